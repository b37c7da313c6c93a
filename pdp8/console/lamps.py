"""The lamps of the panel, each as bright as it was often on while the room looked once.

    MEMORY ADDRESS    ○ ○ ○  ● ○ ○  ○ ○ ○  ○ ○ ○   0200    ● FETCH    ○ WORD COUNT   ○ ION
    MEMORY BUFFER     ● ● ○  ○ ○ ○  ● ○ ○  ● ● ○   6046    ○ DEFER    ○ CURR ADDR    ○ PARITY
    ...

Between two looks the lamps of a running machine change many thousand times; a filament shows the mean, and so
do these.

Not emulated: a filament's own slowness; EMA, which belongs to the memory extension.
"""

from rich.style import Style
from rich.text import Text

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

_MNEMONICS = ("AND", "TAD", "ISZ", "DCA", "JMS", "JMP", "IOT", "OPR")
_ROWS = (
    ("MEMORY ADDRESS", "MEM ADDR", "ma"),
    ("MEMORY BUFFER", "MEM BUFF", "mb"),
    ("ACCUMULATOR", "ACC", "ac"),
)
_STATES = (
    (("fetch", "FETCH", "FETCH"), ("word_count", "WORD COUNT", "WC"), ("ion", "ION", "ION")),
    (("defer", "DEFER", "DEFER"), ("current_address", "CURR ADDR", "CA"), ("parity", "PARITY", "PARITY")),
    (("execute", "EXECUTE", "EXECUTE"), ("break_", "BREAK", "BREAK"), ("protect", "PROTECT", "PROTECT")),
)


def lamp(brightness: float) -> tuple[str, Style]:
    """Return a lamp as a character and its colour; a dark one has a shape of its own."""
    return "●" if brightness > 0.04 else "○", _STYLES[round(brightness * _LEVELS)]


class LampRows(Page):
    """Memory address, memory buffer, accumulator with link; instruction register, states, RUN."""

    DEFAULT_CSS = "LampRows { height: 5; }"

    def look(self) -> object:
        return self.session.brightness, self.session.machine.panel.lamps

    def render(self) -> Text:
        """Draw the rows to the width there is: a lamp takes three columns, or two."""
        wide = self.size.width >= 95
        rows = [self._numbers(wide), *(self._word(number, wide) for number in range(3)), self._last(wide)]
        return Text("\n").join(rows)

    def _numbers(self, wide: bool) -> Text:
        row = Text(" " * label_width(wide))
        for bit in range(12):
            row.append(f"{bit:<{pitch(wide)}}", _LABEL if bit // 3 % 2 == 0 else _FAINT)
            row.append(" " if bit % 3 == 2 else "")
        return row

    def _word(self, number: int, wide: bool) -> Text:
        long, short, field = _ROWS[number]
        row = Text()
        label = long if wide else short
        if field == "ac":
            row.append(f"{label:<{label_width(wide) - 4}}", _LABEL)
            row.append("L ", _FAINT).append(*lamp(self.session.brightness["link"][0])).append(" ")
        else:
            row.append(f"{label:<{label_width(wide)}}", _LABEL)
        for bit, brightness in enumerate(self.session.brightness[field]):
            row.append(*lamp(brightness)).append(" " * (pitch(wide) - 1 + (bit % 3 == 2)))
        running = self.session.machine.panel.lamps.run
        row.append("     " if running else f"{getattr(self.session.machine, field):04o} ", _OCTAL)
        for place, (name, full, brief) in enumerate(_STATES[number]):
            text = full if wide else brief
            row.append(*lamp(self.session.brightness[name][0]))
            row.append(f" {text:<{_widths(wide)[place]}}", _LABEL)
        return row

    def _last(self, wide: bool) -> Text:
        row = Text(f"{'INSTRUCTION' if wide else 'INSTR':<{label_width(wide)}}", _LABEL)
        for brightness in self.session.brightness["ir"]:
            row.append(*lamp(brightness)).append(" " * (pitch(wide) - 1))
        lamps = self.session.machine.panel.lamps
        row.append(" ").append("   " if lamps.run else _MNEMONICS[lamps.ir], _OCTAL)
        row.append(" " * (9 * pitch(wide) + 5 + sum(_widths(wide)[:2]) + 4))
        row.append(*lamp(self.session.brightness["run"][0])).append(" RUN", _LABEL)
        return row


def _widths(wide: bool) -> tuple[int, int, int]:
    """Return how many columns the words beside the lamps of the states have."""
    return (9, 11, 7) if wide else (9, 6, 7)


def pitch(wide: bool) -> int:
    """Return how many columns a lamp takes, and the switch under it."""
    return 3 if wide else 2


def label_width(wide: bool) -> int:
    """Return how many columns stand before the first lamp."""
    return 17 if wide else 13
