"""A program from a tape's bytes: its kind, its words, the tape that loads it, its listing.

    PAL source  ── assembled ──┐
    words spelled out as text ─┤
    BIN tape    ── decoded   ──┼──► Program ──► core, or the reader; trace and listing
    RIM tape    ── decoded   ──┘

Its frames say what a tape is. A damaged tape is refused, or loaded by force as far as it can be read.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from pdp8.computer.hardware.extension import FIELD
from tapes import ascii, binary, codes, dump, rim
from tapes.code import Code
from tapes.errors import TapeError, WorkError, called, naming
from tapes.loaders import Words
from tapes.quantities import counted, ranges

if TYPE_CHECKING:
    from pal import Assembly
    from pdp8.computer.use.trace import Listing


FOUND, PAL3, PAL8 = "auto", "pal3", "pal8"
DIALECTS = (FOUND, PAL3, PAL8)
"""Dialects, as `pal.assembly` calls them, which is loaded for a source alone."""
_SHOWN = 3
"""Errors of a source that are shown."""


class Program:
    """A program that goes into core, of 4K or more.

    name     the file's name, or the bundled one; `names` are those of all its tapes
    code     codes.ASCII (PAL source), codes.BIN or codes.RIM
    words    {address: word}
    notes    what there is to say of its tape: a label, damage that was passed over
    tape     the frames that load it, in BIN or RIM format
    listing  its lines and symbols; a tape is listed disassembled
    """

    def __init__(
        self,
        name: str,
        code: Code,
        words: dict[int, int],
        source: "Assembly | bytes",
        notes: tuple[str, ...] = (),
    ) -> None:
        self.name = name
        self.names: tuple[str, ...] = (name,)
        self.code = code
        self.words = words
        self.notes = notes
        self._source = source

    def notes_on(self, start: int, option: str) -> tuple[str, ...]:
        """What there is to say where it is started at `start`, which `option` says."""
        has = f"it has {ranges(self.words)}, and {option} says where to begin"
        return () if start in self.words else (f"no word at {start:04o}, where it is started; {has}",)

    @cached_property
    def tape(self) -> bytes:
        """The frames that load it: source is punched in BIN format."""
        return self._source if isinstance(self._source, bytes) else self._source.tape

    @cached_property
    def listing(self) -> "Listing":
        """Its lines and symbols."""
        from pdp8.computer.use.trace import Listing

        if not isinstance(self._source, bytes):
            return Listing.of(self._source)
        from pal.assembling import assemble
        from pal.disassembler import disassemble

        return Listing.of(assemble(disassemble(self.words)))


def read(frames: bytes, name: str, force: bool = False, dialect: str = FOUND, memory: int = FIELD) -> Program:
    """Return the program of a tape's frames, with `force` a damaged one too; `dialect` is pal3, pal8 or auto.
    Raises WorkError, with `name`, for errors, damage, words beyond `memory`, or no program.
    """
    frames, note = dump.unspelled(frames)
    code = codes.recognise(frames)
    with naming(name):
        if code is codes.ASCII:
            program = _assembled([frames], [name], dialect, memory)
        elif isinstance(code, Words):
            program = _loaded(frames, name, code, force, memory)
        elif code is codes.BLANK_TAPE:
            raise WorkError(f"the program tape is {'blank' if frames else 'empty'}")
        else:
            from tapes import dectape

            raise WorkError(dectape.image(len(frames)) or "neither PAL source nor a BIN or RIM tape")
        program.notes = (note, *program.notes) if note else program.notes
        if not program.words:
            raise WorkError("; ".join(("no word in it goes into core", *program.notes)))
    return program


def read_sources(tapes: Sequence[bytes], names: Sequence[str], memory: int = FIELD) -> Program:
    """Return the program of several tapes of source, as `read` does that of one. Raises WorkError."""
    together = " ".join(names)
    for tape, name in zip(tapes, names, strict=True):
        with naming(name):
            if codes.recognise(tape) is not codes.ASCII:
                raise WorkError("not PAL source: only a source may be on several tapes")
    with naming(together):
        program = _assembled(tapes, names, FOUND, memory)
    program.name = together
    program.names = tuple(names)
    return program


def _assembled(sources: Sequence[bytes], names: Sequence[str], dialect: str, memory: int) -> Program:
    from pal.assembling import assemble
    from pal.messages import DIALECT, worded

    if all(ascii.only_figures(source) for source in sources):
        raise WorkError("nothing but figures: no program, but a tape for the reader")
    assembly = assemble(*sources, names=[called(name) for name in names], dialect=dialect)
    if not assembly.ok:
        for source, name in zip(sources, names, strict=True):
            if titled := codes.ASCII.titled(source, "source"):
                raise WorkError(f"{called(name)}: " * (len(names) > 1) + titled)
        errors = [str(diagnostic) for diagnostic in assembly.diagnostics if diagnostic.error]
        more = [f"and {len(errors) - _SHOWN:,} more: `pal` shows them, with its notes"] * (
            len(errors) > _SHOWN
        )
        other = [each.headline for each in assembly.diagnostics if each.code == DIALECT and not each.error]
        report = "\n".join([*errors[:_SHOWN], *more, *other])
        raise WorkError(f"not loaded: {counted(len(errors), 'errors')}\n{report}")
    for address in assembly.words:
        if address >= memory:
            raise WorkError(
                f"address {address:05o}: a PDP-8/L with {memory // 1024}K of core ends at {memory - 1:05o}"
            )
    notes: tuple[str, ...] = ()
    if dialect == FOUND and assembly.dialect != PAL3:
        notes = (worded(DIALECT).message,)
    return Program(names[0], codes.ASCII, assembly.words, assembly, notes)


def _loaded(frames: bytes, name: str, code: Words, force: bool, memory: int) -> Program:
    words, damage = _bin(frames, memory) if code is codes.BIN else _rim(frames)
    if damage and not force:
        raise damage
    notes = [f"{damage}; loaded as far as it can be read"] if damage else []
    replaced = rim.starts_itself(words) if code is codes.RIM else None
    if replaced is not None:
        itself = f"{replaced:04o} is in the RIM loader: read by it, the tape starts itself"
        notes.append(f"{itself}, as by `pdp8 run --boot`")
    return Program(name, code, words, frames, (*notes, *code.left_out(frames)))


_Loaded = tuple[dict[int, int], TapeError | None]
"""The words, and what is wrong with the tape."""


def _bin(frames: bytes, memory: int) -> _Loaded:
    reading = binary.read(frames)
    words, fields = binary.content(reading)
    damage = binary.find_damage(reading)
    for field, frame in fields.items():
        if field >= memory // FIELD and damage is None:
            last = "only field 0" if memory == FIELD else f"fields 0 to {memory // FIELD - 1}"
            damage = TapeError(f"field {field}: this PDP-8/L has {memory // 1024}K of core, {last}", frame)
    return {address: word for address, word in words.items() if address < memory}, damage


def _rim(frames: bytes) -> _Loaded:
    reading = rim.read(frames)
    return reading.words, reading.damage
