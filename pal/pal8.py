"""PAL8: the dialect of DEC's later assemblers, with literals, links, page operators and conditions.

    pass 1    defines the symbols
    pass 2    writes the words, with the final values

A line is read token by token (`pal.source.tokens`). A statement is an origin, a tag, a definition, a
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
from pal.notes import RESERVED, TOO_LARGE, Mention, Note
from pal.punch import BLOCK
from pal.source import Line, tokens
from pal.symbols import SIGNIFICANT
from tapes.binary import FIELD, ORIGIN, WORD

_MASK = 0o7777
_OPERATORS = frozenset("+-!&^%")
_ENDS = frozenset(["", ";", ")", "]", ">", "<"])
_CELLS = 34  # of DEC's push-down list
_CELLS_OF_EXPRESSION, _CELLS_OF_REFERENCE, _CELLS_OF_LITERAL, _CELLS_OF_EQUALS = 1, 2, 4, 6
_LEAST_IN_PAGE, _LEAST_IN_ZERO = 0o100, 0o20  # DEC has no room for literals below
_LINE = 80  # characters of a line that DEC's keeps

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


class Assembler:
    """One run of PAL8 over the lines of a source: `run`, pass 1 and then pass 2.

    symbols     {name: Symbol}
    written     the words, in the order of the source; `output`, what is punched
    places      (line, first column, the one after) of each statement and of what is pointed at
    complaints  DEC's messages of both passes, in order; `notes`, what is otherwise in DEC's or in palbart
    mentions    the symbols where they stand
    ended       the line of the `$`; `fatal`, whether PAL8 went no further
    """

    def __init__(self, lines: list[Line], wipe: bool = False, exact: bool = False) -> None:
        self._lines = lines
        self._texts = [line.text[:_LINE] if exact else line.text for line in lines]
        self._read = [tokens(text, 0, not exact) for text in self._texts]
        self._wipe = wipe
        self._exact = exact
        self.symbols = _permanent()
        self.written: list[Written] = []
        self.output: Output = []
        self.places: list[tuple[int, int, int]] = []
        self.complaints: list[Complaint] = []
        self.notes: list[Note] = []
        self.mentions: list[Mention] = []
        self.ended = len(lines)
        self.fatal = False
        self._tag = Symbol("", PLAIN, 0, False)
        self._last = 0
        self._is_undefined = False
        self._offset = 0  # from where a word runs to where it is loaded
        self._next_offset = 0
        self._skips_origin = False
        self._expunged = False
        self._routine = self._routines()
        if self._routine.keys() != symbols8.HANDLERS.keys():
            raise ValueError("a pseudo-operator of symbols8 has no routine, or a routine no pseudo-operator")

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
        text = self._texts[self._index]
        self._tokens = tokens(text, column, not self._exact) if column else self._read[self._index]
        self._next = 0
        self._end = column
        self._advance()

    def _advance(self) -> None:
        """Take the next token; `_before` is the column after the one that was taken before it."""
        self._before = self._end
        at = self._next
        blank = self._tokens[at]
        token = self._tokens[at + 1]
        self._start = self._end + len(blank)
        self._end = self._start + len(token)
        self._token = token
        self._next = min(at + 2, len(self._tokens) - 2)
        self._blank = blank != ""
        if not self._blank and token[:1] == "/":
            self._pass_comment()
        elif token == "" and self._end < len(self._texts[self._index]):
            self._go_to(self._end)  # the tokens were those of a part of the line

    def _pass_blank(self) -> None:
        self._blank = False
        if self._token[:1] == "/":
            self._pass_comment()

    def _pass_comment(self) -> None:
        """Go to the line's end; within a condition `<` and `>` count in a comment too."""
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

    def _say(self, code: str, about: str, advice: str, start: int, end: int) -> None:
        """Type a message of DEC's; of several at one statement we speak of the first."""
        late = code in ("IE", "PE", "ZE")
        if late and self._number == 1:
            return
        location = f"{self._location:04o}"
        if self._tagged:
            distance = self._location - self._tagged_at & _MASK
            location = f"{self._tagged}+{distance:04o}" if distance else self._tagged
        if code == "IC":
            if self._dropped:
                about = ""
            self._dropped = True
        at = self._keep(start, max(end, start + 1))
        self.complaints.append(Complaint(code, location, self._number, at, about, advice))

    def _die(self, code: str, about: str, advice: str, start: int, end: int) -> None:
        self._say(code, about, advice, start, end)
        raise Fatal

    def _note(self, code: str, message: str, advice: str, start: int, end: int) -> None:
        if self._number == 2:
            self.notes.append(Note(code, self._keep(start, max(end, start + 1)), message, advice))

    def _drop(self) -> None:
        """Pass over a token that cannot stand here: IC for each of its characters."""
        token = self._token
        about, advice = self._illegal(token)
        length = 1 if token[:1] == '"' else len(token)
        for _ in range(length):
            self._say("IC", about, advice, self._start, self._end)
        if token[:1] == '"' and len(token) > 1:
            self._split_quoted()
        else:
            self._advance()

    def _split_quoted(self) -> None:
        """Take the character after a `"` that was passed over for what it is by itself."""
        self._start += 1
        self._before = self._start
        self._token = self._texts[self._index][self._start : self._end]
        if not self._exact:
            self._token = self._token.upper()
        if self._token in ("\t", " "):
            self._advance()
            self._blank = True
        elif self._token == "/":
            self._pass_comment()
            self._end = len(self._texts[self._index])
            self._tokens = ["", "", ""]
            self._next = 0
        elif _is_letter(self._token):
            while self._tokens[self._next] == "" and self._tokens[self._next + 1][:1].isalnum():
                self._token += self._tokens[self._next + 1]
                self._end += len(self._tokens[self._next + 1])
                self._next += 2

    def _illegal(self, token: str) -> tuple[str, str]:
        """Return message and advice for a token that cannot stand where it does."""
        if self._slips:
            return "", ""
        start = self._start
        text = self._texts[self._index]
        if token == "\xa0":
            return "a no-break space, which is no blank", "write a blank"
        if token[0].isalnum():
            if self._before == start and text[start - 1 : start].isdigit() and not token[0].isdigit():
                number = text[:start].rstrip("0123456789")
                word = text[len(number) : self._end]
                if text[self._end : self._end + 1] == ",":
                    return f"{word} is no tag", "a tag begins with a letter"
                return f"the letter {token[0]} in the number {word}", "a symbol begins with a letter"
            if self._tag.kind == REFERENCE:
                return f"no operator before {token}", "a memory reference comes first in its word"
            return f"{token} cannot stand here", "an operator, or a blank, stands between two terms"
        if token in _OPERATORS:
            if start != self._before:
                return f"{token} after a blank, which is an operator itself (OR)", f"leave no blank beside {token}"
            return f"{token} after another operator", "one operator stands between two terms"
        if token == "*":
            return "* multiplies nothing: it sets the origin at the beginning of a statement", "^ multiplies"
        if token in (")", "]"):
            return f"{token} closes nothing", f"take the {token} away"
        if token == ">":
            return "> closes no condition", "take the > away"
        if token == ",":
            return ", not directly after a tag", "write one comma, directly after the tag"
        if token == "=":
            return "= not directly after a symbol", "write the symbol, and = without a blank"
        if token == ":":
            return "illegal character :", "a tag ends with a comma"
        return f"{token[:1]} cannot stand here", "DEC's PAL8 passes over it"

    # Statements

    def _line(self) -> bool:
        """Assemble the line; return whether `$` ended the program."""
        begins = True
        while True:
            if begins:
                self._dropped = self._slips = False
            if self._blank:
                self._pass_blank()
            if self._token == "$":
                return True
            if self._token not in ("", ";", ">"):
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
            if self._token == "":
                return False
            if self._token == ";":
                self._advance()
                return True
            if self._token == ">" and self._level:
                self._level -= 1
                self._advance()
            else:
                self._drop()

    def _statement(self) -> bool:
        """Assemble a statement; return whether another may follow directly: after a tag, a condition."""
        self._names: list[str] = []
        self._link = False
        self._named = -1  # the column where a word begins
        start = self._start
        if self._token == "*":
            self._advance()
            self._pass_blank()
            self._set_location(self._expression(False, True), False)
            return False
        if not _is_letter(self._token[:1]):
            self._word(False, start)
            return False
        name = self._token[:SIGNIFICANT]
        found = self.symbols.get(name)
        if found is not None and found.kind == PSEUDO:
            level = self._level
            self._look_up()
            if found.name == "TEXT" and not self._exact:
                self._level = level  # what stands after TEXT is no comment
            return self._routine[found.name](start)
        end = self._end
        follows = self._tokens[self._next] + self._tokens[self._next + 1]
        if follows == ",":
            self._look_up()
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
        if below >= self._bottom[page]:
            self._meet_literals(page, below)
        if below >= self._top[page]:
            self._top[page] = below + 1
        if self._number == 2:
            address = self._field << 12 | self._location + self._offset & _MASK
            self._put_word(Written(address, value, at, self._names, False, self._link))
        self._location = self._location + 1 & _MASK
        if not self._location & ADDRESS:
            self._enter_page()

    def _meet_literals(self, page: int, below: int) -> None:
        """Give up the literals that stand below a word."""
        which = "this page" if page else "page zero"
        about = f"{which} has literals from {page << 7 | self._bottom[page]:04o}, and a word at {self._location:04o}"
        advice = "put fewer words on the page; if it is an overlay, --w forgets what was there before"
        self._bottom[page] = below + 1
        self._say("PE" if page else "ZE", about, advice, self._start, self._end)

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
            self._checksum += 0o300 + (value >> 6) + (value & 0o77)

    # Tags and definitions

    def _define_tag(self, name: str, start: int, end: int) -> None:
        """`NAME,`: define it as the location."""
        self._advance()
        self._mention(name, start, end, True)
        self._is_undefined = False
        symbol = self.symbols.get(name)
        if symbol is not None and not self._exact and symbol.kind in (PLAIN, REFERENCE) and not symbol.passed:
            message = f"{name} is a permanent symbol, {symbol.value:04o}, and becomes the source's"
            self.notes.append(
                Note(RESERVED, self._keep(start, end), message, "DEC's PAL8 keeps the old value (ID)")
            )
            symbol = None
        if symbol is None or symbol.kind == WEAK:
            symbol = Symbol(name, PLAIN, self._location, False)
            symbol.where = (self._index, start)
            self.symbols[name] = symbol
            self._tag = symbol
            self._last = self._location
        elif symbol.value != self._location:
            self._say("ID", *self._redefined(symbol, start), start, end)
            return
        symbol.passed = self._number
        self._tagged = name
        self._tagged_at = self._location

    def _redefined(self, symbol: Symbol, start: int) -> tuple[str, str]:
        """Return what to say of a tag that has another value."""
        name = symbol.name
        if symbol.kind == MARK:
            return f"{name} is no tag: it marks a memory reference", "give the tag another name"
        if symbol.where == (self._index, start):
            message = f"{name} is {symbol.value:04o} from pass 1, and stands at {self._location:04o} in pass 2"
            return message, "something before it depends on a symbol that is defined after it; define that first"
        return f"duplicate tag: {name} is {symbol.value:04o} already", "each tag has one place, use another name"

    def _assign(self, name: str, kind: int, start: int, end: int) -> None:
        """`NAME=expression`, the symbol looked up already; `kind` is REFERENCE after FIXMRI."""
        self._advance()
        self._mention(name, start, end, True)
        is_undefined = self._is_undefined
        self._push(_CELLS_OF_EQUALS, start, end)
        self._pass_blank()
        self._named = -1
        value = self._expression(False, True)
        self._stack -= _CELLS_OF_EQUALS
        self._is_undefined = is_undefined
        if self._undefined:
            about = f"{name} has no value, because what follows its = is undefined"
            self._say("IE", about, "define that first", start, end)
            return
        self._is_undefined = False
        symbol = self.symbols.get(name)
        if symbol is None or symbol.kind == WEAK:
            symbol = self.symbols[name] = Symbol(name, kind, value, False)
        elif symbol.value != value:
            if symbol.permanent:
                about = f"{name} is a permanent symbol, {symbol.value:04o}, and is {value:04o} from here on"
                self._say("RD", about, "use another name", start, end)
            elif symbol.passed == self._number:
                message = f"{name} was {symbol.value:04o}, and is {value:04o} from here on"
                self._note("PN41", message, "a use before its first definition sees the last value", start, end)
        symbol.value = value
        symbol.passed = self._number
        if symbol.kind in (PLAIN, REFERENCE):
            symbol.kind = kind
        self._tag = symbol
        self._last = value

    # Expressions

    def _push(self, cells: int, start: int, end: int) -> None:
        self._stack += cells
        if self._stack > _CELLS:
            advice = "DEC's PAL8 takes six literals in each other"
            self._die("BE", "too many literals within literals", advice, start, end)

    def _expression(self, found: bool, may_refer: bool) -> int:
        """Return the value of an expression; `_undefined` is not 0 if something in it is undefined.

        Its first symbol may be looked up already: `found`. It may be a memory reference.
        """
        self._push(_CELLS_OF_EXPRESSION, self._start, self._end)
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
            if self._token in ("+", "-"):
                self._take_operator(self._token)
                self._advance()
            goes_on = self._term()
        while goes_on and self._goes_on(begun):
            goes_on = self._term()
        self._stack -= _CELLS_OF_EXPRESSION
        return self._value

    def _goes_on(self, begun: int) -> bool:
        """Take the operator after a term; return whether there is one."""
        while True:
            token = self._token
            if self._blank:
                self._take_operator(" ")
                self._pass_blank()
                return True
            if token in _ENDS:
                self._end_expression(begun)
                return False
            if token in _OPERATORS:
                self._take_operator(token)
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
            message = f"this is {self._value:04o}; palbart, where a blank comes last, makes {self._ored | self._group:04o}"
            self._note("PN42", message, "put a blank after no other operator", begun, self._before)

    def _term(self) -> bool:
        """Take a term; return whether the expression may go on after it."""
        while True:
            token = self._token
            first = token[:1]
            if self._blank:
                about = "a blank after an operator; a blank is one itself (OR)"
                self._say("IC", about, "leave no blank", self._start - 1, self._start)
                self._pass_blank()
            elif _is_letter(first):
                self._mention(token[:SIGNIFICANT], self._start, self._end, False)
                self._look_up()
                return self._take_symbol()
            elif first.isdigit():
                self._last = self._figures(token)
                self._advance()
                return self._combine()
            elif token == ".":
                self._last = self._location
                self._advance()
                return self._combine()
            elif first == '"':
                return self._take_quoted(token)
            elif token in ("(", "["):
                return self._take_literal(token)
            elif token not in _ENDS:
                self._drop()
            elif self._operator == " ":
                self._end_expression(self._start)
                return False
            else:
                about = "something is missing here"
                self._say("IC", about, "write a symbol, a number, or a literal", self._before, self._end)
                return self._take_symbol()

    def _take_quoted(self, token: str) -> bool:
        if len(token) == 1:
            self._say("IC", 'no character after "', 'write it directly after, as in "A', self._start, self._end)
            self._advance()
            self._end_expression(self._start)
            return False
        character = self._texts[self._index][self._start + 1]
        if not character.isascii():
            self._say("IC", f"the Teletype has no {character}", "write another", self._start, self._end)
            character = "?"
        if character == "\t":
            self._note("PN43", 'a TAB after " is 0211; palbart makes 0240', "write 211", self._start, self._end)
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
            self._note("PN45", "division by 0 makes 0; palbart crashes", "", self._start, self._end)
        elif (value | last) & 0o4000:
            message = f"{value:04o} divided by {last:04o} is {quotient:04o}, without signs"
            self._note("PN45", message, "palbart divides with signs", self._start, self._end)
        return quotient

    def _take_symbol(self) -> bool:
        """Take the symbol looked up last for a term; return whether the expression may go on after it."""
        tag = self._tag
        self._names.append(tag.name)
        if tag.kind == PSEUDO:
            about = f"the pseudo-operator {tag.name} within an expression"
            self._say("IP", about, "a pseudo-operator begins its statement", self._looked_up, self._before)
        elif tag.kind == WEAK:
            message = f"{tag.name}, {tag.value:04o}, is palbart's; in DEC's PAL8 it is undefined (US)"
            self._note("PN47", message, f"define it: {tag.name}={tag.value:04o}", self._looked_up, self._before)
        if self._is_undefined:
            self._is_undefined = False
            self._undefined += 1
            if self._number == 2 or not self._undefined:
                self._say_undefined(tag.name)
        refers = tag.kind == REFERENCE or (tag.kind == WEAK and tag.name in symbols8.PALBARTS_REFERENCES)
        if not (refers and self._blank):
            return self._combine()
        self._pass_blank()
        if self._token in ("", ";") or not self._may_refer:
            return self._combine()
        return self._refer(self._last)

    def _say_undefined(self, name: str) -> None:
        """Say that a symbol is undefined: one that begins the line may be a tag."""
        text = self._texts[self._index]
        start = self._looked_up
        advice = symbols8.ELSEWHERE.get(name) or f"define it with {name}, or {name}="
        follows = text[self._before : self._before + 1] in (" ", "\t")
        if start == 0 and self._named == 0 and follows and self._token not in ("", ";", ">"):
            advice = f"if it is a tag, write {name},"
            self._slips = True
        self._say("US", f"undefined: {name}", advice, start, self._before)

    def _figures(self, token: str) -> int:
        """Return the value of a number; an 8 or 9 in octal is passed over."""
        if self._radix == 8 and ("8" in token or "9" in token):
            good = ""
            for figure in token:
                if figure < "8":
                    good += figure
                else:
                    about = f"the digit {figure} in the octal number {token}"
                    self._say("IC", about, "after DECIMAL it is one", self._start, self._end)
            token = good or "0"
        value = int(token[max(len(token) - 12, 0) :], self._radix)
        if value > _MASK or len(token) > 12:
            message = f"{token} does not fit into twelve bits: it is {value & _MASK:04o}"
            self._note(TOO_LARGE, message, f"write it so: {value & _MASK:o} octal", self._start, self._end)
        return value & _MASK

    def _refer(self, operation: int) -> bool:
        """Take the address of a memory reference, and put both together; return False: no more follows."""
        start = self._start
        self._push(_CELLS_OF_REFERENCE, start, self._end)
        marks = 0
        found = False
        while _is_letter(self._token[:1]) and not found:
            self._mention(self._token[:SIGNIFICANT], self._start, self._end, False)
            self._look_up()
            if self._tag.kind == MARK:
                self._names.append(self._tag.name)
                marks = marks + (self._last or 1) & _MASK
                self._pass_blank()
            else:
                found = True
        sign = self._token
        number = self._tokens[self._next + 1][:1].isdigit()
        address = self._expression(found, False)
        self._stack -= _CELLS_OF_REFERENCE
        if sign == "-" and number and address & 0o7000 == 0o7000:
            message = f"this refers to the word at {address:04o}"
            self._note("PN51", message, "for a number write a literal, as in TAD (-5", start, self._before)
        where = ""
        if address & PAGE:
            if (address ^ self._location) & PAGE:
                where = f"{address:04o} is not on the page of {self._location:04o}"
                address = self._find(address, self._location >> 7, start)
                self._link = True
                operation = self._indirect(operation, where, start)
            operation = operation + CURRENT_PAGE & _MASK
            if marks & 0o77:
                about = f"Z with an address that is not on page zero, {address:04o}"
                self._say("IZ", about, "leave out Z", start, self._before)
        if marks & 0o7700:
            operation = self._indirect(operation, where, start)
        self._last = operation
        self._value = (address & ADDRESS) + operation & _MASK
        return False

    def _indirect(self, operation: int, where: str, start: int) -> int:
        """Return a memory reference with I, which it may not have twice: a link has it."""
        if operation & INDIRECT:
            about = f"{where}, and a link cannot be indirect" if where else "indirect twice"
            advice = "put a pointer on this page or on page zero" if where else "write one I"
            self._say("II", about, advice, start, self._before)
        return operation | INDIRECT

    # Literals

    def _take_literal(self, opening: str) -> bool:
        """Take `(e)`, a literal on this page, or `[e]`, one on page zero; return True."""
        start = self._start
        self._advance()
        self._pass_blank()
        self._push(_CELLS_OF_LITERAL, start, self._end)
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
        if self._token in (")", "]"):
            self._advance()
        return self._combine()

    def _look_for_division(self, start: int) -> None:
        """Note a comment that was meant for a division: `(6/2)`."""
        text = self._texts[self._index][self._before :]
        if self._token == "" and text[:1] == "/" and text[1:2].isalnum() and ")" in text:
            self._note("PN52", "a / begins a comment here", "% divides", start, self._before + 1)

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
            which = "this page" if page else "page zero"
            message = f"no room for another literal on {which}, which has words up to {page << 7 | self._top[page] - 1 & _MASK:04o}"
            if place < least:
                message = f"more than {0o200 - least} literals on {which}"
            advice = "use [ for some, or another page; if it is an overlay, --w forgets what was there before"
            self._say("PE" if page else "ZE", message, advice, start, self._before)
        else:
            self._bottom[page] = place
            pool[value] = place
            if self._pool_end < 0o200 and page and value in self._before_here[page]:
                message = f"the literal {value:04o} is stored again: the source has left this page before"
                self._note("PN46", message, "palbart finds it; keep a page in one piece", start, self._before)
        if self._number == 2:
            words[place] = (value, self._keep(start, self._before))
        else:
            words[place] = (value, 0)
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
            about = "the origin is undefined, and taken for 0000"
            self._say("UO", about, "define it before", self._before, self._before + 1)
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

    # Pseudo-operators

    def _routines(self) -> dict[str, Callable[[int], bool]]:
        """Return {pseudo-operator: what does it}: given the column where it begins, whether it is a condition."""
        return {
            "DECIMAL": lambda _: self._set_radix(10),
            "OCTAL": lambda _: self._set_radix(8),
            "NOPUNCH": lambda _: self._punch(False),
            "ENPUNCH": lambda _: self._punch(True),
            "PAGE": lambda start: self._page(start),
            "FIELD": lambda _: self._to_field(),
            "RELOC": lambda _: self._relocate(),
            "ZBLOCK": lambda start: self._zeros(start),
            "TEXT": lambda start: self._text(start),
            "DEVICE": lambda start: self._device(start),
            "FILENAME": lambda start: self._filename(start),
            "IFDEF": lambda start: self._if_defined("IFDEF", start),
            "IFNDEF": lambda start: self._if_defined("IFNDEF", start),
            "IFZERO": lambda start: self._if_zero("IFZERO", start),
            "IFNZRO": lambda start: self._if_zero("IFNZRO", start),
            "EXPUNGE": lambda _: self._expunge(),
            "FIXTAB": lambda _: self._fix_table(),
            "FIXMRI": lambda _: self._fix_reference(),
            "PAUSE": lambda start: self._pause(start),
            "EJECT": lambda _: self._eject(),
            "XLIST": lambda _: self._list_or_not(),
            "DTORG": lambda _: self._block(),
        }

    def _argument(self) -> int:
        """Return the argument of a pseudo-operator."""
        self._pass_blank()
        self._named = -1
        return self._expression(False, True)

    def _has_argument(self) -> bool:
        self._pass_blank()
        return self._token not in ("", ";", ">")

    def _set_radix(self, radix: int) -> bool:
        self._radix = radix
        return False

    def _punch(self, punching: bool) -> bool:
        self._punching = punching
        return False

    def _expunge(self) -> bool:
        """Forget all symbols but the pseudo-operators, I and Z."""
        if self._number == 1:
            self._expunged = True
            kept = [symbol for symbol in self.symbols.values() if symbol.kind in (MARK, PSEUDO)]
            self.symbols = {symbol.name[:SIGNIFICANT]: symbol for symbol in kept}
        return False

    def _fix_table(self) -> bool:
        """Make all symbols permanent."""
        if self._number == 1:
            for symbol in self.symbols.values():
                symbol.permanent = True
        return False

    def _eject(self) -> bool:
        """A new page of the listing, with a title: to the next `;` or comment."""
        while self._token not in ("", ";"):
            if self._token[:1] == '"' and len(self._token) > 1:
                self._split_quoted()
            else:
                self._advance()
            self._pass_blank()
        return False

    def _list_or_not(self) -> bool:
        if self._has_argument():
            self._argument()
        return False

    def _page(self, start: int) -> bool:
        """Go to page n, or to the next one."""
        self._put_out_page()
        if not self._has_argument():
            self._begin_page(self._location + ADDRESS & PAGE)
            return False
        page = self._argument()
        if page > PAGE >> 7:
            message = f"there is no page {page:o}: this is page {page & 0o37:o}"
            self._note("PN53", message, "a field has pages 0 to 37; FIELD goes to another", start, self._before)
        self._begin_page(page << 7 & PAGE)
        return False

    def _to_field(self) -> bool:
        self._put_out_page()
        self._put_out_zero()
        self._field = self._argument() & 7
        self._put(FIELD, self._field)
        self._clear_pools()
        self._begin_page(START)
        return False

    def _zeros(self, start: int) -> bool:
        count = self._argument()
        at = self._keep(start, self._before)
        for _ in range(count):
            self._write(0, at)
        return False

    def _relocate(self) -> bool:
        """Assemble what follows for where it runs, or again for where it is loaded."""
        if self._has_argument():
            location = self._argument()
            self._next_offset = self._location + self._offset - location & _MASK
        else:
            location = self._location + self._offset & _MASK
            self._next_offset = self._undefined = 0
        self._set_location(location, True)
        return False

    def _block(self) -> bool:
        """DTORG, of DEC's typesetting: a block number on the tape, of which the first frame counts too."""
        value = self._argument()
        self._put(BLOCK, value)
        return False

    def _pause(self, start: int) -> bool:
        """PAUSE: DEC's reads no more of the file; here it goes on."""
        if self._exact:
            self._index = len(self._lines)
            self._token = ""
            self._blank = False
        elif self._index + 1 < len(self._lines) and self._lines[self._index + 1].tape == self._lines[self._index].tape:
            self._note("PN48", "DEC's PAL8 ends the file at PAUSE; here it goes on", "", start, self._before)
        return False

    def _fix_reference(self) -> bool:
        """`FIXMRI NAME=expression`: define a memory reference."""
        self._pass_blank()
        while not _is_letter(self._token[:1]):
            if not self._drop_to("FIXMRI without a definition", "write it so: FIXMRI NAME=5000"):
                return False
        name, start, end = self._token[:SIGNIFICANT], self._start, self._end
        self._look_up()
        self._pass_blank()
        while self._token != "=":
            if not self._drop_to("FIXMRI without a definition", "write it so: FIXMRI NAME=5000"):
                return False
        self._assign(name, REFERENCE, start, end)
        return False

    def _drop_to(self, about: str, advice: str) -> bool:
        """Pass over a character that is not what a pseudo-operator looks for; return False at the end."""
        self._say("IC", about, advice, self._start, self._end)
        if self._token in ("", ";"):
            return False
        for _ in range(len(self._token) - 1):
            if self._token[:1] != '"':
                self._say("IC", about, advice, self._start, self._end)
        if self._token[:1] == '"' and len(self._token) > 1:
            self._split_quoted()
        else:
            self._advance()
        self._pass_blank()
        return True

    # Conditions

    def _if_zero(self, name: str, start: int) -> bool:
        """IFZERO and IFNZRO; return False where it is no condition."""
        value = self._argument()
        return self._condition((value == 0) == (name == "IFZERO"), start)

    def _if_defined(self, name: str, start: int) -> bool:
        """IFDEF and IFNDEF: in pass 2 what is defined below is defined; return False where it is no condition."""
        self._pass_blank()
        while not _is_letter(self._token[:1]):
            if not self._drop_to(f"{name} without a symbol", f"write it so: {name} A <statements>"):
                return False
        asked, first, end = self._token[:SIGNIFICANT], self._start, self._end
        self._mention(asked, first, end, False)
        is_undefined = self._is_undefined
        self._look_up()
        tag = self._tag
        holds = self._is_undefined or tag.kind == WEAK
        self._is_undefined = is_undefined
        if tag.kind == PSEUDO:
            about = f"{tag.name} is a pseudo-operator, and defined"
            self._say("IP", about, "ask for another symbol", first, end)
        elif tag.passed == 1 and self._number == 2 and f"{asked}=" not in self._texts[self._index].upper():
            message = f"{asked}, which is defined below, is defined here in pass 2"
            self._note("PN49", message, "palbart takes it for undefined; define it before", first, end)
        self._pass_blank()
        return self._condition(holds == (name == "IFNDEF"), start)

    def _condition(self, holds: bool, start: int) -> bool:
        """Take what stands after `<`, or pass over it; return False where there is no `<`."""
        while self._token != "<":
            if not self._drop_to("< is missing after the condition", "it stands on the same line"):
                return False
        if holds:
            self._advance()
            self._level += 1
        else:
            self._pass_over(start)
        return True

    def _pass_over(self, start: int) -> None:
        """Pass over a condition that does not hold, from its `<` to its `>`, whatever they stand in."""
        began, opened = self._index, self._start
        outside = self._level
        text = self._texts[self._index]
        column = self._end
        if text[column : column + 1] == "/":
            self._level = self._level_after(column)
            column = len(text)
        self._level += 1
        while True:
            while column < len(text) and ("<" in text or ">" in text):
                character = text[column]
                column += 1
                if character == "<":
                    self._level += 1
                elif character == ">":
                    self._level -= 1
                elif character == "/":
                    self._level = self._level_after(column)
                    column = len(text)
                if self._level <= outside and character in ("/", ">"):
                    self._go_to(column)
                    return
            if self._index + 1 == len(self._lines):
                self._index = began
                advice = "write > after what is left out"
                self._die("PH", "a condition without its end", advice, start, opened + 1)
            self._index += 1
            text = self._texts[self._index]
            column = 0
            if text[:1] == "$":
                self._note("PN50", "this $ is left out by a condition", "palbart ends the condition here", 0, 1)

    # Texts

    def _text(self, start: int) -> bool:
        """TEXT: two characters a word, six bits each, and 00 at the end."""
        text = self._texts[self._index]
        column = self._before
        if self._exact and not self._blank and self._token in ("", ";"):
            self._write(0, self._keep(start, column))
            return False
        if not self._exact and text[column : column + 1] in ("/", ";"):
            message = f"DEC's PAL8 takes this {text[column]} for the end of the statement"
            self._note("PN44", message, "leave a blank after TEXT", start, column + 1)
        last = "_" if self._exact else "~"
        while column < len(text) and not "!" <= text[column] <= last:
            column += 1
        first = column
        if column == len(text):
            self._note("PN54", "TEXT without a text is one word of 0", "write it so: TEXT /LETTERS/", start, column)
        delimiter = text[column : column + 1]
        codes: list[int] = []
        at = self._keep(start, len(text))
        column += 1
        while column < len(text) and text[column] != delimiter:
            character = text[column]
            if " " <= character <= last:
                codes.append(ord(character) & 0o77)
                if len(codes) == 2:
                    self._write(codes[0] << 6 | codes[1], at)
                    codes = []
            else:
                about = "a character that TEXT cannot have, as a TAB is"
                self._say("IC", about, "write a blank, or the code as a number", column, column + 1)
            column += 1
        if first < len(text) <= column:
            message = f"{delimiter} does not stand again: the text goes to the end of the line"
            self._note("PN54", message, "a text ends with the character it begins with", start, len(text))
        self._write(codes[0] << 6 if codes else 0, at)
        self._go_to(min(column + 1, len(text)))
        return False

    def _device(self, start: int) -> bool:
        """DEVICE: a name of four characters."""
        self._pass_blank()
        self._pack(4, start)
        return False

    def _filename(self, start: int) -> bool:
        """FILENAME: six characters, and two after the point."""
        self._pass_blank()
        self._pack(6, start)
        if self._token == "." and not self._blank:
            self._advance()
        self._pack(2, start)
        return False

    def _pack(self, room: int, start: int) -> None:
        """Pack letters and digits, two a word, and 00 for those that are not there."""
        characters = ""
        while not self._blank and self._token[:1].isalnum():
            characters += self._token
            self._advance()
        if not characters and room > 2:
            self._note("PN54", "no name: the words are 0", "write it so: DEVICE SYS", start, self._before)
        characters = characters[:room].ljust(room, "\0")
        at = self._keep(start, self._before)
        for first in range(0, room, 2):
            self._write((ord(characters[first]) & 0o77) << 6 | ord(characters[first + 1]) & 0o77, at)
