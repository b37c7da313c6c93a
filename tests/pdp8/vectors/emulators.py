"""The project's machines and the reference as emulators that play vectors: what runner.py asks for."""

from typing import Any

from pdp8.computer.machine import Machine
from tests.reference.model import Reference

STATES = ("FETCH", "DEFER", "EXECUTE")
NOP = 0o7000
REGISTERS = ("pc", "ac", "link", "sr", "ion", "mem_prot", "run", "protect")


class _MachineEmulator:
    """A machine that is set and looked at."""

    def __init__(self) -> None:
        self.machine = Machine(highspeed=True)
        self.processor = self.machine.processor
        self.touched: set[int] = set()
        self.start = 0

    def set(self, registers: dict[str, int]) -> None:
        self.machine.power_up()
        for name in ("pc", "ac", "link", "sr", "ion"):
            setattr(self.machine, name, registers[name])
        p = self.processor
        p.mem_prot, p.protect, p.run = registers["mem_prot"], 0, 1
        for address in self.touched:
            p.core[address] = 0
        self.touched.clear()
        for device in self.machine.bus:
            device.flag = 0
        self.start = p.clock

    def deposit(self, address: int, word: int) -> None:
        self.machine.core[address] = word
        self.touched.add(address)

    def examine(self, address: int) -> int:
        return self.machine.core[address]

    def get(self) -> dict[str, int]:
        p = self.processor
        registers = {name: getattr(self.machine, name) for name in ("pc", "ac", "link", "sr", "ion")}
        switches = {"mem_prot": p.mem_prot, "run": p.run, "protect": p.protect}
        return registers | switches | {"ticks": p.clock - self.start}


class ProcessorEmulator(_MachineEmulator):
    """The processor, cycle by cycle."""

    def flag(self, device: int) -> bool:
        next(one for one in self.machine.bus if one.code == device).flag = 1
        return True

    def cycle(self) -> list[Any]:
        p = self.processor
        p.cycle()
        return [STATES[p.state], p.ma, p.mb]


class EngineEmulator(_MachineEmulator):
    """The engine, by whole instructions. It leaves the last one of a run to the processor, so a NOP is put
    behind the vector's; where none fits in, or where the machine stops, the processor alone plays.
    """

    nops = 0

    def run(self, instructions: int) -> None:
        before, core = super().get(), {address: self.examine(address) for address in self.touched}
        self._run(instructions)
        after = self.machine.pc
        self.nops = int(self.processor.run and after not in core)
        if self.nops:
            self.set(before)
            for address, word in {**core, after: NOP}.items():
                self.deposit(address, word)
            self._run(instructions + 1)

    def _run(self, instructions: int) -> None:
        self.machine.run(instructions=instructions)

    def get(self) -> dict[str, int]:
        registers = super().get()
        registers["pc"] = registers["pc"] - self.nops & 0o7777
        registers["ticks"] -= 32 * self.nops
        return registers


class ReferenceEmulator:
    """The reference: instructions by cycles, and the devices."""

    def set(self, registers: dict[str, int]) -> None:
        self.m = Reference(fast=True)
        for name, value in registers.items():
            setattr(self.m, name, value)
        self.m.ion_ready, self.m.run = self.m.ion, 1

    def deposit(self, address: int, word: int) -> None:
        self.m.core[address] = word

    def examine(self, address: int) -> int:
        return int(self.m.core[address])

    def flag(self, device: int) -> bool:
        m = self.m
        (m.fast_reader, m.fast_punch, m.teletype.receiver, m.teletype.transmitter)[device - 1].flag = 1
        return True

    def cycle(self) -> list[Any]:
        self.m.cycle()
        return [STATES[self.m.state], self.m.ma, self.m.mb]

    def get(self) -> dict[str, int]:
        return {name: getattr(self.m, name) for name in REGISTERS} | {"ticks": self.m.now}

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
        receiver, transmitter = m.teletype.receiver, m.teletype.transmitter
        flags = (m.fast_reader.flag, m.fast_punch.flag, receiver.flag, transmitter.flag)
        counts = m.fast_tape.position, m.teletype.sender.position, m.page.count, m.fast_punched.count
        return {"flags": flags, "counts": counts}

    def _to(self, tick: int) -> None:
        m = self.m
        while (due := m.next_event()) <= tick:
            m.wait(max(due - m.now, 0))
            m.settle()
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
        m.settle()
        final = {"ac": m.ac, "skip": m.pc - 0o201}
        self.events.append({"tick": tick, "iot": word, "ac": ac, "final": final})
        self._look()
