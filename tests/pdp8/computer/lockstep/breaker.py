"""A device that asks for data breaks of every kind, as tests/reference/breaks.c describes it."""

from pdp8.computer.hardware.bus import BreakDevice
from pdp8.computer.hardware.fields import BIT, TICK, saved
from pdp8.computer.hardware.signals import NEVER, SKIP


class Breaker(BreakDevice):
    """That under code 70; its word count is at 0030."""

    CODE = 0o70
    fields = saved(
        **dict.fromkeys(("flag", "tested", "breaking", "three_cycle", "into_core"), BIT),
        **dict.fromkeys(("counts_address", "increments"), BIT),
        **dict.fromkeys(("due", "asked"), TICK),
        **dict.fromkeys(("address", "word"), "7777"),
        field="70000",
        period=11 + 37 * 63,
        left=20,
    )

    def __init__(self) -> None:
        super().__init__()
        self.three_cycle = self.counts_address = 0
        self.period = 0
        self.word = 0
        self.left = 0

    def pulse(self, iop: int, ac: int, now: int) -> int:
        if iop == 1:
            return SKIP if self.flag else 0
        if iop == 2:
            self.flag = 0
            return 0
        self.three_cycle = ac >> 11 & 1
        self.into_core = ac >> 10 & 1
        self.increments = ac >> 9 & 1
        self.counts_address = ac >> 8 & 1
        self.field = (ac & 0o300) << 6
        self.period = 11 + 37 * (ac & 0o77)
        self.left = 20
        self.asked = NEVER
        self.due = now + self.period
        return 0

    def advance(self, now: int) -> None:
        if self.due <= now and self.asked == NEVER:
            self.asked = self.due

    def first(self) -> int:
        """Return where the word count is."""
        return 0o30

    def accepted(self, now: int) -> None:
        self.address = self.first() if self.three_cycle else self.word
        self.due += self.period
        if not self.three_cycle:
            self.left -= 1
            if self.left == 0:
                self.due = NEVER
                self.flag = 1

    def overflow(self, now: int) -> None:
        self.flag = 1
        self.due = self.asked = NEVER

    def give(self, now: int) -> int:
        self.word = self.word * 5 + 1 & 0o7777
        return self.word

    def take(self, word: int, now: int) -> None:
        self.word ^= word

    def initialize(self, now: int) -> None:
        self.flag = self.breaking = 0
        self.due = self.asked = NEVER


class Nearer(Breaker):
    """That under code 71, nearer on the cable; its word count is at 0032."""

    CODE = 0o71

    def first(self) -> int:
        return 0o32
