"""What the operator is asked: which tape goes into the reader, what a torn-off tape is to be called."""

from typing import ClassVar

from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen
from textual.widgets import Input, Label, OptionList

from pdp8.console.session import Tape
from tapes import shelf
from tapes.errors import WorkError
from tapes.measure import length


class ChooseTape(ModalScreen[Tape | None]):
    """A tape of those at hand, or a file by its name."""

    BINDINGS: ClassVar[list[BindingType]] = [("escape", "dismiss(None)", "back")]

    def __init__(self, tapes: list[Tape]) -> None:
        super().__init__()
        self.tapes = tapes

    def compose(self) -> ComposeResult:
        """List the tapes at hand above a line for a name."""
        with Vertical(classes="dialog"):
            yield Label("Which tape goes into the reader? ESC: none")
            yield OptionList(
                *(f"{tape.name:<16} {length(len(tape.frames)):>14}" for tape in self.tapes), markup=False
            )
            yield Input(placeholder="or a file's name, or a bundled one")
            yield Label("", classes="wrong", markup=False)

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Take the tape that was chosen."""
        self.dismiss(self.tapes[event.option_index])

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Take the file that was named, if it can be read."""
        name = event.value.strip()
        if not name:
            return
        try:
            if name == "-":
                raise WorkError("-: the keyboard is no tape")
            self.dismiss(Tape(name, shelf.read(name)))
        except WorkError as error:
            self.query_one(".wrong", Label).update(str(error))


class NameTape(ModalScreen[str | None]):
    """A name for the tape that is torn off, and written under it."""

    BINDINGS: ClassVar[list[BindingType]] = [("escape", "dismiss(None)", "back")]

    def compose(self) -> ComposeResult:
        """Ask for the name."""
        with Vertical(classes="dialog"):
            yield Label("Tear the tape off the punch and write it to which file? ESC: leave it")
            yield Input(value="punched.tape")

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Take the name."""
        self.dismiss(event.value.strip() or None)
