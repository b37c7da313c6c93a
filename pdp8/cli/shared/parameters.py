"""What options take: octal words, seconds of machine time."""

import click


def octal(text: str) -> int:
    """Return the word, 0000 to 7777. Raises click.BadParameter."""
    try:
        word = int(text, 8)
    except ValueError:
        raise click.BadParameter(f"{text!r} is not an octal number") from None
    if not 0 <= word <= 0o7777:
        raise click.BadParameter(f"{text} is not between 0000 and 7777")
    return word


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
