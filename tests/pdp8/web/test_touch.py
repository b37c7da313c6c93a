"""The first minutes, by somebody who does what each sentence of the room says, exactly as it stands."""

import re
from collections.abc import Callable
from pathlib import Path
from random import Random

import pytest

from tests.pdp8.web.browsing import Browser, Page, click, until, visit

_DESK = (1366, 768)
_SMALL = [(390, 844), (320, 568), (600, 300), (300, 180), (1920, 1080)]
_PROCESSOR = "workbench.machine.processor"
_RINGED = """(() => {  // what is ringed is in sight, without any scrolling
  const ringed = [...document.querySelectorAll("#room .hand [aria-current]")];
  return ringed.length > 0 && ringed.every((each) => {
    const { left, right, top, bottom } = each.getBoundingClientRect();
    return document.elementFromPoint((left + right) / 2, (top + bottom) / 2) === each;
  });
})()"""
_PRESSED = f"(key) => [{_PROCESSOR}.run, workbench.switches.press(key), workbench.room.guide.did]"
"""A key, before the machine goes on: whether it ran, and what is said of the key."""
_KEYS = ["start", "load add", "dep", "exam", "cont", "stop", "sing step", "mem prot"]
_SHORT = {"start": "s", "load add": "l", "dep": "d", "exam": "e", "cont": "c", "stop": "t"}


def _said(page: Page) -> str:
    """Return the sentence, which has to be on the screen, whole, and in the accessibility tree."""
    said: str = page.locator("#room .story").inner_text()
    seen = page.evaluate(
        "() => { const place = document.querySelector('#room .story');"
        " place.scrollIntoView({ block: 'nearest' });"
        " const { left, right, top, bottom, width, height } = place.getBoundingClientRect();"
        " const at = (x, y) => place.contains(document.elementFromPoint(x, y));"
        " return left >= 0 && right <= innerWidth && top >= 0 && bottom <= innerHeight && width > 0"
        "   && at(left + 2, top + height / 3) && at(left + 2, bottom - height / 4); }"
    )
    assert seen, said
    snapshot = page.locator("#room").aria_snapshot()
    if page.locator("#room .story").inner_text() != said:  # the machine went on
        return _said(page)
    assert said in snapshot, said
    return said


def _words(page: Page) -> str:
    """Return what was said of the last key, and the lamps in words."""
    return " ".join(page.locator("#room .did, #room .lamps").all_text_contents())


def _by_mouse(page: Page, said: str) -> None:
    if "Flip the ringed switch" in said:
        ringed = page.locator("#room .rocker[aria-current]")
        for bit in ringed.evaluate_all("(all) => all.map((each) => each.value)"):
            page.locator(f'#room .rocker[value="{bit}"]').click()
    elif key := re.search(r"Press ([A-Z ]+)[.:,]", said):
        page.locator("#room .key").and_(page.get_by_label(key[1], exact=True)).click()
    else:
        raise AssertionError(f"nothing to be done: {said}")


def _by_keys(page: Page, said: str) -> None:
    if word := re.search(r"or type (\d{4})", said):
        page.keyboard.type(word[1])
    elif (key := re.search(r"Press ([A-Z ]+)[.:,]", said)) and key[1].lower() in _SHORT:
        page.keyboard.press(_SHORT[key[1].lower()])
    else:
        _by_mouse(page, said)


def _helped(page: Page, said: str) -> None:
    del said
    page.get_by_role("button", name="Do it for me").click()


def _until_it_waits(page: Page, do: Callable[[Page, str], None], most: int) -> None:
    """Do what is said, until a name is asked for, and look at what was promised."""
    for _ in range(most):
        said = _said(page)
        if "Type your name" in said:
            return
        until(page, _RINGED)
        if "RUN is lit" in said:
            lit = page.evaluate(f"{_PROCESSOR}.run") == 1
            assert lit or _said(page) != said  # it may have stopped by itself meanwhile
        before = page.evaluate(_PROCESSOR + ".core.slice()")
        do(page, said)
        page.wait_for_timeout(30)
        done = _words(page)
        if "Press STOP" in said:
            assert page.evaluate(f"{_PROCESSOR}.run") == 0
            assert "RUN is dark" in done or "stopped" in done  # by itself, before the button was pressed
        elif "the lamps show the word there" in said:
            address, word = re.findall(r"memory address (\d{4}), memory buffer (\d{4})", done)[0]
            assert address in said
            assert before[int(address, 8)] == int(word, 8)
        elif put := re.search(r"The switches say (\d{4}). Press DEP: .* at (\d{4})", said):
            assert page.evaluate(f"{_PROCESSOR}.core[0o{put[2]}]") == int(put[1], 8)
            assert f"now it holds {put[1]}" in done
        assert _said(page) != said, (said, done)
    raise AssertionError("no end")


def _name(page: Page) -> None:
    """Type a name, see it on the tape, and keep the picture."""
    page.keyboard.type("Ada 1")
    until(page, "document.querySelector('#room .story').textContent.startsWith('ADA 1: 5 rows')")
    punched = page.evaluate("[...workbench.machine.teletype.punch.frames]")
    assert punched == [0o301, 0o304, 0o301, 0o240, 0o261]
    until(page, "workbench.room.page.paper.lines.at(-1) === 'ADA 1'")
    assert "Type on, or see your tape" in _said(page)
    page.get_by_role("button", name="See your tape").click()
    until(page, "document.querySelector('#tape img').complete && document.querySelector('#tape').open")
    assert page.get_by_role("img", name="A paper tape with 5 rows of holes: ADA 1").is_visible()
    with page.expect_download() as picture:
        page.get_by_role("link", name="Keep the picture").click()
    assert picture.value.suggested_filename == "ADA-1.png"
    assert Path(picture.value.path()).read_bytes().startswith(b"\x89PNG")
    page.get_by_role("button", name="Back to the machine").click()


def _walk(page: Page, turn: int, do: Callable[[Page, str], None], most: int = 40) -> None:
    page.evaluate("(turn) => workbench.room.go({ value: turn })", turn)
    page.get_by_role("button", name="Take the switches").click()
    _until_it_waits(page, do, most)
    _name(page)


def test_a_name_in_tape(browser: Browser, file: Path) -> None:
    """From the running translation, by the mouse."""
    with visit(browser, file.as_uri(), viewport=dict(zip(("width", "height"), _DESK, strict=True))) as page:
        _walk(page, 0, _by_mouse)


@pytest.mark.slow("the first minute six times, 1 min")
@pytest.mark.parametrize(
    ("size", "turn", "do"),
    [
        (_DESK, 6, _by_keys),
        *(
            pytest.param(_DESK, turn, _by_keys, marks=pytest.mark.rare("9 s each"))
            for turn in (0, 1, 2, 3, 4, 5, 7)
        ),
        *((_DESK, turn, _helped) for turn in (2, 6)),
        *zip(_SMALL[:3], (1, 5, 7), [_by_mouse] * 3, strict=True),
        *(
            pytest.param(size, turn, _by_mouse, marks=pytest.mark.rare("20 s each"))
            for size, turn in zip(_SMALL[3:], (3, 4), strict=True)
        ),
    ],
)
def test_each_act_and_size(
    browser: Browser, file: Path, size: tuple[int, int], turn: int, do: Callable[[Page, str], None]
) -> None:
    """What is said is done in every act, by mouse, by keys, and by the button; in every kind of window."""
    viewport = dict(zip(("width", "height"), size, strict=True))
    with visit(browser, file.as_uri(), viewport=viewport, accept_downloads=True) as page:
        _walk(page, turn, do)


@pytest.mark.slow("at random, then guided, 30 s")
@pytest.mark.parametrize(
    "seed", [*range(3), *(pytest.param(n, marks=pytest.mark.rare("15 s each")) for n in range(3, 6))]
)
def test_from_anywhere(browser: Browser, file: Path, seed: int) -> None:
    """Who has pressed 40 keys at random is answered by what happened, and guided from there."""
    random = Random(seed)
    with visit(browser, file.as_uri()) as page:
        page.evaluate("(turn) => workbench.room.go({ value: turn })", random.randrange(8))
        click(page, "#take")
        for _ in range(40):
            if random.random() < 0.5:
                page.evaluate("(bit) => workbench.switches.flip({ value: bit })", random.randrange(12))
                continue
            key = random.choice(_KEYS)
            run, _, did = page.evaluate(_PRESSED, key)
            heard = key in ("stop", "sing step", "mem prot")
            assert ("did not hear" in did) == bool(run and not heard), (key, did)
        _until_it_waits(page, _helped, 20)


def test_one_leaves_and_goes_on(browser: Browser, file: Path) -> None:
    """In the midst of it to the story, to the desk, and back by the browser's own key: nothing is lost."""
    with visit(browser, file.as_uri()) as page:
        click(page, "#take")
        for _ in range(4):
            _helped(page, "")
        before = _said(page)
        click(page, "#take")
        assert page.evaluate("workbench.afternoon.on")
        page.get_by_role("button", name="Go on at the switches").click()
        assert _said(page) == before
        click(page, "#leave")
        assert page.evaluate(f"{_PROCESSOR}.core[0o200]") == 0o6031
        page.go_back()
        until(page, "workbench.room.open")
        page.get_by_role("button", name="Go on at the switches").click()
        assert _said(page) == before
        _until_it_waits(page, _helped, 20)


def _width(page: Page) -> float:
    """Return how wide the lamps in words are, in CSS pixels."""
    width: float = page.locator("#room .lamps").evaluate("place => place.getBoundingClientRect().width")
    return width


def test_the_lamps_are_heard(browser: Browser, file: Path) -> None:
    """After each key the lamps are in the status; W shows them, and hides them."""
    with visit(browser, file.as_uri()) as page:
        click(page, "#take")
        page.keyboard.press("t")
        assert "stopped" in page.locator("#room .lamps").inner_text()
        assert _width(page) < 2
        page.keyboard.press("w")
        assert _width(page) > 100
        page.keyboard.press("l")
        assert "memory address 0200" in page.locator("#room .lamps").inner_text()
        page.keyboard.press("w")
        assert page.get_by_role("button", name="Lamps in words").get_attribute("aria-pressed") == "false"


def _offers(page: Page, words: str, *labels: str) -> None:
    """Wait until the desk says the words, and beside them these controls."""
    until(page, f"document.querySelector('#next span').textContent.includes({words!r})")
    assert page.locator("#next [data-for]").all_inner_texts() == list(labels)


def test_what_the_desk_says_next(page: Page, browser: Browser, file: Path) -> None:
    """In each state of the machine every control that stands beside the sentence does what it says."""

    def press(label: str, on: Page = page) -> None:
        on.locator("#next").get_by_role("button", name=label, exact=True).click()

    waits = "The program waits for a key at 0200."
    waiting = ("Type a character", "Choose a tape", "STOP")
    stopped = ("START", "CONT", "Assemble and run")
    _offers(page, "Its core memory is empty.", "Assemble and run")
    page.locator("#source").fill("*200\n\tKSF\n\tJMP .-1\n\tKRB\n\tTLS\n\tHLT\n$\n")
    press("Assemble and run")
    _offers(page, waits, *waiting)
    press("STOP")
    _offers(page, "CONT goes on.", *stopped)
    press("CONT")
    _offers(page, waits, *waiting)
    press("Type a character")
    page.keyboard.type("A")
    _offers(page, "HLT at 0204. START begins at 0205", *stopped)
    until(page, "document.querySelector('#paper pre').textContent.endsWith('A')")
    until(page, "!workbench.clock.pictures.running")  # the printer is at rest: no more time passes
    click(page, "#computer [data-key='sing step']")
    _offers(page, "START begins at 0205, CONT does one cycle.", *stopped)
    for key, address in (("START", 0o205), ("CONT", 0)):  # AND 0: fetched, then executed
        before = page.evaluate(f"{_PROCESSOR}.clock")
        press(key)
        found = page.evaluate(f"[{_PROCESSOR}.clock - {before}, {_PROCESSOR}.ma, {_PROCESSOR}.pc]")
        assert found == [32, address, 0o206]
    click(page, "#computer [data-key='sing step']")
    press("Assemble and run")
    _offers(page, waits, *waiting)
    press("Choose a tape")
    assert page.evaluate("document.activeElement.id") == "shelf"
    page.locator("#shelf").select_option("circle.asc")
    _offers(page, "HLT at 0204.", *stopped)
    click(page, "#lever")
    press("Assemble and run")
    _offers(page, waits, "Type a character", "Lever to START", "STOP")
    press("Lever to START")
    _offers(page, "HLT at 0204.", *stopped)
    with visit(browser, f"{file.as_uri()}?embed=panel#workbench") as panel:
        _offers(panel, "Its core memory is empty.", "Toggle in the RIM loader", "Assemble and run")
        press("Toggle in the RIM loader", panel)
        assert panel.locator("#drill").get_attribute("aria-pressed") == "true"
        assert panel.locator("#card .now").is_visible()
