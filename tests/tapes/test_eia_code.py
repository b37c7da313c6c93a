"""EIA RS-244 against the published hexadecimal table and the thesis's constants."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pdp8 import shelf
from tapes import eia
from tapes.errors import TapeError, TextError
from tests.tapes.strips import octal, refused

TABLE = """
0 20  1 01  2 02  3 13  4 04  5 15  6 16  7 07  8 08  9 19
A 61  B 62  C 73  D 64  E 75  F 76  G 67  H 68  I 79
J 51  K 52  L 43  M 54  N 45  O 46  P 57  Q 58  R 49
S 32  T 23  U 34  V 25  W 26  X 37  Y 38  Z 29
/ 31  . 6B  , 3B  + 70  - 40  & 0E  ( 1A  ) 4A  % 0B
"""
"""Hexadecimal, as N/C manuals print it; % is the stop code."""

NAMED = {" ": 0x10, "\n": 0x80, "\b": 0x2A, "\t": 0x3E, eia.UPPER_CASE: 0x7C, eia.LOWER_CASE: 0x7A}


PUBLISHED = {character: int(code, 16) for character, code in zip(*[iter(TABLE.split())] * 2, strict=True)}
ASSIGNED = PUBLISHED | NAMED


def test_the_whole_table() -> None:
    assert ASSIGNED == eia.CODES
    assert eia.encode("g01x") == eia.encode("G01X")


def test_every_frame_has_its_name() -> None:
    names = {code: character for character, code in PUBLISHED.items()}
    names |= {0o000: "blank", 0o200: "EOB", 0o177: "DEL", 0o020: "space", 0o076: "TAB", 0o052: "BS"}
    names |= {0o013: "stop", 0o174: "UC", 0o172: "LC"}
    assert [eia.name(frame) for frame in range(256)] == [names.get(frame, "?") for frame in range(256)]


@given(st.text(st.sampled_from(sorted(eia.CODES))))
def test_what_is_punched_is_read(text: str) -> None:
    assert eia.decode(eia.encode(text)) == text


def test_blank_tape_around_the_data_and_deletes_in_it_say_nothing() -> None:
    assert eia.decode(octal("000 000 001 177 002 200 000")) == "12\n"
    assert eia.decode(b"") == ""


def test_exactly_the_assigned_frames_are_read() -> None:
    read = {frame for frame in range(1, 256) if refused(eia.decode, bytes([frame])) is None}
    assert read == {*ASSIGNED.values(), 0o177}


@pytest.mark.parametrize(
    ("tape", "frame", "message"),
    [
        ("000 040 003 200", 2, "003 (channels 2 1) is no EIA code: an even number of holes"),
        ("040 133", 1, "133 (channels 7 5 4 2 1) is no EIA code: not assigned"),
        ("040 377 000 001", 1, "377"),
        ("040 000 377 001", 1, "blank frame inside the data"),
    ],
)
def test_the_first_bad_frame_is_named(tape: str, frame: int, message: str) -> None:
    error = refused(eia.decode, octal(tape))
    assert error
    assert error.frame == frame
    assert str(error).startswith(f"frame {frame}: {message}")


@pytest.mark.parametrize("character", ["!", "é", "Ā", "?", "\r", "ı"])
def test_a_character_without_a_code_is_named_by_line_and_column(character: str) -> None:
    with pytest.raises(TextError, match=r"line 2, column 3: .* has no EIA code"):
        eia.encode(f"12\n34{character}\n")


def test_a_clean_tape_has_digits_and_ends_of_block_alone() -> None:
    """The codes that program 2 passes on: LF as 332, RUBOUT as 117 (Chapter 5)."""
    assert eia.clean(octal("000 000 040 332 031 117 117 000 020 200")) == octal("000 000 040 031 200")
    assert eia.clean(bytes(3)) == bytes(3)
    with pytest.raises(TapeError, match="it has no digit and no end of block"):
        eia.clean(shelf.read("circle.asc"))
