"""The devices that come with the machine: one line each.

With its line a device is fitted by its NAME (`--device NAME`), a saved state that has it can be restored, and
the page has it.
"""

from pdp8.computer.hardware.bus import Peripheral
from pdp8.computer.hardware.highspeed import HighSpeed
from pdp8.computer.hardware.teletype import Teletype


def one_of_each() -> list[Peripheral]:
    """Return one device of every type, for a machine that has them all."""
    return [
        Teletype(),
        HighSpeed(),
    ]
