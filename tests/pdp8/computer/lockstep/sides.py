"""The machine in each of its forms, and the reference, each doing all acts of a situation.

compiled, plain    the package, as Cython compiled it and as Python reads its sources
javascript         the package as the pages have it, in Node.js (side.mjs)

What is called, set and seen of a machine is named by its path in the package; SEEN has what is the same of
the reference.
"""

import copy
import json
import subprocess
import sys
from array import array
from collections.abc import Iterable
from functools import cache, partial
from operator import attrgetter
from pathlib import Path
from typing import Any
from unittest.mock import patch

from tests.pdp8.computer.lockstep.situations import CONT, LOOKS, Act, Situation, put
from tests.pdp8.computer.speed.forms import module
from tests.pdp8.web.node import NODE, modules
from tests.reference.model import NEVER, QUEUE, Counts, Reference

FORMS = ("compiled", "plain", *(["javascript"] if NODE else []))
TICKS_PER_SECOND = 20_000_000
Seen = dict[str, Any]

SEEN = {
    **{f"panel.lamps.{name}": name for name in ("ma", "mb", "link", "ac", "ir", "ion", "protect", "run")},
    **{f"panel.lamps.{name}": name for name in ("fetch", "defer", "execute")},
    **{f"panel.lamps.{name}": name for name in ("word_count", "current_address", "break_")},
    "panel.lamps.parity": "dark",
    **{"pc": "pc", "sr": "sr", "processor.next": "next", "processor.ion_delayed": "ion_ready"},
    **{"processor.clock": "now", "instructions": "instructions", "processor.core": "core"},
    "teletype.receiver.flag": "teletype.receiver.flag",
    "teletype.receiver.buffer": "teletype.receiver.bits",
    "teletype.receiver.reader_run": "teletype.receiver.reader_run",
    "teletype.reader.position": "teletype.sender.position",
    "teletype.keyboard.waiting": "waiting",
    "teletype.transmitter.flag": "teletype.transmitter.flag",
    "teletype.transmitter.register": "register",
    "teletype.printer.frames": "page",
    "teletype.punch.frames": "punched",
}
SEEN_FAST = {
    **{f"highspeed.reader_control.{name}": f"fast_reader.{name}" for name in ("flag", "buffer", "fetching")},
    **{f"highspeed.punch_control.{name}": f"fast_punch.{name}" for name in ("flag", "buffer")},
    "highspeed.reader.position": "fast_tape.position",
    "highspeed.punch.frames": "fast_punched",
}


STATES = ("fetch", "defer", "execute", "", "word_count", "current_address", "break_")
BREAKER = ("flag", "breaking", "word", "left")
_REGISTERS = ("inst_field", "data_field", "inst_buffer", "saved_inst", "saved_data", "inhibit", "field")
SEEN_RACK = {
    **{f"processor.extension.{name}": name for name in _REGISTERS},
    "panel.ema": "ema",
    **{f"devices.{device - 2}.{name}": f"breaker{device}.{name}" for device in (0, 1) for name in BREAKER},
}
"""The breakers are the last of the machine's devices."""


def seen_of(situation: Situation) -> dict[str, str]:
    """Return what is compared of a machine with what the situation fits."""
    return SEEN | (SEEN_FAST if situation.fast else {}) | (SEEN_RACK if situation.memory else {})


def breakers(form: str) -> list[Any]:
    """Return the two devices with data breaks, in a form of the machine."""
    names = [f"pdp8.computer.hardware.{name}" for name in ("bus", "fields", "signals")]
    source = Path(__file__).with_name("breaker.py")
    there: dict[str, Any] = {"__name__": "breaker"}
    with patch.dict(sys.modules, {name: module(form, name) for name in names}):
        exec(compile(source.read_text(), source, "exec"), there)
    return [there["Breaker"](), there["Nearer"]()]


class Side:
    """Does the acts of a situation, one after the other, by its methods."""

    def __init__(self) -> None:
        self.marks: frozenset[int] = frozenset()
        self.writes: frozenset[int] = frozenset()

    def do(self, act: Act) -> str | None:
        """Do an act; return why the run ended, if it was one."""
        result: str | None = getattr(self, act.name)(*act.values)
        return result

    def seen(self) -> Seen:
        """Return everything that can be seen of the machine."""
        raise NotImplementedError

    def breakpoints(self, addresses: frozenset[int]) -> None:
        self.marks = addresses

    def watch(self, writes: frozenset[int], observed: bool) -> None:
        self.writes = writes

    def delays(self, on: bool) -> None:
        """Whether delay loops are counted down at once."""


class InPython(Side):
    """The machine of the package, compiled or plain."""

    def __init__(self, form: str, situation: Situation) -> None:
        super().__init__()
        self.module = partial(module, form)
        self.form, self.rack = form, situation.memory > 0
        self.machine = self.module("pdp8.computer.machine").Machine(memory=situation.memory or 4096)
        if situation.fast:
            self.machine.fit(self.machine.highspeed)
        for device in breakers(form) if self.rack else ():
            self.machine.fit(device)
        self.machine.load(situation.words)
        self.paths = [path.rpartition(".") for path in seen_of(situation)]
        self.count_delays = True
        self.count: Any = None
        self.history: Any = None

    def call(self, path: str, *values: Any) -> None:
        attrgetter(path)(self.machine)(*values)

    def part(self, path: str) -> Any:
        """Return what is at a path, in which numbers are places of lists."""
        part: Any = self.machine
        for name in path.split(".") if path else ():
            part = part[int(name)] if name in ("-1", "-2") else getattr(part, name)
        return part

    def set(self, path: str, value: Any) -> None:
        owner, _, name = f"machine.{path}".rpartition(".")
        setattr(attrgetter(owner)(self), name, value)

    def wait(self, ticks: int) -> None:
        self.machine.wait(ticks / TICKS_PER_SECOND)

    def deposit_at_pc(self, beyond: int, word: int) -> None:
        pc = self.machine.pc
        self.machine.core[pc & 0o70000 | pc + beyond & 0o7777] = word

    def delays(self, on: bool) -> None:
        self.count_delays = on

    def watch(self, writes: frozenset[int], observed: bool) -> None:
        super().watch(writes, observed)
        self.count = self.module("pdp8.computer.count").Count() if observed else None

    def run(self, ticks: int | None, instructions: int) -> str:
        watch = self.machine.watch
        watch.breakpoints, watch.writes, watch.observer = set(self.marks), set(self.writes), self.count
        self.machine.engine.delays = self.count_delays
        seconds = None if ticks is None else ticks / TICKS_PER_SECOND
        return str(self.machine.run(seconds, instructions).reason)

    def single_cycle(self) -> None:
        self.machine.panel.sing_step = True
        self.machine.run()
        self.machine.panel.sing_step = False

    def run_cycles(self, count: int) -> None:
        self.machine.run(cycles=count)

    def look(self) -> None:
        """Save it, copy it, begin a run in slices: nothing is changed by that."""
        self.module("pdp8.computer.past.state").save(self.machine)
        copy.deepcopy(self.machine)
        next(self.machine.slices(0))

    def save_and_restore(self) -> None:
        """Go on with a copy made from what is saved."""
        state = self.module("pdp8.computer.past.state")
        text = state.save(self.machine)
        self.machine = state.restore(text, breakers(self.form) if self.rack else [])
        self.machine.watch.observer = self.count
        assert state.save(self.machine) == text

    def record(self) -> None:
        self.history = self.module("pdp8.computer.past.history").History(self.machine)

    def back(self, instructions: int) -> None:
        self.module("pdp8.computer.past.rewind").instructions(self.history, instructions)

    def seen(self) -> Seen:
        parts = {path: self.part(path) for path in {path for path, *_ in self.paths}}
        seen = {path + dot + name: _plain(getattr(parts[path], name)) for path, dot, name in self.paths}
        return seen | _counted(self.count, lambda name: +getattr(self.count, name))


def _plain(value: Any) -> Any:
    return value if isinstance(value, int) else bytes(value)


def _counted(count: Any, by_address: Any) -> Seen:
    if not count:
        return {"counted": 0}
    seen = {name: getattr(count, name) for name in ("cycles", "ticks", "interrupts")}
    seen |= {name: by_address(name) for name in ("executed", "written")}
    return seen | {"counted": sum(seen["executed"].values())}


class InNode(Side):
    """The machine of the pages, of which Node.js has one at a time."""

    def __init__(self, situation: Situation) -> None:
        paths = [path for path in seen_of(situation) if path != "processor.core"]
        fast, words, memory = situation.fast, list(situation.words.items()), situation.memory
        _node().ask({"fast": fast, "words": words, "paths": paths, "memory": memory})
        self._seen: Seen = {}
        self._core = array("H", bytes(2 * (memory or 4096)))

    def do(self, act: Act) -> str | None:
        reason, different, words = _node().ask([act.name, [_as_json(value) for value in act.values]])
        for name, value in different.items():
            self._seen[name] = bytes.fromhex(value) if isinstance(value, str) else value
        for address, word in words:
            self._core[address] = word
        return str(reason) if reason else None

    def seen(self) -> Seen:
        return {**self._seen, "processor.core": self._core.tobytes()}


def _as_json(value: Any) -> Any:
    return list(value) if isinstance(value, bytes | frozenset) else value


class _Node:
    """One Node.js for all situations; it ends with its standard input, that is with us."""

    def __init__(self) -> None:
        command = [str(NODE), str(Path(__file__).with_name("side.mjs")), str(modules())]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, given: object) -> Any:
        asked, answered = self._process.stdin, self._process.stdout
        assert asked
        assert answered
        print(json.dumps(given), file=asked, flush=True)
        line = answered.readline()
        assert line, "Node.js ended; its message stands above"
        return json.loads(line)


_node = cache(_Node)


class ReferenceSide(Side):
    """The reference."""

    def __init__(self, situation: Situation) -> None:
        super().__init__()
        self.reference = Reference(situation.fast)
        self.reference.do("rack", situation.memory or 4096, situation.memory > 0)
        self.paths = seen_of(situation)
        for address, word in situation.words.items():
            self.reference.core[address] = word
        self.counts: Counts | None = None
        self.moments: dict[int, Reference] | None = None

    def call(self, path: str, *values: Any) -> None:
        where, _, what = path.rpartition(".")
        m, fast = self.reference, where == "highspeed.reader"
        if path in LOOKS:
            return
        if where == "panel":
            self._stands(what)
            m.press(what)
        elif what in ("load", "lever"):
            m.do("tape" if what == "load" else "lever", fast, *values)
        elif what == "press":
            m.do("type", *values)
        else:
            assert path == "core.__setitem__"
            m.core[values[0]] = values[1]

    def set(self, path: str, value: int) -> None:
        m = self.reference
        if path == "panel.sing_step":
            m.do("sing_step", value)
            return
        others = {"teletype.punch.on": "punch_on", "highspeed.punch.on": "fast_punch_on"}
        others |= {f"panel.{name}_field": f"{name}_switch" for name in ("inst", "data")}
        if path in ("panel.inst_field", "panel.data_field"):
            value <<= 12
        if path == "pc":
            m.do("set_pc", value)
            return
        setattr(m, others.get(path, path.removeprefix("panel.")), value)
        if path == "ion":
            m.ion_ready = value

    def wait(self, ticks: int) -> None:
        self.reference.do("wait", ticks)

    def deposit_at_pc(self, beyond: int, word: int) -> None:
        m = self.reference
        m.core[m.inst_field | m.pc + beyond & 0o7777] = word

    def _stands(self, key: str = "") -> None:
        """Note a moment that can be gone back to: the last with so many instructions. For START under
        SING STEP it is that between INITIALIZE and the cycle.
        """
        if self.moments is None:
            return
        moment = self.moments[self.reference.instructions] = self.reference.copied()
        if key == "start" and moment.sing_step:
            moment.sing_step = 0
            moment.press("start")
            moment.run, moment.sing_step = 0, 1

    def run(self, ticks: int | None, instructions: int) -> str:
        """Run a piece; return "limit", "stopped" or "breakpoint"."""
        self._stands()
        m = self.reference
        until = NEVER if ticks is None else m.now + ticks
        reason = m.run_to(until, m.instructions + instructions, self.marks, self.writes)
        if reason != "limit":
            m.do("finish")
        return reason

    def run_endless(self, instructions: int) -> bool:
        """Run as far as a machine did before it said that it waits for ever; tell whether it does."""
        self._stands()
        m = self.reference
        reason = m.run_to(NEVER, instructions, self.marks, self.writes)
        m.do("finish")
        return reason == "limit" and bool(m.do("endless"))

    def watch(self, writes: frozenset[int], observed: bool) -> None:
        super().watch(writes, observed)
        self.counts = self.reference.count() if observed else None

    def single_cycle(self) -> None:
        for part in (put("panel.sing_step", True), CONT, put("panel.sing_step", False)):
            self.do(part)

    def run_cycles(self, count: int) -> None:
        self._stands()
        if self.reference.do("run_cycles", count):
            self.reference.do("finish")

    def look(self) -> None:
        """Nothing is changed by it."""

    def save_and_restore(self) -> None:
        """Nothing is lost here."""

    def record(self) -> None:
        self.moments = {}

    def back(self, instructions: int) -> None:
        assert self.moments is not None
        self.reference = self.moments[self.reference.instructions - instructions].copied()
        self.reference.count(self.counts)

    def seen(self) -> Seen:
        m = self.reference
        sender, transmitter = m.teletype.sender, m.teletype.transmitter
        own: Seen = {name: int(m.state == state) for state, name in enumerate(STATES) if name}
        own |= {"pc": m.inst_field | m.pc, "ema": m.ema >> 12}
        own["core"] = bytes(m.core)[: 2 * m.size]
        for number, device in enumerate(m.breaker):
            own |= {f"breaker{number}.{name}": getattr(device, name) for name in BREAKER}
        own |= {"dark": 0, "register": transmitter.enable << 8 | transmitter.bits}
        own["waiting"] = bytes(sender.keyboard[n % QUEUE] for n in range(sender.keys_sent, sender.keys))
        seen = {
            path: own[theirs] if theirs in own else _plain(attrgetter(theirs)(m))
            for path, theirs in self.paths.items()
        }
        return seen | _counted(self.counts, lambda name: self.counts and self.counts.by_address(name))


def sides(forms: Iterable[str], situation: Situation) -> dict[str, Side]:
    """Return the machine in each of `forms`, as the situation begins."""
    return {form: InNode(situation) if form == "javascript" else InPython(form, situation) for form in forms}
