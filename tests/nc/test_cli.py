"""`pdp8 nc` as a user meets it: its products, its manners, and every bad input in one line."""

import re

import pytest
from click.testing import CliRunner

from nc.cli import nc
from nc.curves import Ellipse
from nc.dxf import dxf
from nc.inspection import inspect
from nc.machine import cut
from nc.plot import plot
from nc.talysurf import talysurf
from tests.conftest import Shell, case
from tests.nc.tapes_1971 import CIRCLE, CIRCLE_BLOCKS, FOUR_HOLES, HEADER, tape

COMMANDS = {
    "list": "  666 666 6   2.251   3.844  01 84  mill X to 2.251 at 1.0 in/min",
    "cut": "machining        36.7 min",
    "plot": "<svg",
    "inspect": "worst trough to peak .0173 in",
    "export --gcode": "\nM2\n",
    "export --dxf": "\nEOF\n",
}
"""The commands, with something that only their product of the circle has."""


def product(shell: Shell, line: str, stdin: bytes = b"") -> str:
    done = shell(line, stdin)
    assert (done.returncode, done.stderr) == (0, b"")
    return done.stdout.decode()


def complaint(shell: Shell, line: str, stdin: bytes = b"", status: int = 1) -> str:
    """Return the line a command that fails says; there is no traceback, and of a failed job no more."""
    done = shell(line, stdin)
    said = done.stderr.decode()
    assert done.returncode == status, said
    assert "Traceback" not in said
    assert not done.stdout or "block 1," not in said
    lines = said.strip().splitlines()
    assert len(lines) == 1 or status == 2
    return lines[-1] if status == 1 else lines[0]


@pytest.mark.parametrize("command", COMMANDS)
def test_a_bundled_tape_and_standard_input_are_the_same(shell: Shell, command: str) -> None:
    named = product(shell, f"pdp8 nc {command} circle.eia")
    assert COMMANDS[command] in named
    assert named == product(shell, f"pdp8 nc {command}", CIRCLE)


def test_the_ellipse_at_other_feeds(shell: Shell) -> None:
    """50 minutes in Chapter 7: not at the programmed code 05, nearly so at code 01 and 20 % fast."""
    assert "contour alone    36.1 min" in product(shell, "pdp8 nc cut ellipse.eia")
    assert "contour alone    53.2 min" in product(shell, "pdp8 nc cut ellipse.eia --feed-code 1")
    assert "contour alone    49.7 min" in product(
        shell, "pdp8 nc cut ellipse.eia --feed-code 1 --feed-error 20"
    )
    assert "milling          26.1 min" in product(
        shell, "pdp8 nc cut ellipse.eia --feed-code 1 --feed-error -20,-20,0"
    )


def test_the_four_holes_typed_in_and_punched(shell: Shell) -> None:
    """Chapter 3: typed with spaces for clarity only, punched in EIA, drilled."""
    typed = ("\n".join(FOUR_HOLES) + "\n").encode()
    spaced = product(shell, "pdp8 tape punch --code eia --drop-spaces - | pdp8 nc list --strict", typed)
    unbroken = product(shell, "tr -d ' ' | pdp8 tape punch --code eia - | pdp8 nc list --strict", typed)
    assert spaced == unbroken
    assert "drill at X 4.000 Y 1.000, from 3.000 to 3.500 at 1.0 in/min" in spaced
    cut = product(shell, "pdp8 tape punch --code eia --drop-spaces - --leader 50 | pdp8 nc cut", typed)
    assert "holes         4" in cut


def test_a_peck_is_a_tenth_of_an_inch_if_nothing_is_said(shell: Shell) -> None:
    deep = "006 9 00000 05000 0 18 89"
    frames = tape(*HEADER[:5], deep, "007 4 01000 01000 0 00 80", "008 6 01500 01000 0 01 84")
    said, *others = (product(shell, f"pdp8 nc cut {peck}", frames) for peck in ("", "--peck .1", "--peck .3"))
    assert said == others[0] != others[1]
    assert "cutter        X 1.500 Y 1.000, quill down 5.000" in said


def test_drawings_go_where_they_are_told(shell: Shell) -> None:
    done = shell(
        "pdp8 nc inspect circle.eia --talyrond a.svg --talysurf b.svg --stretch 1,2; head -c4 a.svg b.svg"
    )
    assert done.stderr.decode() == "wrote a.svg\nwrote b.svg\n"
    assert done.stdout.decode().count("<svg") == 2
    done = shell("pdp8 nc inspect circle.eia --talyrond -")
    assert done.stdout.startswith(b"<svg")
    assert done.stdout.rstrip().endswith(b"</svg>")
    assert b"worst trough to peak" in done.stderr


def test_what_is_out_of_tolerance_is_said_and_ends_with_1(shell: Shell) -> None:
    """A circle without its last block, as 1971 had it, and one that is closed and stops at its limits."""
    assert shell("pdp8 nc inspect circle.eia").returncode == 0  # nothing was asked
    done = shell("pdp8 nc inspect circle.eia --tolerance 0.0001")
    verdict = b"out of tolerance: -.0114 at most, outer wall, -X apex; .0001 is allowed\n"
    assert (done.returncode, done.stderr, done.stdout.endswith(verdict)) == (1, b"", True)
    made = "pdp8 part circle --close --stop inside | pdp8 run eia.pal --quiet | pdp8 nc inspect"
    assert product(shell, made).splitlines()[-1].startswith("within tolerance: +.0050 at most, ")
    assert shell(f"{made} --tolerance 0.0049").returncode == 1


def test_lengths_are_inches_at_the_commands(shell: Shell) -> None:
    path, around = cut(CIRCLE), Ellipse(4000, 4000, 1750, 1750)
    near = plot(path, around, block=100, cutter=250, tolerance=10, zoom=(8, 8), close_at=(4000, 5735))
    options = "--block 100 --cutter .25in --tolerance .01in --zoom 8 --at 4,5.735"
    assert product(shell, f"pdp8 nc plot circle.eia {options}") == near
    options += " --circle 4,4,1.75"
    assert product(shell, f"pdp8 nc plot circle.eia {options}") == near
    trace = talysurf(inspect(path, around, 250, 10), (1000, 2000))
    options = "--circle 4,4,1.75 --cutter .25 --tolerance .01 --talysurf - --stretch 1,2"
    assert shell(f"pdp8 nc inspect circle.eia {options}").stdout.decode() == trace
    assert product(shell, "pdp8 nc export circle.eia --dxf").count("LWPOLYLINE") > 1
    holes = tape(*FOUR_HOLES)
    assert product(shell, "pdp8 nc export --dxf --cutter .25", holes) == dxf(cut(holes), cutter=250)


def test_a_day_with_other_times(shell: Shell) -> None:
    """666 blocks at half a second are 5.55 minutes; one tool change of a minute; all three times over."""
    said = product(shell, "pdp8 nc cut circle.eia --read-seconds 0.5 --tool-change 60 --passes 3")
    assert "reading           5.5 min   666 blocks at 0.5 s" in said
    assert "tool changes      1.0 min   1 at 60 s" in said
    assert "3 passes         63.2 min   21.1 each" in said


def test_the_polynomial_against_its_band(shell: Shell) -> None:
    """Chapter 7: y = 0.2 x (x - 2) (x - 6), +-.01, cut along its centre line."""
    printed = product(shell, "pdp8 part polynomial --parity none --fill 0")
    frames = tape(*printed.replace(" ", "0").split())
    curve = "--function '0.2*x*(x-2)*(x-6)' --range 0,6 --origin 4,6"
    line = f"pdp8 nc inspect {curve} --tolerance 0.011 --cutter 0.125"
    said = product(shell, line, frames)
    assert "curve y = 0.2*x*(x-2)*(x-6), x from 0 to 6, origin X 4.000 Y 6.000" in said
    assert float(said.split("worst trough to peak ")[1].split()[0]) < 0.0215


@pytest.mark.parametrize("command", ["list", "plot"])
def test_bad_tapes(shell: Shell, command: str) -> None:
    line = f"pdp8 nc {command}"
    assert complaint(shell, line) == f"{line}: standard input: no row is punched: the tape is empty or blank"
    assert complaint(shell, f"{line} no.eia").startswith(f"{line}: no.eia: no such file")
    end = "block 666, row 13: the tape ends after 13 rows of the block's 20"
    assert complaint(shell, line, CIRCLE[:-7]) == f"{line}: standard input: frame 13313: {end}"
    row_1 = "block 1, row 1: the block ends in row 1; a block has 20 rows; the tape seems to be"
    cure = "; `pdp8 run eia.pal` translates it"
    for name, frame, kind, more in (("circle.asc", 0, "ASCII", cure), ("eia.bin", 1, "BIN", "")):
        said = complaint(shell, f"{line} {name}")
        assert said == f"{line}: {name}: frame {frame}: {row_1} {kind}, and the machine reads EIA{more}"
    row_19 = "block 25, row 19: the block ends in row 19; a block has 20 rows"
    shifted = complaint(shell, line, CIRCLE[:495] + CIRCLE[496:])
    assert shifted == f"{line}: standard input: frame 499: {row_19}"


def test_what_was_cut_before_a_bad_block_is_told(shell: Shell) -> None:
    bad = tape(*CIRCLE_BLOCKS[:40], "041 2 00000 00000 0 00 80", *CIRCLE_BLOCKS[41:])
    for command, first, lines in (("list", b"block seq ", 41), ("cut", b"blocks        40\n", 14)):
        done = shell(f"pdp8 nc {command}", bad)
        assert (done.returncode, len(done.stdout.splitlines())) == (1, lines)
        assert done.stdout.startswith(first)
        assert b"block 41, row 4: unknown preparatory function 2" in done.stderr
    for command in ("plot -o out", "export --gcode -o out", "inspect --talyrond out"):
        assert shell(f"pdp8 nc {command}; test ! -e out", bad).returncode == 0


def test_strict_reads_parity(shell: Shell) -> None:
    changed = bytearray(CIRCLE)
    changed[700] ^= 0o020
    assert product(shell, "pdp8 nc list", bytes(changed)) == product(shell, "pdp8 nc list circle.eia")
    assert "block 35, row 20: wrong parity" in complaint(shell, "pdp8 nc list --strict", bytes(changed))


MISUSE = {
    "cut": {
        "--feed-error 5,-21,0": "-21 %: -20 to 20 is allowed",
        "--feed-error nan": "nan %: -20 to 20 is allowed",
        "--feed-error 1,2": "'1,2' is not X,Y,Z: 3 numbers separated by commas",
        "--feed-error fast": "'fast' is not X,Y,Z: 3 numbers separated by commas",
        "--feed-code 0": "0 is not in the range 1<=x<=18.",
        "--feed-code 19": "19 is not in the range 1<=x<=18.",
        "--tool-change -0.1": "-0.1 is not from 0 to 3600",
        "--tool-change 3601": "3601 is not from 0 to 3600",
        "--read-seconds -0.1": "-0.1 is not from 0 to 3600",
        "--read-seconds 3601": "3601 is not from 0 to 3600",
        "--passes 0": "0 is not in the range x>=1.",
        "--peck 0": "0 is not from 0.001 to 5",
        "--peck 5.1": "5.1 is not from 0.001 to 5",
        "ellipse.eia": "Got unexpected extra argument (ellipse.eia)",
    },
    "plot": {
        "--cutter 0": "0 is not above 0 to 10",
        "--cutter 10.1": "10.1 is not above 0 to 10",
        "--cutter nan": "nan is not above 0 to 10",
        "--tolerance 1mm": "'1mm' is not a length in inches, such as .005 or .005in",
        "--tolerance 0": "0 is not above 0 to 1",
        "--tolerance 1.1": "1.1 is not above 0 to 1",
        "--zoom 0.9": "0.9 is not from 1 to 1000",
        "--zoom 1001": "1001 is not from 1 to 1000",
        "--block 0": "0 is not in the range x>=1.",
        "--at 4": "'4' is not X,Y: 2 numbers separated by commas",
    },
    "inspect": {
        "--circle 4,4": "'4,4' is not X,Y,RADIUS: 3 numbers separated by commas",
        "--ellipse 4,4,1": "'4,4,1' is not X,Y,A,B: 4 numbers separated by commas",
        "--line 4,4": "'4,4' is not X1,Y1,X2,Y2: 4 numbers separated by commas",
        "--origin 4": "'4' is not X,Y: 2 numbers separated by commas",
        "--range 0 --function x": "'0' is not FROM,TO: 2 numbers separated by commas",
        "--stretch inf,2": "'inf,2' is not FROM,TO: 2 numbers separated by commas",
        "--stretch 1,2": "--stretch needs --talysurf",
        "--circle 4,4,1 --line 1,1,2,2": "give one of --circle, --ellipse, --line and --function",
        "--function x": "--function and --range go together",
        "--range 0,1": "--function and --range go together",
    },
    "export": {
        "": "give one of --gcode and --dxf",
        "--gcode --dxf": "give one of --gcode and --dxf",
    },
}


@pytest.mark.parametrize("command", MISUSE)
def test_misuse(command: str) -> None:
    for given, says in MISUSE[command].items():
        with case(command, given):
            done = CliRunner().invoke(nc, [command, "circle.eia", *given.split()])
            said = done.output.splitlines()[-1]
            assert done.exit_code == 2
            assert said.startswith("Error: ")
            assert said.endswith(f": {says}")
            assert given.partition(" ")[0] in said


def test_misuse_from_the_shell(shell: Shell) -> None:
    assert (
        complaint(shell, "pdp8 nc export circle.eia", status=2)
        == "pdp8 nc export: give one of --gcode and --dxf"
    )
    assert (
        complaint(shell, "pdp8 nc inspect circle.eia --talyrond e.PNG", status=2)
        == "pdp8 nc inspect: e.PNG: a picture is written as SVG alone; name it .svg"
    )


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("plot circle.eia --block 667", "block 667: the tape has blocks 1 to 666"),
        ("inspect circle.eia --circle 15,5,1", "the cutter did not reach the curve"),
        ("inspect circle.eia --circle 4,4,0", "greater than 0"),
        ("inspect circle.eia --function x --range 0,0", "from 0 to 0: must go from less to more"),
        ("inspect circle.eia --function y --range 0,1", "column 1: 'y'"),
        ("inspect circle.eia --line 1,1,1,1", "two different ends"),
        (
            "inspect circle.eia --talysurf a.svg --stretch 50,60",
            "stretch from 50.000 to 60.000: the curve runs from 0 to",
        ),
        ("plot .", "."),
        ("plot circle.eia -o nowhere/a.svg", "nowhere/a.svg: No such file or directory"),
        ("list circle.eia > /dev/full", "No space left on device"),
    ],
)
def test_failed_jobs(shell: Shell, line: str, says: str) -> None:
    assert says in complaint(shell, f"pdp8 nc {line}")


@pytest.mark.parametrize(
    ("command", "defaults"),
    [
        ("", []),
        ("list", []),
        ("cut", ["0.1", "0.0", "2.0", "1; x>=1"]),
        ("plot", ["4,5", "0.5", "0.005", "10.0", "standard output"]),
        ("inspect", ["4,5", "0.5", "0.005"]),
        ("export", ["4,5", "0.5", "0.005", "standard output"]),
    ],
)
def test_every_command_has_help_with_examples(shell: Shell, command: str, defaults: list[str]) -> None:
    said = product(shell, f"pdp8 nc {command} --help")
    assert re.findall(r"\[default:\s+([^]]*)\]", said) == defaults
    assert "Examples:\n" in said
    assert "pdp8 nc" in said
