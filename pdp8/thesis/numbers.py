"""Every number of the thesis's chapters: where it stands, what we make of it, and what makes it.

numbers.txt has them, a line each:

    page | the scan's words, the number between « and » | state | ours | made by

    ‹ ›       after a number the scan has damaged or in words: how it is read
    ours      the name of a measure, of `measures`; nothing where nothing here makes the number
    made by   an item of the catalogue, a command, or a page of docs/

    state     in the file
    text      from the text           a constant that the software takes from the thesis
    made      computed                comes out of what runs here, to the thesis's last place or within 5 %
    fits      fitted or conjectured   ours was chosen so that it comes out
    errs      differs                 ours is another: see errata and implied
    none      not made here           history, another's measurement, or a specification that is not emulated

Not among them: numbers of figures, tables, chapters, references and models; the codes of Tables 2.3 and 2.4,
which `pdp8 thesis make` shows; Appendices B to D, which are the evidence's.
"""

import re
from collections.abc import Iterator
from importlib.resources import files
from typing import Final, NamedTuple

from pdp8.thesis.measures import Measure, measure
from pdp8.thesis.table import Table

STATES: Final = {
    "text": "from the text",
    "made": "computed",
    "fits": "fitted or conjectured",
    "errs": "differs",
    "none": "not made here",
}
WITHIN: Final = 0.05

_CHAPTERS: Final = (1, 7, 17, 30, 41, 55, 66, 78, 87, 92, 97)
_MARKED = re.compile(r"«(.*?)»(?:‹(.*?)›)?")


class Number(NamedTuple):
    """A number of the thesis; `words` are the scan's, `said` is the number as it stands there or is read."""

    page: int
    words: str
    said: str
    state: str
    measure: str
    by: str

    @property
    def chapter(self) -> int:
        """Its chapter."""
        return sum(first <= self.page for first in _CHAPTERS)

    @property
    def ours(self) -> Measure | None:
        """What we make of it; None where nothing here makes it."""
        return measure(self.measure) if self.measure else None

    @property
    def shown(self) -> str:
        """Ours as a table shows it."""
        return f"{ours:.4g}" if isinstance(ours := self.ours, int | float) else ours or ""

    @property
    def agrees(self) -> bool:
        """Whether ours is the thesis's: the same text, or to its last place, or within 5 %."""
        ours = self.ours
        if isinstance(ours, str):
            return ours == plain(self.said)
        found = re.search(r"\d*\.?\d+", self.said)
        if ours is None or not found:
            return False
        said = float(found[0])
        if "or more" in self.said:
            return ours >= said
        places = len(found[0].partition(".")[2])
        return abs(ours - said) <= WITHIN * abs(said) or (places > 0 and round(ours, places) == said)


def plain(said: str) -> str:
    """Return a number as the scan has it without the base of octals and spaces before commas."""
    return re.sub(r" ,", ",", re.sub(r"_8|₈|°", "", said)).strip()


def numbers() -> Iterator[Number]:
    """Yield every number, in the order of the thesis."""
    text = (files("pdp8.thesis") / "numbers.txt").read_text(encoding="utf-8")
    for line in text.splitlines():
        if line.startswith("#"):
            continue
        page, words, state, name, by = (cell.strip() for cell in line.split("|"))
        found = _MARKED.search(words)
        assert found, line
        scan = _MARKED.sub(r"\1", words)
        yield Number(int(page), scan, found[2] or found[1], STATES[state], name, by)


def table(chapter: int | None = None) -> Table:
    """Return the numbers of a chapter, or all, with what we make of them."""
    rows = (
        (str(one.page), one.words, plain(one.said), one.shown, one.state, one.by)
        for one in numbers()
        if chapter in (None, one.chapter)
    )
    return Table(("page", "the thesis", "number", "ours", "state", "made by"), tuple(rows))
