"""Inches, as commands and chapters give lengths, in thousandths, the unit of the machine."""

from math import isfinite

from tapes.errors import WorkError
from tapes.hydrapoint import RESOLUTION


def thousandths(name: str, inches: float) -> int:
    """Return `inches` in thousandths. Raises WorkError unless it is a whole number of them."""
    units = inches / RESOLUTION
    if not isfinite(units) or abs(units - round(units)) > 1e-6:
        raise WorkError(f"{name} {inches:g} in: must be a whole number of thousandths of an inch")
    return round(units)


def tolerance_units(tolerance: float) -> float:
    """Return `tolerance`, inches, in thousandths to the last digit given. Raises WorkError if not finite."""
    units = round(tolerance / RESOLUTION, 9)
    if not isfinite(units):
        raise WorkError(f"tolerance {tolerance:g} in: must be a finite number")
    return units
