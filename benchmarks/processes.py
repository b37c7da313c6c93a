"""The main job as a whole process, beside Python itself and Python with click: seconds and peak memory.

    python -m benchmarks.processes [--repeat 15]

Medians of processes started in turn, from start to exit. What is measured is the installation of this Python:
an editable one starts slower than a wheel.
"""

import os
import statistics
import subprocess
import sys
import tempfile
import time
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
    """Run `command` with the tape as its standard input."""
    began = time.perf_counter()
    with open(tape, "rb") as frames:
        process = subprocess.Popen(
            command,
            stdin=frames,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            cwd=os.path.dirname(tape),
        )
        _, _, used = os.wait4(process.pid, 0)
    return Cost(time.perf_counter() - began, used.ru_utime + used.ru_stime, used.ru_maxrss)


def table(costs: dict[str, list[Cost]]) -> Table:
    """Return the medians, as multiples of `import click` too."""
    shown = Table(title=f"whole processes, Python {sys.version.split()[0]}, medians")
    for column in ("process", "wall ms", "processor ms", "× import click", "peak MiB"):
        shown.add_column(column, justify="left" if column == "process" else "right")
    base = statistics.median(cost.processor for cost in costs["import click"])
    for name, samples in costs.items():
        wall, processor, memory = (statistics.median(values) for values in zip(*samples, strict=True))
        shown.add_row(
            name,
            f"{wall * 1e3:.1f}",
            f"{processor * 1e3:.1f}",
            f"{processor / base:.2f}",
            f"{memory / 1024:.1f}",
        )
    return shown


@click.command()
@click.option("--repeat", type=click.IntRange(min=1), default=15, show_default=True, help="Runs of each.")
def main(repeat: int) -> None:
    """Time the main job's process beside that of Python and of Python with click."""
    with tempfile.TemporaryDirectory() as folder:
        tape = f"{folder}/circle.asc"
        subprocess.run([PDP8, "part", "circle", "-o", tape], check=True, cwd=folder)
        commands = {
            "python": [sys.executable, "-c", "pass"],
            "import click": [sys.executable, "-c", "import click"],
            "pdp8 run eia.pal < circle.asc": [PDP8, "run", "eia.pal"],
        }
        costs: dict[str, list[Cost]] = {name: [] for name in commands}
        for _ in range(repeat):
            for name, command in commands.items():
                costs[name].append(run(command, tape))
    Console().print(table(costs))


if __name__ == "__main__":
    main()
