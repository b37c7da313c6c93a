"""`pdp8 tape` as a user meets it: its products, its manners, and every bad input in one line."""

import re
from pathlib import Path

import pytest

from tapes import ascii, binary, eia
from tests import commands
from tests.conftest import Shell
from tests.tapes.strips import FORMAT_BIN, FORMAT_WORDS, assert_same

DRILLING = """\
001 0 00000 00000 0 35 88
002 9 03000 03500 0 01 89
003 5 01000 01000 0 01 89
004 5 01000 02000 0 01 89
005 5 04000 02000 0 01 89
006 5 04000 01000 0 01 89
"""
"""The four holes of the thesis's chapter 3, spaces "used for clarity only"."""


def pdp8(*arguments: str, given: bytes = b"", cwd: Path | None = None) -> commands.Done:
    return commands.run("pdp8", *arguments, stdin=given, folder=cwd)


def product(*arguments: str, given: bytes = b"", cwd: Path | None = None) -> bytes:
    done = pdp8(*arguments, given=given, cwd=cwd)
    assert done.returncode == 0
    assert re.fullmatch(rb"(wrote x\.\w+\n)?", done.stderr)
    return done.stdout


def complaint(*arguments: str, given: bytes = b"", cwd: Path | None = None, status: int = 1) -> str:
    """Return the one line a command that fails says."""
    done = pdp8(*arguments, given=given, cwd=cwd)
    said = done.stderr.decode()
    assert done.returncode == status, said
    assert b"Traceback" not in done.stderr
    assert done.stdout == b""
    if status == 1:
        assert said.count("\n") == 1, said
    return said


def test_the_drilling_program_is_punched() -> None:
    made = product(
        "tape", "punch", "--code", "eia", "--drop-spaces", "--leader", "20", given=DRILLING.encode()
    )
    assert len(made) == 20 + 6 * 20 + 20
    assert_same(made, bytes(20) + eia.encode(DRILLING.replace(" ", "")) + bytes(20))


def test_the_spaces_of_the_thesis_are_for_clarity_and_others_are_codes() -> None:
    punch = ("tape", "punch", "--code", "eia")
    assert_same(product(*punch, given=DRILLING.encode()), eia.encode(DRILLING.replace(" ", "")))
    assert_same(product(*punch, "--keep-spaces", given=DRILLING.encode()), eia.encode(DRILLING))
    assert_same(product(*punch, given=b"G1 X2\n"), eia.encode("G1 X2\n"))
    for lines in ("  1019   0    0   2\n  76 2250 4133  185\n", " 010000000000003588\n"):
        assert_same(product(*punch, given=lines.encode()), eia.encode(lines))
    assert_same(product("tape", "punch", given=DRILLING.encode()), ascii.encode(DRILLING.replace(" ", "")))


def test_a_text_file_becomes_a_proper_tape(tmp_path: Path) -> None:
    (tmp_path / "typed.txt").write_bytes(b"*200\r\n\tHLT\r\n$\r\n")
    assert product("tape", "punch", "typed.txt", "--parity", "even", "-o", "x.asc", cwd=tmp_path) == b""
    assert_same((tmp_path / "x.asc").read_bytes(), ascii.encode("*200\n\tHLT\n$\n", "even"))


def test_show_a_range() -> None:
    rows = [
        "      65    102  |   o       .   o   |  origin 0200",
        '      66    000  |           .       |  "',
    ]
    for last, expected in (("66", rows), ("65", rows[:1])):
        shown = product("tape", "show", "--from", "65", "--to", last, given=FORMAT_BIN)
        assert shown.decode().splitlines()[1:] == expected


def test_show_as_svg() -> None:
    assert product("tape", "show", "--svg", "-", given=FORMAT_BIN).startswith(b"<svg")


def test_info_of_several(tmp_path: Path) -> None:
    (tmp_path / "a.bin").write_bytes(FORMAT_BIN)
    said = product("tape", "info", "a.bin", "-", given=eia.encode("1\n"), cwd=tmp_path).decode()
    assert re.findall(r"^\S.*|tape  .*", said, re.M) == [
        "a.bin",
        "tape       BIN, DEC's binary loader format",
        "standard input",
        "tape       EIA RS-244",
    ]


def test_convert_tells_the_code_and_goes_round() -> None:
    as_rim = product("tape", "convert", "--to", "rim", given=FORMAT_BIN)
    assert_same(product("tape", "convert", "--to", "bin", given=as_rim), binary.encode(FORMAT_WORDS))
    spelled = product("tape", "convert", "--to", "octal", given=FORMAT_BIN)
    assert_same(product("tape", "convert", "--code", "octal", "--to", "frames", given=spelled), FORMAT_BIN)
    assert product("tape", "convert", "--to", "text", given=eia.encode("12\n")) == b"12\n"


@pytest.mark.parametrize(
    ("line", "given", "said"),
    [
        ("show nowhere.asc", b"", "show: nowhere.asc: no such file, here or among the bundled ones"),
        ("show .", b"", "pdp8 tape show: .: Is a directory"),
        ("show", b"", "pdp8 tape show: standard input: frame 0: empty tape"),
        ("show --from 9", b"\0", "pdp8 tape show: standard input: frame 9: the tape has only 1"),
        ("show --svg .", b"\0", "pdp8 tape show: .: Is a directory"),
        ("convert --to rim", FORMAT_BIN[:100], "frame 100: the tape is cut short inside a word"),
        ("convert --code eia --to text", b"C\n", "input: frame 1: 012 (channels 4 2) is no EIA"),
        ("convert --to octal -o no/x", FORMAT_BIN, "pdp8 tape convert: no/x: No such file or directory"),
        ("punch", b"\xff\xfe", "standard input: line 1, column 1: byte 377 is no text"),
        ("punch", "1\né".encode(), "standard input: line 2, column 1: 'é' is no ASCII character"),
        ("punch --code eia", b"1!\n", "standard input: line 1, column 2: '!' has no EIA code"),
        ("punch -o /dev/full", b"C\n", "pdp8 tape punch: /dev/full: No space left on device"),
    ],
)
def test_bad_input_in_one_line(line: str, given: bytes, said: str, tmp_path: Path) -> None:
    assert said in complaint("tape", *line.split(), given=given, cwd=tmp_path)
    assert not list(tmp_path.iterdir())


MISUSE = """\
show --from -1: Invalid value for '--from': -1 is not in the range x>=0.
show --to -1: Invalid value for '--to': -1 is not in the range x>=0.
show --to 1 --from 2: --to 1 lies before --from 2
show --code x: '--code': 'x' is not one of 'auto', 'ascii', 'eia', 'bin', 'rim', 'none'.
convert: Missing option '--to'. Choose from:
convert --code x: '--code': 'x' is not one of 'auto', 'text', 'ascii', 'eia', 'bin', 'rim', 'octal'.
convert --to x: '--to': 'x' is not one of 'text', 'ascii', 'eia', 'bin', 'rim', 'octal', 'frames'.
convert --parity x: '--parity': 'x' is not one of 'mark', 'even', 'odd', 'none'.
convert --fill 1001: '--fill': 1001 is not in the range 0<=x<=1000.
punch --code text: '--code': 'text' is not one of 'ascii', 'eia'.
punch --fill -1: '--fill': -1 is not in the range 0<=x<=1000.
punch --fill 1001: '--fill': 1001 is not in the range 0<=x<=1000.
punch --leader -1: '--leader': -1 is not in the range 0<=x<=100000.
punch --leader 100001: '--leader': 100001 is not in the range 0<=x<=100000.
read: Missing argument 'PHOTOS...'.
hang: there is no command 'hang'"""


@pytest.mark.parametrize("case", MISUSE.splitlines())
def test_misuse(case: str) -> None:
    line, _, says = case.partition(": ")
    said = complaint("tape", *line.split(), status=2)
    assert said.startswith("pdp8 tape")
    assert said.splitlines()[0].endswith(says)
    assert "--help shows what there is" in said


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("tape convert a.asc --to text -o a.asc", "a.asc is the source; name another file"),
        ("run a.bin --reader a.asc --punch a.asc", "a.asc is the source; name another file"),
        ("nc inspect a.asc --stretch 1,2", "--stretch needs --talysurf"),
        ("run a.bin --punch x --trace x", "two outputs go to x"),
        ("run a.bin --trace -", "two outputs go to standard output"),
        ("run - --reader -", "standard input can be read only once"),
        ("run a.bin --cycles", "--cycles means nothing without --trace"),
    ],
)
def test_no_output_is_a_source(line: str, message: str, tmp_path: Path) -> None:
    (tmp_path / "a.bin").write_bytes(FORMAT_BIN)
    (tmp_path / "a.asc").write_bytes(b"12\r\n")
    done = pdp8(*line.split(), cwd=tmp_path)
    assert done.returncode == 2
    assert message in done.stderr.decode()
    assert sorted(file.read_bytes() for file in tmp_path.iterdir()) == [FORMAT_BIN, b"12\r\n"]


def test_a_data_tape_is_no_program() -> None:
    said = complaint("run", "circle.asc")
    assert said == "pdp8 run: circle.asc: nothing but figures: no program, but a tape for the reader\n"


def test_a_file_that_hides_a_bundled_one_is_named(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "circle.asc").write_bytes(b"A\r\n")
    said = shell("pdp8 tape info circle.asc").stderr
    assert b"circle.asc is the file in this folder, not the bundled one of that name" in said
