r"""The scanner: frames of source tapes to lines, statements and tokens.

    ``A,<TAB>TAD I B+1;<TAB>HLT  /COMMENT<CR>``
      A  ,  TAB  TAD  sp  I  sp  B  +  1   |   TAB  HLT  sp  sp

Characters. PAL III knows A-Z, 0-9, space, TAB, CR and ``+ - , = * ; $ . /``, and passes over blank frames,
leader (0200), line feed, form feed and RUBOUT. All others are illegal, lower case included: the Teletype
has none. Channel 8 is set on every frame of a tape of DEC's and not in a file of a text editor; here it
does not matter. A line feed without channel 8 is the end of a line in a text file, so it counts as CR, LF,
unless a CR came just before; one with channel 8 (0212) comes off a Teletype and is passed over as PAL III
does.

Illegal characters. What DEC-08-ASB1 does with ``A!B`` (A), ``"A`` (A), ``(5)`` (0) and ``1A,`` (the tag is
A of the line before, and the message says IC 0001, the internal code of A) has one explanation: the
character is reported and passed over, and scanning goes on where it was, but the report has cleared the one
temporary that both scanning loops use: the symbol's count of characters still to come, and the number so
far. So the rest of a symbol is lost, and a number starts again from zero; in a number letters are illegal
too. (Inferred from these outputs.)

Not emulated: a limit to the length of a line.

Sources: DEC-08-ASAC-D, sections on characters and symbols; the output of DEC-08-ASB1.
"""

import re
from collections.abc import Iterator
from contextlib import suppress
from typing import NamedTuple

from pal.symbols import SIGNIFICANT
from tapes.frames import PARITIES

# Blank, leader, RUBOUT, form feed with and without channel 8, line feed with it.
IGNORED = bytes((0o000, 0o200, 0o177, 0o377, 0o014, 0o214, 0o212))

SPACE = " "
BLANKS = " \t"
TERMINATORS = BLANKS + "+-,=*."
_TOKEN = re.compile(r"(?:([A-Z][A-Z0-9]*)|([0-9]+))([^ \t+\-,=*.]*)|(.)", re.DOTALL)
_NOT_IN_NUMBER = r"[^0-9]"  # compiled only when there is an illegal character
_NOT_IN_SYMBOL = r"[^A-Z0-9]"


class Token(NamedTuple):
    """A piece of a statement: exactly one of `symbol`, `number` and `mark` is not empty.

    symbol   its significant characters
    number   its digits, those after the last illegal character; "" with `mark` "" too: none, which is zero
    illegal  codes of the illegal characters in it, as the IC message prints them
    mark     one character: an operator, a terminator, or an illegal one
    """

    symbol: str
    number: str
    illegal: tuple[int, ...]
    mark: str


class Line(NamedTuple):
    """A line of source as PAL III sees it: `statements` are the texts between semicolons.

    `complete` is false for the line that `$` ends: its last statement is scanned but never finished.
    """

    tape: int
    number: int
    text: str
    statements: list[str]
    complete: bool


def characters(tape: bytes) -> str:
    r"""Return the characters of a source tape that PAL III acts upon; each line ends with ``\r``.

    A character beyond ASCII in a text (UTF-8, which no tape with channel 8 happens to be) becomes a ``?``.
    """
    if not tape.isascii():
        with suppress(UnicodeDecodeError):
            tape = tape.decode("utf-8-sig").encode("ascii", "replace")
    text = tape.translate(PARITIES["none"], IGNORED).decode("ascii")
    return text.replace("\r\n", "\r").replace("\n", "\r")


def lines(tapes: list[bytes], modern: bool = False) -> Iterator[Line]:
    """Yield the lines of the tapes in order up to `$`; a last line without CR is taken as if it had one.

    `modern` folds lower case in all but the texts of the lines.
    """
    for tape, frames in enumerate(tapes):
        texts = characters(frames).split("\r")
        if not texts[-1]:
            texts.pop()
        for number, text in enumerate(texts, 1):
            code = text.partition("/")[0]
            if modern:
                code = code.upper()
            if "$" in code:
                yield Line(tape, number, text, code.partition("$")[0].split(";"), False)
                return
            yield Line(tape, number, text, code.split(";"), True)


def tokens(statement: str) -> list[Token]:
    """Return the tokens of a statement. Spaces and TABs are left out but for one that follows a + or -."""
    return [_token(*match.groups("")) for match in _matches(statement)]


def _matches(statement: str) -> Iterator[re.Match[str]]:
    operated = False
    for match in _TOKEN.finditer(statement):
        mark = match[4]
        if not mark:
            operated = False
        elif mark in "+-":
            operated = True
        elif mark in BLANKS:
            if not operated:
                continue
            operated = False
        yield match


def _token(symbol: str, number: str, tail: str, mark: str) -> Token:
    if mark and mark in BLANKS:
        return Token("", "", (), SPACE)
    if mark:
        return Token("", "", () if mark in TERMINATORS else (ord(mark) | 0o200,), mark)
    if not tail:
        return Token(symbol[:SIGNIFICANT], number, (), "")
    if symbol:
        return Token(symbol[:SIGNIFICANT], "", _codes(_NOT_IN_SYMBOL, tail), "")
    return Token("", re.split(_NOT_IN_NUMBER, tail)[-1], _codes(_NOT_IN_NUMBER, tail), "")


def _codes(illegal: str, tail: str) -> tuple[int, ...]:
    return tuple(map(_code, re.findall(illegal, tail)))


def _code(character: str) -> int:
    """Return what an IC message prints: the internal code of a letter, the frame of anything else."""
    return ord(character) - 0o100 if "A" <= character <= "Z" else ord(character) | 0o200


def columns(line: Line, statement: int, token: int) -> tuple[int, int]:
    """Return where a token starts and ends in its line's text, from 0; a token that is not there: the end."""
    start = sum(len(text) + 1 for text in line.statements[:statement])
    spans = [match.span() for match in _matches(line.statements[statement])]
    first, after = spans[token] if token < len(spans) else (len(line.statements[statement]),) * 2
    return start + first, start + after
