"""`Assembly.words` is what DEC's BIN loader leaves in core: RIM toggled, BIN read, then our tape.

SOURCES=8000 pytest -k loaded tests/pal     tries 2,000 sources, right and wrong, in both dialects
"""

from copy import copy
from functools import cache

import pal
from pal import punch
from pdp8 import Machine, shelf
from pdp8.computer.stop import Reason
from tapes import rim
from tests.conftest import case
from tests.pal.random_pal8 import PAL8, SEEDS, faulty, written

FREE = range(0o7600)
"""Where no loader is: a tape with a word elsewhere overwrites what reads it (PN57)."""


def read(machine: Machine, start: int, frames: bytes) -> Reason:
    machine.sr = 0o7777
    machine.teletype.reader.lever(False)
    machine.teletype.reader.load(frames)
    machine.start(start)
    machine.run(instructions=8)  # KCC, before the lever is thrown
    machine.teletype.reader.lever(True)
    return machine.run(seconds=1e6).reason


@cache
def with_bin() -> Machine:
    """Return a machine with BIN, which a RIM loader read that was toggled in."""
    machine = Machine()
    machine.load(shelf.bundled_program("rim.pal").words)
    read(machine, 0o7756, rim.encode(shelf.bundled_program("bin.pal").words))
    machine.stop()
    return machine


def loaded(frames: bytes) -> tuple[bool, dict[int, int]]:
    """Return whether BIN halts with a good checksum, and the words it leaves in core."""
    machine = copy(with_bin())
    reason = read(machine, 0o7777, frames)
    good = reason is Reason.HALT and machine.ac == 0
    return good, {address: machine.core[address] for address in FREE if machine.core[address]}


def compare(source: str, dialect: str) -> bool:
    """Compare core with the assembly's words; return whether there were words in core to compare."""
    assembly = pal.assemble(source, dialect=dialect)
    if not assembly.tape or any(address & 0o7777 not in FREE for address in assembly.words):
        return False
    good, core = loaded(assembly.tape.lstrip(b"\0"))  # an operator sets the tape on its leader
    no_loader = any(found.code == "PS02" for found in assembly.diagnostics)
    assert good or no_loader
    found: dict[int, set[int]] = {}
    for address, word in assembly.words.items():
        found.setdefault(address & 0o7777, set()).add(word)  # a machine of one field: the last one stays
    if no_loader:
        return True
    assert core.keys() <= found.keys()
    for address, words in found.items():
        assert core.get(address, 0) in words, f"{address:04o}"
    return True


def test_a_word_is_loaded_at_0_and_none_before_an_origin() -> None:
    assert punch.loaded(b"\x80\x00\x05\x40\x00\x00\x07\x00\x08\x80") == {0: 7}


def test_words_are_what_is_loaded() -> None:
    compared = 0
    for seed in SEEDS[::8]:
        for source in (written(PAL8, seed), faulty(seed)):
            for dialect in ("pal3", "pal8"):
                with case(dialect, source):
                    compared += compare(source, dialect)
    assert compared
