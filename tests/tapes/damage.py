"""Tapes with one kind of damage each, drawn at random: what is damaged is known, and nothing else is.

    python -m tests.tapes.damage 2000     how many damaged frames are named, missed, invented, rightly guessed

Texts: Hydra-Point blocks, word address, prose. Codes: EIA, ASCII with even parity (ISO), mark, or one after
the other. It uses the codes' encoders, and no other part of the package to make a tape.
"""

import random
import sys
from collections import Counter
from collections.abc import Iterator
from typing import NamedTuple

from tapes import ascii, controls, convert, doubts, eia, ita2, redundancy
from tapes import codes as tape_codes
from tapes.errors import WorkError

DAMAGES = (
    "none", "hole", "holes", "rubout", "splice", "reverse", "mirror", "both", "title", "mixed", "missing",
    "doubled",
)  # fmt: skip
CODES = ("eia", "even", "mark", "odd", "ita2")
_PROSE = ("THE", "TAPE", "IS", "READ", "BY", "A", "MACHINE", "AND", "PUNCHED", "FOR", "EACH", "PART")
_GLYPHS = [b"\x7f\x11\x11\x0e", b"\x7f\x40\x40", b"\x3e\x41\x41\x22", b"\x7f\x49\x49\x41", b"\x01\x7f\x01"]


class Damaged(NamedTuple):
    """A tape; the frames that are damaged in a way its code can show; {frame: value} before the damage."""

    what: str
    tape: bytes
    wrong: frozenset[int]
    was: dict[int, int]


def drawn(count: int, seed: int) -> Iterator[Damaged]:
    """Yield so many tapes."""
    draw = random.Random(seed)
    for number in range(count):
        yield _one(draw, DAMAGES[number % len(DAMAGES)], CODES[number // len(DAMAGES) % len(CODES)])


def _one(draw: random.Random, damage: str, code: str) -> Damaged:
    form = "prose" if code == "ita2" else draw.choice(("blocks", "words", "prose"))
    text = {"blocks": _blocks, "words": _words, "prose": _lines}[form](draw, draw.randrange(12, 90))
    body = _punched(text, code)
    lead = bytes(draw.randrange(40))
    tape, wrong, was = lead + body + lead, frozenset[int](), dict[int, int]()
    if damage in ("hole", "holes"):
        for at in draw.sample(range(len(lead), len(lead) + len(body)), 1 if damage == "hole" else 3):
            bit = 0o200 if code in ("mark", "ita2") else 1 << draw.randrange(8)
            if tape[at] in (0o377, 0o177) or tape[at] ^ bit in (0, 0o200, 0o377):
                continue
            was[at] = tape[at]
            tape = tape[:at] + bytes([tape[at] ^ bit]) + tape[at + 1 :]
        seen = {at for at in was if not (code == "eia" and tape[at] == 0o177)}
        wrong = frozenset(seen)
    elif damage == "rubout":
        at = draw.randrange(len(lead), len(lead) + len(body))
        tape = tape[:at] + bytes([{"eia": 0o177, "ita2": 0o37}.get(code, 0o377)]) * 2 + tape[at:]
    elif damage == "splice":
        at = draw.randrange(len(lead) + 30, len(lead) + len(body) - 30)
        tape = tape[:at] + bytes(6) + tape[at:]
        wrong = frozenset([at] if code == "eia" else [])
    elif damage == "title":
        letters = b"\0\0".join(draw.choice(_GLYPHS) for _ in range(draw.randrange(4, 9)))
        tape = letters + bytes(draw.randrange(8, 30)) + body + lead
    elif damage in ("missing", "doubled"):
        at = len(lead) + draw.randrange(30, len(body) - 30)
        tape = tape[:at] + tape[at + 1 if damage == "missing" else at :]
        tape = tape if damage == "missing" else tape[:at] + tape[at : at + 1] + tape[at:]
        if form == "blocks":
            wrong = _uneven(damage, at - len(lead), 20 if code == "eia" else 21, len(lead))
    elif damage == "mixed" and code not in ("eia", "ita2"):
        other = "odd" if code == "even" else "even"
        tape = lead + body + _punched(text, other) + lead
    elif damage == "mirror":
        tape = bytes(int(f"{frame:08b}"[::-1], 2) for frame in tape)
    elif damage == "reverse":
        tape = tape[::-1]
    elif damage == "both":
        tape = bytes(int(f"{frame:08b}"[::-1], 2) for frame in tape[::-1])
    return Damaged(f"{damage} {code} {form}", tape, wrong, was)


def _uneven(damage: str, at: int, rows: int, first: int) -> frozenset[int]:
    """Return where a line is named of which frame `at` is missing or doubled: it has not 19 digits then."""
    row = at % rows
    if row == 19 and rows == 21:  # a carriage return says nothing of the length
        return frozenset()
    if row == rows - 1 and damage == "doubled":
        return frozenset([first + at + 1])
    return frozenset([first + at - row])


def _punched(text: str, code: str) -> bytes:
    if code == "ita2":
        return ita2.ITA2.encode(text)
    return eia.encode(text) if code == "eia" else ascii.encode(text, code, 0)


def _blocks(draw: random.Random, count: int) -> str:
    x, y, lines = draw.randrange(9000), draw.randrange(5000), []
    for number in range(1, count + 1):
        x, y = x + draw.randrange(40), y + draw.randrange(40)
        lines.append(f"{number:03}6{x:05}{y:05}0{draw.randrange(1, 19):02}{draw.choice((84, 85))}\n")
    return "".join(lines)


def _words(draw: random.Random, count: int) -> str:
    lines = []
    for number in range(1, count + 1):
        x, y = draw.uniform(-9, 9), draw.uniform(-9, 9)
        lines.append(f"N{number:03}G0{draw.randrange(4)}X{x:.3f}Y{y:.3f}F{draw.randrange(1, 40)}\n")
    return "".join(lines)


def _lines(draw: random.Random, count: int) -> str:
    return "".join(" ".join(draw.choices(_PROSE, k=draw.randrange(3, 9))) + "\n" for _ in range(count))


def _refused(tape: bytes) -> bool:
    try:
        convert.convert(tape, tape_codes.recognise(tape).name, "text")
    except WorkError:
        return True
    return False


def survey(count: int, seed: int) -> tuple[Counter[str], list[str]]:
    """Return what was found, counted, and what was not as it should be."""
    found: Counter[str] = Counter()
    faults = []
    ways = {"reverse": "--reverse", "mirror": "--mirror", "both": "--reverse --mirror"}
    for what, tape, wrong, was in drawn(count, seed):
        damage, _, form = what.split()
        way = redundancy.turned(tape)
        if damage in ways and form != "prose":
            found["turned, of"] += 1
            found["turned"] += way == ways[damage]
            if way != ways[damage]:
                faults.append(f"{what}: said to be {way or 'not'} turned")
        elif way and damage not in ways:
            faults.append(f"{what}: said to be turned {way}")
        if damage in ways:
            if way and not _refused(tape):
                faults.append(f"{what}: made a text of")
            continue
        doubtful = {doubt.frame: doubt for doubt in doubts.find(tape)}
        found["damaged"] += len(wrong)
        found["of a wrong hole"] += len(wrong & was.keys())
        found["named"] += len(wrong & doubtful.keys())
        found["invented"] += len(doubtful.keys() - wrong)
        proposed = [at for at in wrong & doubtful.keys() if doubtful[at].likely is not None]
        found["proposed"] += len(proposed)
        found["rightly"] += sum(doubtful[at].likely == was.get(at) for at in proposed)
        if doubtful.keys() != wrong:
            faults.append(f"{what}: {sorted(wrong)} damaged, {[str(each) for each in doubtful.values()][:3]}")
        code = tape_codes.recognise(tape)
        if (controls.other_control(tape, code) == "word address") != (form == "words"):
            faults.append(f"{what}: word address not as it is")
        refused = _refused(tape)
        if refused != bool(wrong):
            faults.append(f"{what}: {'refused' if refused else 'mended in silence'}")
    return found, faults


if __name__ == "__main__":
    counted, wrongs = survey(int(sys.argv[1]), int(sys.argv[2]) if sys.argv[2:] else 60)
    print(*wrongs[:60], sep="\n")
    print(dict(counted), f"{len(wrongs)} not as they should be")
