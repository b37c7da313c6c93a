"""The machine and the reference, each with the same methods: one for every act of a situation."""

from typing import Any

from tests.pdp8.computer.speed.forms import machine_module, state_module
from tests.reference.model import NEVER, Reference

TICKS_PER_SECOND = 20_000_000
LONGEST_WATCHED = 2_000
"""Instructions of a piece that is watched: the machine is slow then."""


class Watching:
    """Which instructions are watched."""

    def __init__(self) -> None:
        self.marks: frozenset[int] = frozenset()
        self.writes: frozenset[int] = frozenset()
        self.observed = False

    def breakpoints(self, addresses: frozenset[int]) -> None:
        self.marks = addresses

    def watch(self, writes: frozenset[int], observed: bool) -> None:
        self.writes, self.observed = writes, observed

    def limited(self, instructions: int) -> int:
        return min(instructions, LONGEST_WATCHED) if self.writes or self.observed else instructions


class _Observer:
    def cycle(self, processor: object) -> None:
        """See a cycle."""

    def waited(self, processor: object, instructions: int, ticks: int) -> None:
        """Hear of a wait."""


class MachineSide(Watching):
    """The machine of the package, in one of its forms."""

    def __init__(self, form: str, fast: bool, words: dict[int, int]) -> None:
        super().__init__()
        self.state: Any = state_module(form)
        self.machine: Any = machine_module(form).Machine(highspeed=fast)
        self.machine.load(words)
        self.count_delays = True

    def run(self, ticks: int | None, instructions: int) -> str:
        """Run a piece; return why it ended, in the machine's words."""
        watch = self.machine.watch
        watch.breakpoints, watch.writes = set(self.marks), set(self.writes)
        watch.observer = _Observer() if self.observed else None
        self.machine.engine.delays = self.count_delays
        seconds = None if ticks is None else ticks / TICKS_PER_SECOND
        return str(self.machine.run(seconds=seconds, instructions=self.limited(instructions)).reason)

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

    def single_cycles(self, count: int) -> None:
        """Put SING STEP down and press CONT `count` times."""
        self.machine.panel.sing_step = True
        for _ in range(count):
            self.machine.run()
        self.machine.panel.sing_step = False

    def save_and_restore(self) -> None:
        """Go on with a copy made from what is saved."""
        self.machine = self.state.restore(self.state.save(self.machine))

    def seen(self) -> dict[str, Any]:
        """Return everything that can be seen of the machine."""
        machine = self.machine
        p, teletype = machine.processor, machine.teletype
        receiver, transmitter = teletype.receiver, teletype.transmitter
        seen = {
            **{name: getattr(p, name) for name in ("pc", "ma", "mb", "ir", "sr", "state", "next", "run")},
            **{"link": p.lac >> 12, "ac": p.lac & 0o7777, "ion": p.ion, "ion delayed": p.ion_delayed},
            **{"protect": p.protect, "clock": p.clock, "instructions": p.instructions},
            **{"keyboard flag": receiver.flag, "buffer": receiver.buffer},
            **{"reader run": receiver.reader_run, "read": teletype.reader.position},
            **{"keys": len(teletype.keyboard.waiting), "printer flag": transmitter.flag},
            **{"register": transmitter.register, "page": bytes(teletype.printer.frames)},
            **{"punched": teletype.punch.tape, "core": p.core.tobytes()},
        }
        if machine.highspeed.fitted:
            reader, punch = machine.highspeed.reader_control, machine.highspeed.punch_control
            seen |= {"reader flag": reader.flag, "reader buffer": reader.buffer, "fetching": reader.fetching}
            seen |= {"fast read": reader.reader.position, "punch flag": punch.flag}
            seen |= {"punch buffer": punch.buffer, "fast punched": punch.punch.tape}
        return seen


class ReferenceSide(Watching):
    """The reference."""

    def __init__(self, fast: bool, words: dict[int, int]) -> None:
        super().__init__()
        self.reference = Reference(fast)
        for address, word in words.items():
            self.reference.core[address] = word

    def run(self, ticks: int | None, instructions: int) -> str:
        """Run a piece; return "limit", "stopped" or "breakpoint"."""
        m = self.reference
        until = NEVER if ticks is None else m.now + ticks
        reason = m.run_to(until, m.instructions + self.limited(instructions), self.marks, self.writes)
        if reason != "limit":
            m.finish()
        return reason

    def run_endless(self, instructions: int) -> bool:
        """Run as far as the machine did before it said that it waits for ever; tell whether it does."""
        m = self.reference
        reason = m.run_to(NEVER, instructions, self.marks, self.writes)
        m.finish()
        return reason == "limit" and m.endless()

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

    def single_cycles(self, count: int) -> None:
        for _ in range(count):
            self.reference.run = 0
            self.reference.settle()
            self.reference.cycle()
            self.reference.settle()
            self.reference.finish()

    def save_and_restore(self) -> None:
        """Nothing is lost here."""

    def seen(self) -> dict[str, Any]:
        """Return everything that can be seen of the reference."""
        m = self.reference
        receiver, transmitter, sender = m.teletype.receiver, m.teletype.transmitter, m.teletype.sender
        seen = {
            **{name: getattr(m, name) for name in ("pc", "ma", "mb", "ir", "sr", "state", "next", "run")},
            **{"link": m.link, "ac": m.ac, "ion": m.ion, "ion delayed": m.ion_ready},
            **{"protect": m.protect, "clock": m.now, "instructions": m.instructions},
            **{"keyboard flag": receiver.flag, "buffer": receiver.bits},
            **{"reader run": receiver.reader_run, "read": sender.position},
            **{"keys": sender.keys - sender.keys_sent, "printer flag": transmitter.flag},
            **{"register": transmitter.enable << 8 | transmitter.bits, "page": bytes(m.page)},
            **{"punched": bytes(m.punched), "core": bytes(m.core)},
        }
        if m.fast:
            reader, punch = m.fast_reader, m.fast_punch
            seen |= {"reader flag": reader.flag, "reader buffer": reader.buffer, "fetching": reader.fetching}
            seen |= {"fast read": m.fast_tape.position, "punch flag": punch.flag}
            seen |= {"punch buffer": punch.buffer, "fast punched": bytes(m.fast_punched)}
        return seen
