"""The machine room: a PDP-8/L, and what stands around it.

computer/   the machine itself: processor, engine, Teletype, panel, loaders
monitor/    the operator's prompt, for people and scripts
console/    the front panel in a terminal
replay/     the whole 1971 afternoon in one call
web/        pages for a browser
cli/        the command
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pdp8.computer.machine import Machine, Stop

__all__ = ["Machine", "Stop"]


def __getattr__(name: str) -> object:
    """Import the machine when it is asked for: most commands need none."""
    if name not in __all__:
        raise AttributeError(f"module 'pdp8' has no attribute {name!r}")
    from pdp8.computer import machine

    return getattr(machine, name)
