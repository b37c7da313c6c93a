"""Every figure, table, listing and program of the thesis: its words, what there is here, what makes it.

catalogue.toml has them:

    number   as in the thesis; figures and tables share one count, an appendix is a letter. What has no number
             is called by its chapter: ch3-drilling
    state    works as in the thesis    all of it stands in the text or in a legible table or listing
             reconstructed             the original is lost or a photograph; the text says what it shows
             inferred                  some of what it shows is not in the thesis
             lost                      nothing can give it back
    says     the thesis's own words
    note     what is shown here, and why it may differ
    maker    the function, of a module of this package, that makes it
    tape     the function that makes the tape it was cut from, where that is no part's own
    across   whether its pictures stand side by side, or one above the other

Source: the thesis; the captions and the text of the scan.
"""

import tomllib
from functools import cache
from importlib.resources import files
from typing import Final, NamedTuple

from tapes.errors import WorkError

STATES: Final = ("works as in the thesis", "reconstructed", "inferred", "lost")
KINDS: Final = ("figure", "table", "listing", "program")


class Item(NamedTuple):
    """An entry of the catalogue; `maker` is empty where it is lost."""

    kind: str
    number: str
    title: str
    state: str
    says: str
    note: str
    maker: str = ""
    tape: str = ""
    across: bool = True

    @property
    def name(self) -> str:
        """What the thesis calls it, Figure 7.2 or Appendix B; by its chapter where it has no number."""
        if self.kind == "listing":
            return f"Appendix {self.number}"
        if self.number.startswith("ch"):
            return f"Chapter {self.number[2]}, {self.kind}"
        return f"{self.kind.capitalize()} {self.number}"


@cache
def catalogue() -> tuple[Item, ...]:
    """Return every item, in the order of the thesis."""
    text = (files("pdp8.thesis") / "catalogue.toml").read_text(encoding="utf-8")
    return tuple(_item(entry) for entry in tomllib.loads(text)["item"])


def _item(entry: dict[str, str | bool]) -> Item:
    """Return an entry with its texts unwrapped."""
    across = bool(entry.pop("across", True))
    return Item(**{field: " ".join(str(text).split()) for field, text in entry.items()}, across=across)


def find(number: str) -> Item:
    """Return the item of that number. Raises WorkError if the thesis has none."""
    for item in catalogue():
        if item.number.casefold() == number.casefold():
            return item
    raise WorkError(f"{number}: no such figure, table, listing or program; `pdp8 thesis list` has all")
