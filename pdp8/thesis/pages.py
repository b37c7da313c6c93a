"""Where a line of a listing is on a picture of its page: rows of ink, counted.

A page is taken to be straight and upright. Needs OpenCV, the extra `vision`, through `tapes.photograph`.
"""

from itertools import groupby

import numpy as np

from pdp8.thesis.collate import Conjecture
from pdp8.thesis.facsimile import HEADINGS, facsimile
from tapes.photograph.pixels import lights
from tapes.text import lines_of

_DARK = 128


def find(conjecture: Conjecture, picture: bytes) -> tuple[int, int, bool] | None:
    """The first and last row of pixels of a conjecture's line, and whether it is sure; None off listings."""
    texts = (page for each in HEADINGS for page in facsimile(each).partition("\n\n")[2].split("\f"))
    pages = [page.replace("Ø", "0").replace("[", "").replace("]", "").strip() for page in texts]
    lines = lines_of(next((page for page in pages if page.split()[-1] == conjecture.page), ""))
    lines = [line for line in lines if line.strip()]
    number = next((at for at, line in enumerate(lines) if line[:4].strip() == conjecture.place[5:]), None)
    ink: list[bool] = np.asarray(np.less(lights(picture)[0], _DARK).any(axis=1)).tolist()
    runs = [[at for at, _ in run] for dark, run in groupby(enumerate(ink), key=lambda row: row[1]) if dark]
    if number is None or not runs:
        return None
    if len(runs) == len(lines):
        return runs[number][0], runs[number][-1], True
    top, pitch = runs[0][0], (runs[-1][-1] - runs[0][0]) / len(lines)
    return int(top + pitch * (number - 1)), int(top + pitch * (number + 2)), False
