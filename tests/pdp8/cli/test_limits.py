"""Both sides of every limit of a command's options: the nearest values that are taken and refused.

A line: the command and the option, what is taken, what is refused.
"""

import click
import pytest

from pdp8.cli.nc_options import Within
from pdp8.cli.root import pdp8
from release.reference import commands

LIMITS = """\
run --start, panel --start | 0 77777 | 8 -1 100000
run --sr, panel --sr | 0 7777 | 8 -1 10000
run --max-time | 0 1e9 | -0.1 1.1e9 nan soon
check --cpu | 0.1 3600 | 0.09 3600.1 nan
check --seed | 0 -1 | 1.5 x
tape clean --mend, tape convert --mend, tape cut --mend | 0=0 0=377 7=1,8=2 | 0=400 -1=0 0=-1 0=8 0 =1
tape cut --mend | 0=377,12=0, | x 1=2=3
tape convert --fill, tape punch --fill | 0 1000 | -1 1001
tape punch --leader | 0 100000 | -1 100001
tape cut --from, tape cut --to, tape show --from, tape show --to | 0 | -1
tape cut --without | 0 0,2-2,5-6 | -1 x
tape read --strips | 1 2,1 | 0 x
nc cut --feed-code, nc export --feed-code, nc inspect --feed-code, nc plot --feed-code | 1 18 | 0 19
nc cut --tool-change, nc cut --read-seconds | 0 3600 | -0.1 3600.1 nan
nc cut --peck, nc export --peck | 0.001 5 | 0 0.0009 5.001 nan
nc export --safe | 0.001 5 | 0 0.0009 5.001
nc export --tap | 0.001 1 | 0 0.0009 1.001
nc cut --passes, nc plot --block | 1 | 0
nc export --cutter, nc inspect --cutter, nc plot --cutter | 0.001 10 | -0.001 10.001 nan
nc inspect --tolerance, nc plot --tolerance | 0.001 1 | -0.001 1.001
nc plot --zoom | 1 1000 | 0.9 1000.1 nan
thesis numbers --chapter | 1 10 | 0 11
vectors --states | 4 1000 | 3 1001
"""
FOUND = {
    each.command_path.partition(" ")[2]: each for each in commands(click.Context(pdp8, info_name="pdp8"))
}
ROWS = [
    (*name.rsplit(" ", 1), taken.split(), refused.split())
    for names, taken, refused in (row.split(" | ") for row in LIMITS.splitlines())
    for name in names.split(", ")
]


def option(command: str, word: str) -> click.Parameter:
    return next(each for each in FOUND[command].command.params if word in each.opts)


@pytest.mark.parametrize(("command", "word", "taken", "refused"), ROWS)
def test_the_nearest_values_are_taken_and_refused(
    command: str, word: str, taken: list[str], refused: list[str]
) -> None:
    for value in taken:
        option(command, word).process_value(FOUND[command], value)
    for value in refused:
        with pytest.raises(click.UsageError):
            option(command, word).process_value(FOUND[command], value)


def test_every_option_that_is_a_number_has_its_limits_here() -> None:
    """Those of a part are in tests/programs/test_part_command.py."""
    numbers = (
        f"{name} {param.opts[0]}"
        for name, context in FOUND.items()
        for param in context.command.params
        if isinstance(param.type, click.types.IntRange | Within) and not name.startswith("part ")
    )
    assert {*numbers} <= {f"{command} {word}" for command, word, *_ in ROWS}
