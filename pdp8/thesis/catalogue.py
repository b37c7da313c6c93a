"""Every figure, table, listing and program of the thesis: its words, what there is here, what makes it.

catalogue.toml has them:

    number   as in the thesis; figures and tables share one count, an appendix is a letter. An item without
             a number is called by its chapter: ch3-drilling
    page     the thesis's; counted, between the numbers that the scan shows
    state    from the text           all of it is in the text, or in a legible table or listing
             our drawing             the original is lost or a photograph; we drew what the text says of it
             fitted or conjectured   some of what it shows is fitted to figures of the thesis, or chosen
             lost                    nothing can give it back
    says     the thesis's own words
    note     what is shown here, and why it may differ
    maker    the function, of a module of this package, that makes it
    given    what that is called with
    tape     the function that makes the tape it was cut from, where that is no part's own
    across   whether its pictures are side by side, or one above the other

Source: the thesis; the captions and the text of the scan.
"""

import re
import tomllib
from collections.abc import Mapping
from functools import cache
from typing import Any, Final, NamedTuple

from pdp8.thesis.collate import settled
from pdp8.thesis.table import text_of
from tapes.errors import WorkError

STATES: Final = ("from the text", "our drawing", "fitted or conjectured", "lost")


class Item(NamedTuple):
    """An entry of the catalogue; `maker` is empty where it is lost."""

    kind: str
    number: str
    title: str
    state: str
    page: int
    says: str
    note: str
    maker: str = ""
    given: Mapping[str, Any] = {}
    tape: str = ""
    across: bool = True

    @property
    def chapter(self) -> str:
        """The number of its chapter; A for an appendix."""
        number = re.match(r"(?:ch)?(\d+)", self.number)
        return number[1] if number else "A"

    @property
    def stem(self) -> str:
        """The beginning of its files' names, and its anchor: figure-7.2."""
        return f"{self.kind}-{self.number}"

    @property
    def caption(self) -> str:
        """The text under it: its page in the thesis, its state, what is shown."""
        return f"Page {self.page}. {self.state.capitalize()}. {self.note}"

    @property
    def name(self) -> str:
        """Its name in the thesis, Figure 7.2 or Appendix B; by its chapter if it has no number."""
        if self.kind == "listing":
            return f"Appendix {self.number}"
        if self.number.startswith("ch"):
            return f"Chapter {self.number[2]}, {self.kind}"
        return f"{self.kind.capitalize()} {self.number}"


@cache
def catalogue() -> tuple[Item, ...]:
    """Return every item, in the order of the thesis."""
    return tuple(_item(entry) for entry in tomllib.loads(text_of("catalogue.toml"))["item"])


def _item(entry: dict[str, Any]) -> Item:
    """Return an entry, each of its texts on one line."""
    unwrapped = {field: " ".join(text.split()) for field, text in entry.items() if isinstance(text, str)}
    if settled(entry["number"]):
        unwrapped["state"] = "our drawing"
    return Item(**entry | unwrapped)


def find(number: str) -> Item:
    """Return the item of that number. Raises WorkError if the thesis has none."""
    for item in catalogue():
        if item.number.casefold() == number.casefold():
            return item
    raise WorkError(f"{number}: no such figure, table, listing or program; `pdp8 thesis list` lists all")
