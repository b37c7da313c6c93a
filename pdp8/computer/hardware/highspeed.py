"""The high-speed reader (01) and punch (02), PC8/L: 300 and 50 characters a second, fitted on request.

    reader   RSF 1 skip if flag | RRB 2 AC or buffer, flag down | RFC 4 flag down, buffer 0, fetch a frame
    punch    PSF 1 skip if flag | PCF 2 flag down, buffer 0     | PPC 4 buffer or AC, punch it

The reader's flag rises when the frame is in the buffer, 1/300 s after RFC, and never if there is no more
tape; the punch's flag 1/50 s after PPC.

By convention: an RFC while a frame is coming clears flag and buffer and starts no second one; a PPC while the
punch works ors into the frame it is about to punch.

Not emulated: the reader's start and stop times (a program that keeps it waiting loses nothing here), the feed
switch. Sources: Small Computer Handbook 1970, PC8 reader and punch; PDP-8/I instruction card.
"""

from pdp8.computer.hardware.bus import Bus, Device
from pdp8.computer.hardware.fields import BIT, PART, TICK, saved
from pdp8.computer.hardware.signals import AT_ONCE, NEVER, SKIP
from pdp8.computer.hardware.teletype import Punch, Reader

READ_TICKS = 66_667
PUNCH_TICKS = 400_000


class ReaderControl(Device):
    """Device 01."""

    fields = saved(flag=BIT, tested=BIT, due=TICK, buffer="377", fetching=BIT, reader=PART)

    def __init__(self) -> None:
        super().__init__()
        self.reader = Reader(self)
        self.buffer = 0
        self.fetching = 0
        """Set by RFC until the frame is in the buffer."""

    def look(self) -> None:
        """Look whether there is a frame to fetch now."""
        if self.fetching and self.due == NEVER:
            self.due = AT_ONCE

    def fetch(self, now: int) -> None:
        """Start the tape at tick `now`, if there is one."""
        self.fetching = 1
        self.due = now + READ_TICKS if self.reader.ready() else NEVER

    def advance(self, now: int) -> None:
        """Take the frame into the buffer if it has come by tick `now`."""
        if self.due == AT_ONCE:
            self.fetch(now)
        elif self.due <= now:
            self.due = NEVER
            if self.reader.ready():
                self.buffer = self.reader.tape[self.reader.position]
                self.reader.position += 1
                self.flag = 1
                self.fetching = 0

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """RSF at IOP1, RRB at IOP2, RFC at IOP4."""
        if iop == 1:
            return SKIP if self.flag else 0
        self.advance(now)
        self.flag = 0
        if iop == 2:
            return self.buffer
        self.buffer = 0
        if not self.fetching:
            self.fetch(now)
        return 0

    def initialize(self, now: int) -> None:
        """Clear flag and buffer; a frame that was coming is lost to the program."""
        self.advance(now)
        self.flag = self.buffer = self.fetching = 0
        self.due = NEVER

    def out_of_tape(self) -> bool:
        """Tell whether a frame is asked for and the tape has run out."""
        return self.fetching == 1 and self.reader.empty()


class PunchControl(Device):
    """Device 02."""

    fields = saved(flag=BIT, tested=BIT, due=TICK, buffer="377", punched=BIT, punch=PART)

    def __init__(self) -> None:
        super().__init__()
        self.punch = Punch()
        self.buffer = 0
        self.punched = 0
        """Set while the punch is busy with a frame that `finish` has punched already."""

    def advance(self, now: int) -> None:
        """Punch the frame whose time has come by tick `now`."""
        if self.due <= now:
            self.flag = 1
            try:
                self.finish()
            finally:
                self.punched = 0
                self.due = NEVER

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """PSF at IOP1, PCF at IOP2, PPC at IOP4."""
        if iop == 1:
            return SKIP if self.flag else 0
        self.advance(now)
        if iop == 2:
            self.flag = self.buffer = 0
        else:
            self.buffer |= ac & 0o377
            if self.due == NEVER:
                self.due = now + PUNCH_TICKS
        return 0

    def finish(self) -> None:
        """Punch the frame the punch has begun."""
        if self.due != NEVER and not self.punched:
            self.punched = 1
            self.punch.take(self.buffer)

    def initialize(self, now: int) -> None:
        """Clear the flag and the buffer; a frame that is being punched is punched."""
        self.advance(now)
        self.finish()
        self.flag = self.buffer = self.punched = 0
        self.due = NEVER


class HighSpeed:
    """The reader and the punch of the PC8/L."""

    NAME = "highspeed"
    CODE = 0o01

    def __init__(self) -> None:
        self.reader_control = ReaderControl()
        self.punch_control = PunchControl()
        self.reader = self.reader_control.reader
        self.punch = self.punch_control.punch
        self.fitted = False

    def connect(self, bus: Bus) -> None:
        """Connect both to the bus."""
        self.fitted = True
        bus.connect(self.CODE, self.reader_control)
        bus.connect(0o02, self.punch_control)
