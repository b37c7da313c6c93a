"""The computer: a PDP-8/L, its Teletype, its panel.

processor    AC L PC MA MB IR, one memory cycle at a time: the one to read
engine       the same for long runs: core decoded once, compiled where it can be
operate      the OPR groups as pure functions
bus          IOP pulses, SKIP, interrupt request: what processor and devices say to each other
teletype     ASR-33: keyboard and reader (03), printer and punch (04)
highspeed    PC8/L: the high-speed reader (01) and punch (02)
panel        lamps, switches and keys
waiting      loops that only wait, passed over exactly
watch        breakpoints, words being written, whoever looks on
machine      the one place that knows every part and wires it
loaders      words into core; RIM and BIN as an operator loads them
trace        an instruction or a cycle a line, as in the listing
state        a whole machine as text, and back
monitor      the operator's prompt
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pdp8.machine import Machine, Stop

__all__ = ["Machine", "Stop"]


def __getattr__(name: str) -> object:
    """Import the machine when it is asked for: most commands need none."""
    if name not in __all__:
        raise AttributeError(f"module 'pdp8' has no attribute {name!r}")
    from pdp8 import machine

    return getattr(machine, name)
