"""What the tests of this folder share: a machine with words in it, and single instructions."""

from collections.abc import Mapping

from pdp8.computer.machine import Machine


def machine(words: Mapping[int, int], highspeed: bool = False) -> Machine:
    """Return a machine with `words` in core, started at 0200."""
    made = Machine(highspeed)
    made.load(words)
    made.start(0o200)
    return made


def program(*words: int) -> Machine:
    """Return a machine with `words` from 0200 on, started there."""
    return machine(dict(enumerate(words, 0o200)))


def octal(words: str) -> list[int]:
    """Return the octal numbers of a string such as "7200 1205"."""
    return [int(word, 8) for word in words.split()]
