"""The afternoon on the page, in a real browser, opened from disk."""

import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from pdp8.computer.hardware.signals import NEVER, TICKS_PER_SECOND
from pdp8.replay import Afternoon, clock
from tests.pdp8.web import small
from tests.pdp8.web.browsing import DESK, Page, click, in_chromium, until
from tests.pdp8.web.follower import Follower, state
from tests.pdp8.web.model import STALE
from tests.pdp8.web.node import needs_node, plain


@pytest.fixture(params=small.BOTH)
def page(request: pytest.FixtureRequest, circle_page: Path) -> Iterator[Page]:
    """The circle's page, on a projector or on the small document."""
    yield from small.opened(request, circle_page, DESK + "&t=0", viewport={"width": 1280, "height": 720})


def _now(page: Page) -> int:
    return int(page.evaluate("workbench.afternoon.script.now"))


def _go(page: Page, tick: int) -> None:
    page.evaluate("(tick) => workbench.afternoon.go(tick)", tick)


def _translating(circle: Afternoon, seconds: float = 100.05) -> int:
    lever = next(action.at for action in reversed(circle.actions) if action.key == "lever")
    return lever + round(seconds * TICKS_PER_SECOND)


_SHOWN = """() => {
  const word = (lit) => [...lit].reduce((word, bit) => word * 2 + Number(bit), 0);
  const { panel } = workbench.switches;
  const rockers = panel.hands.buttons.slice(0, 12).map(({ ariaChecked }) => ariaChecked === "true");
  const plain = (value) => value?.[Symbol.iterator] ? [...value] : value === 2 ** 62 ? null : value;
  return {
    lamps: Object.fromEntries([...panel.filaments.lit].map(([name, bits]) => [name, word(bits)])),
    switches: word(rockers),
    registers: Object.fromEntries([...document.querySelectorAll("[data-register]")].map((row) =>
      [row.dataset.register, row.querySelector("input")?.value ?? row.lastElementChild.textContent])),
    line: [document.querySelectorAll("#gutter [aria-current]").length,
      ...[...document.querySelectorAll("#gutter .now button, #gutter .now b")].map((each) => each.innerText)],
    state: Object.fromEntries([...workbench.machine.values().items()]
      .map(([name, value]) => [name, plain(value)])
      .filter(([name]) => !name.startsWith("waiting"))),
  };
}"""


@pytest.mark.slow("a hundred instants of the page, 20 s")
@pytest.mark.parametrize(
    "page",
    [
        pytest.param("node", marks=needs_node),
        pytest.param("chromium", marks=pytest.mark.rare("40 s; nothing is asked of the browser")),
    ],
    indirect=True,
)
def test_any_instant_is_that_of_the_machine(page: Page, circle: Afternoon) -> None:
    """In any order: lamps, switches, registers, current line, all of its state, as one that goes forward."""
    steps = [_translating(circle, 0.0773 + step * 0.00004) for step in range(30)]
    seconds = (0.0771, 0.0774, 0.1775, 99.97728, 1234.5678, *(50 + 0.10001 * each for each in range(30)))
    ticks = [action.at for action in circle.actions[::9]] + [act.ends for act in circle.acts]
    ticks = sorted({*ticks, *steps, *(_translating(circle, each) for each in seconds)})
    follower, expected = Follower(circle), {}
    for tick in ticks:
        follower.to(tick)
        machine = follower.machine
        whole = {name: None if each == NEVER else plain(each) for name, each in state(machine).items()}
        names = {name: f"{getattr(machine, name.lower()):04o}" for name in ("AC", "MA", "MB")}
        lit = machine.panel.lamps._asdict() | {"ema": machine.panel.ema}
        expected[tick] = lit, machine.sr, whole, {"L": str(machine.link), **names}
    words = {line.address: line.word for line in circle.programs["eia.pal"].lines}
    for tick in random.Random(71).sample(ticks, len(ticks)):
        _go(page, tick)
        shown = page.evaluate(_SHOWN)
        lamps, switches, whole, registers = expected[tick]
        assert (shown["lamps"], shown["switches"]) == (lamps, switches), f"at {clock(tick)}, tick {tick}"
        assert shown["state"] == whole, f"at {clock(tick)}, tick {tick}"
        if tick in steps:
            assert shown["registers"].items() >= registers.items()
            lit, address, word = shown["line"]  # one, wherever the listing was put away before
            assert (lit, int(word, 8)) == (1, words[int(address, 8)])


def test_the_tapes_are_those_on_the_desk(page: Page, circle: Afternoon) -> None:
    """The frame under each head is named, and a block's fields."""
    _go(page, circle.acts[4].ends - 1)
    assert "13\u202f321 frames" in page.locator("#punch .name").inner_text()
    named = page.locator("#reader canvas").get_attribute("aria-label")
    assert named == "the reader's tape, under the head: 377 RUBOUT"
    _go(page, circle.mill_starts + round(1.95 * TICKS_PER_SECOND))
    named = page.locator("#mill-reader canvas").get_attribute("aria-label")
    assert named == "circle.eia, frame 20 of 13\u202f321: 200 EOB"
    names, digits = (
        page.locator(f"#mill-block p > span {each}").all_inner_texts() for each in ("small", "b")
    )
    assert names == ["sequence", "prep.", "X", "Y", "res.", "tool", "misc.", "end"]
    assert digits == ["001", "0", "19000", "00000", "0", "00", "02", "↵"]
    _go(page, circle.acts[-1].ends)
    click(page, "[data-opens=mill]")
    assert page.locator("#whole-label").inner_text().startswith("circle.eia, block 666 of 666")
    assert "circle of 1.750 in about 4.000, 4.000" in page.locator("#close-label").inner_text()
    assert page.locator("#blocks li").count() == 666


def test_every_key_works(page: Page, circle: Afternoon) -> None:
    """Each presses the button that names it; the units have the arrows while they have the focus.

    Nothing rushes in slow motion, and no play is lost between frames.
    """
    press = page.keyboard.press
    for key, tick in (("End", circle.acts[-1].ends), ("Home", 0)):
        press(key)
        assert _now(page) == tick
    _go(page, _translating(circle))
    unit = page.locator("#units input:checked")
    units = {"block": 60_000_000, "character": 4_000_000, "instruction": 200, "cycle": 85}
    for number, (name, most) in enumerate(units.items(), 1):
        press(str(number))
        assert unit.get_attribute("value") == name
        before = _now(page)
        press("ArrowRight")
        after = _now(page)
        assert 0 < after - before <= most
        press("ArrowLeft")
        assert _now(page) < after
    speed = page.locator("#speed")
    chosen = speed.evaluate("(select) => select.selectedIndex")
    for key, by in (("+", 1), ("-", 0), ("-", -1)):
        press(key)
        assert speed.evaluate("(select) => select.selectedIndex") == chosen + by
    for key, end in (("-", 0), ("+", 10)):
        for _ in range(12):
            press(key)
        assert speed.evaluate("(select) => select.selectedIndex") == end
    speed.select_option(index=1)  # a millionth, cycle by cycle
    before = _now(page)
    press(" ")
    until(page, f"workbench.afternoon.script.now > {before + 40}")
    press(" ")
    assert not page.evaluate("workbench.afternoon.playing")
    assert _now(page) - before < 1000
    before = _now(page)
    page.locator("#units input[value=block]").focus()
    press("ArrowRight")
    assert (_now(page), unit.get_attribute("value")) == (before, "character")


@needs_node
def test_what_is_drawn_is_what_is_so(circle_page: Path, circle: Afternoon) -> None:
    """Each key as it is pressed and released, also where no lamp changes with it; another tape as long as the
    one before (stale.mjs).
    """
    pressed = [action.at for action in circle.actions if action.key in ("load add", "dep", "start")]
    ticks = [at + int(part * TICKS_PER_SECOND) for at in pressed[:3] for part in (0, 0.3, 0.5)]
    with small.visit(circle_page, DESK + "&t=0") as page:
        page.evaluate(STALE)
        page.wait_for_timeout(400)  # it knows its size now
        for tick in ticks:
            page.evaluate("(tick) => workbench.afternoon.go(tick)", tick)
            assert page.evaluate("stale()") == [], clock(tick)
        assert len(page.evaluate("workbench.switches.panel.canvas.lines")) > 20
    with small.visit(circle_page, DESK) as page:
        page.evaluate(STALE)
        for digit in "37":
            page.evaluate("(digit) => workbench.take(new File([`${digit} 2\\n`], 't.txt'))", digit)
            page.wait_for_timeout(400)
            tape = page.evaluate("[...workbench.machine.teletype.reader.tape]")
            assert tape[:5] == [0o260 + int(digit), 0o240, 0o262, 0o215, 0o212]
            assert page.evaluate("stale()") == [], digit


_UNFIT = """() => {
  const seen = [...document.querySelectorAll("body *")].filter((each) => each.checkVisibility());
  const all = (selector, unfit) => seen.filter((each) => each.matches(selector) && unfit(each));
  const box = (each) => each.getBoundingClientRect();
  const small = ({ width, height }) => width > 0 && (width < 24 || height < 24);
  const own = (each) => [...each.childNodes].some((node) => node.nodeType === 3 && node.data.trim());
  const cut = (each) => each.scrollWidth > each.clientWidth + 1;
  const targets = "button, input:not([type=file]), select, summary, a[href]:not(.skip)";
  return [
    ...all("main", () => document.documentElement.scrollWidth > innerWidth),
    ...all("#time", (each) => box(each).bottom > innerHeight + 1),
    ...all("#registers dd, .block span, #units span", cut),
    ...all(targets, (each) => small(box(each))),
    ...all(":not(.speed)", (each) => own(each) && parseFloat(getComputedStyle(each).fontSize) < 11),
  ].map((each) => each.outerHTML.slice(0, 99));
}"""

_LIVE = """() => {  // as at the first visit
  workbench.touched();
  for (const each of document.querySelectorAll("details")) each.open = true;
}"""


@in_chromium
@pytest.mark.slow("six sizes of screen, 5 s")
def test_it_fits_from_a_telephone_to_a_projector(page: Page, circle: Afternoon) -> None:
    """In every act and on every tab nothing is cut off; targets have 24 pixels, letters 11."""
    for width in (320, 390, 720, 768, 1024, 1261, 1280, 1366, 1440, 1920):
        page.set_viewport_size({"width": width, "height": 720})
        assert page.evaluate(_UNFIT) == [], width
        for act in circle.acts if width in (390, 1280) else ():
            _go(page, (act.starts + act.ends) // 2)
            assert page.evaluate(_UNFIT) == [], (width, act.name)
        page.evaluate(_LIVE)
        for tab in page.get_by_role("tab").all() if width in (390, 768, 1440, 1920) else ():
            tab.click()
            assert page.evaluate(_UNFIT) == [], (width, tab.inner_text())


def test_the_address_names_the_instant(page: Page) -> None:
    """It follows, and leads to it when it is changed; nonsense does no harm. The panel says its lamps."""
    _go(page, 10**10)
    until(page, "location.hash === '#workbench&t=500'")
    for address in (f"{DESK}&t=1000.5", f"{DESK}&t=1.2.3"):
        page.evaluate(
            "(address) => new Promise((done) => { location.hash = address;"
            " addEventListener('hashchange', () => setTimeout(done), { once: true }); })",
            address,
        )
        assert _now(page) == 1000.5 * TICKS_PER_SECOND
    assert page.locator("#clock").inner_text() == clock(_now(page))
    click(page, "#in-words")
    spoken = r"memory address [0-7]{4}, memory buffer [0-7]{4}, link [01], accumulator [0-7]{4}"
    assert re.match(spoken, page.locator("#computer .words p").inner_text())


_HIDDEN = """(hidden) => {
  Object.defineProperty(document, "hidden", { get: () => hidden, configurable: true });
  document.dispatchEvent(new Event("visibilitychange"));
}"""


@in_chromium
def test_a_page_that_slept_does_not_jump(page: Page) -> None:
    """A picture stands for a quarter of a second at most, and a page that is hidden pauses."""
    page.clock.install(time=0)
    page.clock.pause_at(1)
    page.locator("#speed").select_option(index=8)
    page.evaluate("workbench.afternoon.play(true)")
    page.clock.fast_forward(20_000)
    page.clock.run_for(20)
    assert 0 < _now(page) <= 60 * 60 * TICKS_PER_SECOND / 4
    page.locator("#speed").select_option(label="as in 1971")  # so that the afternoon does not end meanwhile
    page.evaluate("workbench.afternoon.play(true)")
    page.evaluate(_HIDDEN, True)
    assert not page.evaluate("workbench.clock.pictures.running")
    assert page.title() == "Stopped: PDP-8/L workbench"
    page.evaluate(_HIDDEN, False)
    assert page.title() == "PDP-8/L workbench"
    assert "everything stood still for" in page.locator("#said:not(.spoken)").inner_text()
    click(page, ".rocker >> nth=0")
    assert page.locator("#said:not(.spoken)").count() == 0


_NEARLY = """for (const [name, bits] of workbench.switches.panel.filaments.lit) {
  workbench.switches.panel.filaments.lit.set(name, bits.map(() => 0.9));
}"""


def test_lamps_are_as_bright_as_they_were_often_lit(page: Page, circle: Afternoon) -> None:
    """Halted, each is full or dark, and registers and line, written less often, are of the same instant."""
    _go(page, _translating(circle))
    page.locator("#speed").select_option(index=6)
    for _ in range(5):
        page.evaluate("workbench.afternoon.play(true)")
        until(page, f"Object.values(({_SHOWN})().lamps).some((word) => !Number.isInteger(word))")
        lamps = page.evaluate(_SHOWN)["lamps"]
        assert (lamps["run"], lamps["word_count"]) == (1, 0)
        page.evaluate(f"() => {{ {_NEARLY} workbench.afternoon.play(false); }}")
        word, at = page.evaluate(
            "(({ ma, pc, next }) => [ma, next % 3 ? pc - 1 : pc])(workbench.machine.processor)"
        )
        shown = page.evaluate(_SHOWN)
        assert shown["lamps"]["ma"] == word
        assert all(isinstance(lit, int) for lit in shown["lamps"].values())
        assert (shown["registers"]["MA"], shown["line"][1]) == (f"{word:04o}", f"{at:04o}")


def test_taken_over_and_brought_back(page: Page, circle: Afternoon) -> None:
    """Back at the afternoon what was done is undone; taken over again it can be stepped, and back."""
    tick = _translating(circle, 1234.5678)
    _go(page, tick)
    before = page.evaluate(_SHOWN) | {"line": None}  # that is drawn a little later
    for _ in range(2):
        click(page, ".rocker >> nth=0")
        assert not page.evaluate("workbench.afternoon.on || workbench.machine.processor.run")
        assert "You have taken over at" in page.locator("#next").inner_text()
        page.evaluate("workbench.machine.processor.deposit(0o200, 0); workbench.teletype.mount('hello.pal');")
        click(page, "#next [data-click='afternoon.back']")
        assert _now(page) == tick
        assert page.evaluate(_SHOWN) | {"line": None} == before
    click(page, ".rocker >> nth=0")
    clock = "workbench.machine.processor.clock"
    before = page.evaluate(clock)
    click(page, "#forward")
    assert page.evaluate(clock) > before
    click(page, "#back", "[data-opens=debugger]")
    assert page.locator("#core input").first.input_value() == f"{circle.programs['eia.pal'].words[0o200]:04o}"
    click(page, "[data-click='afternoon.back']", "#play", "#enter", "#leave")
    assert page.locator("#play").inner_text() == "Play", "a play ends where one goes into the room"


@in_chromium
def test_who_takes_over_has_all_of_the_machine(page: Page, circle: Afternoon) -> None:
    """A play waits while the slider is dragged.

    Taken over it runs on, to a breakpoint in the listing; there is a PC8/L, which the afternoon has not.
    """
    page.evaluate("workbench.afternoon.play(true)")
    page.locator("#slider").hover()
    page.mouse.down()
    held = _now(page)
    page.wait_for_timeout(200)
    assert _now(page) == held > 0
    page.mouse.up()
    until(page, f"workbench.afternoon.playing && workbench.afternoon.script.now > {held}")
    page.evaluate("workbench.afternoon.play(false)")
    _go(page, _translating(circle))
    page.locator("#speed").select_option(label="as in 1971")
    line = page.locator("#gutter button").first
    address = line.inner_text()
    click(page, "#play")
    line.click()
    assert not page.evaluate("workbench.afternoon.on")
    until(page, "!workbench.machine.processor.run")
    assert f"breakpoint at {address}" in page.locator("#next").inner_text()
    click(page, "#pc8 summary")
    page.locator("#pc8-shelf").select_option("circle.asc")
    page.evaluate("workbench.machine.load([[8, 0o6014], [9, 0o6011], [10, 0o5011], [11, 0o7402]])")
    page.evaluate("workbench.machine.start(8); workbench.machine.run(); workbench.touched();")
    assert page.locator("#pc8-reader").inner_text().startswith("1 of ")


_HASTE = """(() => {  // 10 ms pass at every look at the clock; what is done from turn to turn is noted
  const now = performance.now.bind(performance), frame = window.requestAnimationFrame.bind(window);
  const seen = window.seen = { looks: 0, most: 0, pictures: 0 };
  performance.now = () => now() + 10 * ++seen.looks;
  window.requestAnimationFrame = (show) => frame(() => {
    seen.pictures++;
    show(performance.now());
  });
  let looks = 0;
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    seen.most = Math.max(seen.most, seen.looks - looks);
    looks = seen.looks;
    port2.postMessage(0);
  };
  port2.postMessage(0);
})()"""


@in_chromium
def test_no_task_is_long(page: Page, circle: Afternoon) -> None:
    """By a clock on which all is late, the page has its turn after a unit or two of play, of run."""
    page.add_init_script(_HASTE)
    page.reload()
    until(page, "window.workbench?.ready && workbench.afternoon.on")
    page.locator("#speed").select_option(label="as fast as it goes")
    _go(page, _translating(circle))
    for button, passed, most in (
        ("#play", "workbench.afternoon.script.now", 15),
        (".rocker >> nth=0", "workbench.machine.processor.clock", 1 / 6),
    ):
        click(page, button)
        before = page.evaluate(f"seen.pictures = 0, {passed}")
        until(page, f"{passed} > {before + 10 * most * TICKS_PER_SECOND}")
        now, pictures = page.evaluate(f"[{passed}, seen.pictures]")
        assert (now - before) / pictures <= most * TICKS_PER_SECOND, button
    assert page.evaluate("seen.most") < 40
