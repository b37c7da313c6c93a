"""The catalogue of faults.

A file of faults is of one room. Before the first fault, and again wherever another source begins, stands what
the faults share:

    [[source]]
    file = "pdp8/computer/hardware/operate.py"
    tests = ["tests/pdp8/computer/hardware/test_operate.py"]      the fewest that catch them

    [[source.fault]]
    name = "CIA leaves the link"
    old = "..."                    in the source exactly once
    new = "..."
    tests = [...]                  where others catch it
"""

import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

FOLDER = Path(__file__).parent


class Fault(NamedTuple):
    """One fault: `old` replaced by `new` in `file`; which tests catch it."""

    room: str
    name: str
    file: str
    old: str
    new: str
    tests: tuple[str, ...]


def catalogue() -> list[Fault]:
    """Return all faults. Raises ValueError where two have one name."""
    faults = [fault for path in sorted(FOLDER.glob("*.toml")) for fault in _read(path)]
    names = [(fault.room, fault.name) for fault in faults]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise ValueError(f"two faults of one name: {sorted(twice)}")
    return faults


def _read(path: Path) -> Iterator[Fault]:
    for source in tomllib.loads(path.read_text())["source"]:
        for fault in source["fault"]:
            yield Fault(
                path.stem,
                fault["name"],
                source["file"],
                fault["old"],
                fault["new"],
                tuple(fault.get("tests", source["tests"])),
            )


def applied(fault: Fault, text: str) -> str:
    """Return `text` with the fault in it. Raises ValueError unless the place is there once."""
    count = text.count(fault.old)
    if count != 1:
        raise ValueError(f"{fault.file} has {fault.old!r} {count} times, not once")
    return text.replace(fault.old, fault.new)
