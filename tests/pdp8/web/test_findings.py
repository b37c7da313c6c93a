"""What the page says of a source: its words, its first diagnostics in brief and whole, a sentence on it."""

import pytest

from pal.assembly import MOST
from pdp8.web.findings import checked, here
from tests.conftest import Call


def test_what_is_found() -> None:
    found = checked("a.pal", "*200\n\t5 + 3\n\tHLT\n$\n")
    assert (found.ok, found.summary) == (True, "2 words, a tape of 139 frames; 1 note.")
    assert found.words == [(0o200, 7), (0o201, 0o7402)]
    assert found.places == [(2, 0o200, 7), (3, 0o201, 0o7402)]
    (note,) = found.diagnostics
    assert (note.line, note.start, note.severity) == (2, 4, "note")
    many = checked("a.pal", "*200\n" + "\t5 + 3\n" * 150 + "$\n")
    assert (len(many.diagnostics), many.more) == (MOST, 50)
    pal8 = checked("a.pal", "*200\n\tCLA\n\tTAD (7)\n\tHLT\n$\n")
    assert pal8.ok
    assert (0o377, 7) in pal8.words
    assert "assembled as PAL8" in pal8.diagnostics[0].whole


def test_it_says_what_pal_prints(call: Call) -> None:
    """Place, message, line, carets, advice and hint, in the words of the command; notes among the errors."""
    source = "*200\n\tJMP 400\n\tCLA!\n\tTAD FOO\n\t5 + 3\n$\n"
    printed = call("pdp8 pal - -o a.bin", source.encode())[2].partition("\npdp8 pal: ")[0]
    said = [each.whole for each in checked("standard input", source).diagnostics]
    assert "\n".join(said) == printed.rstrip("\n")


@pytest.mark.parametrize("source", ["\tcla\n\tHLT\n", "\tTAD (7)\n", "\tTAD [7]\n\tCLA!\n"])
def test_no_option_of_the_command_is_advised(source: str) -> None:
    """Small letters, literals: the page says what to write, and not what `pal` could be told."""
    for said in checked("a.pal", f"*200\n{source}$\n").diagnostics:
        assert "--" not in said.brief + said.whole
        assert said.brief
    assert here("it did not end; pdp8 run LOADER --start 7777") == "it did not end"
