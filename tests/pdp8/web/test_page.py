"""The afternoon on the page, in a real browser, opened from disk."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.replay import Afternoon, clock
from tests.pdp8.web.browsing import drawn, until
from tests.pdp8.web.follower import Follower

if TYPE_CHECKING:
    from playwright.sync_api import Browser, Page

PROJECTOR, PHONE = (1280, 720), (390, 844)


@pytest.fixture
def page(browser: "Browser", circle_page: Path) -> "Iterator[Page]":
    """The circle's page on a projector; the test fails if the page complains or asks for anything else."""
    opened = browser.new_page(viewport={"width": PROJECTOR[0], "height": PROJECTOR[1]})
    complaints: list[str] = []
    opened.on("console", lambda message: complaints.append(message.text))
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.on("request", lambda request: complaints.append(request.url) if _outside(request.url) else None)
    opened.goto(circle_page.as_uri() + "#t=0")
    until(opened, "!!window.workbench?.afternoon.on")
    yield opened
    opened.close()
    assert complaints == []


def _outside(url: str) -> bool:
    return not url.startswith(("file:", "data:", "blob:"))


def _now(page: "Page") -> int:
    return int(page.evaluate("workbench.afternoon.script.now"))


def _go(page: "Page", tick: int) -> None:
    page.evaluate("(tick) => workbench.afternoon.go(tick)", tick)


def _translating(circle: Afternoon, seconds: float = 100.05) -> int:
    lever = next(action.at for action in reversed(circle.actions) if action.key == "lever")
    return lever + round(seconds * TICKS_PER_SECOND)


_LAMPS = """() => {
  const word = (lit) => [...lit].reduce((word, bit) => word * 2 + Number(bit), 0);
  const lamps = Map.groupBy(document.querySelectorAll("[data-lamp]"), ({ dataset }) => dataset.lamp);
  lamps.delete("ema");
  const lit = (bits) => word(bits.map(({ classList }) => classList.contains("on")));
  const shown = [...lamps].map(([name, bits]) => [name, lit(bits)]);
  const rockers = [...document.querySelectorAll(".rocker")].map(({ classList }) => classList.contains("up"));
  return Object.fromEntries([...shown, ["sr", word(rockers)]]);
}"""


def test_the_lamps_are_the_processors(page: "Page", circle: Afternoon) -> None:
    """While RIM is toggled in, tapes load, characters are translated and afterwards."""
    ends = [act.ends for act in circle.acts]
    instants = sorted(
        [action.at for action in circle.actions[::7]]
        + [_translating(circle, seconds) for seconds in (0.0771, 0.0773, 0.0774, 0.1775, 99.97728, 1234.5678)]
        + [
            _translating(circle, 50 + 0.1 * character + 0.07730 + 0.00001 * character)
            for character in range(40)
        ]
        + ends
    )
    follower = Follower(circle)
    for tick in instants:
        follower.to(tick)
        _go(page, tick)
        expected = {**follower.machine.panel.lamps._asdict(), "sr": follower.machine.sr}
        assert page.evaluate(_LAMPS) == expected, f"at {clock(tick)}, tick {tick}"


def test_a_block_is_shown_by_its_fields(page: "Page", circle: Afternoon) -> None:
    """The first block under the head of the Hydra-Point: digits above their names."""
    _go(page, circle.mill_starts + round(1.95 * TICKS_PER_SECOND))
    cells = page.locator("#mill-block p > span").all()
    shown = {cell.locator("small").inner_text(): cell.locator("b").inner_text() for cell in cells}
    assert list(shown.items()) == [
        ("sequence", "001"), ("prep.", "0"), ("X", "19000"), ("Y", "00000"),
        ("res.", "0"), ("tool", "00"), ("misc.", "02"), ("end", "↵"),
    ]  # fmt: skip


def test_registers_and_listing_stand_beside_the_lamps(page: "Page", circle: Afternoon) -> None:
    """L, AC, MA, MB are written in octal, and the line of Appendix B is lit that is being done."""
    lines = {line.address: line for line in circle.programs["eia.pal"].lines if line.address is not None}
    follower = Follower(circle)
    for step in range(30):
        tick = _translating(circle, 0.0773 + step * 0.00004)
        follower.to(tick)
        _go(page, tick)
        machine = follower.machine
        shown = page.evaluate(_REGISTERS)
        assert (shown["L"], shown["AC"]) == (str(machine.link), f"{machine.ac:04o}")
        assert (shown["MA"], shown["MB"]) == (f"{machine.ma:04o}", f"{machine.mb:04o}")
        address, word = page.locator("#gutter .now button, #gutter .now b").all_inner_texts()
        assert int(word, 8) == lines[int(address, 8)].word


_REGISTERS = """() => Object.fromEntries([...document.querySelectorAll("[data-register]")].map((row) =>
  [row.dataset.register, row.querySelector("input")?.value ?? row.lastElementChild.textContent]))"""


def test_what_has_keys_of_its_own(page: "Page", circle: Afternoon) -> None:
    """The units have the arrows while they have the focus; the rail and the slider lead to instants."""
    _go(page, _translating(circle))
    before = _now(page)
    page.locator("#units input[value=block]").focus()
    page.keyboard.press("ArrowRight")
    assert _now(page) == before
    assert page.locator("#units input:checked").get_attribute("value") == "character"
    page.locator("#acts span").nth(2).click()
    assert _now(page) == circle.acts[2].starts
    page.locator("#slider").evaluate(
        "(slider) => { slider.value = 1e10; slider.dispatchEvent(new Event('input')); }"
    )
    assert _now(page) == 10**10
    page.locator("#speed").select_option(index=9)
    page.locator("#play").click()
    until(page, "workbench.afternoon.script.now > 1e10 + 20e6 * 10")
    page.locator("#play").click()
    stopped = _now(page)
    page.wait_for_timeout(200)
    assert _now(page) == stopped


def test_every_key_works(page: "Page", circle: Afternoon) -> None:
    """By keyboard alone, the focus on nothing; each presses the button that names it."""
    press = page.keyboard.press
    press("]")
    assert _now(page) == circle.acts[1].starts
    press("[")
    assert _now(page) == 0
    press("End")
    assert _now(page) == circle.acts[-1].ends
    press("Home")
    assert _now(page) == 0
    _go(page, _translating(circle))
    units = {"block": 60_000_000, "character": 4_000_000, "instruction": 200, "cycle": 85}
    for key, (unit, most) in enumerate(units.items(), 1):
        press(str(key))
        assert page.locator("#units input:checked").get_attribute("value") == unit
        before = _now(page)
        press("ArrowRight")
        after = _now(page)
        assert 0 < after - before <= most
        press("ArrowLeft")
        assert _now(page) < after
    chosen = page.locator("#speed").evaluate("(select) => select.selectedIndex")
    press("+")
    assert page.locator("#speed").evaluate("(select) => select.selectedIndex") == chosen + 1
    press("-")
    press("-")
    assert page.locator("#speed").evaluate("(select) => select.selectedIndex") == chosen - 1
    before = _now(page)
    press(" ")
    until(page, f"workbench.afternoon.script.now > {before}")
    press(" ")
    assert not page.evaluate("workbench.afternoon.playing")


def test_slow_motion_goes_cycle_by_cycle(page: "Page", circle: Afternoon) -> None:
    """At a millionth of its speed the machine does not rush, and no play is lost between frames."""
    _go(page, _translating(circle))
    page.locator("#speed").select_option(index=1)
    before = _now(page)
    page.keyboard.press(" ")
    page.wait_for_timeout(700)
    page.keyboard.press(" ")
    assert 40 < _now(page) - before < 1000


def test_the_tapes_are_those_on_the_desk(page: "Page", circle: Afternoon) -> None:
    """The page's machine punches the very tape; the block and the frame under each head are named."""
    _go(page, circle.acts[4].ends - 1)
    punched = page.evaluate("workbench.machine.teletype.punch.frames")
    assert bytes(punched) == circle.tapes["circle.eia"]
    assert "13\u2009321 frames" in page.locator("#punch .name").inner_text()
    named = page.locator("#reader canvas").get_attribute("aria-label")
    assert named == "the reader's tape, under the head: 377 RUBOUT"
    _go(page, circle.mill_starts + round(1.95 * TICKS_PER_SECOND))
    named = page.locator("#mill-reader canvas").get_attribute("aria-label")
    assert named == "circle.eia, frame 20 of 13\u2009321: 200 EOB"


@pytest.mark.parametrize("size", [PROJECTOR, PHONE])
def test_nothing_hangs_over_the_edge(page: "Page", circle: Afternoon, size: tuple[int, int]) -> None:
    """At both widths, in every act, the page needs no scrolling sideways, and the controls are in sight."""
    page.set_viewport_size({"width": size[0], "height": size[1]})
    for act in circle.acts:
        _go(page, (act.starts + act.ends) // 2)
        assert page.evaluate("document.documentElement.scrollWidth <= innerWidth"), act.name
        box = page.locator("#time").bounding_box()
        assert box is not None
        assert box["y"] + box["height"] <= size[1] + 1
        assert page.evaluate(_CLIPPED) == [], act.name


_CLIPPED = """() => [...document.querySelectorAll("#registers dd, .block span, .key small, #units span")]
  .filter((element) => element.checkVisibility() && element.scrollWidth > element.clientWidth + 1)
  .map((element) => element.textContent)"""


def test_the_lamps_in_words(page: "Page", circle: Afternoon) -> None:
    """The panel says them while its button is down."""
    _go(page, _translating(circle))
    page.locator("#in-words").click()
    spoken = page.locator("#computer .words p").inner_text()
    assert re.match(
        r"memory address [0-7]{4}, memory buffer [0-7]{4}, link [01], accumulator [0-7]{4}", spoken
    )


def _lines(kind: str) -> str:
    return f"document.querySelectorAll('#gutter {kind}').length"


def test_one_line_is_current_whatever_sheet_comes_back(page: "Page", circle: Afternoon) -> None:
    """Act after act and back: a line that was lit when its sheet was put away is not lit when it returns."""
    ends = [act.ends - 1 for act in circle.acts[:-1]]
    for tick in [*ends, *reversed(ends), *ends]:
        _go(page, tick)
        lit, named = page.evaluate(f"[{_lines('.now')}, {_lines('[aria-current]')}]")  # at one instant
        assert lit == named <= 1


def test_the_address_names_the_instant(page: "Page") -> None:
    """It follows the instant, leads to it when it is changed, and nonsense in it does no harm."""
    _go(page, 10**10)
    page.wait_for_url("**#t=500")
    page.evaluate("location.hash = '#t=1000.5'")
    page.wait_for_timeout(50)
    assert _now(page) == 1000.5 * TICKS_PER_SECOND
    assert page.locator("#clock").inner_text() == clock(_now(page))
    page.evaluate("location.hash = '#t=1.2.3'")
    page.wait_for_timeout(50)
    assert _now(page) == 1000.5 * TICKS_PER_SECOND
    assert "memory address" in page.locator("#said").inner_text()


def test_a_page_that_slept_does_not_jump(page: "Page") -> None:
    """A picture stands for a quarter of a second at most, and a page that is hidden pauses."""
    page.evaluate(
        """() => {
          const request = window.requestAnimationFrame.bind(window);
          window.requestAnimationFrame = (then) => request((now) => then(now + 20_000));
        }"""
    )
    page.locator("#speed").select_option(index=8)
    page.evaluate("workbench.afternoon.play(true)")
    until(page, "workbench.afternoon.script.now > 0")
    page.evaluate("workbench.afternoon.play(false)")
    assert _now(page) <= 60 * 60 * TICKS_PER_SECOND / 4
    page.evaluate("workbench.afternoon.play(true)")
    page.evaluate(
        """() => {
          Object.defineProperty(document, "hidden", { get: () => true, configurable: true });
          document.dispatchEvent(new Event("visibilitychange"));
        }"""
    )
    assert not page.evaluate("workbench.clock.pictures.running")
    assert page.title() == "Stopped: PDP-8/L workbench"
    page.evaluate(
        """() => {
          Object.defineProperty(document, "hidden", { get: () => false });
          document.dispatchEvent(new Event("visibilitychange"));
        }"""
    )
    assert page.title() == "PDP-8/L workbench"
    assert "everything stood still for" in page.locator("#said:not(.spoken)").inner_text()
    page.locator(".rocker").first.click()
    assert page.locator("#said:not(.spoken)").count() == 0


_LEVELS = """() => {
  const lamps = Map.groupBy(document.querySelectorAll("[data-lamp]"), ({ dataset }) => dataset.lamp);
  const level = ({ style }) => Number(style.getPropertyValue("--lit"));
  return Object.fromEntries([...lamps].map(([name, bits]) => [name, bits.map(level)]));
}"""


def test_lamps_are_as_bright_as_they_were_often_lit(page: "Page", circle: Afternoon) -> None:
    """While a character is awaited RUN is full, WORD COUNT dark, and some lamp of KSF, JMP .-1 between."""
    _go(page, _translating(circle))
    page.locator("#speed").select_option(index=6)
    page.evaluate("workbench.afternoon.play(true)")
    page.wait_for_timeout(400)
    levels = page.evaluate(_LEVELS)
    assert levels["run"] == [1]
    assert levels["word_count"] == [0]
    assert any(0 < level < 1 for bits in levels.values() for level in bits)


_NEARLY = """for (const lamp of [...workbench.switches.panel.lamps.values()].flat()) {
  workbench.switches.panel.levels.set(lamp, 11);
  lamp.style.setProperty("--lit", 11 / 12);
}"""


def test_all_is_of_one_instant_when_a_play_is_halted(page: "Page", circle: Afternoon) -> None:
    """Registers and line, which are written less often while they run, agree with the lamps; each lamp is
    full or dark, however bright it was: nearly full is near enough only while a machine runs.
    """
    _go(page, _translating(circle))
    page.locator("#speed").select_option(index=6)
    for _ in range(5):
        page.evaluate("workbench.afternoon.play(true)")
        page.wait_for_timeout(330)
        page.evaluate(f"() => {{ {_NEARLY} workbench.afternoon.play(false); }}")
        word, at = page.evaluate(
            "(({ ma, pc, next }) => [ma, next % 3 ? pc - 1 : pc])(workbench.machine.processor)"
        )
        levels = page.evaluate(_LEVELS)
        assert levels["ma"] == [word >> (11 - bit) & 1 for bit in range(12)]
        assert {level for field in levels if field != "ema" for level in levels[field]} == {0, 1}
        assert page.locator("[data-register=MA] dd").inner_text() == f"{word:04o}"
        assert page.locator("#gutter .now button").text_content() == f"{at:04o}"


def test_nothing_is_drawn_while_nothing_changes(page: "Page") -> None:
    """Standing still, the page asks for no picture and changes no element."""
    page.wait_for_timeout(400)
    assert drawn(page) == 0


def test_a_pane_alone_for_a_projector(page: "Page") -> None:
    """Its button shows it alone, as large as the page, and all again."""
    page.locator("#computer .enlarge").click()
    assert page.locator("main > section:visible").count() == 1
    page.locator("#computer .enlarge").click()
    assert page.locator("main > section:visible").count() == 5


def test_a_play_waits_while_the_slider_is_dragged(page: "Page") -> None:
    """Held, it stays where it was put; let go, it plays on from there."""
    page.evaluate("workbench.afternoon.play(true)")
    box = page.locator("#slider").bounding_box()
    assert box is not None
    page.mouse.move(box["x"] + box["width"] / 4, box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.move(box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    held = _now(page)
    page.wait_for_timeout(200)
    assert _now(page) == held > 0
    page.mouse.up()
    until(page, f"workbench.afternoon.playing && workbench.afternoon.script.now > {held}")


def _take_over(page: "Page", circle: Afternoon) -> int:
    """Go to an instant of the translation, and flip a switch: the machine is the visitor's, and stopped."""
    tick = _translating(circle, 1234.5678)
    _go(page, tick)
    page.locator(".rocker").first.click()
    assert not page.evaluate("workbench.afternoon.on || workbench.machine.processor.run")
    return tick


def test_taken_over_and_finished(page: "Page", circle: Afternoon) -> None:
    """A switch flipped, a word looked at, a step forward and back: CONT goes on to the right EIA tape."""
    _take_over(page, circle)
    assert "You have taken over at" in page.locator("#next").inner_text()
    clock = page.evaluate("workbench.machine.processor.clock")
    page.locator("#forward").click()
    assert page.evaluate("workbench.machine.processor.clock") > clock
    page.locator("#back").click()
    page.locator("[data-opens=debugger]").click()
    assert page.locator("#core input").first.input_value() == f"{circle.programs['eia.pal'].words[0o200]:04o}"
    page.locator("#speed").select_option(label="as fast as it goes")
    page.locator("[data-key=cont]").click()
    until(page, "workbench.machine._out_of_tape()")
    page.wait_for_timeout(200)
    assert bytes(page.evaluate("workbench.machine.teletype.punch.frames")) == circle.tapes["circle.eia"]


def test_who_takes_over_has_all_of_the_machine(page: "Page", circle: Afternoon) -> None:
    """A breakpoint in the listing, at which the run stops; a PC8/L, which the afternoon has not."""
    _go(page, _translating(circle))
    line = page.locator("#gutter button").first
    address = line.inner_text()
    line.click()
    assert not page.evaluate("workbench.afternoon.on")
    page.locator("[data-key=cont]").click()
    until(page, "!workbench.machine.processor.run")
    assert f"breakpoint at {address}" in page.locator("#next").inner_text()
    page.locator("#pc8 summary").click()
    page.locator("#pc8-shelf").select_option("circle.asc")
    page.evaluate("workbench.machine.load([[8, 0o6014], [9, 0o6011], [10, 0o5011], [11, 0o7402]])")
    page.evaluate("workbench.machine.start(8); workbench.machine.run(); workbench.touched();")
    assert page.locator("#pc8-reader").inner_text().startswith("1 of ")


def test_back_to_the_afternoon(page: "Page", circle: Afternoon) -> None:
    """What was done in between is undone: the machine is at the instant at which it was taken over."""
    tick = _take_over(page, circle)
    page.evaluate("workbench.machine.processor.deposit(0o200, 0); workbench.teletype.mount('hello.pal');")
    page.locator("#next [data-click='afternoon.back']").click()
    assert _now(page) == tick
    follower = Follower(circle)
    follower.to(tick)
    expected = {**follower.machine.panel.lamps._asdict(), "sr": follower.machine.sr}
    assert page.evaluate(_LAMPS) == expected
    assert page.evaluate("[...workbench.machine.processor.core]") == [*follower.machine.processor.core]


def test_a_play_that_is_taken_over_runs_on(page: "Page", circle: Afternoon) -> None:
    """Whoever touches a lever while it plays has a machine that runs."""
    _go(page, _translating(circle))
    page.locator("#speed").select_option(label="as it was")
    page.locator("#play").click()
    page.locator("#punch-on").click()
    before = page.evaluate("workbench.machine.processor.clock")
    until(page, f"workbench.machine.processor.clock > {before} + 1e6")
    assert not page.evaluate("workbench.afternoon.on")


def test_the_doors(page: "Page") -> None:
    """Each leads where it says, in any order: the afternoon plays, a program prints, the drill waits for an
    address, and for nothing else once another door is open.
    """
    page.locator("[data-door=rim]").click()
    page.locator("[data-door=first]").click()
    until(page, "document.querySelector('#paper pre').textContent.includes('HELLO')")
    page.locator("[data-door=rim]").click()
    assert page.locator("#card .now").inner_text().startswith("7756")
    page.locator("[data-door=afternoon]").click()
    until(page, "workbench.afternoon.playing && workbench.afternoon.script.now > 0")
    page.keyboard.press("Space")
    assert not page.evaluate("workbench.afternoon.playing")
    assert page.evaluate("workbench.switches.card.coach === null")


def test_the_panel_alone_begins_with_the_first_switch(browser: "Browser", circle_page: Path) -> None:
    """The half hour at the terminal in Toronto shows nothing on it."""
    opened = browser.new_page()
    opened.goto(circle_page.as_uri() + "?embed=panel")
    until(opened, "!!window.workbench?.afternoon.playing")
    assert opened.evaluate("workbench.afternoon.script.act.kind") == "toggle"
    opened.close()


_HASTE = """(() => {  // 10 ms pass at every look at the clock; what is done from turn to turn is noted
  const now = performance.now.bind(performance), frame = window.requestAnimationFrame.bind(window);
  const seen = window.seen = { looks: 0, most: 0, ran: 0, led: 0 };
  performance.now = () => now() + 10 * ++seen.looks;
  window.requestAnimationFrame = (show) => frame(() => show(performance.now()));
  let looks = 0, clock = 0, position = 0;
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    const { machine, afternoon } = window.workbench ?? {};
    seen.most = Math.max(seen.most, seen.looks - looks);
    looks = seen.looks;
    if (machine) {
      if (!afternoon.on) seen.ran = Math.max(seen.ran, machine.processor.clock - clock);
      seen.led = Math.max(seen.led, afternoon.position - position || 0);
      clock = machine.processor.clock;
      position = afternoon.position;
    }
    port2.postMessage(0);
  };
  port2.postMessage(0);
})()"""


def test_no_task_is_long(browser: "Browser", circle_page: Path, circle: Afternoon) -> None:
    """By a clock on which all work is late, the page has its turn after a unit or two of it: of the day's
    rehearsal, of a play and of a run at full speed. How long that takes is measured by `benchmarks.tasks`.
    """
    opened = browser.new_page()
    opened.add_init_script(_HASTE)
    opened.goto(circle_page.as_uri() + "#t=0")
    until(opened, "!!window.workbench?.afternoon.on")
    assert opened.evaluate("seen.looks") > 200
    opened.locator("#speed").select_option(label="as fast as it goes")
    tick = _translating(circle)
    _go(opened, tick)
    opened.evaluate("seen.led = 0")
    opened.locator("#play").click()
    until(opened, f"workbench.afternoon.script.now > {tick + 4e8}")
    opened.locator(".rocker").first.click()
    opened.evaluate("seen.ran = 0")
    begun = opened.evaluate("workbench.machine.processor.clock")
    until(opened, f"workbench.machine.processor.clock > {begun + 3e7}")
    seen = opened.evaluate("seen")
    assert seen["most"] < 40
    assert seen["led"] <= 15 * TICKS_PER_SECOND
    assert seen["ran"] <= TICKS_PER_SECOND / 6
    opened.close()
