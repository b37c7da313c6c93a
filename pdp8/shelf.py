"""The shelf: where tapes and sources are found and where they are put.

`-` is a standard stream. A name that is not in the current folder may be a bundled one: a sample tape of
tapes/, a source of programs/. A file is written whole or not at all; only
a punch streams, and what it punched stays. While the shelf is watched, as in every command, nothing that was
read is written over.
"""

import os
import stat
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, BinaryIO

from tapes.errors import WorkError, called
from tapes.text import is_utf16, without_mark

if TYPE_CHECKING:
    from pdp8.computer.use.program import Program
    from tapes.notebook import Tape

HIDES = "is the file in this folder, not the bundled one of that name"
LARGEST = 2 << 20
"""Bytes of a file, frames of a tape: 3.3 miles, which a Teletype reads in 58 hours."""

_TAPES = (".asc", ".eia", ".bin", ".rim")
_BUNDLED = {"tapes": _TAPES, "programs": (".pal", ".for")}
_BY_HAND = (".pal", ".pa", ".for", ".toml", ".jpg", ".jpeg", ".png")
_BEGINS = {"JSON": b"{", "XML": b"<", "SVG": b"<", "HTML": b"<"}
_WORKED_ON = (".tu56", ".dt8", ".df32", ".dsk", ".state")
_KEEPS = {
    "tape": (*_BY_HAND, *_WORKED_ON),
    "image": (*_BY_HAND, *_TAPES),
    **dict.fromkeys(("text", "drawing"), (*_BY_HAND, *_TAPES, *_WORKED_ON)),
}
"""What a product of each kind never replaces: a forgotten name after an option would cost a day's work."""
_OTHER_PICTURES = (".png", ".jpg", ".jpeg", ".gif", ".webp", ".pdf", ".eps", ".dxf")
"""Endings of pictures in another format than SVG."""
_PICTURES = {"SVG": (".svg",), "drawing": (".svg", ".dxf")}
"""Endings of the formats that a picture of each kind is written in."""

_STREAMS = {
    "stdin": "standard input",
    "stdout": "standard output, whose name is -",
    "stderr": "standard error",
}

_IMAGES = {
    **dict.fromkeys((".rk05", ".rl01", ".rf08", ".dsk"), "a disk image"),
    **dict.fromkeys((".rx01", ".rx02"), "a floppy's image; no PDP-8/L had one"),
    **dict.fromkeys((".tu56", ".dt8"), "a DECtape image: --dectape 0=FILE mounts it, or attach dt0 FILE"),
}
"""Files of other emulators, by their endings."""

JSON = "JSON"
_ELSEWHERE = {
    **dict.fromkeys((b"{\\rtf", b"pk\3\4\x14\0"), "a word processor's file"),
    **dict.fromkeys((b"<!doctype html", b"<html"), "a web page"),
    b"%pdf-": "PDF",
    b"{": JSON,
}
"""Files that are never a source, by their beginnings in small letters."""

_watches: list["_Watch | None"] = [None]


def beside(module: str) -> str:
    """Return the folder of a module; of one that Python imported from a zip, a copy."""
    folder = os.path.dirname(os.path.abspath(module))
    return folder if os.path.isdir(folder) else _unpacked(folder)


def _unpacked(folder: str) -> str:
    import atexit
    import shutil
    import tempfile
    import zipfile

    archive = folder
    while not os.path.isfile(archive):
        archive = os.path.dirname(archive)
    copy = tempfile.mkdtemp()
    atexit.register(shutil.rmtree, copy, ignore_errors=True)
    within = os.path.relpath(folder, archive)
    with zipfile.ZipFile(archive) as opened:
        inside = f"{within.replace(os.sep, '/')}/"
        opened.extractall(copy, [name for name in opened.namelist() if name.startswith(inside)])
    return os.path.join(copy, within)


def _laid() -> dict[str, str]:
    """Return the path of each bundled file."""
    house = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
    laid: dict[str, str] = {}
    for package, endings in _BUNDLED.items():
        folder = beside(os.path.join(house, package, "__init__.py"))
        laid |= {name: os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(endings)}
    return laid


_bundled = _laid()


class _Watch:
    """The files read, by identity, and the paths of those written."""

    def __init__(self) -> None:
        self.read: set[object] = set()
        self.written: set[str] = set()


@contextmanager
def watched() -> Iterator[None]:
    """Within it, files that were read are not replaced, unless they were written there first."""
    _watches.append(_Watch())
    try:
        yield
    finally:
        _watches.pop()


class ShelfError(WorkError):
    """A file that cannot be read or written; the message names it and says why."""


@contextmanager
def failing(name: str, more: str = "") -> Iterator[None]:
    """Raise ShelfError for an OSError inside: the file's `name`, what the system says, and `more`."""
    try:
        yield
    except OSError as error:
        raise ShelfError(f"{name}: {error.strerror}{more}") from error


def bundled() -> list[str]:
    """Return the names of everything on the shelf, sorted."""
    return sorted(_bundled)


def find(name: str) -> str:
    """Return the path of `name`: a file, else the bundled one, which no folder hides. Raises ShelfError."""
    check_named(name)
    if os.path.exists(name) and not (name in _bundled and os.path.isdir(name)):
        return name
    if name in _bundled:
        return _bundled[name]
    try:
        os.getcwd()
    except FileNotFoundError:
        raise ShelfError(f"{name}: the current folder is no longer there") from None
    with failing(name), suppress(FileNotFoundError, NotADirectoryError):
        os.stat(name)  # in a locked folder, say
    raise ShelfError(f"{name}: no such file, here or among the bundled ones ({', '.join(bundled())})")


def has(name: str) -> bool:
    """Tell whether `find` finds `name`."""
    return os.path.exists(name) or name in _bundled


def is_name(text: str) -> bool:
    """Tell whether a text, which may be an expression, names a file: it is there, or ends as names do."""
    return has(text) or ("." in text and text.rpartition(".")[2].isalpha())


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


def read(name: str, most: int = LARGEST, wide: bool = False) -> bytes:
    """Return the content of `name`, `-` or a bundled file.

    Raises ShelfError for more than `most` bytes and, unless `wide`, for UTF-16.
    """
    if name == "-":
        content = sys.stdin.buffer.read(most + 1)
    else:
        path = find(name)
        with failing(name), open(path, "rb") as file:
            content = file.read(most + 1)
        remember(path)
    if len(content) > most:
        from tapes import dectape

        image = "" if name == "-" else dectape.image(os.path.getsize(path))
        what = f"{image}, " if image else ""
        raise ShelfError(f"{called(name)}: {what}longer than {most:,} bytes, the most that is read of a file")
    if not wide and is_utf16(content):
        raise ShelfError(
            f"{called(name)}: UTF-16, as PowerShell's > writes it; save a text as UTF-8, and let a command "
            "write its file itself: -o FILE, or --punch FILE of pdp8 run"
        )
    return content


def tape(name: str) -> "Tape":
    """Return the frames of a file as `read` does; a notebook shows them as a picture."""
    from tapes.notebook import Tape

    return Tape(read(name))


def program(name: str, force: bool = False, dialect: str = "auto", memory: int = 0o10000) -> "Program":
    """Return the program called `name` as `read` finds it. Raises WorkError as `program.read` does."""
    from pdp8.computer.use import program

    image = next((what for ending, what in _IMAGES.items() if name.lower().endswith(ending)), None)
    if image:
        raise ShelfError(f"{name}: no program tape: {image}")
    content = read(name)
    if what := no_source(content):
        cure = "; a saved state is restored, not loaded" * (what == JSON)
        raise ShelfError(f"{called(name)}: {what}, not a program{cure}")
    return program.read(content, name, force, dialect, memory)


def programs(names: Sequence[str], memory: int = 0o10000) -> "Program":
    """Return the program of a tape, or of source tapes read one after the other. Raises WorkError."""
    from pdp8.computer.use.program import read_sources

    if len(names) == 1:
        return program(names[0], memory=memory)
    return read_sources([read(name) for name in names], names, memory)


def bundled_program(name: str) -> "Program":
    """Return a bundled program, whatever lies in the current folder."""
    from pdp8.computer.use import program

    return program.read(read_bundled(name), name)


def remember(path: str) -> None:
    """Remember that the file at `path` was read, if the shelf is watched."""
    if watch := _watches[-1]:
        watch.read.add(identity(path))


def read_text(name: str, most: int = LARGEST) -> str:
    """Return the text of a file as `read` does, without a byte order mark. Raises ShelfError if not UTF-8."""
    content = read(name, most)
    text = without_mark(content)
    try:
        return text.decode()
    except UnicodeDecodeError as error:
        at = len(content) - len(text) + error.start
        raise ShelfError(f"{called(name)}: byte {at}: not UTF-8") from error


def no_source(content: bytes) -> str:
    """Return what a file is that is never a source, as a saved state is JSON, by how it begins; else ""."""
    begins = without_mark(content).lstrip()[:20].lower()
    return next((what for beginning, what in _ELSEWHERE.items() if begins.startswith(beginning)), "")


def identity(name: str) -> object:
    """Return what all names of one file share: links, hard ones too, and other spellings of its path."""
    if name == "-":
        return name
    path = os.path.realpath(name)  # as it is written
    try:
        found = os.stat(path)
    except OSError:
        return path.casefold() if sys.platform == "darwin" else os.path.normcase(path)
    return found.st_dev, found.st_ino


def stream(name: str) -> str:
    """Return which standard stream is redirected from or to the file `name`; an empty text for none."""
    for stream, what in _STREAMS.items():
        with suppress(AttributeError, OSError, ValueError):  # of a test or a notebook, or closed
            found = os.fstat(getattr(sys, stream).fileno())
            if stat.S_ISREG(found.st_mode) and identity(name) == (found.st_dev, found.st_ino):
                return what
    return ""


def check_kind(name: str, kind: str) -> None:
    """Raise ShelfError where `name` is a file that no product of that kind replaces, or of a wrong ending."""
    own = _PICTURES.get(kind, _OTHER_PICTURES)
    if name.lower().endswith(_OTHER_PICTURES) and not name.lower().endswith(own):
        formats, names = " or ".join(each[1:].upper() for each in own), " or ".join(own)
        raise ShelfError(f"{name}: pictures are written only as {formats}; name it {names}")
    if not os.path.isfile(name) or not os.path.getsize(name):
        return
    kept = any(each.lower().endswith(_KEEPS.get(kind, ())) for each in (name, os.path.realpath(name)))
    if kind in _BEGINS:
        with open(name, "rb") as file:
            kept = not without_mark(file.read(64)).lstrip().startswith(_BEGINS[kind])
    if kept:
        raise ShelfError(f"{name} is there, and is no {kind}: it is not replaced; name another")


def leave(name: str, content: bytes, kind: str) -> str:
    """Write a session's product, of a kind that `check_kind` knows; return the message for it."""
    if name == "-":
        raise ShelfError("-: standard output has what is said; name a file")
    check_kind(name, kind)
    return told(name, write(name, content))


def told(name: str, replaced: bool) -> str:
    """Return the message for a written file."""
    return f"{'replaced' if replaced else 'wrote'} {name}"


def write(name: str, content: bytes) -> bool:
    """Write file `name` whole or not at all; return whether it replaced one. Raises ShelfError."""
    check_writable(name)
    if os.path.exists(name) and not os.path.isfile(name):  # a device such as /dev/null
        with failing(name), open(name, "wb") as device:
            device.write(content)
        return False
    replaced = os.path.exists(name)
    with failing(name, "; this file was not written"), replacing(name) as beside, open(beside, "wb") as file:
        file.write(content)
    if watch := _watches[-1]:
        watch.written.add(os.path.realpath(name))
    return replaced


@contextmanager
def replacing(name: str) -> Iterator[str]:
    """Give the name of a file beside `name`, which takes its place and mode unless an exception is raised."""
    path = os.path.realpath(name)
    folder, last = os.path.split(path)
    beside = os.path.join(folder, f"{last[:50]}.{os.getpid()}.part")  # no longer than a name may be
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
    if os.path.isdir(name) or not os.path.basename(name):
        raise ShelfError(f"{name}: Is a directory")
    path = os.path.realpath(name)
    folder = os.path.dirname(path)
    if not os.path.isdir(folder):
        raise ShelfError(f"{name}: No such file or directory")
    _check_permission(name, name if os.path.exists(name) else folder)
    if not os.path.isfile(name):
        return
    if opened := stream(name):
        raise ShelfError(f"{name} is {opened}: it is not replaced; name another")
    watch = _watches[-1]
    if watch and identity(name) in watch.read and path not in watch.written:
        raise ShelfError(f"{name} was read: it is not replaced; name another")


def make_folder(name: str) -> None:
    """Make a folder, with those above it. Raises ShelfError."""
    check_named(name)
    above = os.path.abspath(name)
    while not os.path.exists(above):
        above = os.path.dirname(above)
    _check_permission(name, above)
    with failing(name):
        os.makedirs(name, exist_ok=True)


def _check_permission(name: str, place: str) -> None:
    barred = sys.platform != "win32" and not os.stat(place).st_mode & 0o222
    if barred or not os.access(place, os.W_OK):  # the superuser may, but did not ask
        raise ShelfError(f"{name}: Permission denied")


def check_named(name: str) -> None:
    """Raise ShelfError for the empty name that a script's unset variable gives, and for one with NUL."""
    if not name:
        raise ShelfError("the name of a file is empty")
    if "\0" in name:
        raise ShelfError(f"{name}: NUL in the name of a file")


def of_user(variable: str, default: str) -> str:
    """Return the user's folder that `variable` of the environment names; a relative name counts for none."""
    named = os.environ.get(variable, "")
    return named if os.path.isabs(named) else os.path.expanduser(default)


def open_punch(name: str) -> BinaryIO:
    """Open `name` for frames as they are punched, `-` if no terminal. Raises ShelfError."""
    if name == "-":
        if sys.stdout.isatty():
            raise ShelfError(
                "a tape is binary and standard output is a terminal: send it to a file or a pipe"
            )
        return sys.stdout.buffer
    with failing(name):
        return open(name, "wb")
