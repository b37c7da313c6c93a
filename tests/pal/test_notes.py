"""The notes: where a source means something else to PAL III than it says, and nowhere else."""

from pathlib import Path

import pytest

import pal
from pal.assembler import HIGH_SPEED_SYMBOLS
from tests.conftest import case

EXAMPLES = Path(__file__).parent / "examples"
PROGRAMS = Path(__file__).parents[2] / "programs"
ORDINARY = [
    "assign",
    "expr",
    "format",
    "offpage",
    "syms",
    "pause",
    "field",
    "fieldword",
    "fieldmod",
    "fixmri",
]
ORDINARY += ["float", "dectape552", "longtag", "redef", "emptycomma", "nosym", "undeforg", "formfeed"]
NOTED = [
    ("A ,5", 1, 3, "PN10", "what stands before this comma is part of the word"),
    ("TAD A, 5", 1, 5, "PN10", "what stands before this comma is part of the word"),
    ("TAD B\n,5", 2, 1, "PN11", "no symbol stands before this comma"),
    ("A=3\nB=A\nB =4", 3, 3, "PN12", "what stands before the equals sign, 0003, is part of the value"),
    ("TAD B\n=5", 2, 1, "PN11", "no symbol stands before this equals sign"),
    ("CLA DECIMAL", 1, 5, "PN13", "DECIMAL at the end of a statement leaves no word"),
    ("TAD 5 Z", 1, 7, "PN13", "Z at the end of a statement leaves no word"),
    ("*400\nA,TAD Z A", 2, 9, "PN14", "Z makes this refer to 0000 on page zero"),
    ("5 TAD 3", 1, 3, "PN15", "what stands before TAD is part of its address"),
    ("I 5", 1, 3, "PN16", "I without a memory-reference symbol makes an AND"),
    ("5 + 3", 1, 4, "PN17", "this makes an inclusive OR of it"),
    ("3-5.", 1, 3, "PN18", "the - is used for 5 and for the location"),
    ("3 *20", 1, 3, "PN19", "what stands before it, 0003, is part of the operand"),
    ("A=5\nA*30", 2, 1, "PN19", "A before the asterisk has no effect"),
    ("5 FIELD 2", 1, 3, "PN19", "what stands before it, 0005, is part of the operand"),
    ("FIELD\n1", 1, 1, "PN20", "FIELD takes the next statement"),
    ("FIXMRI A=1000", 1, 10, "PN21", "FIXMRI makes ION a memory reference, whatever it defines"),
    ("EXPUNGE\nA=5", 1, 1, "PN22", "with EXPUNGE and no FIXMRI every symbol is a memory reference"),
    (
        "A=5\nEXPUNGE\nFIXMRI TAD=1000",
        2,
        1,
        "PN22",
        "EXPUNGE forgets the symbols that the source has used before",
    ),
    ("TAD A\nFIXTAB\nA,5", 2, 1, "PN23", "FIXTAB keeps what is not defined yet: A"),
    ("P=Q\nQ=R\nR=3\nP", 4, 1, "PN24", "this is 0200 on the tape and 0003 in the listing"),
    ("*B+10\nA,5\nB=20", 2, 1, "PN25", "A is 0010 from pass 1, and stands at 0030 in pass 2"),
]
"""Sources without their `$`, and where a note of what is in them (docs/notes.md has the codes)."""


def noted(source: str | bytes, capacity: int = 585) -> list[tuple[int, int, str, str]]:
    found = pal.assemble(source, capacity=capacity).diagnostics
    return [
        (diagnostic.line, diagnostic.column, diagnostic.code, diagnostic.message)
        for diagnostic in found
        if not diagnostic.error
    ]


@pytest.mark.parametrize("name", ORDINARY)
def test_an_ordinary_source_has_none(name: str) -> None:
    found = pal.assemble((EXAMPLES / f"{name}.pal").read_bytes()).diagnostics
    assert [note for note in found if "PN10" <= note.code < "PN30"] == []


@pytest.mark.parametrize("path", sorted(PROGRAMS.glob("*.pal")), ids=lambda path: path.stem)
def test_our_programs_have_none(path: Path) -> None:
    assert pal.assemble(path.read_bytes()).diagnostics == []


def test_each_is_found_where_it_stands() -> None:
    for source, *note in NOTED:
        with case(source, *note):
            assert [found for found in noted(source + "\n$\n") if found[2] == note[2]] == [tuple(note)]


RUNS_ON = [
    "CLA;CLA",
    "SZA;CLA",
    "CLA;ISZ 20",
    "SZA;JMP 20",
    "SKP;JMP 20",
    "ISZ 20;JMP 20",
    "KSF;JMP 20",
    "SZA;KCC",
]
ENDS = [
    "CLA;HLT",
    "CLA;SNA HLT",
    "SZA;JMS 20",
    "CLA;JMP 20",
    "OSR;JMP 20",
    "RAL;JMP 20",
    "KCC;JMP 20",
    "DCA 20;JMP 20",
]
ENDS += ["7440;JMP 20", "SZA;5"]


def test_data_that_the_program_runs_into_are_noted() -> None:
    for words in RUNS_ON + ENDS:
        for use, counts in (
            ("TAD A", True),
            ("ISZ A", True),
            ("JMS A", True),
            ("JMP A", False),
            ("DCA A", False),
        ):
            with case(words, use):
                found = noted(f"*200\n\t{words}\nA,\t5\n\t{use}\n\tHLT\n$\n")
                note = (3, 4, "PN06", "the program runs on from 0201 into data at 0202")
                assert found == ([note] if counts and words in RUNS_ON else [])


def test_the_end_of_a_line_that_the_high_speed_reader_loses() -> None:
    source = "PAUSE;5\n1\n$\n"
    lost = (1, 1, "PN26", "what follows PAUSE on its line is lost")
    assert noted(source, HIGH_SPEED_SYMBOLS) == [lost]
    assert noted(source) == []
