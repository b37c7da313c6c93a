"""What else the words of the conversion program's lost page may be: variants.c tries every one.

`python -m tests.reference.variants`, part of `make evidence`, writes pdp8/thesis/scan/variants.txt.
"""

import subprocess
import tempfile
from collections import defaultdict
from pathlib import Path

import pal
from pdp8.thesis.evidence import source, table
from tests.reference.compiling import compile_c

FILE = Path(__file__).parents[2] / "pdp8" / "thesis" / "scan" / "variants.txt"
_HEADING = """\
# Words of page 106, which is lost; how many other words would do the same work, one at a time; and which of
# these are the same instruction with another of the program's own names. By tests/reference/variants.c.
"""
_MEMORY_REFERENCES = ("AND", "TAD", "ISZ", "DCA", "JMS", "JMP")


def lines() -> str:
    """Return the file: address, count, statements, for each word that is not shown."""
    assembly = pal.assemble(source("eia.pal"))
    found: dict[int, list[int]] = defaultdict(list)
    for line in _tried(assembly.words).splitlines():
        place, word = (int(digits, 8) for digits in line.split())
        found[place].append(word)
    names = {address: name for name, address in assembly.symbols.items() if name[0].isalpha()}
    lost = (int(row.ours[:4], 8) for row in table("eia.pal") if row.page == "106")
    text = _HEADING
    for address in lost:
        named = ", ".join(_named(found[address], assembly.words[address], names))
        text += f"{address:04o} | {len(found[address])} | {named}".rstrip() + "\n"
    return text


def _tried(words: dict[int, int]) -> str:
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "variants")
        compile_c(program, Path(__file__).with_name("variants.c"))
        given = "".join(f"{address:04o} {word:04o}\n" for address, word in words.items())
        return subprocess.run([program], input=given, check=True, capture_output=True, text=True).stdout


def _named(words: list[int], ours: int, names: dict[int, str]) -> list[str]:
    """Return those of the words that are our instruction with another name of the program."""
    return [
        f"{_MEMORY_REFERENCES[word >> 9]} {names[operand]}"
        for word in words
        if word < 0o6000 and not word & 0o400 and word >> 9 == ours >> 9
        for operand in [(0o200 if word & 0o200 else 0) | word & 0o177]
        if operand in names
    ]


if __name__ == "__main__":
    FILE.write_text(lines())
