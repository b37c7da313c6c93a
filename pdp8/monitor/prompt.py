"""The operator's prompt: one line in, what it says out. A script feeds it as well as a person.

Numbers are octal. An address may be a symbol of the program that was loaded, with + or - a number: CHK,
CHK+3. A name may be shortened as long as it stays one of them, as DEC's were: e for examine, se for set.

Not here: files are read by whoever made the monitor (`open_program`), the prompt and its history are the
command's.
"""

from collections.abc import Callable, Iterable
from textwrap import wrap
from typing import NamedTuple

from pdp8.computer import loaders, state
from pdp8.computer.machine import TICKS_PER_SECOND, Machine
from pdp8.computer.stop import Reason
from pdp8.computer.teletype import Punch, printed
from pdp8.computer.trace import Listing, Trace
from tapes import rim, shelf
from tapes.errors import WorkError

_REGISTERS = ("ac", "link", "pc", "ma", "mb", "ir", "sr")
_SWITCHES = ("mem_prot", "sing_step")
_NAMES = " ".join(_REGISTERS + _SWITCHES)
_KEYS = ("load_add", "exam", "dep", "start", "cont", "stop")
_STATES = ("FETCH", "DEFER", "EXECUTE")
_ON = ("1", "on")
_SLICE = 0.5
_FOR_EVER = 1e12
_WHOLE_CORE = range(0o10000)


class MonitorError(WorkError):
    """A line that the monitor cannot carry out."""


class Program(NamedTuple):
    """What a program's name stands for: its words, its tape, and its listing if it is source."""

    words: dict[int, int]
    tape: bytes
    listing: Listing


class Monitor:
    """A machine at a prompt; `say` takes each line of the answers."""

    def __init__(
        self,
        say: Callable[[str], object],
        open_program: Callable[[str], Program],
        machine: Machine | None = None,
    ) -> None:
        self.machine = machine or Machine()
        self.listing = Listing()
        self.finished = False
        self.stopping = False
        """Set by whoever wants a run to end as by the STOP key."""
        self._say = say
        self._open_program = open_program

    def do(self, line: str) -> None:
        """Carry out one line; blank lines and those that begin with `#` do nothing. Raises WorkError."""
        words = line.split("#", 1)[0].split()
        if words:
            command = _command(words[0])
            command.action(self, words[1:])

    def _address(self, text: str) -> int:
        """Return the address that `text` names: octal, or symbol, plus or minus octal."""
        for sign, factor in (("+", 1), ("-", -1)):
            name, found, offset = text.partition(sign)
            if found and name:
                return self._address(name) + factor * _octal(offset) & 0o7777
        symbol = self.listing.symbols.get(text.upper()[:6])
        return _octal(text) if symbol is None else symbol

    def _range(self, text: str) -> range:
        """Return the addresses of A or A:B."""
        first, found, last = text.partition(":")
        begin = self._address(first)
        end = self._address(last) if found else begin
        if end < begin:
            raise MonitorError(f"{text}: {end:04o} lies before {begin:04o}")
        return range(begin, end + 1)

    def examine(self, arguments: list[str]) -> None:
        """Say words of core, each with its line of the listing."""
        for argument in _some(arguments, "an address"):
            for address in self._range(argument):
                self._say(self.listing.line(address, self.machine.core[address]))

    def deposit(self, arguments: list[str]) -> None:
        """Put words into core."""
        first, *words = _some(arguments, "an address and words", 2)
        for offset, word in enumerate(words):
            self.machine.core[self._address(first) + offset & 0o7777] = _octal(word)

    def set_(self, arguments: list[str]) -> None:
        """Set a register or a switch."""
        name, word = _exactly(arguments, f"one of {_NAMES} and a word", 2)
        name = {"l": "link"}.get(name.lower(), name.lower())
        if name in _REGISTERS:
            setattr(self.machine, name, self._address(word))
        elif name in _SWITCHES:
            setattr(self.machine.panel, name, word.lower() in _ON)
        else:
            raise MonitorError(f"{name}: no register or switch; there are {_NAMES}")

    def registers(self, arguments: list[str]) -> None:
        """Say the lamps, the PC and the time."""
        _exactly(arguments, "nothing", 0)
        m, lamps = self.machine, self.machine.panel.lamps
        lit = [name for name in ("ion", "protect", "run") if getattr(lamps, name)]
        self._say(
            f"PC {m.pc:04o}  L {lamps.link}  AC {lamps.ac:04o}  MA {lamps.ma:04o}  MB {lamps.mb:04o}  "
            f"IR {lamps.ir} {_STATES[m.processor.state]:7}  SR {m.sr:04o}  {m.elapsed * 1000:.5f} ms"
            + "".join(f"  {name.upper()}" for name in lit)
        )

    def load(self, arguments: list[str]) -> None:
        """Put a program straight into core."""
        (name,) = _exactly(arguments, "the name of a program", 1)
        program = self._open_program(name)
        self.machine.load(program.words)
        self.listing = program.listing
        self._say(f"{name}: {len(program.words)} words")

    def boot(self, arguments: list[str]) -> None:
        """Load a program from cold as an operator does."""
        (name,) = _exactly(arguments, "the name of a program", 1)
        program = self._open_program(name)
        loader = self._open_program("bin.pal")
        for step in loaders.boot(self.machine, rim.encode(loader.words), program.tape, name):
            self._say(str(step))
        self.listing = program.listing

    def rim(self, arguments: list[str]) -> None:
        """Toggle in the RIM loader."""
        _exactly(arguments, "nothing", 0)
        keys = loaders.toggle(self.machine.panel, loaders.RIM_START, loaders.RIM)
        self._say(f"RIM loader in {loaders.RIM_START:04o}-7776, {keys} keys")

    def key(self, arguments: list[str]) -> None:
        """Press keys of the panel."""
        for name in _some(arguments, f"one or more of the keys {' '.join(_KEYS)}"):
            if name.lower() not in _KEYS:
                raise MonitorError(f"{name}: the keys are {' '.join(_KEYS)}")
            getattr(self.machine.panel, name.lower())()

    def go(self, arguments: list[str]) -> None:
        """START, at an address if one is given, and run."""
        self.machine.start(self._address(arguments[0]) if arguments else None)
        self._run(arguments[1:])

    def cont(self, arguments: list[str]) -> None:
        """CONT: go on."""
        self._run(arguments)

    def _run(self, arguments: list[str]) -> None:
        """Run slice by slice, so that somebody else can press STOP; say how it ended."""
        seconds = _seconds(arguments[0]) if arguments else _FOR_EVER
        end = self.machine.ticks + round(seconds * TICKS_PER_SECOND)
        self.stopping = False
        while True:
            left = (end - self.machine.ticks) / TICKS_PER_SECOND
            stop = self.machine.run(seconds=min(_SLICE, left))
            if stop.reason != "limit" or self.machine.ticks >= end:
                break
            if self.stopping:
                self.machine.stop()
                stop = stop._replace(reason=Reason.STOP_KEY)
                break
            if stop.pc in self.machine.watch.breakpoints:
                stop = stop._replace(reason=Reason.BREAKPOINT)
                break
        line = self.listing.line(stop.pc, self.machine.core[stop.pc])
        self._say(f"{stop.reason}; {stop.elapsed:,.6f} s; next {line}")

    def step(self, arguments: list[str]) -> None:
        """Run instructions, and say each."""
        self._traced(arguments, cycles=False)

    def cycle(self, arguments: list[str]) -> None:
        """Run memory cycles, and say each."""
        self._traced(arguments, cycles=True)

    def _traced(self, arguments: list[str], cycles: bool) -> None:
        count = _octal(arguments[0]) if arguments else 1
        processor = self.machine.processor
        trace = Trace(self._say, self.listing, cycles)
        trace.begin(processor)
        processor.run = 1
        for _ in range(count):
            processor.cycle()
            trace.cycle(processor)
            while not cycles and processor.next in (1, 2):
                processor.cycle()
                trace.cycle(processor)
            if not processor.run:
                return

    def trace(self, arguments: list[str]) -> None:
        """Say every instruction, or cycle, of the runs to come, or no longer."""
        (what,) = _exactly(arguments, "on, cycles or off", 1)
        if what not in ("on", "cycles", "off"):
            raise MonitorError(f"{what}: on, cycles or off")
        self.machine.watch.observer = (
            None if what == "off" else Trace(self._say, self.listing, what == "cycles")
        )

    def break_(self, arguments: list[str]) -> None:
        """Stop before instructions; without addresses, say where."""
        self._points(self.machine.watch.breakpoints, arguments)

    def watch(self, arguments: list[str]) -> None:
        """Stop after words are written; without addresses, say which."""
        self._points(self.machine.watch.writes, arguments)

    def _points(self, points: set[int], arguments: list[str]) -> None:
        points |= {address for argument in arguments for address in self._range(argument)}
        if not arguments:
            self._say(" ".join(f"{address:04o}" for address in sorted(points)) or "none")

    def forget(self, arguments: list[str]) -> None:
        """Forget breakpoints and watched words at addresses, or all."""
        watch = self.machine.watch
        gone = {address for argument in arguments for address in self._range(argument)}
        gone = gone or set(_WHOLE_CORE)
        watch.breakpoints -= gone
        watch.writes -= gone

    def reader(self, arguments: list[str]) -> None:
        """Put a tape into the Teletype's reader; or its lever to start or stop; or take the tape out."""
        (what,) = _exactly(arguments, "the name of a tape, or start, stop, or none", 1)
        reader = self.machine.teletype.reader
        if what in ("start", "stop"):
            reader.lever(what == "start")
        elif what == "none":
            reader.remove()
        else:
            reader.load(shelf.read(what))
            self._say(f"{what}: {len(reader.tape)} frames")

    def fast_reader(self, arguments: list[str]) -> None:
        """Put a tape into the high-speed reader."""
        (name,) = _exactly(arguments, "the name of a tape", 1)
        self.machine.highspeed.reader.load(shelf.read(name))

    def fast_punch(self, arguments: list[str]) -> None:
        """Take the tape off the high-speed punch into a file."""
        self._take_off(self.machine.highspeed.punch, arguments)

    def punch(self, arguments: list[str]) -> None:
        """Take the tape off the Teletype's punch into a file; or switch it on or off."""
        self._take_off(self.machine.teletype.punch, arguments)

    def _take_off(self, punch: Punch, arguments: list[str]) -> None:
        (what,) = _exactly(arguments, "the name of a file, or on, or off", 1)
        if what in ("on", "off"):
            punch.on = what == "on"
        else:
            shelf.write(what, punch.tape)
            self._say(f"{what}: {len(punch.tape)} frames")
            punch.frames.clear()

    def type(self, arguments: list[str]) -> None:
        """Press keys of the Teletype: words, with a RETURN behind them."""
        text = " ".join(arguments).upper() + "\r"
        self.machine.teletype.keyboard.press(bytes(ord(character) & 0o177 | 0o200 for character in text))

    def page(self, arguments: list[str]) -> None:
        """Say what the Teletype has printed."""
        _exactly(arguments, "nothing", 0)
        text = printed(bytes(self.machine.teletype.printer.frames)).decode()
        for line in text.replace("\a", "").replace("\r", "").split("\n"):
            self._say(line)

    def save(self, arguments: list[str]) -> None:
        """Write the machine's state into a file."""
        (name,) = _exactly(arguments, "the name of a file", 1)
        shelf.write(name, state.save(self.machine).encode())

    def restore(self, arguments: list[str]) -> None:
        """Read the machine's state from a file."""
        (name,) = _exactly(arguments, "the name of a file", 1)
        watch = self.machine.watch
        self.machine = state.restore(shelf.read(name).decode("ascii", "replace"))
        self.machine.watch = watch

    def help(self, arguments: list[str]) -> None:
        """Say what the monitor knows, or one of its commands."""
        for command in [_command(name) for name in arguments] or COMMANDS.values():
            said = f"{command.name + ' ' + command.arguments:28}{command.action.__doc__}"
            for line in wrap(said, 79, subsequent_indent=" " * 28):
                self._say(line)

    def quit(self, arguments: list[str]) -> None:
        """Leave."""
        self.finished = True


class Command(NamedTuple):
    """A command: its name, what comes after it, and what it does."""

    name: str
    arguments: str
    action: Callable[[Monitor, list[str]], None]


COMMANDS = {
    command.name: command
    for command in (
        Command("examine", "A | A:B ...", Monitor.examine),
        Command("deposit", "A WORD ...", Monitor.deposit),
        Command("set", "REGISTER|SWITCH WORD", Monitor.set_),
        Command("registers", "", Monitor.registers),
        Command("load", "PROGRAM", Monitor.load),
        Command("boot", "PROGRAM", Monitor.boot),
        Command("rim", "", Monitor.rim),
        Command("key", "KEY ...", Monitor.key),
        Command("go", "[A] [SECONDS]", Monitor.go),
        Command("cont", "[SECONDS]", Monitor.cont),
        Command("step", "[N]", Monitor.step),
        Command("cycle", "[N]", Monitor.cycle),
        Command("break", "[A ...]", Monitor.break_),
        Command("watch", "[A ...]", Monitor.watch),
        Command("forget", "[A ...]", Monitor.forget),
        Command("trace", "on|cycles|off", Monitor.trace),
        Command("reader", "TAPE|start|stop|none", Monitor.reader),
        Command("punch", "FILE|on|off", Monitor.punch),
        Command("fast-reader", "TAPE", Monitor.fast_reader),
        Command("fast-punch", "FILE|on|off", Monitor.fast_punch),
        Command("type", "TEXT", Monitor.type),
        Command("page", "", Monitor.page),
        Command("save", "FILE", Monitor.save),
        Command("restore", "FILE", Monitor.restore),
        Command("help", "[COMMAND]", Monitor.help),
        Command("quit", "", Monitor.quit),
    )
}


def _command(word: str) -> Command:
    """Return the command that `word` names or begins. Raises MonitorError."""
    word = word.lower()
    if not word.isprintable():
        raise MonitorError("this is no text; help tells which commands there are")
    if word in COMMANDS:
        return COMMANDS[word]
    found = [command for name, command in COMMANDS.items() if name.startswith(word)]
    if len(found) == 1:
        return found[0]
    if found:
        raise MonitorError(f"{word}: {', '.join(command.name for command in found)}?")
    raise MonitorError(f"{word}: no such command; help tells which there are")


def _octal(text: str) -> int:
    try:
        number = int(text, 8)
    except ValueError:
        raise MonitorError(f"{text}: neither an octal number nor a symbol of the program") from None
    if not 0 <= number <= 0o7777:
        raise MonitorError(f"{text}: not between 0000 and 7777")
    return number


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        raise MonitorError(f"{text}: seconds of machine time were expected") from None
    if not 0 <= seconds < 1e9:
        raise MonitorError(f"{text}: no time a machine can run")
    return seconds


def _some(arguments: list[str], what: str, least: int = 1) -> list[str]:
    if len(arguments) < least:
        raise MonitorError(f"{what} expected")
    return arguments


def _exactly(arguments: list[str], what: str, count: int) -> Iterable[str]:
    if len(arguments) != count:
        raise MonitorError(f"{what} expected")
    return arguments
