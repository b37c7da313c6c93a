"""Tapes drawn: rows of holes with their captions, SVG in true geometry, octal text."""

import re
import xml.etree.ElementTree as ET

import pytest

from pdp8 import shelf
from tapes import ascii, codes, octal, picture, rim
from tapes.errors import TextError
from tests.pictures import assert_looked_at
from tests.tapes.strips import FORMAT_BIN
from tests.tapes.strips import octal as holes

NS = "{http://www.w3.org/2000/svg}"


def test_rows_of_an_ascii_tape() -> None:
    assert picture.text(ascii.encode("A\n", fill=1), "ascii") == (
        "   frame  octal    8 7 6 5 4 . 3 2 1      ^ feed: the top row is read first\n"
        "       0    301  | o o       .     o |  A\n"
        "       1    215  | o       o . o   o |  CR\n"
        "       2    212  | o       o .   o   |  LF\n"
        "       3    377  | o o o o o . o o o |  RUBOUT\n"
    )


CAPTIONS = """\
bin  200 310 100 000 377 311 322 377 000 001 001 001 200
     leader|field 1|origin 0000|"|rubout|(I)|(R)|rubout|0000: 0001|"|checksum 0101|"|leader
bin  200 370 215 177 077 000 001 000 002 000 000 003 201
     leader|label|label|origin 7777|"|7777: 0001|"|0000: 0002|"|0001: 0000|"|?|?
bin  200 102 000 000 000 001 002 200 000 000 200
     leader|origin 0200|"|0200: 0000|"|checksum 0102|"|leader|blank|blank|leader
bin  200 377 102 000
     leader|rubout|origin 0200|"
bin  200 000 001 200
     leader|blank|?|leader
bin  200 102
     leader|?
rim  200 102 000 074 002 103 077 000 001 200
     leader|address 0200|"|7402|"|address 0377|"|0001|"|leader
rim  200 102 000 102 000 074 002 200
     leader|?|blank|address 0200|"|7402|"|leader
rim  200 377 000 310 102 000 074
     leader|label|blank|field 1|?|blank|?"""


def test_captions_frame_by_frame() -> None:
    """Fields, a typed message; a frame of no kind, the end of core, no trailer; blank tape is no word."""
    lines = CAPTIONS.splitlines()
    for tape, said in zip(lines[::2], lines[1::2], strict=True):
        assert codes.named(tape[:3]).captions(holes(tape[5:])) == said.strip().split("|")


def test_captions_of_labels_before_the_leader_and_after_the_trailer() -> None:
    one = rim.encode({0o200: 0o7402})
    behind = holes("000 000 000 177 011 000")
    assert codes.ASCII.labels(FORMAT_BIN + behind) == ()
    said = ["leader", "blank", "blank", "blank", "label", "label", "label"]
    assert codes.BIN.captions(FORMAT_BIN.rstrip(b"\0") + behind)[-7:] == said
    assert codes.RIM.captions(one + behind)[-7:] == said
    before = holes("000 177 011 377 000 000 000")
    said = ["blank", "label", "label", "label", "blank", "blank", "blank"]
    assert codes.BIN.captions(before + FORMAT_BIN.lstrip(b"\0"))[:8] == [*said, "leader"]
    assert codes.RIM.captions(before + one) == said + codes.RIM.captions(one)


def test_svg_has_every_hole_where_the_standard_puts_it() -> None:
    """Thousandths of an inch from the paper's edge beside channel 1: 0.392 to the sprocket, 0.1 a channel."""
    tape = bytes([0o377, 0o000, 0o301])
    page = ET.fromstring(picture.svg(tape, "ascii"))
    paper = next(rect for rect in page.iter(f"{NS}rect") if rect.attrib["class"] == "paper")
    left, top, width, height = (int(paper.attrib[name]) for name in ("x", "y", "width", "height"))
    assert (width, height) == (300, 1000)
    one, two = (float(ET.fromstring(picture.svg(bytes(count))).attrib["width"][:-2]) for count in (1, 2))
    assert two - one == pytest.approx(0.1)
    circles = [
        tuple(int(circle.attrib[name]) for name in ("cx", "cy", "r"))
        for circle in ET.fromstring(picture.svg(tape)).iter(f"{NS}circle")
    ]
    tracks = {1: 92, 2: 192, 3: 292, 4: 492, 5: 592, 6: 692, 7: 792, 8: 892}
    expected = [(x, 392, 23) for x in (50, 150, 250)]
    expected += [(50, y, 36) for y in tracks.values()] + [(250, tracks[channel], 36) for channel in (1, 7, 8)]
    assert sorted((x - left, y - top, radius) for x, y, radius in circles) == sorted(expected)


def test_a_drawing_is_the_one_that_was_looked_at() -> None:
    typed, binary = ascii.encode("<&A 12\n"), shelf.read("eia.bin")[:260]
    assert_looked_at("tape in ASCII", picture.svg(typed, "ascii", 1, -1, 7, tracks=True), "32d2d628")
    assert_looked_at("tape in BIN", picture.svg(binary, "bin"), "ba5e299c")


def test_octal_text() -> None:
    assert octal.decode(bytes(range(18))).splitlines() == [
        "      0: 000 001 002 003 004 005 006 007 010 011 012 013 014 015 016 017",
        "     16: 020 021",
    ]
    assert octal.encode("200 1 377 / trailer 9\n\n5:7") == holes("200 001 377 007")


@pytest.mark.parametrize("number", ["8", "400", "-1", "0o7", "7?", "١"])
def test_what_is_no_frame(number: str) -> None:
    with pytest.raises(TextError, match=f"line 2, column 9: {re.escape(repr(number))} is no frame"):
        octal.encode(f"200 200\n    16: {number}\n")
