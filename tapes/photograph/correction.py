"""What was read from photographs: the tape, what is doubtful on it, and a page in which it is corrected.

The page (correction.html) needs nothing but a browser. It shows each picture with the holes that were read
drawn over it, lights the doubtful frames, and gives the corrected tape and a record of what was changed.
"""

import json
from base64 import b64encode
from collections.abc import Iterable, Iterator
from functools import cached_property
from importlib.resources import files
from itertools import groupby
from typing import NamedTuple

from tapes import measure, redundancy
from tapes.photograph import UNSEEN, Frame, pixels


class Picture(NamedTuple):
    """A picture's name, its file's content, and its frames."""

    name: str
    content: bytes
    frames: list[Frame]


class Reading:
    """The frames of some pictures, one after another, as one tape."""

    def __init__(self, pictures: Iterable[Picture]) -> None:
        self.pictures = tuple(pictures)
        self.seen = bytes(frame.holes for picture in self.pictures for frame in picture.frames)
        self.proposed, self.proposed_by = redundancy.propose(self.seen, self._doubtful)

    @property
    def _doubtful(self) -> dict[int, int]:
        return {number: frame.open for number, frame, _ in self.frames if frame.doubtful}

    @cached_property
    def frames(self) -> list[tuple[int, Frame, str]]:
        """Return each frame with its number on the tape and the name of its picture."""
        pairs = [(frame, picture.name) for picture in self.pictures for frame in picture.frames]
        return [(number, frame, name) for number, (frame, name) in enumerate(pairs)]

    @property
    def tape(self) -> bytes:
        """Return the tape: what was seen, but what its own redundancy proposes where that is doubtful."""
        return bytes(self.proposed.get(number, frame) for number, frame in enumerate(self.seen))

    def report(self, underside: bool) -> Iterator[str]:
        """Say what is doubtful, where a gap is, what tape it seems to be, and from which side."""
        for unseen, run in groupby(
            self.frames, key=lambda one: (one[1].doubtful and one[1].why == UNSEEN, one[2])
        ):
            group = list(run)
            if unseen[0] and len(group) > 1:
                (first, frame, name), (last, _, _) = group[0], group[-1]
                yield (
                    f"frames {first} to {last}: a gap of {len(group)} frames without a sprocket hole, "
                    f"counted by their distance, at {frame.x}, {frame.y} in {name}"
                )
            else:
                yield from (self._doubt(*one) for one in group if one[1].doubtful)
        yield f"{len(self.tape):,} frames: {dict(measure.report(self.tape))['tape']}"
        if redundancy.looks_reversed(self.tape):
            other = "without --underside it would" if underside else "--underside would"
            yield f"read in this order it makes no sense; {other}"

    def _doubt(self, number: int, frame: Frame, name: str) -> str:
        where = "" if frame.open == 0o377 else f"channel {frame.channel}, "
        place = f"{where}at {frame.x}, {frame.y} in {name}: {frame.why}"
        if number in self.proposed:
            said = f"{self.proposed[number]:03o} by {self.proposed_by}; {frame.holes:03o} was seen"
            return f"frame {number}: {said}: {place}"
        return f"frame {number}: {frame.holes:03o} is doubtful: {place}"


def page(read: Reading) -> str:
    """Return the page in which it is looked at and corrected."""
    numbers = iter(range(len(read.seen)))
    pictures = [
        {
            "name": picture.name,
            "source": "data:image/jpeg;base64," + b64encode(pixels.shown(picture.content)).decode(),
            "frames": [_shown(read, next(numbers), frame) for frame in picture.frames],
        }
        for picture in read.pictures
    ]
    content = json.dumps(pictures, separators=(",", ":")).replace("<", "\\u003c")
    template = files("tapes.photograph").joinpath("correction.html").read_text(encoding="utf-8")
    return template.replace("/*PICTURES*/[]", content)


def _shown(read: Reading, number: int, frame: Frame) -> dict[str, object]:
    return {
        "seen": frame.holes,
        "holes": read.proposed.get(number, frame.holes),
        "by": read.proposed_by if number in read.proposed else "",
        "why": frame.why,
        "open": frame.open,
        "places": frame.places,
    }
