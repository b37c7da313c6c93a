"""What the thesis's figures imply: the feed, range, size and allowance that it does not give.

Each function tries candidates against Table 10.1, and yields them all. docs/implied.md shows the tables;
`python -m pdp8.replay.implied` prints them.

Minutes are those of the contour alone, as Chapter 7's: its blocks at 2 s each, and the milling.
"""

from collections.abc import Iterable, Iterator
from itertools import product
from typing import Final, NamedTuple

import nc
from programs.milling import Milling
from programs.parts import PARTS
from programs.thesis import TABLE_10_1, Timed
from tapes import eia

ALLOWANCES: Final = (0.2, 0.15, 0.1)
FASTEST: Final = (4, 5)
CODES: Final = (1, 2)
FEED_ERRORS: Final = (-0.2, 0.0, 0.2)


class Candidate(NamedTuple):
    """A part under one assumption, and the thesis's figures; None: it gives none."""

    assumption: str
    blocks: int
    minutes: float
    thesis_blocks: int | None
    thesis_minutes: float | None

    @property
    def off(self) -> float:
        """The greatest difference from what the thesis says, as a fraction of it."""
        pairs = ((self.blocks, self.thesis_blocks), (self.minutes, self.thesis_minutes))
        return max(abs(ours / said - 1) for ours, said in pairs if said is not None)


def machined(printout: str, feed_code: int | None = None, feed_error: float = 0.0) -> nc.Path:
    """Return the path of a part program's printout, translated without the PDP-8/L."""
    frames = eia.encode(printout.replace(" ", "0"))
    return nc.cut(frames, settings=nc.Settings((feed_error, feed_error, 0.0), feed_code))


def feeds(part: str) -> Iterator[Candidate]:
    """Yield the part at several feeds; the thesis's minutes are those of Table 10.1."""
    printout = PARTS[part].program()()
    said = TABLE_10_1[part].step
    for code, error in product(CODES, FEED_ERRORS):
        path = machined(printout, code, error)
        yield Candidate(
            f"code {code:02}, {error:+.0%}", len(path), path.contour.total / 60, None, said.minutes
        )


def ranges() -> Iterator[Candidate]:
    """Yield the polynomial over each range in quarter inches that crosses the axis three times.

    Ranges of more than the 10 in of the table along Y are left out. The feed is code 01, 20 % fast.
    """
    program, said = PARTS["polynomial"].program(), TABLE_10_1["polynomial"].step
    for first, last in product((-0.25, -0.5, -0.75, -1.0), (6.25, 6.5, 6.75)):
        path = machined(program(from_=first, to=last, origin_y=5.0), 1, 0.2)
        assumption = f"{first:g} to {last:g}"
        yield Candidate(assumption, len(path), path.contour.total / 60, said.blocks, said.minutes)


def allowances(part: str) -> Iterator[Candidate]:
    """Yield the part by the piece-wise technique, for several allowances and fastest feeds."""
    program, row = PARTS[part].program(), TABLE_10_1[part].piece
    assert row is not None
    for error, fastest in product(ALLOWANCES, FASTEST):
        path = machined(program(milling=Milling("piece", feed_error=error, fastest=fastest)))
        assumption = f"±{error:.0%}, codes 01 to {fastest:02}"
        yield Candidate(assumption, len(path), path.contour.total / 60, row.blocks, row.minutes)


def element() -> Iterator[Candidate]:
    """Yield the programs of the fluidic element, of both rules where a cut stops."""
    blocks = {"main": 2050, "control": 600, "both": TABLE_10_1["fluidic"].step.blocks}
    for rule, (name, said) in product(("boundary", "inside"), blocks.items()):
        path = machined(PARTS["fluidic"].program()(program=name, milling=Milling(stop=rule)))  # type: ignore[arg-type]
        minutes = TABLE_10_1["fluidic"].step.minutes if name == "both" else None
        yield Candidate(f"{name}, stop {rule}", len(path), path.contour.total / 60, said, minutes)


def table_10_1() -> Iterator[list[str]]:
    """Yield Table 10.1, the thesis's figures beside ours, both techniques; minutes at the feeds that fit."""
    for name, row in TABLE_10_1.items():
        printout = PARTS[name].program()()
        step = machined(printout, *fitting_feed(name))
        yield [row.part, "step-wise", *_cells(row.step, step, PASSES.get(name, 1))]
        if row.piece is not None:
            piece = machined(PARTS[name].program()(milling=FITTING_PIECES[name]))
            yield [row.part, "piece-wise", *_cells(row.piece, piece, PASSES.get(name, 1))]


PASSES: Final = {"die": 5}
"""Passes through the 2 in of the die: 200 minutes of 40."""

FITTING_FEEDS: Final = {"circle": (2, 0.0), "fluidic": (1, -0.2)}
"""The feed code, and its error, that fit the minutes of a part, where it is not code 01, 20 % fast."""


def fitting_feed(part: str) -> tuple[int, float]:
    """Return the feed code, and its error, that fit the minutes of a part."""
    return FITTING_FEEDS.get(part, (1, 0.2))


FITTING_PIECES: Final = {
    "circle": Milling("piece", feed_error=0.1, fastest=5),
    "ellipse": Milling("piece", feed_error=0.15, fastest=4),
    "die": Milling("piece", feed_error=0.15, fastest=4),
}
"""The allowance and fastest feed that fit blocks and minutes of a part."""


def _cells(said: Timed, path: nc.Path, passes: int) -> list[str]:
    minutes = path.contour.total / 60
    ours = (f"{len(path)}", f"{minutes:.1f}", f"{passes * minutes:.0f}")
    return [cell for pair in zip(map(str, said), ours, strict=True) for cell in pair]


def rows(candidates: Iterable[Candidate]) -> Iterator[list[str]]:
    """Yield the cells of a table of candidates: assumption, blocks, minutes, difference."""
    for found in candidates:
        yield [found.assumption, str(found.blocks), f"{found.minutes:.1f}", f"{found.off:.1%}"]


def tables() -> Iterator[tuple[str, list[list[str]]]]:
    """Yield each table of the page, with its name."""
    for part in TABLE_10_1:
        yield f"feed, {part}", list(rows(feeds(part)))
    yield "range", list(rows(ranges()))
    for part in FITTING_PIECES:
        yield f"allowance, {part}", list(rows(allowances(part)))
    yield "element", list(rows(element()))
    yield "Table 10.1", list(table_10_1())


if __name__ == "__main__":
    for name, table in tables():
        print(name)
        for cells in table:
            print(f"| {' | '.join(cells)} |")
