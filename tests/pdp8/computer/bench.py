"""What the tests of this folder share: core in one line, and a machine with words in it."""

from pdp8.computer.machine import Machine
from tests.pdp8.computer.speed.forms import machine_module


def core(words: str) -> dict[int, int]:
    """Return {address: word} of octal words from 0200 on; "20/" sets the address as DEC's ODT has it."""
    found: dict[int, int] = {}
    address = 0o200
    for word in words.split():
        if word.endswith("/"):
            address = int(word[:-1], 8)
        else:
            found[address] = int(word, 8)
            address = address + 1 & 0o7777
    return found


def octal(words: str) -> list[int]:
    """Return the octal numbers of a string such as "7200 1205"."""
    return [int(word, 8) for word in words.split()]


def machine(
    words: str = "",
    tape: bytes | None = None,
    highspeed: bool = False,
    form: str = "",
    field: int = 0,
    **registers: int,
) -> Machine:
    """Return a machine with `core(words)` in a field and a tape in its reader, started at 0200 there, then
    `registers` set; `form` is one of the package's, else the one in use.
    """
    made: Machine = (machine_module(form).Machine if form else Machine)(memory=(field + 1) << 12)
    if highspeed:
        made.fit(made.highspeed)
    made.load({field << 12 | address: word for address, word in core(words).items()})
    if tape is not None:
        (made.highspeed if highspeed else made.teletype).reader.load(tape)
    made.start(field << 12 | 0o200)
    for name, value in registers.items():
        setattr(made, name, value)
    return made
