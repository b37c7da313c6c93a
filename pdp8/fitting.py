"""Devices by what `--device` calls them: a name, or a class in a file of one's own.

    pdp8 run --device highspeed prog.pal        of pdp8/computer/hardware/devices.py, dectape, or of the rack
    pdp8 run --device clock.py:Clock prog.pal

A class of one's own is derived from Device (pdp8/computer/hardware/bus.py) and has its device code as CODE.
Its file is run as Python runs any file: fit no device whose file you would not run.
"""

import os
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from traceback import walk_tb
from types import ModuleType

from pdp8.computer.hardware.bus import Device, Peripheral
from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.hardware.fields import all_fields, changed, take
from pdp8.computer.machine import Machine
from tapes.errors import WorkError

_MARK = "__file_of_devices__"

MOUNT = "--dectape N=FILE mounts it, or attach dtN FILE"
"""How a reel comes that a saved state needs: to `pdp8 run`, or to the monitor."""
Devices = list[type[Peripheral]]


class TwiceError(WorkError):
    """Two devices of one code are asked for."""

    exit_status = 2


def known() -> list[Peripheral]:
    """Return a device of every kind that has a name."""
    from pdp8.computer.dectape.tc08 import TC08  # for those who have one
    from pdp8.computer.rack.df32 import DF32
    from pdp8.computer.rack.kw8 import KW8
    from pdp8.computer.rack.lp08 import LP08
    from pdp8.computer.rack.pt08 import PT08

    return [*one_of_each(), TC08(), KW8(), LP08(), PT08(), DF32()]


@cache
def _by_name() -> dict[str, type[Peripheral]]:
    return {device.NAME: type(device) for device in known()}


def file_of(name: str) -> str | None:
    """Return the file of FILE:CLASS, None for the name of a device. Raises WorkError for neither."""
    if name in _by_name():
        return None
    file, _, of_class = name.rpartition(":")
    if not (file and of_class.isidentifier()):
        raise WorkError(
            f"{name}: {', '.join(_by_name())} are devices; your own are FILE:CLASS, as in clock.py:Clock"
        )
    return file


def devices(names: Iterable[str]) -> Devices:
    """Return the classes that are named. Raises WorkError where one is not there or no device."""
    found: Devices = []
    for name in names:
        file = file_of(name)
        made = _by_name()[name] if file is None else _device(file, name.removeprefix(f"{file}:"))
        for other in found:
            if made.CODE == other.CODE:
                raise TwiceError(f"{name}: {other.__name__} has device code {made.CODE:02o} too")
        found.append(made)
    return found


def fit(machine: Machine, classes: Devices) -> None:
    """Fit a device of each class to the machine. Raises WorkError where a code is taken or no code."""
    for made in classes:
        try:
            device = made()
            if isinstance(device, Device):
                _check(device)
            machine.fit(device)
            if isinstance(device, Device):
                device.initialize(machine.processor.clock)
        except Exception as error:
            raise WorkError(fault(error) or f"{made.__name__}: {error}") from error


def _check(device: Device) -> None:
    """Raise ValueError for a device that lacks a method or a field, or that IOP1 changes."""
    made = type(device)
    for name in ("pulse", "advance", "initialize"):
        if getattr(made, name) is getattr(Device, name):
            raise ValueError(f"it has no method {name}, which a device has to have")
    for name in made.fields:
        if not hasattr(device, name):
            raise ValueError(f"fields names {name}, and it has no such attribute")
    tried = made()
    fields = all_fields([("", tried)])
    before = take(fields)
    for ac in (0, 0o7777):
        tried.pulse(1, ac, 0)
    if touched := changed(before, take(fields)):
        raise ValueError(
            f"its pulse 1 changes {', '.join(touched).strip()}: pulse 1 only tests, as loops that test are "
            "passed over; act at pulse 2 or 4"
        )


def fault(error: BaseException) -> str:
    """Return the line and message of an error raised in a device's file, "" if elsewhere."""
    said = where = ""
    for frame, line in walk_tb(error.__traceback__):
        where = frame.f_code.co_name
        if file := frame.f_globals.get(_MARK):
            said = f"{file}, line {line}: {type(error).__name__}: {error}"
    if not said and isinstance(error, TypeError) and where.endswith("pulse"):
        return "a device of your own: its pulse returned no number; 0, SKIP, CLEAR_AC and words are answers"
    return said


def _device(file: str, name: str) -> type[Device]:
    if not os.path.isfile(file):
        raise WorkError(f"{file}: no such file")
    if not file.endswith(".py"):
        raise WorkError(f"{file}: a device is in a Python file, NAME.py")
    path = os.path.abspath(file)
    module = ModuleType(Path(file).stem)
    vars(module).update({"__file__": path, _MARK: file})
    try:  # not as an import, which would leave its bytecode in the user's folder
        exec(compile(Path(file).read_bytes(), path, "exec"), vars(module))
    except (Exception, SystemExit) as error:
        lines = [line for at, line in walk_tb(error.__traceback__) if at.f_code.co_filename == path]
        line = getattr(error, "lineno", None) or (lines[-1] if lines else 0)
        where = f", line {line}" if line else ""
        raise WorkError(f"{file}{where}: {type(error).__name__}: {error}") from error
    made = getattr(module, name, None)
    if made is None:
        raise WorkError(f"{file}: there is no class {name} in it")
    if not (isinstance(made, type) and issubclass(made, Device)):
        raise WorkError(f"{file}: {name} is no class derived from Device of pdp8.computer.hardware.bus")
    if type(made.CODE) is not int:
        raise WorkError(f"{file}: {name}.CODE is {made.CODE!r}, not a device code as in CODE = 0o13")
    return made
