"""The measures that take long to compute, kept in measured.json: `pdp8 thesis numbers` is there at once.

`make evidence` computes them again; a test compares each with what is computed.
"""

import json
from collections.abc import Iterable
from functools import cache
from importlib.resources import files
from pathlib import Path

from pdp8.thesis import measures
from pdp8.thesis.measures import Measure

_FILE = "measured.json"


def value(name: str) -> Measure:
    """Return a measure by its name, as `measures.measure` does."""
    return _kept()[name] if measures.takes_long(name) else measures.measure(name)


def computed(names: Iterable[str]) -> dict[str, Measure]:
    """Return the measures of those names that take long, computed."""
    return {name: measures.measure(name) for name in names if name and measures.takes_long(name)}


def write(names: Iterable[str]) -> None:
    """Compute the measures of those names that take long, and keep them."""
    Path(__file__).with_name(_FILE).write_text(json.dumps(computed(names), indent=1) + "\n")


@cache
def _kept() -> dict[str, Measure]:
    kept: dict[str, Measure] = json.loads((files("pdp8.thesis") / _FILE).read_text(encoding="utf-8"))
    return kept
