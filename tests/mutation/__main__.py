"""Try mutants package by package; print the survivors and the table of scores.

    python -m tests.mutation nc tapes [--sample 300] [--seed 0] [--since REF] [--near] [-j JOBS]

The score is the part of the mutants that a test catches, of those that change something: equal.toml names
those that do not, each with its reason. Exit status 1 where a package is below its floor.
"""

import argparse
import random
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

from tests.mutation.mutants import mutants
from tests.mutation.packages import PACKAGES, ROOT, equal, sources
from tests.mutation.runner import tried

FLOORS = dict.fromkeys(PACKAGES, 0.95) | dict.fromkeys(("dap", "cli", "web", "translator"), 0.9)
FLOORS["photographs"] = 0.85
"""No picture shows a limit that is one sample further off."""


def main(arguments: argparse.Namespace) -> int:
    changed = _changed(arguments.since) if arguments.since else None
    table = []
    for package in arguments.packages or PACKAGES:
        found = _package(package, arguments, changed)
        if found["tried"]:
            table.append((package, found))
    print("\n| package | mutants | tried | caught | survive | not run | change nothing | score |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    for package, found in table:
        numbers = (found[verdict] for verdict in ("there", "tried", "caught", "survived", "not run", "equal"))
        print(f"| {package} | {' | '.join(map(str, numbers))} | {_score(found):.1%} |")
    return int(any(_score(found) < FLOORS[package] for package, found in table))


def _score(found: Counter[str]) -> float:
    """Return the part that is caught of the mutants that change something."""
    counted = found["tried"] - found["equal"]
    return found["caught"] / counted if counted else 1.0


def _package(
    package: str, arguments: argparse.Namespace, changed: dict[str, set[int]] | None
) -> Counter[str]:
    """Try the mutants of a package, print those that no test catches, and count the verdicts."""
    there = [
        (file, mutant)
        for file in sources(package)
        for mutant in mutants((ROOT / file).read_text())
        if changed is None or not changed.get(file, set()).isdisjoint(mutant.lines)
    ]
    picked = there
    if 0 < arguments.sample < len(there):
        numbers = random.Random(arguments.seed).sample(range(len(there)), arguments.sample)
        picked = [there[number] for number in sorted(numbers)]
    same = equal()
    chosen = [(file, mutant) for file, mutant in picked if (file, mutant.scope, mutant.text) not in same]
    found = Counter(there=len(there), tried=len(picked), equal=len(picked) - len(chosen))
    with tempfile.TemporaryDirectory(prefix="pdp8-mutation-") as folder:
        for file, mutant, verdict in tried(package, chosen, arguments.jobs, Path(folder), arguments.near):
            found[verdict] += 1
            if verdict != "caught":
                place = f"{file}:{mutant.lines[-1]} {mutant.scope or '(module)'}"
                print(f"{verdict:8} {place}: {mutant.text}", flush=True)
    return found


def _changed(since: str) -> dict[str, set[int]]:
    """Return the lines of each file that differ from a commit."""
    shown = subprocess.run(
        ["git", "diff", "-U0", since, "--", "*.py"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout
    found: dict[str, set[int]] = {}
    file = ""
    for line in shown.splitlines():
        if line.startswith("+++ "):
            file = line.removeprefix("+++ b/")
        elif hunk := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
            first, count = int(hunk[1]), int(hunk[2] or 1)
            found.setdefault(file, set()).update(range(first, first + count))
    return found


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Change the sources by rule and see whether a test fails.")
    parser.add_argument("packages", nargs="*", metavar="PACKAGE", help=f"of {', '.join(PACKAGES)} [all]")
    parser.add_argument(
        "--sample", type=int, default=0, metavar="N", help="at most N mutants a package, drawn at random"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the drawing [0]")
    parser.add_argument("--since", metavar="REF", help="only on lines that differ from this commit")
    parser.add_argument(
        "--near", action="store_true", help="only by the tests that run the changed line: no fewer survive"
    )
    parser.add_argument("-j", "--jobs", type=int, default=1, help="how many at once [1]")
    found = parser.parse_args()
    if unknown := set(found.packages) - set(PACKAGES):
        parser.error(f"no package {', '.join(sorted(unknown))}; the packages are {', '.join(PACKAGES)}")
    sys.exit(main(found))
