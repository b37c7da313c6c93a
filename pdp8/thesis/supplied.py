"""Which characters of the thesis's text the scan does not show, and how each output marks them.

    [JMS CHK]                             in text: brackets; NOTE says what they are
    <mark class="supplied">JMS CHK</mark> in HTML: another colour
    <supplied>JMS CHK</supplied>          in TEI (`tei`)

What is supplied follows from the evidence: a row's scan, read by the six rules, beside ours.
"""

import re
from collections.abc import Iterator
from difflib import SequenceMatcher
from html import escape
from typing import Final

from pdp8.thesis.evidence import Row, read, table
from pdp8.thesis.reading import pal_line

NOTE: Final = "Characters in [brackets] cannot be read in the scan: they are supplied."

_BRACKETS = re.compile(r"\[([^][]*)\]")
_MARKED_LINE = re.compile(r"^(?!\s*/)(.*(?:\t/[WDRC]| (?:DAMAGED|RESTORED|CONJECTURE))\b.*)$", re.MULTILINE)
_PAL_DIGITS = 8
_ZEROS = str.maketrans("ØQ@", "000")


def marked(artefact: str) -> Iterator[tuple[Row, list[bool]]]:
    """Yield each row of the thesis, and whether each of its characters but spaces is supplied."""
    above = ""
    for row in table(artefact):
        above = row.scan if row.scan != "^" else above
        yield row, _supplied(row, above, artefact)


def _supplied(row: Row, scan: str, artefact: str) -> list[bool]:
    ours = "".join(row.ours.split())
    if row.kind in ("legible", "read"):
        return [False] * len(ours)
    if artefact.endswith(".pal"):
        digits, source = _pal_shown(scan, second=row.scan == "^")
        shown = "" if row.kind == "implied" else source
        return _unlike(digits, ours[:_PAL_DIGITS]) + _unlike(shown, ours[_PAL_DIGITS:])
    if row.kind != "damaged" and artefact.endswith(".for"):  # of the statement itself nothing is left
        number, _, note = scan.partition(" ¦ ")
        return _unlike(number[:3] + "".join(note.split()), ours)
    return _unlike("".join(read(scan, artefact).split()), ours)


def _pal_shown(scan: str, *, second: bool) -> tuple[str, str]:
    """Return the octal digits and the source that a line shows; of two lines run together, those of one."""
    digits, source = pal_line(scan)
    words = source.translate(_ZEROS).split()
    merged = [word for word in words if re.fullmatch("[0-7]{4}", word)]
    if len(merged) == 2:  # both addresses, then both words
        digits = digits[4:] + merged[1] if second else digits[:4] + merged[0]
    return digits, "".join(word for word in words if word not in merged)


def _unlike(shown: str, ours: str) -> list[bool]:
    """Return for each character of `ours` whether the scan lacks it, by place or by longest common runs."""
    if len(shown) == len(ours):
        return [one != other for one, other in zip(shown, ours, strict=True)]
    lacks = [True] * len(ours)
    for match in SequenceMatcher(None, shown, ours, autojunk=False).get_matching_blocks():
        lacks[match.b : match.b + match.size] = [False] * match.size
    return lacks


def bracketed(line: str, supplied: list[bool]) -> str:
    """Return a line with brackets about the characters that are supplied; its columns stay if they can."""
    flags = iter(supplied)
    marks = [None if character == " " else next(flags) for character in line]
    known = [at for at, mark in enumerate(marks) if mark is not None]
    text = list(line)
    inside = False
    for before, at in zip([-1, *known], known, strict=False):
        if marks[at] and not inside:
            _put(text, "[", at, before=True)
        if not marks[at] and inside:
            _put(text, "]", before, before=False)
        inside = bool(marks[at])
    if inside:
        text[known[-1]] += "]"
    return "".join(text)


def _put(text: list[str], bracket: str, at: int, *, before: bool) -> None:
    """Put a bracket before or behind a character, in place of a space if there are two."""
    beside, next_ = (at - 1, at - 2) if before else (at + 1, at + 2)
    if min(beside, next_) >= 0 and text[beside : beside + 1] == text[next_ : next_ + 1] == [" "]:
        text[beside] = bracket
    else:
        text[at] = bracket + text[at] if before else text[at] + bracket


def html(text: str) -> str:
    """Return text as HTML; text in brackets, and lines with a mark of ours, in another colour."""
    coloured = _BRACKETS.sub(r'<mark class="supplied">[\1]</mark>', escape(text))
    return _MARKED_LINE.sub(r'<mark class="supplied">\1</mark>', coloured)
