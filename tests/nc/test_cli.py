"""`pdp8 nc` as a user meets it: its products, its manners, and every bad input in one line."""

import re
from pathlib import Path

import pytest
from click.testing import CliRunner

from nc.curves import Ellipse, Graph
from nc.dxf import dxf
from nc.gcode import Output, gcode
from nc.gcode_1971 import gcode_1971
from nc.inspection import inspect
from nc.machine import cut
from nc.plot import plot
from nc.talysurf import talysurf
from pdp8.cli.nc import nc
from tapes.paper import sized
from tests.conftest import Call, Shell
from tests.nc.tapes_1971 import CIRCLE, FOUR_HOLES, HEADER, tape


def product(shell: Shell, line: str, stdin: bytes = b"") -> str:
    done = shell(line, stdin)
    assert (done.returncode, done.stderr) == (0, b"")
    return done.stdout.decode()


def test_a_day_with_other_feeds_and_times(shell: Shell) -> None:
    """Chapters 7 and 10: the ellipse takes 50 minutes, of which about 33 are reading."""
    for options, *lines in (
        (
            "ellipse.eia --feed-code 1 --feed-error 20",
            "49.7 min   970 milling blocks: reading 32.3, cutting 17.4, efficiency 35%",
        ),
        ("ellipse.eia --feed-code 1 --feed-error -20,-20,0", "milling          26.1 min"),
        (
            "circle.eia --read-seconds 0.5 --tool-change 60 --passes 2",
            "reading           5.5 min   666 blocks at 0.5 s",
            "tool changes      1.0 min   1 at 60 s",
            "2 passes         42.1 min   21.1 each",
        ),
    ):
        said = product(shell, f"pdp8 nc cut {options}")
        assert [line for line in lines if line not in said] == []
        assert ("each" in said) == ("--passes" in options)


def test_the_four_holes_typed_in_and_punched(shell: Shell) -> None:
    """Chapter 3: typed with spaces for clarity only, punched in EIA, drilled."""
    typed = ("\n".join(FOUR_HOLES) + "\n").encode()
    spaced = product(shell, "pdp8 tape punch --code eia --drop-spaces - | pdp8 nc list", typed)
    unbroken = product(shell, "tr -d ' ' | pdp8 tape punch --code eia - | pdp8 nc list", typed)
    assert spaced == unbroken
    assert "drill at X 4.000 Y 1.000, from 3.000 to 3.500 at 1.0 in/min" in spaced


def test_a_peck_is_a_tenth_of_an_inch_if_nothing_is_said(shell: Shell) -> None:
    deep = "006 9 00000 05000 0 18 89"
    frames = tape(*HEADER[:5], deep, "007 4 01000 01000 0 00 80", "008 6 01500 01000 0 01 84")
    said, *others = (product(shell, f"pdp8 nc cut {peck}", frames) for peck in ("", "--peck .1", "--peck .3"))
    assert said == others[0] != others[1]
    assert "cutter        X 1.500 Y 1.000, quill down 5.000" in said
    pecks = [product(shell, f"pdp8 nc export --gcode --peck {each}", frames).count("G1 Z") for each in (5, 1)]
    assert pecks == [2, 6]


OF_EXPORT = "--peck .1|--safe .3|--tap .05|--tool-change|--as-1971|--depth|--circle 4,4,1.75|--line 1,1,2,2"
OF_EXPORT += (
    "|--ellipse 4,4,2,1|--function x --range 0,1|--profile 1+0*x|--shift 1,1|--cutter .25|--feed-code 2"
)


@pytest.mark.parametrize("option", OF_EXPORT.split("|"))
def test_an_option_is_for_the_same_format_by_its_name_and_by_an_option(option: str, call: Call) -> None:
    """Nothing is taken and has no effect: what --dxf refuses is refused for a file.dxf."""
    for asked, ending in (("--dxf", "dxf"), ("--gcode", "ngc")):
        Path("holes.eia").write_bytes(tape(*FOUR_HOLES))
        named, given = (
            call(f"pdp8 nc export holes.eia {option} {how} -o out.{ending}")[0] for how in ("", asked)
        )
        assert (named == 2) == (given == 2), (asked, named, given)


def test_what_is_out_of_tolerance_is_said_and_ends_with_1(shell: Shell) -> None:
    """A circle without its last block, as 1971 had it, and one that is closed and stops at its limits."""
    done = shell("pdp8 nc inspect circle.eia --tolerance 0.0001")
    verdict = b"out of tolerance: -.0114 off nominal at most, outer wall, -X apex; .0001 is allowed\n"
    assert (done.returncode, done.stderr, done.stdout.endswith(verdict)) == (1, b"", True)
    made = "pdp8 part circle --stop inside | pdp8 run eia.pal --quiet | pdp8 nc inspect --circle 4,4,1.75"
    assert product(shell, made).splitlines()[-1].startswith("within tolerance: +.0050 off nominal at most, ")
    assert shell(f"{made} --tolerance 0.0049").returncode == 1


def test_lengths_are_inches_at_the_commands(shell: Shell) -> None:
    path, around = cut(CIRCLE), Ellipse(4000, 4000, 1750, 1750)
    options = "--block 100 --cutter .25in --tolerance .01in --zoom 8 --at 4,5.735"
    for named, curve in (
        ("", around),
        ("--circle 4,4,1.75", around),
        ("--function x*x --range 0,1", Graph(4000, 5000, "x*x", 0, 1)),
        ("--function x*x --range 0,1 --origin 3,6", Graph(3000, 6000, "x*x", 0, 1)),
    ):
        near = plot(path, curve, block=100, cutter=250, tolerance=10, zoom=(8, 8), close_at=(4000, 5735))
        assert product(shell, f"pdp8 nc plot circle.eia {options} {named}") == sized(near)
    trace = talysurf(inspect(path, around, 250, 10), (1000, 2000))
    options = "--circle 4,4,1.75 --cutter .25 --tolerance .01 --talysurf - --stretch 1,2"
    assert shell(f"pdp8 nc inspect circle.eia {options}").stdout.decode() == trace
    holes = tape(*FOUR_HOLES)
    assert product(shell, "pdp8 nc export --dxf --cutter .25", holes) == dxf(cut(holes), cutter=250)
    for options, lines in (
        ("", gcode(cut(holes))),
        (
            "--safe .5in --shift=-1,.5 --tool-change --cutter .25",
            gcode(cut(holes), Output(250, 500, (-1000, 500), tool_change=True)),
        ),
        ("--as-1971", gcode_1971(cut(holes))),
    ):
        assert product(shell, f"pdp8 nc export --gcode {options}", holes).splitlines() == [*lines]


_ORIGIN = "4,5 in; the centre of a profile: 4,4 in"
_KNOWN = ("that of the nominal curve, or 0.5", "that of the nominal curve, or 0.005")


def test_every_command_has_help_with_examples() -> None:
    for command, defaults in (
        ("", []),
        ("list", []),
        ("cut", ["0.0", "2.0", "0.1", "1; x>=1"]),
        ("plot", [_ORIGIN, *_KNOWN, "10.0", "standard output"]),
        ("inspect", [_ORIGIN, *_KNOWN]),
        ("export", [_ORIGIN, _KNOWN[0], "0.1", "0.25", "standard output"]),
    ):
        said = CliRunner().invoke(nc, [*command.split(), "--help"], max_content_width=100).output
        found = re.findall(r"\[default:\s+([^]]*)\]", said)
        assert [" ".join(each.split()) for each in found] == defaults
        assert "Examples:\n" in said


@pytest.mark.slow("measures five parts")
def test_a_part_is_judged_by_the_curve_that_was_written_beside_its_tape(shell: Shell) -> None:
    """A cam is within its own tolerance."""
    made = "pdp8 part profile '1.5+0.25*cos(x)' --cutter 0.25 --stop inside --tolerance 0.003"
    chain = f"{made} -o cam.asc && pdp8 run eia.pal --reader cam.asc --punch cam.eia --quiet"
    done = shell(f"{chain} && pdp8 nc inspect cam.eia --tolerance 0.003 | tail -1")
    assert b"within tolerance: " in done.stdout
