"""Which dialect a source is in.

PAL III if it has no error there; else PAL8 if it has none there. If it has errors in both, it is PAL8 if a
line has something of PAL8's or small letters, and at most an undefined symbol wrong, and PAL8 has no more
errors, or PAL III went no further.

A character that PAL III lacks shows at once that a source has errors there; then PAL8 is tried first.
"""

import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from pal.assembly import PAL3, PAL8, SPELLED, Assembly
from pal.messages import DIALECT
from pal.source import characters

if TYPE_CHECKING:
    from pal.assembly3 import Assembly3
    from pal.pal8.assembly import Assembly8

_MARKS = set('(["<&^%abcdefghijklmnopqrstuvwxyz')
_MARK_OR_END = re.compile(r'\r(?:[^/\r(["<&^%]*[(["<&^%]|\$)')
"""Behind the end of a line: the first of the marks in the next line's code, or a `$` that begins it."""


def found(
    sources: Sequence[str | bytes], pal3: Callable[[], "Assembly3"], pal8: Callable[[], "Assembly8"]
) -> Assembly:
    """Return the assembly in PAL III or PAL8, whichever fits; `pal3` and `pal8` assemble on demand."""
    if _is_beyond_pal3(sources):
        eight = pal8()
        if eight.ok and not eight.is_empty():
            return _as_pal8(eight)
        three = pal3()
    else:
        three = pal3()
        if three.ok:
            return three
        eight = pal8()
    clean = eight.ok and not eight.is_empty()
    fewer = three.stopped is not None or len(eight.errors) <= len(three.messages)
    if clean or (_is_pal8s(eight) and fewer):
        return _as_pal8(eight)
    return three


def _is_pal8s(assembly: "Assembly8") -> bool:
    from pal import symbols
    from pal.pal8.symbols import PSEUDO_OPERATORS

    names = [name for name in PSEUDO_OPERATORS if name not in symbols.PSEUDO_OPERATORS]
    return assembly.takes(_MARKS, {name[: symbols.SIGNIFICANT] for name in names})


def _as_pal8(assembly: Assembly) -> Assembly:
    assembly.add_note(DIALECT)
    return assembly


def compared(assembly: Assembly, other: Assembly) -> Assembly:
    """Return a failed assembly, with a note if the `other` dialect accepts the source."""
    if other.ok and not other.is_empty():
        dialect = PAL3 if assembly.dialect == PAL8 else PAL8
        assembly.add_note("PN36 other", dialect=SPELLED[dialect], option=dialect)
    return assembly


def _is_beyond_pal3(sources: Sequence[str | bytes]) -> bool:
    """Whether the code of a source has a character that PAL III lacks."""
    for source in sources:
        first: list[str] = _MARK_OR_END.findall("\r" + characters(source))[:1]
        if first:
            return first[0][-1:] != "$"
    return False
