"""What is drawn, as it was when it was last looked at: acts in the room, the desk, the curve's figures."""

from pathlib import Path

import pytest

from pdp8.web import curve
from tests.pdp8.web import small
from tests.pdp8.web.node import needs_node
from tests.pictures import assert_looked_at

_DIGESTS = Path(__file__).with_name("looked.txt")
_ROOM = """async ([turn, part, wide, high]) => {
  const { room } = workbench;
  dom.size(wide, high);
  room.playing = false;
  room.go({ value: turn });
  room.tour.go(turn, part);
  workbench.afternoon.lead(room.tour.tick);
  room.show();
  await dom.pass(900);
  const lines = await dom.drawn(async () => (room.show(), await dom.pass(60)));
  return [...lines, document.querySelector(".when").textContent].join("\\n");
}"""
_DESK = """async () => {
  const { mill, parts, tabs } = workbench;
  const seen = [];
  await dom.pass(400);
  const look = async (act) => seen.push(...await dom.drawn(async () => {
    act();
    workbench.show();
    await dom.pass(300);
  }));
  await look(() => workbench.editor.run());
  await look(() => workbench.teletype.mount("circle.asc"));
  await look(() => mill.cut("circle.eia"));
  for (const value of [0.001, 0.2, 0.5, 0.77, 1]) {
    await look(() => mill.slide({ value }));
    seen.push(document.querySelector("#whole").innerHTML, document.querySelector("#close").innerHTML);
    seen.push(document.querySelector("#mill").innerText);
  }
  tabs.open("parts");
  parts.choose("drawn", {});
  seen.push(document.querySelector("#part-pad").innerHTML);
  return seen.join("\\n");
}"""
_FIGURE = """async ([name, wide]) => {
  const { figures: { [name]: figure } } = curve, seen = [];
  dom.size(wide, 600);
  const look = () => {
    figure.now();
    seen.push(figure.svg.getAttribute("viewBox"), figure.svg.innerHTML, figure.said.innerText);
    for (const [name, { x = 90, y = 80, to }] of Object.entries(figure.holds)) {
      seen.push(name, to({ x: x + 9, y: y - 8, dx: 9, dy: -8, start: 40 }).toPrecision(6));
    }
    seen.push(...figure.inputs.map((input) => input.parentElement.innerText));
  };
  look();
  for (const input of wide < 500 ? figure.inputs : []) {
    const { min, max, type, value } = input;
    if (type === "checkbox") input.click();
    else for (const to of [Number(min) + (max - min) * 0.3, max, value]) (input.value = to), look();
    look();
  }
  return seen.join("\\n");
}"""


def _looked_at(name: str, seen: str) -> None:
    noted = dict(line.rsplit(" ", 1) for line in _DIGESTS.read_text().splitlines())
    assert_looked_at(name, seen, noted.get(name, 12 * "?"))


@needs_node
@pytest.mark.parametrize("part", [0.3, pytest.param(0.8, marks=pytest.mark.slow("plays all acts"))])
def test_an_act(file: Path, part: float) -> None:
    with small.visit(file) as page:
        for turn in range(8):
            for wide, high in ((1000, 600), (400, 700))[: 2 if part < 0.5 else 1]:
                seen = page.evaluate(_ROOM, [turn, part, wide, high])
                assert len(seen) > 2000
                _looked_at(f"room {turn} {part} {wide}", seen)


@needs_node
def test_the_desk(file: Path) -> None:
    with small.visit(file, "#workbench") as page:
        _looked_at("desk", page.evaluate(_DESK))


@needs_node
@pytest.mark.slow("5 s")
def test_the_figures(tmp_path: Path) -> None:
    html = tmp_path / "curve.html"
    html.write_text(curve.page(), encoding="utf-8")
    with small.visit(html, entry="curve") as page:
        for name in page.evaluate("Object.keys(curve.figures)"):
            for wide in (390, 900):
                _looked_at(f"figure {name} {wide}", page.evaluate(_FIGURE, [name, wide]))
