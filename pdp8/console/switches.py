"""The switches under the lamps: twelve rockers of the switch register, and the keys.

    SWITCH REGISTER   ▀ ▄ ▀  ...   up is 1, under the lamp it sets; the hand's rocker is red
    DATA FIELD  INST FIELD  with the memory extension
    MEM PROT  LOAD ADD  START  CONT  STOP  SING STEP  EXAM  DEP

A rocker is thrown by a click, or with the hand: left and right move it, up and down throw. Of a key the
underlined letter is its key.
"""

from rich.style import Style
from rich.text import Text
from textual import events
from textual.containers import Horizontal
from textual.reactive import reactive
from textual.widgets import Static

from pdp8.computer.hardware.extension import FIELD
from pdp8.console.lamps import columns
from pdp8.console.pages import Page
from pdp8.console.session import Session

_CREAM, _RUST, _HAND, _WELL = "#efe3c2", "#d07a35", "#ff5a45", "#4b3a2a"

KEYS = (
    ("mem_prot", "MEM PROT", "m"),
    ("load_add", "LOAD ADD", "l"),
    ("start", "START", "s"),
    ("cont", "CONT", "c"),
    ("stop", "STOP", "t"),
    ("sing_step", "SING STEP", "n"),
    ("exam", "EXAM", "e"),
    ("dep", "DEP", "d"),
)
FIELDS = (("data_field", "DATA FIELD", "f"), ("inst_field", "INST FIELD", "i"))
"""The switches of the memory extension, where it is fitted."""
LOCKING = ("mem_prot", "sing_step", "data_field", "inst_field")


class Rocker(Page):
    """One switch of the switch register, `bit` 0 the leftmost."""

    DEFAULT_CSS = "Rocker { height: 2; }"

    def __init__(self, session: Session, bit: int) -> None:
        super().__init__(session, f"sr{bit}")
        self.bit = bit

    @property
    def up(self) -> bool:
        """Whether it is up, a 1."""
        return bool(self.session.machine.sr & 0o4000 >> self.bit)

    @property
    def held(self) -> bool:
        """Whether the mouse button is held on it."""
        focused = self.screen.focused
        return self.session.hand == self.bit and focused is not None and focused.id == "panel"

    def look(self) -> object:
        return self.up, self.held

    async def on_click(self, event: events.Click) -> None:
        event.stop()
        await self.run_action(f"app.flip({self.bit})")

    def render(self) -> Text:
        wide = self.size.width >= 3
        colour = _HAND if self.held else (_CREAM if self.bit // 3 % 2 == 0 else _RUST)
        raised = ("▐█▌" if wide else "▐▌", Style(color=colour))
        well = ("▕ ▏" if wide else "▕▏", Style(color=_WELL))
        top, bottom = (raised, well) if self.up else (well, raised)
        return Text().append(*top).append("\n").append(*bottom)


class Key(Page):
    """A key or a locking switch, with its letter."""

    DEFAULT_CSS = "Key { height: 2; width: 1fr; text-align: center; }"
    down: reactive[bool] = reactive(False)

    def __init__(self, session: Session, name: str, label: str, letter: str) -> None:
        super().__init__(session, name)
        self.label = label
        self.letter = letter

    async def on_click(self, event: events.Click) -> None:
        event.stop()
        await self.run_action(f"app.key('{self.id}')")

    @property
    def active(self) -> bool:
        """Whether it is a locking switch that is on."""
        return self.id in LOCKING and bool(getattr(self.session.machine.panel, self.id))

    def look(self) -> object:
        return self.active

    def flash(self) -> None:
        self.down = True
        self.set_timer(0.15, self._let_go)

    def _let_go(self) -> None:
        self.down = False

    def render(self) -> Text:
        at = self.label.lower().index(self.letter)
        label = Text(self.label, Style(color="#e8d9b8"))
        label.stylize(Style(underline=True, bold=True, color="#ffd9a0"), at, at + 1)
        return self._cap().append("\n").append_text(label)

    def _cap(self) -> Text:
        if self.id not in LOCKING:
            return Text("▐██▌", Style(color=_HAND if self.down else _CREAM))
        up = self.active == (self.id != "sing_step")
        return Text("▐▀▀▌" if up else "▐▄▄▌", Style(color=_HAND if self.active else _RUST))


class Octal(Page):
    """The octal value of the switches."""

    DEFAULT_CSS = "Octal { height: 2; width: 6; }"

    def look(self) -> object:
        return self.session.machine.sr

    def render(self) -> Text:
        return Text(f" {self.session.machine.sr:04o}", Style(color="#ffd9a0", bold=True))


class SwitchRegister(Horizontal):
    """The twelve rockers, each under the lamps of its bit, and what they come to."""

    DEFAULT_CSS = "SwitchRegister { height: 2; } SwitchRegister Static { height: 2; color: #d8c7a4; }"

    def __init__(self, session: Session) -> None:
        self.label = Static()
        self.rockers = [Rocker(session, bit) for bit in range(12)]
        fields = FIELDS if session.machine.memory > FIELD else ()
        keys = (Key(session, *each) for each in fields)
        super().__init__(self.label, *self.rockers, Octal(session, "octal"), *keys)

    def on_resize(self) -> None:
        """Keep every rocker under its lamps."""
        room = columns(self.size.width)
        self.label.styles.width = room.label - 1
        self.label.update("SWITCH REGISTER" if room.wide else "SWITCHES")
        for bit, rocker in enumerate(self.rockers):
            rocker.styles.width = room.lamp
            rocker.styles.margin = (0, 1 if bit % 3 == 2 else 0, 0, 0)
