"""RIM tapes: the loader's own format, and what can be wrong with one; test_binary.py has what judges both."""

import pytest

from tapes import rim
from tapes.errors import TapeError
from tests.conftest import assert_same_tape
from tests.tapes.strips import LEADER, octal, refused


def test_address_and_word_in_four_frames() -> None:
    punched = LEADER + octal("102 000 073 000 177 077 043 021") + LEADER
    assert_same_tape(rim.encode({0o7777: 0o4321, 0o200: 0o7300}), punched)
    assert rim.decode(punched) == {0o7777: 0o4321, 0o200: 0o7300}
    with pytest.raises(TapeError, match="address 10000: a RIM tape can name only 0000 to 7777"):
        rim.encode({0o10000: 0})


def test_leader_between_the_words_and_blank_tape_around() -> None:
    tape = bytes(9) + octal("200 200 102 000 073 000 200 200 102 001 074 002 200 000 000")
    assert rim.decode(tape) == {0o200: 0o7300, 0o201: 0o7402}


@pytest.mark.parametrize(
    ("frames", "frame", "message"),
    [
        ("", 0, "empty tape"),
        ("000 000", 0, "nothing but blank tape"),
        ("200 200", 0, "nothing but leader"),
        ("000 102 000 073 000 200", 1, "102 where the leader (200) was expected"),
        ("200 102 000 073 000", 5, "the tape is cut short: it has no trailer"),
        ("200 102 000 073", 4, "the tape is cut short inside a word"),
        ("200 102 000 073 200", 4, "200 where the second half of a word was expected"),
        ("200 102 102 073 000 200", 2, "102 where the second half of an address was expected"),
        ("200 073 000 200", 1, "073 where the first half of an address was expected"),
        ("200 102 000 073 000 074 002 200", 5, "074 where the first half of an address was expected"),
        ("200 102 000 103 000 200", 3, "103 where a word was expected"),
        ("200 300 000 103 000 200", 1, "300 where the first half of an address was expected"),
    ],
)
def test_what_is_wrong_and_where(frames: str, frame: int, message: str) -> None:
    assert str(refused(rim.decode, octal(frames))) == f"frame {frame}: {message}"
