"""`pdp8 part`: tapes that the chain translates into whole blocks, or one clear sentence."""

import re
import shlex

import pytest

from pdp8.cli.root import pdp8
from programs import parts
from programs.printout import check_band
from programs.units import THOUSANDTHS
from tapes import ascii, command
from tapes.errors import WorkError
from tests.conftest import Shell

PARTS = [
    "polynomial --technique piece",
    "polynomial --to 2 --cutter 0.5",
    "slope",
    "curve 'sin(x)' --to 2",
    "die --technique piece",
    "drill",
    "fluidic --program control --control 0.8",
]
"""Parts to send through the whole chain; the circle and the ellipse go there in tests/test_chain.py."""

REFUSED = [
    ("circle --radius -5", "radius -5 in: must be greater than 0"),
    ("circle --radius 0", "radius 0 in: must be greater than 0"),
    ("circle --tolerance 0", "a tolerance must be .001 in, the machine's resolution, or more"),
    ("circle --tolerance 0.0005", "radius 1.75 in between 1.7495 in and 1.7505 in"),
    ("circle --radius 0.5 --tolerance 0.6", "the tolerance must be smaller than the curve"),
    ("circle --radius 5", "block 005: X -1.000 leaves the table: 0 to 20 in"),
    ("circle --centre-x 19", "block 226: X 20.002 leaves the table"),
    ("circle --centre-y 9", "leaves the table"),
    ("circle --feed-code 19", "feed code 19 is not in Table 2.4"),
    ("circle --sequence -1", "sequence number -1"),
    ("circle --preparatory 3", "preparatory function 3"),
    ("circle --x-feed 99", "miscellaneous function 99"),
    ("circle --start-x 9", "must be in the first quadrant"),
    ("circle --spindle 20", "spindle code 20"),
    ("circle --outer 90", "the table is 20 in"),
    ("circle --park-x 20.002", "park X 20.002 in is outside the travel: 0 to 20 in"),
    ("polynomial --from 0 --to 0.1 --tolerance 0.9", "must be smaller than the curve"),
    ("polynomial --a 999999", "off the table"),
    ("polynomial --a 999999 --cutter 0.1", "off the table"),
    ("polynomial --a 999999 --arithmetic ge635", "off the table"),
    ("slope --to-x 4.1 --to-y 4.1 --tolerance 0.6", "must be smaller than the curve"),
    ("curve 'exp(x)*1e300'", "must be within 1e+06"),
    ("curve x --to 0.5 --tolerance 0.8", "must be smaller than the curve"),
    ("drill --holes 1.0005,1", "X 1.0005 in: must be a whole number of thousandths"),
    ("fluidic --tolerance 0.2", "must be smaller than the curve"),
    ("ellipse --minor -1", "semi-minor axis -1"),
    ("ellipse --minor 0.5 --tolerance 0.6", "the tolerance must be smaller than the curve"),
    ("die --cut groove --centre-y 1", "leaves the table"),
    ("polynomial --tolerance 0", "must be .001 in, the machine's resolution"),
    ("polynomial --tolerance 0.001", "too steep"),
    ("polynomial --from 6 --to 0", "must go from less to more"),
    ("polynomial --to 7.5", "leaves the table"),
    ("curve 1 --from 0 --to 99", "block 007: X 24.000 leaves the table"),
    ("curve 1 --from -99 --to 0", "block 005: X -16.000 leaves the table"),
    ("curve 1 --from -99 --to -50", "block 005: X "),
    ("curve 1 --from 30 --to 40", "block 005: X 34.000 leaves the table"),
    ("polynomial --cutter 4", "too big: at x ="),
    ("polynomial --cutter -1", "cutter of diameter -1 in: must be greater than 0"),
    ("curve x --cutter 11", "cutter of diameter 11 in: must be greater than 0, and 10 at most"),
    ("slope --to-x 4 --to-y 4", "two different ends"),
    ("slope --tolerance -0.005", "must be .001 in, the machine's resolution"),
    ("slope --to-x 21", "leaves the table"),
    ("slope --to-x 4.0000000001", "X 4.0000000001 in: must be a whole number of thousandths"),
    ("curve 1/x", "at x = 0 the expression"),
    ("curve 'tan(x)' --to 3", "too steep"),
    ("curve 'import os'", "not an expression in x"),
    ("curve x --technique piece --feed-error -5", "feed error -5%: must be from 0 to less than 100 %"),
    ("drill --holes ''", "no holes are given"),
    ("drill --z-depth 2", "final Z depth 2 in is above the Z feed point, 3 in"),
    ("drill --holes 21,1", "block 003: X 21.000 leaves the table"),
    ("fluidic --control 3", "must be beside the walls"),
    ("fluidic --axis-x 1", "leaves the table"),
]

MISUSED = [
    ("circle --radius x", "--radius"),
    ("circle --radius 1750", "1750 in: must be less than 100 in; for 1750 thousandths write"),
    ("circle --radius 1.7505", "1.7505 is not a whole number of thousandths of an inch"),
    ("circle --tolerance 5", "for 5 thousandths write 0.005"),
    ("circle --outer 1e999999999", "1e999999999 in: must be less than 100 in."),
    ("circle --sequence 7.5", "7.5 is not a whole number."),
    ("circle --sequence 1e999999999", "must be less than 1,000,000"),
    ("slope --park-x 19000", "for 19000 thousandths write 19"),
    ("slope --z-depth 3.4995", "3.4995 is not a whole number of thousandths of an inch"),
    ("slope --feed-error 0.2", "0.2 %: must be 0, or at least 1 %; for 0.2 as a fraction write 20"),
    ("slope --feed-error 0.01", "for 0.01 as a fraction write 1"),
    ("circle --radius 1_0", "'1_0' is not a number"),
    ("polynomial --tolerance 1000", "must be less than 1 in"),
    ("drill --holes 1000,1000", "for 1000 thousandths write 1"),
    ("drill --holes nan,1", "not a finite number"),
    ("circle --tolerance nan", "not a finite number"),
    ("curve x --cutter inf", "not a finite number"),
    ("curve x --cutter nan", "not a finite number"),
    ("circle --arithmetic pdp8", "--arithmetic"),
    ("circle --fill -1", "--fill"),
    ("curve", "EXPRESSION"),
    ("drill --holes 1", "not a list of places"),
    ("square", "square"),
    ("compare slope", "slope"),
]


@pytest.mark.parametrize("part", PARTS)
def test_the_chain_translates_every_part_into_whole_blocks(shell: Shell, part: str) -> None:
    done = shell(
        f"pdp8 part {part} --parity none --fill 0 > part.asc && pdp8 run eia.pal < part.asc && cat part.asc"
    )
    assert done.returncode == 0, done.stderr
    tape, printout = (
        done.stdout[: done.stdout.rindex(b"\x80") + 1],
        done.stdout[done.stdout.rindex(b"\x80") + 1 :],
    )
    lines = printout.decode().splitlines()
    rows = tape[1:]
    assert tape[0] == 0
    assert len(rows) == 20 * len(lines)
    digit = {
        0o040: 0,
        0o001: 1,
        0o002: 2,
        0o023: 3,
        0o004: 4,
        0o025: 5,
        0o026: 6,
        0o007: 7,
        0o010: 8,
        0o031: 9,
    }
    for number, line in enumerate(lines):
        block = rows[20 * number : 20 * number + 20]
        assert block[19] == 0o200
        assert "".join(str(digit[row]) for row in block[:19]) == line.replace(" ", "0"), (
            f"block {number + 1:03}"
        )


def ended(capfd: pytest.CaptureFixture[str], line: str) -> tuple[object, str, str]:
    """Run a command line here, not in a process of its own; return exit status, output and complaint."""
    with pytest.raises(SystemExit) as exit_:
        command.run(pdp8, "pdp8", shlex.split(line))
    return exit_.value.code, *capfd.readouterr()


@pytest.mark.parametrize(("part", "said"), REFUSED)
def test_a_part_that_cannot_be_is_refused_in_one_sentence(
    capfd: pytest.CaptureFixture[str], part: str, said: str
) -> None:
    status, output, message = ended(capfd, f"part {part}")
    assert (status, output) == (1, "")
    assert said in message
    assert message.count("\n") == 1


def test_a_radius_of_a_thousandth_can_have_a_band() -> None:
    check_band("radius", 1, 0.25, 2.5)


@pytest.mark.parametrize(("part", "said"), MISUSED)
def test_misuse_is_exit_2(capfd: pytest.CaptureFixture[str], part: str, said: str) -> None:
    status, output, message = ended(capfd, f"part {part}")
    assert (status, output) == (2, "")
    assert said in message


@pytest.mark.parametrize(
    ("inches", "digits"), [("3.5", "03500"), ("3.4", "03400"), ("4.001", "04001"), ("3.0010", "03001")]
)
def test_every_command_takes_lengths_in_inches(
    capfd: pytest.CaptureFixture[str], inches: str, digits: str
) -> None:
    depths = []
    for part in ("circle", "slope", "curve 0", "drill"):
        _, tape, _ = ended(capfd, f"part {part} --z-depth {inches} --parity none --fill 0")
        depths += [line[9:14] for line in tape.replace(" ", "0").splitlines() if line.endswith("189")][:1]
    assert depths == [digits] * 4


def test_no_digit_of_a_length_is_lost() -> None:
    for thousandths in range(1, 20_001, 7):
        text = f"{thousandths // 1000}.{thousandths % 1000:03}"
        assert THOUSANDTHS.keep(text) == thousandths
        assert THOUSANDTHS.keep(THOUSANDTHS.ask(thousandths)) == thousandths
    assert THOUSANDTHS.keep("0.123456789012345") == 123.456789012345


def test_what_a_curve_knows_stands_in_its_help_and_in_its_message(
    capfd: pytest.CaptureFixture[str],
) -> None:
    _, shown, _ = ended(capfd, "part curve --help")
    _, _, unknown = ended(capfd, "part curve 'sinus(x)'")
    _, _, broken = ended(capfd, "part curve 'x +'")
    for text in (" ".join(shown.split()), unknown, broken):
        assert "x, pi, e, + - * / ** ( ) and sqrt, exp, log, sin, cos, tan" in text


def test_capitals_are_fortrans(capfd: pytest.CaptureFixture[str]) -> None:
    tapes = [ended(capfd, f"part curve '{y}' --to 2")[1] for y in ("SIN(X)**2*1E0", "sin(x)**2*1e0")]
    assert tapes[0] == tapes[1] != ""


def test_the_circles_tape_is_27_frames_a_line(shell: Shell) -> None:
    tape = shell("pdp8 part circle").stdout
    assert len(tape) == 17982 == 27 * 666
    assert tape[19:27] == bytes([0o215, 0o212, *[0o377] * 6])


@pytest.mark.parametrize("options", ["--parity even", "--parity none --fill 0"])
def test_a_tape_to_a_file_is_the_tape_to_a_pipe(shell: Shell, options: str) -> None:
    done = shell(f"pdp8 part ellipse {options} -o there.asc && pdp8 part ellipse {options} | cmp - there.asc")
    assert done.returncode == 0


def test_compare_shows_the_nine_blocks_side_by_side(shell: Shell) -> None:
    lines = shell("pdp8 part compare ellipse").stdout.decode().splitlines()
    assert lines[0].split() == ["block", "exact", "ge635"]
    assert lines[1] == "  587  5876 6404 2647  585  5876 6404 2646  585"
    assert len(lines) == 11
    assert lines[-1] == "ellipse: 976 blocks exact, 976 ge635, 9 differ"


def test_compare_of_two_that_agree(shell: Shell) -> None:
    lines = shell("pdp8 part compare circle --with ieee32").stdout.decode().splitlines()
    assert lines[1:] == ["circle: 666 blocks exact, 666 ieee32, 0 differ"]


def test_a_full_disk_and_a_closed_pipe(shell: Shell) -> None:
    full = shell("pdp8 part circle > /dev/full")
    assert full.returncode == 1
    assert b"No space left" in full.stderr
    closed = shell("pdp8 part ellipse | head -c 1")
    assert closed.stderr == b""


def test_a_folder_is_no_file(shell: Shell) -> None:
    done = shell("mkdir here && pdp8 part circle -o here")
    assert done.returncode == 1
    assert done.stderr.decode().count("\n") == 1


@pytest.mark.parametrize(
    ("typed", "constants"),
    [
        ("circle --radius 1 --tolerance .003", {"radius": 1, "tolerance": ".003"}),
        ("circle --radius 1.5in --close --park-x 18", {"radius": "1.5in", "close": True, "park_x": 18}),
        (
            "ellipse --arithmetic ge635 --feed-code 2",
            {"arithmetic": "ge635", "feed_code": 2, "outer_major": None},
        ),
        ("slope --technique piece --feed-error 10%", {"technique": "piece", "feed_error": 10}),
        ("drill --holes '1,1 2.5,1.125'", {"holes": ((1, 1), (2.5, 1.125))}),
        ("curve 'sin(x)' --from 1 --to 2", {"from_": 1, "to": "2"}),
    ],
)
def test_a_script_gives_constants_as_the_command_takes_them(
    typed: str, constants: dict[str, object], shell: Shell
) -> None:
    name, *more = shlex.split(typed)
    done = shell(f"pdp8 part {typed}")
    assert done.stdout == ascii.encode(parts.part(name, *more[: name == "curve"], **constants)), done.stderr


@pytest.mark.parametrize(
    ("constants", "message"),
    [
        (
            {"radius": 1750},
            "circle: radius: 1750 in: must be less than 100 in; for 1750 thousandths write 1.75",
        ),
        ({"radus": 1}, "circle: no constant 'radus'; there are radius, tolerance"),
        ({"technique": "leap"}, "circle: technique: 'leap' is not one of"),
    ],
)
def test_a_script_is_told_what_the_command_says(constants: dict[str, object], message: str) -> None:
    with pytest.raises(WorkError, match=re.escape(message)):
        parts.part("circle", **constants)
