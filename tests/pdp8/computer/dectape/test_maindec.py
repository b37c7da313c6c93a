"""DEC's own tests of DECtape, of memory extension and of the DF32, on our machine.

Their tapes are DEC's and not here: PDP8_MAINDEC=FOLDER names a folder with those of docs/rack.md.
"""

import os
from array import array
from pathlib import Path
from typing import NamedTuple

import pytest

from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.hardware.extension import MEMORY
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.computer.rack.df32 import DF32
from tapes import binary
from tapes.dectape import BLOCKS, WORDS, Image

TAPES = Path(os.environ.get("PDP8_MAINDEC", ""))
LIMITS = "TEST LIMITS\r\n0,1\r\r\nSETUP SR\r\r\nFIELD     OCTAL ADR.     GOOD     BAD     TEST"


class Maindec(NamedTuple):
    """One of DEC's: where it starts; the switches then and after its halts; what it then types in so long,
    and where it halts, if it does.
    """

    tape: str
    start: int
    switches: list[int]
    seconds: float
    page: str = ""
    halt: int = 0
    size: str = "4k"


TESTS = [
    Maindec("08-d3ra", 0o200, [0o3400, 0], 180),
    *(
        test
        for tape in ("08-d3bc", "08-ditca-a")
        for test in (
            Maindec(tape, 0o201, [0o4000, 0], 65, halt=0o2564 if tape == "08-d3bc" else 0o2565),
            Maindec(tape, 0o203, [0o4000, 0], 120),
            Maindec(tape, 0o204, [0o4000, 0], 240, "0000 END"),
            Maindec(tape, 0o205, [0o4000, 0], 240),
        )
    ),
    Maindec("08-d3eb", 0o200, [0o10, 0o10], 240, size="8k"),
    Maindec("08-d1gb", 0o200, [0o17], 160, "\a\a\a", size="32k"),
    Maindec("08-d1gd", 0o200, [0o17], 600, "\a\a", size="32k"),
    *(Maindec(tape, 0o200, [0], 120, LIMITS, size="8k") for tape in ("08-d1eb", "08-d1ec", "08-d1ha")),
    Maindec("08-d5db", 0o150, [0], 600, "1 EXISTENT DISK(S)"),
]


def page(m: Machine) -> str:
    """Return what was printed."""
    return "".join(chr(frame & 0o177) for frame in bytes(m.teletype.printer.frames)).replace("\x7f", "")


def type_slowly(m: Machine, keys: str) -> None:
    """Press each key half a second after the one before."""
    for key in keys:
        m.run(0.5)
        m.teletype.keyboard.press(bytes([ord(key) | 0o200]))


@pytest.mark.slow("minutes of 1971")
@pytest.mark.parametrize("test", TESTS, ids=[f"{test.tape}-{test.start:o}" for test in TESTS])
def test_dec_finds_no_fault(test: Maindec) -> None:
    path = TAPES / f"maindec-{test.tape}-pb"
    path = path if path.exists() else path.with_suffix(".bin")
    if not (os.environ.get("PDP8_MAINDEC") and path.exists()):
        pytest.skip("PDP8_MAINDEC=FOLDER names DEC's tapes")
    control = TC08()
    for drive in control.drives[:4]:
        drive.mount(Image(array("H", [0] * (BLOCKS * WORDS))))
    m = Machine([Teletype(), control, DF32()], MEMORY[test.size])
    m.load(binary.decode(path.read_bytes()).words)
    m.panel.sr = test.switches[0]
    m.start(test.start)
    for switches in test.switches[1:]:
        assert m.run(10).reason == "halt"
        m.panel.sr = switches
        m.panel.cont()
    if test.page == LIMITS:
        m.run(2)
        type_slowly(m, "0,1\r")
        m.run(3)
        type_slowly(m, "\r")
    m.run(test.seconds)
    assert page(m).strip("\r\n\0") == test.page
    assert m.processor.run == (not test.halt), f"halt at {m.pc:04o}"
    assert m.pc == test.halt if test.halt else m.elapsed >= test.seconds
