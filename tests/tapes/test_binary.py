"""BIN and RIM tapes: DEC's own, SIMH's and palbart's reading, and what can be wrong with one."""

import subprocess
from itertools import product
from pathlib import Path
from types import ModuleType

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tapes import ascii, binary, codes, rim
from tapes.errors import TapeError
from tapes.frames import draw_label, leader
from tests.conftest import assert_same_tape, case
from tests.pdp8.computer.hardware.test_simh import SIMH
from tests.tapes.strips import FORMAT_BIN, FORMAT_WORDS, LEADER, octal, refused

WORDS = st.dictionaries(st.integers(0, 0o7777), st.integers(0, 0o7777))


def tape(body: str) -> bytes:
    return LEADER + octal(body) + LEADER


@pytest.mark.parametrize(
    ("words", "punched", "fields"),
    [
        # checksum: 102+000+073+000+074+002 + 104+000+000+001, octal
        ({0o201: 0o7402, 0o200: 0o7300, 0o400: 1}, "102 000 073 000 074 002 104 000 000 001 004 000", {}),
        # fields are not summed: 177+077+001 + 100+000+002 + 100+000+003 = 0504 octal
        (
            {0o07777: 1, 0o10000: 2, 0o70000: 3},
            "177 077 000 001 310 100 000 000 002 370 100 000 000 003 005 004",
            {1: 68, 7: 73},
        ),
    ],
)
def test_the_canonical_tape(words: dict[int, int], punched: str, fields: dict[int, int]) -> None:
    assert_same_tape(binary.encode(words), tape(punched))
    assert binary.decode(tape(punched)) == (words, fields)


def test_a_tape_of_dec_s_assembler() -> None:
    """Start-up frame, redundant origin and all; the words are those of its own listing."""
    assert binary.decode(FORMAT_BIN) == (FORMAT_WORDS, {})
    (section,) = binary.read(FORMAT_BIN).sections
    assert section.items[:3] == (("origin", 0o200, 65), ("origin", 0o200, 67), ("word", 1, 69))
    assert (section.computed, section.punched, section.frame) == (0o1251, 0o1251, 119)


@given(WORDS)
@example({0o7777: 1, 0: 2})
@example({})
def test_what_is_punched_is_read(words: dict[int, int]) -> None:
    assert binary.decode(binary.encode(words)) == (words, {})
    assert not words or rim.decode(rim.encode(words)) == words


def test_no_address_and_no_word_out_of_range_is_punched() -> None:
    for code, beyond in ((binary, 0o100000), (rim, 0o10000)):
        for address in (-1, beyond):
            with pytest.raises(TapeError, match=f"address {address:o}: a .* tape can name only"):
                code.encode({address: 0})
        for word in (-1, 0o10000):
            with pytest.raises(TapeError, match=f"0200: {word:o} .octal. is no word; 0000 to 7777 are"):
                code.encode({0o200: word})


def test_what_stands_between_rubouts_is_not_read() -> None:
    """A message typed by the ASR-33 in the middle of its own punching, leader codes and all."""
    message = "377 215 212 311 322 200 101 102 377"
    typed = tape(f"{message} 102 000 {message} 073 000 {message} 001 075")
    assert binary.decode(typed) == ({0o200: 0o7300}, {})
    # within the leader, as in DEC's loader, which passes over leader until another frame comes
    shown = LEADER + octal(message)
    two = shown + shown + FORMAT_BIN.lstrip(b"\0") + octal(message) + binary.encode({0o201: 3})
    assert binary.decode(two).words == FORMAT_WORDS | {0o201: 3}
    assert binary.read(two).labels == ()
    assert codes.recognise(two) is codes.BIN


def test_sections_follow_each_other_and_the_later_word_stays() -> None:
    """Without a field a section goes where the last word went: DEC-08-LBAA takes its field from the data
    field (6214 at 7703), which CONT leaves as the section before has set it.
    """
    sections = {0o200: 1, 0o201: 2}, {0o201: 3}, {0o10000: 4}, {0: 5}
    several = bytes(9).join(map(binary.encode, sections))
    assert binary.decode(several).words == {0o200: 1, 0o201: 3, 0o10000: 5}
    assert len(binary.read(several).sections) == 4
    ends = tape("102 000 000 001 320 001 003")  # a field after the last word
    assert binary.decode(ends + tape("102 001 000 001 001 004")).words == {0o200: 1, 0o201: 1}


def test_padding_behind_a_tape_is_no_section() -> None:
    """OS/8 closes a file with ^Z and fills its block with zeros, which are words and their sum."""
    for rest in ("232" + " 000" * 40, "032" + " 000" * 3, "000" + " 000" * 40):
        assert binary.read(FORMAT_BIN + octal(rest)) == binary.read(FORMAT_BIN)
        assert binary.decode(FORMAT_BIN + FORMAT_BIN + octal(rest)).words == FORMAT_WORDS


LABELS = {
    "a word's frames": "032 032 101",
    "one rubout": "377",
    "its own sum": "005 005 000 012",
    "blank tape, then letters": "000 000 000 177 011 011 001 000 076 101 101 076 000",
    "seven rows high": "265 231 000 377",
    "letters and leader": "000 177 011 011 001 000 200 200 200",
}


def apart(frames: bytes) -> int | None:
    """Return where a good section begins after the label of this tape."""
    return binary.find_apart(frames, binary.read(frames).labels)


@pytest.mark.parametrize("label", LABELS.values(), ids=LABELS)
def test_what_follows_a_good_tape_is_a_label(label: str) -> None:
    labelled = FORMAT_BIN + octal(label)
    assert binary.decode(labelled).words == FORMAT_WORDS
    start = len(FORMAT_BIN) + (len(octal(label)) - len(octal(label).lstrip(b"\0")))
    assert binary.read(labelled)[2:4] == (None, (range(start, len(labelled)),))
    assert codes.recognise(labelled) is codes.BIN
    # 102+000+074+002 is 200, octal: a checksum; another word before it; and an origin
    good, bad, unsummed = (tape(f"102 000 074 {end} 000") for end in ("002 002", "003 002", "002 103"))
    labelled += bytes(3)
    assert apart(labelled + good) == len(labelled)
    assert [apart(labelled), apart(labelled + bad), apart(labelled + unsummed)] == [None] * 3
    assert apart(labelled + bad + bytes(3) + good) == len(labelled + bad + bytes(3))


@pytest.mark.parametrize(
    "label",
    [
        "000 000 177 011 011 001 000 076 101 101 076 000 000 000",
        "265 231 377 101 000 000 000 000",
        "000 377 377 377",
    ],
)
@pytest.mark.parametrize("after", ["", "000 177 011 011"])
def test_letters_before_the_leader_are_a_label(label: str, after: str) -> None:
    front = octal(label)
    labelled = front + FORMAT_BIN + octal(after)
    assert binary.decode(labelled).words == FORMAT_WORDS
    letters = range(len(front) - len(front.lstrip(b"\0")), len(front.rstrip(b"\0")))
    behind = (range(len(front + FORMAT_BIN) + 1, len(labelled)),) if after else ()
    assert binary.read(labelled).labels == (letters, *behind)
    assert codes.recognise(labelled) is codes.BIN
    assert codes.start(labelled) == labelled.index(LEADER)
    assert apart(labelled) is None
    damaged = bytearray(labelled)
    damaged[len(front) + 67] ^= 0o002
    assert codes.recognise(bytes(damaged)) is codes.BIN


def test_a_file_of_text_before_the_leader_is_a_label() -> None:
    """As before DEC's MAINDECs of the PDP-8/I, which CP/M kept."""
    front = b"digital\r\nMAINDEC-08-D1GB-PB  5/5/68\r\nPDP 8I,8,8/S\r\nEXTENDED MEMORY\r\n\x1a"
    for labelled in (front + FORMAT_BIN, LEADER + bytes(3) + front + FORMAT_BIN):
        assert codes.recognise(labelled) is codes.BIN
        assert binary.decode(labelled).words == FORMAT_WORDS
    assert draw_label(front)[:2] == ["digital", "MAINDEC-08-D1GB-PB  5/5/68"]
    assert codes.recognise(front[:-1] + FORMAT_BIN) is not codes.BIN


def test_a_checksum_with_channel_7_is_as_decs_loader_makes_it() -> None:
    """DEC-08-LBAA shifts the first frame and adds the second; FOCAL-8.bn of the PiDP-8 ends so, and
    the overlays of UW-FOCAL: AC = 0000.
    """
    for closing in ("101 112", "001 112", "102 012"):
        assert binary.decode(tape(f"102 000 011 077 {closing}")).words == {0o200: 0o1177}
        assert codes.BIN.captions(tape(f"102 000 011 077 {closing}"))[-66:-64] == ["checksum 0212", '"']
    for closing in ("101 113", "101 312", "112 101", "102 013", "101 112 000 000"):
        assert refused(binary.decode, tape(f"102 000 011 077 {closing}"))


def test_a_bin_tape_behind_a_rim_tape_is_a_tape_of_its_own() -> None:
    """As EduSystem 20-C has it: a loader in RIM, then what that loader reads."""
    loader = rim.encode({0o7600: 1, 0o7774: 0o5200})
    for gap, start in (b"", len(loader) - 64), (bytes(9), len(loader) + 9):  # without a gap, one leader
        said = f"a good BIN section from frame {start} on: a tape of its own, left out"
        assert rim.read(loader + gap + binary.encode(FORMAT_WORDS))[1:4] == (None, (), (said,))
    assert rim.read(loader + FORMAT_BIN[:-66] + b"\1\1" + leader()).labels


def test_a_section_without_its_leader_is_no_label() -> None:
    """A tape of two sections, torn in the first: the second is not all of it."""
    for torn in ((FORMAT_BIN + bytes(20) + FORMAT_BIN)[at:] for at in (66, 68, 70)):
        assert refused(binary.decode, torn)
    assert refused(binary.decode, octal("102 000 000 000 000") + LEADER)


def test_text_before_a_leader_is_no_label() -> None:
    text = ascii.encode("*200\nHLT\n$\n")
    for tail in (bytes(10) + binary.encode({0o200: 1}), bytes(10) + leader(), bytes(10) + leader() + text):
        assert codes.recognise(text + tail) not in (codes.BIN, codes.RIM)
        assert codes.start(text + tail) == 0
    assert codes.recognise(text * 9 + bytes(10) + leader() + b"\3\6\5") is codes.ASCII
    assert codes.recognise(b"ABC" * 9 + bytes(10) + leader() + b"\3\6\5") is codes.ASCII
    assert codes.start(ascii.encode("A") + bytes(9) + leader()) == 0
    assert codes.start(ascii.encode("A") + bytes(9) + b"\x41") == 0


def test_a_damaged_second_section_is_no_label() -> None:
    second = bytearray(binary.encode({0o400 + at: at for at in range(20)}))
    for cut in (64 + 6, 64 + 7, len(second) - 66):
        assert "cut short" in str(refused(binary.decode, bytes(FORMAT_BIN + second[:cut])))
    second[64 + 2 * 8] = 0o265  # after eight items; after fewer it is a label
    assert ": 265 " in str(refused(binary.decode, bytes(FORMAT_BIN + second)))
    second[64 + 2 * 7] = 0o265
    assert binary.decode(FORMAT_BIN + second).words == FORMAT_WORDS


def test_what_a_damaged_tape_holds() -> None:
    tape = bytearray(binary.encode({0o200: 1, 0o201: 2, 0o202: 3}))
    tape[67] ^= 0o004
    for reading, damage in (
        (binary.read(bytes(tape)), "checksum: computed"),
        (binary.read(bytes(tape[:-64])), "no trailer"),
    ):
        assert damage in str(binary.find_damage(reading))
        assert binary.content(reading).words == {0o200: 5, 0o201: 2, 0o202: 3}


def test_without_trailer_one_frame_may_be_behind_the_checksum() -> None:
    whole = binary.encode({0o200 + at: at for at in range(9)}).rstrip(b"\x80")
    ends = ((b"", True), (b"A", True), (b"AB", False), (b"\0\0A", True))
    for before, (behind, good) in product((b"", FORMAT_BIN), ends):
        with case(before, behind):
            damage = binary.find_damage(binary.read(before + whole + behind))
            assert (damage is None) == good, damage


def test_a_field_is_no_origin() -> None:
    assert "a word before any origin" in str(binary.find_damage(binary.read(tape("310 074 002 000 076"))))


def test_origins_may_overlap_and_wrap() -> None:
    assert binary.decode(tape("177 077 000 001 000 002 177 077 000 003 006 002")).words == {0o7777: 3, 0: 2}


@pytest.mark.parametrize(
    ("frames", "frame", "message"),
    [
        (b"", 0, "empty tape"),
        (bytes(2), 0, "nothing but blank tape"),
        (LEADER, 64, "nothing but leader"),
        (bytes(3) + b"/ A PROGRAM\n", 3, "057 where the leader (200) or an origin (1nn) was expected"),
        (LEADER + octal("102 000 073 000"), 68, "the tape is cut short: it has no trailer"),
        (LEADER + octal("102 000 073"), 67, "the tape is cut short inside a word"),
        (LEADER + octal("102 000 377 101"), 66, "this rubout has no other"),
        (tape("102 000 073 000 002 076"), 68, "checksum: computed 0175, punched 0276"),
        (tape("102 000 073 000 074 002 102 000"), 72, "the trailer where a checksum was expected"),
        (tape("102 000 073 102"), 67, "102 where the second half of a word was expected"),
        (tape("102 000 073 200"), 67, "200 where the second half of a word was expected"),
        (tape("073 000 074 002 001 071"), 64, "a word before any origin"),
        (tape("102 000 215 000"), 66, "215 is not a frame of a BIN tape"),
        (LEADER + bytes(4) + FORMAT_BIN[65:], 64, "a word before any origin"),
        (FORMAT_BIN + binary.encode({1: 1, 2: 2})[:70], 255, "the tape is cut short"),
    ],
)
def test_what_is_wrong_and_where(frames: bytes, frame: int, message: str) -> None:
    assert str(refused(binary.decode, frames)).startswith(f"frame {frame}: {message}")


@pytest.mark.parametrize(
    ("frames", "frame", "message"),
    [
        ("200 200", 0, "nothing but leader"),
        ("200 102 000 073", 4, "the tape is cut short inside a word"),
        ("200 102 000 073 200", 4, "200 where the second half of a word was expected"),
        ("200 102 102 073 000 200", 2, "102 where the second half of an address was expected"),
        ("200 102 000 073 000 074 002 200", 5, "074 where the first half of an address was expected"),
        ("200 102 000 103 000 200", 3, "103 where a word was expected"),
        ("200 300 000 103 000 200", 2, "000 where the first half of an address was expected"),
        ("200 102 000 073 000 301 000", 6, "000 where the first half of an address was expected"),
    ],
)
def test_what_is_wrong_with_a_rim_tape_and_where(frames: str, frame: int, message: str) -> None:
    assert str(refused(rim.decode, octal(frames))) == f"frame {frame}: {message}"


def test_one_wrong_hole_is_always_noticed() -> None:
    """A single wrong hole in a frame of DEC's tape, leader and checksum apart, is refused."""
    for frame in range(65, 119):
        for channel in range(8):
            damaged = bytearray(FORMAT_BIN)
            damaged[frame] ^= 1 << channel
            assert refused(binary.decode, bytes(damaged)), f"frame {frame} as {damaged[frame]:03o} was read"


@given(st.binary())
def test_any_frames_have_captions_and_a_kind_and_are_read_or_refused_with_their_place(given: bytes) -> None:
    for frames in (given, LEADER + given + LEADER):
        known = (*codes.CODES, codes.BLANK_TAPE, codes.UNKNOWN)
        assert codes.recognise(frames) in known
        assert {len(code.captions(frames)) for code in known} == {len(frames)}
        for error in (refused(code.decode, frames) for code in (binary, rim)):
            assert error is None or error.frame in range(len(frames) + 1)


@pytest.mark.skipif(not SIMH, reason="SIMH's pdp8 is not installed")
@pytest.mark.parametrize(("load", "code"), [("load", binary), ("load -r", rim)])
def test_simh_loads_the_same_words(load: str, code: ModuleType, tmp_path: Path) -> None:
    words = {address: address * 0o1357 + 0o2461 & 0o7777 for address in range(0, 0o10000, 3)} | FORMAT_WORDS
    (tmp_path / "x").write_bytes(code.encode(words))
    (tmp_path / "x.ini").write_text(f"{load} x\nexamine 0-7777\nquit\n")
    said = subprocess.run(
        [SIMH, "x.ini"], cwd=tmp_path, capture_output=True, text=True, timeout=60, check=True
    ).stdout
    lines = (line.split(":\t") for line in said.splitlines() if ":\t" in line)
    core = {int(address, 8): int(word, 8) for address, word in lines}
    assert core == {address: words.get(address, 0) for address in range(0o10000)}


def test_address_and_word_in_four_frames() -> None:
    """Leader between the words and blank tape around are passed over."""
    words = {0o7777: 0o4321, 0o200: 0o7300}
    assert_same_tape(rim.encode(words), tape("102 000 073 000 177 077 043 021"))
    assert rim.decode(bytes(9) + tape("102 000 073 000 200 200 177 077 043 021") + bytes(2)) == words
