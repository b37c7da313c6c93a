"""The machine in each of its forms, and the reference, each with a method for every act of a situation.

compiled, plain    the package, as Cython compiled it and as Python reads its sources
javascript         the package as the pages have it, in Node.js (side.mjs)
"""

import copy
import json
import subprocess
from array import array
from collections.abc import Callable
from functools import cache, partial
from itertools import islice
from pathlib import Path
from typing import Any, Protocol

from tests.pdp8.computer.lockstep.situations import Act, Situation
from tests.pdp8.computer.speed.forms import module
from tests.pdp8.web.node import NODE, modules
from tests.reference.model import NEVER, Counts, Reference

TICKS_PER_SECOND = 20_000_000
LONGEST_WATCHED = 2_000
"""Instructions of a piece that is watched: the machine is slow then."""
Seen = dict[str, Any]


class Side(Protocol):
    """A machine that does all acts of one situation, one after the other."""

    def do(self, act: Act) -> str | None:
        """Do an act; return why the run ended, if it was one."""

    def seen(self) -> Seen:
        """Return everything that can be seen of the machine."""


def side(form: str, situation: Situation) -> Side:
    """Return the machine in a form, as the situation begins."""
    return InNode(situation) if form == "javascript" else InPython(form, situation)


class Acting:
    """Does acts by its methods, and keeps which instructions are watched."""

    def __init__(self) -> None:
        self.marks: frozenset[int] = frozenset()
        self.writes: frozenset[int] = frozenset()
        self.observed = False

    def do(self, act: Act) -> str | None:
        result: str | None = getattr(self, act.name)(*act.values)
        return result

    def breakpoints(self, addresses: frozenset[int]) -> None:
        self.marks = addresses

    def watch(self, writes: frozenset[int], observed: bool) -> None:
        self.writes, self.observed = writes, observed

    def limited(self, instructions: int) -> int:
        return min(instructions, LONGEST_WATCHED) if self.writes or self.observed else instructions


def _taken_back(stood: list[int], now: int, runs: int) -> int | None:
    """Take the last `runs` moments before `now` off `stood`; return the first of them, if there is one."""
    stood[:] = [number for number in stood if number < now]
    taken = stood[-runs:]
    del stood[-runs:]
    return taken[0] if taken else None


LOOKS: dict[str, Callable[[Any], object]] = {
    "values": lambda machine: machine.values(),
    "lamps": lambda machine: machine.panel.lamps,
    "save": lambda machine: module("plain", "pdp8.computer.past.state").save(machine),
    "no time": lambda machine: machine.wait(0),
    "no seconds": lambda machine: machine.run(seconds=0),
    "no instructions": lambda machine: machine.run(instructions=0),
    "out of tape": lambda machine: [device.out_of_tape() for device in machine.bus],
    "copy": copy.deepcopy,
    "repr": repr,
    "no slice": lambda machine: list(islice(machine.slices(seconds=0), 1)),
}
"""Looking at a machine changes nothing."""


class InPython(Acting):
    """The machine of the package, compiled or plain."""

    def __init__(self, form: str, situation: Situation) -> None:
        super().__init__()
        self.module = partial(module, form)
        self.machine = self.module("pdp8.computer.machine").Machine(highspeed=situation.fast)
        self.machine.load(situation.words)
        self.count_delays = True
        self.count: Any = None
        self.history: Any = None
        self.stood: list[int] = []

    def run(self, ticks: int | None, instructions: int) -> str:
        watch = self.machine.watch
        watch.breakpoints, watch.writes = set(self.marks), set(self.writes)
        watch.observer = self.count
        self.machine.engine.delays = self.count_delays
        self.stood.append(self.machine.instructions)
        seconds = None if ticks is None else ticks / TICKS_PER_SECOND
        return str(self.machine.run(seconds=seconds, instructions=self.limited(instructions)).reason)

    def watch(self, writes: frozenset[int], observed: bool) -> None:
        super().watch(writes, observed)
        self.count = self.module("pdp8.computer.count").Count() if observed else None

    def deposit(self, address: int, word: int) -> None:
        self.machine.core[address] = word

    def deposit_at_pc(self, beyond: int, word: int) -> None:
        self.deposit(self.machine.pc + beyond & 0o7777, word)

    def switches(self, word: int) -> None:
        self.machine.panel.sr = word

    def mem_prot(self, up: bool) -> None:
        self.machine.panel.mem_prot = up

    def type(self, frames: bytes) -> None:
        self.machine.teletype.keyboard.press(frames)

    def _station(self, fast: bool) -> Any:
        return self.machine.highspeed if fast else self.machine.teletype

    def load_tape(self, fast: bool, frames: bytes) -> None:
        self._station(fast).reader.load(frames)

    def lever(self, fast: bool, start: bool) -> None:
        self._station(fast).reader.lever(start)

    def punch(self, fast: bool, on: bool) -> None:
        self._station(fast).punch.on = on

    def press(self, key: str) -> None:
        getattr(self.machine.panel, key)()

    def wait(self, ticks: int) -> None:
        self.machine.wait(ticks / TICKS_PER_SECOND)

    def set(self, name: str, value: int) -> None:
        setattr(self.machine, name, value)

    def delays(self, on: bool) -> None:
        self.count_delays = on

    def look(self, name: str) -> None:
        LOOKS[name](self.machine)

    def single_cycles(self, count: int) -> None:
        """Put SING STEP down and press CONT `count` times."""
        self.machine.panel.sing_step = True
        for _ in range(count):
            self.stood.append(self.machine.instructions)
            self.machine.run()
        self.machine.panel.sing_step = False

    def save_and_restore(self) -> None:
        """Go on with a copy made from what is saved."""
        state = self.module("pdp8.computer.past.state")
        text = state.save(self.machine)
        self.machine = state.restore(text)
        assert state.save(self.machine) == text
        if self.history:
            self.record()

    def record(self) -> None:
        self.history = self.module("pdp8.computer.past.history").History(self.machine)
        self.stood = []

    def back(self, runs: int) -> None:
        """Go back to the moment before one of the last runs."""
        now = self.machine.instructions
        number = _taken_back(self.stood, now, runs)
        if self.history and number is not None:
            self.module("pdp8.computer.past.rewind").instructions(self.history, now - number)
            self.machine.panel.sing_step = False

    def seen(self) -> Seen:
        machine, count = self.machine, self.count
        p, teletype = machine.processor, machine.teletype
        receiver, transmitter = teletype.receiver, teletype.transmitter
        seen = {
            **machine.panel.lamps._asdict(),
            **{"pc": p.pc, "sr": p.sr, "next": p.next, "ion delayed": p.ion_delayed},
            **{"clock": p.clock, "instructions": p.instructions},
            **{"keyboard flag": receiver.flag, "buffer": receiver.buffer},
            **{"reader run": receiver.reader_run, "read": teletype.reader.position},
            **{"keys": len(teletype.keyboard.waiting), "printer flag": transmitter.flag},
            **{"register": transmitter.register, "page": bytes(teletype.printer.frames)},
            **{"punched": teletype.punch.tape, "core": p.core.tobytes()},
            "counted": count.instructions if count else 0,
        }
        if count:
            seen |= {name: getattr(count, name) for name in ("cycles", "ticks", "interrupts")}
            seen |= {name: +getattr(count, name) for name in ("executed", "written")}
        if machine.highspeed.fitted:
            reader, punch = machine.highspeed.reader_control, machine.highspeed.punch_control
            seen |= {"reader flag": reader.flag, "reader buffer": reader.buffer, "fetching": reader.fetching}
            seen |= {"fast read": reader.reader.position, "punch flag": punch.flag}
            seen |= {"punch buffer": punch.buffer, "fast punched": punch.punch.tape}
        return seen


_FRAMES = ("page", "punched", "fast punched")


class InNode:
    """The machine of the pages; all acts are done at once, and what was seen is told act by act."""

    def __init__(self, situation: Situation) -> None:
        acts = [[name, [_plain(value) for value in values]] for name, values in situation.acts]
        words = list(situation.words.items())
        given = {"fast": situation.fast, "words": words, "watched": LONGEST_WATCHED, "acts": acts}
        self._answers = iter(_node().ask(given))
        self._seen: Seen = {}
        self._core = array("H", bytes(2 * 4096))

    def do(self, act: Act) -> str | None:
        reason, different, words = next(self._answers)
        for name in _FRAMES:
            if name in different:
                different[name] = bytes.fromhex(different[name])
        self._seen |= different
        for address, word in words:
            self._core[address] = word
        return str(reason) if reason else None

    def seen(self) -> Seen:
        return {**self._seen, "core": self._core.tobytes()}


def _plain(value: Any) -> Any:
    return list(value) if isinstance(value, bytes | frozenset) else value


class _Node:
    """One Node.js for all situations; it ends with its standard input, that is with us."""

    def __init__(self) -> None:
        command = [str(NODE), str(Path(__file__).with_name("side.mjs")), str(modules())]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ask(self, given: object) -> Any:
        asked, answered = self._process.stdin, self._process.stdout
        assert asked is not None
        assert answered is not None
        asked.write(json.dumps(given) + "\n")
        asked.flush()
        line = answered.readline()
        if not line:
            raise RuntimeError("Node.js ended; its message stands above")
        return json.loads(line)


_node = cache(_Node)


class ReferenceSide(Acting):
    """The reference."""

    def __init__(self, situation: Situation) -> None:
        super().__init__()
        self.reference = Reference(situation.fast)
        for address, word in situation.words.items():
            self.reference.core[address] = word
        self.counts: Counts | None = None
        self.recorded = False
        self.stood: list[int] = []
        self.moments: dict[int, Reference] = {}

    def _stands(self) -> None:
        """Note a moment that can be gone back to: the last with so many instructions."""
        self.stood.append(self.reference.instructions)
        if self.recorded:
            self.moments[self.reference.instructions] = self.reference.copied()

    def run(self, ticks: int | None, instructions: int) -> str:
        """Run a piece; return "limit", "stopped" or "breakpoint"."""
        self._stands()
        m = self.reference
        until = NEVER if ticks is None else m.now + ticks
        reason = m.run_to(until, m.instructions + self.limited(instructions), self.marks, self.writes)
        if reason != "limit":
            m.finish()
        return reason

    def run_endless(self, instructions: int) -> bool:
        """Run as far as a machine did before it said that it waits for ever; tell whether it does."""
        self._stands()
        m = self.reference
        reason = m.run_to(NEVER, instructions, self.marks, self.writes)
        m.finish()
        return reason == "limit" and m.endless()

    def watch(self, writes: frozenset[int], observed: bool) -> None:
        super().watch(writes, observed)
        self.counts = self.reference.count() if observed else None

    def deposit(self, address: int, word: int) -> None:
        self.reference.core[address] = word

    def deposit_at_pc(self, beyond: int, word: int) -> None:
        self.deposit(self.reference.pc + beyond & 0o7777, word)

    def switches(self, word: int) -> None:
        self.reference.sr = word

    def mem_prot(self, up: bool) -> None:
        self.reference.mem_prot = up

    def type(self, frames: bytes) -> None:
        self.reference.type(frames)

    def load_tape(self, fast: bool, frames: bytes) -> None:
        self.reference.load_tape(frames, fast)

    def lever(self, fast: bool, start: bool) -> None:
        self.reference.throw_lever(start, fast)

    def punch(self, fast: bool, on: bool) -> None:
        setattr(self.reference, "fast_punch_on" if fast else "punch_on", on)

    def press(self, key: str) -> None:
        self.reference.press(key)

    def wait(self, ticks: int) -> None:
        self.reference.wait(ticks)

    def set(self, name: str, value: int) -> None:
        setattr(self.reference, name, value)
        if name == "ion":
            self.reference.ion_ready = value
        if name == "pc":
            self.reference.next = 0

    def delays(self, on: bool) -> None:
        """There are none that could be counted down at once."""

    def look(self, name: str) -> None:
        """Nothing is changed by it."""

    def single_cycles(self, count: int) -> None:
        for _ in range(count):
            self._stands()
            self.reference.run = 0
            self.reference.settle()
            self.reference.cycle()
            self.reference.settle()
            self.reference.finish()

    def save_and_restore(self) -> None:
        """Nothing is lost here; but what was recorded is not saved."""
        if self.recorded:
            self.record()

    def record(self) -> None:
        self.recorded = True
        self.stood, self.moments = [], {}

    def back(self, runs: int) -> None:
        number = _taken_back(self.stood, self.reference.instructions, runs)
        if self.recorded and number is not None:
            self.reference = self.moments[number].copied()
            self.reference.count(self.counts)

    def seen(self) -> Seen:
        m, counts = self.reference, self.counts
        receiver, transmitter, sender = m.teletype.receiver, m.teletype.transmitter, m.teletype.sender
        seen = {
            **{name: getattr(m, name) for name in ("ma", "mb", "link", "ac", "ir", "ion", "protect", "run")},
            **{name: int(m.state == state) for state, name in enumerate(("fetch", "defer", "execute"))},
            **dict.fromkeys(("word_count", "current_address", "break_", "parity"), 0),
            **{"pc": m.pc, "sr": m.sr, "next": m.next, "ion delayed": m.ion_ready},
            **{"clock": m.now, "instructions": m.instructions},
            **{"keyboard flag": receiver.flag, "buffer": receiver.bits},
            **{"reader run": receiver.reader_run, "read": sender.position},
            **{"keys": sender.keys - sender.keys_sent, "printer flag": transmitter.flag},
            **{"register": transmitter.enable << 8 | transmitter.bits, "page": bytes(m.page)},
            **{"punched": bytes(m.punched), "core": bytes(m.core)},
            "counted": sum(counts.executed) if counts else 0,
        }
        if counts:
            seen |= {name: getattr(counts, name) for name in ("cycles", "ticks", "interrupts")}
            seen |= {name: counts.by_address(name) for name in ("executed", "written")}
        if m.fast:
            reader, punch = m.fast_reader, m.fast_punch
            seen |= {"reader flag": reader.flag, "reader buffer": reader.buffer, "fetching": reader.fetching}
            seen |= {"fast read": m.fast_tape.position, "punch flag": punch.flag}
            seen |= {"punch buffer": punch.buffer, "fast punched": bytes(m.fast_punched)}
        return seen
