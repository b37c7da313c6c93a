"""The shelf: where tapes and sources are found and where they are put.

`-` is a standard stream. A name that is not in the current folder may be a bundled one: a sample tape of this
package, or what another package has laid on the shelf with `add`. A file is written whole or not at all; only
a punch streams, and what it punched stays.
"""

import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import BinaryIO

from tapes.errors import WorkError, called

HIDES = "is the file in this folder, not the bundled one of that name"
LARGEST = 2 << 20
"""Bytes of a file, frames of a tape: 3.3 miles, which a Teletype reads in 58 hours."""

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"
_bundled: dict[str, str] = {}


def add(folder: str, *endings: str) -> None:
    """Lay on the shelf every file of `folder` whose name ends so; its package calls this."""
    for name in os.listdir(folder):
        if name.endswith(endings):
            _bundled[name] = os.path.join(folder, name)


add(os.path.dirname(os.path.abspath(__file__)), ".asc", ".eia", ".bin", ".rim")


class ShelfError(WorkError):
    """A file that cannot be read or written; the message names it and says why."""


def bundled() -> list[str]:
    """Return the names of everything on the shelf, sorted."""
    return sorted(_bundled)


def find(name: str) -> str:
    """Return the path of `name`: as given if it is there, else the bundled file of that name.

    Raises ShelfError if there is neither.
    """
    check_named(name)
    if os.path.exists(name):
        return name
    if name in _bundled:
        return _bundled[name]
    raise ShelfError(f"{name}: no such file, here or among the bundled ones ({', '.join(bundled())})")


def has(name: str) -> bool:
    """Tell whether `find` finds `name`."""
    return os.path.exists(name) or name in _bundled


def hides(name: str) -> bool:
    """Tell whether the file called `name` hides a bundled one of other content."""
    if name not in _bundled or not os.path.isfile(name):
        return False
    with open(name, "rb") as here, open(_bundled[name], "rb") as there:
        return here.read(LARGEST) != there.read()


def read_bundled(name: str) -> bytes:
    """Return the content of a bundled file, whatever lies in the current folder. Raises KeyError."""
    with open(_bundled[name], "rb") as file:
        return file.read()


def read(name: str, most: int = LARGEST) -> bytes:
    """Return the whole content of file `name`, bundled name, or standard input for `-`.

    Raises ShelfError, also for more than `most` bytes and for text in UTF-16, which nothing here reads.
    """
    if name == "-":
        content = sys.stdin.buffer.read(most + 1)
    else:
        path = find(name)
        try:
            with open(path, "rb") as file:
                content = file.read(most + 1)
        except OSError as error:
            raise ShelfError(f"{name}: {error.strerror}") from error
    if len(content) > most:
        raise ShelfError(f"{called(name)}: longer than {most:,} bytes, the most that is read of a file")
    if is_utf16(content):
        raise ShelfError(
            f"{called(name)}: UTF-16, as PowerShell's > writes it; let the command write the file itself: "
            "-o FILE, or --punch FILE of pdp8 run"
        )
    return content


def read_text(name: str, most: int = LARGEST) -> str:
    """Return the text of a file as `read` does, without a byte order mark. Raises ShelfError if not UTF-8."""
    try:
        return read(name, most).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ShelfError(f"{called(name)}: byte {error.start}: not UTF-8") from error


def is_utf16(content: bytes) -> bool:
    """Tell whether a file is text in UTF-16: its byte order mark, then characters of Latin scripts or those
    that stand for bytes that were none.
    """
    if content[:2] == b"\xff\xfe":
        low, high = content[2::2], content[3::2]
    elif content[:2] == b"\xfe\xff":
        low, high = content[3::2], content[2::2]
    else:
        return False
    plain = high.count(0) + sum(pair == (0xFD, 0xFF) for pair in zip(low, high, strict=False))
    return len(high) > 0 and plain * 4 >= len(high)


def without_mark(content: bytes) -> bytes:
    """Return the content of a text file without the byte order mark that an editor put there."""
    return content.removeprefix(_BYTE_ORDER_MARK)


def write(name: str, content: bytes) -> bool:
    """Write `content` to file `name` whole or not at all; `-` is standard output. Return whether it took the
    place of a file. Raises ShelfError.
    """
    if name == "-":
        stream = open_punch("-")
        stream.write(content)
        stream.flush()
        return False
    check_writable(name)
    if os.path.exists(name) and not os.path.isfile(name):  # a device such as /dev/null
        _write_through(name, content)
        return False
    replaced = os.path.exists(name)
    try:
        with replacing(name) as beside, open(beside, "wb") as file:
            file.write(content)
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}; nothing was written") from error
    return replaced


@contextmanager
def replacing(name: str) -> Iterator[str]:
    """Give the name of a file beside `name` to write; it takes the place of `name`, with its mode, unless an
    exception is raised. A link is followed. Raises OSError.
    """
    path = os.path.realpath(name)
    beside = f"{path}.{os.getpid()}.part"
    try:
        yield beside
        with suppress(FileNotFoundError):
            os.chmod(beside, stat.S_IMODE(os.stat(path).st_mode))
        os.replace(beside, path)
    finally:
        with suppress(FileNotFoundError):
            os.unlink(beside)


def check_writable(name: str) -> None:
    """Raise ShelfError where file `name` cannot be written or is read-only; nothing is opened or made."""
    if name == "-":
        return
    check_named(name)
    if os.path.isdir(name):
        raise ShelfError(f"{name}: Is a directory")
    folder = os.path.dirname(os.path.realpath(name))
    if not os.path.isdir(folder):
        raise ShelfError(f"{name}: No such file or directory")
    place = name if os.path.exists(name) else folder
    if (
        not os.access(place, os.W_OK) or not os.stat(place).st_mode & 0o222
    ):  # the superuser may, but did not ask
        raise ShelfError(f"{name}: Permission denied")


def check_named(name: str) -> None:
    """Raise ShelfError for the empty name that a script's unset variable gives, and for one with NUL."""
    if not name:
        raise ShelfError("the name of a file is empty")
    if "\0" in name:
        raise ShelfError(f"{name}: NUL in the name of a file")


def _write_through(name: str, content: bytes) -> None:
    try:
        with open(name, "wb") as file:
            file.write(content)
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}") from error


def open_punch(name: str) -> BinaryIO:
    """Open `name` for frames that are written as they are punched; `-` is standard output, if no terminal.

    Raises ShelfError.
    """
    if name == "-":
        if sys.stdout.isatty():
            raise ShelfError(
                "a tape is binary and standard output is a terminal: send it to a file or a pipe"
            )
        return sys.stdout.buffer
    check_writable(name)
    try:
        return open(name, "wb")
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}") from error
