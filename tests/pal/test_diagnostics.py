"""The messages for people: every message of DEC's, ours beside it, in the order of the source."""

import re

import pytest

import pal


def test_a_diagnostic_in_full() -> None:
    first = pal.assemble("*200\nX,\t1\n\tCLA; TAD BEYOND\n$\n", names=["a.pal"]).diagnostics[0]
    assert str(first) == (
        "a.pal:3:11: error: UA  BEYOND  AT  0202\n"
        "    \tCLA; TAD BEYOND\n"
        "    \t         ^^^^^^\n"
        "  undefined: BEYOND is taken as 0377, the last address of its page; "
        "define it with BEYOND, or BEYOND="
    )


def test_of_an_empty_line_nothing_is_shown() -> None:
    assert [pal.assemble(*tapes).diagnostics[0].file for tapes in ([], [""])] == ["source", "tape 1"]
    (note,) = pal.assemble("\n").diagnostics
    advice = "PAL III would wait for more tape; it is taken as if there were one"
    assert str(note) == f"tape 1:1:1: note: no $ at the end [PN27]\n  {advice}"


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


def test_tapes_after_the_end_are_noted() -> None:
    for others, message in ((["2\n$\n"], "1 more tape not read"), (["2\n", "$"], "2 more tapes not read")):
        (note,) = pal.assemble("1\n", "1\n$\n", *others).diagnostics
        assert (note.file, note.line, note.column, note.message) == ("tape 2", 2, 1, message)


def test_a_good_source_has_nothing_to_say() -> None:
    assert pal.assemble("*200\nA,\tJMP A\n$\n").diagnostics == []
    assert pal.assemble("*200\na,\tjmp a\n$\n", modern=True).diagnostics == []


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
        assert diagnostic.excerpt[0] == "    \t" + re.sub("[\033\a]", "·", statement)
        assert not any(ord(character) < 0o40 and character not in "\t\n" for character in str(diagnostic))
