"""The machine room: a PDP-8/L, and what stands around it.

computer/   the machine itself: processor, engine, Teletype, panel, loaders
monitor/    the operator's prompt, for people and scripts
console/    the front panel in a terminal
replay/     the whole 1971 afternoon in one call
web/        pages for a browser
cli/        the command; `python -m pdp8` is the same

`Machine` and `Stop` are loaded when they are first asked for: most commands do without.
"""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pdp8.computer.machine import Machine
    from pdp8.computer.stop import Stop

    __version__: str

__all__ = ["Machine", "Stop"]
_MODULES = {"Machine": "pdp8.computer.machine", "Stop": "pdp8.computer.stop"}


def __getattr__(name: str) -> object:
    """Return what is not loaded yet, or the version of the installed package."""
    if name == "__version__":
        from importlib.metadata import version

        return version("pdp8")
    if name not in _MODULES:
        raise AttributeError(f"module 'pdp8' has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_MODULES[name]), name)


def __dir__() -> list[str]:
    """Return the names of the package, those that are not loaded yet too."""
    return sorted({*globals(), *__all__, "__version__"})
