"""One run of PAL8: pass 1 defines the symbols, pass 2 writes the words with the final values.

Not emulated: /B, /E, /F, /O; the limit on symbols; literals below a bound that words have pushed up, for
which DEC's searches all memory.

Sources: DEC's PAL8 V10D; PAL8.PA (V13, 1975).
"""

from pal.pal8.expressions import Expression
from pal.pal8.lexer import Lexer, is_letter
from pal.pal8.literals import Literals
from pal.pal8.log import Fatal, Log
from pal.pal8.operators import Operators
from pal.pal8.output import Punch
from pal.pal8.table import PLAIN, PSEUDO, REFERENCE, SymbolTable
from pal.source import Line
from pal.symbols import SIGNIFICANT


class Assembler:
    """Assembles the lines of a source: `run`.

    log        what is said of it
    table      its symbols
    punch      its words, and what is punched
    operators  its origins
    ended      the line of the `$`
    fatal      whether PAL8 stopped without a tape

    `wipe` is /W: literals that were put out are forgotten. `exact` is DEC's own reading (`pal.pal8`).
    """

    def __init__(self, lines: list[Line], wipe: bool, exact: bool) -> None:
        self._lexer = lexer = Lexer(lines, exact)
        self.log = log = Log(lexer)
        self.table = table = SymbolTable(lexer, log, exact)
        literals = Literals(log)
        self.punch = Punch(log, literals, wipe)
        self._expression = expression = Expression(lexer, log, table, literals)
        self.operators = Operators(lexer, log, table, self.punch, expression, exact)
        self._exact = exact
        self.ended = len(lines)
        self.fatal = False

    def run(self) -> None:
        """Run both passes, as far as they go."""
        try:
            self._pass(1)
            if not self._exact and not self.table.expunged:
                self.table.add_palbarts()
            self._pass(2)
        except Fatal:
            self.fatal = True

    def _pass(self, number: int) -> None:
        self.log.number = number
        self._lexer.rewind()
        self.punch.begin()
        while self._lexer.next_line():
            if self._line():
                self.ended = self._lexer.index
                break
        self.punch.end()

    def _line(self) -> bool:
        """Assemble the line; return whether `$` ended the program."""
        lexer = self._lexer
        begins = True
        while True:
            if begins:
                self.log.begin_statement()
            if lexer.blank:
                lexer.pass_blank()
            if lexer.first == "$":
                return True
            if lexer.first not in "\n;>":
                begins = False
                if self._statement():
                    continue
            if not self._ends_statement():
                return False
            begins = True

    def _ends_statement(self) -> bool:
        """Go to the next statement; return whether there is one on the line."""
        lexer = self._lexer
        while True:
            if lexer.blank:
                lexer.pass_blank()
            if lexer.first == "\n":
                return False
            if lexer.first == ";":
                lexer.advance()
                return True
            if lexer.first == ">" and lexer.level:
                lexer.level -= 1
                lexer.advance()
            else:
                self.log.drop(self.table.found.kind == REFERENCE)

    def _statement(self) -> bool:
        """Assemble a statement; return whether another may follow without a separator, as after a tag."""
        lexer = self._lexer
        start = lexer.start
        if lexer.first == "*":
            self.operators.set_origin()
            return False
        if not is_letter(lexer.first):
            self._word(start, False)
            return False
        name = lexer.token[:SIGNIFICANT]
        end = lexer.end
        follows = lexer.after(end)
        level = lexer.level
        self.table.look_up()
        found = self.table.found
        if found.kind == PSEUDO:
            if found.name == "TEXT" and not self._exact:
                lexer.level = level  # what follows TEXT is no comment
            return self.operators.obey(found.name, start)
        if follows == "," or (follows == ":" and not self._exact):
            if follows == ":":
                self.log.note("PN31 PAL8", start, name=name)
                self.log.say("IC :")
            self.table.define_tag(name, start, end)
            return True
        if follows == "=":
            self.operators.assign(name, PLAIN, start, end)
            return False
        self.log.mention(name, start, end, False)
        self._word(start, True)
        return False

    def _word(self, start: int, looked_up: bool) -> None:
        """Assemble an expression as a word; `looked_up` says whether its first symbol is looked up."""
        expression = self._expression
        value = expression.word(start, looked_up)
        self.punch.write(value, self.log.keep_word(start), expression.names, expression.link)
