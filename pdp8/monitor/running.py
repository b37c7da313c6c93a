"""Commands that let the machine run: for a time, until a text is on the page, until it ends.

    expect "PROCEED." 60     until the page shows it, what was printed since the last `expect` included
    run until BEL            until it is printed from now on;  until "04" 3 times 60
    assert AC 0              fails, and ends a script with status 1, where it is not so

Times are the machine's. The run stops at most a twentieth of a second after what it waits for.
"""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from pdp8 import shelf
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.hardware.teletype import printed
from pdp8.computer.stop import Reason, Stop
from pdp8.monitor.arguments import LONGEST, MonitorError, Quoted, seconds, some
from pdp8.monitor.debugging import is_register, register, value
from pdp8.monitor.prompt import Monitor
from tapes.quantities import counted

_SLICE = 0.5
GLANCE = 0.05
"""Seconds between two looks at what the machine does."""
_DEFAULT = 60.0
_LAST_LINES = 3
_LAST = 216
"""Lines and characters of the page that are shown where a text was not printed."""
_CODES = {"BEL": "\a", "CR": "\r", "LF": "\n", "FF": "\f", "RUBOUT": "\x7f"}


class Goal(NamedTuple):
    """How long to run: at most `seconds`; until `text` has been printed so many `times`, if any."""

    seconds: float = LONGEST
    text: str = ""
    times: int = 0


def go(monitor: Monitor, *arguments: str) -> None:
    """START, at an address if one is given, and run: for SECONDS, or until a text is printed."""
    address = None
    if arguments and arguments[0] != "until":
        address = monitor.address(arguments[0])
        arguments = arguments[1:]
    goal = goal_of(arguments)
    monitor.operator.press("stop")
    if address is not None:
        monitor.machine.pc = address
    _begin(monitor, "start", goal)


def cont(monitor: Monitor, *arguments: str) -> None:
    """CONT: go on, for SECONDS or until a text is printed."""
    goal = goal_of(arguments)
    if monitor.machine.panel.lamps.run:
        _pursue(monitor, goal)
    else:
        _begin(monitor, "cont", goal)


def run(monitor: Monitor, *arguments: str) -> None:
    """Go on without a key being pressed, for SECONDS or until a text is printed; from a halt START, at A."""
    if monitor.machine.panel.lamps.run or arguments[:1] == ("until",):
        _pursue(monitor, goal_of(arguments))
    else:
        go(monitor, *arguments)


def until(monitor: Monitor, *arguments: str) -> None:
    """Go on until TEXT, or BEL, is printed from now on, N times if given; fail after SECONDS (60)."""
    _pursue(monitor, goal_of(("until", *arguments)))


def expect(monitor: Monitor, *arguments: str) -> None:
    """Go on until the page shows TEXT after the last command, or with --from-start after the last expect."""
    if arguments[-1:] == ("--from-start",):
        monitor.expected = monitor.matched
        arguments = arguments[:-1]
    text, *rest = some(some(arguments, "a text"), "a text and seconds", 1, 2)
    _wait_for(monitor, Goal(seconds(rest[0]) if rest else _DEFAULT, text_of(text), 1))


def goal_of(arguments: Sequence[str]) -> Goal:
    """Return the goal of [SECONDS] or until TEXT [N times] [SECONDS]. Raises MonitorError."""
    if arguments[:1] != ("until",):
        some(arguments, "seconds, or until TEXT,", 0, 1)
        return Goal(seconds(arguments[0])) if arguments else Goal()
    text, *rest = some(arguments[1:], "a text, or BEL,")
    times = 1
    if rest[1:2] in (["times"], ["time"]):
        if not rest[0].isdecimal() or not int(rest[0]):
            raise MonitorError(f"{rest[0]}: how many times, a decimal number from 1")
        times = int(rest[0])
        rest = rest[2:]
    some(rest, 'a text, a count and "times", seconds', 0, 1)
    return Goal(seconds(rest[0]) if rest else _DEFAULT, text_of(text), times)


def text_of(word: str) -> str:
    """Return the wanted text: a word, a quoted text, or a code's name."""
    text = word if isinstance(word, Quoted) else _CODES.get(word.upper(), word)
    if not text:
        raise MonitorError("a text expected, not an empty one")
    return text


def _begin(monitor: Monitor, key: str, goal: Goal) -> None:
    """Press START or CONT and run to `goal`; under SING STEP the key runs one cycle."""
    monitor.operator.press(key)
    machine = monitor.machine
    if machine.panel.sing_step and not goal.times:
        monitor.say_where(Reason.PROTECT if machine.panel.lamps.protect else Reason.STOP_KEY)
    else:
        _pursue(monitor, goal)


def _pursue(monitor: Monitor, goal: Goal) -> None:
    """Run to `goal`; report how the run ended if no text ended it."""
    if goal.times:
        monitor.expected = len(monitor.machine.teletype.printer.frames)
    while monitor.once_running:  # keys of `send`
        monitor.once_running.pop(0)()
    if goal.times:
        _wait_for(monitor, goal)
        times = f" {counted(goal.times, 'times')}" if goal.times > 1 else ""
        monitor.say(f"{_named(goal.text)}{times}; {monitor.machine.elapsed:,.2f} s")
        return
    if monitor.live is not None:
        stop = monitor.live(goal.seconds)
    else:
        *_, stop = slices(monitor, goal.seconds)
    monitor.say_stop(stop)


def _wait_for(monitor: Monitor, goal: Goal) -> None:
    """Run until the text has been printed so often since `monitor.expected`. Raises MonitorError."""
    left = goal.times - _passed(monitor, goal.text, goal.times)
    why = "the machine is stopped"
    if left and monitor.machine.panel.lamps.run:
        for stop in slices(monitor, goal.seconds, GLANCE):
            why = f"{goal.seconds:g} s have passed" if stop.reason is Reason.LIMIT else str(stop.reason)
            left -= _passed(monitor, goal.text, left)
            if not left:
                break
    if left:
        raise MonitorError(_failure(monitor, goal, left, why))


def _passed(monitor: Monitor, text: str, most: int) -> int:
    """Move past the text in the page since `monitor.expected`, at most `most` times; return how often."""
    page = bytes(frame & 0o177 for frame in monitor.machine.teletype.printer.frames[monitor.expected :])
    *passed, rest = page.split(bytes(ord(character) & 0o177 for character in text), most)
    monitor.expected += len(page) - len(rest)
    if passed:
        monitor.matched = monitor.expected
    return len(passed)


def _failure(monitor: Monitor, goal: Goal, left: int, why: str) -> str:
    page = printed(bytes(monitor.machine.teletype.printer.frames)).decode().replace("\r", "").strip("\n")
    shown = "\n".join(page.split("\n")[-_LAST_LINES:])[-_LAST:]
    of = f" {counted(goal.times - left, 'times')} of {goal.times}" if goal.times > 1 else ""
    return f"{_named(goal.text)} was {'' if of else 'not '}printed{of}: {why}; the page shows {shown!r}"


def _named(text: str) -> str:
    shown = re.sub(r"\\uf7(..)", lambda code: f"\\{int(code[1], 16):o}", repr(str(text)))
    return next((name for name, code in _CODES.items() if code == text), shown)


def slices(monitor: Monitor, limit: float, longest: float = _SLICE) -> Iterator[Stop]:
    """Run for `limit` seconds at most, in slices; change tapes, and press STOP when `monitor.stopping`."""
    machine = monitor.machine
    end = machine.ticks + round(limit * TICKS_PER_SECOND)
    while True:
        for stop in machine.slices((end - machine.ticks) / TICKS_PER_SECOND, GLANCE, longest):
            if stop.reason is Reason.TAPE_OUT and next_tape(monitor):
                break
            yield stop
            if monitor.stopping:
                machine.stop()
        else:
            return


def next_tape(monitor: Monitor) -> bool:
    """Put the next tape into the reader that has run out; return whether there is one."""
    if not monitor.waiting_tapes:
        return False
    name, *more = monitor.waiting_tapes
    monitor.operator.mount(name, shelf.read(name))
    monitor.waiting_tapes = more
    monitor.say(f"{name} goes into the reader")
    return True


def wait(monitor: Monitor, time: str) -> None:
    """Let time pass: the program runs on if RUN is lit, else the Teletype ends what it has begun."""
    machine = monitor.machine
    end = machine.ticks + round(seconds(time) * TICKS_PER_SECOND)
    if machine.panel.lamps.run:
        *_, stop = slices(monitor, seconds(time))
        if stop.reason is Reason.BREAKPOINT:
            monitor.say_stop(stop)
            return
    if not monitor.stopping:
        machine.wait(max(0, end - machine.ticks) / TICKS_PER_SECOND)


def assert_(monitor: Monitor, name: str, word: str) -> None:
    """Fail unless a register, or the word at an address, is so."""
    wanted = monitor.address(word) if register(name) in ("pc", "ma") else monitor.word(word)
    if is_register(monitor, name):
        found = value(monitor.machine, name)
    else:
        found = monitor.machine.core[monitor.address(name)]
    if found != wanted:
        raise MonitorError(f"{name.upper()} is {found:04o}, not {wanted:04o}")
