"""Tapes of every sort, each read by BIN or RIM in the machine: what is in core is what the recogniser finds.

A tape has leader of 200, blank leader or none, a title before or within it, rubouts, gaps, and what a file
may end with; some are cut, in some a frame is wrong. The loader reads it from its first frame to its last.
The recogniser's words are those in core, or its notes name what differs; what a loader loads is not
refused, and what it halts on with a wrong checksum is.
"""

import random
from typing import NamedTuple

import pytest

from pdp8 import Machine, shelf
from pdp8.computer.stop import Reason
from tapes import binary, codes, rim
from tapes.errors import TapeError
from tapes.frames import leader, with_parity
from tapes.loaders import Words
from tests.sampling import some

LOADERS = {
    "bin": (shelf.bundled_program("bin.pal").words, 0o7777),
    "rim": (shelf.bundled_program("rim.pal").words, 0o7756),
}
FREE = range(0o7600)
"""Where no loader is."""


class Made(NamedTuple):
    """A tape, the words that its maker put on it, and whether it was cut or damaged."""

    kind: str
    frames: bytes
    words: dict[int, int]
    faulty: bool


def made(seed: int) -> Made:
    """Return tape number `seed`."""
    chance = random.Random(seed)
    kind = chance.choice(["bin", "rim"])
    body, words = _body(chance, kind)
    front = chance.choice(
        [
            b"",
            leader(chance.randrange(1, 90)),
            bytes(chance.randrange(1, 60)),
            bytes(chance.randrange(1, 20)) + leader(chance.randrange(8, 70)),
            _titled(chance),
        ]
    )
    ends = [b"", leader(1), leader(chance.randrange(2, 90)), bytes(chance.randrange(1, 90))]
    after = [
        b"",
        b"",
        b"\n",
        b"\r\n",
        b"\x1a",
        bytes(chance.randrange(1, 200)),
        bytes([chance.randrange(256)]),
    ]
    tape = bytearray(front + body + chance.choice(ends) + chance.choice(after))
    fault = chance.randrange(12)
    if fault == 0:
        del tape[chance.randrange(len(front), len(front) + len(body)) :]
    elif fault == 1:
        tape[chance.randrange(len(front), len(front) + len(body))] ^= 1 << chance.randrange(8)
    return Made(kind, bytes(tape), words, fault < 2)


def _body(chance: random.Random, kind: str) -> tuple[bytes, dict[int, int]]:
    words: dict[int, int] = {}
    frames = b""
    for _ in range(chance.choice([1, 1, 2, 3]) if kind == "bin" else 1):
        section: dict[int, int] = {}
        for _ in range(chance.randrange(1, 4)):
            at = chance.randrange(0o7500)
            section |= {at + word: chance.randrange(0o10000) for word in range(chance.randrange(1, 20))}
        words |= section
        frames += leader(chance.randrange(9, 40)) * bool(frames) + _punched(chance, kind, section)
    return frames, words


def _punched(chance: random.Random, kind: str, words: dict[int, int]) -> bytes:
    frames = (binary.encode(words) if kind == "bin" else rim.encode(words)).strip(leader(1))
    if kind == "bin" and chance.randrange(4) == 0:
        message = bytes([0o377, *(chance.randrange(0o377) for _ in range(chance.randrange(9))), 0o377])
        return frames[:2] + message + frames[2:]
    if kind == "rim" and chance.randrange(4) == 0:
        step = 4 * chance.randrange(1, len(frames) // 4 + 1)
        return frames[:step] + leader(chance.randrange(1, 20)) + frames[step:]
    return frames


def _titled(chance: random.Random) -> bytes:
    text = "".join(chance.choices("ABCDEFGHIJKLMNOPQRSTUVWXYZ 0123456789-.", k=chance.randrange(2, 20)))
    text += chance.choice(["", "\r\n"])
    title = with_parity(text.encode(), chance.choice(["mark", "mark", "even", "none"]))
    before = chance.choice([b"", bytes(chance.randrange(1, 30)), leader(chance.randrange(8, 60))])
    return before + title + bytes(chance.choice([0, 0, 3, 16])) + leader(chance.randrange(8, 80))


def loaded(kind: str, frames: bytes) -> tuple[dict[int, int], bool]:
    """Return what the loader leaves in core of these frames, and whether each checksum was good."""
    words, start = LOADERS[kind]
    machine = Machine()
    machine.load(words)
    machine.sr = 0o7777
    machine.teletype.reader.lever(False)
    machine.teletype.reader.load(frames)
    machine.start(start)
    machine.run(instructions=8)  # KCC, before the lever is thrown
    machine.teletype.reader.lever(True)
    halts = []
    while (stop := machine.run(seconds=1e6)).reason is Reason.HALT:
        halts.append(machine.ac == 0)
        if not frames[machine.teletype.reader.position :].strip(b"\0\200"):
            break  # nobody presses CONT for blank tape
    assert stop.reason in (Reason.TAPE_OUT, Reason.HALT)
    good = all(halts) and (bool(halts) or kind == "rim")
    return {at: machine.core[at] for at in FREE if machine.core[at]}, good


def judged(tape: Made) -> None:
    """Compare what the loader and the recogniser make of the tape."""
    core, good = loaded(tape.kind, tape.frames)
    good &= core == {at: word for at, word in tape.words.items() if word}
    code = codes.recognise(tape.frames)
    damage = code.damage(tape.frames) if isinstance(code, Words) else TapeError("no program")
    if damage is not None:
        assert tape.faulty, damage
        # A hole too many in a second half may be one that is there in the first: RIM, which has no sum, ORs
        # them. In the first half of a checksum BIN masks it.
        assert not good or "second half" in str(damage) or "not a frame of a BIN tape" in str(damage)
        return
    assert isinstance(code, Words)
    found = {at: word for at, word in code.decode(tape.frames).items() if word}
    if not tape.faulty:
        assert (code.name, found) == (tape.kind, {at: word for at, word in tape.words.items() if word})
    start = code.known(tape.frames).start
    if found != core and not code.left_out(tape.frames):
        assert found == loaded(tape.kind, tape.frames[start:])[0]


def test_what_a_loader_leaves_in_core_is_what_is_found() -> None:
    for seed in range(300):
        judged(made(seed))


@pytest.mark.slow("5,000 tapes go through a loader by WHOLE=1")
def test_many_tapes() -> None:
    for seed in range(1000, 1000 + some(5000)):
        judged(made(seed))
