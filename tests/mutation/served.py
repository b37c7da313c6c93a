"""Our commands in forks of this process, with the mutant that is in it, under the coverage it is under.

test ── bash ─► pdp8 (tests/warm.c) ──► server, a fork of this process ── fork ──► the command
"""

import os
import shutil
import signal
from pathlib import Path

import coverage

from tests import warm

_LONGEST = 60.0
"""Seconds of processor time that a command may take."""
_COMMAND = "command"


def serve(clients: Path, own: Path, measured: coverage.Coverage | None = None) -> None:
    """Have tests run our commands so, by copies of `clients` in the empty folder `own`."""
    shutil.copytree(clients, own, symlinks=True)
    life, ready = os.pipe(), os.pipe()
    if os.fork() == 0:
        try:
            os.close(life[1])
            os.dup2(life[0], 0)
            os.dup2(ready[1], 1)
            _bound(own, measured)
            warm.serve(f"{own}/server")
        finally:
            os._exit(0)
    os.close(life[0])
    os.close(ready[1])
    os.read(ready[0], 1)
    warm.environment = lambda cold: {
        "PATH": f"{own}{os.pathsep}{cold}{os.pathsep}{os.environ['PATH']}",
        "WARM_COMMANDS": f"{own}/server",
        "COLD_COMMANDS": str(cold),
    }


def _bound(own: Path, measured: coverage.Coverage | None) -> None:
    """Let no command run for ever; leave in `own` which lines it ran."""
    status = warm._status

    def bounded(run: object) -> int:
        signal.setitimer(signal.ITIMER_PROF, _LONGEST)
        if measured is None:
            return status(run)
        measured.switch_context(_COMMAND)
        found = status(run)
        measured.stop()
        data = measured.get_data()
        lines = [
            f"{file}\t{line}\n"
            for file in data.measured_files()
            for line, names in data.contexts_by_lineno(file).items()
            if _COMMAND in names
        ]
        (own / f"{os.getpid()}.lines").write_text("".join(lines))
        return found

    warm._status = bounded


def lines_of_commands(own: Path) -> set[tuple[str, int]]:
    """Return the files and lines that the commands since the last call ran."""
    found: set[tuple[str, int]] = set()
    for path in own.glob("*.lines"):
        for line in path.read_text().splitlines():
            file, _, number = line.partition("\t")
            found.add((file, int(number)))
        path.unlink()
    return found
