"""Beside DEC's own BIN loader, DEC-08-LBAA, run on our machine where PDP8_TAPES names a folder with its tape.

Each BIN tape of that folder is read, such as those of data/tapes/dec in velocityboy/pdp-8.
"""

import os
from pathlib import Path

import pytest

from pdp8.computer.machine import LoadError, Machine
from pdp8.computer.use.operator import Operator
from tapes import codes, rim
from tests.conftest import case

FOLDER = Path(os.environ.get("PDP8_TAPES", "nowhere"))
LOADER = FOLDER / "dec-08-lbaa-pm"
pytestmark = pytest.mark.skipif(not LOADER.exists(), reason="PDP8_TAPES names no folder with dec-08-lbaa-pm")


@pytest.mark.slow("8 s for 230 tapes")
def test_each_tape_is_read_as_decs_loader_reads_it() -> None:
    """Those apart that load over the loader: they are for another one."""
    loader = rim.decode(LOADER.read_bytes())
    for file in sorted(FOLDER.rglob("*")):
        frames = file.read_bytes() if file.is_file() and file.stat().st_size < 100_000 else b""
        if not frames or codes.recognise(frames) is not codes.BIN:
            continue
        words = codes.BIN.readable(frames)
        if loader.keys() & words.keys():
            continue
        machine = Machine(memory=1 << 15)
        machine.load(loader)
        with case(file.name):
            try:
                Operator(machine).read_bin(frames)
            except LoadError:
                assert codes.BIN.damage(frames)
            else:
                assert codes.BIN.damage(frames) is None
                assert {at: machine.core[at] for at in words} == words
