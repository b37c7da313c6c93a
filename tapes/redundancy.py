"""What a tape says of its own frames: which value a doubtful one must have, which way the tape was read.

    ascii      every character has the tape's parity
    eia        every character has an odd number of holes, and a code
    rim        an address every four frames, and channel 7 in its first alone
    bin        the checksum

A value is proposed only if one alone differs least from what was seen, in channels that are in doubt.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from itertools import combinations, pairwise
from math import inf

from tapes import binary, eia, kinds, rim
from tapes.errors import TapeError
from tapes.frames import BLANK, LEADER, PARITIES, RUBOUT, find_leader, parity, skip

_MOST_FLIPPED = 3
_MOST_CHANNELS = 24
_NO_CHARACTERS = bytes([BLANK, LEADER, RUBOUT])


def propose(frames: bytes, doubtful: Mapping[int, int]) -> tuple[dict[int, int], str]:
    """Return the frames that the tape's redundancy says are others, {number: value}, and by what it says so.

    `doubtful` are the frames in doubt and their channels in doubt as a mask, {number: mask}. ({}, "") if it
    says nothing.
    """
    kind = kinds.classify(frames)
    sure = bytes(frame for number, frame in enumerate(frames) if number not in doubtful)
    if kind == kinds.BIN:
        return _by_checksum(frames, doubtful)
    if kind == kinds.RIM:
        start = skip(frames, find_leader(frames), LEADER)
        return _by_frame(
            frames, doubtful, lambda at, frame: frame >> 6 == ((at - start) % 4 == 0)
        ), "RIM's order"
    if kind == kinds.EIA:
        return _by_frame(
            frames, doubtful, lambda _, frame: frame in eia.CHARACTERS or frame == BLANK
        ), "EIA's odd holes"
    obeyed = parity(sure)
    if kind == kinds.ASCII and obeyed in PARITIES:
        table = PARITIES[obeyed]
        obeys = bytes(frame for frame in range(256) if table[frame] == frame or frame in _NO_CHARACTERS)
        return _by_frame(frames, doubtful, lambda _, frame: frame in obeys), f"the tape's parity, {obeyed}"
    return {}, ""


def _by_frame(frames: bytes, doubtful: Mapping[int, int], fits: Callable[[int, int], bool]) -> dict[int, int]:
    found = {}
    for at, mask in doubtful.items():
        if not fits(at, frames[at]):
            one = [frames[at] ^ bit for bit in _bits(mask) if fits(at, frames[at] ^ bit)]
            if len(one) == 1:
                found[at] = one[0]
    return found


def _bits(mask: int) -> Iterator[int]:
    return (1 << channel for channel in range(8) if mask >> channel & 1)


def _by_checksum(frames: bytes, doubtful: Mapping[int, int]) -> tuple[dict[int, int], str]:
    places = [(at, bit) for at, mask in doubtful.items() for bit in _bits(mask)]
    if len(places) > _MOST_CHANNELS or _sums_up(frames):
        return {}, ""
    for count in range(1, _MOST_FLIPPED + 1):
        found = []
        for flipped in combinations(places, count):
            tape = bytearray(frames)
            for at, bit in flipped:
                tape[at] ^= bit
            if _sums_up(bytes(tape)):
                found.append({at: tape[at] for at, _ in flipped})
        if found:
            return (found[0], "the checksum") if len(found) == 1 else ({}, "")
    return {}, ""


def _sums_up(frames: bytes) -> bool:
    try:
        return bool(binary.decode(frames).words)
    except TapeError:
        return False


def looks_reversed(frames: bytes) -> bool:
    """Tell whether a tape makes sense only from its other end, as one does that was seen from below."""
    return _sense(frames[::-1]) > _sense(frames)


def _sense(frames: bytes) -> float:
    """Return how much sense a tape makes in its order; 0 if none can be told."""
    kind = kinds.classify(frames)
    if kind in (kinds.BIN, kinds.RIM):
        try:
            damage = binary.find_damage(binary.read(frames)) if kind == kinds.BIN else rim.read(frames).damage
        except TapeError as error:
            damage = error
        return inf if damage is None or damage.frame is None else damage.frame
    if kind == kinds.ASCII:
        return frames.translate(PARITIES["none"]).count(b"\r\n")
    if kind == kinds.EIA:
        with suppress(TapeError):
            return _in_sequence(frames)
    return 0


def _in_sequence(frames: bytes) -> float:
    """Return how many blocks of an EIA tape have a number one more than that before. Raises TapeError."""
    starts = [line[:3] for line in eia.decode(frames, blank="0").split("\n")]
    numbers = [int(start) for start in starts if start.isdecimal()]
    return sum(after - before == 1 for before, after in pairwise(numbers))
