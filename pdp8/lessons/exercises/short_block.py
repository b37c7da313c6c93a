"""The tapes of the exercise `short-block`: blocks of twenty rows, then one that is shorter or longer."""

from random import Random
from typing import Any

from tapes import eia

_ROWS = 20
_DIGITS = eia.encode("0123456789")


def tape(random: Random, case: dict[str, Any]) -> dict[str, Any]:
    """Return a tape in the reader, and the number of its wrong block in the AC."""
    good = random.randint(0, 6)
    wrong = random.choice([rows for rows in range(1, 101) if rows != _ROWS])
    frames = [frame for rows in (*[_ROWS] * good, wrong, _ROWS) for frame in _block(random, rows)]
    return {**case, "reader": frames, "ac": good + 1}


def _block(random: Random, rows: int) -> list[int]:
    return [*random.choices(_DIGITS, k=rows - 1), 0o200]
