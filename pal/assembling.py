"""One call: source tapes in, an assembly out, in PAL III or PAL8.

assemble("*200\\n\\tCLA\\n\\tHLT\\n$\\n").words  ->  {0o200: 0o7200, 0o201: 0o7402}
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from pal.assembler import TELETYPE_SYMBOLS
from pal.assembly import PAL3, PAL8, Assembly
from pal.assembly3 import Assembly3
from pal.source import Source

if TYPE_CHECKING:
    from pal.pal8.assembly import Assembly8

FOUND = "auto"
DIALECTS = (FOUND, PAL3, PAL8)


def assemble(
    *sources: str | bytes,
    names: Sequence[str] | None = None,
    modern: bool = False,
    capacity: int = TELETYPE_SYMBOLS,
    model: str | None = None,
    dialect: str = PAL3,
    wipe: bool = False,
    exact: bool = False,
) -> Assembly:
    """Assemble the source tapes, read one after the other.

    sources   frames, with channel 8 or without, or texts; in a text a character beyond ASCII is illegal
    names     what the diagnostics call each tape
    modern    fold lower case
    capacity  how many symbols of the source the table takes: TELETYPE_SYMBOLS, or HIGH_SPEED_SYMBOLS, which
              reads ahead and at PAUSE loses the rest of the line
    model     one of models.MODELS: the diagnostics note what other models do otherwise
    dialect   "pal3", "pal8", or "auto": PAL III if the source has no error there, else PAL8 if it has none
              there, or has a line of PAL8's (`pal.recognition`); a note says so
    wipe      PAL8's /W: literals that were put out are forgotten, so that an overlay may go there
    exact     PAL8 as DEC's own reads it, without what is allowed besides (`pal.pal8`)

    Whatever is wrong with the source is a diagnostic. Raises ValueError for another dialect.
    """
    if dialect not in DIALECTS:
        raise ValueError(f"{dialect!r} is not one of {', '.join(DIALECTS)}")
    called = names or [f"tape {number}" for number in range(1, len(sources) + 1)]

    def pal3() -> Assembly3:
        return Assembly3(Source(sources, modern), called, capacity, model)

    def pal8() -> "Assembly8":
        from pal.pal8.assembly import Assembly8

        return Assembly8(sources, called, model, wipe, exact)

    if dialect == FOUND:
        from pal import recognition

        return recognition.found(sources, pal3, pal8)
    assembly = pal3() if dialect == PAL3 else pal8()
    if assembly.ok:
        return assembly
    from pal import recognition

    return recognition.compared(assembly, pal8() if dialect == PAL3 else pal3())
