"""A copy of the sources in which a fault is put and its tests are run.

Nothing is compiled there, so that what is run is what is changed.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tests.faults.catalogue import Fault, applied

HOUSE = Path(__file__).parents[2]
CLIENTS = Path("tests/node/node_modules")
"""What the debug client and the pages' tests in Node.js import."""
LONGEST = 300
"""Seconds after which a test that does not end has found the fault."""


def copy(folder: Path) -> None:
    """Copy every file that git knows or would add; link what npm has installed."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "-z"]
    listed = subprocess.run(command, cwd=HOUSE, capture_output=True, text=True, check=True)
    for name in listed.stdout.split("\0"):
        if (HOUSE / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(HOUSE / name, folder / name)
    if (HOUSE / CLIENTS).is_dir():
        (folder / CLIENTS).symlink_to(HOUSE / CLIENTS)


def first_failure(tests: list[str], fault: Fault | None = None) -> str:
    """Return the first of the tests that fails in a copy with the fault in it; "" where all pass.

    Raises ValueError if the fault does not fit, or the tests do not run.
    """
    with tempfile.TemporaryDirectory(prefix="pdp8-fault-") as folder:
        copy(Path(folder))
        if fault:
            path = Path(folder) / fault.file
            path.write_text(applied(fault, path.read_text()))
        options = ("-x", "-q", "--no-header", "--tb=no", "-p", "no:cacheprovider", "-p", "no:xdist")
        longest = LONGEST if fault else LONGEST * len(tests)
        try:
            done = subprocess.run(
                [sys.executable, "-m", "pytest", *options, *tests],
                cwd=folder,
                env=os.environ | {"PYTHONDONTWRITEBYTECODE": "1", "PYTHONPATH": folder},
                capture_output=True,
                text=True,
                timeout=longest,
                check=False,
            )
        except subprocess.TimeoutExpired:
            return f"did not end in {longest} s"
    lines = [line for line in done.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    if done.returncode and not (lines and done.returncode in (1, 2)):
        raise ValueError(done.stdout[-200:] + done.stderr[-200:])
    return lines[0].split(" ", 1)[1].split(" - ")[0] if lines else ""
