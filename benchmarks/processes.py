"""The main job as a whole process, beside Python itself and Python with click: seconds and peak memory.

    python -m benchmarks.processes [--repeat 25]

The least of processes started in turn, from start to exit, of the installation this Python has: an editable
one starts slower than a wheel. A click command that only copies its input is the least that a command can
take; the main job with an empty tape is all but the run.
"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

import click
from rich.console import Console
from rich.table import Table

PDP8 = str(Path(sys.executable).with_name("pdp8"))


class Cost(NamedTuple):
    """What a process took: seconds on the clock and of the processor, and KiB of memory at most."""

    wall: float
    processor: float
    memory: int


def run(command: list[str], tape: str) -> Cost:
    """Run `command` with the tape as its standard input.

    A bare Python starts it and looks at what it used: a process that is started begins with the memory of the
    one that starts it, and this one has much.
    """
    with open(tape, "rb") as frames:
        told = subprocess.run(
            [sys.executable, "-I", "-S", "-c", _STARTER, *command],
            stdin=frames,
            capture_output=True,
            check=True,
        )
    wall, processor, memory = told.stdout.split()
    return Cost(float(wall), float(processor), int(memory))


_STARTER = """
import os, sys, time
nothing = os.open(os.devnull, os.O_WRONLY)
began = time.perf_counter()
files = [(os.POSIX_SPAWN_DUP2, nothing, 1), (os.POSIX_SPAWN_DUP2, nothing, 2)]
child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions=files)
_, status, used = os.wait4(child, 0)
print(time.perf_counter() - began, used.ru_utime + used.ru_stime, used.ru_maxrss)
sys.exit(status != 0)
"""


COPIES = """
import click, sys
@click.command()
@click.argument("program")
def copy(program): sys.stdout.buffer.write(sys.stdin.buffer.read())
copy(["eia.pal"])
"""
"""The smallest command of its kind."""


def table(costs: dict[str, list[Cost]]) -> Table:
    """Return the least of each, also as a multiple of `import click`, and that multiple's range."""
    shown = Table(title=f"whole processes, Python {sys.version.split()[0]}, least of each")
    for column in ("process", "wall ms", "processor ms", "× import click", "to", "peak MiB"):
        shown.add_column(column, justify="left" if column == "process" else "right")
    base = [cost.processor for cost in costs["import click"]]
    for name, samples in costs.items():
        used = [cost.processor for cost in samples]
        ratios = sorted(ours / theirs for ours, theirs in zip(used, base, strict=True))
        shown.add_row(
            name,
            f"{min(cost.wall for cost in samples) * 1e3:.1f}",
            f"{min(used) * 1e3:.1f}",
            f"{min(used) / min(base):.2f}",
            f"{ratios[0]:.2f}-{ratios[-1]:.2f}",
            f"{min(cost.memory for cost in samples) / 1024:.1f}",
        )
    return shown


@click.command()
@click.option("--repeat", type=click.IntRange(min=1), default=25, show_default=True, help="Runs of each.")
def main(repeat: int) -> None:
    """Time the main job's process beside that of Python and of Python with click."""
    with tempfile.TemporaryDirectory() as folder:
        tape = f"{folder}/circle.asc"
        subprocess.run([PDP8, "part", "circle", "-o", tape], check=True, cwd=folder)
        commands = {
            "python": [sys.executable, "-c", "pass"],
            "import click": [sys.executable, "-c", "import click"],
            "a click command that copies": [sys.executable, "-c", COPIES],
            "pdp8 run eia.pal < an empty tape": [PDP8, "run", "eia.pal"],
            "pdp8 run eia.pal < circle.asc": [PDP8, "run", "eia.pal"],
        }
        costs: dict[str, list[Cost]] = {name: [] for name in commands}
        for _ in range(repeat):
            for name, command in commands.items():
                costs[name].append(run(command, os.devnull if "empty" in name else tape))
    Console(width=None if sys.stdout.isatty() else 120).print(table(costs))


if __name__ == "__main__":
    main()
