"""Every number of the thesis's chapters: its place, our value of it, and what makes that.

numbers.txt has them, a line each:

    page | the scan's words, the number between « and » | ours | made by

    ‹ ›       after a number the scan has damaged or in words: how it is read
    ours      the name of a measure, of `measures`; nothing where nothing here makes the number
    made by   an item of the catalogue, a command, or a page of docs/

The state of a number follows from what its measure is made from, and from whether ours is the thesis's
(`inputs.state`):

    from the text           the software takes it from the thesis
    computed                what runs here computes it from parameters, to its last place or 5 %
    fitted or conjectured   an input was fitted to the thesis or chosen, whether ours agrees or not
    differs                 ours is another number: see errata and implied
    not made here           history, another's measurement, or a specification that is not emulated

Not among them: numbers of figures, tables, chapters, references and models; the codes of Tables 2.3 and 2.4,
which `pdp8 thesis list` shows; Appendices B to D, which are the evidence's.
"""

import re
from collections.abc import Iterator
from typing import Final, NamedTuple

from pdp8.thesis.inputs import state
from pdp8.thesis.measures import Measure, inputs, value
from pdp8.thesis.table import Table, cells, text_of

WITHIN: Final = 0.05

_CHAPTERS: Final = (1, 7, 17, 30, 41, 55, 66, 78, 87, 92, 97)
_MARKED = re.compile(r"«(.*?)»(?:‹(.*?)›)?")


class Number(NamedTuple):
    """A number of the thesis; `words` are the scan's; `said` is the number in them, as we read it."""

    page: int
    words: str
    said: str
    measure: str
    by: str

    @property
    def chapter(self) -> int:
        """Its chapter."""
        return sum(first <= self.page for first in _CHAPTERS)

    @property
    def ours(self) -> Measure | None:
        """What we make of it; None where nothing here makes it."""
        return value(self.measure) if self.measure else None

    @property
    def inputs(self) -> tuple[str, ...]:
        """The names of the inputs that our value is computed from."""
        return inputs(self.measure) if self.measure else ()

    @property
    def state(self) -> str:
        """Its state (`inputs.state`)."""
        return state(self.ours is not None, self.agrees, self.inputs)

    @property
    def shown(self) -> str:
        """Ours as a table shows it."""
        return f"{ours:.4g}" if isinstance(ours := self.ours, int | float) else ours or ""

    @property
    def agrees(self) -> bool:
        """Whether ours is the thesis's: the same text, to its last place, within 5 %; or possible."""
        ours = self.ours
        found = re.search(r"\d*\.?\d+", self.said)
        if isinstance(ours, str):
            least, _, more = ours.partition(" or ")
            return float(found[0]) >= int(least) if found and more == "more" else ours == plain(self.said)
        if ours is None or not found:
            return False
        said = float(found[0])
        if "or more" in self.said:
            return ours >= said
        places = len(found[0].partition(".")[2])
        return abs(ours - said) <= WITHIN * abs(said) or (places > 0 and round(ours, places) == said)


def plain(said: str) -> str:
    """Return a number of the scan without the base of octals and without spaces before commas."""
    return re.sub(r" ,", ",", re.sub(r"_8|₈|°", "", said)).strip()


def numbers() -> Iterator[Number]:
    """Yield every number, in the order of the thesis."""
    for page, words, name, by in cells(text_of("numbers.txt")):
        found = _MARKED.search(words)
        assert found, words
        scan = _MARKED.sub(r"\1", words)
        yield Number(int(page), scan, found[2] or found[1], name, by)


def table(chapter: int | None = None) -> Table:
    """Return the numbers of a chapter, or all, with what we make of them."""
    rows = (
        (str(one.page), one.words, plain(one.said), one.shown, one.state, ", ".join(one.inputs), one.by)
        for one in numbers()
        if chapter in (None, one.chapter)
    )
    return Table(("page", "the thesis", "number", "ours", "state", "made from", "made by"), tuple(rows))
