"""The Teletype and the PC8/L against the clock: IOTs at given ticks, and what the devices do at which tick.

README.md says what an event is, and how a vector begins.
"""

import random
from collections.abc import Iterator, Sequence
from typing import Any

from pdp8.computer.hardware.highspeed import HighSpeed
from pdp8.computer.hardware.teletype import Teletype, half_units, tick_of
from pdp8.computer.machine import Machine

Event = dict[str, Any]

READER, RECEIVER = 0o01, 0o03
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
    codes, directed = {"teletype": ((0o03, 0o04), _teletype), "pc8l": ((0o01, 0o02), _pc8l)}[name]
    for title, inputs in directed():
        yield _vector(f"{name}: {title}", inputs)
    draw = random.Random(_SEED)
    for number in range(_RANDOM):
        yield _vector(f"{name}: IOTs by chance {number}", _by_chance(draw, codes))


def _iot(tick: int, word: int, ac: int = 0) -> Event:
    return {"tick": tick, "iot": word, "ac": ac}


def _teletype() -> Iterator[tuple[str, list[Event]]]:
    def reading(*ticks: int) -> list[Event]:
        return [_iot(0, KCC, 0o7777), *(_iot(tick, KRB) for tick in ticks)]

    yield "read at full speed", reading(*(n * FRAME + FLAG_03 + 1000 for n in range(4)))
    yield "read as late as can be", reading(*(FRAME * (n + 1) - 40_000 for n in range(3)))
    yield "read too late: a character is lost", reading(2 * FRAME + 1_600_000)
    looks = [_iot(50 + half_units(half), KRS) for half in range(20)]
    yield "the buffer while a character comes in", [_iot(0, KCC), *looks]
    key = {"tick": 500_000, "key": 0o240}
    yield "a key while the line is busy", [_iot(0, KCC), key, _iot(5_000_000, KRB)]
    yield "START while a character comes in", [_iot(0, KCC), {"tick": 900_000, "start": 1}]
    for late in range(-24, 8):
        read = _iot(FRAME - IOP2 + late, KRB)
        yield f"KRB {late} ticks from where the line falls free", [read]
        again = [_iot(FLAG_03 + 100, KCC), read]
        yield f"KRB {late} ticks from where the line falls free, after a KCC", again
    for late in (-1, 0, 1):
        yield f"KSF {late} ticks from the flag", [_iot(FLAG_03 - IOP1 + late, KSF)]
        skip = _iot(IOP4 + FLAG_04 - IOP1 + late, TSF)
        yield f"TSF {late} ticks from the flag", [_iot(0, TLS, 0o301), skip]
    yield "print at full speed", [_iot(n * FRAME + n * 100, TLS, 0o300 + n) for n in range(4)]
    late_prints = [_iot(1_700_000, TPC, 0o302), _iot(4_000_000, TCF), _iot(4_001_000, TLS, 0o7525)]
    yield "print when the flag is up", [_iot(0, TLS, 0o301), *late_prints]
    for half in range(0, 22, 3):
        second = _iot(IOP4 + half_units(half) + 100, TLS, 0o111)
        yield f"load again {half} half units into a character", [_iot(0, TLS, 0o252), second]
    start = [{"tick": 700_000, "start": 1}, _iot(700_100, TLS, 0o301)]
    yield "START while a character goes out", [_iot(0, TLS, 0o252), *start]
    yield from _every_iot((0o03, 0o04), 3 * FRAME)


def _pc8l() -> Iterator[tuple[str, list[Event]]]:
    yield "read", [_iot(0, RFC), *(_iot(n * 70_000, RRB_RFC) for n in range(1, 7))]
    yield "fetch while a frame comes", [_iot(0, RFC), _iot(30_000, RFC), _iot(80_000, RRB, 0o7000)]
    for late in (-1, 0, 1):
        skip = _iot(FETCHED + IOP4 - IOP1 + late, RSF)
        yield f"RSF {late} ticks from the flag", [_iot(0, RFC), skip]
        skip = _iot(PUNCHED + IOP4 - IOP1 + late, PSF)
        yield f"PSF {late} ticks from the flag", [_iot(0, PPC, 5), skip]
    yield "punch", [_iot(n * 410_000, PLS, 0o201 + n) for n in range(4)]
    yield "punch, and or into the frame", [_iot(0, PLS, 0o201), _iot(100_000, PPC, 0o42)]
    yield "clear the frame that is being punched", [_iot(0, PLS, 0o201), _iot(100_000, PCF)]
    start = [{"tick": 5_000, "start": 1}, _iot(100_000, RRB)]
    yield "START while both work", [_iot(0, RFC), _iot(100, PLS, 0o201), *start]
    yield from _every_iot((0o01, 0o02), 500_000)


def _every_iot(codes: tuple[int, int], far: int) -> Iterator[tuple[str, list[Event]]]:
    """Yield each IOT of the devices at rest, and again when all flags are up."""
    up = [_iot(100 * n, 0o6006 | code << 3, 0o252) for n, code in enumerate(codes)]
    for word in (0o6000 | code << 3 | pulses for code in codes for pulses in range(8)):
        yield f"{word:04o} at rest", [_iot(0, word, 0o7421)]
        yield f"{word:04o} with the flags up", [*up, _iot(far, word, 0o7421)]


def _by_chance(draw: random.Random, codes: tuple[int, int]) -> list[Event]:
    inputs = []
    tick = 0
    for _ in range(12):
        kind = draw.getrandbits(4)
        word = 0o6000 | codes[draw.getrandbits(1)] << 3 | draw.getrandbits(3)
        if kind == 0:
            inputs.append({"tick": tick, "start": 1})
        elif kind == 1:
            inputs.append({"tick": tick, "key": draw.getrandbits(8)})
        else:
            inputs.append(_iot(tick, word, draw.getrandbits(12)))
        tick += IOT_TICKS + draw.getrandbits((5, 12, 17, 20, 22)[draw.getrandbits(8) % 5])
    return inputs


class Devices:
    """The Teletype and PC8/L of a new machine that executes only single IOTs."""

    def __init__(self) -> None:
        self.machine = Machine([Teletype(), HighSpeed()])
        for reader in (self.machine.teletype.reader, self.machine.highspeed.reader):
            reader.load(bytes(TAPE))

    @property
    def now(self) -> int:
        """The tick."""
        return self.machine.processor.clock

    def see(self) -> list[tuple[int, Event]]:
        """Return each flag and tape position, with the event that changed it."""
        teletype, fast = self.machine.teletype, self.machine.highspeed
        read = ((READER, fast.reader.position), (RECEIVER, teletype.reader.position))
        told = (("print", teletype.printer.frames), ("punch", fast.punch.frames))
        return [
            *((count, {"read": TAPE[count - 1], "device": device}) for device, count in read),
            *((flag, {"flag": device, "is": flag}) for device, flag in self.flags()),
            *((len(frames), {what: frames[-1] if frames else 0}) for what, frames in told),
        ]

    def flags(self) -> list[tuple[int, int]]:
        """Return the code and the flag of each device."""
        return sorted((device.code, device.flag) for device in self.machine.bus)

    def next_event(self) -> int:
        """Return the tick at which a device moves next."""
        teletype, fast = self.machine.teletype, self.machine.highspeed
        line = min(teletype.receiver.due, teletype.receiver.step, tick_of(teletype.transmitter.next_step()))
        return min(line, fast.reader_control.due, fast.punch_control.due)

    def to(self, tick: int) -> None:
        """Let the devices run up to and including `tick`."""
        self.machine.bus.advance(tick)
        self.machine.processor.clock = tick

    def iot(self, word: int, ac: int) -> Event:
        """Do an IOT; return AC after it, and whether it skips."""
        machine, processor = self.machine, self.machine.processor
        machine.pc, machine.ac, machine.core[PLACE] = PLACE, ac, word
        processor.cycle()
        machine.bus.advance(processor.clock)
        return {"ac": machine.ac, "skip": machine.pc - PLACE - 1}

    def key(self, frame: int) -> None:
        """Press a key."""
        self.machine.teletype.keyboard.press(bytes([frame]))

    def start(self) -> None:
        """Do INITIALIZE."""
        self.machine.bus.initialize(self.now)


def play(devices: Devices, inputs: Sequence[Event], ticks: int) -> list[Event]:
    """Return the events of so many ticks: inputs and their results."""
    events: list[Event] = []
    seen = devices.see()

    def look() -> None:
        nonlocal seen
        before, seen = seen, devices.see()
        told = zip(seen, before, strict=True)
        events.extend({"tick": devices.now, **now[1]} for now, then in told if now != then)

    def to(tick: int) -> None:
        while (due := devices.next_event()) <= tick:
            devices.to(max(due, devices.now))
            look()
        devices.to(tick)

    to(0)
    for one in inputs:
        to(one["tick"])
        if "iot" in one:
            events.append({**one, "final": devices.iot(one["iot"], one["ac"])})
        elif "key" in one:
            events.append(one)
            devices.key(one["key"])
        else:
            events.append(one)
            devices.start()
        look()
        to(devices.now)
    to(ticks)
    return events


def _vector(name: str, inputs: list[Event]) -> dict[str, Any]:
    ours = Devices()
    ticks = inputs[-1]["tick"] + AFTERWARDS
    events = play(ours, inputs, ticks)
    return {
        "name": name,
        "models": ["8/L"],
        "instructions": sum("iot" in one for one in inputs),
        "initial": {"tape": list(TAPE)},
        "final": {"flags": [device for device, flag in ours.flags() if flag]},
        "ticks": ticks,
        "events": events,
    }
