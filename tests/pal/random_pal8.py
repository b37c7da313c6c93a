"""Random sources in PAL8: what palbart takes, and now and then what it does not.

python -m tests.pal.random_pal8 5000     compares so many with palbart; prints the first that differ
"""

import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import pal

PALBART = shutil.which("palbart")
REFERENCES = ["AND", "TAD", "ISZ", "DCA", "JMS", "JMP"]
OPERATES = ["CLA", "CLL CMA", "RAL", "SZA CLA", "HLT", "IAC;RTL", "KSF", "TLS", "CDF 10", "NOP", "SPA SNA"]
CHARACTERS = "ABCXYZ0189 .;$,+-*=()[]<&!?@#"
INSIDE = ["5", "\n\tTAD (7\n", "CLA;HLT", "IFDEF K1 <6>", "\n\tIFNDEF K2 <\n8>\n1\n", ""]


class Author:
    """Writes a source of a few pages, with every construct of the dialect."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.names = [f"K{number}" for number in range(5)] + ["LONGERNAME", "X1"]
        self.tags: list[str] = []
        self.decimal = False

    def pick(self, *options: str | Callable[[], str]) -> str:
        """Return one of the options, or what one writes."""
        option = self.random.choice(options)
        return option if isinstance(option, str) else option()

    def number(self, *limits: int) -> str:
        number = self.random.randrange(*limits)
        return f"{number:d}" if self.decimal else f"{number:o}"

    def source(self) -> str:
        lines = ["FIXMRI OWN=4000", *(f"{name}={self.number(1, 0o300)}" for name in self.names)]
        count = self.random.randrange(3, 9)
        self.coming = [f"T{number}" for number in range(count * 3)]
        for _ in range(count):
            lines.append(self.begin())
            lines += [self.line() for _ in range(self.random.randrange(1, 12))]
        lines += ["DECIMAL;OCTAL", *(f"{tag},\t0" for tag in self.coming)]
        return "\n".join([*lines, self.pick("$", "$", "$JUNK (", "")]) + "\n"

    def begin(self) -> str:
        page = self.random.choice([1, self.random.randrange(1, 0o37)]) << 7
        origin = "*" + self.number(page, page + 0o60)
        field, relocated = f"FIELD {self.random.randrange(4)}", self.pick("400", ".+200", "1000", "")
        pages = ["PAGE"] * 3 + [f"PAGE {self.random.randrange(-1, 7)}"] * 2
        return self.pick(*[origin] * 8, *pages, field, f"RELOC {relocated}", self.pick("NOPUNCH", "ENPUNCH"))

    def line(self) -> str:
        statements = [self.statement() for _ in range(self.random.choice([1, 1, 1, 1, 2]))]
        tag = ""
        if self.coming and self.random.random() < 0.2:
            self.tags.append(self.coming.pop(0))
            tag = self.tags[-1] + self.pick(",", ", ", ",\t")
        return f"{tag}\t" + ";".join(statements) + self.pick("", "", "", " ", "\t/A <;$> COMMENT")

    def statement(self) -> str:
        usual = [self.reference] * 9 + [lambda: self.pick(*OPERATES)] * 4 + [self.expression] * 3
        return self.pick(*usual, self.condition, self.condition, self.text, self.assign, self.pseudo)

    def reference(self) -> str:
        how = self.pick("", "", "", "I ", "Z ")
        near = how == "I " and self.random.random() < 0.98
        place = ("." if self.decimal else self.number(0o200)) if near else self.address()
        return f"{self.pick(*REFERENCES, 'OWN')} {how}{place}"

    def address(self) -> str:
        named = self.pick(*self.tags, *self.coming[:4], *self.names) + self.pick("", "", "+1", "-1")
        here = "." + self.pick("", "+1", "+2", "-1", "+K1")
        return self.pick(self.literal, self.literal, named, named, here, self.expression)

    def literal(self) -> str:
        opening = self.pick(*"((((", "[")
        reference = f"{self.pick(*REFERENCES)} {self.pick('', 'I ')}{self.item()}"
        operate = self.pick("CLA CLL", "CMA", "JMP I 20", "SZA")
        inside = self.pick(self.expression, self.expression, reference, operate)
        return opening + inside + self.pick("", ")" if opening == "(" else "]")

    def item(self) -> str:
        number = self.number(self.random.choice([10, 0o10000]))
        return self.pick(*[number] * 3, self.pick(*self.names, *self.tags), ".", '"' + self.pick(*CHARACTERS))

    def expression(self) -> str:
        text = self.pick("", "", "", "-") + self.item()
        for _ in range(self.random.choice([0, 0, 0, 1, 1, 2, 3])):
            text += self.pick(*"+-+-!&^") + self.item()
        if self.random.random() < 0.05:
            text += f"%{self.random.randrange(1, 8)}"
        return text + (" " + self.item() if self.random.random() < 0.1 else "")

    def condition(self) -> str:
        name, known = self.pick(*self.names), self.pick(*self.names, "NONAME", *self.tags)
        what = self.pick(
            f"IFDEF {self.pick(known, *self.coming[:2])}",
            *(f"IFNDEF {known}", f"IFZERO {name}-{self.random.randrange(3)}", f"IFNZRO {name}&1"),
        )
        return f"{what} <{self.pick(*INSIDE)}>" + self.pick("", ";HLT", "\n")

    def text(self) -> str:
        text = "".join(self.random.choice(CHARACTERS + "\t") for _ in range(self.random.randrange(7)))
        decimals = self.random.randrange(6)
        return self.pick(
            *(f"TEXT /{text}/", f'TEXT "{text}"', "TEXT %AB%", f"ASCII /{text}/", "ZBLOCK 3"),
            *("DEVICE SYS", "FILENAME PIP.SV", "FILENAME LONGERNAME", "FILENAME A.SAVE"),
            f"DUBL;{self.random.randrange(1 << 23)};-{self.random.randrange(1 << 23)}",
            f"FLTG;{self.random.randrange(1, 10**6) / 10**decimals:f};-7;NOP",
        )

    def assign(self) -> str:
        name = self.pick(*self.names, "N1")
        if name not in self.names:
            self.names.append(name)
        return f"{name}={self.expression()}"

    def pseudo(self) -> str:
        pick = self.pick("DECIMAL", "OCTAL", "XLIST", "PAUSE", "FIXTAB", "EJECT A")
        self.decimal = pick == "DECIMAL" or (self.decimal and pick != "OCTAL")
        return pick


def palbarts(source: str, folder: Path, *options: str) -> tuple[bytes, str]:
    """Return the tape that palbart makes, without leader and trailer, and its messages."""
    for path in folder.iterdir():
        path.unlink()
    (folder / "x.pal").write_text(source)
    command = [str(PALBART), *options, "x.pal"]
    done = subprocess.run(command, cwd=folder, capture_output=True, check=False, timeout=10)
    if done.returncode < 0:
        return b"", "crashed"
    errors = folder / "x.err"
    said = errors.read_text() if errors.exists() else ""
    return (folder / "x.bin").read_bytes().strip(b"\x80"), said if done.returncode else ""


def compare(source: str, folder: Path) -> str:
    """Return what is different between palbart and ours, "" if nothing is."""
    tape, said = palbarts(source, folder, "-$")
    assembly = pal.assemble(source, dialect="pal8")
    errors = [str(diagnostic) for diagnostic in assembly.diagnostics if diagnostic.error]
    if said:
        return "" if errors else f"palbart refuses it: {said}"
    if errors:
        return f"ours alone refuses it: {errors[0]}"
    ours = assembly.tape.strip(b"\x80")
    differ = [number for number, (our, their) in enumerate(zip(ours, tape, strict=False)) if our != their]
    return f"frame {[*differ, min(len(ours), len(tape))][0]}" if ours != tape else ""


def main(count: int) -> int:
    """Compare `count` sources; return how many differ."""
    sources = [Author(seed).source() for seed in range(count)]
    with tempfile.TemporaryDirectory() as folder:
        found = [compare(source, Path(folder)) for source in sources]
    wrong = [seed for seed in range(count) if found[seed]]
    for seed in wrong[:3]:
        print(f"seed {seed}: {found[seed]}\n{sources[seed]}")
    clean = sum(pal.assemble(source, dialect="pal8").ok for source in sources)
    print(f"{count} sources, {clean} without errors, {len(wrong)} differ")
    return len(wrong)


if __name__ == "__main__":
    sys.exit(bool(main(int(sys.argv[1]))))
