"""`pdp8 part`: tapes that the chain translates into whole blocks, or one clear sentence."""

import shlex

import pytest

from pdp8.cli.root import pdp8
from tapes import command
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
    ("circle --radius -5", "radius -5: must be greater than 0"),
    ("circle --radius 0", "radius 0: must be greater than 0"),
    ("circle --tolerance 0", "tolerance must be 1 or more"),
    ("circle --tolerance 0.005", "thousandths of an inch"),
    ("circle --tolerance 2000", "the tolerance must be smaller than the curve"),
    ("circle --radius 5000", "block 005: X -1000 leaves the table"),
    ("circle --centre-x 19000", "block 226: X 20002 leaves the table"),
    ("circle --centre-y 9000", "leaves the table"),
    ("circle --feed 19", "feed code 19 is not in Table 2.4"),
    ("circle --sequence -1", "sequence number -1"),
    ("circle --preparatory 3", "preparatory function 3"),
    ("circle --x-feed 99", "miscellaneous function 99"),
    ("circle --start-x 9000", "must be in the first quadrant"),
    ("circle --spindle 20", "spindle code 20"),
    ("circle --outer 1e300", "the table is 20000"),
    ("polynomial --tolerance 1000", "must be smaller than the curve"),
    ("polynomial --tolerance 1e308", "tolerance 1e+308 in: must be a finite number"),
    ("polynomial --a 1e308", "off the table"),
    ("polynomial --a 1e308 --cutter 0.1", "off the table"),
    ("polynomial --a 1e308 --arithmetic ge635", "off the table"),
    ("slope --tolerance 6", "must be smaller than the curve"),
    ("slope --to-x 1e308", "must be a whole number of thousandths"),
    ("curve 'exp(x)*1e300'", "must be within 1e+06"),
    ("curve x --tolerance 5", "must be smaller than the curve"),
    ("drill --holes nan,1", "must be a whole number of thousandths"),
    ("fluidic --tolerance 0.2", "must be smaller than the curve"),
    ("ellipse --minor -1", "semi-minor axis -1"),
    ("ellipse --tolerance 2250", "the tolerance must be smaller than the curve"),
    ("die --cut groove --centre-y 1000", "leaves the table"),
    ("polynomial --tolerance 0", "must be .001 in, the machine's resolution"),
    ("polynomial --tolerance 0.001", "too steep"),
    ("polynomial --from 6 --to 0", "must go from less to more"),
    ("polynomial --to 7.5", "leaves the table"),
    ("curve 1 --from 0 --to 1e6", "block 007: X 24000 leaves the table"),
    ("curve 1 --from -1e6 --to 0", "block 005: X -16000 leaves the table"),
    ("curve 1 --from -1e6 --to -1e5", "block 005: X "),
    ("curve 1 --from 30 --to 40", "block 005: X 34000 leaves the table"),
    ("polynomial --cutter 4", "too big: at x ="),
    ("polynomial --cutter -1", "cutter of diameter -1 in: must be greater than 0"),
    ("curve x --cutter 1e308", "cutter of diameter 1e+308 in: must be greater than 0, and 10 at most"),
    ("slope --to-x 4 --to-y 4", "two different ends"),
    ("slope --tolerance -0.005", "must be .001 in, the machine's resolution"),
    ("slope --to-x 21", "leaves the table"),
    ("slope --to-x 4.00001", "must be a whole number of thousandths"),
    ("curve 1/x", "at x = 0 the expression"),
    ("curve 'tan(x)' --to 3", "too steep"),
    ("curve 'import os'", "not an expression in x"),
    ("curve x --technique piece --feed-error 2", "feed error 2: must be a fraction"),
    ("drill --holes ''", "no holes are given"),
    ("drill --holes 21,1", "block 003: X 21000 leaves the table"),
    ("fluidic --control 3", "must be beside the walls"),
    ("fluidic --axis-x 1", "leaves the table"),
]

MISUSED = [
    ("circle --radius x", "--radius"),
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


@pytest.mark.parametrize(("part", "said"), MISUSED)
def test_misuse_is_exit_2(capfd: pytest.CaptureFixture[str], part: str, said: str) -> None:
    status, output, message = ended(capfd, f"part {part}")
    assert (status, output) == (2, "")
    assert said in message


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
    "name",
    [
        "",
        "circle",
        "ellipse",
        "polynomial",
        "slope",
        "curve",
        "die",
        "drill",
        "fluidic",
        "compare",
        "compare die",
    ],
)
def test_every_help_has_examples(capfd: pytest.CaptureFixture[str], name: str) -> None:
    status, output, _ = ended(capfd, f"part {name} --help")
    assert status == 0
    assert "Examples:" in output
