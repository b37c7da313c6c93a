"""The listings and programs of the thesis as text: sources, PAL's printout, what part programs print."""

from typing import Any

import pal
from pdp8 import shelf
from pdp8.thesis import chain
from programs.milling import Milling


def source(name: str) -> str:
    """A bundled source: Programs 1 and 2 of Chapter 5, Appendices C and D."""
    return shelf.read_bundled(name).decode()


def assembled(name: str) -> str:
    """Appendix B: address, word and source, as PAL's third pass prints them."""
    return pal.assemble(shelf.read_bundled(name), names=[name]).listing


def printed(part: str, technique: Any = "step", **constants: Any) -> str:
    """What a part program prints."""
    return chain.printout(part, milling=Milling(technique), **constants)


def die() -> str:
    """The printouts of the die's three programs, one after another."""
    return "".join(chain.printout("die", cut=cut) for cut in ("opening", "rounding", "groove"))
