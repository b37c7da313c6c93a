"""Pictures that say true size, measured in what a browser prints; a tape for a laser, audited by ezdxf."""

import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
import zlib
from collections.abc import Iterator
from io import StringIO
from pathlib import Path

import pytest

from pdp8 import shelf
from tapes import cutting, paper, picture
from tapes.errors import TapeError
from tests.conftest import Call

CHROMIUM = shutil.which("chromium")
CIRCLE = shelf.read("circle.eia")
NUMBER = r"(-?[\d.]+)"


def printed(svg: Path) -> list[tuple[float, float]]:
    """Return the sizes in inches of all rectangles of an SVG that Chromium has printed, and of its pages."""
    pdf = svg.with_suffix(".pdf")
    options = ["--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer"]
    command = [str(CHROMIUM), *options, f"--print-to-pdf={pdf}", svg.as_uri()]
    subprocess.run(command, check=True, capture_output=True, timeout=300)
    found = pdf.read_bytes()
    boxes = re.findall(rb"MediaBox *\[0 0 ([\d.]+) ([\d.]+)\]", found)
    pages = [(float(width) / 72, float(height) / 72) for width, height in boxes]
    streams = re.findall(rb"FlateDecode.*?stream\r?\n(.*?)endstream", found, re.DOTALL)
    texts = [zlib.decompressobj().decompress(stream) for stream in streams]
    return [
        *pages,
        *(size for text in texts if b" cm" in text for size in _rectangles(text.decode("latin-1"))),
    ]


def _rectangles(content: str) -> Iterator[tuple[float, float]]:
    scale, saved = (1.0, 1.0), []
    for line in content.splitlines():
        if line == "q":
            saved.append(scale)
        elif line == "Q":
            scale = saved.pop()
        elif found := re.fullmatch(f"{NUMBER} 0 0 {NUMBER} \\S+ \\S+ cm", line):
            scale = scale[0] * float(found[1]), scale[1] * float(found[2])
        elif found := re.fullmatch(rf"\S+ \S+ {NUMBER} {NUMBER} re", line):
            yield abs(float(found[1]) * scale[0]) / 72, abs(float(found[2]) * scale[1]) / 72


@pytest.mark.skipif(CHROMIUM is None, reason="Chromium is not installed")
@pytest.mark.slow("a browser prints five drawings")
@pytest.mark.parametrize(
    ("line", "size", "page"),
    [
        ("tape show circle.eia --from 1 --to 80", (8, 1), None),
        ("tape show circle.eia --to 300 --paper a4", (7, 1), (210 / 25.4, 297 / 25.4)),
        ("tape show circle.asc --to 700 --paper letter", (7, 1), (8.5, 11)),
        ("nc plot circle.eia", (4.399, 4.41), (8, 11.656)),
        ("nc plot circle.eia --paper letter", (4.399, 4.41), (8.5, 11)),
    ],
)
def test_true_size_is_true_on_paper(
    line: str, size: tuple[float, float], page: tuple[float, float] | None, call: Call, tmp_path: Path
) -> None:
    target = tmp_path / "drawn.svg"
    assert call(f"pdp8 {line} {'-o' if line.startswith('nc') else '--svg'} {target}")[0] == 0
    sizes = printed(target)
    assert any(found == pytest.approx(size, abs=0.001) for found in sizes), sizes[:20]
    assert page is None or sizes[0] == pytest.approx(page, abs=0.01)


def test_pages_have_the_whole_tape_and_a_ruler() -> None:
    page = ET.fromstring(picture.pages(CIRCLE, "eia", 0, 1000, "a4"))
    circles = [each for each in page.iter() if each.tag.endswith("circle")]
    assert len(circles) == sum(frame.bit_count() + 1 for frame in CIRCLE[:1000])
    drawn = [float(each.attrib["height"]) for each in page if each.tag.endswith("svg")]
    assert max(drawn) < paper.area("a4")[1] * 96 < sum(drawn[:2])
    rulers = [each.text for each in page.iter() if "100 mm" in (each.text or "")]
    assert rulers == [f"100 mm: print at 100 %; page {number} of 3" for number in (1, 2, 3)]
    placed = [float(each.attrib["y"]) * 25.4 / 96 // 297 for each in page if "y" in each.attrib]
    assert placed == [0, 0, 1, 1, 2, 2]


@pytest.mark.parametrize("paper", ["a4", "letter"])
@pytest.mark.parametrize("tape", ["circle", "ellipse"])
def test_a_plot_is_one_page(paper: str, tape: str, call: Call) -> None:
    """The part in true size; the close view takes what room is left."""
    assert re.findall(r"page 1 of \d+", call(f"pdp8 nc plot {tape}.eia --paper {paper}")[1]) == [
        "page 1 of 1"
    ]


def test_a_drawing_has_a_limit() -> None:
    with pytest.raises(TapeError, match="20,001 frames: a drawing has 20,000 at most"):
        picture.svg(bytes(20_001))
    with pytest.raises(TapeError, match="20,001 frames: a drawing has 20,000 at most"):
        cutting.svg(bytes(20_001))


def test_a_tape_for_a_laser() -> None:
    """Two strips; the same holes in both formats, in millimetres; nothing but outline and holes."""
    frames = CIRCLE[:100]
    holes = sum(frame.bit_count() + 1 for frame in frames)
    drawn = ET.fromstring(cutting.svg(frames))
    tags = [each.tag.partition("}")[2] for each in drawn]
    assert (tags.count("rect"), tags.count("circle"), len(tags)) == (2, holes, holes + 2)
    assert drawn.attrib["width"] == "203.200mm"
    ezdxf = pytest.importorskip("ezdxf")
    document = ezdxf.read(StringIO(cutting.dxf(frames)))
    assert not document.audit().has_errors
    circles = document.modelspace().query("CIRCLE")
    radii = sorted({round(circle.dxf.radius * 2 / 25.4, 4) for circle in circles})
    assert (len(circles), radii) == (holes, [0.046, 0.072])
    outlines = [[(x, y) for x, y, *_ in line.points()] for line in document.modelspace().query("POLYLINE")]
    assert [max(x for x, _ in outline) for outline in outlines] == pytest.approx([203.2, 50.8])
    spans = [(min(y for _, y in outline), max(y for _, y in outline)) for outline in outlines]
    places = [sum(low < circle.dxf.center.y < high for low, high in spans) for circle in circles]
    assert {*places, *(round(high - low, 4) for low, high in spans)} == {1, 25.4}
