"""What the operator is asked: which tape goes into the reader, a torn-off tape's name, whether to leave.

The keyboard is the name's: ENTER takes what is on its line, whether it was typed, or written there by the
arrows that go up and down the list. ESC and Ctrl-C leave without an answer.
"""

import os
from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen
from textual.widgets import Input, Label, OptionList

from pdp8 import shelf
from pdp8.console.session import Tape
from tapes.errors import WorkError
from tapes.measure import length
from tapes.quantities import counted

_NAMES = ("punched.tape", *(f"punched-{number}.tape" for number in range(2, 1000)), "tape")
"""What a tape that is torn off may be called."""
_LEAVE = Binding("escape,ctrl+c", "dismiss(None)", "back", priority=True)


class ChooseTape(ModalScreen[Tape | None]):
    """A dialog to choose a tape: one at hand, or a file."""

    AUTO_FOCUS = "Input"
    BINDINGS: ClassVar[list[BindingType]] = [
        _LEAVE,
        Binding("up", "step(-1)", show=False),
        Binding("down", "step(1)", show=False),
    ]

    def __init__(self, tapes: list[Tape]) -> None:
        super().__init__()
        self.tapes = tapes

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Label("Which tape goes into the reader? ESC: none")
            hand = OptionList(
                *(f"{tape.name:<16} {length(len(tape.frames)):>14}" for tape in self.tapes), markup=False
            )
            hand.can_focus = False
            yield hand
            yield Label("one at hand (↑ ↓), a file, or a bundled one:")
            yield Input(value=self.tapes[0].name)
            yield Label("", classes="wrong", markup=False)

    def action_step(self, by: int) -> None:
        """Go up or down the list and put the tape's name on the line."""
        at = self.query_one(OptionList).highlighted
        at = (0 if by > 0 else -1) if at is None else at + by
        line = self.query_one(Input)
        line.value = self.tapes[at % len(self.tapes)].name
        line.action_select_all()

    def on_input_changed(self, event: Input.Changed) -> None:
        """Highlight the tape whose name is on the line, if any."""
        names = [tape.name for tape in self.tapes]
        name = event.value.strip()
        self.query_one(OptionList).highlighted = names.index(name) if name in names else None
        self.query_one(".wrong", Label).update("")

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        self.dismiss(self.tapes[event.option_index])

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Take the tape that was named: one at hand, else a file, if it can be read."""
        name = event.value.strip()
        if not name:
            return
        try:
            self.dismiss(self._named(name))
        except WorkError as error:
            self.query_one(".wrong", Label).update(str(error))

    def _named(self, name: str) -> Tape:
        if name == "-":
            raise WorkError("-: the keyboard is no tape")
        at_hand = (tape for tape in self.tapes if tape.name == name)
        return next(at_hand, None) or Tape(name, shelf.read(name))


class AskToLeave(ModalScreen[bool]):
    """Asks whether to leave although a tape is still in the punch."""

    BINDINGS: ClassVar[list[BindingType]] = [
        _LEAVE,
        Binding("y,Y,q,Q", "dismiss(True)", "leave"),
        Binding("n,N", "dismiss(False)", "stay"),
    ]

    def __init__(self, frames: int) -> None:
        super().__init__()
        self.frames = frames

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Label(
                f"{counted(self.frames, 'frames')} punched and not torn off. Leave all the same? y or n"
            )


class NameTape(ModalScreen[str | None]):
    """A dialog for the name of the tape that is torn off."""

    BINDINGS: ClassVar[list[BindingType]] = [_LEAVE]

    def compose(self) -> ComposeResult:
        with Vertical(classes="dialog"):
            yield Label("Tear the tape off the punch and write it to which file? ESC: leave it")
            yield Input(value=next(name for name in _NAMES if not os.path.exists(name)))

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Take the name."""
        self.dismiss(event.value.strip() or None)
