"""PAL8: the dialect of DEC's later assemblers, with literals, links, page operators and conditions.

    pass 1    defines the symbols
    pass 2    writes the words, with the final values; errors and notes are of this pass

A line is read token by token (`pal.source.tokens`). A statement is an origin, tags, a definition, a
pseudo-operator, or expressions that make a word:

    expressions   expression, blank, expression ...    ORed; after a memory reference: the address
    expression    term, operator, term ...             + - ! & ^ %, from left to right, in sixteen bits
    term          symbol, number, ., "c, (expressions), [expressions]

The literals of a page stand at its end, from 0177 downward: a value stands there once, a link (the address
of another page) like any other. They are put out when the source goes to another page, those of page zero
at FIELD and at the end.

The words are those of palbart, to the last one; `pal.notes` says where DEC's PAL8 makes others. Where it is
silent at what is no program, this is not: division by 0, a name of a pseudo-operator within an expression, a
condition without its end.

Not emulated: RIMPUNCH, BINPUNCH and SEGMNT, palbart's alone; the break of a line after 130 characters.

Sources: palbart 2.13 and DEC's PAL8 V10D under OS/8, each run on several hundred sources.
"""

from pal import symbols8
from pal.assembler import START, Output, Punched, Written
from pal.isa import ADDRESS, CURRENT_PAGE, INDIRECT, PAGE
from pal.notes import COLON, RESERVED, TOO_LARGE, Mention, Note
from pal.source import Line, tokens
from pal.symbols import SIGNIFICANT
from tapes.binary import FIELD, ORIGIN, WORD

_MASK = 0o7777
_OPERATORS = frozenset("+-!&^%")
_STOPS = frozenset(["", ";", ")", "]", "<"])
_KNOWN = frozenset('+-!&^%,=*.;$"()[]<')
_MISPLACED = {
    "": ("the expression is not complete", "write a symbol, a number, or a literal"),
    '"': ('no character after "', 'write it directly after, as in "A'),
    "=": ("= not directly after a symbol", "write the symbol, and = without a blank"),
    ",": (", not directly after a tag", "write the tag, and the comma without a blank"),
}
_LINKED = INDIRECT | CURRENT_PAGE
_MODES = ("DUBL", "FLTG")
_MOST_FIGURES = 15  # with the point; a number is less than 2^53

# What a symbol is.
UNKNOWN, USER, INSTRUCTION, REFERENCE, PSEUDO = 0, 1, 2, 3, 4


class Symbol:
    """A symbol: what it is, its value, and the pass that defined it last."""

    def __init__(self, name: str, kind: int, value: int) -> None:
        self.name = name
        self.kind = kind
        self.value = value
        self.passed = 0


class Pool:
    """The literals of a page, in the order in which they were first used, from 0177 downward.

    `places` are the statements that made them; `out`, how many of them have been put out.
    """

    def __init__(self) -> None:
        self.values: list[int] = []
        self.places: list[int] = []
        self.out = 0


def _permanent() -> dict[str, Symbol]:
    references = {**symbols8.REFERENCES, **symbols8.PALBARTS_REFERENCES}
    instructions = {**symbols8.INSTRUCTIONS, **symbols8.PALBARTS}
    pseudo_operators = symbols8.PSEUDO_OPERATORS + symbols8.PALBARTS_PSEUDO_OPERATORS
    return {
        **{name: Symbol(name, REFERENCE, value) for name, value in references.items()},
        **{name: Symbol(name, INSTRUCTION, value) for name, value in instructions.items()},
        **{name[:SIGNIFICANT]: Symbol(name, PSEUDO, 0) for name in pseudo_operators},
    }


def _signed(value: int) -> int:
    """Return a value as palbart keeps it between operators: sixteen bits with sign."""
    return (value + 0o100000 & 0o177777) - 0o100000


class Assembler:
    """One run of PAL8 over the lines of a source: `run` pass 1, then pass 2.

    symbols   {name: Symbol}
    written   the words, in the order of the source; `output`, what is punched
    places    (line, first column, the one after) of each statement, symbol or other thing that is pointed at
    problems  the errors; `notes`, what DEC's does otherwise
    mentions  the symbols where they stand
    """

    def __init__(self, lines: list[Line]) -> None:
        self._lines = lines
        self._read = [tokens(line.text) for line in lines]
        self.symbols = _permanent()
        self.written: list[Written] = []
        self.output: Output = []
        self.places: list[tuple[int, int, int]] = []
        self.problems: list[Note] = []
        self.notes: list[Note] = []
        self.mentions: list[Mention] = []
        self.ended = len(lines)

    def run(self, number: int) -> None:
        """Run pass `number`."""
        self._number = number
        self._location = START
        self._field = 0
        self._shift = 0  # what RELOC adds to the location
        self._radix = 8
        self._mode = ""  # DUBL or FLTG
        self._punching = True
        self._pools: dict[int, Pool] = {}
        self._loading = START  # where the loader stands, its field above the twelve bits
        self._checksum = 0
        self._index = -1
        self._put(ORIGIN, START)
        while self._index + 1 < len(self._lines):
            self._index += 1
            self._take_line(0)
            if self._token and self._line():
                self.ended = self._index
                break
        self._put_out(0)
        self._put(WORD, self._checksum & _MASK)

    def place_of_line(self, index: int) -> int:
        """Return the place of a whole line."""
        self._index = index
        return self._at(0, len(self._lines[index].text))

    # The tokens of the line

    def _take_line(self, column: int) -> None:
        """Go to `column` of the line."""
        line = self._lines[self._index]
        self._tokens = tokens(line.text, column) if column else self._read[self._index]
        self._next = 0
        self._end = column
        self._advance()

    def _advance(self) -> None:
        """Take the next token; `_before` is the column after the one that was taken before it."""
        self._before = self._end
        self._start = self._end + len(self._tokens[self._next])
        self._token = self._tokens[self._next + 1]
        self._end = self._start + len(self._token)
        self._next = min(self._next + 2, len(self._tokens) - 2)

    def _joined(self) -> str:
        """Return the token directly after this one, "" where a blank stands between."""
        return "" if self._tokens[self._next] else self._tokens[self._next + 1]

    def _at(self, start: int, end: int) -> int:
        """Keep a place, in pass 2; return its index."""
        if self._number == 2:
            self.places.append((self._index, start, end))
        return len(self.places) - 1

    def _mention(self, name: str, start: int, end: int, defined: bool) -> None:
        """Keep where a symbol stands, in pass 2."""
        if self._number == 2:
            self.mentions.append(Mention(name, self._at(start, end), defined))

    def _span(self) -> tuple[int, int]:
        """Return the columns of the token; of none, the column where it stands."""
        return self._start, max(self._end, self._start + 1)

    def _fail(self, code: str, message: str, advice: str, *span: int) -> int:
        """Note an error of syntax, and pass over the rest of the line; return 0, its value."""
        start, end = span or self._span()
        self._complain(code, message, advice, start, end)
        self._take_line(len(self._lines[self._index].text))
        return 0

    def _complain(self, code: str, message: str, advice: str, start: int, end: int) -> int:
        """Note an error, in pass 2; return 0."""
        if self._number == 2:
            self.problems.append(Note(code, self._at(start, end), message, advice))
        self._failed = True
        return 0

    def _note(self, code: str, message: str, advice: str, *span: int) -> None:
        if self._number == 2:
            start, end = span or self._span()
            self.notes.append(Note(code, self._at(start, end), message, advice))

    # Statements

    def _line(self) -> bool:
        """Assemble the line; return whether `$` ended the program."""
        while True:
            if self._token == "":
                return False
            if self._token == ";":
                self._advance()
            elif self._token == "$":
                return True
            else:
                self._statement()

    def _statement(self) -> None:
        token = self._token
        follows = self._joined()
        self._names: list[str] = []
        self._link = self._failed = False
        if not (token[0].isdigit() or token in ("+", "-")):
            self._mode = ""
        if follows == "," or (follows == ":" and token[0].isalpha()):
            self._tag()
        elif follows == "=":
            self._assign()
        elif token == "*":
            self._advance()
            self._origin()
        elif self._mode:
            self._number_of_words()
        else:
            symbol = self.symbols.get(token[:SIGNIFICANT])
            if symbol is not None and symbol.kind == PSEUDO:
                self._pseudo_operator(symbol.name)
            else:
                self._word()

    def _word(self) -> None:
        """Assemble the expressions of a word."""
        start = self._start
        value = self._expressions() & _MASK
        self._write(0 if self._failed else value, self._at(start, self._before))

    def _write(self, value: int, at: int) -> None:
        """Put a word where the location is."""
        if self._number == 2:
            address = self._field << 12 | self._location
            self._put_word(Written(address, value, at, self._names, False, self._link))
        self._location = self._location + 1 & _MASK

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
        if self._number == 1 or not (self._punching or kind == WORD):
            return
        self.output.append(Punched(kind, value))
        if kind == FIELD:
            self._loading = value << 12 | self._loading & _MASK
        elif kind == ORIGIN:
            self._loading = self._loading & ~_MASK | value
            self._checksum += 0o100 + (value >> 6) + (value & 0o77)

    def _tag(self) -> None:
        name, start, end = self._token[:SIGNIFICANT], self._start, self._end
        self._advance()
        if not name[0].isalpha():
            self._fail("IC", f"{name} is no tag", "a tag begins with a letter", start, end)
            return
        if self._token == ":":
            self._note(COLON, "a colon ends no tag", f"write a comma: {name},", start, end + 1)
            self._complain("IC", "illegal character :", "a tag ends with a comma", end, end + 1)
        self._advance()
        value = self._location + self._shift & _MASK
        symbol = self._define(name, start, end)
        old = symbol.value & _MASK
        if symbol.passed == self._number and old != value:
            advice = "each tag has one place, use another name"
            self._complain("ID", f"duplicate tag: {name} is {old:04o} already", advice, start, end)
            return
        if symbol.passed and old != value and self._number == 2:
            message = f"{name} is {old:04o} from pass 1, and stands at {value:04o} in pass 2"
            advice = "something before it depends on a symbol that is defined after it; define that first"
            self._complain("ID", message, advice, start, end)
        symbol.value = self._field << 12 | value
        symbol.passed = self._number

    def _define(self, name: str, start: int, end: int) -> Symbol:
        """Return the symbol `name`, which becomes one of the source's."""
        symbol = self.symbols.get(name)
        if symbol is None or symbol.kind not in (USER, UNKNOWN):
            if symbol is not None and self._number == 1:
                self._replaced(name, symbol, start, end)
            symbol = Symbol(name, USER, 0)
            self.symbols[name] = symbol
        symbol.kind = USER
        self._mention(name, start, end, True)
        return symbol

    def _replaced(self, name: str, symbol: Symbol, start: int, end: int) -> None:
        """Note that a permanent symbol is defined again; that is in pass 1."""
        message = f"{name} is a permanent symbol, {symbol.value:04o}, and becomes the source's"
        advice = "DEC's PAL8 keeps a tag's old value (ID) and warns of = (RD); use another name"
        self.places.append((self._index, start, end))
        self.notes.append(Note(RESERVED, len(self.places) - 1, message, advice))

    def _assign(self) -> None:
        """`NAME=expressions`."""
        name, start, end = self._token[:SIGNIFICANT], self._start, self._end
        self._advance()
        self._advance()
        if not name[0].isalpha():
            self._fail("IC", f"{name} is no symbol", "a symbol begins with a letter", start, end)
            return
        if self._token in ("", ";"):
            self._fail("IE", f"no value for {name}", "write an expression after =", start, end)
            return
        value = self._expressions() & _MASK
        if self._failed:
            value = 0
        known = self.symbols.get(name)
        if known is not None and known.kind == INSTRUCTION and known.value == value:
            self._mention(name, start, end, True)
            return
        symbol = self._define(name, start, end)
        if symbol.passed == self._number and symbol.value != value:
            message = f"{name} was {symbol.value & _MASK:04o}, and is {value:04o} from here on"
            self._note("PN41", message, "a use before its first definition sees the last value", start, end)
        symbol.value = value
        symbol.passed = self._number

    def _origin(self) -> None:
        """Set the location; the address is where RELOC says that it runs."""
        address = self._expressions()
        if self._failed:
            if self._number == 2:
                return
            address = 0
        location = address - self._shift & _MASK
        if (address ^ self._location) & PAGE:
            self._put_out(1)
        self._location = location
        self._put(ORIGIN, location)

    # Expressions

    def _expressions(self) -> int:
        """Return the value of expressions with blanks between them; after a memory reference, an address."""
        word, refers = self._expression()
        start = self._start
        addressed = False
        address = 0
        while self._token not in _STOPS:
            item, also = self._expression()
            if refers and also and not addressed:
                word |= item
            elif refers:
                addressed = True
                address |= item
            else:
                if also:
                    advice = "write the memory reference first"
                    self._note("PN42", "a memory reference within a word: DEC's PAL8 refuses it (IC)", advice)
                word |= item
        return self._refer(word, address & _MASK, start) if addressed else word

    def _refer(self, word: int, address: int, start: int) -> int:
        """Put the address into a memory reference, by a link where it is on another page."""
        if not address & PAGE:
            return word | address
        if (address ^ self._location + self._shift) & PAGE == 0:
            return word | CURRENT_PAGE | address & ADDRESS
        if word & INDIRECT:
            place = f"{self._location + self._shift & _MASK:04o}"
            message = f"{address:04o} is not on the page of {place}, and a link cannot be indirect"
            self._complain("II", message, "put a pointer on this page or on page zero", start, self._before)
            return word
        self._link = True
        return word | _LINKED | self._literal(self._location >> 7, address)

    def _expression(self) -> tuple[int, bool]:
        """Return the value of terms and operators, and whether the first term is a memory reference."""
        sign = self._token
        if sign in ("+", "-") and not self._takes_sign(sign):
            return self._fail("IC", f"no operand after {sign}", "write it directly after"), False
        value, refers = self._term()
        value = (-value if sign == "-" else value) & _MASK
        while self._token in _OPERATORS and self._start == self._before:
            operator = self._token
            self._advance()
            if self._start != self._before:
                self._note("PN43", f"a blank after {operator}: DEC's PAL8 refuses it (IC)", "leave no blank")
            operand, _ = self._term()
            value = _signed(self._operate(value, operator, operand))
        return value, refers

    def _takes_sign(self, sign: str) -> bool:
        """Take a sign at the beginning of an expression, unless a blank follows; DEC's drops one in an OR."""
        operand = self._joined()
        if not operand:
            return False
        last = self._tokens[max(self._next - 3, 0)] if self._start != self._before else ""
        symbol = self.symbols.get(last[:SIGNIFICANT])
        value = symbol is None or symbol.kind not in (PSEUDO, REFERENCE)
        if value and last[len(last) - 1 :].isalnum():
            message = f"this is an OR with {sign}{operand}; DEC's PAL8 drops the {sign} (IC)"
            self._note("PN44", message, f"leave no blank before {sign}, to add or subtract")
        self._advance()
        return True

    def _operate(self, value: int, operator: str, operand: int) -> int:
        if operator == "+":
            return value + operand
        if operator == "-":
            return value - operand
        if operator == "&":
            return value & operand
        if operator == "!":
            return value | operand
        if operator == "^":
            return value * operand
        return self._divide(value, operand)

    def _divide(self, value: int, operand: int) -> int:
        if not operand:
            advice = "palbart crashes here; DEC's PAL8 makes 0"
            return self._complain("DZ", "division by 0", advice, self._start, self._start + 1)
        quotient = abs(value) // abs(operand)
        if (value < 0) != (operand < 0):
            quotient = -quotient
        decs = (value & _MASK) // (operand & _MASK) if operand & _MASK else 0
        if decs != quotient & _MASK:
            message = f"this is {quotient & _MASK:04o}; DEC's PAL8, without signs, makes {decs:04o}"
            self._note("PN45", message, "divide numbers without sign, and below 10000")
        return quotient

    def _term(self) -> tuple[int, bool]:
        """Return the value of a term, and whether it is a memory reference."""
        token = self._token
        first = token[:1]
        if first.isalpha():
            return self._symbol(token[:SIGNIFICANT])
        if first.isdigit():
            value = self._figures(token)
        elif token == ".":
            value = self._location + self._shift
        elif first == '"' and len(token) > 1:
            character = self._lines[self._index].text[self._start + 1]
            if not character.isascii():
                message = f"the Teletype has no {character}"
                return self._fail("IC", message, "write another"), False
            value = ord(" " if character == "\t" else character) | 0o200
        elif token in ("(", "["):
            return self._literal_term(token), False
        else:
            return self._fail("IC", *self._illegal(token)), False
        self._end_term()
        return value, False

    def _end_term(self) -> None:
        """Take the next token; what is joined to a term is an operator or an end."""
        self._advance()
        joined = self._start == self._before
        if joined and self._token not in _STOPS and self._token not in _OPERATORS:
            self._fail("IC", *self._illegal(self._token))

    @staticmethod
    def _illegal(token: str) -> tuple[str, str]:
        """Return message and advice for a token that cannot stand where it does."""
        if token in _MISPLACED:
            return _MISPLACED[token]
        if token[0] in _KNOWN or token[0].isalnum():
            return f"{token} cannot stand here", "a blank or an operator stands between two terms"
        return f"illegal character {token}", "PAL8 has no such operator"

    def _symbol(self, name: str) -> tuple[int, bool]:
        symbol = self.symbols.get(name)
        start, end = self._start, self._end
        if symbol is None:
            symbol = self.symbols[name] = Symbol(name, UNKNOWN, 0)
        self._names.append(name)
        self._mention(name, start, end, False)
        self._end_term()
        if symbol.kind == PSEUDO:
            message = f"the pseudo-operator {symbol.name} within an expression"
            self._fail("IP", message, "a pseudo-operator begins its statement", start, end)
        elif symbol.kind == UNKNOWN:
            self._undefined(name, start, end)
        return symbol.value, symbol.kind == REFERENCE

    def _undefined(self, name: str, start: int, end: int) -> None:
        """Take an undefined symbol for 0, and with it the expressions that it stands in."""
        advice = symbols8.ELSEWHERE.get(name) or f"define it with {name}, or {name}="
        self._complain("US", f"undefined: {name}", advice, start, end)

    def _figures(self, token: str) -> int:
        value = 0
        large = False
        for figure in token:
            if not figure.isdigit():
                message = f"the letter {figure} in the number {token}"
                return self._fail("IC", message, "a symbol begins with a letter")
            if int(figure) >= self._radix:
                message = f"the digit {figure} in the octal number {token}"
                return self._fail("IC", message, "after DECIMAL it is one")
            value = value * self._radix + int(figure)
            large = large or value > _MASK
            value &= _MASK
        if large:
            message = f"{token} does not fit into twelve bits: it is {value:04o}"
            self._note(TOO_LARGE, message, f"write it so: {value:o} octal")
        return value

    # Literals

    def _literal_term(self, opening: str) -> int:
        """Return the address of a literal, `(e)` on this page or `[e]` on page zero."""
        self._advance()
        if self._start != self._before:
            return self._fail("IC", f"a blank after {opening}", "write the literal directly after it")
        link = self._link
        value = self._expressions() & _MASK
        self._link = link
        if self._token == (")" if opening == "(" else "]"):
            self._end_term()
        page = 0 if opening == "[" else self._location >> 7
        here = 0 if opening == "[" else self._location + self._shift & PAGE
        return here | self._literal(page, value)

    def _literal(self, page: int, value: int) -> int:
        """Return where in its page a literal stands; it is stored if it does not stand there yet."""
        pool = self._pools.get(page)
        if pool is None:
            pool = self._pools[page] = Pool()
        for number in range(len(pool.values)):
            if pool.values[number] == value:
                if number < pool.out:
                    message = f"this is the literal {value:04o} that was put out before"
                    self._note("PN46", message, "DEC's PAL8 stores it again: keep a page in one piece")
                return ADDRESS - number
        if len(pool.values) > ADDRESS:
            code = "PE" if page else "ZE"
            message = "more than 128 literals on this page"
            return self._complain(code, message, "use [ for some, or another page", *self._here())
        pool.values.append(value)
        start, end = self._here()
        pool.places.append(self._at(start, end))
        return ADDRESS - len(pool.values) + 1

    def _here(self) -> tuple[int, int]:
        return self._before - 1, self._before

    def _put_out(self, first: int) -> None:
        """Put out the literals of page `first` and those after it, of the last page first."""
        for page in sorted(self._pools, reverse=True):
            pool = self._pools[page]
            if page < first or pool.out == len(pool.values):
                continue
            self._put(ORIGIN, page << 7 | ADDRESS - len(pool.values) + 1)
            for number in range(len(pool.values) - 1, pool.out - 1, -1):
                value = pool.values[number]
                if self._number == 2:
                    address = self._field << 12 | page << 7 | ADDRESS - number
                    self._put_word(Written(address, value, pool.places[number], [], True))
            pool.out = len(pool.values)

    # Pseudo-operators

    def _pseudo_operator(self, name: str) -> None:
        start, end = self._start, self._end
        self._advance()
        if name in symbols8.PALBARTS_PSEUDO_OPERATORS:
            self._note("PN47", f"{name} is palbart's: undefined in DEC's PAL8 (US)", "do without", start, end)
        if name in ("DECIMAL", "OCTAL"):
            self._radix = 10 if name == "DECIMAL" else 8
        elif name in ("IFDEF", "IFNDEF"):
            self._if_defined(name)
        elif name in ("IFZERO", "IFNZRO", "IFNZERO"):
            self._if_zero(name)
        elif name in ("TEXT", "ASCII"):
            self._text(name, start)
        elif name in ("DEVICE", "FILENAME"):
            self._file(name, start)
        elif name in ("NOPUNCH", "ENPUNCH"):
            self._punching = name == "ENPUNCH"
        elif name in _MODES:
            self._mode = name
        elif name == "EXPUNGE":
            if self._number == 1:
                self._expunge()
        elif name == "FIXMRI":
            self._fix_reference()
        elif name == "EJECT":
            self._take_line(len(self._lines[self._index].text))
        elif name == "FIXTAB":
            pass  # what is permanent may be defined again, so that nothing changes
        elif name == "PAUSE":
            self._note("PN48", "DEC's PAL8 ends the file at PAUSE; here it does nothing", "", start, end)
        elif name in ("SEGMNT", "RIMPUNCH", "BINPUNCH"):
            self._fail("US", f"{name} is palbart's alone, and not taken", "do without it", start, end)
        else:
            self._with_number(name, start, end)

    def _with_number(self, name: str, start: int, end: int) -> None:
        """FIELD, PAGE, ZBLOCK, RELOC, XLIST: with a number, or without where that means something."""
        given = self._token not in ("", ";")
        if not given and name == "ZBLOCK":
            self._fail("IC", "ZBLOCK without a number", "write how many words, as in ZBLOCK 10", start, end)
            return
        value = self._expressions() if given else 0
        if self._failed:
            if self._number == 2:
                return
            value = 0
        if name == "FIELD":
            self._go_to_field(value if given else self._field + 1, given, start, end)
        elif name == "PAGE":
            following = self._location + self._shift + ADDRESS & PAGE
            self._go_to_page((value & 0o37) << 7 if given else following)
        elif name == "ZBLOCK":
            self._zeros(value & _MASK, start)
        elif name == "RELOC":
            self._shift = (value & _MASK) - self._location if given else 0

    def _go_to_field(self, field: int, given: bool, start: int, end: int) -> None:
        if not 0 <= field <= 7:
            self._fail("IC", f"there is no field {field & _MASK:o}", "fields are 0 to 7", start, end)
            return
        if not given:
            message = f"FIELD alone is FIELD {field}; DEC's PAL8 refuses it (IC, IP)"
            self._note("PN47", message, "write the number", start, end)
        self._put_out(0)
        self._pools = {}
        self._field = field
        self._put(FIELD, field)
        self._location = START
        self._put(ORIGIN, START)

    def _go_to_page(self, there: int) -> None:
        """Go to the page that begins `there`."""
        self._put_out(1)
        location = there - self._shift & _MASK
        if location != self._location:
            self._location = location
            self._put(ORIGIN, location)

    def _zeros(self, count: int, start: int) -> None:
        if count > 0o10000 - self._location:
            message = f"ZBLOCK {count:o} goes beyond the field"
            self._complain("IC", message, "leave room for the words", start, self._before)
            return
        at = self._at(start, self._before)
        for _ in range(count):
            self._write(0, at)

    def _if_defined(self, name: str) -> None:
        """IFDEF and IFNDEF: a symbol of the source counts from its definition on, in pass 2 too."""
        token = self._token[:SIGNIFICANT]
        if not token[:1].isalpha():
            self._fail("IC", f"{name} without a symbol", f"write it so: {name} A <statements>")
            return
        symbol = self.symbols.get(token)
        defined = symbol is not None and symbol.kind != UNKNOWN
        if symbol is not None and symbol.passed not in (0, self._number):
            defined = False
            message = f"{token} is defined below; DEC's PAL8 takes it for defined in pass 2"
            self._note("PN49", message, "define it before")
        self._mention(token, self._start, self._end, False)
        self._advance()
        self._condition(defined == (name == "IFDEF"))

    def _if_zero(self, name: str) -> None:
        """IFZERO, IFNZRO and IFNZERO: here 10000, a sum, is not zero."""
        start = self._start
        value = self._expressions()
        if self._failed:
            value = 0
        if value and not value & _MASK:
            message = f"{value & 0o177777:o} is not zero; in DEC's PAL8, which keeps twelve bits, it is"
            self._note("PN45", message, "compare what cannot go beyond 7777", start, self._before)
        self._condition((value == 0) == (name == "IFZERO"))

    def _condition(self, holds: bool) -> None:
        """Take what stands after `<`, or pass over it to its `>`."""
        if self._token != "<":
            self._fail("IC", "< is missing after the condition", "it stands on the same line")
        elif holds:
            self._advance()
        else:
            self._pass_over(self._end)

    def _pass_over(self, column: int) -> None:
        """Pass over a condition that does not hold: to its `>`, or to a `$`, whatever they stand in."""
        depth = 1
        began = self._at(self._start, self._end)
        while True:
            text = self._lines[self._index].text
            while column < len(text):
                character = text[column]
                column += 1
                if character == "<":
                    depth += 1
                if character == ">":
                    depth -= 1
                if character == "$":
                    self._note("PN50", "$ ends what the condition leaves out", "DEC's PAL8 passes over it")
                    depth = 0
                if not depth:
                    self._take_line(column)
                    return
            if self._index + 1 == len(self._lines):
                if self._number == 2:
                    advice = "write > after what is left out"
                    self.problems.append(Note("PH", began, "a condition without its end", advice))
                self._take_line(len(text))
                return
            self._index += 1
            column = 0

    def _expunge(self) -> None:
        """Forget all symbols but the pseudo-operators, I and Z."""
        kept = {name: symbol for name, symbol in self.symbols.items() if symbol.kind == PSEUDO}
        self.symbols = {**kept, **{name: Symbol(name, REFERENCE, symbols8.REFERENCES[name]) for name in "IZ"}}

    def _fix_reference(self) -> None:
        """`FIXMRI NAME=expressions`: define a memory reference."""
        if not self._token[:1].isalpha() or self._joined() != "=":
            self._fail("IC", "FIXMRI without a definition", "write it so: FIXMRI NAME=5000")
            return
        name = self._token[:SIGNIFICANT]
        self._mention(name, self._start, self._end, True)
        self._advance()
        self._advance()
        value = self._expressions()
        symbol = self.symbols[name] = Symbol(name, REFERENCE, value & _MASK)
        symbol.passed = self._number

    # Texts and numbers of several words

    def _text(self, name: str, start: int) -> None:
        """TEXT: two characters a word, six bits each, and 00 at its end; ASCII: one of eight bits."""
        line = self._lines[self._index].text
        first = self._start
        if first >= len(line):
            self._fail("IC", f"{name} without a text", f"write it so: {name} /LETTERS/", start, self._before)
            return
        last = line.find(line[first], first + 1)
        if last < 0:
            message = f"{line[first]} does not stand again at the end of the text"
            self._fail("TX", message, "a text ends with the character it begins with", start, len(line))
            return
        if not line[first:last].isascii():
            message = "a character that is not the Teletype's in a text"
            self._fail("IC", message, "write another", start, last + 1)
            return
        before = len(line[: first + 1].expandtabs())
        characters = line[:last].expandtabs()[before:]
        self._take_line(last + 1)
        at = self._at(start, last + 1)
        if name == "ASCII":
            for character in characters:
                self._write(ord(character) | 0o200, at)
        else:
            self._pack(characters + ("\0" if len(characters) % 2 else "\0\0"), at)

    def _pack(self, characters: str, at: int) -> None:
        """Write characters, two a word; there is an even number of them."""
        for first in range(0, len(characters), 2):
            left, right = ord(characters[first]) & 0o77, ord(characters[first + 1]) & 0o77
            self._write(left << 6 | right, at)

    def _file(self, name: str, start: int) -> None:
        """DEVICE: four characters in two words; FILENAME: six in three, and two of the extension in one."""
        given = self._token if self._token[:1].isalnum() else ""
        if not given:
            self._fail("IC", f"{name} without a name", f"write it so: {name} SYS", start, self._before)
            return
        extension = ""
        joined = self._joined()
        self._advance()
        if name == "FILENAME" and joined == ".":
            joined = self._joined()
            self._advance()
            if joined[:1].isalnum():
                extension = joined
                self._advance()
        at = self._at(start, self._before)
        if name == "DEVICE":
            self._pack(given[:4].ljust(4, "\0"), at)
        else:
            self._pack(given[:6].ljust(6, "\0") + extension[:2].ljust(2, "\0"), at)

    def _number_of_words(self) -> None:
        """A number after DUBL, two words of it, or after FLTG, an exponent and two words."""
        start = self._start
        negative = self._token == "-"
        if self._token in ("+", "-"):
            self._advance()
        text = self._lines[self._index].text
        end = begin = self._start
        while end < len(text) and text[end] in "0123456789.":
            end += 1
        figures = text[begin:end]
        whole, _, fraction = figures.partition(".")
        if not figures or figures == "." or "." in fraction or (fraction and self._mode == "DUBL"):
            self._fail("IC", f"no number for {self._mode}", "write decimal digits, with a sign or without")
            return
        fraction = fraction.rstrip("0")
        value = int(whole + fraction or "0") if len(figures) <= _MOST_FIGURES else 0
        if len(figures) > _MOST_FIGURES or (self._mode == "DUBL" and value - negative >= 1 << 23):
            message = f"{figures} does not fit into the words of {self._mode}"
            advice = f"the most is 8388607 after DUBL, {_MOST_FIGURES} figures after FLTG"
            self._fail("IC", message, advice, start, end)
            return
        at = self._at(start, end)
        self._take_line(end)
        floating = self._mode == "FLTG"
        exponent = floating and self._token[:1].isalpha()
        if self._token not in ("", ";") and not exponent:
            value = self._fail("IC", f"more than a number for {self._mode}", "put a ; between two numbers")
        elif exponent or (floating and value == 0):
            self._fail(
                "IC", "FLTG with 0 or an exponent", "palbart never ends here; write three words", start, end
            )
            return
        if self._mode == "DUBL":
            value = -value if negative else value
            self._write(value >> 12 & _MASK, at)
            self._write(value & _MASK, at)
        else:
            self._floating(value, len(fraction), negative, at)

    def _floating(self, value: int, decimals: int, negative: bool, at: int) -> None:
        """Write a number as exponent and mantissa, from a half to one, of 24 bits.

        palbart divides by ten once for each decimal, and cuts what is beyond 26 bits each time.
        """
        exponent = value.bit_length()
        mantissa = value << 26 >> exponent
        for _ in range(decimals):
            mantissa //= 10
            shift = 26 - mantissa.bit_length()
            mantissa <<= shift
            exponent -= shift
        mantissa >>= 3
        if negative:
            mantissa = -mantissa
        self._write(exponent & _MASK, at)
        self._write(mantissa >> 12 & _MASK, at)
        self._write(mantissa & _MASK, at)
