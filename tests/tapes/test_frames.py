"""Channels, parity, leader and trailer, a frame drawn."""

import pytest

from tapes import frames
from tapes.errors import TapeError
from tests.tapes.strips import octal


@pytest.mark.parametrize(
    ("parity", "punched"),
    [  # A 101, C 103, CR 015, LF 012, space 040, RUBOUT 177, blank 000; by counting holes
        ("mark", "301 303 215 212 240 377 200"),
        ("even", "101 303 215 012 240 377 000"),
        ("odd", "301 103 015 212 040 177 200"),
        ("none", "101 103 015 012 040 177 000"),
    ],
)
def test_parity(parity: str, punched: str) -> None:
    assert frames.with_parity(octal("101 103 015 012 040 177 000"), parity) == octal(punched)
    assert frames.with_parity(octal("301 303 215 212 240 377 200"), parity) == octal(punched)


def test_unknown_parity_is_an_error() -> None:
    with pytest.raises(TapeError, match="no parity is called 'space': mark, even, odd, none"):
        frames.with_parity(b"A", "space")


def test_every_frame_drawn() -> None:
    for frame in range(256):
        drawn = frames.draw(frame)
        assert drawn[5] == "."
        assert int((drawn[:5] + drawn[6:]).replace("o", "1").replace(" ", "0"), 2) == frame
        assert sum(1 << channel - 1 for channel in frames.channels(frame)) == frame


@pytest.mark.parametrize(
    "pieces", ["000 000 200 200|102 000 001 000|200 000", "|102 000 001 002|", "200 200||", "||"]
)
def test_leader_body_trailer(pieces: str) -> None:
    assert frames.strip(octal(pieces.replace("|", " "))) == tuple(map(octal, pieces.split("|")))


def test_an_end_of_block_is_no_trailer() -> None:
    assert frames.strip(octal("000 040 200 000"), frames.BLANK) == (b"\0", octal("040 200"), b"\0")


@pytest.mark.parametrize(("blanks", "leader", "start"), [(3, 8, 4), (2, 8, None), (3, 7, None)])
def test_a_label_ends_with_blank_tape_and_leader(blanks: int, leader: int, start: int | None) -> None:
    assert frames.leader_start(b"A" + bytes(blanks) + frames.leader(leader) + octal("102 000")) == start


def test_a_label_is_drawn_in_lines_of_72_columns() -> None:
    assert frames.draw_label(b"\0" + octal("200 001 377") * 25 + b"\0") == [
        *([" oo" * 24] + ["  o" * 24] * 6 + [("o o" * 24)]),
        *([" oo"] + ["  o"] * 6 + ["o o"]),
    ]
    assert [frames.has_leader(tape) for tape in (b"\0A", b"\x80A", b"A\0", b"")] == [True, True, False, False]
