"""What all our commands have in common: how they end.

0 done, 1 the job failed, 2 misuse, 130 interrupted. An error is one line on standard error that names its
place; a closed pipe is no error, the reader had enough; a full disk is. No traceback reaches a user.
"""

import os
import sys
from collections.abc import Sequence

import click

from tapes.errors import WorkError


def run(command: click.Command, name: str, arguments: Sequence[str] | None = None) -> None:
    """Run `command` as program `name` and end the process with its exit status."""
    _reopen_closed_streams()
    sys.exit(_status(command, name, arguments))


def _reopen_closed_streams() -> None:
    """Give a standard stream that the caller closed (`>&-`) nothing to read from or to write to."""
    for stream, mode in (("stdin", "r"), ("stdout", "w"), ("stderr", "w")):
        if getattr(sys, stream) is None:
            setattr(sys, stream, os.fdopen(os.open(os.devnull, os.O_RDWR), mode))


def _status(command: click.Command, name: str, arguments: Sequence[str] | None) -> int:
    try:
        status = command.main(args=arguments, prog_name=name, standalone_mode=False)
        sys.stdout.flush()
    except WorkError as error:
        return _complain(f"{name}: {error}", error.exit_status)
    except click.exceptions.Exit as stop:
        return stop.exit_code
    except click.ClickException as error:
        error.show()
        return error.exit_code
    except (click.Abort, KeyboardInterrupt):
        return _complain(f"{name}: interrupted", 130)
    except BrokenPipeError:
        _silence(sys.stdout)
        return 1
    except OSError as error:
        _silence(sys.stdout)
        where = error.filename or "standard output"  # every file's errors are named by the shelf
        return _complain(f"{name}: {where}: {error.strerror or error}", 1)
    return status if isinstance(status, int) else 0


def _complain(message: str, status: int) -> int:
    click.echo(message, err=True)
    return status


def _silence(stream: object) -> None:
    """Point the closed stream at nothing, so that Python's own flush at exit stays quiet."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, stream.fileno())  # type: ignore[attr-defined]
