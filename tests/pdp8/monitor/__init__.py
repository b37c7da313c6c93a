"""The monitor's prompt: sessions word for word, and what no session shows."""

from pdp8.computer.past import state
from pdp8.monitor import commands
from pdp8.monitor.prompt import Monitor


def do(monitor: Monitor, *lines: str) -> None:
    for line in lines:
        commands.do(monitor, line)


def session(monitor: Monitor) -> dict[str, object]:
    """Return all that a line could change: each field of the session by its name, the machine saved."""
    watch, pace = monitor.machine.watch, monitor.operator.pace
    places = monitor.reels.places.values()
    fields = {name: [*each] if isinstance(each, list) else each for name, each in vars(monitor).items()}
    return fields | {
        "machine": state.save(monitor.machine),
        "watch": ({*watch.breakpoints}, {*watch.writes}, {*watch.reads}, watch.observer),
        "operator": (pace, monitor.operator.lever_waits),
        "reels": [(place.file, place.locked) for place in places],
        "punching": {**monitor.punching},
        "history": monitor.history.instructions,
    }
