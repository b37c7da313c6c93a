"""Walks through the page by its controls: each step changes what walked.txt has, and nothing else."""

from pathlib import Path

import pytest

from tests.pdp8.web import walk
from tests.pdp8.web.node import needs_node


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> dict[bool, Path]:
    return walk.pages(tmp_path_factory.mktemp("walked"))


@needs_node
@pytest.mark.slow("18 s and more")
@pytest.mark.parametrize("name", walk.walks())
def test_a_walk(files: dict[bool, Path], name: str) -> None:
    """Where it should: look at `python -m tests.pdp8.web.walk` and what git says of walked.txt."""
    for step, wanted, seen in walk.walked(files[name.startswith(walk.CURVE)], name):
        assert seen == wanted, step
