"""What `pdp8 thesis make` leaves: whole sheets, texts with captions, a page that needs nothing else."""

import re
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

import nc
from pdp8.thesis import codes, flow, flowcharts, gallery, listings, slopes, work
from pdp8.thesis.catalogue import Item, catalogue, find
from pdp8.thesis.making import Made, make
from programs import fluidic
from tapes import eia, shelf
from tests.conftest import Shell

SVG = "{http://www.w3.org/2000/svg}"
DRAWN = [item for item in catalogue() if item.maker and item.kind == "figure"]
WRITTEN = [item for item in catalogue() if item.maker and item.kind != "figure"]


def texts(svg: str) -> Iterator[str]:
    """Yield what is written; a halo is drawn apart, and is not to be read."""
    for element in ET.fromstring(svg).iter(f"{SVG}text"):
        if "aria-hidden" not in element.attrib:
            yield element.text or ""


@pytest.mark.parametrize("item", DRAWN, ids=lambda item: item.number)
def test_a_figure_is_a_sheet_with_title_description_and_caption(item: Item) -> None:
    made = make(item)
    assert made.name == f"figure-{item.number}.svg"
    root = ET.fromstring(made.text)
    assert root.findtext(f"{SVG}title") == f"{item.name.upper()}: {item.title}"
    assert item.note in (root.findtext(f"{SVG}desc") or "")
    assert f"{item.name.upper()}  {item.title}" in list(texts(made.text))
    assert len(root.findall(f".//{SVG}title")) == 1
    assert "nan" not in made.text


@pytest.mark.parametrize("item", DRAWN, ids=lambda item: item.number)
def test_a_figure_s_identifiers_are_its_own(item: Item) -> None:
    svg = make(item).text
    names = re.findall(r'\bid="([^"]+)"', svg)
    assert len(names) == len(set(names))
    assert set(re.findall(r"url\(#([^)]+)\)", svg)) <= set(names)


@pytest.mark.parametrize("item", WRITTEN, ids=lambda item: item.number)
def test_a_text_has_its_caption(item: Item) -> None:
    made = make(item)
    first, second, *rest = made.text.splitlines()
    assert first == f"{item.name.upper()}  {item.title}"
    assert item.note in second
    assert len(rest) > 3


class Page(HTMLParser):
    """The identifiers, links, pictures and languages of a page."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.pictures: list[dict[str, str | None]] = []
        self.tags: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        named = dict(attrs)
        self.tags.append(tag)
        self.ids += [named["id"] or ""] if "id" in named else []
        self.links += [named["href"] or ""] if "href" in named else []
        self.pictures += [named] if tag == "img" else []


@pytest.fixture(scope="module")
def everything() -> dict[str, Made]:
    """Everything made: about 7 s, most of it inspections and plots."""
    return {item.number: make(item) for item in catalogue() if item.maker}


def test_the_page_shows_every_item_and_needs_nothing_else(everything: dict[str, Made]) -> None:
    text = gallery.page(everything)
    page = Page(text)
    assert {f"{item.kind}-{item.number}" for item in catalogue()} <= set(page.ids)
    assert len(page.ids) == len(set(page.ids))
    files = {name for made in everything.values() for name, _ in made.files}
    assert {link for link in page.links if not link.startswith("#")} == files
    assert {link[1:] for link in page.links if link.startswith("#")} <= set(page.ids)
    assert len(page.pictures) == len(DRAWN)
    assert all(str(picture["src"]).startswith("data:image/svg+xml;base64,") for picture in page.pictures)
    assert all(picture["alt"] for picture in page.pictures)
    assert not {"script", "link"} & set(page.tags)
    assert "{{" not in text


def test_the_files_of_all_have_names_of_their_own(everything: dict[str, Made]) -> None:
    names = [name for made in everything.values() for name, _ in made.files]
    assert len(names) == len(set(names))


def test_figure_3_1_has_the_slopes_of_the_two_ratios() -> None:
    said = " ".join(texts(slopes.wrong_slope()))
    assert "1.9 / 1.0 = 1.90: 27.8°" in said
    assert "4.0 / 2.7 = 1.48: 34.0°" in said


@pytest.mark.parametrize(
    ("figure", "stops"),
    [(slopes.piecewise, "ACDEFB"), (slopes.stepwise, "ACDEFGHB")],
    ids=["3.2", "3.3"],
)
def test_the_stops_are_those_the_chapter_names(figure: "type[object]", stops: str) -> None:
    named = [text for text in texts(str(figure())) if re.fullmatch("[A-H]", text)]
    assert sorted(named) == sorted(stops)


def test_the_new_codes_of_figure_5_3_are_those_stored_in_appendix_b() -> None:
    definitions = shelf.read("eia.pal").decode().partition("/DEFINITIONS:")[2]
    stored = [int(word, 8) for word in re.findall(r"^P(?:\d|CR),\t(\d+)", definitions, re.MULTILINE)]
    drawn = [int(code, 8) for code in re.findall(r"new code (\d{3})", flowcharts.third_program())]
    assert drawn == [*stored[:10], stored[0], stored[10]]


def test_the_constants_of_figure_5_3_are_those_stored_in_appendix_b() -> None:
    definitions = shelf.read("eia.pal").decode().partition("/DEFINITIONS:")[2]
    stored = re.findall(r"^M(?:[1-9]|SP|CR),\t(-?\d+)", definitions, re.MULTILINE)
    assert re.findall(r"add (-?\d+), zero", flowcharts.third_program()) == stored


def test_the_limits_of_figure_6_1_are_those_of_the_listing() -> None:
    listing = listings.circle()
    for limit in re.findall(r"R [≥≤] (\d+)", flowcharts.circle()):
        assert f"={limit}." in listing


def test_an_arrow_of_a_chart_ends_at_its_boxes() -> None:
    chart = flow.Chart(
        {"a": flow.Node(flow.PROCESS, "A", 0, 0), "b": flow.Node(flow.DECISION, "B", 0, 1)},
        (flow.Arrow("a", "b"), flow.Arrow("b", "a", "NO", out="W", into="W")),
    )
    root = ET.fromstring(flow.draw(chart, "two boxes"))
    box = root.findall(f"{SVG}rect")[1]
    bottom = float(box.attrib["y"]) + float(box.attrib["height"])
    down, back = (
        path.attrib["d"] for path in root.findall(f"{SVG}path") if path.attrib.get("fill") == "none"
    )
    assert re.match(rf"M\S+ {bottom:g}L", down)
    assert back.endswith(f"L{box.attrib['x']} {float(box.attrib['y']) + float(box.attrib['height']) / 2:g}")


def test_figure_5_4_is_one_block_before_and_after() -> None:
    before, after = codes.before_and_after()
    assert before.count("RUBOUT") == 6
    assert after.count("EOB") == 1


def test_the_polar_graphs_show_what_the_closing_block_does() -> None:
    """Figures of the note: .0173 at -X as the listing has it; .0106 is then the worst."""
    item = find("7.2")
    as_listed, closed = (" ".join(texts(graph)) for graph in work.polar_graphs())
    assert "worst trough to peak .0173 in: outer wall, -X apex" in as_listed
    assert "worst trough to peak .0106 in: outer wall, +Y apex" in closed
    assert ".0173" in item.note
    assert ".0106" in item.note


def test_the_die_s_tape_is_its_three_tapes() -> None:
    tape = work.die_tape()
    assert tape.count(eia.EOB) == listings.die().count("\n")
    assert len(tape) == 20 * tape.count(eia.EOB)
    assert nc.cut(tape).gap > 0


def test_a_straight_wall_has_no_steps() -> None:
    assert "outer wall, trough to peak .0000 in" in list(texts(work.straight_surface()))


def test_the_slope_measured_is_one_of_the_element_s() -> None:
    (x1, y1), (x2, y2) = work.slope_ends()
    ends = [segment for segment in fluidic.outline() if isinstance(segment, fluidic.Slope)]
    assert any(
        (round(x2 - x1, 6), round(y2 - y1, 6))
        == (round(s.end[0] - s.start[0], 6), round(s.end[1] - s.start[1], 6))
        for s in ends
    )


def test_the_list_names_every_item(shell: Shell) -> None:
    lines = shell("pdp8 thesis list").stdout.decode().splitlines()
    assert [line.split()[0] for line in lines[1:]] == [item.number for item in catalogue()]


def test_the_command_makes_one(shell: Shell, tmp_path: Path) -> None:
    done = shell("pdp8 thesis make 4.1 --out made")
    assert done.returncode == 0
    assert [file.name for file in (tmp_path / "made").iterdir()] == ["figure-4.1.svg"]


@pytest.mark.parametrize(
    ("line", "status", "message"),
    [
        ("pdp8 thesis make 4.2", 1, b"Figure 4.2: lost. Photograph, lost"),
        ("pdp8 thesis make 7.9", 1, b"7.9: no such figure"),
        ("touch there; pdp8 thesis make 4.1 --out there", 1, b"there"),
        ("pdp8 thesis make", 2, b"NUMBER|all"),
    ],
)
def test_what_cannot_be_made_is_said(shell: Shell, line: str, status: int, message: bytes) -> None:
    done = shell(line)
    assert done.returncode == status
    assert message in done.stderr
    assert b"Traceback" not in done.stderr
