"""The room, in which the page opens: what it shows is the machine's state, and what can be done in it."""

from pathlib import Path

import pytest

from pdp8.computer.hardware.signals import FRAME, TICKS_PER_SECOND
from pdp8.replay import Afternoon
from tests.pdp8.web.browsing import (
    AXE,
    Browser,
    Page,
    click,
    needs_axe,
    room_in_chromium,
    serious,
    until,
    visit,
)
from tests.pdp8.web.follower import Follower

_HD = {"width": 1366, "height": 768}
_PROLOGUE, _PRINT, _TOGGLE, _TRANSLATE, _CUT, _MEASURE = 0, 1, 2, 5, 6, 7
_STORY = "document.querySelector('#room .story').textContent"
_NOW = "workbench.afternoon.script.now"


def _to(page: Page, turn: int, part: float) -> int:
    """Go to a part of an act, standing still; return the tick."""
    page.evaluate(
        "([turn, part]) => { const { room } = workbench; room.playing = false; room.go({ value: turn });"
        " room.tour.go(turn, part); workbench.afternoon.lead(room.tour.tick); room.show(); }",
        [turn, part],
    )
    return int(page.evaluate(_NOW))


def test_the_page_opens_in_the_midst_of_the_translation(room: Page) -> None:
    """It is alive from the first picture. The room left, the page opens at the desk again."""
    assert room.evaluate("workbench.room.open && workbench.room.playing")
    assert room.evaluate("workbench.afternoon.script.act.kind") == "translate"
    before = room.evaluate("workbench.machine.processor.instructions")
    until(room, f"workbench.machine.processor.instructions > {before}")
    assert "1971" in room.evaluate(_STORY)
    room.reload()
    until(room, "window.workbench?.ready && workbench.room.open")
    click(room, "#leave")
    assert room.evaluate("location.hash") == "#workbench"
    room.reload()
    until(room, "!!window.workbench?.ready")
    assert not room.evaluate("workbench.room.open")


def test_the_desk_comes_where_the_browser_is_never_idle(browser: Browser, file: Path) -> None:
    """A control that is pressed before the desk is there waits for it."""
    context = browser.new_context(offline=True)
    page = context.new_page()
    page.add_init_script(
        "setInterval(() => { for (const from = performance.now(); performance.now() < from + 30; ); });"
    )
    page.goto(file.as_uri())
    page.evaluate(
        "() => new Promise((done) => {"
        " const look = () => window.workbench ? done() : setTimeout(look); look(); })"
    )
    assert not page.evaluate("() => { document.getElementById('leave').click(); return workbench.ready; }")
    until(page, "workbench.ready && !workbench.room.open && location.hash === '#workbench'")
    context.close()


def test_an_afternoons_page_says_first_what_it_is(browser: Browser, circle_page: Path) -> None:
    """It begins with the whole scene; then the terminal types and punches frame by frame, ten a second."""
    with visit(
        browser, circle_page.as_uri(), "window.workbench?.ready && workbench.room.playing", viewport=_HD
    ) as page:
        assert page.evaluate("workbench.room.tour.turn") == _PROLOGUE
        page.evaluate("workbench.room.go({ value: 1 })")
        until(page, f"{_NOW} > {5 * FRAME}")
        page.evaluate("workbench.room.toggle()")
        until(page, f"workbench.room.typed === Math.floor({_NOW} / {FRAME})")
        assert page.evaluate("document.querySelectorAll('.chapters [aria-current]').length") == 1


def test_the_address_is_an_instant(browser: Browser, file: Path) -> None:
    """#t= opens the room as it was then; paused, its address says when; back and forward lead in and out."""
    with visit(browser, file.as_uri() + "#t=3000.5", viewport=_HD) as page:
        assert (
            page.evaluate(f"workbench.room.open && !workbench.room.playing && {_NOW}")
            == 3000.5 * TICKS_PER_SECOND
        )
        page.keyboard.press("Space")
        until(page, f"{_NOW} > {3001 * TICKS_PER_SECOND}")
        page.keyboard.press("Space")
        assert page.evaluate(f"location.hash === `#t=${{{_NOW} / {TICKS_PER_SECOND}}}`")
        click(page, "#leave")
        page.go_back()
        until(page, "workbench.room.open")
        page.go_forward()
        until(page, "!workbench.room.open")


@pytest.mark.parametrize(
    ("turn", "part"),
    [
        *[(_PROLOGUE, 0.3), (_TOGGLE, 0.4), (_TRANSLATE, 0.9)],
        pytest.param(_CUT, 0.5, marks=pytest.mark.slow("plays all acts before")),
    ],
)
def test_what_is_lit_is_the_machines(room: Page, circle: Afternoon, turn: int, part: float) -> None:
    """Standing still, lamps and switches are those of a machine that goes forward only."""
    tick = _to(room, turn, part)
    until(room, "!workbench.room.awake")
    follower = Follower(circle)
    follower.to(tick)
    lit = room.evaluate(
        "Object.fromEntries([...workbench.room.filaments.lit].map(([name, bits]) =>"
        " [name, bits.reduce((word, bit) => word * 2 + Math.round(bit), 0)]))"
    )
    assert lit == follower.machine.panel.lamps._asdict() | {"ema": 0}
    assert room.evaluate("workbench.machine.processor.sr") == follower.machine.sr


def test_an_act_ends_before_the_next_begins(room: Page) -> None:
    """However long its end is looked at, the instant is the last of the act."""
    ends = room.evaluate("""() => {
      const { tour } = workbench.room, { acts } = workbench.afternoon.script.day;
      return acts.map(({ ends }, at) => { tour.go(at + 1, 0); tour.wall = 1e6; return ends - tour.tick; });
    }""")
    assert ends == [1] * len(ends)


def test_the_switches_are_taken_and_given_back(room: Page) -> None:
    """By mouse and by keys the machine is the visitor's; back in the story it is as it was."""
    _to(room, _TRANSLATE, 0.2)
    before = room.evaluate("[workbench.machine.ac, workbench.machine.processor.sr]")
    room.evaluate("() => { workbench.room.playing = true; }")
    click(room, "#take")
    assert room.evaluate("workbench.machine.processor.run") == 1, "it runs on"
    room.keyboard.press("t")
    room.keyboard.type("1234l")
    processor = "workbench.machine.processor"
    assert room.evaluate(f"[{processor}.pc, {processor}.sr]") == [0o1234, 0o1234]
    room.locator("#room .rocker").last.click()
    assert room.evaluate(f"{processor}.sr") == 0o1235
    until(room, "[...document.querySelectorAll('#room .rocker')].at(-1).ariaChecked === 'true'")
    room.keyboard.press("Tab")
    click(room, "#room [data-key=exam]")
    assert room.evaluate(f"{processor}.ma") == 0o1234
    click(room, "#take")
    assert room.evaluate("workbench.afternoon.on")
    assert room.locator("#room .rocker").count() == 0
    _to(room, _TRANSLATE, 0.2)
    assert room.evaluate("[workbench.machine.ac, workbench.machine.processor.sr]") == before


_FIRST = """(() => {  // the first instruction is in sight
  const { x, y, height } = document.querySelector(".typed pre .known").getBoundingClientRect();
  return document.elementFromPoint(x + 2, y + height - 2)?.id === "source";
})()"""


@room_in_chromium
@pytest.mark.parametrize("size", [(1366, 768), (390, 844), (600, 300)])
def test_a_program_is_written(room: Page, size: tuple[int, int]) -> None:
    """hello.pal runs on the desk, its first instruction in sight, and what it prints is there; by the button
    one is in the room again.
    """
    room.set_viewport_size({"width": size[0], "height": size[1]})
    click(room, "#write")
    until(room, _FIRST)
    until(room, "workbench.machine.processor.run && !workbench.afternoon.on")
    until(room, "document.querySelector('#paper pre').textContent.includes('HELLO')")
    assert room.evaluate("document.activeElement.id") == "source"
    click(room, "#enter")
    assert room.evaluate("workbench.room.open && workbench.afternoon.on && location.hash === ''")


_SLOW = """() => {  // each picture of the browser takes 60 ms, before the machine has its turn
  const busy = () => {
    for (const end = performance.now() + 60; performance.now() < end; );
    requestAnimationFrame(busy);
  };
  requestAnimationFrame(busy);
}"""


@room_in_chromium
def test_the_machine_goes_on_where_pictures_are_slow(room: Page) -> None:
    room.evaluate(_SLOW)
    click(room, "#take")
    room.evaluate(
        "workbench.touch((machine) => { machine.panel.stop();"
        " machine.load([[0o200, 0o2300], [0o201, 0o5200], [0o202, 0o5200]]); machine.start(0o200); })"
    )
    before = room.evaluate("workbench.machine.processor.clock")
    until(room, f"workbench.machine.processor.clock > {before + TICKS_PER_SECOND}")


_HELD = "[workbench.machine.processor.core[0o1000], workbench.machine.ac]"


def test_what_was_worked_at_is_there_afterwards(room: Page) -> None:
    """Who had a program in core when he went into the room finds it when he comes back, by the switches, by
    the desk or to write another, with the tape in its reader. The sound is one, at the desk and in the room.
    """
    click(room, "#hear", "#leave")
    assert room.evaluate("document.getElementById('sound').checked")
    click(room, "#sound")
    room.evaluate("workbench.teletype.mount('hello.pal')")
    click(room, "#enter", "#leave")
    room.evaluate("workbench.touch((machine) => { machine.load([[0o1000, 0o7402]]); machine.ac = 0o1234; })")
    click(room, "#lever", "#punch-on", "#enter")
    assert room.locator("#hear").inner_text() == "Sound off"
    until(room, f"workbench.afternoon.on && ({_HELD})[1] !== 0o1234")
    click(room, "#leave")
    assert room.evaluate(_HELD) == [0o7402, 0o1234]
    assert not room.evaluate("workbench.afternoon.on")
    for sample, ways in ((0o4321, ["#leave"]), (0o2222, ["#take", "#take"])):
        click(room, "#enter", "#take")
        levers = "(({ reader, punch }) => [reader.on, punch.on])(workbench.machine.teletype)"
        assert room.evaluate(levers) == [False, True], "else it would read the tape, or punch nothing"
        room.evaluate("(word) => workbench.touch((machine) => { machine.ac = word; })", sample)
        click(room, *ways)
        assert room.evaluate(_HELD) == [0o7402, sample]
    click(room, "#leave")
    assert room.locator("#reader .name").inner_text().startswith("hello.pal")
    click(room, "#enter", "#write")
    assert room.evaluate(_HELD)[0] == 0o7402


_FRAMES = """() => new Promise((done) => {
  let frames = 0;
  const request = window.requestAnimationFrame;
  window.requestAnimationFrame = (then) => { frames++; return request.call(window, then); };
  setTimeout(() => done(frames), 400);
})"""


_BRIGHT = """(sample) => {  // the lamps of the accumulator as they are drawn on the desk, 0 to 255
  workbench.touch((machine) => { machine.ac = sample; });
  const canvas = document.querySelector("#computer canvas");
  const c = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  c.drawImage(canvas, 0, 0);
  const inch = canvas.width / 19;
  const places = Array.from({ length: 12 }, (_, bit) => 2.75 + bit * 0.68 + Math.floor(bit / 3) * 0.2);
  return places.map((x) => c.getImageData(Math.round(x * inch), Math.round(4.7 * inch), 1, 1).data[1]);
}"""


@room_in_chromium
def test_the_lamps_are_drawn(room: Page) -> None:
    """Where the panel of the desk has a lamp there is light, if its bit is set."""
    click(room, "#leave")
    for word in (0o7777, 0o0000, 0o5252, 0o0001):
        lit = [light > 150 for light in room.evaluate(_BRIGHT, word)]
        assert lit == [bool(word >> (11 - bit) & 1) for bit in range(12)]


@room_in_chromium
@pytest.mark.slow("the camera comes to rest, 10 s")
def test_what_stands_still_costs_nothing(room: Page) -> None:
    """Paused, or taken and halted: when camera and filaments have come to rest no picture is asked for."""
    for act in ("", "workbench.room.take(); workbench.machine.panel.stop(); workbench.touched();"):
        _to(room, _TRANSLATE, 0.3)
        room.evaluate(f"() => {{ {act} }}")
        until(room, "!workbench.room.awake")
        assert room.evaluate(_FRAMES) == 0, act


@room_in_chromium
@pytest.mark.slow("the camera rests three times, 12 s")
def test_what_is_looked_at_is_drawn_for_its_size(room: Page) -> None:
    """Also where the camera has come a little nearer, or gone back again."""
    for part in (0.1, 0.5, 0.9):
        _to(room, _TOGGLE, part)
        until(room, "!workbench.room.awake")
        drawn = room.evaluate("workbench.room.scene.stills.get('panel').sharp")
        assert drawn == pytest.approx(room.evaluate("workbench.room.camera.scale"), rel=0.005)


def test_where_nothing_shall_move(browser: Browser, file: Path) -> None:
    """With reduced motion nothing plays; an act is a still of its middle, with what was typed by then."""
    with visit(browser, file.as_uri(), viewport=_HD, reduced_motion="reduce") as page:
        assert not page.evaluate("workbench.room.playing")
        assert not page.locator("#pause").is_visible()
        page.locator(".chapters button").first.click()
        until(page, "!workbench.room.awake")
        assert page.evaluate("workbench.room.tour.turn") == _PRINT
        assert page.evaluate("workbench.room.page.ended") > 10
        assert page.evaluate(_FRAMES) == 0


@pytest.mark.slow("six sizes of screen, 10 s")
def test_every_target_is_large_enough(browser: Browser, file: Path) -> None:
    """From a small telephone to a wall: all that is told is on the screen; choices have 44 pixels, marks and
    switches 24.
    """
    with visit(browser, file.as_uri(), viewport=_HD, reduced_motion="reduce") as page:
        _fits(page)


def _fits(room: Page) -> None:
    sizes = ((360, 640), (390, 844), (844, 390), (1366, 768), (1920, 1080), (3840, 2160))
    for width, height in sizes:
        room.set_viewport_size({"width": width, "height": height})
        _to(room, _TRANSLATE, 0.5)
        found = room.evaluate(
            "[...document.querySelectorAll('#room :is(.story, .choices button, .chapters button)')]"
            ".map((each) => {"
            " const { left, right, top, bottom } = each.getBoundingClientRect();"
            " return [each.className || each.id || 'mark', left, right, top, bottom]; })"
        )
        for name, left, right, top, bottom in found:
            assert left >= 0, (width, name)
            assert right <= width + 0.5, (width, name)
            assert top >= 0, (width, name)
            assert bottom <= height + 0.5, (width, name)
            assert bottom - top >= (24 if name in ("mark", "story") else 44), (width, name)
        click(room, "#take")
        until(room, "!workbench.room.awake")
        for box in [each.bounding_box() for each in room.locator("#room .hand button").all()]:
            assert box is not None
            assert box["width"] >= 23.5, (width, box)
            assert box["height"] >= 24, (width, box)
            assert box["x"] >= 0, (width, box)
            assert box["x"] + box["width"] <= width, (width, box)
            assert box["y"] + box["height"] <= height, (width, box)
        click(room, "#take")


@needs_axe
@pytest.mark.slow  # twelve seconds
def test_axe_finds_nothing_in_the_room(browser: Browser, circle_page: Path) -> None:
    """In every act, and with the switches taken."""
    with visit(browser, circle_page.as_uri(), viewport=_HD, bypass_csp=True) as page:
        page.add_script_tag(path=AXE)
        for turn in range(8):
            _to(page, turn, 0.5)
            assert serious(page) == [], turn
        click(page, "#take")
        assert serious(page) == []


def test_sounds_come_at_their_events(room: Page) -> None:
    """At the pace of 1971 each frame that is read, and each that is punched, strikes once."""
    room.evaluate(
        "() => { const { room, sound } = workbench; room.playing = false; room.go({ value: 5 });"
        " window.struck = []; sound.strike = (kind, later) => struck.push([kind, later]);"
        " const { script } = workbench.afternoon; const from = script.now; let since = 0;"
        " room.heard = null; room.later = () => 0;"
        " }"
    )
    counts = "[workbench.machine.teletype.reader.position, workbench.machine.teletype.punch.frames.length]"
    room.evaluate("() => { workbench.room.playing = true; workbench.room.show(); }")
    until(room, f"{_NOW} > workbench.afternoon.script.act.starts + 26 * {TICKS_PER_SECOND}")
    room.evaluate("() => { window.struck.length = 0; window.before = " + counts + "; }")
    until(room, f"{counts}[0] > before[0] + 5")
    room.evaluate("() => { workbench.room.playing = false; }")
    read, punched = room.evaluate(f"() => {counts}.map((count, index) => count - before[index])")
    kinds = [kind for kind, _ in room.evaluate("struck")]
    assert kinds.count("read") == read
    assert kinds.count("punch") == punched
    assert all(0 <= later < 0.2 for _, later in room.evaluate("struck"))


def test_a_name_is_punched_by_the_button_that_helps(room: Page) -> None:
    """What is ringed is what is due: pressed, the next thing is said. Then each letter is a row of holes, at
    whatever speed the desk goes.
    """
    room.evaluate("workbench.time.setSpeed(0.00001)")
    click(room, "#take")
    ringed = room.locator("#room .hand [aria-current]")
    for _ in range(40):
        said = room.evaluate(_STORY)
        if "Type your name" in said:
            break
        assert ringed.count() > 0, said
        due = room.evaluate("[workbench.room.step.switches, workbench.machine.processor.sr]")
        bits = room.locator("#room .rocker[aria-current]").count()
        assert bits == (0 if due[0] < 0 else (due[0] ^ due[1]).bit_count()), said
        click(room, "#help")
        room.wait_for_timeout(30)
        assert room.evaluate(_STORY) != said
    assert room.evaluate("document.activeElement.id") == "mine"
    assert ringed.count() == 0
    room.keyboard.type("Ada 1")
    until(room, f"{_STORY}.startsWith('ADA 1: 5 rows')")
    punch = "[...workbench.machine.teletype.punch.frames]"
    assert room.evaluate(punch) == [0o301, 0o304, 0o301, 0o240, 0o261]
    for key in ("Backspace", "2"):  # what is taken out of the field stays on the tape
        room.keyboard.press(key)
    until(room, "workbench.room.page.paper.lines.at(-1) === 'ADA 12'")
    click(room, "#see")
    until(room, "document.querySelector('#tape').open")
    assert room.locator("#tape img").get_attribute("alt") == "A paper tape with 6 rows of holes: ADA 12"
    click(room, "#tape form button", "#turn")
    assert room.locator("#turn").inner_text() == "To the punch"
    click(room, "#take", "#take")
    assert room.evaluate(punch) == [0o301, 0o304, 0o301, 0o240, 0o261, 0o262]
