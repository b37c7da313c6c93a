"""Random sources in PAL8: what palbart takes, and now and then what it does not.

python -m tests.pal.random_pal8 5000     compares so many with palbart; prints the first that differ
"""

import random
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import pal

PALBART = shutil.which("palbart")
REFERENCES = ["AND", "TAD", "ISZ", "DCA", "JMS", "JMP"]
OPERATES = ["CLA", "CLL CMA", "RAL", "SZA CLA", "HLT", "IAC;RTL", "KSF", "TLS", "CDF 10", "NOP", "SPA SNA"]
CHARACTERS = "ABCXYZ0189 .;$,+-*=()[]<&!?@#"


class Author:
    """Writes a source of a few pages, with every construct of the dialect."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.names = [f"K{number}" for number in range(5)] + ["LONGERNAME", "X1"]
        self.tags: list[str] = []
        self.decimal = False

    def source(self) -> str:
        lines = ["FIXMRI OWN=4000", *(f"{name}={self.random.randrange(1, 0o300):o}" for name in self.names)]
        count = self.random.randrange(3, 9)
        self.coming = [f"T{number}" for number in range(count * 3)]
        for _ in range(count):
            lines += self.part()
        lines += ["DECIMAL;OCTAL", *(f"{tag},\t0" for tag in self.coming)]
        return "\n".join([*lines, self.random.choice(["$", "$", "$JUNK (", ""])]) + "\n"

    def part(self) -> list[str]:
        lines = [self.begin()]
        for _ in range(self.random.randrange(1, 12)):
            statements = [self.statement() for _ in range(self.random.choice([1, 1, 1, 1, 2]))]
            tag = ""
            if self.coming and self.random.random() < 0.2:
                tag = self.coming.pop(0) + self.random.choice([",", ", ", ",\t"])
                self.tags.append(tag.rstrip(", \t"))
            lines.append(
                f"{tag}\t" + ";".join(statements) + self.random.choice(["", "", "", " ", "\t/A <;$> COMMENT"])
            )
        return lines

    def begin(self) -> str:
        pick = self.random.random()
        if pick < 0.5:
            origin = self.random.choice([1, self.random.randrange(1, 0o37)]) << 7 | self.random.randrange(
                0o60
            )
            return f"*{origin:d}" if self.decimal else f"*{origin:o}"
        if pick < 0.7:
            return "PAGE"
        if pick < 0.8:
            return f"PAGE {self.random.randrange(7)}"
        if pick < 0.88:
            return f"FIELD {self.random.randrange(4)}"
        if pick < 0.94:
            return f"RELOC {self.random.choice(['400', '.+200', '1000', ''])}"
        return self.random.choice(["NOPUNCH", "ENPUNCH"])

    def statement(self) -> str:
        kinds = [self.reference] * 9 + [self.operate] * 4 + [self.expression] * 3
        kinds += [self.condition, self.condition, self.text, self.assign, self.pseudo]
        return self.random.choice(kinds)()

    def reference(self) -> str:
        name = self.random.choice([*REFERENCES, "OWN"])
        how = self.random.choice(["", "", "", "I ", "Z "])
        near = f"{self.random.randrange(0o200):o}" if not self.decimal else "."
        return f"{name} {how}{near if how == 'I ' and self.random.random() < 0.98 else self.address()}"

    def address(self) -> str:
        pick = self.random.random()
        if pick < 0.35:
            opening = self.random.choice("(((([")
            inside = self.random.choice(
                [self.expression, self.expression, self.reference_inside, self.operate_inside]
            )()
            closing = self.random.choice(["", ")" if opening == "(" else "]"])
            return opening + inside + closing
        if pick < 0.6:
            return self.random.choice(self.tags + self.coming[:4] + self.names) + self.random.choice(
                ["", "", "+1", "-1"]
            )
        if pick < 0.8:
            return "." + self.random.choice(["", "+1", "+2", "-1", "+K1"])
        return self.expression()

    def reference_inside(self) -> str:
        return f"{self.random.choice(REFERENCES)} {self.random.choice(['', 'I '])}{self.item()}"

    def operate_inside(self) -> str:
        return self.random.choice(["CLA CLL", "CMA", "JMP I 20", "SZA"])

    def operate(self) -> str:
        return self.random.choice(OPERATES)

    def item(self) -> str:
        number = self.random.choice([self.random.randrange(10), self.random.randrange(0o10000)])
        text = f"{number:d}" if self.decimal else f"{number:o}"
        character = '"' + self.random.choice(CHARACTERS)
        return self.random.choice(
            [text, text, text, self.random.choice(self.names + self.tags), ".", character]
        )

    def expression(self) -> str:
        text = self.random.choice(["", "", "", "-"]) + self.item()
        for _ in range(self.random.choice([0, 0, 0, 1, 1, 2, 3])):
            text += self.random.choice("+-+-!&^") + self.item()
        if self.random.random() < 0.05:
            text += f"%{self.random.randrange(1, 8)}"
        if self.random.random() < 0.1:
            text += " " + self.item()
        return text

    def condition(self) -> str:
        what = self.random.choice(
            [
                f"IFDEF {self.random.choice([*self.names, 'NONAME', *self.tags, *self.coming[:2]])}",
                f"IFNDEF {self.random.choice([*self.names, 'NONAME', *self.tags])}",
                f"IFZERO {self.random.choice(self.names)}-{self.random.randrange(3)}",
                f"IFNZRO {self.random.choice(self.names)}&1",
            ]
        )
        inside = self.random.choice(
            ["5", "\n\tTAD (7\n", "CLA;HLT", "IFDEF K1 <6>", "\n\tIFNDEF K2 <\n8>\n1\n", ""]
        )
        return f"{what} <{inside}>" + self.random.choice(["", ";HLT", "\n"])

    def text(self) -> str:
        text = "".join(self.random.choice(CHARACTERS + "\t") for _ in range(self.random.randrange(7)))
        return self.random.choice(
            [
                *(f"TEXT /{text}/", f'TEXT "{text}"', "TEXT %AB%", f"ASCII /{text}/", "ZBLOCK 3"),
                *("DEVICE SYS", "FILENAME PIP.SV", "FILENAME LONGERNAME", "FILENAME A.SAVE"),
                f"DUBL;{self.random.randrange(1 << 23)};-{self.random.randrange(1 << 23)}",
                f"FLTG;{self.random.randrange(1, 10**6) / 10 ** self.random.randrange(6):f};-7;NOP",
            ]
        )

    def assign(self) -> str:
        name = self.random.choice([*self.names, "N1"])
        if name == "N1" and name not in self.names:
            self.names.append(name)
        return f"{name}={self.expression()}"

    def pseudo(self) -> str:
        pick = self.random.choice(["DECIMAL", "OCTAL", "XLIST", "PAUSE", "FIXTAB", "EJECT A"])
        if pick in ("DECIMAL", "OCTAL"):
            self.decimal = pick == "DECIMAL"
        return pick


def palbarts(source: str, folder: Path) -> tuple[bytes, str]:
    """Return the tape that palbart makes, without leader and trailer, and its messages."""
    for path in folder.iterdir():
        path.unlink()
    (folder / "x.pal").write_text(source)
    done = subprocess.run(
        [str(PALBART), "-$", "x.pal"], cwd=folder, capture_output=True, check=False, timeout=10
    )
    if done.returncode < 0:
        return b"", "crashed"
    errors = folder / "x.err"
    said = errors.read_text() if errors.exists() else ""
    return (folder / "x.bin").read_bytes().strip(b"\x80"), said if done.returncode else ""


def compare(source: str, folder: Path) -> str:
    """Return what is different between palbart and ours, "" if nothing is."""
    tape, said = palbarts(source, folder)
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
    wrong = clean = 0
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(count):
            source = Author(seed).source()
            found = compare(source, Path(folder))
            clean += pal.assemble(source, dialect="pal8").ok
            if found:
                wrong += 1
                if wrong <= 3:
                    print(f"seed {seed}: {found}\n{source}")
    print(f"{count} sources, {clean} without errors, {wrong} differ")
    return wrong


if __name__ == "__main__":
    sys.exit(bool(main(int(sys.argv[1]))))
