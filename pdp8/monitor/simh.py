"""The words of SIMH's pdp8 where the monitor's own are others.

    attach ptr TAPE, detach ptr     the reader            attach ptp FILE, detach ptp     the punch
    attach dt0 FILE, attach df FILE, attach lpt FILE      the rack: each is fitted as it is attached
    send "ABC\\r"                    keys, as the program asks for them, once the machine runs
    echo TEXT                       of scripts, as do, goto and if are (see commands)
    set cpu 4k, set throttle ...    what the machine is anyway, or its pace at a terminal

A device that this machine lacks is an error; disabling it does nothing.
"""

import os
import re
from collections.abc import Sequence
from contextlib import ExitStack
from functools import partial

from pal.assembling import assemble
from pdp8 import shelf
from pdp8.computer.hardware.extension import MEMORY
from pdp8.computer.rack.lp08 import LP08
from pdp8.monitor import debugging, rack, tapes
from pdp8.monitor.arguments import MonitorError, Quoted, some
from pdp8.monitor.keystrokes import frames_of, press
from pdp8.monitor.prompt import Monitor
from pdp8.monitor.running import text_of

_HAS = ("tti", "tto", "ptr", "ptp")
SWITCH = re.compile("-[a-zA-Z]+")
_PACE = re.compile(r"((after|delay)=\d+,?)+", re.IGNORECASE)
"""Instructions between keys at SIMH, where no program asks for them."""
_NOTHING_TO_SET = ("on", "quiet", "verbose", "console", "env", "debug", "log", "noon")
DEVICES = "ptr, ptp, dt0 to dt7, df, lpt"


def _kind(name: str) -> str:
    """Return the name of a device without the number of its unit."""
    return name.lower().rstrip("01234567")


def _device(monitor: Monitor, name: str) -> str:
    """Return the name of a device that is here, or can be fitted. Raises MonitorError."""
    device = _kind(name) if name.lower().startswith("dt") else name.lower().rstrip("0")
    if device in _HAS or device in rack.RACK:
        return device
    raise MonitorError(f"{name}: {rack.absent(monitor, name) or f'no device; there are {DEVICES}'}")


def _has(switch: str, words: Sequence[str]) -> bool:
    """Whether a switch is among words, by itself or with others: -r, -er."""
    return any(switch in word for word in words if SWITCH.fullmatch(word))


def attach(monitor: Monitor, *words: str) -> None:
    """Mount FILE: ptr is the reader, ptp the punch, dt0 to dt7 are DECtapes, df is a DF32 disk, lpt the LP08
    line printer. -r locks a DECtape.
    """
    names = [each for each in words if not each.startswith("-")]
    device, *name = some(names, f"{DEVICES}, and the name of a file", 1, 2)
    kind = _device(monitor, device)
    (file,) = some(name, "the name of a file")
    if kind in ("ptr", "tti"):
        fast = kind == "ptr" and monitor.machine.highspeed.fitted
        (tapes.fast_reader if fast else tapes.reader)(monitor, file)
    elif kind in ("dt", "df"):
        rack.attach(monitor, device, file, locked=_has("r", words))
    else:
        shelf.check_writable(file)
        shelf.check_kind(file, "text" if kind == "lpt" else "tape")
        if kind == "lpt":
            rack.fit(monitor, kind)
        take_off(monitor, kind)
        monitor.punching[kind] = file


def detach(monitor: Monitor, device: str, where: str = "") -> None:
    """Take the tape out of the reader (ptr), or off the punch into its file (ptp); dt0 to dt7 and df: save
    what is on them in FILE, or forget it.
    """
    if device.lower() == "all":
        if where not in ("", "forget"):
            raise MonitorError(f"all: {where} can have one reel; detach each")
        reels = (place.device for place in monitor.reels.mounted())
        for each in [*monitor.punching, *reels, "tti", *["ptr"] * monitor.machine.highspeed.fitted]:
            detach(monitor, each, where)
        return
    kind = _device(monitor, device)
    if kind in ("dt", "df"):
        rack.detach(monitor, device, where)
    elif kind in ("ptr", "tti"):
        if kind == "ptr" and monitor.machine.highspeed.fitted:
            monitor.machine.highspeed.reader.remove()
        else:
            tapes.reader(monitor, "none")
    elif kind in monitor.punching:
        take_off(monitor, kind)
    else:
        raise MonitorError(f"{device}: no file is attached to it")


def take_off(monitor: Monitor, kind: str = "") -> None:
    """Write what was punched into the file that was attached for it; all of them without a name."""
    with ExitStack() as stack:  # each is written, though another cannot be
        for each in reversed([name for name in monitor.punching if kind in ("", name)]):
            stack.callback(_take_off, monitor, each, monitor.punching.pop(each))


def _take_off(monitor: Monitor, kind: str, file: str) -> None:
    machine = monitor.machine
    fast = kind == "ptp" and machine.highspeed.fitted
    punch = (machine.highspeed if fast else machine.teletype).punch
    printed = [device.frames for device in machine.devices if isinstance(device, LP08) and kind == "lpt"]
    if not (printed or [punch.frames])[0] and os.path.exists(file):
        monitor.say(f"{file} stays as it is: nothing was {'printed' if printed else 'punched'}")
    elif printed:
        monitor.say(shelf.leave(file, bytes(printed[0]), "text"))
        printed[0].clear()
    else:
        tapes.take_off(monitor, punch, file)


def leave(monitor: Monitor) -> None:
    """Write what was punched and printed for attached files, and save reels and discs that were changed."""
    try:
        take_off(monitor)
    finally:
        rack.leave(monitor)


def send(monitor: Monitor, *texts: str) -> None:
    """Press keys as the program asks for them; with the machine stopped, once it runs."""
    texts = tuple(text for text in texts if isinstance(text, Quoted) or not _PACE.fullmatch(text))
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
    """Say what is fitted; with `break`, where a run stops."""
    if what and "break".startswith(what[0].lower()):
        debugging.break_(monitor)
        return
    machine = monitor.machine
    fast = ", PC8/L reader and punch" if machine.highspeed.fitted else ""
    others = [each for each in machine.devices if each not in (machine.teletype, machine.highspeed)]
    more = "".join(f", {type(each).__name__} (device {each.CODE:02o})" for each in others)
    size = f"{machine.memory // 1024}K"
    monitor.say(f"PDP-8/L, {size} of core, ASR-33 Teletype{fast}{more}; no EAE")
    rack.show(monitor)


def passed_over(monitor: Monitor, *words: str) -> None:
    """Do nothing: scripts of SIMH's may have it."""


def set_(monitor: Monitor, name: str, *values: str) -> None:
    """Set a register, a switch (0 or 1), the seconds that a key of the panel takes (hands), or an option of
    SIMH's.
    """
    if not _option(monitor, name, values):
        debugging.set_(monitor, name, *some(values, f"one of {debugging.NAMES} and a word", 1, 1))


def _option(monitor: Monitor, name: str, values: Sequence[str]) -> bool:
    """Set an option as SIMH's SET does; return whether there is one of that name. Raises MonitorError."""
    name, value = name.lower(), " ".join(values).lower()
    kind = _kind(name)
    if name in ("throttle", "nothrottle"):
        monitor.realtime = name == "throttle"
    elif name == "cpu":
        for each in value.split(","):
            if each in MEMORY:
                debugging.set_core(monitor, each)
            elif each not in ("idle", "noidle", "noeae", ""):
                raise MonitorError(
                    f"{each}: {', '.join(MEMORY)} are the sizes of core. There is no EAE; idle is always on"
                )
    elif kind in rack.RACK and not value.isdecimal():
        if value.startswith("en"):
            rack.fit(monitor, kind)
        elif value.startswith("dis") and rack.fitted(monitor, kind):
            raise MonitorError(f"{name}: it is fitted, and cannot be removed")
        elif not value.startswith("dis") and not rack.lock(monitor, name, value):
            monitor.say(f"{' '.join((name, *values))}: passed over, it is SIMH's own")
    elif what := rack.absent(monitor, name):
        if not value.startswith("dis"):
            raise MonitorError(f"{name}: {what}")
    elif kind not in _HAS:
        return name in _NOTHING_TO_SET
    elif value.startswith("dis"):
        raise MonitorError(f"{name}: it cannot be removed; `reader stop` and `punch off` switch it off")
    return True


def _of_machine(monitor: Monitor, words: Sequence[str]) -> Sequence[str]:
    """Return places without SIMH's switches and its word cpu; none for registers of SIMH's devices."""
    device, *places = some([each for each in words if not SWITCH.fullmatch(each)], "an address")
    known = debugging.is_register(monitor, device) or device.upper() in monitor.listing.symbols
    kind = _kind(device)
    if not places or known:
        return [device, *places]
    if kind == "cpu":
        return places
    if what := rack.absent(monitor, device):
        raise MonitorError(f"{device}: {what}")
    if kind in ("system", "int-clock", "int-throttle", *_HAS, *rack.RACK):
        monitor.say(f"{device} {' '.join(places)}: passed over, it is SIMH's own")
        return []
    return [device, *places]


def examine(monitor: Monitor, place: str, *more: str) -> None:
    """Say words of core, each with its line of the listing, or a register."""
    for each in _of_machine(monitor, (place, *more)):
        debugging.examine(monitor, each)


def deposit(monitor: Monitor, place: str, word: str, *more: str) -> None:
    """Put words into core from A on, or one word into all of A:B; with -m an instruction: -m 200 CLA CLL."""
    words = _of_machine(monitor, (place, word, *more))
    if not words:
        return
    if _has("m", (place, word)):
        at = monitor.address(words[0]) & 0o7777
        made = assemble(f"*{at:o}\n{' '.join(some(words[1:], 'an instruction'))}\n$\n")
        if not made.ok or list(made.words) != [at]:
            raise MonitorError(f"{' '.join(words[1:])}: no instruction")
        words = [words[0], f"{made.words[at]:o}"]
    debugging.deposit(monitor, *some(words, "an address and a word", 2))
