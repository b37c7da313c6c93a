"""What every package raises when the work it was given is wrong.

The message names the place in the domain's own coordinate: a tape frame, a line and column, a block number,
an octal address. Commands print it as it is and exit with `exit_status`.
"""

from collections.abc import Iterator
from contextlib import contextmanager


class WorkError(ValueError):
    """Something wrong with the work given: a tape, a source, a part, a parameter. Exit status 1."""

    exit_status = 1


class TapeError(WorkError):
    """A tape that cannot be what it should be; `frame` counts from 0 at the first frame of the tape."""

    def __init__(self, message: str, frame: int | None = None) -> None:
        super().__init__(message if frame is None else f"frame {frame}: {message}")
        self.frame = frame


class TextError(WorkError):
    """A character of a text that has no place on the tape, named by its line and column, both from 1."""

    def __init__(self, message: str, text: str, index: int) -> None:
        before = text[:index]
        line = before.count("\n") + 1
        column = index - before.rfind("\n")
        super().__init__(f"line {line}, column {column}: {message}")


_CONTROLS = {
    **{code: chr(0x2400 + code) for code in range(0x20) if code not in (0o11, 0o12)},
    0x7F: "\u2421",
    **{code: f"\\x{code:02x}" for code in range(0x80, 0xA0)},
    0xFFFE: "\\ufffe",
    0xFFFF: "\\uffff",
}


def visible(text: str) -> str:
    """Return a text with its control codes, but tabs and line ends, as pictures or inert escapes."""
    return text.translate(_CONTROLS).encode("utf-8", "backslashreplace").decode()


def called(file: str) -> str:
    """Return what messages call a file that is read: its name, "standard input" for `-`."""
    return "standard input" if file == "-" else file.encode("utf-8", "backslashreplace").decode()


def named(file: str, error: WorkError) -> WorkError:
    """Return the error with what the file is called before its message."""
    return WorkError(f"{called(file)}: {error}")


@contextmanager
def naming(file: str) -> Iterator[None]:
    """Put the name of the file before the message of a WorkError raised inside."""
    try:
        yield
    except WorkError as error:
        raise named(file, error) from error
