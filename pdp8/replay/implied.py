"""Explanations of the thesis's minutes, side by side, and of sizes and ranges that it does not give.

docs/implied.md shows the tables; `python -m pdp8.replay.implied` prints them. thesis/inputs.txt has the
conjectures that other numbers depend on.

Minutes are those of the contour, as in Chapter 7: its blocks at 2 s each, and the milling.
"""

from collections.abc import Iterator
from itertools import product
from typing import Final

import nc
from programs.milling import Milling
from programs.parts import PARTS
from programs.thesis import TABLE_10_1
from tapes import eia

LINE_SECONDS: Final = 2.7
"""A line of the ASCII tape at 10 frames a second: 19 digits, CR, LF and 6 rubouts."""

ROUGHLY: Final = 3.0
"""Seconds a block of an estimate: 2 to read, 1 to cut."""

_CODES, _FEED_ERRORS = (1, 2), (-0.2, 0.0, 0.2)
SLOWEST: Final = 1
"""The feed code of 1 inch a minute."""


def machined(printout: str, feed_code: int | None = None, feed_error: float = 0.0) -> nc.Path:
    """Return the path of a part program's printout, translated without the PDP-8/L."""
    frames = eia.encode(printout.replace(" ", "0"))
    return nc.cut(frames, settings=nc.Settings((feed_error, feed_error, 0.0), feed_code))


def _minutes(printout: str, feed_code: int | None = None, feed_error: float = 0.0) -> str:
    return f"{machined(printout, feed_code, feed_error).contour.total / 60:.1f}"


def rivals() -> Iterator[list[str]]:
    """Yield each cell of Table 10.1 with its rivals: the tape's time, 3 s a block, 1 in/min, its feeds."""
    for name, row in TABLE_10_1.items():
        cells = {
            "step-wise": (row.step, Milling(), SLOWEST),
            "piece-wise": (row.piece, Milling("piece"), None),
        }
        for technique, (said, milling, code) in cells.items():
            if said is None:
                continue
            yield [
                row.part,
                technique,
                str(said.blocks),
                f"{said.minutes:g}",
                f"{60 * said.minutes / said.blocks:.2f}",
                f"{said.blocks * LINE_SECONDS / 60:.1f}",
                f"{said.blocks * ROUGHLY / 60:.1f}",
                _minutes(PARTS[name].program()(milling=milling), code),
            ]


def feeds() -> Iterator[list[str]]:
    """Yield for each part its minutes as listed, and all at feed codes 01 and 02, -20 % to +20 %."""
    for name, row in TABLE_10_1.items():
        printout = PARTS[name].program()()
        others = [_minutes(printout, code, error) for code, error in product(_CODES, _FEED_ERRORS)]
        yield [row.part, f"{row.step.minutes:g}", _minutes(printout), *others]


def ranges() -> Iterator[list[str]]:
    """Yield the polynomial's blocks for each range of x that has three crossings and fits 10 in along Y."""
    program, said = PARTS["polynomial"].program(), TABLE_10_1["polynomial"].step.blocks
    for first, last in product((-0.25, -0.5, -0.75, -1.0), (6.25, 6.5, 6.75)):
        blocks = program(from_=first, to=last, origin_y=5.0).count("\n")
        yield [f"{first:g} to {last:g}", str(blocks), _off(blocks, said)]


def die() -> Iterator[list[str]]:
    """Yield the blocks of the die's opening, for 6 x 3 in as the cutter's path or as the hole."""
    program, said = PARTS["die"].program(), TABLE_10_1["die"].step.blocks
    for what, axes in (("path", (3000, 1500)), ("hole", (2750, 1250))):
        blocks = program(major=axes[0], minor=axes[1]).count("\n")
        path, hole = (" × ".join(f"{2 * axis / 1000 + wider:g}" for axis in axes) for wider in (0.0, 0.5))
        yield [f"the {what} is 6 × 3", path, hole, str(blocks), _off(blocks, said)]


def element() -> Iterator[list[str]]:
    """Yield the blocks and minutes of the fluidic element's programs, by both rules for where cuts stop."""
    blocks = {"main": 2050, "control": 600, "both": TABLE_10_1["fluidic"].step.blocks}
    for rule, (name, said) in product(("boundary", "inside"), blocks.items()):
        printout = PARTS["fluidic"].program()(program=name, milling=Milling(stop=rule))  # type: ignore[arg-type]
        count = printout.count("\n")
        yield [f"{name}, stop {rule}", str(count), _off(count, said), _minutes(printout)]


def _off(ours: int, said: int) -> str:
    return f"{ours / said - 1:+.1%}"


TABLES: Final = {"rivals": rivals, "feeds": feeds, "die": die, "range": ranges, "element": element}
"""The tables of the page."""


if __name__ == "__main__":
    for name, table in TABLES.items():
        print(name)
        for cells in table():
            print(f"| {' | '.join(cells)} |")
