"""What options take: octal words, seconds of machine time; and the options that several commands have."""

from collections.abc import Callable
from typing import Any, TypeVar

import click

from pdp8.cli.shared.rules import option
from tapes.errors import WorkError

_Function = TypeVar("_Function", bound=Callable[..., Any])
_Value = TypeVar("_Value")


def dialect_option(needs: str = "") -> Callable[[_Function], _Function]:
    """Return the decorator that adds --dialect."""
    from pdp8.computer.use.program import DIALECTS, FOUND

    kind = click.Choice(DIALECTS)
    return option("--dialect", "Dialect of PAL source.", kind, default=FOUND, show_default=False, needs=needs)


def drive(text: str) -> tuple[str, str]:
    """Return the device of a drive and the file, of N=FILE. Raises click.BadParameter."""
    from pdp8.reels import assignment

    return _read(assignment, text)


def _device(text: str) -> str:
    """Return what names a device. Raises click.BadParameter."""
    from pdp8.fitting import file_of

    _read(file_of, text)
    return text


def _read(read: Callable[[str], _Value], text: str) -> _Value:
    try:
        return read(text)
    except WorkError as error:
        raise click.BadParameter(str(error)) from None


device_option = option(
    "--device",
    "Fit a device, such as highspeed or kw8, or a class in a Python file of your own.",
    _device,
    multiple=True,
    metavar="NAME|FILE:CLASS",
)


def octal(text: str) -> int:
    """Return the word, 0000 to 7777. Raises click.BadParameter."""
    return _octal(text, 0o7777)


def address(text: str) -> int:
    """Return an address, perhaps with its field: 0000 to 77777. Raises click.BadParameter."""
    return _octal(text, 0o77777)


def _octal(text: str, most: int) -> int:
    try:
        word = int(text, 8)
    except ValueError:
        raise click.BadParameter(f"{text!r} is not an octal number") from None
    if not 0 <= word <= most:
        raise click.BadParameter(f"{text} is not between 0000 and {most:o}")
    return word


def check_start(start: int, memory: int) -> None:
    """Raise a UsageError for an address beyond `memory` words of core."""
    if start >= memory:
        raise click.UsageError(
            f"--start {start:o} is not between 0000 and {memory - 1:o}; --memory adds core."
        )


def seconds(text: str) -> float:
    """Return a machine time: 0 to a thousand million seconds, 31 years. Raises click.BadParameter."""
    return _seconds(text, "0", "1e9")


def processor_seconds(text: str) -> float:
    """Return a time of this computer's: a tenth of a second to an hour. Raises click.BadParameter."""
    return _seconds(text, "0.1", "3600")


def _seconds(text: str, least: str, most: str) -> float:
    try:
        time = float(text)
    except ValueError:
        raise click.BadParameter(f"{text!r} is not a number of seconds") from None
    if not float(least) <= time <= float(most):
        raise click.BadParameter(f"{text} is not between {least} and {most} seconds")
    return time
