"""The input/output bus: what the processor and a device say to each other.

                      IOP1 IOP2 IOP4, device code, AC
         processor  ──────────────────────────────────►  device   (flag, due)
                    ◄──────────────────────────────────
                      SKIP, clear AC, data or-ed into AC; interrupt request

A device sees three separate pulses, so that every combined IOT works of itself; where its gates need the
instruction, `iot` has its last digit. Its flag is its interrupt request, unless the device itself disables
it. Between pulses a device knows the tick at which its flag changes next; it is brought up to date when its
state is needed.

A BreakDevice moves words to and from core by data break, between two instructions:

    BRK RQ ──► up at TP1 of a last cycle? ──► address accepted ──► WORD COUNT, CURRENT ADDRESS, BREAK
                                                                   or BREAK alone

A new device is a class derived from Device, in a file of its own: it says in `fields` what a saved state
holds of it, and Machine.fit connects it (docs/pdp8.md has one as an example).

Source: Small Computer Handbook 1970, chapter 9 (I/O bus).
"""

from collections.abc import Iterator
from typing import Protocol

from pdp8.computer.hardware.fields import BIT, COUNT, TICK, saved
from pdp8.computer.hardware.signals import CLEAR_AC, IOP1, IOP2, IOP4, NEVER, SKIP


class Peripheral(Protocol):
    """One device or several that belong together, to fit to a machine."""

    NAME: str
    """What commands call it."""
    CODE: int
    """Its device code, or the first of its codes."""

    def connect(self, bus: "Bus") -> None:
        """Connect every device of it to the bus."""


class Device:
    """One device code: a flag, and `due`, the tick at which it changes next."""

    fields = saved(flag=BIT, tested=BIT, due=TICK)
    """What a saved state holds of the device: its attributes, and how each is written (see fields.py)."""
    NAME = ""
    """What commands call it, if they know it."""
    CODE = 0
    """The device code."""

    def __init__(self) -> None:
        self.code = 0
        self.behind: Device | None = None
        """The next device on the cable."""
        self.flag = 0
        self.iot = 0
        """The last digit of the instruction under way: which pulses it has."""
        self.tested = 0
        """Set by IOP1, until the bus forgets the tests."""
        self.due = NEVER
        self.enabled = 1
        """Whether the flag requests an interrupt."""

    def connect(self, bus: "Bus") -> None:
        """Connect the device to the bus, under its CODE."""
        bus.connect(self.CODE, self)

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """Take pulse IOP1, IOP2 or IOP4 (1, 2, 4) at tick `now`; return the answer. IOP1 may only test the
        flag, so that loops that only test can be skipped.
        """
        raise NotImplementedError

    def restored(self) -> None:
        """Set `due` from the other fields, because a saved state did not give it."""

    def advance(self, now: int) -> None:
        """Let everything happen that happens up to and including tick `now`."""
        raise NotImplementedError

    def initialize(self, now: int) -> None:
        """INITIALIZE, from the START key or at power-up."""
        raise NotImplementedError

    def look(self) -> None:
        """Note that a tape, key or lever has changed; the device acts when time goes on."""

    def finish(self) -> None:
        """The processor has stopped: finish what the mechanism has begun; the flag rises when it is due."""

    def out_of_tape(self) -> bool:
        """Tell whether the program asked for a frame of a tape that has run out."""
        return False


class BreakDevice(Device):
    """A device with a data break; a request sets `asked`, and `due` is that tick until it is accepted."""

    THREE_CYCLE = True
    """Whether word count and current address are in core."""
    ADDRESS = 0
    """The address of the word count, which that of the current address follows."""

    def __init__(self) -> None:
        super().__init__()
        self.asked = NEVER
        """The tick at which BRK RQ rose; NEVER while it is down."""
        self.breaking = 0
        """Set from the request's acceptance to the end of the BREAK cycle."""
        self.address = self.ADDRESS
        """Where the first cycle goes."""
        self.field = 0
        """The field of the BREAK cycle, as the address of its first word."""
        self.three_cycle = 1 if self.THREE_CYCLE else 0
        self.counts_address = 1
        """Whether CURRENT ADDRESS adds 1."""
        self.into_core = 0
        """DATA IN: the word goes into core, else out of it."""
        self.increments = 0
        """MEM INCREMENT: out of core, and the word in core counts up."""

    def accepted(self, now: int) -> None:
        """BRK RQ was accepted at tick `now`: set `due` to what comes next."""

    def overflow(self, now: int) -> None:
        """The word count became 0."""

    def give(self, now: int) -> int:
        """Return the word that goes into core."""
        raise NotImplementedError

    def take(self, word: int, now: int) -> None:
        """Take the word that comes out of core."""
        raise NotImplementedError


class Bus:
    """The devices on the cable, one behind the other; unused codes do not answer."""

    fields = saved(actions=COUNT)

    def __init__(self) -> None:
        self.first: Device | None = None
        self.has_breaks = False
        """Whether a device with a data break is fitted."""
        self.actions = 0
        """How many pulses other than IOP1, and how many INITIALIZE, ION and IOF, there have been."""

    def __iter__(self) -> Iterator[Device]:
        device = self.first
        while device is not None:
            yield device
            device = device.behind

    def connect(self, code: int, device: Device) -> None:
        """Connect `device` under `code`, in front of the others. Raises ValueError for an impossible or used
        code.
        """
        if not 0o01 <= code <= 0o77:
            raise ValueError(f"device code {code:o}: 01 to 77 are allowed")
        if device.code or self.device(code) is not None:
            raise ValueError(f"device {code:02o} is fitted already")
        if isinstance(device, BreakDevice):
            self.has_breaks = True
        device.code = code
        device.behind = self.first
        self.first = device

    def device(self, code: int) -> Device | None:
        """Return the device that answers to `code`, if one is fitted."""
        device = self.first
        while device is not None and device.code != code:
            device = device.behind
        return device

    def transfer(self, word: int, lac: int, clock: int) -> int:
        """Send the pulses of IOT `word` at tick `clock`; return {L, AC}, and above its 13 bits 1 for SKIP."""
        device = self.device(word >> 3 & 0o77)
        if device is None:
            return lac
        device.iot = word & 7
        if word & 1:
            device.tested = 1
            lac = _pulse(device, 1, lac, clock + IOP1)
        if word & 2:
            self.actions += 1
            lac = _pulse(device, 2, lac, clock + IOP2)
        if word & 4:
            self.actions += 1
            lac = _pulse(device, 4, lac, clock + IOP4)
        return lac

    def advance(self, now: int) -> None:
        """Bring every device to tick `now`."""
        for device in self:
            device.advance(now)

    def forget_tests(self) -> None:
        """Forget which devices were sent IOP1."""
        device = self.first
        while device is not None:
            device.tested = 0
            device = device.behind

    def request(self, now: int) -> bool:
        """Tell whether any device requests an interrupt at tick `now`."""
        device = self.first
        while device is not None:
            if device.due <= now:
                device.advance(now)
            if device.flag and device.enabled:
                return True
            device = device.behind
        return False

    def accept_break(self, tp1: int, now: int) -> BreakDevice | None:
        """Accept the break requested by `tp1`, of the nearest device on the cable; return the device."""
        device = self.first
        while device is not None:
            if isinstance(device, BreakDevice):
                asking: BreakDevice = device
                if asking.due <= tp1:
                    asking.advance(tp1)
                if asking.asked <= tp1:
                    asking.asked = NEVER
                    asking.breaking = 1
                    asking.accepted(now)
                    return asking
            device = device.behind
        return None

    def in_break(self) -> BreakDevice | None:
        """Return the device whose break is under way."""
        device = self.first
        while device is not None:
            if isinstance(device, BreakDevice):
                asking: BreakDevice = device
                if asking.breaking:
                    return asking
            device = device.behind
        return None

    def next_event(self, now: int) -> int:
        """Return the tick after `now` of the next flag change or data break, NEVER if none will come."""
        event = NEVER
        device = self.first
        while device is not None:
            if device.due <= now:
                device.advance(now)
            event = min(event, device.due)
            device = device.behind
        return event

    def finish(self) -> None:
        """Let every mechanism finish what it has begun."""
        for device in self:
            device.finish()

    def initialize(self, now: int) -> None:
        """INITIALIZE on every device."""
        self.actions += 1
        for device in self:
            device.initialize(now)


def _pulse(device: Device, iop: int, lac: int, now: int) -> int:
    """Send one pulse; return {L, AC} as the answer leaves them, and 1 above them for SKIP."""
    if device.due <= now:
        device.advance(now)
    answer = device.pulse(iop, lac & 0o7777, now)
    if answer & CLEAR_AC:
        lac &= 0o30000
    if answer & SKIP:
        lac |= 0o20000
    return lac | answer & 0o7777
