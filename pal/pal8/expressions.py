"""The expressions of PAL8.

    expression    term, operator, term ...    + - ! & ^ % and the blank, which is OR; from left to right, in
                                              twelve bits; the first term may have a sign
    term          symbol, number, ., "c, (expression), [expression]

A memory reference comes first in its expression; I and Z may follow it, then its address, an expression too.
"""

from pal.isa import ADDRESS, CURRENT_PAGE, INDIRECT, PAGE
from pal.pal8 import symbols
from pal.pal8.lexer import Lexer, ends_expression, is_digit, is_letter, is_operator
from pal.pal8.literals import Literals
from pal.pal8.log import Log
from pal.pal8.table import MARK, PSEUDO, REFERENCE, WEAK, SymbolTable
from pal.symbols import SIGNIFICANT

_MASK = 0o7777
_CELLS = 34  # of DEC's push-down list
_CELLS_OF_EXPRESSION, _CELLS_OF_REFERENCE, _CELLS_OF_LITERAL = 1, 2, 4


class Expression:
    """An expression as it is read; what is inside it, a literal or an address, is an expression too.

    value    so far, in twelve bits
    names    the symbols in it and inside it
    link     whether it is a memory reference through a link
    """

    def __init__(self, lexer: Lexer, log: Log, table: SymbolTable, literals: Literals) -> None:
        self._lexer = lexer
        self._log = log
        self._table = table
        self._literals = literals
        self._within: Expression | None = None
        self.value = 0
        self.link = False
        self.names: list[str] = []

    def word(self, start: int, looked_up: bool) -> int:
        """Return the value of a word that begins at column `start`, its first symbol perhaps looked up."""
        self.names = []
        return self._read(start, looked_up, True, 0)

    def argument(self, cells: int = 0) -> int:
        """Return the value of what follows an operator, which uses so many cells of the push-down list."""
        self._lexer.pass_blank()
        self.names = []
        return self._read(-1, False, True, cells)

    def _inside(self) -> "Expression":
        """Return a new expression for one nested in this one."""
        if self._within is None:
            self._within = Expression(self._lexer, self._log, self._table, self._literals)
        self._within.names = self.names
        return self._within

    def _read(self, begun: int, looked_up: bool, may_refer: bool, cells: int) -> int:
        """Return the value; the table says whether something in it is undefined.

        begun      the column where the word begins, -1 outside a word
        looked_up  whether the first symbol is looked up already
        may_refer  whether it may be a memory reference
        cells      of the push-down list that are in use
        """
        self._begun = begun
        self._cells = cells
        self._use_cells(_CELLS_OF_EXPRESSION)
        self._may_refer = may_refer
        self.value = 0
        self.link = False
        self._operator = "+"
        self._has_blank = False  # then palbart's value is that of `_ored` OR `_group`
        self._ored = 0
        self._group = 0
        self._table.undefined = 0
        lexer = self._lexer
        start = lexer.start
        if looked_up:
            more = self._take_symbol()
        else:
            if lexer.first in "+-":
                self._take_operator(lexer.first)
                lexer.advance()
            more = self._term()
        while more and self._next_operator(start):
            more = self._term()
        return self.value

    def _use_cells(self, cells: int) -> None:
        self._cells += cells
        if self._cells > _CELLS:
            self._log.die("BE")

    def _next_operator(self, start: int) -> bool:
        """Take the operator after a term; return whether there is one."""
        lexer = self._lexer
        while True:
            if lexer.blank:
                self._take_operator(" ")
                lexer.pass_blank()
                return True
            if ends_expression(lexer.first):
                self._end(start)
                return False
            if is_operator(lexer.first):
                self._take_operator(lexer.first)
                lexer.advance()
                return True
            self._drop()

    def _take_operator(self, operator: str) -> None:
        self._operator = operator
        self._may_refer = False

    def _drop(self) -> None:
        self._log.drop(self._table.found.kind == REFERENCE)

    def _end(self, start: int) -> None:
        if self._table.undefined:
            self._table.undefined = -1
            self.value = 0
        elif self._has_blank and self._ored | self._group != self.value:
            other = f"{self._ored | self._group:04o}"
            self._log.note("PN42", start, value=f"{self.value:04o}", other=other)

    def _term(self) -> bool:
        """Take a term; return whether an operator may follow."""
        lexer = self._lexer
        table = self._table
        while True:
            first = lexer.first
            if lexer.blank:
                self._log.say("IC blank", lexer.before)
                lexer.pass_blank()
            elif is_letter(first):
                self._log.mention(lexer.token[:SIGNIFICANT], lexer.start, lexer.end, False)
                table.look_up()
                return self._take_symbol()
            elif is_digit(first):
                table.last = self._number(lexer.token)
                lexer.advance()
                return self._combine()
            elif first == ".":
                table.last = self._log.location
                lexer.advance()
                return self._combine()
            elif first == '"':
                return self._take_quoted()
            elif first in "([":
                return self._take_literal(first)
            elif not ends_expression(first):
                self._drop()
            elif self._operator == " ":
                self._end(lexer.start)
                return False
            else:
                key = "IC address" if table.found.kind == MARK else "IC missing"
                self._log.say(key, name=table.found.name)
                return self._take_symbol()

    def _take_quoted(self) -> bool:
        lexer = self._lexer
        if len(lexer.token) == 1:
            self._log.say('IC "')
            lexer.advance()
            self._end(lexer.start)
            return False
        character = lexer.text()[lexer.start + 1]
        if not character.isascii():
            self._log.say("IC Teletype", character=character)
            character = "?"
        if character == "\t":
            self._log.note("PN43")
        self._table.last = ord(character) | 0o200
        lexer.advance()
        return self._combine()

    def _combine(self) -> bool:
        """Combine the value with the term by the operator; return True."""
        operator = self._operator
        last = self._table.last
        if operator == " ":
            self._ored = self._ored | self._group if self._has_blank else self.value
            self._group = last
            self._has_blank = True
        elif self._has_blank:
            self._group = self._operate(self._group, operator, last)
        self.value = self._operate(self.value, operator, last)
        if operator == "%":
            self._table.last = -last & _MASK
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
            self._log.note("PN45 zero")
        elif (value | last) & 0o4000:
            self._log.note("PN45", value=f"{value:04o}", by=f"{last:04o}", quotient=f"{quotient:04o}")
        return quotient

    def _take_symbol(self) -> bool:
        """Use the symbol just looked up as a term; return whether an operator may follow."""
        lexer = self._lexer
        found = self._table.found
        self.names.append(found.name)
        if found.kind == PSEUDO:
            self._log.say("IP", self._table.found_at, name=found.name)
        elif found.kind == WEAK and not found.permanent:
            found.permanent = True  # a second note would say the same
            self._log.note("PN47", self._table.found_at, name=found.name, octal=f"{found.value:04o}")
        if self._table.is_undefined and self._table.use_undefined():
            self._say_undefined(found.name)
        refers = found.kind == REFERENCE or (found.kind == WEAK and found.name in symbols.PALBARTS_REFERENCES)
        if not (refers and lexer.blank):
            return self._combine()
        lexer.pass_blank()
        if lexer.first in "\n;" or not self._may_refer:
            return self._combine()
        return self._refer(self._table.last)

    def _say_undefined(self, name: str) -> None:
        """Report an undefined symbol; one that begins the line may be a tag."""
        lexer = self._lexer
        text = lexer.text()
        start, end = self._table.found_at, lexer.before
        written = text[start:end].rstrip("= \t").upper()
        instead = symbols.ELSEWHERE.get(name, "")
        key = "US elsewhere" if instead else "US"
        follows = text[end : end + 1] in (" ", "\t") and not ends_expression(lexer.first)
        if self._begun == start == 0 and follows:
            key = "US EQU" if lexer.token.upper() == "EQU" else "US tag"
            self._log.misread = True
        self._log.say(key, start, name=written, instead=instead)

    def _number(self, token: str) -> int:
        """Return the value of a number; an 8 or 9 in octal is passed over."""
        radix = self._lexer.radix
        if radix == 8 and ("8" in token or "9" in token):
            good = ""
            for digit in token:
                if digit < "8":
                    good += digit
                else:
                    self._log.say("IC octal", figure=digit, number=token)
            token = good or "0"
        value = int(token[max(len(token) - 12, 0) :], radix)
        address = self._begun < 0 and value < 0o100000  # with its field, in an origin or a definition
        if (value > _MASK and not address) or len(token) > 12:
            kept = value & _MASK
            self._log.note("PN04 PAL8", number=token, word=f"{kept:04o}", octal=f"{kept:o}")
        return value & _MASK

    def _refer(self, operation: int) -> bool:
        """Combine a memory reference with its address; return False, because no operator may follow."""
        lexer = self._lexer
        log = self._log
        table = self._table
        start = lexer.start
        self._use_cells(_CELLS_OF_REFERENCE)
        marks = 0
        found = False
        while is_letter(lexer.first) and not found:
            log.mention(lexer.token[:SIGNIFICANT], lexer.start, lexer.end, False)
            table.look_up()
            if table.found.kind == MARK:
                self.names.append(table.found.name)
                marks = marks + (table.last or 1) & _MASK
                lexer.pass_blank()
            else:
                found = True
        number = not found and lexer.first == "-" and lexer.rest().lstrip()[:1].isdigit()
        address = self._inside()._read(self._begun, found, False, self._cells)
        if number and address & 0o7000 == 0o7000:
            log.note("PN51", start, address=f"{address:04o}")
        elsewhere = -1
        if address & PAGE:
            if (address ^ log.location) & PAGE:
                elsewhere = address
                address = self._literals.find(address, log.location >> 7, start)
                self.link = True
                operation = self._indirect(operation, elsewhere, start)
            operation = operation + CURRENT_PAGE & _MASK
            if marks & 0o77:
                log.say("IZ", start, address=f"{address:04o}")
        if marks & 0o7700:
            operation = self._indirect(operation, elsewhere, start)
        table.last = operation
        self.value = (address & ADDRESS) + operation & _MASK
        return False

    def _indirect(self, operation: int, elsewhere: int, start: int) -> int:
        """An indirect memory reference; one that already has I refers through a link to `elsewhere`."""
        if operation & INDIRECT and elsewhere < 0:
            self._log.say("II", start)
        elif operation & INDIRECT:
            location = f"{self._log.location:04o}"
            self._log.say("II link", start, address=f"{elsewhere:04o}", location=location)
        return operation | INDIRECT

    def _take_literal(self, opening: str) -> bool:
        """Take `(e)`, a literal on this page, or `[e]`, one on page zero; return True."""
        lexer = self._lexer
        start = lexer.start
        lexer.advance()
        lexer.pass_blank()
        value = self._inside()._read(-1, False, True, self._cells + _CELLS_OF_LITERAL)
        text = lexer.text()[lexer.before :] if lexer.first == "\n" else ""
        if text[:1] == "/" and text[1:2].isalnum() and ")" in text:
            self._log.note("PN52", start)
        self._table.last = self._literals.find(value, 0 if opening == "[" else self._log.location >> 7, start)
        if lexer.first in ")]":
            lexer.advance()
        return self._combine()
