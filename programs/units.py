"""The units of a part program's constants: how it keeps them, and how its command asks for them.

    unit          kept as                                  asked for in
    INCHES        inches, as the chapters give lengths     INCHES
    THOUSANDTHS   thousandths, as the listings have them   INCHES
    FRACTION      a fraction, 0.2                          PERCENT
    CODE          a code of Table 2.3 or 2.4               CODE

A command asks for each length in inches. Its decimal point is moved to what is kept: no digit is lost.
"""

from decimal import MAX_EMAX, MAX_PREC, MIN_EMIN, Context, Decimal, InvalidOperation
from math import isfinite
from typing import Final, NamedTuple

from tapes.errors import WorkError

_EXACT: Final = Context(prec=MAX_PREC, Emax=MAX_EMAX, Emin=MIN_EMIN)
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
    least: float = 0
    limit: float = 1_000_000
    of_another: str = ""
    shift: int = 0

    def below(self, limit: float) -> "Unit":
        """Return the unit for values less than `limit`."""
        return self._replace(limit=limit)

    def keep(self, text: str) -> Decimal:
        """Return what is kept for `text`, with its unit behind it or without, exactly. Raises UnitError."""
        try:
            asked = Decimal(text.removesuffix(self.short.strip()))
        except InvalidOperation:
            raise UnitError(f"{text!r} is not a number") from None
        if not asked.is_finite():
            raise UnitError(f"{text!r} is not a finite number")
        if asked and not self.least <= asked.copy_abs() < self.limit:
            raise UnitError(self._refusal(text, asked))
        return asked.scaleb(self.places, _EXACT)

    def ask(self, kept: float) -> str:
        """Return what to write for a value that is kept."""
        return f"{Decimal(repr(kept)).scaleb(-self.places, _EXACT).normalize():f}"

    def _refusal(self, text: str, asked: Decimal) -> str:
        bound = (
            f"less than {self.limit:,}"
            if asked.copy_abs() >= self.limit
            else f"0, or at least {self.least:,}"
        )
        refusal = f"{text}{self.short}: must be {bound}{self.short}"
        meant = asked.scaleb(self.shift, _EXACT)
        if not (self.shift and self.least <= meant.copy_abs() < self.limit):
            return refusal
        return f"{refusal}; for {text} {self.of_another} write {meant.normalize():f}"


INCHES: Final = Unit("INCHES", " in", limit=100, of_another="thousandths", shift=-3)
THOUSANDTHS: Final = INCHES._replace(places=_THOUSANDTHS)
FRACTION: Final = Unit("PERCENT", " %", -2, least=1, limit=100, of_another="as a fraction", shift=2)
PER_SQUARE_INCH: Final = Unit("PER-SQ-INCH")
CODE: Final = Unit("CODE")
NUMBER: Final = Unit("NUMBER")


def thousandths(name: str, inches: float) -> int:
    """Return `inches` in thousandths. Raises WorkError unless it is a whole number of them."""
    units = _moved(name, inches)
    if units != units.to_integral_value():
        raise WorkError(f"{name} {inches!r} in: must be a whole number of thousandths of an inch")
    return int(units)


def tolerance_units(tolerance: float) -> float:
    """Return `tolerance`, inches, in thousandths to the last digit given. Raises WorkError if not finite."""
    return float(_moved("tolerance", tolerance))


def _moved(name: str, inches: float) -> Decimal:
    if not isfinite(inches):
        raise WorkError(f"{name} {inches:g} in: must be a finite number")
    return Decimal(repr(float(inches))).scaleb(_THOUSANDTHS, _EXACT)
