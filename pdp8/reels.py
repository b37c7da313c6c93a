"""DECtapes between files and the drives of a machine, and the discs of a DF32.

A file that was mounted is not written: what the program changed is on the reel in the machine, until it is
saved in a file of its own. What nobody saved is left beside the file it came from.
"""

import os
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

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
"""Bytes: as long as the images of disks, so that one is refused by its name."""


class Reels:
    """The reels on the drives of a control, the discs of a DF32, and the files they came from."""

    def __init__(self, drives: Sequence[Transport] = ()) -> None:
        self.drives = drives
        self.names: dict[int, str] = {}
        """The files, by drives."""
        self.discs: DF32 | None = None
        self.discs_name = "df.df32"
        self.discs_kept = b""
        """What was on the discs when they were filled or saved."""

    def look_at(self, machine: Machine) -> None:
        """Turn to the drives and discs of a machine; none where there are none."""
        before = self.discs
        self.discs = next((each for each in machine.devices if isinstance(each, DF32)), None)
        if self.discs and not before:
            self.discs_kept = self.discs.content
        self.drives = drives(machine.devices)
        mounted = [unit for unit, drive in enumerate(self.drives) if drive.image is not None]
        self.names = {unit: self.names.get(unit, f"dt{unit}.tu56") for unit in mounted}

    def images(self) -> list[dectape.Image]:
        """Return the reels as they were mounted."""
        return [drive.image for drive in self.drives if drive.image is not None]

    def read(self, unit: int, name: str) -> tuple[dectape.Image, list[str]]:
        """Return the reel in a file that is to go on a drive, and notes about it. Raises WorkError."""
        for other, before in self.names.items():
            if other != unit and shelf.identity(shelf.find(before)) == shelf.identity(shelf.find(name)):
                raise WorkError(f"{name} is on drive {other}: a reel is on one drive")
        with naming(name):
            return dectape.decode(shelf.read(name, _LONGEST))

    def mount(self, unit: int, name: str, locked: bool = False) -> list[str]:
        """Mount the reel in a file; return notes about it. Raises WorkError, and changes nothing then."""
        image, notes = self.read(unit, name)
        self.drives[unit].mount(image, locked)
        self.names[unit] = name
        return notes

    def changed(self, unit: int) -> int:
        """Return how many blocks of a reel were written since it was mounted or saved."""
        return len(self.drives[unit].blocks)

    def said(self, unit: int) -> str:
        """Say how many blocks were written."""
        return f"drive {unit}: {counted(self.changed(unit), 'blocks')} of {self.names[unit]} changed"

    def save(self, unit: int, name: str) -> str:
        """Save a reel as it is now; return what to say of it. Raises WorkError, and the reel stays."""
        reel = self.drives[unit].written()
        if reel is None:
            raise WorkError(f"drive {unit}: no tape is mounted")
        if any(shelf.identity(shelf.find(each)) == shelf.identity(name) for each in self.names.values()):
            raise WorkError(f"{name} was mounted; name another file")
        return shelf.told(name, shelf.write(name, reel.content()))

    def fill(self, name: str) -> None:
        """Put an image onto the discs of the DF32. Raises WorkError, and changes nothing then."""
        content, discs = shelf.read(name), self.discs or DF32()
        try:
            discs.content = content
        except ValueError as error:
            raise WorkError(f"{name}: {error}") from error
        self.discs_name, self.discs_kept = name, content

    def empty(self) -> None:
        """Take the image off the discs."""
        if self.discs:
            self.discs.content = bytes(len(self.discs.content))
            self.discs_name, self.discs_kept = "df.df32", self.discs.content

    def said_of_discs(self) -> str:
        """Say how many words of the discs were written and not saved, "" for none."""
        now = self.discs.content if self.discs else self.discs_kept
        pairs = zip(now[::2], now[1::2], self.discs_kept[::2], self.discs_kept[1::2], strict=False)
        words = sum((low, high) != (before, above) for low, high, before, above in pairs)
        return f"df: {counted(words, 'words')} of {self.discs_name} changed" if words else ""

    def save_discs(self, name: str) -> str:
        """Save the discs as they are now; return what to say of it. Raises WorkError."""
        if shelf.identity(shelf.find(self.discs_name)) == shelf.identity(name):
            raise WorkError(f"{name} was mounted; name another file")
        content = self.discs.content if self.discs else self.discs_kept
        said = shelf.told(name, shelf.write(name, content))
        self.discs_kept = content
        return said

    def unmount(self, unit: int) -> None:
        """Take the reel off the drive."""
        self.drives[unit].mount(None)
        self.names.pop(unit, None)

    def rescue(self) -> Iterator[str]:
        """Save each changed reel, and changed discs, beside their file; yield a message for each."""
        changed: list[tuple[str, str, Callable[[str], str]]] = [
            (self.said(unit), self.names[unit], partial(self.save, unit))
            for unit, drive in enumerate(self.drives)
            if drive.blocks
        ]
        if of_discs := self.said_of_discs():
            changed.append((of_discs, self.discs_name, self.save_discs))
        for written, name, save in changed:
            try:
                said = save(_free(name))
            except WorkError:
                said = save(_free(os.path.join(tempfile.gettempdir(), os.path.basename(name))))
            yield f"{written}, and not saved: {said}"


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
