"""Mutants of the pages' scripts, from the syntax tree that ESLint's parser gives; each is tried as a fault.

    python -m tests.mutation.scripts [--fast] [--sample 60] [--seed 0] [-j JOBS] [FOLDER...]

The folders are bench, room, curve, and "." for the modules beside them; --fast runs what `make test` runs.

As in mutants.py: a comparison, an operator, a condition, its halves, a number, a return, a statement. A
number within a template or an object is a size or a colour, which no test knows.
"""

import argparse
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from functools import cache
from pathlib import Path
from typing import Any

from pdp8.web import curve, workbench
from tests.faults.catalogue import Fault
from tests.faults.workshop import HOUSE, first_failure
from tests.pdp8.web.node import NODE, modules

WEB = "pdp8/web"
TESTS = {
    "bench": ["again", "walked", "drives", "workbench", "desk", "looked", "model", "page", "controls"],
    "room": ["again", "looked", "walked", "room", "model", "touch"],
    "curve": ["again", "looked", "curve", "walked"],
    ".": ["again", "walked", "looked", "workbench", "desk", "room", "curve", "model"],
}
"""The tests of each folder, the quickest first."""
FLOOR = 0.85
_LONGEST = 900
"""Seconds for all the fast tests of a folder, on a busy machine."""
_LIST = """
import { parse } from "PARSER";
import { readFileSync } from "node:fs";
const OTHERS = { "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "===": ["!=="],
  "!==": ["==="], "+": ["-"], "-": ["+"], "*": ["+"], "/": ["*"], "%": ["*"], "&&": ["||"], "||": ["&&"],
  "??": ["&&"], "+=": ["-="], "-=": ["+="] };
const found = [];
for (const file of JSON.parse(readFileSync(0, "utf8"))) {
  const text = readFileSync(file, "utf8");
  const of = ({ start, end }) => text.slice(start, end);
  const change = ({ start, end }, after) => found.push([file, start, end, after]);
  const visit = (node, plain) => {
    const { type, left, right, operator, test, argument, value } = node;
    if (OTHERS[operator] && left) {
      const start = left.end + text.slice(left.end, right.start).lastIndexOf(operator);
      for (const other of OTHERS[operator]) change({ start, end: start + operator.length }, other);
    }
    if (type === "LogicalExpression") for (const half of [left, right]) change(node, `(${of(half)})`);
    if (operator === "!") change(node, of(argument));
    if (type === "Literal" && plain && typeof value === "number") change(node, String(value + 1));
    if (type === "Literal" && typeof value === "boolean") change(node, String(!value));
    if (/^(If|Cond)/.test(type) && !OTHERS[test.operator]) change(test, `!(${of(test)})`);
    if (type === "ReturnStatement" && argument) change(argument, "null");
    if (type === "ExpressionStatement") change(node, ";");
    const within = plain && type !== "TemplateLiteral" && type !== "Property";
    for (const each of Object.values(node).flat()) if (each?.type) visit(each, within);
  };
  visit(parse(text, { ecmaVersion: "latest", sourceType: "module" }), true);
}
console.log(JSON.stringify(found));
"""


def mutants(folder: str) -> list[Fault]:
    """Return the mutants of a folder's scripts."""
    files = sorted(path.relative_to(HOUSE).as_posix() for path in (HOUSE / WEB / folder).glob("*.mjs"))
    parser = HOUSE / "tests/node/node_modules/acorn/dist/acorn.mjs"
    command = [str(NODE), "--input-type=module", "--eval", _LIST.replace("PARSER", parser.as_uri())]
    listed = subprocess.run(
        command, input=json.dumps(files), cwd=HOUSE, stdout=subprocess.PIPE, text=True, check=True
    )
    texts = {file: (HOUSE / file).read_text() for file in files}
    tests = [f"tests/pdp8/web/test_{name}.py" for name in TESTS[folder]]

    def one(file: str, start: int, end: int, after: str) -> Fault:
        text = texts[file]
        line, before = text.count("\n", 0, start) + 1, " ".join(text[start:end].split())
        return Fault(
            folder, f"{line}: {before} → {after}", file, text, text[:start] + after + text[end:], tests
        )

    found: list[Any] = json.loads(listed.stdout)
    return [one(*each) for each in found]


@cache
def ready() -> Path:
    """Return the modules, with the pages beside them."""
    for name, make in (("pdp8", workbench.page), ("curve", curve.page)):
        (modules() / f"{name}.html").write_text(make(), encoding="utf-8")
    return modules()


def fast(fault: Fault) -> str:
    """Return the first test of `make test` that finds a fault; "" where none does."""
    with tempfile.TemporaryDirectory(prefix="pdp8-fault-") as folder:
        there = Path(folder) / "modules"
        shutil.copytree(ready(), there, copy_function=os.link)
        (there / fault.file).unlink()
        (there / fault.file).write_text(fault.new)
        command = [sys.executable, "-m", "pytest", "-xqm", "not slow", "--tb=no", "-pno:cacheprovider", "-n0"]
        try:
            done = subprocess.run(
                [*command, *fault.tests], cwd=HOUSE, env=os.environ | {"PDP8_MODULES": str(there)},
                stdout=subprocess.PIPE, text=True, check=False, timeout=_LONGEST,
            )  # fmt: skip
        except subprocess.TimeoutExpired:
            return f"did not end in {_LONGEST} s"
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return " ".join(failed) or done.stdout[-200:] if done.returncode else ""


def _found(fault: Fault, quick: bool) -> bool:
    """Whether a test finds a fault; one that none finds is printed."""
    by = fast(fault) if quick else first_failure(fault.tests, fault)
    if not by:
        print(f"survived {fault.file}:{fault.name[:120]}", flush=True)
    return bool(by)


def main(arguments: argparse.Namespace) -> int:
    """Try a sample of each folder; print what survives and the scores; return the exit status."""
    low = False
    for folder in arguments.folders or TESTS:
        there = mutants(folder)
        picked = random.Random(arguments.seed).sample(there, min(arguments.sample or len(there), len(there)))
        with ThreadPoolExecutor(arguments.jobs) as pool:
            verdicts = list(pool.map(lambda fault: _found(fault, arguments.fast), picked))
        score = sum(verdicts) / len(verdicts)
        print(f"| {folder} | {len(there)} | {len(picked)} | {sum(verdicts)} | {score:.1%} |", flush=True)
        low |= score < FLOOR
    return int(low)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description="Change the pages' scripts by rule and see whether a test fails."
    )
    parser.add_argument("folders", nargs="*", help=f"of {', '.join(TESTS)} [all]")
    parser.add_argument(
        "--sample", type=int, default=60, metavar="N", help="at most N of a folder; 0 for all"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the drawing [0]")
    parser.add_argument("--fast", action="store_true", help="by the tests of `make test` alone")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="how many at once [1]")
    sys.exit(main(parser.parse_args()))
