"""Where a line of a listing is on a picture of its page: rows of ink, counted.

Needs OpenCV, the extra `vision`, through `tapes.photograph`. A page is taken to be straight and upright.
"""

from typing import Any, NamedTuple

import numpy as np

from pdp8.thesis.collate import Conjecture
from pdp8.thesis.facsimile import HEADINGS, facsimile
from tapes.photograph.pixels import lights

_DARK = 128


class Place(NamedTuple):
    """A part of a picture in pixels, `x` and `y` of its upper left; `sure` if every line was found."""

    x: int
    y: int
    width: int
    height: int
    sure: bool

    def __str__(self) -> str:
        """The place in words."""
        about = "" if self.sure else "about, by its number among the lines: "
        return f"{about}x {self.x} to {self.x + self.width}, y {self.y} to {self.y + self.height}"


def find(conjecture: Conjecture, picture: bytes) -> Place | None:
    """Return where the conjecture's line is on a picture of its page; None if it is no line of a listing.

    Raises TapeError where the picture cannot be read.
    """
    name = conjecture.place.removeprefix("line ")
    pages = {page.split()[-1].strip("[]").replace("Ø", "0"): page for page in _pages()}
    text = pages.get(conjecture.page, "").replace("Ø", "0").replace("[", "")
    lines = [line for line in text.splitlines() if line.strip()]
    numbers = [at for at, line in enumerate(lines) if line.startswith(f"{name} ")]
    if not numbers:
        return None
    ink: np.ndarray[Any, Any] = np.less(lights(picture)[0], _DARK)
    rows, columns = _runs(np.asarray(ink.any(axis=1))), np.flatnonzero(ink.any(axis=0))
    if not rows:
        return None
    left, width = int(columns[0]), int(columns[-1] - columns[0]) + 1
    if len(rows) == len(lines):
        top, end = rows[numbers[0]]
        return Place(left, top, width, end - top, sure=True)
    pitch = (rows[-1][1] - rows[0][0]) / len(lines)
    return Place(left, int(rows[0][0] + pitch * (numbers[0] - 1)), width, int(3 * pitch), sure=False)


def _pages() -> list[str]:
    return [page for appendix in HEADINGS for page in facsimile(appendix).partition("\n\n")[2].split("\f")]


def _runs(marks: "np.ndarray[Any, Any]") -> list[tuple[int, int]]:
    """Return the beginning and the end of each run of rows that have ink."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], marks.astype(np.int8), [0]])))
    return [(int(start), int(end)) for start, end in edges.reshape(-1, 2)]
