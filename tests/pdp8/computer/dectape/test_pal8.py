"""OS/8's own PAL8 on our machine beside ours, exact: random sources, and the tapes are equal.

    PDP8_OS8=FOLDER SOURCES=100 pytest tests/pdp8/computer/dectape/test_pal8.py

FOLDER has os8.tu56, as docs/rack.md fetches it. Each source is a file on a reel of its own, on drive 1. Left
out is PAUSE, at which DEC's PAL8 ends a file and ours does not.

Source: OS/8 Software Support Manual (directory, three characters in two words).
"""

import os
from array import array
from pathlib import Path

import pytest

import pal
from pdp8.computer.dectape.tc08 import TC08
from tapes.dectape import BLOCKS, WORDS, Image
from tests.pal.random_pal8 import PAL8, faulty, written
from tests.pdp8.computer.dectape.test_systems import Ours

IMAGE = Path(os.environ.get("PDP8_OS8", "")) / "os8.tu56"
NAME, SOURCE, BINARY = 0o2300, 0o2001, 0o0216
"""S, PA and BN in six-bit codes."""
FIRST, LENGTH = 7, 730
"""The first block of files, and how many there are."""


def reel(source: str) -> Image:
    """Return a tape with the source as S.PA."""
    codes = [ord(character) | 0o200 for character in source.replace("\n", "\r\n") + "\x1a"]
    codes += [0] * (-len(codes) % 384)
    words = [0] * (BLOCKS * WORDS)
    blocks = len(codes) // 384
    directory = [-2, FIRST, 0, 0, -1, NAME, 0, 0, SOURCE, 0, -blocks, 0, blocks - LENGTH]
    content = {256 + place: word & 0o7777 for place, word in enumerate(directory)}
    for at in range(0, len(codes), 3):
        one, two, three = codes[at : at + 3]
        place = 256 * FIRST + at // 3 * 2
        content |= {place: one | three >> 4 << 8, place + 1: two | (three & 0o17) << 8}
    for place, word in content.items():
        words[WORDS * (place // 128) + place % 128] = word
    return Image(array("H", words))


def punched(tape: Image) -> bytes:
    """Return the frames of S.BN, without leader and trailer."""
    words = [tape.words[WORDS * (place // 128) + place % 128] for place in range(256 * (FIRST + LENGTH))]
    at, block = 256 + 5, FIRST
    while words[at : at + 4] != [NAME, 0, 0, BINARY]:
        length = at + 1 if words[at] == 0 else at + 5
        block += -words[length] & 0o7777
        at = length + 1
    frames = bytearray()
    for place in range(256 * block, 256 * (block + (-words[at + 5] & 0o7777)), 2):
        one, two = words[place : place + 2]
        frames += bytes([one & 0o377, two & 0o377, one >> 8 << 4 | two >> 8])
    return bytes(frames).rstrip(b"\0\x9a").strip(b"\x80")  # a checksum may end in 000


@pytest.mark.slow("a minute of 1971 for each source")
@pytest.mark.skipif(not IMAGE.exists(), reason="PDP8_OS8=FOLDER names the folder with os8.tu56")
def test_the_tapes_of_decs_pal8_are_ours() -> None:
    system = Ours(IMAGE, 0o100000)
    control = system.machine.devices[-1]
    assert isinstance(control, TC08)
    system.until(".")
    for seed in range(int(os.environ.get("SOURCES", "3"))):
        source = (written(PAL8, seed) if seed % 4 else faulty(seed)).replace("PAUSE", "NOP")
        control.drives[1].mount(reel(source))
        system.press("R PAL8\r")
        system.until("*")
        system.press("DTA1:S.BN<DTA1:S.PA\r")
        system.until("\r\n.")
        tape = control.drives[1].written()
        assert tape is not None
        ours = pal.assemble(source, dialect="pal8", exact=True).tape
        assert punched(tape) == ours.strip(b"\x80"), f"source {seed}"
