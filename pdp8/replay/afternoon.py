"""One afternoon of 1971, done again, and what it left: from a part program to a milled and measured part."""

from collections.abc import Callable

from nc.inspection import Inspection, against
from nc.path import Path
from pdp8 import shelf
from pdp8.computer.machine import Machine
from pdp8.replay.day import PROGRAMS, Act, Day, Judgement
from programs.parts import find
from tapes.errors import WorkError
from tapes.quantities import inches


class Afternoon(Day):
    """The day of `part`, whose walls are measured; `inspection` is None without a curve to compare with."""

    def __init__(self, part: str, tell: Callable[[Act], object], machine: Machine | None = None) -> None:
        self.made = find(part)
        self.inspection: Inspection | None = None
        sources = {name: shelf.read_bundled(name) for name in PROGRAMS}
        super().__init__(part, self.made.program()(), sources, self._measured, tell, machine)

    def _measured(self, path: Path) -> Judgement:
        """Measure the walls that a path leaves."""
        made, nominal = self.made, self.made.nominal()
        if nominal is None:
            return Judgement("Inspection", "Not inspected: this part follows no curve.", "not inspected")
        try:
            self.inspection = against(path, nominal)
        except WorkError as error:
            return Judgement("Inspection", f"Not inspected: {error}.", "not inspected")
        worst = self.inspection.worst
        outcome = f"worst trough to peak {inches(worst.trough_to_peak)} in, {worst.wall} wall, {worst.place}"
        if made.instrument:
            said = f"At Mohawk College, it seems, the stylus follows the walls: {outcome}."
            return Judgement(made.instrument, said, outcome)
        said = f"The thesis measured no such part; computed: {outcome}."
        return Judgement("Inspection", said, outcome)


def replay(part: str, tell: Callable[[Act], object] = lambda act: None) -> Afternoon:
    """Do the whole afternoon of `part`; `tell` gets each act. Raises WorkError if a step fails."""
    afternoon = Afternoon(part, tell)
    for _ in afternoon.through():
        pass
    return afternoon
