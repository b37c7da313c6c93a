"""The catalogue of faults.

A file of faults is of one area; each of its sources has faults, a line each:

    ["pdp8/computer/hardware/operate.py"]
    tests = ["tests/pdp8/computer/hardware/test_instructions.py"]      the fewest that catch them
    "CIA leaves the link" = { old = "...", new = "..." }                `old` is in the source exactly once
    "..." = { old = "...", new = "...", tests = [...] }                 where others catch it
"""

import tomllib
from pathlib import Path
from typing import NamedTuple

FOLDER = Path(__file__).parent


class Fault(NamedTuple):
    """One fault: `old` replaced by `new` in `file`; which tests catch it."""

    package: str
    name: str
    file: str
    old: str
    new: str
    tests: list[str]


def catalogue() -> list[Fault]:
    return [
        Fault(path.stem, name, file, **{"tests": faults["tests"], **fault})
        for path in sorted(FOLDER.glob("*.toml"))
        for file, faults in tomllib.loads(path.read_text()).items()
        for name, fault in faults.items()
        if name != "tests"
    ]


def applied(fault: Fault, text: str) -> str:
    """Return `text` with the fault in it. Raises ValueError unless the place is there once."""
    count = text.count(fault.old)
    if count != 1:
        raise ValueError(f"{fault.file} has {fault.old!r} {count} times, not once")
    return text.replace(fault.old, fault.new)
