"""What the editor asks about breakpoints: request by request.

A breakpoint at a line without a word goes to the next that has one. One at an address is a function
breakpoint to the editor: its name is an octal address or a symbol. A data breakpoint stops after a word was
written.
"""

from collections.abc import Callable

from pdp8.dap.breakpoints import ADDRESSES, DATA, INSTRUCTIONS, LINES
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.places import place, reference
from pdp8.dap.scopes import SYMBOLS
from pdp8.dap.wire import Body
from tapes.errors import WorkError


def set_lines(room: Debuggee, arguments: Body) -> Body:
    """Set the breakpoints of a source, in place of those before."""
    asked = [point["line"] for point in arguments.get("breakpoints") or ()]
    if not room.places.is_of(arguments["source"]):
        why = f"the program that runs is {room.places.source['name']}"
        return {"breakpoints": [{"verified": False, "line": line, "message": why} for line in asked]}
    room.breakpoints.lines = asked
    return place_lines(room)


def place_lines(room: Debuggee) -> Body:
    """Set the breakpoints of the source's lines, and say where each is."""
    found = [(line, room.places.first_from(line)) for line in room.breakpoints.lines]
    numbers = room.breakpoints.put(LINES, [place[0] for _, place in found if place])
    return {
        "breakpoints": [
            {**_verified(numbers, place[0]), "line": place[1], "source": room.places.source}
            if place
            else {"verified": False, "line": line, "message": "no word from this line on"}
            for line, place in found
        ]
    }


def set_functions(room: Debuggee, arguments: Body) -> Body:
    return _set(room, ADDRESSES, arguments, lambda point: room.monitor.address(point["name"]))


def set_instructions(room: Debuggee, arguments: Body) -> Body:
    def find(point: Body) -> int:
        return place(point["instructionReference"], point.get("offset") or 0)

    return _set(room, INSTRUCTIONS, arguments, find)


def set_data(room: Debuggee, arguments: Body) -> Body:
    return _set(room, DATA, arguments, lambda point: room.monitor.address(point["dataId"]))


def _set(room: Debuggee, kind: str, arguments: Body, find: Callable[[Body], int]) -> Body:
    found: list[int | WorkError] = []
    for point in arguments["breakpoints"]:
        try:
            found.append(find(point))
        except WorkError as error:
            found.append(error)
    numbers = room.breakpoints.put(kind, [place for place in found if isinstance(place, int)])
    return {
        "breakpoints": [
            _verified(numbers, place)
            if isinstance(place, int)
            else {"verified": False, "message": str(place)}
            for place in found
        ]
    }


def _verified(numbers: dict[int, int], address: int) -> Body:
    return {"id": numbers[address], "verified": True, "instructionReference": reference(address)}


def data_info(room: Debuggee, arguments: Body) -> Body:
    """Say whether a word can be watched: that of a symbol or an address."""
    name, scope = arguments["name"], arguments.get("variablesReference") or SYMBOLS
    try:
        if scope != SYMBOLS:
            raise WorkError(f"{name}: words of core alone are watched")
        address = room.monitor.address(name)
    except WorkError as error:
        return {"dataId": None, "description": str(error)}
    return {"dataId": f"{address:04o}", "description": f"{name}, {address:04o}", "accessTypes": ["write"]}
