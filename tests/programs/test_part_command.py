"""`pdp8 part`: its options, its help, its limits; what cannot be is refused in one clear sentence."""

import re
import shlex
from collections.abc import Callable
from contextlib import nullcontext
from math import nan
from typing import Any

import pytest

from pdp8 import shelf
from programs import fluidic, least_squares, parts, stretches
from programs.function import Range, offset_path
from programs.header import Header
from programs.milling import Milling
from programs.mirror import mirrored
from programs.piecewise import Technique
from programs.points import read
from programs.printout import check_band, check_codes, check_on_table, check_start
from programs.stretches import Point, arc, graph
from programs.units import FRACTION, INCHES, NUMBER, THOUSANDTHS, UnitError
from tapes import ascii, eia
from tapes.errors import WorkError
from tests.conftest import Call, Shell, case

REFUSED = [
    ("circle --tolerance 0.0005", "radius 1.75 in between 1.7495 in and 1.7505 in"),
    ("circle --radius 5", "block 005: X -1.000 leaves the table: 0 to 20 in"),
    ("circle --centre-x 19", "block 226: X 20.002 leaves the table"),
    ("circle --start-x 9", "start X 9 in, Y 0 in from the centre: must be in the first quadrant"),
    ("circle --outer 90", "the table is 20 in"),
    ("polynomial --a 999999", "at x = -0.75 the curve is off the table"),
    ("polynomial --a 999999 --cutter 0.1", "at x = -0.75 the curve is off the table"),
    ("slope --to-y 1.0005", "slope: Y 1.0005 in: must be a whole number of thousandths"),
    ("ellipse --minor 0.5 --tolerance 0.5", "semi-minor axis 0.5 in has an inner limit of 0 in"),
    ("ellipse --major 0", "semi-major axis 0 in: must be greater than 0"),
    ("polynomial --from 6 --to 0", "must go from less to more"),
    ("curve 1 --from 0 --to 99", "block 007: X 24.000 leaves the table"),
    ("curve 1 --from -99 --to 0", "block 005: X -16.000 leaves the table"),
    ("curve 1 --from -99 --to 99", "block 005: X -0.001 leaves the table"),
    ("curve 1 --from -4 --to 99", "block 007: X 20.001 leaves the table"),
    ("curve 1 --from 30 --to 40", "block 005: X 34.000 leaves the table"),
    ("polynomial --cutter 4", "too big: at x ="),
    ("polynomial --cutter -1", "cutter of diameter -1 in: must be greater than 0"),
    ("slope --to-x 4 --to-y 4", "two different ends"),
    ("slope --to-x 4.003 --to-y 4.004 --tolerance 0.6", "0.6 in: must be smaller than the curve, 0.005 in"),
    ("slope --tolerance 0.0009", "tolerance 0.0009 in: must be .001 in, the machine's resolution, or more"),
    (
        "curve 9.99*x --tolerance .005",
        "a tolerance of 0.005 in: at X 4.000 of the table it moves 0.00999 in along Y",
    ),
    ("curve x --technique piece --feed-error -5", "feed error -5%: must be from 0 to less than 100 %"),
    ("drill --z-depth 2", "final Z depth 2 in is above the Z feed point, 3 in"),
    ("drill --holes 21,1", "block 003: X 21.000 leaves the table"),
]

MISUSED = [
    ("circle --radius x", "--radius"),
    ("circle --radius 1.7505", "1.7505 is not a whole number of thousandths of an inch"),
    ("circle --tolerance 5", "for 5 thousandths write 0.005"),
    ("circle --outer 1e999999999", "1e999999999 in: must be less than 100 in."),
    ("circle --tool 7.5", "7.5 is not a whole number."),
    ("circle --tool 1e999999999", "must be less than 1,000,000"),
    ("slope --feed-error 0.2", "0.2 %: must be 0, or at least 1 %; for 0.2 as a fraction write 20"),
    ("slope --feed-error 0.01", "for 0.01 as a fraction write 1"),
    ("circle --radius 1_0", "'1_0' is not a number"),
    ("circle --radius ?nan", "'?nan' is not a number"),
    ("circle --radius -Infinity", "'-Infinity' is not a finite number"),
    ("polynomial --tolerance 1", "1 in: must be less than 1 in"),
    ("drill --holes 1000,1000", "for 1000 thousandths write 1"),
    ("drill --holes nan,1", "not a finite number"),
    ("curve x --cutter inf", "not a finite number"),
    ("circle --arithmetic pdp8", "--arithmetic"),
    ("curve", "EXPRESSION"),
    ("profile", "EXPRESSION"),
    ("drill --holes 1", "not a list of places"),
    ("circle --park-x 18", "No such option"),
    ("curve x --side below", "--side means nothing without --cutter"),
    ("heptagon", "heptagon"),
    ("compare slope", "slope"),
]


@pytest.mark.parametrize(
    ("status", "part", "said"), [*((1, *row) for row in REFUSED), *((2, *row) for row in MISUSED)]
)
def test_a_part_that_cannot_be_is_refused(call: Call, status: int, part: str, said: str) -> None:
    exit_status, output, message = call(f"pdp8 part {part}")
    assert (exit_status, output) == (status, "")
    assert said in message
    assert status == 2 or message.count("\n") == 1, "one sentence"


@pytest.mark.parametrize(
    ("name", "constants", "said"),
    [
        ("circle", {"preparatory": 3}, "preparatory function 3"),
        ("circle", {"x_feed": 99}, "miscellaneous function 99"),
        ("circle", {"park_x": 20.002}, "park X 20.002 in is outside the travel: 0 to 20 in"),
        ("ellipse", {"sequence": 1000}, "sequence number 1000: must be 0 to 999"),
        ("circle", {"overflow": "dots"}, "overflow: 'dots' is not one of low-digits, stars"),
    ],
)
def test_a_constant_that_no_command_offers_is_a_keyword(
    name: str, constants: dict[str, Any], said: str
) -> None:
    with pytest.raises(WorkError, match=re.escape(said)):
        parts.part(name, **constants)


LIMITS: list[tuple[Callable[..., object], tuple[Any, ...], tuple[Any, ...]]] = [
    (lambda size: check_band("radius", size, 0.5, 2.5), (1,), (0, nan)),
    (lambda inner: check_band("radius", 1, inner, 2.5), (0.5,), (0, 0.6, nan)),
    (lambda outer: check_band("radius", 1, 0.5, outer), (2.5, 20_000), (2.4, 20_001, nan)),
    (lambda x, y: check_start(x, y, 7, 5), ((0, 0), (7, 5)), ((-1, 0), (0, -1), (8, 0), (0, 6))),
    (lambda number: check_codes(number, 6), (0, 999), (-1, 1000)),
    (lambda place: check_on_table("1", "X", place), (0, 20_000), (-1, 20_001)),
    (lambda place: check_on_table("1", "Y", place), (0, 10_000), (-1, 10_001)),
    (Header, ((0, 0), (20_000, 10_000)), ((-1, 0), (0, -1), (20_001, 0), (0, 10_001))),
    (lambda a, b: Header(z_feed_point=a, z_depth=b), ((0, 0), (5000, 5000)), ((-1, 0), (1, 0), (0, 5001))),
    (lambda tool: Header(tool=tool), (1, 24), (0, 25)),
    (lambda coolant: Header(coolant=coolant), (7, 8, 9), (6, 10)),
    (lambda code: Header(spindle=code), (1, 18, 21, 38), (0, 19, 20, 39)),
    (lambda code: Header(z_feed=code), (1, 18), (0, 19)),
    (lambda code: Milling(feed_code=code), (1, 18), (0, 19)),
    (lambda code: Milling(fastest=code), (1, 18), (0, 19)),
    (lambda error: Technique(5, error), (0, 0.99), (-0.1, 1.0, nan)),
    (INCHES.keep, ("99.999", "-99.999"), ("100", "-100")),
    (FRACTION.keep, ("0", "1", "99.9"), ("0.99", "100")),
    (NUMBER.keep, ("999999",), ("1000000",)),
    (lambda tolerance: stretches.line(Point(0, 0), Point(3, 4), tolerance), (1, 4.9), (0.9, 5, nan)),
    (lambda radius: arc(Point(0, 0), radius, 0, 90, 1), (1.1,), (0, 1)),
    (lambda step: graph(0, [0, step, 2 * step], [4, step + 4, 2 * step + 4]), (3, -3), (3.1, -3.1)),
    (lambda places: graph(0, [0] * places, [4] * places), (4,), (3,)),
    (lambda last: Range(0, last, 0, 0), (0.001,), (0, -0.001)),
    (lambda to: offset_path(lambda _: 0, Range(0, to, 0, 0), 0.001, 0.1, "above"), (0.002,), (0.001,)),
    (lambda wide: offset_path(lambda _: 0, Range(0, 1, 0, 0), 0.001, wide, "above"), (10,), (0, 10.1)),
    (fluidic.channel, (0, 2.5), (-0.001, 2.501)),
    (lambda degree: least_squares.fit([(0, 0), (1, 1), (2, 1), (2, 2)], degree), (0, 2), (-1, 3)),
    (lambda degree: least_squares.fit([(x, x) for x in range(15)], degree), (12,), (13,)),
]
"""What takes a value, or two, which it takes, and which it refuses."""


def test_what_is_at_a_limit_is_taken_and_what_is_beyond_is_refused() -> None:
    for number, (taking, taken, refused) in enumerate(LIMITS):
        for value in (*taken, *refused):
            expected = pytest.raises((WorkError, UnitError)) if value in refused else nullcontext()
            with case(number, value), expected:
                taking(*value) if isinstance(value, tuple) else taking(value)


def test_no_digit_of_a_length_is_lost() -> None:
    for thousandths in range(1, 20_001, 7):
        text = f"{thousandths // 1000}.{thousandths % 1000:03}"
        assert THOUSANDTHS.keep(text) == thousandths
        assert THOUSANDTHS.keep(THOUSANDTHS.ask(thousandths)) == thousandths
    assert THOUSANDTHS.keep("0.123456789012345") == 123.456789012345


def test_help_says_units_defaults_and_the_language(call: Call) -> None:
    shown = call("pdp8 part circle --help")[1] + call("pdp8 part polynomial --help")[1]
    for option in ("radius INCHES", "feed-error PERCENT", "spindle CODE", "a PER-SQ-INCH"):
        assert f"--{option} " in shown
    for part, said in (
        ("circle", "1.75 0.005 4 4 0 outside step 1"),
        ("drill", "1,1 1,2 4,2 4,1 35 3 3.5 1 standard output"),
        ("compare", "exact ge635"),
    ):
        shown = " ".join(call(f"pdp8 part {part} --help")[1].split())
        assert " ".join(re.findall(r"\[default: ([^];]*)", shown)).startswith(said)
    language = "EXPRESSION is y as a function of x, inches: numbers, x, pi, e, + - * / ** ( ) and sqrt, exp,"
    assert language in " ".join(call("pdp8 part curve --help")[1].split())


def test_compare_shows_the_nine_blocks_side_by_side(shell: Shell) -> None:
    lines = shell("pdp8 part compare ellipse").stdout.decode().splitlines()
    assert lines[0].split() == ["block", "exact", "ge635"]
    assert lines[1] == "  587  5876 6404 2647  585  5876 6404 2646  585"
    assert len(lines) == 11
    assert lines[-1] == "ellipse: 976 blocks exact, 976 ge635, 9 differ"


def test_a_name_with_a_point_is_a_file_and_a_word_is_not(call: Call) -> None:
    for command in ("part profile", "nc inspect circle.eia --profile"):
        for given, is_file in (("none.csv", True), ("none", False), ("2.5*none", False), ("sin(x", False)):
            said = call(f"pdp8 {command} '{given}'")[2]
            assert ("no such file" in said) == is_file, given


def test_points_become_a_function_and_a_part_has_another_hand(shell: Shell) -> None:
    points = "0 1\n1 2.5\n2 1\n3 4\n4 7\n5 0\n"
    for degree, option, code in ((3, "", "utf-8"), (0, " --degree 0", "utf-16")):
        done = shell(f"pdp8 part fit -{option}", points.encode(code))
        found = least_squares.fit(read(points), degree)
        assert done.stdout.decode() == f"{found.expression}\n"
        assert done.stderr.decode() == f"at most {found.worst:.4f} in from a point\n"
    falling = least_squares.fit([(0, 0), (1, -1)], 1).expression
    assert shell(f"pdp8 part curve {falling} --to 1").returncode == 0, "its minus begins no option"
    slope = parts.part("slope")
    for option, other in (
        ("", mirrored(slope, "x")),
        (" --across y --about 5.0005", mirrored(slope, "y", 5000.5)),
    ):
        done = shell(f"pdp8 part slope | pdp8 part mirror{option}")
        assert done.stdout == ascii.encode(other)


@pytest.mark.parametrize(
    ("typed", "constants"),
    [
        ("circle --radius 1 --tolerance .003", {"radius": 1, "tolerance": ".003"}),
        ("circle --radius 1.5in --close", {"radius": "1.5in", "close": True}),
        ("ellipse --arithmetic ge635", {"arithmetic": "ge635", "outer_major": None}),
        ("slope --technique piece --feed-error 10%", {"technique": "piece", "feed_error": 10}),
        ("slope --z-depth 4.001", {"z_depth": 4.001}),
        ("drill --holes '1,1 2.5,1.125'", {"holes": ((1, 1), (2.5, 1.125))}),
        ("curve 'sin(x)' --from 1 --to 2", {"from_": 1, "to": "2"}),
        ("profile '1+0.1*cos(x)' --cutter .25 --side inside", {"cutter": 0.25, "side": "inside"}),
    ],
)
def test_a_script_gives_constants_as_the_command_takes_them(
    typed: str, constants: dict[str, object], call: Call
) -> None:
    name, *more = shlex.split(typed)
    printed = ascii.decode(call(f"pdp8 part {typed}")[1].encode("utf-8", "surrogateescape"))
    formula = more[: name in ("curve", "profile")]
    assert printed == parts.part(name, *formula, **constants)
    assert printed == parts.part(name, **constants, **dict(zip(("expression",), formula, strict=False)))


def test_a_script_is_told_what_the_command_says() -> None:
    refused: list[tuple[str, dict[str, Any], str]] = [
        ("circle", {"radius": 1750}, "radius: 1750 in: must be less than 100 in; for 1750 thousandths write"),
        ("circle", {"radus": 1}, "no constant 'radus'; there are radius, tolerance"),
        ("circle", {"technique": "leap"}, "technique: 'leap' is not one of"),
        ("circle", {"radius": True}, "radius: True is not a number"),
        ("circle", {"close": 1}, "close: 1 is not True or False"),
        ("heptagon", {}, f"no such part program; there are {', '.join(parts.PARTS)}"),
    ]
    for name, constants, message in refused:
        with pytest.raises(WorkError, match=re.escape(f"{name}: {message}")):
            parts.part(name, **constants)


@pytest.mark.parametrize("name", ["slope", "circle", "ellipse", "die"])
def test_fewest_punches_the_proved_tape(call: Call, name: str) -> None:
    """Its own sizes alone: with another it is refused, as without the technique."""
    status, punched, _ = call(f"pdp8 part {name} --technique piece --fewest")
    assert status == 0
    text = ascii.decode(punched.encode("utf-8", "surrogateescape"))
    assert eia.encode(text) == shelf.read_bundled(f"{name}-fewest.eia")
    for wrong in ("--fewest", "--fewest --technique piece --tolerance .01"):
        assert call(f"pdp8 part {name} {wrong}")[0] == 2
