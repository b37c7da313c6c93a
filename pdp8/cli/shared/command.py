"""What all our commands have in common: how they end, what they say, how a product leaves them.

0 done, 1 the job failed, 2 misuse, 130 interrupted. An error is one line on standard error that names its
place; a closed pipe is no error, the reader had enough, and every named file is written all the same; a full
disk is one. No traceback reaches a user, and no control code of a file's at a terminal.
"""

import errno
import os
import signal
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, redirect_stdout, suppress
from io import TextIOWrapper, UnsupportedOperation
from types import FrameType
from typing import BinaryIO

import click

from pdp8 import leaving, shelf
from tapes.errors import WorkError, called, visible

_NAMED = 6
"""At most so many files in a folder are named one by one."""
_IMPORTING = "<frozen importlib._bootstrap>"
_HELP = ["-h", "--help"]
_NO_CLOBBER = "pdp8.cli.shared.command.no_clobber"
QUIET = "pdp8.cli.shared.command.quiet"
"""The key of a command's context that is set if it does not name the files it writes."""

_NoArguments = getattr(click.exceptions, "NoArgsIsHelpError", ())  # click 8.2 and later; 8.1 prints the help


def run(command: click.Command, name: str, arguments: Sequence[str] | None = None) -> None:
    """Run `command` as program `name` and end the process with its exit status."""
    _reopen_closed_streams()
    _take_any_character()
    _take_signals()
    given = sys.argv[1:] if arguments is None else arguments
    before = signal.getsignal(signal.SIGINT)
    if before is not signal.SIG_IGN:  # as a shell has it for what runs in the background
        signal.signal(signal.SIGINT, _interrupt)
    ended = status(command, name, given)
    signal.signal(signal.SIGINT, before)
    sys.exit(ended)


def _take_signals() -> None:
    """End as SIGTERM asks, and SIGHUP of a terminal that is closed."""
    for number in leaving.heard(*leaving.ENDS):
        signal.signal(number, lambda number, _: sys.exit(128 + number))  # what is half written goes


def _interrupt(number: int, frame: FrameType | None) -> None:
    """Take Ctrl-C; within an import, where an exception can leave a module half made, end the process."""
    while frame:
        if frame.f_code.co_filename == _IMPORTING:
            os._exit(128 + number)
        frame = frame.f_back
    raise KeyboardInterrupt


def tell(message: str, styled: bool = False) -> None:
    """Write a line on standard error; only a `styled` message keeps its control codes, which are colours."""
    try:
        color = False if os.environ.get("NO_COLOR") else None
        click.echo(message if styled else visible(message), err=True, color=color)
    except OSError:
        silence(sys.stderr)


def say(message: str) -> None:
    """Write a progress message, with the command's name, on standard error."""
    tell(f"{click.get_current_context().command_path}: {message}")


def say_of(file: str, notes: Iterable[str]) -> None:
    """Write notes about a file that was read, a line each."""
    for note in notes:
        say(f"{called(file)}: {note}")


def echo(text: str, nl: bool = True) -> None:
    """Write on standard output; a terminal is shown control codes, and one that is closed ends nothing."""
    try:
        click.echo(visible(text) if sys.stdout.isatty() else text, nl=nl, color=True)  # takes nothing out
    except OSError as error:
        if error.errno not in (errno.EPIPE, errno.EIO):
            raise
        silence(sys.stdout)


def keep(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    """Take the option --no-clobber."""
    ctx.meta[_NO_CLOBBER] = wanted


def keeps(ctx: click.Context) -> bool:
    """Tell whether --no-clobber was given."""
    return bool(ctx.meta.get(_NO_CLOBBER))


def check_output(name: str) -> None:
    """Raise ShelfError where `name` cannot be written, or is a file and --no-clobber was given."""
    shelf.check_writable(name)
    if keeps(click.get_current_context()) and os.path.isfile(name):
        raise shelf.ShelfError(f"{name} exists, and --no-clobber forbids to replace it")


def put(name: str, product: str | bytes) -> None:
    """Put a product, a tape as bytes or a text, where asked, and say which file it is. Raises ShelfError."""
    content = product.encode(errors="backslashreplace") if isinstance(product, str) else product
    if name != "-":
        tell_written(name, shelf.write(name, content))
        return
    try:
        if isinstance(product, bytes):
            shelf.open_punch("-").write(content)
        elif sys.stdout.isatty():
            click.echo(visible(product), nl=False)
        else:  # in UTF-8, whatever the stream's encoding is
            click.echo(content, nl=False)
    except BrokenPipeError:
        silence(sys.stdout)


def put_all(folder: str, files: Iterable[tuple[str, bytes]]) -> None:
    """Write files into a folder, which is made, and name those written in one line. Raises ShelfError."""
    names, replaced = [], 0
    shelf.make_folder(folder)
    try:
        for name, content in files:
            path = os.path.join(folder, name)
            check_output(path)
            replaced += shelf.write(path, content)
            names.append(name)
    finally:
        said = ", ".join(names) if len(names) <= _NAMED else f"{len(names)} files"
        if names:
            tell(f"wrote {said} in {folder}" + (f"; {replaced} replaced" if replaced else ""))


def tell_written(name: str, replaced: bool) -> None:
    """Say that a file was written, in the one form that all commands have."""
    if not click.get_current_context().meta.get(QUIET):
        tell(shelf.told(name, replaced))


def _take_any_character() -> None:
    """Replace characters that the output's encoding lacks by "?"; Python spells those of errors."""
    if isinstance(sys.stdout, TextIOWrapper) and sys.stdout.errors == "strict":
        sys.stdout.reconfigure(errors="replace")


def _reopen_closed_streams() -> None:
    """Give a stream that the caller closed (`>&-`) nothing to read; writing to it is an error."""
    streams = (("stdin", "r", os.O_RDWR), ("stdout", "w", os.O_RDONLY), ("stderr", "w", os.O_RDWR))
    for stream, mode, access in streams:
        if getattr(sys, stream) is None:
            setattr(sys, stream, os.fdopen(os.open(os.devnull, access), mode))


@contextmanager
def conversation() -> Iterator[tuple[BinaryIO, BinaryIO]]:
    """Yield standard input and output for a protocol; other input is empty, other output is an error's."""
    reader, writer = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    with open(os.devnull) as nothing, redirect_stdout(sys.stderr):
        sys.stdin = nothing
        yield reader, writer


def status(command: click.Command, name: str, arguments: Sequence[str]) -> int:
    """Run `command` as program `name`, print its error if any, and return the exit status."""
    stdout = sys.stdout
    try:
        with shelf.watched():
            ended = command.main(list(arguments), name, standalone_mode=False, help_option_names=_HELP)
        sys.stdout.flush()
    except WorkError as error:
        path = _path(command, name, arguments)
        hint = f"\n{path} --help shows what there is" * (error.exit_status == 2)
        return _complain(f"{path}: {error}{hint}", error.exit_status)
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
        silence(sys.stdout)
        return 0
    except RecursionError:
        return _complain(f"{_path(command, name, arguments)}: nested too deeply", 1)
    except MemoryError:
        return _complain(f"{_path(command, name, arguments)}: out of memory", 1)
    except SystemExit:
        if sys.stdout is not stdout:  # click puts a silent one there as it meets a closed pipe
            return 0
        raise
    except OSError as error:
        silence(sys.stdout)
        gone = isinstance(error, FileNotFoundError)  # as os.getcwd has it
        where = error.filename or ("the current folder" if gone else "standard output")
        return _complain(f"{_path(command, name, arguments)}: {where}: {error.strerror or error}", 1)
    except Exception as error:
        fitting = sys.modules.get("pdp8.fitting")  # there only if a device of somebody's is
        said = fitting.fault(error) if fitting else ""
        if not said:
            raise
        return _complain(f"{_path(command, name, arguments)}: {said}", 1)
    finally:
        try:
            sys.stdout.flush()
        except OSError:  # Python's own flush, at exit, would fail again, and change the status to 120
            silence(sys.stdout)
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
    tell(message)
    return status


def silence(stream: object) -> None:
    """Point a closed stream at nothing, so that Python's flush at exit is quiet; a notebook's has no file."""
    with suppress(UnsupportedOperation):
        where = stream.fileno()  # type: ignore[attr-defined]
        os.dup2(os.open(os.devnull, os.O_WRONLY), where)
