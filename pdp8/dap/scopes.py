"""What the editor is shown of the stopped machine, and sets there: calls, variables, expressions.

Registers and switches are set as by the monitor. A symbol of the program shows the word at its address. A
device, and each of its parts, shows the fields of its saved state (see computer/hardware/fields.py).

A line at the debug console is a register, a symbol or an address, whose word is shown, or an expression;
anything else is a command of the monitor, which a hover or a watched expression cannot be.
"""

from collections.abc import Callable, Iterator
from typing import Any

from pal.isa import JMP, refers_to
from pdp8.computer.hardware.extension import FIELD
from pdp8.computer.hardware.fields import CORE, FRAMES, PART, TICK, Part, walk
from pdp8.computer.hardware.signals import AT_ONCE, NEVER, TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.dap import calls, expressions
from pdp8.dap.breakpoints import LINES
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.places import reference
from pdp8.dap.wire import Body
from pdp8.monitor import debugging
from pdp8.monitor.arguments import MonitorError, command, octal
from pdp8.monitor.commands import COMMANDS, do
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError
from tapes.quantities import counted

REGISTERS, LAMPS, SYMBOLS, DEVICES = 1, 2, 3, 4
"""References of the scopes."""
_PARTS = 100
"""The reference of the first part of a device."""
_READ_ONLY = {"presentationHint": {"attributes": ["readOnly"]}}
_LIT, _DARK = "\N{BLACK CIRCLE}", "\N{WHITE CIRCLE}"
_ROWS = {"ma": 12, "mb": 12, "ac": 12, "ir": 3}


def stack_trace(debuggee: Debuggee, arguments: Body) -> Body:
    """Return the call stack."""
    machine = debuggee.monitor.machine
    found = calls.of(machine)
    start = arguments.get("startFrame") or 0
    end = start + (arguments.get("levels") or len(found))
    frames = [_frame(debuggee, number, frame) for number, frame in enumerate(found)]
    return {"stackFrames": frames[start:end], "totalFrames": len(found)}


def _frame(debuggee: Debuggee, number: int, frame: calls.Frame) -> Body:
    place = debuggee.places.at(frame.address) if debuggee.knows_source else None
    return {
        "id": number,
        "name": f"{frame.address:04o}  {_routine(debuggee, frame.entry)}",
        "instructionPointerReference": reference(frame.address),
        **(place or {"line": 0, "column": 0}),
    }


def _routine(debuggee: Debuggee, entry: int | None) -> str:
    if not entry:
        return "main program" if entry is None else "interrupt"
    names = (name for name, value in debuggee.monitor.listing.symbols.items() if value == entry)
    return next(names, f"{entry:04o}")


def source(debuggee: Debuggee, arguments: Body) -> Body:
    """Return the listing that replaces a tape's source."""
    return {"content": "\n".join(debuggee.places.listing.lines) + "\n"}


def scopes(debuggee: Debuggee, arguments: Body) -> Body:
    named = {"Registers": REGISTERS, "Lamps": LAMPS, "Symbols": SYMBOLS, "Devices": DEVICES}
    return {
        "scopes": [
            {"name": name, "variablesReference": number, "expensive": False}
            | ({"presentationHint": "registers"} if number == REGISTERS else {})
            for name, number in named.items()
        ]
    }


def variables(debuggee: Debuggee, arguments: Body) -> Body:
    """Return the variables of a scope or of a device's part."""
    return {"variables": list(_variables(debuggee.monitor, arguments["variablesReference"]))}


def set_variable(debuggee: Debuggee, arguments: Body) -> Body:
    """Set a variable; return it as it is then."""
    monitor, number, name = debuggee.monitor, arguments["variablesReference"], arguments["name"]
    value = arguments["value"].strip()
    if number == REGISTERS:
        debugging.set_(monitor, name.lower().replace(" ", "_"), value)
    elif number == SYMBOLS:
        _deposit(monitor, name, value)
    elif number >= _PARTS:
        path, part = _part(monitor.machine, number)
        monitor.machine.put({f"{path} {name}": _given(name, part.fields.get(name), value)})
    else:
        raise WorkError(f"{name}: lamps only show; set the registers")
    now = {each["name"]: each["value"] for each in _variables(monitor, number)}
    return {"value": now.get(name, "")}


def data_info(debuggee: Debuggee, arguments: Body) -> Body:
    """Say whether a word can be watched: that of a symbol or an address."""
    name, scope = arguments["name"], arguments.get("variablesReference") or SYMBOLS
    try:
        if scope != SYMBOLS:
            raise WorkError(f"{name}: only words of core can be watched")
        address = debuggee.monitor.address(name)
    except WorkError as error:
        return {"dataId": None, "description": str(error)}
    return {
        "dataId": f"{address:04o}",
        "description": f"{name}, {address:04o}",
        "accessTypes": ["write", "read", "readWrite"],
    }


def evaluate(debuggee: Debuggee, arguments: Body) -> Body:
    """Return the value of an expression, or the monitor's answer to a line of the console."""
    line = arguments["expression"].strip()
    word = line in debuggee.monitor.listing.symbols or debugging.is_register(debuggee.monitor, line)
    named = not word and command(line)[0].lower() in COMMANDS
    at_console = arguments.get("context") == "repl"
    if not (at_console and named):
        try:
            return {"variablesReference": 0, **_value_of(debuggee.monitor, line)}
        except MonitorError:
            if not at_console:
                raise
    debuggee.put_points()
    do(debuggee.monitor, line)
    said = "\n".join(debuggee.said)
    debuggee.said.clear()
    return {"result": said, "variablesReference": 0}


def set_expression(debuggee: Debuggee, arguments: Body) -> Body:
    """Set a register, or the word at a symbol or an address; return it as it is then."""
    monitor, name, value = debuggee.monitor, arguments["expression"].strip(), arguments["value"].strip()
    if debugging.is_register(monitor, name):
        debugging.set_(monitor, name, value)
    else:
        _deposit(monitor, name, value)
    return {"value": _value_of(monitor, name)["result"]}


def _deposit(monitor: Monitor, name: str, value: str) -> None:
    monitor.machine.core[monitor.address(name)] = monitor.word(value)


def set_lines(debuggee: Debuggee, arguments: Body) -> Body:
    """Set the breakpoints of a source, in place of those before."""
    source = arguments["source"]
    asked = [(point["line"], {**point, "source": source}) for point in arguments.get("breakpoints") or ()]
    name = str(source.get("path") or source.get("sourceReference") or "")
    return {"breakpoints": debuggee.breakpoints.put(debuggee.monitor, debuggee.places, LINES, name, asked)}


def setting(kind: str, *names: str) -> Callable[[Debuggee, Body], Body]:
    """Return a function that sets one type of breakpoints; their fields `names` tell one from another."""

    def set_(debuggee: Debuggee, arguments: Body) -> Body:
        asked = [(tuple(point.get(name) for name in names), point) for point in arguments["breakpoints"]]
        return {"breakpoints": debuggee.breakpoints.put(debuggee.monitor, debuggee.places, kind, "", asked)}

    return set_


def goto_targets(debuggee: Debuggee, arguments: Body) -> Body:
    """Return the word that a line makes, as a place to go on from."""
    found = debuggee.places.first_from(arguments["source"], arguments["line"])
    if found is None:
        return {"targets": []}
    address, line = found
    return {"targets": [{"id": address, "label": f"{address:04o}", "line": line}]}


def completions(debuggee: Debuggee, arguments: Body) -> Body:
    """Return completions for a console line: commands first, then registers and symbols."""
    begun = arguments["text"][: max(arguments["column"] - debuggee.places.column, 0)].rpartition(" ")
    known = [*_named(debuggee.monitor.machine), *debuggee.monitor.listing.symbols]
    names = known if begun[1] else [*COMMANDS, *known]
    typed = begun[2].upper()
    found = [name if name in COMMANDS else name.upper() for name in names]
    return {"targets": [{"label": name} for name in dict.fromkeys(found) if name.upper().startswith(typed)]}


def _value_of(monitor: Monitor, expression: str) -> Body:
    """Return what a register holds, the word at an address, or what an expression is. Raises MonitorError."""
    if debugging.is_register(monitor, expression):
        return {"result": _register(monitor.machine, expression)}
    if not expression:
        raise MonitorError("a register, a symbol or an address expected")
    try:
        address = monitor.address(expression)
    except MonitorError:
        return {"result": f"{expressions.read(expression, monitor)():04o}"}
    machine = monitor.machine
    line = monitor.listing.line(address, machine.core[address], machine.processor)
    return {"result": line, "memoryReference": reference(address)}


def _register(machine: Machine, name: str) -> str:
    name = debugging.register(name)
    digits = len(debugging.EXTENSION.get(name, "")) or len(f"{debugging.greatest(machine, name):o}")
    return f"{debugging.value(machine, name):0{digits}o}"


def _variables(monitor: Monitor, number: int) -> Iterator[Body]:
    found: dict[int, Callable[[Monitor], Iterator[Body]]] = {
        REGISTERS: _registers,
        LAMPS: _lamps,
        SYMBOLS: _symbols,
        DEVICES: _devices,
    }
    return found[number](monitor) if number in found else _fields(monitor.machine, number)


def _named(machine: Machine) -> list[str]:
    """Return the names of a machine's registers."""
    return [*debugging.REGISTERS, *(debugging.EXTENSION if machine.memory > FIELD else ())]


def _registers(monitor: Monitor) -> Iterator[Body]:
    machine = monitor.machine
    for name in _named(machine):
        refers = {"memoryReference": reference(getattr(machine, name))} if name in ("pc", "ma") else {}
        yield _variable(name.upper(), _register(machine, name), **refers)
    for switch in (*debugging.SWITCHES, *(debugging.FIELDS if machine.memory > FIELD else ())):
        yield _variable(switch.upper().replace("_", " "), str(int(getattr(machine.panel, switch))))


def _lamps(monitor: Monitor) -> Iterator[Body]:
    for name, value in monitor.machine.panel.lamps._asdict().items():
        width = _ROWS.get(name, 1)
        lights = "".join(_LIT if value >> bit & 1 else _DARK for bit in range(width - 1, -1, -1))
        row = " ".join(lights[at : at + 3] for at in range(0, width, 3))
        yield _variable(name.strip("_").upper().replace("_", " "), row, **_READ_ONLY)
    yield _variable("TIME", f"{monitor.machine.elapsed:,.8f} s", **_READ_ONLY)


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
        raise WorkError(f"{number}: no scope has this number")
    return found[number - _PARTS]


def _fields(machine: Machine, number: int) -> Iterator[Body]:
    path, part = _part(machine, number)
    numbers = {each: number for number, (each, _) in enumerate(walk(machine.parts()), _PARTS)}
    for name, kind in part.fields.items():
        if kind == PART:
            yield _variable(name, "", variablesReference=numbers[f"{path} {name}"])
        elif kind != CORE:
            settable = kind not in (TICK, FRAMES)
            shown = _shown(machine, kind, getattr(part, name))
            yield _variable(name, shown, **({} if settable else _READ_ONLY))


def _shown(machine: Machine, kind: int | str, value: Any) -> str:
    """Return a field's value: numbers as in saved states, times relative to now."""
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
            raise WorkError(f"{text}: {name} is 0 to {kind:,}")
        return int(text)
    if kind is None or not kind.isdecimal():
        raise WorkError(f"{name} cannot be set")
    return octal(text, int(kind, 8))


def _variable(name: str, value: str, **more: Any) -> Body:
    return {"name": name, "value": value, "variablesReference": 0, **more}
