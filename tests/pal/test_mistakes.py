"""What students write by mistake, in mistakes/, and below each all that is said of it, as it was read by eye:
line, columns, code, message, advice, hint. In auto.txt PN36 says that PAL8 was found. In beside.txt the
nearest sources that have a note and do not. Below, what of a line is shown.

A `$` is added where there is none, but at "no end". No advice changes what a source means: it names what to
write, and never says to take a character away.
"""

import re
from collections.abc import Iterator
from pathlib import Path

import pal
from tests.conftest import case

FOLDER = Path(__file__).parent / "mistakes"
_OF_FIELD_0 = "PN39 PN40 PN57 PN59 PN60"
_SAID = re.compile(r"^\d+:\d+-\d+ \| .*\n", re.MULTILINE)


def mistakes(dialect: str) -> Iterator[tuple[str, str, str]]:
    """Yield the title of each mistake, its text without its `$`, and what is said of it."""
    for mistake in (FOLDER / f"{dialect}.txt").read_text("utf-8").split("== ")[1:]:
        title, _, text = mistake.partition("\n")
        yield title, _SAID.sub("", text), "".join(_SAID.findall(text))


def test_what_is_said_of_each_is_what_was_read() -> None:
    """And each note of a dialect has a line of it in beside.txt, but PN36, which is of the whole source."""
    beside = {tuple(line.split(" ")[:2]) for line in (FOLDER / "beside.txt").read_text("utf-8").splitlines()}
    for dialect in ("pal3", "pal8", "auto"):
        for title, text, expected in mistakes(dialect):
            end = "" if title.startswith("no end") or "$" in text else "$\n"
            said = ""
            for found in pal.assemble(text + end, dialect=dialect).diagnostics:
                place = f"{found.line}:{found.column}-{found.end_column}"
                known = found.code[:2] != "PN" or found.code == "PN36" or dialect == "auto"
                assert known or (found.code, dialect) in beside, found.code
                told = (place, found.code, found.message, found.advice, found.hint)
                said += " | ".join(filter(None, told)) + "\n"
            with case(dialect, title):
                assert said == expected


def test_each_note_is_said_of_one_source_and_not_of_the_nearest() -> None:
    """A line of beside.txt: the note, a dialect or a model, and a source. Of `[one|other]` the first has no
    such note and the second has it; ! ends a line; A{3} is AAA. In field 1 it is the same, but for the notes
    on where a program starts, is interrupted and is loaded.
    """
    for line in (FOLDER / "beside.txt").read_text("utf-8").splitlines():
        code, how, _ = line.split(" ", 2)
        for said in (False, True):
            text = beside(line, said)
            with case(line, text):
                for start in ("", *["FIELD 1\n"] * (code not in _OF_FIELD_0)):
                    dialect, model = (how, None) if how[0] == "p" else ("pal3", how)
                    found = pal.assemble(start + text, dialect=dialect, model=model).diagnostics
                    assert (code in [each.code for each in found]) == said, start


def beside(line: str, said: bool) -> str:
    """Return the source of a line of beside.txt that has the note, or the one that has not."""
    _, _, template = line.split(" ", 2)
    text = re.sub(r"\[([^|]*)\|([^]]*)\]", r"\2" if said else r"\1", template).replace("!", "\n")
    text = re.sub(r"(.)\{(\d+)\}", lambda found: found[1] * int(found[2]), text)
    return text + ("" if "$" in template else "\n$\n")


def sources() -> Iterator[tuple[str, str, str]]:
    """Yield the dialect, the title and the text of each mistake without its `$`."""
    for dialect in ("pal3", "pal8"):
        for title, text, _ in mistakes(dialect):
            yield dialect, title, text
    for line in (FOLDER / "beside.txt").read_text("utf-8").splitlines():
        yield line.split(" ")[1], line, beside(line, True).removesuffix("$\n")


def test_what_is_said_of_a_mistake_is_said_wherever_it_is_written() -> None:
    """On a second tape and on two; its lines on one, but for tags at the margin; nothing behind the `$`."""

    def said(dialect: str, *tapes: str, but: str) -> list[tuple[str, str]]:
        found = pal.assemble(*tapes, dialect=dialect).diagnostics
        return sorted((each.code, each.headline.partition(":")[2]) for each in found if each.code not in but)

    for dialect, title, text in sources():
        with case(title):
            if "$" in title + text or dialect not in ("pal3", "pal8"):
                continue
            assert said(dialect, "*200\n\tHLT\n$\n" + text, but="PN03") == []
            here = said(dialect, text + "$\n", but="PN36 PN55")
            if "value for no symbol" not in title:
                assert said(dialect, "\n", text + "$\n\x1a\0", but="PN36 PN55") == here
            lines = text.split("\n")
            pauses = [at for at, line in enumerate(lines, 1) if line.strip() == "PAUSE"]
            cut = pauses[0] if pauses else len(lines) // 2
            tapes = "\n".join([*lines[:cut], ""]), "\n".join([*lines[cut:], "$\n"])
            parted = [code for code, _ in said(dialect, *tapes, but="PN36 PN55")]
            assert parted == [code for code, _ in here if code != "PN48"], "PAUSE ends a tape there"
            if "/" not in text and "tag without" not in title:
                joined = text.rstrip("\n").replace("\n", ";") + "\n$\n"
                codes = [code for code, _ in said(dialect, joined, but="PN36 PN55")]
                assert codes == [code for code, _ in here]


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
    for dialect in ("pal3", "pal8"):
        said = pal.assemble("TAD X;TAD Y;TAD Z\n$\n", dialect=dialect).diagnostics
        assert len({id(found.source) for found in said}) == 1 < len(said), "it is kept once"
    line = "\tTEXT /" + "ABCDEFGHIJ" * 15
    (error,) = pal.assemble(f"{line}\n$\n", dialect="pal8").diagnostics
    assert error.excerpt == [f"    {line[:100]}", "    \t" + "^" * 99]


def test_what_a_reader_wrote_is_shown() -> None:
    (error, *_) = pal.assemble('*200\n\t"é\n\tTEXT /ü/\n$\n', dialect="pal8").diagnostics
    assert (error.source, error.error) == ('\t"é', True)
