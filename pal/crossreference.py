"""The cross reference: every symbol of a source, where it is defined and where it is used.

    CHK     0227  eia.pal  defined 19   used 27 33
    TAD     1000  permanent             used 13 24 26

A symbol followed by a comma or an equals sign is defined there; anywhere else it is used. Pseudo-operators
are left out.
"""

from typing import NamedTuple

from pal.assembly import Assembly
from pal.symbols import codes


class Occurrence(NamedTuple):
    """A place where a symbol stands: the file, and line and column from 1."""

    file: str
    line: int
    column: int


class Reference(NamedTuple):
    """A symbol, its value at the end, and where it stands; `permanent` unless the source defines it."""

    name: str
    value: int
    permanent: bool
    defined: tuple[Occurrence, ...]
    used: tuple[Occurrence, ...]


def cross_reference(assembly: Assembly) -> list[Reference]:
    """Return the symbols that occur in the source, in the order of PAL III's symbol table."""
    defined: dict[str, list[Occurrence]] = {}
    used: dict[str, list[Occurrence]] = {}
    for mention in assembly.mentions:
        place = assembly.place(mention.at)
        occurrence = Occurrence(assembly.names[place.tape], place.line, place.start + 1)
        (defined if mention.defined else used).setdefault(mention.name, []).append(occurrence)
    return [
        Reference(
            name,
            assembly.values.get(name, 0),
            name not in assembly.symbols,
            tuple(defined.get(name, ())),
            tuple(used.get(name, ())),
        )
        for name in sorted(defined.keys() | used.keys(), key=codes)
    ]


def text(references: list[Reference]) -> str:
    """Return the cross reference as a text, one symbol a line; with several files they are named."""
    several = len({place.file for entry in references for place in entry.defined + entry.used}) > 1
    return "".join(_line(entry, several) for entry in references)


def _line(entry: Reference, several: bool) -> str:
    where = _places(entry.defined, several) or ("permanent" if entry.permanent else "")
    return f"{entry.name:6}  {entry.value:04o}  {where:16}  {_places(entry.used, several)}".rstrip() + "\n"


def _places(places: tuple[Occurrence, ...], several: bool) -> str:
    return " ".join(f"{place.file}:{place.line}" if several else str(place.line) for place in places)
