"""One afternoon of 1971, done again, and what it left: from a part program to a milled and measured part."""

from collections.abc import Callable
from dataclasses import dataclass

import nc
import pal
from nc.curves import nominal
from nc.inspection import Inspection, inspect
from pdp8.computer.use.operator import Action
from pdp8.replay.day import PROGRAMS, Act, Day, Judgement
from programs.parts import Part, find
from tapes import shelf
from tapes.errors import WorkError
from tapes.measure import inches


@dataclass(frozen=True)
class Afternoon:
    """Everything the afternoon left.

    `tapes` are {name: frames}; `programs` {name: assembly}; `minutes` what the thesis timed: punch, translate
    and cut. `path` began at tick `mill_starts`. `inspection` is None where the part follows no curve that
    could be inspected.
    """

    part: str
    text: str
    acts: tuple[Act, ...]
    actions: tuple[Action, ...]
    tapes: dict[str, bytes]
    programs: dict[str, pal.Assembly]
    path: nc.Path
    mill_starts: int
    inspection: Inspection | None
    minutes: dict[str, float]


def replay(part: str, tell: Callable[[Act], object] = lambda act: None) -> Afternoon:
    """Do the whole afternoon for the part program `part`; `tell` hears of every act as it is done.

    Raises WorkError, naming its place, where something goes wrong, as it would have in 1971.
    """
    made = find(part)
    inspector = _Inspector(made)
    sources = {name: shelf.read_bundled(name) for name in PROGRAMS}
    day = Day(part, made.program()(), sources, inspector.judge, tell)
    for _ in day.through():
        pass
    assert day.path is not None
    return Afternoon(
        part,
        day.text,
        tuple(day.acts),
        tuple(day.actions),
        day.tapes,
        day.programs,
        day.path,
        day.mill_starts,
        inspector.inspection,
        day.minutes,
    )


class _Inspector:
    """Who measures the part."""

    def __init__(self, made: Part) -> None:
        self.made = made
        self.inspection: Inspection | None = None

    def judge(self, path: nc.Path) -> Judgement:
        """Measure the walls that a path leaves."""
        made = self.made
        try:
            found = inspect(path, nominal(**made.nominal), made.cutter * 1000, made.tolerance * 1000)
        except WorkError as error:
            return Judgement("Inspection", f"Not inspected: {error}.", "not inspected")
        self.inspection = found
        worst = found.worst
        outcome = f"worst trough to peak {inches(worst.trough_to_peak)} in, {worst.wall} wall, {worst.place}"
        done = (
            "The stylus follows the walls"
            if made.instrument
            else "The thesis measured no such part; computed"
        )
        return Judgement(made.instrument or "Inspection", f"{done}: {outcome}.", outcome)
