"""The units of a part program's constants: how it keeps them, and how its command asks for them.

    unit          kept as                                  asked for in
    INCHES        inches, as the chapters give lengths     INCHES
    THOUSANDTHS   thousandths, as the listings have them   INCHES
    FRACTION      a fraction, 0.2                          PERCENT
    CODE          a code of Table 2.3 or 2.4               CODE

A command asks for each length in inches. Its decimal point is moved to what is kept: no digit is lost. A
length that ends in mm is converted.
"""

from math import isfinite
from typing import Final, NamedTuple

from tapes.errors import WorkError

_THOUSANDTHS = 3
"""Decimal places from inches to thousandths."""


class UnitError(ValueError):
    """A value that is no number, or is plainly of another unit; the message says what to write."""


class Unit(NamedTuple):
    """What a command asks for, and how many places the decimal point moves to what is kept.

    A value other than 0 is at least `least` and less than `limit`, its sign apart. One beyond them is plainly
    `of_another` unit; its decimal point moves by `shift` places to what should have been written.
    """

    metavar: str
    short: str = ""
    places: int = 0
    least: int = 0
    limit: int = 1_000_000
    of_another: str = ""
    shift: int = 0

    def below(self, limit: int) -> "Unit":
        """Return the unit for values less than `limit`."""
        return self._replace(limit=limit)

    def keep(self, text: str, whole: bool = False) -> float:
        """What is kept for `text`, with or without its unit, to a float's last digit. Raises UnitError."""
        text = text.removesuffix(self.short.strip())
        if self.metavar == "INCHES" and text.endswith("mm"):
            text = _plain(_moved(text.removesuffix("mm"), 0) / 25.4)
        asked = _moved(text, 0)
        if asked and not self.least <= abs(asked) < self.limit:
            raise UnitError(self._refusal(text, asked))
        kept = _moved(text, self.places)
        if whole and kept != int(kept):
            of = " of thousandths of an inch" if self.places else ""
            raise UnitError(f"{text} is not a whole number{of}")
        return kept

    def ask(self, kept: float) -> str:
        """Return how to write a kept value."""
        return _plain(_moved(repr(float(kept)), -self.places))

    def _refusal(self, text: str, asked: float) -> str:
        bound = f"less than {self.limit:,}" if abs(asked) >= self.limit else f"0, or at least {self.least:,}"
        meant = _moved(text, self.shift)
        fits = self.least <= abs(meant) < self.limit
        cure = f"; for {text} {self.of_another} write {_plain(meant)}" if fits else ""
        return f"{text}{self.short}: must be {bound}{self.short}{cure}"


INCHES: Final = Unit("INCHES", " in", limit=100, of_another="thousandths", shift=-3)
THOUSANDTHS: Final = INCHES._replace(places=_THOUSANDTHS)
FRACTION: Final = Unit("PERCENT", " %", -2, least=1, limit=100, of_another="as a fraction", shift=2)
PER_SQUARE_INCH: Final = Unit("PER-SQ-INCH")
CODE: Final = Unit("CODE")
NUMBER: Final = Unit("NUMBER")


def thousandths(name: str, inches: float) -> int:
    """Return `inches` in thousandths. Raises WorkError unless it is a whole number of them."""
    units = _units(name, inches)
    if units != int(units):
        raise WorkError(f"{name} {float(inches)!r} in: must be a whole number of thousandths of an inch")
    return int(units)


def tolerance_units(tolerance: float) -> float:
    """Return `tolerance`, inches, in thousandths to the last digit given. Raises WorkError if not finite."""
    return _units("tolerance", tolerance)


def _units(name: str, inches: float) -> float:
    if not isfinite(inches):
        raise WorkError(f"{name} {inches:g} in: must be a finite number")
    return _moved(repr(float(inches)), _THOUSANDTHS)


def _moved(text: str, places: int) -> float:
    """Return the number that `text` says, its decimal point moved to the right. Raises UnitError."""
    digits, _, power = text.strip().lower().partition("e")
    if digits.lstrip("+-") in ("nan", "inf", "infinity"):
        raise UnitError(f"{text!r} is not a finite number")
    try:
        if not all(digit in "+-.0123456789" for digit in digits):
            raise ValueError
        return float(f"{digits}e{int(power or '0') + places}")
    except ValueError:
        raise UnitError(f"{text!r} is not a number") from None


def _plain(number: float) -> str:
    return f"{number:.9f}".rstrip("0").rstrip(".")
