"""The source of PAL8 as tokens: names, numbers, a `"` with its character, and single characters."""

from pal.source import Line, plain

LINE = 80  # characters of a line that DEC's PAL8 keeps


class Lexer:
    r"""Reads the source token by token.

    index      the line, counted from 0; `text`, what is on it
    token      the token, "" at the end of a line; `first`, its first character, \n at the end of a line
    start      its column; `end`, the column after it; `before`, the column after the token before it
    blank      whether blanks or TABs come before it
    level      how many conditions are open: within one, `<` and `>` count in comments too
    radix      of numbers, 8 or 10
    """

    def __init__(self, lines: list[Line], exact: bool) -> None:
        self.lines = lines
        self.texts = [line.text[:LINE] if exact else line.text for line in lines]
        self._codes = [plain(text) if exact else plain(text).upper() for text in self.texts]

    def rewind(self) -> None:
        """Go before the first line."""
        self.index = -1
        self.level = 0
        self.radix = 8

    def next_line(self) -> bool:
        """Go to the next line; return whether there is one."""
        if self.index + 1 >= len(self.lines):
            return False
        self.index += 1
        self.go_to(0)
        return True

    def go_to(self, column: int) -> None:
        """Go to a column of the line."""
        self._code = self._codes[self.index]
        self.end = column
        self.advance()

    def end_file(self) -> None:
        """Read nothing more."""
        self.index = len(self.lines)
        self.first = "\n"
        self.token = ""
        self.blank = False

    def advance(self) -> None:
        """Take the next token."""
        code = self._code
        length = len(code)
        start = self.before = self.end
        while start < length and code[start] in " \t":
            start += 1
        self.blank = start > self.before
        self.start = self.end = start
        self.first = "\n"
        if start < length:
            self.first = code[start]
            self.end = self._token_end(start + 1, length)
        self.token = code[start : self.end]
        if self.first == "/" and not self.blank:
            self._pass_comment()

    def _token_end(self, end: int, length: int) -> int:
        """Return where the token ends that begins just before `end`."""
        code = self._code
        first = self.first
        if is_letter(first):
            while end < length and (is_letter(code[end]) or is_digit(code[end])):
                end += 1
        elif is_digit(first):
            while end < length and is_digit(code[end]):
                end += 1
        elif first == '"':
            return min(end + 1, length)
        return length if first == "/" else end

    def pass_blank(self) -> None:
        """Pass over the blanks before the token."""
        self.blank = False
        if self.first == "/":
            self._pass_comment()

    def skip(self) -> None:
        """Take the next token; after a `"` this is the character that belonged to it."""
        if self.first == '"':
            self.end = self.start + 1
        self.advance()

    def after(self, column: int) -> str:
        r"""Return the character at a column, \n at the end of the line."""
        return self._code[column] if column < len(self._code) else "\n"

    def rest(self) -> str:
        """Return what follows the token."""
        return self._code[self.end :]

    def text(self) -> str:
        """Return the line as it is written."""
        return self.texts[self.index]

    def _pass_comment(self) -> None:
        self.first = "\n"
        self.token = ""
        if self.level:
            self.level = self.level_after(self.start)

    def level_after(self, column: int) -> int:
        """Return the level of conditions after a comment; once all are closed, its rest does not count."""
        level = self.level
        for character in self.texts[self.index][column:]:
            if level:
                level += (character == "<") - (character == ">")
        return level


def is_letter(character: str) -> bool:
    """Whether a character is a capital letter."""
    return "A" <= character <= "Z"


def is_digit(character: str) -> bool:
    """Whether a character is a digit."""
    return "0" <= character <= "9"


def is_operator(character: str) -> bool:
    """Whether a character is an operator between two terms."""
    return character in "+-!&^%"


def ends_expression(character: str) -> bool:
    r"""Whether an expression ends before a character; \n is the end of the line."""
    return character in "\n;)]><"
