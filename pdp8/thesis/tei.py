"""The evidence as TEI, for editors: what the scan shows, what it misreads, and what is supplied.

    <pb n="106"/><gap reason="lost" unit="page"/>                 a page that the scan has lost
    <ab><choice><sic>0205 3190</sic><corr>0205 3100 <supplied>DCA HOLD</supplied></corr></choice>
      <note>9 is no octal digit; ...</note></ab>                  the scan's line, the line as it was, why

What is supplied has cert="low" if it is a conjecture, a tag that is ours, an operand that may have been a
tag, or the wording of a table. `eia1.pal` and `eia2.pal` are ours: no page of the thesis has them.

Source: TEI P5, chapters 2 (header), 3.5 (sic, corr), 11.3 (supplied, gap); tests validate it by TEI's schema.
"""

import re
from collections.abc import Iterator
from itertools import groupby
from typing import Final
from xml.sax.saxutils import escape

from pdp8.thesis.catalogue import find
from pdp8.thesis.evidence import ARTEFACTS, TABLES, Row, read
from pdp8.thesis.supplied import marked

RECONSTRUCTIONS: Final = ARTEFACTS[1:3]
_HEADER: Final = """<?xml version="1.0" encoding="UTF-8"?>
<TEI xmlns="http://www.tei-c.org/ns/1.0">
<teiHeader><fileDesc>
<titleStmt><title>{title}</title>{author}
<respStmt><resp>{resp}</resp><orgName xml:id="pdp8">the pdp8 project</orgName></respStmt></titleStmt>
<publicationStmt><distributor>the pdp8 project</distributor><idno>pdp8 thesis evidence {name} --tei</idno>
<availability status="restricted">{licence}</availability></publicationStmt>
<sourceDesc><bibl><author>Moses S. Wong</author>, <title>The Application of a Point-to-Point
Numerical Control Machine for Continuous Contour Cutting</title>, M.Eng. thesis, McMaster University,
<date when="1971-12">December 1971</date>{where}; from the text of a scan</bibl></sourceDesc>
</fileDesc>
<encodingDesc><editorialDecl>{editorial}</editorialDecl></encodingDesc></teiHeader>
<text><body>
"""
_ITEMS: Final = dict(zip(ARTEFACTS, ("B", "ch5-1", "ch5-2", "C", "D"), strict=True))
_OURS: Final = '<licence target="https://opensource.org/license/mit">The MIT license.</licence>'
_HIS: Final = """<p>The text is Moses S. Wong's; what is supplied, notes and markup: the MIT license.</p>"""
_EDITORIAL: Final = """<p>The source is the text of a scan; the pictures of the pages were not at hand.
Legible lines are read by six rules (slashed zeros, points, spaces, boldface, stray marks, line numbers).
choice has the scan's text of a damaged line in sic, and in corr the line as it was; two lines that the scan
has run together are in the first one's sic. supplied is what the scan does not show: cert is "low" for a
conjecture, for tags, for operands that may have been tags, and for the wording of tables.</p>"""
_RECONSTRUCTED: Final = """<p>No listing of this program survives. A note says what each line is taken from:
pages 44 and 45, which describe the program, or the listing of the third program.</p>"""


def tei(artefact: str) -> str:
    """Return the thesis's rows of an artefact as a TEI document. Raises WorkError if there is none."""
    item, lines = find(_ITEMS.get(artefact, artefact)), list(marked(artefact))
    ours = artefact in RECONSTRUCTIONS
    header = _HEADER.format(
        name=artefact,
        title=f"{item.name}. {item.title}{', a reconstruction' if ours else ''}",
        author="" if ours else "<author>Moses S. Wong</author>",
        resp="reconstructed by" if ours else "supplied, corrected and annotated by",
        licence=_OURS if ours else _HIS,
        where=", pages 44 and 45" if ours else "",
        editorial=_RECONSTRUCTED if ours else _EDITORIAL,
    )
    reconstruction = (f"<ab>{escape(row.ours)}{_note(row)}</ab>\n" for row, _ in lines)
    body = "".join(reconstruction if ours else _pages(lines, artefact))
    return f"{header}{body}</body></text>\n</TEI>\n"


def _pages(lines: list[tuple[Row, list[bool]]], artefact: str) -> Iterator[str]:
    """Yield each page: its break, the gap if the scan has lost it, its lines."""
    tags = {row.ours.split()[2].rstrip(",") for row, _ in lines if "the tag is ours" in row.reason}
    for page, group in groupby(lines, key=lambda each: each[0].page):
        rows = list(group)
        yield f'<pb n="{page}"/>'
        yield "\n" if any(row.scan for row, _ in rows) else '<gap reason="lost" unit="page" quantity="1"/>\n'
        for row, supplied in rows:
            text = "".join(_runs(row, supplied, tags, artefact))
            if _is_misread(row, artefact):
                corr = f'<corr resp="#pdp8" cert="{_cert(row, artefact)}">{text}</corr>'
                text = f"<choice><sic>{escape(row.scan)}</sic>{corr}</choice>"
            yield f"<ab>{text}{_note(row)}</ab>\n"


def _is_misread(row: Row, artefact: str) -> bool:
    """Whether the scan shows this line with some other characters."""
    if row.kind == "damaged":
        return row.scan != "^"
    return artefact in TABLES and row.kind == "conjecture" and len(read(row.scan, artefact)) == len(row.ours)


def _cert(row: Row, artefact: str) -> str:
    return "low" if row.kind == "conjecture" or artefact in TABLES else "high"


def _note(row: Row) -> str:
    return f'<note resp="#pdp8">{escape(row.reason)}</note>' if row.reason else ""


def _runs(row: Row, supplied: list[bool], tags: set[str], artefact: str) -> Iterator[str]:
    """Yield a line's text in runs: as the scan shows it, or supplied with one certainty."""
    flags, usual = iter(supplied), _cert(row, artefact)
    reason = "illegible" if row.kind == "damaged" else "lost"
    given: list[tuple[str, str]] = []
    for word in re.findall(r"\S+|\s+", row.ours):
        cert = "low" if word.rstrip(",") in tags or word == ".-1" else usual
        for character in word:
            last = given[-1][0] if given else ""
            given.append((last if word.isspace() else cert if next(flags) else "", character))
    for cert, characters in groupby(given, key=lambda each: each[0]):
        text = escape("".join(character for _, character in characters))
        mark = f'<supplied resp="#pdp8" reason="{reason}" cert="{cert}">'
        yield f"{mark}{text}</supplied>" if cert else text
