"""A student's file, read within bounds: a program as words and symbols, or the lines of a sheet.

Whatever the file holds, reading it takes little time and room: 16 KiB at most, from a regular file or from
standard input, in lines of 200 characters, and of a source's errors the first few are kept.
"""

import os
import re
import sys
from collections.abc import Mapping
from dataclasses import dataclass, field

import pal
from pdp8.computer.use import program
from tapes import kinds, shelf
from tapes.errors import WorkError, called

LARGEST = 16 * 1024
LONGEST = 200
"""Characters of a line."""
_SHOWN = 5
_COMMENT = re.compile(r"/.*")
_ITEM = re.compile(r"[A-Z][A-Z0-9]*|[0-7]+")
_LINE = re.compile(r"\s*([^\s:=.)]+)\s*[:=.)]?\s*(.*?)\s*$")


@dataclass(frozen=True)
class Answer:
    """What a student wrote: its words in core and its symbols, the source if there is one, what is wrong."""

    name: str
    words: Mapping[int, int] = field(default_factory=dict)
    symbols: Mapping[str, int] = field(default_factory=dict)
    source: str = ""
    fault: str = ""

    def address(self, place: str) -> int | None:
        """Return the address that octal digits or a symbol name; None for a symbol it has not."""
        return int(place, 8) if place[0].isdigit() else self.symbols.get(place)

    def items(self) -> set[str]:
        """Return the symbols and numbers that stand in the source, comments apart."""
        return {item for line in self.source.splitlines() for item in _ITEM.findall(_COMMENT.sub("", line))}

    def lines(self) -> dict[str, str]:
        """Return a sheet's answers by their questions' names: `a: 270`."""
        found = (_LINE.match(line) for line in self.source.splitlines())
        return {line[1].lower(): line[2] for line in found if line}


def read(name: str) -> Answer:
    """Return the answer in file `name`, `-` for standard input; what cannot be read has a fault."""
    try:
        if name != "-" and os.path.exists(name) and not os.path.isfile(name):
            return Answer(called(name), fault="not a file")
        return of(_content(name), called(name))
    except OSError as error:
        return Answer(called(name), fault=f"{error.strerror}")
    except ValueError:
        return Answer(called(name), fault="NUL in the name of a file")


def _content(name: str) -> bytes:
    if name == "-":
        return sys.stdin.buffer.read(LARGEST + 1)
    with open(name, "rb") as file:
        return file.read(LARGEST + 1)


def of(content: bytes, name: str) -> Answer:
    """Return the answer a file of that content gives: PAL III source, a BIN or RIM tape, a sheet."""
    if not content:
        return Answer(name, fault="an empty file")
    if len(content) > LARGEST:
        return Answer(name, fault=f"more than {LARGEST:,} bytes")
    if shelf.is_utf16(content):
        return Answer(name, fault="text in UTF-16: save it as UTF-8 or ASCII, or write it with an editor")
    content = shelf.without_mark(content)
    kind = kinds.classify(content)
    try:
        if kind in (kinds.BIN, kinds.RIM):
            return Answer(name, program.read(content, name).words)
    except WorkError as error:
        return Answer(name, fault=str(error))
    source = content.decode("ascii", "replace").replace("\r\n", "\n")
    for number, line in enumerate(source.splitlines(), 1):
        if len(line) > LONGEST:
            return Answer(name, fault=f"line {number} has {len(line):,} characters; at most {LONGEST} can be")
    return Answer(name, source=source)


def assembled(answer: Answer, dialect: str = program.FOUND) -> Answer:
    """Return the answer with the words and symbols of its source, in `dialect`; its errors are a fault."""
    if answer.fault or not answer.source:
        return answer
    assembly = pal.assemble(answer.source, names=[answer.name], modern=True, dialect=dialect)
    errors = [diagnostic for diagnostic in assembly.diagnostics if diagnostic.error]
    more = f"\nand {len(errors) - _SHOWN} more" if len(errors) > _SHOWN else ""
    fault = "\n".join(map(str, errors[:_SHOWN])) + more
    if not fault and not assembly.words:
        fault = "no word for core in it"
    source = answer.source.upper()
    if fault:
        return Answer(answer.name, source=source, fault=fault)
    try:
        return Answer(answer.name, _in_core(assembly.words), assembly.symbols, source)
    except WorkError as error:
        return Answer(answer.name, source=source, fault=str(error))


def _in_core(words: Mapping[int, int]) -> Mapping[int, int]:
    beyond = next((address for address in words if address > 0o7777), None)
    if beyond is not None:
        raise WorkError(f"address {beyond:05o}: a PDP-8/L with 4K of core ends at 07777")
    return words
