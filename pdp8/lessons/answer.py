"""A student's answer: a program as words and symbols, or the lines of a sheet."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from pal.assembling import assemble
from pdp8.computer.use.program import FOUND
from pdp8.computer.use.trace import Listing
from tapes.text import lines_of

_SHOWN = 5
"""Errors of a source that are shown."""
_BEFORE, _BEHIND = " -*>([", ")]*"
"""What may stand about the name of a question."""


@dataclass(frozen=True)
class Answer:
    """A student's answer: its words, symbols, source if any, and fault."""

    name: str
    words: Mapping[int, int] = field(default_factory=dict)
    symbols: Mapping[str, int] = field(default_factory=dict)
    source: str = ""
    fault: str = ""
    listing: Listing = field(default_factory=Listing)
    sheet: str = ""
    """The text of words spelled out, which may be a sheet."""

    def address(self, place: str) -> int:
        """Return the address that octal digits name, or a tag of the answer, or a tag with an offset."""
        if place[0].isdigit():
            return int(place, 8)
        name, behind = tag(place)
        return self.symbols[name] + behind & 0o7777

    def items(self) -> list[str]:
        """Return the symbols and numbers of the source as they stand, comments apart."""
        return [item for line in lines_of(self.source) for item in parted(line.partition("/")[0])
                if _of_a_word(item[0])]  # fmt: skip

    def lines(self) -> dict[str, str]:
        """Return a sheet's answers by their questions' names: `a: 270`, `(a) 270`, `- **a**: 270`; or
        `a 270`, which may be a sentence, if no line has a mark behind that name.
        """
        found: dict[str, str] = {}
        marked: set[str] = set()
        for line in lines_of(self.source or self.sheet):
            plain = line.removeprefix("\ufeff").strip().lstrip(_BEFORE)
            end = 0
            while end < len(plain) and not plain[end].isspace() and plain[end] not in ":=." + _BEHIND:
                end += 1
            name, behind = plain[:end].lower(), plain[end:].lstrip(_BEHIND)
            rest = behind.lstrip()
            ends = rest[:1] in (":", "=") or behind[:1] == "."
            if ends or len(behind) + end < len(plain):
                marked.add(name)
            elif name in marked:
                continue
            if end:
                found[name] = (rest[1:] if ends else rest).strip()
        return found


def tag(place: str) -> tuple[str, int]:
    """Return the tag of a place and the offset from it: `TABLE+1`."""
    name, sign, behind = place.replace("-", "+-").partition("+")
    return name, int(behind, 8) if sign else 0


def parted(line: str) -> list[str]:
    """Return the symbols, numbers and single marks of a line of PAL."""
    found: list[str] = []
    item = ""
    for character in line.upper() + " ":
        if _of_a_word(character):
            item += character
            continue
        if item:
            found.append(item)
            item = ""
        if not character.isspace():
            found.append(character)
    return found


def _of_a_word(character: str) -> bool:
    return character.isascii() and (character.isalpha() or character.isdigit())


def assembled(answer: Answer, dialect: str = FOUND) -> Answer:
    """Return the answer with the words and symbols of its source, in `dialect`; its errors are a fault."""
    if answer.fault or not answer.source:
        return answer
    assembly = assemble(answer.source, names=[answer.name], modern=True, dialect=dialect)
    errors = [diagnostic for diagnostic in assembly.diagnostics if diagnostic.error]
    more = f"\nand {len(errors) - _SHOWN} more" if len(errors) > _SHOWN else ""
    fault = "\n".join([str(error) for error in errors[:_SHOWN]]) + more
    if not fault and not assembly.words:
        fault = "no word for core in it"
    beyond = [address for address in assembly.words if address > 0o7777]
    if not fault and beyond:
        fault = f"address {beyond[0]:05o}: a PDP-8/L with 4K of core ends at 07777"
    source = answer.source.upper()
    if fault:
        return Answer(answer.name, source=source, fault=fault)
    return Answer(answer.name, assembly.words, assembly.symbols, source, listing=Listing.of(assembly))
