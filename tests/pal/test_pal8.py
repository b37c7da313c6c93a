"""PAL8 beside three judges: DEC's own assembler on 113 small sources, a model of it, and palbart on 100 more.

dec8.json has {name: [source, words, messages]}: what PAL8 V10D under OS/8 makes and types. pal8.json has
{name: [source, words]}: what palbart 2.13 makes, where DEC's was seen to make the same without a message.
"""

import json
import re
from pathlib import Path

import pytest

import pal
from pal.assembler import TELETYPE_SYMBOLS
from pal.assembly import Assembly
from tapes import binary
from tests.conftest import case
from tests.pal.random_pal8 import PAL8, SEEDS, faulty, written
from tests.reference import pal8 as model

FOLDER = Path(__file__).parent
DECS: dict[str, list[str]] = json.loads((FOLDER / "dec8.json").read_text())
PALBARTS: dict[str, list[str]] = json.loads((FOLDER / "pal8.json").read_text())


def core(words: str) -> dict[int, int]:
    """Return {address: word} of a text such as `00200: 1377 0005*3 00377: 0005`."""
    loaded: dict[int, int] = {}
    for run in re.findall(r"(\d+):((?: \d{4}(?:\*\d+)?\b(?!:))+)", words):
        many = [word.partition("*") for word in run[1].split()]
        loaded |= enumerate((int(w, 8) for w, _, n in many for _ in range(int(n or 1))), int(run[0], 8))
    return loaded


def made(source: str | bytes, wipe: bool = False, exact: bool = False) -> Assembly:
    return pal.assemble(source, dialect="pal8", wipe=wipe, exact=exact)


def octal(words: dict[int, int]) -> str:
    return " ".join(f"{address:05o}:{word:04o}" for address, word in sorted(words.items()))


def errors(assembly: Assembly) -> list[str]:
    return [found.code for found in assembly.diagnostics if found.error]


def test_decs_examples_have_decs_words_and_messages() -> None:
    for name, (source, words, messages) in DECS.items():
        with case(name):
            assembly = made(source, exact=True)
            assert octal(assembly.words) == octal(core(words))
            assert "; ".join(assembly.messages).replace("  ", " ") == messages
            assert bool(assembly.stopped) == (words == "NO TAPE")


def test_decs_reading_has_no_colon_and_a_text_without_a_blank() -> None:
    assert made("*200\nA:\tCLA\n$\n").symbols == {"A": 0o200}
    assert made("*200\nA:\tCLA\n$\n", exact=True).symbols == {}
    for mark, words in (("'", {0o200: 0o0102, 0o201: 0}), ("/", {0o200: 0})):
        assert made(f"*200\n\tTEXT{mark}AB{mark}\n$\n", exact=True).words == words


def test_what_is_no_ascii_is_illegal_in_decs_reading_too() -> None:
    for character in "²é":
        with case(character):
            assert (
                made(f"*200\n{character}\n$\n", exact=True).messages
                == made("*200\n?\n$\n", exact=True).messages
            )


def test_the_model_agrees_with_decs_examples() -> None:
    for name, (source, words, messages) in DECS.items():
        with case(name):
            result = model.assemble(source)
            assert octal(model.core(result.tape) or {}) == octal(core(words))
            assert "; ".join(f"{code} {place}" for _, code, place in result.messages) == messages


def test_of_palbarts_examples_each_is_clean_and_has_its_words() -> None:
    for name, (source, words) in PALBARTS.items():
        with case(name):
            assembly = made(source.encode("latin-1"))
            assert octal(assembly.words) == octal(core(words))
            assert (errors(assembly), assembly.messages) == ([], [])
            assert binary.decode(assembly.tape).words == assembly.words
            listed = [line.source for line in assembly.lines if line.source]
            assert "$" in listed[-1]
            for mention in assembly.mentions:
                text, start, end = assembly.place(mention.at)[2:]
                assert text[start:end].upper()[:6] == mention.name
            if "PUNCH" not in source:
                assert {line.address: line.word for line in assembly.lines if line.word is not None} == (
                    assembly.words
                )


def beside(source: str, wipe: bool) -> None:
    """Compare the frames and all messages, with their passes and places, of ours and the model's."""
    try:
        result = model.assemble(source, wipe)
    except model.Wild:
        return
    assembly = made(source, wipe, exact=True)
    said = [f"{code}  {place}" for _, code, place in result.messages]
    assert assembly.messages == said
    ones = [one for one, _, _ in result.messages].count(1)
    assert assembly.text(1).splitlines() == said[:ones]
    assert (assembly.tape.strip(b"\x80") or None) == result.tape


@pytest.mark.parametrize(
    "lines", ["IFZERO 1 </ > \n\t7;<5>;6\n>", "IFZERO 1 <>/ <\n\t7\n>>", "IFZERO 1 <\n>/ <\n7\n>\n6\n>\n5"]
)
def test_a_condition_that_a_comment_ends_or_opens_is_decs(lines: str) -> None:
    beside(f"*200\nIFZERO 0 <\n{lines}\n\tHLT\n$\n", wipe=False)


def test_random_sources_are_as_in_the_model() -> None:
    """SOURCES=5000 pytest -k model tests/pal     compares so many, here 40 of each kind."""
    for seed in SEEDS:
        for source in (faulty(seed), written(PAL8, seed)):
            with case(source):
                beside(source, seed % 8 == 0)


ALLOWED = {
    "small letters": ("*200\n\ttad (5)\n\thlt\n$\n", "PN35", "00200: 1377 7402 00377: 0005"),
    "text": ("*200\n\tTEXT/AB/\n$\n", "PN44", "00200: 0102 0000"),
    "small text": ("*200\n\tTEXT /aB/\n$\n", "PN35", "00200: 4102 0000"),
    "tag": ("*200\nCLA,\t0\n\tTAD CLA\n$\n", "PN30", "00200: 0000 1200"),
    "palbart's": ("*200\n\tACL\n\tFADD 300\n$\n", "PN47 PN47", "00200: 7701 1300"),
    "palbart's as a name": ("*200\nDISK,\t0\n\tTAD DISK\n$\n", "", "00200: 0000 1200"),
    "80 characters": (f"*200\n\tCLA{' ' * 80};HLT\n$\n", "PN55", "00200: 7200 7402"),
    "a long comment": (f"*200\n\tHLT /{'A' * 80};HLT\n$\n", "", "00200: 7402"),
    "the end": ("*200\n\tHLT", "PN27", "00200: 7402"),
}
"""What goes on where DEC's does not, with the code of its note, and the words."""


def test_what_is_allowed_has_a_note() -> None:
    for name, (source, code, words) in ALLOWED.items():
        with case(name):
            assembly = made(source)
            assert octal(assembly.words) == octal(core(words))
            notes = [found.code for found in assembly.diagnostics if found.code != "PN37"]
            assert (errors(assembly), notes) == ([], code.split())


def test_overlays_need_w() -> None:
    source = "*400\n\tTAD (1\n*600\n\tHLT\n*577\n\t5\n$\n"
    assert errors(made(source)) == ["PE"]
    assert "--w" in made(source).diagnostics[0].advice
    assert errors(made(source, wipe=True)) == []
    assert made(source, wipe=True).words == {0o400: 0o1377, 0o577: 5, 0o600: 0o7402}


def test_what_ends_it() -> None:
    """A condition without its end, and too many literals within literals, however deep."""
    for source, code in (("IFDEF A <\n5\n$\n", "PH"), ("*200\n" + "(" * 20000 + "5\n$\n", "BE")):
        assembly = made(source)
        assert (errors(assembly), assembly.tape, assembly.words) == ([code], b"", {})
        assert assembly.stopped


def test_a_line_of_many_statements_ends() -> None:
    """With statements before each of which the rest of the line was read again, this took minutes."""
    for statement, count in (
        ("TEXT /A/;", 1),
        ('TEXT "A";', 1),
        ("IFZERO 1 <5>;", 0),
        ('"A;', 1),
        ("CLA;", 1),
    ):
        for dialect in ("pal8", "auto"):
            assembly = pal.assemble("*200\n" + statement * 3000 + "\n$\n", dialect=dialect)
            assert (len(assembly.words), assembly.ok) == (3000 * count, True)
    assert len(pal.assemble("*200\n" + "CLA;" * 3000 + "\n$\n").words) == 3000


def test_the_passes_type_messages() -> None:
    assembly = made("A=5\n*200\nB,UND\n#\n$\n")
    assert [assembly.text(number) for number in (1, 2)] == [
        "IC  B     +0001\nIC  B     +0001\n".replace("     ", ""),
        "US  B\nIC  B+0001\nIC  B+0001\n",
    ]
    assert assembly.text(3) == assembly.listing
    assert b"".join(assembly.teletype).count(b"\x8d\x8a") > 5


@pytest.mark.parametrize("dialect", ["pal3", "pal8"])
def test_an_assembly_has_the_same_members_in_both(dialect: str) -> None:
    assembly = pal.assemble("*200\nA,\tTAD A\n\tHLT\n$\n", dialect=dialect)
    assert (assembly.dialect, assembly.ok, assembly.stopped, assembly.messages) == (dialect, True, None, [])
    assert (assembly.symbols, assembly.values["HLT"]) == ({"A": 0o200}, 0o7402)
    assert [mention.name for mention in assembly.mentions] == ["A", "TAD", "A", "HLT"]
    assert [(line.address, line.word) for line in assembly.lines] == [
        *((None, None), (0o200, 0o1200), (0o201, 0o7402)),
        *([(None, None)] if dialect == "pal8" else []),
    ]
    assert binary.decode(assembly.tape).words == assembly.words == {0o200: 0o1200, 0o201: 0o7402}


@pytest.mark.parametrize("source", [b"\x9a", b"\x9a<", "\x1a*200\n\tTAD (5\n\tHLT\n$\n"])
def test_a_source_that_begins_with_its_end_is_not_taken_for_pal8(source: str | bytes) -> None:
    """PAL8 would read nothing of it, and say nothing."""
    for dialect in ("pal3", "auto"):
        assembly = pal.assemble(source, dialect=dialect)
        assert (assembly.dialect, assembly.ok) == ("pal3", False)
        assert assembly.messages[0] == "IC  0232  AT  0200"
        assert "PN36" not in {found.code for found in assembly.diagnostics}


def test_a_mistake_in_small_letters_is_the_one_that_is_reported() -> None:
    """In PAL III each small letter is wrong, which hides it; in a comment they say nothing of the dialect."""
    assembly = pal.assemble("*200\n\ttad fivex\n\thlt\nfive,\t5\n$\n", dialect="auto")
    errors = [(found.code, found.line) for found in assembly.diagnostics if found.error]
    assert errors == [("US", 2)]
    commented = pal.assemble("*200\n\tTAD FIVEX\t/five\n$\n", dialect="auto")
    assert commented.dialect == "pal3"


def test_zblock_makes_four_times_what_32k_of_core_has_and_no_more() -> None:
    for last, said in (("40", []), ("41", ["PS01"])):
        found = pal.assemble(
            "*0\n" + "ZBLOCK 7777\n" * 32 + f"ZBLOCK {last}\n$\n", dialect="pal8"
        ).diagnostics
        assert [each.code for each in found if each.error] == said


def test_a_source_with_pal8s_words_is_pal8s_if_it_has_no_more_errors_there() -> None:
    for line, dialect in (("\tTAD 8", "pal8"), ("\tTAD 8\n\tTAD 9", "pal3")):
        assert pal.assemble(f"*200\n\tZBLOCK 2\n{line}\n$\n", dialect="auto").dialect == dialect


def test_a_source_too_long_for_pal3s_table_is_pal8s_if_it_has_pal8s_words() -> None:
    """TSS/8's FIP without its parameters: PAL III stops in pass 1 and has seen few of the errors."""
    tags = "".join(f"A{number:o},\t0\n" for number in range(TELETYPE_SYMBOLS + 1))
    for line, dialect in (("\tIFNZRO LATER <HLT>\n" + "\tTAD LATER\n" * 9, "pal8"), ("\tTAD LATER", "pal3")):
        assert pal.assemble(f"*200\n{line}\n{tags}$\n", dialect="auto").dialect == dialect
