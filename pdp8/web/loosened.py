"""The circle with another tolerance, by the whole chain.

tolerance ──► programs.circle ──► ASCII tape ──► eia.pal ──► EIA tape
"""

from pal.assembling import assemble
from pdp8.web.method import translated
from programs import circle
from tapes import ascii


def loosened(tolerance: int, source: str) -> bytes:
    """Return the circle's EIA tape for half a band of so many thousandths; `source` is that of eia.pal."""
    words = assemble(source, names=["eia.pal"]).words
    printout = ascii.encode(circle.part(tolerance=tolerance))
    return translated(words.items(), printout).teletype.punch.tape
