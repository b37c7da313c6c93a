"""ITA2: letters and figures, as telex machines punched them."""

import pytest

from tapes import codes
from tapes.errors import TextError
from tests.tapes.strips import octal


def test_letters_and_figures() -> None:
    """RYRYRY 1/2 by the alphabet of CCITT F.1: 12 and 25 are R and Y, 33 shifts to figures, 37 back."""
    tape = octal("037 012 025 004 033 027 035 023 004 037 021 010 002")
    assert codes.recognise(tape) is codes.named("ita2")
    assert codes.named("ita2").captions(tape)[:6] == ["LTRS", "R", "Y", "space", "FIGS", "1"]
    assert codes.ITA2.decode(tape) == "RY 1/2 Z\n"
    text = "THE QUICK BROWN FOX (1971) JUMPS OVER 4.50 + 3 LAZY DOGS?\n"
    assert codes.ITA2.decode(codes.ITA2.encode(text)) == text


def test_a_character_without_a_code() -> None:
    with pytest.raises(TextError, match="line 2, column 3: '%' has no code in ITA2"):
        codes.ITA2.encode("A\nAB%\n")


def test_six_levels_are_not_text() -> None:
    """The frames of an LGP-21's tape: digits are odd numbers, letters and stop codes have other holes."""
    tape = octal("001 003 011 020 037 023 001 061 001 021 020 037 031 001 015 022 001 061 001 063") * 9
    assert codes.recognise(tape) is codes.SIX_LEVEL
