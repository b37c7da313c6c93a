"""Small programs with `main() -> str`: what it returns in Python and in Node.js, or why it is refused."""

import json
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

from pdp8.web.translator import runtime
from pdp8.web.translator.modules import translate
from tests.pdp8.web.node import NODE

_RUN = """
import { readFileSync, writeSync } from "node:fs";
const [folder, ...names] = JSON.parse(readFileSync(0, "utf8"));
for (const name of names) {
  let found;
  try { found = (await import(`file://${folder}/${name}.mjs`)).main(); }
  catch (error) { found = `!${error.constructor.name}: ${error.message}`; }
  writeSync(1, JSON.stringify([name, found]) + "\\n");
}
"""
_SECONDS = 60
"""What all of them may take; the first without an answer is one that does not end."""


class Tried(NamedTuple):
    """What became of a specimen: refused, with the reason, or run."""

    python: str
    javascript: str | None
    refused: str

    @property
    def place(self) -> str:
        """Where it is refused; the runtime refuses what is seen too late."""
        if self.refused:
            return f"in line {self.refused.partition(':')[0]}"
        return "as it runs" if (self.javascript or "").startswith("!Untranslated: ") else ""

    @property
    def differs(self) -> bool:
        """Whether it was accepted and gives something else."""
        return not self.place and self.python != self.javascript


def tried(specimens: Mapping[str, str], folder: Path) -> dict[str, Tried]:
    """Return what became of each of the specimens, {name: source}."""
    refused: dict[str, str] = {}

    def note(fault: str) -> None:
        path, _, why = fault.partition(":")
        refused.setdefault(path, why)

    sources = {name: (name, source) for name, source in specimens.items()}
    written = translate(sources, {}, note)
    names = [name for name in specimens if name not in refused]
    target = folder / "pdp8" / "web" / "translator" / "runtime.mjs"
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(runtime(), encoding="utf-8")
    for name in names:
        (folder / f"{name}.mjs").write_text(written[name], encoding="utf-8")
    found: dict[str, str] = {}
    while left := [name for name in names if name not in found]:
        found |= _in_node(folder, left)
        if left[0] not in found or len(found) < len(names):
            found.setdefault(next(name for name in names if name not in found), "!it does not end")
    return {
        name: Tried(_run(name, source), found.get(name), refused.get(name, ""))
        for name, source in specimens.items()
    }


def _in_node(folder: Path, names: list[str]) -> dict[str, str]:
    """Return what those of `names` return that come to an end."""
    command = [str(NODE), "--input-type=module", "--eval", _RUN]
    asked = json.dumps([str(folder), *names])
    try:
        done = subprocess.run(
            command, input=asked, capture_output=True, text=True, check=False, timeout=_SECONDS
        )
        said = done.stdout
    except subprocess.TimeoutExpired as late:
        said = late.stdout.decode() if isinstance(late.stdout, bytes) else ""
    return dict(json.loads(line) for line in said.split("\n") if line.endswith("]"))


def _run(name: str, source: str) -> str:
    """Return what `main` returns in Python, or the error it raises."""
    module = sys.modules[name] = ModuleType(name)  # where dataclasses look
    try:
        exec(compile(source, name, "exec"), vars(module))
        return str(module.main())
    except Exception as error:
        return f"!{type(error).__name__}: {error}"
    finally:
        del sys.modules[name]
