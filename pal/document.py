"""The source tapes of a program as an editor asks about them: where each symbol is, and what it means.

Tapes, lines and columns count from 0; columns are code points. The answers come from the assembly that `pal`
makes of the same tapes.
"""

import re
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import groupby, zip_longest
from typing import NamedTuple

from pal import meaning
from pal.assembling import FOUND, assemble
from pal.assembly import PAL8
from pal.diagnostics import Diagnostic
from pal.isa import IOT
from pal.pal8 import symbols as symbols8
from pal.pieces import COMMENT, NAME, NUMBER, TEXT, Piece, comment, pieces
from pal.symbols import PERMANENT, PSEUDO_OPERATORS, SIGNIFICANT
from pal.text import Text

SYMBOL = re.compile(r"[A-Za-z][A-Za-z0-9]*")
TAG, VALUE = "tag", "value"
_PSEUDO_OPERATORS = {*PSEUDO_OPERATORS, *symbols8.PSEUDO_OPERATORS}
_WORDS = {symbol.mnemonic: symbol.octal for symbol in PERMANENT} | symbols8.INSTRUCTIONS | symbols8.PALBARTS
_IOTS = {name for name, word in _WORDS.items() if word >> 9 == IOT}
_CALL = re.compile(r"\bJMS[ \t]+(?:[IZ][ \t]+)*([A-Z][A-Z0-9]*)", re.IGNORECASE)
_RETURN = re.compile(r"\bJMP[ \t]+I[ \t]+(?:Z[ \t]+)?([A-Z][A-Z0-9]*)", re.IGNORECASE)

LABEL, VARIABLE, OPERATION, IN_OUT, DIRECTIVE = "function", "variable", "keyword", "macro", "decorator"
KINDS = (LABEL, VARIABLE, OPERATION, IN_OUT, DIRECTIVE, "number", "string", "comment")
"""What a piece of a line is, by the protocol's names for the types of tokens."""


class Span(NamedTuple):
    """A part of a line of a tape: from column `start` to before `end`."""

    tape: int
    line: int
    start: int
    end: int


class Occurrence(NamedTuple):
    """One use of a symbol: where, as it is written there, and whether it is defined there."""

    span: Span
    written: str
    defined: bool


class Definition(NamedTuple):
    """A symbol where it is defined: as a TAG, or a VALUE by an equals sign."""

    name: str
    kind: str
    value: int
    span: Span


class Routine(NamedTuple):
    """A subroutine: its entry and its lines, from `first` to `last`."""

    entry: Definition
    first: int
    last: int


class Document:
    """The tapes of a program, assembled: their `texts`, and what diagnostics call them."""

    def __init__(self, texts: Sequence[Text], names: Sequence[str], dialect: str = FOUND) -> None:
        self.texts = list(texts)
        self.tapes = [text.lines for text in texts]
        self.assembly = assemble(*(text.content for text in texts), names=names, dialect=dialect)
        self.dialect = self.assembly.dialect
        self._names = names

    def found(self, tape: int) -> list[Diagnostic]:
        """Return the diagnostics of one tape."""
        return [each for each in self.assembly.diagnostics if each.file == self._names[tape]]

    @cached_property
    def known(self) -> dict[str, str]:
        """{permanent symbol of the dialect: meaning}."""
        return meaning.names8() if self.dialect == PAL8 else meaning.names()

    def line(self, tape: int, line: int) -> str:
        """Return the text of a line, "" for one that the tape does not have."""
        return self.tapes[tape][line] if line < len(self.tapes[tape]) else ""

    def characters(self, span: Span) -> tuple[int, int]:
        """Return the first and the last character of a span as its editor counts them."""
        text = self.texts[span.tape]
        return text.character(span.line, span.start), text.character(span.line, span.end)

    def written_at(self, tape: int, line: int, column: int) -> Span | None:
        """Return where the symbol at a place is written; None in a comment, in a text and elsewhere."""
        for piece in pieces(self.line(tape, line), self.dialect):
            if piece.kind == NAME and piece.start <= column <= piece.end:
                return Span(tape, line, piece.start, piece.end)
        return None

    def name_at(self, tape: int, line: int, column: int) -> str:
        """Return the significant six characters of the symbol at a place, "" for none."""
        span = self.written_at(tape, line, column)
        return self.line(tape, line)[span.start : span.end].upper()[:SIGNIFICANT] if span else ""

    @cached_property
    def occurrences(self) -> dict[str, list[Occurrence]]:
        """{name: its places}, in the order of the source."""
        found: dict[str, list[Occurrence]] = {}
        for mention in self.assembly.mentions:
            place = self.assembly.place(mention.at)
            written = SYMBOL.search(place.text, place.start)
            if written:
                span = Span(place.tape, place.line - 1, written.start(), written.end())
                found.setdefault(mention.name, []).append(Occurrence(span, written[0], mention.defined))
        return found

    def places(self, name: str, defined: bool | None = None) -> list[Span]:
        """Return where `name` is used; with `defined`, only its definitions (True) or other uses (False)."""
        return [each.span for each in self.occurrences.get(name, ()) if defined in (None, each.defined)]

    def written(self, name: str) -> str:
        """Return a symbol with all its letters, as it is first written."""
        return next((each.written for each in self.occurrences.get(name, ())), name)

    def refusal(self, name: str, new: str, tape: int = 0) -> str:
        """Return why the symbol `name` cannot be renamed `new`, in a tape, "" if it can."""
        if name not in self.assembly.symbols:
            return f"{name or 'this place'} is not a symbol that the source defines"
        if not SYMBOL.fullmatch(new):
            return f"{new!r} is not a symbol: a letter, then letters and digits"
        called = new[:SIGNIFICANT].upper()
        pal8 = self.dialect == PAL8
        if not (pal8 or new.isupper()):
            return f"{new} has small letters: PAL III knows capitals only"
        if called == name:
            return ""
        if called in {known[:SIGNIFICANT] for known in self.known}:
            return f"{called} is taken: it is a permanent symbol of {'PAL8' if pal8 else 'PAL III'}"
        if self.places(called):
            return f"{called} is taken: it is in {self._line_of(self.places(called)[0], tape)}"
        return ""

    def _line_of(self, span: Span, tape: int) -> str:
        """Return which line a place is in, as said in a tape: with the name of another one."""
        return f"line {span.line + 1}" + f" of {self._names[span.tape]}" * (span.tape != tape)

    @cached_property
    def definitions(self) -> list[Definition]:
        """The symbols of the source, in its order."""
        return sorted(
            (
                Definition(name, self._kind(span), self.assembly.symbols[name], span)
                for name in self.occurrences
                for span in self.places(name, defined=True)[:1]
                if name in self.assembly.symbols
            ),
            key=lambda definition: definition.span,
        )

    def _kind(self, span: Span) -> str:
        behind = self.line(span.tape, span.line)[span.end :].lstrip(" \t")
        return VALUE if behind.startswith("=") else TAG

    @cached_property
    def _words(self) -> dict[tuple[int, int], list[tuple[int, int]]]:
        """{(tape, line): its words with their addresses}, the literals that it makes left out."""
        words: dict[tuple[int, int], list[tuple[int, int]]] = {}
        for listed in self.assembly.lines:
            if listed.address is not None and listed.word is not None:
                here = words.setdefault((listed.tape, listed.number - 1), [])
                if not here or listed.address == here[-1][0] + 1:
                    here.append((listed.address, listed.word))
        return words

    def hover(self, tape: int, line: int, column: int) -> str:
        """Return Markdown about the symbol at a place and the words of its line, "" for none."""
        name = self.name_at(tape, line, column)
        if not name:
            return ""
        said = self._symbol(name, tape)
        for address, word in self._words.get((tape, line), ()):
            said.append(f"`{address:04o}  {word:04o}`")
            if self._is_instruction(self.line(tape, line)):
                said += meaning.of_word(word, address)
        return "  \n".join(said)

    def _is_instruction(self, line: str) -> bool:
        names = {
            line[each.start : each.end].upper() for each in pieces(line, self.dialect) if each.kind == NAME
        }
        return any(name in self.known for name in names - _PSEUDO_OPERATORS)

    def _symbol(self, name: str, tape: int) -> list[str]:
        if name not in self.assembly.symbols:
            known = next((each for each in self.known if each[:SIGNIFICANT] == name), "")
            return [f"`{meaning.of_name(known) or f'{known}: {self.known[known]}'}`"] if known else []
        at = self.places(name, defined=True)[:1]
        where = f", defined in {self._line_of(at[0], tape)}" if at else ""
        used = len(self.places(name, defined=False))
        said = [f"`{name}` = {self.assembly.symbols[name]:04o}{where}, used {used} time{'s' * (used != 1)}"]
        return said + [f"`{self.line(each.tape, each.line).strip()}`" for each in at]

    def completions(self, tape: int, line: int, column: int) -> list[tuple[str, str, str]]:
        """Return what may be written at a place: name, kind (TAG, VALUE, "" if permanent), meaning."""
        found = pieces(self.line(tape, line), self.dialect)
        if any(each.kind in (COMMENT, TEXT) and each.start < column <= each.end for each in found):
            return []
        own = [(self.written(each.name), each.kind, f"{each.value:04o}") for each in self.definitions]
        return own + [(name, "", said) for name, said in self.known.items()]

    def hints(self, tape: int) -> Iterator[tuple[int, str]]:
        """Yield each line that makes a word, with the address and the first of its words."""
        for (of, line), words in sorted(self._words.items()):
            if of == tape:
                yield line, f"{words[0][0]:04o} {words[0][1]:04o}"

    def tokens(self, tape: int) -> Iterator[tuple[Span, str, bool]]:
        """Yield each piece of the tape with its kind, one of KINDS, and whether a symbol is defined there."""
        values = {each.name for each in self.definitions if each.kind == VALUE}
        for number, line in enumerate(self.tapes[tape]):
            for piece in pieces(line, self.dialect):
                kind, defined = self._token(line, piece, values)
                yield Span(tape, number, piece.start, piece.end), kind, defined

    def _token(self, line: str, piece: Piece, values: set[str]) -> tuple[str, bool]:
        if piece.kind != NAME:
            return {NUMBER: "number", COMMENT: "comment"}.get(piece.kind, "string"), False
        name, behind = line[piece.start : piece.end].upper(), line[piece.end :].lstrip(" \t")[:1]
        if behind in (",", "="):
            return (LABEL if behind == "," else VARIABLE), True
        if name[:SIGNIFICANT] in self.assembly.symbols or name not in self.known:
            return (VARIABLE if name[:SIGNIFICANT] in values else LABEL), False
        if name in _PSEUDO_OPERATORS and len(name) > 1:
            return DIRECTIVE, False
        return (IN_OUT if name in _IOTS else OPERATION), False

    @cached_property
    def routines(self) -> list[Routine]:
        """The subroutines: each tag that a JMS calls, to its last return before the next entry."""
        code = [[line[: comment(line, self.dialect)].upper() for line in lines] for lines in self.tapes]
        called = {name[:SIGNIFICANT] for lines in code for line in lines for name in _CALL.findall(line)}
        entries = [each for each in self.definitions if each.name in called and each.kind == TAG]
        found = []
        for entry, following in zip_longest(entries, entries[1:]):
            lines, first = code[entry.span.tape], entry.span.line
            same = following is not None and following.span.tape == entry.span.tape
            end = following.span.line if following is not None and same else len(lines)
            returns = [
                number
                for number in range(first, end)
                if entry.name in (name[:SIGNIFICANT] for name in _RETURN.findall(lines[number]))
            ]
            found.append(Routine(entry, first, returns[-1] if returns else first))
        return found

    def folds(self, tape: int) -> list[tuple[int, int, bool]]:
        """Return the first and last line of each fold: comments (True), origins, subroutines, conditions."""
        lines = self.tapes[tape]
        last = len(lines) - 1
        while last > 0 and not lines[last].strip():
            last -= 1
        origins = [number for number, line in enumerate(lines) if line.startswith("*")]
        ends = [number - 1 for number in origins[1:]] + [last]
        found = [(begin, end, False) for begin, end in zip(origins, ends, strict=False)]
        found += [(each.first, each.last, False) for each in self.routines if each.entry.span.tape == tape]
        if self.dialect == PAL8:
            found += self._conditions(lines)
        after = 0
        for comments, run in groupby(line.lstrip().startswith("/") for line in lines):
            begin, after = after, after + len(list(run))
            if comments:
                found.append((begin, after - 1, True))
        return [(begin, end, comments) for begin, end, comments in found if end > begin]

    def _conditions(self, lines: Sequence[str]) -> Iterator[tuple[int, int, bool]]:
        opened: list[int] = []
        for number, line in enumerate(lines):
            texts = [piece for piece in pieces(line, self.dialect) if piece.kind not in (NAME, NUMBER)]
            for column, sign in enumerate(line):
                if sign in "<>" and not any(piece.start <= column < piece.end for piece in texts):
                    if sign == "<":
                        opened.append(number)
                    elif opened:
                        yield opened.pop(), number, False
