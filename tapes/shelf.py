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

from tapes.errors import WorkError

HIDES = "is the file in this folder, not the bundled one of that name"

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
    _check_named(name)
    if os.path.exists(name):
        return name
    if name in _bundled:
        return _bundled[name]
    raise ShelfError(f"{name}: no such file, here or among the bundled ones ({', '.join(bundled())})")


def hides(name: str) -> bool:
    """Tell whether the file called `name` hides a bundled one of other content."""
    if name not in _bundled or not os.path.isfile(name):
        return False
    with open(name, "rb") as here, open(_bundled[name], "rb") as there:
        return here.read() != there.read()


def read_bundled(name: str) -> bytes:
    """Return the content of a bundled file, whatever lies in the current folder. Raises KeyError."""
    with open(_bundled[name], "rb") as file:
        return file.read()


def read(name: str) -> bytes:
    """Return the whole content of file `name`, bundled name, or standard input for `-`. Raises ShelfError."""
    if name == "-":
        return sys.stdin.buffer.read()
    path = find(name)
    try:
        with open(path, "rb") as file:
            return file.read()
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}") from error


def write(name: str, content: bytes) -> None:
    """Write `content` to file `name` whole or not at all; `-` is standard output. Raises ShelfError."""
    if name == "-":
        stream = open_punch("-")
        stream.write(content)
        stream.flush()
        return
    _check_named(name)
    if os.path.exists(name) and not os.path.isfile(name):  # a device such as /dev/null, a directory
        _write_through(name, content)
        return
    try:
        with replacing(name) as beside, open(beside, "wb") as file:
            file.write(content)
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}; nothing was written") from error


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
    """Raise ShelfError where file `name` cannot be written; nothing is opened, made or emptied."""
    if name == "-":
        return
    _check_named(name)
    if os.path.isdir(name):
        raise ShelfError(f"{name}: Is a directory")
    folder = os.path.dirname(os.path.realpath(name))
    if not os.path.isdir(folder):
        raise ShelfError(f"{name}: No such file or directory")
    place = name if os.path.exists(name) else folder
    if not os.access(place, os.W_OK):
        raise ShelfError(f"{name}: Permission denied")


def _check_named(name: str) -> None:
    """Raise ShelfError for the empty name that a script's unset variable gives."""
    if not name:
        raise ShelfError("the name of a file is empty")


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
    try:
        return open(name, "wb")
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}") from error
