"""The messages for people: every message of DEC's, ours beside it, in the order of the source."""

import pytest

import pal
from tests.conftest import case

ONE_OF_EACH = """\
*200
A,	1
A,	2
A=3
	TAD NOWHERE
	JMP 400
	A!A
	PAGE
	TEXT
	4
"""


def said(source: str, modern: bool = False) -> list[tuple[str, int, int, str]]:
    found = pal.assemble(source, names=["x.pal"], modern=modern).diagnostics
    return [(diagnostic.code, diagnostic.line, diagnostic.column, diagnostic.source) for diagnostic in found]


def test_one_error_of_every_kind_in_source_order() -> None:
    assert said(ONE_OF_EACH) == [
        ("DT", 3, 1, "A,\t2"),
        ("RD", 4, 1, "A=3"),
        ("UA", 5, 6, "\tTAD NOWHERE"),
        ("IR", 6, 2, "\tJMP 400"),
        ("IC", 7, 2, "\tA!A"),
        ("UA", 8, 2, "\tPAGE"),
        ("UA", 9, 2, "\tTEXT"),
        ("PN27", 10, 2, "\t4"),
    ]


def test_a_diagnostic_in_full() -> None:
    first = pal.assemble("*200\nX,\t1\n\tCLA; TAD BEYOND\n$\n", names=["a.pal"]).diagnostics[0]
    assert str(first) == (
        "a.pal:3:11: error: UA  BEYOND  AT  0202\n"
        "    \tCLA; TAD BEYOND\n"
        "    \t         ^^^^^^\n"
        "  undefined: BEYOND is taken as 0377, the last address of its page; "
        "define it with BEYOND, or BEYOND="
    )


def test_of_a_long_line_a_hundred_characters_are_shown() -> None:
    line = "\t1" + f"{'!':>61}2" * 3
    shown = [found.excerpt for found in pal.assemble(f"{line}\n$\n").diagnostics]
    assert shown == [
        [f"    {line[start : start + 100]}", f"    {' ' * blanks}^"]
        for start, blanks in ((12, 50), (74, 50), (88, 98))
    ]
    line = "\tTEXT /" + "ABCDEFGHIJ" * 15
    (error,) = pal.assemble(f"{line}\n$\n", dialect="pal8").diagnostics
    assert error.excerpt == [f"    {line[:100]}", "    \t" + "^" * 99]


@pytest.mark.parametrize(
    ("statement", "hint"),
    [
        ("PAGE", "write the origin, as in *400"),
        ("TEXT", "write the codes as numbers"),
        ("ZBLOCK 5", "leave the words out"),
        ("IFZERO", "assembles everything"),
        ("TAD (5)", "no literals"),
        ("TAD [5]", "no literals"),
        ("CLA!CLL", "a space is inclusive OR"),
        ('"A', "no character constants"),
        ("JMP @5", "with I"),
        ("BSW", "a later PDP-8's"),
        ("OPR", "write 7000, or OPR=7000"),
        ("IOT", "write 6000, or IOT=6000"),
        ("cla", "capital letters only"),
        ("é", "not ASCII"),
    ],
)
def test_another_assemblers_dialect_is_recognised(statement: str, hint: str) -> None:
    hints = [diagnostic.hint for diagnostic in pal.assemble(f"\t{statement}\n$\n").diagnostics]
    assert any(hint in sentence for sentence in hints), hints


NOTED = [
    ("\t1\n", 1, 2, "no $ at the end"),
    ("\n", 1, 1, "no $ at the end"),
    ("\t1\n\n2;3$\n", 3, 3, "what stands before this $ is lost"),
    ("A=5;\tA + 1\n$\n", 1, 9, "this makes an inclusive OR of it"),
    ("\tB\n,5\n$\n", 2, 1, "no symbol stands before this comma"),
    ("", 1, 1, "the source is empty"),
]


@pytest.mark.parametrize(("source", "line", "column", "message"), NOTED)
def test_notes_are_no_errors(source: str, line: int, column: int, message: str) -> None:
    assembly = pal.assemble(source)
    assert assembly.ok
    (note,) = assembly.diagnostics
    assert (note.line, note.column, note.message, note.error) == (line, column, message, False)


def test_tapes_after_the_end_are_noted() -> None:
    (note,) = pal.assemble("1\n$\n", "2\n$\n", names=["one.pal", "two.pal"]).diagnostics
    assert (note.file, note.message) == ("one.pal", "1 more tape not read")


def test_a_good_source_has_nothing_to_say() -> None:
    assert said("*200\nA,\tJMP A\n$\n") == []


def test_modern_has_no_quarrel_with_small_letters() -> None:
    assert said("*200\na,\tjmp a\n$\n", modern=True) == []


def test_a_full_table_ends_the_assembly_in_pass_1() -> None:
    assembly = pal.assemble("A=1\nB=2\nC=3\n\t7\n$\n", capacity=2)
    assert [diagnostic.message for diagnostic in assembly.diagnostics] == ["ST  C       AT  0200"]
    assert (assembly.tape, assembly.words, assembly.listing) == (b"", {}, "")
    assert assembly.text(1) == "\nST  C       AT  0200"
    assert assembly.teletype.pass1.endswith(b"\xff")


def test_a_byte_order_mark_is_no_character() -> None:
    assert pal.assemble(b"\xef\xbb\xbf*200\n\tCLA\n$\n").diagnostics == []


@pytest.mark.parametrize("statement", ["CLA \033[31mX\x07", "FIELD\0331"])
def test_a_terminal_is_shown_no_control_codes_of_a_source(statement: str) -> None:
    for diagnostic in pal.assemble(f"*200\n\t{statement}\n$\n").diagnostics:
        assert not any(ord(character) < 0o40 and character not in "\t\n" for character in str(diagnostic))


MEANT = {
    "HLT": "HALT STOP",
    "JMP": "JUMP BRA GOTO",
    "JMS": "CALL JSR SUBR",
    "TAD": "ADD LOAD LDA",
    "DCA": "STORE STO",
    "IAC": "INC",
    "CLA": "CLEAR CLR",
    "CIA": "NEG",
    "CMA": "COM NOT",
    "SKP": "SKIP",
    "RAL": "ROL",
    "RAR": "ROR",
    "JMP I": "RETURN RET RTS",
    "TEXT": "BYTE",
    "*": "ORG",
}
"""What the 6502, the 68000, the PDP-11 and others write, by what PAL III has."""


def test_what_other_machines_call_it_is_known() -> None:
    for ours, others in MEANT.items():
        for name in others.split():
            with case(name):
                said = [found.message for found in pal.assemble(f"\t{name}\n\tHLT\n$\n").diagnostics]
                assert f"{name} is not defined: did you mean {ours}?" in said
