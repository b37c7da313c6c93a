"""A curve in ten minutes: the page that teaches the method of the thesis, in Chapter 3's order.

    eia.pal, assembled                                              ──► record (JSON)  ┐
    method.py: programs, nc, the computer                           ──► translated     ├──► one HTML file
    curve.html, curve.css, curve.mjs, curve/                                           ┘

Each figure runs what it shows: the technique makes the blocks, the Hydra-Point carries out their tape, the
PDP-8/L translates one. By hand is what draws, and the walls (curve/walls.mjs), which nc measures with numpy.

Source: thesis, Chapter 3; Chapters 5 to 7 for the circle, its tape and its graph.
"""

from typing import Any

import pal
from pdp8 import shelf
from pdp8.web import bundle


def page(workbench: str = "pdp8.html") -> str:
    """Return the whole page; the tape of a curve that is drawn opens in the page at address `workbench`."""
    return bundle.page("A curve in ten minutes", "curve.html", ("curve.css",), "curve", record(workbench))


def record(workbench: str) -> dict[str, Any]:
    """Return what the page has at hand, ready for JSON: eia.pal's words, its listing, a proved tape."""
    assembly = pal.assemble(shelf.read_bundled("eia.pal"))
    lines = [[line.address, line.word, line.source] for line in assembly.lines if line.word is not None]
    fewest = list(shelf.read_bundled("slope-fewest.eia"))
    words = list(assembly.words.items())
    return {"words": words, "listing": lines, "fewest": fewest, "workbench": workbench}
