"""Interrupts, by PAL programs that check themselves: each halts at PASS, or at the FAIL that says what went
wrong.
"""

from pathlib import Path

import pytest

import pal
from pdp8.computer.machine import Machine

FOLDER = Path(__file__).parent / "interrupts"
PROGRAMS = sorted(FOLDER.glob("*.pal"))


def halts(machine: Machine, symbols: dict[str, int]) -> list[str]:
    """Run to PASS or to a FAIL, pressing CONT at STOPS; return the symbols of the halts."""
    names = {address: name for name, address in symbols.items() if name[:4] in ("PASS", "FAIL", "STOP")}
    seen: list[str] = []
    while not seen or seen[-1] == "STOPS":
        stop = machine.run(seconds=10)
        seen.append(names.get(machine.ma, f"{stop.reason} at {machine.pc:04o}"))
    return seen


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.stem)
def test_program(path: Path) -> None:
    assembly = pal.assemble(path.read_text())
    assert assembly.ok
    machine = Machine(highspeed=True)
    machine.load(assembly.words)
    machine.highspeed.reader.load(b"\1")
    if "KSF" in path.read_text():
        machine.teletype.reader.load(b"\1")
    machine.start(0o200)
    stops = ["STOPS"] if "STOPS" in assembly.symbols else []
    assert halts(machine, assembly.symbols) == [*stops, "PASS"]


def test_an_interrupt_is_one_cycle_that_the_lamps_show() -> None:
    machine = Machine()
    machine.load({0o200: 0o6001, 0o201: 0o7001, 0o202: 0o7001, 1: 0o7402})
    machine.start(0o200)
    machine.teletype.transmitter.flag = 1
    processor = machine.processor
    processor.instruction()
    processor.instruction()
    assert (machine.ticks, machine.pc, machine.ac) == (85 + 32, 0o202, 1)
    processor.cycle()
    lamps = machine.panel.lamps
    assert (lamps.ma, lamps.mb, lamps.ir, lamps.execute, lamps.ion) == (0, 0o202, 4, 1, 0)
    assert (machine.ticks, machine.pc, machine.core[0]) == (85 + 32 + 32, 1, 0o202)
