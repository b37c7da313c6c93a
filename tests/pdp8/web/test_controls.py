"""Every control of the workbench works by mouse, by touch and by keyboard; axe holds its role and its name.

The page is asked for its controls: one that is not in CONTROLS, or is no longer there, fails the test.
"""

import json
import re
from pathlib import Path
from typing import NamedTuple

import pytest

from pdp8 import shelf
from tests.conftest import case
from tests.pdp8.web.browsing import Page, Tab
from tests.sampling import WHOLE


class Control(NamedTuple):
    """How a control is tried.

    watch   an expression of the page: when its value becomes another one, the control works
    before  statements that bring the page to where it can be used; `which` of those that are alike it is
    keys    what works it by keyboard; texts and regions get them after the pointer, too; lists get only them
    focus   what has the focus for that, if not the control
    within  what in it is pointed at, where its middle is another control
    """

    watch: str
    before: str = ""
    keys: str = "Enter"
    focus: str = ""
    within: str = ""


MACHINE, EDITOR, SCRIPT = "workbench.machine", "workbench.editor", "workbench.afternoon.script"
P, TTY, FAST = f"{MACHINE}.processor", f"{MACHINE}.teletype", f"{MACHINE}.highspeed"
SENT = f"[{TTY}.keyboard.waiting.length, {TTY}.receiver.line, {TTY}.receiver.start]"
STAND = (
    f"{P}.core.fill(0o7000); Object.assign({P}, {{ run: 0, pc: 0o200, next: 0, lac: 0 }});"
    "workbench.switches.card.coach = null; workbench.time.choose({ value: 'instruction' });"
)
OPEN = "document.querySelector('#card details').open = true;"
PUNCHED = f"{TTY}.punch.frames.append(0o60); {TTY}.punch.frames.append(0o200); workbench.touched();"
SAVED = (
    "window.saved = 0; window.made ??= URL.createObjectURL;"
    "URL.createObjectURL = (blob) => { window.saved++; return window.made.call(URL, blob); };"
)


def opened(tab: str) -> str:
    """Return the statement that opens a tab."""
    return f"workbench.tabs.open('{tab}');"


def written(*lines: str) -> str:
    """Return the statements that bring a source into the editor, assembled."""
    return f"{opened('program')} {EDITOR}.text = {list(lines)}.join('\\n'); {EDITOR}.assemble();"


WRITTEN = f"{opened('program')} {EDITOR}.open('a.pal', workbench.shelf.get('hello.pal').frames);"
ASSEMBLED = f"{WRITTEN} {EDITOR}.assemble(); {P}.core.fill(0);"
WRONG = written("*200", " JMP X", "$")
LOADED = f"{STAND} {ASSEMBLED} {EDITOR}.load(); {opened('debugger')}"
ALL = "document.querySelector('main.one .alone .enlarge')?.click();"
DRIVES = "workbench.drives.control.drives"
REEL = (
    "document.querySelector('#drives').open = true; for (const unit of [0, 1])"
    " if (!workbench.drives.control?.drives[unit].image)"
    " workbench.drives.mount(`${unit}.tu56`, new Uint8Array(380292));"
)
CLOSE = "document.querySelectorAll('dialog').forEach((box) => box.close());"
ROOM = f"{CLOSE} if (!workbench.room.open) workbench.enter();"
TAKEN = f"{ROOM} if (!workbench.room.live) workbench.room.take();"
WAITS = (
    f"{TAKEN} {MACHINE}.load([6031, 5200, 6036, 6046, 5200].map((word, at) =>"
    f" [0o200 + at, parseInt(word, 8)])); {MACHINE}.start(0o200);"
    f"{TTY}.punch.frames.append(0o301); workbench.touched();"
)
AFTERNOON = "workbench.afternoon.go(6e10);"
CUT = "workbench.mill.cut('circle.eia');"
EXERCISES = f"{opened('exercises')} workbench.exercises.open('add');"
PC8 = "document.querySelector('#pc8').open = true;"
PARTS = f"{opened('parts')} workbench.parts.choose('circle', {{}});"
DOOR = "document.querySelector('#part-options details').open = true;"
READY = (
    f"{PARTS} workbench.parts.name = 'circle.asc'; workbench.teletype.mount('circle.asc');"
    "for (const id of ['part-translate', 'part-cut']) document.getElementById(id).disabled = false;"
)


def of(selector: str, name: str = "value") -> str:
    """Return the expression of what all that a selector finds have."""
    return f"[...document.querySelectorAll('{selector}')].map((each) => each.{name})"


SHOWN, CHOSEN = of("[data-tab]", "hidden"), "[role=tab][aria-selected=true]"
CONTROLS = {
    ".rocker": Control(f"{P}.sr"),
    "[data-key='mem prot']": Control(f"{P}.mem_prot"),
    "[data-key='sing step']": Control(f"{P}.sing_step"),
    "[data-key='start']": Control(f"{P}.started", f"{STAND} {P}.clock += 1; {P}.sing_step = 0;"),
    "[data-key='load add']": Control(f"{P}.pc", f"{STAND} {P}.sr = 0o1234;"),
    "[data-key='dep']": Control(f"{P}.core[0o200]", f"{STAND} {P}.mem_prot = 0; {P}.sr = 0o1234;"),
    "[data-key='exam']": Control(f"{P}.pc", STAND),
    "[data-key='cont']": Control(f"{P}.clock", STAND),
    "[data-key='stop']": Control(f"{P}.run", f"{STAND} {P}.run = 1;"),
    "#card summary": Control(of("#card details", "open")),
    "#toggle-rim": Control(f"{P}.core[0o7756]", STAND + OPEN),
    "#drill": Control(of("#drill", "ariaPressed"), OPEN),
    "#paper": Control(SENT, keys="a"),
    "#typed": Control(SENT, keys="a"),
    "[data-click='teletype.key']": Control(SENT),
    "#in-words": Control("workbench.switches.panel.speaking"),
    ".enlarge": Control(of("main", "className"), ALL),
    ".skip": Control(
        "location.hash",
        f"{ALL} history.replaceState(null, '', '#workbench'); document.querySelector('.skip').focus();",
    ),
    "#sound": Control("workbench.sound.on", keys="Space"),
    "#lever": Control(f"{TTY}.reader.on"),
    "#shelf": Control(f"{TTY}.reader.tape.length", f"{TTY}.reader.remove();", "c"),
    "#save, #save-page": Control("window.saved", SAVED),
    "#pc8 summary": Control(of("#pc8", "open")),
    "#pc8-shelf": Control(f"{FAST}.reader.tape.length", f"{PC8} {FAST}.reader.remove();", "c"),
    "#pc8-tear": Control(f"{FAST}.punch.frames.length", f"{PC8} {FAST}.punch.frames.append(1);"),
    "#drives summary": Control(of("#drives", "open")),
    "[data-change='drives.lock']": Control(f"{DRIVES}.map((drive) => drive.locked)", REEL, "Space"),
    "[data-click='drives.save']": Control("window.saved", REEL + SAVED),
    "[data-click='drives.takeOff']": Control(f"{DRIVES}.map((drive) => drive.image === null)", REEL),
    "#punch-on": Control(f"{TTY}.punch.on"),
    "#tear": Control(f"{TTY}.punch.frames.length", PUNCHED),
    "#store": Control("window.saved", PUNCHED + SAVED),
    "#to-mill": Control(f"{TTY}.punch.frames.length", PUNCHED),
    "#speed": Control(
        "workbench.clock.speed",
        "workbench.time.setSpeed(60); document.getElementById('speed').selectedIndex = 0;",
        "a",
    ),
    "#share": Control("location.hash", "history.replaceState(null, '', '#');"),
    "#open, #put-file": Control(
        "window.chosen",
        "window.chosen = 0; document.getElementById('file').click = () => { window.chosen++; };",
    ),
    "[role=tab]:not(:last-child)": Control(
        SHOWN, "workbench.tabs.open(workbench.tabs.panes[which + 1].id);", "ArrowLeft", CHOSEN
    ),
    "[role=tab]:last-child": Control(SHOWN, opened("exercises"), "ArrowRight", CHOSEN),
    "#sources": Control(f"{EDITOR}.name", WRITTEN, "e"),
    "#assemble": Control(f"{EDITOR}.assembly !== null", f"{WRITTEN} {EDITOR}.assembly = null;"),
    "#load": Control(f"{P}.core[0o200]", ASSEMBLED),
    "#boot": Control(f"{P}.core[0o200]", ASSEMBLED),
    "#source": Control(f"{EDITOR}.text", WRITTEN, "a"),
    "#messages button": Control(of("#source", "selectionStart"), WRONG),
    "#run-it": Control(f"{P}.core[0o200]", WRITTEN + STAND),
    "#forward": Control(f"{P}.clock", LOADED),
    "#back": Control(f"{P}.clock", f"{LOADED} workbench.remember(); workbench.time.step({{ value: 1 }});"),
    "#play": Control(f"{P}.clock", LOADED),
    "#units input": Control(
        "workbench.time.unit", "document.querySelectorAll('#units input')[which ? 0 : 1].click();", "Space"
    ),
    "#next button": Control(f"{P}.clock", f"{LOADED} workbench.show();"),
    "#kind": Control(of("#kind"), opened("debugger"), "w"),
    "#where": Control(of("#where"), opened("debugger"), "7"),
    "#until button": Control(f"{P}.clock", f"{LOADED} document.getElementById('where').value = '0203';"),
    "#registers input": Control(f"[{P}.pc, {P}.lac]", LOADED, "Control+a 1 Enter"),
    "#gutter button": Control(
        f"{MACHINE}.watch.breakpoints.length",
        f"{LOADED} {written('*200', *['7000'] * 90, '$')} {EDITOR}.load();",
    ),
    "#program-name": Control(f"{EDITOR}.name", WRITTEN, "End 7 Enter"),
    "#new-program": Control(f"{EDITOR}.name", WRITTEN),
    "#delete-program": Control(of("#program-says", "textContent"), WRITTEN),
    "#save-as": Control("window.saved", WRITTEN + SAVED, "."),
    "#counts": Control(of("#counts", "checked"), opened("program"), "Space"),
    "#core": Control(of("#core", "scrollTop"), LOADED, "PageDown", within=" th"),
    "#core input": Control(f"[...{P}.core]", LOADED, "Control+a 7 Enter"),
    "#page": Control("workbench.core.first", opened("debugger"), "0"),
    "#eia": Control("workbench.mill.name", CUT, "e"),
    "#at": Control("workbench.mill.part", CUT, "ArrowLeft"),
    "#tolerance": Control("workbench.mill.asked?.[0]", CUT, "ArrowRight"),
    "#run-mill": Control("workbench.mill.part", CUT),
    "#save-cut": Control("window.saved", CUT + SAVED),
    "#blocks": Control(
        of("#blocks", "scrollTop"), f"{CUT} document.getElementById('blocks').scrollTop = 0;", "PageDown"
    ),
    "#slider": Control(f"{SCRIPT}.now", AFTERNOON, "ArrowLeft"),
    "#link": Control(
        "window.copied",
        f"{AFTERNOON} window.copied = 0; navigator.clipboard.writeText = async () => {{ window.copied++; }};",
    ),
    "#part-name": Control(of("#part-name"), PARTS, "e"),
    "#part-options [type=checkbox]": Control(of("#part-options [type=checkbox]", "checked"), PARTS, "Space"),
    "#part-options select": Control(of("#part-options select"), f"{PARTS} {DOOR}", "ArrowDown"),
    "#part-options [type=text]": Control(of("#part-options [type=text]"), f"{PARTS} {DOOR}", "7"),
    "#part-options summary": Control(of("#part-options details", "open"), PARTS),
    "#part-punch": Control(f"{TTY}.reader.tape.length", f"{PARTS} {TTY}.reader.remove();"),
    "#part-translate": Control(f"{TTY}.reader.position", READY),
    "#part-cut": Control("workbench.mill.name", f"{READY} {PUNCHED}"),
    "#exercise": Control("workbench.exercises.name", EXERCISES, "m"),
    "#exercise-link": Control("location.hash", f"{EXERCISES} history.replaceState(null, '', '#');"),
    "#asked [data-click='exercises.begin']": Control(f"{EDITOR}.name", f"{WRITTEN} {EXERCISES}"),
    "#asked .go": Control(
        of("#marks", "textContent.length"), f"{EXERCISES} document.getElementById('marks').textContent = '';"
    ),
    "#enter": Control("workbench.room.open", "if (workbench.room.open) workbench.room.leave();"),
    "#room .chapters button": Control(
        "workbench.room.tour.turn", f"{ROOM} workbench.room.go({{ value: which ? 1 : 2 }});"
    ),
    "#pause": Control("workbench.room.playing", f"{ROOM} workbench.room.go({{ value: 5 }});"),
    "#hear": Control("workbench.sound.on", ROOM),
    "#take": Control("workbench.room.live", ROOM),
    "#write": Control("workbench.room.open", f"{ROOM} if (workbench.room.live) workbench.room.take();"),
    "#leave": Control("workbench.room.open", ROOM),
    "#help": Control(
        f"[{P}.pc, {P}.sr]", f"{TAKEN} {MACHINE}.panel.stop(); {MACHINE}.panel.sr = 0; workbench.touched();"
    ),
    "#mine": Control(SENT, WAITS, "a"),
    "#see": Control("document.getElementById('tape').open", WAITS),
    "#turn": Control("workbench.room.typing", WAITS),
    "#speak": Control("document.getElementById('room').className", TAKEN),
    "#authentic": Control("document.getElementById('truth').open", ROOM),
    "#tape button": Control(
        "document.getElementById('tape').open", f"{ROOM} document.getElementById('tape').showModal();"
    ),
    "#truth button": Control(
        "document.getElementById('truth').open", f"{ROOM} document.getElementById('truth').showModal();"
    ),
    # The last one: a machine in the midst of a data break is not made to stand by setting its registers.
    "#boot-reel": Control(
        f"{P}.run", f"{CLOSE} if (workbench.room.open) workbench.room.leave(); {REEL} {P}.run = 0;"
    ),
}


_ALL = f"workbench.enter(); workbench.room.leave(); {REEL} {CUT} {LOADED} {WRONG} {OPEN}"
"""Everything that can be there is there: a listing, messages, blocks, the card."""
_OF_A_FAMILY = 12 if WHOLE else 3
"""How many are tried of those that are alike; by `WHOLE=1` all the switches, some of the words of core."""
_FIELDS = "select, textarea, input:not([type=checkbox], [type=range]), [tabindex='0']:not(button)"
"""What a pointer gives the focus to, and keys then work."""
_FOUND = """(selectors) => {
  const controls = "button, input:not([hidden]), select, textarea, summary, a[href], [tabindex='0']";
  return [...document.querySelectorAll(controls)].map((control) =>
    selectors.find((selector) => control.matches(selector)) ?? control.outerHTML.slice(0, 100));
}"""
_NAMED = re.compile(r'data-(?:click|change|input|submit)=[\'"]([\w.]+)')
_WRONG = """(paths) => paths.filter((path) =>
  typeof path.split(".").reduce((of, name) => of?.[name], workbench) !== "function")"""


def test_every_control_is_tried(page: Page) -> None:
    """The page and the table have the same controls; what any HTML names is there to be called."""
    page.evaluate(f"() => {{ {_ALL} }}")
    assert set(page.evaluate(_FOUND, list(CONTROLS))) == set(CONTROLS)
    web = Path(shelf.__file__).parent / "web"
    named = {name for file in web.rglob("*.[hm]*") for name in _NAMED.findall(file.read_text())}
    assert page.evaluate(_WRONG, sorted(named)) == []
    assert len(named) > 70


@pytest.mark.slow  # ten seconds and more each: some 100 controls, in each browser
@pytest.mark.parametrize("way", ["mouse", pytest.param("touch", marks=pytest.mark.rare("1 min")), "keyboard"])
def test_every_control_works(tab: Tab, way: str) -> None:
    """What it is there for is seen to happen."""
    tab.run(f"workbench.afternoon.go(0); {_ALL}")
    tab.until("workbench.afternoon.script")
    for selector, control in CONTROLS.items():
        count = tab.run(f"return document.querySelectorAll({json.dumps(selector)}).length")
        for which in range(min(count, _OF_A_FAMILY)):
            with case(selector, which):
                try:
                    _try(tab, control, selector, which, way)
                except AssertionError:  # on a busy machine a list scrolls before its key comes
                    _try(tab, control, selector, which, way)


def _try(tab: Tab, control: Control, selector: str, which: int, way: str) -> None:
    """Bring the page to where the control can be used, work it, and see that it works."""
    tab.run(f"const which = {which}; {control.before} workbench.show();")
    tab.run(f"window.earlier = JSON.stringify({control.watch});")
    _work(tab, control, selector, which, way)
    tab.until(f"JSON.stringify({control.watch}) !== window.earlier")


def _work(tab: Tab, control: Control, selector: str, which: int, way: str) -> None:
    """Work a control by mouse, touch or keyboard."""
    first = f"document.querySelector({json.dumps(selector)})"
    if tab.run(f"return !!{first}?.matches('select')"):
        way = "keyboard"  # a list that a pointer has opened is the browser's, not the page's
    if way == "keyboard":
        focus = json.dumps(control.focus or selector)
        focused = f"document.querySelectorAll({focus})[{0 if control.focus else which}]"
        tab.until(focused)  # a text that was put in is looked at a moment later
        tab.run(f"{focused}.focus()")
    else:
        tab.point(selector + control.within, which, way)
    if way == "keyboard" or tab.run(f'return !!{first}?.matches("{_FIELDS}")'):  # it may be gone
        for keys in control.keys.split():
            tab.press(keys)
