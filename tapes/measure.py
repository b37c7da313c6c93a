"""What can be said of a tape without running it: what it is, how long, how many minutes, whether it is whole.

Sources: 10 frames an inch (ECMA-10); ASR-33 10 characters a second, PC8/L reader 300 and punch 50 (Small
Computer Handbook, DEC).
"""

from collections.abc import Callable, Iterable, Iterator
from itertools import pairwise

from tapes import ascii, binary, eia, frames, kinds, rim
from tapes.errors import TapeError
from tapes.quantities import counted, duration, ranges

Row = tuple[str, str]

_KINDS = {
    kinds.BIN: "BIN, DEC's binary loader format",
    kinds.RIM: "RIM, DEC's read-in mode format",
    kinds.EIA: "EIA RS-244",
    kinds.ASCII: "ASCII",
    kinds.BLANK_TAPE: "blank",
    kinds.UNKNOWN: "unknown: not ASCII, EIA, BIN or RIM",
}


def report(tape: bytes) -> list[Row]:
    """Return what there is to say of the tape, as (name, value) in the order of interest."""
    kind = kinds.classify(tape)
    pieces = frames.strip(tape, frames.BLANK if kind == kinds.EIA else frames.LEADER)
    details = {kinds.ASCII: _text, kinds.EIA: _blocks, kinds.BIN: _sections, kinds.RIM: _words}
    return [
        ("tape", _KINDS.get(kind, kind) if tape else "empty"),
        ("frames", f"{len(tape):,}: leader {len(pieces.leader)}, trailer {len(pieces.trailer)}"),
        ("length", length(len(tape))),
        ("time", times(len(tape))),
        *(details[kind](tape) if kind in details else ()),
    ]


def left_out(tape: bytes, kind: str) -> tuple[str, ...]:
    """Say what is on a tape of `kind`, BIN or RIM, beside its program: labels, a good section after one."""
    reading = rim.read(tape) if kind == kinds.RIM else binary.read(tape)
    labels = [f"a label of {_place(label)}, left out" for label in reading.labels]
    start = binary.find_apart(tape, reading) if isinstance(reading, binary.Reading) else None
    if start is None:
        return tuple(labels)
    return *labels, f"after the label, from frame {start} on, a good section: a tape of its own, left out"


def length(count: int) -> str:
    """Return the length of `count` frames in feet and inches."""
    feet, inches = divmod(count / frames.FRAMES_PER_INCH, 12)
    return f"{feet:.0f} ft {inches:.1f} in" if feet else f"{inches:.1f} in"


def times(count: int) -> str:
    """Return how long `count` frames take on the Teletype and on the high-speed reader and punch."""
    teletype, reader, punch = (duration(count / rate) for rate in (10, 300, 50))
    return f"Teletype (10 a second) {teletype}; high-speed reader (300) {reader}, punch (50) {punch}"


def _text(tape: bytes) -> Iterator[Row]:
    codes = tape.translate(frames.PARITIES["none"])
    returns, feeds = codes.count(ascii.CR), codes.count(ascii.LF)
    lines = ascii.decode(tape).split("\n")
    rest = lines.pop()
    yield "parity", frames.parity(tape)
    yield "lines", f"{len(lines):,}{_lengths(map(len, lines), 'characters')}{_unended(rest, 'characters')}"
    if returns == feeds == 0:
        return
    yield "line ends", f"{returns:,} CR, {feeds:,} LF, {codes.count(ascii.RUBOUT):,} RUBOUT"
    if feeds and not returns:
        yield (
            "warning",
            "LF without CR: no Teletype would return its carriage; `pdp8 tape punch` punches CR LF",
        )


def _blocks(tape: bytes) -> Iterator[Row]:
    codes = tape.strip(bytes([frames.BLANK]))
    ends = [at for at, code in enumerate(codes, 1) if code == eia.EOB]
    lengths = (end - begin for begin, end in pairwise([0, *ends]))
    rest = codes[ends[-1] :] if ends else codes
    yield "blocks", f"{len(ends):,}{_lengths(lengths, 'frames')}{_unended(rest, 'frames')}"
    yield "parity", _fault(eia.decode, tape) or "odd in every frame; every frame an EIA code"


def _sections(tape: bytes) -> Iterator[Row]:
    fault = _fault(binary.read, tape)
    if fault:
        yield "damage", fault
        return
    reading = binary.read(tape)
    first = (reading.sections[0].items if reading.sections else ()) or reading.unended
    first = tuple(item for item in first if item.kind != binary.FIELD)
    if first and first[0].kind == binary.WORD:
        yield (
            "damage",
            f"frame {first[0].frame}: a word before any origin. The BIN loader has no address for it; "
            "an object tape of FORTRAN looks so",
        )
        return
    for section in reading.sections:
        good = section.computed == section.punched
        verdict = "good" if good else f"WRONG, {section.computed:04o} computed"
        yield "checksum", f"{section.punched:04o} at frame {section.frame}: {verdict}"
        held = [item.kind for item in section.items]
        yield (
            "holds",
            ", ".join(f"{kind}s {held.count(kind)}" for kind in (binary.WORD, binary.ORIGIN, binary.FIELD)),
        )
    if reading.damage:
        yield "damage", str(reading.damage)
    if _fault(binary.decode, tape) is None:
        yield "core", ranges(binary.content(reading).words)
    yield from _labels(tape, reading.labels)
    if (start := binary.find_apart(tape, reading)) is not None:
        yield "apart", f"a good section from frame {start} on, after the label: a tape of its own"


def _words(tape: bytes) -> Iterator[Row]:
    words, damage, labels = rim.read(tape)
    yield "holds", f"{counted(len(words), 'words')}; RIM has no checksum"
    yield "core", ranges(words)
    if damage:
        yield "damage", str(damage)
    yield from _labels(tape, labels)


def _labels(tape: bytes, labels: Iterable[range]) -> Iterator[Row]:
    """Say where each label is, and draw it as the eye reads it."""
    for label in labels:
        yield "label", _place(label)
        for row in frames.draw_label(tape[label.start : label.stop]):
            yield "", row


def _place(label: range) -> str:
    return f"{counted(len(label), 'frames')} from frame {label.start} on"


def _fault(read: Callable[[bytes], object], tape: bytes) -> str | None:
    try:
        read(tape)
    except TapeError as error:
        return str(error)
    return None


def _lengths(counts: Iterable[int], unit: str) -> str:
    found = sorted(set(counts))
    if not found:
        return ""
    return f" of {counted(found[0], unit)}" if len(found) == 1 else f" of {found[0]} to {found[-1]} {unit}"


def _unended(rest: str | bytes, unit: str) -> str:
    return f", then {counted(len(rest), unit)} without an end" if rest else ""
