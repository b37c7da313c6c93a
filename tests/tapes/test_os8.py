"""Files of OS/8 on a DECtape: a small tape of our own; images of DEC's where PDP8_OS8 names a folder."""

import os
import random
import string
from array import array
from collections.abc import Sequence
from pathlib import Path

import pytest

from tapes import dectape, os8
from tapes.errors import TapeError
from tests.conftest import Call

BLOCK = 0o7
FREE = 737 - BLOCK
FULL = (BLOCK, 0, 0, 0, 0o0102, 0, 0, 0, -1, *(0, -1) * 123)
"""Entries to the last word of a segment, after their number."""


def formatted(*segment: int, then: Sequence[int] = ()) -> dectape.Image:
    """Return a tape with one segment of a directory, or two, by their words."""
    words = array("H", bytes(2 * dectape.BLOCKS * dectape.WORDS))
    for block, half in ((2, segment[:128]), (3, segment[128:]), (4, then)):
        start = block * dectape.WORDS
        words[start : start + len(half)] = array("H", [word & 0o7777 for word in half])
    return dectape.Image(words)


def empty() -> dectape.Image:
    return formatted(-1, BLOCK, 0, 0, -1, 0, -FREE)


def test_a_text_is_packed_three_characters_in_two_words() -> None:
    """A B C of mark parity: 0301 0302 0303 are 6301 1702, after them CR LF ^Z."""
    assert os8.frames([0o101, 0o102]) == b"AB\0", "not ended by ^Z"
    assert os8.frames(os8.pack(b"")) == b""
    packed = os8.from_text("ABC\n")
    assert [f"{word:04o}" for word in packed[:4]] == ["6301", "1702", "4615", "5212"]
    assert os8.text(packed) == "ABC\n"
    assert os8.from_text("ABC\r\n") == os8.from_text("ABC\r") == packed
    assert os8.text(os8.pack(b"A\rB\r\nC")) == "A\nB\nC"


def test_two_hundred_files_are_there_as_they_were_put() -> None:
    """In six segments of the directory, until the last one is full."""
    draw = random.Random(8)
    image, kept = empty(), dict[str, str]()
    for number in range(200):
        name = f"F{number}.{draw.choice(('PA', 'FT', 'TX', ''))}".removesuffix(".")
        lines = "".join(draw.choices(string.printable[:95] + "\n", k=draw.randrange(1_500))) + "\n"
        image = os8.insert(image, name, os8.from_text(lines), draw.randrange(4096))
        kept[name] = lines
        some = draw.sample([*kept], min(3, len(kept)))
        assert [os8.text(os8.words(image, each)) for each in some] == [kept[each] for each in some]
    assert [each.name for each in os8.directory(image)] == [*kept, ""]
    assert sum(each.length for each in os8.directory(image)) == FREE


def test_a_full_directory_and_a_full_tape_are_refused() -> None:
    image = empty()
    with pytest.raises(TapeError, match="needs 731 blocks; the largest free place has 730"):
        os8.insert(image, "LARGE", [0] * (731 * 256))
    said = ""
    for number in range(300):
        try:
            image = os8.insert(image, f"F{number}", [0])
        except TapeError as error:
            said = str(error)
            break
    assert said == "segment 6 of the directory is full: squeeze the tape with PIP /S"
    assert len(os8.directory(image)) > 240


@pytest.mark.parametrize("last_there", [False, True])
def test_a_free_place_in_a_full_segment_is_passed_over(last_there: bool) -> None:
    """What was deleted left a place, but its segment has no room for another entry."""
    files = [
        word for number in range(41) for word in (0o0101 + number % 26, 0o0101 + number // 26, 0, 0, 0, -1)
    ]
    entries = (*files, 0, -5) if last_there else (0, -5, *files)
    image = formatted(-42, BLOCK, 2, 0, -1, *entries, then=(-1, BLOCK + 46, 0, 0, -1, 0, -FREE + 46))
    *_, last, free = os8.directory(os8.insert(image, "NEW", [0]))
    assert (last.name, last.block, free.length) == ("NEW", BLOCK + 46, FREE - 47)


def test_a_file_that_was_not_closed_is_none_as_in_os8() -> None:
    """DIR leaves out FORT.PA of no blocks, which an image of DEC's has, and PIP does not find it."""
    image = formatted(-2, BLOCK, 0, 0, -1, 0o0617, 0o2224, 0, 0o2001, 0, 0, 0, -FREE)
    assert [each.name for each in os8.directory(image)] == [""]
    assert "FORT.PA was opened for output and not closed" in os8.listing(image)
    with pytest.raises(TapeError, match=r"no file FORT\.PA"):
        os8.words(image, "FORT.PA")
    image = os8.insert(image, "FORT.PA", [5])
    assert os8.directory(image)[0].name == "FORT.PA"
    with pytest.raises(TapeError, match=r"FORT\.PA is there already"):
        os8.insert(image, "FORT.PA", [5])


@pytest.mark.parametrize(("more", "date"), [((), 0), ((0o1234,), 0o1234), ((0o1234, 0o5670), 0o1234)])
def test_the_first_additional_word_of_an_entry_is_its_date(more: tuple[int, ...], date: int) -> None:
    """A directory may have none, one or more of them."""
    image = formatted(-2, BLOCK, 0, 0, -len(more), 0o0102, 0, 0, 0o2001, *more, -2, 0, 2 - FREE)
    file, free = os8.directory(image)
    assert file == os8.Entry("AB.PA", BLOCK, 2, date)
    assert (free.name, free.block, free.length) == ("", BLOCK + 2, FREE - 2)


def test_a_free_place_has_no_date() -> None:
    before, *_ = os8.directory(formatted(-2, BLOCK, 0, 0, -1, 0, -5, 0o0101, 0o0101, 0o0101, 0, 0, -1))
    assert before == os8.Entry("", BLOCK, 5, 0)


def test_what_is_there_instead_of_a_file_is_said() -> None:
    for names, said in (
        ("", "no file"),
        ("ABCDEFGH", "A, B, C, D, E, F, G, H"),
        ("ABCDEFGHI", "H and 1 more"),
    ):
        image = empty()
        for name in names:
            image = os8.insert(image, name, [0])
        with pytest.raises(TapeError, match=f"{said}$"):
            os8.words(image, "X.PA")
    assert "opened" not in os8.listing(formatted(-2, BLOCK, 0, 0, -256, 0, 0, 0, -FREE)), (
        "a place of no block"
    )


def test_a_free_place_within_a_full_segment_begins_no_other() -> None:
    files = [
        word for number in range(41) for word in (0o0101 + number % 26, number // 26 + 1 << 6, 0, 0, 0, -1)
    ]
    with pytest.raises(TapeError, match="segment 1 of the directory is full"):
        os8.insert(formatted(-42, BLOCK, 0, 0, -1, 0, -5, *files), "NEW", [0])


def test_a_segment_is_full_to_its_last_word() -> None:
    assert len(os8.directory(formatted(-124, *FULL))) == 124
    files = [word for number in range(48) for word in (0o0101 + number % 26, number // 26 + 1 << 6, 0, 0, -1)]
    image = os8.insert(formatted(-51, BLOCK, 0, 0, 0, 0, -1, 0, -1, *files, 0, 50 - FREE), "NEW", [0] * 257)
    assert len(os8.directory(image)) == 52
    assert image.words[2 * dectape.WORDS + 2] == 0, "no next segment"


def test_a_file_may_fill_the_free_place() -> None:
    image = os8.insert(empty(), "WHOLE", [0] * (FREE * 256))
    assert [(each.name, each.length) for each in os8.directory(image)] == [("WHOLE", FREE)]


@pytest.mark.parametrize(
    ("image", "said"),
    [
        (dectape.blank(), "no OS/8 directory: segment 1 of the directory has 0 entries from block 0 on"),
        (formatted(-1, BLOCK, 7, 0, -1, 0, -FREE), "the next segment is 7; 1 to 6 are allowed, each once"),
        (formatted(-1, BLOCK, 1, 0, -1, 0, -FREE), "the next segment is 1"),
        (formatted(-1, BLOCK, 0, 0, -1, 0, -FREE - 1), "entry 1, a free place of 731 blocks from block 7 on"),
        (formatted(-1, BLOCK, 0, 0, -1, 0o4141, 0, 0, 0, 0, -1), r"entry 1, \.|entry 1, !!"),
        (formatted(-126, BLOCK, 0, 0, -1), "has 126 entries"),
        (formatted(-1, BLOCK, 0, 0, -257, 0, -FREE), "has 1 entries from block 7 on"),
        (formatted(-1, 737, 0, 0, -1, 0, -1), "entry 1, a free place of 1 block from block 1341 on"),
        (formatted(-1, 738, 0, 0, -1, 0, -1), "has 1 entries from block 1342 on"),
        (formatted(-1, BLOCK, 0, 0, -1, 0o0140, 0o0200, 0, 0, 0, -1), "entry 1, A B of 1 block"),
        (formatted(-125, *FULL), "entry 125 of 125 lies beyond its 256 words"),
    ],
)
def test_a_damaged_directory_is_named(image: dectape.Image, said: str) -> None:
    with pytest.raises(TapeError, match=said):
        os8.directory(image)


@pytest.mark.parametrize("name", ["", "1A", "SEVENTH", "A.BCD", "A-B", "A.B.C"])
def test_what_is_no_name_is_refused(name: str) -> None:
    with pytest.raises(TapeError, match="is no OS/8 name"):
        os8.insert(empty(), name, [0])
    assert os8.canonical("sixltr.p8") == "SIXLTR.P8"


@pytest.mark.parametrize("name", ["a.pa", "A", "b.bn", "B.BN", "c.sv", "C.SV", "d.rl", "d.bns"])
def test_a_file_is_a_text_a_tape_or_words_by_the_ending_of_its_name(
    name: str, call: Call, tmp_path: Path
) -> None:
    """Of the bytes 101 and 002 a text has the first with channel 8, a tape as it is, words both in one."""
    (tmp_path / "os8.tu56").write_bytes(empty().content())
    (tmp_path / name).write_bytes(b"\xef\xbb\xbf" * (name == "a.pa") + b"A\x02")
    assert call(f"pdp8 tape insert os8.tu56 {name} -o with.tu56")[0] == (name == "d.bns")
    ending = name.upper().partition(".")[2]
    if ending != "BNS":
        first = os8.words(dectape.decode((tmp_path / "with.tu56").read_bytes())[0], name)[0]
        assert first == {"BN": 0o4501, "SV": 0o1101, "RL": 0o1101}.get(ending, 0o4701)
        assert call(f"pdp8 tape extract with.tu56 {name} -o out")[0] == 0
        assert (tmp_path / "out").read_bytes()[:2] == b"A\x02"


@pytest.mark.skipif("PDP8_OS8" not in os.environ, reason="PDP8_OS8 names no folder with images of OS/8")
def test_every_file_of_public_images_is_within_its_tape() -> None:
    images = [*Path(os.environ["PDP8_OS8"]).glob("*.tu56")]
    for file in images:
        image, _ = dectape.decode(file.read_bytes())
        entries = os8.directory(image)
        assert sum(each.length for each in entries) + entries[0].block == 737
        for each in entries:
            if each.name:
                assert len(os8.words(image, each.name)) == 256 * each.length
