"""The room: the panel above, Teletype and tapes at the left, listing, core and card at the right.

    ┌ panel: lamps, switches, keys ──────────────────┐
    ├ reader ──┬ punch ────┬ card, listing or core ──┤
    ├ paper ───┴───────────┤ (where wide all three,  │
    └ keys ────────────────┴ the Teletype at right) ─┘

The keys of the keyboard are the operator's hands at the panel, or, after TAB, fingers at the Teletype.
"""

import asyncio
import os
from time import perf_counter
from typing import Any, ClassVar

from textual import events
from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Container, Horizontal
from textual.widgets import Footer, Static

from pdp8 import leaving, shelf
from pdp8.computer.use.program import Program
from pdp8.console.dialogs import AskToLeave, ChooseTape, NameTape
from pdp8.console.lamps import LampRows
from pdp8.console.pages import Card, Core, DrillCard, ListingPage, Page, Paper, frame
from pdp8.console.session import Session, Tape
from pdp8.console.strips import PunchStrip, ReaderStrip
from pdp8.console.switches import FIELDS, KEYS, LOCKING, Key, Rocker, SwitchRegister
from pdp8.lessons.drill import Coach
from tapes.errors import WorkError
from tapes.quantities import duration

TURN = 0.05  # seconds between two looks
SMALLEST = (80, 24)
_PAGES = ("card", "listing", "core")
_WIDE, _TALL = 150, 34
_WIDTHS = ((0, "-narrow"), (100, "-normal"), (_WIDE, "-wide"))
_HEIGHTS = ((0, "-short"), (30, "-tall"))


def _letter(letter: str, action: str, label: str, show: bool = True) -> tuple[Binding, Binding]:
    """Return the key bindings of a letter, in both cases."""
    return Binding(letter, action, label, show=show), Binding(letter.upper(), action, label, show=False)


class PanelFace(Container, can_focus=True):
    """The panel itself; while it has the focus the keyboard's keys are its keys and switches."""

    BINDINGS: ClassVar[list[BindingType]] = [
        *(
            key
            for name, label, letter in KEYS + FIELDS
            for key in _letter(letter, f"app.key('{name}')", label, False)
        ),
        *(Binding(str(digit), f"app.dial({digit})", show=False) for digit in range(8)),
        Binding("left", "app.hand(-1)", show=False),
        Binding("right", "app.hand(1)", show=False),
        Binding("up", "app.throw(1)", show=False),
        Binding("down", "app.throw(0)", show=False),
        *_letter("r", "app.rim", "RIM"),
        *_letter("o", "app.tape", "tape"),
        *_letter("v", "app.lever", "lever"),
        *_letter("u", "app.punch", "punch"),
        *_letter("w", "app.tear", "tear"),
        *_letter("p", "app.pace", "pace"),
        *_letter("g", "app.page", "page"),
        Binding("ctrl+c", "app.key('stop')", "STOP"),
        *_letter("b", "app.undo(0)", "back", False),
        *_letter("z", "app.undo(1)", "1 s back", False),
        *_letter("x", "app.again", "again", False),
        *_letter("q", "app.quit", "quit"),
        Binding("tab", "app.turn_round", "Teletype"),
    ]


class Room(App[None]):
    """The panel in the terminal; `programs` are RIM, BIN and the user's; without `ticking` no time passes."""

    CSS_PATH = "room.tcss"
    TITLE = "PDP-8/L"
    ENABLE_COMMAND_PALETTE = False
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("ctrl+q", "leave", show=False),
        Binding("ctrl+c", "key('stop')", show=False),
    ]
    HORIZONTAL_BREAKPOINTS = [*_WIDTHS]  # noqa: RUF012
    VERTICAL_BREAKPOINTS = [*_HEIGHTS]  # noqa: RUF012

    def __init__(
        self, session: Session, programs: list[Program], ticking: bool = True, coach: Coach | None = None
    ) -> None:
        super().__init__()
        self.coach = coach
        self.session = session
        self.programs = programs
        self.ticking = ticking
        self.shown_page = self._first_page = "listing" if session.machine.core[session.address] else "card"
        self._at_hand = [*session.tapes]
        self._before = 0.0
        self._signal = 0
        self._turns: asyncio.AbstractEventLoop | None = None

    def operate(self) -> int:
        """Run until the panel is left or a signal ends it; return the exit status."""
        with leaving.taken(self._ask_to_end, "SIGINT", *leaving.ENDS):
            self.run()
        return self.return_code or 0

    def compose(self) -> ComposeResult:
        session = self.session
        yield Static("The panel needs a terminal of 80 columns and 24 lines.", id="cramped")
        with PanelFace(id="panel"):
            yield LampRows(session, "lamps")
            yield SwitchRegister(session)
            with Horizontal(id="keys"):
                yield from (Key(session, *key) for key in KEYS)
        with Container(id="teletype"):
            with Container(id="tapes"):
                yield ReaderStrip(session, "reader")
                yield PunchStrip(session, "punch")
            yield Paper(session, "paper")
        with Container(id="pages"):
            if self.coach is not None:
                yield DrillCard(session, "card", self.coach)
            else:
                yield Card(session, "card", self.programs[0], self.programs[-1])
            yield ListingPage(session, "listing", self.programs)
            yield Core(session, "core")
        yield Footer(compact=True)

    def on_mount(self) -> None:
        self.query_one("#panel").focus()
        self._turn_pages()
        self._turns = asyncio.get_running_loop()
        if self._signal:
            self._end()
        if self.ticking:
            self._before = perf_counter()
            self.set_interval(TURN, self._tick)

    def _ask_to_end(self, number: int, _: object) -> None:
        """End as a signal asks, with the terminal put back; at once if it is closed: Textual would wait."""
        try:
            os.get_terminal_size(0)
        except OSError:
            os._exit(128 + number)
        self._signal = number
        if self._turns is not None:  # before, `on_mount` looks
            self._turns.call_soon_threadsafe(self._end)

    def on_unmount(self) -> None:
        self._turns = None

    def _end(self) -> None:
        self.exit(None, 128 + self._signal)

    def on_resize(self, event: events.Resize) -> None:
        small = event.size.width < SMALLEST[0] or event.size.height < SMALLEST[1]
        self.screen_stack[0].set_class(small, "-cramped")
        self._turn_pages(event.size.width, event.size.height)

    def _turn_pages(self, width: int = 0, height: int = 0) -> None:
        width, height = width or self.size.width, height or self.size.height
        everything = width >= _WIDE and height >= _TALL
        self.query_one("#pages").set_class(everything, "all")
        for name in _PAGES:
            self.query_one(f"#{name}").display = everything or name == self.shown_page
        self.look()

    def _tick(self) -> None:
        now = perf_counter()
        seconds, self._before = min(now - self._before, 4 * TURN), now
        self.turn(seconds)

    def turn(self, seconds: float) -> None:
        """Let `seconds` pass and show the result."""
        self.session.advance(seconds)
        if self.coach is not None and self.coach.advance(seconds):
            self._welcome()
        self.look()

    def _welcome(self) -> None:
        """Clear the room for the next visitor at a kiosk."""
        while len(self.screen_stack) > 1:
            self.pop_screen()
        self.session.clear(self._at_hand)
        self.query_one(Paper).clear()
        self.query_one("#panel").focus()
        self.shown_page = self._first_page
        self._turn_pages()

    def look(self) -> None:
        """Show everything as it is now."""
        screen = self.screen_stack[0]
        panel = screen.query_one("#panel")
        frame(panel, "digital · PDP-8/L", self._status())
        for page in screen.query(Page):
            if page.display:
                page.show()

    def _status(self) -> str:
        """Return the status line, with the clock in whole seconds while the machine runs."""
        session = self.session
        elapsed = session.machine.elapsed
        clock = duration(int(elapsed) if session.machine.panel.lamps.run else elapsed)
        pace = "real pace" if session.speed == 1 else f"×{session.speed}"
        return f"{session.said} · {clock} in 1971 · {'not quite ' if session.behind else ''}{pace}"

    async def run_action(self, *action: Any, **namespaces: Any) -> bool:
        """Do what a key or a click asks for, and show what has changed."""
        done = await super().run_action(*action, **namespaces)
        self.look()
        return done

    def action_key(self, name: str) -> None:
        """Press a key, or throw a locking switch."""
        if not self.query(f"#{name}"):
            return  # a field's switch where there is one field
        if self.coach is not None and name not in LOCKING and not self.coach.allows(name):
            return
        if name in LOCKING:
            self.session.lock(name)
        else:
            self.session.press(name)
        self.screen_stack[0].query_one(f"#{name}", Key).flash()

    def action_dial(self, digit: int) -> None:
        self.session.dial(digit)

    def action_flip(self, bit: int) -> None:
        self.session.throw(bit)

    def action_hand(self, by: int) -> None:
        self.session.hand = (self.session.hand + by) % 12

    def action_throw(self, up: int) -> None:
        if self.query_one(f"#sr{self.session.hand}", Rocker).up != bool(up):
            self.session.throw(self.session.hand)

    def action_rim(self) -> None:
        """Toggle the RIM loader in; in a drill the user does it."""
        if self.coach is not None:
            self.notify("in a drill you toggle it in yourself")
            return
        self.shown_page = "card"
        self._turn_pages()
        self.session.toggle_rim()

    def action_tape(self) -> None:
        def mount(tape: Tape | None) -> None:
            if tape is not None:
                self.session.mount(tape)
                self.look()

        self.push_screen(ChooseTape(self.session.tapes), mount)

    def action_lever(self) -> None:
        self.session.operator.throw_lever()

    def action_punch(self) -> None:
        punch = self.session.machine.teletype.punch
        punch.on = not punch.on

    def action_tear(self) -> None:
        if not self.session.machine.teletype.punch.frames:
            self.notify("nothing is punched yet")
            return
        self.push_screen(NameTape(), self._tear_off)

    def _tear_off(self, name: str | None) -> None:
        if name is None:
            return
        try:
            wrote = shelf.leave(name, self.session.machine.teletype.punch.tape, "tape")
        except WorkError as error:
            self.notify(str(error), severity="error", markup=False)
            return
        tape = self.session.tear_off(name)
        self.notify(f"{wrote}: {len(tape.frames):,} frames", markup=False)
        self.look()

    async def action_leave(self) -> None:
        """Leave a kiosk at once; else leave as Q does."""
        if self.coach is not None and self.coach.left_alone is not None:
            self.exit()
        else:
            await self.action_quit()

    async def on_event(self, event: events.Event) -> None:
        """Note that the panel is in use, before anything else is done with a key or the mouse."""
        if self.coach is not None and isinstance(event, events.Key | events.MouseDown):
            self.coach.touched()
        await super().on_event(event)

    async def action_quit(self) -> None:
        """Leave; ask first if a punched tape would be lost. A kiosk begins again, and Ctrl-Q leaves it."""
        if self.coach is not None and self.coach.left_alone is not None:
            self.action_again()
            return
        count = len(self.session.machine.teletype.punch.frames)
        if not count:
            self.exit()
            return

        def leave(yes: bool | None) -> None:
            if yes:
                self.exit()

        self.push_screen(AskToLeave(count), leave)

    def action_undo(self, seconds: int) -> None:
        """Undo an instruction, or that many seconds; not in a drill, which is done forwards."""
        if self.coach is None:
            self.session.back(seconds)
            paper = self.query_one(Paper)
            paper.clear()
            for each in self.session.machine.teletype.printer.frames:
                paper.take(each)

    def action_again(self) -> None:
        if self.coach is not None:
            self.coach.again()
            self._welcome()

    def action_pace(self) -> None:
        self.session.change_speed()

    def action_page(self) -> None:
        self.shown_page = _PAGES[(_PAGES.index(self.shown_page) + 1) % len(_PAGES)]
        self._turn_pages()

    def action_turn_round(self) -> None:
        at_paper = self.query_one("#paper").has_focus
        self.query_one("#panel" if at_paper else "#paper").focus()
        self.call_after_refresh(self.look)
