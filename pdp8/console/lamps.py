"""The lamps of the panel, each as bright as its share of the time between two looks.

    MEMORY ADDRESS    ○ ○ ○  ● ○ ○  ○ ○ ○  ○ ○ ○   0200    ● FETCH    ○ WORD COUNT   ○ ION
    MEMORY BUFFER     ● ● ○  ○ ○ ○  ● ○ ○  ● ● ○   6046    ○ DEFER    ○ CURR ADDR    ○ PARITY
    ...

Between two looks the lamps of a running machine change many thousand times; a filament shows the mean, and so
do these.

EMA is there with the memory extension. Not emulated: a filament's own slowness.
"""

from typing import NamedTuple

from rich.style import Style
from rich.text import Text

from pal.isa import OPERATIONS
from pdp8.computer.hardware.extension import FIELD
from pdp8.console.pages import Page

ON, OFF = (255, 190, 92), (84, 66, 48)
_LEVELS = 12
_STYLES = [
    Style(
        color="rgb({},{},{})".format(
            *(round(low + (high - low) * step / _LEVELS) for low, high in zip(OFF, ON, strict=True))
        )
    )
    for step in range(_LEVELS + 1)
]
_LABEL = Style(color="#d8c7a4")
_FAINT = Style(color="#9a876a")
_OCTAL = Style(color="#ffd9a0", bold=True)

# Each label where there is little room, and where there is more.
_ROWS = (
    (("MEM ADDR", "MEMORY ADDRESS"), "ma"),
    (("MEM BUFF", "MEMORY BUFFER"), "mb"),
    (("ACC", "ACCUMULATOR"), "ac"),
)
_STATES = (
    (("fetch", "FETCH", "FETCH"), ("word_count", "WC", "WORD COUNT"), ("ion", "ION", "ION")),
    (("defer", "DEFER", "DEFER"), ("current_address", "CA", "CURR ADDR"), ("parity", "PARITY", "PARITY")),
    (("execute", "EXECUTE", "EXECUTE"), ("break_", "BREAK", "BREAK"), ("protect", "PROTECT", "PROTECT")),
)


class Columns(NamedTuple):
    """Widths in columns: of the label before the lamps, of a lamp, of the names of states."""

    label: int
    lamp: int
    states: tuple[int, int, int]
    wide: bool


def columns(width: int) -> Columns:
    """Return the columns for a panel of this width."""
    return Columns(17, 3, (9, 11, 7), True) if width >= 95 else Columns(13, 2, (9, 6, 7), False)


def lamp(brightness: float) -> tuple[str, Style]:
    """Return a lamp as a character and its colour; a dark one has a shape of its own."""
    return "●" if brightness > 0.04 else "○", _STYLES[round(brightness * _LEVELS)]


class LampRows(Page):
    """Memory address, memory buffer, accumulator with link; instruction register, states, RUN."""

    DEFAULT_CSS = "LampRows { height: 5; }"

    def look(self) -> object:
        panel = self.session.machine.panel
        return self.session.brightness, panel.lamps, panel.ema

    def render(self) -> Text:
        """Draw the rows to the width there is."""
        room = columns(self.size.width)
        rows = [self._numbers(room), *(self._word(number, room) for number in range(3)), self._last(room)]
        return Text("\n").join(rows)

    def _numbers(self, room: Columns) -> Text:
        row = Text(" " * room.label)
        for bit in range(12):
            row.append(f"{bit:<{room.lamp}}", _LABEL if bit // 3 % 2 == 0 else _FAINT)
            row.append(" " if bit % 3 == 2 else "")
        return row

    def _word(self, number: int, room: Columns) -> Text:
        labels, field = _ROWS[number]
        beside = {"ac": ("L ", self.session.brightness["link"][0])}
        if self.session.machine.memory > FIELD:
            beside["ma"] = "EMA ", float(self.session.machine.panel.ema > 0)
        name, lit = beside.get(field, ("", 0.0))
        width = room.label - (len(name) + 2 if name else 0)
        label = labels[room.wide]
        row = Text().append(f"{label if len(label) < width else label.split()[-1]:<{width}}", _LABEL)
        if name:
            row.append(name, _FAINT).append(*lamp(lit)).append(" ")
        for bit, brightness in enumerate(self.session.brightness[field]):
            row.append(*lamp(brightness)).append(" " * (room.lamp - 1 + (bit % 3 == 2)))
        lamps = self.session.machine.panel.lamps
        row.append("     " if lamps.run else f"{getattr(lamps, field):04o} ", _OCTAL)
        for (name, *words), width in zip(_STATES[number], room.states, strict=True):
            row.append(*lamp(self.session.brightness[name][0]))
            row.append(f" {words[room.wide]:<{width}}", _LABEL)
        return row

    def _last(self, room: Columns) -> Text:
        row = Text(f"{('INSTR', 'INSTRUCTION')[room.wide]:<{room.label}}", _LABEL)
        for brightness in self.session.brightness["ir"]:
            row.append(*lamp(brightness)).append(" " * (room.lamp - 1))
        lamps = self.session.machine.panel.lamps
        row.append(" ").append("   " if lamps.run else OPERATIONS[lamps.ir], _OCTAL)
        row.append(" " * (9 * room.lamp + 5 + sum(room.states[:2]) + 4))
        row.append(*lamp(self.session.brightness["run"][0])).append(" RUN", _LABEL)
        return row
