"""From code to code, and what is said of a tape."""

from collections.abc import Sequence

import pytest

from tapes import ascii, binary, eia, measure, rim
from tapes.convert import convert, typed
from tapes.errors import TextError, WorkError
from tests.conftest import assert_same_tape
from tests.tapes.strips import FORMAT_BIN, FORMAT_WORDS, LEADER, octal

TEXT = "0010000000000003588\n0029030000350000189\n"


@pytest.mark.parametrize("source", ["text", "ascii", "eia"])
@pytest.mark.parametrize("target", ["text", "ascii", "eia"])
def test_characters(source: str, target: str) -> None:
    punched = {"text": TEXT.encode(), "ascii": ascii.encode(TEXT), "eia": eia.encode(TEXT)}
    assert_same_tape(convert(punched[source], source, target), punched[target])


def test_words() -> None:
    assert_same_tape(convert(FORMAT_BIN, "bin", "rim"), rim.encode(FORMAT_WORDS))
    assert_same_tape(convert(rim.encode(FORMAT_WORDS), "rim", "bin"), binary.encode(FORMAT_WORDS))


def test_octal_gives_back_the_very_frames() -> None:
    assert_same_tape(convert(convert(FORMAT_BIN, "bin", "octal"), "octal", "frames"), FORMAT_BIN)
    assert_same_tape(convert(b"200 102 000 073 000 001 075 200", "octal", "rim"), rim.encode({0o200: 0o7300}))


def test_parity_alone_leaves_leader_and_fill_as_they_are() -> None:
    tape = LEADER + octal("301 215 212 377 000 303") + bytes(3)
    assert_same_tape(
        convert(tape, "ascii", "ascii", "even"), LEADER + octal("101 215 012 377 000 303") + bytes(3)
    )


def test_the_fill_is_punched_again() -> None:
    assert_same_tape(convert(ascii.encode(TEXT), "ascii", "ascii", "none", 1), ascii.encode(TEXT, "none", 1))


def test_a_text_file_taken_for_a_tape_becomes_a_tape() -> None:
    assert_same_tape(convert(b"A\nB\n", "ascii", "ascii"), ascii.encode("A\nB\n"))


@pytest.mark.parametrize(
    ("content", "source", "target", "message"),
    [
        (b"", "blank", "text", "frame 0: empty tape"),
        (bytes(5), "blank", "eia", "a blank tape cannot become eia"),
        (b"\x81", "unknown", "eia", "a tape of no known code cannot become eia"),
        (FORMAT_BIN, "bin", "text", "bin cannot become text; octal takes any tape"),
        (TEXT.encode(), "text", "bin", "text cannot become bin"),
        (FORMAT_BIN[:90], "bin", "rim", "frame 90: the tape is cut short"),
        (binary.encode({0o10000: 1}), "bin", "rim", "address 10000: a RIM tape can name only 0000 to 7777"),
        (b"A\n!\n", "text", "eia", "line 2, column 1: '!' has no EIA code"),
        (octal("040 003"), "eia", "ascii", "frame 1: 003"),
        (b"200 400", "octal", "frames", "line 1, column 5: '400' is no frame"),
    ],
)
def test_what_cannot_be(content: bytes, source: str, target: str, message: str) -> None:
    with pytest.raises(WorkError, match=message.replace("(", r"\(")):
        convert(content, source, target)


def test_typed_text_with_any_line_ends() -> None:
    assert typed(b"\xef\xbb\xbfA\r\nB\rC\n") == "A\nB\nC\n"
    with pytest.raises(TextError, match="line 2, column 3: byte 377 is no text"):
        typed(b"AB\nCD\xff\n")


def rows(tape: bytes, *names: str) -> Sequence[str]:
    said = measure.report(tape)
    return [value for name, value in said if name in names]


def test_the_circle_s_tape_measured() -> None:
    """27 frames a line, 10 frames an inch and 10 a second: the thesis's 30 minutes."""
    tape = ascii.encode(("0" * 19 + "\n") * 666)
    assert measure.report(tape) == [
        ("tape", "ASCII"),
        ("frames", "17,982: leader 0, trailer 0"),
        ("length", "149 ft 10.2 in"),
        (
            "time",
            "Teletype (10 a second) 29 min 58.2 s; high-speed reader (300) 59.9 s, punch (50) 5 min 59.6 s",
        ),
        ("parity", "mark"),
        ("lines", "666 of 19 characters"),
        ("line ends", "666 CR, 666 LF, 3,996 RUBOUT"),
    ]


def test_an_eia_tape_measured() -> None:
    tape = bytes(4) + eia.encode(TEXT + "003") + bytes(2)
    assert rows(tape, "frames", "blocks", "parity") == [
        "49: leader 4, trailer 2",
        "2 of 20 frames, then 3 frames without an end",
        "odd in every frame; every frame an EIA code",
    ]
    damaged = tape.replace(b"\x15", b"\x14")
    assert rows(damaged, "parity") == ["frame 20: 024 (channels 5 3) is no EIA code: an even number of holes"]


def test_a_bin_tape_measured() -> None:
    assert rows(FORMAT_BIN, "frames", "checksum", "holds", "core") == [
        "185: leader 65, trailer 64",
        "1251 at frame 119: good",
        "words 22, origins 5, fields 0",
        "0200-0221, 0232, 0300, 0400-0401",
    ]
    assert rows(binary.encode({}), "holds", "core") == ["words 0, origins 0, fields 0", "none"]
    damaged = bytearray(FORMAT_BIN)
    damaged[70] ^= 1
    assert rows(bytes(damaged), "checksum", "core") == ["1251 at frame 119: WRONG, 1250 computed"]
    assert rows(FORMAT_BIN[:101], "damage") == ["frame 101: the tape is cut short: it has no trailer"]
    assert rows(FORMAT_BIN + b"\x41", "label") == [f"1 frame from frame {len(FORMAT_BIN)} on"]


def test_a_rim_tape_measured() -> None:
    tape = rim.encode(FORMAT_WORDS)
    assert rows(tape, "holds", "core") == [
        "22 words; RIM has no checksum",
        "0200-0221, 0232, 0300, 0400-0401",
    ]
    assert rows(tape[:90], "damage") == ["frame 90: the tape is cut short inside a word"]


def test_text_of_one_line_has_no_line_ends() -> None:
    assert rows(b"ABAB", "line ends") == []
    assert rows(bytes(9), "tape") == ["blank"]
    assert rows(b"A\rB", "line ends") == ["1 CR, 0 LF, 0 RUBOUT"]


def test_a_text_file_is_told_to_be_punched() -> None:
    assert rows(b"A\nB", "lines", "line ends") == [
        "1 of 1 character, then 1 character without an end",
        "0 CR, 1 LF, 0 RUBOUT",
    ]
    (warning,) = rows(b"A\nB", "warning")
    assert "pdp8 tape punch" in warning


@pytest.mark.parametrize(
    ("frames", "said"), [(0, "0.0 in"), (119, "11.9 in"), (120, "1 ft 0.0 in"), (17982, "149 ft 10.2 in")]
)
def test_lengths(frames: int, said: str) -> None:
    assert measure.length(frames) == said


@pytest.mark.parametrize(
    ("tape", "kind", "damage"),
    [
        (b"", "empty", []),
        (bytes(9), "blank", []),
        (bytes(range(256)), "unknown: not ASCII, EIA, BIN or RIM", []),
        (eia.encode("1\n"), "EIA RS-244", []),
        (rim.encode({0: 1}), "RIM, DEC's read-in mode format", []),
        (LEADER, "BIN, DEC's binary loader format", ["frame 64: nothing but leader"]),
        (
            LEADER + octal("300 012 034 056 070") * 9 + LEADER,
            "BIN, DEC's binary loader format",
            [
                "frame 65: a word before any origin. The BIN loader has no address for it; "
                "an object tape of FORTRAN looks so"
            ],
        ),
    ],
)
def test_every_kind_has_a_report(tape: bytes, kind: str, damage: list[str]) -> None:
    assert rows(tape, "tape") == [kind]
    assert rows(tape, "damage") == damage


SEVEN = octal("001 161 011 005 003")
DRAWN = ["ooooo", "    o", "   o", "  o", " o", " o", " o", ""]
"""A 7 for the eye, channel 1 at the top."""


def test_labels_are_placed_and_drawn() -> None:
    tape = bytes(2) + SEVEN + bytes(3) + rim.encode({0o200: 0o7402}) + bytes(1) + SEVEN + bytes(3)
    first, last = "5 frames from frame 2 on", "8 frames from frame 143 on"
    assert rows(tape, "label", "") == [first, *DRAWN, last, *DRAWN]
    said = tuple(f"a label of {place}, left out" for place in (first, last))
    assert measure.left_out(tape, "rim") == said
    section = binary.encode({0o200: 0o7402})
    assert measure.left_out(FORMAT_BIN, "bin") == ()
    assert measure.left_out(FORMAT_BIN + SEVEN, "bin") == ("a label of 5 frames from frame 185 on, left out",)
    two = "a good section from frame 193 on, after the label: a tape of its own"
    apart = FORMAT_BIN + SEVEN + bytes(3) + section
    assert rows(apart, "apart") == [two]
    assert measure.left_out(apart, "bin")[1:] == (
        "after the label, from frame 193 on, a good section: a tape of its own, left out",
    )
