"""What was read from photographs: the tape, what is doubtful on it, and a page in which it is corrected.

The page (correction.html) needs nothing but a browser. It shows each picture with the holes that were read
drawn over it, lights the doubtful frames, and gives the corrected tape and a record of what was changed.
"""

import json
from base64 import b64encode
from collections.abc import Iterable, Iterator, Sequence
from importlib.resources import files
from itertools import groupby
from typing import NamedTuple

from tapes import measure, redundancy
from tapes.errors import TapeError
from tapes.photograph import UNSEEN, Frame, Strip, pixels, stitch
from tapes.photograph.reader import LONG

_SHOWN = 5


class Picture(NamedTuple):
    """A picture's name, its file's content, and its strips in the order in which they are read."""

    name: str
    content: bytes
    strips: list[Strip]


class Reading:
    """The strips of some pictures, one after another, as one tape.

    `order` has the numbers of the strips, counted from 1 over all pictures, in the order in which they are
    read; - before those that were photographed from the other side. Without it those that cannot be read are
    left out. `stitched`: they are parts of one tape, which overlap. Raises TapeError for an order that names
    a strip twice, or one that has no frames, and for strips that cannot be joined.
    """

    def __init__(
        self, pictures: Iterable[Picture], order: Sequence[int] = (), stitched: bool = False
    ) -> None:
        self.pictures = tuple(pictures)
        seen = [(picture.name, strip) for picture in self.pictures for strip in picture.strips]
        self.strips = [(name, strip) for name, strip in seen if strip.tape]
        self.no_tape = [(name, strip) for name, strip in seen if not strip.tape]
        there = [number for number, (_, strip) in enumerate(self.strips, 1) if strip.frames]
        named = {abs(number) for number in order}
        if len(named) < len(order) or not named <= {*there}:
            said, numbers = (",".join(map(str, each)) for each in (order, there))
            raise TapeError(f"strips {said}: {numbers} can be named, each once")
        self.order = tuple(order or (at for at, (_, strip) in enumerate(self.strips, 1) if not strip.why))
        for at in (-number - 1 for number in order if number < 0):
            name, strip = self.strips[at]
            self.strips[at] = name, strip.turned()
        read = {abs(number): self.strips[abs(number) - 1][1].frames for number in self.order}
        self._stitched = stitched and len(read) > 1
        tape, self._begins = stitch.join(read) if self._stitched else stitch.one_after_another(read)
        self.seen = bytes(frame.holes for frame, _ in tape)
        doubtful = {number: frame.open for number, (frame, _) in enumerate(tape) if frame.doubtful}
        weakest = [(frame.margin, frame.weakest) for frame, _ in tape]
        wrong, by = redundancy.contradict(self.seen, doubtful, weakest)
        for number, mask in wrong.items():
            frame, of = tape[number]
            tape[number] = frame._replace(open=mask, why=f"it contradicts {by}"), of
        self.proposed, self.proposed_by = redundancy.propose(self.seen, doubtful | wrong)
        self._tape = [(number, *one) for number, one in enumerate(tape)]

    @property
    def frames(self) -> list[tuple[int, Frame, str]]:
        """Each frame with its number and picture's name, doubtful if its holes or the tape's rules say so."""
        return [(number, frame, self.strips[strip - 1][0]) for number, frame, strip in self._tape]

    @property
    def runs(self) -> list[tuple[int, list[tuple[int, Frame]]]]:
        """Return the frames in runs of one strip each: (number of the strip, [(number, frame)])."""
        runs = groupby(self._tape, key=lambda one: one[2])
        return [(strip, [(number, frame) for number, frame, _ in run]) for strip, run in runs]

    @property
    def tape(self) -> bytes:
        """Return the tape as seen, with doubtful frames as its redundancy proposes."""
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
                    f"counted by their distance, at {frame.place} in {name}"
                )
            else:
                yield from (self._doubt(*one) for one in group if one[1].doubtful)
        yield from self._of_strips()
        sure = [frame.holes for _, frame, _ in self.frames if not frame.doubtful]
        doubtful = len(self.seen) - len(sure)
        if doubtful and not any(sure):
            yield f"{len(self.seen):,} frames: {doubtful} are doubtful, the others blank"
            return
        said = measure.report(self.tape)
        yield f"{len(self.tape):,} frames: {said[0][1]}"
        yield from (f"{name}: {value}" for name, value in said[4:] if name != "doubt")
        if redundancy.looks_reversed(self.tape):
            other = "without --underside it would" if underside else "--underside would"
            yield f"read in this order it makes no sense; {other}"

    def _of_strips(self) -> Iterator[str]:
        """Say where on the tape several strips are, which are left out, and where one leaves its picture."""
        for number in map(abs, self.order):
            name, strip = self.strips[number - 1]
            first, (before, after) = self._begins[number], strip.off
            last = first + len(strip.frames) - 1
            if len(self.strips) > 1:
                (start, *_, end) = strip.frames
                yield (
                    f"frames {first} to {last}: strip {number} of {len(self.strips)}, "
                    f"from {start.place} to {end.place} in {name}"
                )
            if before and not (self._stitched and first):
                yield f"the tape may go on before frame {first}, where it leaves {name}"
            if after and not (self._stitched and last + 1 < len(self.seen)):
                yield f"the tape may go on after frame {last}, where it leaves {name}"
        for number, (name, strip) in enumerate(self.strips, 1):
            if number not in map(abs, self.order):
                why = f": {strip.why}" if strip.why else ""
                of = f"strip {number} of {len(self.strips)} in {name}{said_place(strip)}"
                yield f"{of}{',' * bool(strip.ends)} is left out{why}"
        if self.no_tape:
            shown = [f"{_place(strip)} in {name}" for name, strip in self.no_tape[:_SHOWN]]
            more = [f"{len(self.no_tape) - _SHOWN} more"] * (len(self.no_tape) > _SHOWN)
            yield f"called no tape, rows of fewer than {LONG} holes: {'; '.join([*shown, *more])}"

    def _doubt(self, number: int, frame: Frame, name: str) -> str:
        where = "" if frame.open == 0o377 else f"channel {frame.channel}, "
        place = f"{where}at {frame.place} in {name}: {frame.why}"
        if number in self.proposed:
            said = f"{self.proposed[number]:03o} by {self.proposed_by}; {frame.holes:03o} was seen"
            return f"frame {number}: {said}: {place}"
        return f"frame {number}: {frame.holes:03o} is doubtful: {place}"


def said_place(strip: Strip) -> str:
    """Where a row lies in its picture, or "" if that is not known."""
    return f", from {_place(strip)}" if strip.ends else ""


def _place(strip: Strip) -> str:
    (x, y), (to_x, to_y) = strip.ends
    return f"{x}, {y} to {to_x}, {to_y}"


def page(read: Reading) -> str:
    """Return the page on which the tape is checked and corrected."""
    pictures = [
        {
            "name": picture.name,
            "source": "data:image/jpeg;base64," + b64encode(pixels.shown(picture.content)).decode(),
        }
        for picture in read.pictures
    ]
    of_picture = [at for at, picture in enumerate(read.pictures) for strip in picture.strips if strip.tape]
    left_out = [number for number in range(1, len(read.strips) + 1) if number not in map(abs, read.order)]
    unread = [(number, [(-1, frame) for frame in read.strips[number - 1][1].frames]) for number in left_out]
    strips = [
        {
            "number": number,
            "picture": of_picture[number - 1],
            "read": number not in left_out,
            "why": read.strips[number - 1][1].why,
            "ends": () if frames else read.strips[number - 1][1].ends,
            "frames": [_shown(read, at, frame) for at, frame in frames],
        }
        for number, frames in (*read.runs, *unread)
    ]
    content = json.dumps([pictures, strips], separators=(",", ":")).replace("<", "\\u003c")
    template = files("tapes.photograph").joinpath("correction.html").read_text(encoding="utf-8")
    return template.replace("/*READ*/[[], []]", content)


def _shown(read: Reading, number: int, frame: Frame) -> dict[str, object]:
    return {
        "seen": frame.holes,
        "holes": read.proposed.get(number, frame.holes),
        "by": read.proposed_by if number in read.proposed else "",
        "why": frame.why,
        "open": frame.open,
        "places": frame.places,
    }
