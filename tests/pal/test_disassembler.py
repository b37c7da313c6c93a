"""Tapes and words back to source: what it assembles to again, and how it reads."""

from pathlib import Path

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

import pal
from pal.disassembler import disassemble, disassemble_tape, microinstruction
from pal.formatting import silenced
from tapes import binary, codes, rim
from tests.conftest import case

EXAMPLES = sorted((Path(__file__).parent / "examples").glob("*.bin"))

words = st.integers(0, 0o7777)
cores = st.dictionaries(st.integers(0, 0o77777), words, min_size=1, max_size=60)


@given(cores, st.integers(0, 0o77777), st.lists(words, max_size=200))
def test_words_of_any_field_come_back(core: dict[int, int], start: int, run: list[int]) -> None:
    core |= {(start + offset) & 0o77777: word for offset, word in enumerate(run)}
    assembly = pal.assemble(disassemble(core))
    assert assembly.words == core
    assert {line.address: line.word for line in assembly.lines if line.word is not None} == core
    assert assembly.ok


@pytest.mark.parametrize("address", [0o0000, 0o0176, 0o0200, 0o0376, 0o7600, 0o7776, 0o10000, 0o70200])
def test_every_word_comes_back_from_any_page(address: int) -> None:
    for word in range(0o10000):
        core = {address: word, address + 1: word ^ 0o7777}
        assembly = pal.assemble(disassemble(core))
        assert assembly.words == core, f"{word:04o} at {address:05o}"
        assert assembly.ok, f"{word:04o} at {address:05o}"


def test_a_full_core_needs_no_more_symbols_than_there_is_room_for() -> None:
    core = {address: (address * 0o2345 + 0o1234) & 0o7777 for address in range(0o10000)}
    source = disassemble(core)
    assert source.count(",") == 488
    assembly = pal.assemble(source, capacity=489)
    assert assembly.words == core
    assert assembly.ok


OVERLAPPING = "1\n*200\n*200\n2\nFIELD 1\n3\n*20\nFIELD 1\nFIELD 2\n*0\n*7777\n4;5\nFIELD 0\n*200\n6\n$\n"


def test_a_tape_of_pal_comes_back_frame_for_frame() -> None:
    for tape in (*(path.read_bytes() for path in EXAMPLES), pal.assemble(OVERLAPPING).tape):
        with case(tape):
            assert pal.assemble(disassemble_tape(tape)).tape == tape


def test_a_second_section_begins_in_field_0() -> None:
    tape = pal.assemble("FIELD 1\n*200\n1\n$\n").tape + pal.assemble("*300\n2\n$\n").tape
    assert pal.assemble(disassemble_tape(tape)).words == {0o10200: 1, 0o300: 2}


@given(cores)
def test_a_bin_tape_comes_back_with_its_words_and_fields(core: dict[int, int]) -> None:
    tape = binary.encode(core)
    again = binary.decode(pal.assemble(disassemble_tape(tape)).tape)
    assert again.words == binary.decode(tape).words
    assert disassemble_tape(tape).removeprefix("*200\n") == disassemble(core).removeprefix("*200\n")


@given(st.dictionaries(st.integers(0, 0o7777), words, min_size=2, max_size=60))
def test_a_rim_tape_comes_back_with_its_words(core: dict[int, int]) -> None:
    """One in 4096 is a BIN tape too, checksum and all, and is taken for it (tapes/loaders.py)."""
    tape = rim.encode(core)
    assume(codes.recognise(tape) is codes.RIM)
    assert pal.assemble(disassemble_tape(tape)).words == core


NAMED = {
    **{0o7000: "NOP", 0o7300: "CLA CLL", 0o7041: "CIA", 0o7240: "STA", 0o7367: "CLA CLL CMA CML RTL IAC"},
    **{0o7016: "RTR RTL", 0o7002: None, 0o7640: "SZA CLA", 0o7460: "SZA SNL", 0o7570: "SPA SNA SZL"},
    **{0o7610: "SKP CLA", 0o7604: "LAS", 0o7602: "CLA HLT", 0o7400: None, 0o7401: None},
    **{0o6046: "TLS", 0o6016: "RRB RFC", 0o6203: None},
}


def test_microinstructions_are_named() -> None:
    assert {word: microinstruction(word) for word in NAMED} == NAMED


LINES = {
    0o5420: "\tJMP I 20\t/0200 5420",  # eight characters: a tab reaches the comment's column from there
    0o5407: "\tJMP I 7\t\t/0200 5407",
    **{0o7641: "\t7641\t\t/0200 7641", 0o7300: "\tCLA CLL\t\t/0200 7300"},
    **{0o7640: "\tSZA CLA\t\t/0200 7640", 0o7340: "\tCLA CLL CMA\t/0200 7340"},
}


def test_the_comment_stands_in_its_column() -> None:
    assert {word: disassemble({0o200: word}).splitlines()[1] for word in LINES} == LINES


def test_targets_have_tags_and_data_are_numbers() -> None:
    core = {0o200: 0o1205, 0o201: 0o7440, 0o202: 0o5200, 0o203: 0o4600, 0o204: 0o5204, 0o205: 0o7402}
    source = [" ".join(line.partition("/")[0].split()) for line in disassemble(core).splitlines()]
    lines = "*200;L0200, TAD L0205;SZA;JMP L0200;JMS I L0200;L0204, JMP L0204;L0205, 7402;$"
    assert source == lines.split(";")
    zero = disassemble({0o20: 0o1021, 0o21: 0o1220}).split("\t")
    assert zero == ["*20\n", "TAD L0021", "/0020 1021\nL0021,", "1220", "", "/0021 1220\n$\n"]


@given(
    cores, st.dictionaries(st.sampled_from(["A", "B", "L0200", "CLA"]), words), st.lists(words, max_size=3)
)
def test_with_symbols_and_entries_the_words_come_back_and_nothing_is_noted(
    core: dict[int, int], symbols: dict[str, int], entries: list[int]
) -> None:
    assembly = pal.assemble(silenced(disassemble(core, symbols, entries)))
    assert (assembly.words, assembly.diagnostics) == (core, [])


def test_a_comment_is_put_to_each_note_and_to_no_error() -> None:
    source = "\tTAD 18; RAL RAR\n\tTAD 19\t/C\n\tTAD NIX\n\tHLT\n$\n"
    said = "\tTAD 18; RAL RAR/pal: PN05 PN01\n\tTAD 19\t/C pal: PN05\n\tTAD NIX\n\tHLT\n$\n"
    assert silenced(source) == said


def test_entries_tell_code_from_numbers_and_symbols_name_words() -> None:
    source = """\
*200
LOOP,\tTAD K
\tDCA OUT
\tJMS SUB
\tJMP LOOP
SUB,\t0
\tISZ C
\tJMP I SUB
\tHLT
K,\t7402
C,\t1200
OUT=300
$
"""
    assembly = pal.assemble(source)
    made = disassemble(assembly.words, assembly.symbols, [0o200])
    assert [line.partition("/")[0].strip() for line in made.splitlines()] == [
        *("OUT=300", "*200", "LOOP,\tTAD K", "DCA OUT", "JMS SUB", "JMP LOOP"),
        *("SUB,\t0", "ISZ C", "JMP I SUB", "HLT", "K,\t7402", "C,\t1200", "$"),
    ]
    assert "K,\tHLT" not in disassemble(assembly.words, assembly.symbols)
    above = {at | 0o40000: word for at, word in assembly.words.items()}
    for entry in (0o200, 0o40200):
        again = disassemble(above, assembly.symbols, [entry]).replace("FIELD 4\n", "").replace("/4", "/")
        assert again == made
    assert "ISZ" in disassemble(above | {0o10000: 5}, {}, [0o40200]), "of several fields it says its own"


def test_what_a_skip_passes_over_to_is_code() -> None:
    """Each is before a JMP, and what is behind that is reached by a skip alone."""
    passing = 0o7410, 0o7440, 0o7450, 0o7420, 0o7500, 0o7610, 0o6031, 0o2300
    plain = 0o7400, 0o7600, 0o7404, 0o6032, 0o7010, 0o7411, 0o3300
    for word in passing + plain:
        with case(f"{word:o}"):
            core = {0o200: word, 0o201: 0o5200, 0o202: 0o7001}
            assert ("IAC" in disassemble(core, {}, [0o200])) == (word in passing)
