"""What the Teletype types in each pass, frame for frame.

    pass 1    000, messages, the symbol table
    pass 2    000, leader, the object tape with the messages among its frames, between RUBOUTs
    pass 3    000, leader, the listing with the messages among its lines, the symbol table

    CR LF 0201  6032  <source>               a word: location, contents, the line as typed
    CR LF             <source>               a line without one: twelve blanks
    CR LF 0202  7200                         a statement ended by a semicolon
    RUBOUT CR LF IR  0400  AT  0201 RUBOUT   a message
    CR LF, leader, RUBOUT,                   the symbol table: before each symbol, or the UA message in its
      CR LF symbol, ..., CR LF,              place, CR LF; in pass 3 one that is not defined is an empty line
      EOT, CR LF, RUBOUT, trailer

A TAB is followed by a RUBOUT, the time it takes; six blank frames come before and after a form feed.

Source: the frames of DEC-08-ASB1.
"""

from collections.abc import Iterable, Iterator
from functools import cache
from typing import NamedTuple

from pal import punch
from pal.assembler import Entry, Listed, Message, Output, Punched, Written
from pal.source import Source
from pal.symbols import typed
from tapes import frames

EOT = "\x04"
RUBOUT = "\x7f"
NEW_LINE = "\r\n"
LONGEST = 222  # characters of a line that pass 3 takes

UNNUMBERED = " " * 12
_FORM_FEED = "\0" * 6 + "\f" + "\0" * 6
_MARKED = bytes([0, *frames.PARITIES["mark"][1:]])
_SILENT = bytes((0, 0o200, 0o204, 0o215, 0o377))


class ListingLine(NamedTuple):
    """A statement of the listing; `source` is the whole line at its last statement, "" at earlier ones."""

    address: int | None
    word: int | None
    source: str
    tape: int
    number: int


class Teletype(NamedTuple):
    """The raw frames of an ASR-33's punch in the three passes."""

    pass1: bytes
    pass2: bytes
    pass3: bytes


@cache
def octal(number: int) -> str:
    """Return a word or an address as it is typed."""
    return f"{number:04o}"


def text_of(raw: bytes) -> str:
    r"""Return the text of typed frames: without codes that do not print, CR LF as ``\n``."""
    return raw.translate(frames.PARITIES["none"], _SILENT).decode("ascii")


def typed_frames(text: str) -> bytes:
    r"""Return the frames of a text, CR LF for ``\n``."""
    return _frames(text.replace("\n", NEW_LINE).encode("ascii", "replace").decode("ascii"))


def complaints(output: Output) -> bytes:
    """Return the messages that pass 1 types, and pass 2 while the high-speed punch is used."""
    return _frames("".join(_message(str(piece)) for piece in output if isinstance(piece, Message)))


def object_tape(output: Output, finished: bool) -> bytes:
    """Return the tape of pass 2 as the ASR-33 punches it, messages and all."""
    body = b"".join(
        punch.frames_of(piece) if isinstance(piece, (Written, Punched)) else _frames(_message(str(piece)))
        for piece in output
    )
    return punch.START_UP + frames.leader() + body + (frames.leader() if finished else b"")


def listing(
    source: Source, output: Output, lost: Iterable[tuple[int, int]], again: Iterable[tuple[int, int, str]]
) -> bytes:
    """Return what pass 3 types before its symbol table; `lost` and `again` are the assembler's."""
    texts = _texts(source, output, lost, again)
    pieces = [
        _statement(piece, next(texts)) if isinstance(piece, Listed) else _message(str(piece))
        for piece in output
    ]
    typed_text = "".join(pieces).replace("\t", "\t" + RUBOUT).replace("\f", _FORM_FEED)
    return punch.START_UP + frames.leader() + _frames(typed_text)


def lines(source: Source, output: Output, lost: Iterable[tuple[int, int]]) -> Iterator[ListingLine]:
    """Yield the listing by statements."""
    texts = _texts(source, output, lost)
    for piece in output:
        if isinstance(piece, Listed):
            place = source.place(piece.at)
            address = None if piece.word is None else piece.location
            yield ListingLine(address, piece.word, next(texts), place.tape, place.line)


def symbol_table(table: Iterable[Entry], number: int) -> bytes:
    """Return the symbol table that ends pass 1 or 3."""
    typed_lines = "".join(NEW_LINE + _symbol(entry, number) for entry in table)
    return (
        _frames(NEW_LINE)
        + frames.leader()
        + _frames(RUBOUT + typed_lines + NEW_LINE + EOT + NEW_LINE + RUBOUT)
        + frames.leader()
    )


def _frames(text: str) -> bytes:
    return text.encode("latin-1").translate(_MARKED)


def _texts(
    source: Source,
    output: Output,
    lost: Iterable[tuple[int, int]],
    again: Iterable[tuple[int, int, str]] = (),
) -> Iterator[str]:
    """Yield the text of each statement: that of its line where CR ends it, else none."""
    spans = source.spans if lost or again else []
    changes = [(spans[first - 1][1] + 1, spans[after - 1][1], "") for first, after in lost]
    for at, number, character in again:
        place = spans[at][0] + number + 1
        changes.append((place, place, character))
    text = source.text
    for start, end, typed_besides in sorted(changes, reverse=True):
        text = text[:start] + typed_besides + text[end:]
    texts = text.split("\r")
    items = source.items
    ends = source.line_ends
    line = 0
    for piece in output:
        if not isinstance(piece, Listed):
            continue
        if items[piece.at][1] != "\r":
            yield ""
        elif ends[line] == piece.at:
            yield texts[line]
            line += 1
        else:
            begun = line
            line = ends.index(piece.at, begun) + 1
            yield "".join(texts[begun:line])


def _statement(listed: Listed, text: str) -> str:
    if listed.word is None:
        return NEW_LINE + UNNUMBERED + text
    return f"{NEW_LINE}{octal(listed.location & 0o7777)}  {octal(listed.word)}  {text}"


def _message(text: str) -> str:
    return RUBOUT + NEW_LINE + text + RUBOUT


def _symbol(entry: Entry, number: int) -> str:
    if entry.defined:
        return f"{typed(entry.name)}  {entry.value:04o}"
    return _message(f"UA  {typed(entry.name)}  AT  {entry.value:04o}") if number == 1 else ""
