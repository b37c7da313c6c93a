"""Random sources in the language that PAL III and palbart share: the same frames, first origin to checksum.

palbart (Debian's, by Gary A. Messenbrink) is an assembler of its own, for PAL8's dialect. What the dialects
do not share is left out: the floating-point names, references beyond the page, Z with another address than
one on page zero, digits 8 and 9 in octal, spaces beside an operator or before one (palbart does what follows
the space first), FIELD (palbart goes to 0200), redefinition, undefined symbols. Its leader and trailer have
other lengths.
"""

import random
import shutil
import subprocess
from pathlib import Path

import pytest

import pal
from tapes import binary

PALBART = shutil.which("palbart")
MEMORY_REFERENCE = ["AND", "TAD", "ISZ", "DCA", "JMS", "JMP"]
GROUP_1 = ["CLA", "CLL", "CMA", "CML", "RAL", "IAC", "7000"]
GROUP_2 = ["SMA", "SZA", "SNL", "CLA", "OSR", "HLT"]
IN_OUT = ["ION", "IOF", "KSF", "KCC", "KRS", "KRB", "TSF", "TCF", "TPC", "TLS", "RSF", "RRB", "PSF", "PLS"]


class Author:
    """Writes a source: constants first, then pages, each of them with tags that its instructions refer to."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.constants = [self.name("K", number) for number in range(12)]
        self.here: list[str] = []
        self.tags = 0

    def name(self, letter: str, number: int) -> str:
        return letter + self.random.choice("ABX9") + str(number) + self.random.choice(["", "LONGER", "Z"])

    def source(self) -> str:
        lines = [f"{name}={self.number()}" for name in self.constants]
        for _ in range(6):
            lines += self.page(self.random.randrange(1, 0o37) << 7)
        return "\n".join([*lines, "$"]) + "\n"

    def page(self, origin: int) -> list[str]:
        start = origin + self.random.randrange(0o20)
        count = self.random.randrange(4, 0o60)
        self.here = []
        lines = [f"*{start:o}" for _ in range(self.random.choice([1, 1, 2]))]
        pending = count
        while pending > 0:
            statements = min(pending, self.random.choice([1, 1, 1, 3]))
            pending -= statements
            tag = ""
            if self.random.random() < 0.3:
                self.tags += 1
                self.here.append(self.name("T", self.tags))
                tag = self.here[-1] + ","
            words = "; ".join(self.word() for _ in range(statements))
            lines.append(f"{tag}\t{words}" + self.random.choice(["", "", "\t/SAYS $ AND ;", "/"]))
        return lines

    def word(self) -> str:
        return self.random.choice([self.reference, self.reference, self.operate, self.expression])()

    def reference(self) -> str:
        address = [f"{self.random.randrange(0o200):o}", f".+{self.random.randrange(4):o}"]
        if self.here:
            address.append(self.random.choice(self.here))
        how = self.random.choice(["", "", "I ", "Z ", "I Z "])
        place = self.random.choice(address)
        how = how if place.isdigit() else how.replace("Z ", "")
        return f"{self.random.choice(MEMORY_REFERENCE)} {how}{place}"

    def operate(self) -> str:
        group = self.random.choice([GROUP_1, GROUP_2, IN_OUT])
        return " ".join(self.random.sample(group, self.random.randrange(1, 4)))

    def expression(self) -> str:
        items = [self.item() for _ in range(self.random.randrange(1, 5))]
        operators = sorted((self.random.choice("+- ") for _ in items), key=" ".__eq__)
        text = "".join(item + operator for item, operator in zip(items, operators, strict=True))
        return self.random.choice(["", "", "-"]) + text[:-1]

    def item(self) -> str:
        return self.random.choice([self.number(), self.number(), self.random.choice(self.constants), "."])

    def number(self) -> str:
        return f"{self.random.randrange(0o10000):o}"


def between(tape: bytes) -> bytes:
    return tape.lstrip(b"\0").strip(b"\x80")


@pytest.mark.skipif(PALBART is None, reason="palbart is not installed")
@pytest.mark.parametrize("seed", range(40))
def test_palbart_punches_the_same_frames(seed: int, tmp_path: Path) -> None:
    source = Author(seed).source()
    (tmp_path / "random.pal").write_text(source)
    assembly = pal.assemble(source)
    assert assembly.ok, [str(diagnostic) for diagnostic in assembly.diagnostics]
    subprocess.run([str(PALBART), "-e", "random.pal"], cwd=tmp_path, check=True, capture_output=True)
    theirs = (tmp_path / "random.bin").read_bytes()
    assert binary.decode(theirs).words == assembly.words
    assert between(assembly.tape) == between(theirs)
