"""Pictures that were looked at by eye: a test holds each by its digest, and says how to look at it again."""

import re
from hashlib import sha256
from pathlib import Path

import pytest

FOLDER = Path(__file__).parent.parent / "build" / "pictures"


def assert_looked_at(name: str, svg: str, digest: str) -> None:
    """Fail unless `svg`, the picture called `name`, is the one whose `digest` was noted when it was seen."""
    now = sha256(svg.encode()).hexdigest()[: len(digest)]
    if now != digest:
        FOLDER.mkdir(parents=True, exist_ok=True)
        file = FOLDER / f"{re.sub(r'[^a-z0-9.]+', '-', name)}.svg"
        file.write_text(svg)
        said = f"{name} is not the picture that was last looked at: open {file}; if it is right, note {now}"
        pytest.fail(said, pytrace=False)
