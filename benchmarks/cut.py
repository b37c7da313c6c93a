"""Cut, list and inspect ever longer tapes, and say how long each takes: the time should grow with the blocks.

    .venv/bin/python benchmarks/cut.py [--rounds 5]

The tapes are circles one inside the other in steps of .001 inch, no two blocks alike; medians of so many
rounds, in seconds of this process's own time. The last column is the time of 100,000 blocks over that of
25,000: 4 is linear.
"""

import argparse
import time
from collections.abc import Callable
from math import isqrt
from statistics import median

from rich.console import Console
from rich.table import Table

import nc
from nc.curves import Ellipse
from nc.inspection import inspect
from nc.listing import lines
from tapes import eia

SIZES = (25_000, 50_000, 100_000)
_HEADER = ("006 9 03000 03500 0 01 89", "007 0 02250 04000 0 01 84", "008 0 02250 04000 0 01 85")


def rings(blocks: int) -> bytes:
    """Return a tape of so many blocks."""
    typed = list(_HEADER)
    radius = 1750
    while len(typed) < blocks:
        typed += _quarter(radius)
        radius -= 1
    return eia.encode("\n".join(typed[:blocks]).replace(" ", "") + "\n")


def _quarter(radius: int) -> list[str]:
    """Return a staircase along a quarter of a circle, the X step and then the Y step of each .001 of X."""
    steps = []
    for x in range(radius, -1, -1):
        y = isqrt(radius * radius - x * x)
        steps += [f"009 6 {4000 - x:05} {4000 + y:05} 0 01 84", f"010 6 {4000 - x:05} {4001 + y:05} 0 01 85"]
    return steps


def seconds(work: Callable[[], object], rounds: int) -> float:
    """Return the median of the processor seconds that `work` takes."""
    taken = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        taken.append(time.process_time() - start)
    return median(taken)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--rounds", type=int, default=5)
    rounds = parser.parse_args().rounds
    tapes = [rings(blocks) for blocks in SIZES]
    paths = [nc.cut(tape) for tape in tapes]
    curve = Ellipse(4000, 4000, 1750, 1750)
    jobs: dict[str, Callable[[int], object]] = {
        "cut": lambda size: nc.cut(tapes[size]),
        "list": lambda size: sum(1 for _ in lines(paths[size], modes=True)),
        "inspect": lambda size: inspect(paths[size], curve=curve),
    }
    table = Table("seconds", *(f"{blocks:,} blocks" for blocks in SIZES), "growth")
    for name, job in jobs.items():
        taken = [seconds(lambda job=job, size=size: job(size), rounds) for size in range(len(SIZES))]  # type: ignore[misc]
        table.add_row(name, *(f"{each:.2f}" for each in taken), f"{taken[-1] / taken[0]:.1f}")
    Console().print(table)


if __name__ == "__main__":
    main()
