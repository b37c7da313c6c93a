"""Try mutants room by room; print the survivors and the table of scores.

    python -m tests.mutation nc tapes [--sample 300] [--seed 0] [--since REF] [-j JOBS]

The score is the part of the mutants that a test catches, of those that change something: equal.toml names
those that do not, each with its reason. Exit status 1 where a room is below the floor.
"""

import argparse
import os
import random
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tests.faults.workshop import Workshop
from tests.mutation.mutants import Mutant, mutants
from tests.mutation.rooms import HOUSE, ROOMS, equal, sources

FLOOR = 0.95


def main(arguments: argparse.Namespace) -> int:
    """Try the rooms; return the exit status."""
    changed = _changed(arguments.since) if arguments.since else None
    table = []
    for room in arguments.rooms or ROOMS:
        began = time.monotonic()
        found = _room(room, arguments, changed)
        if found["tried"]:
            table.append((room, found, time.monotonic() - began))
    print("\n| room | mutants | tried | caught | survive | not run | change nothing | score |")
    print("|---|--:|--:|--:|--:|--:|--:|--:|")
    for room, found, seconds in table:
        numbers = (found[verdict] for verdict in ("there", "tried", "caught", "survived", "not run", "equal"))
        print(f"| {room} | {' | '.join(map(str, numbers))} | {score(found):.1%} |")
        print(f"{room}: {seconds:.0f} s", file=sys.stderr)
    return int(any(score(found) < FLOOR for _, found, _ in table))


def score(found: Counter[str]) -> float:
    """Return the part that is caught of the mutants that change something."""
    counted = found["tried"] - found["equal"]
    return found["caught"] / counted if counted else 1.0


def _room(room: str, arguments: argparse.Namespace, changed: dict[str, set[int]] | None) -> Counter[str]:
    """Try the mutants of a room and print those that no test catches; return the number of each verdict."""
    same = equal()
    known: dict[tuple[str, int], Mutant] = {}
    found: Counter[str] = Counter()
    for path in sources(room):
        file = path.as_posix()
        for mutant in mutants((HOUSE / path).read_text()):
            if changed is not None and changed.get(file, set()).isdisjoint(mutant.lines):
                continue
            if arguments.only and arguments.only not in f"{file} {mutant.scope}":
                continue
            known[file, mutant.number] = mutant._replace(tree=None)  # type: ignore[arg-type]
    picked = sorted(known)
    if arguments.sample and len(picked) > arguments.sample:
        picked = sorted(random.Random(arguments.seed).sample(picked, arguments.sample))
    found.update(there=len(known), tried=len(picked))
    chosen: dict[str, set[int]] = {path.as_posix(): set() for path in sources(room)}
    for file, number in picked:
        if (file, known[file, number].scope, known[file, number].text) in same:
            found["equal"] += 1
        else:
            chosen[file].add(number)
    for file, number, verdict in _tried(room, chosen, arguments.jobs):
        found[verdict] += 1
        if verdict != "caught":
            mutant = known[file, number]
            print(
                f"{verdict:8} {file}:{mutant.lines[-1]} {mutant.scope or '(module)'}: {mutant.text}",
                flush=True,
            )
    return found


def _tried(room: str, chosen: dict[str, set[int]], jobs: int) -> Iterator[tuple[str, int, str]]:
    """Try mutants in a copy of the sources, where nothing of the room is compiled."""
    if not any(chosen.values()):
        return
    kept = HOUSE / "build" / "mutation" / room
    kept.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="pdp8-mutation-") as name:
        copy = Path(name)
        Workshop(copy)
        folder, tests = ROOMS[room]
        for built in () if room == "pal" else HOUSE.glob("p*/**/*.so"):
            path = built.relative_to(HOUSE)
            if not path.is_relative_to(folder):
                (copy / path).symlink_to(built)
        work = "import sys; from tests.mutation.runner import main; main(*sys.argv[1:])"
        with subprocess.Popen(
            [sys.executable, "-c", work, repr(tests), repr(chosen), str(jobs), str(kept)],
            cwd=copy,
            env=os.environ | {"PYTHONPATH": str(copy)},
            stdout=subprocess.PIPE,
            text=True,
        ) as running:
            assert running.stdout
            for line in running.stdout:
                if line.count("\t") == 2:
                    file, number, verdict = line.split("\t")
                    yield file, int(number), verdict.rstrip()
    if running.returncode:
        raise SystemExit(f"the runner ended with status {running.returncode}")


def _changed(since: str) -> dict[str, set[int]]:
    """Return the lines of each file that differ from a commit."""
    shown = subprocess.run(
        ["git", "diff", "-U0", since, "--", "*.py"], cwd=HOUSE, capture_output=True, text=True, check=True
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
    parser.add_argument("rooms", nargs="*", metavar="ROOM", help=f"of {', '.join(ROOMS)} [all]")
    parser.add_argument(
        "--sample", type=int, default=0, metavar="N", help="at most N mutants a room, drawn at random"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the drawing [0]")
    parser.add_argument("--since", metavar="REF", help="only on lines that differ from this commit")
    parser.add_argument("--only", metavar="TEXT", help="only in files or functions with this in their name")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="how many at once [1]")
    found = parser.parse_args()
    if unknown := set(found.rooms) - set(ROOMS):
        parser.error(f"no room {', '.join(sorted(unknown))}; the rooms are {', '.join(ROOMS)}")
    sys.exit(main(found))
