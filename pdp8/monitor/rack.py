"""Commands about what is in the rack: DECtapes on their drives, a DF32, a line printer."""

import re

from pdp8 import fitting, reels
from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.hardware.bus import Peripheral
from pdp8.computer.rack.df32 import DF32
from pdp8.computer.rack.kw8 import KW8
from pdp8.computer.rack.lp08 import LP08
from pdp8.computer.rack.pt08 import PT08
from pdp8.computer.use import bootstrap
from pdp8.monitor import running, tapes
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.prompt import Monitor
from tapes.quantities import counted

RACK: dict[str, type[Peripheral]] = {"dt": TC08, "df": DF32, "lpt": LP08}
"""Devices that attaching a file fits, by SIMH's names."""
_NEVER = {
    "rk": "an RK8E disk",
    "rl": "an RL8A disk",
    "rx": "an RX8E floppy",
    "td": "a TD8E DECtape",
    "mt": "a TM8E magnetic tape",
    "ct": "a TA8E cassette",
    "fpp": "an FPP8A",
    "tsc": "a TSC8-75",
    "vc": "a VC8E display",
    "clk": "a DK8E clock",
    **dict.fromkeys(("ttix", "ttox"), "a KL8JA Teletype"),
}
"""Devices of SIMH's PDP-8/E, by their names there."""
_ELSE: dict[str, type[KW8 | PT08]] = {"clk": KW8, "ttix": PT08, "ttox": PT08}
"""What a PDP-8/L could have in their place."""
_LOCKS = {"locked": 1, "writeenabled": 0}
_DEVICE = re.compile(r"dt\d+|df0?", re.IGNORECASE)


def absent(monitor: Monitor, name: str) -> str:
    """Return what a SIMH device is that this machine lacks, "" for other words."""
    kind = name.lower().rstrip("0123456789")
    if kind == "rf":
        return "an RF08 disk, which is not emulated; df is a DF32"
    if kind not in _NEVER:
        return ""
    why = f"{_NEVER[kind]}, which no PDP-8/L had"
    if kind not in _ELSE:
        return f"{why}; dt0 to dt7 are a TC08's" if kind == "td" else why
    other = _ELSE[kind]
    here = any(isinstance(each, other) for each in monitor.machine.devices)
    return f"{why}; a {other.__name__} is fitted{'' if here else f' by pdp8 monitor --device {other.NAME}'}"


def fit(monitor: Monitor, kind: str) -> None:
    """Fit a device of the rack, if it is not there."""
    if not fitted(monitor, kind):
        fitting.fit(monitor.machine, [RACK[kind]])
        monitor.reels.look_at(monitor.machine.devices)
        monitor.history = type(monitor.history)(monitor.machine)


def fitted(monitor: Monitor, kind: str) -> bool:
    """Tell whether a device of the rack is there."""
    return any(isinstance(each, RACK[kind]) for each in monitor.machine.devices)


def attach(monitor: Monitor, device: str, name: str, locked: bool = False) -> None:
    """Mount a DECtape image on a drive, or fill the discs of a DF32. The file is not written."""
    device = reels.device(device)
    kind = device.rstrip("01234567")
    _check_saved(monitor, device)
    if not fitted(monitor, kind):
        reels.Reels().mount(device, name)  # a file that is refused fits nothing
        fit(monitor, kind)
    monitor.reels.discs.changes(monitor.machine.processor.clock)
    for note in monitor.reels.mount(device, name, locked):
        monitor.say(f"{name}: {note}")
    place = monitor.reels.places[device]
    monitor.say(f"{name} is on {place.called}{', locked' * place.locked}; the file itself is not written")


def detach(monitor: Monitor, device: str, where: str) -> None:
    """Take a DECtape off its drive, or empty the discs; save them in FILE, or forget what was written."""
    place = _mounted(monitor, device)
    monitor.reels.discs.changes(monitor.machine.processor.clock)
    if where not in ("", "forget"):
        monitor.say(monitor.reels.save(place.device, where))
    elif not where:
        _check_saved(monitor, place.device)
    place.take_off()


def _mounted(monitor: Monitor, device: str) -> reels.Reel | reels.Discs:
    """Return the place that a name such as dt0 or df0 is of. Raises WorkError where nothing is mounted."""
    place = monitor.reels.places[reels.device(device)]
    if not place.file:
        raise MonitorError(f"{device}: {place.missing}")
    return place


def _check_saved(monitor: Monitor, device: str) -> None:
    """Raise MonitorError if something was written and not saved."""
    if written := monitor.reels.said(device):
        raise MonitorError(f"{written}; detach {device} FILE saves them, or forget drops them")


def lock(monitor: Monitor, device: str, value: str) -> bool:
    """Throw WRITE LOCK of a drive; return False for a word that is not of it."""
    found = [position for word, position in _LOCKS.items() if value and word.startswith(value)]
    if not found:
        return False
    place = _mounted(monitor, device)
    if isinstance(place, reels.Discs):
        raise MonitorError(f"{device}: no switch locks the discs")
    place.drive.locked = found[0]
    return True


def boot(monitor: Monitor, name: str, *more: str) -> None:
    """Load a program from cold as an operator does; with force, whatever its checksum. ptr, what is in the
    reader, and dt0 or df run as `run` does.
    """
    if what := absent(monitor, name):
        raise MonitorError(f"{name}: {what}")
    if _DEVICE.fullmatch(name):
        running.goal_of(more)
        bootstrap.boot(monitor.machine, _mounted(monitor, name).bootstrap)
        running.run(monitor, *more)
    else:
        tapes.boot(monitor, name, *more)


def show(monitor: Monitor) -> None:
    """Say what is on the drives, if there are any."""
    for place in monitor.reels.mounted():
        written = f", {counted(place.changed(), place.unit)} written" * bool(place.changed())
        monitor.say(f"{place.device:5}{place.file}{', locked' * place.locked}{written}")


def leave(monitor: Monitor) -> None:
    """Save what was written on reels and discs and not saved."""
    for said in monitor.reels.rescue():
        monitor.say(said)
