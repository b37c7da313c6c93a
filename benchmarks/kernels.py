"""How fast the machine is, beside SIMH: the same programs in the same run, least times, spread and ratios.

    counter      two nested counters, ISZ and JMP alone
    body         nested counters with an IAC in each turn
    mixed        checksum, software multiplication and sieve
    sort         an insertion sort
    calls        three-word arithmetic in subroutines, as a floating-point package has it
    interrupt    a count, and characters printed under interrupt
    translation  the thesis's character translation, a tape of 18,000 frames at 10 a second

A time is that of the processor, inside the run: SIMH's is its whole process less that of one that only starts
and ends. Runs of ours and of SIMH alternate. SIMH is run as it is installed; its Teletype is not timed as a
real one, so it has no part in interrupt and translation.

    python -m benchmarks.kernels [--repeat 9] [--form plain]
"""

import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from shutil import which
from types import ModuleType
from typing import Any, NamedTuple

import click
from rich.console import Console
from rich.table import Table

import pal
from tests.pdp8.computer.speed.forms import FORMS, machine_module

HERE = Path(__file__).parent
PROGRAMS = HERE.parent / "programs"
SIMH = next((path for path in ("/usr/bin/pdp8", which("simh-pdp8") or "") if Path(path).is_file()), "")
TIMEOUT = 600


class Row(NamedTuple):
    """A kernel as it was run: instructions and machine seconds, then seconds of our runs and of SIMH's."""

    name: str
    instructions: int
    machine_time: float
    ours: list[float]
    simh: list[float]


def kernel(name: str) -> dict[int, int]:
    """Return the words of one of the sources beside this file."""
    return dict(pal.assemble((HERE / f"{name}.pal").read_bytes()).words)


def machine(form: ModuleType, words: dict[int, int], delays: bool, tape: bytes = b"") -> Any:
    """Return a machine started at 0200 with the words and the tape."""
    made = form.Machine()
    made.load(words)
    made.engine.delays = delays
    made.teletype.reader.load(tape)
    made.start(0o200)
    return made


def timed(action: Callable[[], object]) -> float:
    """Return the processor's seconds that `action` takes."""
    began = time.process_time()
    action()
    return time.process_time() - began


def children() -> float:
    """Return the processor's seconds that all processes started from here have taken."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def simh(words: dict[int, int] | None) -> float:
    """Return the seconds of a SIMH process that runs the words from 0200, or that only starts and ends."""
    commands = [f"deposit {address:o} {word:o}" for address, word in (words or {}).items()]
    if words:
        commands.append("go 200")
    with tempfile.NamedTemporaryFile("w", suffix=".simh") as script:
        script.write("\n".join([*commands, "exit", ""]))
        script.flush()
        began = children()
        subprocess.run([SIMH, script.name], capture_output=True, timeout=TIMEOUT, check=True)
    return children() - began


def computed(
    form: ModuleType, name: str, label: str, repeat: int, delays: bool = True, beside: bool = True
) -> Row:
    """Run a kernel, in turns with SIMH if it is to be `beside`."""
    words = kernel(name)
    ours, theirs, empty = [], [], []
    for _ in range(repeat):
        made = machine(form, words, delays)
        ours.append(timed(made.run))
        if SIMH and beside:
            theirs.append(simh(words))
            empty.append(simh(None))
    return Row(label, made.instructions, made.elapsed, ours, [seconds - min(empty) for seconds in theirs])


def translated(form: ModuleType, label: str, frames: int, repeat: int) -> Row:
    """Run the translation on a tape of digits, lines and parity as the circle's has."""
    words = dict(pal.assemble((PROGRAMS / "eia.pal").read_bytes()).words)
    line = bytes(code | 0o200 for code in b"1234567890 123\r\n") + b"\xff" * 2
    tape = (line * (frames // len(line) + 1))[:frames]
    ours = []
    for _ in range(repeat):
        made = machine(form, words, True, tape)
        ours.append(timed(made.run))
    return Row(label, made.instructions, made.elapsed, ours, [])


def rows(form: ModuleType, repeat: int) -> Iterator[Row]:
    """Run every kernel."""
    yield computed(form, "counter", "counter, every turn", repeat, delays=False)
    yield computed(form, "counter", "counter, delays passed over", repeat, delays=True)
    for name in ("body", "mixed", "sort", "calls"):
        yield computed(form, name, name, repeat)
    yield computed(form, "interrupt", "interrupt", repeat, beside=False)
    yield translated(form, "translation, 18,000 frames", 18_000, repeat)
    yield translated(form, "translation, 8 hours", 8 * 3600 * 10, repeat)


def table(form: str, results: list[Row]) -> Table:
    """Return the results as a table."""
    shown = Table(title=f"{form} core, Python {sys.version.split()[0]}, least of each")
    shown.add_column("kernel")
    for column in ("instructions", "in 1971", "seconds", "to", "million/s", "× a real 8/L", "× SIMH", "to"):
        shown.add_column(column, justify="right")
    for row in results:
        least = min(row.ours)
        ratios = sorted(theirs / ours for ours, theirs in zip(row.ours, row.simh, strict=False))
        shown.add_row(
            row.name,
            f"{row.instructions:,}",
            f"{row.machine_time:,.1f} s",
            f"{least:.4f}",
            f"{max(row.ours):.4f}",
            f"{row.instructions / least / 1e6:,.0f}",
            f"{row.machine_time / least:,.0f}",
            f"{min(row.simh) / least:.2f}" if row.simh else "",
            f"{ratios[0]:.2f}-{ratios[-1]:.2f}" if ratios else "",
        )
    return shown


@click.command()
@click.option("--form", type=click.Choice(FORMS), default="compiled", show_default=True, help="Which core.")
@click.option("--repeat", type=click.IntRange(min=1), default=9, show_default=True, help="Runs of each.")
def main(form: str, repeat: int) -> None:
    """Run the kernels and show them beside SIMH."""
    console = Console(width=None if sys.stdout.isatty() else 120)
    with Console(stderr=True).status("running the kernels"):
        results = list(rows(machine_module(form), repeat))
    console.print(table(form, results))
    if not SIMH:
        console.print("SIMH is not installed (Debian: apt-get install simh), so there is nothing beside us.")


if __name__ == "__main__":
    main()
