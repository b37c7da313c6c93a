"""What a debugger shows as variables: registers, lamps, symbols, devices.

Registers and switches are set as by the monitor. A symbol of the program shows the word that stands there. A
device, and each of its parts, shows the fields of its saved state (see computer/hardware/fields.py).
"""

from collections.abc import Iterator
from typing import Any

from pal.isa import JMP, refers_to
from pdp8.computer.hardware.fields import CORE, FRAMES, PART, TICK, Part, walk
from pdp8.computer.hardware.signals import AT_ONCE, NEVER, TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.dap.memory import reference
from pdp8.dap.wire import Body
from pdp8.monitor import hands
from pdp8.monitor.arguments import MonitorError, octal
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError
from tapes.measure import counted

REGISTERS, LAMPS, SYMBOLS, DEVICES = 1, 2, 3, 4
"""References of the scopes."""
_PARTS = 100
"""The reference of the first part of a device."""
_LIT, _DARK = "\N{BLACK CIRCLE}", "\N{WHITE CIRCLE}"
_ROWS = {"ma": 12, "mb": 12, "ac": 12, "ir": 3}
_SWITCHES = ("mem_prot", "sing_step")


class ScopeError(WorkError):
    """A variable that there is not, or that cannot be set."""


def scopes() -> list[Body]:
    named = {"Registers": REGISTERS, "Lamps": LAMPS, "Symbols": SYMBOLS, "Devices": DEVICES}
    return [
        {"name": name, "variablesReference": number, "expensive": False}
        | ({"presentationHint": "registers"} if number == REGISTERS else {})
        for name, number in named.items()
    ]


def variables(monitor: Monitor, number: int) -> list[Body]:
    """Return the Variables of a scope or of a device's part. Raises ScopeError."""
    kinds = {REGISTERS: _registers, LAMPS: _lamps, SYMBOLS: _symbols, DEVICES: _devices}
    if number in kinds:
        return list(kinds[number](monitor))
    path, part = _part(monitor.machine, number)
    return list(_fields(monitor.machine, path, part))


def set_variable(monitor: Monitor, number: int, name: str, value: str) -> None:
    """Set a variable. Raises WorkError."""
    if number == REGISTERS:
        hands.set_(monitor, [name.lower().replace(" ", "_"), value.strip()])
    elif number == SYMBOLS:
        monitor.machine.core[monitor.address(name)] = monitor.address(value.strip())
    elif number >= _PARTS:
        path, part = _part(monitor.machine, number)
        monitor.machine.put({f"{path} {name}": _given(name, part.fields.get(name), value.strip())})
    else:
        raise ScopeError(f"{name}: lamps only show; set the registers")


def _registers(monitor: Monitor) -> Iterator[Body]:
    machine = monitor.machine
    for name, most in hands.REGISTERS.items():
        word = getattr(machine, name)
        refers = {"memoryReference": reference(word)} if name in ("pc", "ma") else {}
        yield _variable(name.upper(), f"{word:0{len(f'{most:o}')}o}", **refers)
    for switch in _SWITCHES:
        yield _variable(switch.upper().replace("_", " "), str(int(getattr(machine.panel, switch))))


def _lamps(monitor: Monitor) -> Iterator[Body]:
    for name, value in monitor.machine.panel.lamps._asdict().items():
        width = _ROWS.get(name, 1)
        lights = "".join(_LIT if value >> bit & 1 else _DARK for bit in range(width - 1, -1, -1))
        row = " ".join(lights[at : at + 3] for at in range(0, width, 3))
        yield _variable(name.strip("_").upper().replace("_", " "), row, presentationHint=_READ_ONLY)
    yield _variable("TIME", f"{monitor.machine.elapsed:,.8f} s", presentationHint=_READ_ONLY)


def _symbols(monitor: Monitor) -> Iterator[Body]:
    core, words = monitor.machine.core, monitor.listing.words
    places = words.keys() | {refers_to(word, at) for at, word in words.items() if word >> 9 <= JMP}
    for name, value in monitor.listing.symbols.items():
        if value in places:
            yield _variable(name, f"{core[value]:04o}", memoryReference=reference(value))


def _devices(monitor: Monitor) -> Iterator[Body]:
    for number, (path, part) in enumerate(walk(monitor.machine.parts()), _PARTS):
        first, *rest = path.split()
        if first == "devices" and len(rest) == 1:
            yield _variable(f"{rest[0]} {type(part).__name__}", "", variablesReference=number)


def _part(machine: Machine, number: int) -> tuple[str, Part]:
    found = list(walk(machine.parts()))
    if not _PARTS <= number < _PARTS + len(found):
        raise ScopeError(f"{number}: no scope has this number")
    return found[number - _PARTS]


def _fields(machine: Machine, path: str, part: Part) -> Iterator[Body]:
    numbers = {each: number for number, (each, _) in enumerate(walk(machine.parts()), _PARTS)}
    for name, kind in part.fields.items():
        if kind == PART:
            yield _variable(name, "", variablesReference=numbers[f"{path} {name}"])
        elif kind != CORE:
            settable = isinstance(kind, int) or kind not in (TICK, FRAMES)
            hint = {} if settable else {"presentationHint": _READ_ONLY}
            yield _variable(name, _shown(machine, kind, getattr(part, name)), **hint)


def _shown(machine: Machine, kind: int | str, value: Any) -> str:
    """Return a field's value: numbers as saved states have them, times as so far ahead."""
    if kind == FRAMES:
        return counted(len(value), "frames")
    if kind == TICK:
        if value in (NEVER, AT_ONCE):
            return "never" if value == NEVER else "at once"
        return f"in {(value - machine.processor.clock) / TICKS_PER_SECOND * 1000:,.5f} ms"
    return f"{int(value)}" if isinstance(kind, int) else f"{int(value):0{len(kind)}o}"


def _given(name: str, kind: int | str | None, text: str) -> int:
    """Return the number that a field is to have. Raises WorkError."""
    if isinstance(kind, int):
        if not text.isdecimal() or int(text) > kind:
            raise ScopeError(f"{text}: {name} is 0 to {kind:,}")
        return int(text)
    if kind in (None, TICK, FRAMES, CORE, PART):
        raise ScopeError(f"{name} cannot be set")
    return octal(text, int(str(kind), 8))


_READ_ONLY = {"attributes": ["readOnly"]}


def _variable(name: str, value: str, **more: Any) -> Body:
    return {"name": name, "value": value, "variablesReference": 0, **more}


def value_of(monitor: Monitor, expression: str) -> tuple[str, int | None]:
    """Return what a register holds, or the word at an address, with that address. Raises MonitorError."""
    name = hands.register(expression.strip())
    if name in hands.REGISTERS:
        return f"{getattr(monitor.machine, name):0{len(f'{hands.REGISTERS[name]:o}')}o}", None
    if not name:
        raise MonitorError("a register, a symbol or an address expected")
    address = monitor.address(expression.strip())
    return monitor.listing.line(address, monitor.machine.core[address]), address
