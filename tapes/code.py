"""What is known of a tape code, in one object; `codes.CODES` lists them."""

from collections.abc import Callable, Collection
from typing import Final, NamedTuple

from tapes.frames import BLANK, CHANNEL_8, LABEL_GAP, skip
from tapes.hydrapoint import DIGITS
from tapes.quantities import counted

Row = tuple[str, str]
"""A name and a value, as `pdp8 tape info` prints them."""

WHOLE: Final = 1.0
LABELLED: Final = 0.8
LED: Final = 0.6
MOSTLY: Final = 0.4
PERHAPS: Final = 0.2
"""How likely a tape is in a code, from the top: every frame fits, and so does what only this code has; the
same, but after a label; the tape begins with the code's own leader; nine frames in ten fit; the first frames
fit. 0.0: it is in another code.
"""

MOST_WRONG: Final = 0.1
"""A rule that a larger part of the frames breaks is none."""

_LONGEST_TITLE: Final = 2000
_LETTER: Final = 8
"""Frames of a letter of a title, at most; one may fit the code."""


class Rule(NamedTuple):
    """The rule that each frame of a tape obeys by itself: its name, and the test `obeyed(number, frame)`."""

    name: str
    obeyed: Callable[[int, int], bool]


class Code:
    """A tape code. An object of this class itself is a code in which no frame has a meaning.

    name      as the options --code and --to take it
    title     as `pdp8 tape info` calls it
    article   as messages speak of such a tape
    paper     the colour of its paper on the page
    leader    the frame of which leader and trailer consist
    line_end  the character that ends a line, without channel 8 if that is parity
    """

    def __init__(
        self,
        name: str,
        title: str,
        article: str,
        paper: str = "#dde3d3",
        leader: int = 0o200,
        line_end: int = 0o200,
    ) -> None:
        self.name = name
        self.title = title
        self.article = article
        self.paper = paper
        self.leader = leader
        self.line_end = line_end

    def likelihood(self, frames: bytes) -> float:
        """Return how likely a tape is in this code, from 0.0 to WHOLE."""
        return 0.0

    def caption(self, frame: int) -> str:
        """Return what a frame says by itself, in a few letters."""
        return f"{frame:03o}"

    def captions(self, frames: bytes) -> list[str]:
        """Return a caption for each frame of a tape, whatever its damage."""
        return [""] * len(frames)

    def labels(self, frames: bytes) -> tuple[range, ...]:
        """Return the frames of letters punched for the eye."""
        return ()

    def report(self, frames: bytes) -> list[Row]:
        """Return what `pdp8 tape info` says of a tape in this code beside its length."""
        return []

    def gaps(self, frames: bytes) -> tuple[range, ...]:
        """Return runs of blank tape inside the data, if they are no data."""
        return ()

    def uneven(self, frames: bytes) -> list[tuple[int, str]]:
        """Return the first frame of each block that is not as long as nearly all others, and what it is."""
        return []

    def rule(self, frames: bytes, doubtful: Collection[int] = ()) -> Rule | None:
        """Return the rule of its frames, `doubtful` ones apart; None if frames cannot show faults."""
        return None

    def sums_up(self, frames: bytes) -> bool | None:
        """Whether the checksum of a tape is right; None in a code that has none."""
        return None

    def sense(self, frames: bytes) -> float:
        """Return how much sense the order of a tape makes, 0.0 if unknown."""
        return 0.0

    def doubt(self, frames: bytes) -> str:
        """Return why a program that reads ASCII may fail with this tape, or ""."""
        return ""


class Characters(Code):
    """A code of characters. A subclass says how they are punched and read."""

    def encode(self, text: str, parity: str = "mark", fill: int = 6) -> bytes:
        """Punch a text; `parity` and `fill` are those of ASCII. Raises TextError with line and column."""
        raise NotImplementedError

    def decode(self, frames: bytes) -> str:
        r"""Return what the tape says, its lines ended by "\n". Raises TapeError with the frame."""
        raise NotImplementedError

    def captions(self, frames: bytes) -> list[str]:
        """Return each frame's character or function name; title frames are marked."""
        passed = {at for label in self.labels(frames) for at in label}
        return ["label" if at in passed else self.caption(frame) for at, frame in enumerate(frames)]

    def fitting(self, frames: bytes) -> bytes:
        """Return the frames that its characters may be: by default those with a caption other than "?"."""
        return bytes(frame for frame in range(0o400) if self.caption(frame) != "?")

    def labels(self, frames: bytes) -> tuple[range, ...]:
        """Return the frames of a title before the text: letters for the eye, then blank tape."""
        first = skip(frames, 0, BLANK)
        title = range(0)
        end = frames.find(LABEL_GAP, first, _LONGEST_TITLE)
        while end != -1:
            start = skip(frames, end, BLANK)
            if start == len(frames):
                break
            piece = frames[max(first, title.stop) : end].strip(LABEL_GAP)
            if self.has_lines(frames[start:]) and self.likelihood(frames[start:]) >= 0.9 * MOSTLY:
                odd = piece.translate(None, LABEL_GAP[:1]).translate(None, self.fitting(frames[start:]))
                written = self.has_lines(piece) and len(odd) < len(piece) / 10
                if written or not (odd or BLANK in piece or (title and len(piece) <= _LETTER)):
                    break
                title = range(first, end)
            end = frames.find(LABEL_GAP, start, _LONGEST_TITLE)
        return (title,) if title else ()

    def titled(self, frames: bytes, what: str) -> str:
        """Say that a title comes before the `what` of a tape, and how to leave it out; "" if none does."""
        for label in self.labels(frames):
            cure = f"`pdp8 tape cut --from {label.stop}` leaves it out"
            title = f"a title of {counted(len(label), 'frames')} before the {what}"
            return f"frame {label.start}: {title}; {cure}"
        return ""

    def lines(self, frames: bytes) -> list[tuple[int, str]]:
        """Return the first frame of each line or block, and its characters in ASCII without fill."""
        return []

    def uneven(self, frames: bytes) -> list[tuple[int, str]]:
        """Return the blocks of digits that have not 19, on a tape of which nine in ten have."""
        found: list[tuple[int, str]] = []
        blocks = 0
        for at, line in self.lines(frames):
            if len(line) == DIGITS:
                blocks += 1
            elif blocks and not line:
                found.append((at, "an end of block without a block"))
            elif not line.strip("0123456789 ") and line:
                found.append((at, f"a block of {counted(len(line), 'digits')}; nearly all have {DIGITS}"))
        return found if blocks >= 9 * len(found) else []

    def has_lines(self, frames: bytes) -> bool:
        """Whether some line ends."""
        return self.line_end in frames or self.line_end | CHANNEL_8 in frames


def lines_of(text: str, at: int, fill: str) -> list[tuple[int, str]]:
    """Return the lines of a tape's characters from frame `at` on: where each begins, and what it says."""
    lines: list[tuple[int, str]] = []
    for piece in text[at:].split("\n"):
        begun = piece.lstrip(fill)
        lines.append((at + len(piece) - len(begun), "".join([each for each in begun if each not in fill])))
        at += len(piece) + 1
    return lines if lines[-1][1] else lines[:-1]


def nearly_all(frames: bytes, of: bytes) -> bool:
    """Whether at least nine in ten of the frames are one of `of`."""
    return not frames or 1 - len(frames.translate(None, of)) / len(frames) >= 0.9


def lined(counts: list[int], unit: str) -> str:
    """Say how many lines or blocks are on a tape, of which lengths, and the last of `counts`, which no end
    follows: "2 of 19 frames, then 3 frames without an end".
    """
    ended, rest = counts[:-1], counts[-1]
    said = f"{len(ended):,}"
    if ended:
        least, most = min(ended), max(ended)
        said += f" of {counted(least, unit)}" if least == most else f" of {least} to {most} {unit}"
    return said + f", then {counted(rest, unit)} without an end" * (rest > 0)
