"""Commands about what is in the rack: DECtapes on their drives, a DF32, a line printer."""

from pdp8 import fitting, reels
from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.hardware.bus import Peripheral
from pdp8.computer.rack.df32 import DF32
from pdp8.computer.rack.kw8 import KW8
from pdp8.computer.rack.lp08 import LP08
from pdp8.computer.rack.pt08 import PT08
from pdp8.computer.use import bootstrap
from pdp8.monitor import running, tapes
from pdp8.monitor.arguments import MonitorError, some
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
_NO_DISCS = "{}: no DF32 is fitted; attach df FILE fits it"


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
        monitor.attend(monitor.machine)


def fitted(monitor: Monitor, kind: str) -> bool:
    """Tell whether a device of the rack is there."""
    return any(isinstance(each, RACK[kind]) for each in monitor.machine.devices)


def attach(monitor: Monitor, device: str, name: str, locked: bool = False) -> None:
    """Mount a DECtape image on a drive, or fill the discs of a DF32. The file is not written."""
    mounted, place = monitor.reels, _place(device)
    _check_saved(monitor, place, device if place == "df" else place)
    where = "the DF32"
    if place == "df":
        fit(monitor, "df")
        mounted.fill(name)
    else:
        unit = reels.drive(place)
        mounted.read(unit, name)
        fit(monitor, "dt")
        for note in mounted.mount(unit, name, locked):
            monitor.say(f"{name}: {note}")
        where = f"{place}{', locked' if locked else ''}"
    monitor.say(f"{name} is on {where}; the file itself is not written")


def detach(monitor: Monitor, device: str, where: str) -> None:
    """Take a DECtape off its drive, or empty the discs; save them in FILE, or forget what was written."""
    mounted, place = monitor.reels, _place(device)
    if place not in mounted.names:
        raise MonitorError(_NO_DISCS.format(device) if place == "df" else f"{place}: no tape is mounted")
    if where not in ("", "forget"):
        monitor.say(mounted.save(place, where))
    elif not where:
        _check_saved(monitor, place, device)
    mounted.take_off(place)


def _place(device: str) -> str:
    """Return the name of a device of the rack as `Reels` has it: df0 is df. Raises WorkError."""
    return "df" if device.lower().startswith("df") else f"dt{reels.drive(device)}"


def _check_saved(monitor: Monitor, place: str, device: str) -> None:
    """Raise MonitorError if something was written and not saved."""
    if written := monitor.reels.said(place):
        raise MonitorError(f"{written}; detach {device} FILE saves them, or forget drops them")


def boot(monitor: Monitor, name: str, *more: str) -> None:
    """Load a program from cold as an operator does; with force, whatever its checksum. `boot ptr` reads what
    is in the reader by RIM.
    """
    if name.startswith("-"):
        name, *rest = some(more, "the name of a program")
        more = tuple(rest)
    if what := absent(monitor, name):
        raise MonitorError(f"{name}: {what}")
    if name.lower() in ("df", "df0"):
        if "df" not in monitor.reels.names:
            raise MonitorError(_NO_DISCS.format(name))
        toggled = bootstrap.DF32
    elif name.lower().startswith("dt") and name[2:].isdigit():
        unit = reels.drive(name)
        if f"dt{unit}" not in monitor.reels.names:
            raise MonitorError(f"{name}: no tape is mounted; attach {name} FILE")
        toggled = bootstrap.bootstrap(unit)
    else:
        tapes.boot(monitor, name, *more)
        return
    bootstrap.boot(monitor.machine, toggled)
    running.run(monitor)


def show(monitor: Monitor) -> None:
    """Say what is on the drives, if there are any."""
    mounted = monitor.reels
    for device in mounted.devices():
        number = mounted.changed(device)
        if device == "df":
            more = ", changed" if number else ""
        else:
            more = ", locked" if mounted.drives[reels.drive(device)].locked else ""
            more += f", {counted(number, 'blocks')} written" if number else ""
        monitor.say(f"{device:5}{mounted.names[device]}{more}")


def leave(monitor: Monitor) -> None:
    """Save what was written on reels and discs and not saved."""
    for said in monitor.reels.rescue():
        monitor.say(said)
