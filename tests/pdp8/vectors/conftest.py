"""A set of vectors with few states, for all tests of this package."""

from pathlib import Path

import pytest

from pdp8.vectors.folder import files

STATES = 8
"""States of each word."""


@pytest.fixture(scope="session")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("vectors")
    for name, content in files(STATES, pipan8l=True):
        (folder / name).write_bytes(content)
    return folder
