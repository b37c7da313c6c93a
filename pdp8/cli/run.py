"""`pdp8 run`: a program and its tape go in, the punched tape comes out, as it is punched."""

import os
import stat
import sys
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import ExitStack, closing, contextmanager
from dataclasses import dataclass
from functools import partial
from io import UnsupportedOperation
from typing import TYPE_CHECKING, Final, Literal

import click

from pdp8 import fitting, shelf
from pdp8.cli.running import pacing
from pdp8.cli.running.feed import Feed, say_unread
from pdp8.cli.running.outputs import Output, send
from pdp8.cli.shared import arguments, command
from pdp8.cli.shared.arguments import Command, Source, Target
from pdp8.cli.shared.parameters import (
    address,
    check_start,
    device_option,
    dialect_option,
    drive,
    octal,
    seconds,
)
from pdp8.cli.shared.rules import declared, field, flag, is_given, of
from pdp8.computer.hardware.bus import Peripheral
from pdp8.computer.hardware.extension import MEMORY
from pdp8.computer.machine import Machine
from pdp8.computer.past.history import History, PipedHistory
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.use.ending import DEPARTURES, ended, explained, may_be_wrong, rerun, sentences
from pdp8.computer.use.program import Program
from pdp8.computer.use.trace import Listing
from pdp8.shelf import ShelfError
from tapes import codes, rim
from tapes.errors import WorkError, called, naming
from tapes.quantities import counted, duration

if TYPE_CHECKING:
    from pdp8.reels import Reels

_DONE = (Reason.HALT, Reason.TAPE_OUT)
_CLOSED: Final = "closed"
_FAILED: Final = "failed"
_Ended = Stop | Literal["closed", "failed"] | None
"""How a run ended: by itself (a Stop), standard output was closed, a file failed; None: interrupted."""


@dataclass(frozen=True)
class Options:
    """What to run, its inputs and outputs, and what to record."""

    program: str | None = of(click.argument("program", type=Source(), required=False))
    start: int = field("--start", "Address to start at, octal.", address, default="0200")
    sr: int = field("--sr", "Switch register, octal.", octal, default="0000")
    reader: tuple[str, ...] = field(
        "--reader",
        "Tape in the Teletype's reader; several go in one after another.  [default: standard input]",
        Source(),
        multiple=True,
    )
    punch: str | None = field(
        "--punch", "Where the punched tape goes.  [default: standard output]", Target("tape")
    )
    fast_reader: str | None = field("--fast-reader", "Fit the high-speed reader, with this tape.", Source())
    fast_punch: str | None = field(
        "--fast-punch", "Fit the high-speed punch; its tape goes here.", Target("tape")
    )
    device: tuple[str, ...] = of(device_option)
    memory: str = field(
        "--memory",
        "Words of core; no PDP-8/L had 32k.",
        click.Choice(list(MEMORY), case_sensitive=False),
        default="4k",
        excludes="--restore",
        show_default=False,
    )
    dectape: tuple[tuple[str, str], ...] = field(
        "--dectape",
        "Mount a DECtape image on drive N, 0 to 7. Without PROGRAM drive 0 is booted, or the disk.",
        drive,
        multiple=True,
        metavar="N=FILE",
    )
    save_dectape: tuple[tuple[str, str], ...] = field(
        "--save-dectape",
        "Save the reel of drive N as the run ends; the image that was mounted stays.",
        drive,
        multiple=True,
        metavar="N=FILE",
        needs="--dectape",
        writes=True,
    )
    disk: str | None = field(
        "--disk",
        "Fit a DF32 with an image of one to four discs, 65,536 bytes each.",
        metavar="df32=FILE",
        excludes="--restore",
    )
    save_disk: str | None = field(
        "--save-disk", "Save the disk as the run ends.", metavar="df32=FILE", needs="--disk", writes=True
    )
    printer: str | None = field("--printer", "Fit the line printer LP08; its text goes here.", Target("text"))
    keyboard: bool = of(
        flag("--keyboard", "Type at the Teletype and see it print; Ctrl-] stops and opens the monitor.")
    )
    line: str | None = field(
        "--line",
        "The Teletype is a line: a serial port, a pty, a TCP port for telnet. At 110 baud's pace.",
        Target(),
        metavar="PATH|tcp:PORT",
        excludes="--keyboard --reader --realtime",
    )
    line_bits: int | None = field(
        "--line-bits",
        "8: frames as they are; 7: characters as a terminal has them.  [default: 8; tcp: 7]",
        click.Choice([7, 8]),
        needs="--line",
    )
    line_speed: str = field(
        "--line-speed",
        "At 110 baud's pace, or as fast as it goes.",
        click.Choice(["110", "full"]),
        default="110",
        needs="--line",
    )
    max_time: float | None = field("--max-time", "Stop after this machine time.", seconds, metavar="SECONDS")
    realtime: bool = of(flag("--realtime", "Run no faster than a PDP-8/L did: 10 frames a second."))
    boot: bool = of(
        flag(
            "--boot", "From cold: toggle RIM in, read the BIN loader, read the program.", excludes="--restore"
        )
    )
    loader: str | None = field(
        "--loader",
        "The RIM tape of the BIN loader --boot reads.  [default: bin.pal]",
        Source(),
        needs="--boot",
    )
    dialect: str = of(dialect_option(needs="PROGRAM"))
    force: bool = of(flag("--force", "Load a damaged tape as far as it can be read.", needs="PROGRAM"))
    trace: str | None = field(
        "--trace", "Write each instruction: time, L AC, MA MB, its listing.", Target("text")
    )
    count: bool = of(
        flag("--count", "Count instructions, cycles, waiting; a table as the run ends.", excludes="--trace")
    )
    annotate: str | None = field(
        "--annotate",
        "Write the listing with each word's count in its margin.",
        Target("text"),
        needs="PROGRAM",
        excludes="--trace",
    )
    save: str | None = field("--save", "Write the machine's state as the run ends.", Target("JSON"))
    restore: str | None = field(
        "--restore",
        "Go on from a saved state and the tape in its reader, as CONT does; with --start, START "
        "there. --sr sets the switches, --reader changes the tape (- for standard input).",
        Source(),
    )
    quiet: bool = of(flag("--quiet", "Do not say how the run ended, unless it failed."))


@click.command(cls=Command, context_settings={"allow_extra_args": True})
@declared
@click.pass_context
def run(ctx: click.Context, /, options: Options) -> None:
    """Run PROGRAM on the PDP-8/L: standard input is the tape in its reader, standard output what it punches.

    PROGRAM is PAL III source, a BIN or a RIM tape, or the name of a bundled one, such as eia.pal. A pipe is
    read as it comes.

    The last line says why the run stopped, where, what was read and punched, and how long it would have taken
    in 1971. Exit status: 0 HLT or out of tape, 1 the program cannot be run, did not end or
    left its words, 130 interrupted.
    A program that counts while it waits for its tape never ends: give it --max-time.

    \b
    Examples:
      pdp8 run eia.pal < circle.asc > circle.eia
      pdp8 run eia.pal --reader ellipse.asc --punch ellipse.eia
      pdp8 run eia.pal --boot < circle.asc > circle.eia
      pdp8 run echo.pal --keyboard --realtime
      pdp8 run echo.pal --line /dev/ttyUSB0
      pdp8 run echo.pal --line tcp:5000
      pdp8 run eia.pal --trace eia.trace --max-time 1 < circle.asc > some.eia
      pdp8 run eia.pal --count --annotate eia.counts < circle.asc > circle.eia
      pdp8 run eia.pal --save noon.state --max-time 60 < circle.asc > first.eia
      pdp8 run --restore noon.state > rest.eia
      pdp8 run --device clock.py:Clock ticks.pal
      pdp8 run --memory 8k --dectape 0=ps8.tu56 --keyboard
      pdp8 run mine.bin --start 400 --sr 7777 --fast-reader in.tape --fast-punch out.tape
    """
    ctx.meta[command.QUIET] = options.quiet
    explicit = {param.name for param in ctx.command.params if is_given(ctx, param)}
    ctx.exit(_Run(options, ctx.args, explicit).done())


class _Run:
    """One run: its program, machine and tapes, and the files that could not be written."""

    def __init__(self, options: Options, more: Sequence[str], explicit: Collection[str | None]) -> None:
        self.options = options
        self.paged = options.keyboard or bool(options.line)
        """Whether somebody is at the Teletype, by keyboard or line, and no tape goes to standard output."""
        self.reels_in = _by_device(options.dectape, options.disk)
        self.reels_out = _by_device(options.save_dectape, options.save_disk)
        self.mounted: Reels | None = None
        self.failures: list[WorkError] = []
        _check_options(options, more, self.reels_in, self.reels_out)
        self.found = self._program(explicit)
        self.machine = self._machine()
        if self.found or "sr" in explicit:
            self.machine.sr = options.sr
        if self.mounted:
            self.mounted.look_at(self.machine.devices)
        self.feed = self._feed()
        if "start" in explicit or (self.found and not self.machine.panel.lamps.run):
            self.machine.start(options.start)
        elif self.mounted and options.restore is None:
            from pdp8.computer.use import bootstrap

            booted = self.mounted.places["dt0" if "dt0" in self.reels_in else "df"]
            bootstrap.boot(self.machine, booted.bootstrap)
        if options.restore is not None:
            from pdp8.computer.use.operator import Operator

            Operator(self.machine).throw_what_waits()
        self.began = self.machine.values()
        self.before = _moved(self.machine, self.feed.read) if "start" in explicit else [(0, 0), (0, 0)]
        """The frames that were read and punched before START, with which time begins."""
        if self.paged or self.feed.left:
            PipedHistory(self.machine)

    @property
    def listing(self) -> Listing:
        """The program's listing, empty without one."""
        return self.found.listing if self.found else Listing()

    def _program(self, explicit: Collection[str | None]) -> Program | None:
        """Return the program, if named, after checking all file names. Raises UsageError."""
        options = self.options
        reads = [options.program, *options.reader, options.fast_reader, options.restore, options.loader]
        reads += [fitting.file_of(name) for name in options.device] + [*self.reels_in.values()]
        page = "-" if options.punch is None and not self.paged else options.punch
        writes = [options.fast_punch, options.trace, options.annotate, options.save, options.printer]
        arguments.check_files(reads, [page, *writes, *self.reels_out.values()])
        if options.keyboard and not (sys.stdin.isatty() and sys.stdout.isatty()):
            raise click.UsageError("--keyboard needs a terminal to type and print at.")
        if options.program is None:
            return None
        forced, memory = options.force or options.boot, MEMORY[options.memory]
        found = shelf.program(options.program, forced, options.dialect, memory)
        if found.code is codes.ASCII and options.force:
            raise click.UsageError(
                f"--force means nothing for {found.name}: it is no tape that may be damaged."
            )
        if found.code is not codes.ASCII and "dialect" in explicit:
            raise click.UsageError(
                f"--dialect means nothing for {found.name}: it is a tape, and no PAL source."
            )
        return found

    def _machine(self) -> Machine:
        """Return the machine, new with the program in core or restored; say what there is to say of both."""
        options, found = self.options, self.found
        names = list(options.device)
        if "highspeed" not in names and (options.fast_reader is not None or options.fast_punch is not None):
            names.insert(0, "highspeed")
        asked = {"dectape": options.dectape, "df32": options.disk, "lp08": options.printer}
        names += [name for name, given in asked.items() if given and name not in names]
        devices = fitting.devices(names)
        if options.restore is None:
            machine = Machine(memory=MEMORY[options.memory])
            fitting.fit(machine, devices)
            self._mount(machine.devices)
        else:
            fitting.fit(Machine(), devices)  # a device that cannot be fitted is refused as without a state
            machine = self._restored(options.restore, [made() for made in devices])
        check_start(options.start, machine.memory)
        if machine.memory == MEMORY["32k"]:
            command.say("32K of core, and three bits of field: no PDP-8/L had them")
        if found is not None:
            if options.boot:
                self._boot(machine, found)
            else:
                machine.load(found.words)
            if not machine.panel.lamps.run:  # else its tape starts itself
                if options.force or not options.quiet:
                    command.say_of(found.name, found.notes)
                if not options.quiet:
                    command.say_of(found.name, found.notes_on(options.start, "--start"))
        return machine

    def _restored(self, name: str, fitted: Sequence[Peripheral]) -> Machine:
        """Return the saved machine, with the devices `fitted` too, and with the reels that are mounted."""
        from pdp8.computer.past import state

        text = shelf.read_text(name, state.LARGEST)
        self._mount(fitted)
        with naming(name):
            return state.restore(text, fitted, known=fitting.known(), mount=fitting.MOUNT)

    def _mount(self, devices: Sequence[Peripheral]) -> None:
        """Mount the reels of --dectape and the disk of --disk, and say what there is to say of them."""
        options = self.options
        if not (self.reels_in or options.device or options.restore or options.keyboard):
            return
        from pdp8.reels import Reels

        self.mounted = Reels(devices)
        for device, name in self.reels_in.items():
            notes = self.mounted.mount(device, name)
            if not options.quiet:
                command.say_of(name, notes)

    def _boot(self, machine: Machine, found: Program) -> None:
        """Load the program as an operator does, saying what it took."""
        from pdp8.computer.use.operator import Operator

        options = self.options
        if options.loader is None:
            tape = rim.encode(shelf.bundled_program("bin.pal").words)
        else:
            of_loader = shelf.program(options.loader, options.force)
            tape = of_loader.tape if of_loader.code is codes.RIM else rim.encode(of_loader.words)
        total = 0.0
        for step in Operator(machine).boot(tape, found.tape, called(found.name), options.force):
            total += step.seconds
            if not options.quiet:
                command.say(str(step))
        if total and not options.quiet:
            command.say(f"loaded in {duration(total)} of tape; switches and keys not counted")

    def _feed(self) -> Feed:
        """Return the feeder of the Teletype's reader, with the first tape in the reader."""
        options, machine = self.options, self.machine
        used = self.paged or options.restore is not None or "-" in (options.program, options.fast_reader)
        names = list(options.reader) or ([] if used or sys.stdin.isatty() else ["-"])
        feed = Feed(machine.teletype.reader, names, options.quiet)
        waits = options.boot and machine.panel.lamps.run  # the program's tape is still to be read
        if not (waits or feed.next_tape() or options.restore is not None):
            machine.teletype.reader.load(b"")
        if options.fast_reader is not None:
            machine.highspeed.reader.load(shelf.read(options.fast_reader))
        return feed

    def done(self) -> int:
        """Run to the end and write what was asked for; return the exit status."""
        try:
            stop = self._stop()
        finally:
            self._save_mounted()
            self._save_paper()
        if self.options.save is not None:
            from pdp8.computer.past import state

            with self._noting():
                command.put(self.options.save, state.save(self.machine))
        for failure in self.failures:
            command.say(str(failure))
        status = self._report(stop)
        return 1 if self.failures else status

    def _stop(self) -> _Ended:
        """Run to the end, recorded as asked for; return how it ended."""
        options, machine = self.options, self.machine
        outputs = []
        if options.punch is not None or not self.paged:
            outputs.append(Output(machine, options.punch))
        if options.fast_punch is not None:
            outputs.append(Output(machine, options.fast_punch, fast=True))
        begun = False
        stop: _Ended = None
        with ExitStack() as stack:
            for output in outputs:
                stack.callback(output.tell)
                stack.callback(output.close)
            stack.enter_context(self._noting())
            if options.trace is not None:
                from pdp8.cli.running.watching import tracing

                stack.enter_context(tracing(machine, options.trace, self.listing))
            if options.count or options.annotate:
                from pdp8.cli.running.watching import counting

                stack.enter_context(counting(machine, self.listing, options.count, options.annotate))
            live = self._live(stack, outputs)
            begun, stop = True, _FAILED
            try:
                if live is not None:
                    stop = live(partial(send, outputs))
                else:
                    pace = options.max_time, options.realtime, options.quiet
                    stop = pacing.run(machine, self.feed, outputs, *pace)
            except BrokenPipeError:
                command.silence(sys.stdout)  # its reader has closed it; what else was asked for is written
                send(outputs)
                stop = _CLOSED
            except ShelfError as error:
                self.failures.append(error)
        if not begun:
            raise self.failures.pop()
        return stop

    def _live(
        self, stack: ExitStack, outputs: Sequence[Output]
    ) -> Callable[[Callable[[], object]], Stop | None] | None:
        """Return the function that runs the machine with a user at its Teletype; None without a user."""
        options = self.options
        if options.keyboard:
            from pdp8.cli.monitor import sit_down

            pace, follow = (options.max_time, options.realtime), partial(self._follow, outputs)
            of_program = self.listing, options.dialect
            return partial(sit_down, self.machine, *of_program, self.mounted, self.feed, *pace, follow)
        if options.line is not None and sys.platform != "win32":  # as _check_options has it
            from pdp8.cli.running.line import opened

            line = opened(options.line, options.line_bits, options.line_speed == "full")
            return partial(stack.enter_context(closing(line)).run, self.machine, options.max_time)
        return None

    def _follow(self, outputs: Sequence[Output], machine: Machine) -> None:
        """Use `machine` from now on: who sat at the monitor left this one."""
        self.machine = machine
        for output in outputs:
            output.settle(machine)

    @contextmanager
    def _noting(self) -> Iterator[None]:
        """Add an error of the work that is raised inside to the failures."""
        try:
            yield
        except WorkError as error:
            self.failures.append(error)

    def _save_mounted(self) -> None:
        """Save the reels and the disk that options name, and then the others that were written."""
        if self.mounted is None:
            return
        for device, name in self.reels_out.items():
            with self._noting():
                said = self.mounted.save(device, name)
                if not self.options.quiet:
                    command.say(said)
        with self._noting():
            for said in self.mounted.rescue() if self.options.save is None else ():
                command.say(said)

    def _save_paper(self) -> None:
        """Save the text that the printer has printed since the run began, or, undone, all of it."""
        if self.options.printer is None:
            return
        from pdp8.computer.rack.lp08 import LP08

        for device in self.machine.devices:
            with self._noting():
                if isinstance(device, LP08):
                    before = self.began["devices 66 frames"]
                    new = len(before) * bytes(device.frames).startswith(before)
                    command.put(self.options.printer, device.paper[new:])

    def _report(self, stop: _Ended) -> int:
        """Say how the run ended; return the exit status."""
        options, machine, feed = self.options, self.machine, self.feed
        if stop is None and options.keyboard:
            return 0
        counts = _counts(machine, _moved(machine, feed.read), self.before)
        if feed.left and not options.quiet:
            command.say(f"{feed.left} did not go into the reader: the program did not wait for it")
        if options.restore and not (options.reader or options.quiet):
            say_unread()
        if not options.quiet:
            self._tell_of_channel_8()
        if stop is None:
            command.say(f"interrupted at {machine.pc:04o}{counts}")
            return 130
        if stop == _FAILED:
            command.say(f"stopped at {machine.pc:04o}, as an output or a tape failed{counts}")
            return 1
        if stop == _CLOSED:
            if not options.quiet:
                command.say(f"the reader of standard output has closed it, at {machine.pc:04o}{counts}")
            return 0
        stop = self._explained(stop)
        done = stop.reason in _DONE and not any(why.what in DEPARTURES for why in stop.why)
        fed = options.reader or options.fast_reader or options.restore or self.paged
        if stop.reason is Reason.TAPE_OUT and sys.stdin.isatty() and not fed:
            counts += "; --keyboard types at the Teletype, --reader FILE puts a tape in"
        if not (options.quiet and done):
            still = f"still running at {stop.pc:04o} when --max-time was over"
            command.say((still if stop.reason is Reason.LIMIT else ended(stop, machine)) + counts)
            for sentence in sentences(stop, self.listing, machine.core):
                command.say(sentence)
        return 0 if done else 1

    def _explained(self, stop: Stop) -> Stop:
        """Return the stop with its causes, found in the run's history, or by running it again."""
        words = self.found.words if self.found else {}
        if not may_be_wrong(stop, self.machine, words):
            return stop
        history = self.machine.recorder
        if not isinstance(history, History):
            history = rerun(self.machine, self.began)
        return explained(stop, history, words)

    def _tell_of_channel_8(self) -> None:
        """Say how to get text from what was printed: a pipe receives frames, with channel 8."""
        if self.options.punch is not None or self.paged or not _piped():
            return
        before = self.began["devices 04 punch frames"]
        frames = self.machine.teletype.punch.tape[len(before) :]
        if codes.recognise(frames) is codes.ASCII and not frames.isascii():
            command.say("the frames have channel 8: `| pdp8 tape convert - --to text` makes text of them")


def _piped() -> bool:
    """Return whether standard output is a pipe."""
    try:
        return stat.S_ISFIFO(os.fstat(sys.stdout.fileno()).st_mode)
    except UnsupportedOperation:  # a stream of Python's own
        return False


def _check_options(
    options: Options, more: Sequence[str], reels_in: Collection[str], reels_out: Mapping[str, str]
) -> None:
    """Raise UsageError for options that mean nothing together, and for what follows the program."""
    if more:
        raise click.UsageError(
            f"{more[0]}: one PROGRAM is run; a tape goes into the reader: --reader {more[0]}"
        )
    if options.program is None and options.restore is None and not {"df", "dt0"} & set(reels_in):
        raise click.UsageError(
            "give a PROGRAM, or --restore FILE, or --dectape 0=FILE or --disk df32=FILE to boot."
        )
    if options.program is not None and options.restore is not None:
        raise click.UsageError("give a PROGRAM or --restore FILE, not both.")
    if options.line and sys.platform == "win32":
        raise click.UsageError("--line needs the serial lines of Linux, macOS or another POSIX system.")
    for device, name in reels_out.items():
        if device not in reels_in:
            raise click.UsageError(f"{device[2:]}={name}: no tape is mounted on drive {device[2:]}.")
        if name == "-":
            raise click.UsageError(f"{device}: standard output has the punched tape; name a file.")
        Target("image").check(name)


def _by_device(reels: Sequence[tuple[str, str]], disk: str | None) -> dict[str, str]:
    """Return the files of drives and of df32=FILE, by the devices that they go on."""
    found: dict[str, str] = {}
    for device, name in reels:
        if device in found:
            raise click.UsageError(f"{device[2:]}={name}: drive {device[2:]} has {found[device]}.")
        found[device] = name
    if disk is not None:
        kind, _, file = disk.partition("=")
        if kind != "df32" or not file:
            raise click.UsageError(f"{disk}: df32=FILE is expected, and there is no other disk.")
        found["df"] = file
    return found


def _moved(machine: Machine, read: int) -> list[tuple[int, int]]:
    """Return how many frames were read and punched, and how many at high speed where that is fitted."""
    fast = machine.highspeed
    at_high_speed = [(fast.reader.position, len(fast.punch.frames))] * fast.fitted
    return [(read, len(machine.teletype.punch.frames)), *at_high_speed]


def _counts(machine: Machine, now: Sequence[tuple[int, int]], before: Sequence[tuple[int, int]]) -> str:
    """Say what was read and punched, and the time of 1971."""
    said = "".join(
        f"; {counted(read - r, 'frames')} read, {counted(punched - p, 'frames')} punched{how}"
        for (read, punched), (r, p), how in zip(now, before, ("", " at high speed"), strict=False)
    )
    return f"{said}; {duration(machine.elapsed)} in 1971"
