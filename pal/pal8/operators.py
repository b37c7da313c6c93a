"""What `*`, `=` and the pseudo-operators of PAL8 do."""

from collections.abc import Callable

from pal.isa import ADDRESS, PAGE
from pal.messages import Worded, worded
from pal.pal8 import symbols
from pal.pal8.expressions import Expression
from pal.pal8.lexer import Lexer, is_digit, is_letter
from pal.pal8.log import Log
from pal.pal8.output import Punch
from pal.pal8.table import PSEUDO, REFERENCE, WEAK, SymbolTable
from pal.symbols import SIGNIFICANT

_CELLS_OF_EQUALS = 6  # of the push-down list
_MOST_ZEROS = 1 << 18  # words of ZBLOCK in both passes: four times 32K in each


class Operators:
    """Obeys the operator that begins a statement.

    origins    [(line, whether it is a number only)] of each `*`
    """

    def __init__(
        self, lexer: Lexer, log: Log, table: SymbolTable, punch: Punch, expression: Expression, exact: bool
    ) -> None:
        self._lexer = lexer
        self._log = log
        self._table = table
        self._punch = punch
        self._expression = expression
        self._exact = exact
        self._start = 0  # the column of the operator
        self._opens = False  # whether a statement may follow it directly, as after a condition
        self._zeros = 0  # words of ZBLOCK so far, in both passes
        self.origins: list[tuple[int, bool]] = []

    def set_origin(self) -> None:
        """`*e`: go to a location."""
        lexer = self._lexer
        start = lexer.start
        lexer.advance()
        location = self._argument()
        if self._log.number == 2:
            number = lexer.text()[start + 1 : lexer.before].strip(" \t0123456789") == ""
            self.origins.append((lexer.index, number))
        self._punch.go_to(location, self._table.undefined != 0)

    def assign(self, name: str, kind: int, start: int, end: int) -> None:
        """`NAME=e`, the symbol looked up already; `kind` is REFERENCE after FIXMRI."""
        table = self._table
        self._log.mention(name, start, end, True)
        self._lexer.advance()
        is_undefined = table.is_undefined
        value = self._expression.argument(_CELLS_OF_EQUALS)
        table.is_undefined = is_undefined
        if table.undefined:
            self._log.say("IE", start, name=name)
        else:
            table.define(name, kind, value, start)

    def obey(self, name: str, start: int) -> bool:
        """Obey the pseudo-operator just looked up; return whether a statement may follow it directly."""
        self._start = start
        self._opens = False
        _ROUTINE_OF[name](self)
        return self._opens

    def _argument(self) -> int:
        return self._expression.argument()

    def _has_argument(self) -> bool:
        self._lexer.pass_blank()
        return self._lexer.first not in "\n;>"

    def _place(self) -> int:
        """Keep the place of the pseudo-operator with its argument; return its number."""
        return self._log.keep(self._start, self._lexer.before)

    def set_radix(self, radix: int) -> None:
        """DECIMAL, OCTAL."""
        self._lexer.radix = radix

    def set_punching(self, punching: bool) -> None:
        """NOPUNCH, ENPUNCH."""
        self._punch.punching = punching

    def page(self) -> None:
        """PAGE n, or the next one: put out the literals of this page first."""
        self._punch.leave_page()
        if not self._has_argument():
            self._punch.enter_page(self._log.location + ADDRESS & PAGE)
            return
        page = self._argument()
        if page > PAGE >> 7:
            self._log.note("PN53", self._start, page=f"{page:o}", taken=f"{page & 0o37:o}")
        self._punch.enter_page(page << 7 & PAGE)

    def field(self) -> None:
        """FIELD n: put out all literals first."""
        self._punch.leave_page()
        self._punch.leave_page_zero()
        self._punch.begin_field(self._argument() & 7)

    def zeros(self) -> None:
        """ZBLOCK n."""
        count = self._argument()
        at = self._place()
        self._zeros += count
        if self._zeros > _MOST_ZEROS:
            self._log.die("PS01 ZBLOCK")
        for _ in range(count):
            self._punch.write(0, at, self._expression.names, False)

    def relocate(self) -> None:
        """RELOC e: assemble for the address where the code runs; RELOC: for where it is loaded."""
        location, undefined = self._punch.loaded_at(), False
        if self._has_argument():
            location, undefined = self._argument(), self._table.undefined != 0
        self._punch.relocate(location, undefined, self._place())

    def expunge(self) -> None:
        """EXPUNGE, in pass 1."""
        if self._log.number == 1:
            self._table.expunge()

    def fix_table(self) -> None:
        """FIXTAB, in pass 1."""
        if self._log.number == 1:
            self._table.fix()

    def fix_reference(self) -> None:
        """`FIXMRI NAME=e`: define a memory reference."""
        lexer = self._lexer
        missing = worded("IC FIXMRI")
        if self._find_token("", missing, False):
            name, start, end = lexer.token[:SIGNIFICANT], lexer.start, lexer.end
            self._table.look_up()
            if self._find_token("=", missing, True):
                self.assign(name, REFERENCE, start, end)

    def pause(self) -> None:
        """PAUSE: DEC's PAL8 reads no more of the file; here the rest is read."""
        lexer = self._lexer
        if self._exact:
            lexer.end_file()
            return
        tape = lexer.lines[lexer.index].tape
        rest = [line.text for line in lexer.lines[lexer.index + 1 :] if line.tape == tape]
        if any(text.partition("/")[0].strip(" \t;>$") for text in [lexer.text()[lexer.before :], *rest]):
            self._log.note("PN48", self._start)

    def eject(self) -> None:
        """EJECT: ignore the new page's title, which goes up to a `;` or comment."""
        while self._lexer.first not in "\n;":
            self._lexer.skip()
            self._lexer.pass_blank()

    def list_or_not(self) -> None:
        """XLIST, perhaps with an argument."""
        if self._has_argument():
            self._argument()

    def block(self) -> None:
        """DTORG n: punch a block number, for DEC's typesetting."""
        value = self._argument()
        self._punch.put_block(value, self._place())

    def device(self) -> None:
        """DEVICE: four characters."""
        self._lexer.pass_blank()
        self._pack(4)

    def filename(self) -> None:
        """FILENAME: six characters, and two after the point."""
        lexer = self._lexer
        lexer.pass_blank()
        self._pack(6)
        if lexer.first == "." and not lexer.blank:
            lexer.advance()
        self._pack(2)

    def _pack(self, length: int) -> None:
        """Pack letters and digits, two a word, and 00 for those that are missing."""
        lexer = self._lexer
        characters = ""
        while not lexer.blank and (is_letter(lexer.first) or is_digit(lexer.first)):
            characters += lexer.token
            lexer.advance()
        if not characters and length > 2:
            self._log.note("PN54 name", self._start)
        characters = characters[:length].ljust(length, "\0")
        at = self._place()
        for first in range(0, length, 2):
            self._write(ord(characters[first]), ord(characters[first + 1]), at)

    def _write(self, left: int, right: int, at: int) -> None:
        self._punch.write((left & 0o77) << 6 | right & 0o77, at, [], False)

    def text(self) -> None:
        """TEXT: two characters a word, six bits each, and 00 at the end."""
        lexer = self._lexer
        log = self._log
        text = lexer.text()
        column = lexer.before
        if self._exact and not lexer.blank and lexer.first in "\n;":
            self._write(0, 0, log.keep(self._start, column))
            return
        lexer.before = column + 1
        if not self._exact and text[column : column + 1] in ("/", ";"):
            log.note("PN44", self._start, mark=text[column])
        last = "_" if self._exact else "~"
        while column < len(text) and not "!" <= text[column] <= last:
            column += 1
        first = column
        delimiter = text[column : column + 1]
        if delimiter == "":
            log.note("PN54", self._start)
        codes: list[int] = []
        at = log.keep(self._start, len(text))
        column += 1
        while column < len(text) and text[column] != delimiter:
            character = text[column]
            if " " <= character <= last:
                codes.append(ord(character))
                if len(codes) == 2:
                    self._write(codes[0], codes[1], at)
                    codes = []
            else:
                lexer.start, lexer.end = column, column + 1
                log.say("IC TEXT")
            column += 1
        lexer.before = min(column + 1, len(text))
        if not self._exact and any("`" <= character <= "~" for character in text[first:column]):
            log.note("PN35 TEXT", self._start)
        if delimiter and column == len(text):
            log.note("PN54 end", self._start, mark=delimiter)
        self._write(codes[0] if codes else 0, 0, at)
        lexer.go_to(lexer.before)

    def if_defined(self, name: str) -> None:
        """IFDEF, IFNDEF: in pass 2 a symbol that is only defined further on counts as defined."""
        if self._find_token("", worded("IC asked", name=name), True):
            self._condition(self._is_undefined() == (name == "IFNDEF"))

    def if_zero(self, holds: bool) -> None:
        """IFZERO, IFNZRO."""
        self._condition((self._argument() == 0) == holds)

    def _is_undefined(self) -> bool:
        """Look up the symbol of IFDEF or IFNDEF; return whether it is undefined."""
        lexer = self._lexer
        table = self._table
        name, start = lexer.token[:SIGNIFICANT], lexer.start
        self._log.mention(name, start, lexer.end, False)
        kept = table.is_undefined
        table.look_up()
        is_undefined = table.is_undefined or table.found.kind == WEAK
        table.is_undefined = kept
        if table.found.kind == PSEUDO:
            self._log.say("IP asked", start, name=table.found.name)
        elif table.found.passed == 1 and self._log.number == 2:
            text = lexer.text().upper()
            # `IFNDEF A <A=5>` is the same in palbart
            if f"{text[start : lexer.before]}=" not in text[lexer.before :].partition(">")[0]:
                self._log.note("PN49", start, name=name)
        return is_undefined

    def _condition(self, holds: bool) -> None:
        """Assemble the text after `<`, or skip it if the condition is false."""
        if not self._find_token("<", worded("IC <"), True):
            return
        self._opens = True
        if holds:
            self._lexer.advance()
            self._lexer.level += 1
        else:
            self._pass_over()

    def _pass_over(self) -> None:
        """Skip the text of a false condition, from its `<` to its `>`."""
        lexer = self._lexer
        began, end = lexer.index, lexer.end
        text = lexer.text()
        column = end
        if text[column : column + 1] == "/":
            lexer.level = lexer.level_after(column)
            column = len(text)
        outside = lexer.level
        lexer.level += 1
        while True:
            if not ("<" in text or ">" in text):
                column = len(text)
            while column < len(text):
                character = text[column]
                column += 1
                lexer.level += (character == "<") - (character == ">")
                if character == "/":
                    lexer.level = lexer.level_after(column)
                    column = len(text)
                if lexer.level <= outside:
                    lexer.go_to(column)
                    if lexer.level <= outside:
                        return
                    column = len(text)  # a comment right behind the `>` opens another
            if lexer.index + 1 == len(lexer.lines):
                lexer.index, lexer.start, lexer.end = began, self._start, end
                self._log.die("PH")
            lexer.index += 1
            text = lexer.text()
            column = 0
            if text[:1] == "$":
                lexer.start, lexer.end = 0, 1
                self._log.note("PN50")

    def _find_token(self, wanted: str, missing: Worded, blanks: bool) -> bool:
        """Skip to the token wanted, or to a name; return whether there is one. `blanks` may come before."""
        lexer = self._lexer
        lexer.pass_blank()
        while lexer.blank or not (lexer.token == wanted if wanted else is_letter(lexer.first)):
            if not lexer.blank and lexer.first not in "\n;":
                self._log.complain_of_token(missing)
                lexer.skip()
                lexer.blank = lexer.blank and not blanks
                if not lexer.blank:
                    lexer.pass_blank()
                continue
            self._log.complain(missing)
            if not lexer.blank:
                return False
            lexer.pass_blank()
        return True


_ROUTINES: dict[str, Callable[[Operators], None]] = {
    "DECIMAL": lambda run: run.set_radix(10),
    "DEVICE": lambda run: run.device(),
    "DTORG": lambda run: run.block(),
    "EJECT": lambda run: run.eject(),
    "ENPUNCH": lambda run: run.set_punching(True),
    "EXPUNGE": lambda run: run.expunge(),
    "FIELD": lambda run: run.field(),
    "FILENAME": lambda run: run.filename(),
    "FIXMRI": lambda run: run.fix_reference(),
    "FIXTAB": lambda run: run.fix_table(),
    "IFDEF": lambda run: run.if_defined("IFDEF"),
    "IFNDEF": lambda run: run.if_defined("IFNDEF"),
    "IFNZRO": lambda run: run.if_zero(False),
    "IFZERO": lambda run: run.if_zero(True),
    "NOPUNCH": lambda run: run.set_punching(False),
    "OCTAL": lambda run: run.set_radix(8),
    "PAGE": lambda run: run.page(),
    "PAUSE": lambda run: run.pause(),
    "RELOC": lambda run: run.relocate(),
    "TEXT": lambda run: run.text(),
    "XLIST": lambda run: run.list_or_not(),
    "ZBLOCK": lambda run: run.zeros(),
}
_ROUTINE_OF = {name: _ROUTINES[name] for name in symbols.HANDLERS}  # each has one
