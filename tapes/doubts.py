"""Frames that break a rule which their tape obeys: each named, with the likeliest reading.

    frame 1067: 114 (L) breaks the tape's parity, even; likely 116 (N), channel 2

One hole is taken to be wrong. Which, is a guess from how often the rest of the tape has the character there:
between the same neighbours, and at the same place of a line. Where that does not decide, nothing is proposed.
A rule that more than one frame in ten breaks is none.
"""

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from tapes import codes
from tapes.code import LED, MOST_WRONG, Characters, Code, Rule
from tapes.errors import TapeError
from tapes.frames import BLANK, FILL, channels
from tapes.quantities import counted

_LIKELIER = 3.0
_FEW = 20
_PART = re.compile(rb"[^\0](?:.*?[^\0])??(?=\0{10}|\0*\Z)", re.DOTALL)
"""What lies between inches of blank tape."""


class Doubt(NamedTuple):
    """A frame that breaks the rule: its number, value, likely value or None, and reading if accepted."""

    frame: int
    seen: int
    likely: int | None
    said: str
    reading: str = ""

    def __str__(self) -> str:
        return f"frame {self.frame}: {self.said}"


def find(
    frames: bytes, code: Code | None = None, parts: Sequence[tuple[range, Code]] | None = None
) -> list[Doubt]:
    """Return the doubtful frames of a tape in `code`, `parts` of it in others; what is not given is found."""
    code = code or codes.recognise(frames)
    parts = others(frames, code) if parts is None else parts
    found = [_other(part, frames[part.start], other, code) for part, other in parts]
    rule = code.rule(frames)
    if rule is None:
        return found
    passed = {at for part in (*code.labels(frames), *(part for part, _ in parts)) for at in part}
    wrong = [
        at
        for at, frame in enumerate(frames)
        if frame != BLANK and not rule.obeyed(at, frame) and at not in passed
    ]
    if len(wrong) > MOST_WRONG * len(frames.replace(b"\0", b"")):
        return found
    context = _Context(frames, code.line_end)
    found += [_doubt(at, frames, code, rule, context) for at in wrong]
    for gap in code.gaps(frames):
        said = f"{counted(len(gap), 'blank frames')} inside the data, as at a splice"
        found.append(Doubt(gap.start, BLANK, None, said, "nothing"))
    found += [
        Doubt(at, frames[at], None, said, "as punched")
        for at, said in code.uneven(frames)
        if at not in passed
    ]
    return sorted(found, key=lambda doubt: doubt.frame)


def others(frames: bytes, code: Code) -> list[tuple[range, Code]]:
    """Return the parts of a tape of characters, between inches of blank tape, that are in another code."""
    found: list[tuple[range, Code]] = []
    parts = [*_PART.finditer(frames)] if isinstance(code, Characters) else []
    for part in parts if len(parts) > 1 else ():
        piece = part.group()
        other = codes.recognise(piece) if len(piece.translate(None, FILL)) >= _FEW else code
        if (
            other in codes.CODES
            and other is not code
            and _obeys(piece, other)
            and not _is_title(piece, other)
        ):
            found.append((range(*part.span()), other))
    return found


def _is_title(piece: bytes, code: Code) -> bool:
    """Whether a part may be letters for the eye: they have blank tape between them, and end no lines."""
    return isinstance(code, Characters) and (BLANK in piece or not code.has_lines(piece))


def _obeys(piece: bytes, code: Code) -> bool:
    rule = code.rule(piece)
    if rule is None:
        return code.likelihood(piece) >= LED
    return all(rule.obeyed(at, frame) for at, frame in enumerate(piece))


def check(frames: bytes, code: Code | None = None) -> None:
    """Raise TapeError for doubtful frames, naming them and how to correct them."""
    found = find(frames, code)
    if not found:
        return
    shown = [f"{doubt}" for doubt in found[:5]] + [f"and {len(found) - 5} more"] * (len(found) > 5)
    mends = [f"{doubt.frame}={doubt.likely:03o}" for doubt in found if doubt.likely is not None]
    mend = f"--mend {','.join(mends[:8])}" if mends else "--mend FRAME=OCTAL"
    accept = "; --accept takes them as they were punched" * any(doubt.reading for doubt in found)
    raise TapeError("\n".join([*shown, f"{mend} replaces frames{accept}"]))


def mended(frames: bytes, values: Mapping[int, int]) -> bytes:
    """Return the tape with other values in some frames, {number: value}."""
    tape = bytearray(frames)
    for at, value in values.items():
        tape[at] = value
    return bytes(tape)


class _Context:
    """How often each character comes after, before and below another."""

    def __init__(self, frames: bytes, end: int) -> None:
        self._codes = frames.translate(bytes(range(0o200)) * 2) if end < 0o200 else frames
        self._columns = []
        start = 0
        for at, frame in enumerate(self._codes):
            self._columns.append(at - start)
            if frame in (end, BLANK):
                start = at + 1
        self._alone = Counter(self._codes)
        self._pairs = Counter(zip(self._codes, self._codes[1:], strict=False))
        self._below = Counter(zip(self._columns, self._codes, strict=True))

    def likelihood(self, at: int, frame: int) -> float:
        """Return how likely a frame is at a place, by the rest of the tape."""
        code = frame if frame in self._alone else frame & 0o177
        if not self._alone[code]:
            return 0.0
        own = code == self._codes[at]  # the frame itself says nothing of what it should be
        before = self._pairs[self._codes[at - 1], code] - own if at else 0
        after = self._pairs[code, self._codes[at + 1]] - own if at + 1 < len(self._codes) else 0
        below = self._below[self._columns[at], code] - own
        return (before + 0.1) * (after + 0.1) * (below + 0.1) / (self._alone[code] - own + 1) ** 2


def _doubt(at: int, frames: bytes, code: Code, rule: Rule, context: _Context) -> Doubt:
    seen = frames[at]
    values = [seen ^ 1 << channel for channel in range(8)]
    scores = {value: context.likelihood(at, value) for value in values if value and rule.obeyed(at, value)}
    best, second, *_ = [*sorted(scores.values(), reverse=True), 0.0, 0.0]
    decided = best > 0 and best >= _LIKELIER * second
    likely = max(scores, key=lambda value: scores[value]) if decided else None
    said = f"{_called(code, seen)} breaks {rule.name}"
    if likely is not None:
        said += f"; likely {_called(code, likely)}, channel {channels(seen ^ likely)[0]}"
    return Doubt(at, seen, likely, said, _reading(code, seen))


def _other(part: range, seen: int, other: Code, code: Code) -> Doubt:
    cut = f"`pdp8 tape cut --from {part.start} --to {part[-1]}` cuts them out"
    said = f"the frames from here to {part[-1]} are {other.title}, not {code.title}; {cut}"
    return Doubt(part.start, seen, None, said, "as punched")


def _reading(code: Code, frame: int) -> str:
    caption = code.caption(frame)
    return "" if caption in ("?", f"{frame:03o}") else caption


def _called(code: Code, frame: int) -> str:
    holes = "channels " + " ".join(map(str, channels(frame)))
    return f"{frame:03o} ({_reading(code, frame) or holes})"
