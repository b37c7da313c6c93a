"""What students write by mistake, in mistakes/; and in said.txt all that is said of each, as it was read by
eye: line, columns, code, message, advice, hint. In auto.txt PN36 says that PAL8 was found. Below, what of a
line is shown.

A `$` is added where there is none, but at "no end". No advice changes what a source means: it names what to
write, and never says to take a character away.
"""

from pathlib import Path

import pal

FOLDER = Path(__file__).parent / "mistakes"


def test_what_is_said_of_each_is_what_was_read() -> None:
    said = []
    for dialect in ("pal3", "pal8", "auto"):
        for mistake in (FOLDER / f"{dialect}.txt").read_text("utf-8").split("== ")[1:]:
            title, _, text = mistake.partition("\n")
            said.append(f"== {dialect} {title}")
            end = "" if title.startswith("no end") or "$" in text else "$\n"
            for found in pal.assemble(text + end, dialect=dialect).diagnostics:
                place = f"{found.line}:{found.column}-{found.end_column}"
                told = (place, found.code, found.message, found.advice, found.hint)
                said.append(" | ".join(filter(None, told)))
    assert said == (FOLDER / "said.txt").read_text("utf-8").splitlines()


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


def test_what_a_reader_wrote_is_shown() -> None:
    (error, *_) = pal.assemble('*200\n\t"é\n\tTEXT /ü/\n$\n', dialect="pal8").diagnostics
    assert (error.source, error.error) == ('\t"é', True)
