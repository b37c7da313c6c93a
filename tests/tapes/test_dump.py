"""Dumps as other tools write them, whole, cut, and with a line lost; od, xxd and hexdump are what judges."""

import re
import shutil

import pytest

from pdp8 import shelf
from tapes import dump
from tapes.frames import LEADER
from tests import commands

FRAMES = bytes(100) + shelf.read("circle.eia")[:333] + bytes(100) + bytes(range(256))
COMMANDS = [
    "xxd", "xxd -p", "xxd -i", "xxd -b", "xxd -u -g1", "hexdump -Cv", "od -An -to1 -v", "od -to1 -v",
    "od -tx1z -v", "od -Ax", "od -Ax -to2 -v", "od -tx4", "od -Ad -tx8 -v",
    "od", "od -x", "od -b", "od -Ax -tx1", "hexdump", "hexdump -C", "hexdump -b", "xxd -a",
    "pdp8 tape convert - --code bin --to octal",
    "pdp8 tape show - --code eia", "pdp8 tape show -",
]  # fmt: skip


@pytest.mark.parametrize("command", COMMANDS)
def test_what_other_tools_write(command: str) -> None:
    if not shutil.which(command.partition(" ")[0]):
        pytest.skip(f"{command} is not installed")
    done = commands.run(*command.split(), stdin=FRAMES)
    written = done.stdout
    assert done.returncode == 0, done.stderr
    found = dump.found(written)
    assert found
    assert (found.frames, found.gap) == (FRAMES, "")
    few = bytes(range(0o240, 0o264))
    short = dump.found(commands.run(*command.split(), stdin=few).stdout)
    assert short
    assert short.frames == few
    lines = written.splitlines(keepends=True)
    if b"*\n" in lines:  # zeros alone, whose addresses may fit in two bases
        zeros = dump.found(commands.run(*command.split(), stdin=bytes(256)).stdout)
        assert zeros
        assert len(zeros.frames) == 256 or zeros.note.rpartition("; its addresses are taken in base ")[1]
    if not re.match(rb"[0-9a-f]{6,8}[ :]", lines[1 - (lines[1] == b"*\n")]):
        return
    for at in range(1, len(lines) - 2):
        if b"*\n" not in lines[at - 1 : at + 1]:
            excerpt = dump.found(b"".join(lines[at:]))
            assert excerpt
            assert FRAMES.endswith(excerpt.frames)
            assert not excerpt.gap
        if b"*\n" not in (lines[at - 1], lines[at + 1]):  # which then repeats the line before
            lost = dump.found(b"".join([*lines[:at], *lines[at + 1 :]]))
            assert lost
            assert lost.note.endswith("do not follow one another: is a line missing?")


def test_an_address_is_no_reason_to_fill_up_memory() -> None:
    for last, pairs, gap in (b"ffffffffffff0000", 8, True), (b"1f020000", 1 << 16, False):
        found = dump.found(b"1f000000: " + b"8081 " * 8 + b"\n*\n" + last + b": " + b"8283 " * 8)
        assert found
        assert (found.frames, bool(found.gap)) == (b"\x80\x81" * pairs + b"\x82\x83" * 8, gap)


TAPE = bytes([0] + [LEADER] * 20) + FRAMES
DIGITS = FRAMES[100:433]
CHANNELS = ["".join([" o"[frame >> at & 1] for at in range(8)]) for frame in FRAMES]
DRAWN = "".join([f"|{row[:3]}.{row[3:]}| {frame:02x}\n" for row, frame in zip(CHANNELS, FRAMES, strict=True)])
"""From channel 1 on."""


@pytest.mark.parametrize(
    ("frames", "text"),
    [
        (FRAMES, "char tape[] = {" + ",\n".join([str(frame) for frame in FRAMES]) + "};"),
        (b" 1" * 8, f"tape = {[*map(hex, b' 1' * 8)]}".replace("'", "")),
        (DIGITS, f"tape = {[*map(oct, DIGITS)]}".replace("'", "")),
        (b"\1\2" * 8, "".join([f"{at:07o} 0201\n" for at in range(0, 16, 2)])),
        (b"dekg" * 4, f"tape = {[100, 101, 107, 103] * 4}"),
        (TAPE, "\n".join([str(frame) for frame in TAPE])),
        (TAPE, "".join([f"{at:07o} {frame:3}\n" for at, frame in enumerate(TAPE)])),
        (TAPE, "int tape[] = {" + ", ".join([f"0{frame:o}" for frame in TAPE]) + "};"),
        (TAPE, " ".join([f"{frame:o}" for frame in TAPE])),
        (TAPE, " ".join([f"{frame:x}" for frame in TAPE])),
        (FRAMES, "# Tape Label: MAINDEC-08-D1L2-PM\n#Start\n" + FRAMES.hex("\n").upper() + " # its end\n"),
        (FRAMES, "|   1 inch Tape Reader  |\n+----+\n" + DRAWN),
        (FRAMES, "".join([f"{frame:04o}\r\n" for frame in FRAMES]) + "\x1a"),
    ],
)
def test_numbers_as_programs_write_them(frames: bytes, text: str) -> None:
    """The last as the collection of DEC's tapes for velocityboy's emulator has each tape, from CP/M."""
    found = dump.found(text.encode())
    assert found
    assert found.frames == frames


@pytest.mark.parametrize("name", ["circle.asc", "circle.eia", "eia.bin", "eia.pal", "hello.pal"])
def test_what_is_no_dump(name: str) -> None:
    assert dump.found(shelf.read(name)) is None


@pytest.mark.parametrize(
    "figures",
    [
        "0,0\n10,0\n10,10\n0,10\n",
        "128 129 130 131 132 133 134 135",
        "7300\n1250\n7402\n" * 9,
        "1971: 12345678901234567890123456789012\n",
        DRAWN + "| oo |\n" + DRAWN,
    ],
)
def test_figures_are_no_dump(figures: str) -> None:
    """Points of a part, or data of a program, which no leader begins."""
    assert dump.found(figures.encode()) is None
    assert dump.found(b"0010000000000003588\n0029030000350000189\n" * 9) is None
