"""What a notebook shows of a tape, a listing and a path: well-formed, and with what it is about."""

from xml.etree import ElementTree

import nc
import pal
from pdp8 import shelf
from tapes.notebook import Tape


def test_a_tape_is_bytes_and_shows_its_first_frames() -> None:
    frames = shelf.read("circle.eia")
    tape = Tape(frames)
    assert tape == frames
    assert (tape[1], type(tape[1:3]), bytes(tape[1:3])) == (0o040, Tape, frames[1:3])
    drawn = ElementTree.fromstring(tape[:21]._repr_svg_())
    holes = [circle for circle in drawn.iter("{http://www.w3.org/2000/svg}circle") if circle.get("r") == "36"]
    assert len(holes) == sum(frame.bit_count() for frame in frames[:21])
    assert tape._repr_svg_().count('r="23"') == 320
    assert ElementTree.fromstring(Tape()._repr_svg_()) is not None


def test_at_a_terminal_a_tape_is_rows_of_holes() -> None:
    assert str(Tape(b"\xc1")).splitlines()[1] == "       0    301  | o o       .     o |  A"


def test_a_listing_shows_every_line_and_marks_what_is_wrong() -> None:
    second = "*200\n\tTAD 300\t/A < B & C\n\tJMP 400\n\tJMP 600\n$\n"
    page = pal.assemble("/\n/\n/\n/\nPAUSE\n", second)._repr_html_()
    table, _, below = page.partition("</table>")
    rows = ElementTree.fromstring(table[table.index("<table") :] + "</table>").findall("tr")
    cells = [["".join(cell.itertext()) for cell in row] for row in rows]
    assert ["0200", "1300", "        TAD 300 /A < B & C"] in cells
    wrong = [row[2].text for row in rows if row.get("class") == "wrong"]
    assert wrong == ["        JMP 400", "        JMP 600"]
    taken, *errors = (said[:11] for said in below.removeprefix("<pre>").split("\n\n"))
    assert (taken, errors) == ("tape 1:1:2:", ["tape 2:3:2:", "tape 2:4:2:"]), "PAL8 would make links"


def test_a_path_draws_itself() -> None:
    drawn = ElementTree.fromstring(nc.cut(shelf.read("circle.eia")[:201])._repr_svg_())  # type: ignore[attr-defined]
    assert drawn.tag.endswith("svg")
