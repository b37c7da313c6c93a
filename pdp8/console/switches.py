"""The switches under the lamps: twelve rockers of the switch register, and the keys.

    SWITCH REGISTER   ▀ ▄ ▀  ...   up is 1, under the lamp it sets; the hand's rocker is red
    MEM PROT  LOAD ADD  START  CONT  STOP  SING STEP  EXAM  DEP

A rocker is thrown by a click, or with the hand: left and right move it, up and down throw. Of a key the
underlined letter is its key.
"""

from rich.style import Style
from rich.text import Text
from textual import events
from textual.containers import Horizontal
from textual.reactive import reactive
from textual.widget import Widget
from textual.widgets import Static

from pdp8.console.lamps import columns
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
LOCKING = ("mem_prot", "sing_step")


class Rocker(Widget):
    """One switch of the switch register, `bit` 0 the leftmost."""

    DEFAULT_CSS = "Rocker { height: 2; }"
    state: reactive[object] = reactive(None)

    def __init__(self, session: Session, bit: int) -> None:
        super().__init__(id=f"sr{bit}")
        self.session = session
        self.bit = bit
        self.held = False

    @property
    def up(self) -> bool:
        """Whether it is up, a 1."""
        return bool(self.session.machine.sr & 0o4000 >> self.bit)

    def show(self, held: bool) -> None:
        """Show it as it is now, and whether the hand is on it."""
        self.held = held
        self.state = (self.up, held)

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


class Key(Widget):
    """A key or a locking switch, with its letter."""

    DEFAULT_CSS = "Key { height: 2; width: 1fr; text-align: center; }"
    state: reactive[object] = reactive(None)
    down: reactive[bool] = reactive(False)

    def __init__(self, session: Session, name: str, label: str, letter: str) -> None:
        super().__init__(id=name)
        self.session = session
        self.label = label
        self.letter = letter

    async def on_click(self, event: events.Click) -> None:
        event.stop()
        await self.run_action(f"app.key('{self.id}')")

    @property
    def active(self) -> bool:
        """Whether it is a locking switch that is on."""
        return self.id in LOCKING and bool(getattr(self.session.machine.panel, self.id))

    def show(self) -> None:
        self.state = self.active

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
        up = self.active == (self.id == "mem_prot")
        return Text("▐▀▀▌" if up else "▐▄▄▌", Style(color=_HAND if self.active else _RUST))


class SwitchRegister(Horizontal):
    """The twelve rockers, each under the lamps of its bit, and what they come to."""

    DEFAULT_CSS = "SwitchRegister { height: 2; } SwitchRegister Static { height: 2; color: #d8c7a4; }"

    def __init__(self, session: Session) -> None:
        self.session = session
        self.label = Static()
        self.rockers = [Rocker(session, bit) for bit in range(12)]
        self.octal = Static()
        self.hand = 0
        self.shown = -1
        super().__init__(self.label, *self.rockers, self.octal)

    def on_resize(self) -> None:
        """Keep every rocker under its lamps."""
        room = columns(self.size.width)
        self.label.styles.width = room.label - 1
        self.label.update("SWITCH REGISTER" if room.wide else "SWITCHES")
        for bit, rocker in enumerate(self.rockers):
            rocker.styles.width = room.lamp
            rocker.styles.margin = (0, 1 if bit % 3 == 2 else 0, 0, 0)
        self.octal.styles.width = 6
        self.show()

    def show(self) -> None:
        focused = self.screen.focused
        at_panel = focused is not None and focused.id == "panel"
        for bit, rocker in enumerate(self.rockers):
            rocker.show(held=at_panel and bit == self.hand)
        word = self.session.machine.sr
        if word != self.shown:
            self.shown = word
            self.octal.update(Text(f" {word:04o}", Style(color="#ffd9a0", bold=True)), layout=False)
