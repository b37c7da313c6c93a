"""DEC's RIM (read-in mode) format: every word with its address, for the 17-word loader an operator toggles
in.

    200 ...      leader
    1aa 0aa      address, six bits a frame, channel 7 marks its first half
    0dd 0dd      contents
    ...          and so on, word by word
    200 ...      trailer: there is no checksum, and nothing but the operator stops the loader

Frames of 200 between the words are skipped, and blank frames before the leader: the operator sets the tape on
its leader. What follows the trailer and is no word (letters punched for the eye) is a label.

Not emulated: what the loader makes of frames that are not RIM (it stores them somewhere); such a tape is
damaged.

Sources: Small Computer Handbook (DEC), "Readin Mode Loader"; the loader's instructions on DEC's instruction
card.
"""

from collections.abc import Mapping
from typing import NamedTuple

from tapes.errors import TapeError
from tapes.frames import (
    BLANK,
    LEADER,
    LEAST_LEADER,
    check_word,
    find_leader,
    label_before,
    leader,
    paper_end,
    skip,
)


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
    frames of its labels: before the leader, after the trailer.
    """

    words: dict[int, int]
    damage: TapeError | None = None
    labels: tuple[range, ...] = ()


def decode(frames: bytes) -> dict[int, int]:
    """Return {address: word}; where an address comes twice the later word stays, as in core.

    Raises TapeError naming the frame: an empty tape, no leader, a frame out of place, a tape cut short.
    """
    reading = read(frames)
    if reading.damage:
        raise reading.damage
    return reading.words


def read(frames: bytes) -> Reading:
    """Return the tape as far as it can be read. Raises TapeError where no RIM tape begins: an empty tape, no
    leader, nothing but leader.
    """
    at = start = find_leader(frames)
    end = _end(frames)
    labels = label_before(frames, start)
    words: dict[int, int] = {}
    while at < end:
        if frames[at] == LEADER:
            at += 1
            continue
        group = frames[at : at + 4]
        damage = _fault(group, at)
        if damage and words and _after_trailer(frames, at):
            return Reading(words, labels=(*labels, range(skip(frames, at, BLANK), len(frames))))
        if damage:
            return Reading(words, damage, labels)
        words[(group[0] & 0o77) << 6 | group[1]] = group[2] << 6 | group[3]
        at += 4
    if not words:
        raise TapeError("nothing but leader", start)
    if frames[end - 1] != LEADER:
        return Reading(words, TapeError("the tape is cut short: it has no trailer", end), labels)
    return Reading(words, labels=labels)


def _end(frames: bytes) -> int:
    """Return where the trailer ends, blank tape apart; with no trailer, where the tape ends."""
    end = paper_end(frames)
    return end if frames[end - 1] == LEADER else len(frames)


def _after_trailer(frames: bytes, at: int) -> bool:
    """Tell whether frame `at` follows a trailer: frames of 200, more than stand between two words."""
    return frames[: paper_end(frames[:at])].endswith(LEAST_LEADER)


def _fault(group: bytes, at: int) -> TapeError | None:
    """Return what is wrong unless the four frames have channels 8 and 7 as 01 00 00 00."""
    for place, frame in enumerate(group):
        if frame >> 6 != (place == 0):
            return TapeError(f"{frame:03o} where {_EXPECTED[place]} was expected", at + place)
    if len(group) < 4:
        return TapeError("the tape is cut short inside a word", at + len(group))
    return None


_EXPECTED = (
    "the first half of an address",
    "the second half of an address",
    "a word",
    "the second half of a word",
)
