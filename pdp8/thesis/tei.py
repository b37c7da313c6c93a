"""The evidence as TEI, for editors: what the scan shows, and what is supplied where it shows nothing.

    <pb n="106"/><gap reason="lost" unit="page"/>                          a page that the scan has lost
    <ab><supplied reason="lost" cert="high">0340 1103 TAD P0</supplied>    what we put there
      <note>as 0250; ...</note></ab>                                       and why

Of a damaged line the characters that cannot be read are `illegible`. A conjecture has cert="low".

Source: TEI P5, chapters 11.3 (supplied, gap) and 3.5 (note).
"""

from collections.abc import Iterator
from itertools import groupby
from typing import Final
from xml.sax.saxutils import escape

from pdp8.thesis.evidence import Row
from pdp8.thesis.supplied import marked

_HEADER: Final = """<?xml version="1.0" encoding="UTF-8"?>
<TEI xmlns="http://www.tei-c.org/ns/1.0">
<teiHeader><fileDesc>
<titleStmt><title>{name}</title><author>Moses S. Wong</author></titleStmt>
<publicationStmt><p>pdp8 thesis evidence {name} --tei. The text is the author's.</p></publicationStmt>
<sourceDesc><bibl><author>Moses S. Wong</author>, <title>The Application of a Point-to-Point Numerical
Control Machine for Continuous Contour Cutting</title>, M.Eng. thesis, McMaster University,
<date when="1971-12">December 1971</date>; from the text of a scan.</bibl></sourceDesc>
</fileDesc></teiHeader>
<text><body>
"""


def tei(artefact: str) -> str:
    """Return the thesis's rows of an artefact as a TEI document. Raises WorkError if there is none."""
    pages = []
    for page, group in groupby(marked(artefact), key=lambda each: each[0].page):
        rows = list(group)
        lost = "" if any(row.scan for row, _ in rows) else '<gap reason="lost" unit="page"/>'
        lines = "".join(f"<ab>{''.join(_line(row, supplied))}</ab>\n" for row, supplied in rows)
        pages.append(f'<pb n="{page}"/>{lost}\n{lines}')
    return _HEADER.format(name=artefact) + "".join(pages) + "</body></text>\n</TEI>\n"


def _line(row: Row, supplied: list[bool]) -> Iterator[str]:
    """Yield a line's text, supplied or not, a run at a time, and the reason for it."""
    flags = iter(supplied)
    given, run = [], False
    for character in row.ours:
        run = run if character == " " else next(flags)
        given.append((run, character))
    reason = "illegible" if row.kind == "damaged" else "lost"
    opened = f'<supplied reason="{reason}" cert="{"low" if row.kind == "conjecture" else "high"}">'
    for is_supplied, characters in groupby(given, key=lambda each: each[0]):
        text = escape("".join(character for _, character in characters))
        yield f"{opened}{text}</supplied>" if is_supplied else text
    if row.reason:
        yield f"<note>{escape(row.reason)}</note>"
