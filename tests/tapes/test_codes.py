"""Telling a tape by its frames: whole ones, damaged ones, and the pairs that look alike."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from pdp8 import shelf
from tapes import ascii, binary, codes, eia, rim
from tapes.code import Characters, Code
from tapes.loaders import Words
from tests.tapes.strips import FORMAT_BIN, FORMAT_WORDS, LEADER, octal

WORDS = st.dictionaries(st.integers(0, 0o7777), st.integers(0, 0o7777), min_size=1)
PARITIES = st.sampled_from(["mark", "even", "odd", "none"])
PAL = st.text(st.sampled_from("ABCTADZ0127 *,/=\n"), min_size=4).map(lambda text: text + "\n")
NC = st.lists(st.text(st.sampled_from("0123456789"), min_size=19, max_size=19), min_size=1)
SIX_LEVEL = octal("041 003 050 066 007") * 4


def classify(tape: bytes) -> str:
    return codes.recognise(tape).name


@given(WORDS)
def test_loader_tapes(words: dict[int, int]) -> None:
    assert classify(binary.encode(words)) == "bin"
    tape = rim.encode(words)
    before_the_last_word = tape[: -64 - 2]
    checksum = sum(before_the_last_word) - 64 * 0o200 & 0o7777
    assert classify(tape) == "rim" or (len(words) > 1 and checksum == words[max(words)])


def test_a_tape_that_reads_as_both_is_what_its_checksum_says() -> None:
    """HLT at 0200, an origin with nothing after it, checksum: to a RIM loader two words."""
    both = LEADER + octal("102 000 074 002 103 000 003 003") + LEADER
    assert rim.decode(both) == {0o200: 0o7402, 0o300: 0o0303}
    assert binary.decode(both).words == {0o200: 0o7402}
    assert classify(both) == "bin"
    assert classify(both.replace(octal("003 003"), octal("003 004"))) == "rim"
    assert classify(rim.encode({0: 0o100})) == "rim", "one word by RIM is more than none by BIN"


@given(PAL, PARITIES, st.integers(0, 100), st.sampled_from([0, 0o200]))
def test_pal_text(text: str, parity: str, leader: int, code: int) -> None:
    assert classify(bytes([code]) * leader + ascii.encode(text, parity)) == "ascii"


@given(NC, st.integers(0, 70), st.booleans())
def test_eia(blocks: list[str], leader: int, ended_first: bool) -> None:
    text = "\n" * ended_first + "".join(block + "\n" for block in blocks)
    assert classify(bytes(leader) + eia.encode(text) + bytes(leader)) == "eia"


@pytest.mark.parametrize(
    ("tape", "kind"),
    [
        (b"", "blank"),
        (LEADER, "bin"),
        (b"\7", "ascii"),  # BELL, and EIA's 7
        (b"\16", "eia"),  # SO, and EIA's &
        (b"2478", "ascii"),  # EIA's S, U, X and Y
        (octal("377 377 377"), "ascii"),
        (octal("200 102 000 073 000 001 076 200"), "bin"),
        (octal("200 200 310 102 000 073 000 001 075"), "bin"),
        (octal("200 102 000 073 000 103 000 074 002"), "rim"),
        (octal("200 301 302 303"), "ascii"),
        *((LEADER + text, "ascii") for text in (b"ABCDE\n", b"ABCDE\r")),
        (octal("200 105 040 001 147 040 003 040 040 040 001 001 200"), "eia"),
        (b"*200\nSTART,\tCLA CLL\n\tHLT\n$\n", "ascii"),
        ("/ 二つの数を足す\n\tHLT\n$\n".encode(), "ascii"),
        (b"ABCDEFGHI\1", "ascii"),  # nine in ten
        (b"ABCDEFGH\1", "unknown"),
        (octal("001 002 004 010 001 002 004 010 001 003 200"), "eia"),
        (octal("001 002 004 010 001 002 004 010 003 200"), "unknown"),
        (SIX_LEVEL[:19], "unknown"),
        (SIX_LEVEL[:20], "six-level"),
        (SIX_LEVEL[:18] + bytes(20) + b"\300\300", "six-level"),  # nine in ten of what is punched
        (SIX_LEVEL[:17] + bytes(20) + b"\300\300\300", "unknown"),
        (bytes(range(256)), "unknown"),
        (LEADER + octal("102 000 073 000") + 64 * b"\210" + 150 * b"\1", "bin"),
        (LEADER + octal("102 000 073 000") + 65 * b"\210" + 150 * b"\1", "unknown"),  # too few are words
        (b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR\x00\x00\x01\x2c\x00\x00\x00\xc8\x08\x06", "unknown"),
    ],
)
def test_the_rest(tape: bytes, kind: str) -> None:
    assert classify(tape) == kind


@pytest.mark.parametrize(
    ("kind", "tape", "first", "last"),
    [
        ("bin", FORMAT_BIN, 66, 121),
        ("rim", rim.encode(FORMAT_WORDS), 72, 72),
        ("eia", eia.encode("0010000000000003588\n0029030000350000189\n"), 0, 40),
    ],
)
def test_a_damaged_tape_keeps_its_kind(kind: str, tape: bytes, first: int, last: int) -> None:
    """Loader tapes cut short; BIN and EIA tapes with one wrong hole in frames `first` to `last`."""
    if kind != "eia":
        assert {classify(tape[:end]) for end in range(first, len(tape))} == {kind}
    for frame in range(first, last):
        for channel in range(8):
            damaged = bytearray(tape)
            damaged[frame] ^= 1 << channel
            assert classify(bytes(damaged)) == kind, f"frame {frame}: {damaged[frame]:03o}"


@pytest.mark.parametrize(
    ("tape", "said"),
    [
        (shelf.read_bundled("circle.eia"), "is an EIA tape"),
        (b"A\nB\n", "has line feeds but no carriage returns"),
        (b"A\r\nB\r\n", ""),
        (binary.encode({0o12: 0o1212, 0o1212: 0o12}), ""),
        (b"", ""),
    ],
)
def test_what_a_program_for_ascii_does_not_find(tape: bytes, said: str) -> None:
    assert codes.recognise(tape).doubt(tape).startswith(said)
    assert bool(codes.recognise(tape).doubt(tape)) == bool(said)


def test_a_damaged_bin_tape_of_single_words_is_no_rim_tape() -> None:
    """Origin, word, origin, word: as on a RIM tape, but six frames from the last to the trailer."""
    tape = bytearray(binary.encode(dict.fromkeys(range(0o200, 0o400, 0o20), 0o1234)))
    tape[tape.index(0o34)] ^= 1
    assert classify(bytes(tape)) == "bin"


@pytest.mark.parametrize("code", codes.CODES, ids=lambda code: code.name)
def test_what_every_code_does(code: Code) -> None:
    """Its own tape is recognised and read back; damaged or not, each frame has a caption."""
    if isinstance(code, Characters):
        text = "0010000000000003588\n0029030000350000189\n"
        tape = code.encode(text)
        assert code.decode(tape) == text
        assert set(tape) <= set(code.fitting(tape))
    else:
        assert isinstance(code, Words)
        tape = code.encode(FORMAT_WORDS)
        assert code.decode(tape) == FORMAT_WORDS
    assert codes.recognise(tape) is codes.named(code.name) is code
    assert len(code.captions(tape)) == len(tape)
    assert len(code.captions(bytes(range(256)))) == 256
