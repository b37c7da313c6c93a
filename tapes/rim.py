"""DEC's RIM (read-in mode) format: every word with its address, for the 17-word loader an operator toggles
in.

    200 ...      leader
    1aa 0aa      address, six bits a frame, channel 7 marks its first half
    0dd 0dd      contents
    ...          and so on, word by word
    200 ...      trailer: there is no checksum, and only the operator stops the loader

The loader passes over every frame with channel 8 that comes where an address or a word begins, and so does
`read`; there may be none before or after the words. The operator sets the tape on its first hole, or past a
title without channel 8. Blank tape between the words is passed over; the loader makes a word 0000 at 0000 of
each two frames. What follows the trailer and is no word is a label. `Reading.notes` names all this.

Not emulated: what the loader makes of frames that are not RIM (it stores them somewhere); such a tape is
damaged.

Sources: Small Computer Handbook (DEC), "Readin Mode Loader"; the loader's instructions on DEC's instruction
card.
"""

from collections.abc import Mapping
from typing import NamedTuple

from tapes import binary
from tapes.errors import TapeError
from tapes.frames import (
    BLANK,
    LEADER,
    LEAST_LEADER,
    PADDING,
    check_word,
    find_start,
    label_after,
    label_before,
    leader,
    missing_leader,
    no_trailer,
    paper_end,
    skip,
    starts,
)
from tapes.quantities import counted


def encode(words: Mapping[int, int]) -> bytes:
    """Punch `words`, {address: word}, ascending. Raises TapeError for an address or a word outside 0-7777."""
    body = bytearray()
    for address in sorted(words):
        if not 0 <= address <= 0o7777:
            raise TapeError(f"address {address:o}: a RIM tape can name only 0000 to 7777")
        word = words[address]
        check_word(address, word)
        body += bytes((0o100 | address >> 6, address & 0o77, word >> 6 & 0o77, word & 0o77))
    return leader() + bytes(body) + leader()


class Reading(NamedTuple):
    """A tape as far as it can be read: {address: word}, what is wrong with it, None if nothing is, and the
    frames of its labels, in its order.

    `notes` say what it lacks, `start` is the frame on which an operator sets it, and at `end` its trailer, or
    its last word, has been read.
    """

    words: dict[int, int]
    damage: TapeError | None = None
    labels: tuple[range, ...] = ()
    notes: tuple[str, ...] = ()
    start: int = 0
    end: int = 0


def starts_itself(words: Mapping[int, int]) -> int | None:
    """Return the address of a tape's last word if it puts a JMP into the RIM loader, 7756-7776, which then
    obeys it; else None.
    """
    last = [*words][-1] if words else 0
    return last if last in _LOADER and words[last] >> 9 == _JMP else None


def decode(frames: bytes) -> dict[int, int]:
    """Return {address: word}, the later where an address comes twice. Raises TapeError, naming the frame."""
    reading = read(frames)
    if reading.damage:
        raise reading.damage
    return reading.words


def read(frames: bytes) -> Reading:
    """Return the tape as far as it can be read. Raises TapeError where no RIM tape begins."""
    reading = read_whole(frames)
    if reading is None:
        start = find_start(frames)
        reading = _read_from(frames, start)
        if not reading.words and not reading.damage:
            raise TapeError("nothing but leader", start)
    return reading


def read_whole(frames: bytes) -> Reading | None:
    """Return the tape from the first of its `starts` at which whole words begin; None if there is none."""
    for start in starts(frames):
        reading = _read_from(frames, start)
        if reading.words and not reading.damage:
            return reading
    return None


def _read_from(frames: bytes, start: int) -> Reading:
    at = end = start
    words: dict[int, int] = {}
    labels = [*label_before(frames, start)]
    gaps: list[str] = []
    damage: TapeError | None = None
    apart = False
    while at < len(frames):
        if frames[at] >= LEADER:
            after = _passed_over(frames, at)
            letters = range(skip(frames, at, LEADER), len(frames[:after].rstrip(bytes([LEADER]))))
            if letters and not words:
                labels.append(letters)
            if words and after - at >= len(LEAST_LEADER):
                behind = skip(frames, after, BLANK)
                begins = behind if frames[behind : behind + 1] == bytes([LEADER]) else at
                apart, _ = binary.good_section(frames, begins)
                if apart:
                    gaps.append(f"a good BIN section from frame {begins} on: a tape of its own, left out")
                    break
            at = after
            continue
        data = _passed_over(frames, at + 2)
        fault = _fault(frames, at, 0) or _fault(frames, data, 2)
        if fault is None:
            words[(frames[at] & 0o77) << 6 | frames[at + 1]] = frames[data] << 6 | frames[data + 1]
            at = end = data + 2
            continue
        after = skip(frames, at, BLANK)
        if words and _after_trailer(frames, at):
            labels += [range(after, len(frames))] * (after < len(frames))
            break
        if words and frames[-1] != LEADER and not frames[end:-1].strip(_AT_THE_END):
            break  # torn: a last frame of anything; a trailer has no blank tape before it
        if not words or not at < after < len(frames) or frames[after] >> 6 != 1:
            damage = fault
            break
        gaps.append(f"{counted(after - at, 'blank frames')} from frame {at} on, passed over")
        at = after
    ended = damage is not None or apart or label_after(frames, tuple(labels)) is not None
    notes = (*missing_leader(frames, start), *gaps, *([] if ended else _ending(frames[end:])))
    return Reading(words, damage, tuple(labels), notes, start, skip(frames, end, LEADER))


def _passed_over(frames: bytes, at: int) -> int:
    """Return the first frame from `at` on without channel 8."""
    while at < len(frames) and frames[at] >= LEADER:
        at += 1
    return at


def _ending(rest: bytes) -> list[str]:
    """Say what is wrong with the end of a tape, the `rest` after its last word."""
    if rest.startswith(bytes([LEADER])):
        more = len(rest.strip(bytes([BLANK, LEADER])))
        return [f"{counted(more, 'frames')} after the trailer, left out"] * (more > 0)
    return [no_trailer(len(rest), "last word")]


def _after_trailer(frames: bytes, at: int) -> bool:
    """Whether frame `at` follows a trailer, that is, more frames of 200 than are between two words."""
    return frames[: paper_end(frames[:at])].endswith(LEAST_LEADER)


def _fault(frames: bytes, at: int, first: int) -> TapeError | None:
    """Return what is wrong unless two frames are an address (`first` 0) or a word (2)."""
    for place in (first, first + 1):
        if at == len(frames):
            return TapeError("the tape is cut short inside a word", at)
        if frames[at] >> 6 != (place == 0):
            return TapeError(f"{frames[at]:03o} where {_EXPECTED[place]} was expected", at)
        at += 1
    return None


_LOADER = range(0o7756, 0o7777)
_JMP = 5
_AT_THE_END = PADDING + bytes([LEADER])
_EXPECTED = (
    "the first half of an address",
    "the second half of an address",
    "a word",
    "the second half of a word",
)
