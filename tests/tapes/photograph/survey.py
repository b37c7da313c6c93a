"""The table of errors in docs/photographs.md, by `python -m tests.tapes.photograph.survey`.

Each row is a kind of picture, read several times with other tapes. A frame is wrong in silence if it is not
what was drawn and not doubtful; that, and a frame that is lost or invented without a word, must never be.
"""

import random
import sys
from collections import Counter
from difflib import SequenceMatcher

from tapes import photograph
from tapes.errors import TapeError
from tests.tapes.photograph import camera
from tests.tapes.photograph.camera import Shot

LENGTH = 150

WORST = Shot(row=6, perspective=0.3, curl=0.11, barrel=0.15, shadow=0.5, jpeg=30)

WITHIN = {
    "plain": Shot(),
    "turned by 37 degrees": Shot(angle=37),
    "perspective .1": Shot(perspective=0.1),
    "perspective .2": Shot(perspective=0.2),
    "perspective .3": Shot(perspective=0.3),
    "perspective .3, from the side": Shot(perspective=0.3, towards=90),
    "perspective .3, from a corner": Shot(perspective=0.3, towards=50, angle=15),
    "curl 4 %": Shot(curl=0.04, towards=90, perspective=0.1),
    "curl 11 %": Shot(curl=0.11, towards=90, perspective=0.15),
    "barrel .15": Shot(barrel=0.15),
    "shadow of half the light": Shot(shadow=0.5),
    "light falls by 85 %": Shot(fall=0.85),
    "6 pixels a row": Shot(row=6),
    "JPEG 30": Shot(jpeg=30),
    "noise 12": Shot(noise=12),
    "blur .12": Shot(blur=0.12),
    "dark tape, lit from behind": Shot(paper=70, behind=235),
    "on wood": Shot(table="wood"),
    "on a desk": Shot(table="desk"),
    "bright table": Shot(behind=140),
    "all at once": WORST._replace(fall=0.5, table="wood"),
}
"""The limits within which every frame is to be right or doubtful."""

BEYOND = {
    "4 pixels a row": Shot(row=4),
    "perspective .5": Shot(perspective=0.5),
    "curl 25 %": Shot(curl=0.25, towards=90, perspective=0.15),
    "blur .25": Shot(blur=0.25),
    "noise 60": Shot(noise=60),
}

MARKED, SILENT = "wrong and marked", "wrong in silence"
HEADINGS = ("frames", "doubtful", MARKED, SILENT, "lost", "refused")


def some_tape(seed: int, length: int = LENGTH) -> bytes:
    """Return a tape of all kinds of frames: runs of blanks, leader and rubouts among any others."""
    draw = random.Random(seed)
    tape = bytearray()
    while len(tape) < length:
        run = draw.choice([1, 1, 1, 1, 1, 1, draw.randrange(2, 16)])
        tape += bytes([draw.choice([0, 0o377, 0o200, *(draw.randrange(256) for _ in range(5))])]) * run
    return bytes(tape[:length])


def varied(shot: Shot, seed: int) -> Shot:
    """Return the shot from another side, so that no two pictures of a row are alike."""
    draw = random.Random(seed)
    return shot._replace(
        seed=seed,
        angle=shot.angle + draw.choice([0, 180]) + draw.uniform(-6, 6),
        row=shot.row + draw.uniform(0, 0.5),
        towards=shot.towards + draw.choice([0, 180]),
        barrel=shot.barrel * draw.choice([1, -1]),
        curl=shot.curl * draw.choice([1, -1]),
        fall_towards=draw.uniform(0, 360),
        shadow_at=draw.uniform(0.3, 0.7),
    )


def count(tape: bytes, picture: bytes) -> Counter[str]:
    """Read a picture of a tape, and count its frames under the table's headings."""
    try:
        found = photograph.read(picture)
    except TapeError:
        return Counter(frames=len(tape), refused=len(tape))
    counted = Counter(frames=len(tape), doubtful=sum(frame.doubtful for frame in found))
    seen = bytes(frame.holes for frame in found)
    for tag, *drawn, begin, end in SequenceMatcher(None, tape, seen, autojunk=False).get_opcodes():
        if tag != "equal":
            marked = sum(frame.doubtful for frame in found[begin:end])
            missing = max(0, drawn[1] - drawn[0] - (end - begin))
            counted += Counter({MARKED: marked, SILENT: end - begin - marked, "lost": missing})
    return counted


def row(kind: str, counted: Counter[str]) -> str:
    return f"| {kind} | {' | '.join(f'{counted[heading]:,}' for heading in HEADINGS)} |"


def main(pictures: int, only: str = "") -> None:
    print(f"| picture | {' | '.join(HEADINGS)} |")
    print("| --- " * 7 + "|")
    total: Counter[str] = Counter()
    for kind, shot in {**WITHIN, **BEYOND}.items():
        if only in kind:
            tapes = {seed: some_tape(seed) for seed in range(201, 201 + pictures)}
            shots = (camera.photograph(tape, varied(shot, seed)) for seed, tape in tapes.items())
            found = sum(map(count, tapes.values(), shots), Counter[str]())
            print(row(kind, found))
            total += found
    print(row("all", total))


if __name__ == "__main__":
    main(int(sys.argv[1]) if sys.argv[1:] else 4, *sys.argv[2:3])
