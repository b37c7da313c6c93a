"""A debugger's session with one editor: what it asks for, and what it is told.

    initialize ─► launch ─► initialized ─► breakpoints ─► configurationDone ─► runs, stopped, runs, ...
    ... ─► terminate ─► terminated, exited ─► disconnect

One machine is one thread. While it runs, requests are answered between two slices of the run.
"""

from collections.abc import Callable, Mapping
from functools import partial
from time import monotonic
from traceback import format_exc
from typing import BinaryIO

from pdp8.dap import memory, motion, scopes
from pdp8.dap.breakpoints import ADDRESSES, DATA, INSTRUCTIONS, Breakpoints
from pdp8.dap.debuggee import Debuggee, Halt
from pdp8.dap.launch import Launch
from pdp8.dap.requests import checked
from pdp8.dap.wire import Body, MessageError, Wire
from pdp8.fitting import fault
from pdp8.monitor import simh
from tapes.errors import WorkError

_THREAD = 1
_BACK = "back"
_PROGRESS = 0.5
"""Seconds between two events that tell how far something is."""
_CAPABILITIES = (
    "supportsConfigurationDoneRequest supportsFunctionBreakpoints supportsInstructionBreakpoints "
    "supportsDataBreakpoints supportsEvaluateForHovers supportsStepBack supportsSetVariable "
    "supportsRestartRequest supportsTerminateRequest supportsReadMemoryRequest "
    "supportsWriteMemoryRequest supportsDisassembleRequest supportsConditionalBreakpoints "
    "supportsHitConditionalBreakpoints supportsLogPoints supportsSetExpression "
    "supportsCompletionsRequest supportsGotoTargetsRequest"
)
_OF_THE_MACHINE: Mapping[str, Callable[[Debuggee, Body], Body]] = {
    "setBreakpoints": scopes.set_lines,
    "setFunctionBreakpoints": scopes.setting(ADDRESSES, "name"),
    "setInstructionBreakpoints": scopes.setting(INSTRUCTIONS, "instructionReference", "offset"),
    "setDataBreakpoints": scopes.setting(DATA, "dataId", "accessType"),
    "dataBreakpointInfo": scopes.data_info,
    "setExceptionBreakpoints": lambda debuggee, arguments: {},
    "stackTrace": scopes.stack_trace,
    "source": scopes.source,
    "scopes": scopes.scopes,
    "variables": scopes.variables,
    "setVariable": scopes.set_variable,
    "evaluate": scopes.evaluate,
    "setExpression": scopes.set_expression,
    "completions": scopes.completions,
    "gotoTargets": scopes.goto_targets,
    "readMemory": memory.read_memory,
    "writeMemory": memory.write_memory,
    "disassemble": memory.disassemble,
}
"""What the editor asks about the machine, whether it runs or is stopped."""


class Session:
    """One editor at a machine, from `initialize` to `disconnect`."""

    def __init__(self, reader: BinaryIO, writer: BinaryIO) -> None:
        self._room: Debuggee | None = None
        self._breakpoints = Breakpoints()
        self._first = 1, 1
        self._runs = self._finished = self._ended = self._works = self._paused = self._reports = False
        """In this order: the editor takes the machine as running; it takes the program as ended; it has left;
        a request is being carried out; the editor asked to pause that one; it shows progress.
        """
        self._waits = ""
        """What was said of the program's waiting in this run."""
        self._after: list[Callable[[], object]] = []
        """What comes after the response."""
        self._requests: Mapping[str, Callable[[Body], Body | None]] = {
            "initialize": self._initialize,
            "launch": self._launch,
            "configurationDone": self._begin,
            "restart": self._restart,
            "terminate": lambda arguments: self._after.append(self._finish),
            "disconnect": self._disconnect,
            "threads": lambda arguments: {"threads": [{"id": _THREAD, "name": "PDP-8/L"}]},
            "continue": self._continue,
            "next": lambda arguments: self._moved(self._standing.over()),
            "stepIn": lambda arguments: self._moved(self._standing.into()),
            "stepOut": self._step_out,
            "stepBack": lambda arguments: self._moved(self._standing.back()),
            "reverseContinue": self._back,
            "goto": self._goto,
            "pause": self._pause,
        }
        self._wire = Wire(reader, writer, self._heard)

    def serve(self) -> None:
        """Answer until the editor leaves. Raises WorkError for a broken stream, ShelfError for a punch."""
        while not self._ended:
            if self._runs and self._loaded.advances and not self._wire.holds:
                self._advance()
            else:
                self._receive()
        if self._room is not None:
            try:
                self._room.take_off()
            finally:
                simh.leave(self._room.monitor)

    def _receive(self) -> None:
        """Answer the next message; one that is not an object is said and passed over."""
        try:
            message = self._wire.receive()
        except MessageError as error:
            self._put_out("stderr", f"{error}; it is passed over\n")
            return
        if message is None:
            self._ended = True
        else:
            self._answer(message)

    def _heard(self, message: Body) -> None:
        """Press STOP if a request is being carried out; the new one is answered afterwards."""
        if message.get("command") == "pause" and self._room is not None and self._works:
            self._room.monitor.stopping = self._paused = True

    def _answer(self, message: Body) -> None:
        """Carry out a request, respond to it, and say what came of it."""
        name = message.get("command")
        self._after = []
        try:
            if message.get("type") != "request" or not isinstance(name, str):
                raise WorkError(f"a request was expected, not {message.get('type')!r} {name!r}")
            self._works, self._paused = True, False
            body = self._body(name, checked(name, message.get("arguments")))
        except WorkError as error:
            self._wire.respond(message, error=str(error))
        except Exception as error:
            said = fault(error)
            ours = f"{name}: a fault of the debugger, please report it: {error!r}"
            self._wire.respond(message, error=said or ours)
            self._put_out("stderr", "" if said else format_exc())
        else:
            self._wire.respond(message, body)
        finally:
            self._works = False
        for action in self._after:
            action()
        if self._room is not None:
            self._tell(self._room)
        if self._runs:
            self._loaded.go_on()

    def _body(self, name: str, arguments: Body) -> Body | None:
        if name in self._requests:
            return self._requests[name](arguments)
        if name not in _OF_THE_MACHINE:
            raise WorkError(f"{name}: this debugger has no such request")
        debuggee = self._loaded
        moment, machine = debuggee.moment, debuggee.monitor.machine
        watch = machine.watch
        watch.written.clear()  # a command may step or go back, unwatched
        watch.read.clear()
        try:
            return _OF_THE_MACHINE[name](debuggee, arguments)
        finally:
            if debuggee.monitor.machine is not machine:  # `restore` and `set cpu` put another one there
                self._place_anew(reloaded=False)
            if debuggee.monitor.finished:
                self._after.append(self._finish)
            elif debuggee.moment != moment:  # a command of the monitor has moved the machine
                halt = debuggee.stands()
                if not self._runs or halt.reason != "pause":
                    self._moved(halt)

    @property
    def _loaded(self) -> Debuggee:
        if self._room is None:
            raise WorkError("no program is loaded: launch comes first")
        return self._room

    @property
    def _standing(self) -> Debuggee:
        if self._runs:
            raise WorkError("the machine runs: pause comes first")
        return self._loaded

    def _initialize(self, arguments: Body) -> Body:
        lines, columns = arguments.get("linesStartAt1"), arguments.get("columnsStartAt1")
        self._first = int(lines is not False), int(columns is not False)
        self._reports = bool(arguments.get("supportsProgressReporting"))
        return dict.fromkeys(_CAPABILITIES.split(), True)

    def _load(self, launch: Launch) -> None:
        made = Debuggee(launch, self._breakpoints, self._first)
        self._leave()
        self._room, self._runs, self._finished = made, False, False
        self._place_anew(reloaded=True)

    def _leave(self) -> None:
        """Save what the machine leaves, if there is one: the tapes in its punches, and its reels."""
        if self._room is not None:
            self._save(self._room.take_off)
            self._save(partial(simh.leave, self._room.monitor))
            self._tell(self._room)

    def _launch(self, arguments: Body) -> None:
        self._load(Launch.of(arguments))
        self._after.append(lambda: self._wire.event("initialized"))

    def _begin(self, arguments: Body) -> None:
        debuggee = self._loaded
        if debuggee.launch.stopOnEntry and not debuggee.launch.noDebug:
            self._moved(Halt("entry"))
        else:
            self._run(debuggee)

    def _restart(self, arguments: Body) -> None:
        given = arguments.get("arguments")
        self._load(Launch.of(given) if given else self._loaded.launch)
        self._begin(arguments)

    def _place_anew(self, reloaded: bool) -> None:
        for moved in self._breakpoints.place_anew(self._loaded.monitor, self._loaded.places, reloaded):
            self._wire.event("breakpoint", reason="changed", breakpoint=moved)

    def _finish(self) -> None:
        self._runs = False
        self._leave()
        if not self._finished:  # an editor may answer `terminated` with another request to terminate
            self._finished = True
            self._wire.event("exited", exitCode=0)
            self._wire.event("terminated")

    def _disconnect(self, arguments: Body) -> None:
        self._runs, self._ended = False, True

    def _continue(self, arguments: Body) -> Body:
        self._run(self._standing)
        return {"allThreadsContinued": True}

    def _step_out(self, arguments: Body) -> None:
        debuggee = self._standing
        self._run(debuggee, motion.out(debuggee.monitor.machine))

    def _back(self, arguments: Body) -> None:
        """Go back to the last breakpoint, telling how far the search has come; a pause ends it."""
        debuggee, shown = self._standing, monotonic()
        began = False

        def look(part: float) -> None:
            nonlocal shown, began
            if self._paused:
                raise WorkError("paused: the machine is where it was")
            if self._reports and monotonic() - shown > _PROGRESS:
                if not began:
                    self._wire.event("progressStart", progressId=_BACK, title="Going back", cancellable=False)
                shown, began = monotonic(), True
                self._wire.event("progressUpdate", progressId=_BACK, percentage=round(100 * part))

        try:
            self._moved(debuggee.back_to(look))
        finally:
            if began:
                self._wire.event("progressEnd", progressId=_BACK)

    def _goto(self, arguments: Body) -> None:
        """Go on from another address: set the PC."""
        debuggee, target = self._standing, arguments["targetId"]
        if not 0 <= target < debuggee.monitor.machine.memory:
            raise WorkError(f"{target:o}: no address of core")
        debuggee.monitor.machine.pc = target
        self._moved(Halt("goto"))

    def _pause(self, arguments: Body) -> None:
        if self._runs:
            self._moved(Halt("pause"))

    def _run(self, debuggee: Debuggee, goal: motion.Goal | None = None) -> None:
        debuggee.run(goal)
        self._moved(None)

    def _moved(self, halt: Halt | None) -> None:
        """Say, after the response, where the machine is stopped; let it run on otherwise."""
        if halt is None:
            self._runs, self._waits = True, ""
        else:
            self._after.append(lambda: self._stopped(halt))

    def _advance(self) -> None:
        """Let the machine run on for a slice."""
        debuggee = self._loaded
        halt = debuggee.advance()
        self._tell(debuggee)
        if halt is not None and halt.reason:
            self._stopped(halt)
        elif halt is not None and halt.description != self._waits:
            self._waits = halt.description
            self._put_out("console", f"{halt.description}\n")

    def _stopped(self, halt: Halt) -> None:
        debuggee = self._loaded
        self._runs = False
        debuggee.pause()
        self._save(debuggee.take_off)
        debuggee.sources_changed()
        self._tell(debuggee)
        self._put_out("console", halt.description and f"{halt.description}\n")
        if debuggee.launch.noDebug:
            self._finish()
            return
        more: Body = {"hitBreakpointIds": list(halt.breakpoints)} if halt.breakpoints else {}
        if halt.description:
            more["description"] = more["text"] = halt.description
        self._wire.event("stopped", reason=halt.reason, threadId=_THREAD, allThreadsStopped=True, **more)

    def _tell(self, debuggee: Debuggee) -> None:
        """Show what was printed, and what the monitor says."""
        self._put_out("console", debuggee.notes())
        self._put_out("stdout", debuggee.typed())

    def _put_out(self, category: str, text: str) -> None:
        if text:
            self._wire.event("output", category=category, output=text)

    def _save(self, leave: Callable[[], object]) -> None:
        try:
            leave()
        except WorkError as error:
            self._put_out("stderr", f"{error}\n")
