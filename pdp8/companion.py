"""The nominal curve in a file beside the tape that was made for it: cam.json beside cam.asc and cam.eia.

    part ──► cam.asc, cam.json ── eia.pal ──► cam.eia ──► nc: is cam.json there, and of these blocks?

`blocks` is a digest of the tape's digits, so that the curve of another tape is not taken for this one's.
"""

import json
import os
from collections.abc import Iterable
from hashlib import sha256
from math import isfinite
from typing import Any, get_args

from tapes.errors import WorkError
from tapes.nominal import SIDES, Kind, Nominal
from tapes.text import lines_of

_MARK = "pdp8 nominal curve"
_COUNTS = {"line": 4, "circle": 3, "ellipse": 4, "function": 4, "profile": 2}


def beside(tape: str) -> str:
    """Return the name of the file that belongs to a tape."""
    return f"{os.path.splitext(tape)[0]}.json"


def digest(blocks: Iterable[str]) -> str:
    """Return a digest of a tape's blocks of 19 digits, blanks counted as zeros."""
    return sha256("\n".join(blocks).replace(" ", "0").encode()).hexdigest()[:16]


def written(nominal: Nominal, printout: str) -> str:
    """Return the file's text for a printout."""
    curve = {name: value for name, value in nominal._asdict().items() if value not in ("", ())}
    return json.dumps({"is": _MARK, **curve, "blocks": digest(lines_of(printout))}, indent=1) + "\n"


def is_one(text: str) -> bool:
    """Whether the text is that of such a file, valid or not."""
    return _MARK in text


def read(text: str) -> tuple[Nominal, str]:
    """Return the curve, and the digest of its tape's blocks. Raises WorkError for what is no such file."""
    try:
        found = json.loads(text)
        blocks = str(found.pop("blocks", ""))
        if found.pop("is", None) != _MARK:
            raise ValueError(f'"is" has to be "{_MARK}"')
        numbers, points = tuple(map(float, found.pop("numbers"))), found.pop("points", ())
        nominal = Nominal(numbers=numbers, points=tuple((float(x), float(y)) for x, y in points), **found)
        _check(nominal)
    except (ValueError, TypeError, KeyError, AttributeError) as error:
        raise WorkError(f"it is not a whole nominal curve: {error}") from error
    return nominal, blocks


def _check(nominal: Nominal) -> None:
    """Raise ValueError for impossible values."""
    if nominal.kind not in get_args(Kind):
        raise ValueError(f"kind {nominal.kind!r} is not one of {', '.join(get_args(Kind))}")
    if len(nominal.numbers) != _COUNTS[nominal.kind]:
        raise ValueError(f"{len(nominal.numbers)} numbers; a {nominal.kind} has {_COUNTS[nominal.kind]}")
    if nominal.side not in ("", *SIDES[nominal.kind]):
        raise ValueError(f"side {nominal.side!r} is not a side of a {nominal.kind}")
    lengths: list[Any] = [*nominal.numbers, nominal.cutter, nominal.tolerance, *sum(nominal.points, ())]
    if not all(isfinite(length) for length in lengths) or min(nominal.cutter, nominal.tolerance) <= 0:
        raise ValueError("cutter and tolerance have to be greater than 0, and all numbers finite")
    if nominal.kind in ("function", "profile") and not (nominal.expression or nominal.points):
        raise ValueError(f"a {nominal.kind} needs an expression")
