"""What the Teletype prints in each pass.

    pass 1    messages, then the symbol table
    pass 2    messages; by the ASR-33's punch they are on the object tape itself, between RUBOUTs
    pass 3    the listing, messages among its lines, then the symbol table

    CR LF 0201  6032  <source>               a word: location, contents, the line as typed
    CR LF             <source>               a line without one: twelve blanks
    CR LF 0202  7200                         a statement ended by a semicolon
    RUBOUT CR LF IR  0400  AT  0201 RUBOUT   a message
    CR LF CR LF, symbols, CR LF              the symbol table: each symbol is followed by CR LF, as is a UA
                                             message in its place

Every line begins with its CR LF, so the first one is blank. A TAB is followed by a RUBOUT, the time it
takes. The tape of each pass begins with the start-up frame and the leader; that of a symbol table ends with
EOT (0204), CR, LF, RUBOUT and the trailer. (Leader, EOT and RUBOUTs of passes 1 and 3: from a later
edition, with this one's leader of 64 frames.)

Sources: the printed output of DEC-08-ASB1, from which the codes that do not print are removed;
DEC-08-ASAC-D.
"""

from collections.abc import Iterable
from typing import NamedTuple

from pal import punch
from pal.assembler import WORD, Entry, Message, Result
from pal.scanner import Line
from pal.symbols import internal_order
from tapes import binary, frames

EOT = "\x04"
RUBOUT = "\x7f"
NEW_LINE = "\r\n"

_SILENT = str.maketrans("", "", "\0\r" + EOT + RUBOUT)
_UNNUMBERED = " " * 12


class ListingLine(NamedTuple):
    """A statement of the listing: where its word is and what it is (None: it has none), and its line.

    `tape` and `number` count the source tapes from 0 and their lines from 1. `source` is the whole line as
    typed, at the last of its statements; before that it is "", as in DEC's listing.
    """

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


def printed(typed: str) -> str:
    r"""Return what is to be read of `typed`: without codes that do not print, CR LF as ``\n``."""
    return typed.translate(_SILENT)


def tape(typed: str, finished: bool = True) -> bytes:
    """Return the frames of a pass in which the ASR-33 punched all it typed, from start-up to trailer.

    A pass that is not `finished` has no trailer: the machine halted.
    """
    body = punch.START_UP + frames.leader() + _frames(typed)
    return body + frames.leader() if finished else body


def _frames(typed: str) -> bytes:
    return frames.with_parity(typed.encode("ascii"), "mark")


def definitions(messages: Iterable[Message], table: Iterable[Entry]) -> str:
    """Return what pass 1 types."""
    return complaints(messages) + _symbols(table)


def complaints(messages: Iterable[Message]) -> str:
    """Return what pass 2 types while the high-speed punch works."""
    return "".join(map(_message, messages))


def object_tape(results: list[Result]) -> bytes:
    """Return the tape of pass 2 as the ASR-33 punches it, messages and all."""
    body, checksum = punch.body(results)
    pieces = [body[:2]]
    for result in results:
        if result.message:
            pieces.append(_frames(_message(result.message)))
        pieces.append(punch.frames_of(result))
    return punch.START_UP + binary.tape(b"".join(pieces), checksum)


def listing(lines: list[Line], results: Iterable[Result], table: Iterable[Entry]) -> str:
    """Return what pass 3 types."""
    return "".join(_statement(lines[result.line], result) for result in results) + _symbols(table)


def listing_line(line: Line, result: Result) -> ListingLine:
    """Return one statement of the listing."""
    address, word = (result.location, result.value) if result.kind == WORD else (None, None)
    return ListingLine(address, word, line.text if result.last else "", line.tape, line.number)


def _statement(line: Line, result: Result) -> str:
    numbers = f"{result.location:04o}  {result.value:04o}  " if result.kind == WORD else _UNNUMBERED
    source = line.text.replace("\t", "\t" + RUBOUT) if result.last else ""
    return (_message(result.message) if result.message else "") + NEW_LINE + numbers + source


def _message(message: Message) -> str:
    return RUBOUT + NEW_LINE + str(message) + RUBOUT


def _symbols(table: Iterable[Entry]) -> str:
    lines = (
        _symbol(entry) + NEW_LINE for entry in sorted(table, key=lambda entry: internal_order(entry.name))
    )
    return NEW_LINE + NEW_LINE + "".join(lines) + EOT + NEW_LINE + RUBOUT


def _symbol(entry: Entry) -> str:
    if entry.defined:
        return f"{entry.name:6}  {entry.value:04o}"
    return RUBOUT + NEW_LINE + f"UA  {entry.name:6}  AT  {entry.value:04o}" + RUBOUT
