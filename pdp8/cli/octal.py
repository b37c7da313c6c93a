"""Words and addresses as an operator types them: octal."""

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
