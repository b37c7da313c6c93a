"""The fixed-head disk DF32 (60, 61, 62) with one to four discs of 32,768 words.

    60   DCMA 1  address and flags 0      DMAR 2  read, DMAW 4  write: address <- it or AC, AC <- 0
    61   DCEA 1  extension and field 0    DSAC 2  skip if the disc is at the address
         DEAL 5  extension and field <- AC 1-8 (4: or)            DEAC 6  AC <- status
    62   DFSE 1  skip if no error         DFSC 2  skip if done    DMAC 6  AC <- address

    status    photocell 4000 | extension 3700 | field 70 | data late 4 | write lock or no disc 2 | parity 1

The disc turns in 33.8 ms. A track has 2048 words, and the next word comes with every fourth place:

    place   0  1     2     3     4  5  ...   2047        330 ticks, 16.5 µs, from place to place
    word    0  512   1024  1536  1  513 ...  2047        66 µs from word to word

Words go by three-cycle data break, word count in 7750, current address in 7751, until the word count
overflows. The address is then that of the next word, after a write of the last one. Address and extension
count as one number of 17 bits. The disc turns since power-up.

Eight switches WLS lock 16,384 words each. Data late: a break was not taken before the next word.

By convention: the interleaving by four, which 33 ms a turn and 66 µs a word demand; the photocell is seen
before word 0, during six words; a word to write is asked for one word ahead; a locked or missing disc is an
error at the word. DEAC names a missing one as soon as the extension does: so DEC's MAINDEC-08-D5DB counts the
discs. Not emulated: parity errors.

Sources: Small Computer Handbook 1970 (66 µs, 16.67 ms on average); SIMH PDP8/pdp8_df.c (pulses, status, WLS,
the address after a write); fpw/SoCDP8 df32.vhd (which digit does what).
"""

from array import array
from typing import Final

from pdp8.computer.hardware.bus import BreakDevice, Bus, Device
from pdp8.computer.hardware.fields import BIT, FRAMES, TICK, saved
from pdp8.computer.hardware.signals import CLEAR_AC, NEVER, SKIP
from tapes.dectape import low_first, packed

DISC = 0o100000
LOCKED_TOGETHER = 0o40000
PLACE: Final = 330
_TRACK, _TURN = 2048, 2048 * PLACE
WORD: Final = 4 * PLACE
_PHOTOCELL = 6 * WORD
LATE, REFUSED = 4, 2


class DF32(BreakDevice):
    """The control: device 60, with two doors for 61 and 62; `words` is what is on its discs."""

    NAME = "df32"
    CODE = 0o60
    ADDRESS = 0o7750
    fields = saved(
        **dict.fromkeys(("flag", "tested", "breaking", "into_core", "done", "busy", "over"), BIT),
        **dict.fromkeys(("due", "asked", "late"), TICK),
        at="377777",
        field="70000",
        status="7",
        buffer="7777",
        locks="377",
        content=FRAMES,
    )

    def __init__(self) -> None:
        super().__init__()
        self.words = array("H", bytes(2 * DISC))
        """The words of one to four discs."""
        self.locks = 0
        """The switches WLS, the first in the lowest bit."""
        self.at = 0
        """Extension and address."""
        self.status = 0
        """The errors."""
        self.done = self.busy = self.over = 0
        self.buffer = 0
        self.late = NEVER
        """The tick by which a break that is asked for has to be accepted."""

    @property
    def content(self) -> bytes:
        """The words as an image has them: 65,536 bytes a disc."""
        return packed(self.words)

    @content.setter
    def content(self, content: bytes) -> None:
        words = low_first(array("H", content[: len(content) & ~1]))
        if len(content) not in range(2 * DISC, 8 * DISC + 1, 2 * DISC) or max(words) > 0o7777:
            raise ValueError("one to four discs of 65,536 bytes, words of 12 bits")
        self.words = words

    def connect(self, bus: Bus) -> None:
        """Connect the control under its three codes."""
        super().connect(bus)
        for code in (0o61, 0o62):
            bus.connect(code, Door(self))

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """DCMA at IOP1, DMAR at IOP2, DMAW at IOP4."""
        if iop == 1:
            self.at &= ~0o7777
            self.status = 0
            self._end(0)
            return 0
        self.at |= ac
        self.done = self.over = 0
        self.busy, self.into_core = 1, 1 if iop == 2 else 0
        self._flags()
        self._plan(now)
        return CLEAR_AC

    def pulse_extension(self, iop: int, iot: int, ac: int, now: int) -> int:
        """Code 61."""
        if iop == 1:
            self.at &= 0o7777
            self.field = 0
        elif iop == 2:
            return CLEAR_AC if iot & 4 else SKIP if _comes(self.at, now - PLACE) <= now else 0
        elif iot & 2:
            photocell = 0o4000 if -now % _TURN <= _PHOTOCELL else 0
            missing = REFUSED if self.at >= len(self.words) else 0
            return photocell | self.at >> 6 & 0o3700 | self.field >> 9 | missing | self.status
        else:
            self.at |= (ac & 0o3700) << 6
            self.field |= (ac & 0o70) << 9
        return 0

    def pulse_flags(self, iop: int, iot: int) -> int:
        """Code 62."""
        if iop == 1:
            return 0 if self.status else SKIP
        if iop == 2:
            return CLEAR_AC if iot & 4 else SKIP if self.done else 0
        return self.at & 0o7777

    def _plan(self, now: int) -> None:
        """Plan the next word; one to write is asked for ahead of it."""
        self.asked = self.late = NEVER
        self.due = _comes(self.at, now if self.into_core else now + WORD) - (0 if self.into_core else WORD)

    def advance(self, now: int) -> None:
        """Let happen what happens up to tick `now`; a request waits until it is accepted."""
        while self.due <= now:
            if self.asked == NEVER:
                self._word(self.due)
            elif self.late <= now:
                self.status |= LATE
                self._end(1)
            else:
                return

    def _word(self, now: int) -> None:
        """The word has come, or is to be asked for."""
        locked = not self.into_core and self.locks >> self.at // LOCKED_TOGETHER & 1
        if self.at >= len(self.words) or locked:
            self.status |= REFUSED
            self._end(1)
            return
        if self.into_core:
            self.buffer = self.words[self.at]
        self.asked = self.due = now
        self.late = now + WORD

    def accepted(self, now: int) -> None:
        """BRK RQ falls; what comes next is planned after the BREAK cycle."""
        self.due = self.late = NEVER

    def overflow(self, now: int) -> None:
        """WC has overflowed: this is the last word."""
        self.over = 1

    def give(self, now: int) -> int:
        """Return the word that was read."""
        self._next(now)
        return self.buffer

    def take(self, word: int, now: int) -> None:
        """Write the word, unless the program has changed the address to a missing disc meanwhile."""
        if self.at < len(self.words):
            self.words[self.at] = word
        self._next(now)

    def _next(self, now: int) -> None:
        if self.over and not self.into_core:
            self._end(1)
            return
        self.at = self.at + 1 & 0o377777
        if self.over:
            self._end(1)
        else:
            self._plan(now)

    def _end(self, done: int) -> None:
        self.done, self.busy = done, 0
        self.asked = self.due = self.late = NEVER
        self._flags()

    def _flags(self) -> None:
        self.flag = 1 if self.done or self.status else 0

    def initialize(self, now: int) -> None:
        """Clear everything; what moves stops."""
        self.at = self.field = self.status = self.breaking = 0
        self._end(0)


class Door(Device):
    """Device 61 or 62 of the same control."""

    fields = saved(tested=BIT)

    def __init__(self, control: DF32) -> None:
        super().__init__()
        self.control = control

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """Pass the pulse on to the control."""
        if self.control.due <= now:
            self.control.advance(now)
        if self.code == 0o61:
            return self.control.pulse_extension(iop, self.iot, ac, now)
        return self.control.pulse_flags(iop, self.iot)

    def advance(self, now: int) -> None:
        """Nothing happens here by itself."""

    def initialize(self, now: int) -> None:
        """The control does it."""


def _comes(at: int, now: int) -> int:
    """Return the first tick after `now` at which word `at` is under its head."""
    word = at % _TRACK
    place = 4 * word % _TRACK + 4 * word // _TRACK
    return now + 1 + (place * PLACE - now - 1) % _TURN
