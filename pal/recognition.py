"""Which dialect a source is in.

PAL III where it is clean there; else PAL8 where it is clean there and has a name or a character that PAL III
lacks, or where a line of it that is right can be PAL8's alone and PAL8 has no more errors.

A character that PAL III lacks shows at once that a source is not clean there; PAL8 is then tried first.
"""

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from pal.assembly import PAL3, PAL8, SPELLED, Assembly
from pal.messages import DIALECT
from pal.notes import NOTE, note
from pal.source import characters

if TYPE_CHECKING:
    from pal.work3 import Work3
    from pal.work8 import Work8

_MARKS = set('(["<&^%')
_MARK_OR_END = re.compile(r'\r(?:[^/\r(["<&^%]*[(["<&^%]|\$)')
"""Behind the end of a line: the first of the marks in the next line's code, or a `$` that begins it."""

_Work3 = Callable[[], "Work3"]
_Work8 = Callable[[], "Work8"]


def found(sources: Sequence[str | bytes], names: Sequence[str], pal3: _Work3, pal8: _Work8) -> Assembly:
    """Return a source as PAL III or PAL8 makes it; `pal3` and `pal8` do their work when they are called."""
    if _is_beyond_pal3(sources):
        work8 = pal8()
        if work8.ok and not work8.is_empty():
            return _as_pal8(names, work8)
        work3 = pal3()
    else:
        work3 = pal3()
        if work3.ok:
            return Assembly(PAL3, names, work3)
        work8 = pal8()
    said = work3.messages()
    if work8.ok and not work8.is_empty() and any(message[:2] in ("IC", "UA") for message in said):
        return _as_pal8(names, work8)
    if _is_pal8s(work8) and len(work8.errors) <= len(said):
        return _as_pal8(names, work8)
    return _told(Assembly(PAL3, names, work3), work3, work8)


def _is_pal8s(work: "Work8") -> bool:
    from pal import symbols
    from pal.symbols8 import PSEUDO_OPERATORS

    names = [name for name in PSEUDO_OPERATORS if name not in symbols.PSEUDO_OPERATORS]
    return work.takes(_MARKS, {name[: symbols.SIGNIFICANT] for name in names})


def _as_pal8(names: Sequence[str], work: "Work8") -> Assembly:
    assembly = Assembly(PAL8, names, work)
    assembly.noted.append((NOTE, note(DIALECT, work.first()), ""))
    return assembly


def told(assembly: Assembly, work: "Work3 | Work8", other: _Work3 | _Work8) -> Assembly:
    """Return an assembly in the dialect that was asked for, with a note if `other` alone has no error."""
    return assembly if assembly.ok else _told(assembly, work, other())


def _told(assembly: Assembly, work: "Work3 | Work8", other: "Work3 | Work8") -> Assembly:
    if other.ok and not other.is_empty():
        dialect = PAL3 if assembly.dialect == PAL8 else PAL8
        said = note("PN36 other", work.first(), dialect=SPELLED[dialect], option=dialect)
        assembly.noted.append((NOTE, said, ""))
    return assembly


def _is_beyond_pal3(sources: Sequence[str | bytes]) -> bool:
    """Tell whether a character in the code of a source is none of PAL III's."""
    for source in sources:
        first: list[str] = _MARK_OR_END.findall("\r" + characters(source))[:1]
        if first:
            return first[0][-1:] != "$"
    return False
