"""The pages' modules under Node.js."""

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

NODE = shutil.which("node")
MODULES = Path(__file__).parents[3] / "pdp8" / "web"

needs_node = pytest.mark.skipif(NODE is None, reason="Node.js is not installed")

_DRIVER = """
import { readFileSync } from "node:fs";
console.log(JSON.stringify(await (FUNCTION)(JSON.parse(readFileSync(0, "utf8")))));
"""


def in_node(function: str, given: Any = None) -> Any:
    """Return what the JavaScript `function` returns of `given`, both as JSON goes. In it "@/" is the modules'
    folder: `async (given) => { const { pal } = await import("@/pal.mjs"); ... }`.
    """
    driver = _DRIVER.replace("FUNCTION", function.replace('"@/', f'"{MODULES.as_uri()}/'))
    done = subprocess.run(
        [str(NODE), "--input-type=module", "--eval", driver],
        input=json.dumps(given),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)
