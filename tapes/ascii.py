r"""ASCII as a Teletype punches it: a line of text ends with CR, LF and fill.

    "A\n"   ->   301 215 212 377 377 377 377 377 377      (mark parity, 6 RUBOUTs of fill)

The fill gives the carriage time to return, and on the 1971 tapes it is what gives the punch of the
translation its slack: 19 characters, CR, LF and 6 RUBOUTs make 27 frames a line, which fits the thesis's
times.

Not emulated: the ASR-33's want of lower case; a character of a text is punched as it is typed.

Sources: ANSI X3.4-1968; the thesis's own codes (0260-0271, 0215, 0240: channel 8 always punched) and times,
chapters 5 and 6; CR LF RUBOUT as the end of a line, GE-600 time-sharing system.
"""

from collections.abc import Collection
from typing import Final

from tapes import frames as strip
from tapes.code import MOSTLY, Characters, Row, Rule, lengths, nearly_all, unended
from tapes.errors import TapeError, TextError

CR, LF, RUBOUT = 0o015, 0o012, 0o177

WRITING = bytes(
    frame for frame in range(256) if 0o007 <= frame & 0o177 <= 0o015 or 0o040 <= frame & 0o177 <= 0o177
)
"""BELL to CR and all that prints, with and without channel 8."""

_FIGURES = bytes(code | channel_8 for code in b"0123456789 \r\n\0\x7f" for channel_8 in (0, 0o200))
_NO_CHARACTERS = bytes([strip.BLANK, strip.LEADER, strip.RUBOUT])
_MOST_WRONG = 0.1
_MANY = 20
_SILENT = bytes([0o000, 0o200, 0o177, 0o377])  # blank, leader and RUBOUT, with and without channel 8

_NAMES = {
    0o000: "blank", 0o001: "SOH", 0o002: "STX", 0o003: "ETX", 0o004: "EOT", 0o005: "WRU", 0o006: "ACK",
    0o007: "BELL", 0o010: "BS", 0o011: "TAB", 0o012: "LF", 0o013: "VT", 0o014: "FF", 0o015: "CR",
    0o016: "SO", 0o017: "SI",
    0o020: "DLE", 0o021: "X-ON", 0o022: "TAPE", 0o023: "X-OFF", 0o024: "TAPE OFF", 0o025: "NAK", 0o026: "SYN",
    0o027: "ETB", 0o030: "CAN", 0o031: "EM", 0o032: "SUB", 0o033: "ESC", 0o034: "FS", 0o035: "GS",
    0o036: "RS", 0o037: "US", 0o040: "space", 0o177: "RUBOUT",
}  # fmt: skip


def encode(text: str, parity: str = "mark", fill: int = 6) -> bytes:
    r"""Punch `text`; each "\n" becomes CR LF and `fill` RUBOUTs, every other character its own code.

    `parity` is one of "mark", "even", "odd", "none". Raises TextError for a character that is not ASCII,
    naming its line and column, and TapeError for a `parity` or `fill` that cannot be.
    """
    if fill < 0:
        raise TapeError(f"{fill} RUBOUTs of fill: cannot be less than 0")
    if not text.isascii():
        index = next(at for at, character in enumerate(text) if not character.isascii())
        raise TextError(f"{text[index]!r} is no ASCII character", text, index)
    line_end = "\r\n" + chr(RUBOUT) * fill
    return strip.with_parity(text.replace("\n", line_end).encode(), parity)


def decode(frames: bytes) -> str:
    r"""Return what the tape says, its lines ended by "\n" whether it has CR LF, CR or LF.

    Channel 8 is not looked at; blank frames, leader and RUBOUTs say nothing. Any tape has a reading.
    """
    codes = frames.translate(strip.PARITIES["none"], _SILENT)
    return codes.decode().replace("\r\n", "\n").replace("\r", "\n")


def name(frame: int) -> str:
    """Return the character as a picture shows it: itself, or the name of its function."""
    if frame == strip.LEADER:
        return "leader"
    code = frame & 0o177
    return _NAMES.get(code, chr(code))


def ends_blocks(frames: bytes) -> bool:
    """Whether a tape with line feeds has carriage returns, which end a block."""
    codes = frames.translate(strip.PARITIES["none"])
    return b"\n" not in codes or b"\r" in codes


def only_figures(frames: bytes) -> bool:
    """Whether a tape holds nothing but figures and line ends: data, and no program's source."""
    return not frames.translate(None, _FIGURES)


class _Ascii(Characters):
    def encode(self, text: str, parity: str = "mark", fill: int = 6) -> bytes:
        return encode(text, parity, fill)

    def decode(self, frames: bytes) -> str:
        return decode(frames)

    def caption(self, frame: int) -> str:
        return name(frame)

    def likelihood(self, frames: bytes) -> float:
        """Return MOSTLY if nine in ten frames are characters that a text has."""
        _, content, _ = strip.strip(frames)
        if not strip.begins_as_words(frames, content):
            content = content.translate(None, _NO_CHARACTERS)
        return MOSTLY if nearly_all(content, WRITING) else 0.0

    def report(self, frames: bytes) -> list[Row]:
        """Return parity, lines and line ends."""
        codes = frames.translate(strip.PARITIES["none"])
        returns, feeds = codes.count(CR), codes.count(LF)
        lines = decode(frames).split("\n")
        rest = lines.pop()
        held = f"{len(lines):,}{lengths(map(len, lines), 'characters')}{unended(rest, 'characters')}"
        rows = [("parity", strip.parity(frames)), ("lines", held)]
        if returns or feeds:
            ends = f"{returns:,} CR, {feeds:,} LF, {codes.count(RUBOUT):,} RUBOUT"
            rows.append(("line ends", ends))
        if feeds and not returns:
            said = "LF without CR: no Teletype would return its carriage; `pdp8 tape punch` punches CR LF"
            rows.append(("warning", said))
        return rows

    def rule(self, frames: bytes, doubtful: Collection[int] = ()) -> Rule | None:
        """Return the parity that nine in ten of the characters obey, all of them if they are few."""
        sure = bytes(frame for at, frame in enumerate(frames) if at not in doubtful)
        parity = _obeyed(sure)
        if parity not in strip.PARITIES:
            return None
        table = strip.PARITIES[parity]
        obeys = bytes(frame for frame in range(256) if table[frame] == frame or frame in _NO_CHARACTERS)
        return Rule(f"the tape's parity, {parity}", lambda _, frame: frame in obeys)

    def sense(self, frames: bytes) -> float:
        """Return how many lines end with CR LF."""
        return frames.translate(strip.PARITIES["none"]).count(b"\r\n")

    def doubt(self, frames: bytes) -> str:
        """Return that no block will end, where lines end with LF."""
        if ends_blocks(frames):
            return ""
        return (
            "has line feeds but no carriage returns: no block will end. "
            "A proper tape is made from text with: pdp8 tape punch FILE -o FILE.asc"
        )


def _obeyed(frames: bytes) -> str:
    characters = bytes(frame for frame in frames if frame not in _NO_CHARACTERS)
    wrong = int(_MOST_WRONG * len(characters)) if len(characters) >= _MANY else 0
    best = "mixed"
    for name, table in strip.PARITIES.items():
        punched = characters.translate(table)
        breaking = sum(frame != punched[at] for at, frame in enumerate(characters))
        if breaking < wrong or (breaking == wrong and best == "mixed"):
            best, wrong = name, breaking
    return best if characters else "none"


ASCII: Final = _Ascii("ascii", "ASCII", "an ASCII tape", "#f1dfae")
