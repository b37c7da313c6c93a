"""Random sources in the language that PAL III and palbart share: the same frames, first origin to checksum.

palbart (Debian's, by Gary A. Messenbrink) is an assembler of its own, for PAL8's dialect. What the dialects
do not share is left out: the floating-point names, references beyond the page, Z with another address than
one on page zero, digits 8 and 9 in octal, spaces beside an operator or before one (palbart does what follows
the space first), FIELD (palbart goes to 0200), redefinition, undefined symbols. Its leader and trailer have
other lengths.
"""

from pathlib import Path

import pytest

import pal
from tests.pal import random_pal8
from tests.pal.random_pal8 import PALBART, REFERENCES, palbarts

GROUP_1 = ["CLA", "CLL", "CMA", "CML", "RAL", "IAC", "7000"]
GROUP_2 = ["SMA", "SZA", "SNL", "CLA", "OSR", "HLT"]
IN_OUT = ["ION", "IOF", "KSF", "KCC", "KRS", "KRB", "TSF", "TCF", "TPC", "TLS", "RSF", "RRB", "PSF", "PLS"]


class Author(random_pal8.Author):
    """Writes a source: constants first, then pages, each of them with tags that its instructions refer to."""

    def __init__(self, seed: int) -> None:
        super().__init__(seed)
        self.names = [self.name("K", number) for number in range(12)]
        self.count = 0

    def name(self, letter: str, number: int) -> str:
        return letter + self.pick(*"ABX9") + str(number) + self.pick("", "LONGER", "Z")

    def source(self) -> str:
        lines = [f"{name}={self.number(0o10000)}" for name in self.names]
        for _ in range(6):
            self.tags = []
            origin = f"*{(self.random.randrange(1, 0o37) << 7) + self.random.randrange(0o20):o}"
            lines += [origin] * self.random.choice([1, 1, 2])
            left = self.random.randrange(4, 0o60)
            while left > 0:
                statements = min(left, self.random.choice([1, 1, 1, 3]))
                left -= statements
                lines.append(self.tagged(statements))
        return "\n".join([*lines, "$"]) + "\n"

    def tagged(self, statements: int) -> str:
        tag = ""
        if self.random.random() < 0.3:
            self.count += 1
            self.tags.append(self.name("T", self.count))
            tag = self.tags[-1] + ","
        words = [self.pick(self.reference, self.reference, self.operate, self.sum) for _ in range(statements)]
        return f"{tag}\t{'; '.join(words)}" + self.pick("", "", "\t/SAYS $ AND ;", "/")

    def reference(self) -> str:
        how = self.pick("", "", "I ")
        on_page_zero = f"{how}{self.pick('', 'Z ')}{self.number(0o200)}"
        here = [f"{how}.+{self.number(4)}", *(how + self.pick(*self.tags) for _ in self.tags[:1])]
        return f"{self.pick(*REFERENCES)} {self.pick(on_page_zero, *here)}"

    def operate(self) -> str:
        group = self.random.choice([GROUP_1, GROUP_2, IN_OUT])
        return " ".join(self.random.sample(group, self.random.randrange(1, 4)))

    def sum(self) -> str:
        items = [self.item() for _ in range(self.random.randrange(1, 5))]
        operators = sorted((self.pick(*"+- ") for _ in items), key=" ".__eq__)
        text = "".join(item + operator for item, operator in zip(items, operators, strict=True))
        return self.pick("", "", "-") + text[:-1]

    def item(self) -> str:
        number = self.number(0o10000)
        return self.pick(number, number, self.pick(*self.names), ".")


@pytest.mark.skipif(PALBART is None, reason="palbart is not installed")
@pytest.mark.parametrize("seed", range(40))
def test_palbart_punches_the_same_frames(seed: int, tmp_path: Path) -> None:
    source = Author(seed).source()
    assembly = pal.assemble(source)
    assert assembly.ok, [str(diagnostic) for diagnostic in assembly.diagnostics]
    tape, said = palbarts(source, tmp_path, "-e")
    assert said == ""
    assert assembly.tape.lstrip(b"\0").strip(b"\x80") == tape
