"""The wheel for every platform runs the main job in Pyodide, CPython in WebAssembly, as in a browser."""

import os
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import click
import pytest

from tests.conftest import assert_same_tape
from tests.faults import workshop

HOUSE = Path(__file__).parents[2]
PYODIDE = HOUSE / "tests" / "node" / "node_modules" / "pyodide"
NODE = shutil.which("node")
_RUN = """
import { readFileSync } from "node:fs";
const [, folder, ...archives] = process.argv;
const { loadPyodide } = await import(`file://${folder}/pyodide.mjs`);
const python = await loadPyodide({ indexURL: `${folder}/` });
for (const archive of archives) python.unpackArchive(new Uint8Array(readFileSync(archive)).buffer, "zip");
console.log(python.runPython(`
import programs  # its files are on the shelf
from click.testing import CliRunner
from pdp8.cli.root import pdp8

tape = CliRunner().invoke(pdp8, ["part", "circle"], catch_exceptions=False).stdout_bytes
cut = CliRunner().invoke(pdp8, ["run", "eia.pal"], input=tape, catch_exceptions=False)
assert cut.exit_code == 0, cut.output
cut.stdout_bytes.hex()
`));
"""


@pytest.mark.slow("starts a Python in WebAssembly")
@pytest.mark.skipif(NODE is None, reason="node is not installed")
@pytest.mark.skipif(not PYODIDE.is_dir(), reason="pyodide is not installed: npm ci --prefix tests/node")
def test_the_main_job_runs_in_pyodide(tmp_path: Path) -> None:
    clicks = tmp_path / "click.zip"
    with zipfile.ZipFile(clicks, "w") as archive:
        for path in Path(click.__file__).parent.glob("*.py"):
            archive.write(path, f"click/{path.name}")
    command = str(NODE), "--input-type=module", "--eval", _RUN, PYODIDE, _plain_wheel(tmp_path), clicks
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert_same_tape(bytes.fromhex(done.stdout), (HOUSE / "tapes" / "circle.eia").read_bytes())


def _plain_wheel(folder: Path) -> Path:
    """Build py3-none-any from a copy of the sources, so that no other build is disturbed."""
    source = folder / "source"
    workshop.copy(source)
    words = ("-m", "pip", "wheel", "-q", "--no-deps", "--no-build-isolation", "-w", folder, source)
    subprocess.run([sys.executable, *words], env={**os.environ, "PDP8_EXTENSIONS": "forbid"}, check=True)
    (built,) = folder.glob("pdp8-*-py3-none-any.whl")
    return built
