"""PAL8: the dialect of DEC's later assemblers, with literals, links, page operators and conditions.

    pass 1    defines the symbols
    pass 2    writes the words, with the final values

A line is read token by token. A statement is an origin, a tag, a definition, a
pseudo-operator, or an expression, which makes a word:

    expression    term, operator, term ...    + - ! & ^ % and the blank, which is OR; from left to right, in
                                              twelve bits; the first term may have a sign
    term          symbol, number, ., "c, (expression), [expression]

A memory reference comes first in its expression; I and Z may follow it, then its address, an expression too.

Each page has its literals at its end, from 0177 downward; a value stands there once for as long as the source
stays on the page, a link (the address of another page) like any other. They are put out when the source goes
to another page, those of page zero at FIELD and at the end. The source may return to a page, or be so long
that it meets its literals: `_bottom` is the lowest literal of each page, `_top` is one past its highest word.

Where a term is missing, the symbol or number looked up last is taken again, as DEC's does: `_tag` and
`_last` stay from statement to statement for that.

`exact` is DEC's own reading. Without it a source goes on where authors rely on palbart, and a note says so:
small letters are capitals, a line is not cut after 80 characters, TEXT/AB/ needs no blank, PAUSE does not
end the file, a tag may have the name of an instruction, and palbart's names are known where they are not
defined. `wipe` is /W: what was put out of a page is forgotten, so that another overlay may go there.

Not emulated: /B, /E, /F, /O; room for symbols; literals below a bound that words have pushed up, for which
DEC's searches all memory; the value that an expunged name keeps.

Sources: DEC's PAL8 V10D under OS/8 on several thousand sources; PAL8.PA (V13, 1975); palbart 2.13.
"""

from collections.abc import Callable
from typing import NamedTuple

from pal import symbols8
from pal.assembler import START, Output, Punched, Written
from pal.isa import ADDRESS, CURRENT_PAGE, INDIRECT, PAGE
from pal.messages import Worded, worded
from pal.notes import Mention, Note, note
from pal.punch import BLOCK
from pal.source import Line, plain
from pal.symbols import SIGNIFICANT
from tapes.binary import FIELD, ORIGIN, WORD

_MASK = 0o7777
_CELLS = 34  # of DEC's push-down list
_CELLS_OF_EXPRESSION, _CELLS_OF_REFERENCE, _CELLS_OF_LITERAL, _CELLS_OF_EQUALS = 1, 2, 4, 6
_LEAST_IN_PAGE, _LEAST_IN_ZERO = 0o100, 0o20  # DEC has no room for literals below
LINE = 80  # characters of a line that DEC's keeps

# What a symbol is.
PLAIN, REFERENCE, MARK, PSEUDO, WEAK = 1, 2, 3, 4, 5


class Fatal(Exception):
    """PAL8 goes no further."""


class Symbol:
    """A symbol: what it is, its value, and whether it is permanent.

    `passed` is the pass that defined it last, 0 if the source does not; `where`, the line and column.
    """

    def __init__(self, name: str, kind: int, value: int, permanent: bool) -> None:
        self.name = name
        self.kind = kind
        self.value = value
        self.permanent = permanent
        self.passed = 0
        self.where = (0, 0)


class Complaint(NamedTuple):
    """A message of DEC's: its code and place, as it is typed; the pass; our place; and what we say of it."""

    code: str
    location: str
    number: int
    at: int
    about: str
    advice: str


def _permanent() -> dict[str, Symbol]:
    return {
        **{name: Symbol(name, REFERENCE, value, True) for name, value in symbols8.REFERENCES.items()},
        **{name: Symbol(name, PLAIN, value, True) for name, value in symbols8.INSTRUCTIONS.items()},
        **{name[:SIGNIFICANT]: Symbol(name, PSEUDO, at, True) for name, at in symbols8.HANDLERS.items()},
        **{name: Symbol(name, MARK, value, True) for name, value in symbols8.MARKS.items()},
    }


def _is_letter(character: str) -> bool:
    return "A" <= character <= "Z"


def _is_figure(character: str) -> bool:
    return "0" <= character <= "9"


def _operates(character: str) -> bool:
    return character in "+-!&^%"


def _ends(character: str) -> bool:
    r"""Tell whether an expression ends before a character: \n is the end of the line."""
    return character in "\n;)]><"


class Assembler:
    """One run of PAL8 over the lines of a source: `run`, pass 1 and then pass 2.

    symbols     {name: Symbol}
    written     the words, in the order of the source; `output`, what is punched
    places      (line, first column, the one after) of each statement and of what is pointed at
    complaints  DEC's messages of both passes, in order; `notes`, what is otherwise in DEC's or in palbart
    mentions    the symbols where they stand
    origins     the lines with `*`, each with whether it is a number alone
    ended       the line of the `$`; `fatal`, whether PAL8 went no further
    """

    def __init__(self, lines: list[Line], wipe: bool = False, exact: bool = False) -> None:
        self._lines = lines
        self._texts = [line.text[:LINE] if exact else line.text for line in lines]
        self._codes = [plain(text) if exact else plain(text).upper() for text in self._texts]
        self._wipe = wipe
        self._exact = exact
        self.symbols = _permanent()
        self.written: list[Written] = []
        self.output: Output = []
        self.places: list[tuple[int, int, int]] = []
        self.complaints: list[Complaint] = []
        self.notes: list[Note] = []
        self.mentions: list[Mention] = []
        self.origins: list[tuple[int, bool]] = []
        self.ended = len(lines)
        self.fatal = False
        self._tag = Symbol("", PLAIN, 0, False)
        self._last = 0
        self._is_undefined = False
        self._offset = 0  # from where a word runs to where it is loaded
        self._next_offset = 0
        self._skips_origin = False
        self._expunged = False
        self._early: set[str] = set()  # names that are used before they are defined

    def run(self) -> None:
        """Run both passes, as far as it goes."""
        try:
            self._pass(1)
            if not self._exact and not self._expunged:
                self._add_palbarts()
            self._pass(2)
        except Fatal:
            self.fatal = True

    def _pass(self, number: int) -> None:
        self._number = number
        self._location = START
        self._tagged = ""  # the last tag, and its location
        self._tagged_at = 0
        self._dropped = False  # whether a character of the statement was passed over
        self._slips = False  # whether the statement was spoken of as a whole
        self._named = -1  # the column where a word begins
        self._begun = 0  # the column where a pseudo-operator begins
        self._opens = False  # whether it is a condition
        self._field = 0
        self._level = 0  # of conditions
        self._radix = 8
        self._punching = True
        self._stack = 0
        self._loading = START  # where the loader stands, its field above the twelve bits
        self._checksum = 0
        self._index = -1
        self._clear_pools()
        self._pool_end = 0o200
        self._set_origin(START)
        while self._index + 1 < len(self._lines):
            self._index += 1
            self._go_to(0)
            if self._line():
                self.ended = self._index
                break
        self._put_out_page()
        self._next_offset = 0
        self._put_out_zero()
        self._punching = True
        self._put(WORD, self._checksum & _MASK)

    def _add_palbarts(self) -> None:
        """Let palbart's names be known that the source does not define."""
        for name, value in symbols8.PALBARTS.items():
            if name not in self.symbols:
                self.symbols[name] = Symbol(name, WEAK, value, False)

    def place_of_line(self, index: int) -> int:
        """Return the place of a whole line."""
        self.places.append((index, 0, len(self._lines[index].text)))
        return len(self.places) - 1

    # The tokens of the line

    def _go_to(self, column: int) -> None:
        """Go to `column` of the line."""
        self._code = self._codes[self._index]
        self._end = column
        self._advance()

    def _advance(self) -> None:
        r"""Take the next token: a name, number, `"` with its character, comment, another character, or none.

        `_first` is its first character, \n if there is none; `_before`, the column after the token before it.
        """
        code = self._code
        length = len(code)
        start = self._before = self._end
        while start < length and code[start] in " \t":
            start += 1
        self._blank = start > self._before
        self._start = self._end = start
        self._first = "\n"
        if start < length:
            self._first = code[start]
            self._end = self._token_end(start + 1, length)
        self._token = code[start : self._end]
        if self._first == "/" and not self._blank:
            self._pass_comment()

    def _token_end(self, end: int, length: int) -> int:
        """Return where the token ends that begins just before `end`."""
        code = self._code
        first = self._first
        if _is_letter(first):
            while end < length and (_is_letter(code[end]) or _is_figure(code[end])):
                end += 1
        elif _is_figure(first):
            while end < length and _is_figure(code[end]):
                end += 1
        elif first == '"':
            return min(end + 1, length)
        return length if first == "/" else end

    def _pass_blank(self) -> None:
        self._blank = False
        if self._first == "/":
            self._pass_comment()

    def _pass_comment(self) -> None:
        """Go to the line's end; within a condition `<` and `>` count in a comment too."""
        self._first = "\n"
        self._token = ""
        if self._level:
            self._level = self._level_after(self._start)

    def _level_after(self, column: int) -> int:
        """Return the level of conditions after a comment: when all are closed, the rest does not count."""
        level = self._level
        for character in self._texts[self._index][column:]:
            if level:
                level += (character == "<") - (character == ">")
        return level

    def _keep(self, start: int, end: int) -> int:
        """Keep a place; return its index."""
        self.places.append((self._index, start, end))
        return len(self.places) - 1

    def _mention(self, name: str, start: int, end: int, defined: bool) -> None:
        """Keep where a symbol stands, in pass 2."""
        if self._number == 2:
            self.mentions.append(Mention(name, self._keep(start, end), defined))

    # Messages

    def _say(self, key: str, start: int = -1, **values: str) -> None:
        """Type a message of DEC's, of what was read since column `start`, or of the token."""
        self._complain(worded(key, **values), start)

    def _complain(self, said: Worded, start: int = -1) -> None:
        """Type a message; of several illegal characters in a statement we speak of the first."""
        code, about, advice = said
        if self._number == 1 and code in ("IE", "PE", "ZE"):
            return
        location = f"{self._location:04o}"
        if self._tagged:
            distance = self._location - self._tagged_at & _MASK
            location = f"{self._tagged}+{distance:04o}" if distance else self._tagged
        if code == "IC":
            about = "" if self._dropped else about
            self._dropped = True
        self.complaints.append(Complaint(code, location, self._number, self._span(start), about, advice))

    def _note(self, key: str, start: int = -1, **values: str) -> None:
        if self._number == 2:
            self.notes.append(note(key, self._span(start), **values))

    def _span(self, start: int) -> int:
        if start < 0:
            return self._keep(self._start, max(self._end, self._start + 1))
        return self._keep(start, max(self._before, start + 1))

    def _drop(self) -> None:
        """Pass over a token that cannot stand here: IC for each of its characters."""
        self._complain_of_token(self._illegal(self._token))
        self._skip_token()

    def _complain_of_token(self, said: Worded) -> None:
        for _ in range(1 if self._first == '"' else len(self._token)):
            self._complain(said)

    def _skip_token(self) -> None:
        """Take the next token, which is the character after a `"`."""
        if self._first == '"':
            self._end = self._start + 1
        self._advance()

    def _illegal(self, token: str) -> Worded:
        """Return what is said of a token that cannot stand where it does."""
        if self._slips:
            return Worded("IC", "", "")
        start = self._start
        text = self._texts[self._index]
        if _operates(token[0]):
            return worded("IC after" if start == self._before else "IC beside", token=token)
        if text[start : start + 1] == "\xa0":
            return worded("IC no-break")
        if token in ("*", ")", "]", ">", ",", "=", ":"):
            return worded(f"IC {token}")
        if not token[0].isalnum():
            return worded("IC other", character=text[start : start + 1])
        if self._before == start and text[start - 1 : start].isdigit() and not token[0].isdigit():
            word = text[len(text[:start].rstrip("0123456789")) : self._end]
            if text[self._end : self._end + 1] == ",":
                return worded("IC tag", word=word)
            return worded("IC number", letter=token[0], word=word)
        return worded("IC reference" if self._tag.kind == REFERENCE else "IC token", token=token)

    # Statements

    def _line(self) -> bool:
        """Assemble the line; return whether `$` ended the program."""
        begins = True
        while True:
            if begins:
                self._dropped = self._slips = False
            if self._blank:
                self._pass_blank()
            if self._first == "$":
                return True
            if self._first not in "\n;>":
                begins = False
                if self._statement():
                    continue
            if not self._ends_statement():
                return False
            begins = True

    def _ends_statement(self) -> bool:
        """Go to the next statement; return whether there is one on the line."""
        while True:
            if self._blank:
                self._pass_blank()
            if self._first == "\n":
                return False
            if self._first == ";":
                self._advance()
                return True
            if self._first == ">" and self._level:
                self._level -= 1
                self._advance()
            else:
                self._drop()

    def _statement(self) -> bool:
        """Assemble a statement; return whether another may follow directly: after a tag, a condition."""
        self._names: list[str] = []
        self._link = False
        self._named = -1
        start = self._start
        if self._first == "*":
            self._advance()
            self._pass_blank()
            location = self._expression(False, True)
            if self._number == 2:
                number = self._texts[self._index][start + 1 : self._before].strip(" \t0123456789") == ""
                self.origins.append((self._index, number))
            self._set_location(location, False)
            return False
        if not _is_letter(self._first):
            self._word(False, start)
            return False
        name = self._token[:SIGNIFICANT]
        found = self.symbols.get(name)
        if found is not None and found.kind == PSEUDO:
            level = self._level
            self._look_up()
            if found.name == "TEXT" and not self._exact:
                self._level = level  # what stands after TEXT is no comment
            self._begun = start
            self._opens = False
            _ROUTINE_OF[found.name](self)
            return self._opens
        end = self._end
        follows = self._code[end] if end < len(self._code) else "\n"
        if follows == "," or (follows == ":" and not self._exact):
            self._look_up()
            if follows == ":":
                self._note("PN31 PAL8", start, name=name)
                self._say("IC :")
            self._define_tag(name, start, end)
            return True
        if follows == "=":
            self._look_up()
            self._assign(name, PLAIN, start, end)
            return False
        self._look_up()
        self._mention(name, start, end, False)
        self._word(True, start)
        return False

    def _word(self, found: bool, start: int) -> None:
        """Assemble an expression as a word; its first symbol may be looked up already."""
        self._named = start
        value = self._expression(found, True)
        self._write(value, self._keep(start, self._before) if self._number == 2 else 0)

    def _look_up(self) -> None:
        """Look the token up, and take the next; `_tag`, `_last` and `_is_undefined` say what was found."""
        name = self._token[:SIGNIFICANT]
        self._looked_up = self._start
        found = self.symbols.get(name)
        self._is_undefined = found is None
        self._tag = Symbol(name, PLAIN, 0, False) if found is None else found
        self._last = self._tag.value
        self._advance()

    def _write(self, value: int, at: int) -> None:
        """Put a word where the location is."""
        page = self._location >> 7
        below = self._location & ADDRESS
        if below >= self._top[page]:
            self._top[page] = below + 1
        if below >= self._bottom[page]:
            self._say_full(page, -1)
            self._bottom[page] = below + 1
        if self._number == 2:
            address = self._field << 12 | self._location + self._offset & _MASK
            self._put_word(Written(address, value, at, self._names, False, self._link))
        self._location = self._location + 1 & _MASK
        if not self._location & ADDRESS:
            self._enter_page()

    def _say_full(self, page: int, start: int) -> None:
        """Say that the words and the literals of a page meet."""
        words, literals = (page << 7) + self._top[page] - 1 & _MASK, (page << 7) + self._bottom[page]
        self._say("PE" if page else "ZE", start, words=f"{words:04o}", literals=f"{literals:04o}")

    def _put_word(self, written: Written) -> None:
        """Keep a word, and punch it: after NOPUNCH it may be loaded elsewhere."""
        self.written.append(written)
        if not self._punching:
            return
        if written.address != self._loading:
            written = Written(self._loading, written.word, written.at, written.names)
        self.output.append(written)
        self._loading = self._loading & ~_MASK | self._loading + 1 & _MASK
        self._checksum += (written.word >> 6) + (written.word & 0o77)

    def _put(self, kind: str, value: int) -> None:
        """Punch an origin, a field or the checksum, in pass 2."""
        if self._number == 1 or not self._punching:
            return
        self.output.append(Punched(kind, value))
        if kind == FIELD:
            self._loading = value << 12 | self._loading & _MASK
        elif kind == ORIGIN:
            self._loading = self._loading & ~_MASK | value
            self._checksum += 0o100 + (value >> 6) + (value & 0o77)
        elif kind == BLOCK:
            self._checksum += value & 0o77

    # Tags and definitions

    def _define_tag(self, name: str, start: int, end: int) -> None:
        """`NAME,`: define it as the location."""
        self._mention(name, start, end, True)
        self._advance()
        self._is_undefined = False
        symbol = self.symbols.get(name)
        if symbol is not None and not self._exact and symbol.kind in (PLAIN, REFERENCE) and not symbol.passed:
            at = self._keep(start, end)
            self.notes.append(note("PN30 PAL8", at, name=name, value=f"{symbol.value:04o}"))
            symbol = None
        if symbol is None or symbol.kind == WEAK:
            symbol = self.symbols[name] = Symbol(name, PLAIN, self._location, False)
            symbol.where = (self._index, start)
            self._tag = symbol
            self._last = self._location
        elif symbol.value != self._location:
            self._say_redefined(symbol, start)
            return
        symbol.passed = self._number
        self._tagged = name
        self._tagged_at = self._location

    def _say_redefined(self, symbol: Symbol, start: int) -> None:
        """Say that a tag has another value: it marks a reference, moved since pass 1, or stands twice."""
        moved = symbol.where == (self._index, start)
        key = "ID mark" if symbol.kind == MARK else "ID moved" if moved else "ID"
        value, location = f"{symbol.value:04o}", f"{self._location:04o}"
        self._say(key, start, name=symbol.name, value=value, location=location)

    def _assign(self, name: str, kind: int, start: int, end: int) -> None:
        """`NAME=expression`, the symbol looked up already; `kind` is REFERENCE after FIXMRI."""
        self._mention(name, start, end, True)
        self._advance()
        is_undefined = self._is_undefined
        self._push(_CELLS_OF_EQUALS)
        self._pass_blank()
        self._named = -1
        value = self._expression(False, True)
        self._stack -= _CELLS_OF_EQUALS
        self._is_undefined = is_undefined
        if self._undefined:
            self._say("IE", start, name=name)
            return
        self._is_undefined = False
        symbol = self.symbols.get(name)
        if symbol is None or symbol.kind == WEAK:
            symbol = self.symbols[name] = Symbol(name, kind, value, False)
        elif symbol.value != value:
            before, now = f"{symbol.value:04o}", f"{value:04o}"
            if symbol.permanent:
                self._say("RD permanent", start, name=name, value=before, now=now)
            elif symbol.passed == self._number and name in self._early:
                self._note("PN41", start, name=name, value=before, now=now)
        if symbol.value != value or symbol.passed or not symbol.permanent:
            symbol.value = value
            symbol.passed = self._number
        if symbol.kind in (PLAIN, REFERENCE):
            symbol.kind = kind
        self._tag = symbol
        self._last = value

    # Expressions

    def _push(self, cells: int) -> None:
        """Take cells of DEC's push-down list."""
        self._stack += cells
        if self._stack > _CELLS:
            self._die("BE")

    def _die(self, key: str) -> None:
        self._say(key)
        raise Fatal(key)

    def _expression(self, found: bool, may_refer: bool) -> int:
        """Return the value of an expression; `_undefined` is not 0 if something in it is undefined.

        Its first symbol may be looked up already: `found`. It may be a memory reference.
        """
        self._push(_CELLS_OF_EXPRESSION)
        self._value = 0
        self._undefined = 0
        self._operator = "+"
        self._may_refer = may_refer
        self._has_blank = False  # and palbart's value is that of `_ored` OR `_group`
        self._ored = 0
        self._group = 0
        begun = self._start
        if found:
            goes_on = self._take_symbol()
        else:
            if self._first in "+-":
                self._take_operator(self._first)
                self._advance()
            goes_on = self._term()
        while goes_on and self._goes_on(begun):
            goes_on = self._term()
        self._stack -= _CELLS_OF_EXPRESSION
        return self._value

    def _goes_on(self, begun: int) -> bool:
        """Take the operator after a term; return whether there is one."""
        while True:
            if self._blank:
                self._take_operator(" ")
                self._pass_blank()
                return True
            if _ends(self._first):
                self._end_expression(begun)
                return False
            if _operates(self._first):
                self._take_operator(self._first)
                self._advance()
                return True
            self._drop()

    def _take_operator(self, operator: str) -> None:
        self._operator = operator
        self._may_refer = False

    def _end_expression(self, begun: int) -> None:
        if self._undefined:
            self._undefined = -1
            self._value = 0
        elif self._has_blank and self._ored | self._group != self._value:
            other = f"{self._ored | self._group:04o}"
            self._note("PN42", begun, value=f"{self._value:04o}", other=other)

    def _term(self) -> bool:
        """Take a term; return whether the expression may go on after it."""
        while True:
            first = self._first
            if self._blank:
                self._say("IC blank", self._before)
                self._pass_blank()
            elif _is_letter(first):
                self._mention(self._token[:SIGNIFICANT], self._start, self._end, False)
                self._look_up()
                return self._take_symbol()
            elif _is_figure(first):
                self._last = self._figures(self._token)
                self._advance()
                return self._combine()
            elif first == ".":
                self._last = self._location
                self._advance()
                return self._combine()
            elif first == '"':
                return self._take_quoted(self._token)
            elif first in "([":
                return self._take_literal(first)
            elif not _ends(first):
                self._drop()
            elif self._operator == " ":
                self._end_expression(self._start)
                return False
            else:
                self._say("IC address" if self._tag.kind == MARK else "IC missing", name=self._tag.name)
                return self._take_symbol()

    def _take_quoted(self, token: str) -> bool:
        if len(token) == 1:
            self._say('IC "')
            self._advance()
            self._end_expression(self._start)
            return False
        character = self._texts[self._index][self._start + 1]
        if not character.isascii():
            self._say("IC Teletype", character=character)
            character = "?"
        if character == "\t":
            self._note("PN43")
        self._last = ord(character) | 0o200
        self._advance()
        return self._combine()

    def _combine(self) -> bool:
        """Combine the value with the term by the operator; return True."""
        operator = self._operator
        last = self._last
        if operator == " ":
            self._ored = self._ored | self._group if self._has_blank else self._value
            self._group = last
            self._has_blank = True
        elif self._has_blank:
            self._group = self._operate(self._group, operator, last)
        self._value = self._operate(self._value, operator, last)
        if operator == "%":
            self._last = -last & _MASK
        return True

    def _operate(self, value: int, operator: str, last: int) -> int:
        if operator == "+":
            return value + last & _MASK
        if operator == "-":
            return value - last & _MASK
        if operator == "&":
            return value & last
        if operator == "^":
            return value * last & _MASK
        if operator == "%":
            return self._divide(value, last)
        return value | last

    def _divide(self, value: int, last: int) -> int:
        """Return a quotient without signs, 0 where palbart crashes."""
        quotient = value // last if last else 0
        if last == 0:
            self._note("PN45 zero")
        elif (value | last) & 0o4000:
            self._note("PN45", value=f"{value:04o}", by=f"{last:04o}", quotient=f"{quotient:04o}")
        return quotient

    def _take_symbol(self) -> bool:
        """Take the symbol looked up last for a term; return whether the expression may go on after it."""
        tag = self._tag
        self._names.append(tag.name)
        if tag.kind == PSEUDO:
            self._say("IP", self._looked_up, name=tag.name)
        elif tag.kind == WEAK and not tag.permanent:
            tag.permanent = True  # it is told once
            self._note("PN47", self._looked_up, name=tag.name, octal=f"{tag.value:04o}")
        if self._is_undefined:
            self._early.add(tag.name)
            self._is_undefined = False
            self._undefined += 1
            if self._number == 2 or not self._undefined:
                self._say_undefined(tag.name)
        refers = tag.kind == REFERENCE or (tag.kind == WEAK and tag.name in symbols8.PALBARTS_REFERENCES)
        if not (refers and self._blank):
            return self._combine()
        self._pass_blank()
        if self._first in "\n;" or not self._may_refer:
            return self._combine()
        return self._refer(self._last)

    def _say_undefined(self, name: str) -> None:
        """Say that a symbol is undefined: one that begins the line may be a tag."""
        text = self._texts[self._index]
        start, end = self._looked_up, self._before
        written = text[start:end].upper()
        instead = symbols8.ELSEWHERE.get(name, "")
        key = "US elsewhere" if instead else "US"
        if self._named == start == 0 and text[end : end + 1] in (" ", "\t") and not _ends(self._first):
            key = "US EQU" if self._token.upper() == "EQU" else "US tag"
            self._slips = True
        self._say(key, start, name=written, instead=instead)

    def _figures(self, token: str) -> int:
        """Return the value of a number; an 8 or 9 in octal is passed over."""
        if self._radix == 8 and ("8" in token or "9" in token):
            good = ""
            for figure in token:
                if figure < "8":
                    good += figure
                else:
                    self._say("IC octal", figure=figure, number=token)
            token = good or "0"
        value = int(token[max(len(token) - 12, 0) :], self._radix)
        address = self._named < 0 and value < 0o100000  # with its field, in an origin or a definition
        if (value > _MASK and not address) or len(token) > 12:
            kept = value & _MASK
            self._note("PN04 PAL8", number=token, word=f"{kept:04o}", octal=f"{kept:o}")
        return value & _MASK

    def _refer(self, operation: int) -> bool:
        """Take the address of a memory reference, and put both together; return False: no more follows."""
        start = self._start
        self._push(_CELLS_OF_REFERENCE)
        marks = 0
        found = False
        while _is_letter(self._first) and not found:
            self._mention(self._token[:SIGNIFICANT], self._start, self._end, False)
            self._look_up()
            if self._tag.kind == MARK:
                self._names.append(self._tag.name)
                marks = marks + (self._last or 1) & _MASK
                self._pass_blank()
            else:
                found = True
        number = not found and self._first == "-" and self._code[self._end :].lstrip()[:1].isdigit()
        address = self._expression(found, False)
        self._stack -= _CELLS_OF_REFERENCE
        if number and address & 0o7000 == 0o7000:
            self._note("PN51", start, address=f"{address:04o}")
        elsewhere = -1
        if address & PAGE:
            if (address ^ self._location) & PAGE:
                elsewhere = address
                address = self._find(address, self._location >> 7, start)
                self._link = True
                operation = self._indirect(operation, elsewhere, start)
            operation = operation + CURRENT_PAGE & _MASK
            if marks & 0o77:
                self._say("IZ", start, address=f"{address:04o}")
        if marks & 0o7700:
            operation = self._indirect(operation, elsewhere, start)
        self._last = operation
        self._value = (address & ADDRESS) + operation & _MASK
        return False

    def _indirect(self, operation: int, elsewhere: int, start: int) -> int:
        """Return a memory reference with I, which it may not have twice: a link to `elsewhere` has it."""
        if operation & INDIRECT and elsewhere < 0:
            self._say("II", start)
        elif operation & INDIRECT:
            self._say("II link", start, address=f"{elsewhere:04o}", location=f"{self._location:04o}")
        return operation | INDIRECT

    # Literals

    def _take_literal(self, opening: str) -> bool:
        """Take `(e)`, a literal on this page, or `[e]`, one on page zero; return True."""
        start = self._start
        self._advance()
        self._pass_blank()
        self._push(_CELLS_OF_LITERAL)
        kept = (self._may_refer, self._operator, self._value, self._has_blank, self._ored, self._group)
        link = self._link
        named = self._named
        self._named = -1
        value = self._expression(False, True)
        self._look_for_division(start)
        self._named = named
        self._link = link
        self._last = self._find(value, 0 if opening == "[" else self._location >> 7, start)
        self._may_refer, self._operator, self._value, self._has_blank, self._ored, self._group = kept
        self._stack -= _CELLS_OF_LITERAL
        if self._first in ")]":
            self._advance()
        return self._combine()

    def _look_for_division(self, start: int) -> None:
        """Note a comment that was meant for a division: `(6/2)`."""
        text = self._texts[self._index][self._before :] if self._first == "\n" else ""
        if text[:1] == "/" and text[1:2].isalnum() and ")" in text:
            self._note("PN52", start)

    def _find(self, value: int, page: int, start: int) -> int:
        """Return the address of a literal of a page; it is stored if it does not stand there yet."""
        pool = self._here if page else self._zero
        bottom = self._bottom[page]
        known = pool.get(value)
        if known is not None and known >= bottom:
            return page << 7 | known
        place = bottom - 1
        least = _LEAST_IN_PAGE if page else _LEAST_IN_ZERO
        words = self._here_words if page else self._zero_words
        if self._top[page] >= bottom or place < least:
            self._say_full(page, start)
        else:
            self._bottom[page] = place
            pool[value] = place
            if self._pool_end < 0o200 and page and value in self._before_here[page]:
                self._note("PN46", start, value=f"{value:04o}")
        words[place] = (value, self._keep(start, self._before) if self._number == 2 else 0)
        return (page << 7) + place & _MASK

    def _clear_pools(self) -> None:
        self._bottom = [0o200] * 32
        self._top = [0] * 32
        self._here: dict[int, int] = {}
        self._zero: dict[int, int] = {}
        self._here_words = [(0, 0)] * 128
        self._zero_words = [(0, 0)] * 128
        self._before_here: list[set[int]] = [set() for _ in range(32)]
        self._tagged = ""
        self._tagged_at = 0

    def _enter_page(self) -> None:
        self._pool_end = self._bottom[self._location >> 7]
        self._here = {}

    def _put_out_page(self) -> None:
        """Put out the literals of the page of the location that stand there since it was entered."""
        page = self._location >> 7
        if not page:
            return
        bottom = self._bottom[page]
        if bottom < self._pool_end:
            self._skips_origin = False
            self._set_origin(page << 7 | bottom)
            self._put_out(self._here_words, bottom, self._pool_end)
            self._before_here[page].update(self._here)
            if self._wipe:
                self._bottom[page] = self._pool_end
        if self._wipe:
            self._top[page] = 0

    def _put_out_zero(self) -> None:
        bottom = self._bottom[0]
        if bottom < 0o200:
            self._set_origin(bottom)
            self._put_out(self._zero_words, bottom, 0o200)

    def _put_out(self, words: list[tuple[int, int]], first: int, after: int) -> None:
        for place in range(first, after):
            value, at = words[place]
            if self._number == 2:
                address = self._field << 12 | self._location + self._offset & _MASK
                self._put_word(Written(address, value, at, [], True))
            self._location = self._location + 1 & _MASK

    # Origins

    def _set_location(self, location: int, relocates: bool) -> None:
        """`*` and RELOC: go to a location, by an origin, which RELOC need not punch."""
        self._skips_origin = relocates
        if self._undefined:
            self._say("UO")
        if (location ^ self._location) & PAGE:
            self._put_out_page()
            self._offset = self._next_offset
            self._begin_page(location)
        else:
            self._offset = self._next_offset
            self._set_origin(location)
            self._tagged = ""

    def _begin_page(self, location: int) -> None:
        self._set_origin(location)
        self._enter_page()
        self._tagged = ""

    def _set_origin(self, location: int) -> None:
        self._location = location & _MASK
        if self._number == 2:
            if not self._skips_origin:
                self._put(ORIGIN, self._location + self._offset & _MASK)
            self._skips_origin = False

    # What pseudo-operators do

    def _argument(self) -> int:
        """Return the argument of a pseudo-operator."""
        self._pass_blank()
        self._named = -1
        return self._expression(False, True)

    def _has_argument(self) -> bool:
        self._pass_blank()
        return self._first not in "\n;>"

    def _find_token(self, wanted: str, missing: Worded, blanks: bool = True) -> bool:
        """Pass over what comes before a token that is wanted, or a name; return whether there is one.

        `blanks` is whether blanks between are nothing; else they are illegal too.
        """
        self._pass_blank()
        while self._blank or not (self._token == wanted if wanted else _is_letter(self._first)):
            if not self._blank and self._first not in "\n;":
                self._complain_of_token(missing)
                self._skip_token()
                self._blank = self._blank and not blanks
                if not self._blank:
                    self._pass_blank()
                continue
            self._complain(missing)
            if not self._blank:
                return False
            self._pass_blank()
        return True

    def _name_to_ask(self, name: str) -> bool:
        """Look up the symbol of IFDEF or IFNDEF; return whether it is undefined."""
        asked, start = self._token[:SIGNIFICANT], self._start
        self._mention(asked, start, self._end, False)
        kept = self._is_undefined
        self._look_up()
        is_undefined = self._is_undefined or self._tag.kind == WEAK
        self._is_undefined = kept
        if self._tag.kind == PSEUDO:
            self._say("IP asked", start, name=self._tag.name)
        elif self._tag.passed == 1 and self._number == 2:
            text = self._texts[self._index].upper()
            if f"{text[start : self._before]}=" not in text:  # `IFNDEF A <A=5>` is the same in palbart
                self._note("PN49", start, name=asked)
        return is_undefined

    def _condition(self, holds: bool) -> None:
        """Take what stands after `<`, or pass over it."""
        if not self._find_token("<", worded("IC <")):
            return
        self._opens = True
        if holds:
            self._advance()
            self._level += 1
        else:
            self._pass_over()

    def _pass_over(self) -> None:
        """Pass over a condition that does not hold, from its `<` to its `>`, whatever they stand in."""
        began, end = self._index, self._end
        outside = self._level
        text = self._texts[self._index]
        column = end
        if text[column : column + 1] == "/":
            self._level = self._level_after(column)
            column = len(text)
        self._level += 1
        while True:
            while column < len(text) and ("<" in text or ">" in text):
                character = text[column]
                column += 1
                self._level += (character == "<") - (character == ">")
                if character == "/":
                    self._level = self._level_after(column)
                    column = len(text)
                if self._level <= outside and character in ("/", ">"):
                    self._go_to(column)
                    return
            if self._index + 1 == len(self._lines):
                self._index, self._start, self._end = began, self._begun, end
                self._die("PH")
            self._index += 1
            text = self._texts[self._index]
            column = 0
            if text[:1] == "$":
                self._start, self._end = 0, 1
                self._note("PN50")

    def _pack_text(self) -> None:
        """TEXT: two characters a word, six bits each, and 00 at the end."""
        text = self._texts[self._index]
        column = self._before
        if self._exact and not self._blank and self._first in "\n;":
            self._write(0, self._keep(self._begun, column))
            return
        self._before = column + 1
        if not self._exact and text[column : column + 1] in ("/", ";"):
            self._note("PN44", self._begun, mark=text[column])
        last = "_" if self._exact else "~"
        while column < len(text) and not "!" <= text[column] <= last:
            column += 1
        first = column
        delimiter = text[column : column + 1]
        if delimiter == "":
            self._note("PN54", self._begun)
        codes: list[int] = []
        at = self._keep(self._begun, len(text))
        column += 1
        while column < len(text) and text[column] != delimiter:
            character = text[column]
            if " " <= character <= last:
                codes.append(ord(character) & 0o77)
                if len(codes) == 2:
                    self._write(codes[0] << 6 | codes[1], at)
                    codes = []
            else:
                self._start, self._end = column, column + 1
                self._say("IC TEXT")
            column += 1
        self._before = min(column + 1, len(text))
        if not self._exact and any("`" <= character <= "~" for character in text[first:column]):
            self._note("PN35 TEXT", self._begun)
        if delimiter and column == len(text):
            self._note("PN54 end", self._begun, mark=delimiter)
        self._write(codes[0] << 6 if codes else 0, at)
        self._go_to(self._before)

    def _pack(self, room: int) -> None:
        """Pack letters and digits, two a word, and 00 for those that are not there."""
        characters = ""
        while not self._blank and (_is_letter(self._first) or _is_figure(self._first)):
            characters += self._token
            self._advance()
        if not characters and room > 2:
            self._note("PN54 name", self._begun)
        characters = characters[:room].ljust(room, "\0")
        at = self._keep(self._begun, self._before)
        for first in range(0, room, 2):
            self._write((ord(characters[first]) & 0o77) << 6 | ord(characters[first + 1]) & 0o77, at)


# The pseudo-operators


def _radix(run: Assembler, radix: int) -> None:
    run._radix = radix


def _punching(run: Assembler, punching: bool) -> None:
    run._punching = punching


def _page(run: Assembler) -> None:
    """Go to page n, or to the next one."""
    run._put_out_page()
    if not run._has_argument():
        run._begin_page(run._location + ADDRESS & PAGE)
        return
    page = run._argument()
    if page > PAGE >> 7:
        run._note("PN53", run._begun, page=f"{page:o}", taken=f"{page & 0o37:o}")
    run._begin_page(page << 7 & PAGE)


def _field(run: Assembler) -> None:
    run._put_out_page()
    run._put_out_zero()
    run._field = run._argument() & 7
    run._put(FIELD, run._field)
    run._clear_pools()
    run._begin_page(START)


def _zeros(run: Assembler) -> None:
    count = run._argument()
    at = run._keep(run._begun, run._before)
    for _ in range(count):
        run._write(0, at)


def _relocate(run: Assembler) -> None:
    """Assemble what follows for where it runs, or again for where it is loaded."""
    if run._has_argument():
        location = run._argument()
        run._next_offset = run._location + run._offset - location & _MASK
    else:
        location = run._location + run._offset & _MASK
        run._next_offset = run._undefined = 0
    run._set_location(location, True)


def _device(run: Assembler) -> None:
    run._pass_blank()
    run._pack(4)


def _filename(run: Assembler) -> None:
    """Pack six characters, and two after the point."""
    run._pass_blank()
    run._pack(6)
    if run._first == "." and not run._blank:
        run._advance()
    run._pack(2)


def _if_defined(run: Assembler, name: str) -> None:
    """Ask for a symbol: in pass 2 what is defined below is defined."""
    if run._find_token("", worded("IC asked", name=name)):
        run._condition(run._name_to_ask(name) == (name == "IFNDEF"))


def _if_zero(run: Assembler, holds: bool) -> None:
    run._condition((run._argument() == 0) == holds)


def _expunge(run: Assembler) -> None:
    """Forget all symbols but the pseudo-operators, I and Z."""
    if run._number == 1:
        run._expunged = True
        kept = [symbol for symbol in run.symbols.values() if symbol.kind in (MARK, PSEUDO)]
        run.symbols = {symbol.name[:SIGNIFICANT]: symbol for symbol in kept}


def _fix_table(run: Assembler) -> None:
    """Make all symbols permanent."""
    if run._number == 1:
        for symbol in run.symbols.values():
            symbol.permanent = True


def _fix_reference(run: Assembler) -> None:
    """`FIXMRI NAME=expression`: define a memory reference."""
    missing = worded("IC FIXMRI")
    if run._find_token("", missing, False):
        name, start, end = run._token[:SIGNIFICANT], run._start, run._end
        run._look_up()
        if run._find_token("=", missing):
            run._assign(name, REFERENCE, start, end)


def _pause(run: Assembler) -> None:
    """DEC's reads no more of the file; here it goes on."""
    if run._exact:
        run._index = len(run._lines)
        run._first = "\n"
        run._token = ""
        run._blank = False
    else:
        tape = run._lines[run._index].tape
        if [line for line in run._lines[run._index + 1 :] if line.tape == tape and line.text.strip(" \t$")]:
            run._note("PN48", run._begun)


def _eject(run: Assembler) -> None:
    """Begin a page of the listing, with a title, to the next `;` or comment."""
    while run._first not in "\n;":
        run._skip_token()
        run._pass_blank()


def _text(run: Assembler) -> None:
    run._pack_text()


def _list_or_not(run: Assembler) -> None:
    if run._has_argument():
        run._argument()


def _block(run: Assembler) -> None:
    """Punch a block number, for DEC's typesetting; its first frame counts even after NOPUNCH."""
    value = run._argument()
    run._checksum += 0o300 + (value >> 6)
    run._note("PN56", run._begun)
    run._put(BLOCK, value)


_ROUTINES: dict[str, Callable[[Assembler], None]] = {
    "DECIMAL": lambda run: _radix(run, 10),
    "DEVICE": _device,
    "DTORG": _block,
    "EJECT": _eject,
    "ENPUNCH": lambda run: _punching(run, True),
    "EXPUNGE": _expunge,
    "FIELD": _field,
    "FILENAME": _filename,
    "FIXMRI": _fix_reference,
    "FIXTAB": _fix_table,
    "IFDEF": lambda run: _if_defined(run, "IFDEF"),
    "IFNDEF": lambda run: _if_defined(run, "IFNDEF"),
    "IFNZRO": lambda run: _if_zero(run, False),
    "IFZERO": lambda run: _if_zero(run, True),
    "NOPUNCH": lambda run: _punching(run, False),
    "OCTAL": lambda run: _radix(run, 8),
    "PAGE": _page,
    "PAUSE": _pause,
    "RELOC": _relocate,
    "TEXT": _text,
    "XLIST": _list_or_not,
    "ZBLOCK": _zeros,
}
_ROUTINE_OF = {name: _ROUTINES[name] for name in symbols8.HANDLERS}  # each has one
