"""Titles: letters that the eye reads, and what they are to each command."""

import pytest

from tapes import ascii, codes, eia, title
from tapes.convert import convert
from tapes.errors import TextError
from tapes.frames import draw_label

HI = """\
o   o ooooo
o   o   o
o   o   o
ooooo   o
o   o   o
o   o   o
o   o ooooo
"""


def test_letters_for_the_eye() -> None:
    assert "\n".join(draw_label(title.punch("HI"))) == HI
    assert title.read(title.punch("Part 7:  X/Y")) == "PART 7: X/Y"
    assert title.read(b"\x7f\x41\x7f") == ""
    with pytest.raises(TextError, match="line 1, column 2: '%' cannot be punched for the eye"):
        title.punch("9%")


@pytest.mark.parametrize("said", ["PART 7", "HELLO, WORLD", "A7", "III", "EIA TAPE 12 OF 1971"])
def test_a_title_is_found_and_left_out(said: str) -> None:
    text = "0010000000000003588\n0029030000350000189\n" * 3
    for tape in (eia.encode(text), ascii.encode(text), ascii.encode(text, "even")):
        titled = bytes(9) + title.punch(said) + tape
        code = codes.recognise(titled)
        assert code is codes.recognise(tape)
        ((start, stop),) = ((label.start, label.stop) for label in code.labels(titled))
        assert title.read(titled[start:stop]) == said
        assert convert(titled, code.name, "text") == text.encode()
