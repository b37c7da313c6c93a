"""What is said of a tape; quantities in words and on drawings."""

from collections.abc import Callable

import pytest

from tapes import ascii, binary, codes, eia, measure, quantities, rim
from tapes.convert import convert
from tapes.errors import TapeError
from tests.tapes.strips import FORMAT_BIN, FORMAT_WORDS, LEADER, octal

BLOCKS = "0010000000000003588\n0029030000350000189\n"
EIA = bytes(4) + eia.encode(BLOCKS + "003") + bytes(2)
RIM = rim.encode(FORMAT_WORDS)
CORE = "0200-0221, 0232, 0300, 0400-0401"
SEVEN = octal("001 161 011 005 003")
LABELLED = bytes(2) + SEVEN + bytes(3) + rim.encode({0o200: 0o7402}) + bytes(1) + SEVEN + bytes(3)
APART = FORMAT_BIN + SEVEN + bytes(3) + binary.encode({0o200: 0o7402})
WRONG = FORMAT_BIN.replace(octal("072 000 071"), octal("072 000 070"))
FORTRAN = LEADER + octal("300 012 034 056 070") * 9 + LEADER
NO_ADDRESS = "The BIN loader has no address for it; an object tape of FORTRAN looks so"
DRAWN = "\n".join(f" {row}" for row in ("ooooo", "    o", "   o", "  o", " o", " o", " o", ""))
"""A 7 for the eye, channel 1 at the top."""
BIN = "tape BIN, DEC's binary loader format\n"
HOLDS = "holds words 22, origins 5, fields 0"

REPORTS: dict[bytes, str] = {
    ascii.encode(("0" * 19 + "\n") * 666): """\
tape ASCII
frames 17,982: leader 0, trailer 0
length 149 ft 10.2 in
time Teletype (10 a second) 29 min 58.2 s; high-speed reader (300) 59.9 s, punch (50) 5 min 59.6 s
parity mark
lines 666 of 19 characters
line ends 666 CR, 666 LF, 3,996 RUBOUT""",
    b"ABAB": """\
tape ASCII
parity none
lines 0, then 4 characters without an end""",
    b"A\nBC\nBCD\nD": """\
tape ASCII
parity none
lines 3 of 1 to 3 characters, then 1 character without an end
line ends 0 CR, 3 LF, 0 RUBOUT
warning LF without CR: no Teletype would return its carriage; `pdp8 tape punch` punches CR LF""",
    b"": "tape empty",
    bytes(9): "tape blank",
    bytes(range(256)): f"tape unknown: none of {', '.join(code.name.upper() for code in codes.CODES)}",
    EIA: """\
tape EIA RS-244
frames 49: leader 4, trailer 2
blocks 2 of 20 frames, then 3 frames without an end
parity odd in every frame; every frame an EIA code""",
    EIA.replace(b"\x15", b"\x14"): """\
tape EIA RS-244
blocks 2 of 20 frames, then 3 frames without an end
parity odd, but not in every frame
doubt frame 20: 024 (channels 5 3) breaks EIA's code, of odd holes
doubt frame 35: 024 (channels 5 3) breaks EIA's code, of odd holes""",
    FORMAT_BIN: f"""{BIN}\
frames 185: leader 65, trailer 64
checksum 1251 at frame 119: good
{HOLDS}
core {CORE}""",
    WRONG: f"{BIN}checksum 1251 at frame 119: WRONG, 1250 computed\n{HOLDS}",
    binary.encode({}): f"{BIN}checksum 0000 at frame 64: good\nholds words 0, origins 0, fields 0\ncore none",
    binary.encode({0o10200: 0o7402}): f"""{BIN}\
checksum 0200 at frame 69: good
holds words 1, origins 1, fields 1
core 10200""",
    LEADER: f"{BIN}damage frame 64: nothing but leader",
    FORMAT_BIN[:101]: f"{BIN}damage frame 101: the tape is cut short: it has no trailer",
    FORTRAN: f"{BIN}damage frame 65: a word before any origin. {NO_ADDRESS}",
    FORMAT_BIN + b"\x41": f"""{BIN}\
checksum 1251 at frame 119: good
{HOLDS}
core {CORE}
label 1 frame from frame 185 on""",
    APART: f"""{BIN}\
checksum 1251 at frame 119: good
{HOLDS}
core {CORE}
label 142 frames from frame 185 on
apart a good section from frame 193 on, after the label: a tape of its own""",
    RIM: f"tape RIM, DEC's read-in mode format\nholds 22 words; RIM has no checksum\ncore {CORE}",
    RIM[:90]: """\
tape RIM, DEC's read-in mode format
holds 6 words; RIM has no checksum
core 0200-0205
damage frame 90: the tape is cut short inside a word""",
    LABELLED: f"""\
tape RIM, DEC's read-in mode format
holds 1 word; RIM has no checksum
core 0200
label 5 frames from frame 2 on
{DRAWN}
label 8 frames from frame 143 on
{DRAWN}""",
}
"""What is said of each: its length in frames, inches and minutes only where it is told here."""


@pytest.mark.parametrize("tape", REPORTS)
def test_a_report(tape: bytes) -> None:
    report = [f"{name} {value}" for name, value in measure.report(tape)]
    told = REPORTS[tape].splitlines()
    assert [row for row in report if row in told or not (row in report[1:4] or row[0] == " ")] == told


@pytest.mark.parametrize(
    ("write", "number", "written"),
    [
        (measure.length, 119, "11.9 in"),
        (measure.length, 120, "1 ft 0.0 in"),
        (quantities.inches, 0, ".0000"),
        (quantities.inches, 1250, "1.2500"),
        (quantities.inches, 10_500.04, "10.5000"),
        (quantities.inches, -4.6, "-.0046"),
        (quantities.inches, -0.01, "-.0000"),
        (quantities.duration, 59.94, "59.9 s"),
        (quantities.duration, 60, "1 min 0.0 s"),
        (quantities.duration, 3599.96, "1 h 0 min 0.0 s"),
        (quantities.duration, 3723, "1 h 2 min 3.0 s"),
    ],
)
def test_quantities_in_words_and_as_on_drawings(
    write: Callable[[float], str], number: float, written: str
) -> None:
    assert write(number) == written


BINARY = "BIN, DEC's binary loader format"
_LINES = "".join(f"N{number:02} G01 X{number * 37:04} Y{number * 91:04}\n" for number in range(1, 30))
_PARTS = {
    "ASCII": ascii.encode(_LINES, "even"),
    "EIA RS-244": eia.encode(_LINES[: len(_LINES) // 29 * 14]),
    BINARY: FORMAT_BIN.lstrip(bytes(1)),
}


@pytest.mark.parametrize("order", [("ASCII", "EIA RS-244"), ("EIA RS-244", "ASCII"), ("ASCII", BINARY)])
def test_a_part_in_another_code_is_named_and_not_converted(order: tuple[str, str]) -> None:
    parts = [_PARTS[name] for name in order]
    tape = bytes(30).join(parts)
    report = measure.report(tape)
    (doubt,) = [value for said, value in report if said == "doubt"]
    whole = dict(report)["tape"]
    (at,) = {0, 1} - {order.index(whole)}
    first = at * (len(parts[0]) + 30)
    last = first + len(parts[at]) - 1
    assert doubt.startswith(f"frame {first}: the frames from here to {last} are {order[at]}, not {whole}; ")
    assert f"--from {first} --to {last}" in doubt
    with pytest.raises(TapeError, match=f", not {whole}"):
        convert(tape, codes.recognise(tape).name, "text")
    assert not any("from here to" in value for _, value in measure.report(parts[0] + bytes(30) + parts[0]))


def test_blank_tape_inside_a_line_is_named() -> None:
    tape = _PARTS["ASCII"]
    assert "blank" not in dict(measure.report(tape[:27] + bytes(30) + tape[27:])), "between two lines"
    for more, others in ((b"", ""), (b"\0", ", and in 1 other place")):
        said = dict(measure.report(tape[:30] + bytes(30) + tape[30:60] + more + tape[60:]))["blank"]
        assert said == f"30 frames inside a line from frame 30 on{others}"


@pytest.mark.parametrize(("count", "last"), [(10, "frame "), (11, "and 1 more"), (13, "and 3 more")])
def test_ten_doubts_are_told_and_the_others_counted(count: int, last: str) -> None:
    tape = bytearray(eia.encode("".join(f"{number:03}0000000000003588\n" for number in range(30))))
    for damaged in range(count):
        tape[40 + 37 * damaged] ^= 0o100
    *first, ended = [what for name, what in measure.report(bytes(tape)) if name == "doubt"]
    assert ended.startswith(last)
    assert len(first) == 10 - (count == 10)


def test_an_end_of_block_may_be_in_doubt_for_two_reasons() -> None:
    block = "0123456789012345678\n"
    tape = bytearray(ascii.encode(block * 9 + "\n" + block * 9))
    tape[9 * 27 + 1] ^= 0o200
    said = [value for name, value in measure.report(bytes(tape)) if name == "doubt"]
    first = "frame 244: 012 (LF) breaks the tape's parity, mark; likely 212 (LF), channel 8"
    assert said == [first, "frame 244: an end of block without a block"]
