"""The Teletype and the PC8/L against the clock: IOTs at given ticks, and what the devices do at which tick.

A vector begins with the machine as it is switched on and the tape of "initial" in both readers. Its events
are in the order of their ticks. What is done:

    {"tick", "iot": word, "ac", "final": {"ac", "skip"}}    an IOT begins; it takes 85 ticks
    {"tick", "key": frame}                                  a key is pressed
    {"tick", "start": 1}                                    INITIALIZE, by the START key

What comes of it, by itself at this tick, or seen at the end of an IOT:

    {"tick", "flag": device, "is": 0 or 1}
    {"tick", "read": frame, "device"}      a start unit begins (03), the frame is in the buffer (01)
    {"tick", "print": frame}               the middle of the eighth data unit
    {"tick", "punch": frame}               by the high-speed punch
"""

import random
from collections.abc import Iterator
from typing import Any

from pdp8.computer.hardware.teletype import half_units, tick_of
from pdp8.computer.machine import Machine

Event = dict[str, Any]
Input = tuple[int, str, int, int]
"""The tick, what is done ("iot", "key", "start"), its word or frame, and AC."""

READER, PUNCH, RECEIVER, TRANSMITTER = 0o01, 0o02, 0o03, 0o04
KSF, KCC, KRS, KRB = 0o6031, 0o6032, 0o6034, 0o6036
TSF, TCF, TPC, TLS = 0o6041, 0o6042, 0o6044, 0o6046
RSF, RRB, RFC, RRB_RFC = 0o6011, 0o6012, 0o6014, 0o6016
PSF, PCF, PPC, PLS = 0o6021, 0o6022, 0o6024, 0o6026
FLAG_03, FLAG_04, FRAME = half_units(17), half_units(18), half_units(22)
FETCHED, PUNCHED = 66_667, 400_000
IOT_TICKS, IOP1, IOP2, IOP4 = 85, 29, 47, 65
_SEED = 1968
_RANDOM = 60
"""Vectors of IOTs by chance, of each device."""
TAPE = (0o301, 0o252, 0o000, 0o377, 0o125, 0o215)
PLACE = 0o200
"""Where the IOTs stand."""
AFTERWARDS = 2 * FRAME


def vectors(name: str) -> Iterator[dict[str, Any]]:
    """Yield the vectors of "teletype" or "pc8l"."""
    directed = {"teletype": _teletype, "pc8l": _pc8l}[name]
    codes = {"teletype": (0o03, 0o04), "pc8l": (0o01, 0o02)}[name]
    for title, inputs in directed():
        yield _vector(f"{name}: {title}", inputs)
    draw = random.Random(_SEED)
    for number in range(_RANDOM):
        yield _vector(f"{name}: IOTs by chance {number}", _by_chance(draw, codes))


def _teletype() -> Iterator[tuple[str, list[Input]]]:
    def reading(*ticks: int) -> list[Input]:
        return [(0, "iot", KCC, 0o7777), *((tick, "iot", KRB, 0) for tick in ticks)]

    flags = [n * FRAME + FLAG_03 for n in range(4)]
    yield "read at full speed", reading(*(flag + 1000 for flag in flags))
    yield "read as late as can be", reading(*(FRAME * (n + 1) - 40_000 for n in range(3)))
    yield "read too late: a character is lost", reading(2 * FRAME + 1_600_000)
    yield (
        "the buffer while a character comes in",
        [(0, "iot", KCC, 0), *((50 + half_units(half), "iot", KRS, 0) for half in range(20))],
    )
    yield (
        "a key while the line is busy",
        [(0, "iot", KCC, 0), (500_000, "key", 0o240, 0), *reading(5_000_000)[1:]],
    )
    yield "START while a character comes in", [(0, "iot", KCC, 0), (900_000, "start", 0, 0)]
    for late in range(-24, 8):
        yield f"KRB {late} ticks from where the line falls free", [(FRAME - IOP2 + late, "iot", KRB, 0)]
        again: list[Input] = [(FLAG_03 + 100, "iot", KCC, 0), (FRAME - IOP2 + late, "iot", KRB, 0)]
        yield f"KRB {late} ticks from where the line falls free, after a KCC", again
    for late in (-1, 0, 1):
        yield (f"KSF {late} ticks from the flag", [(FLAG_03 - IOP1 + late, "iot", KSF, 0)])
        yield (
            f"TSF {late} ticks from the flag",
            [(0, "iot", TLS, 0o301), (IOP4 + FLAG_04 - IOP1 + late, "iot", TSF, 0)],
        )
    yield "print at full speed", [(n * FRAME + n * 100, "iot", TLS, 0o300 + n) for n in range(4)]
    yield (
        "print when the flag is up",
        [
            (0, "iot", TLS, 0o301),
            (1_700_000, "iot", TPC, 0o302),
            (4_000_000, "iot", TCF, 0),
            (4_001_000, "iot", TLS, 0o7525),
        ],
    )
    for half in range(0, 22, 3):
        yield (
            f"load again {half} half units into a character",
            [(0, "iot", TLS, 0o252), (IOP4 + half_units(half) + 100, "iot", TLS, 0o111)],
        )
    yield (
        "START while a character goes out",
        [(0, "iot", TLS, 0o252), (700_000, "start", 0, 0), (700_100, "iot", TLS, 0o301)],
    )
    yield from _every_iot((0o03, 0o04), 3 * FRAME)


def _pc8l() -> Iterator[tuple[str, list[Input]]]:
    yield "read", [(0, "iot", RFC, 0), *((n * 70_000, "iot", RRB_RFC, 0) for n in range(1, 7))]
    yield (
        "fetch while a frame comes",
        [(0, "iot", RFC, 0), (30_000, "iot", RFC, 0), (80_000, "iot", RRB, 0o7000)],
    )
    for late in (-1, 0, 1):
        yield (
            f"RSF {late} ticks from the flag",
            [(0, "iot", RFC, 0), (FETCHED + IOP4 - IOP1 + late, "iot", RSF, 0)],
        )
        yield (
            f"PSF {late} ticks from the flag",
            [(0, "iot", PPC, 5), (PUNCHED + IOP4 - IOP1 + late, "iot", PSF, 0)],
        )
    yield "punch", [(n * 410_000, "iot", PLS, 0o201 + n) for n in range(4)]
    yield "punch, and or into the frame", [(0, "iot", PLS, 0o201), (100_000, "iot", PPC, 0o42)]
    yield "clear the frame that is being punched", [(0, "iot", PLS, 0o201), (100_000, "iot", PCF, 0)]
    yield (
        "START while both work",
        [(0, "iot", RFC, 0), (100, "iot", PLS, 0o201), (5_000, "start", 0, 0), (100_000, "iot", RRB, 0)],
    )
    yield from _every_iot((0o01, 0o02), 500_000)


def _every_iot(codes: tuple[int, int], far: int) -> Iterator[tuple[str, list[Input]]]:
    """Yield each IOT of the devices at rest, and again when all flags are up."""
    up: list[Input] = [(0, "iot", 0o6000 | code << 3 | 6, 0o252) for code in codes]
    up = [(tick + 100 * n, *rest) for n, (tick, *rest) in enumerate(up)]  # type: ignore[misc]
    for word in (0o6000 | code << 3 | pulses for code in codes for pulses in range(8)):
        yield f"{word:04o} at rest", [(0, "iot", word, 0o7421)]
        yield f"{word:04o} with the flags up", [*up, (far, "iot", word, 0o7421)]


def _by_chance(draw: random.Random, codes: tuple[int, int]) -> list[Input]:
    inputs: list[Input] = []
    tick = 0
    for _ in range(12):
        kind = draw.getrandbits(4)
        word = 0o6000 | codes[draw.getrandbits(1)] << 3 | draw.getrandbits(3)
        if kind == 0:
            inputs.append((tick, "start", 0, 0))
        elif kind == 1:
            inputs.append((tick, "key", draw.getrandbits(8), 0))
        else:
            inputs.append((tick, "iot", word, draw.getrandbits(12)))
        tick += IOT_TICKS + draw.getrandbits((5, 12, 17, 20, 22)[draw.getrandbits(8) % 5])
    return inputs


class _Bench:
    """A machine whose devices are driven IOT by IOT, and looked at whenever one of them has moved."""

    def __init__(self) -> None:
        self.machine = Machine(highspeed=True)
        self.machine.teletype.reader.load(bytes(TAPE))
        self.machine.highspeed.reader.load(bytes(TAPE))
        self.events: list[Event] = []
        self.seen = self._see()
        self.to(0)

    def _see(self) -> dict[str, Any]:
        """Return the flags by device, and the frames so far."""
        teletype, fast = self.machine.teletype, self.machine.highspeed
        return {
            "flag": {device.code: device.flag for device in self.machine.bus},
            "read": {READER: fast.reader.position, RECEIVER: teletype.reader.position},
            "print": len(teletype.printer.frames),
            "punch": len(fast.punch.frames),
        }

    def _look(self, tick: int) -> None:
        """Write down what has changed."""
        before, self.seen = self.seen, self._see()
        now, events = self.seen, self.events
        for device, count in now["read"].items():
            if count != before["read"][device]:
                events.append({"tick": tick, "read": TAPE[count - 1], "device": device})
        for device, flag in sorted(now["flag"].items()):
            if flag != before["flag"][device]:
                events.append({"tick": tick, "flag": device, "is": flag})
        if now["print"] != before["print"]:
            events.append({"tick": tick, "print": self.machine.teletype.printer.frames[-1]})
        if now["punch"] != before["punch"]:
            events.append({"tick": tick, "punch": self.machine.highspeed.punch.frames[-1]})

    def _next(self) -> int:
        """Return the tick at which a device moves next."""
        machine = self.machine
        teletype, fast = machine.teletype, machine.highspeed
        line = min(teletype.receiver.due, teletype.receiver.step, tick_of(teletype.transmitter.next_step()))
        return min(line, fast.reader_control.due, fast.punch_control.due)

    def to(self, tick: int) -> None:
        """Let everything happen up to and including `tick`."""
        processor = self.machine.processor
        while (due := self._next()) <= tick:
            self.machine.bus.advance(max(due, processor.clock))
            self._look(max(due, processor.clock))
        self.machine.bus.advance(tick)
        processor.clock = tick

    def do(self, tick: int, what: str, value: int, ac: int) -> None:
        """Do one input at `tick`."""
        self.to(tick)
        if what == "iot":
            self._iot(value, ac)
        elif what == "key":
            self.events.append({"tick": tick, "key": value})
            self.machine.teletype.keyboard.press(bytes([value]))
        else:
            self.events.append({"tick": tick, "start": 1})
            self.machine.bus.initialize(tick)
            self._look(tick)
        self.to(self.machine.processor.clock)

    def _iot(self, word: int, ac: int) -> None:
        machine, processor = self.machine, self.machine.processor
        tick = processor.clock
        machine.pc, machine.ac, machine.core[PLACE] = PLACE, ac, word
        processor.cycle()
        machine.bus.advance(processor.clock)
        final = {"ac": machine.ac, "skip": machine.pc - PLACE - 1}
        self.events.append({"tick": tick, "iot": word, "ac": ac, "final": final})
        self._look(processor.clock)


def _vector(name: str, inputs: list[Input]) -> dict[str, Any]:
    bench = _Bench()
    for one in inputs:
        bench.do(*one)
    ticks = inputs[-1][0] + AFTERWARDS
    bench.to(ticks)
    return {
        "name": name,
        "models": ["8/L"],
        "instructions": sum(what == "iot" for _, what, _, _ in inputs),
        "initial": {"tape": list(TAPE)},
        "final": {"flags": [device for device, flag in sorted(bench.seen["flag"].items()) if flag]},
        "ticks": ticks,
        "events": bench.events,
    }
