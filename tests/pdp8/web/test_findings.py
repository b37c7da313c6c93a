"""What the page says of a source: its words, its first diagnostics in brief and whole, a sentence on it."""

from pal.assembly import MOST
from pdp8.web.findings import checked, here


def test_a_note_is_counted_by_itself() -> None:
    found = checked("a.pal", "*200\n\t5 + 3\n\tHLT\n$\n")
    assert (found.ok, found.summary) == (True, "2 words, a tape of 139 frames; 1 note.")
    assert found.words == [(0o200, 7), (0o201, 0o7402)]
    assert found.places == [(2, 0o200, 7), (3, 0o201, 0o7402)]
    (note,) = found.diagnostics
    assert (note.line, note.start, note.severity) == (2, 4, "note")


def test_pal8_is_found() -> None:
    found = checked("a.pal", "*200\n\tCLA\n\tTAD (7)\n\tHLT\n$\n")
    assert found.ok
    assert (0o377, 7) in found.words
    assert "taken for PAL8" in found.diagnostics[0].whole


def test_no_option_of_the_command_is_advised() -> None:
    """Small letters, literals: the page says what to write, and not what `pal` could be told."""
    for source in ("*200\n\tcla\n\tHLT\n$\n", "*200\n\tTAD (7)\n$\n", "*200\n\tTAD [7]\n\tCLA!\n$\n"):
        for said in checked("a.pal", source).diagnostics:
            assert "--" not in said.brief + said.whole
            assert said.brief
    assert here("it did not end; pdp8 run LOADER --start 7777") == "it did not end"


def test_many_are_counted() -> None:
    found = checked("a.pal", "*200\n" + "\t5 + 3\n" * 150 + "$\n")
    assert (len(found.diagnostics), found.more) == (MOST, 50)
