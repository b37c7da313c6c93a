"""What the pages are made of and what they run, function by function, in Python."""

import base64
import hashlib
import json
import re
import zlib
from dataclasses import replace
from importlib.util import find_spec
from math import dist
from pathlib import Path
from typing import Any

import pytest

import nc
import pal
from nc.inspection import inspect
from pdp8 import shelf
from pdp8.lessons.course import COURSE
from pdp8.replay import replay
from pdp8.replay.day import Kind
from pdp8.web import bundle, curve, findings, method, names, parts, record, translator, workbench
from pdp8.web import kept as module
from pdp8.web.loosened import loosened
from pdp8.web.passing import passing
from programs import circle
from programs.stretches import Point
from tapes import ascii, codes, eia

SOURCE = shelf.read_bundled("eia.pal").decode("latin-1")
WORDS = pal.assemble(SOURCE).words
FEWEST = [*shelf.read_bundled("slope-fewest.eia")]


# The method.


def test_the_circle_loosened_is_what_its_program_prints() -> None:
    printed = circle.part(tolerance=100).replace(" ", "0")
    assert eia.decode(loosened(100, SOURCE)).strip() == printed.strip()


@pytest.mark.parametrize(
    ("made", "start", "end", "cuts"),
    [
        (method.pieces(2, 1, 2, 0.0, 0.0), (4000, 4000), (8330, 6500), 4),
        (method.fewest(FEWEST, 0.0, 0.0), (4000, 4000), (8330, 6500), 265),
        (method.slope(5.0), (4000, 4000), (8330, 6500), 408),
        (method.slope(5.0, angle=45.0), (4000, 4000), (7536, 7536), 443),
        (method.drawn([4000.0, 4100.0, 4200.0, 4000.0], 5.0), (2000, 4000), (2120, 4000), 79),
        (method.quarter(5.0, 3), (2250, 4000), (4000, 5750), 166),
        (method.circle(5.0), (2250, 4000), (2251, 3844), 660),
        (method.circle(5.0, close=True), (2250, 4000), (2250, 4000), 662),
    ],
)
def test_where_a_technique_leads(made: method.Made, start: object, end: object, cuts: int) -> None:
    assert ((made.way[0].x, made.way[0].y), (made.way[-1].x, made.way[-1].y)) == (start, end)
    assert made.reading * 60 == pytest.approx(2 * (cuts if made.text else 133))  # two seconds a block
    assert made.minutes == pytest.approx(made.reading + made.milling)
    assert len(made.way) == cuts + 1
    assert [place for place in made.stops if place not in made.way] == []
    assert made.blocks == (made.text.count("\n") or 139)


def test_errors_of_feeds_are_those_of_their_axes() -> None:
    """Code 1 is an inch a minute: 4.33 in take as many minutes, with 20 % less feed a quarter more."""
    assert method.SLOPE[1] == Point(8330, 6500)
    assert method.pieces(2, 1, 1, 0.0, 0.0).milling == pytest.approx(4.33)
    assert method.pieces(2, 1, 1, -0.2, 0.0).milling == pytest.approx(4.33 / 0.8)
    assert method.pieces(2, 1, 1, 0.0, -0.2).milling == pytest.approx(4.33)
    errors = ((0.0, 0.0), (-0.2, 0.0), (0.0, -0.2))
    proved = [method.fewest(FEWEST, *error).milling for error in errors]
    assert proved == pytest.approx([2.511, 2.519, 3.132], abs=1e-3)
    assert [method.slope(5.0, *error).milling for error in errors] == pytest.approx([6.83, 7.9125, 7.455])


def test_what_a_character_does() -> None:
    frames = ascii.encode(" 7\n")
    found = method.characters(WORDS.items(), frames)
    assert [each.character for each in found] == [*frames]
    punched = bytes(each.punched for each in found if each.punched is not None)
    assert b"\0" + punched == method.translated(WORDS.items(), frames).teletype.punch.tape
    assert found[0].rows[0].word == 0o6036
    assert all(each.rows[0].ac == each.character for each in found)
    assert [each.waited > 30_000 for each in found] == [True] * (len(found) - 1) + [False]
    assert found[-1].waited > 0
    assert all(WORDS[row.address] == row.word for each in found for row in each.rows if row.word >= 0o6000)


# What passes, what is found.


@pytest.mark.parametrize(
    ("text", "head", "texts"),
    [
        ("12\n34\n", -2, ["", "12↵"]),
        ("12\n34\n", 0, ["1", "2↵"]),
        ("12\n34\n", 2, ["12↵", ""]),
        ("12\n34\n", 3, ["3", "4↵"]),
        ("12\n34\n", 5, ["34↵", ""]),
    ],
)
def test_the_first_field_of_a_block(text: str, head: int, texts: list[str]) -> None:
    assert passing(eia.encode(text), head, codes.EIA)[:2] == texts
    assert passing(eia.encode(text), head, codes.EIA)[2:] == passing(b"", 0, codes.EIA)[2:]


def test_a_block_without_end_is_as_long_as_a_block() -> None:
    rows = sum(map(len, passing(b"", 0, codes.EIA)))
    assert passing(eia.encode("1" * (rows + 5)), 0, codes.EIA) == passing(
        eia.encode("1" * rows), 0, codes.EIA
    )
    assert "".join(passing(eia.encode("1" * (rows - 1)), rows - 2, codes.EIA)) == "1" * (rows - 1) + "·"
    spaces = bytes([0o240, 0o200, 0o71, 0o212, 0o215, 0o60])
    assert passing(spaces, 5, codes.ASCII)[:2] == ["0", "··"]
    assert passing(spaces[:5], 4, codes.ASCII)[:2] == ["09↵", ""]


def test_what_is_said_of_a_source() -> None:
    found = findings.checked("a.pal", "*200\n\tTAD FOO\n\t5 + 3\n\tJMP 400\n$\n")
    assert [each[:4] for each in found.diagnostics] == [
        (2, 5, 8, "error"),
        (3, 4, 5, "note"),
        (4, 1, 4, "error"),
    ]
    assert not found.ok
    assert found.summary.endswith("; 2 errors, 1 note.")
    assert found.more == 0
    good = findings.checked("a.pal", "*200\n\tHLT\n$\n")
    assert good.summary == f"1 word, a tape of {len(good.tape)} frames."
    assert findings.here("a; b --c; d") == "a; d"


# Names, modules, pages.


def test_a_name_is_used_as_a_value_and_not_as_a_key() -> None:
    text = "export const one = { two: 1, x: a.two };\nexport const two = 2;\nconst $three = 3;\n"
    one, two, three = text.splitlines(keepends=True)
    assert [names.needed(text, [name], []) for name in ("one", "two", "$three")] == [one, two, three]
    assert names.needed(text + "two.x = $three;\n", ["two"], []) == two + three + "two.x = $three;\n"


def test_a_method_is_needed_where_it_is_called() -> None:
    give = "give(String, {\n  a() {\n    return 1;\n  },\n  b(x) {\n    return x.c();\n  },\n  c() {},\n});\n"
    assert names.needed(give, ["x"], ["a"]) == give.replace("  b(x) {\n    return x.c();\n  },\n", "")
    assert names.needed(give, ["x"], ["b"]) == give.replace("  a() {\n    return 1;\n  },\n", "")


def test_what_a_module_exports() -> None:
    text = "export const { a, b: c } = d;\nexport class E {}\nexport async function f() {}\n"
    text += "export function* g() {}\nlet h;\n"
    assert names.exports(text) == ["a", "c", "E", "f", "g"]


def test_a_fault_is_found_in_whatever_module_is_imported(monkeypatch: pytest.MonkeyPatch) -> None:
    """At once or later, by hand or translated; what is translated may have a name of a function twice."""
    one = 'import { isa } from "../../../pal/isa.mjs";\nexport const one = 1;\nconst one = 2;\n'
    there = {
        "pdp8/web/workbench": 'import { one } from "./bench/one.mjs";\nimport("../../pal/isa.mjs");\n',
        "pdp8/web/bench/one": one,
        "pal/isa": 'import * as two from "./gone.mjs";\nexport const isa = 1;\nlet isa;\n',
    }

    def module(name: str) -> str:
        if name == "pal/gone":
            raise FileNotFoundError
        return there.get(name, "")

    monkeypatch.setattr(bundle, "module", module)
    monkeypatch.setattr(translator, "translated", lambda: {"pal.isa": ""})
    assert bundle.faults() == [
        "pal/isa.py: there is no module ./gone.mjs",
        "pdp8/web/bench/one.mjs: one is declared 2 times",
    ]


def _unpacked(html: str) -> dict[str, str]:
    """Return the scripts of a page, {id or "": text}."""
    found = re.findall(r"<script(?: id=\"(\w+)\" type=\"text/plain\")?>(.*?)</script>", html, re.DOTALL)
    return {
        name: zlib.decompress(base64.b64decode(text), -15).decode() if name else text for name, text in found
    }


def test_a_page_may_run_its_own_scripts_and_nothing_else(file: Path) -> None:
    html = file.read_text(encoding="utf-8")
    scripts = _unpacked(html)
    digests = {name: hashlib.sha256(text.encode()).digest() for name, text in scripts.items()}
    [policy] = re.findall(r'<meta http-equiv="Content-Security-Policy" content="(.*?)">', html)
    rules = dict(rule.split(" ", 1) for rule in policy.split("; "))
    run = [f"'sha256-{base64.b64encode(digests[name]).decode()}'" for name in ("code", "later", "")]
    assert rules.pop("script-src").split()[:3] == run
    assert rules == {
        "default-src": "'none'",
        "style-src": "'unsafe-inline'",
        "img-src": "data: blob:",
        "worker-src": "blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
        "require-trusted-types-for": "'script'",
        "trusted-types": "page start",
    }
    assert re.findall(r"<title>(.*?)</title>", html) == ["PDP-8/L workbench"]
    assert re.findall(r"<!-- [\w/.]+ -->", html) == []
    assert '<body class="room">' in html
    first, more = json.loads(scripts["record"]), json.loads(scripts["more"])
    assert (first["url"], first["view"], first["opens"]) == ("", "", 0)
    assert {*more} == {"exercises", "figures", "graph", "parts"}
    assert more.keys().isdisjoint(first)
    assert first["html"].count("<section") > 5
    assert first["style"].startswith(bundle.source("workbench.css"))


def test_what_pages_are_given(monkeypatch: pytest.MonkeyPatch) -> None:
    given: list[Any] = []

    def page(*of: Any) -> str:
        given[:] = of
        return ""

    monkeypatch.setattr(bundle, "page", page)
    workbench.page(("a.eia", b"\x01\xff"), url="https://a/")
    *_, first, _, kind = given
    assert (first["url"], first["view"], kind) == ("https://a/", "a.eia", "")
    assert first["tapes"] == workbench.record()["tapes"] | {"a.eia": "\x01\xff"}
    curve.page("there.html")
    assert given[:4] == ["A curve in ten minutes", "curve.html", ("curve.css",), "curve"]
    assert given[4]["workbench"] == "there.html"
    assert dict(given[4]["words"]) == WORDS
    assert [address for address, *_ in given[4]["listing"]] == [*WORDS]
    assert all(WORDS[address] == word for address, word, _ in given[4]["listing"])
    assert given[4]["fewest"] == FEWEST


def test_a_change_of_any_package_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    whole, found = module.house(), set[str]()
    for package in ("nc", "pal", "pdp8", "programs", "tapes"):
        others = lambda name, left=package: None if name == left else find_spec(name)  # noqa: E731
        monkeypatch.setattr(module, "find_spec", others)
        found.add(module.house())
    assert len({whole, *found}) == 6


# The record, the parts.


def test_the_record_of_the_usual_afternoon() -> None:
    done = replay("circle")
    found: dict[str, Any] = json.loads(json.dumps(record.record(done)))
    afternoon = found["afternoon"]
    assert (found["cutter"], found["opens"], found["view"]) == (500.0, 1, "")
    assert {name: (len(line), line[0], line[-1]) for name, line in afternoon["band"].items()} == {
        "inner": (361, [5745.0, 4000.0], [5745.0, 4000.0]),
        "nominal": (361, [5750.0, 4000.0], [5750.0, 4000.0]),
        "outer": (361, [5755.0, 4000.0], [5755.0, 4000.0]),
    }
    wall = afternoon["wall"]
    assert (wall["place"], wall["normal"], wall["off"]) == ([2004.1, 3871.3], [-0.9979, -0.0644], ".0173")
    assert [(len(line), line[0], line[-1]) for line in wall["lines"]] == [
        (61, [2017.5, 4155.68], [2052.78, 3596.4]),
        (61, [2000.21, 4157.04], [2035.81, 3592.88]),
    ]
    assert afternoon["acts"] == json.loads(json.dumps([act._replace(real=0.0) for act in done.acts]))
    assert afternoon["part"] == done.part == "circle"
    assert afternoon["millStarts"] == done.mill_starts
    computed = [name for name, frames in found["tapes"].items() if frames is None]
    assert computed == ["circle.eia", "ellipse.eia"]
    assert not any(name.endswith(".for") for name in found["tapes"])
    assert {*afternoon["read"]} == {"bin.rim", "eia.bin"}
    (amid, first), (end, last) = afternoon["machines"]
    translation = next(act for act in done.acts if act.kind == Kind.TRANSLATE)
    assert (amid, end) == ((translation.starts + translation.ends) // 2, translation.ends)
    assert first != last
    assert found["figures"].startswith('<thead><tr><th scope="col">')
    assert [*found["exercises"]] == [name for listed in COURSE.values() for name in listed.split()]


def test_steps_of_a_path_are_relative() -> None:
    assert record._steps("M0.3 10.2 L1 2 L1.5 -2 Z") == "M.3 10.2l.7-8.2 .5-4Z"
    assert record._steps("M1 1 L2 2 M3 3 L13 3") == "M1 1l1 1M3 3l10 0"


def test_a_piece_of_a_tape_is_written_as_its_place() -> None:
    tapes = {"a": b"abc", "b": b"bcd"}
    assert [record._written(each, tapes) for each in (b"bc", b"cd", b"x\xff", b"", 5)] == [
        ["a", 1, 3],
        ["b", 1, 3],
        "x\xff",
        "",
        5,
    ]


def test_the_fields_of_a_part() -> None:
    declared = {part["name"]: part for part in parts.declared()}
    drill = declared["drill"]
    assert drill["arguments"] == [["holes"], ["spindle"], ["z_feed_point"], ["z_depth"], ["z_feed"]]
    holes, spindle, point, *_ = drill["options"]
    about = {"name": "holes", "help": "X,Y of each hole in inches.", "spelling": "holes"}
    assert holes == {**about, "default": "1,1 1,2 4,2 4,1", "places": True}
    assert (spindle["whole"], point.get("whole"), point["unit"][:2]) == (True, None, ["INCHES", " in"])
    assert drill["form"].startswith(
        '<label>holes <input type="text" name="holes" title="X,Y of each hole in inches."'
        ' placeholder="1,1 1,2 4,2 4,1" size="24"><small></small></label><label>spindle <input type="text"'
        ' name="spindle" title="Spindle speed code of Table 2.4." placeholder="35" size="8"><small></small>'
        '</label><label>z feed point <input type="text" name="z_feed_point" title="Z where the feed begins."'
        ' placeholder="3" size="8"><small>in</small></label>'
    )
    form = declared["circle"]["form"]
    assert '<label>close <input type="checkbox" name="close" title=' in form
    assert "<option selected>step</option><option>piece</option></select>" in form
    own, shared = form.split("<details><summary>Milling and header</summary><div>")
    assert shared.endswith("</div></details>")
    assert ('name="radius"' in own, 'name="spindle"' in own, 'name="spindle"' in shared) == (
        True,
        False,
        True,
    )
    assert "<details>" not in drill["form"]
    [expression] = [each for each in declared["curve"]["options"] if each["name"] == "expression"]
    assert expression["required"]
    assert "default" not in expression


@pytest.mark.parametrize(("wall", "radius"), [("outer", 2000), ("inner", 1500)])
def test_a_wall_is_shown_where_it_is_worst(wall: str, radius: int) -> None:
    """The thesis's circle: 1.75 in about (4, 4), cut with .5 in; 250 thousandths of it to either side."""
    whole = inspect(nc.cut(shelf.read_bundled("circle.eia")))
    of = replace(whole, readings=tuple(each for each in whole.readings if each.wall == wall))
    found = record._wall(of)
    assert dist(found["place"], (4000, 4000)) == pytest.approx(radius, abs=0.1)
    for line, level in zip(found["lines"], (of.worst.lowest, of.worst.highest), strict=True):
        for end in (line[0], line[-1]):
            assert dist(end, (4000, 4000)) == pytest.approx(radius + level, abs=0.1)
            assert dist(end, found["place"]) == pytest.approx(250 * radius / 1750, rel=0.03)
