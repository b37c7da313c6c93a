"""One call: source tapes in, an assembly out, in PAL III or PAL8.

assemble("*200\\n\\tCLA\\n\\tHLT\\n$\\n").words  ->  {0o200: 0o7200, 0o201: 0o7402}
"""

from collections.abc import Sequence

from pal.assembler import TELETYPE_SYMBOLS
from pal.assembly import PAL3, PAL8, Assembly
from pal.source import Source

FOUND = "auto"
DIALECTS = (FOUND, PAL3, PAL8)


def assemble(
    *sources: str | bytes,
    names: Sequence[str] | None = None,
    modern: bool = False,
    capacity: int = TELETYPE_SYMBOLS,
    model: str | None = None,
    dialect: str = PAL3,
) -> Assembly:
    """Assemble the source tapes, read one after the other.

    sources   frames, with channel 8 or without, or texts; in a text a character beyond ASCII is illegal
    names     what the diagnostics call each tape
    modern    fold lower case
    capacity  room for symbols of the source, by its reader: TELETYPE_SYMBOLS, or HIGH_SPEED_SYMBOLS, which
              reads ahead and at PAUSE loses the rest of the line
    model     one of models.MODELS: the diagnostics note what other models do otherwise
    dialect   "pal3", "pal8", or "auto": PAL8 where a source in error has at most half as many errors as PAL8,
              and a line of PAL8's alone (`pal.assembly8.found`); a note says so

    Whatever is wrong with the source is a diagnostic. Raises ValueError for another dialect.
    """
    if dialect not in DIALECTS:
        raise ValueError(f"{dialect!r} is not one of {', '.join(DIALECTS)}")
    called = names or [f"tape {number}" for number in range(1, len(sources) + 1)]
    if dialect == PAL8:
        from pal.assembly8 import Assembly8

        return Assembly8(sources, called, model)
    assembly = Assembly(Source(sources, modern), called, capacity, model)
    if dialect == FOUND and not assembly.ok:
        from pal.assembly8 import found

        return found(assembly, sources)
    return assembly
