"""`pdp8 run`: a program and its tape go in, the punched tape comes out, as it is punched."""

import sys
import time
from typing import BinaryIO

import click

from pdp8.cli.octal import octal
from pdp8.cli.program import read_words
from pdp8.cli.progress import Bar
from pdp8.machine import Machine, Stop
from tapes import shelf

_SLICE = 1.0  # seconds of machine time between two looks at the punch and at the clock
_WHY = {
    "halt": "HLT at {last:04o}",
    "tape out": "the reader ran out of tape, and the program waits for it at {pc:04o}",
    "idle": "an endless loop at {pc:04o} that nothing can end",
    "limit": "still running at {pc:04o} when --max-time was over",
    "stop key": "stopped before {pc:04o}",
    "protect": "MEM PROT stopped a write at {last:04o}",
}
_DONE = ("halt", "tape out")


class _Output:
    """Where the punched frames go as they are punched; at a terminal, the printed page instead."""

    def __init__(self, machine: Machine, name: str | None) -> None:
        self._machine = machine
        self._name = name or "standard output"
        self._sent = 0
        self._page = name is None and sys.stdout.isatty()
        self._stream: BinaryIO = sys.stdout.buffer if self._page else shelf.open_punch(name or "-")

    def send(self) -> None:
        """Pass on what was punched since the last time."""
        frames = self._machine.teletype.punch.tape
        fresh = frames[self._sent :]
        if not fresh:
            return
        try:
            self._stream.write(_printed(fresh) if self._page else fresh)
            self._stream.flush()
        except BrokenPipeError:
            raise
        except OSError as error:
            raise shelf.ShelfError(f"{self._name}: {error.strerror} after {self._sent:,} frames") from error
        self._sent = len(frames)


def _printed(frames: bytes) -> bytes:
    """Return what a Model 33 would print of the frames: without channel 8 and control codes."""
    codes = (frame & 0o177 for frame in frames)
    return bytes(code for code in codes if 0o40 <= code < 0o177 or code in b"\r\n")


@click.command()
@click.argument("program")
@click.option("--start", type=octal, default="0200", show_default=True, help="Address to start at, octal.")
@click.option("--sr", type=octal, default="0000", show_default=True, help="Switch register, octal.")
@click.option("--reader", metavar="FILE", help="Tape in the Teletype's reader.  [default: standard input]")
@click.option("--punch", metavar="FILE", help="Where the punched tape goes.  [default: standard output]")
@click.option(
    "--max-time", type=click.FloatRange(min=0), metavar="SECONDS", help="Stop after this machine time."
)
@click.option("--realtime", is_flag=True, help="Run no faster than a PDP-8/L did: 10 frames a second.")
@click.option("--quiet", is_flag=True, help="Do not say how the run ended, unless it failed.")
@click.pass_context
def run(
    ctx: click.Context,
    program: str,
    start: int,
    sr: int,
    reader: str | None,
    punch: str | None,
    max_time: float | None,
    realtime: bool,
    quiet: bool,
) -> None:
    """Run PROGRAM on the PDP-8/L: standard input is the tape in its reader, standard output what it punches.

    PROGRAM is PAL III source, a BIN or a RIM tape, or the name of a bundled one, such as eia.pal.

    The last line says why the run stopped, where, what was read and punched, and how long it would have taken
    in 1971. Exit status: 0 HLT or out of tape, 1 the program cannot be run or did not end, 130 interrupted.

    \b
    Examples:
      pdp8 run eia.pal < circle.asc > circle.eia
      pdp8 run eia.pal --reader ellipse.asc --punch ellipse.eia
      pdp8 run mine.bin --start 400 --sr 7777 --max-time 60 > out.tape
    """
    machine = Machine()
    machine.load(read_words(program))
    machine.sr = sr
    machine.teletype.reader.load(_tape(program, reader, quiet))
    output = _Output(machine, punch)
    machine.start(start)
    try:
        stop = _run(machine, output, max_time, realtime, quiet)
    except KeyboardInterrupt:
        output.send()
        _say(f"interrupted at {machine.pc:04o}{_counts(machine)}")
        ctx.exit(130)
    done = stop.reason in _DONE
    if not (quiet and done):
        last = machine.ma if stop.reason == "halt" else stop.pc - 1 & 0o7777
        _say(_WHY[stop.reason].format(pc=stop.pc, last=last) + _counts(machine))
    ctx.exit(0 if done else 1)


def _run(machine: Machine, output: _Output, max_time: float | None, realtime: bool, quiet: bool) -> Stop:
    """Run slice by slice, so that what is punched is seen as it is punched; return how it ended."""
    reader = machine.teletype.reader
    began = time.monotonic()
    with Bar("reading tape", len(reader.tape), wanted=not quiet) as bar:
        while True:
            left = _SLICE if max_time is None else min(_SLICE, max_time - machine.elapsed)
            stop = machine.run(seconds=left)
            output.send()
            bar.show(reader.position)
            if stop.reason != "limit" or (max_time is not None and stop.elapsed >= max_time):
                return stop
            if realtime:
                time.sleep(max(0.0, machine.elapsed - (time.monotonic() - began)))


def _tape(program: str, reader: str | None, quiet: bool) -> bytes:
    """Return the tape for the reader, and say so where it will not do what its owner thinks."""
    if reader is None and (program == "-" or sys.stdin.isatty()):
        frames, name = b"", "the reader"
    else:
        name = reader or "-"
        frames = shelf.read(name)
    if not quiet:
        lines = frames.translate(_CHANNELS_1_TO_7)
        if b"\n" in lines and b"\r" not in lines:
            shown = "the tape" if name == "-" else name
            _say(
                f"{shown} has line feeds but no carriage returns: no block will end. "
                "A proper tape is made from text with: pdp8 tape punch FILE -o FILE.asc"
            )
    return frames


_CHANNELS_1_TO_7 = bytes(frame & 0o177 for frame in range(256))


def _counts(machine: Machine) -> str:
    """Say what was read and punched, and the time of 1971."""
    from tapes.measure import duration

    read, punched = machine.teletype.reader.position, len(machine.teletype.punch.tape)
    return f"; {_frames(read)} read, {_frames(punched)} punched; {duration(machine.elapsed)} in 1971"


def _frames(count: int) -> str:
    return f"{count or 'no'} frames" if count < 1000 else f"{count:,} frames"


def _say(message: str) -> None:
    click.echo(f"pdp8 run: {message}", err=True)
