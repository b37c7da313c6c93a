"""What can be said of a tape without running it: what it is, how long, how many minutes, whether it is whole.

Sources: 10 frames an inch (ECMA-10); ASR-33 10 characters a second, PC8/L reader 300 and punch 50 (Small
Computer Handbook, DEC).
"""

import re
from collections.abc import Iterator, Sequence

from tapes import codes, controls, dectape, doubts, frames, redundancy, title
from tapes.code import Characters, Code, Row
from tapes.quantities import counted, duration

TO_TEXT = "`pdp8 tape convert --to text` gives its G-code"
_SHOWN = 10
_INTERRUPTED = re.compile(rb"(?<=[^\0\n\r\x7f\x80\x8a\x8d\xff])\0+(?=[^\0])")


def report(tape: bytes) -> list[Row]:
    """Return what there is to say of the tape, as (name, value) in the order of interest."""
    code = codes.recognise(tape)
    others = doubts.others(tape, code)
    found = doubts.find(tape, code, others)
    way = redundancy.turned(tape)
    control = controls.other_control(tape, code)
    pieces = frames.strip(tape, code.leader)
    image = dectape.image(len(tape))
    listed = "; `pdp8 tape show` lists its files" if dectape.is_image(tape) else ""
    return [
        ("tape", code.title if tape else "empty"),
        *((("image", f"{image}, by its length{listed}"),) if image and code not in codes.CODES else ()),
        ("frames", f"{len(tape):,}: leader {len(pieces.leader)}, trailer {len(pieces.trailer)}"),
        ("length", length(len(tape))),
        ("time", times(len(tape))),
        *code.report(tape),
        *(_blanks(tape) if code is codes.ASCII and not (others or code.labels(tape)) else ()),
        *((("control", f"{control}, not the Hydra-Point's; {TO_TEXT}"),) if control else ()),
        *((("turned", f"{redundancy.TURNED[way]}: `pdp8 tape cut {way}` turns it"),) if way else ()),
        *(("doubt", f"{doubt}") for doubt in found[:_SHOWN]),
        *((("doubt", f"and {len(found) - _SHOWN:,} more"),) if found[_SHOWN:] else ()),
        *(_labels(tape, code, others) if isinstance(code, Characters) else ()),
    ]


def _blanks(tape: bytes) -> Iterator[Row]:
    """Say where blank tape interrupts a line of ASCII: a splice, or frames that were rubbed out."""
    found = [*_INTERRUPTED.finditer(tape)]
    if found:
        first = f"{counted(len(found[0].group()), 'frames')} inside a line from frame {found[0].start()} on"
        more = f", and in {counted(len(found) - 1, 'other places')}" * (len(found) > 1)
        yield "blank", f"{first}{more}"


def _labels(tape: bytes, code: Code, others: Sequence[tuple[range, Code]]) -> Iterator[Row]:
    for label in code.labels(tape):
        if any(part.start in label for part, _ in others):
            continue
        said = title.read(tape[label.start : label.stop])
        called = f", {said!r}" if said else ""
        yield "title", f"{counted(len(label), 'frames')} from frame {label.start} on{called}"
        for row in frames.draw_label(tape[label.start : label.stop]):
            yield "", row


def length(count: int) -> str:
    """Return the length of `count` frames in feet and inches."""
    feet, inches = divmod(count / frames.FRAMES_PER_INCH, 12)
    return f"{feet:.0f} ft {inches:.1f} in" if feet else f"{inches:.1f} in"


def times(count: int) -> str:
    """Return how long `count` frames take on the Teletype and on the high-speed reader and punch."""
    teletype, reader, punch = (duration(count / rate) for rate in (10, 300, 50))
    return f"Teletype (10 a second) {teletype}; high-speed reader (300) {reader}, punch (50) {punch}"
