"""The listings and programs of the thesis as text: sources, PAL's printout, what part programs print."""

import pal
from pdp8.thesis import chain
from programs.milling import Milling
from tapes import shelf


def first_conversion() -> str:
    """Program 1 of Chapter 5."""
    return shelf.read_bundled("eia1.pal").decode()


def second_conversion() -> str:
    """Program 2 of Chapter 5."""
    return shelf.read_bundled("eia2.pal").decode()


def third_conversion() -> str:
    """Appendix B: address, word and source, as PAL's third pass prints them."""
    return pal.assemble(shelf.read_bundled("eia.pal"), names=["eia.pal"]).listing


def circle() -> str:
    """Appendix C."""
    return shelf.read_bundled("circle.for").decode()


def ellipse() -> str:
    """Appendix D."""
    return shelf.read_bundled("ellipse.for").decode()


def piecewise_circle() -> str:
    """The circle by the Piece-wise Linear Technique."""
    return chain.printout("circle", milling=Milling("piece"))


def polynomial() -> str:
    """The polynomial's printout."""
    return chain.printout("polynomial")


def die() -> str:
    """The printouts of the die's three programs, one after another."""
    return "".join(chain.printout("die", cut=cut) for cut in ("opening", "rounding", "groove"))


def element() -> str:
    """The printout of the fluidic element's main program."""
    return chain.printout("fluidic", program="main")


def control_channels() -> str:
    """The printout of its subprogram."""
    return chain.printout("fluidic", program="control")
