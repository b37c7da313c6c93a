"""What DEC-08-ASB1, DEC's own PAL III of February 1967, made of eight sources.

NAME.bin is the tape of the high-speed punch, raw; NAME.passN.txt is what the Teletype printed in a pass,
without the codes that do not print and with CR LF as one line end.
"""

from itertools import zip_longest
from pathlib import Path

import pytest

import pal
from pal.assembly import Assembly
from tapes import binary
from tapes.frames import draw

EXAMPLES = Path(__file__).parent / "examples"
NAMES = sorted(path.stem for path in EXAMPLES.glob("*.pal"))


def assembled(name: str) -> Assembly:
    return pal.assemble((EXAMPLES / f"{name}.pal").read_bytes())


def assert_same_tape(ours: bytes, theirs: bytes) -> None:
    for number, (our, their) in enumerate(zip_longest(ours, theirs)):
        if our != their:
            shown = " and ".join(
                "no frame" if frame is None else f"[{draw(frame)}]" for frame in (our, their)
            )
            pytest.fail(f"frame {number}: ours and DEC's are {shown}")


def assert_same_print(ours: str, theirs: str) -> None:
    for number, (our, their) in enumerate(zip_longest(ours.split("\n"), theirs.split("\n")), 1):
        assert our == their, f"line {number} of the print"
    assert ours == theirs


def test_there_are_examples() -> None:
    assert len(NAMES) == 8


@pytest.mark.parametrize("name", NAMES)
def test_the_tape_is_decs_frame_for_frame(name: str) -> None:
    assert_same_tape(assembled(name).tape, (EXAMPLES / f"{name}.bin").read_bytes())


@pytest.mark.parametrize("number", [1, 2, 3])
@pytest.mark.parametrize("name", NAMES)
def test_the_teletype_prints_what_it_printed(name: str, number: int) -> None:
    assert_same_print(assembled(name).printed(number), (EXAMPLES / f"{name}.pass{number}.txt").read_text())


@pytest.mark.parametrize("name", NAMES)
def test_the_asr_33_punches_the_same_print(name: str) -> None:
    assembly = assembled(name)
    for number in (1, 3):
        frames = assembly.teletype[number - 1].translate(None, bytes((0, 0o200, 0o377, 0o204)))
        text = bytes(frame & 0o177 for frame in frames).decode().replace("\r\n", "\n")
        assert_same_print(text, (EXAMPLES / f"{name}.pass{number}.txt").read_text())


@pytest.mark.parametrize("name", NAMES)
def test_the_loader_skips_the_messages_on_the_asr_33s_tape(name: str) -> None:
    assembly = assembled(name)
    tape = assembly.teletype.pass2
    assert binary.decode(tape).words == assembly.words
    without = bytearray()
    for number, piece in enumerate(tape.split(b"\xff")):
        without += piece if number % 2 == 0 else b""
    assert_same_tape(bytes(without), (EXAMPLES / f"{name}.bin").read_bytes())


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("form", ["CR LF", "CR", "mark", "even", "leader and rubouts"])
def test_the_form_of_the_source_tape_does_not_matter(name: str, form: str) -> None:
    text = (EXAMPLES / f"{name}.pal").read_bytes()
    line_end = {"CR": b"\r", "leader and rubouts": b"\r\0\xff\n\xff\xff"}.get(form, b"\r\n")
    tape = text.replace(b"\n", line_end)
    if form == "mark":
        tape = bytes(frame | 0o200 for frame in tape)
    elif form == "even":
        tape = bytes(frame | 0o200 * (frame.bit_count() % 2) for frame in tape)
    elif form == "leader and rubouts":
        tape = b"\0" * 5 + b"\x80" * 20 + tape + b"\x80" * 20
    assembly = pal.assemble(tape)
    assert_same_tape(assembly.tape, (EXAMPLES / f"{name}.bin").read_bytes())
    assert_same_print(assembly.listing, (EXAMPLES / f"{name}.pass3.txt").read_text())
