"""One afternoon of 1971, done again, and what it left: from a part program to a milled and measured part."""

from collections.abc import Callable
from dataclasses import dataclass

import nc
import pal
from nc.curves import nominal
from nc.inspection import Inspection, inspect
from pdp8.computer.use.operator import Action
from pdp8.replay.day import PROGRAMS, Act, Day, Judgement
from programs.parts import find
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
    found: list[Inspection] = []

    def judge(path: nc.Path) -> Judgement:
        """Measure the walls that a path leaves."""
        try:
            inspection = inspect(path, nominal(**made.nominal), made.cutter * 1000, made.tolerance * 1000)
        except WorkError as error:
            return Judgement("Inspection", f"Not inspected: {error}.", "not inspected")
        found.append(inspection)
        worst = inspection.worst
        outcome = f"worst trough to peak {inches(worst.trough_to_peak)} in, {worst.wall} wall, {worst.place}"
        if made.instrument:
            return Judgement(made.instrument, f"The stylus follows the walls: {outcome}.", outcome)
        said = f"The thesis measured no such part; computed: {outcome}."
        return Judgement("Inspection", said, outcome)

    sources = {name: shelf.read_bundled(name) for name in PROGRAMS}
    day = Day(part, made.program()(), sources, judge, tell)
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
        found[0] if found else None,
        day.minutes,
    )
