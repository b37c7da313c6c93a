"""The pages' modules under Node.js: those by hand and those translated, each where a page has it."""

import atexit
import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Iterable
from dataclasses import fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest

from pdp8.web import translator

NODE = shutil.which("node")
HOUSE = Path(__file__).parents[3]
SECONDS = 300
"""What a call may take on a busy machine; more is a loop that does not end."""

needs_node = pytest.mark.skipif(NODE is None, reason="Node.js is not installed")

_DRIVER = """
import { readFileSync } from "node:fs";
import { bytes, Dict } from "@/pdp8/web/translator/runtime.mjs";
const plain = (of) =>
  of instanceof Dict ? Array.from(of.items(), plain)
  : of instanceof Number ? of.valueOf()
  : typeof of === "bigint" ? Number(of)
  : of === null || typeof of !== "object" ? of
  : of[Symbol.iterator] ? Array.from(of, plain)
  : of.constructor.$fields?.map((name) => plain(of[name])) ?? of;
const given = JSON.parse(readFileSync(0, "utf8"), (_, of) => (of?.$bytes ? bytes(of.$bytes) : of));
console.log(JSON.stringify(plain(await (FUNCTION)(given))));
"""
_CALLED = """(calls) => Promise.all(calls.map(async ([module, name, ...given]) => {
  const found = await import("@/" + module + ".mjs");
  try { return found[name](...given); }
  catch (error) { return `${error.constructor.name}: ${error.message}`; }
}))"""


@cache
def modules(checked: bool = True) -> Path:
    """Return the folder where all modules stand, as long as this process lives: checked, or as shipped."""
    if made := os.environ.get("PDP8_MODULES"):
        return Path(made)
    folder = Path(tempfile.mkdtemp(prefix="pdp8-modules-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    with patch.dict(translator.MODULES, {"tests.pdp8.computer.lockstep": "breaker"}):
        write(folder, translator.translated(checked=checked))
    for file in Path(__file__).parent.glob("*.mjs"):
        shutil.copy(file, folder)
    return folder


def page(name: str, make: Callable[[], str]) -> str:
    """Return the HTML of a page; while faults of its modules are tried it is made once: they run, not it."""
    if folder := os.environ.get("PDP8_MODULES"):
        return (Path(folder) / f"{name}.html").read_text(encoding="utf-8")
    return make()


def write(folder: Path, translated: dict[str, str], suffix: str = ".mjs") -> None:
    """Write translated modules, {name: text}, with the runtime and the modules by hand."""
    for file in (HOUSE / "pdp8" / "web").rglob("*.mjs"):
        target = folder / file.relative_to(HOUSE)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(file.read_bytes())
    for name, text in translated.items():
        target = folder.joinpath(*name.split(".")).with_suffix(suffix)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")


def in_node(function: str, given: Any = None, folder: Path | None = None) -> Any:
    """Return what the JavaScript `function` returns of `given`, as `plain` does. In it "@/" is the house:
    `async (given) => { const { assemble } = await import("@/pal/assembling.mjs"); ... }`; bytes are bytes.
    """
    house = (folder or modules()).as_uri()
    driver = _DRIVER.replace("FUNCTION", function).replace('"@/', f'"{house}/')
    command = [str(NODE), "--input-type=module", "--eval", driver]
    asked = json.dumps(given, default=lambda frames: {"$bytes": [*frames]})
    done = subprocess.run(command, input=asked, capture_output=True, text=True, check=False, timeout=SECONDS)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def called(*calls: tuple[Any, ...], folder: Path | None = None) -> list[Any]:
    """Return what each call, (module, function, *arguments), returns there, or what it raises, as text."""
    return list(in_node(_CALLED, calls, folder))


def plain(of: Any) -> Any:
    """Return a value as JSON has it in both languages: records, sequences and tables as lists."""
    if isinstance(of, dict):
        return plain(of.items())
    if is_dataclass(of):
        return [plain(getattr(of, field.name)) for field in fields(of)]
    return [plain(each) for each in of] if isinstance(of, Iterable) and not isinstance(of, str) else of
