"""Quantities as they are said: counts with their units, times, lengths in inches, ranges of addresses."""

from collections.abc import Iterable


def duration(seconds: float) -> str:
    """Return a time as hours, minutes and seconds, to a tenth of a second."""
    tenths = round(seconds * 10)
    minutes, tenths = divmod(tenths, 600)
    hours, minutes = divmod(minutes, 60)
    said = f"{tenths / 10:.1f} s"
    if minutes or hours:
        said = f"{minutes} min {said}"
    return f"{hours} h {said}" if hours else said


def inches(thousandths: float) -> str:
    """Return a length in thousandths of an inch as drawings give it, in inches: .0106, 1.2500, -.0046."""
    whole, point, decimals = f"{thousandths / 1000:.4f}".partition(".")
    sign, digits = ("-", whole[1:]) if whole.startswith("-") else ("", whole)
    return f"{sign}{'' if digits == '0' else digits}{point}{decimals}"


def counted(number: int, unit: str) -> str:
    """Return a number with its unit, a plural: "no frames", "1 frame", "13,321 frames"."""
    if number == 1:
        return f"1 {unit.removesuffix('s')}"
    return f"{number:,} {unit}" if number else f"no {unit}"


def ranges(addresses: Iterable[int]) -> str:
    """Return runs of addresses, 0200-0351, joined by commas."""
    runs: list[list[int]] = []
    for address in sorted(addresses):
        if runs and address == runs[-1][1] + 1:
            runs[-1][1] = address
        else:
            runs.append([address, address])
    said = [f"{first:04o}-{last:04o}" if last > first else f"{first:04o}" for first, last in runs]
    return ", ".join(said) or "none"
