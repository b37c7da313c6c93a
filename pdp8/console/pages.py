"""What lies on the table beside the machine: the printed page, the listing, core, the operator's or a drill's
card.
"""

from string import ascii_lowercase
from textwrap import wrap
from typing import ClassVar

from rich.style import Style
from rich.text import Text
from textual import events
from textual.binding import Binding, BindingType
from textual.content import Content
from textual.reactive import reactive
from textual.widget import Widget

from pdp8.computer.use import keys
from pdp8.computer.use.operator import RIM, RIM_START
from pdp8.computer.use.program import Program
from pdp8.console.opening import label
from pdp8.console.session import Session
from pdp8.lessons.drill import Coach
from tapes import codes
from tapes.quantities import duration

_INK = Style(color="#2d2618")
_BRIGHT = Style(color="#ffe9c4")
_LABEL = Style(color="#d8c7a4")
_FAINT = Style(color="#9a876a")
_HERE = Style(color="#1d160e", bgcolor="#ffc46b", bold=True)
_LAST = Style(color="#ffd9a0", bold=True, underline=True)
_KEYS = {
    "enter": "\r",
    "backspace": "\x7f",
    **{f"ctrl+{letter}": chr(ord(letter) & 0o37) for letter in ascii_lowercase},
}
_LINES = 200
_CARD_WIDTH = 48
_STEPS = 12
"""Lines of a drill that are shown at once."""


def frame(widget: Widget, above: str, below: str = "") -> None:
    """Write on the edges of the widget's frame, as plain text: a file's name may look like markup."""
    if widget.border_title != Content(above).markup:
        widget.border_title = Text(above)
    if widget.border_subtitle != Content(below).markup:
        widget.border_subtitle = Text(below)


class Page(Widget):
    """A widget that is redrawn when what it depends on has changed."""

    state: reactive[object] = reactive(None)

    def __init__(self, session: Session, name: str) -> None:
        super().__init__(id=name)
        self.session = session

    def look(self) -> object:
        """Set the title, and return what the page depends on."""
        raise NotImplementedError

    def show(self) -> None:
        """Redraw if something has changed."""
        self.state = self.look()


class Paper(Page, can_focus=True):
    """The Teletype's page: 72 columns, upper case, and what a code does to the carriage."""

    DEFAULT_CSS = "Paper { height: 1fr; }"
    BINDINGS: ClassVar[list[BindingType]] = [Binding("tab,escape", "app.turn_round", "back to the panel")]

    def __init__(self, session: Session, name: str) -> None:
        super().__init__(session, name)
        self.typed = keys.Paper(_LINES)
        self.struck = 0
        session.machine.teletype.printer.on_frame = self.take

    def on_key(self, event: events.Key) -> None:
        """Type what is typed: RETURN, RUBOUT, CTRL with a letter, and every key with a character."""
        if event.key in ("tab", "escape"):
            return
        typed = _KEYS.get(event.key, event.character or "")
        if typed:
            self.session.machine.teletype.keyboard.press(keys.sent(typed))
            event.stop()

    def on_paste(self, event: events.Paste) -> None:
        """Type what is pasted, with RETURN at the end of a line."""
        text = event.text.replace("\r\n", "\r").replace("\n", "\r")
        self.session.machine.teletype.keyboard.press(keys.sent(text))

    def clear(self) -> None:
        self.typed = keys.Paper(_LINES)
        self.struck += 1

    def take(self, frame: int) -> None:
        """Print one frame."""
        self.struck += 1
        self.typed.take(frame)

    def look(self) -> object:
        """Look again, and say who the keys are for."""
        frame(self, "Teletype: you type here, ESC goes back" if self.has_focus else "Teletype (TAB to type)")
        return (self.has_focus, self.struck)

    def render(self) -> Text:
        width, height = self.size
        lines, column = self.typed.lines, self.typed.column
        start = max(0, column - width + 1)
        shown = [*lines[:-1], lines[-1].ljust(column)][-height:]
        text = Text("\n" * (height - len(shown)), _INK)
        text.append("\n".join(line[start : start + width] for line in shown), _INK)
        if self.has_focus:
            text.append("▁", Style(color="#c0392b", bold=True))
        return text


class ListingPage(Page):
    """The listing that fits core where the PC points, the line of the PC lit."""

    def __init__(self, session: Session, name: str, programs: list[Program]) -> None:
        super().__init__(session, name)
        self.programs = programs
        self.program = programs[-1]

    def look(self) -> object:
        """Find a listing that fits core, the present one if it still does."""
        address = self.session.address
        word = self.session.machine.core[address]
        fitting = (each for each in (self.program, *self.programs) if each.listing.fits(address, word))
        found = next(fitting, None)
        self.program = found or self.program
        where = f"{address:04o}" if found else f"{address:04o} is not in it"
        frame(self, f"listing of {self.program.name} · PC {where}")
        return (self.program.name, address, found is None)

    def render(self) -> Text:
        address = self.session.address
        listing = self.program.listing
        middle = listing.places.get(address, 0)
        here = middle if listing.fits(address, self.session.machine.core[address]) else None
        height, width = self.size.height, self.size.width
        first = max(0, min(middle - height // 2, len(listing.lines) - height))
        text = Text()
        for number, line in enumerate(listing.lines[first : first + height], first):
            shown = f"{'▸' if number == here else ' '}{line}"[:width]
            text.append(f"{shown:<{width}}" if number == here else shown, _HERE if number == here else _LABEL)
            text.append("\n")
        text.right_crop(1)
        return text


class Core(Page):
    """Core about the PC: its word lit, that of the memory address underlined."""

    def look(self) -> object:
        frame(self, f"core about the PC, {self.session.address:04o}")
        return list(self.session.machine.core), self.session.address, self.session.machine.ma

    def render(self) -> Text:
        machine, pc = self.session.machine, self.session.address
        words = 8 if self.size.width >= 46 else 4
        rows = min(self.size.height, machine.memory // words)
        first = max(0, min(pc // words - rows // 2, machine.memory // words - rows))
        text = Text()
        for row in range(first, first + rows):
            text.append(f"{row * words:04o} ", _FAINT)
            for address in range(row * words, row * words + words):
                text.append(" ")
                style = _HERE if address == pc else _LAST if address == machine.ma else None
                word = machine.core[address]
                text.append(f"{word:04o}", style or (_LABEL if word else _FAINT))
            text.append("\n")
        text.right_crop(1)
        return text


class Card(Page):
    """The operator's card: the RIM loader word by word, ticked where core has it, and what comes after."""

    def __init__(self, session: Session, name: str, rim: Program, program: Program) -> None:
        super().__init__(session, name)
        lines, places = rim.listing.lines, rim.listing.places
        self.statements = {address: _statement(lines[place]) for address, place in places.items()}
        reads = "7756 L S, at its end T" if program.code is codes.RIM else "7777 L S, halts, AC 0"
        self.steps = (
            "1 RIM: SR 7756 L, then each word D",
            "2 bin.rim: O, SR 7756 L S, at its end T",
            f"3 {label(program)}: O, SR {reads}",
            "4 its data: O, SR 0200 L S",
        )

    def look(self) -> object:
        frame(self, "RIM loader · R toggles it in for you")
        core, start = self.session.machine.core, self._start
        return [core[start + place] for place in range(len(RIM))], start, self.session.address

    @property
    def _start(self) -> int:
        """Where the loader goes: in the field that INST FIELD says."""
        return self.session.machine.panel.inst_field << 12 | RIM_START

    def render(self) -> Text:
        wide = self.size.width >= _CARD_WIDTH
        height = -(-len(RIM) // (2 if wide else 3))
        text = Text()
        for row in range(height):
            for place in range(row, len(RIM), height):
                text.append_text(self._word(place, wide)).append("  ")
            text.append("\n")
        for step in self.steps:
            text.append(f"{step}\n", _FAINT)
        text.right_crop(1)
        return text

    def _word(self, place: int, wide: bool) -> Text:
        address, word = self._start + place, RIM[place]
        there = self.session.machine.core[address] == word
        tick, ticked = "✓" if there else "·", _BRIGHT if there else _FAINT
        here = _HERE if address == self.session.address else None
        text = Text(f"{address:04o}", here or _FAINT).append(f" {word:04o}", here or _BRIGHT)
        if wide:
            return text.append(f" {self.statements[RIM_START + place]:<11}", _LABEL).append(
                f"{tick} ", ticked
            )
        return text.append(tick, here or ticked)


def _statement(line: str) -> str:
    """Return the statement of a listing's line, without numbers, tag and comment."""
    return line[12:].split("/", maxsplit=1)[0].rpartition(",")[2].strip()


class DrillCard(Page):
    """A drill's card."""

    def __init__(self, session: Session, name: str, coach: Coach) -> None:
        super().__init__(session, name)
        self.coach = coach

    def look(self) -> object:
        """Set the title; the card depends on the step, on what was said, and on the whole seconds."""
        coach = self.coach
        below = f"{duration(int(coach.seconds))} · {coach.wrong} wrong · X begins again"
        frame(self, f"drill: {coach.drill.title}", below)
        return coach.at, coach.said, coach.wrong

    def render(self) -> Text:
        coach, steps = self.coach, self.coach.drill.steps
        first = max(0, min(coach.at - _STEPS // 3, len(steps) - _STEPS))
        said = wrap(coach.said, max(20, self.size.width))
        lines = [*(Text(line, style="bold") for line in said), Text("")]
        for number, step in enumerate(steps[first : first + _STEPS], first):
            mark = "✓" if number < coach.at else "▸" if number == coach.at else " "
            style = "bold" if number == coach.at else "dim" if number < coach.at else ""
            lines.append(Text(f"{mark} {step.say}", style=style))
        return Text("\n").join(lines)
