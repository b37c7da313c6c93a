"""The desk: programs that are kept, what is typed, files and links, exercises and parts, in Chromium."""

import re
from itertools import product
from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.lessons import form, student
from pdp8.lessons.course import COURSE
from programs import circle
from tests.conftest import Call
from tests.pdp8.web import small
from tests.pdp8.web.browsing import DESK, Browser, Page, click, in_chromium, until, visit
from tests.pdp8.web.node import needs_node
from tests.pdp8.web.test_hostile import link

HALT = "*200\n\tHLT\n$\n"


def _reopened(page: Page) -> None:
    page.reload()
    until(page, "!!window.workbench?.ready")


def _drop(page: Page, name: str, content: str) -> None:
    page.evaluate("([name, content]) => workbench.take(new File([content], name))", [name, content])


def test_a_browser_that_keeps_nothing_says_so(page: Page) -> None:
    page.add_init_script("Storage.prototype.setItem = () => { throw new Error('forbidden'); };")
    _reopened(page)
    assert "does not keep programs for this page (forbidden)" in page.locator("#program-says").inner_text()
    page.locator("#source").fill(HALT)
    assert page.evaluate("workbench.editor.assemble()")


_DRAGGED = """(kind) => ["dragover", "drop"].map((each) => {
  const dragged = new Event(each, { bubbles: true, cancelable: true });
  dragged.dataTransfer = { types: [kind], files: [] };
  return document.getElementById("source").dispatchEvent(dragged);
})"""
_PASTED = """(length) => {
  const source = document.getElementById("source"), text = "A\\r\\n".repeat(length / 2);
  const pasted = new Event("paste", { cancelable: true });
  pasted.clipboardData = { getData: () => text };
  if (source.id === "source") source.setSelectionRange(1, 3);
  source.dispatchEvent(pasted);
  return [pasted.defaultPrevented, source.value?.length, source.value?.slice(0, 4), source.selectionStart];
}"""


def test_a_long_text_is_pasted_at_once(page: Page) -> None:
    """Where the selection was, and undone; a short one, or one dragged, by the browser, too long a one not.

    At the Teletype it is typed, with its line ends.
    """
    assert [page.evaluate(_DRAGGED, kind) for kind in ("text/plain", "Files")] == [[True] * 2, [False] * 2]
    page.locator("#source").fill(HALT)
    assert page.evaluate(_PASTED, 1998) == [False, len(HALT), HALT[:4], 1]
    assert page.evaluate(_PASTED, 2000) == [True, len(HALT) - 2 + 2000, "*A\nA", 2001]
    assert page.evaluate(_PASTED, 200_000)[1] == len(HALT) - 2 + 2000
    page.locator("#source").press("Control+z")
    assert page.evaluate("[workbench.editor.text, workbench.editor.area.selectionEnd]") == [HALT, 3]
    assert "200\u202f000 are allowed" in page.locator("#next").inner_text()
    put = "(length) => { try { workbench.editor.put('a.pal', '/'.repeat(length)); } catch { return false; } }"
    assert [page.evaluate(put, length) for length in (200_000, 200_001)] == [None, False]
    page.evaluate("workbench.editor.lay('eia.pal')")
    assert not page.evaluate(_PASTED, 2000)[0]
    for place in ("paper", "typed"):
        page.evaluate(_PASTED.replace('("source")', f'("{place}")'), 2)
        typed = page.evaluate("[...workbench.machine.teletype.keyboard.waiting]")
        assert typed[-2:] == [0o301, 0o215], place


_KEYS = """([text, ...pressed]) => {
  const { editor, machine } = workbench, source = document.getElementById("source"), seen = [];
  editor.put("keys.pal", text);
  editor.assemble();
  const run = editor.run;
  editor.run = () => seen.push("ran");
  for (const [key, line, more] of pressed) {
    if (key === "8K") workbench.drives.mount("a.tu56", new Uint8Array(380292));
    const at = text.split("\\n").slice(0, line).join("\\n").length, on = { bubbles: true, cancelable: true };
    source.setSelectionRange(at, at);
    source.emit?.("keydown", { key, [more]: true, ...on })
      ?? source.dispatchEvent(new KeyboardEvent("keydown", { key, [more]: true, ...on }));
    seen.push([key, editor.writing, ...machine.watch.breakpoints]);
  }
  editor.run = run;
  return seen;
}"""


def test_keys_of_the_editor(page: Page) -> None:
    """F9 at a line of a word in core, of any field that there is; Enter runs with Ctrl or the command key."""
    pressed = [("Escape", 1, ""), *(("F9", line, "") for line in (1, 2, 5, 2, 3))]
    pressed += [("c", 1, "ctrlKey"), ("v", 1, "metaKey"), ("b", 1, ""), ("Escape", 1, "")]
    pressed += [("Enter", 1, more) for more in ("shiftKey", "ctrlKey", "metaKey")]
    pressed += [("8K", 1, ""), ("F9", 3, ""), ("F9", 5, "")]
    seen = page.evaluate(_KEYS, ["*200\n\tCLA!CLL\n\tHLT\nFIELD 1\n\tHLT\n$\n", *pressed])
    points = [[], [], [0o200], [0o200], [], *([0o201] for _ in range(9)), [], [0o10200]]
    writes = [*[False] * 8, True, False, *[True] * 6]
    found = [[key, on, *at] for (key, _, _), on, at in zip(pressed, writes, points, strict=True)]
    assert seen == [*found[:11], "ran", found[11], "ran", *found[12:]]


def test_two_tabs_do_not_write_over_each_other(page: Page) -> None:
    """The later one says so and keeps both; a third that only looks writes nothing."""
    page.evaluate("(text) => workbench.editor.put('mine.pal', text)", HALT)
    tabs = [page.context.new_page() for _ in range(2)]
    for other in tabs:
        other.goto(page.url)
        until(other, "window.workbench?.editor?.name === 'mine.pal'")
    says = "document.getElementById('program-says').textContent"
    for tab in (tabs[0], page):  # both write the same
        tab.locator("#source").fill(HALT + "/ same\n")
        tab.evaluate("workbench.editor.keep()")
        until(tab, "workbench.programs.get('mine.pal').includes('same')")
        assert tab.evaluate("workbench.editor.name") == "mine.pal"
    _drop(tabs[0], "x.json", '{"title": "Another\'s", "task": "x"}')
    tabs[0].locator("#source").fill(HALT + "/ first\n")
    until(tabs[0], "workbench.programs.get('mine.pal').includes('first')")
    until(page, f"{says}.includes('mine.pal was changed in another tab')")
    assert "Another's" in page.locator("#exercise").inner_text()
    page.locator("#source").fill(HALT + "/ second\n")
    until(page, "workbench.editor.name === 'mine 2.pal'")
    assert "kept as mine 2.pal" in page.locator("#program-says").inner_text()
    click(tabs[1], "[data-click='editor.back']")
    assert "first" in tabs[1].evaluate("workbench.editor.text")
    tabs[0].evaluate("workbench.editor.begin('mine.pal'); workbench.editor.remove();")
    until(tabs[1], f"{says}.includes('mine.pal was deleted in another tab')")
    tabs[1].locator("#source").fill(HALT + "/ third\n")
    until(tabs[1], "workbench.programs.get('mine.pal')?.includes('third')")
    assert "second" in tabs[1].evaluate("workbench.programs.get('mine 2.pal')")
    page.evaluate("workbench.editor.lay('eia.pal')")
    tabs[0].evaluate("workbench.editor.begin('mine 2.pal'); workbench.editor.remove();")
    click(page, "[data-click='editor.back']")
    kept = page.evaluate("workbench.programs.get(workbench.editor.name) === workbench.editor.text")
    assert kept, "one that there is"
    for tab in (page, tabs[0]):
        tab.evaluate("workbench.editor.begin('mine.pal')")
    for tab in (tabs[0], page):
        tab.evaluate("workbench.editor.remove()")
    page.evaluate("workbench.editor.undo()")
    assert "third" in page.evaluate("workbench.editor.text")


def test_a_reload_loses_nothing(page: Page) -> None:
    """Machine, breakpoints, tapes, marks, answers, a loader half toggled in; a run stands still then.

    The next visit finds it again, too; what no browser keeps it asks about before it leaves.
    """
    page.evaluate("workbench.editor.put('mine.pal', '*200\\n\\tJMP .\\n$\\n'); workbench.editor.run();")
    page.evaluate("workbench.machine.watch.breakpoints.add(0o1234)")
    page.evaluate("workbench.teletype.mount(workbench.shelf.put('<mine>.asc', Uint8Array.of(177, 141)))")
    page.evaluate("workbench.exercises.open('read-a-frame'); workbench.tabs.open('exercises');")
    page.locator("#asked input").first.fill("270 & <b>")
    page.evaluate("workbench.exercises.open('add')")
    click(page, "#asked [data-click='exercises.begin']")
    page.locator("#source").fill(form.read("add").solution)
    click(page, "#asked .go")
    until(page, "document.getElementById('exercise').textContent.includes('✓ Add two words')")
    click(page, "#card summary", "#drill")
    page.locator("#computer .rocker").first.focus()
    page.keyboard.type("t7756l6032d")
    held = "[workbench.machine.processor.pc, ...workbench.machine.processor.core]"
    before = page.evaluate(held)
    for _ in range(2):
        page = _visited_again(page)
        assert page.evaluate(held) == before
        assert page.evaluate("[...workbench.machine.watch.breakpoints]") == [0o1234]
        assert page.evaluate("[...workbench.machine.teletype.reader.tape]") == [0o261, 0o215]
        assert page.locator("#reader .name").inner_text().startswith("<mine>.asc")
        assert page.evaluate("[workbench.editor.name, workbench.exercises.name]") == ["add.pal", "add"]
        assert "✓ Add two words" in page.locator("#exercise").inner_text()
        assert page.locator("#exercises").is_visible()
        page.locator("#computer .rocker").first.focus()
        page.keyboard.type("0d")
        assert "switch 0 should be up" in page.locator("#drill-says").inner_text()
        page.locator("#exercise").select_option("read-a-frame")
        assert page.locator("#asked input").first.input_value() == "270 & <b>"
        page.locator("#exercise").select_option("add")
    page.evaluate("() => { Storage.prototype.setItem = () => { throw new Error('full'); }; }")
    asked = page.evaluate("!dispatchEvent(new Event('beforeunload', { cancelable: true }))")
    assert asked


def _visited_again(page: Page) -> Page:
    """Reload the page, then come again in another tab, by the room, which leads a machine of its own."""
    _reopened(page)
    address = page.url.split("#")[0]
    other = page.context.new_page()
    other.goto(f"{address}?embed=panel{DESK}")  # panes in a frame have a machine and settings of their own
    until(other, "!!window.workbench?.ready")
    assert not other.evaluate("workbench.machine.processor.core.some(Boolean)")
    page.close(run_before_unload=True)
    other.goto(address)
    until(other, "!!window.workbench?.ready")
    assert other.evaluate("workbench.machine === workbench.afternoon.script.machine")
    other.evaluate("dispatchEvent(new Event('pagehide'))")
    click(other, "#leave")
    return other


_ASKS = {
    "checked": ("editor.text += '/'", "#messages", "editor.text += '/'"),
    "booted": ("editor.boot()", "#next", ""),
    "loosened": ("mill.loosen({ value: '5' })", "#loosened", "mill.cut('circle.eia')"),
    "marks": ("exercises.markOpen()", "#marks", "exercises.open('larger')"),
    "located": (
        "exercises.marked = workbench.editor.text; workbench.exercises.where({ value: 'x' })",
        "#next",
        "",
    ),
    "printout": ("parts.punch()", "#part-punched", ""),
    "translated": ("parts.mill('x.eia')", "#part-is-cut", ""),
}
"""{what a Worker is asked: (the statement that asks, where a refusal is said, what makes it out of date)}."""
_REFUSED = """(refused) => {
  const { apart } = workbench, ask = window.ask ??= apart.ask;
  const kept = (_, no) => (window.refuse = () => no(new Error(`${refused} is refused`)));
  apart.ask = (what, ...given) => (what === refused ? new Promise(kept) : ask.call(apart, what, ...given));
}"""


_ANSWERED = """() => {
  const { apart, drives, machine } = workbench, state = drives.bare(machine);
  const made = { booted: { state, said: "" }, located: { says: "", state, until: 0 }, printout: "1\\n" };
  apart.ask = async (what, ...given) => made[what] ?? window.ask.call(apart, what, ...given);
}"""


@pytest.mark.slow("waits for each answer twice")
def test_what_a_worker_refuses_is_said_where_it_was_asked(page: Page) -> None:
    """Whatever is asked; and nowhere once something else was opened; nor is another machine touched."""
    sources = "".join(file.read_text() for file in (Path(shelf.__file__).parent / "web").glob("bench/*.mjs"))
    assert set(re.findall(r'\bask\("(\w+)"', sources)) == set(_ASKS)
    page.wait_for_timeout(600)  # what is open at first has been looked at
    for name, (asks, place, then) in _ASKS.items():
        page.evaluate(_REFUSED, name)
        for later in ("", then) if then else ("",):
            page.evaluate(f"() => {{ window.refuse = null; workbench.{asks}; }}")
            until(page, "!!window.refuse")
            page.evaluate(
                f"() => {{ const {{ refuse }} = window; workbench.{later or 'show()'}; refuse(); }}"
            )
            refused = f"document.querySelector({place!r}).textContent.includes('{name} is refused')"
            if later:
                page.wait_for_timeout(100)
                assert not page.evaluate(refused), (name, later)
            else:
                until(page, refused)
            page.locator(place).evaluate("(it, later) => { if (later) it.textContent = ''; }", bool(then))
            page.wait_for_timeout(300)
    page.evaluate(_ANSWERED)
    for asks, _, _ in _ASKS.values():
        page.evaluate(f"() => {{ workbench.{asks}; workbench.enter(); }}")
        page.wait_for_timeout(200)
        assert page.evaluate("workbench.room.open && workbench.afternoon.on"), asks
        page.evaluate("workbench.room.leave()")


_DONE = (
    "editor.open('x.pal', workbench.shelf.get('hello.pal').frames); workbench.editor.run();",
    "teletype.key({ value: 65 }); workbench.teletype.lever(); workbench.teletype.punchOn();",
    "machine.teletype.reader.lever(true); workbench.teletype.mount('hello.pal');",
    "editor.run(); workbench.time.toggle(); workbench.time.toggle(); workbench.core.runUntil();",
    "drives.mount('one.tu56', new Uint8Array(380292));",
    "switches.press('sing step'); workbench.switches.press('mem prot'); workbench.switches.press('start');",
    "switches.card.practise(); workbench.switches.press('load add');",
    "switches.card.toggle(); workbench.switches.flip({ value: 3 }); workbench.switches.press('load add');",
    "editor.count({ checked: true }); workbench.editor.mark({ value: 130 }); workbench.editor.run();",
    "parts.name = 'circle.asc'; workbench.parts.translate();",
    "touch(({ highspeed: { punch, reader } }) => (reader.load([1, 2]), punch.frames.append(1)));",
)
"""What a visitor may do at the machine."""
_THERE = (
    r"machine |\.(?!program|speed|own)"
    r"|#(clock|why|play|next|computer|registers|paper|block@hidden|drill|reader|lever|punch|pc8|part)\b"
)
_CHANGED = """([before, there]) => {
  const now = walk.state(), all = [...new Set([...Object.keys(before), ...Object.keys(now)])];
  return all.filter((name) => new RegExp(`^(${there})`).test(name) && before[name] !== now[name])
    .map((name) => `${name}: ${now[name]}`);
}"""


_BACK = ("take(new File([window.held], 'a.state'))", "afternoon.go(3.8e10)")


@needs_node
@pytest.mark.slow("5 s")
def test_nothing_of_the_machine_before_is_left(file: Path) -> None:
    """A saved machine that is opened, and an instant of the afternoon, are the same whatever was done."""
    with small.visit(file, DESK) as page:
        printed = "{ for (let left = 40; left; left--) machine.teletype.printer.frames.append(65); }"
        page.evaluate(f"() => workbench.touch((machine) => {printed})")
        page.evaluate("() => { window.held = workbench.drives.bare(workbench.machine); }")
        page.evaluate(f"() => {{ workbench.{_BACK[1]}; workbench.editor.back(); workbench.touched(); }}")
        states: dict[str, dict[str, str]] = {}
        for done, back in product(("show();", *_DONE), _BACK):
            page.evaluate(f"() => {{ workbench.{done} }}")
            page.wait_for_timeout(400)
            page.evaluate(f"async () => {{ await workbench.{back}; }}")
            page.wait_for_timeout(400)
            if back == _BACK[1]:
                shown = page.evaluate("workbench.editor.area.readOnly && workbench.editor.text")
                assert shown == shelf.read_bundled("rim.pal").decode("ascii"), done
            before = states.setdefault(back, page.evaluate("walk.state()"))
            assert page.evaluate(_CHANGED, [before, _THERE]) == [], (done, back)


_LAST = """async () => {
  const { afternoon, editor, exercises, programs, room, tabs } = workbench, lost = [];
  const on = ({ dataset: { click, opens }, id }) =>
    id ? `#${id}` : opens ? `[data-opens=${opens}]` : `[data-click='${click}']`;
  exercises.open("add");
  tabs.open("exercises");
  exercises.begin();
  const buttons = ":is(#program .tools, #exercises) button, [data-opens=mill], #enter, #share";
  const all = [...document.querySelectorAll(buttons)]
    .filter((each) => each.checkVisibility() && !each.matches("#delete-program, #asked .go")).map(on);
  const acts = all.map((each) => [each, () => document.querySelector(each).point()]);
  acts.push(["a source", () => document.querySelector("#sources").choose("counter.pal")]);
  acts.push(["a file", () => workbench.take(new File(["/"], "b.pal"))]);
  acts.push(["the afternoon", () => afternoon.go(6e10)]);
  acts.push(["Delete and Undo", () => (editor.remove(), editor.undo())]);
  for (const [number, [name, act]] of acts.entries()) {
    if (room.open) room.leave();
    afternoon.takeOver();
    tabs.open("exercises");
    if (editor.area.readOnly || editor.name !== "add.pal") editor.begin("add.pal");
    editor.area.fill(`/ ${number} before\n`);
    await dom.pass(260);
    editor.area.fill(`/ ${number} last\n`);
    await act();
    await dom.pass(260);
    const texts = programs.names().map((each) => programs.get(each).trim());
    const found = texts.filter((each) => each === `/ ${number} last`).length;
    if (found !== 1 || texts.includes(`/ ${number} before`)) lost.push([name, ...texts]);
  }
  return [acts.length, lost];
}"""


@needs_node
def test_what_was_typed_last_is_kept_whatever_comes_next(file: Path) -> None:
    """Once, under its name; and what it was before is nowhere any more."""
    with small.visit(file, DESK) as page:
        count, lost = page.evaluate(_LAST)
        assert lost == []
        assert count > 10


@in_chromium
def test_an_exercise_stands_beside_its_program(page: Page) -> None:
    """In the order of a class, by level. Another program is not marked for the answer."""
    click(page, "[data-opens=exercises]")
    levels = page.locator("#exercise optgroup").evaluate_all("(all) => all.map(({ label }) => label)")
    assert levels == list(COURSE)
    page.locator("#exercise").select_option("larger")
    task, editor = page.locator("#asked").bounding_box(), page.locator("#source").bounding_box()
    assert task
    assert editor
    assert task["x"] + task["width"] <= editor["x"]
    click(page, "#asked .go")
    assert "hello.pal is open, and larger.pal is the answer." in page.locator("#marks").inner_text()
    click(page, "#marks [data-click='exercises.markOpen']")
    until(page, "document.getElementById('marks').textContent.includes('hello.pal: 0 of')")
    page.locator("#exercise").select_option("read-a-frame")
    assert not page.locator("#source").is_visible()
    page.set_viewport_size({"width": 900, "height": 800})
    page.locator("#exercise").select_option("larger")
    task, editor = page.locator("#asked").bounding_box(), page.locator("#source").bounding_box()
    assert task
    assert editor
    assert task["y"] + task["height"] <= editor["y"]


def test_where_it_went_wrong(page: Page, browser: Browser, tmp_path: Path, call: Call) -> None:
    """A button beside the case that failed, and the link of `pdp8 check --where`, lead to the place;
    from there the steps lead back to START. The line is marked, and nothing runs.
    """
    answer = tmp_path / "ben.pal"
    answer.write_text(form.read("add").solution.replace("DCA SUM", "DCA B"))
    click(page, "[data-opens=exercises]", "#asked [data-click='exercises.begin']")
    page.locator("#source").fill(answer.read_text())
    click(page, "#asked .go")
    click(page, "#marks h2 button >> nth=0")
    until(page, "document.getElementById('next').textContent.includes('B becomes 0014; 0007 is wanted')")
    status, said, _ = call("pdp8 check add ben.pal --where")
    assert status == 1
    link = next(line for line in said.splitlines() if "#s=" in line)
    with visit(browser, page.url.split("#")[0] + link[link.index("#") :]) as other:
        for tab in (page, other):
            until(tab, "!!document.querySelector('#gutter .now')")
            assert "DCA B" in tab.evaluate("workbench.editor.lines[workbench.editor.now - 1]")
            assert tab.evaluate("[workbench.machine.processor.run, workbench.machine.pc]") == [0, 0o203]
            for address in (0o202, 0o201, 0o200):
                click(tab, "#back")
                assert tab.evaluate("workbench.machine.pc") == address
            click(tab, "#back")
            assert "the history goes back 0" in tab.locator("#next").inner_text()
            click(tab, "#forward")
            assert tab.evaluate("workbench.machine.pc") == 0o201


@in_chromium
def test_it_prints_as_listing_and_figures(page: Page) -> None:
    """The whole listing, which no window shows, what the Teletype has printed, and the path; no control."""
    click(page, "#run-it")
    until(page, "workbench.machine.pc === 0o206 && !workbench.machine.processor.run")
    page.evaluate("workbench.mill.cut('circle.eia'); dispatchEvent(new Event('beforeprint'));")
    page.emulate_media(media="print")
    listing = page.locator("#printed pre").inner_text()
    assert "0205  7402" in listing
    assert "TEXT    0214" in listing
    shown = ("#printed", "#paper", "#whole", "#graph")
    assert [selector for selector in shown if not page.locator(selector).is_visible()] == []
    assert page.locator("button:visible, select:visible, input:visible, textarea:visible").count() == 0


_SHIFTED = """window.shifts = 0;
new PerformanceObserver((list) => list.getEntries().forEach((each) => {
  if (!each.hadRecentInput) window.shifts += each.value;
})).observe({ type: "layout-shift", buffered: true });"""


@pytest.mark.slow("opens six pages, and waits")
@pytest.mark.parametrize("opens", ["workbench", "t=3000"])
@pytest.mark.parametrize(("width", "height"), [(390, 844), (1366, 768), (1920, 1080)])
def test_nothing_moves_while_it_opens(
    browser: Browser, file: Path, width: int, height: int, opens: str
) -> None:
    """The layout shifts by less than .1 at the desk and at an instant, also where the processor is slow."""
    context = browser.new_context(viewport={"width": width, "height": height}, offline=True)
    page = context.new_page()
    page.add_init_script(_SHIFTED)
    context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": 4})
    page.goto(f"{file.as_uri()}#{opens}")
    until(page, "!!window.workbench?.ready")
    until(page, "document.getElementById('messages').textContent.includes('words')")
    page.wait_for_timeout(500)
    assert page.evaluate("window.shifts") < 0.1
    context.close()


_TYPED = """(area) => {  // the nodes that are made anew by each of 40 keys
  area.focus();
  area.setSelectionRange(500, 500);
  const seen = new MutationObserver(() => {});
  seen.observe(document, { subtree: true, childList: true });
  return Array.from({ length: 40 }, () => {
    document.execCommand("insertText", false, "A");
    const size = ({ childNodes }) => [...childNodes].reduce((sum, each) => sum + size(each), 1);
    return size({ childNodes: seen.takeRecords().flatMap(({ addedNodes }) => [...addedNodes]) });
  });
}"""


@in_chromium
def test_a_key_draws_as_much_in_a_thousand_lines_as_in_a_hundred(page: Page) -> None:
    """Of what is found the first hundred are shown, and what is drawn is what can be seen."""
    drawn = []
    for lines, more in ((1200, 1100), (150, 50)):
        page.evaluate("(text) => { workbench.editor.text = text; }", "*200\n" + "\t5 + 3\n" * lines + "$\n")
        until(page, f"document.getElementById('messages').textContent.includes('and {more:,} more')")
        drawn.append(max(page.locator("#source").evaluate(_TYPED)))
    assert drawn[0] == drawn[1] > 0


_COUNTS = """[...document.querySelectorAll("#gutter .line")].slice(1, 4)
  .map((line) => line.innerText.trim().split(/\\s+/)[3]).join()"""


def test_counts_and_the_current_line(page: Page) -> None:
    page.locator("#source").fill("*200\n\tISZ N\n\tJMP .-1\n\tHLT\nN,\t-5\n$\n")
    page.locator("#counts").check()
    click(page, "#run-it")
    until(page, "!workbench.machine.processor.run && workbench.machine.processor.pc === 0o203")
    until(page, f"{_COUNTS} === '5,4,1'")  # it is drawn a moment later
    page.evaluate("workbench.machine.pc = 0o201; workbench.touched();")
    assert page.locator("#gutter .now").inner_text().split()[:2] == ["3", "0201"]
    page.evaluate("workbench.tabs.open('mill')")
    _drop(page, "a.state", page.evaluate("workbench.drives.bare(workbench.machine)"))
    until(page, "workbench.machine.watch.observer === workbench.editor.counts")


@in_chromium
def test_a_link_holds_program_and_machine(page: Page, browser: Browser) -> None:
    """Another browser opens it; a bundled tape goes by its name, so it is short; foreign text stays text.

    One that is too long becomes a file.
    """
    page.locator("#source").fill("*200\n\tHLT\n/<img src=x onerror=alert(1)>&\n$\n")
    click(page, "#assemble", "#load")
    page.evaluate("workbench.teletype.mount('circle.asc')")
    click(page, "#share")
    until(page, "location.hash.startsWith('#s=')")
    assert len(page.url) < 1500
    with visit(browser, page.url, "window.workbench?.editor?.text.includes('onerror')") as other:
        assert other.evaluate("workbench.machine.processor.core[0o200]") == 0o7402
        assert other.locator("img[onerror]").count() == 0
        tape = other.evaluate("[...workbench.machine.teletype.reader.tape]")
        assert bytes(tape) == shelf.read_bundled("circle.asc")
    core = "workbench.machine.processor.core"
    page.evaluate(
        f"crypto.getRandomValues({core}).forEach((word, at, core) => {{ core[at] = word & 0o7777; }})"
    )
    with page.expect_download() as download:
        click(page, "#share")
    assert "allowed: here is a file instead" in page.locator("#next").inner_text()
    words = page.evaluate(f"[...{core}]")
    text = download.value.path().read_text()
    _reopened(page)
    _drop(page, "session.json", text)
    until(page, f"{core}[4095] === {words[4095]}")
    assert page.evaluate(f"[...{core}]") == words


@pytest.mark.slow("opens the page ten times")
def test_a_link_opened_anew_is_what_it_holds_and_a_reload_what_became_of_it(page: Page) -> None:
    """For who made it as for who opened it. One that comes into the page's address is opened there."""
    click(page, "#share")
    until(page, "location.hash.startsWith('#s=')")
    other = page.context.new_page()
    other.goto(page.url)
    until(other, "!!window.workbench?.ready")
    for tab in (page, other):
        assert tab.evaluate("workbench.machine.sr") == 0
        click(tab, "#computer .rocker >> nth=0")
        _reopened(tab)
        assert tab.evaluate("workbench.machine.sr") == 0o4000
    click(page, "#enter")
    page.evaluate("() => { location.hash = '#exercise=larger'; }")
    until(page, "workbench.exercises.name === 'larger' && history.state")
    page.evaluate("() => { workbench.exercises.open('echo'); workbench.enter(); }")
    page.evaluate("() => history.replaceState(true, '', '#exercise=larger')")  # as Back leads there again
    page.evaluate("() => { dispatchEvent(new Event('hashchange')); }")
    assert page.evaluate("[workbench.room.open, workbench.exercises.name, location.hash]") == [
        False, "echo", "#exercise=larger",
    ]  # fmt: skip
    part = {"name": "drill", "typed": {"holes": "1,1"}, "tape": "link.eia"}
    page.goto(page.url.split("#")[0] + link({"part": part}))
    until(page, "window.workbench?.mill?.name?.startsWith('link')")
    _reopened(page)
    until(page, "workbench.mill.name?.startsWith('link')")  # nothing keeps it: it is made again
    page.evaluate("(end) => { location.hash = end; }", link({"part": {"name": "slope"}}))
    until(page, "document.getElementById('part-name').value === 'slope'")


def test_an_exercise_of_a_teachers_is_dropped_and_marked(page: Page) -> None:
    """The form for students, without what is hidden, is marked by a Worker; a link leads to a bundled one."""
    exercise = form.read("delay", student.SEED)
    _drop(page, "homework.json", student.form(exercise))
    until(page, "workbench.exercises.name === 'homework.json'")
    click(page, "[data-click='exercises.begin']")
    assert page.evaluate("workbench.editor.name") == "homework.pal"
    page.locator("#source").fill(exercise.solution)
    click(page, "#asked .go")
    until(page, "document.getElementById('marks').textContent.includes('homework.pal: 3 of 3 points')")
    assert exercise.points == 6
    page.goto(page.url.split("#")[0] + "#exercise=read-a-frame")
    _reopened(page)
    assert page.locator("#asked code").inner_text() == "o   o o o .       "
    given = "async (long) => { await workbench.give('#'.padEnd(long, '_')); return workbench.why; }"
    assert page.evaluate(given, 8000) == ""
    assert page.evaluate(given, 8001).endswith("8\u202f001 characters, and 8\u202f000 are allowed")


_STOPPED = """() => {
  const punch = workbench.machine.teletype.punch;
  const look = () => {
    if (punch.frames.length <= 20) return requestAnimationFrame(look);
    window.speeds = [String(workbench.clock.speed), workbench.time.kept.speed];
    document.getElementById("play").click();
  };
  requestAnimationFrame(look);
}"""
"""Stop as soon as a translation has begun, which at its speed ends soon, and keep the speeds."""


def test_from_a_radius_to_a_wall(page: Page) -> None:
    """A small circle is punched, translated and cut by three buttons, while another program copies
    what is in the reader.

    Typed anew, it is refused.
    """
    copies = "*200\n\tKCC\n\tKSF\n\tJMP .-1\n\tKRB\n\tTLS\n\tJMP 201\n$\n"
    page.evaluate("(text) => { workbench.editor.put('a.pal', text); workbench.editor.run(); }", copies)
    says = "document.getElementById('part-punched').textContent.includes"
    click(page, "[data-opens=parts]")
    page.locator("[name=radius]").fill("0.25")
    click(page, "#part-punch")
    until(page, f"{says}('blocks: circle 2.asc')")
    until(page, "workbench.machine.teletype.reader.position > 15")
    page.evaluate("workbench.switches.press('sing step')")
    page.evaluate("workbench.machine.watch.breakpoints.add(0o210)")
    page.evaluate(_STOPPED)
    click(page, "#part-translate")
    until(page, "document.getElementById('part-translated').textContent.includes('Stopped: ')")
    assert page.evaluate("window.speeds") == ["Infinity", "1"]
    page.evaluate("workbench.parts.translate(); workbench.teletype.mount('circle.asc');")
    until(page, "!workbench.parts.translating && document.getElementById('part-cut').disabled")
    click(page, "#part-translate")
    page.evaluate("workbench.time.setSpeed(300)")
    until(page, "!document.getElementById('part-cut').disabled")
    assert page.evaluate("[...workbench.machine.watch.breakpoints]") == [], "it was another program's"
    assert page.evaluate("workbench.clock.speed") == 300, "who chose another one keeps it"
    click(page, "#part-cut")
    assert " s at the Hydra-Point" in page.evaluate("document.getElementById('part-is-cut').textContent")
    assert page.evaluate("workbench.mill.name") == "circle 2.eia"
    assert page.locator("#part-cut").get_attribute("disabled") is not None, "there is no tape any more"
    page.locator("[name=radius]").evaluate("(input) => { input.value = '1750'; }")
    page.evaluate("workbench.tabs.open('parts')")
    click(page, "#part-punch")
    until(page, f"{says}('for 1750 thousandths write 1.75')")


@pytest.mark.slow("computes circles on the page and here")
def test_a_circle_within_another_tolerance(page: Page) -> None:
    """The slider has its tape made by the whole chain: the wider it is, the fewer blocks."""
    click(page, "[data-opens=mill]")
    for value, thousandths in ((16, 500), (8, 30), (3, 5)):
        page.evaluate("(value) => workbench.mill.loosen({ value })", value)
        blocks = circle.part(tolerance=thousandths).count("\n")
        until(page, f"document.querySelectorAll('#blocks li').length === {blocks}")
    with page.expect_download() as download:
        click(page, "#save-cut")
    assert download.value.suggested_filename == "circle within 0.005 in.eia"
    assert download.value.path().read_bytes() == shelf.read_bundled("circle.eia")
