"""The notes: where a source means something else to PAL III than it says, and nowhere else."""

from pathlib import Path

import pal
from pal.notes import meant
from tests.conftest import case

EXAMPLES = Path(__file__).parent / "examples"
PROGRAMS = Path(__file__).parents[2] / "programs"
ORDINARY = (
    "assign expr format offpage syms pause field fieldword fieldmod fixmri float dectape552 longtag redef"
    " emptycomma nosym undeforg formfeed"
)


def noted(source: str) -> list[tuple[int, int, str, str]]:
    found = pal.assemble(source).diagnostics
    return [(note.line, note.column, note.code, note.message) for note in found]


def test_an_ordinary_source_has_none() -> None:
    for name in ORDINARY.split():
        with case(name):
            found = pal.assemble((EXAMPLES / f"{name}.pal").read_bytes()).diagnostics
            assert [note for note in found if "PN10" <= note.code < "PN30"] == []
    for path in sorted(PROGRAMS.glob("*.pal")):
        with case(path):
            assert pal.assemble(path.read_bytes()).diagnostics == []


NEAR = {
    "COUNT": "CUONT OCUNT COUTN OUNT CONT COUN XCOUNT COXUNT COUNTX XOUNT COUNX",
    **{"LOOP": "LOPO LOP LOOPS", "TAD": "TDA TADX ADD LOAD LDA"},
    "": "COUNT TNUOC COUXX COU COUNTXX XLOOPX LOXP TA AD A TXD AX BA",
    **{"HLT": "HALT STOP", "JMP": "JUMP BRA GOTO", "JMS": "CALL JSR SUBR", "JMP I": "RETURN RET RTS"},
    **{"DCA": "STORE STO", "IAC": "INC", "CLA": "CLEAR CLR", "CIA": "NEG", "CMA": "COM NOT", "SKP": "SKIP"},
    **{"RAL": "ROL", "RAR": "ROR", "TEXT": "BYTE", "*": "ORG"},
}
"""Undefined names by what is meant: AB, COUNT, LOOP or TAD; or as the 6502, the 68000, the PDP-11 call it."""


def test_what_is_meant_is_near_or_another_machines() -> None:
    for other, names in NEAR.items():
        for name in names.split():
            with case(name):
                assert (meant(name, ["AB", "COUNT", "LOOP", "TAD"]) or "") == other


RUNS_ON = "CLA;CLA|SZA;CLA|CLA;ISZ 20|SZA;JMP 20|SKP;JMP 20|KSF;JMP 20|SZA;KCC"
ENDS = "CLA;HLT|CLA;SNA HLT|SZA;JMS 20|CLA;JMP 20|OSR;JMP 20|RAL;JMP 20|KCC;JMP 20|DCA 20;JMP 20"
ENDS += "|HLT;CLA|5;CLA|7440;JMP 20|SZA 1;JMP 20|SZA;5|ION;JMP I 0"


def test_a_hundred_undefined_names_are_looked_for() -> None:
    for count in (99, 100):
        source = "*200\n" + "".join(f"\tTAD ZZ{number}\n" for number in range(count)) + "\tTDA 5\n$\n"
        found = [each.message for each in pal.assemble(source).diagnostics if each.code == "PN33"]
        assert found == ["TDA is not defined: did you mean TAD?"] * (count < 100)


def test_data_that_the_program_runs_into_are_noted() -> None:
    for data, notes in (("5777", 1), ("6000", 0)):
        assert len(noted(f"*250\n\tTAD A\n\tHLT\n*200\n\tCLA\nA,\t{data}\n$\n")) == notes


def test_a_routine_without_a_first_word_is_noted_at_its_first_call() -> None:
    source = "*200\n\tJMS A\n\tJMS A\n\tJMS B\n\tHLT\nA,\tCLA\n\tJMP I A\nB,\tCMA\n\tJMP I B\n$\n"
    found = [each.line for each in pal.assemble(source).diagnostics if each.code == "PN07"]
    assert found == [2, 4]


def test_a_subroutine_in_field_1_is_followed_and_a_jump_into_another_field_is_not() -> None:
    for call, jump, notes in (("CLA", "CLA", 1), ("CIF 0", "CLA", 0), ("CLA", "CIF 0", 0)):
        source = f"FIELD 1\n*200\n{call}\nJMS 240\nHLT\n*240\n0\n{jump}\nJMP 277\n*277\nCLA\n$\n"
        found = pal.assemble(source, dialect="pal8").diagnostics
        assert [each.code for each in found].count("PN39") == notes, source


def test_a_constant_among_the_instructions_is_run_on_purpose() -> None:
    assert noted("*200\n\tCLA\nA,\t70\n\tTAD A\n\tHLT\n$\n") == []
    assert [note[2] for note in noted("*200\n\tCLA\nA,\t0\n\tJMS A\n\tHLT\n$\n")] == ["PN06"]
    assert noted("*200\n\tJMS A\n\tHLT\nA,\tHLT\n\tJMP I A\n$\n") == []
    assert noted("*200\n\tTAD LONGNAME\n\tHLT\nLONGNA,\t5\n$\n") == []


def test_an_isz_skips_the_jump_back_of_its_loop_and_no_other() -> None:
    for jump, use, codes in (
        *(("200", "TAD", ["PN06"]), ("200", "JMS", []), ("240", "TAD", []), ("I 20", "TAD", [])),
    ):
        found = noted(f"*250\n\t{use} A\n\tHLT\n*200\n\tISZ 20\n\tJMP {jump}\nA,\t5\n$\n")
        assert [note[2] for note in found] == codes
    for words in f"{RUNS_ON}|{ENDS}".split("|"):
        for use in ("TAD", "ISZ", "JMS", "JMP", "DCA"):
            with case(words, use):
                found = noted(f"*250\n\t{use} A\n\tHLT\n*200\n\t{words}\nA,\t5\n$\n")
                note = (6, 4, "PN06", "the program runs on from 0201 into data at 0202")
                assert found == ([note] if use not in ("JMP", "DCA") and words in RUNS_ON.split("|") else [])


def test_a_wait_for_a_device_that_may_be_fitted_has_no_note() -> None:
    """One for each device of the rack; 14 is none."""
    for device in (0o13, 0o40, 0o41, 0o60, 0o66, 0o76, 0o14):
        found = noted(f"*200\n\tSKIPS=6001\n\tSKIPS {device << 3:o}\n\tJMP .-1\n\tHLT\n$\n")
        assert ("PN59" in [code for _, _, code, _ in found]) == (device == 0o14), f"{device:02o}"


def test_a_comment_silences_notes_and_no_error() -> None:
    """Of its own line, and of its codes alone, in either case."""
    for comment, left in (
        ("", ["PN01"]),
        (" / pal: PN01", []),
        (" / PAL: pn06, pn01", []),
        (" / pal: PN06", ["PN01"]),
    ):
        found = pal.assemble(f"*200\n\tCLA IAC RAL RAR{comment}\n\tHLT\n$\n").diagnostics
        assert [each.code for each in found] == left, comment
    (error,) = pal.assemble("*200\n\tTAD UNDEF / pal: UA US\n$\n").diagnostics
    assert error.error
