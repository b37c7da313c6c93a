"""The table of errors in docs/photographs.md, by `python -m tests.tapes.photograph.survey`.

Each row is a kind of picture, read several times with other tapes. A frame is wrong in silence if it is not
what was drawn and not doubtful; that, and a frame that is lost or invented without a word, must never be.
"""

import random
import sys
from collections.abc import Iterator
from typing import NamedTuple

from tapes import photograph
from tapes.errors import TapeError
from tests.tapes.photograph import camera, scenes
from tests.tapes.photograph.camera import Shot

LENGTH = 150

WORST = Shot(row=6, perspective=0.3, curl=0.11, barrel=0.15, shadow=0.5, jpeg=30)

WITHIN: dict[str, Shot] = {
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

BEYOND: dict[str, Shot] = {
    "4 pixels a row": Shot(row=4),
    "perspective .5": Shot(perspective=0.5),
    "curl 25 %": Shot(curl=0.25, towards=90, perspective=0.15),
    "blur .25": Shot(blur=0.25),
    "noise 60": Shot(noise=60),
}


class Count(NamedTuple):
    """Of the frames of some pictures: how they were read."""

    frames: int = 0
    doubtful: int = 0
    marked: int = 0
    silent: int = 0
    lost: int = 0
    refused: int = 0
    why: tuple[str, ...] = ()

    def plus(self, other: "Count") -> "Count":
        """Return the count of both."""
        return Count._make(one + two for one, two in zip(self, other, strict=True))  # type: ignore[operator]


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


def count(tape: bytes, picture: bytes) -> Count:
    """Read a picture of a tape, and count its frames."""
    try:
        found = photograph.read(picture)
    except TapeError as error:
        return Count(len(tape), refused=len(tape), why=(str(error),))
    doubtful = marked = silent = lost = 0
    for right, number in _aligned(tape, bytes(frame.holes for frame in found)):
        if number is None:
            lost += 1
        elif right is None:
            silent += not found[number].doubtful
            marked += found[number].doubtful
        else:
            doubtful += found[number].doubtful
            marked += found[number].doubtful and found[number].holes != right
            silent += not found[number].doubtful and found[number].holes != right
    return Count(len(tape), doubtful, marked, silent, lost)


def _aligned(tape: bytes, found: bytes) -> Iterator[tuple[int | None, int | None]]:
    """Lay what was found beside the tape with the fewest frames changed, lost or invented."""
    cost = [list(range(len(found) + 1))]
    for at, right in enumerate(tape):
        row = [at + 1]
        for number, seen in enumerate(found):
            row.append(min(cost[-1][number] + (seen != right), cost[-1][number + 1] + 1, row[-1] + 1))
        cost.append(row)
    at, number = len(tape), len(found)
    while at or number:
        if (
            at
            and number
            and cost[at][number] == cost[at - 1][number - 1] + (tape[at - 1] != found[number - 1])
        ):
            at, number = at - 1, number - 1
            yield tape[at], number
        elif at and cost[at][number] == cost[at - 1][number] + 1:
            at -= 1
            yield tape[at], None
        else:
            number -= 1
            yield None, number


def main(pictures: int, only: str = "") -> None:
    """Print the table, a row a kind of picture."""
    print("| picture | frames | doubtful | wrong and marked | wrong in silence | lost | refused |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    total = Count()
    for kind, shot in {**WITHIN, **BEYOND}.items():
        if only not in kind:
            continue
        found = Count()
        for seed in range(201, 201 + pictures):
            tape = some_tape(seed)
            found = found.plus(count(tape, camera.photograph(tape, varied(shot, seed))))
        print(
            "|", kind, "|", " | ".join(f"{number:,}" for number in found[:-1]), "|", *sorted(set(found.why))
        )
        total = total.plus(found)
    print("| all |", " | ".join(f"{number:,}" for number in total[:-1]), "|")
    for name, scene in scenes.SCENES.items():
        if only in name:
            try:
                print(f"| {name} | {len(photograph.read(camera.develop(scene(), Shot())))} frames |")
            except TapeError as error:
                print(f"| {name} | refused: {error} |")


if __name__ == "__main__":
    main(int(sys.argv[1]) if sys.argv[1:] else 4, *sys.argv[2:3])
