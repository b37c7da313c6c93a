"""The keys of a Model 33 by the table of its codes."""

import pytest

from pdp8.computer.use.keys import Paper, sent

CONTROL = "\0\1\2\3\4\5\6\a\b\t\n\v\f\r\x0e\x0f\x10\x11\x12\x13\x14\x15\x16\x17\x18\x19\x1a"


@pytest.mark.parametrize(
    ("first", "keys"),
    [
        *((0o200, CONTROL), (0o235, "\x1d\x1e\x1f"), (0o375, "\x1b"), (0o377, "\x7f")),
        (0o240, " !\"#$%&'()*+,-./0123456789:;<=>?"),
        (0o300, "@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_"),
        (0o301, "abcdefghijklmnopqrstuvwxyz"),
    ],
)
def test_each_key_sends_its_code(first: int, keys: str) -> None:
    assert list(sent(keys)) == list(range(first, first + len(keys)))


def test_here_is_sends_blank_frames_and_what_has_no_key_nothing() -> None:
    assert (sent("\x1c"), sent("`{|}~\x80É")) == (bytes(20), b"")


@pytest.mark.parametrize(
    ("typed", "lines", "column"),
    [
        (b"", [""], 0),
        (b"AB\rC", ["CB"], 1),  # typed over
        (b"AB\r  X", ["ABX"], 3),  # a space leaves what is there
        (b"AB\nC", ["AB", "  C"], 3),  # LINE FEED leaves the carriage where it is
        (b"A\x07\0\xffB", ["AB"], 2),  # BELL, blank tape and RUBOUT print nothing
        (b"1\r\n2\r\n3\r\n4", ["2", "3", "4"], 1),  # so many lines are kept
        (b"0" * 71 + b"12\r9", ["9" + "0" * 70 + "2"], 1),  # at the last of 72 columns it stays
        (b"0" * 80, ["0" * 72], 71),
    ],
)
def test_the_paper_of_a_model_33(typed: bytes, lines: list[str], column: int) -> None:
    paper = Paper(3)
    for frame in typed:
        paper.take(frame)
    assert (paper.lines, paper.column) == (lines, column)
