"""A machine's whole state as JSON that a person can read, and back.

A run saved at any instant goes on as if nothing had happened.

    {"format": "pdp8 state", "version": 2,
     "left": {},                                 the machine is as its last run left it, ended by its limit;
                                                 {"sr": "0200"}: it is once SR is 0200 again; null: it is not
     "processor": {"pc": "0200", "clock": 85},   words are octal strings; counts, flags and ticks are numbers
     "core": {"0200": "7200 1205 ..."},          eight words a line; words not named are 0000
     "bus": {...}, "waiting": {...},
     "devices": {"03": {"device": "Receiver", "flag": 1, "reader": {"tape": ["215 212 ..."], ...}, ...}}}

What is saved of a part is what its class declares in `fields` (see fields.py). Breakpoints and observers are
not part of the machine, and not saved. Files of version 1 are read too (see oldstate.py).
"""

import json
from array import array
from collections.abc import Iterator, Mapping
from typing import Any

from pdp8.computer.hardware.bus import AT_ONCE, NEVER, Device
from pdp8.computer.hardware.fields import CORE, FRAMES, PART, TICK
from pdp8.computer.machine import SETTABLE, Machine
from pdp8.computer.past.oldstate import TITLE, modern
from tapes.errors import WorkError

_HEAD = {"format": "pdp8 state", "version": 2}
_PARTS = ("left", "processor", "core", "bus", "waiting", "devices")
_FORMERLY = "continues"  # of `left`
_LATEST = 1 << 60
_ROW = 8
_FRAMES = 24
_NEVER = "never"


class StateError(WorkError):
    """A text that is not a saved state; the message names the place."""


def save(machine: Machine) -> str:
    """Return the state of `machine` as text."""
    words = machine.processor.core
    state = {
        **_HEAD,
        "left": _left(machine),
        "processor": _written(machine.processor, words),
        "core": _rows(words),
        "bus": _written(machine.bus, words),
        "waiting": _written(machine.waiting, words),
        "devices": {
            f"{device.code:02o}": {"device": type(device).__name__, **_written(device, words)}
            for device in machine.bus
        },
    }
    return json.dumps(state, indent=1) + "\n"


def _left(machine: Machine) -> dict[str, object] | None:
    """Return the registers set since the last run as JSON has them."""
    left, kinds = machine.left(), machine.processor.fields
    if left is None:
        return None
    return {name: _value(kinds[name], value, machine.processor.core) for name, value in left.items()}


def _written(part: Any, core: "array[int]") -> dict[str, object]:
    """Return the fields of a part as JSON has them."""
    return {name: _value(kind, getattr(part, name), core) for name, kind in part.fields.items()}


def _value(kind: int | str, value: Any, core: "array[int]") -> object:
    if kind == PART:
        return _written(value, core)
    if kind == TICK:
        return _NEVER if value == NEVER else value
    if kind == FRAMES:
        rows = (value[at : at + _FRAMES] for at in range(0, len(value), _FRAMES))
        return [" ".join(f"{frame:03o}" for frame in row) for row in rows]
    if kind == CORE:
        return None if value is None else _rows(value, core)
    return f"{value:0{len(kind)}o}" if isinstance(kind, str) else int(value)


def _rows(words: "array[int]", usual: "array[int] | None" = None) -> dict[str, str]:
    """Return rows of words, {address: words}, but for those that are as `usual`, or 0."""
    usual = usual or array("H", bytes(2 * len(words)))
    return {
        f"{address:04o}": " ".join(f"{word:04o}" for word in words[address : address + _ROW])
        for address in range(0, len(words), _ROW)
        if words[address : address + _ROW] != usual[address : address + _ROW]
    }


def restore(text: str, others: Mapping[int, type[Device]] | None = None) -> Machine:
    """Return the machine whose state `text` is; what the text does not name is as at power-up. Raises
    StateError.

    `others` are the classes of devices that are fitted beside the Teletype and the PC8/L, by their codes.
    """
    state = _parsed(text)
    devices = _object(state.get("devices", {}), "devices")
    machine = Machine(highspeed="01" in devices)
    for code, device in (others or {}).items():
        machine.bus.fit(code, device())
    for address, word in _words(state.get("core", {}), "core"):
        machine.core[address] = word
    for name in ("processor", "bus", "waiting"):
        _take(getattr(machine, name), state.get(name, {}), name, machine)
    for number, fields in devices.items():
        _take_device(machine, number, fields)
    _check(machine)
    left = state.get("left", {} if state.get(_FORMERLY) else None)
    if left is not None:
        machine.leave(_registers(left, machine))
    return machine


def _parsed(text: str) -> dict[str, Any]:
    """Return the object that a state of either version is."""
    begins = f"a saved state begins with {json.dumps(_HEAD)[:-1]}"
    if not text.startswith((TITLE, "{")):
        raise StateError(begins)
    try:
        state: dict[str, Any] = modern(text) if text.startswith(TITLE) else {**json.loads(text)}
    except ValueError as error:
        raise StateError(f"the saved state is cut short or damaged: {error}") from error
    if {name: state.get(name) for name in _HEAD} != _HEAD:
        raise StateError(begins)
    for name in state:
        if name not in (*_HEAD, *_PARTS, _FORMERLY):
            raise StateError(f"{name}: the parts are {' '.join(_PARTS)}")
    return state


def _take_device(machine: Machine, code: str, fields: object) -> None:
    """Set the fields of the device that is fitted under `code`."""
    place = f"devices {code}"
    device = machine.bus.device(_octal(code, 0o77, place))
    if device is None:
        raise StateError(f"{place}: this machine has no such device")
    named = dict(_object(fields, place))
    kind = named.pop("device", type(device).__name__)
    if kind != type(device).__name__:
        raise StateError(f"{place}: {kind!r} was saved, but {type(device).__name__!r} is fitted")
    _take(device, named, place, machine)
    if "due" not in named:
        device.restored()


def _take(part: Any, fields: object, place: str, machine: Machine) -> None:
    """Set the fields of a part."""
    for name, value in _object(fields, place).items():
        where = f"{place} {name}"
        if name not in part.fields:
            raise StateError(f"{where}: the fields are {' '.join(part.fields)}")
        kind = part.fields[name]
        if kind == PART:
            _take(getattr(part, name), value, where, machine)
        elif kind == FRAMES:
            setattr(part, name, type(getattr(part, name))(_frames(value, where)))
        elif kind == CORE:
            setattr(part, name, None if value is None else _copy(value, where, machine))
        else:
            setattr(part, name, type(getattr(part, name))(_plain(value, kind, where)))


def _plain(value: object, kind: int | str, place: str) -> int:
    """Return the value of a field that is no tape, no part and no copy of core."""
    if isinstance(kind, int):
        return _number(value, 0, kind, place)
    return _tick(value, place) if kind == TICK else _octal(value, int(kind, 8), place)


def _registers(left: object, machine: Machine) -> dict[str, int]:
    """Return the registers set since the last run, {name: value}."""
    registers = {}
    for name, value in _object(left, "left").items():
        if name not in SETTABLE:
            raise StateError(f"left {name}: the registers are {' '.join(SETTABLE)}")
        registers[name] = _plain(value, machine.processor.fields[name], f"left {name}")
    return registers


def _object(value: object, place: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise StateError(f"{place}: {_short(value)} is not an object with fields")
    return value


def _number(value: object, least: int, most: int, place: str) -> int:
    if not isinstance(value, int) or not least <= value <= most:
        raise StateError(f"{place}: {_short(value)} is not a number from {least} to {most}")
    return value


def _octal(value: object, most: int, place: str) -> int:
    """Return an octal number written as a string."""
    digits = isinstance(value, str) and value.isascii() and value.isdigit() and not set(value) & {"8", "9"}
    if not digits or int(str(value), 8) > most:
        raise StateError(f"{place}: {_short(value)} is not an octal number from 0 to {most:o}")
    return int(str(value), 8)


def _tick(value: object, place: str) -> int:
    return NEVER if value == _NEVER else _number(value, AT_ONCE, _LATEST, place)


def _frames(value: object, place: str) -> Iterator[int]:
    if not isinstance(value, list):
        raise StateError(f"{place}: {_short(value)} is not a list of rows of frames")
    for row in value:
        for frame in str(row).split():
            yield _octal(frame, 0o377, place)


def _words(value: object, place: str) -> Iterator[tuple[int, int]]:
    """Yield the addresses and words of {address: words}."""
    for first, words in _object(value, place).items():
        for offset, word in enumerate(str(words).split()):
            address = _octal(first, 0o7777, place) + offset
            if address > 0o7777:
                raise StateError(f"{place} {first}: the words go beyond 7777")
            yield address, _octal(word, 0o7777, f"{place} {first}")


def _copy(value: object, place: str, machine: Machine) -> "array[int]":
    """Return a copy of core that differs from it in the words given."""
    copy = machine.processor.core[:]
    for address, word in _words(value, place):
        copy[address] = word
    return copy


def _check(machine: Machine) -> None:
    """Raise StateError for fields that contradict each other."""
    for reader in (machine.teletype.reader, machine.highspeed.reader):
        if reader.position > len(reader.tape):
            raise StateError(f"the reader stands at frame {reader.position} of a tape of {len(reader.tape)}")
    p, waiting = machine.processor, machine.waiting
    if waiting.clock > p.clock or waiting.instructions > p.instructions:
        raise StateError("waiting: its clock and instructions lie after those of the processor")


def _short(value: object) -> str:
    return json.dumps(value)[:60]
