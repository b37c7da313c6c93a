"""Every command of the monitor by its name."""

from collections.abc import Callable, Sequence
from difflib import get_close_matches
from textwrap import wrap
from typing import NamedTuple

from pdp8.monitor import hands, keystrokes, past, running, tapes
from pdp8.monitor.arguments import MonitorError, as_it_stands, command, exactly, split
from pdp8.monitor.prompt import Monitor

_SHORT = {"b": "break", "e": "examine", "ex": "examine", "l": "load", "w": "watch"}
"""Names that are the beginning of several and mean one."""


class Command(NamedTuple):
    """A command: its name, what comes after it, and what it does."""

    name: str
    arguments: str
    action: Callable[[Monitor, Sequence[str]], None]
    arguments_of: Callable[[str], Sequence[str]] = split
    """Makes the arguments of what stands after the name."""


def help_(monitor: Monitor, arguments: Sequence[str]) -> None:
    """Say what the monitor knows, or one of its commands."""
    for each in [find(name) for name in arguments] or COMMANDS.values():
        said = f"{each.name + ' ' + each.arguments:27} {each.action.__doc__}"
        for line in wrap(said, 79, subsequent_indent=" " * 28):
            monitor.say(line)


def quit_(monitor: Monitor, arguments: Sequence[str]) -> None:
    """Leave."""
    exactly(arguments, "nothing", 0)
    monitor.finished = True


COMMANDS = {
    each.name: each
    for each in (
        Command("examine", "A | A:B ...", hands.examine),
        Command("deposit", "A WORD ...", hands.deposit),
        Command("set", "NAME WORD", hands.set_),
        Command("registers", "", hands.registers),
        Command("load", "PROGRAM [force]", tapes.load),
        Command("boot", "PROGRAM [force]", tapes.boot),
        Command("listing", "PROGRAM", tapes.listing),
        Command("rim", "", tapes.rim),
        Command("key", "KEY ...", hands.key),
        Command("go", "[A] [SECONDS|until TEXT]", running.go),
        Command("cont", "[SECONDS|until TEXT]", running.cont),
        Command("run", "[SECONDS|until TEXT]", running.run),
        Command("until", "TEXT [N times] [SECONDS]", running.until),
        Command("expect", "TEXT [SECONDS]", running.expect),
        Command("assert", "REGISTER|A WORD", running.assert_),
        Command("wait", "SECONDS", running.wait),
        Command("step", "[N]", hands.step),
        Command("cycle", "[N]", hands.cycle),
        Command("back", "[N] [UNIT] | until A [written|flag]", past.back),
        Command("break", "[A ...]", hands.break_),
        Command("watch", "[A ...]", hands.watch),
        Command("forget", "[A ...]", hands.forget),
        Command("trace", "on|cycles|off", hands.trace),
        Command("count", "[on|off|listing]", hands.count),
        Command("reader", "TAPE ...|start|stop|none", tapes.reader),
        Command("punch", "FILE|on|off", tapes.punch),
        Command("fast-reader", "TAPE", tapes.fast_reader),
        Command("fast-punch", "FILE|on|off", tapes.fast_punch),
        Command("type", "TEXT", keystrokes.type_, as_it_stands),
        Command("keyboard", "[now] TEXT ...", keystrokes.keyboard),
        Command("page", "[more]", tapes.page),
        Command("save", "FILE", tapes.save),
        Command("restore", "FILE", tapes.restore),
        Command("help", "[COMMAND]", help_),
        Command("quit", "", quit_),
        Command("exit", "", quit_),
    )
}


def find(word: str) -> Command:
    """Return the command that `word` names or begins. Raises MonitorError."""
    word = word.lower()
    if word in COMMANDS:
        return COMMANDS[word]
    found = [each for name, each in COMMANDS.items() if name.startswith(word)]
    if word in _SHORT:
        return COMMANDS[_SHORT[word]]
    if len(found) == 1:
        return found[0]
    if found:
        raise MonitorError(f"{word}: {', '.join(each.name for each in found)}?")
    near = [name for name in COMMANDS if word.startswith(name)] or get_close_matches(word, COMMANDS, 1, 0.8)
    meant = f"did you mean {near[0]}?" if near else "help tells which there are"
    raise MonitorError(f"{word!r}: no such command; {meant}")


def do(monitor: Monitor, line: str) -> None:
    """Carry out one line; blank lines and comments do nothing. Raises WorkError."""
    name, rest = command(line)
    if name:
        found = find(name)
        found.action(monitor, found.arguments_of(rest))
