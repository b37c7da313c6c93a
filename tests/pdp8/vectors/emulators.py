"""The reference as an emulator that plays vectors: what runner.py asks for."""

from typing import Any

from pdp8.vectors.devices import Devices, Event, play
from tests.reference.model import KEYS, NEVER, Reference

FRAME = 2_000_000
LAMPS = ("ma", "mb", "link", "ac", "ir", "ion", "protect", "run")
STATES = ("FETCH", "DEFER", "EXECUTE", "", "WORD COUNT", "CURR ADDR", "BREAK", "")
"""As pdp8l.h numbers them; no lamp is lit before an interrupt and after a key."""
REGISTERS = ("pc", "ac", "link", "sr", "ion", "mem_prot", "run", "protect")


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

    def hand(self, what: str, value: int) -> dict[str, Any]:
        m = self.m
        if what == "sing_step":
            m.do("sing_step", value)
        elif what in KEYS:
            m.press(what)
        elif what != "run":
            setattr(m, what, value)
        elif m.run:
            m.run_to(NEVER, m.instructions + 1_000_000)
        if not m.run:
            m.do("wait", FRAME)
        return {name: getattr(m, name) for name in LAMPS} | {"state": STATES[m.state]}

    def cycle(self) -> list[Any]:
        self.m.do("cycle")
        return [STATES[self.m.state], self.m.ma, self.m.mb]

    def get(self) -> dict[str, int]:
        return {name: getattr(self.m, name) for name in REGISTERS} | {"ticks": self.m.now}

    def play(self, initial: dict[str, Any], inputs: list[dict[str, Any]], ticks: int) -> list[dict[str, Any]]:
        return play(ReferenceDevices(bytes(initial["tape"])), inputs, ticks)


class ReferenceDevices(Devices):
    def __init__(self, tape: bytes) -> None:
        self.tape = tape
        self.m = Reference(fast=True)
        for fast in (False, True):
            self.m.do("tape", fast, tape)

    @property
    def now(self) -> int:
        return int(self.m.now)

    def see(self) -> list[tuple[int, Event]]:
        m = self.m
        read = (1, m.fast_tape.position), (3, m.teletype.sender.position)
        flagged = m.fast_reader, m.fast_punch, m.teletype.receiver, m.teletype.transmitter
        return [
            *((count, {"read": self.tape[count - 1], "device": device}) for device, count in read),
            *((one.flag, {"flag": device, "is": one.flag}) for device, one in enumerate(flagged, 1)),
            (m.page.count, {"print": m.page.frames[max(0, m.page.count - 1)]}),
            (m.fast_punched.count, {"punch": m.fast_punched.frames[max(0, m.fast_punched.count - 1)]}),
        ]

    def next_event(self) -> int:
        return self.m.do("next")

    def to(self, tick: int) -> None:
        self.m.do("wait", tick - self.m.now)
        self.m.do("settle")

    def iot(self, word: int, ac: int) -> Event:
        m = self.m
        m.pc, m.ac, m.core[0o200], m.next = 0o200, ac, word, 0
        m.do("cycle")
        m.do("settle")
        return {"ac": m.ac, "skip": m.pc - 0o201}

    def key(self, frame: int) -> None:
        self.m.do("type", bytes([frame]))

    def start(self) -> None:
        self.m.run = 0
        self.m.press("start")
