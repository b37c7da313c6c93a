"""A debugger's session with one editor: what it asks for, and what it is told.

    initialize ─► launch ─► initialized ─► breakpoints ─► configurationDone ─► runs, stopped, runs, ...
    ... ─► terminate ─► terminated, exited ─► disconnect

One machine is one thread. While it runs, requests are answered between two slices of the run.
"""

from collections.abc import Callable, Mapping

from pdp8.dap import motion
from pdp8.dap.answers import ANSWERS
from pdp8.dap.breakpoints import Breakpoints
from pdp8.dap.debuggee import Debuggee, Halt
from pdp8.dap.launch import Launch
from pdp8.dap.stops import STOPS, place_lines
from pdp8.dap.wire import NOTHING, Body, Wire
from tapes.errors import WorkError

_THREAD = 1
_CAPABILITIES = (
    "supportsConfigurationDoneRequest",
    "supportsFunctionBreakpoints",
    "supportsInstructionBreakpoints",
    "supportsDataBreakpoints",
    "supportsEvaluateForHovers",
    "supportsStepBack",
    "supportsSetVariable",
    "supportsRestartRequest",
    "supportsTerminateRequest",
    "supportsReadMemoryRequest",
    "supportsWriteMemoryRequest",
    "supportsDisassembleRequest",
)


class SessionError(WorkError):
    """A request that cannot be carried out now, or at all."""


class Session:
    """One editor at a machine, from `initialize` to `disconnect`."""

    def __init__(self, wire: Wire) -> None:
        self._wire = wire
        self._room: Debuggee | None = None
        self._breakpoints = Breakpoints()
        self._first_line = 1
        self._runs = self._ended = False
        """Whether the editor was told that the machine runs; whether it has left."""
        self._waits = ""
        """What was said of the program's waiting in this run."""
        self._after: list[Callable[[], object]] = []
        """What comes after the response."""
        self._requests: Mapping[str, Callable[[Body], Body | None]] = {
            "initialize": self._initialize,
            "launch": self._launch,
            "configurationDone": self._begin,
            "restart": self._restart,
            "terminate": self._terminate,
            "disconnect": self._disconnect,
            "threads": lambda arguments: {"threads": [{"id": _THREAD, "name": "PDP-8/L"}]},
            "continue": self._continue,
            "next": lambda arguments: self._moved(self._standing.over()),
            "stepIn": lambda arguments: self._moved(self._standing.into()),
            "stepOut": self._step_out,
            "stepBack": lambda arguments: self._moved(self._standing.back()),
            "reverseContinue": lambda arguments: self._moved(self._standing.back_to()),
            "pause": self._pause,
        }
        wire.heard = self._heard

    def serve(self) -> None:
        """Answer until the editor leaves. Raises WireError for what is no message, ShelfError for a punch."""
        while not self._ended:
            message = self._wire.receive(wait=not (self._runs and self._loaded.advances))
            if message is None:
                self._ended = True
            elif message is not NOTHING:
                self._answer(message)
            else:
                self._advance()
        if self._room is not None:
            self._room.take_off()

    def _heard(self, message: Body) -> None:
        """Press STOP for a command of the monitor that runs: the editor is answered only after it."""
        if message.get("command") == "pause" and self._room is not None:
            self._room.monitor.stopping = True

    def _answer(self, message: Body) -> None:
        """Carry out a request, respond to it, and say what came of it."""
        name = message.get("command")
        self._after = []
        try:
            if message.get("type") != "request" or not isinstance(name, str):
                raise SessionError(f"a request was expected, not {message.get('type')!r} {name!r}")
            body = self._body(name, message.get("arguments") or {})
        except WorkError as error:
            self._wire.respond(message, error=str(error))
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            self._wire.respond(message, error=f"{name}: arguments that the protocol does not have: {error!r}")
        else:
            self._wire.respond(message, body)
        for action in self._after:
            action()
        if self._room is not None:
            self._tell(self._room)
        if self._runs:
            self._loaded.go_on()

    def _body(self, name: str, arguments: Body) -> Body | None:
        if name in self._requests:
            return self._requests[name](arguments)
        asked = STOPS.get(name) or ANSWERS.get(name)
        if asked is None:
            raise SessionError(f"{name}: this debugger has no such request")
        room = self._loaded
        moment = room.moment
        body = asked(room, arguments)
        if room.monitor.finished:
            self._after.append(self._finish)
        elif room.moment != moment:  # a command of the monitor has moved the machine
            halt = room.stands()
            if not self._runs or halt.breakpoints:
                self._after.append(lambda: self._stopped(halt))
        return body

    @property
    def _loaded(self) -> Debuggee:
        if self._room is None:
            raise SessionError("no program is loaded: launch comes first")
        return self._room

    @property
    def _standing(self) -> Debuggee:
        if self._runs:
            raise SessionError("the machine runs: pause comes first")
        return self._loaded

    def _initialize(self, arguments: Body) -> Body:
        self._first_line = int(arguments.get("linesStartAt1", True))
        return dict.fromkeys(_CAPABILITIES, True)

    def _launch(self, arguments: Body) -> None:
        self._room = Debuggee(Launch.of(arguments), self._breakpoints, self._first_line)
        self._after.append(lambda: self._wire.event("initialized"))

    def _begin(self, arguments: Body) -> None:
        room = self._loaded
        if room.launch.stopOnEntry and not room.launch.noDebug:
            self._moved(Halt("entry"))
        else:
            self._run(room)

    def _restart(self, arguments: Body) -> None:
        launch = Launch.of(arguments["arguments"]) if arguments.get("arguments") else self._loaded.launch
        self._room = Debuggee(launch, self._breakpoints, self._first_line)
        place_lines(self._room)
        self._begin(arguments)

    def _terminate(self, arguments: Body) -> None:
        self._after.append(self._finish)

    def _finish(self) -> None:
        self._runs = False
        if self._room is not None:
            self._take_off(self._room)
            self._tell(self._room)
        self._wire.event("exited", exitCode=0)
        self._wire.event("terminated")

    def _disconnect(self, arguments: Body) -> None:
        self._runs, self._ended = False, True

    def _continue(self, arguments: Body) -> Body:
        self._run(self._standing)
        return {"allThreadsContinued": True}

    def _step_out(self, arguments: Body) -> None:
        room = self._standing
        self._run(room, motion.out(room.monitor.machine))

    def _pause(self, arguments: Body) -> None:
        if self._runs:
            self._moved(Halt("pause"))

    def _run(self, room: Debuggee, goal: motion.Goal | None = None) -> None:
        self._runs, self._waits = True, ""
        room.run(goal)

    def _moved(self, halt: Halt | None) -> None:
        """Tell, after the response, where the machine stands; it runs on if there is nothing to tell."""
        if halt is None:
            self._runs, self._waits = True, ""
        else:
            self._after.append(lambda: self._stopped(halt))

    def _advance(self) -> None:
        """Let the machine run on for a slice."""
        room = self._loaded
        halt = room.advance()
        self._tell(room)
        if halt is not None and halt.reason:
            self._stopped(halt)
        elif halt is not None and halt.description != self._waits:
            self._waits = halt.description
            self._wire.event("output", category="console", output=f"{halt.description}\n")

    def _stopped(self, halt: Halt) -> None:
        room = self._loaded
        self._runs = False
        room.pause()
        self._take_off(room)
        self._tell(room)
        if halt.description:
            self._wire.event("output", category="console", output=f"{halt.description}\n")
        if room.launch.noDebug:
            self._finish()
            return
        more: Body = {"hitBreakpointIds": list(halt.breakpoints)} if halt.breakpoints else {}
        if halt.description:
            more["description"] = more["text"] = halt.description
        self._wire.event("stopped", reason=halt.reason, threadId=_THREAD, allThreadsStopped=True, **more)

    def _tell(self, room: Debuggee) -> None:
        """Show what was printed, and what the monitor says."""
        for category, text in (("console", room.notes()), ("stdout", room.typed())):
            if text:
                self._wire.event("output", category=category, output=text)

    def _take_off(self, room: Debuggee) -> None:
        try:
            room.take_off()
        except WorkError as error:
            self._wire.event("output", category="stderr", output=f"{error}\n")
