"""Interrupts, by PAL programs that check themselves: each halts at PASS, or at the FAIL that says what went
wrong.
"""

from pathlib import Path

import pytest

import pal
from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.machine import Machine

FOLDER = Path(__file__).parent / "interrupts"
PROGRAMS = sorted(FOLDER.glob("*.pal"))


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_program(path: Path) -> None:
    """CONT is pressed at STOPS."""
    assembly = pal.assemble(path.read_text())
    assert assembly.ok
    m = Machine(one_of_each())
    m.load(assembly.words)
    m.highspeed.reader.load(b"\1")
    if "KSF" in path.read_text():
        m.teletype.reader.load(b"\1")
    m.start(0o200)
    names = {address: name for name, address in assembly.symbols.items()}
    expected = ["STOPS", "PASS"] if "STOPS" in assembly.symbols else ["PASS"]
    assert [(m.run(seconds=10).reason, names.get(m.ma)) for _ in expected] == [
        ("halt", name) for name in expected
    ]
