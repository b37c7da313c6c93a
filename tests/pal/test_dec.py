"""Beside DEC's own PAL III, DEC-08-ASB1, run on our machine where PDP8_TAPES names a folder with its tape.

The tape is DEC's and no part of this project. Left out are sources after which PAL III writes over itself:
ours stops there.
"""

import os
import random
from pathlib import Path

import pytest

import pal
from pdp8.computer.machine import Machine
from tapes import binary
from tests.conftest import case

FOLDER = os.environ.get("PDP8_TAPES")
TAPE = Path(FOLDER or ".") / "dec-08-asb1-pb"
pytestmark = pytest.mark.skipif(
    FOLDER is None or not TAPE.exists(), reason="PDP8_TAPES names no folder with PAL III"
)
HALT = 0o242  # where PAL III halts after a pass
SWITCHES = (0o2000, 0o4000, 0o6000)
NAMES = ["A", "B", "TAD", "CLA", "JMP", "ION", "X1", "5", "189", "400", "12AB", "0X1F", "1A"]


def source(seed: int) -> str:
    """Return a source of some lines with letters in its numbers."""
    author = random.Random(seed)
    lines = ["*200"]
    for _ in range(author.randrange(1, 6)):
        line = author.choice(["DECIMAL;", "OCTAL;", "", "", "X,", "B="])
        for _ in range(author.randrange(1, 6)):
            number = "".join(author.choice("0123456789ABXO") for _ in range(author.randrange(1, 7)))
            line += number if author.random() < 0.6 else author.choice(NAMES)
            line += author.choice("   +-;!_(\t")
        lines.append(line)
    return "\n".join(lines) + "\n$\n"


def decs(tape: bytes, text: bytes) -> list[bytes]:
    """Return what the Teletype's punch has of the three passes; fewer where PAL III does not end."""
    machine = Machine()
    machine.load(binary.decode(tape[tape.index(0o200) :]).words)
    frames = b"\x80" * 64 + text + b"\x80" * 64
    passes: list[bytes] = []
    for switches in SWITCHES:
        machine.teletype.reader.load(frames)
        machine.panel.sr = 0o200
        machine.panel.load_add()
        machine.panel.sr = switches
        before = len(machine.teletype.punch.tape)
        machine.panel.start()
        if machine.run(4000).pc != HALT:
            break
        passes.append(bytes(machine.teletype.punch.tape[before:]))
    return passes


def compare(tape: bytes, text: str) -> str:
    """Return which pass is other than DEC's, "" if none is or PAL III does not end."""
    frames = bytes(ord(character) | 0o200 for character in text.replace("\n", "\r\n"))
    assembly = pal.assemble(frames)
    theirs = decs(tape, frames)
    if assembly.stopped or len(theirs) < len(SWITCHES):
        return ""
    for number, (our, their) in enumerate(zip(assembly.teletype, theirs, strict=True), 1):
        if our != their:
            return f"pass {number}"
    return ""


def test_letters_in_numbers() -> None:
    for seed in range(20):
        with case(source(seed)):
            assert not compare(TAPE.read_bytes(), source(seed))


@pytest.mark.parametrize("count", [584, 585])
def test_a_full_table(count: int) -> None:
    text = "*200\n" + "".join(f"A{number:04},\t7402\n" for number in range(count)) + f"\tA{count - 1:04}\n$\n"
    assert not compare(TAPE.read_bytes(), text)
