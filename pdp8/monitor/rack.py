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
"""What is fitted as it is attached, by SIMH's names."""
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
"""What a PDP-8/L could have for them."""
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
    mounted = monitor.reels
    if device.lower().startswith("df"):
        _check_saved(mounted.said_of_discs(), device)
        fit(monitor, "df")
        mounted.fill(name)
        monitor.say(f"{name} is on the DF32; the file itself is not written")
        return
    unit = reels.drive(device)
    _check_saved(_written(monitor, unit), f"dt{unit}")
    mounted.read(unit, name)
    fit(monitor, "dt")
    for note in mounted.mount(unit, name, locked):
        monitor.say(f"{name}: {note}")
    monitor.say(f"{name} is on dt{unit}{', locked' if locked else ''}; the file itself is not written")


def detach(monitor: Monitor, device: str, where: str) -> None:
    """Take a DECtape off its drive, or empty the discs; save them in FILE, or forget what was written."""
    mounted = monitor.reels
    discs = device.lower().startswith("df")
    unit = 0 if discs else reels.drive(device)
    if not discs and unit not in mounted.names:
        raise MonitorError(f"dt{unit}: no tape is mounted")
    if discs and not mounted.discs:
        raise MonitorError(_NO_DISCS.format(device))
    if where not in ("", "forget"):
        monitor.say(mounted.save_discs(where) if discs else mounted.save(unit, where))
    elif not where:
        _check_saved(mounted.said_of_discs() if discs else _written(monitor, unit), device)
    if discs:
        mounted.empty()
    else:
        mounted.unmount(unit)


def _written(monitor: Monitor, unit: int) -> str:
    """Say how many blocks of a reel were written and not saved, "" for none."""
    written = unit in monitor.reels.names and monitor.reels.changed(unit)
    return monitor.reels.said(unit) if written else ""


def _check_saved(written: str, device: str) -> None:
    """Raise MonitorError if something was written and not saved."""
    if written:
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
        if not monitor.reels.discs:
            raise MonitorError(_NO_DISCS.format(name))
        toggled = bootstrap.DF32
    elif name.lower().startswith("dt") and name[2:].isdigit():
        unit = reels.drive(name)
        if unit not in monitor.reels.names:
            raise MonitorError(f"{name}: no tape is mounted; attach {name} FILE")
        toggled = bootstrap.bootstrap(unit)
    else:
        tapes.boot(monitor, name, *more)
        return
    bootstrap.boot(monitor.machine, toggled)
    running.run(monitor)


def show(monitor: Monitor) -> None:
    """Say what is on the drives, if there are any."""
    for unit, drive in enumerate(monitor.reels.drives):
        if unit in monitor.reels.names:
            locked = ", locked" if drive.locked else ""
            written = f", {counted(monitor.reels.changed(unit), 'blocks')} written" if drive.blocks else ""
            monitor.say(f"dt{unit}  {monitor.reels.names[unit]}{locked}{written}")
    if monitor.reels.discs:
        monitor.say(f"df   {monitor.reels.discs_name}{', changed' if monitor.reels.said_of_discs() else ''}")


def leave(monitor: Monitor) -> None:
    """Save what was written on reels and discs and not saved."""
    for said in monitor.reels.rescue():
        monitor.say(said)
