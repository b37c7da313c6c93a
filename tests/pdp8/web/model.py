"""A small model of the page: random steps by its controls, and what must be true after each.

    python -m tests.pdp8.web.model 10000 [SEED]         in Node.js; test_model.py has it in Chromium, too

The model knows nothing of the page's code: programs by name, what was punched, the switches, who leads the
machine, what is kept. Whatever the page shows that the model does not expect is a difference.
"""

import random
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

from pdp8 import shelf
from pdp8.lessons import form
from pdp8.web import method
from tapes import binary
from tests.pdp8.web import small
from tests.pdp8.web.browsing import DESK, Page, until

NEW = "/ A new program\n*200\n\tCLA CLL\n\tHLT\n$\n"
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
SECOND = 20_000_000
"""Ticks."""
EIA_PAL = binary.decode(shelf.read_bundled("eia.bin")).words.items()
SHEET = "follow-a-digit"
"""An exercise that no program answers."""
PRESSED = (
    "#drill", "#counts", "#in-words", "#lever", "#card summary", "#run-mill",
    "#computer .enlarge", "#assemble",
    *(f"#computer [data-key='{key}']" for key in ("load add", "exam", "dep")),
)  # fmt: skip
IDLE = """(() => {
  const { bus, processor } = workbench.machine;
  return !processor.run && bus.next_event(processor.clock) > 1e14;
})()"""
"""The processor is stopped, and no device has anything to do."""
WORKED = "workbench.machine.processor.core.some(Boolean) || workbench.machine.teletype.reader.loaded"
NEWEST = 20
"""Tapes that a reload finds again."""
STALE = Path(__file__).with_name("stale.mjs").read_text(encoding="utf-8")
DRIVER = (
    STALE
    + """
window.driver = {
  click(selector) { document.querySelector(selector).click(); },
  put(selector, value, ...events) {
    const field = document.querySelector(selector);
    field.value = value;
    for (const each of events) field.dispatchEvent(new Event(each, { bubbles: true }));
  },
  facts() {
    const { afternoon, editor, exercises, machine, programs, room, shelf, teletype } = workbench;
    const marked = (name) => {
      const button = document.querySelector(`#computer [data-key="${name}"]`);
      return (button.ariaPressed ?? button.ariaChecked) === "true";
    };
    return {
      programs: Object.fromEntries(programs.names().map((name) => [name, programs.get(name)])),
      program: editor.name, text: editor.text, shown: document.getElementById("program-name").value,
      stale: stale(), exercise: exercises.name, led: afternoon.on, playing: afternoon.playing,
      over: afternoon.on && afternoon.script.now >= afternoon.script.end,
      room: room.open,
      sr: machine.processor.sr,
      step: Boolean(machine.processor.sing_step), protect: Boolean(machine.processor.mem_prot),
      marks: [marked("sing step"), marked("mem prot")],
      punched: afternoon.on ? null : [...machine.teletype.punch.frames].map((frame) => frame & 0o177),
      tapes: shelf.names().filter((name) => !shelf.bundled.includes(name)),
      mounted: afternoon.on ? null : teletype.called(),
      unit: document.querySelector("#units :checked").value, speed: document.getElementById("speed").value,
      refused: !dispatchEvent(new Event("beforeunload", { cancelable: true })),
    };
  },
};
"""
)

REFUSING = """() => {
  const { setItem } = Storage.prototype;
  Storage.prototype.setItem = function (name, text) {
    if (name.startsWith("pdp8 program")) throw new Error("full");
    setItem.call(this, name, text);
  };
}"""


class Model:
    """What must be true of the page; each method does one step at both."""

    def __init__(self, page: Page, draw: random.Random) -> None:
        self.page, self.draw = page, draw
        self.programs: dict[str, str] = {}
        self.punched: list[int] = []
        self.sr, self.step, self.protect = 0, False, False
        self.tapes: list[str] = []
        self.dropped: dict[str, str] = {}
        self.mounted = ""
        self.exercise = "add"
        self.held: tuple[int, bool, bool, list[int]] | None = None
        self.led = self.playing = False
        self.laid = False
        """Whether the story's source lies over the program, to be read."""
        self.refuses = False
        page.evaluate(DRIVER)
        facts = self._facts()
        self.program, self.text = facts["program"], facts["text"]
        self.programs[self.program] = self.text
        self.unit, self.speed = facts["unit"], facts["speed"]
        self.steps: dict[Callable[[], None], int] = {
            self.create: 2, self.write: 4, self.rename: 2, self.remove_and_undo: 1, self.choose: 3,
            self.run: 4, self.flip: 3, self.throw: 4, self.drop: 3, self.mount: 3, self.tear: 2,
            self.translate: 1, self.lead: 3, self.play: 4, self.drag: 4, self.take_over: 3,
            self.visit_room: 2, self.pick_unit: 2, self.pick_speed: 2, self.reload: 2,
            self.other_tab: 1, self.refuse: 1, self.answer: 2, self.restore: 3,
            self.strike: 2, self.look: 3, self.press: 4,
        }  # fmt: skip

    def one(self) -> str:
        """Do a step drawn at random; return its name."""
        (step,) = self.draw.choices([*self.steps], [*self.steps.values()])
        step()
        return step.__name__

    def differences(self) -> dict[str, tuple[object, object]]:
        """{what differs: (in the page, in the model)}."""
        facts = self._facts()
        if self.led:
            if facts["over"]:  # it stops there with the next picture
                until(self.page, "!workbench.afternoon.playing")
                facts, self.playing = self._facts(), False
            label = "Pause" if self.playing else "Play"  # the button follows with the next picture
            until(self.page, f"workbench.afternoon.script.now >= workbench.afternoon.script.end || "
                             f"document.getElementById('play').textContent === {label!r}")  # fmt: skip
        if (
            self.text != self.programs[self.program]
        ):  # typing is kept when another program is opened, or at the end
            facts["programs"][self.program] = self.text
            self.programs[self.program] = self.text
        expected: dict[str, object] = {
            "programs": self.programs, "program": self.program,
            "led": self.led, "playing": self.playing, "room": False,
            "tapes": self.tapes, "unit": self.unit, "speed": self.speed,
            "refused": self.refuses, "stale": [], "exercise": self.exercise,
        }  # fmt: skip
        if not self.laid:
            expected |= {"text": self.text, "shown": self.program}
        if not self.led:
            expected |= {
                "sr": self.sr, "step": self.step, "protect": self.protect, "marks": [self.step, self.protect],
                "punched": self.punched, "mounted": self.mounted,
            }  # fmt: skip
        return {name: (facts[name], value) for name, value in expected.items() if facts[name] != value}

    def _facts(self) -> dict[str, Any]:
        facts: dict[str, Any] = self.page.evaluate("driver.facts()")
        return facts

    def _click(self, selector: str) -> None:
        self.page.evaluate("(selector) => driver.click(selector)", selector)

    def _put(self, selector: str, value: str, *events: str) -> None:
        self.page.evaluate("([selector, value, ...events]) => driver.put(selector, value, ...events)",
                           [selector, value, *events])  # fmt: skip

    # Programs

    def _turn(self, name: str) -> None:
        self.laid = False
        self.program, self.text = name, self.programs[name]

    def create(self) -> None:
        if self.refuses or self.led:
            return
        self._click("#new-program")
        name, number = "program.pal", 1
        while self.programs.get(name, NEW) != NEW:
            number += 1
            name = f"program {number}.pal"
        self.programs[name] = NEW
        self._turn(name)

    def write(self) -> None:
        if self.laid:
            return
        letter = self.draw.choice(LETTERS)
        self.text = f"*200\n\tCLA CLL\n\tTAD C\n\tTLS\n\tTSF\n\tJMP .-1\n\tHLT\nC,\t{ord(letter):o}\n$\n"
        self._put("#source", self.text, "input")

    def rename(self) -> None:
        if self.refuses or self.laid:
            return
        name = f"{self.draw.choice(LETTERS).lower()}  {self.draw.randrange(100)}.pal"
        if name in self.programs:
            return
        self._put("#program-name", name, "change")
        del self.programs[self.program]
        self.programs[name] = self.text
        self.program = name

    def choose(self) -> None:
        if self.led:
            return
        name = self.draw.choice([*self.programs])
        self._put("#sources", name, "change")
        self._turn(name)

    def answer(self) -> None:
        """Open an exercise, and the program that answers it."""
        if self.refuses or self.led:
            return
        self.exercise = self.draw.choice(("add", "larger", SHEET))
        self._put("#exercise", self.exercise, "change")
        if self.exercise == SHEET:
            return
        self._click("#asked [data-click='exercises.begin']")
        begun = f"/ {form.read(self.exercise).title}\n*200\n\tHLT\n$\n"
        self.programs.setdefault(f"{self.exercise}.pal", begun)
        self._turn(f"{self.exercise}.pal")

    def remove_and_undo(self) -> None:
        if self.refuses or self.laid:
            return
        self._click("#delete-program")
        if len(self.programs) == 1:  # there is always one that is open
            self.programs.setdefault("program.pal", NEW)
        self.page.evaluate("driver.click(\"[data-click='editor.undo']\")")

    # The machine

    def take_over(self) -> None:
        """Touch a switch: the machine is the visitor's, as the story has it."""
        self.flip()

    def flip(self) -> None:
        self._click("#computer .rocker[value='11']")
        self.sr ^= 1
        if self.led:
            self._taken()

    def _taken(self) -> None:
        """What the story left in the machine is the visitor's."""
        self._click('#computer [data-key="stop"]')
        until(self.page, IDLE)  # the Teletype ends what it has begun
        facts = self._facts()
        self.sr, self.step, self.protect = facts["sr"], facts["step"], facts["protect"]
        self.punched, self.mounted = facts["punched"], facts["mounted"]
        self.led = self.playing = False

    def throw(self) -> None:
        if self.led:
            return
        name = self.draw.choice(("sing step", "mem prot"))
        self._click(f'#computer [data-key="{name}"]')
        if name == "sing step":
            self.step = not self.step
        else:
            self.protect = not self.protect

    def run(self) -> None:
        """Assemble, load, START: with both switches down the program punches its letter and halts."""
        if self.led or self.laid or self.step or self.protect or "C,\t" not in self.text:
            return
        self._put("#speed", "Infinity", "change")
        self.speed = "Infinity"
        self._click("#run-it")
        until(self.page, "!workbench.machine.processor.run")
        self.sr = 0o200
        self.punched.append(int(self.text.split("C,\t")[1].split("\n")[0], 8))

    def press(self) -> None:
        """Press what changes nothing that the model knows; what is shown of it is compared all the same."""
        if self.led:
            return
        self._click(self.draw.choice(PRESSED))
        self._put("#eia", self.draw.choice(("", "circle-fewest.eia", "slope-fewest.eia")), "change")

    def look(self) -> None:
        """Open another tab."""
        panes = ("program", "debugger", "mill", "parts", "exercises", "figures")
        self._click(f"[data-opens={self.draw.choice(panes)}]")

    def strike(self) -> None:
        """A key of the Teletype reaches the computer at any speed, and comes no further while it stands."""
        if self.led:
            return
        self.speed = self.draw.choice(("1", "Infinity"))
        self._put("#speed", self.speed, "change")
        self._click("[data-key='return']")
        until(self.page, f"workbench.machine.teletype.receiver.flag && {IDLE}")

    def restore(self) -> None:
        """Save the machine, or open the one that was saved."""
        if self.led:
            return
        if not self.held:
            self.page.evaluate("() => { window.held = workbench.drives.bare(workbench.machine); }")
            self.held = self.sr, self.step, self.protect, [*self.punched]
            return
        self.page.evaluate("() => workbench.take(new File([window.held], 'held.state'))")
        (self.sr, self.step, self.protect, self.punched), self.held = self.held, None
        self.mounted = ""

    # Tapes

    def drop(self) -> None:
        if not self.led:
            self._drop()

    def _drop(self) -> None:
        content = f"{self.draw.randrange(40)} 2\r\n"
        self.page.evaluate("(content) => workbench.take(new File([content], 't  t.txt'))", content)
        name, number = "t  t.txt", 1
        while name in self.tapes and self.dropped[name] != content:
            number += 1
            name = f"t  t {number}.txt"
        self.dropped[name] = content
        until(self.page, f"workbench.teletype.called() === {name!r}")
        self.tapes = [*(each for each in self.tapes if each != name), name]
        self.mounted = name

    def mount(self) -> None:
        if self.led or not self.tapes:
            return
        self.mounted = self.draw.choice(self.tapes)
        self._put("#shelf", self.mounted, "change")

    def tear(self) -> None:
        if self.led or not self.punched:
            return
        before = self.tapes
        self._click("#tear")
        *others, torn = self.tapes = self._facts()["tapes"]
        assert others == [each for each in before if each != torn], "it is the newest"
        self.punched = []

    def translate(self) -> None:
        """A part through eia.pal: what is punched is its EIA tape only, however often it is done."""
        if self.led or self.step or self.protect or self.refuses:
            return
        self._put("#part-name", "drill", "change")
        self.page.evaluate("document.querySelector('#part-options [name]').value = '1,1'")
        self.page.evaluate("workbench.parts.punch()")
        until(self.page, "!document.getElementById('part-translate').disabled")
        self._click("#part-translate")
        until(self.page, "!workbench.parts.translating && !document.getElementById('part-cut').disabled")
        facts = self._facts()
        tape = self.page.evaluate("[...workbench.shelf.get(workbench.teletype.called()).frames]")
        made = method.translated(EIA_PAL, bytes(tape)).teletype.punch.tape
        assert facts["punched"] == [frame & 0o177 for frame in made], "its tape, and nothing before it"
        self.page.evaluate(
            "workbench.machine.panel.stop(); workbench.touched()"
        )  # it would read the next tape
        self.laid = False
        self.tapes, self.mounted, self.punched = facts["tapes"], facts["mounted"], facts["punched"]
        self.sr, self.program, self.text = facts["sr"], facts["program"], facts["text"]
        self.programs[self.program] = self.text

    # The afternoon

    def lead(self) -> None:
        seconds = self.draw.randrange(1, 10_000)
        self.speed = "10"  # as fast as it goes a play would end between two steps
        self._put("#speed", self.speed, "change")
        self.page.evaluate("(tick) => workbench.afternoon.go(tick)", seconds * SECOND)
        self.led = self.laid = True

    def play(self) -> None:
        if not self.led:
            return
        self._click("#play")
        self.playing = not self.playing

    def drag(self) -> None:
        """While it is held the play waits; let go, it goes on if it played before."""
        if not self.led:
            return
        for _ in range(self.draw.randrange(1, 4)):
            self._put("#slider", str(self.draw.randrange(1, 10_000) * SECOND), "input")
            assert not self._facts()["playing"]
        self._put("#slider", str(self.draw.randrange(1, 10_000) * SECOND), "change")

    def visit_room(self) -> None:
        """Into the room, at its switches or not, and back, also by a tape that is dropped there: the machine
        is as the visitor left it.
        """
        worked = self.page.evaluate(WORKED)
        self._click("#enter")
        if self.led:  # a play ends there
            self.playing = False
            self._click("#leave")
            return
        way = self.draw.choice(("take", "take", "look", "drop"))
        if way == "take":
            self._click("#take")
            self._click('#room [data-key="stop"]')
            until(self.page, IDLE)
            self._click("#room .rocker[value='10']")
            self.sr ^= 2
        if way == "drop":
            self._drop()
        else:
            self._click("#leave")
        self.laid = True
        if worked:
            return
        if way == "look":
            self.led = True
            self.playing = self._facts()["playing"]
        else:
            self._taken()

    # What is kept

    def pick_unit(self) -> None:
        self.unit = self.draw.choice(("block", "character", "instruction", "cycle"))
        self._click(f"#units [value='{self.unit}']")

    def pick_speed(self) -> None:
        self.speed = self.draw.choice(("1", "10") if self.led else ("1", "10", "Infinity"))
        self._put("#speed", self.speed, "change")

    def reload(self) -> None:
        """All is as it was, by the room, too, or before a story led, which does not any more; of the tapes
        the newest are kept.
        """
        if self.refuses:
            return
        end = self.draw.choice((DESK, "")) if not self.led and self.page.evaluate(WORKED) else DESK
        here = "history.replaceState(null, '', location.href.replace(/#.*/, '') + end)"
        self.page.evaluate(f"(end) => {{ workbench.afternoon.hush(); {here}; }}", end)
        tab = self.page.evaluate("workbench.tabs.kept")
        self.page.reload()
        self._found_again()
        if not end:
            assert self.page.evaluate("stale()") == []
            self._click("#leave")
        assert self.page.evaluate("workbench.tabs.kept") == tab

    def _found_again(self) -> None:
        until(self.page, "!!window.workbench?.ready")
        self.page.evaluate(DRIVER)
        self.tapes = self.tapes[-NEWEST:]
        self.laid = self.led = self.playing = False
        self.held = None

    def other_tab(self) -> None:
        """Another tab has other settings, and is closed last: this one finds its own."""
        if self.refuses or self.led:
            return
        here = self.page.url.partition("#")[0] + DESK
        self.page.goto("about:blank")
        other = self.page.context.new_page()
        other.goto(here)
        until(other, "!!window.workbench?.ready")
        other.evaluate(DRIVER)
        other.evaluate("driver.click(\"#units [value='block']\"); driver.put('#speed', '10', 'change')")
        other.close()
        self.page.goto(here)
        self._found_again()

    def refuse(self) -> None:
        """The browser keeps no program from now on: before the page is left it asks about what is new."""
        if self.refuses or self.led or self.laid:
            return
        self.page.evaluate(REFUSING)
        self.write()
        self.refuses = True
        self.page.evaluate("workbench.editor.keep()")


def differ(page: Page, count: int, seed: int) -> str:
    """Do `count` steps; return the first difference with the steps before it, "" for none."""
    model = Model(page, random.Random(seed))
    done: list[str] = []
    for _ in range(count):
        done.append(model.one())
        if found := model.differences():
            return f"seed {seed}, after {done[-12:]}, {len(done)} steps: {found}"
    return ""


def main() -> None:
    """Do so many steps, two hundred in a page."""
    from pdp8.web.workbench import page as workbench

    count, first = int(sys.argv[1]), int(sys.argv[2]) if sys.argv[2:] else 0
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "pdp8.html"
        file.write_text(workbench(), encoding="utf-8")
        for seed in range(first, first + count // 200):
            with small.visit(file, DESK) as page:
                print(seed, differ(cast("Page", page), 200, seed) or "no difference", flush=True)


if __name__ == "__main__":
    main()
