"""A program by name becomes words for core: PAL source, a BIN tape or a RIM tape, told by its frames."""

from typing import TYPE_CHECKING

from tapes import binary, kinds, rim, shelf
from tapes.errors import TapeError, WorkError, naming

if TYPE_CHECKING:
    from pal import Assembly

_FIGURES = b"0123456789 \r\n\0\x7f"
_FIGURES += bytes(code | 0o200 for code in _FIGURES)  # with channel 8 too


def read_words(name: str) -> dict[int, int]:
    """Return {address: word} of the program called `name`: a file, a bundled name, `-` for standard input.

    Raises WorkError saying what is wrong with it, and where.
    """
    frames = shelf.read(name)
    with naming(name):
        return words(frames, name)


def words(frames: bytes, name: str) -> dict[int, int]:
    """Return {address: word} of a program tape; `name` is for its diagnostics. Raises WorkError."""
    kind = kinds.classify(frames)
    if kind == kinds.BIN:
        content = binary.decode(frames)
        for field, frame in content.fields.items():
            if field:
                raise TapeError(f"field {field}: this PDP-8/L has 4K of core, field 0 alone", frame)
        return content.words
    if kind == kinds.RIM:
        return rim.decode(frames)
    if kind == kinds.ASCII:
        if not frames.translate(None, _FIGURES):
            raise WorkError("nothing but figures: no program, but a tape for the reader")
        return assembled(frames, name).words
    if kind == kinds.BLANK_TAPE:
        raise WorkError(f"the program tape is {'blank' if frames else 'empty'}")
    raise WorkError("neither PAL source nor a BIN or RIM tape")


def assembled(source: bytes, name: str) -> "Assembly":
    """Return the assembly of PAL III source. Raises WorkError with its diagnostics."""
    import pal

    assembly = pal.assemble(source, names=[name])
    if not assembly.ok:
        report = "\n".join(str(diagnostic) for diagnostic in assembly.diagnostics)
        raise WorkError(f"not run, it has errors\n{report}")
    return assembly
