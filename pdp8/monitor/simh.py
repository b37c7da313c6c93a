"""The words of SIMH's pdp8 where the monitor's own are others.

    attach ptr TAPE, detach ptr     the reader            attach ptp FILE, detach ptp     the punch
    send "ABC\\r"                    keys, as the program asks for them, once the machine runs
    do FILE, echo TEXT              scripts
    set cpu 4k, set throttle ...    what the machine is anyway, or its pace at a terminal

A device that this machine has not is named; to disable it does nothing.
"""

from collections.abc import Sequence
from functools import partial

from pdp8 import shelf
from pdp8.computer.hardware.extension import MEMORY
from pdp8.monitor import debugging, rack, tapes
from pdp8.monitor.arguments import MonitorError, some
from pdp8.monitor.keystrokes import frames_of, press
from pdp8.monitor.prompt import Monitor
from pdp8.monitor.running import text_of

_ABSENT = {
    "rk": "an RK8 disk",
    "rl": "an RL8 disk",
    "rf": "an RF08 disk",
    "df": "a DF32 disk",
    "rx": "an RX8 floppy",
    "td": "a TD8E DECtape",
    "mt": "a magnetic tape",
    "ct": "a cassette",
    "lpt": "a line printer",
    "clk": "a clock",
    "fpp": "an FPP8",
    "tsc": "a time-sharing control",
    **dict.fromkeys(("ttix", "ttox"), "a further Teletype"),
}
_HAS = ("cpu", "tti", "tto", "ptr", "ptp")
_NOTHING_TO_SET = ("on", "quiet", "verbose", "console", "env", "debug", "log", "noon")


def absent(name: str) -> str:
    """Return what a SIMH device is that this machine lacks, "" for other words."""
    return _ABSENT.get(name.lower()) or _ABSENT.get(name.lower().rstrip("0123456789"), "")


def _device(name: str) -> str:
    """Return the name of a device that is here. Raises MonitorError."""
    device = name.lower().rstrip("0")
    if device in _HAS:
        return device
    what = absent(name)
    why = f"{what}, which this machine has not" if what else "no device"
    raise MonitorError(f"{name}: {why}; ptr is the reader, ptp the punch")


def attach(monitor: Monitor, device: str, *names: str) -> None:
    """Put a tape into the reader (ptr), or name the file for what is punched (ptp)."""
    if "dt" in [each[:2].lower() for each in (device, *names)[:2]]:
        rack.attach(monitor, device, *names)
        return
    *switches, name = some((device, *names), "ptr or ptp, and the name of a file", 2)
    kind = _device(switches[-1])
    if kind in ("ptr", "tti"):
        fast = kind == "ptr" and monitor.machine.highspeed.fitted
        (tapes.fast_reader if fast else tapes.reader)(monitor, name)
    else:
        shelf.check_writable(name)
        shelf.check_kind(name, "tape")
        monitor.punching[kind] = name


def detach(monitor: Monitor, device: str, where: str = "") -> None:
    """Take the tape out of the reader (ptr), or off the punch into its file (ptp)."""
    if device[:2].lower() == "dt":
        rack.detach(monitor, device, where)
        return
    kind = _device(device)
    if kind in ("ptr", "tti"):
        fast = kind == "ptr" and monitor.machine.highspeed.fitted
        monitor.waiting_tapes = []
        (monitor.machine.highspeed if fast else monitor.machine.teletype).reader.remove()
    elif kind in monitor.punching:
        take_off(monitor, kind)
    else:
        raise MonitorError(f"{device}: no file is attached to it")


def take_off(monitor: Monitor, kind: str = "") -> None:
    """Write what was punched into the file that was attached for it; all of them without a name."""
    for each in [kind] if kind else list(monitor.punching):
        fast = each == "ptp" and monitor.machine.highspeed.fitted
        (tapes.fast_punch if fast else tapes.punch)(monitor, monitor.punching.pop(each))


def send(monitor: Monitor, *texts: str) -> None:
    """Press keys as the program asks for them; with the machine stopped, once it runs."""
    frames = frames_of("".join(text_of(text) for text in some(texts, "a text")))
    if monitor.machine.panel.lamps.run:
        press(monitor, frames)
    else:
        monitor.once_running.append(partial(press, monitor, frames))


def echo(monitor: Monitor, text: str) -> None:
    """Say TEXT."""
    monitor.say(text)


def reset(monitor: Monitor, *devices: str) -> None:
    """Press STOP, and do what the power switch does: INITIALIZE."""
    monitor.operator.press("stop")
    monitor.machine.power_up()


def show(monitor: Monitor, *what: str) -> None:
    """Say what is fitted."""
    fast = ", PC8/L reader and punch" if monitor.machine.highspeed.fitted else ""
    size = f"{monitor.machine.memory // 1024}K"
    monitor.say(f"PDP-8/L, {size} of core, ASR-33 Teletype{fast}; no EAE")
    rack.show(monitor)


def passed_over(monitor: Monitor, *words: str) -> None:
    """Do nothing: a script of SIMH's may have it."""


def set_(monitor: Monitor, name: str, *values: str) -> None:
    """Set a register, a switch (0 or 1), the seconds that a key of the panel takes (hands), or an option of
    SIMH's.
    """
    if not _option(monitor, name, values):
        debugging.set_(monitor, name, *some(values, f"one of {debugging.NAMES} and a word", 1, 1))


def _option(monitor: Monitor, name: str, values: Sequence[str]) -> bool:
    """Set an option as SIMH's SET does; return whether there is one of that name. Raises MonitorError."""
    name, value = name.lower(), " ".join(values).lower()
    if name in ("throttle", "nothrottle"):
        monitor.realtime = name == "throttle"
    elif name == "cpu":
        if value in MEMORY:
            debugging.set_core(monitor, value)
        elif value not in ("idle", "noidle", "noeae", ""):
            raise MonitorError(
                f"{value}: {', '.join(MEMORY)} are the sizes of core; no EAE, and idle is always so"
            )
    elif absent(name):
        if value != "disabled":
            raise MonitorError(f"{name}: {absent(name)}, which this machine has not")
    elif name.rstrip("0") not in _HAS[1:]:
        return name in _NOTHING_TO_SET
    elif value == "disabled":
        raise MonitorError(f"{name}: it is fitted; `reader stop` and `punch off` switch it off")
    return True
