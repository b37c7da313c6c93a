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
from tapes.code import MOST_WRONG, MOSTLY, Characters, Row, Rule, lined, lines_of, nearly_all
from tapes.errors import TapeError, TextError

CR, LF, RUBOUT = 0o015, 0o012, 0o177

_SPACING = bytes(code | channel_8 for code in b" \r\n\0\x7f" for channel_8 in (0, 0o200))
_FIGURES = _SPACING + bytes(code | channel_8 for code in b"0123456789" for channel_8 in (0, 0o200))
_MANY = 20
_SPLICE = 6
"""A tape is taken for two pieces of different parity only if that saves so many faults."""
_LIKELIEST = ("none", "mark", "even", "odd")
_BEYOND = bytes(range(0o200, 0o400))
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
    r"""Return the text, "\n" for CR LF, CR or LF, without the ^Z at its end; channel 8, blanks, leader and
    RUBOUTs are ignored.
    """
    codes = frames[: strip.text_end(frames)].translate(strip.PARITIES["none"], _SILENT)
    return codes.decode("ascii").replace("\r\n", "\n").replace("\r", "\n")


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
    """Whether a tape holds figures, and nothing else but line ends: data, and no program's source."""
    return not frames.translate(None, _FIGURES) and frames.translate(None, _SPACING) != b""


class _Ascii(Characters):
    def encode(self, text: str, parity: str = "mark", fill: int = 6) -> bytes:
        return encode(text, parity, fill)

    def decode(self, frames: bytes) -> str:
        return decode(frames)

    def caption(self, frame: int) -> str:
        return name(frame)

    def lines(self, frames: bytes) -> list[tuple[int, str]]:
        return lines_of(frames.translate(strip.PARITIES["none"]).decode("ascii"), 0, "\0\r\x7f")

    def likelihood(self, frames: bytes) -> float:
        """Return MOSTLY if nine in ten frames are characters that a text has, or it is a file in UTF-8."""
        _, content, _ = strip.strip(frames)
        if not strip.begins_as_words(frames, content):
            content = content.translate(None, strip.FILL)
        others = content.translate(None, _FIGURES)
        if len(content) > 8 and max(content) < 0o100 and 2 * len(others) > len(content):
            return 0.0  # text without letters is figures; this is a tape of six levels
        return MOSTLY if nearly_all(content, strip.WRITING) or utf_8(frames) else 0.0

    def report(self, frames: bytes) -> list[Row]:
        codes = frames.translate(strip.PARITIES["none"])
        returns, feeds = codes.count(CR), codes.count(LF)
        text = decode(frames)
        pages = text.count("\f")  # a form feed moves the paper, and begins no line
        held = lined([len(line) for line in text.replace("\f", "").split("\n")], "characters")
        pieces = _parities(frames, ())
        rows = [("parity", said(pieces) if pieces else "mixed"), ("lines", held)]
        if returns or feeds:
            ends = f"{returns:,} CR, {feeds:,} LF, {codes.count(RUBOUT):,} RUBOUT"
            ends += f", {pages:,} FF" * (pages > 0)
            rows.append(("line ends", ends))
        end = strip.text_end(frames)
        if end < strip.paper_end(frames):
            rows.append(("file end", f"^Z at frame {end}, with which OS/8 and CP/M end a file"))
        for strange in [char for char in utf_8(frames) if not char.isascii()][:1]:
            rows.append(("warning", f"a text in UTF-8: {strange!r} is no ASCII character"))
        if feeds and not returns:
            warning = "LF without CR: no Teletype would return its carriage; `pdp8 tape punch` punches CR LF"
            rows.append(("warning", warning))
        return rows

    def fitting(self, frames: bytes) -> bytes:
        tables = [strip.PARITIES[name] for name, _ in _parities(frames, ())] or [bytes(range(256))]
        obeying = {frame for frame in strip.WRITING if any(table[frame] == frame for table in tables)}
        return bytes(sorted({*obeying, strip.RUBOUT}))

    def rule(self, frames: bytes, doubtful: Collection[int] = ()) -> Rule | None:
        """Return the parity of nine in ten characters, or of all of a few; a spliced tape has several."""
        pieces = [] if utf_8(frames) else _parities(frames, doubtful)
        if not pieces:
            return None
        ends = [end for _, end in pieces]
        closes = strip.text_end(frames)

        def obeyed(at: int, frame: int) -> bool:
            if at >= closes:
                return True
            piece = 0
            while ends[piece] <= at:
                piece += 1
            return frame in strip.FILL or strip.PARITIES[pieces[piece][0]][frame] == frame

        return Rule(f"the tape's parity, {said(pieces)}", obeyed)

    def sense(self, frames: bytes) -> float:
        """Return how many lines end with CR LF."""
        return frames.translate(strip.PARITIES["none"]).count(b"\r\n")

    def doubt(self, frames: bytes) -> str:
        if ends_blocks(frames):
            return ""
        return (
            "has line feeds but no carriage returns: no block will end. "
            "A proper tape is made from text with: pdp8 tape punch FILE -o FILE.asc"
        )


def utf_8(frames: bytes) -> str:
    """Return the text of a file in UTF-8 with letters beyond ASCII, whose bytes no Teletype has, else ""."""
    if frames.isascii() or not nearly_all(frames.translate(None, _BEYOND), strip.WRITING):
        return ""
    try:
        return frames.decode("utf-8")
    except ValueError:  # it is not UTF-8
        return ""


def _parities(frames: bytes, doubtful: Collection[int]) -> list[tuple[str, int]]:
    """Return the parity of each piece of a tape and the frame where it ends, doubtful frames apart; [] where
    more than a tenth of the characters break it. One piece is likelier than two that save few faults.
    """
    characters = ((at, frame) for at, frame in enumerate(frames) if frame not in strip.FILL)
    sure = [(at, frame) for at, frame in characters if at not in doubtful]
    for name in _LIKELIEST:
        if all(strip.PARITIES[name][frame] == frame for frame in set(frames) - set(strip.FILL)):
            return [(name, len(frames))]
    costs = {name: 0 for name in _LIKELIEST}
    ways: dict[str, list[tuple[str, int]]] = {name: [(name, 0)] for name in _LIKELIEST}
    for at, frame in sure:
        best = _least(costs)
        spliced, before = costs[best] + _SPLICE, ways[best]
        for name in _LIKELIEST:
            if spliced < costs[name]:
                costs[name], ways[name] = spliced, [*before, (name, at)]
            costs[name] += strip.PARITIES[name][frame] != frame
    best = _least(costs)
    if not sure or costs[best] > (MOST_WRONG * len(sure) if len(sure) >= _MANY else 0):
        return []
    starts = [start for _, start in ways[best]][1:]
    return list(zip([name for name, _ in ways[best]], [*starts, len(frames)], strict=True))


def _least(costs: dict[str, int]) -> str:
    least = min(costs.values())
    return next(name for name, cost in costs.items() if cost == least)


def said(pieces: list[tuple[str, int]]) -> str:
    """Return the parities of a tape's pieces: "even", "even to frame 399, mark"."""
    return ", ".join([*(f"{name} to frame {end - 1}" for name, end in pieces[:-1]), pieces[-1][0]])


ASCII: Final = _Ascii("ascii", "ASCII", "an ASCII tape", "#f1dfae", line_end=LF)
