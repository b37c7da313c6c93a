"""A machine's whole state as JSON that a person can read, and back.

A run saved at any instant goes on as if nothing had happened.

    {"format": "pdp8 state", "version": 2,
     "memory": 8192,                             where it is not 4096: words of core
     "core": {"0200": "7200 1205 ..."},          eight words a line; words not named are 0000
     "processor": {"pc": "0200", "clock": 85},   words are octal strings; counts, flags and ticks are numbers
     "bus": {...}, "waiting": {...},
     "devices": {"03": {"device": "Receiver", "flag": 1, "reader": {"tape": ["215 212 ..."], ...}, ...}}}

Each part is written with the `fields` that its class declares (see fields.py); `Machine.values` takes them.
Breakpoints and observers are not part of the machine, and not saved.
"""

import json
from array import array
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pdp8.computer.hardware.bus import Device, Peripheral
from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.hardware.extension import FIELD, SIZES
from pdp8.computer.hardware.fields import CORE, FRAMES, MEDIUM, PART, TICK, Medium, Values, walk
from pdp8.computer.hardware.signals import AT_ONCE, INTERRUPT, NEVER
from pdp8.computer.hardware.teletype import Reader, Teletype
from pdp8.computer.machine import Machine
from tapes.errors import WorkError

_FORMAT = "pdp8 state"
HEAD = {"format": _FORMAT, "version": 2}
_PARTS = ("memory", "core", "processor", "bus", "waiting", "extension", "devices")
_LATEST = 1 << 56
"""Ticks, 114 years: eleven times as many, the Teletype's parts of a tick, still fit into 64 bits."""
_ROW = 8
_FRAMES = 24
_NEVER = "never"


class StateError(WorkError):
    """A text that is not a saved state; the message names the place."""


def save(machine: Machine) -> str:
    """Return the state of `machine` as text."""
    values = machine.values()
    core = _words(values["core"])
    state: dict[str, Any] = {**HEAD}
    if machine.memory != FIELD:
        state["memory"] = machine.memory
    state["core"] = _rows(core, _words(bytes(2 * len(core))))
    for path, part in walk(machine.parts()):
        place = state
        for step in path.split():
            place = place.setdefault(step, {})
        if isinstance(part, Device):
            place["device"] = type(part).__name__
        for name, kind in part.fields.items():
            if kind != PART:
                place[name] = _written(kind, values[f"{path} {name}"], core)
    return json.dumps(state, indent=1) + "\n"


def _written(kind: int | str, value: Any, core: "array[int]") -> object:
    """Return a value for JSON; a copy of core only by the rows that differ from `core`."""
    if kind == TICK:
        return _NEVER if value == NEVER else value
    if kind == MEDIUM:
        return None if value is None else value.digest
    if kind == FRAMES:
        rows = (value[at : at + _FRAMES] for at in range(0, len(value), _FRAMES))
        return [" ".join(f"{frame:03o}" for frame in row) for row in rows]
    if kind == CORE:
        return None if value is None else _rows(_words(value), core)
    return f"{value:0{len(kind)}o}" if isinstance(kind, str) else int(value)


def _words(content: bytes) -> "array[int]":
    return array("H", content)


def _rows(words: "array[int]", usual: "array[int]") -> dict[str, str]:
    """Return {address: words} of the rows that differ from `usual`."""
    return {
        f"{address:04o}": " ".join(f"{word:04o}" for word in words[address : address + _ROW])
        for address in range(0, len(words), _ROW)
        if words[address : address + _ROW] != usual[address : address + _ROW]
    }


LARGEST = 48 << 20
"""Bytes of a saved state: five tapes of 2 MiB, four bytes a frame and some more."""


def restore(
    text: str,
    fitted: Iterable[Peripheral] = (),
    media: Iterable[Medium] = (),
    known: Iterable[Peripheral] | None = None,
    mount: str = "mount it first",
) -> Machine:
    """Return the machine of a saved state, with new devices `fitted`, the `known` ones that it names, and its
    reels from `media`; missing fields are as at power-up. Raises StateError; `mount` says how a reel comes.
    """
    state = _parsed(text)
    devices = _object(state.get("devices", {}), "devices")
    memory = _memory(state)
    machine = Machine(_fitted(devices, fitted, one_of_each() if known is None else known), memory)
    for number, fields in devices.items():
        _check_device(machine, number, fields)
    core = _copy(state.get("core", {}), "core", machine.processor.core)
    values: Values = {"core": core.tobytes()}
    reels = {medium.digest: medium for medium in media}
    for path, part in walk(machine.parts()):
        for name, given in _fields(state, path).items():
            kind, place = part.fields.get(name), f"{path} {name}"
            if kind is None:
                raise StateError(f"{place}: the fields are {' '.join(part.fields)}")
            if kind == MEDIUM:
                mounted = getattr(part, name)
                values[place] = mounted if given is None else _medium(given, mounted, reels, place, mount)
            elif kind != PART:
                values[place] = _read(kind, given, place, core)
    try:
        machine.put(values)
    except ValueError as error:
        raise StateError(f"{error}") from error
    for device in machine.bus:
        if f"devices {device.code:02o} due" not in values:
            device.restored()
    _check(machine)
    return machine


def core(text: str) -> "array[int]":
    """Return the core of a saved state, whatever devices and reels that needs. Raises StateError."""
    state = _parsed(text)
    return _copy(state.get("core", {}), "core", _words(bytes(2 * _memory(state))))


def _memory(state: dict[str, Any]) -> int:
    memory = _number(state.get("memory", FIELD), FIELD, max(SIZES), "memory")
    if memory not in SIZES:
        raise StateError(f"memory: {memory} words; {', '.join(f'{size}' for size in SIZES)} are allowed")
    return memory


def _fitted(
    saved: Mapping[str, Any], fitted: Iterable[Peripheral], known: Iterable[Peripheral]
) -> list[Peripheral]:
    """Return the devices for a machine: `fitted`, and known ones that `saved` names."""
    by_code = {device.CODE: device for device in fitted}
    found: list[Peripheral] = []
    for each in known:
        if each.CODE in by_code:
            found.append(by_code.pop(each.CODE))
        elif f"{each.CODE:02o}" in saved or each.CODE == Teletype.CODE:
            found.append(each)
    return [*found, *by_code.values()]


def _parsed(text: str) -> dict[str, Any]:
    """Return the JSON object of a saved state."""
    begins = f"a saved state begins with {json.dumps(HEAD)[:-1]}"
    if not text.lstrip().startswith("{") or _FORMAT not in text:
        raise StateError(begins)
    try:
        state: dict[str, Any] = json.loads(text)
    except RecursionError as error:
        raise StateError("the saved state is nested too deeply") from error
    except ValueError as error:
        raise StateError(f"the saved state is cut short or damaged: {error}") from error
    if {name: state.get(name) for name in HEAD} != HEAD:
        raise StateError(begins)
    for name in state:
        if name not in (*HEAD, *_PARTS):
            raise StateError(f"{name}: the parts are {' '.join(_PARTS)}")
    return state


def _check_device(machine: Machine, code: str, fields: object) -> None:
    """Raise StateError unless the device saved under `code` is fitted there; drop its name."""
    place = f"devices {code}"
    device = machine.bus.device(_octal(code, 0o77, place))
    if device is None or code != f"{device.code:02o}":
        name = _object(fields, place).get("device", "device of this code")
        raise StateError(f"{place}: the state needs a {name}; --device FILE:CLASS fits one, a page has none")
    fitted = type(device).__name__
    kind = _object(fields, place).pop("device", fitted)
    if kind != fitted:
        raise StateError(f"{place}: the state needs a {kind}, not a {fitted}; --device FILE:CLASS fits one")


def _fields(state: dict[str, Any], path: str) -> dict[str, Any]:
    """Return what `state` says of the part at `path`, by the names of fields."""
    found: Any = state
    for step in path.split():
        found = _object(found.get(step, {}), path)
    return _object(found, path)


def _read(kind: int | str, value: object, place: str, core: "array[int]") -> Any:
    """Return the value of a field that JSON has as `value`."""
    if kind == FRAMES:
        return bytes(_frames(value, place))
    if kind == CORE:
        return None if value is None else _copy(value, place, core).tobytes()
    if kind == TICK:
        return NEVER if value == _NEVER else _number(value, AT_ONCE, _LATEST, place)
    return _octal(value, int(kind, 8), place) if isinstance(kind, str) else _number(value, 0, kind, place)


def _medium(
    given: object, mounted: Medium | None, reels: Mapping[str, Medium], place: str, mount: str
) -> Medium:
    """Return the reel that a state names by its digest."""
    if mounted is not None and mounted.digest == given:
        return mounted
    if not isinstance(given, str) or given not in reels:
        raise StateError(f"{place}: the state needs the reel of SHA-256 {_short(given)}; {mount}")
    return reels[given]


def _object(value: object, place: str) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise StateError(f"{place}: {_short(value)} is not an object with fields")
    return value


def _number(value: object, least: int, most: int, place: str) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or not least <= value <= most:
        raise StateError(f"{place}: {_short(value)} is not a number from {least} to {most}")
    return value


def _octal(value: object, most: int, place: str) -> int:
    """Return an octal number written as a string."""
    digits = isinstance(value, str) and value.isascii() and value.isdigit() and not set(value) & {"8", "9"}
    if not digits or int(str(value), 8) > most:
        raise StateError(f"{place}: {_short(value)} is not an octal number from 0 to {most:o}")
    return int(str(value), 8)


def _numbers(value: object, place: str) -> list[str]:
    """Return the octal numbers of a text of several."""
    if not isinstance(value, str):
        raise StateError(f"{place}: {_short(value)} is not a text of octal numbers")
    return value.split()


_WRITTEN = {f"{frame:03o}": frame for frame in range(0o400)}
"""The frames as they are written: a long tape is read in a third of the time."""


def _frames(value: object, place: str) -> Iterator[int]:
    if not isinstance(value, list):
        raise StateError(f"{place}: {_short(value)} is not a list of rows of frames")
    for row in value:
        for frame in _numbers(row, place):
            known = _WRITTEN.get(frame)
            yield _octal(frame, 0o377, place) if known is None else known


def _copy(value: object, place: str, core: "array[int]") -> "array[int]":
    """Return a copy of `core` that differs from it in the words given, {address: words}."""
    copy = core[:]
    for first, words in _object(value, place).items():
        for offset, word in enumerate(_numbers(words, f"{place} {first}")):
            address = _octal(first, len(core) - 1, place) + offset
            if address >= len(core):
                raise StateError(f"{place} {first}: the words go beyond {len(core) - 1:o}")
            copy[address] = _octal(word, 0o7777, f"{place} {first}")
    return copy


def _check(machine: Machine) -> None:
    """Raise StateError for contradictory fields."""
    for _, part in walk(machine.parts()):
        if isinstance(part, Reader) and part.position > len(part.tape):
            raise StateError(f"the reader stands at frame {part.position} of a tape of {len(part.tape)}")
    p, waiting, x = machine.processor, machine.waiting, machine.processor.extension
    used = (x.field, x.inst_field, x.data_field, x.inst_buffer, x.saved_inst, x.saved_data)
    for field in (*used, x.inst_switch, x.data_switch):
        if field % FIELD != 0 or field >= machine.memory:
            raise StateError(f"extension: {field:05o} is not a field of {machine.memory} words of core")
    if (p.next > INTERRUPT) != (machine.bus.in_break() is not None):
        raise StateError("processor next: must be 4 to 6, as a device has a data break")
    if NEVER in (p.clock, p.started):
        raise StateError('processor: its clock and started are numbers, not "never"')
    if waiting.clock > p.clock or waiting.instructions > p.instructions:
        raise StateError("waiting: its clock and instructions must not exceed the processor's")


def _short(value: object) -> str:
    return json.dumps(value)[:66]  # a digest is whole
