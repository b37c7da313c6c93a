"""A second DF32 with the few instructions that drive it, from the table of its IOTs and SIMH's pdp8_df.c.

It shares nothing with the package. The order of words on a track is a table; time is in ticks of 0.05 µs.
"""

DISC, LOCKED = 0o100000, 0o40000
PLACE, CYCLE, IOT = 330, 32, 85
WORD, TURN = 4 * PLACE, 2048 * PLACE
PULSES = {1: CYCLE - 3, 2: CYCLE + 15, 4: CYCLE + 33}
PLACES = {place // 4 + 512 * (place % 4): place for place in range(2048)}
WC, CA = 0o7750, 0o7751


def passes(address: int, after: int) -> int:
    """Return the first tick behind `after` at which a word is under its head."""
    tick = PLACES[address % 2048] * PLACE
    return tick + (after - tick) // TURN * TURN + TURN


class Model:
    """A machine: core, AC, PC, tick, and the disc's registers."""

    def __init__(self, core: list[int], words: list[int], locks: int, tick: int, pc: int) -> None:
        self.core, self.words, self.locks, self.tick, self.pc = core, words, locks, tick, pc
        self.ac = self.address = self.extension = self.field = self.errors = self.done = 0
        self.way = ""
        """"read", "write", or "" while nothing is transferred."""
        self.comes: int | None = None
        """When the word is under its head, or is asked for if it is to be written."""
        self.asked: int | None = None
        self.breaks: list[int] = []
        """The ticks at which breaks began."""
        self.head = 0
        """The word that was read last."""
        self.skip = False
        """The flip-flop SKIP, which an IOT's pulses set."""
        self.seen = -1
        """TP1 of the last cycle."""

    def disc(self, now: int) -> None:
        """Let the disc turn up to tick `now`."""
        if self.comes is not None and self.comes <= now:
            at, tick, self.comes = self.extension << 12 | self.address, self.comes, None
            if at >= len(self.words) or (self.way == "write" and self.locks >> at // LOCKED & 1):
                self.errors |= 2
                self._finish()
            else:
                self.asked, self.head = tick, self.words[at]
        if self.asked is not None and now >= self.asked + WORD:
            self.errors |= 4
            self._finish()

    def _finish(self) -> None:
        self.way, self.comes, self.asked, self.done = "", None, None, 1

    def _seek(self, now: int) -> None:
        at = self.extension << 12 | self.address
        self.comes = passes(at, now) if self.way == "read" else passes(at, now + WORD) - WORD

    def step(self) -> None:
        """Do the breaks that are due, and an instruction behind them."""
        seen = self.seen
        while True:
            self.disc(seen)
            if self.asked is None or self.asked > seen:
                break
            self._steal()
            seen = self.tick - CYCLE + 10
        began, word = self.tick, self.core[self.pc]
        self.pc = self.pc + 1 & 0o7777
        self.seen = began + 10
        if word >> 9 == 6:
            self.tick, self.skip = self.tick + IOT, False
            for pulse in (1, 2, 4):
                if word & pulse:
                    now = began + PULSES[pulse]
                    self.disc(now)
                    self._pulse(word, pulse, now)
            self.pc += self.skip
        elif word >> 9 == 1:
            self.ac = self.ac + self.core[word & 0o177] & 0o7777
            self.tick += 2 * CYCLE
            self.seen = began + CYCLE + 10
        else:
            self.tick += CYCLE
            if word >> 9 == 5:
                self.pc = self.pc - 1 & 0o7600 | word & 0o177
            else:
                assert word == 0o7200
                self.ac = 0

    def _steal(self) -> None:
        self.breaks.append(self.tick)
        self.asked = None
        self.core[WC] = self.core[WC] + 1 & 0o7777
        self.core[CA] = self.core[CA] + 1 & 0o7777
        at, place = self.extension << 12 | self.address, (self.field & 1) << 12 | self.core[CA]
        last, wrote = self.core[WC] == 0, self.way == "write"
        if not wrote:
            self.core[place] = self.head
        elif at < len(self.words):
            self.words[at] = self.core[place]
        self.tick += 3 * CYCLE
        if not (last and wrote):
            at = (at + 1) % (4 * DISC)
            self.extension, self.address = at >> 12, at & 0o7777
        if last:
            self._finish()
        else:
            self._seek(self.tick)

    def _pulse(self, word: int, pulse: int, now: int) -> None:
        match (word >> 3 & 0o77, pulse):
            case (0o60, 1):
                self.address = self.errors = self.done = 0
                self.way, self.comes, self.asked = "", None, None
            case (0o60, _):
                self.address |= self.ac
                self.ac = self.done = 0
                self.way, self.asked = "read" if pulse == 2 else "write", None
                self._seek(now)
            case (0o61, 1):
                self.extension = self.field = 0
            case (0o61, 2):
                at = self.extension << 12 | self.address
                if word & 4:
                    self.ac = 0
                else:
                    self.skip |= passes(at, now - PLACE) <= now
            case (0o61, 4) if word & 2:
                photocell = 0o4000 if -now % TURN <= 6 * WORD else 0
                missing = 2 if self.extension >> 3 >= len(self.words) // DISC else 0
                self.ac |= photocell | self.extension << 6 | self.field << 3 | missing | self.errors
            case (0o61, 4):
                self.extension |= self.ac >> 6 & 0o37
                self.field |= self.ac >> 3 & 7
            case (0o62, 1):
                self.skip |= not self.errors
            case (0o62, 2) if word & 4:
                self.ac = 0
            case (0o62, 2):
                self.skip |= bool(self.done)
            case (0o62, 4):
                self.ac |= self.address
