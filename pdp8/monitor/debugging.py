"""Commands that look at the machine and change it: words, registers, switches, keys, breakpoints, steps."""

import json
from collections.abc import Sequence
from itertools import cycle as cycle_of

from pal.isa import DEFER, EXECUTE, STATES
from pdp8.computer.count import Count
from pdp8.computer.hardware.extension import FIELD, MEMORY
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.computer.use import counted
from pdp8.computer.use.operator import DEAD
from pdp8.computer.use.trace import Trace
from pdp8.computer.watch import Observer, Watch
from pdp8.monitor.arguments import MonitorError, octal, seconds, some
from pdp8.monitor.prompt import Monitor, Observers

REGISTERS = {
    "ac": 0o7777,
    "link": 1,
    "pc": 0o77777,
    "ma": 0o77777,
    "mb": 0o7777,
    "ir": 7,
    "sr": 0o7777,
    "ion": 1,
}
"""Each register with its greatest value, that of an address in 32K of core."""
EXTENSION = {
    "if": ["inst_field"],
    "df": ["data_field"],
    "ib": ["inst_buffer"],
    "sf": ["saved_inst", "saved_data"],
}
"""Those of the memory extension, each with its digits."""
SWITCHES = ("mem_prot", "sing_step")
FIELDS = ("inst_field", "data_field")
"""The panel's switches for fields."""
NAMES = " ".join((*REGISTERS, *SWITCHES, *FIELDS, "hands", "cpu"))
KEYS = ("load_add", "exam", "dep", "start", "cont", "stop")
_POSITIONS = {"1": True, "on": True, "0": False, "off": False}
_NO_EAE = ("mq", "sc", "gtf")
"""Registers of SIMH's PDP-8/E."""


def examine(monitor: Monitor, place: str, *more: str) -> None:
    """Say words of core, each with its line of the listing, or a register."""
    for each in " ".join((place, *more)).replace(",", " ").split() or [place]:
        _examine(monitor, each)


def _examine(monitor: Monitor, place: str) -> None:
    core = monitor.machine.core
    if is_register(monitor, place):
        monitor.say(f"{place.upper()} {value(monitor.machine, place):04o}")
    elif place.lower() == "state":
        registers(monitor)
    elif place.lower() == "all":
        for address in range(monitor.machine.memory):
            if core[address]:
                monitor.say(monitor.listing.line(address, core[address], monitor.machine.processor))
        monitor.say("all other words are 0000")
    else:
        for address in _words(monitor, place):
            monitor.say(monitor.listing.line(address, core[address], monitor.machine.processor))


def deposit(monitor: Monitor, place: str, word: str, *more: str) -> None:
    """Put words into core from A on, or one word into all of A:B."""
    if is_register(monitor, place):
        set_(monitor, place, *some((word, *more), "a word", 1, 1))
        return
    addresses = _words(monitor, place)
    words = [monitor.word(each) for each in (word, *more)]
    if len(addresses) > 1 and more:
        raise MonitorError(
            f"{place}: a range is filled with one word; give several with the first address alone"
        )
    if len(addresses) == 1:
        addresses = range(addresses.start, addresses.start + len(words))
    if addresses.stop > monitor.machine.memory:
        raise MonitorError(f"{place}: {len(words)} words go beyond {monitor.machine.memory - 1:o}")
    for address, each in zip(addresses, cycle_of(words), strict=False):
        monitor.machine.core[address] = each


def _words(monitor: Monitor, place: str) -> range:
    """Return the addresses of a place. Raises MonitorError, also for a register that this machine lacks."""
    if place.lower() in _NO_EAE:
        raise MonitorError(f"{place}: this machine has no EAE, and no such register")
    return monitor.range(place)


def set_(monitor: Monitor, name: str, text: str) -> None:
    """Set a register, a switch (0 or 1), the seconds that a key takes (hands), the core (cpu 4k, 8k, 32k)."""
    name = register(name)
    most = (monitor.machine.memory >> 12) - 1
    if name in REGISTERS:
        most = greatest(monitor.machine, name)
        setattr(monitor.machine, name, monitor.word(text, most))
    elif name in EXTENSION:
        value(monitor.machine, name)
        digits = octal(text, int(f"{most:o}" * len(EXTENSION[name]), 8))
        if digits & 7 > most:
            raise MonitorError(f"{text}: fields are 0 to {most}")
        for digit, part in enumerate(reversed(EXTENSION[name])):
            setattr(monitor.machine.processor.extension, part, (digits >> 3 * digit & 7) << 12)
    elif name in SWITCHES:
        if text.lower() not in _POSITIONS:
            raise MonitorError(f"{text}: {name} is 0 or 1, off or on")
        setattr(monitor.machine.panel, name, _POSITIONS[text.lower()])
    elif name in FIELDS:
        setattr(monitor.machine.panel, name, octal(text, most))
    elif name == "hands":
        monitor.operator.pace = monitor.operator.pace._replace(pressing=seconds(text))
    else:
        raise MonitorError(f"{name}: no register or switch; there are {NAMES}")


def set_core(monitor: Monitor, size: str) -> None:
    """Let the machine have other core; what is in core and in the devices stays."""
    memory = MEMORY[size]
    if memory == monitor.machine.memory:
        return
    if any(monitor.machine.core[min(memory, monitor.machine.memory) :]):
        raise MonitorError(f"{size}: there are words beyond {memory - 1:o}")
    if memory == MEMORY["32k"]:
        monitor.say("no PDP-8/L had 32K, nor three bits of field")
    extension = monitor.machine.processor.extension
    for part, kind in extension.fields.items():
        if kind == "70000":
            setattr(extension, part, getattr(extension, part) & memory - 1)
    saved = json.loads(state.save(monitor.machine))
    saved["memory"] = memory
    seen = monitor.expected, monitor.matched, monitor.shown
    monitor.turn_to(json.dumps(saved))
    monitor.expected, monitor.matched, monitor.shown = seen


def greatest(machine: Machine, name: str) -> int:
    """Return the greatest value of a register in this machine's core."""
    return min(REGISTERS.get(name, 7), machine.memory - 1)


def value(machine: Machine, name: str) -> int:
    """Return what is in a register, or how a switch is. Raises MonitorError for one that is not there."""
    name = register(name)
    if name in REGISTERS:
        return int(getattr(machine, name))
    if name in (*SWITCHES, *FIELDS):
        return int(getattr(machine.panel, name))
    if machine.memory == FIELD:
        raise MonitorError(f"{name}: this machine has 4K of core, and no such register; set cpu 8k fits it")
    digits = [getattr(machine.processor.extension, part) >> 12 for part in EXTENSION[name]]
    return int("".join(map(str, digits)), 8)


def register(name: str) -> str:
    """Return a register's whole name."""
    return {"l": "link"}.get(name.lower(), name.lower())


def is_register(monitor: Monitor, name: str) -> bool:
    """Whether a name is a register's or a switch's, and no symbol's of the program."""
    known = register(name) in (*REGISTERS, *EXTENSION, *SWITCHES, *FIELDS)
    return known and name.upper() not in monitor.listing.symbols


def registers(monitor: Monitor) -> None:
    """Say the lamps, the PC and the time."""
    m, lamps = monitor.machine, monitor.machine.panel.lamps
    lit = [name for name in ("ion", "protect", "run") if getattr(lamps, name)]
    fields = ""
    if m.memory > FIELD:
        fields = "".join(f" {name.upper()} {value(m, name):0{len(EXTENSION[name])}o}" for name in EXTENSION)
        fields = f" {fields} EMA {m.panel.ema}"
    monitor.say(
        f"PC {m.pc:04o}  L {lamps.link}  AC {lamps.ac:04o}  MA {lamps.ma:04o}  MB {lamps.mb:04o}  "
        f"IR {lamps.ir} {STATES[m.processor.state]:7}  SR {m.sr:04o}  {m.elapsed * 1000:.5f} ms"
        + fields
        + "".join(f"  {name.upper()}" for name in lit)
    )


def key(monitor: Monitor, first: str, *more: str) -> None:
    """Press keys of the panel."""
    names = [name.lower() for name in (first, *more)]
    for name in names:
        if name not in KEYS:
            raise MonitorError(f"{name}: the keys are {' '.join(KEYS)}")
    for name in names:
        if name != "stop" and monitor.machine.panel.lamps.run:
            monitor.say(f"{name}: {DEAD}")
        monitor.operator.press(name)


def step(monitor: Monitor, count: str = "1") -> None:
    """Run instructions, and say each."""
    _traced(monitor, count, cycles=False)


def cycle(monitor: Monitor, count: str = "1") -> None:
    """Run memory cycles, and say each."""
    _traced(monitor, count, cycles=True)


class _Said(Trace):
    """A trace that the monitor says, by what is loaded now; `pdp8 run --trace` writes another."""

    def __init__(self, monitor: Monitor, cycles: bool) -> None:
        super().__init__(monitor.say, monitor.listing, cycles)
        self._monitor = monitor

    def cycle(self, processor: Processor, interrupt: bool) -> None:
        self._listing = self._monitor.listing
        super().cycle(processor, interrupt)


class _Counted(Count):
    """What the monitor counts; `pdp8 run --count` counts another."""


def _observe(monitor: Monitor, kind: type[Observer], observer: Observer | None) -> None:
    """Let `observer` see what is done from now on, or none of this kind; observers of another stay."""
    each = [other for other in monitor.observers() if not isinstance(other, kind)]
    each += [observer] if observer else []
    monitor.machine.watch.observer = Observers(each) if each else None


def _traced(monitor: Monitor, count: str, cycles: bool) -> None:
    processor = monitor.machine.processor
    machine, watch = monitor.machine, monitor.machine.watch
    machine.watch = Watch()
    machine.watch.observer = watch.observer
    _observe(monitor, _Said, _Said(monitor, cycles))
    try:
        for _ in range(octal(count)):
            machine.run(cycles=1)
            while not cycles and processor.run and processor.next in (DEFER, EXECUTE):
                machine.run(cycles=1)
            if monitor.stopping or not (processor.run or processor.sing_step):
                return
    finally:
        machine.watch = watch


def trace(monitor: Monitor, what: str) -> None:
    """Say every instruction, or cycle, of the runs to come, or no longer."""
    if what not in ("on", "cycles", "off"):
        raise MonitorError(f"{what}: on, cycles or off")
    _observe(monitor, _Said, None if what == "off" else _Said(monitor, what == "cycles"))


def count(monitor: Monitor, what: str = "") -> None:
    """Count, from now on, what is done; say it, or the listing with its counts; or count no longer."""
    counts = [each for each in monitor.observers() if isinstance(each, Count)]
    if what in ("on", "off"):
        _observe(monitor, _Counted, _Counted() if what == "on" else None)
    elif what not in ("", "listing"):
        raise MonitorError(f"{what}: on, off or listing, or nothing")
    elif not counts:
        raise MonitorError("nothing is counted: count on begins")
    else:
        report = counted.annotated if what else counted.table
        for line in report(counts[-1], monitor.listing):
            monitor.say(line)


def break_(monitor: Monitor, *places: str) -> None:
    """Stop before instructions; without addresses, say where."""
    _points(monitor, monitor.machine.watch.breakpoints, places)


def watch(monitor: Monitor, *places: str) -> None:
    """Stop after words are written; without addresses, say which."""
    _points(monitor, monitor.machine.watch.writes, places)


def _points(monitor: Monitor, points: set[int], places: Sequence[str]) -> None:
    points |= {address for place in places for address in monitor.range(place)}
    if not places:
        monitor.say(" ".join(f"{address:04o}" for address in sorted(points)) or "none")


def forget(monitor: Monitor, *places: str) -> None:
    """Forget breakpoints and watched words at addresses, or all."""
    points = monitor.machine.watch
    if [each.lower() for each in places] == ["all"] and "ALL" not in monitor.listing.symbols:
        places = ()
    given = {address for place in places for address in monitor.range(place)}
    gone = given if places else points.breakpoints | points.writes
    points.breakpoints -= gone
    points.writes -= gone
