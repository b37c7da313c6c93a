r"""ASCII as a Teletype punches it: a line of text ends with CR, LF and fill.

    "A\n"   ->   301 215 212 377 377 377 377 377 377      (mark parity, 6 RUBOUTs of fill)

The fill gives the carriage time to return, and on the 1971 tapes it is what gives the punch of the
translation its slack: 19 characters, CR, LF and 6 RUBOUTs make 27 frames a line, which fits the thesis's
times.

Not emulated: the ASR-33's want of lower case; a character of a text is punched as it is typed.

Sources: ANSI X3.4-1968; the thesis's own codes (0260-0271, 0215, 0240: channel 8 always punched) and times,
chapters 5 and 6; CR LF RUBOUT as the end of a line, GE-600 time-sharing system.
"""

from tapes import frames as strip
from tapes.errors import TapeError, TextError

CR, LF, RUBOUT = 0o015, 0o012, 0o177

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
