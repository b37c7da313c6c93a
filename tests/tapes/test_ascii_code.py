"""ASCII tapes: line ends, fill, parity."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tapes import ascii, convert, doubts
from tapes.errors import TapeError, TextError
from tapes.frames import leader
from tests.conftest import assert_same_tape
from tests.tapes.strips import octal


@pytest.mark.parametrize(
    ("text", "options", "punched"),
    [  # the first as the thesis has it: channel 8 always punched, CR LF and six RUBOUTs
        (" 1019\n", {}, "240 261 260 261 271 215 212 377 377 377 377 377 377"),
        ("01\n", {"parity": "even", "fill": 2}, "060 261 215 012 377 377"),
        ("01\n", {"parity": "none", "fill": 1}, "060 061 015 012 177"),
        ("01\n", {"parity": "odd", "fill": 1}, "260 061 015 212 177"),
        ("01\n", {"fill": 0}, "260 261 215 212"),
    ],
)
def test_parity_and_fill(text: str, options: dict[str, Any], punched: str) -> None:
    assert_same_tape(ascii.encode(text, **options), octal(punched))


@given(
    st.text(st.characters(min_codepoint=0o040, max_codepoint=0o176) | st.sampled_from("\n\t\f\a")),
    st.sampled_from(["mark", "even", "odd", "none"]),
    st.integers(0, 12),
)
def test_what_is_punched_is_read(text: str, parity: str, fill: int) -> None:
    assert ascii.decode(ascii.encode(text, parity, fill)) == text


@pytest.mark.parametrize(
    ("tape", "text"),
    [
        ("000 000 301 215 212 377 302 200 200", "A\nB"),
        ("101 015 102 012 103", "A\nB\nC"),
        ("101 015 012 015 012", "A\n\n"),
        ("", ""),
        ("101 232 000 000", "A"),  # ^Z ends a file of OS/8 or CP/M
        ("101 032 032", "A"),
        ("101 232 102", "A\x1aB"),
        ("232", ""),
    ],
)
def test_lines_however_they_end(tape: str, text: str) -> None:
    assert ascii.decode(octal(tape)) == text


def test_what_cannot_be_punched_is_named() -> None:
    with pytest.raises(TapeError, match="-1 RUBOUTs"):
        ascii.encode("A", fill=-1)


NAMES = (
    "blank SOH STX ETX EOT WRU ACK BELL BS TAB LF VT FF CR SO SI "
    "DLE X-ON TAPE X-OFF TAPE_OFF NAK SYN ETB CAN EM SUB ESC FS GS RS US space"
)
"""Codes 000 to 040, as a Teletype's keys and handbook have them."""


def test_every_code_has_its_name_with_channel_8_and_without() -> None:
    printing = [chr(code) for code in range(0o041, 0o177)]
    names = [*(name.replace("_", " ") for name in NAMES.split()), *printing, "RUBOUT"]
    assert [ascii.name(frame) for frame in range(0o200)] == names
    assert [ascii.name(frame) for frame in range(0o200, 0o400)] == ["leader", *names[1:]]


@pytest.mark.parametrize("parity", ["mark", "even", "odd", "none"])
def test_parity_is_told_from_the_characters(parity: str) -> None:
    tape = bytes(8) + ascii.encode("TAD HOLD\n", parity, 0) + octal("377 377") + leader(9)
    assert dict(ascii.ASCII.report(tape))["parity"] == parity
    assert dict(ascii.ASCII.report(octal("301 101 303")))["parity"] == "mixed"
    assert ascii.ASCII.rule(octal("301 102"), {0, 1}) is None, "every character is in doubt"


@pytest.mark.parametrize("parity", ["mark", "even", "odd", "none"])
def test_the_end_of_a_file_obeys_no_parity(parity: str) -> None:
    tape = ascii.encode("TAD HOLD\n" * 5, parity, 0)
    rule = ascii.ASCII.rule(tape)
    assert rule
    for end in (b"\x1a", b"\x9a"):
        assert doubts.find(tape + end + bytes(9)) == []
        assert dict(ascii.ASCII.report(tape + end))["file end"].startswith(f"^Z at frame {len(tape)}, ")
        assert len(doubts.find(tape + end + tape)) == (not rule.obeyed(0, end[0]))


def test_a_letter_in_utf_8_is_no_wrong_hole() -> None:
    text = "/ COPYRIGHT © 2017, AS A FILE OF THE PIDP-8 BEGINS\r\n*200\r\n\tHLT\r\n$\r\n"
    tape = text.encode()
    assert doubts.find(tape) == []
    assert dict(ascii.ASCII.report(tape))["warning"] == "a text in UTF-8: '©' is no ASCII character"
    assert convert.convert(tape, "ascii", "text") == text.replace("\r", "").encode()
    with pytest.raises(TextError, match="line 1, column 13: '©' is no ASCII character"):
        convert.convert(tape, "ascii", "ascii")
    assert [doubt.frame for doubt in doubts.find(tape.replace("©".encode(), b"\302"))] == [12]
