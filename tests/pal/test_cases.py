"""Sources that say on each line what comes of it: one feature of PAL III a file, in cases/.

    CLA; CLL        /= 0200 7200 0201 7100      the words of the line, each with its address
    ?               /! IC  0277  AT  0200       a message; several follow each other
    /TABLE A 0200 B 0201                        the symbol table

What a line does not say must not be: a line without `/=` makes no word, and one without `/!` gets no message.
"""

import re
from pathlib import Path

import pytest

import pal
from tapes import binary

CASES = sorted((Path(__file__).parent / "cases").glob("*.pal"))


def expected_words(line: str) -> list[tuple[int, int]]:
    found = re.search(r"/=((?: [0-7]{4,5} [0-7]{4})+)", line)
    numbers = [int(number, 8) for number in found[1].split()] if found else []
    return list(zip(numbers[::2], numbers[1::2], strict=True))


def expected_messages(line: str) -> list[str]:
    return [message.rstrip() for message in re.findall(r"/! ([^/]*)", line)]


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_a_source_gives_what_its_lines_say(path: Path) -> None:
    source = path.read_text()
    assembly = pal.assemble(source)
    words: dict[int, int] = {}
    for number, text in enumerate(source.splitlines(), 1):
        said = expected_words(text)
        words |= dict(said)
        statements = [line for line in assembly.lines if line.number == number and line.word is not None]
        listed = [(statement.address, statement.word) for statement in statements]
        assert listed == said, f"line {number}: {text}"
    assert (binary.decode(assembly.tape).words, assembly.words) == (words, words)
    messages = sorted(message.rstrip() for message in assembly.messages)
    assert messages == sorted(message for line in source.splitlines() for message in expected_messages(line))
    table = re.search(r"^/TABLE (.*)$", source, re.MULTILINE)
    if table:
        pairs = zip(table[1].split()[::2], table[1].split()[1::2], strict=True)
        assert assembly.symbol_table == "".join(f"{name:6}  {value}\n" for name, value in pairs)


def test_each_pass_assigns_again_so_that_tape_and_listing_may_differ() -> None:
    assembly = pal.assemble("P=Q\nQ=R\nR=3\n\tP\n$\n")
    assert "\nP       0000\nQ       0200\nR       0003\n" in assembly.text(1)
    assert assembly.words == {0o200: 0o200}
    assert "0200  0003  " in assembly.text(3)


def test_the_package_has_the_call_for_three_dialects() -> None:
    assert {"assemble", "Assembly"} <= set(dir(pal))
    with pytest.raises(ValueError, match="'pal9' is not one of auto, pal3, pal8"):
        pal.assemble("$", dialect="pal9")
