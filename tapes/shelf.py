"""The shelf: where tapes and sources are found and where they are put.

`-` is a standard stream. A name that is not in the current folder may be a bundled one: a program of
programs/ or a sample tape of tapes/. A file is written whole or not at all; only a punch streams, and what it
punched stays.
"""

import os
import sys
from typing import BinaryIO

from tapes.errors import WorkError

_HERE = os.path.dirname(os.path.abspath(__file__))
BUNDLED = (os.path.join(os.path.dirname(_HERE), "programs"), _HERE)
_SHELVED = (".pal", ".for", ".asc", ".eia", ".bin", ".rim")


class ShelfError(WorkError):
    """A file that cannot be read or written; the message names it and says why."""


def bundled() -> list[str]:
    """Return the names of everything on the shelf, sorted."""
    return sorted(name for folder in BUNDLED for name in os.listdir(folder) if name.endswith(_SHELVED))


def find(name: str) -> str:
    """Return the path of `name`: as given if it is there, else the bundled file of that name.

    Raises ShelfError if there is neither.
    """
    if os.path.exists(name):
        return name
    if os.path.basename(name) == name and name.endswith(_SHELVED):
        for folder in BUNDLED:
            path = os.path.join(folder, name)
            if os.path.exists(path):
                return path
    raise ShelfError(f"{name}: no such file, here or among the bundled ones ({', '.join(bundled())})")


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
    if os.path.exists(name) and not os.path.isfile(name):  # a device such as /dev/null, a directory
        _write_through(name, content)
        return
    beside = f"{name}.{os.getpid()}.part"
    try:
        try:
            with open(beside, "wb") as file:
                file.write(content)
            os.replace(beside, name)
        except BaseException:
            if os.path.exists(beside):
                os.unlink(beside)
            raise
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}; nothing was written") from error


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
