"""The register of what docs, page and story claim: each sentence with the test that holds it, and its bounds.

claims.txt has first the tests, then a line for each sentence that says "no", "none", "only", "proved",
"cannot", "first", "exactly", "lost", "equal", or a figure:

    @ name | what is run: tests, or nothing | bounds | the same with wider bounds => what it then prints
    == docs/nc.md thesis              a file; with `thesis`, only sentences that name it or its author
    name, name | 1a2b3c | The sentence's first words

The middle is the sentence's checksum: a changed sentence has no entry, and is judged again. A test that runs
nothing counts as untested. `python -m tests.claims.register missing` prints lines to fill in.
"""

import ast
import re
import subprocess
import sys
import zlib
from pathlib import Path
from typing import Final, NamedTuple

ROOT: Final = Path(__file__).parents[2]
REGISTER: Final = Path(__file__).with_name("claims.txt")

_CLAIM = re.compile(r"\b(no|none|only|proved|cannot|first|exactly|lost|equal)\b|\d", re.IGNORECASE)
_THESIS = re.compile(r"thesis|Wong|Chapter \d|Appendi|Table \d|Figure \d|Talyrond|listing")
_NOT_SAID = re.compile(r"`[^`]*`|\]\([^)]*\)")
_SENTENCE = re.compile(r"(?<=[.!?:])\s+(?=[A-Z\"*`(“])")


class Held(NamedTuple):
    """A test: what it runs, within which bounds, and the same wider with what that prints."""

    run: list[str]
    bounds: str
    wider: str
    prints: str


class Register(NamedTuple):
    """The tests by name; and by file its sentences' checksums with the names of their tests."""

    tests: dict[str, Held]
    files: dict[str, dict[str, list[str]]]


def load() -> Register:
    register, entries = Register({}, {}), dict[str, list[str]]()
    for line in REGISTER.read_text().splitlines():
        if line.startswith("@"):
            name, run, bounds, wider = (cell.strip() for cell in line[1:].split("|"))
            register.tests[name] = Held(run.split(), bounds, *wider.partition(" => ")[::2])
        elif line.startswith("=="):
            entries = register.files.setdefault(line[2:].strip(), {})
        elif line and not line.startswith("#"):
            names, checksum, _ = line.split(" | ", 2)
            entries[checksum] = names.split(", ")
    return register


def _paragraphs(path: Path) -> list[str]:
    """Return a file's paragraphs, table rows and items, without headings, consoles and generated tables."""
    text = path.read_text()
    if path.suffix == ".py":
        constants = (node.value for node in ast.walk(ast.parse(text)) if isinstance(node, ast.Constant))
        return [each for each in constants if isinstance(each, str)]
    if path.suffix == ".html":
        text = re.sub(r"<figure.*?</figure>", "", text, flags=re.DOTALL)
        text = re.sub(r"</?(p|h\d|summary|details|footer)\b[^>]*>", "\n\n", text)
        text = re.sub(r"<[^>]+>", "", text)
    text = re.sub(r"```.*?```|<!-- [^\n]* -->\n\|.*?\n(?=<!-- end -->|\n)", "", text, flags=re.DOTALL)
    found = [" ".join(each.split()) for each in re.split(r"\n\s*\n|\n(?=\||- |\d\. |<!--)", text)]
    return [each for each in found if each and each[0] != "#" and not set(each) <= set("|-: ")]


def claims(file: str) -> dict[str, str]:
    """Return the sentences of a file of the register that claim something, by their checksums."""
    name, _, only = file.partition(" ")
    said = [
        one
        for each in _paragraphs(ROOT / name)
        for one in ([each] if each.startswith("|") else _SENTENCE.split(each))
        if one.count(" ") > 2
    ]
    return {
        f"{zlib.crc32(sentence.encode()):08x}"[:6]: sentence
        for sentence in said
        if _CLAIM.search(_NOT_SAID.sub("", sentence)) and (not only or _THESIS.search(sentence))
    }


def missing(register: Register) -> list[str]:
    """Return a line to fill in for each sentence that has no entry, under its file."""
    lines = []
    for file, entries in register.files.items():
        new = [f"? | {key} | {words[:90]}" for key, words in claims(file).items() if key not in entries]
        lines += [f"== {file}", *new] if new else []
    return lines


def main() -> int:
    """Run every test of the register, then the wider ones; return 1 if one fails."""
    register = load()
    entries = [names for each in register.files.values() for names in each.values()]
    tested = [names for names in entries if any(register.tests[name].run for name in names)]
    print(f"{len(entries)} sentences, {len(tested)} of them held by {len(register.tests)} tests", flush=True)
    run = sorted({file for each in register.tests.values() for file in each.run})
    failed = subprocess.run([sys.executable, "-m", "pytest", "-q", *run], cwd=ROOT, check=False).returncode
    for name, held in register.tests.items():
        if held.wider:
            done = subprocess.run(held.wider.split(), cwd=ROOT, capture_output=True, text=True, check=False)
            now = done.stdout.strip()
            failed |= now != held.prints
            print(f"{name}, wider: {held.wider}: {now}{'' if now == held.prints else f'; was {held.prints}'}")
    return int(bool(failed))


if __name__ == "__main__":
    if sys.argv[1:] == ["missing"]:
        print("\n".join(missing(load())))
    else:
        sys.exit(main())
