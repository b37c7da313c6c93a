"""DECtapes between files and the drives of a machine, and the discs of a DF32.

A file that was mounted is not written: what the program changed is in the machine, until it is saved in a
file of its own. What nobody saved is left beside the file it came from.
"""

import os
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

from pdp8 import shelf
from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.dectape.tu55 import Transport
from pdp8.computer.hardware.bus import Peripheral
from pdp8.computer.rack.df32 import DF32, DISC
from pdp8.computer.use import bootstrap
from tapes import dectape
from tapes.errors import WorkError, naming
from tapes.quantities import counted

UNITS = range(8)
_LONGEST = 8 << 20
"""Bytes that are read: enough for the image of a disk, which is then refused by its name."""


class Reel:
    """A drive: what is on it, and how much of it was changed; `files` has the files that reels came from."""

    unit = "blocks"
    missing = "no tape is mounted; attach dtN FILE mounts one"

    def __init__(self, number: int, files: dict[dectape.Image, str]) -> None:
        self.device = self.called = f"dt{number}"
        self.place = f"drive {number}"
        self._files = files
        self.drive = Transport()
        self.bootstrap = bootstrap.bootstrap(number)
        self._number = number

    def look_at(self, devices: Sequence[Peripheral]) -> None:
        """Use the drive of the DECtape control among `devices` from now on."""
        found = next((each for each in devices if isinstance(each, TC08)), None)
        self.drive = found.drives[self._number] if found else Transport()

    @property
    def file(self) -> str:
        """The file that the reel on the drive came from, which `back` may have put there; "" for no reel."""
        image = self.drive.image
        return self._files.get(image, f"{self.device}.tu56") if image else ""

    def mount(self, name: str, locked: bool = False) -> list[str]:
        """Mount the reel in a file; return notes about it. Raises WorkError, and changes nothing then."""
        content = shelf.read(name, _LONGEST)
        with naming(name):
            image, notes = dectape.decode(content)
        self.drive.mount(image, locked)
        self._files[image] = name
        return notes

    def take_off(self) -> None:
        """Leave the drive empty."""
        self.drive.mount(None)

    def changed(self) -> int:
        """Return how many blocks were written and not saved."""
        return len(self.drive.blocks)

    def save(self, name: str) -> str:
        """Save the reel as it is now; return what to say of it. Raises WorkError."""
        reel = self.drive.written() or dectape.blank()
        said = shelf.leave(name, reel.content(), "image")
        self._files[reel] = self.file
        self.drive.image, self.drive.blocks = reel, {}
        return said

    @property
    def locked(self) -> bool:
        """WRITE LOCK."""
        return bool(self.drive.locked)


class Discs:
    """The discs of a DF32: the file they were filled from, "" without a DF32, and how much was changed."""

    device = place = "df"
    called = "the DF32"
    unit = "words"
    locked = False
    missing = "no DF32 is fitted; attach df FILE fits it"
    bootstrap = bootstrap.DF32

    def __init__(self) -> None:
        self.file = ""
        self.control = DF32()
        self._kept = b""
        """What was on the discs when they were filled or saved."""
        self._past: list[tuple[int, str, bytes]] = []
        """Until which ticks file and content were others."""

    def changes(self, clock: int) -> None:
        """Note, before the discs are filled, emptied or saved at a tick, what they are."""
        self._past.append((clock, self.file, self._kept))

    def went_back(self, clock: int) -> None:
        """Follow the machine, which has gone back to a tick."""
        while self._past and self._past[-1][0] > clock:
            _, self.file, self._kept = self._past.pop()

    def look_at(self, devices: Sequence[Peripheral]) -> None:
        """Use the DF32 among `devices` from now on."""
        self._past.clear()
        found = next((each for each in devices if isinstance(each, DF32)), None)
        self.control = found or DF32()
        if not self.file:
            self._kept = self.control.content
        self.file = (self.file or "df.df32") if found else ""

    def mount(self, name: str, locked: bool = False) -> list[str]:
        """Fill the discs from a file, the rest of the last with zeros: SIMH's images end with the last word
        written. Return notes about it. Raises WorkError, and changes nothing then.
        """
        content = shelf.read(name)
        missing = 0 if len(content) % 2 else -len(content) % (2 * DISC)
        try:
            self.control.content = content + bytes(missing)
        except ValueError as error:
            raise WorkError(f"{name}: {len(content):,} bytes: {error}") from error
        self.file, self._kept = name, self.control.content
        if not missing:
            return []
        discs, words = counted(len(self._kept) // (2 * DISC), "discs"), counted(missing // 2, "words")
        return [f"{discs}, the last {words} of them missing and taken as 0000"]

    def take_off(self) -> None:
        """Clear the discs."""
        self._kept = self.control.content = bytes(len(self.control.content))
        self.file = "df.df32"

    def changed(self) -> int:
        """Return how many words were written and not saved."""
        now, kept = self.control.content, self._kept
        pairs = zip(now[::2], now[1::2], kept[::2], kept[1::2], strict=False)
        return sum((low, high) != (before, above) for low, high, before, above in pairs)

    def save(self, name: str) -> str:
        """Save the discs as they are now; return what to say of it. Raises WorkError."""
        said = shelf.leave(name, self.control.content, "image")
        self._kept = self.control.content
        return said


class Reels:
    """The drives and the discs of a machine, by SIMH's names of their devices: dt0 to dt7 and df."""

    def __init__(self, devices: Sequence[Peripheral] = ()) -> None:
        files: dict[dectape.Image, str] = {}
        self.discs = Discs()
        places: list[Reel | Discs] = [*(Reel(unit, files) for unit in UNITS), self.discs]
        self.places = {place.device: place for place in places}
        self.look_at(devices)

    def look_at(self, devices: Sequence[Peripheral]) -> None:
        """Use the drives and discs among `devices` from now on; files keep their names."""
        for place in self.places.values():
            place.look_at(devices)

    def mounted(self) -> list[Reel | Discs]:
        """Return the places where something is."""
        return [place for place in self.places.values() if place.file]

    @contextmanager
    def staying(self, devices: Sequence[Peripheral]) -> Iterator[None]:
        """Let a DF32 among new `devices` have what is on the discs. Then others are looked at: put back the
        reels that are on none of their drives, with what was written on them, where the drive is empty.
        """
        drives = [(place, place.drive) for place in self.places.values() if isinstance(place, Reel)]
        for control in devices:
            if isinstance(control, DF32):
                control.content = self.discs.control.content
        yield
        mounted = self.images()
        for reel, was in drives:
            if was.image and was.image not in mounted and not reel.drive.image:
                reel.drive.mount(was.image, bool(was.locked))
                reel.drive.blocks = was.blocks

    def images(self) -> list[dectape.Image]:
        """Return the reels as they were mounted."""
        reels = (place.drive for place in self.mounted() if isinstance(place, Reel))
        return [drive.image for drive in reels if drive.image]

    def mount(self, device: str, name: str, locked: bool = False) -> list[str]:
        """Mount the image in a file; return notes about it. Raises WorkError, and changes nothing then."""
        place = self.places[device]
        for other in self.mounted():
            if other.unit == place.unit and other is not place and _same(other.file, shelf.find(name)):
                raise WorkError(f"{name} is on {other.place}: a reel is on one drive")
        return place.mount(name, locked)

    def said(self, device: str) -> str:
        """Say how much was written and not saved, "" for nothing."""
        place = self.places[device]
        number = place.changed()
        return f"{place.place}: {counted(number, place.unit)} of {place.file} changed" if number else ""

    def save(self, device: str, name: str) -> str:
        """Save a reel or the discs as they are now; return what to say of it. Raises WorkError."""
        if any(_same(each.file, name) for each in self.mounted()):
            raise WorkError(f"{name} was mounted; name another file")
        return self.places[device].save(name)

    def rescue(self) -> Iterator[str]:
        """Save each changed reel, and changed discs, beside their file or in the temporary folder; yield a
        message for each. Raises WorkError for those that cannot be saved, after the others.
        """
        lost: list[str] = []
        for place in self.mounted():
            if written := self.said(place.device):
                try:
                    said = self._save_beside(place)
                except WorkError as error:
                    lost.append(f"{written}, and not saved: {error}")
                else:
                    yield f"{written}, and not saved: {said}"
        if lost:
            raise WorkError("; ".join(lost))

    def _save_beside(self, place: Reel | Discs) -> str:
        try:
            return self.save(place.device, _free(place.file))
        except WorkError:
            name = os.path.basename(place.file)
            return self.save(place.device, _free(os.path.join(tempfile.gettempdir(), name)))


def device(text: str) -> str:
    """Return the name of the device that "0", "dt0" or "df0" is. Raises WorkError."""
    return "df" if text.lower() in ("df", "df0") else _drive(text)


def _drive(text: str) -> str:
    number = text.lower().removeprefix("dt")
    if number not in [str(unit) for unit in UNITS]:
        raise WorkError(f"{text}: the drives are dt0 to dt7")
    return f"dt{number}"


def assignment(text: str) -> tuple[str, str]:
    """Return the device of a drive and the file, of "0=FILE". Raises WorkError."""
    unit, found, name = text.partition("=")
    if not found or not name:
        raise WorkError(f"{text}: a drive and a file expected, as in 0=ps8.tu56")
    return _drive(unit), name


def _same(before: str, name: str) -> bool:
    return shelf.has(before) and shelf.identity(shelf.find(before)) == shelf.identity(name)


def _free(name: str) -> str:
    """Return an unused name like that of a file."""
    stem, ending = os.path.splitext(name)
    numbered = (f"{stem}-changed{'' if number == 1 else f'-{number}'}{ending}" for number in range(1, 1000))
    return next(each for each in numbered if not os.path.exists(each))
