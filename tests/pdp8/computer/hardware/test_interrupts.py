"""Interrupts, by PAL programs that check themselves: each halts at PASS, or at the FAIL that says what went
wrong.
"""

from pathlib import Path

import pytest

import pal
from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import machine

FOLDER = Path(__file__).parent / "interrupts"
PROGRAMS = sorted(FOLDER.glob("*.pal"))


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_program(path: Path) -> None:
    """CONT is pressed at STOPS."""
    assembly = pal.assemble(path.read_text())
    assert assembly.ok
    m = Machine(highspeed=True)
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


def test_an_interrupt_is_one_cycle_that_the_lamps_show() -> None:
    m = machine("6001 7001 7001 1/ 7402")
    m.teletype.transmitter.flag = 1
    m.processor.instruction()
    m.processor.instruction()
    assert (m.ticks, m.pc, m.ac) == (85 + 32, 0o202, 1)
    m.processor.cycle()
    lamps = m.panel.lamps
    assert (lamps.ma, lamps.mb, lamps.ir, lamps.execute, lamps.ion) == (0, 0o202, 4, 1, 0)
    assert (m.ticks, m.pc, m.core[0]) == (85 + 32 + 32, 1, 0o202)
