"""From code to code."""

import pytest

from tapes import ascii, binary, eia, rim, spelled
from tapes.convert import convert, typed
from tapes.errors import TextError, WorkError
from tests.conftest import assert_same_tape
from tests.tapes.strips import FORMAT_BIN, FORMAT_WORDS, LEADER, octal

TEXT = "0010000000000003588\n0029030000350000189\n"
PUNCHED = {"text": TEXT.encode(), "ascii": ascii.encode(TEXT), "eia": eia.encode(TEXT)}


@pytest.mark.parametrize("source", PUNCHED)
@pytest.mark.parametrize("target", PUNCHED)
def test_characters(source: str, target: str) -> None:
    assert_same_tape(convert(PUNCHED[source], source, target), PUNCHED[target])


def test_words_and_octal_which_gives_back_the_very_frames() -> None:
    assert_same_tape(convert(FORMAT_BIN, "bin", "rim"), rim.encode(FORMAT_WORDS))
    assert_same_tape(convert(rim.encode(FORMAT_WORDS), "rim", "bin"), binary.encode(FORMAT_WORDS))
    assert_same_tape(convert(convert(FORMAT_BIN, "bin", "octal"), "octal", "frames"), FORMAT_BIN)
    assert_same_tape(convert(b"200 102 000 073 000 001 075 200", "octal", "rim"), rim.encode({0o200: 0o7300}))


@pytest.mark.parametrize("frames", ["301 215 212 377 000 303", "101 015 012 377 000 303"])
def test_parity_alone_leaves_leader_and_fill_as_they_are(frames: str) -> None:
    even = LEADER + octal("101 215 012 377 000 303") + bytes(3)
    assert_same_tape(convert(LEADER + octal(frames) + bytes(3), "ascii", "ascii", "even"), even)


def test_the_fill_is_punched_again() -> None:
    assert_same_tape(convert(ascii.encode(TEXT), "ascii", "ascii", "none", 1), ascii.encode(TEXT, "none", 1))
    assert_same_tape(convert(b"A\nB\n", "ascii", "ascii"), ascii.encode("A\nB\n"))  # a file taken for a tape


@pytest.mark.parametrize(
    ("content", "source", "target", "message"),
    [
        (b"", "blank", "text", "frame 0: empty tape"),
        (bytes(5), "blank", "eia", "a blank tape cannot become eia"),
        (b"\x81", "unknown", "eia", "a tape of no known code cannot become eia"),
        (FORMAT_BIN, "bin", "text", "a BIN tape cannot become text; octal takes any tape"),
        (TEXT.encode(), "text", "bin", "text cannot become bin"),
        (binary.encode({0o10000: 1}), "bin", "rim", "address 10000: a RIM tape can name only 0000 to 7777"),
        *((binary.encode({}), "bin", target, "no word to spell out") for target in spelled.FORMATS),
    ],
)
def test_what_cannot_be(content: bytes, source: str, target: str, message: str) -> None:
    with pytest.raises(WorkError, match=message.replace("(", r"\(")):
        convert(content, source, target)


def test_typed_text_with_any_line_ends() -> None:
    assert typed(b"\xef\xbb\xbfA\r\nB\rC\n") == "A\nB\nC\n"
    for before in ("AB\nCD", "AB\rCD", "\ufeffÄ\r\nCÉ"):
        with pytest.raises(TextError, match="line 2, column 3: byte 377 is no text"):
            typed(before.encode() + b"\xff\n")


def test_two_splices_are_left_out() -> None:
    text = TEXT * 4
    tape = eia.encode(text)
    spliced = tape[:50] + bytes(30) + tape[50:90] + bytes(20) + tape[90:]
    assert convert(spliced, "eia", "text", accept=True) == text.encode()
