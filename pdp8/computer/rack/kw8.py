"""The clock KW8/L (13), at the frequency of the line.

    6132 CCFF   flag, clock and interrupt off       6136 CCEC   all off, then clock on
    6133 CSCF   skip if the flag is up, clear it    6137 CECI   all off, then clock and interrupt on

The flag rises each 1/60 s after the clock was turned on. Source: the drawings of the 8/I's KW8/I as decoded
in fpw/SoCDP8, kw8i.vhd; 6136 as DEC's name says. By convention: 6131, 6134 and 6135 do nothing. Not emulated:
the models with a crystal.
"""

from pdp8.computer.hardware.bus import Device
from pdp8.computer.hardware.fields import BIT, TICK, saved
from pdp8.computer.hardware.signals import NEVER, SKIP, TICKS_PER_SECOND

PERIOD = TICKS_PER_SECOND // 60


class KW8(Device):
    """The clock."""

    NAME = "kw8"
    CODE = 0o13
    fields = saved(flag=BIT, tested=BIT, enabled=BIT, due=TICK)

    def __init__(self) -> None:
        super().__init__()
        self.enabled = 0

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """Test at IOP1, turn off at IOP2, turn on at IOP4."""
        if iop == 1:
            return SKIP if self.iot == 3 and self.flag else 0
        if iop == 2:
            self.flag = 0
            if self.iot != 3:
                self.initialize(now)
        elif self.iot & 2:
            self.due = now + PERIOD
            self.enabled = self.iot & 1
        return 0

    def advance(self, now: int) -> None:
        """Raise the flag at each period up to tick `now`."""
        while self.due <= now:
            self.flag = 1
            self.due += PERIOD

    def initialize(self, now: int) -> None:
        """Turn everything off."""
        self.flag = self.enabled = 0
        self.due = NEVER
