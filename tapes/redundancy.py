"""What a tape says of its own frames: which value a doubtful one must have, which way the tape was read.

Each code has its `rule`, and a BIN tape its checksum. A value is proposed only if one alone differs least
from what was seen, in channels that are in doubt. A rule that nine frames in ten obey makes another one
doubtful, however sure its holes look.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import combinations

from tapes import codes
from tapes.code import MOST_WRONG, Code
from tapes.frames import BLANK, LEAST_LEADER
from tapes.loaders import Words

_MIRRORED = bytes(int(f"{frame:08b}"[::-1], 2) for frame in range(256))

REVERSE, MIRROR = "--reverse", "--mirror"
TURNED = {
    REVERSE: "back to front",
    MIRROR: "upside down",
    f"{REVERSE} {MIRROR}": "upside down and back to front",
}
"""How a tape was read that this option of `pdp8 tape cut` turns."""

_MOST_FLIPPED = 3
_MOST_CHANNELS = 24


def propose(frames: bytes, doubtful: Mapping[int, int]) -> tuple[dict[int, int], str]:
    """Return the values that a rule gives to `doubtful` frames, and the rule; ({}, "") if no rule does.

    The frames are {number: mask of the doubtful channels}; the result is {number: value}.
    """
    code = codes.recognise(frames)
    if code.sums_up(frames) is not None:
        return _by_checksum(code, frames, doubtful)
    rule = code.rule(frames, doubtful)
    return (_by_frame(frames, doubtful, rule.obeyed), rule.name) if rule else ({}, "")


def contradict(
    frames: bytes, doubtful: Mapping[int, int], weakest: Sequence[tuple[float, int]]
) -> tuple[dict[int, int], str]:
    """Return which frames that are not in doubt the tape's redundancy says are wrong, and by what it says so:
    {number: mask} with the channel that is likeliest the other.

    `weakest` has for each frame how near that channel is to being the other, and its mask. Nothing is said if
    more than a tenth of the frames are wrong: then it is the rule that is.
    """
    code = codes.recognise(frames)
    if code.sums_up(frames) is not None:
        likely = sorted(range(len(frames)), key=lambda at: weakest[at][0])[:_MOST_CHANNELS]
        masks = {at: weakest[at][1] for at in likely}
        found, by = ({}, "") if doubtful else _by_checksum(code, frames, masks, 1)
        return {at: masks[at] for at in found}, by
    rule = code.rule(frames, doubtful)
    if rule is None:
        return {}, ""
    sure = [at for at, frame in enumerate(frames) if at not in doubtful and frame != BLANK]
    wrong = {at: weakest[at][1] for at in sure if not rule.obeyed(at, frames[at])}
    return (wrong, rule.name) if len(wrong) <= MOST_WRONG * len(sure) else ({}, "")


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
    code: Code, frames: bytes, doubtful: Mapping[int, int], most: int = _MOST_FLIPPED
) -> tuple[dict[int, int], str]:
    places = [(at, bit) for at, mask in doubtful.items() for bit in _bits(mask)]
    if len(places) > _MOST_CHANNELS or code.sums_up(frames):
        return {}, ""
    for count in range(1, most + 1):
        found = []
        for flipped in combinations(places, count):
            tape = bytearray(frames)
            for at, bit in flipped:
                tape[at] ^= bit
            if code.sums_up(bytes(tape)):
                found.append({at: tape[at] for at, _ in flipped})
        if found:
            return (found[0], "the checksum") if len(found) == 1 else ({}, "")
    return {}, ""


def looks_reversed(frames: bytes) -> bool:
    """Whether a tape makes sense only from its other end."""
    return codes.recognise(frames[::-1]).sense(frames[::-1]) > codes.recognise(frames).sense(frames)


def mirrored(frames: bytes) -> bytes:
    """Return the tape turned over: channel 8 is channel 1, channel 7 channel 2."""
    return frames.translate(_MIRRORED)


def turned(frames: bytes) -> str:
    """Return how to turn a tape that makes no sense: REVERSE, MIRROR or both; "" if not."""
    own = _sense(frames)
    ways = {REVERSE: frames[::-1], MIRROR: mirrored(frames), f"{REVERSE} {MIRROR}": mirrored(frames[::-1])}
    senses = {way: _sense(tape) for way, tape in ways.items()}
    best = max(senses, key=lambda way: senses[way])
    return best if senses[best] > max(2, 2 * own) else ""


def _sense(frames: bytes) -> float:
    code = codes.recognise(frames)
    sense = code.sense(frames)
    if isinstance(code, Words):
        whole = LEAST_LEADER in frames and sense >= len(frames) and code.sums_up(frames) is not False
        return sense if whole else 0.0
    return sense
