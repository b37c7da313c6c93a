"""Assemble a generated source of 20,000 lines with pal and with palbart, and say how fast each is.

    .venv/bin/python benchmarks/assemble.py [--lines 20000] [--rounds 7]

The processor time of whole processes, from start to exit, user and system, each writing tape and listing,
in turn, the least of so many rounds; warm is `pal.assemble` alone, passes 1 and 2, in a process that has
assembled before. The source is the same on every run.
"""

import argparse
import random
import resource
import shutil
import subprocess
import sys
import tempfile
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
    """Return the processor time that `work` takes, that of its child processes included."""
    start = _processor_time()
    work()
    return _processor_time() - start


def _processor_time() -> float:
    spent = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(usage.ru_utime + usage.ru_stime for usage in spent)


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
        started = [sys.executable, "-c", "from pdp8.cli import pal; pal()"]
        ours = [*started, "big.pal", "-o", "ours.bin", "--listing", "ours.lst"]
        contenders = {"pal, whole process": ours, "PAL8, whole process": [*ours, "--dialect", "pal8"]}
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
