"""Commands about what the machine has done: undoing it.

    back                     the last instruction          back 20 cycles, 3 characters, 2 blocks, 3.5 seconds
    back until NEXT          to before NEXT was last executed, or after the last JMS to it
    back until HOLD written  to before HOLD was last written
    back until 03 flag       to when the flag of device 03 last rose

Words, keys, switches and tapes set since go back too. Counts are octal, as everywhere here; seconds are not.
"""

from collections.abc import Callable, Mapping

from pdp8.computer.past import rewind
from pdp8.computer.past.history import History
from pdp8.monitor.arguments import MonitorError, octal, seconds, some
from pdp8.monitor.prompt import Monitor

_MEASURES: Mapping[str, Callable[[History, int], None]] = {
    "instructions": rewind.instructions,
    "cycles": rewind.cycles,
    "characters": rewind.characters,
    "blocks": rewind.blocks,
}
_MOST = (1 << 36) - 1
_WHAT = "[N] [instructions|cycles|characters|blocks|seconds], or until A [written|flag],"


def back(monitor: Monitor, *arguments: str) -> None:
    """Undo N instructions (1), cycles, characters, blocks, seconds; or until A was executed or written."""
    if arguments[:1] == ("until",):
        _until(monitor, *some(arguments[1:], _WHAT, 1, 2))
    else:
        _measured(monitor, *some(arguments, _WHAT, 0, 2))
    monitor.went_back()
    monitor.say_where("back")


def _measured(monitor: Monitor, count: str = "1", unit: str = "instructions") -> None:
    measure = unit.removesuffix("s") + "s"
    if measure == "seconds":
        rewind.seconds(monitor.history, seconds(count))
    elif measure in _MEASURES:
        _MEASURES[measure](monitor.history, octal(count, _MOST))
    else:
        raise MonitorError(f"{unit}: there are {', '.join(_MEASURES)} and seconds")


def _until(monitor: Monitor, place: str, how: str = "left") -> None:
    if how == "flag":
        rewind.until_flag(monitor.history, octal(place, 0o77))
    elif how == "written":
        rewind.until_written(monitor.history, monitor.address(place))
    elif how == "left":
        rewind.until_left(monitor.history, monitor.address(place))
    else:
        raise MonitorError(f"{_WHAT} expected")
