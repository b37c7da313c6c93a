"""Tests of the register with wider bounds; each prints what it found."""

import sys
from itertools import product

from programs import circle, polynomial


def radii() -> str:
    """Sixteen values of RAD from 1745 on: the tape of the listing."""
    listed = circle.part()
    tapes = [circle.part(radius=rad, start_x=1750, inner=1745, outer=1755) for rad in range(1745, 2001, 16)]
    return f"{tapes.count(listed)} of {len(tapes)} radii give the same tape"


def ranges() -> str:
    """Ranges of the polynomial in eighths of an inch, not in quarters: those within 2 % of 1200 blocks."""
    eighths = product(range(-8, 0), range(49, 55))
    blocks = [
        polynomial.part(from_=one / 8, to=other / 8, origin_y=5.0).count("\n") for one, other in eighths
    ]
    return f"{sum(abs(count / 1200 - 1) <= 0.02 for count in blocks)} of {len(blocks)} ranges are within 2 %"


if __name__ == "__main__":
    print({"radii": radii, "ranges": ranges}[sys.argv[1]]())
