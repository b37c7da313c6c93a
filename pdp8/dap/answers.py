"""What the editor asks about the machine that stands, or sets there: request by request.

A line at the debug console is a register, a symbol or an address, whose word is shown; anything else is a
command of the monitor. At a hover or in the list of watched expressions it is the former alone.
"""

from collections.abc import Callable, Mapping

from pdp8.dap import calls, memory, scopes
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.wire import Body
from pdp8.monitor.arguments import MonitorError, command
from pdp8.monitor.commands import COMMANDS, do


def stack_trace(room: Debuggee, arguments: Body) -> Body:
    """Return where the machine is, and who called."""
    machine = room.monitor.machine
    found = calls.frames(list(machine.core), machine.pc, machine.ion)
    start = arguments.get("startFrame") or 0
    end = start + (arguments.get("levels") or len(found))
    return {
        "stackFrames": [_frame(room, number, frame) for number, frame in enumerate(found)][start:end],
        "totalFrames": len(found),
    }


def _frame(room: Debuggee, number: int, frame: calls.Frame) -> Body:
    line = room.places.line(frame.address) if room.knows_source else None
    place = {"line": line, "column": 1, "source": room.places.source} if line else {"line": 0, "column": 0}
    return {
        "id": number,
        "name": f"{frame.address:04o}  {_routine(room, frame.entry)}",
        "instructionPointerReference": memory.reference(frame.address),
        **place,
    }


def _routine(room: Debuggee, entry: int | None) -> str:
    if not entry:
        return "main program" if entry is None else "interrupt"
    names = [name for name, value in room.monitor.listing.symbols.items() if value == entry]
    return names[0] if names else f"{entry:04o}"


def variables(room: Debuggee, arguments: Body) -> Body:
    return {"variables": scopes.variables(room.monitor, arguments["variablesReference"])}


def set_variable(room: Debuggee, arguments: Body) -> Body:
    """Set a variable; return it as it is then."""
    number, name = arguments["variablesReference"], arguments["name"]
    scopes.set_variable(room.monitor, number, name, arguments["value"])
    now = {each["name"]: each["value"] for each in scopes.variables(room.monitor, number)}
    return {"value": now.get(name, "")}


def evaluate(room: Debuggee, arguments: Body) -> Body:
    """Return what an expression is, or what the monitor says to a line of the console."""
    line = arguments["expression"].strip()
    named = line not in room.monitor.listing.symbols and command(line)[0].lower() in COMMANDS
    if arguments.get("context") == "repl" and (named or not _is_place(room, line)):
        do(room.monitor, line)
        said = "\n".join(room.said)
        room.said.clear()
        return {"result": said, "variablesReference": 0}
    value, address = scopes.value_of(room.monitor, line)
    refers = {} if address is None else {"memoryReference": memory.reference(address)}
    return {"result": value, "variablesReference": 0, **refers}


def _is_place(room: Debuggee, line: str) -> bool:
    try:
        scopes.value_of(room.monitor, line)
    except MonitorError:
        return False
    return True


def source(room: Debuggee, arguments: Body) -> Body:
    """Return the listing that stands for the source of a tape."""
    return {"content": room.places.text}


def read_memory(room: Debuggee, arguments: Body) -> Body:
    start = memory.byte(arguments["memoryReference"], arguments.get("offset") or 0)
    return memory.read(room.monitor.machine, start, arguments["count"])


def write_memory(room: Debuggee, arguments: Body) -> Body:
    start = memory.byte(arguments["memoryReference"], arguments.get("offset") or 0)
    return {"bytesWritten": memory.write(room.monitor.machine, start, arguments["data"])}


def disassemble(room: Debuggee, arguments: Body) -> Body:
    start = memory.place(arguments["memoryReference"], arguments.get("offset") or 0)
    start += arguments.get("instructionOffset") or 0
    addresses = range(start, start + min(arguments["instructionCount"], memory.MOST))
    machine, listing = room.monitor.machine, room.monitor.listing
    return {"instructions": [memory.disassembled(machine, listing, address) for address in addresses]}


ANSWERS: Mapping[str, Callable[[Debuggee, Body], Body]] = {
    "stackTrace": stack_trace,
    "scopes": lambda room, arguments: {"scopes": scopes.scopes()},
    "variables": variables,
    "setVariable": set_variable,
    "evaluate": evaluate,
    "source": source,
    "readMemory": read_memory,
    "writeMemory": write_memory,
    "disassemble": disassemble,
}
