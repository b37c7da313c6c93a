"""The DECtape control TC08 (76, 77) with its TU55 transports 0 to 7.

    76   DTRA 1  AC or A          DTCA 2  A <- 0    DTXA 4  A <- A xor AC 0-9; AC 10 = 0: error flags off,
    77   DTSF 1  skip if a flag   DTRB 2  AC or B           AC 11 = 0: DECtape flag off; AC <- 0
                                                    DTLB 4  the field in B <- AC 6-8; AC <- 0

    A   unit 7000 | reverse 400 | go 200 | continuous 100 | function 70 | interrupt enable 4
    B   error 4000 | mark track 2000 | end zone 1000 | select 400 | parity 200 | timing 100 | field 70
        DECtape 1

    0 move    1 search    2 read    3 read all    4 write    5 write all

A block is 576 lines in both directions: 30 with its number at lines 6 to 11, 129 words of 4 lines, 30 with
the checksum in the first 6. Words go to and from core by three-cycle data break, word count in 7754, current
address in 7755:

    search      the number of each block, CA unchanged     DECtape flag with it; continuous: when WC overflows
    read,write  words until WC overflows, then the block   DECtape flag after the checksum; continuous: when
                passes by, and zeros are written           WC has overflowed
    all         4 lines each, from line 2 of a block on:   DECtape flag with each; continuous: when WC
                7 groups, the words, 8 groups              overflows

A word is read at its end. A word to write is asked for half a line before its first line, and the flag after
a checksum comes 3 1/2 lines after the last word.

After a change of unit, direction or go the control does not read the tape for 120 ms (U + M delay), and not
before it is fast enough (tu55.py); then it waits for the number of a block. Read the other way, a word is the
complement of its four lines in the other order.

Timing error: a word was not moved before the next one, the DECtape flag is up as the next block begins, or
read or write is commanded within a block. Select error: no tape at that unit, it is write locked, or function
6 or 7. End zone, and these, clear GO. Parity error: a block's words and two checksums do not add up to 77.

By convention: the select error comes at once (5 us later); search begins with the whole of a number, read
and write with the whole of a block; read all and write all begin with a whole group; write all changes only
words and checksums; a word is on the tape as soon as it is taken; a parity error comes with the flag. The
checksums of an image, which has none, are right. Mark track errors never come.

Not emulated: writing the timing and mark track, the transport's own switches for motion.

Sources: DEC TC08 maintenance manual, by its drawings in drovak/verilogpdp, pdp8i/tc08.v (delay of 120 ms,
started by AC 0-4 of DTXA; speed of 70 us a line; groups, requests and flags by running them); OS/8 Handbook;
SIMH PDP8/pdp8_dt.c (the lines of a block); DEC-08-EUFB (what the formatter writes between words).
"""

from pdp8.computer.dectape.tu55 import BLOCK_LINES, END_ZONE, LINE, LINES, Transport
from pdp8.computer.hardware.bus import BreakDevice, Bus, Device
from pdp8.computer.hardware.fields import BIT, PART, TICK, saved
from pdp8.computer.hardware.signals import CLEAR_AC, NEVER, SKIP
from tapes.dectape import BLOCKS, WORDS

DELAY = 2_400_000
"""The U + M delay in ticks, 120 ms."""
CLEARED = 40
"""Ticks after DTCA until the tape stops; DTXA in the same instruction comes before that."""

REVERSE, GO, CONTINUOUS, ENABLE = 0o400, 0o200, 0o100, 0o4
ERROR, END, SELECT, PARITY, TIMING, DONE = 0o4000, 0o1000, 0o400, 0o200, 0o100, 0o1
SEARCH, READ, READ_ALL, WRITE, WRITE_ALL = 1, 2, 3, 4, 5
HEADER, NUMBER, WORD, CHECKED = 30, 12, 4, 550
"""Lines of a block: before its words, to the end of its number, of a word, of the checksum's group."""
FIRST, BESIDE, GROUPS = 2, 7, BLOCK_LINES // WORD
"""The line at which a block's groups of four begin; groups before its words, and in all."""

# What comes at `due`.
NOTHING, STOP, ZONE, BLOCK, NEXT, CHECK = 0, 1, 2, 3, 4, 5


def turned(word: int) -> int:
    """Return a word as it is read the other way."""
    word ^= 0o7777
    return word >> 9 | word >> 3 & 0o70 | (word & 0o70) << 3 | (word & 7) << 9


class TC08(BreakDevice):
    """The control: device 76, and `door`, device 77."""

    NAME = "dectape"
    CODE = 0o76
    ADDRESS = 0o7754
    fields = saved(
        **dict.fromkeys(
            ("flag", "tested", "enabled", "breaking", "counts_address", "into_core", "over"), BIT
        ),
        **dict.fromkeys(("due", "asked", "late", "settled"), TICK),
        **dict.fromkeys(("a", "b", "buffer"), "7777"),
        **dict.fromkeys((f"drive{unit}" for unit in range(8)), PART),
        field="70000",
        event=CHECK,
        block=BLOCKS,
        word=GROUPS,
    )

    def __init__(self) -> None:
        super().__init__()
        self.enabled = 0
        self.a = self.b = 0
        """Status registers A and B."""
        self.buffer = 0
        """The word to or from the tape."""
        self.event = NOTHING
        self.block = 0
        """The block of the event, counted in the direction of motion."""
        self.word = 0
        """The word, or the group of four lines, of the event, counted in the same direction."""
        self.over = 0
        """Whether WC has overflowed."""
        self.late = NEVER
        """The tick by which a break that is asked for has to be accepted."""
        self.settled = 0
        """The tick at which the U + M delay ends."""
        self.door = Door(self)
        self.drives = [Transport() for _ in range(8)]
        for unit, drive in enumerate(self.drives):
            setattr(self, f"drive{unit}", drive)

    def connect(self, bus: Bus) -> None:
        """Connect the control under its two codes."""
        bus.connect(self.CODE, self)
        bus.connect(self.door.CODE, self.door)

    @property
    def drive(self) -> Transport:
        """The transport that is selected."""
        return self.drives[self.a >> 9]

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """DTRA at IOP1, DTCA at IOP2, DTXA at IOP4."""
        if iop == 1:
            return self.a
        if iop == 2:
            self.a = 0
            self._flags()
            self._plan(STOP, now + CLEARED)
            return 0
        self.b &= 0o71 if not ac & 2 else 0o7777
        self.b &= 0o7776 if not ac & 1 else 0o7777
        self.a ^= ac & 0o7774
        if ac & 0o7600:
            self.settled = now + DELAY
        self._flags()
        self._command(now)
        return CLEAR_AC

    def pulse_b(self, iop: int, ac: int) -> int:
        """DTSF at IOP1, DTRB at IOP2, DTLB at IOP4."""
        if iop == 1:
            return SKIP if self.flag else 0
        if iop == 2:
            return self.b
        self.b = self.b & 0o7707 | ac & 0o70
        self.field = (ac & 0o70) << 9
        return CLEAR_AC

    def initialize(self, now: int) -> None:
        """Clear both registers; the selected tape stops."""
        self.drive.stop(now)
        self.a = self.b = self.field = self.breaking = self.over = 0
        self._flags()
        self._plan(NOTHING, NEVER)

    def _flags(self) -> None:
        self.flag = self.door.flag = 1 if self.b & (ERROR | DONE) else 0
        self.enabled = 1 if self.a & ENABLE else 0

    def _error(self, which: int, now: int) -> None:
        self.b |= ERROR | which
        self.a &= ~GO
        self.drive.stop(now)
        self._flags()
        self._plan(NOTHING, NEVER)

    def _done(self) -> None:
        self.b |= DONE
        self._flags()

    def _command(self, now: int) -> None:
        """Obey status register A."""
        drive, function = self.drive, self.a >> 3 & 7
        self.over = 0
        self._plan(NOTHING, NEVER)
        if not self.a & GO:
            drive.stop(now)
        elif drive.image is None or function > WRITE_ALL or (function >= WRITE and drive.locked):
            self._error(SELECT, now)
        else:
            drive.go(1 if self.a & REVERSE else 0, now)
            self._look_ahead(now)

    def _look_ahead(self, now: int) -> None:
        """Plan the first event of a function."""
        reads = max(self.settled, self.drive.readable_from(now))
        ready, begun = max(now, reads), self._along(reads)
        waits = ready > now
        at, function = self._along(ready), self.a >> 3 & 7
        self.word = 0
        if function == SEARCH:
            self.block = _first(at, NUMBER - 6)
            self._plan_at(BLOCK, NUMBER, ready)
        elif function in (READ, WRITE):
            self.block = _first(at, NUMBER - 6 if waits else HEADER - 6)
            if _first(begun, NUMBER - 6) <= _first(at + LINE // 2, CHECKED) < self.block:
                self._error(TIMING, now)
            else:
                self._plan_word(ready)
        elif function in (READ_ALL, WRITE_ALL):
            group = _first(at, FIRST + WORD if function == READ_ALL else FIRST - 2, WORD)
            self.block, self.word = group // GROUPS, group % GROUPS
            self._plan_word(ready)
        else:
            self._plan_zone(ready)

    def _along(self, now: int) -> int:
        """Return where the tape is, from the end at which its motion begins."""
        at = self.drive.position(now)
        return LINES * LINE - at if self.a & REVERSE else at

    def _plan(self, event: int, due: int) -> None:
        self.event, self.due = event, due
        self.asked = self.late = NEVER

    def _plan_at(self, event: int, line: int, now: int, before: int = 0) -> None:
        """Plan an event at a line of the block, less a lead time; past the last block plan the end zone."""
        if self.block >= BLOCKS:
            self._plan_zone(now)
        else:
            place = (END_ZONE + BLOCK_LINES * self.block + line) * LINE - before
            self._plan(event, max(self._tick_at(place, now), now))

    def _plan_zone(self, now: int) -> None:
        self._plan(ZONE, max(self._tick_at((LINES - END_ZONE) * LINE, now), now))

    def _tick_at(self, place: int, now: int) -> int:
        return self.drive.tick_at(LINES * LINE - place if self.a & REVERSE else place, now)

    def _plan_word(self, now: int) -> None:
        """Plan the next word: read at its end, asked for before it is written."""
        function = self.a >> 3 & 7
        line = (HEADER if function in (READ, WRITE) else FIRST) + WORD * self.word
        if function in (READ, READ_ALL):
            self._plan_at(NEXT, line + WORD, now)
        else:
            self._plan_at(NEXT, line, now, LINE // 2)

    def _plan_check(self, now: int) -> None:
        self._plan_at(CHECK, CHECKED, now, LINE // 2)

    def advance(self, now: int) -> None:
        """Let happen what happens up to tick `now`; a request waits until it is accepted."""
        while self.due <= now:
            if self.asked == NEVER:
                self._happen(self.due)
            elif self.late <= now:
                self._error(TIMING, self.late)
            else:
                return

    def _happen(self, now: int) -> None:
        if self.event == STOP:
            self.drive.stop(now)
            self._plan(NOTHING, NEVER)
        elif self.event == ZONE:
            self._error(END, now)
        elif self.event == CHECK:
            self._check(now)
        elif self.breaking or (self.b & DONE and (self.word == 0 or self.a >> 3 & 1)):
            self._error(TIMING, now)
        elif self.event == BLOCK:
            self._number(now)
        elif self.a >> 3 & 7 in (READ, WRITE):
            self._next_word(now)
        else:
            self._next_of_all(now)

    def _number(self, now: int) -> None:
        """The number of a block was read."""
        if self.over:
            self._plan_zone(now)
            return
        self.buffer = self.block if not self.a & REVERSE else BLOCKS - 1 - self.block
        self.block += 1
        self._plan_at(BLOCK, NUMBER, now)
        self._ask(1, 0, now)

    def _check(self, now: int) -> None:
        """A block has passed with its checksums: compare or write the last one."""
        drive, back = self.drive, self.a & REVERSE
        block = BLOCKS - 1 - self.block if back else self.block
        sums = drive.read(block, WORDS)
        wrong = 0o77 ^ drive.sum(block) ^ sums >> 6 ^ sums & 0o77
        if self.a >> 3 & 7 == WRITE:
            drive.write(block, WORDS, sums ^ (wrong << 6 if back else wrong))
        elif wrong:
            self.b |= ERROR | PARITY
            self._flags()
        if self.over or not self.a & CONTINUOUS:
            self._done()
        self.block += 1
        self.word = 0
        self._plan_word(now)

    def _next_word(self, now: int) -> None:
        """The tape has come to the next word of a block."""
        reads = self.a >> 3 & 7 == READ
        if self.over and self.word == 0:
            self._plan_zone(now)
            return
        if self.over and reads:
            self._plan_check(now)
            return
        if reads:
            self.buffer = self._read(self.word)
        elif self.over:
            self._write(BESIDE + self.word, 0)
        self.word += 1
        if self.word == WORDS:
            self._plan_check(now)
        else:
            self._plan_word(now)
        if not self.over:
            self._ask(1 if reads else 0, 1, now)

    def _next_of_all(self, now: int) -> None:
        """The tape has come to the next four lines."""
        reads = self.a >> 3 & 7 == READ_ALL
        if self.over:
            self._plan_zone(now)
            return
        if reads:
            self.buffer = self._group()
        self.word += 1
        if self.word == GROUPS:
            self.block += 1
            self.word = 0
        self._plan_word(now)
        self._ask(1 if reads else 0, 1, now)

    def _ask(self, into_core: int, counts_address: int, now: int) -> None:
        """Raise BRK RQ; it has to be accepted before the event that is planned."""
        self.into_core, self.counts_address = into_core, counts_address
        self.asked, self.due, self.late = now, now, self.due

    def accepted(self, now: int) -> None:
        """BRK RQ falls."""
        self.due, self.late = self.late, NEVER

    def overflow(self, now: int) -> None:
        """WC has overflowed: this is the last word."""
        self.over = 1

    def give(self, now: int) -> int:
        """Return the number of the block or the word that was read."""
        if self.a >> 3 & 7 in (SEARCH, READ_ALL) and (self.over or not self.a & CONTINUOUS):
            self._done()
        return self.buffer

    def take(self, word: int, now: int) -> None:
        """Write a word that core has given."""
        if self.a >> 3 & 7 == WRITE:
            self._write(BESIDE + self.word - 1, word)
            return
        self._write(self.word - 1, word)
        if self.over or not self.a & CONTINUOUS:
            self._done()

    def _read(self, word: int) -> int:
        """Return a word of the block, as it is read in this direction."""
        if self.a & REVERSE:
            return turned(self.drive.read(BLOCKS - 1 - self.block, WORDS - 1 - word))
        return self.drive.read(self.block, word)

    def _write(self, group: int, value: int) -> None:
        """Write four lines, as far as they hold a word or a checksum."""
        block, word = self.block, group - BESIDE
        if self.a & REVERSE:
            block, word, value = BLOCKS - 1 - block, WORDS - 1 - word, turned(value)
        if 0 <= word < WORDS:
            self.drive.write(block, word, value)
        elif word in (-1, WORDS):
            sums = self.drive.read(block, WORDS)
            new = sums & 0o77 | (value & 0o77) << 6 if word < 0 else sums & 0o7700 | value >> 6
            self.drive.write(block, WORDS, new)

    def _group(self) -> int:
        """Return the next four lines, as they are read in this direction."""
        found, first = 0, BLOCK_LINES * self.block + FIRST + WORD * self.word
        for line in range(first, first + WORD):
            found = found << 3 | (
                7 ^ self._line(BLOCKS * BLOCK_LINES - 1 - line) if self.a & REVERSE else self._line(line)
            )
        return found

    def _line(self, at: int) -> int:
        """Return the three bits of a line, counted from block 0 on, as they are read forwards."""
        block, line = at // BLOCK_LINES, at % BLOCK_LINES
        word, part = (line - HEADER) // WORD, (line - HEADER) % WORD
        if at < 0 or block >= BLOCKS:
            return 0
        if 0 <= word < WORDS:
            return self.drive.read(block, word) >> 9 - 3 * part & 7
        if line < NUMBER:
            return block >> min(3 * (NUMBER - 1 - line), 12) & 7
        if line >= BLOCK_LINES - NUMBER:
            return 7 ^ block >> min(3 * (line - BLOCK_LINES + NUMBER), 12) & 7
        if HEADER - 2 <= line < CHECKED - 2:
            last = HEADER + 1 if line < HEADER else CHECKED - 3
            return self.drive.read(block, WORDS) >> 3 * (last - line) & 7
        return 0


class Door(Device):
    """Device 77 of the same control."""

    CODE = 0o77
    fields = saved(flag=BIT, tested=BIT)

    def __init__(self, control: TC08) -> None:
        super().__init__()
        self.enabled = 0
        self.control = control

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """Pass the pulse on to the control, at tick `now`."""
        if self.control.due <= now:
            self.control.advance(now)
        return self.control.pulse_b(iop, ac)

    def advance(self, now: int) -> None:
        """Nothing happens here by itself."""

    def initialize(self, now: int) -> None:
        """The control clears the flag."""


def _first(at: int, before: int, lines: int = BLOCK_LINES) -> int:
    """Return the first block, or unit of so many `lines`, of which line `before` comes after place `at`."""
    return max(-((END_ZONE * LINE - at + before * LINE) // (lines * LINE)), 0)
