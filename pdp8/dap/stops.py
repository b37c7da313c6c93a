"""What the editor asks about breakpoints: request by request.

A breakpoint at a line without a word goes to the next that has one. One at an address is a function
breakpoint to the editor: its name is an octal address or a symbol. A data breakpoint stops after a word was
written.
"""

from collections.abc import Callable, Mapping
from typing import TypeVar

from pdp8.dap import memory
from pdp8.dap.breakpoints import ADDRESSES, DATA, INSTRUCTIONS, LINES
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.scopes import SYMBOLS
from pdp8.dap.wire import Body
from tapes.errors import WorkError

_Asked = TypeVar("_Asked")


def set_lines(room: Debuggee, arguments: Body) -> Body:
    """Set the breakpoints of a source, in place of those before."""
    asked = [point["line"] for point in arguments.get("breakpoints") or ()]
    if not room.places.is_of(arguments["source"]):
        why = f"the program that runs is {room.places.source['name']}"
        return {"breakpoints": [{"verified": False, "line": line, "message": why} for line in asked]}
    room.breakpoints.lines = asked
    return {"breakpoints": place_lines(room)}


def place_lines(room: Debuggee) -> list[Body]:
    """Set the breakpoints of the source's lines, and say where each is."""
    places = [room.places.first_from(line) for line in room.breakpoints.lines]
    numbers = room.breakpoints.put(LINES, [place[1] for place in places if place])
    return [
        {"verified": False, "line": line, "message": "no word from this line on"}
        if place is None
        else {
            "id": numbers[place[1]],
            "verified": True,
            "line": place[0],
            "source": room.places.source,
            "instructionReference": memory.reference(place[1]),
        }
        for line, place in zip(room.breakpoints.lines, places, strict=True)
    ]


def set_functions(room: Debuggee, arguments: Body) -> Body:
    return _set(room, ADDRESSES, [point["name"] for point in arguments["breakpoints"]], room.monitor.address)


def set_instructions(room: Debuggee, arguments: Body) -> Body:
    asked = [(point["instructionReference"], point.get("offset") or 0) for point in arguments["breakpoints"]]
    return _set(room, INSTRUCTIONS, asked, lambda place: memory.place(*place))


def set_data(room: Debuggee, arguments: Body) -> Body:
    return _set(room, DATA, [point["dataId"] for point in arguments["breakpoints"]], room.monitor.address)


def _set(room: Debuggee, kind: str, asked: list[_Asked], find: Callable[[_Asked], int]) -> Body:
    found: list[int | WorkError] = []
    for each in asked:
        try:
            found.append(find(each))
        except WorkError as error:
            found.append(error)
    numbers = room.breakpoints.put(kind, [place for place in found if isinstance(place, int)])
    return {
        "breakpoints": [
            {"id": numbers[place], "verified": True, "instructionReference": memory.reference(place)}
            if isinstance(place, int)
            else {"verified": False, "message": str(place)}
            for place in found
        ]
    }


def data_info(room: Debuggee, arguments: Body) -> Body:
    """Say whether a word can be watched: that of a symbol or an address."""
    name, scope = arguments["name"], arguments.get("variablesReference") or SYMBOLS
    try:
        address = room.monitor.address(name) if scope == SYMBOLS else None
    except WorkError as error:
        return {"dataId": None, "description": str(error)}
    if address is None:
        return {"dataId": None, "description": f"{name}: words of core alone are watched"}
    return {"dataId": f"{address:04o}", "description": f"{name}, {address:04o}", "accessTypes": ["write"]}


STOPS: Mapping[str, Callable[[Debuggee, Body], Body]] = {
    "setBreakpoints": set_lines,
    "setFunctionBreakpoints": set_functions,
    "setInstructionBreakpoints": set_instructions,
    "setDataBreakpoints": set_data,
    "dataBreakpointInfo": data_info,
    "setExceptionBreakpoints": lambda room, arguments: {},
}
