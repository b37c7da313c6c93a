"""A run at its pace: slice by slice, so that what is punched is seen as it is punched.

Ctrl-C is the STOP key: the run ends with an instruction, whole, and says where. A second ends the process.
"""

import signal
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from types import FrameType

from pdp8.cli.running.feed import Feed
from pdp8.cli.running.outputs import Output, send
from pdp8.cli.shared import command
from pdp8.cli.shared.progress import Bar
from pdp8.computer.hardware.signals import NEVER, TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason, Stop
from tapes.quantities import duration

# Slices of a run in seconds of machine time, the shortest and the longest. A trace tells of a wait once a
# slice: so that it is always the same, its slices are.
_FREE, _REALTIME, _TRACED = (0.05, 60.0), (0.05, 0.05), (1.0, 1.0)
_LOOK = 0.05
"""Seconds between two looks at what is typed, while the program waits for it."""
_FIRST_FRAME = 0.0775
"""Seconds after START: the first frame came .2 ms before, and a program that waits has read it."""
_SILENT = 5.0
"""Seconds of ours without a frame, after which a run at a terminal says where it is."""


class Interrupt:
    """Whether Ctrl-C was pressed."""

    pressed = False


@contextmanager
def ctrl_c(on_press: Callable[[], object] = lambda: None) -> Iterator[Interrupt]:
    """Note the first Ctrl-C as `pressed` and call `on_press`; the second raises KeyboardInterrupt."""
    noted = Interrupt()

    def press(number: int, frame: FrameType | None) -> None:
        if noted.pressed:
            raise KeyboardInterrupt
        noted.pressed = True
        on_press()

    before = signal.getsignal(signal.SIGINT)
    if before is not signal.SIG_IGN:  # as a shell has it for what runs in the background
        signal.signal(signal.SIGINT, press)
    try:
        yield noted
    finally:
        signal.signal(signal.SIGINT, before)


def live(
    machine: Machine,
    max_time: float | None,
    pass_on: Callable[[], object],
    take: Callable[[float], bytes | None],
    realtime: bool = True,
) -> Stop | None:
    """Run with a user at the Teletype; `take` returns the keys that were pressed, or None to end the run."""
    began = time.monotonic() - machine.elapsed
    for stop in machine.slices(max_time, *_REALTIME, through_waits=True):
        pass_on()
        waits = stop.reason in (Reason.TAPE_OUT, Reason.IDLE)
        if stop.reason is not Reason.LIMIT and not waits:
            break
        ahead = machine.elapsed - (time.monotonic() - began) if realtime else 0.0
        frames = take(_LOOK if waits else max(0.0, ahead))
        if frames is None:
            return None
        if waits:
            machine.wait(max(_LOOK, time.monotonic() - began - machine.elapsed if realtime else 0.0))
        machine.teletype.keyboard.press(frames)
    return stop._replace(reason=Reason.LIMIT) if waits else stop  # a program that waits does so to the limit


def run(
    machine: Machine,
    feed: Feed,
    outputs: Sequence[Output],
    max_time: float | None = None,
    realtime: bool = False,
    quiet: bool = False,
) -> Stop | None:
    """Run to the end; return how it ended, None if it was interrupted. What was punched is passed on."""
    reader = machine.teletype.reader
    began = time.monotonic() - machine.elapsed
    last = NEVER if max_time is None else machine.ticks + round(max_time * TICKS_PER_SECOND)
    traced = machine.watch.observer is not None
    shortest, longest = _REALTIME if realtime else _TRACED if traced else _FREE
    silence = _Silence(machine, feed, wanted=not quiet)

    def stop() -> None:
        if traced:  # a second of it takes too long to wait for its end
            machine.stop()

    with Bar("reading tape", len(reader.tape), wanted=not quiet) as bar, ctrl_c(stop) as interrupt:

        def idle() -> bool:
            send(outputs)
            return interrupt.pressed

        feed.idle = idle
        ended: Stop | None = None
        while ended is None or (ended.reason is Reason.TAPE_OUT and feed.announce_next()):
            for now in _slices(machine, last, shortest, longest, () if traced else (_FIRST_FRAME,)):
                ended = now
                send(outputs)
                feed.look(now.reason is Reason.HALT)
                bar.show(reader.position)
                if interrupt.pressed:
                    machine.stop()
                elif now.reason is Reason.LIMIT:
                    silence.look()
                    if realtime:
                        time.sleep(max(0.0, machine.elapsed - (time.monotonic() - began)))
            if interrupt.pressed and ended and ended.reason in (Reason.STOP_KEY, Reason.TAPE_OUT):
                return None
        return ended


def _slices(
    machine: Machine, last: int, shortest: float, longest: float, first: Iterable[float]
) -> Iterator[Stop]:
    """Yield the machine's state after each slice until tick `last`; the first take `first` seconds."""
    for seconds in first:
        for now in machine.slices(min(seconds, (last - machine.ticks) / TICKS_PER_SECOND)):
            yield now
        if now.reason is not Reason.LIMIT or machine.ticks >= last:
            return
    yield from machine.slices((last - machine.ticks) / TICKS_PER_SECOND, shortest, longest)


class _Silence:
    """Says once, at a terminal, where a run is that reads and punches nothing, and how to end it."""

    def __init__(self, machine: Machine, feed: Feed, wanted: bool) -> None:
        self._machine = machine
        self._feed = feed
        self._wanted = wanted and sys.stderr.isatty()
        self._frames = -1
        self._since = 0.0

    def look(self) -> None:
        """Look whether a frame was read or punched since the last time."""
        if not self._wanted:
            return
        machine = self._machine
        frames = self._feed.read + len(machine.teletype.punch.frames)
        if machine.highspeed.fitted:
            frames += machine.highspeed.reader.position + len(machine.highspeed.punch.frames)
        now = time.monotonic()
        if frames != self._frames:
            self._frames, self._since = frames, now
        elif now > self._since + _SILENT:
            self._wanted = False
            command.say(
                f"at {machine.pc:04o} after {duration(machine.elapsed)} of machine time, and nothing is read "
                "or punched; Ctrl-C ends the run, --max-time SECONDS limits one"
            )
