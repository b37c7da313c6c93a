"""A table of commands: its blocks run, and their answers as lines."""

import re
from base64 import b32encode, urlsafe_b64decode
from collections.abc import Iterator, Mapping
from hashlib import sha256
from pathlib import Path
from zlib import decompress

from pdp8 import shelf
from pdp8.monitor.commands import do
from pdp8.monitor.prompt import Monitor
from tapes import eia
from tapes.errors import WorkError
from tests.options.inputs import FILES
from tests.options.trial import called, changed, existing, folder

TABLES = sorted(Path(__file__).parent.glob("*.txt"))
_MOST, _WIDEST = 12, 240
"""Lines of a stream that are written in full, and their characters."""
_PACKED = re.compile(rb"(?<=#s=)[\w-]+")
"""What a link to the page has, which zlib packs differently from version to version."""
_WROTE = re.compile(r"(?:! |  )(?:wrote|replaced) ([^:]+)")
_USAGE = re.compile(rb"(.*\b(pdp8[ \w]*): .*\n)\2 --help shows what there is\n", re.DOTALL)
"""What a misuse says: the last line is the same in all, and left out."""


def blocks(table: str) -> list[str]:
    return [block.strip("\n") for block in table.split("\n\n")]


def answered(table: str) -> str:
    """Return the table with what its commands answer now."""
    return "\n\n".join(map(block_answered, blocks(table))) + "\n"


def block_answered(block: str) -> str:
    """Return a block with what its commands answer now, in a folder of its own."""
    lines: list[str] = []
    said: list[str] = []
    named = {name: content for name, content in FILES.items() if name in block}
    with folder(named), shelf.watched():
        monitor = Monitor(said.append)
        for line in block.splitlines():
            if line.startswith(("#", "% ", "$ ", "* ")):
                lines.append(line)
            if line.startswith("% "):
                name, text = line[2:].split(" = ", 1)
                Path(name).write_bytes(_content(name, text))
            elif line.startswith("$ "):
                lines += _answer(line[2:])
            elif line.startswith("* "):
                before = existing()
                lines += _with_files(list(_prompted(monitor, said, line[2:])), changed(before))
    return "\n".join(lines)


def _content(name: str, text: str) -> bytes:
    if name.endswith(".bin"):
        frames = re.sub(r"(\d+)\*(\d+)", lambda found: f"{found[1]} " * int(found[2]), text)
        return bytes(int(frame, 8) for frame in frames.split())
    text = text.replace("|", "\n").replace("¦", "|")
    return eia.encode(text) if name.endswith(".eia") else text.encode()


def _prompted(monitor: Monitor, said: list[str], line: str) -> Iterator[str]:
    said.clear()
    error = ""
    try:
        do(monitor, line)
    except WorkError as refusal:
        error = f"{refusal}\n"
    yield from _stream("  ", "".join(f"{each}\n" for each in said).encode())
    yield from _stream("? ", error.encode())


def _answer(line: str) -> Iterator[str]:
    command, _, given = line.partition(" < ")
    result = called(command, Path(given).read_bytes() if given else b"")
    usage = _USAGE.fullmatch(result.said) if result.status == 2 else None
    lines = [*_stream("  ", result.shown), *_stream("! ", usage[1] if usage else result.said)]
    if result.status:
        lines.append(f"= {result.status}" + ", and no hint" * (result.status == 2 and not usage))
    return _with_files(lines, result.files)


def _with_files(lines: list[str], files: Mapping[str, bytes]) -> Iterator[str]:
    """Yield the lines, a file's bytes and digest behind the one that says it was written, or at the end."""
    left = {name: f"{len(content):,}, {_digest(content)}" for name, content in sorted(files.items())}
    for line in lines:
        said = _WROTE.match(line)
        yield f"{line} + {left.pop(said[1])}" if said and said[1] in left else line
    for name, content in left.items():
        yield f"+ {name} {content}"


def _stream(mark: str, content: bytes) -> Iterator[str]:
    """Yield the lines of a stream; a tape as its number of frames and its digest."""
    if not content:
        return
    content = _PACKED.sub(lambda found: _unpacked(found[0]).encode(), content)
    text = content.decode("utf-8", "replace")
    if any(char == "\ufffd" or not (char.isprintable() or char in "\t\n") for char in text):
        yield f"{mark}{len(content):,} bytes, {_digest(content)}"
        return
    lines = text.removesuffix("\n").split("\n")
    whole = len(lines) if len(lines) <= _MOST else _MOST // 2
    for line in lines[:whole]:
        cut = line if len(line) <= _WIDEST else f"{line[:_WIDEST]}…{_digest(line.encode())}"
        yield f"{mark}{cut or '.'}"
    if lines[whole:]:
        yield f"{mark}… {len(lines) - whole} more, {_digest(content)}"
    elif not text.endswith("\n"):
        yield f"{mark}…"


def _digest(content: bytes) -> str:
    return b32encode(sha256(content).digest())[:5].decode().lower()


def _unpacked(link: bytes) -> str:
    return _digest(decompress(urlsafe_b64decode(link + b"==="), -15))
