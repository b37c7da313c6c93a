"""Record what DEC's FLOAT makes of 2,000 pairs of operands: + - * / and SQRT.

    python -m tests.programs.dec_float ps8.tu56 tests/programs/float.bin

A program in DEC's 8K FORTRAN II is compiled under PS/8 on our PDP-8/L, and halts at a PAUSE; then operands
are put into core and results taken out of it, each 36 bits: sign, exponent of 8 bits, mantissa of 27.
"""

import random
import sys
from collections.abc import Iterator
from pathlib import Path

from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason
from pdp8.computer.use import bootstrap
from pdp8.replay.fortran import Session, rack
from tapes import dectape, os8

PAIRS = 2000
SIGN = 1 << 35
RESULTS = "SDPQT"
_NAMES = f"AB{RESULTS}C"
_PROGRAM = "".join(f"      {name}={number}.2345678\n" for number, name in enumerate(_NAMES, 1)) + (
    "10    PAUSE\n      S=A+B\n      D=A-B\n      P=A*B\n      Q=A/B\n      T=SQRT(C)\n"
    "      GO TO 10\n      END\n"
)


def pairs() -> Iterator[tuple[int, int]]:
    """Yield the operands: exponents up to 32 places apart, half of the mantissas with few bits."""
    draw = random.Random(1971)
    for _ in range(PAIRS):
        yield _operand(draw), _operand(draw)


def _operand(draw: random.Random) -> int:
    mantissa = 1 << 26 | draw.getrandbits(26)
    if draw.getrandbits(1):
        mantissa &= -1 << draw.randrange(27)
    return draw.getrandbits(1) << 35 | draw.randrange(0o160, 0o220) << 27 | mantissa


def _started(reel: dectape.Image) -> Machine:
    """Return a machine that has halted at the PAUSE."""
    machine = rack(os8.insert(reel, "REC.FT", os8.from_text(_PROGRAM)))
    session = Session(machine)
    bootstrap.boot(machine)
    for _ in session.until("."):
        pass
    for line, prompt in (("R FORT", "*"), ("REC<REC", "."), ("R LOADER", "*")):
        for _ in session.type(line, prompt):
            pass
    for _ in session.type("REC/G"):
        pass
    assert machine.run(300).reason is Reason.HALT
    return machine


def record(reel: dectape.Image) -> bytes:
    """Return the results, five bytes each."""
    machine = _started(reel)
    first = next(at for at in range(0o10000) if machine.core[at] == 0o2014 and machine.core[at + 3] == 0o2024)
    pause, found = machine.pc, bytearray()
    for a, b in pairs():
        for at, number in ((0, a), (3, b), (21, a & ~SIGN)):
            for word in range(3):
                machine.core[first + at + word] = number >> 24 - 12 * word & 0o7777
        stop = machine.run(60)
        assert (stop.reason, stop.pc) == (Reason.HALT, pause)
        for at in range(6, 21, 3):
            high, middle, low = (machine.core[first + at + word] for word in range(3))
            found += (high << 24 | middle << 12 | low).to_bytes(5)
    return bytes(found)


if __name__ == "__main__":
    Path(sys.argv[2]).write_bytes(record(dectape.decode(Path(sys.argv[1]).read_bytes())[0]))
