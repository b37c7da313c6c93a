"""The two codes of DEC's loaders, BIN and RIM, as tapes: recognised, captioned, reported.

A RIM tape's groups are address, word; a BIN tape of single words at scattered addresses is origin, word too,
and differs in what is before the trailer: its checksum. So a tape that reads as both is BIN when its
checksum is good and it holds a word by that reading; one RIM tape in 4096 is taken for BIN by this.
"""

from collections.abc import Collection, Iterator, Mapping
from itertools import pairwise
from typing import Final, NamedTuple

from tapes import ascii, binary, rim
from tapes.code import LABELLED, LED, MOSTLY, PERHAPS, WHOLE, Code, Row, Rule, nearly_all
from tapes.errors import TapeError
from tapes.frames import (
    BLANK,
    FILL,
    LEADER,
    LEAST_LEADER,
    LONGEST_LABEL,
    PARITIES,
    RUBOUT,
    WRITING,
    begins_as_words,
    draw_label,
    leader_start,
    skip,
    strip,
)
from tapes.quantities import counted, ranges

_FITTING = 8
"""Frames that have to fit: one tape in 65,000 begins with them by chance."""
_NO_WORDS = 64
"""Frames with channel 8 that are more than a label, rubouts and fields."""
_FILE_END = 0o232
_AROUND = (LEADER, _FILE_END)
_NAMES = {BLANK: "blank", LEADER: "leader", RUBOUT: "rubout", _FILE_END: "^Z, where OS/8 ends a file"}


class Known(NamedTuple):
    """What is known of a tape: its damage, its labels, what it lacks, and where an operator sets it."""

    damage: TapeError | None
    labels: tuple[range, ...] = ()
    notes: tuple[str, ...] = ()
    start: int = 0


class Words(Code):
    """A code of words for core, each with its address if `by_words`. A subclass says how they are read."""

    def __init__(self, name: str, title: str, article: str, by_words: bool) -> None:
        super().__init__(name, title, article)
        self._by_words = by_words

    def encode(self, words: Mapping[int, int]) -> bytes:
        """Punch {address: word}. Raises TapeError for what the format cannot name."""
        raise NotImplementedError

    def decode(self, frames: bytes) -> dict[int, int]:
        """Return {address: word}. Raises TapeError with the frame of the damage."""
        damage = self.damage(frames)
        if damage is not None:
            raise damage
        return self.readable(frames)

    def readable(self, frames: bytes) -> dict[int, int]:
        """Return {address: word} of a damaged tape as far as it can be read. Raises TapeError."""
        raise NotImplementedError

    def known(self, frames: bytes) -> Known:
        """Return what is known of a tape, whatever its damage."""
        raise NotImplementedError

    def damage(self, frames: bytes) -> TapeError | None:
        """Return what is wrong with a tape, None if nothing is."""
        return self.known(frames).damage

    def labels(self, frames: bytes) -> tuple[range, ...]:
        """Return the frames of labels: before the leader, after the last trailer."""
        return self.known(frames).labels

    def left_out(self, frames: bytes) -> tuple[str, ...]:
        """Return what to say of a tape beside its program: labels, what it lacks, a good section after it."""
        known = self.known(frames)
        said = ["a label of " * (len(label) <= LONGEST_LABEL) + _place(label) for label in known.labels]
        return (*(f"{each}, left out" for each in said), *known.notes)

    def likelihood(self, frames: bytes) -> float:
        """Return how likely a tape is in this format; one of characters, without leader, is a text."""
        if LEADER not in frames and not frames.translate(None, WRITING):
            return 0.0
        whole = self._whole(frames)
        if whole:
            return whole
        start = leader_start(frames)
        if start and b"\r\n" not in frames[:start].translate(PARITIES["none"]):
            tape = frames[start:]  # letters for the eye stand before it: lines of text do not
            if self._likelihood(tape) == LED and not nearly_all(tape.strip(FILL), WRITING):
                return LABELLED * 0.9
        return self._likelihood(frames) or self._without_leader(frames)

    def _without_leader(self, frames: bytes) -> float:
        """Return how likely a damaged tape without leader is in this format: its first frames have to fit."""
        damage = self.damage(frames)
        fits = damage is None or (damage.frame or 0) >= _FITTING
        steps = _by_words(strip(frames).body, ended=False) == self._by_words
        return PERHAPS / 2 if frames[0] >> 6 == 1 and fits and steps else 0.0

    def _whole(self, frames: bytes) -> float:
        """Return WHOLE if the loader reads the tape, a little less if that is weak evidence, else 0.0."""
        raise NotImplementedError

    def _likelihood(self, frames: bytes) -> float:
        _, content, trailer = strip(frames)
        if not content:
            return 0.0 if self._by_words else MOSTLY
        if not begins_as_words(frames, content) or _by_words(content, LEADER in trailer) != self._by_words:
            return 0.0
        if sum(frame > LEADER for frame in content) > max(_NO_WORDS, len(content) // 4):
            return 0.0
        return LED if frames.startswith(LEAST_LEADER) and not _has_lines(content) else PERHAPS

    def captions(self, frames: bytes) -> list[str]:
        """Return what each frame is: leader, an address or origin, a word, a label."""
        said: list[str] = []
        for label in (*self.labels(frames), range(len(frames), len(frames))):
            said += self._between(frames[len(said) : label.start])
            said += ["label"] * len(label)
        return said

    def _between(self, frames: bytes) -> list[str]:
        raise NotImplementedError

    def sense(self, frames: bytes) -> float:
        """Return how far a tape reads without damage."""
        damage = self.damage(frames)
        return len(frames) if damage is None or damage.frame is None else damage.frame


class _Bin(Words):
    def encode(self, words: Mapping[int, int]) -> bytes:
        return binary.encode(words)

    def readable(self, frames: bytes) -> dict[int, int]:
        return binary.content(binary.read(frames)).words

    def known(self, frames: bytes) -> Known:
        try:
            reading = binary.read(frames)
        except TapeError as error:
            return Known(error)
        return Known(binary.find_damage(reading), reading.labels, reading.notes, reading.start)

    def left_out(self, frames: bytes) -> tuple[str, ...]:
        start = binary.find_apart(frames, binary.read(frames).labels)
        apart = f"after the label, from frame {start} on, a good section: a tape of its own, left out"
        return (*super().left_out(frames), *[apart] * (start is not None))

    def _whole(self, frames: bytes) -> float:
        reading = binary.read_whole(frames)
        if reading is None or reading.damage is not None:
            return 0.0
        held = [item for section in reading.sections for item in section.items if item.kind == binary.WORD]
        return WHOLE if held else 0.95 * WHOLE

    def _between(self, frames: bytes) -> list[str]:
        def last(at: int) -> bool:  # before a trailer
            return frames[at : at + 1] == bytes([LEADER])

        said: list[str] = []
        address: int | None = None
        at = 0
        while at < len(frames):
            frame, end = frames[at], at + 1
            closing = frames.find(RUBOUT, end) if frame == RUBOUT else -1
            if closing != -1:
                said += ["rubout", *(f"({ascii.name(each)})" for each in frames[end:closing]), "rubout"]
                end = closing + 1
            elif frame == BLANK and (at == 0 or frames[at - 1] in _AROUND):  # blank tape is no word
                end = skip(frames, at, BLANK)
                said += ["blank"] * (end - at)
            elif frame < LEADER and end < len(frames) and frames[end] < 0o100 << last(end + 1):
                value = binary.together(frames, at)
                end += 1
                closes = last(end) and address is not None
                if frame >> 6 and frames[end - 1] < 0o100 and not closes:
                    caption, address = f"origin {value:04o}", value
                elif address is None or closes:
                    caption, address = f"checksum {value:04o}", None
                else:
                    caption, address = f"{address:04o}: {value:04o}", address + 1 & 0o7777
                said += [caption, '"']
            else:
                said.append(_single(frame))
            at = end
        return said

    def report(self, frames: bytes) -> list[Row]:
        try:
            reading = binary.read(frames)
        except TapeError as error:
            return [("damage", str(error))]
        begin = binary.first((reading.sections[0].items if reading.sections else ()) or reading.unended)
        if begin.kind == binary.WORD:
            said = "a word before any origin. The BIN loader has no address for it; an object tape of FORTRAN"
            return [("damage", f"frame {begin.frame}: {said} looks so")]
        rows: list[Row] = []
        for section in reading.sections:
            good = section.computed == section.punched
            verdict = "good" if good else f"WRONG, {section.computed:04o} computed"
            held = [item.kind for item in section.items]
            holds = [f"{kind}s {held.count(kind)}" for kind in (binary.WORD, binary.ORIGIN, binary.FIELD)]
            rows.append(("checksum", f"{section.punched:04o} at frame {section.frame}: {verdict}"))
            rows.append(("holds", ", ".join(holds)))
        if reading.damage:
            rows.append(("damage", str(reading.damage)))
        if binary.find_damage(reading) is None:
            rows.append(("core", ranges(binary.content(reading).words)))
        rows += [("note", note) for note in reading.notes]
        rows += _labels(frames, reading.labels)
        start = binary.find_apart(frames, reading.labels)
        if start is not None:
            apart = f"a good section from frame {start} on, after the label: a tape of its own"
            rows.append(("apart", apart))
        return rows

    def sums_up(self, frames: bytes) -> bool | None:
        return self._whole(frames) == WHOLE


class _Rim(Words):
    def encode(self, words: Mapping[int, int]) -> bytes:
        return rim.encode(words)

    def readable(self, frames: bytes) -> dict[int, int]:
        return rim.read(frames).words

    def known(self, frames: bytes) -> Known:
        try:
            reading = rim.read(frames)
        except TapeError as error:
            return Known(error)
        return Known(reading.damage, reading.labels, reading.notes, reading.start)

    def _whole(self, frames: bytes) -> float:
        led = frames[0] >= LEADER  # without leader it may be in EIA, whose end of block would be a trailer
        return (WHOLE if led else LABELLED) if rim.read_whole(frames) else 0.0

    def _between(self, frames: bytes) -> list[str]:
        said: list[str] = []
        while len(said) < len(frames):
            group = frames[len(said) : len(said) + 4]
            if len(group) == 4 and [frame >> 6 for frame in group] == [1, 0, 0, 0]:
                address, word = (group[0] & 0o77) << 6 | group[1], group[2] << 6 | group[3]
                said += [f"address {address:04o}", '"', f"{word:04o}", '"']
            else:
                said.append(_single(group[0]))
        return said

    def report(self, frames: bytes) -> list[Row]:
        try:
            reading = rim.read(frames)
        except TapeError as error:
            return [("damage", str(error))]
        held = ("holds", f"{counted(len(reading.words), 'words')}; RIM has no checksum")
        damages = [("damage", str(reading.damage))] * (reading.damage is not None)
        notes = [("note", note) for note in reading.notes]
        return [held, ("core", ranges(reading.words)), *damages, *notes, *_labels(frames, reading.labels)]

    def rule(self, frames: bytes, doubtful: Collection[int] = ()) -> Rule | None:
        """Return RIM's order: an address every four frames, and channel 7 in its first only."""
        start = skip(frames, self.known(frames).start, LEADER)
        return Rule(
            "RIM's order",
            lambda at, frame: at < start or frame == LEADER or frame >> 6 == ((at - start) % 4 == 0),
        )


BIN: Final = _Bin("bin", "BIN, DEC's binary loader format", "a BIN tape", by_words=False)
RIM: Final = _Rim("rim", "RIM, DEC's read-in mode format", "a RIM tape", by_words=True)


def _has_lines(content: bytes) -> bool:
    codes = content.translate(PARITIES["none"])
    return nearly_all(content, WRITING) and (ascii.CR in codes or ascii.LF in codes)


def _by_words(content: bytes, ended: bool) -> bool:
    """Whether addresses come every four frames, as on a RIM tape; before a checksum come six."""
    addresses = [at for at, frame in enumerate(content) if frame >> 6 == 1]
    steps = [after - at for at, after in pairwise([*addresses, *[len(content)] * ended])]
    return bool(steps) and steps.count(4) >= 0.75 * len(steps) and steps[-1] != 6


def _single(frame: int) -> str:
    return _NAMES.get(frame) or (f"field {frame >> 3 & 7}" if frame >> 6 == 3 else "?")


def _labels(frames: bytes, labels: tuple[range, ...]) -> Iterator[Row]:
    """Say where each label is, and draw it as the eye reads it."""
    for label in labels:
        yield "label" if len(label) <= LONGEST_LABEL else "rest", _place(label)
        for row in draw_label(frames[label.start : label.stop]):
            yield "", row


def _place(label: range) -> str:
    return f"{counted(len(label), 'frames')} from frame {label.start} on"
