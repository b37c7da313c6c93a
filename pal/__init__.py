"""DEC's PAL III assembler of February 1967 (DEC-08-ASB1), frame for frame, its disassembler, and PAL8.

isa            what the 4,096 words mean; everything else asks it
models         what words do on the 8, 8/S, 8/I and 8/E that an 8/L does otherwise
symbols        the permanent symbols of PAL III, for assembling and disassembling
source         source tapes as the items that PAL III reads
table          the symbol table as it is in core
assembler      PAL III's mechanism: three passes over the same reading
watched        the same, noting where a source means something else than it says
review         the notes on a PAL III source after its passes
pal8           PAL8, a package
assembling     the call: `assemble`, in either dialect
recognition    which dialect a source is in
assembly       what became of a source: `Assembly`; assembly3   in PAL III
punch          the object tape
listing        what the Teletype typed
messages       every message and note of both dialects, in one table
diagnostics    the messages with place, line, caret and advice
notes          what is noted of a program's words, in either dialect
dialects       what PAL III has for what other assemblers know
reports        an assembly as JSON, and as HTML for a notebook
disassembler   words and tapes back to source
lexer          PAL III in colour, for Pygments
meaning        what words and names mean
server         the language server; workspace   the tapes that an editor has open; text   their lines
document       a program as an editor asks about it; pieces   a line as an editor colours it
fixes          edits that correct a diagnostic; formatting   a source in columns, or silenced
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pal.assembling import assemble
    from pal.assembly import Assembly

__all__ = ["Assembly", "assemble"]


def __getattr__(name: str) -> object:
    """Import the assembler when it is asked for: the computer needs only `isa`."""
    if name not in __all__:
        raise AttributeError(f"module 'pal' has no attribute {name!r}")
    from pal import assembling

    return getattr(assembling, name)


def __dir__() -> list[str]:
    """Return the names of the package, those that are not loaded yet too."""
    return sorted({*globals(), *__all__})
