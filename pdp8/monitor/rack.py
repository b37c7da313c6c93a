"""Commands about what is in the rack: DECtapes on their drives."""

from pdp8 import reels
from pdp8.computer.dectape.tc08 import TC08
from pdp8.monitor import running, tapes
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.prompt import Monitor
from tapes.quantities import counted

_PAPER = ("ptr", "ptp", "tti", "tto")


def attach(monitor: Monitor, first: str, *more: str) -> None:
    """Mount a DECtape image on a drive, with -r write locked. The file is not written."""
    locked = first == "-r"
    names = more if locked else (first, *more)
    if len(names) != 2:
        raise MonitorError("a drive and a file expected, as in attach dt0 ps8.tu56")
    if names[0].lower() in _PAPER:
        raise MonitorError(f"{names[0]}: reader TAPE puts a paper tape in, punch FILE takes one off")
    unit, mounted = reels.drive(names[0]), monitor.reels
    if unit in mounted.names:
        _check_saved(monitor, unit)
    mounted.read(unit, names[1])
    if not mounted.drives:
        monitor.machine.fit(TC08())
        monitor.attend(monitor.machine)
    for note in mounted.mount(unit, names[1], locked):
        monitor.say(f"{names[1]}: {note}")
    monitor.say(f"{names[1]} is on dt{unit}{', locked' if locked else ''}; the file itself is not written")


def detach(monitor: Monitor, name: str, where: str = "") -> None:
    """Take a DECtape off its drive; save it in FILE as it is now, or forget what was written."""
    unit, mounted = reels.drive(name), monitor.reels
    if unit not in mounted.names:
        raise MonitorError(f"dt{unit}: no tape is mounted")
    if where not in ("", "forget"):
        monitor.say(mounted.save(unit, where))
    elif not where:
        _check_saved(monitor, unit)
    mounted.unmount(unit)


def _check_saved(monitor: Monitor, unit: int) -> None:
    """Raise MonitorError if a reel has blocks that were written and not saved."""
    if monitor.reels.changed(unit):
        written = monitor.reels.said(unit)
        raise MonitorError(f"{written}; detach dt{unit} FILE saves them, or forget drops them")


def boot(monitor: Monitor, name: str, *force: str) -> None:
    """Load a program from cold as an operator does; with force, whatever its checksum. `boot ptr` reads what
    is in the reader by RIM.
    """
    if not (name.lower().startswith("dt") and name[2:].isdigit()):
        tapes.boot(monitor, name, *force)
        return
    unit = reels.drive(name)
    if unit not in monitor.reels.names:
        raise MonitorError(f"{name}: no tape is mounted; attach {name} FILE")
    reels.boot(monitor.machine, unit)
    running.run(monitor)


def show(monitor: Monitor) -> None:
    """Say what is on the drives, if there are any."""
    for unit, drive in enumerate(monitor.reels.drives):
        if unit in monitor.reels.names:
            locked = ", locked" if drive.locked else ""
            written = f", {counted(monitor.reels.changed(unit), 'blocks')} written" if drive.blocks else ""
            monitor.say(f"dt{unit}  {monitor.reels.names[unit]}{locked}{written}")


def leave(monitor: Monitor) -> None:
    """Save what was written on reels and not saved."""
    for said in monitor.reels.rescue():
        monitor.say(said)
