"""The workbench as one page: the whole machine live, with every bundled tape and program at hand.

shelf ──► record (JSON: tapes, a program, the BIN loader)  ┐
our Python, bench/ workbench.mjs                           ├──► one HTML file with everything inside
base.css workbench.css                                     ┘
"""

from typing import Any

import pal
from pdp8.web import bundle
from programs.parts import PARTS
from tapes import rim, shelf

_STYLES = ("workbench.css", "bench/desk.css")
_OPENS_WITH = "hello.pal"


def page(view: tuple[str, bytes] | None = None) -> str:
    """Return the whole page; with `view`, the name and frames of an EIA tape, opened at the Hydra-Point."""
    return bundle.page(
        "PDP-8/L workbench", "bench.html", ("workbench.css", "bench/desk.css"), "workbench", record(view)
    )


def record(view: tuple[str, bytes] | None = None) -> dict[str, Any]:
    """Return what the page has at hand, ready for JSON; tapes as text, a character a frame."""
    tapes = {name: shelf.read_bundled(name) for name in shelf.bundled() if not name.endswith(".for")}
    if view is not None:
        tapes |= {view[0]: view[1]}
    loader = pal.assemble(shelf.read_bundled("bin.pal"))
    return {
        "tapes": {name: frames.decode("latin-1") for name, frames in tapes.items()},
        "loader": rim.encode(loader.words).decode("latin-1"),
        "source": shelf.read_bundled(_OPENS_WITH).decode("ascii"),
        "cutter": PARTS["circle"].cutter * 1000,
        "view": view[0] if view else "",
    }
