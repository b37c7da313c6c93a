"""`pdp8 run`: a program and its tape go in, the punched tape comes out, as it is punched."""

import sys
import time
from contextlib import AbstractContextManager, ExitStack
from typing import BinaryIO

import click
from click.core import ParameterSource

from pdp8.cli.interrupt import ctrl_c
from pdp8.cli.octal import octal
from pdp8.cli.program import read_words
from pdp8.cli.progress import Bar
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.teletype import Punch, printed
from tapes import command, shelf
from tapes.errors import WorkError
from tapes.frames import PARITIES

# The longest slices of a run in seconds of machine time: what is punched is passed on after each.
_REALTIME, _TRACED, _LONGEST = 0.05, 1.0, 60.0
_WHY = {
    Reason.HALT: "HLT at {last:04o}",
    Reason.TAPE_OUT: "the reader ran out of tape, and the program waits for it at {pc:04o}",
    Reason.IDLE: "an endless loop at {pc:04o} that nothing can end",
    Reason.LIMIT: "still running at {pc:04o} when --max-time was over",
    Reason.STOP_KEY: "stopped before {pc:04o}",
    Reason.PROTECT: "MEM PROT stopped a write at {last:04o}",
}
_DONE = (Reason.HALT, Reason.TAPE_OUT)


class _Output:
    """Where the frames of one punch go as they are punched; at a terminal, the printed page instead."""

    def __init__(self, punch: Punch, name: str | None) -> None:
        self._punch = punch
        self._name = name or "standard output"
        self._sent = len(punch.frames)
        self._page = name is None and sys.stdout.isatty()
        self._stream: BinaryIO = sys.stdout.buffer if self._page else shelf.open_punch(name or "-")

    def send(self) -> None:
        """Pass on what was punched since the last time."""
        fresh = bytes(self._punch.frames[self._sent :])
        if not fresh:
            return
        try:
            self._stream.write(printed(fresh) if self._page else fresh)
            self._stream.flush()
        except BrokenPipeError:
            raise
        except OSError as error:
            raise shelf.ShelfError(f"{self._name}: {error.strerror} after {self._sent:,} frames") from error
        self._sent += len(fresh)


def seconds(text: str) -> float:
    """Return a machine time: 0 to a thousand million seconds, 31 years. Raises click.BadParameter."""
    try:
        time_ = float(text)
    except ValueError:
        raise click.BadParameter(f"{text!r} is not a number of seconds") from None
    if not 0 <= time_ <= 1e9:
        raise click.BadParameter(f"{text} is not between 0 and 1e9 seconds")
    return time_


@click.command()
@click.argument("program", required=False)
@click.option("--start", type=octal, default="0200", show_default=True, help="Address to start at, octal.")
@click.option("--sr", type=octal, default="0000", show_default=True, help="Switch register, octal.")
@click.option("--reader", metavar="FILE", help="Tape in the Teletype's reader.  [default: standard input]")
@click.option("--punch", metavar="FILE", help="Where the punched tape goes.  [default: standard output]")
@click.option("--fast-reader", metavar="FILE", help="Fit the high-speed reader, with this tape.")
@click.option("--fast-punch", metavar="FILE", help="Fit the high-speed punch; its tape goes here.")
@click.option(
    "--keyboard", is_flag=True, help="Type at the Teletype and see it print; Ctrl-] leaves to the monitor."
)
@click.option("--max-time", type=seconds, help="Stop after this machine time.")
@click.option("--realtime", is_flag=True, help="Run no faster than a PDP-8/L did: 10 frames a second.")
@click.option("--boot", is_flag=True, help="From cold: toggle RIM in, read the BIN loader, read the program.")
@click.option("--trace", metavar="FILE", help="Write each instruction: time, L AC, MA MB, its listing.")
@click.option("--cycles", is_flag=True, help="Let --trace write each memory cycle.")
@click.option("--save", metavar="FILE", help="Write the machine's state as the run ends.")
@click.option(
    "--restore",
    metavar="FILE",
    help="Go on from a saved state, its tape in the reader unless --reader is given.",
)
@click.option("--quiet", is_flag=True, help="Do not say how the run ended, unless it failed.")
@click.pass_context
def run(
    ctx: click.Context,
    program: str | None,
    start: int,
    sr: int,
    reader: str | None,
    punch: str | None,
    fast_reader: str | None,
    fast_punch: str | None,
    keyboard: bool,
    max_time: float | None,
    realtime: bool,
    boot: bool,
    trace: str | None,
    cycles: bool,
    save: str | None,
    restore: str | None,
    quiet: bool,
) -> None:
    """Run PROGRAM on the PDP-8/L: standard input is the tape in its reader, standard output what it punches.

    PROGRAM is PAL III source, a BIN or a RIM tape, or the name of a bundled one, such as eia.pal.

    The last line says why the run stopped, where, what was read and punched, and how long it would have taken
    in 1971. Exit status: 0 HLT or out of tape, 1 the program cannot be run or did not end, 130 interrupted.
    A program that counts while it waits for its tape never ends: give it --max-time.

    \b
    Examples:
      pdp8 run eia.pal < circle.asc > circle.eia
      pdp8 run eia.pal --reader ellipse.asc --punch ellipse.eia
      pdp8 run eia.pal --boot < circle.asc > circle.eia
      pdp8 run echo.pal --keyboard --realtime
      pdp8 run eia.pal --trace eia.trace --max-time 1 < circle.asc > some.eia
      pdp8 run eia.pal --save noon.state --max-time 60 < circle.asc > first.eia
      pdp8 run --restore noon.state > rest.eia
      pdp8 run mine.bin --start 400 --sr 7777 --fast-reader in.tape --fast-punch out.tape
    """
    if (program is None) == (restore is None):
        raise click.UsageError("Give a PROGRAM, or --restore FILE and none.")
    if cycles and trace is None:
        raise click.UsageError("--cycles means nothing without --trace.")
    if restore is not None:
        _refuse(ctx, "--restore", ("start", "sr", "boot", "fast_reader"))
    page = None if keyboard else "-"
    command.check_files([program, reader, fast_reader, restore], [punch or page, fast_punch, trace, save])
    if keyboard and not (sys.stdin.isatty() and sys.stdout.isatty()):
        raise click.UsageError("--keyboard needs a terminal to type and print at.")
    if restore is not None:
        machine = _restored(restore, reader)
    else:
        assert program is not None
        machine = Machine(highspeed=fast_reader is not None or fast_punch is not None)
        if boot:
            _boot(machine, program, quiet)
        else:
            machine.load(read_words(program))
        machine.sr = sr
        used = keyboard or "-" in (program, fast_reader)
        machine.teletype.reader.load(_tape(reader, used, quiet))
        if fast_reader is not None:
            machine.highspeed.reader.load(shelf.read(fast_reader))
        machine.start(start)
    outputs = _outputs(machine, punch, fast_punch, keyboard)
    with ExitStack() as stack:
        if trace is not None:
            stack.enter_context(_traced(machine, trace, program, cycles))
        if keyboard:
            stop = _typed(machine, outputs, max_time, realtime)
        else:
            stop = _run(machine, outputs, max_time, realtime, quiet)
    if save is not None:
        _save(machine, save)
    if stop is None and keyboard:
        ctx.exit(0)
    if stop is None:
        _say(f"interrupted at {machine.pc:04o}{_counts(machine)}")
        ctx.exit(130)
    done = stop.reason in _DONE
    if not (quiet and done):
        last = machine.ma if stop.reason is Reason.HALT else stop.pc - 1 & 0o7777
        _say(_WHY[stop.reason].format(pc=stop.pc, last=last) + _counts(machine))
    ctx.exit(0 if done else 1)


def _refuse(ctx: click.Context, option: str, others: tuple[str, ...]) -> None:
    """Raise UsageError if any of `others` was given beside `option`, which leaves them nothing to do."""
    for name in others:
        if ctx.get_parameter_source(name) is ParameterSource.COMMANDLINE:
            raise click.UsageError(f"--{name.replace('_', '-')} means nothing beside {option}.")


def _outputs(machine: Machine, punch: str | None, fast_punch: str | None, keyboard: bool) -> list[_Output]:
    """Return where each punch's frames go; with the keyboard in use the page is the terminal's own."""
    outputs = [] if keyboard and punch is None else [_Output(machine.teletype.punch, punch)]
    if fast_punch is not None:
        outputs.append(_Output(machine.highspeed.punch, fast_punch))
    return outputs


def _run(
    machine: Machine, outputs: list[_Output], max_time: float | None, realtime: bool, quiet: bool
) -> Stop | None:
    """Run slice by slice, so that what is punched is seen as it is punched; return how it ended.

    Returns None if it was interrupted; what was punched is passed on all the same.
    """
    reader = machine.teletype.reader
    began = time.monotonic() - machine.elapsed
    longest = _REALTIME if realtime else _TRACED if machine.watch.observer else _LONGEST
    with Bar("reading tape", len(reader.tape), wanted=not quiet) as bar, ctrl_c() as interrupt:
        for stop in machine.slices(max_time, longest=longest):
            for output in outputs:
                output.send()
            bar.show(reader.position)
            if interrupt.pressed:
                machine.stop()
            elif realtime and stop.reason is Reason.LIMIT:
                time.sleep(max(0.0, machine.elapsed - (time.monotonic() - began)))
    return None if interrupt.pressed and stop.reason is Reason.STOP_KEY else stop


def _typed(machine: Machine, outputs: list[_Output], max_time: float | None, realtime: bool) -> Stop | None:
    from pdp8.cli.keyboard import sit_down

    def pass_on() -> None:
        for output in outputs:
            output.send()

    return sit_down(machine, max_time, realtime, pass_on)


def _traced(machine: Machine, name: str, program: str | None, cycles: bool) -> AbstractContextManager[None]:
    from pdp8.cli.listed import open_program
    from pdp8.cli.tracing import tracing
    from pdp8.computer.trace import Listing

    return tracing(machine, name, open_program(program).listing if program else Listing(), cycles)


def _save(machine: Machine, name: str) -> None:
    from pdp8.computer import state

    shelf.write(name, state.save(machine).encode())


def _restored(name: str, reader: str | None) -> Machine:
    """Return the saved machine, with another tape in its reader if one is given."""
    from pdp8.computer import state

    try:
        machine = state.restore(shelf.read(name).decode("ascii", "replace"))
    except state.StateError as error:
        raise WorkError(f"{name}: {error}") from error
    if reader is not None:
        machine.teletype.reader.load(shelf.read(reader))
    return machine


def _boot(machine: Machine, program: str, quiet: bool) -> None:
    """Load `program` as an operator does, saying what it took."""
    from pdp8.cli.listed import open_program
    from pdp8.computer import loaders
    from tapes import rim
    from tapes.measure import duration

    bin_loader = rim.encode(open_program("bin.pal").words)
    steps = loaders.boot(machine, bin_loader, open_program(program).tape, program)
    if not quiet:
        for step in steps:
            _say(str(step))
        _say(f"loaded in {duration(sum(step.seconds for step in steps))}, besides what the hands take")


def _tape(reader: str | None, used: bool, quiet: bool) -> bytes:
    """Return the tape for the reader, that on standard input unless it is `used` otherwise, and say so where
    it will not do what its owner thinks.
    """
    if reader is None and (used or sys.stdin.isatty()):
        frames, name = b"", "the reader"
    else:
        name = reader or "-"
        frames = shelf.read(name)
    if not quiet:
        lines = frames.translate(PARITIES["none"])
        if b"\n" in lines and b"\r" not in lines:
            shown = "the tape" if name == "-" else name
            _say(
                f"{shown} has line feeds but no carriage returns: no block will end. "
                "A proper tape is made from text with: pdp8 tape punch FILE -o FILE.asc"
            )
    return frames


def _counts(machine: Machine) -> str:
    """Say what was read and punched, and the time of 1971."""
    from tapes.measure import duration

    parts = [(machine.teletype.reader.position, len(machine.teletype.punch.frames), "")]
    if machine.highspeed.fitted:
        fast = machine.highspeed
        parts.append((fast.reader.position, len(fast.punch.frames), " at high speed"))
    told = "".join(f"; {_frames(read)} read, {_frames(punched)} punched{how}" for read, punched, how in parts)
    return f"{told}; {duration(machine.elapsed)} in 1971"


def _frames(count: int) -> str:
    return "1 frame" if count == 1 else f"{count or 'no'} frames" if count < 1000 else f"{count:,} frames"


def _say(message: str) -> None:
    click.echo(f"pdp8 run: {message}", err=True)
