"""A tape where it is read or punched: rows of holes running up past the head, as `pdp8 tape show` has them.

┌ reader: circle.asc ──┐
│  o oo  .   o  1      │   read already
│> o ooo .      8      │   under the head: the next to be read, or the last punched
│  o oo  .o o  5       │   to come
"""

from rich.style import Style
from rich.text import Text

from pdp8.console.pages import Page, frame
from pdp8.console.session import Session
from tapes import codes
from tapes.frames import draw

_PAPER = Style(color="#2d2618", bgcolor="#f0e3bd")
_HEAD = Style(color="#2d2618", bgcolor="#ffc46b", bold=True)
_DONE = Style(color="#6d6046", bgcolor="#d9cca6")
_CAPTION = Style(color="#e8d9b8")
_EDGE = Style(color="#8b7a58")
_FAINT = Style(color="#9a876a")
_KNOWN = 2000  # frames by which a tape that is being punched tells its code


class Strip(Page):
    """A window on a tape, the head one third down or at the bottom."""

    DEFAULT_CSS = "Strip { height: 1fr; }"

    def rows(self, frames: bytes, said: list[str], first: int, head: int) -> Text:
        """Draw the rows from frame `first` on as far as there is room."""
        text = Text()
        room = max(0, self.size.width - 12)
        for number in range(first, first + self.size.height):
            if number > first:
                text.append("\n")
            if not 0 <= number < len(frames):
                text.append(" ")
                continue
            style = _HEAD if number == head else _DONE if number < head else _PAPER
            text.append("▸" if number == head else " ", _EDGE)
            text.append(draw(frames[number], hole="●", sprocket="·"), style)
            text.append(f" {said[number][:room]}", _FAINT if number < head else _CAPTION)
        return text


class ReaderStrip(Strip):
    """The tape in the reader."""

    def __init__(self, session: Session, name: str) -> None:
        super().__init__(session, name)
        self.captions: list[str] = []
        self.captioned = b""

    def look(self) -> object:
        reader = self.session.machine.teletype.reader
        if reader.tape is not self.captioned:
            self.captioned = reader.tape
            self.captions = codes.recognise(reader.tape).captions(reader.tape)
        name = self.session.reader_tape if reader.loaded else "reader"
        place = f"{reader.position:,} of {len(reader.tape):,}" if reader.loaded else ""
        frame(self, name if reader.on else f"STOP · {name}", place)
        return reader.tape, reader.position, reader.on

    def render(self) -> Text:
        reader = self.session.machine.teletype.reader
        if not reader.loaded:
            return Text("no tape: O", _FAINT)
        first = reader.position - max(1, self.size.height // 3)
        return self.rows(reader.tape, self.captions, first, reader.position)


class PunchStrip(Strip):
    """The tape that comes out of the punch."""

    def look(self) -> object:
        punch = self.session.machine.teletype.punch
        punched = f"{len(punch.frames):,} punched" if punch.frames else ""
        frame(self, "punch" if punch.on else "punch OFF", punched)
        return len(punch.frames), punch.on

    def render(self) -> Text:
        frames = self.session.machine.teletype.punch.frames
        if not frames:
            return Text("nothing punched", _FAINT)
        known = bytes(frames[-_KNOWN:])
        first = max(0, len(known) - self.size.height)
        return self.rows(known, codes.recognise(known).captions(known), first, len(known) - 1)
