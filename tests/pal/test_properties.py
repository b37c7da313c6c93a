"""What holds of any source whatever."""

import re
from typing import Any

from hypothesis import example, given
from hypothesis import strategies as st

import pal
from pal.assembler import HIGH_SPEED_SYMBOLS
from pal.pal8.symbols import PSEUDO_OPERATORS
from pal.reports import as_json
from tapes import binary

CHARACTERS = "AB19 \t+-,=*;$./!a\f\n\r"
NAMES = ["A", "B", "LONGNAME", "TAD", "JMP", "CLA", "FADD", "I", "Z", "5", "189", "7777", "400", "1A", ""]
PSEUDO = ["FIELD", "FIXMRI", "EXPUNGE", "FIXTAB", "DECIMAL", "OCTAL", "PAUSE", "DECIMAL;", "OCTAL;"]
MARKS = ["\t", "+", "-", ",", "=", "*", ".", ";", "\n", "/X\n", " ,", " =", "$", "(", "!", "a", "\f"]
statements = st.text(CHARACTERS, max_size=80)
LATER = [*PSEUDO_OPERATORS, "TAD (", "TAD [", "AND", '"', "<>", "<1>"]


def made_of(*words: str) -> st.SearchStrategy[str]:
    pairs = st.tuples(st.sampled_from(words), st.sampled_from([" "] * 8 + ["\n"] * 4 + MARKS))
    return st.lists(pairs.map("".join), max_size=60).map("".join)


pieces = made_of(*NAMES * 3, *PSEUDO)
later = made_of(*NAMES, *LATER)


def look_at_everything(source: bytes | str, **options: Any) -> pal.Assembly:
    diagnostics = pal.assemble(source, **options).diagnostics
    assembly = pal.assemble(source, **options)
    for number in (1, 2, 3):
        assert assembly.text(number).isascii() or assembly.dialect == "pal8"
    assert assembly.dialect == "pal8" or len(assembly.teletype) == 3
    assert assembly.diagnostics == diagnostics
    assert any(diagnostic.error for diagnostic in diagnostics) != assembly.ok
    as_json(assembly)
    if assembly.stopped:
        assert (assembly.tape, assembly.words) == (b"", {})
    elif "PS02" not in {diagnostic.code for diagnostic in diagnostics}:
        assert binary.decode(assembly.tape).words == assembly.words
    return assembly


@given(statements | pieces | st.binary(max_size=200) | st.text(max_size=100), st.booleans())
def test_anything_assembles_to_a_good_tape(source: bytes | str, modern: bool) -> None:
    look_at_everything(source, modern=modern)


@given(st.text(CHARACTERS + '(["<>&%)]', max_size=80) | later | st.text(max_size=100))
def test_anything_is_a_source_of_pal8(source: str) -> None:
    look_at_everything(source, dialect="pal8")


@given(pieces)
@example("B ,5=A ")  # 5= puts a name into the table that has blanks in it
@example("AaA*DECIMAL;a")  # the first small letter is not the first by its address
def test_messages_of_the_three_passes_are_the_diagnostics(source: str) -> None:
    assembly = pal.assemble(source)
    printed = (assembly.text(1) + assembly.text(2)).splitlines()
    found = sorted(diagnostic.message for diagnostic in assembly.diagnostics if len(diagnostic.code) == 2)
    said = [line for line in printed if line[2:4] == "  " and "  AT  " in line]
    small = [line for line in said if re.match("IC  03[4-7]", line)]
    assert found == sorted([line for line in said if line not in small] + small[:1])


@given(pieces, pieces)
def test_two_tapes_are_one_after_the_other(first: str, second: str) -> None:
    assert pal.assemble(first, second).tape == pal.assemble(first + second).tape


@given(pieces, st.sampled_from([1, 3, HIGH_SPEED_SYMBOLS]))
@example("FIXMRI 1\n" * 80, 1)
def test_any_reader_and_any_room_come_to_an_end(source: str, capacity: int) -> None:
    assembly = look_at_everything(source, capacity=capacity)
    assert len(assembly.symbols) <= capacity + 75
