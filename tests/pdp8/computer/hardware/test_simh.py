"""Lockstep with SIMH's PDP-8, an 8/E: random programs, every register and all of core compared.

A program is 4096 random words. We run it instruction by instruction; a word that an 8/E and an 8/L do not
share is replaced on both sides the moment it would be executed, and so is one that has been executed often
enough, so that every run goes somewhere new.
"""

import os
import random
import re
import subprocess
from array import array
from pathlib import Path

import pytest

from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.processor import Processor
from tapes import binary

SIMH = next((path for path in ("/usr/bin/pdp8", "/usr/local/bin/simh-pdp8") if os.path.exists(path)), "")
PROGRAMS = 200
INSTRUCTIONS = 1000
OFTEN = 12


def shared(word: int) -> bool:
    """Tell whether `word` means the same on an 8/E, SIMH's machine, and on an 8/L."""
    return not any(
        (
            word >> 9 == 6,  # IOT: SIMH has other times, 8/E instructions at 600x, memory extension at 62xx
            word & 0o7400 == 0o7000 and word & 0o14 == 0o14,  # both rotates: AND of the two on an 8/L
            word & 0o7416 == 0o7002,  # bit 10 alone: byte swap on an 8/E, nothing on an 8/L
            word & 0o7401 == 0o7401,  # group 3: an 8/E has an MQ, an 8/L nothing, not even the CLA
            word & 0o7403 == 0o7402,  # HLT would end the run
        )
    )


def random_word(source: random.Random) -> int:
    """Return a word both machines share; more OPR than chance would have, or AC is mostly 0."""
    while True:
        word = source.randrange(0o7000, 0o10000) if source.random() < 0.3 else source.randrange(0o10000)
        if shared(word):
            return word


def script(seed: int, folder: Path) -> tuple[list[str], list[str]]:
    """Return the commands for SIMH, and the output expected of it, for one program."""
    source = random.Random(seed)
    processor = Processor(Bus())
    processor.core[:] = array("H", [source.randrange(0o10000) for _ in range(0o10000)])
    processor.pc, processor.lac, processor.sr = (source.randrange(n) for n in (0o10000, 0o20000, 0o10000))
    tape = folder / f"{seed}.bin"
    tape.write_bytes(binary.encode(dict(enumerate(processor.core))))
    link, ac = divmod(processor.lac, 0o10000)
    lines = [
        f"load {tape}",
        f"d pc {processor.pc:o}",
        f"d l {link:o}",
        f"d ac {ac:o}",
        f"d sr {processor.sr:o}",
    ]
    expected: list[str] = []
    executions = [0] * 0o10000
    steps = 0

    def compare() -> None:
        lines.extend([f"step {steps}", "ex pc,l,ac"] if steps else [])
        link, ac = divmod(processor.lac, 0o10000)
        expected.extend([f"PC:\t{processor.pc:05o}", f"L:\t{link:o}", f"AC:\t{ac:04o}"] if steps else [])

    for _ in range(INSTRUCTIONS):
        pc = processor.pc
        executions[pc] += 1
        if not shared(processor.core[pc]) or executions[pc] > OFTEN:
            compare()
            steps = executions[pc] = 0
            processor.core[pc] = random_word(source)
            lines.append(f"d {pc:o} {processor.core[pc]:o}")
        processor.instruction()
        steps += 1
    compare()
    words = [f"{address:o}:\t{word:04o}" for address, word in enumerate(processor.core)]
    return [*lines, "ex 0-7777"], expected + words


@pytest.mark.skipif(not SIMH, reason="SIMH is not installed")
def test_random_programs_in_lockstep(tmp_path: Path) -> None:
    scripts = [script(seed, tmp_path) for seed in range(PROGRAMS)]
    commands = tmp_path / "lockstep.simh"
    lines = [line for given, _ in scripts for line in given]
    commands.write_text("\n".join(["set cpu 4k", "set cpu noeae", *lines, "exit", ""]))
    ran = subprocess.run([SIMH, str(commands)], capture_output=True, text=True, check=True, timeout=120)
    if "PDP-8 simulator" not in ran.stdout:
        pytest.skip(f"{SIMH} is not SIMH")
    said = re.findall(r"^(?:PC|L|AC|[0-7]+):\t[0-7]+$", ran.stdout, re.MULTILINE)
    expected = [(seed, line) for seed, (_, ours) in enumerate(scripts) for line in ours]
    for (seed, ours), theirs in zip(expected, said, strict=False):
        assert ours == theirs, f"program {seed}: ours {ours!r}, SIMH's {theirs!r}"
    assert len(said) == len(expected)
