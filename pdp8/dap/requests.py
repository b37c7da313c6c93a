"""What an editor may send with a request: the type of each argument by its name, and which a request needs.

The protocol uses one type for a name wherever it is; a name that is not here is passed over.
"""

from typing import Any

from pdp8.dap.wire import Body
from tapes.errors import WorkError

_NUMBERS = (
    "line startFrame levels variablesReference count offset instructionOffset instructionCount column "
    "threadId targetId sourceReference"
)
_TEXTS = (
    "name expression value context memoryReference data dataId path text instructionReference condition "
    "hitCondition logMessage accessType"
)
_SWITCHES = "linesStartAt1 columnsStartAt1 supportsProgressReporting"
_KINDS = ((_NUMBERS, int), (_TEXTS, str), (_SWITCHES, bool), ("source", dict))
_TYPES: dict[str, type] = {name: kind for names, kind in _KINDS for name in names.split()}
_NEEDED = {
    "setBreakpoints": ("source",),
    "setFunctionBreakpoints": ("breakpoints",),
    "setInstructionBreakpoints": ("breakpoints",),
    "setDataBreakpoints": ("breakpoints",),
    "dataBreakpointInfo": ("name",),
    "variables": ("variablesReference",),
    "setVariable": ("variablesReference", "name", "value"),
    "setExpression": ("expression", "value"),
    "evaluate": ("expression",),
    "completions": ("text", "column"),
    "readMemory": ("memoryReference", "count"),
    "writeMemory": ("memoryReference", "data"),
    "disassemble": ("memoryReference", "instructionCount"),
    "gotoTargets": ("source", "line"),
    "goto": ("targetId",),
}
_OF_EACH = {
    "setBreakpoints": "line",
    "setFunctionBreakpoints": "name",
    "setInstructionBreakpoints": "instructionReference",
    "setDataBreakpoints": "dataId",
}
"""What each of the breakpoints needs."""


def checked(request: str, arguments: Any) -> Body:
    """Return the arguments of a request. Raises WorkError for what the protocol does not have."""
    found = _object(request, {} if arguments is None else arguments)
    for name in _NEEDED.get(request, ()):
        if name not in found:
            raise WorkError(f"{request}: {name} is missing")
    if request in _OF_EACH and found.get("breakpoints") is not None:
        if not isinstance(found["breakpoints"], list):
            raise WorkError(f"{request}: breakpoints: a list expected, not {found['breakpoints']!r}")
        for each in found["breakpoints"]:
            if _OF_EACH[request] not in _object(f"{request}: breakpoints", each):
                raise WorkError(f"{request}: a breakpoint has no {_OF_EACH[request]}")
    return found


def _object(where: str, given: Any) -> Body:
    if not isinstance(given, dict):
        raise WorkError(f"{where}: an object expected, not {given!r}")
    for name, value in given.items():
        wanted = _TYPES.get(name)
        if wanted is dict:
            _object(f"{where}: {name}", value)
        elif wanted is not None and value is not None and type(value) is not wanted:
            raise WorkError(f"{where}: {name}: {_CALLED[wanted]} expected, not {value!r}")
    return given


_CALLED = {int: "a whole number", str: "a text", bool: "true or false"}
