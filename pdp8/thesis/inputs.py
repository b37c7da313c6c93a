"""What our numbers are made from, and what may be said of a number for it.

A number that is made from its own target proves nothing. So each measure names its inputs, each input has its
kind, and `state` follows from them:

    thesis    a parameter that the thesis gives or lists, and no result of it
    ours      a standard, DEC's instructions: nothing of the thesis
    fitted    a value that was fitted to results of the thesis, or chosen; `why` says to which, or for what
"""

from typing import Final, NamedTuple

FROM_TEXT, COMPUTED, FITTED = "from the text", "computed", "fitted or conjectured"
DIFFERS, NOT_MADE = "differs", "not made here"


class Input(NamedTuple):
    """Something that a number is made from."""

    kind: str
    why: str = ""


ITSELF: Final = "itself"
"""The input of a constant that the software takes from the thesis's text."""

INPUTS: Final = {
    ITSELF: Input("thesis", "the software takes the number from the text"),
    "Chapter 2": Input("thesis", "the fields of a block, the resolution"),
    "Chapter 3": Input("thesis", "the slope; the holes, feed point and depth; the pairs of feeds"),
    "Chapter 8": Input("thesis", "the element's slopes and arcs"),
    "Table 2.4": Input("thesis", "feeds and spindle speeds by their codes"),
    "±20 %": Input("thesis", "by how much a feed may be wrong, Chapter 2"),
    "2 s": Input("thesis", "the time to read a block, Chapters 7 and 10"),
    "±.005": Input("thesis", "the tolerance of the circle and the ellipse"),
    "±.01": Input("thesis", "the tolerance of the polynomial"),
    "cutter": Input("thesis", "its diameter, 1/2 in"),
    "Appendix B": Input("thesis", "the listing of the conversion program"),
    "Appendix C": Input("thesis", "the listing of the circle"),
    "Appendix D": Input("thesis", "the listing of the ellipse"),
    "EIA": Input("ours", "the standard's code"),
    "ASCII": Input("ours", "the standard's code"),
    "PAL III": Input("ours", "DEC's assembler and instructions"),
    "4096": Input("thesis", "the words of core"),
    "6 rubouts": Input("fitted", "behind each line, to the circle's 30 minutes"),
    "die's path": Input("fitted", "6 x 3 in for the path and not the hole, to the die's 800 blocks"),
    "5 passes": Input("fitted", "of the die, to its 200 minutes of 40"),
    "range": Input("fitted", "of the polynomial, to its 1200 blocks"),
    "outline": Input("fitted", "of the element, to its 2050 and 600 blocks and .0028 in"),
    "codes 01 to 05": Input("fitted", "the feeds of the piece-wise technique: chosen"),
    "our stops": Input("fitted", "the stops of the piece-wise technique: chosen"),
}


def state(made: bool, agrees: bool, inputs: tuple[str, ...]) -> str:
    """Return what may be said of a number: is ours made, does it agree, what is it made from."""
    if not made:
        return NOT_MADE
    if any(INPUTS[name].kind == "fitted" for name in inputs):
        return FITTED
    if not agrees:
        return DIFFERS
    return FROM_TEXT if ITSELF in inputs else COMPUTED
