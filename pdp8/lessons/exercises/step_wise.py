"""The cuts of the exercise `step-wise`, worked out as its task says."""

from random import Random
from typing import Any


def cuts(random: Random, case: dict[str, Any]) -> dict[str, Any]:
    """Return the case with alternating lengths along X and Y from 0400 on, ended by 0."""
    rise, run, band, length = (case["deposit"][name] for name in ("RISE", "RUN", "BAND", "LENGTH"))
    error, found = 0, []
    while length:
        along_x = along_y = 0
        while length and error + rise <= band:
            error, length, along_x = error + rise, length - 1, along_x + 1
        found.append(along_x)
        while length and error - run >= -band:
            error, along_y = error - run, along_y + 1
        found += [along_y] * (length > 0)
    return {**case, "core": {f"{0o400 + at:04o}": cut for at, cut in enumerate([*found, 0])}}
