"""The project's machines and the reference as emulators that play vectors: what runner.py asks for."""

from typing import Any

from pdp8.computer.machine import Machine
from tests.reference.model import Reference

STATES = ("FETCH", "DEFER", "EXECUTE")
NOP = 0o7000
REGISTERS = ("pc", "ac", "link", "sr", "ion", "mem_prot")
Result = dict[str, Any]


class ProcessorEmulator:
    """The processor, cycle by cycle."""

    def __init__(self) -> None:
        self.machine = Machine(highspeed=True)
        self.touched: set[int] = set()

    def prepare(self, initial: dict[str, Any]) -> None:
        """Set registers, core and flags."""
        machine, p = self.machine, self.machine.processor
        machine.power_up()
        for name in ("pc", "ac", "link", "sr", "ion"):
            setattr(machine, name, initial[name])
        p.mem_prot, p.protect, p.run = initial["mem_prot"], 0, 1
        ram = dict(initial["ram"])
        for address in self.touched - set(ram):
            machine.core[address] = 0
        for address, word in ram.items():
            machine.core[address] = word
        self.touched = set(ram)
        for device in machine.bus:
            device.flag = int(device.code in initial.get("flags", ()))

    def final(self, initial: dict[str, Any]) -> dict[str, Any]:
        machine, p = self.machine, self.machine.processor
        final = {name: getattr(machine, name) for name in ("pc", "ac", "link", "sr", "ion")}
        ram = [[address, machine.core[address]] for address, _ in initial["ram"]]
        return final | {"mem_prot": p.mem_prot, "run": p.run, "protect": p.protect, "ram": ram}

    def step(self, initial: dict[str, Any], cycles: int) -> Result | None:
        self.prepare(initial)
        p = self.machine.processor
        clock, done = p.clock, []
        for _ in range(cycles):
            p.cycle()
            done.append([STATES[p.state], p.ma, p.mb])
        return {"final": self.final(initial), "ticks": p.clock - clock, "cycles": done}

    def play(self, initial: dict[str, Any], inputs: list[dict[str, Any]], ticks: int) -> None:
        """Leave the devices to the reference."""


class EngineEmulator(ProcessorEmulator):
    """The engine, by whole instructions. It leaves the last one of a run to the processor, so a NOP follows
    the vector's; a vector where none fits in, or where the machine stops, is passed over.
    """

    def step(self, initial: dict[str, Any], cycles: int) -> Result | None:
        probe = super().step(initial, cycles)
        assert probe is not None
        final = probe["final"]
        if "flags" in initial or not final["run"] or final["pc"] in self.touched:
            return None
        self.prepare(initial)
        machine, p = self.machine, self.machine.processor
        machine.core[final["pc"]] = NOP
        self.touched.add(final["pc"])
        clock = p.clock
        machine.run(instructions=2)
        engine = self.final(initial)
        return {"final": engine | {"pc": engine["pc"] - 1 & 0o7777}, "ticks": p.clock - clock - 32}


class ReferenceEmulator:
    """The reference: instructions by cycles, and the devices."""

    def step(self, initial: dict[str, Any], cycles: int) -> Result:
        m = Reference(fast=True)
        for name in REGISTERS:
            setattr(m, name, initial[name])
        m.ion_ready, m.run = m.ion, 1
        for device in initial.get("flags", ()):
            (m.fast_reader, m.fast_punch, m.receiver, m.transmitter)[device - 1].flag = 1
        for address, word in initial["ram"]:
            m.core[address] = word
        done = []
        for _ in range(cycles):
            m.cycle()
            done.append([STATES[m.state], m.ma, m.mb])
        final = {name: getattr(m, name) for name in (*REGISTERS, "run", "protect")}
        ram = [[address, m.core[address]] for address, _ in initial["ram"]]
        return {"final": final | {"ram": ram}, "ticks": m.now, "cycles": done}

    def play(self, initial: dict[str, Any], inputs: list[dict[str, Any]], ticks: int) -> list[dict[str, Any]]:
        return _Bench(bytes(initial["tape"])).play(inputs, ticks)


class _Bench:
    """The devices of the reference, driven IOT by IOT and looked at whenever one has moved."""

    def __init__(self, tape: bytes) -> None:
        self.tape = tape
        self.m = Reference(fast=True)
        self.events: list[dict[str, Any]] = []
        self.seen = self._see()
        for fast in (False, True):
            self.m.load_tape(tape, fast)

    def play(self, inputs: list[dict[str, Any]], ticks: int) -> list[dict[str, Any]]:
        self._to(0)
        for one in inputs:
            self._to(one["tick"])
            self._do(one)
            self._to(self.m.now)
        self._to(ticks)
        return self.events

    def _see(self) -> dict[str, Any]:
        m = self.m
        flags = (m.fast_reader.flag, m.fast_punch.flag, m.receiver.flag, m.transmitter.flag)
        counts = m.fast_tape.position, m.tape.position, m.page.count, m.fast_punched.count
        return {"flags": flags, "counts": counts}

    def _to(self, tick: int) -> None:
        m = self.m
        while (due := min(m.receiver.at, m.transmitter.at, m.fast_reader.at, m.fast_punch.at)) <= tick:
            m.wait(max(due - m.now, 0))
            self._look()
        m.wait(tick - m.now)

    def _look(self) -> None:
        m, before = self.m, self.seen
        self.seen = self._see()
        fast, slow, page, punched = self.seen["counts"]
        now = {"tick": m.now}
        if fast != before["counts"][0]:
            self.events.append(now | {"read": self.tape[fast - 1], "device": 1})
        if slow != before["counts"][1]:
            self.events.append(now | {"read": self.tape[slow - 1], "device": 3})
        for device, (flag, old) in enumerate(zip(self.seen["flags"], before["flags"], strict=True), 1):
            if flag != old:
                self.events.append(now | {"flag": device, "is": flag})
        if page != before["counts"][2]:
            self.events.append(now | {"print": m.page.frames[page - 1]})
        if punched != before["counts"][3]:
            self.events.append(now | {"punch": m.fast_punched.frames[punched - 1]})

    def _do(self, one: dict[str, Any]) -> None:
        m = self.m
        if "key" in one:
            self.events.append({"tick": m.now, "key": one["key"]})
            m.type(bytes([one["key"]]))
        elif "start" in one:
            self.events.append({"tick": m.now, "start": 1})
            m.run = 0
            m.press("start")
            self._look()
        else:
            self._iot(one["iot"], one["ac"])

    def _iot(self, word: int, ac: int) -> None:
        m = self.m
        m.pc, m.ac, m.core[0o200], m.next = 0o200, ac, word, 0
        tick = m.now
        m.cycle()
        m.wait(0)
        final = {"ac": m.ac, "skip": m.pc - 0o201}
        self.events.append({"tick": tick, "iot": word, "ac": ac, "final": final})
        self._look()
