"""The keys of a Model 33 and its paper: the frames that its keys send, and the lines that it types.

The keys send capitals, with channel 8 always set.

    key         at a terminal   sends
    RETURN      Enter           215
    LINE FEED   Ctrl-J          212
    FORM FEED   Ctrl-L          214
    RUBOUT      Backspace       377
    ALT MODE    Esc             375
    HERE IS     Ctrl-\\          twenty blank frames, from a drum that nobody has coded
    CTRL A-Z    Ctrl-A to -Z    201 to 232

A small letter presses the key of its capital. A character without a key sends nothing: `{ | } ~`, the accent
grave, and all that is not ASCII.

The paper has 72 columns; the carriage stays at the last one. Of two characters in one place the paper shows
the later; a space hides nothing.

Source: Teletype Model 33 keyboard; Small Computer Handbook 1970, appendix (ASR-33 codes).
"""

from pdp8.computer.hardware.teletype import PASSED_OVER, TYPES

COLUMNS = 72

_SENDS = (
    {chr(code): bytes([0o200 | code]) for code in range(0o140)}
    | {chr(code): bytes([code + 0o140]) for code in range(0o141, 0o173)}
    | {"\x1b": b"\xfd", "\x7f": b"\xff", "\x1c": bytes(20)}
)


def sent(typed: str) -> bytes:
    """Return the frames for what is typed at a terminal."""
    return b"".join(_SENDS.get(character, b"") for character in typed)


class Paper:
    """The last `kept` lines that were typed, and the carriage's column."""

    def __init__(self, kept: int) -> None:
        self.kept = kept
        self.lines = [""]
        self.column = 0

    def take(self, frame: int) -> str:
        """Print one frame as a Model 33 does; return the character it acts on, "" for none."""
        character = "" if frame in PASSED_OVER else chr(TYPES[frame])
        if character == "\r":
            self.column = 0
        elif character == "\n":
            self.lines = [*self.lines[1 - self.kept :], ""]
        elif character not in ("", "\a"):
            self._strike(character)
        return character

    def _strike(self, character: str) -> None:
        line = self.lines[-1].ljust(self.column)
        before = line[self.column : self.column + 1].strip()
        if before and character == " ":
            character = before
        self.lines[-1] = line[: self.column] + character + line[self.column + 1 :]
        self.column = min(self.column + 1, COLUMNS - 1)
