"""What our numbers are computed from, and the state of a number that follows from it.

A number that is made from its own target proves nothing. So each measure names its inputs, each input has its
kind in inputs.txt, and `state` follows from them:

    thesis    a parameter that the thesis gives or lists, and no result of it
    ours      a standard, DEC's instructions: nothing of the thesis
    fitted    a value that was fitted to results of the thesis, or chosen; `why` says to which, or for what
"""

from typing import Final, NamedTuple

from pdp8.thesis.collate import settled
from pdp8.thesis.table import cells, text_of

FROM_TEXT, COMPUTED, FITTED = "from the text", "computed", "fitted or conjectured"
DIFFERS, NOT_MADE = "differs", "not made here"


class Input(NamedTuple):
    """A value that a number is computed from."""

    kind: str
    why: str = ""


ITSELF: Final = "itself"
"""The input of a constant that the software takes from the thesis's text."""

INPUTS: Final = {
    name: Input("thesis" if settled(name) else kind, why) for name, kind, why in cells(text_of("inputs.txt"))
}


def state(made: bool, agrees: bool, inputs: tuple[str, ...]) -> str:
    """Return a number's state, by whether we compute it, whether it agrees, and from which inputs."""
    if not made:
        return NOT_MADE
    if any(INPUTS[name].kind == "fitted" for name in inputs):
        return FITTED
    if not agrees:
        return DIFFERS
    return FROM_TEXT if ITSELF in inputs else COMPUTED
