"""A student's file, read within bounds: 16 KiB at most, from a regular file or from standard input, in lines
of 200 characters.
"""

import os
import re
import sys

from pdp8 import shelf
from pdp8.computer.use import program
from pdp8.lessons.answer import Answer
from tapes import codes, dump
from tapes.errors import WorkError, called
from tapes.frames import FILL
from tapes.loaders import Words
from tapes.text import is_utf16, lines_of, without_mark

LARGEST = 16 * 1024
LONGEST = 200
"""Characters of a line."""
_PLAIN = bytes(range(0o200))
_ANSWER = re.compile(rb"\W*\w\W*?[:=)]")


def read(name: str) -> Answer:
    """Return the answer in file `name`, `-` for standard input; what cannot be read has a fault."""
    try:
        if name == "-":
            return of(sys.stdin.buffer.read(LARGEST + 1), called(name))
        if os.path.exists(name) and not os.path.isfile(name):
            return Answer(called(name), fault="not a file")
        shelf.remember(name)
        with open(name, "rb") as file:
            return of(file.read(LARGEST + 1), called(name))
    except OSError as error:
        return Answer(called(name), fault=f"{error.strerror}")
    except ValueError:
        return Answer(called(name), fault="NUL in the name of a file")


def of(content: bytes, name: str) -> Answer:
    """Return the answer in a file of this content: PAL III source, a sheet, a BIN or RIM tape or its dump."""
    if not content:
        return Answer(name, fault="an empty file")
    if what := shelf.no_source(content):
        return Answer(name, fault=f"{what}: an answer is plain text, or a tape")
    if len(content) > LARGEST:
        return Answer(name, fault=f"more than {LARGEST:,} bytes")
    if is_utf16(content):
        return Answer(name, fault="text in UTF-16: save it as UTF-8 or ASCII, or write it with an editor")
    content = without_mark(content)
    code = codes.recognise(dump.unspelled(content)[0])
    try:
        if isinstance(code, Words):
            sheet = content.decode("ascii", "replace") if _is_sheet(content) else ""
            return Answer(name, program.read(content, name).words, sheet=sheet)
        if code in (codes.UNKNOWN, codes.EIA):
            content.decode()  # text, its comments in any language, or a picture, another program's file
    except WorkError as error:
        if not _is_sheet(content):
            return Answer(name, fault=str(error))
    except UnicodeDecodeError:
        return Answer(name, fault="neither text, such as PAL source, nor a BIN or RIM tape")
    if code is codes.ASCII and _has_parity(content):
        if titled := codes.ASCII.titled(content, "source"):
            return Answer(name, fault=titled)
        content = codes.ASCII.decode(content).encode()
    source = content.decode(errors="replace").replace("\r\n", "\n")
    for number, line in enumerate(lines_of(source), 1):
        if len(line) > LONGEST:
            return Answer(name, fault=f"line {number} has {len(line):,} characters; at most {LONGEST} can be")
    return Answer(name, source=source)


def _has_parity(content: bytes) -> bool:
    """Whether a tape of characters is no text: channel 8 is in a quarter of them, and they are not UTF-8."""
    characters = content.translate(None, FILL)
    try:
        content.decode()
    except UnicodeDecodeError:
        return 4 * len(characters.translate(None, _PLAIN)) > len(characters)
    return False


def _is_sheet(content: bytes) -> bool:
    """Whether two lines or more are answers of a sheet, `a: 270`, with whatever characters between them."""
    return sum(bool(_ANSWER.match(line)) for line in content.split(b"\n")) > 1
