"""Every command of the monitor by its name."""

import re
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from inspect import signature
from textwrap import wrap
from typing import NamedTuple

from pdp8 import fitting, shelf
from pdp8.monitor import debugging, keystrokes, past, rack, running, simh, tapes
from pdp8.monitor.arguments import MonitorError, as_it_stands, command, some, split
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError, called
from tapes.text import lines_of

_SHORT = {
    "b": "boot", "c": "cont", "d": "deposit", "e": "examine", "ex": "examine", "g": "go", "h": "help",
    "l": "load", "q": "quit", "r": "reset", "ru": "run", "s": "step", "sa": "save", "se": "set", "w": "watch",
    "continue": "cont", "get": "restore", "nobreak": "forget", "bye": "quit",
}  # fmt: skip
"""The command that a short name means if several begin with it; and SIMH's names of our commands."""
_RUNS = ("go", "cont", "run", "type", "keyboard", "send", "boot", "step", "cycle")
"""After one of these, `expect` ignores what was printed before."""
_IF = re.compile(r"(not\s+)?exist\s+(\"[^\"]*\"|\S+)\s+(.*)", re.IGNORECASE)
_SWITCHED = ("examine", "deposit", "attach", "type", "echo", "if")
"""Of other commands SIMH's switches are passed over."""
_DEEPEST = 10
"""Scripts within scripts."""
_NOT_HERE = """\
Numbers are octal, seconds are not. Ctrl-] or Ctrl-E stops a program, cont goes
on in it. Not here, as no PDP-8/L had them: EAE and MQ, the PDP-8/E's BSW and
600x, RK05, RX01; more than 4K of core unless set cpu 8k fits it."""
_AT_SIMH = {
    "assign": "files have their own names",
    "call": "do FILE carries out a script",
    "dump": "punch 0-7577 FILE writes core as a BIN tape",
    "evaluate": "examine says a word of core with its instruction",
    "!": "no command of the system is carried out; type it at a terminal beside this one",
    "next": "step, or break at the return",
}
"""What is here in place of a command of SIMH's, which may be shortened to three letters."""


class Command(NamedTuple):
    """A command: its name, operands, action, what is missing, and how its words are split."""

    name: str
    arguments: str
    action: Callable[..., None]
    expected: str = "nothing"
    words_of: Callable[[str], Sequence[str]] = split

    def words(self, rest: str) -> Sequence[str]:
        """Return the words of `rest`: as many as the action takes. Raises MonitorError."""
        _, *takes = signature(self.action).parameters.values()
        any_number = [each for each in takes if each.kind is each.VAR_POSITIONAL]
        needed = [each for each in takes if each.default is each.empty and each not in any_number]
        words = self.words_of(rest)
        while words and simh.SWITCH.fullmatch(words[0]) and self.name not in _SWITCHED:
            words = words[1:]
        return some(words, self.expected, len(needed), None if any_number else len(takes))


def help_(monitor: Monitor, *names: str) -> None:
    """Say what the monitor knows, or one of its commands."""
    for each in [find(name) for name in names] or COMMANDS.values():
        said = f"{each.name + ' ' + each.arguments:27} {' '.join((each.action.__doc__ or '').split())}"
        for line in wrap(said, 79, subsequent_indent=" " * 28):
            monitor.say(line)
    if not names:
        monitor.say(_NOT_HERE)


def quit_(monitor: Monitor) -> None:
    """Leave."""
    simh.take_off(monitor)
    monitor.finished = True


def do_file(monitor: Monitor, name: str, *more: str) -> None:
    """Carry out the commands of a file; its first error ends it."""
    if monitor.depth >= _DEEPEST:
        raise MonitorError(f"{name}: more than {_DEEPEST} scripts within scripts")
    lines = list(lines_of(shelf.read(name).decode("utf-8-sig", "surrogateescape")))
    labels = {
        line.split()[0].upper(): number
        for number, line in enumerate(lines)
        if line[:1] == ":" != line.strip()
    }
    monitor.depth += 1
    try:
        number = 0
        while number < len(lines) and not monitor.finished:
            monitor.echo(lines[number])
            number += 1
            try:
                do(monitor, lines[number - 1])
                if monitor.goto:
                    label, monitor.goto = monitor.goto, ""
                    if label not in labels:
                        raise MonitorError(f"{label}: no line begins with it")
                    number = labels[label]
                if monitor.stopping:
                    raise MonitorError("stopped")
            except WorkError as error:
                raise MonitorError(f"{called(name)}, line {number}: {error}") from error
    finally:
        monitor.depth -= 1


def goto(monitor: Monitor, label: str) -> None:
    """Go on in the script at the line :LABEL."""
    if not monitor.depth:
        raise MonitorError("goto is for scripts")
    monitor.goto = ":" + label.removeprefix(":").upper()


def if_(monitor: Monitor, text: str) -> None:
    """Carry out a command if a file is there, or not there; `assert` has other conditions."""
    found = _IF.fullmatch(text.strip())
    if not found:
        raise MonitorError("if [not] exist FILE COMMAND expected; to test a register there is assert")
    if shelf.has(found[2].strip('"')) != bool(found[1]):
        do(monitor, found[3])


_PLACES = f"{' '.join(debugging.REGISTERS)} or an address"
_TAPES = "names of tapes, or start, stop, or none"
COMMANDS = {
    each.name: each
    for each in (
        Command("examine", "A|A:B|NAME ...", simh.examine, "an address"),
        Command("deposit", "A WORD ...|A:B WORD", simh.deposit, "an address and words"),
        Command("set", "NAME WORD", simh.set_, f"one of {debugging.NAMES} and a word"),
        Command("registers", "", debugging.registers),
        Command("load", "PROGRAM [force]", tapes.load, "the name of a program"),
        Command("boot", "PROGRAM [force]|DEVICE", rack.boot, "the name of a program"),
        Command("listing", "PROGRAM", tapes.listing, "the name of a program"),
        Command("rim", "", tapes.rim),
        Command("key", "KEY ...", debugging.key, f"one or more of the keys {' '.join(debugging.KEYS)}"),
        Command("go", "[A] [SECONDS|until TEXT]", running.go),
        Command("cont", "[SECONDS|until TEXT]", running.cont),
        Command("run", "[A|SECONDS|until TEXT]", running.run),
        Command("until", "TEXT [N times] [SECONDS]", running.until),
        Command("expect", "TEXT [SECONDS]", running.expect),
        Command("assert", "REGISTER|A WORD", running.assert_, f"one of {_PLACES}, and a word"),
        Command("wait", "SECONDS", running.wait, "seconds"),
        Command("step", "[N]", debugging.step, "how many, octal,"),
        Command("cycle", "[N]", debugging.cycle, "how many, octal,"),
        Command("back", "[N] [UNIT] | until A [written|flag]", past.back),
        Command("break", "[A ...]", debugging.break_),
        Command("watch", "[A ...]", debugging.watch),
        Command("forget", "[A ...]", debugging.forget),
        Command("trace", "on|cycles|off", debugging.trace, "on, cycles or off"),
        Command("count", "[on|off|listing]", debugging.count, "on, off or listing, or nothing"),
        Command("reader", "TAPE ...|start|stop|none", tapes.reader, _TAPES),
        Command("punch", "FILE|on|off|A:B FILE", tapes.punch, "the name of a file, or on, or off"),
        Command("fast-reader", "TAPE", tapes.fast_reader, "the name of a tape"),
        Command("fast-punch", "FILE|on|off", tapes.fast_punch, "the name of a file, or on, or off"),
        Command("type", "TEXT", keystrokes.type_, words_of=as_it_stands),
        Command("keyboard", "[now] TEXT ...", keystrokes.keyboard),
        Command("page", "[more]", tapes.page),
        Command("save", "FILE", tapes.save, "the name of a file"),
        Command("restore", "FILE", tapes.restore, "the name of a file"),
        Command("attach", "[-r] DEVICE FILE", simh.attach),
        Command("detach", "DEVICE [FILE|forget]", simh.detach, simh.DEVICES),
        Command("send", "TEXT ...", simh.send),
        Command("do", "FILE", do_file, "the name of a file"),
        Command("goto", "LABEL", goto, "a label"),
        Command("if", "[not] exist FILE COMMAND", if_, words_of=as_it_stands),
        Command("echo", "TEXT", simh.echo, words_of=as_it_stands),
        Command("reset", "", simh.reset),
        Command("show", "", simh.show),
        Command("on", "", simh.passed_over),
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
    found = found or [COMMANDS[_SHORT[each]] for each in _SHORT if each.startswith(word) and word[2:]]
    if len(found) == 1:
        return found[0]
    if found:
        raise MonitorError(f"{word}: {', '.join(each.name for each in found)}?")
    near = [name for name in COMMANDS if word.startswith(name)] or get_close_matches(word, COMMANDS, 1, 0.8)
    meant = f"did you mean {near[0]}?" if near else "help tells which there are"
    at_simh = [
        ours for name, ours in _AT_SIMH.items() if name[: max(len(word), 2)] == word or word[0] == name
    ]
    meant = f"it is SIMH's; here {at_simh[0]}" if at_simh else meant
    raise MonitorError(f"{word!r}: no such command; {meant}")


def do(monitor: Monitor, line: str) -> None:
    """Carry out one line; blank lines and comments do nothing. Raises WorkError."""
    name, rest = command(line)
    monitor.stopping = monitor.stopping and monitor.depth > 0  # a script is stopped, not its line alone
    if name:
        found = find(name)
        if found.name in _RUNS:
            monitor.expected = len(monitor.machine.teletype.printer.frames)
        try:
            found.action(monitor, *found.words(rest))
        except Exception as error:
            if said := fitting.fault(error):
                raise MonitorError(said) from error
            raise
