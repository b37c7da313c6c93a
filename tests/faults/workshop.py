"""A copy of the sources in which a fault is put and its tests are run.

Nothing is compiled there, so that what is run is what is changed.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

from tests.faults.catalogue import Fault, applied

HOUSE = Path(__file__).parents[2]
LONGEST = 300
"""Seconds after which tests that do not end have found the fault."""


class Found(NamedTuple):
    """The outcome of a fault: "caught" or "passes", and the test that failed first."""

    verdict: str
    by: str


class Workshop:
    """A copy of every file that git knows or would add, in `folder`."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        listed = subprocess.run(
            ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"],
            cwd=HOUSE,
            capture_output=True,
            check=True,
        )
        for name in filter(None, listed.stdout.decode().split("\0")):
            if (HOUSE / name).is_file():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(HOUSE / name, folder / name)

    def try_out(self, fault: Fault) -> Found:
        """Put the fault in, run its tests, take it out. Raises ValueError if it does not fit."""
        path = self.folder / fault.file
        text = path.read_text()
        path.write_text(applied(fault, text))
        try:
            return self.run(fault.tests)
        finally:
            path.write_text(text)

    def run(self, tests: tuple[str, ...], longest: int = LONGEST) -> Found:
        """Run tests up to the first that fails, or for `longest` seconds."""
        options = ("-x", "-q", "--no-header", "--tb=no", "-p", "no:cacheprovider", "-p", "no:xdist")
        try:
            done = subprocess.run(
                [sys.executable, "-m", "pytest", *options, *tests],
                cwd=self.folder,
                env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": str(self.folder)},
                capture_output=True,
                text=True,
                timeout=longest,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return Found("caught", f"did not end in {longest} s")
        if done.returncode == 0:
            return Found("passes", "")
        lines = [line for line in done.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
        first = (
            lines[0].split(" ", 1)[1].split(" - ")[0] if lines else done.stdout[-200:] + done.stderr[-200:]
        )
        return Found("caught" if done.returncode in (1, 2) else "error", first)
