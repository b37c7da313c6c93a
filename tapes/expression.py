"""y = f(x) as a command takes it: sin(x)/x, 0.2*x*(x-2)*(x-6).

    sum       product + product - ...          LANGUAGE says what it has; capitals, as in FORTRAN, are the
    product   factor * factor / ...            same. Signs and powers bind as in Python and FORTRAN:
    factor    - factor, atom ** factor, atom   -x**2 is -(x**2), 2**3**x is 2**(3**x).
    atom      number, name, (sum), name(sum)

Each becomes a function of x; what cannot be read is refused with its column.
"""

from collections.abc import Callable
from math import acos, asin, atan, cos, cosh, exp, fabs, isfinite, log, pow, sin, sinh, sqrt, tan, tanh
from typing import Final, NoReturn

from tapes.errors import WorkError

Function = Callable[[float], float]

FUNCTIONS: Final[dict[str, Function]] = {
    "sqrt": sqrt, "exp": exp, "log": log, "sin": sin, "cos": cos, "tan": tan, "asin": asin, "acos": acos,
    "atan": atan, "sinh": sinh, "cosh": cosh, "tanh": tanh, "abs": fabs,
}  # fmt: skip
CONSTANTS: Final = {"pi": 3.141592653589793, "e": 2.718281828459045}
LANGUAGE: Final = f"numbers, x, {', '.join(CONSTANTS)}, + - * / ** ( ) and {', '.join(FUNCTIONS)}"

_LONGEST = 500
_LARGEST = 1e6
_DIGITS = ".0123456789"


def function(text: str) -> Function:
    """The function, which raises WorkError where it has no value. Raises WorkError, naming the column."""
    if len(text) > _LONGEST:
        raise WorkError(f"expression of {len(text)} characters: at most {_LONGEST} are allowed")
    text = text.strip()
    try:
        inner = _Reader(text).whole()
    except RecursionError:
        raise WorkError(f"{text[:20]!r}... is nested too deeply") from None

    def value(x: float) -> float:
        try:
            found = inner(float(x))
        except (ArithmeticError, ValueError, RecursionError) as error:
            raise WorkError(f"at x = {x:g} the expression {text!r} has no value: {error}") from None
        if not abs(found) < _LARGEST:
            raise WorkError(f"at x = {x:g} the expression {text!r} is {found:g}: must be within {_LARGEST:g}")
        return found

    return value


class _Reader:
    """Reads an expression from left to right; `at` is the next character."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._plain = f"{text.lower()} "
        self._at = 0

    def whole(self) -> Function:
        found = self._sum()
        if self._at < len(self._text):
            self._refuse()
        return found

    def _sum(self) -> Function:
        found = self._product()
        while sign := self._taken("+") or self._taken("-"):
            found = _joined(sign, found, self._product())
        return found

    def _product(self) -> Function:
        found = self._factor()
        while sign := self._taken("*") or self._taken("/"):
            found = _joined(sign, found, self._factor())
        return found

    def _factor(self) -> Function:
        if self._taken("+"):
            return self._factor()
        if self._taken("-"):
            negated = self._factor()
            return lambda x: -negated(x)
        base = self._atom()
        if not self._taken("**"):
            return base
        exponent = self._factor()
        return lambda x: pow(base(x), exponent(x))

    def _atom(self) -> Function:
        start = self._at
        if self._taken("("):
            return self._closed()
        while self._plain[self._at].isalpha():
            self._at += 1
        name = self._plain[start : self._at]
        if name == "x":
            return lambda x: x
        if name in CONSTANTS:
            named = CONSTANTS[name]
            return lambda x: named
        if name in FUNCTIONS and self._taken("("):
            outer, argument = FUNCTIONS[name], self._closed()
            return lambda x: outer(argument(x))
        if name:
            self._refuse(start)
        return self._number()

    def _closed(self) -> Function:
        found = self._sum()
        if not self._taken(")"):
            self._refuse()
        return found

    def _number(self) -> Function:
        start = self._at
        self._digits()
        power = self._at + (2 if self._plain[self._at + 1 : self._at + 2] in ("+", "-") else 1)
        if self._at > start and self._plain[self._at] == "e" and self._plain[power : power + 1].isdigit():
            self._at = power
            self._digits()
        try:
            number = float(self._plain[start : self._at])
        except ValueError:
            self._refuse(start)
        if not isfinite(number):
            raise WorkError(f"a number of {self._text[start : start + 20]!r}... is too large")
        return lambda x: number

    def _digits(self) -> None:
        while self._plain[self._at] in _DIGITS:
            self._at += 1

    def _skip(self) -> None:
        while self._at < len(self._text) and self._text[self._at].isspace():
            self._at += 1

    def _taken(self, mark: str) -> str | None:
        """Return the mark and move past it, None if it does not follow."""
        self._skip()
        if not self._plain.startswith(mark, self._at):
            return None
        self._at += len(mark)
        return mark

    def _refuse(self, start: int | None = None) -> NoReturn:
        """Raise WorkError for the text at `start`, or the next one."""
        self._skip()
        start = self._at if start is None else start
        found = self._text[start : max(self._at, start + 1)].rstrip()
        said = repr(found) if found else "the end"
        hint = "; a power is written **" if said == "'^'" else ""
        raise WorkError(f"column {start + 1}: {said} is not an expression in x: {LANGUAGE}{hint}")


def _joined(sign: str, one: Function, other: Function) -> Function:
    if sign == "+":
        return lambda x: one(x) + other(x)
    if sign == "-":
        return lambda x: one(x) - other(x)
    if sign == "*":
        return lambda x: one(x) * other(x)
    return lambda x: one(x) / other(x)
