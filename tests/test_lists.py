"""Lists that are cut: as many as are shown have no more, and of one beyond it is said."""

from collections.abc import Callable
from pathlib import Path

import pytest

from pdp8.computer.use import program
from pdp8.lessons import scores
from pdp8.lessons.answer import Answer, assembled
from pdp8.lessons.marking import Failure, Mark
from tapes import ascii, codes, doubts, os8
from tapes.errors import TapeError, WorkError
from tests.conftest import Call, case
from tests.tapes.test_os8 import empty

UNDEFINED = "*200\n{}\tHLT\n$\n"
TEXT = "THE QUICK BROWN FOX JUMPS OVER THE LAZY DOG\n" * 20


def source(number: int) -> str:
    return UNDEFINED.format("".join(f"\tTAD Q{at}\n" for at in range(number)))


def doubtful(number: int) -> bytes:
    """Return a tape with so many frames of wrong parity."""
    tape = bytearray(ascii.encode(TEXT, "even"))
    for at in range(number):
        tape[100 + 50 * at] ^= 0o100
    return bytes(tape)


def of_a_program(number: int) -> str:
    with pytest.raises(WorkError) as raised:
        program.read(source(number).encode(), "x.pal", dialect="pal3")
    return str(raised.value)


def of_doubts(number: int) -> str:
    with pytest.raises(TapeError) as raised:
        doubts.check(doubtful(number), codes.ASCII)
    return str(raised.value)


def of_a_directory(number: int) -> str:
    image = empty()
    for at in range(number):
        image = os8.insert(image, f"F{at}.PA", os8.from_text("*200"))
    with pytest.raises(TapeError) as raised:
        os8.words(image, "NONE.PA")
    return str(raised.value)


def of_an_answer(number: int) -> str:
    return assembled(Answer("x.pal", source=source(number)), "pal3").fault


def of_a_mark(number: int) -> str:
    return "\n".join(scores.said(Mark("case", 0, 1, tuple([Failure("AC", "0001", "0002")] * number))))


SHOWN: dict[Callable[[int], str], int] = {
    of_a_program: 3,
    of_doubts: 5,
    of_a_directory: 8,
    of_an_answer: 5,
    of_a_mark: 6,
}


@pytest.mark.parametrize("said", SHOWN, ids=lambda made: str(made.__name__))
def test_a_list_that_is_shown_whole_has_no_more(said: Callable[[int], str]) -> None:
    for number in (1, SHOWN[said], SHOWN[said] + 1, SHOWN[said] + 5):
        more = number - SHOWN[said]
        with case(number):
            assert ("more" in said(number)) == (more > 0)
            assert more <= 0 or f"and {more} more" in said(number)


def test_eight_mends_are_proposed_at_most() -> None:
    for number in (1, 8, 9):
        with case(number):
            mends = of_doubts(number).partition("--mend ")[2].partition(" ")[0]
            assert len(mends.split(",")) == min(number, 8)


@pytest.mark.parametrize("number", [5, 6])
def test_doubts_that_are_accepted_are_said_as_far_as_five(number: int, call: Call) -> None:
    Path("x").write_bytes(doubtful(number))
    said = call("pdp8 tape convert x --to text --accept")[2]
    assert said.count("taken as punched") == 5
    assert ("and 1 more" in said, "more" in said) == (number > 5, number > 5)
