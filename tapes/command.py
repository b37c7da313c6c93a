"""What all our commands have in common: how they end.

0 done, 1 the job failed, 2 misuse, 130 interrupted. An error is one line on standard error that names its
place; a closed pipe is no error, the reader had enough; a full disk is. No traceback reaches a user.
"""

import os
import signal
import sys
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from io import TextIOWrapper, UnsupportedOperation
from types import FrameType
from typing import Any, TextIO, TypeVar

import click

from tapes import shelf
from tapes.errors import WorkError, called

_Function = TypeVar("_Function", bound=Callable[..., Any])

_NoArguments = getattr(click.exceptions, "NoArgsIsHelpError", ())  # click 8.2 and later; 8.1 prints the help


class Option(click.Option):
    """An option that also answers to other names, which its help leaves out."""

    def __init__(self, names: Sequence[str], *, also: Sequence[str] = (), **settings: Any) -> None:
        super().__init__(names, **settings)
        self._also = also

    def add_to_parser(self, parser: Any, ctx: click.Context) -> None:
        """Let the parser know all names."""
        shown, self.opts = self.opts, [*self.opts, *self._also]
        super().add_to_parser(parser, ctx)
        self.opts = shown


def output(
    metavar: str = "FILE",
    default: str | None = "-",
    help: str = "Where to; standard output if not given.",
    **settings: Any,
) -> Callable[[_Function], _Function]:
    """Return the decorator that adds `-o`, `--out`: where a command's product goes, a file or a folder."""
    names = "-o", "--out", "output"
    if default is not None:  # click takes a given None for an answer, even where one is required
        settings["default"] = default
    return click.option(*names, cls=Option, also=("--output",), metavar=metavar, help=help, **settings)


def run(command: click.Command, name: str, arguments: Sequence[str] | None = None) -> None:
    """Run `command` as program `name` and end the process with its exit status."""
    _reopen_closed_streams()
    _take_any_character()
    _take_signals()
    sys.exit(status(command, name, sys.argv[1:] if arguments is None else arguments))


def _take_signals() -> None:
    """End as SIGTERM asks, and SIGHUP of a terminal that is closed: Windows has none, `nohup` ignores it."""
    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is not signal.SIG_IGN:
            signal.signal(number, _end)


def _end(number: int, frame: FrameType | None) -> None:
    """End as the signal asks, with every file that is being written cleaned up."""
    sys.exit(128 + number)


def say(message: str) -> None:
    """Say on standard error how the work goes, after the name of the command."""
    click.echo(f"{click.get_current_context().command_path}: {message}", err=True)


def say_of(file: str, notes: Iterable[str]) -> None:
    """Say what there is to say of a file that was read, a line a note."""
    for note in notes:
        say(f"{called(file)}: {note}")


def check_files(sources: Iterable[str | None], outputs: Iterable[str | None]) -> None:
    """Raise a UsageError where standard input is to be read twice, two outputs are one, or one is a source;
    a ShelfError where an output cannot be written. Nothing is opened. Say where a file hides a bundled one.

    Both are names as the commands take them, None for none.
    """
    read = [name for name in sources if name is not None]
    if read.count("-") > 1:
        raise click.UsageError("standard input can be read only once")
    files = [name for name in read if name != "-"]
    taken = {os.path.realpath(shelf.find(name)): f"{name} is the source; name another file" for name in files}
    for source in files:
        if shelf.hides(source):
            say(f"{source} {shelf.HIDES}")
    for name in outputs:
        if name is None:
            continue
        if name in files:
            raise click.UsageError(f"{name} is the source; name another file")
        shelf.check_writable(name)
        if os.path.exists(name) and not os.path.isfile(name):
            continue
        path = name if name == "-" else os.path.realpath(name)
        if path in taken:
            raise click.UsageError(taken[path])
        taken[path] = f"two outputs go to {'standard output' if name == '-' else name}"


def _take_any_character() -> None:
    """Let standard output and error show a question mark for a character that their encoding has not."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper) and stream.errors == "strict":
            stream.reconfigure(errors="replace")


def _reopen_closed_streams() -> None:
    """Give a standard stream that the caller closed (`>&-`) nothing to read from; what is written to standard
    output then is an error, as it is for every other program.
    """
    streams = (("stdin", "r", os.O_RDWR), ("stdout", "w", os.O_RDONLY), ("stderr", "w", os.O_RDWR))
    for stream, mode, access in streams:
        if getattr(sys, stream) is None:
            setattr(sys, stream, os.fdopen(os.open(os.devnull, access), mode))


def status(command: click.Command, name: str, arguments: Sequence[str]) -> int:
    """Run `command` as program `name`; say what is wrong with it, and return its exit status."""
    stdout = sys.stdout
    try:
        ended = command.main(args=list(arguments), prog_name=name, standalone_mode=False)
        sys.stdout.flush()
    except WorkError as error:
        _write_or_drop(sys.stdout)
        return _complain(f"{_path(command, name, arguments)}: {error}", error.exit_status)
    except click.exceptions.Exit as stop:
        return stop.exit_code
    except _NoArguments as error:
        return _complain(error.format_message(), error.exit_code)
    except click.ClickException as error:
        path = error.ctx.command_path if isinstance(error, click.UsageError) and error.ctx else name
        return _complain(
            f"{path}: {error.format_message()}\n{path} --help shows what there is", error.exit_code
        )
    except (click.Abort, KeyboardInterrupt):
        return _complain(f"{_path(command, name, arguments)}: interrupted", 130)
    except BrokenPipeError:
        _silence(sys.stdout)
        return 0
    except SystemExit:
        if sys.stdout is not stdout:  # click puts a silent one there as it meets a closed pipe
            return 0
        raise
    except OSError as error:
        _silence(sys.stdout)
        where = error.filename or "standard output"  # every file's errors are named by the shelf
        return _complain(f"{_path(command, name, arguments)}: {where}: {error.strerror or error}", 1)
    return ended if isinstance(ended, int) else 0


def _path(command: click.Command, name: str, arguments: Sequence[str]) -> str:
    """Return the name of the command that was called, `pdp8 tape show`."""
    for argument in arguments:
        found = None
        if isinstance(command, click.Group):
            found = command.get_command(click.Context(command), argument)
        if found is None:
            break
        command, name = found, f"{name} {argument}"
    return name


def _complain(message: str, status: int) -> int:
    with suppress(BrokenPipeError):
        click.echo(message, err=True)
    return status


def _write_or_drop(stream: TextIO) -> None:
    """Write what the stream still holds, or drop it: Python's own flush at exit would complain once more."""
    try:
        stream.flush()
    except OSError:
        _silence(stream)


def _silence(stream: object) -> None:
    """Point the closed stream at nothing, so that Python's own flush at exit stays quiet.

    A notebook's stream has no file, and is left alone.
    """
    with suppress(UnsupportedOperation):
        where = stream.fileno()  # type: ignore[attr-defined]
        os.dup2(os.open(os.devnull, os.O_WRONLY), where)
