"""The line printer LP08 (66): 132 columns, 300 lines a minute.

    6661 PSKF   skip if the flag is up       6664 PSTB   print AC 5-11, without flag down
    6662 PCLF   clear the flag               6665 PSIE   interrupt on
    6663 PSKE   skip on an error             6666 PCLF and PSTB     6667 PCIE   interrupt off

A character goes into the printer's buffer in 10 µs; line feed, form feed, carriage return and a full buffer
print the line, and the flag comes when it is printed, 1/5 s later. The codes are ASCII without channel 8;
small letters print as capitals.

By convention: the times, and that the interrupt is off at power-up. Not emulated: errors, as when paper is
out. Source: SIMH, PDP8/pdp8_lp.c; OS/8 Handbook.
"""

from pdp8.computer.hardware.bus import Device
from pdp8.computer.hardware.fields import BIT, FRAMES, TICK, saved
from pdp8.computer.hardware.signals import NEVER, SKIP, TICKS_PER_SECOND

_COLUMNS = 132
_INTO_BUFFER, _LINE = 200, TICKS_PER_SECOND // 5
_ENDS = b"\n\f\r"


class LP08(Device):
    """The printer and its control; `paper` is what it has been sent to print."""

    NAME = "lp08"
    CODE = 0o66
    fields = saved(flag=BIT, tested=BIT, enabled=BIT, due=TICK, column=_COLUMNS, frames=FRAMES)

    def __init__(self) -> None:
        super().__init__()
        self.enabled = 0
        self.column = 0
        """Characters in the buffer."""
        self.frames = bytearray()

    @property
    def paper(self) -> str:
        """The text that was printed."""
        return self.frames.decode("ascii")

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """Do what the digit of the instruction says, at its last pulse."""
        if iop == 1:
            return SKIP if self.iot == 1 and self.flag else 0
        if self.iot in (5, 7):
            self.enabled = 1 if self.iot == 5 else 0
        elif iop == 2 and self.iot != 3:
            self.flag = 0
        elif iop == 4:
            self._print(ac & 0o177, now)
        return 0

    def _print(self, code: int, now: int) -> None:
        ends = code in _ENDS or self.column == _COLUMNS
        self.column = 0 if ends else self.column + 1
        self.frames.append(code - 0o40 if 0o141 <= code <= 0o172 else code)
        self.due = now + (_LINE if ends else _INTO_BUFFER)

    def advance(self, now: int) -> None:
        """Raise the flag when the character is in the buffer or the line printed."""
        if self.due <= now:
            self.due = NEVER
            self.flag = 1

    def initialize(self, now: int) -> None:
        """Clear flag, interrupt and buffer."""
        self.flag = self.enabled = self.column = 0
        self.due = NEVER
