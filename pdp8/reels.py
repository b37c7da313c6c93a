"""DECtapes between files and the drives of a machine, and the discs of a DF32.

A file that was mounted is not written: what the program changed is on the reel in the machine, until it is
saved in a file of its own. What nobody saved is left beside the file it came from.
"""

import os
import tempfile
from collections.abc import Iterable, Iterator, Sequence

from pdp8 import shelf
from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.dectape.tu55 import Transport
from pdp8.computer.hardware.bus import Peripheral
from pdp8.computer.machine import Machine
from pdp8.computer.rack.df32 import DF32
from tapes import dectape
from tapes.errors import WorkError, naming
from tapes.quantities import counted

UNITS = range(8)
_LONGEST = 8 << 20
"""Bytes that are read: enough for the image of a disk, which is then refused by its name."""


class Reels:
    """The reels on the drives of a control, the discs of a DF32, and the files they came from.

    Each goes by SIMH's name of its device, dt0 to dt7 or df.
    """

    def __init__(self, drives: Sequence[Transport] = ()) -> None:
        self.drives = drives
        self.discs = DF32()
        self.names: dict[str, str] = {}
        """The files, by devices."""
        self.discs_kept = b""
        """What was on the discs when they were filled or saved."""

    def look_at(self, machine: Machine) -> None:
        """Use the drives and discs of a machine from now on, if it has any."""
        self.drives = drives(machine.devices)
        mounted = {f"dt{unit}": "tu56" for unit, drive in enumerate(self.drives) if drive.image is not None}
        for each in machine.devices:
            if isinstance(each, DF32):
                self.discs, mounted["df"] = each, "df32"
                if "df" not in self.names:
                    self.discs_kept = each.content
        self.names = {device: self.names.get(device, f"{device}.{kind}") for device, kind in mounted.items()}

    def devices(self) -> list[str]:
        """Return the devices on which something is."""
        return sorted(self.names, key=lambda device: (device == "df", device))

    def images(self) -> list[dectape.Image]:
        """Return the reels as they were mounted."""
        return [drive.image for drive in self.drives if drive.image is not None]

    def read(self, unit: int, name: str) -> tuple[dectape.Image, list[str]]:
        """Return the reel in a file that is to go on a drive, and notes about it. Raises WorkError."""
        for other, before in self.names.items():
            if other not in ("df", f"dt{unit}") and _same(before, shelf.find(name)):
                raise WorkError(f"{name} is on {_place(other)}: a reel is on one drive")
        with naming(name):
            return dectape.decode(shelf.read(name, _LONGEST))

    def mount(self, unit: int, name: str, locked: bool = False) -> list[str]:
        """Mount the reel in a file; return notes about it. Raises WorkError, and changes nothing then."""
        image, notes = self.read(unit, name)
        self.drives[unit].mount(image, locked)
        self.names[f"dt{unit}"] = name
        return notes

    def fill(self, name: str) -> None:
        """Put an image onto the discs of the DF32. Raises WorkError, and changes nothing then."""
        content = shelf.read(name)
        try:
            self.discs.content = content
        except ValueError as error:
            raise WorkError(f"{name}: {error}") from error
        self.names["df"], self.discs_kept = name, content

    def take_off(self, device: str) -> None:
        """Take the reel off its drive, or the image off the discs."""
        del self.names[device]
        if device != "df":
            self.drives[drive(device)].mount(None)
            return
        self.discs_kept = self.discs.content = bytes(len(self.discs.content))
        self.names[device] = "df.df32"

    def changed(self, device: str) -> int:
        """Return how many blocks of a reel, or words of the discs, were written and not saved."""
        if device != "df":
            return len(self.drives[drive(device)].blocks)
        now, kept = self.discs.content, self.discs_kept
        pairs = zip(now[::2], now[1::2], kept[::2], kept[1::2], strict=False)
        return sum((low, high) != (before, above) for low, high, before, above in pairs)

    def said(self, device: str) -> str:
        """Say how much was written and not saved, "" for nothing or no medium."""
        number = self.changed(device) if device in self.names else 0
        what = counted(number, "words" if device == "df" else "blocks")
        return f"{_place(device)}: {what} of {self.names[device]} changed" if number else ""

    def save(self, device: str, name: str) -> str:
        """Save a reel or the discs as they are now; return what to say of it. Raises WorkError."""
        if device not in self.names:
            raise WorkError(f"{_place(device)}: no tape is mounted")
        if any(_same(each, name) for each in self.names.values()):
            raise WorkError(f"{name} was mounted; name another file")
        if device == "df":
            said = shelf.told(name, shelf.write(name, self.discs.content))
            self.discs_kept = self.discs.content
            return said
        on = self.drives[drive(device)]
        reel = on.written() or dectape.blank()
        said = shelf.told(name, shelf.write(name, reel.content()))
        on.image, on.blocks = reel, {}
        return said

    def rescue(self) -> Iterator[str]:
        """Save each changed reel, and changed discs, beside their file; yield a message for each."""
        for device in self.devices():
            if written := self.said(device):
                try:
                    said = self.save(device, _free(self.names[device]))
                except WorkError:
                    name = os.path.basename(self.names[device])
                    said = self.save(device, _free(os.path.join(tempfile.gettempdir(), name)))
                yield f"{written}, and not saved: {said}"


def _place(device: str) -> str:
    return device if device == "df" else f"drive {drive(device)}"


def _same(before: str, name: str) -> bool:
    return shelf.identity(shelf.find(before)) == shelf.identity(name)


def drives(devices: Iterable[Peripheral]) -> Sequence[Transport]:
    """Return the drives of the DECtape control among `devices`, none if there is no control."""
    return next((each.drives for each in devices if isinstance(each, TC08)), ())


def drive(text: str) -> int:
    """Return the unit that "0" or "dt0" names. Raises WorkError."""
    number = text.lower().removeprefix("dt")
    if number not in [str(unit) for unit in UNITS]:
        raise WorkError(f"{text}: the drives are dt0 to dt7")
    return int(number)


def assignment(text: str) -> tuple[int, str]:
    """Return unit and file of "0=FILE". Raises WorkError."""
    unit, found, name = text.partition("=")
    if not found or not name:
        raise WorkError(f"{text}: a drive and a file expected, as in 0=ps8.tu56")
    return drive(unit), name


def _free(name: str) -> str:
    """Return an unused name like that of a file."""
    stem, ending = os.path.splitext(name)
    numbered = (f"{stem}-changed{'' if number == 1 else f'-{number}'}{ending}" for number in range(1, 1000))
    return next(each for each in numbered if not os.path.exists(each))
