"""DEC's PAL III assembler of February 1967 (DEC-08-ASB1), frame for frame, and its inverse; and PAL8.

isa            what the 4,096 words mean; everything else asks it
models         what words do on the 8, 8/S, 8/I and 8/E that an 8/L does otherwise
symbols        the permanent symbols: the one table, for both ways; symbols8, those of PAL8
source         frames of source tapes to the items that PAL III reads
table          the symbol table as it stands in core
assembler      the mechanism: three passes over the same reading
punch          the object tape
listing        what the Teletype typed
assembly       all of it together: `Assembly`
work3, work8   what each dialect does for it
messages       all that is said of a source in either dialect: one table
diagnostics    the messages for people: place, line, caret, advice
notes          what a student should know about a program that assembles
watched        PAL III with an eye on what a source means otherwise than it says
review         what is to be noted of it after its passes
pal8           the later dialect, a front end of its own
assembling     the call: `assemble`, in either dialect
recognition    which dialect a source is in
dialects       what PAL III has for what other assemblers know
reports        cross reference, JSON, and HTML for a notebook
disassembler   words and tapes back to source
lexer          PAL III in colour, for Pygments; grammar   the same for editors
meaning        what words and names mean
server         the language server; workspace   the tapes that an editor has open; text   their lines
document       a program as an editor asks about it; pieces   a line as an editor colours it
fixes          what mends a diagnostic; formatting   a source in columns
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
