"""Public pictures of tape whose strips a person has counted: each strip is read, or left out with its place.

    PDP8_PICTURES=folder pytest tests/tapes/photograph/test_counted.py

The pictures are those of `pix` in hughpyle/ASR33 (MIT) and the example of rumplin/PunchedTapeScanner; skipped
without them. A place is where a strip was seen, in parts of the picture's longer side.
"""

import os
from pathlib import Path

import numpy as np
import pytest

from tapes import photograph
from tests.tapes.photograph.test_real import away, picture

COUNTED = {
    "fita_absoluta.2a.0006.96.scan03.png": [(0.50, 0.17)],
    "mylar02.jpg": [(0.44, 0.42), (0.085, 0.70), (0.65, 0.19)],
    "mylar03.jpg": [(0.48, 0.42), (0.48, 0.535), (0.48, 0.625), (0.48, 0.74)],
    "mylar03_900.jpg": [(0.48, 0.42), (0.48, 0.535), (0.48, 0.625), (0.48, 0.74)],
    "mylar04.jpg": [(0.375, 0.588), (0.375, 0.663), (0.375, 0.738), (0.375, 0.818)],
    "paper_and_tape.jpg": [(0.47, 0.1)],
    "smallcaps.jpg": [(0.48, 0.395)],
    "tape_and_paper.jpg": [(0.50, 0.123)],
    "tape_book1.jpg": [(0.56, 0.17), (0.47, 0.28), (0.52, 0.45)],
    "tape_book2.jpg": [(0.50, 0.19), (0.45, 0.27), (0.42, 0.40)],
    "tape_donotcross.jpg": [(0.06, 0.50), (0.44, 0.32), (0.67, 0.30), (0.85, 0.12)],
    "tape_fade.jpg": [(0.48, 0.10), (0.48, 0.19), (0.48, 0.33), (0.48, 0.406), (0.48, 0.523), (0.48, 0.62)],
    "tape_fonts.jpg": [(0.36, 0.34), (0.36, 0.50), (0.38, 0.67)],
    "tape_invaders.jpg": [(0.50, 0.33)],
    "tape_invaders2.jpg": [(0.48, 0.20), (0.48, 0.54), (0.50, 0.746)],
    "tape_skulls.jpg": [(0.50, 0.27)],
    "tape_subway_tile.jpg": [(0.48, 0.19)],
    "tape_template.jpg": [(0.25, 0.51), (0.61, 0.56)],
    "tape_valentine.jpg": [(0.59, 0.59)],
    "20180925_175242.jpg": [(0.33, 0.47)],
    "20180925_175351.jpg": [(0.475, 0.316)],
}


@pytest.mark.slow("twenty photographs, 4 minutes of processor time, if there is a folder of them")
@pytest.mark.parametrize("name", COUNTED)
def test_every_strip_that_was_counted_is_accounted_for(name: str) -> None:
    file = Path(os.environ.get("PDP8_PICTURES", "none")) / name
    if not file.exists():
        pytest.skip("PDP8_PICTURES names no folder with it")
    found = photograph.strips(file.read_bytes())
    assert all(strip.ends and (strip.why or strip.frames) for strip in found)
    size = max(picture(file).shape)
    lines = [np.array(strip.ends, dtype=float) / size for strip in found]
    for place in COUNTED[name]:
        assert min(away(np.array(place), *line) for line in lines) < 0.05, place
