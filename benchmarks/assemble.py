"""Assemble a generated source of 20,000 lines with pal and with palbart, and say how fast each is.

    .venv/bin/python benchmarks/assemble.py [--lines 20000] [--rounds 7]

Whole processes are timed from start to exit, each writing tape and listing, in turn, the best of so many
rounds; warm is `pal.assemble` alone, passes 1 and 2, in a process that has assembled before. The source is
the same on every run.
"""

import argparse
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import pal

OPERATIONS = (
    "CLA CLL",
    "CMA IAC",
    "SZA CLA",
    "SNL",
    "TLS",
    "KSF",
    "RTL",
    "CIA",
    "7402",
    "-12",
    "TAD I 20",
    "ISZ 40",
)
REFERENCES = ("TAD", "DCA", "JMP", "JMS", "AND", "ISZ")


def source(lines: int) -> str:
    """Return a source of so many lines: pages of 100 words, tags, constants, comments."""
    choose = random.Random(1971)
    text = ["K1=10", "K2=K1+7"]
    page = 1
    while len(text) < lines - 102:
        tag = f"P{page}"
        text.append(f"*{page % 0o36 + 1 << 7:o}")
        text.append(f"{tag},\t0" if page < 500 else "\t0")
        for number in range(100):
            comment = choose.choice(["", "", f"\t/WORD {number}"])
            if choose.random() < 0.4:
                address = choose.choice([f".+{number % 4}", "K1", "K2", f"{choose.randrange(0o200):o}"])
                text.append(f"\t{choose.choice(REFERENCES)} {address}{comment}")
            else:
                text.append(f"\t{choose.choice(OPERATIONS)}{comment}")
        page += 1
    return "\n".join(text + ["\t0"] * (lines - 1 - len(text)) + ["$"]) + "\n"


def seconds(work: Callable[[], object]) -> float:
    """Return how long `work` takes."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def main() -> None:
    """Run the benchmark and print its table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--lines", type=int, default=20_000)
    parser.add_argument("--rounds", type=int, default=7)
    options = parser.parse_args()
    text = source(options.lines).encode()
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "big.pal").write_bytes(text)
        ours = [sys.executable, "-m", "pal.cli", "big.pal", "-o", "ours.bin", "--listing", "ours.lst"]
        contenders = {"pal, whole process": ours}
        if shutil.which("palbart"):
            contenders["palbart -e, whole process"] = ["palbart", "-e", "big.pal"]
        times: dict[str, list[float]] = {name: [] for name in (*contenders, "pal.assemble, warm")}
        for _ in range(options.rounds):
            for name, command in contenders.items():
                run = lambda: subprocess.run(command, cwd=folder, check=True, capture_output=True)  # noqa: B023, E731
                times[name].append(seconds(run))
            times["pal.assemble, warm"].append(seconds(lambda: pal.assemble(text)))
    for name, found in times.items():
        print(f"{name:28} {min(found) * 1000:8.1f} ms {options.lines / min(found):12,.0f} lines/s")


if __name__ == "__main__":
    main()
