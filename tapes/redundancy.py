"""What a tape says of its own frames: which value a doubtful one must have, which way the tape was read.

    ascii      every character has the tape's parity
    eia        every character has an odd number of holes, and a code
    rim        an address every four frames, and channel 7 in its first alone
    bin        the checksum

A value is proposed only if one alone differs least from what was seen, in channels that are in doubt. A rule
that nine frames in ten obey makes another one doubtful, however sure its holes look.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import combinations, pairwise
from math import inf
from operator import eq

from tapes import binary, eia, kinds, rim
from tapes.errors import TapeError
from tapes.frames import BLANK, LEADER, PARITIES, RUBOUT, find_leader, parity, skip

_MOST_FLIPPED = 3
_MOST_WRONG = 0.1
_MANY = 20
_MOST_CHANNELS = 24
_NO_CHARACTERS = bytes([BLANK, LEADER, RUBOUT])


def propose(frames: bytes, doubtful: Mapping[int, int]) -> tuple[dict[int, int], str]:
    """Return the frames that the tape's redundancy says are others, {number: value}, and by what it says so.

    `doubtful` are the frames in doubt and their channels in doubt as a mask, {number: mask}. ({}, "") if it
    says nothing.
    """
    if kinds.classify(frames) == kinds.BIN:
        return _by_checksum(frames, doubtful)
    fits, by = _rule(frames, doubtful)
    return (_by_frame(frames, doubtful, fits), by) if by else ({}, "")


def contradict(
    frames: bytes, doubtful: Mapping[int, int], weakest: Sequence[tuple[float, int]]
) -> tuple[dict[int, int], str]:
    """Return which frames that are not in doubt the tape's redundancy says are wrong, and by what it says so:
    {number: mask} with the channel that is likeliest the other.

    `weakest` has for each frame how near that channel is to being the other, and its mask. Nothing is said if
    more than a tenth of the frames are wrong: then it is the rule that is.
    """
    if kinds.classify(frames) == kinds.BIN:
        likely = sorted(range(len(frames)), key=lambda at: weakest[at][0])[:_MOST_CHANNELS]
        masks = {at: weakest[at][1] for at in likely}
        found, by = ({}, "") if doubtful else _by_checksum(frames, masks, 1)
        return {at: masks[at] for at in found}, by
    fits, by = _rule(frames, doubtful)
    sure = [at for at, frame in enumerate(frames) if at not in doubtful and frame != BLANK]
    wrong = {at: weakest[at][1] for at in sure if not fits(at, frames[at])}
    return (wrong, by) if len(wrong) <= _MOST_WRONG * len(sure) else ({}, "")


def _rule(frames: bytes, doubtful: Mapping[int, int]) -> tuple[Callable[[int, int], bool], str]:
    """Return what every frame of the tape obeys, whatever the others are, and its name, or "" if nothing."""
    kind = kinds.classify(frames)
    if kind == kinds.RIM:
        start = skip(frames, find_leader(frames), LEADER)
        return (
            lambda at, frame: at < start or frame == LEADER or frame >> 6 == ((at - start) % 4 == 0),
            "RIM's order",
        )
    if kind == kinds.EIA:
        return lambda _, frame: frame in eia.CHARACTERS or frame in (BLANK, eia.DELETE), "EIA's odd holes"
    sure = bytes(frame for number, frame in enumerate(frames) if number not in doubtful)
    obeyed = _parity(sure)
    if kind == kinds.ASCII and obeyed in PARITIES:
        table = PARITIES[obeyed]
        obeys = bytes(frame for frame in range(256) if table[frame] == frame or frame in _NO_CHARACTERS)
        return lambda _, frame: frame in obeys, f"the tape's parity, {obeyed}"
    return lambda _at, _frame: True, ""


def _parity(frames: bytes) -> str:
    """Return the parity that nine in ten of a tape's characters obey, all of them if they are few."""
    characters = bytes(frame for frame in frames if frame not in _NO_CHARACTERS)
    obeying = {name: sum(map(eq, characters, characters.translate(PARITIES[name]))) for name in PARITIES}
    best = max(obeying, key=lambda name: obeying[name])
    enough = len(characters) - int(_MOST_WRONG * len(characters) if len(characters) >= _MANY else 0)
    return best if obeying[best] >= enough and characters else parity(frames)


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


def _by_checksum(
    frames: bytes, doubtful: Mapping[int, int], most: int = _MOST_FLIPPED
) -> tuple[dict[int, int], str]:
    places = [(at, bit) for at, mask in doubtful.items() for bit in _bits(mask)]
    if len(places) > _MOST_CHANNELS or _sums_up(frames):
        return {}, ""
    for count in range(1, most + 1):
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
