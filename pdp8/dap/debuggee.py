"""The machine at its monitor, where it is to stop, and what of its output the editor has not seen yet.

run(goal) ──► advance, advance, ... ──► Halt(why)
              a slice of the run each, so that the editor is heard in between
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from pdp8 import shelf
from pdp8.computer.hardware.teletype import printed
from pdp8.computer.past import rewind
from pdp8.computer.past.history import HistoryError
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.use.ending import ended
from pdp8.computer.watch import Watch
from pdp8.dap import motion
from pdp8.dap.breakpoints import DATA, Breakpoints, Point, reached
from pdp8.dap.launch import Launch
from pdp8.dap.places import Places
from pdp8.fitting import fault
from pdp8.monitor.arguments import LONGEST
from pdp8.monitor.running import slices

_WAITS = (Reason.TAPE_OUT, Reason.IDLE)
_STANDS = (Reason.HALT, Reason.PROTECT)


class Halt(NamedTuple):
    """Why a machine halted: the protocol's reason, "" if it awaits a key or tape; a sentence; breakpoints."""

    reason: str
    description: str = ""
    breakpoints: tuple[int, ...] = ()


_OWN = Halt("breakpoint", "at break or watch of the console")


def _at(points: Sequence[Point]) -> Halt:
    """Return the stop at breakpoints."""
    return Halt(points[0].kind, "", tuple(point.number for point in points))


class Debuggee:
    """A machine prepared by a configuration."""

    def __init__(self, launch: Launch, breakpoints: Breakpoints, first: tuple[int, int] = (1, 1)) -> None:
        self.launch = launch
        self.breakpoints = breakpoints
        self.said: list[str] = []
        """What the monitor has said since this was last emptied."""
        self.monitor, program = launch.ready(self.said.append)
        notes = (*program.notes, *program.notes_on(self.monitor.machine.pc, "start of launch.json"))
        self.said += [f"{program.name}: {note}" for note in notes]
        self.places = Places(program, *first)
        self._shown = 0
        self._punched = b""
        self._goal: motion.Goal | None = None
        self._put: tuple[set[int], set[int]] = set(), set()
        """Where the editor lets a run stop, and after which words are written."""
        self._own = self._put
        """Where `break` and `watch` of the monitor do."""
        self._slices: Iterator[Stop] | None = None

    @property
    def advances(self) -> bool:
        """Whether there is more to run: not so if the machine runs and only waits."""
        return self._slices is not None

    @property
    def knows_source(self) -> bool:
        """Whether the program in core is still the one that was loaded first."""
        return self.monitor.listing is self.places.listing

    @property
    def moment(self) -> tuple[int, int]:
        """A value that changes whenever the machine has done something."""
        return self.monitor.machine.processor.clock, self.monitor.machine.instructions

    def run(self, goal: motion.Goal | None = None) -> None:
        """Let the machine run from now on until `goal`."""
        self._goal = goal
        self.go_on()

    def go_on(self) -> None:
        """Continue the run after a request that may have changed something."""
        self.put_points()
        self._slices = slices(self.monitor, LONGEST)

    def put_points(self) -> Watch:
        """Let a run stop where the editor says, and where the monitor's commands did; return its watch."""
        machine, watch = self.monitor.machine, self.monitor.machine.watch
        self._own = watch.breakpoints - self._put[0], watch.writes - self._put[1]
        points = Breakpoints() if self.launch.noDebug else self.breakpoints
        goal = self._goal.places(machine) if self._goal else set()
        points.put_into(watch)
        watch.breakpoints |= goal
        self._put = set(watch.breakpoints), set(watch.writes)
        watch.breakpoints |= self._own[0]
        watch.writes |= self._own[1]
        return watch

    def pause(self) -> None:
        self._slices = self._goal = None

    def advance(self) -> Halt | None:
        """Run a slice; return why the machine stopped, if it did."""
        assert self._slices is not None
        try:
            stop = next(self._slices)
        except Exception as error:
            if not (said := fault(error)):
                raise
            return Halt("exception", said)
        return None if stop.reason is Reason.LIMIT else self._halted(stop)

    def over(self) -> Halt | None:
        """Do one instruction; if that is a call the machine runs to its return, or to a breakpoint."""
        self.put_points()
        stop, goal = motion.over(self.monitor.machine)
        if stop.reason in _STANDS or goal is None:
            return self._stepped(stop)
        if halt := self._at_a_breakpoint():
            return halt
        if goal.reached(self.monitor.machine) and not goal.interrupt:
            return Halt("step")
        self.run(goal)
        return None

    def into(self) -> Halt | None:
        return self._stepped(motion.into(self.monitor.machine))

    def _stepped(self, stop: Stop) -> Halt | None:
        return self._halted(stop) if stop.reason in _STANDS else Halt("step")

    def back(self) -> Halt:
        """Undo one instruction. Raises HistoryError."""
        history = self.monitor.history
        if history.instructions == 0:
            raise HistoryError("nothing to undo: here the history begins")
        rewind.instructions(history, 1)
        self.monitor.went_back()
        return Halt("step")

    def back_to(self, look: motion.Look) -> Halt:
        """Undo as far as the last breakpoint, else all; `look` as in rewind.until_stopped."""
        points, machine = self.breakpoints, self.monitor.machine

        def stops(of_words: bool) -> bool:
            if self._own[1] & machine.watch.written if of_words else self._own[0] & reached(machine):
                return True
            return any((point.kind == DATA) == of_words for point in points.stopped(machine))

        stopped = motion.back_to(self.monitor.history, self.put_points(), stops, look)
        self.monitor.went_back()
        if not stopped:
            return Halt("entry", "here the history begins")
        code = [point for point in points.stopped(machine) if point.kind != DATA]
        if self._own[0] & reached(machine) and not code:
            return _OWN
        return _at(code) if code else Halt(DATA)

    def stands(self) -> Halt:
        """Return why the machine is stopped: a breakpoint, HLT or a pause."""
        machine = self.monitor.machine
        points = self.breakpoints.hit(machine)
        if points:
            return _at(points)
        if not machine.panel.lamps.run and not machine.panel.sing_step:
            return Halt(str(Reason.HALT), f"the machine is stopped; next is {machine.pc:04o}")
        return Halt("pause")

    def _halted(self, stop: Stop) -> Halt | None:
        self._slices = None
        machine = self.monitor.machine
        if stop.reason is Reason.BREAKPOINT:
            if halt := self._at_a_breakpoint():
                return halt
            if self._goal is not None and self._goal.reached(machine):
                return self.over() if self._goal.interrupt else Halt("step")
            self.go_on()
            return None
        stop = self.monitor.explained(stop)
        description = ended(stop, machine)
        self.said += self.monitor.sentences(stop)
        if stop.reason in _WAITS and not (self.launch.noDebug and stop.reason is Reason.TAPE_OUT):
            return Halt("", description)
        return Halt("exception" if stop.reason is Reason.PROTECT else str(stop.reason), description)

    def _at_a_breakpoint(self) -> Halt | None:
        """Return the stop where a run has come to a breakpoint that stops it."""
        machine = self.monitor.machine
        if self.launch.noDebug:
            return None
        points = self.breakpoints.hit(machine)
        if found := [point for point in points if point.stops(machine.instructions, self.said)]:
            return _at(found)
        if self._own[0] & reached(machine) or self._own[1] & machine.watch.written:
            return _OWN
        return None

    def sources_changed(self) -> None:
        """Say which sources were written since the program was loaded: lines may not fit any more."""
        for path in self.places.changed():
            self.said.append(f"{path} was changed: restart to run what it says now")

    def notes(self) -> str:
        """Return what the monitor has said since the last time."""
        said = "".join(f"{line}\n" for line in self.said)
        self.said.clear()
        return said

    def typed(self) -> str:
        """Return what was printed since the last time."""
        frames = self.monitor.machine.teletype.printer.frames
        new = bytes(frames[self._shown :])  # none after going back
        self._shown = len(frames)
        return printed(new).decode().replace("\r", "")

    def take_off(self) -> None:
        """Write the tape in the punch into its file, if the configuration names one. Raises ShelfError."""
        tape = self.monitor.machine.teletype.punch.tape
        if self.launch.punch and tape != self._punched:
            wrote = shelf.leave(self.launch.punch, tape, "tape")
            if not self._punched:  # each stop writes it again
                self.said.append(wrote)
            self._punched = tape
