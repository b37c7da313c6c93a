r"""EIA RS-244, the code of numerically controlled machines and of the Flexowriters that punched for them.

    channel   8    7  6    5       4  .  3  2  1
              EOB  zone    parity  8     4  2  1      BCD digit; zones 7+6 A-I, 7 J-R, 6 S-Z; 0 is channel 6

Channel 5 makes the number of holes odd. Channel 8 belongs to the carriage return alone, the end of a block
(EOB), and is "\n" here. A tape has one code a letter; a Flexowriter shifts its case by UC and LC, here
"\x0e" and "\x0f".

Not emulated: parity in the reading head of the Hydra-Point, which masks channels 5, 6 and 7 (see nc/).

Sources: EIA RS-244; letters, digits, `+ - / . ,` and space derived from the rule above and equal to the IBM
1620 8-channel table; the digits and EOB as the thesis's Appendix B stores them. TAB, the stop code, UC and LC
are as N/C manuals give them and were not seen in the standard itself.
"""

from collections.abc import Collection
from itertools import pairwise
from typing import Final

from tapes.code import MOSTLY, WHOLE, Characters, Row, Rule, lined, lines_of, nearly_all
from tapes.errors import TapeError, TextError
from tapes.frames import BLANK, FILL, LEAST_LEADER, channels, paper_end, skip

EOB = 0o200
DELETE = 0o177
STOP, UPPER_CASE, LOWER_CASE = "%", "\x0e", "\x0f"

CODES = {
    "0": 0o040, "1": 0o001, "2": 0o002, "3": 0o023, "4": 0o004,
    "5": 0o025, "6": 0o026, "7": 0o007, "8": 0o010, "9": 0o031,
    "A": 0o141, "B": 0o142, "C": 0o163, "D": 0o144, "E": 0o165,
    "F": 0o166, "G": 0o147, "H": 0o150, "I": 0o171,
    "J": 0o121, "K": 0o122, "L": 0o103, "M": 0o124, "N": 0o105,
    "O": 0o106, "P": 0o127, "Q": 0o130, "R": 0o111,
    "S": 0o062, "T": 0o043, "U": 0o064, "V": 0o045, "W": 0o046,
    "X": 0o067, "Y": 0o070, "Z": 0o051,
    " ": 0o020, "/": 0o061, ".": 0o153, ",": 0o073, "+": 0o160, "-": 0o100,
    "&": 0o016, "(": 0o032, ")": 0o112, "\n": EOB, "\t": 0o076, "\b": 0o052,
    STOP: 0o013, UPPER_CASE: 0o174, LOWER_CASE: 0o172,
}  # fmt: skip

CHARACTERS = {code: character for character, code in CODES.items()}

_NAMES = {
    BLANK: "blank", EOB: "EOB", DELETE: "DEL", 0o020: "space", 0o076: "TAB", 0o052: "BS", 0o013: "stop",
    0o174: "UC", 0o172: "LC",
}  # fmt: skip

_FITTING = bytes([*CHARACTERS, DELETE])
_WITHOUT_ZERO = bytes([BLANK, DELETE, EOB, *(CODES[digit] for digit in "123456789")])
_NO_CODE = 0o377  # even, so never an EIA code; the mark of one that is none in both tables
_NOT_OF_A_BLOCK = bytes(code for code in range(256) if CHARACTERS.get(code, "") not in tuple("0123456789\n"))
_TO_FRAME = bytes(CODES.get(chr(code).upper(), _NO_CODE) for code in range(256))
_TO_CHARACTER = bytes(
    code if code in (BLANK, DELETE) else ord(CHARACTERS[code]) if code in CHARACTERS else _NO_CODE
    for code in range(256)
)


def encode(text: str) -> bytes:
    r"""Punch `text` in capitals, "\n" as EOB. Raises TextError."""
    frames = text.encode("ascii", "replace").translate(_TO_FRAME)
    index = frames.find(_NO_CODE)  # "replace" makes "?" of what is not ASCII, and that has no code either
    if index != -1:
        raise TextError(f"{text[index]!r} has no EIA code", text, index)
    return frames


def decode(frames: bytes) -> str:
    r"""Return the text, EOB as "\n". Raises TapeError at the first bad frame; blank ones inside are bad."""
    start = skip(frames, 0, BLANK)
    characters = frames[start : paper_end(frames)].translate(_TO_CHARACTER)
    for at, code in enumerate(characters, start):
        if code in (_NO_CODE, BLANK):
            raise TapeError(_complaint(frames[at]) if code else "blank frame inside the data", at)
    return characters.translate(None, bytes([DELETE])).decode("ascii")


def clean(frames: bytes) -> bytes:
    """Return only digits, EOBs and the blanks before them (Chapter 5). Raises TapeError if none is left."""
    start = skip(frames, 0, BLANK)
    cleaned = frames.translate(None, _NOT_OF_A_BLOCK)
    if start < len(frames) and not cleaned:
        raise TapeError("nothing is left of this tape: it has no digit and no end of block in EIA code")
    return frames[:start] + cleaned


def name(frame: int) -> str:
    """Return the character as a picture shows it: itself, the name of its function, or "?" for none."""
    return _NAMES.get(frame) or CHARACTERS.get(frame, "?")


def _complaint(frame: int) -> str:
    holes = " ".join(map(str, channels(frame)))
    fault = "an even number of holes" if frame.bit_count() % 2 == 0 else "not assigned"
    return f"{frame:03o} (channels {holes}) is no EIA code: {fault}"


class _Eia(Characters):
    def encode(self, text: str, parity: str = "mark", fill: int = 6) -> bytes:
        return encode(text)

    def decode(self, frames: bytes) -> str:
        return decode(frames)

    def caption(self, frame: int) -> str:
        return name(frame)

    def likelihood(self, frames: bytes) -> float:
        """Return almost WHOLE if every frame has a code and blocks end."""
        has_blocks = EOB in frames.lstrip(bytes([EOB])) and not frames.startswith(LEAST_LEADER)
        if has_blocks and not frames.translate(None, _FITTING + bytes([BLANK])):
            return 0.9 * WHOLE
        return MOSTLY if nearly_all(frames.translate(None, FILL), _FITTING) else 0.0

    def report(self, frames: bytes) -> list[Row]:
        codes = frames.strip(bytes([BLANK]))
        ends = [at for at, code in enumerate(codes, 1) if code == EOB]
        counts = [end - begin for begin, end in pairwise([0, *ends, len(codes)])]
        every = not codes.translate(None, _FITTING)
        odd = "odd in every frame; every frame an EIA code" if every else "odd, but not in every frame"
        return [("blocks", lined(counts, "frames")), ("parity", odd)]

    def gaps(self, frames: bytes) -> tuple[range, ...]:
        """Return the runs of blank tape between characters; none on a tape whose zeros are blank."""
        if not frames.translate(None, _WITHOUT_ZERO):
            return ()
        found: list[range] = []
        labels = self.labels(frames)
        at = skip(frames, labels[-1].stop if labels else 0, BLANK)
        end = paper_end(frames)
        while (start := frames.find(BLANK, at, end)) != -1:
            at = skip(frames, start, BLANK)
            found.append(range(start, at))
        return tuple(found)

    def lines(self, frames: bytes) -> list[tuple[int, str]]:
        text = frames[: paper_end(frames)].translate(_TO_CHARACTER)
        return lines_of(text.decode("latin-1"), skip(frames, 0, BLANK), chr(DELETE))

    def fitting(self, frames: bytes) -> bytes:
        return _FITTING

    def rule(self, frames: bytes, doubtful: Collection[int] = ()) -> Rule | None:
        """Return the rule that each frame has a code, all of which have an odd number of holes."""
        return Rule(
            "EIA's code, of odd holes", lambda _, frame: frame in CHARACTERS or frame in (BLANK, DELETE)
        )

    def sense(self, frames: bytes) -> float:
        """Return how many blocks have a slightly higher number than the one before."""
        lines = "".join(CHARACTERS.get(frame, "0" * (frame == BLANK)) for frame in frames).split("\n")
        starts = [line.removeprefix("N")[:3] for line in lines]
        numbers = [int(start) for start in starts if start.isdecimal()]
        return sum(0 < after - before <= 10 for before, after in pairwise(numbers))

    def doubt(self, frames: bytes) -> str:
        return "is an EIA tape: a program for ASCII finds no character on it"


EIA: Final = _Eia("eia", "EIA RS-244", "an EIA tape", "#ebe6d4", leader=BLANK)
