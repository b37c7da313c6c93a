"""The ASR-33 Teletype and its two interfaces: keyboard and reader (03), printer and punch (04).

      tape ─► reader ─┐                                        ┌─► printer ─► page
                      ├─ line, 110 baud ─► M706     M707 ─ line ┤
       keys ► keyboard┘   READER RUN ◄───  (03)     (04)       └─► punch ─► tape

A character on the line is 11 units: a start unit (space), 8 data units, channel 1 first, 2 stop units (mark).

    unit   0     0.5          1.5 ... 8.5                  9.0      10.5   11.0
    03     start flag falls   bits shift in, flag at 8.5                   the next start at the earliest
    04     start              (1.0: a raised flag falls)   flag             the next start at the earliest

Receiver: its buffer is the shift register itself, so a character must be read before the next start unit.
READER RUN is set by the second pulse (KCC, KRB) and by INITIALIZE, and cleared only by a start unit: a KCC
between two characters loses nothing, and the reader never goes faster than 10 a second.

Transmitter: loading it while it is busy ors into what is left of the character and puts a new end marker
behind it, which makes one longer, garbled character.

By convention: a transmission from idle starts with the pulse itself (the 220 Hz clock of the real one runs
free, 0 to 4.5 ms of delay); the reader starts as soon as READER RUN lets it, but a start unit between the
pulses of the IOT that set READER RUN is not in the buffer before that IOT is over (a real receiver sees it up
to 1/8 unit later), so that KRB reads its character however late it comes; a key pressed while the line is
busy waits for it; the printer takes a space after its eighth data unit for a new start unit, and finishes
with marks what a line that fell silent has begun. INITIALIZE silences the transmitter so, and the receiver
drops what it has half received.

Not emulated: LOCAL, BREAK, answer-back, the reader's trip latency; a START key pressed in the middle of an
incoming character makes a real receiver take one of its later spaces for a start unit.

Sources: DEC M706 and M707 module schematics; Small Computer Handbook 1970 (Teletype control); PDP-8/I
instruction card.
"""

from collections.abc import Callable

from pdp8.computer.hardware.bus import AT_ONCE, CLEAR_AC, NEVER, SKIP, Bus, Device
from pdp8.computer.hardware.fields import BIT, COUNT, FRAMES, PART, TICK, saved

# A unit of the line is 1/110 s, 181 818.18 ticks of 0.05 us.
FRAME = 2_000_000

_MARKER = 0o400


def half_units(count: int) -> int:
    """Return the ticks of `count` half units of the line, to the nearest tick: 17 are 1 545 455, 18 are 1 636
    364.
    """
    return (count * (FRAME // 2) + 5) // 11


IOP2_TO_IOP4 = 18
START_CHECKED = half_units(1)
RECEIVED = half_units(17)

# Compiled, these are C numbers (teletype.pxd); importers find them here.
globals().update(FRAME=FRAME, START_CHECKED=START_CHECKED, RECEIVED=RECEIVED, IOP2_TO_IOP4=IOP2_TO_IOP4)


class Reader:
    """The tape reader: a tape, where it stands under the head, and the lever."""

    fields = saved(tape=FRAMES, position=COUNT, loaded=BIT, on=BIT)

    def __init__(self, device: Device) -> None:
        self.device = device
        self.tape = b""
        self.position = 0
        """Frames read so far of this tape; the next one is tape[position]."""
        self.loaded = False
        self.on = True
        """The lever: START, else STOP."""
        self.more: Callable[[], bytes] | None = None
        """Where the frames of a tape come from that is still being made; none at its end."""

    def load(self, frames: bytes) -> None:
        """Put a tape of `frames` in, its first frame under the head."""
        self.tape = bytes(frames)
        self.more = None
        self.position = 0
        self.loaded = True
        self.device.look()

    def remove(self) -> None:
        """Take the tape out."""
        self.load(b"")
        self.loaded = False

    def lever(self, on: bool) -> None:
        """Put the lever to START or STOP."""
        self.on = on
        self.device.look()

    def ready(self) -> bool:
        """Tell whether there is a frame under the head and the lever is at START."""
        if self.more is not None and self.on and self.position >= len(self.tape):
            self.take_more()
        return self.on and self.position < len(self.tape)

    def take_more(self) -> None:
        """Wait for further frames of a tape that is still being made."""
        frames = self.more() if self.more is not None else b""
        self.tape += frames
        if not frames:
            self.more = None

    def empty(self) -> bool:
        """Tell whether a tape was loaded, with the lever at START, and has run out."""
        return self.loaded and self.on and self.more is None and self.position >= len(self.tape)


class Keyboard:
    """The keyboard: the keys pressed that are not yet on the line."""

    fields = saved(waiting=FRAMES)

    def __init__(self, device: Device) -> None:
        self.device = device
        self.waiting = bytearray()

    def press(self, frames: bytes) -> None:
        """Press the keys that send `frames`, one after another; a Model 33 sets channel 8 (A is 0o301)."""
        self.waiting += frames
        self.device.look()


class Receiver(Device):
    """M706, device 03: takes characters off the line that the reader and the keyboard share."""

    fields = saved(
        **dict.fromkeys(("flag", "reader_run"), BIT),
        **dict.fromkeys(("buffer", "frame"), "377"),
        **dict.fromkeys(("due", "step", "now", "start", "free", "requested"), TICK),
        stage=2,
        reader=PART,
        keyboard=PART,
    )

    def __init__(self) -> None:
        super().__init__()
        self.reader = Reader(self)
        self.keyboard = Keyboard(self)
        self.now = 0
        self.reader_run = 1
        self.buffer = 0
        """The last character; while the next comes in see `shifted`."""
        self.frame = 0
        """The character on the line."""
        self.start = 0
        """The tick at which its start unit began."""
        self.stage = 0
        """What the receiver has noticed of it: 0 idle, 1 its start unit, 2 that it is no false start."""
        self.free = 0
        """The tick from which the line is free."""
        self.requested = NEVER
        """The tick of the last pulse that set READER RUN."""
        self.step = NEVER
        """The tick of the next thing that happens here; `due` is the next that changes the flag."""

    def look(self) -> None:
        """Look whether something waits for the idle line."""
        if self.stage == 0:
            self.step = self.due = AT_ONCE

    def restored(self) -> None:
        """Set what happens next."""
        self.plan()

    def plan(self) -> None:
        """Set `step` to the next thing that happens here, and `due` to the next that changes the flag."""
        if self.stage == 2:
            self.step = self.due = self.start + RECEIVED
            return
        start = self.start
        if self.stage == 1:
            self.step = start + START_CHECKED
        elif self.keyboard.waiting or (self.reader_run and self.reader.ready()):
            self.step = start = self.free if self.free > self.now else self.now
        else:
            self.step = self.due = NEVER
            return
        self.due = start + (START_CHECKED if self.flag else RECEIVED)

    def advance(self, now: int) -> None:
        """Let the line and the reader run up to tick `now`."""
        if self.step == AT_ONCE:
            self.now = now
            self.plan()
        while self.step <= now:
            self.now = self.step
            if self.stage == 0:
                self.begin()
            elif self.stage == 1:
                self.flag = 0
                self.stage = 2
            else:
                self.flag = 1
                self.buffer = self.frame
                self.stage = 0
            self.plan()
        self.now = now

    def begin(self) -> None:
        """See the start unit of the next character."""
        if self.keyboard.waiting:
            self.frame = self.keyboard.waiting.pop(0)
        elif self.reader.ready():
            self.frame = self.reader.tape[self.reader.position]
            self.reader.position += 1
        self.reader_run = 0
        self.start = self.now
        self.free = self.now + FRAME
        self.stage = 1

    def shifted(self, now: int) -> int:
        """Return the buffer as it reads at tick `now`: 377 shifted down, the character coming in above."""
        if self.stage == 0 or (self.start >= self.requested and now - self.requested <= IOP2_TO_IOP4):
            return self.buffer
        bits = 0
        while bits < 8 and now >= self.start + half_units(2 * bits + 3):
            bits += 1
        return (self.frame << 8 - bits | 0o377 >> bits) & 0o377

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """KSF at IOP1; clear AC and flag, set READER RUN at IOP2; the buffer into AC 4-11 at IOP4."""
        if iop == 1:
            return SKIP if self.flag else 0
        self.advance(now)
        if iop == 2:
            self.flag = 0
            self.reader_run = 1
            self.requested = now
            self.plan()
            return CLEAR_AC
        return self.shifted(now)

    def initialize(self, now: int) -> None:
        """Clear the flag, drop a character half received, set READER RUN."""
        if self.step != AT_ONCE:
            self.advance(now - 1)  # a character that would begin now has not begun
        self.buffer = self.shifted(now)
        self.stage = self.flag = 0
        self.reader_run = 1
        self.now = now
        self.plan()

    def out_of_tape(self) -> bool:
        """Tell whether READER RUN is set and the tape has run out."""
        return self.reader_run == 1 and self.reader.empty()


_ACTED_ON = bytes((0o007, 0o012, 0o015, *range(0o040, 0o175)))
_PASSED_OVER = bytes(frame for frame in range(0o400) if frame & 0o177 not in _ACTED_ON)
_TYPES = bytes(code - 0o40 if code >= 0o140 else code for code in range(0o200)) * 2


def printed(frames: bytes) -> bytes:
    """Return what a Model 33 acts on of the frames: 64 characters, BELL, line feed and return; no other code
    does anything. Channel 8 is not looked at, and lower case is printed as upper case.
    """
    return frames.translate(_TYPES, _PASSED_OVER)


class Printer:
    """The printer: every frame it was sent, and `on_frame`, called with each as it is printed."""

    fields = saved(frames=FRAMES)

    def __init__(self) -> None:
        self.frames = bytearray()
        self.on_frame: Callable[[int], object] | None = None

    def take(self, frame: int) -> None:
        """Print one frame."""
        self.frames.append(frame)
        if self.on_frame is not None:
            self.on_frame(frame)


class Punch:
    """The tape punch: while it is `on` it punches all 8 channels of every frame it is sent."""

    fields = saved(frames=FRAMES, on=BIT)

    def __init__(self) -> None:
        self.frames = bytearray()
        self.on = True
        self.on_frame: Callable[[int], object] | None = None
        """Called with each frame as it is punched."""

    @property
    def tape(self) -> bytes:
        """The tape punched so far."""
        return bytes(self.frames)

    def take(self, frame: int) -> None:
        """Punch one frame, if the punch is on."""
        if self.on:
            self.frames.append(frame)
            if self.on_frame is not None:
                self.on_frame(frame)


class Transmitter(Device):
    """M707, device 04: puts characters on the line, where the printer's selector takes them off."""

    fields = saved(
        **dict.fromkeys(("flag", "printed"), BIT),
        **dict.fromkeys(("due", "start", "free"), TICK),
        register="777",
        selected="377",
        shifts=1 << 30,
        unit=8,
        printer=PART,
        punch=PART,
    )

    def __init__(self) -> None:
        super().__init__()
        self.printer = Printer()
        self.punch = Punch()
        self.register = 0
        """What is still to be sent, the next unit lowest, the end marker highest; 0 when idle."""
        self.start = 0
        """The tick at which the start unit begins."""
        self.shifts = 0
        """How many units have followed it."""
        self.free = 0
        """The tick from which the line is free."""
        self.unit = 0
        """The data unit the selector takes next, 1 to 8; 0 while it waits for a start unit."""
        self.selected = 0
        """The data units it has taken."""
        self.printed = 0
        """Set while the register sends what the printer was let finish ahead of its time."""

    def restored(self) -> None:
        """Set what happens next."""
        self.plan()

    def plan(self) -> None:
        """Set `due` to the next event: a raised flag falls at the first shift and rises at the last."""
        if self.register == 0:
            self.due = NEVER
        elif self.flag:
            self.due = self.start + half_units(2)
        else:
            self.due = self.start + half_units(2 * (self.shifts + self.left()))

    def left(self) -> int:
        """Return how many units are still to be sent, the end marker too."""
        units = 9
        while not self.register >> units - 1:
            units -= 1
        return units

    def advance(self, now: int) -> None:
        """Let the line run up to tick `now`."""
        while self.register and self.start + half_units(2 * self.shifts + 2) <= now:
            mark = self.register & 1
            self.register >>= 1
            self.shifts += 1
            self.flag = 0
            if not self.printed:
                self.select(mark)
            if self.register == 0:
                self.end()
        self.plan()

    def end(self) -> None:
        """Raise the flag as the end marker goes out, the first of two stop units at least."""
        self.flag = 1
        self.free = self.start + half_units(2 * self.shifts + 4)
        self.printed = 0
        self.stop()

    def stop(self) -> None:
        """Let the selector finish its frame with marks."""
        while self.unit:
            self.select(1)

    def finish(self) -> None:
        """Let the printer finish what is on the line, as it does while a processor stands still; the flag
        keeps its time.
        """
        rest = 0 if self.printed else self.register
        while rest:
            self.select(rest & 1)
            rest >>= 1
        self.stop()
        self.printed = 1 if self.register else 0

    def select(self, mark: int) -> None:
        """Let the printer's selector take one unit off the line; after the eighth, printer and punch have a
        frame.
        """
        if self.unit:
            self.selected |= mark << self.unit - 1
            self.unit += 1
            if self.unit == 9:
                self.unit = 0
                try:
                    self.printer.take(self.selected)
                finally:
                    self.punch.take(self.selected)
        elif not mark:
            self.selected = 0
            self.unit = 1

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """TSF at IOP1; clear the flag at IOP2; load and send AC 4-11 at IOP4."""
        if iop == 1:
            return SKIP if self.flag else 0
        self.advance(now)
        if iop == 2:
            self.flag = 0
        else:
            self.load(ac & 0o377, now)
        self.plan()
        return 0

    def load(self, character: int, now: int) -> None:
        """Or `character` and an end marker into the shift register; if that was empty begin a start unit."""
        if self.register == 0:
            self.start = self.free if self.free > now else now
            self.shifts = 0
        if self.register == 0 or self.printed:
            self.printed = 0
            self.select(0)
        self.register |= _MARKER | character

    def initialize(self, now: int) -> None:
        """Clear the flag and the shift register: the line goes to mark, and what is begun ends in marks."""
        self.advance(now)
        self.advance(now)
        self.register = self.flag = 0
        self.free = now
        if self.start > now:
            self.unit = 0
        self.stop()
        self.printed = 0
        self.plan()


class Teletype:
    """The whole ASR-33, on line, its punch on and its reader's lever at START."""

    def __init__(self) -> None:
        self.receiver = Receiver()
        self.transmitter = Transmitter()
        self.reader = self.receiver.reader
        self.keyboard = self.receiver.keyboard
        self.printer = self.transmitter.printer
        self.punch = self.transmitter.punch

    def connect(self, bus: Bus) -> None:
        """Connect both interfaces to the bus, under the console's codes."""
        bus.fit(0o04, self.transmitter)
        bus.fit(0o03, self.receiver)
