"""A source as an editor asks about it: the symbol at a place, where it stands, what it means.

Lines and columns count from 0. The assembly that answers is the one that `pal` makes of the same text.

`formatted` puts it in columns: tags at the margin, statements at the first stop, comments below each other.

    LOOP,   TAD I POINT     /NEXT CHARACTER
            SNA
            HLT             /THE END

Only blanks and TABs before a statement and before a comment change: the words stay as they are.
"""

import re
from functools import cached_property
from itertools import groupby
from typing import NamedTuple

from pal import meaning, symbols8
from pal.assembling import FOUND, assemble
from pal.assembly import PAL8
from pal.symbols import PSEUDO_OPERATORS, SIGNIFICANT

NAME = re.compile(r"[A-Za-z][A-Za-z0-9]*")
_PSEUDO_OPERATORS = {*PSEUDO_OPERATORS, *symbols8.PSEUDO_OPERATORS, *symbols8.PALBARTS_PSEUDO_OPERATORS}
TAG, VALUE = "tag", "value"
_LINE = re.compile(
    r"[ \t]*(?P<tag>[A-Za-z][A-Za-z0-9]*[ \t]*,)?[ \t]*(?P<rest>[^/]*?)[ \t]*(?P<comment>/.*)?"
)
_AT_THE_MARGIN = re.compile(r"[*$]|[A-Za-z][A-Za-z0-9]*[ \t]*=")
_TEXTS = re.compile(r'"|\b(?:TEXT|FILENAME|DEVICE)\b', re.IGNORECASE)
_STOP = 8
_COMMENTS = 24


class Span(NamedTuple):
    """A part of a line: from column `start` to before `end`."""

    line: int
    start: int
    end: int


class Definition(NamedTuple):
    """A symbol where it is defined: as a TAG, or a VALUE by an equals sign."""

    name: str
    kind: str
    value: int
    span: Span


class Document:
    """A source text, assembled."""

    def __init__(self, text: str, name: str, dialect: str = FOUND) -> None:
        self.text = text
        self.lines = re.split(r"\r\n|\r|\n", text)
        self.assembly = assemble(text, names=[name], dialect=dialect)

    @cached_property
    def known(self) -> dict[str, str]:
        """{permanent symbol of the dialect: meaning}."""
        return meaning.names8() if self.assembly.dialect == PAL8 else meaning.names()

    def name_at(self, line: int, column: int) -> str:
        """Return the symbol at a place as it counts, six characters at most; "" in a comment or elsewhere."""
        text = self.lines[line] if line < len(self.lines) else ""
        code = text.partition("/")[0]
        for found in NAME.finditer(code):
            if found.start() <= column <= found.end():
                return found[0].upper()[:SIGNIFICANT]
        return ""

    @cached_property
    def occurrences(self) -> dict[str, list[tuple[Span, bool]]]:
        """{name: its places, each with whether it is defined there}, in source order."""
        found: dict[str, list[tuple[Span, bool]]] = {}
        for mention in self.assembly.mentions:
            place = self.assembly.place(mention.at)
            written = NAME.search(place.text, place.start)
            if written:
                span = Span(place.line - 1, written.start(), written.end())
                found.setdefault(mention.name, []).append((span, mention.defined))
        return found

    def places(self, name: str, defined: bool | None = None) -> list[Span]:
        """Return where `name` stands; only where it is, or is not, `defined`."""
        return [span for span, here in self.occurrences.get(name, ()) if defined in (None, here)]

    def refusal(self, name: str, new: str) -> str:
        """Return why the symbol `name` cannot be called `new`, "" if it can."""
        if name not in self.assembly.symbols:
            return f"{name or 'what stands here'} is no symbol that this source defines"
        if not NAME.fullmatch(new):
            return f"{new!r} is no symbol: a letter, then letters and digits"
        called = new[:SIGNIFICANT].upper()
        pal8 = self.assembly.dialect == PAL8
        if not (pal8 or new.isupper()):
            return f"{new} has small letters: PAL III knows capitals only"
        if called == name:
            return ""
        if called in {known[:SIGNIFICANT] for known in self.known}:
            return f"{called} is taken: it is a permanent symbol of {'PAL8' if pal8 else 'PAL III'}"
        if self.places(called):
            return f"{called} is taken: it stands in line {self.places(called)[0].line + 1}"
        return ""

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
        return VALUE if self.lines[span.line][span.end :].lstrip(" \t").startswith("=") else TAG

    @cached_property
    def _words(self) -> dict[int, list[tuple[int, int]]]:
        """The words of each line, with their addresses."""
        words: dict[int, list[tuple[int, int]]] = {}
        for listed in self.assembly.lines:
            if listed.address is not None and listed.word is not None:
                words.setdefault(listed.number - 1, []).append((listed.address, listed.word))
        return words

    def hover(self, line: int, column: int) -> str:
        """Return what is at a place, in Markdown: the symbol, and the words of its line; "" for nothing."""
        name = self.name_at(line, column)
        if not name:
            return ""
        said = self._symbol(name)
        for address, word in self._words.get(line, ()):
            said.append(f"`{address:04o}  {word:04o}`")
            if self._is_instruction(line):
                said += meaning.of_word(word, address)
        return "  \n".join(said)

    def _is_instruction(self, line: int) -> bool:
        names = NAME.findall(self.lines[line].partition("/")[0].upper())
        return any(name in self.known and name not in _PSEUDO_OPERATORS for name in names)

    def _symbol(self, name: str) -> list[str]:
        if name not in self.assembly.symbols:
            known = self.known.get(name)
            return [f"`{meaning.of_name(name) or f'{name}: {known}'}`"] if known else []
        lines = [span.line for span in self.places(name, defined=True)]
        where = f", defined in line {lines[0] + 1}" if lines else ""
        used = len(self.places(name, defined=False))
        said = [f"`{name}` = {self.assembly.symbols[name]:04o}{where}, used {used} time{'s' * (used != 1)}"]
        return said + [f"`{self.lines[each].strip()}`" for each in lines[:1]]

    def folds(self) -> list[tuple[int, int, bool]]:
        """Return the first and last lines of what folds: comments (True), what follows an origin."""
        comments = [line.lstrip().startswith("/") for line in self.lines]
        origins = [number for number, line in enumerate(self.lines) if line.startswith("*")]
        last = len(self.lines) - 1
        while last > 0 and not self.lines[last].strip():
            last -= 1
        ends = [number - 1 for number in origins[1:]] + [last]
        found = [(begin, end, False) for begin, end in zip(origins, ends, strict=False)]
        after = 0
        for comment, run in groupby(comments):
            begin, after = after, after + len(list(run))
            if comment:
                found.append((begin, after - 1, True))
        return [(begin, end, comment) for begin, end, comment in found if end > begin]


def formatted(source: str, dialect: str) -> str:
    """Return `source` in columns, or as it is where that would make other words of it."""
    text = "\n".join(map(_line, source.split("\n")))
    before, after = assemble(source, dialect=dialect), assemble(text, dialect=dialect)
    same = before.words == after.words and before.symbols == after.symbols
    return text if same and len(before.diagnostics) >= len(after.diagnostics) else source


def _line(line: str) -> str:
    end = "\r" if line.endswith("\r") else ""
    found = _LINE.fullmatch(line.rstrip("\r"))
    if found is None or _TEXTS.search(line):
        return line
    tag, rest, comment = (found[name] or "" for name in ("tag", "rest", "comment"))
    if not tag and not rest:
        return line.rstrip() + end
    margin = not tag and _AT_THE_MARGIN.match(rest)
    code = rest if margin else f"{tag}\t{rest}".rstrip()
    if not comment:
        return code + end
    width = len(code.expandtabs(_STOP))
    tabs = max(1, -(-(_COMMENTS - width) // _STOP))
    return code + "\t" * tabs + comment + end
