"""The workbench in a real browser, opened from disk, the network off."""

import base64
import json
import os
import re
import time
import zlib
from pathlib import Path
from typing import Any

import pytest

import pal
from pdp8 import shelf
from pdp8.computer.past.state import restore
from pdp8.computer.use.operator import RIM, RIM_START
from pdp8.replay import Afternoon
from tests.pdp8.web import small
from tests.pdp8.web.browsing import (
    AXE,
    DESK,
    Browser,
    Page,
    click,
    in_chromium,
    needs_axe,
    serious,
    until,
    visit,
)
from tests.pdp8.web.node import needs_node

_QUICK = ("10 times faster", "a minute a second", "as fast as it goes")
_HALTED = "!workbench.machine.processor.run"


def _write(page: Page, source: str) -> None:
    page.locator("#source").fill(source)
    click(page, "#assemble")


def _load(page: Page, source: str, speed: str = "as fast as it goes") -> None:
    page.locator("#speed").select_option(label=speed)
    _write(page, source)
    click(page, "#load")


def _registers(page: Page, names: str) -> list[int]:
    found: list[int] = page.evaluate(f"(({{ {names} }}) => [{names}])(workbench.machine.processor)")
    return found


def _says(page: Page, what: str) -> None:
    until(page, f"document.querySelector('#next').textContent.includes({what!r})")


def test_what_is_wrong_is_said_at_its_line(page: Page) -> None:
    """While it is typed; a click selects it. Such a program is not run, nor one that does not fit."""
    page.locator("#source").fill("*200\n\t5 + 3\n\tJMP NOPE\n$\n")
    until(page, "document.querySelectorAll('#gutter .error').length === 1")
    assert "undefined: NOPE" in page.locator(".typed em").last.inner_text()
    rows = page.evaluate("[...document.querySelectorAll('#gutter .line')].map((each) => each.innerText)")
    assert [row.split() for row in rows[1:3]] == [["2", "0200", "0007"], ["3", "0201", "5377"]]
    click(page, "#run-it")
    _says(page, "Not run: line 3, undefined: NOPE")
    colours = "[...document.querySelectorAll('#messages button')].map((each) => getComputedStyle(each).color)"
    assert len(set(page.evaluate(colours))) == 2, "a note is no error"
    page.locator("#messages button", has_text="error:").click()
    source = page.locator("#source")
    assert source.evaluate("(it) => it.value.slice(it.selectionStart, it.selectionEnd)") == "NOPE"
    _write(page, "*200\n\tHLT\n\tFIELD 1\n*200\n\tHLT\n$\n")
    click(page, "#run-it")
    _says(page, "10200")
    assert _registers(page, "run") == [0]
    for nothing in ("", "A,\n$\n"):
        _write(page, nothing)
        assert page.locator("#load").get_attribute("disabled") is not None
        click(page, "#run-it")
        _says(page, "Not run: no words")


def test_a_tape_is_loaded_as_an_operator_does(page: Page) -> None:
    """RIM toggled in, BIN through RIM, eia through BIN; the page does not wait. A tape over BIN is told."""
    page.locator("#sources").select_option("eia.pal")
    click(page, "#assemble")
    said = "eia.pal read by BIN: 335 frames, 131 words; 33.5 s"
    told = "document.querySelector('#next').textContent"
    assert said not in page.evaluate(f"document.getElementById('boot').click(), {told}")
    _says(page, said)
    core = page.evaluate("[...workbench.machine.processor.core]")
    words = pal.assemble(shelf.read_bundled("eia.pal")).words
    assert {address: core[address] for address in words} == words
    assert core[RIM_START : RIM_START + len(RIM) - 1] == list(RIM[:-1])
    assert _registers(page, "ma") == [0o200]
    _load(page, "*7700\n" + "\tJMP .\n" * 64 + "$\n")
    click(page, "#boot")
    _says(page, "BIN loader")


def test_the_panel_by_keyboard(page: Page) -> None:
    """At most twelve stops of the Tab key to the editor, a program assembled and all that can be done there.

    Digits go into the switches; S L D E C T press the keys that they name; MEM PROT keeps what is written.
    The drill stops the machine and lets no CONT run it; it names the wrong switch, and at its end how long
    the visitor took, while the machine stood still.
    """
    rocker, says = page.locator("#computer .rocker").first, page.locator("#drill-says")
    press = page.keyboard.type
    _load(page, "*200\n\tISZ 300\n\tJMP 200\n\tJMP 200\n$\n")
    rocker.focus()
    stops = 0
    while page.evaluate("document.activeElement.id") != "source":
        page.keyboard.press("Tab")
        stops += 1
        assert stops <= 12
    click(page, "#run-it", "#card summary", "#drill")
    assert _registers(page, "run") == [0]
    click(page, "#play")
    assert says.inner_text() == "LOAD ADD is next, not CONT"
    rocker.focus()
    press("7757l")
    assert "switch 11 should be down" in says.inner_text()
    press("7756l")
    assert says.inner_text() == "right: 7756 LOAD ADD"
    assert page.locator("#card .now").inner_text().startswith(f"{RIM[0]:04o}  DEP")
    page.wait_for_timeout(100)
    press("".join(f"{word:04o}d" for word in RIM))
    done = re.match(r"Done in (.*) s, 2 mistakes", says.inner_text())
    assert done
    assert float(done[1]) >= 0.1
    press("7756le")
    assert _registers(page, "pc, ma, mb") == [0o7757, 0o7756, RIM[0]]
    for keys, run in (("7756ls", 1), ("t", 0), ("c", 1), ("t", 0)):
        press(keys)
        assert _registers(page, "run") == [run]
    click(page, "[data-key='mem prot']")
    rocker.focus()
    press("7700ld")
    assert _registers(page, "run, protect") == [0, 1]


_MODIFIED = """() => {
  const { machine: { processor, teletype }, clock } = workbench;
  const state = () => String([..."sr run pc clock mem_prot sing_step".split(" ").map((of) => processor[of]),
    teletype.receiver.due, clock.speed, location.hash, document.activeElement.id]);
  const keys = [..." 01234567ABCDELSTWcx[]+-=", "ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown", "Home",
    "End", "Enter", "Escape", "Backspace", "F9"];
  const places = ["body", "#computer .rocker", "#computer .words button", "#time button", "[role=tab]",
    "#paper", "#core", "#blocks", "#drill"];
  const typed = { ctrlKey: /^[a-z]$/i, altKey: /^[^\\w ]$/ }; // control characters, signs
  const left = (at, more, pressed = { ...more, bubbles: true, cancelable: true }) =>
    at.emit?.("keydown", pressed) ?? at.dispatchEvent(new KeyboardEvent("keydown", pressed));
  const taken = [], all = places.flatMap((place) => keys.flatMap((key) =>
    ["altKey", "metaKey", "ctrlKey"].map((more) => [place, key, more])));
  for (const key of ["F5", "Shift", "é", "Tab"]) all.push(["#paper", key, "shiftKey"]);
  for (const [place, key, more] of all) {
    const at = document.querySelector(place), before = state();
    if (place === "#paper" && typed[more]?.test(key)) continue;
    if (!left(at, { key, [more]: true }) || state() !== before) taken.push(`${place} ${more} ${key}`);
  }
  const paper = document.querySelector("#paper"), altGr = { altKey: true, ctrlKey: true };
  if (!left(paper, { key: "V", ctrlKey: true, shiftKey: true })) taken.push("Ctrl-Shift-V");
  return taken.concat([..."@[q1"].filter((key) => !left(paper, { key, ...altGr })));
}"""


def test_a_key_with_a_modifier_is_the_browsers(page: Page) -> None:
    """Alt with an arrow goes back, Ctrl with a digit to another tab; nor has a Teletype F5 or é. AltGr, which
    is Ctrl and Alt on Windows, types @ and [ on some keyboards.
    """
    assert page.evaluate(_MODIFIED) == ["@", "["]


_NAMED = """() => {
  const wrong = [], seen = [], { room } = workbench, all = (at) => [...document.querySelectorAll(at)];
  const named = ({ ariaLabel, dataset, id, value }) => id || dataset.key || ariaLabel || value;
  const names = all("[aria-keyshortcuts]").map((each) => each.getAttribute("aria-keyshortcuts"));
  const keys = [...new Set(names.flatMap((each) => each.split(" ")))];
  const state = () => [workbench.machine.sr, room.tour?.turn].join();
  addEventListener("click", (event) => {
    seen.push(named(event.target));
    event.preventDefault();
    event.stopImmediatePropagation();
  }, true);
  const look = (scene, at, pressed, ...places) => {
    const letters = pressed.filter((key) => /^[A-Z]$/.test(key)).flatMap((key) =>
      [[key, "\u044b", `Key${key}`], [key, key.toLowerCase(), "KeyQ"]]); // Cyrillic, AZERTY
    for (const [key, typed = key, code] of [...pressed.map((key) => [key]), ...letters]) {
      const before = state();
      seen.length = 0;
      document.activeElement.blur();
      at.focus();
      at.press(typed === "Space" ? " " : typed, { code });
      const due = key === "Space" && at.matches("button") ? [at]
        : places.flatMap((place) => all(`${place} [aria-keyshortcuts~="${key}"]`));
      const wanted = String(due.filter((each) => each.checkVisibility()).map(named));
      const moved = !places.length && state() !== before;
      if (String(seen) !== wanted || moved) wrong.push([scene, key, ...seen]);
    }
  };
  const boxes = () => all("#room dialog").forEach((box) => {
    box.showModal();
    look(box.id, box.querySelector("button"), [...keys, ..."[]07+-", "Home", "End"]);
    box.close();
  });
  look("the desk", document.body, [...keys, ..."[]"], "#time");
  look("the panel", document.querySelector("#computer .rocker"), keys, "#computer");
  for (const each of all("main button, #time button, header button").filter((button) => !button.disabled)) {
    if (each.checkVisibility()) look(named(each), each, ["Space"]);
  }
  workbench.enter();
  look("the story", document.body, keys, "#room .told");
  boxes();
  const { body } = document, field = document.getElementById("where");
  const altGr = { altKey: true, ctrlKey: true };
  room.go({ value: 0 });
  const turns = [["["], ["]", body, altGr], ["]", body, { ctrlKey: true }], ["]", field], ..."]]]]]]]]"].map(
    ([key, at = body, more = {}]) => (at.press(key, more), room.tour.turn));
  room.take();
  look("the switches", document.body, keys, "#room .told", "#room .hand");
  boxes();
  for (let n = 0; n < 60 && !room.waits; n++) room.help();
  look("the punch", document.body, keys, "#room .told");
  return [room.waits, turns, wrong];
}"""


@needs_node
def test_a_key_presses_what_names_it(file: Path) -> None:
    """Where it is seen, and nothing behind a box; space the button that has the focus, and nothing else.

    Brackets lead from act to act, as far as there are.
    """
    with small.visit(file, DESK) as page:
        assert page.evaluate(_NAMED) == [True, [0, 1, 1, 1, *range(2, 8), 7, 7], []]


def test_tab_goes_through_the_page(page: Page) -> None:
    """And types nothing; it indents when somebody has begun to write, by Enter, click or character."""
    source, keys = page.locator("#source"), page.locator("#editor-keys")
    before = source.input_value()
    page.locator("#program-name").focus()
    for _ in range(32):
        page.keyboard.press("Tab")
    assert source.input_value() == before
    for begin, typed in (("Enter", ""), ("A", "A")):
        page.evaluate("document.activeElement.blur(); document.getElementById('source').focus();")
        page.evaluate("document.getElementById('source').setSelectionRange(0, 0)")
        assert "or a click begins to write" in keys.inner_text()
        page.keyboard.press(begin)
        page.keyboard.press("Tab")
        before = f"{typed}\t{before}"
        assert source.input_value() == before
        assert "Tab indents; Escape, then Tab, leaves" in keys.inner_text()
        page.keyboard.press("Escape")
        page.keyboard.press("Tab")
        assert page.evaluate("document.activeElement.id") != "source"
    source.click()
    page.keyboard.press("Control+Home")
    page.keyboard.press("Tab")
    if page.evaluate("!!document.execCommand"):  # a browser undoes it, and what was typed before
        page.keyboard.press("Control+z")
        assert source.input_value() == before
        page.keyboard.press("Tab")
    page.keyboard.press("Shift+Tab")
    assert source.input_value() == f"\t{before}"
    page.evaluate("workbench.editor.lay('eia.pal')")
    before = source.input_value()
    source.click()
    page.keyboard.press("Tab")
    assert source.input_value() == before


def test_what_is_printed_is_saved_whole(page: Page) -> None:
    """Also the lines above those that the page shows."""
    lines = [str(line) for line in range(999)]
    page.evaluate(
        "(codes) => { workbench.machine.teletype.printer.frames.extend(codes); workbench.show(); }",
        [0o200 | ord(each) for line in lines for each in f"{line}\r\n"],
    )
    with page.expect_download() as saved:
        click(page, "#save-page")
    assert saved.value.path().read_text().split() == lines


_WATCHED = "[...workbench.machine.watch.breakpoints]"
_ANEW = (
    "switches.press('stop')", "time.step({ value: 1 })", "time.step({ value: -1 })", "editor.load()",
    "editor.run()", "switches.card.toggle()", "drives.boot()", "time.toggle(); workbench.time.toggle()",
)  # fmt: skip
"""What ends a run to a goal; all but the first and the last end a practice, too."""


def test_run_until(page: Page) -> None:
    """It stops where the list says; a word is written over."""
    _load(page, shelf.read_bundled("hello.pal").decode("ascii"))
    click(page, "[data-opens=debugger]")
    page.locator("#kind").select_option("frame")
    click(page, "#until button")
    until(page, _HALTED)
    assert page.evaluate("workbench.machine.teletype.punch.frames.length") == 1
    page.locator("#kind").select_option("word")
    page.locator("#where").fill("10")
    click(page, "#until button")
    until(page, _HALTED)
    assert _registers(page, "pc") == [0o204]
    cell = page.locator("#core input").first
    cell.fill("1234")
    cell.press("Enter")
    click(page, "#core th >> nth=0")
    assert page.evaluate("workbench.machine.processor.core[0o200]") == 0o1234
    click(page, "[data-opens=program]")
    _load(page, "*200\n\tISZ 300\n\tJMP 200\n\tJMP 200\n$\n")
    click(page, "[data-opens=debugger]")
    page.locator("#kind").select_option("address")
    page.locator("#where").fill("10000")
    click(page, "#until button")
    _says(page, "no word 10000: core ends at 7777")
    page.locator("#where").fill("377")
    page.evaluate("workbench.drives.mount('a.tu56', new Uint8Array(380292))")
    for act in _ANEW:
        click(page, "#until button")
        assert page.evaluate(_WATCHED) == [0o377], "asked for again it is watched"
        page.evaluate(f"workbench.{act}")
        assert page.evaluate(_WATCHED) == [], act
    for act in _ANEW[1:-1]:
        page.evaluate(f"workbench.switches.card.practise(); workbench.{act}")
        assert page.evaluate("workbench.switches.card.coach") is None, act
    page.locator("#registers [aria-label=AC]").focus()
    written = "(it) => { it.value = '12'; workbench.machine.ac = 0o777; workbench.show(); return it.value; }"
    assert page.locator("#registers [aria-label=AC]").evaluate(written) == "12", "while it is written"


@pytest.mark.parametrize("speed", ["1000 times slower", "100 times slower", "as in 1971", *_QUICK])
def test_a_stop_says_its_reason(page: Page, speed: str) -> None:
    """At every speed: an address, a word that changes, HLT, MEM PROT, each by its name."""
    _load(page, "*200\n\tTAD A\n\tDCA B\n\tDCA I C\nA,\tHLT\nB,\t0\nC,\t7700\n$\n", speed)
    click(page, "[data-opens=debugger]", "[data-key='mem prot']")
    for kind, where, said in (
        ("address", "202", "breakpoint at 0202."),
        ("word", "204", "the word at 0204 has changed from 0000 to 7402."),
        ("word", "777", "MEM PROT stopped a write at 0202 into 7700. While MEM PROT is up, nothing writes"),
    ):
        page.evaluate("workbench.machine.load([[0o204, 0]]); workbench.machine.panel.load_address(0o200);")
        page.evaluate("workbench.machine.processor.lac = 0")
        page.locator("#kind").select_option(kind)
        page.locator("#where").fill(where)
        click(page, "#until button")
        until(page, _HALTED)
        _says(page, said)
    page.evaluate("workbench.machine.panel.load_address(0o203)")
    click(page, "[data-key=start]")
    _says(page, "HLT at 0203.")


def test_a_wait_names_what_is_waited_for(page: Page) -> None:
    """And offers what ends it: for the high-speed reader its list of tapes."""
    _load(page, "*200\n\t6011\n\tJMP .-1\n\tHLT\n$\n")
    click(page, "[data-key=start]")
    _says(page, "for a flag that nothing will raise. It waits for a frame from the high-speed reader at 0200")
    click(page, "#next button >> nth=0")
    assert page.evaluate("document.activeElement.id") == "pc8-shelf"
    _load(page, "*200\n\tKSF\n\tJMP .-1\n\tHLT\n$\n")
    click(page, "[data-key=start]")
    _says(page, "The program waits for a key at 0200.")
    click(page, "#computer .enlarge", "#next button >> nth=0")
    where = page.evaluate("document.activeElement.id + document.querySelector('main').className")
    assert where == ("typed" if page.evaluate("globalThis.navigator?.maxTouchPoints") else "paper")
    click(page, "#computer .enlarge")
    page.evaluate("workbench.mill.cut('circle.eia')")
    assert page.locator("#mill").is_visible()
    page.evaluate("workbench.switches.press('stop'); workbench.time.choose({ value: 'character' });")
    click(page, "#forward")
    _says(page, "The program waits for a key at 0200.")
    page.evaluate("workbench.machine.teletype.reader.lever(true); workbench.teletype.mount('circle.asc')")
    click(page, "#forward")
    assert page.evaluate("workbench.machine.teletype.reader.position") == 1, "the lever was thrown"


def test_a_pane_alone(browser: Browser, file: Path, circle_page: Path) -> None:
    """By ?embed=panel, where any other name shows all of them; by the button of a pane, and all again.

    An afternoon on the panel alone begins with the first switch.
    """
    for asked, shown, hidden in (
        ("panel", "#computer", "#program"),
        ("debugger", "#debugger", "#program"),
        ("teletype,mill", "#teletype", "#program"),
        ("nothing", "#program", ".none"),
    ):
        with visit(browser, f"{file.as_uri()}?embed={asked}{DESK}") as page:
            assert page.locator(shown).is_visible()
            assert page.locator("#time #play").is_visible()
            assert not page.locator(hidden).is_visible()
            if asked == "nothing":
                for count in (1, 5):
                    click(page, "#computer .enlarge")
                    assert page.locator("main > section:visible").count() == count
    playing = "!!window.workbench?.afternoon.playing"
    with visit(browser, f"{circle_page.as_uri()}?embed=panel", playing) as page:
        assert page.evaluate("workbench.afternoon.script.act.kind") == "toggle"


def test_a_screen_that_nobody_touches_begins_afresh(browser: Browser, circle_page: Path) -> None:
    """It plays again, each time, wherever the afternoon stood, and has nothing of the visitor before."""
    playing = "window.workbench?.ready && workbench.room.playing"
    with visit(browser, f"{circle_page.as_uri()}?rest=60", playing) as page:
        page.clock.install()
        for _ in range(2):
            page.mouse.move(1, 1)
            page.evaluate("workbench.room.leave(); workbench.programs.take('mine.pal', 'RUDE WORDS')")
            page.clock.run_for(50_000)
            page.mouse.move(2, 2)
            page.clock.run_for(50_000)
            assert page.evaluate("location.hash !== '' && workbench.programs.names().includes('mine.pal')")
            with page.expect_event("load"):
                page.clock.run_for(10_000)
            until(page, playing)
            assert page.evaluate("workbench.programs.names().includes('mine.pal')") is False
        page.evaluate("localStorage['pdp8 program: own'] = 1; workbench.programs.remove('own');")
        assert page.evaluate("localStorage['pdp8 program: own']") == "1", "it takes nothing away, either"


_CHANGES = """() => new Promise((done) => {
  let changes = 0;
  new MutationObserver((records) => (changes += records.length))
    .observe(document, { subtree: true, childList: true, attributes: true, characterData: true });
  const request = window.requestAnimationFrame;
  window.requestAnimationFrame = (then) => { changes++; return request(then); };
  setTimeout(() => done(changes), 500);
})"""


@in_chromium
def test_idle_costs_nothing(page: Page) -> None:
    """Afternoon or machine, standing still or waiting for a key: no picture is asked for, nothing changes."""
    _load(page, "*200\n\tKSF\n\tJMP .-1\n\tHLT\n$\n")
    for act, done in (
        ("", "true"),
        ("workbench.machine.panel.start(); workbench.touched();", "workbench.machine.waiting.endless"),
        ("workbench.afternoon.go(6e10);", "workbench.afternoon.on"),
    ):
        page.evaluate(f"() => {{ {act} }}")
        until(page, done)
        for _ in range(20):
            if not (changes := page.evaluate(_CHANGES)):
                break
        assert changes == 0, done


@in_chromium
@pytest.mark.slow("six translations of the circle, 15 s; `make leak SECONDS=600` goes on for ten minutes")
def test_nothing_leaks(page: Page) -> None:
    """The circle again and again at full speed: after it the heap and the nodes of the page are as before."""
    session = page.context.new_cdp_session(page)
    session.send("Performance.enable")
    page.locator("#speed").select_option(label="as fast as it goes")
    found = []
    for seconds in (
        0,
        float(os.environ.get("LEAK", "0")),
    ):  # first all is compiled and cached
        times, end = 0, time.monotonic() + seconds
        while times < 3 or time.monotonic() < end:
            page.evaluate("workbench.parts.name = 'circle.asc'; workbench.parts.translate();")
            until(page, "workbench.machine._out_of_tape()")
            times += 1
        page.wait_for_timeout(1000)  # the last picture is drawn
        session.send("HeapProfiler.collectGarbage")
        metrics = {each["name"]: each["value"] for each in session.send("Performance.getMetrics")["metrics"]}
        found.append((metrics["JSHeapUsedSize"] / 1e6, metrics["Nodes"]))
        print(f"{times} times; then {found[-1][0]:.2f} MB, {found[-1][1]} nodes")
    (heap, nodes), (heap_then, nodes_then) = found
    assert heap_then - heap < 4
    assert nodes_then - nodes < 10


@needs_axe
@pytest.mark.slow  # ten seconds a form
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(
    browser: Browser, circle_page: Path, circle: Afternoon, scheme: str
) -> None:
    """In every act, and on every tab, an error and a note among what is there."""
    with visit(browser, circle_page.as_uri() + DESK, color_scheme=scheme, bypass_csp=True) as page:
        page.add_script_tag(path=AXE)
        for act in circle.acts:
            page.evaluate("(tick) => workbench.afternoon.go(tick)", (act.starts + act.ends) // 2)
            assert serious(page) == [], act.name
        page.evaluate("workbench.afternoon.takeOver(); workbench.editor.create();")
        click(page, "[data-opens=program]")
        _write(page, "\tCLA!\n\t5 + 3\n$\n")
        for tab in page.get_by_role("tab").all():
            tab.click()
            assert serious(page) == [], tab.inner_text()


@pytest.mark.parametrize("speed", _QUICK)
def test_ticks_are_whole_at_every_speed(page: Page, speed: str) -> None:
    """hello.pal stops at the same tick; a state saved after a switch was thrown in it opens."""
    _load(page, shelf.read_bundled("hello.pal").decode("ascii"), speed)
    page.evaluate("workbench.download = (_, content) => { window.kept = content; }")
    click(page, "[data-key=start]", ".rocker >> nth=0", "#save")
    kept = restore(page.evaluate("window.kept")).processor
    assert isinstance(kept.clock, int)
    until(page, _HALTED)
    assert page.evaluate("workbench.machine.elapsed") == 1.68185355
    page.evaluate("workbench.take(new File([window.kept], 'a.state'))")
    _says(page, "It was running when it was saved" if kept.run else "The machine is stopped")


def test_step_back_shows_what_happened(page: Page) -> None:
    """Over a HLT, with a switch thrown in between, to where the history begins; a note does no harm."""
    _load(page, "*200\n\t7000 + 1\n\tHLT\n\tCMA\n\tHLT\n$\n")
    seen = []
    for button in ("#forward", "#forward", ".rocker >> nth=11", "#forward", "#back", "#back", "#back"):
        click(page, button)
        seen.append(_registers(page, "pc, lac, sr"))
    one, _, thrown, complemented, *back = seen
    assert (one[:2], complemented[:2]) == ([0o201, 1], [0o203, 0o7776])
    assert back == [thrown, one, [0o200, 0, one[2]]]
    click(page, "#back")
    _says(page, "cannot be undone: the history goes back 0")


def test_no_breakpoint_is_passed(page: Page) -> None:
    """On the first word that a JMS leads to, at every speed; START on one stops. The message names it."""
    speeds = ("100 times slower", "as in 1971", *_QUICK)
    for speed, address in ((speed, address) for speed in speeds for address in (0o210, 0o200)):
        _load(page, "*200\n\tJMS 210\n\tHLT\n*210\n\t0\n\tJMP I 210\n$\n", speed)
        page.evaluate("workbench.machine.watch.breakpoints.clear()")
        page.evaluate(f"workbench.machine.watch.breakpoints.add({address})")
        page.evaluate("workbench.machine.panel.load_address(0o200)")
        click(page, "[data-key=start]")
        until(page, _HALTED)
        _says(page, f"breakpoint at {address:04o}")
    assert _registers(page, "pc") == [0o200]


_STATE = {"format": "pdp8 state", "version": 2}


@pytest.mark.parametrize(
    ("shared", "said"),
    [
        (
            {"machine": _STATE | {"processor": {"clock": 1e20}}},
            "clock: 100000000000000000000 is not a number",
        ),
        (
            {"machine": _STATE | {"processor": {"run": 1, "clock": 4503599627370000}}},
            "It was running when it was saved",
        ),
        ({"machine": _STATE, "until": 1e15}, "until: 1000000000000000 instructions; 0 to"),
        ({"machine": _STATE, "until": "9"}, "until: 9 instructions; 0 to"),
        ({"machine": {"$tape": ["no.bin", 0, 9]}}, "cannot be opened"),
        ({"exercise": "nothing"}, "there is no exercise nothing"),
        ({"program": {"name": "a.pal"}}, "a value in it is not what the page expects there"),
        ({"program": {"name": "a.pal", "text": "A" * 1_000_000}}, "of 1\u202f000\u202f000 characters"),
        ({"program": {"name": "a.pal", "text": "\tCLA!\n" * 14_000}}, "The machine is stopped."),
    ],
)
def test_a_link_freezes_nothing(browser: Browser, file: Path, shared: dict[str, Any], said: str) -> None:
    """What is wrong with it is said, the page goes on, and nothing of it is remembered."""
    packed = zlib.compress(json.dumps(shared).encode(), wbits=-15)
    link = base64.urlsafe_b64encode(packed).decode().rstrip("=")
    with visit(browser, f"{file.as_uri()}#s={link}") as page:
        _says(page, said)
        assert page.locator("body").inner_text().count("cannot be opened") <= 1, "told twice"
        assert page.evaluate("location.hash") == DESK or said in (
            "It was running when it was saved",
            "The machine is stopped.",
        )
