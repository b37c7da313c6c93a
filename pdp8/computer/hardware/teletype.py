"""The ASR-33 Teletype and its two interfaces: keyboard and reader (03), printer and punch (04).

      tape ─► reader ─┐                                        ┌─► printer ─► page
                      ├─ line, 110 baud ─► M706     M707 ─ line ┤
       keys ► keyboard┘   READER RUN ◄───  (03)     (04)       └─► punch ─► tape

A character on the line is 11 units: a start unit (space), 8 data units, channel 1 first, 2 stop units (mark).

    unit   0     1/8     0.5       1.5 ... 8.5           9.0    10.5         11.0
    03     start PRESET  shift 1   shifts 2 to 9: flag          looks again
    04     start         (1.0: a raised flag falls)      flag                the next start at the earliest

Receiver: its buffer is the shift register itself. PRESET sets it to 377 and clears READER RUN; then the start
unit is shifted in like the data units, and the flag is the complement of what is shifted out: it falls at the
first shift and rises at the ninth, when the start unit comes out. A first shift that finds the line at mark
was a false start. READER RUN is set by IOP2 (KCC, KRB) and by INITIALIZE: a KCC between two characters loses
nothing, and the reader never goes faster than 10 a second. INITIALIZE in the middle of a character leaves the
receiver free: it takes a later space of the same character for a start unit.

Transmitter: loading it while it is busy ors into what is left of the character and puts a new end marker
behind it, which makes one longer, garbled character. INITIALIZE puts the line to mark; once the first half
unit is over, the next start unit waits for the fourth edge of the clock.

The printer's selector takes each data unit in its middle, and nine units after its start it takes a space for
the next start unit.

By convention, because their clocks run free: the receiver's clock (880 Hz) beats an eighth of a unit after
the start unit begins, so that start check and flag come at the late end of what a real one does (0 to 1/8
unit earlier); a start unit that begins before the receiver looks again is seen by the clock as it was. Its
pulse takes no time, where a real one is two ticks wide (0.1 us). INITIALIZE in the tick in which a start unit
begins leaves the character whole: the first pulse that sees the unit comes later. A transmission from idle
starts with the pulse itself (220 Hz, 0 to 1/2 unit later). The reader starts as soon as READER RUN lets it; a
key pressed while the line is busy waits for it.

Not emulated: LOCAL, BREAK, answer-back, the reader's trip latency.

Sources: DEC M706 and M707 module schematics; Small Computer Handbook 1970 (Teletype control); PDP-8/I
instruction card.
"""

from collections.abc import Callable

from pdp8.computer.hardware.bus import Bus, Device
from pdp8.computer.hardware.fields import BIT, COUNT, FRAMES, PART, TICK, saved
from pdp8.computer.hardware.signals import AT_ONCE, CLEAR_AC, FRAME, NEVER, SKIP

PARTS = 11
"""Parts of a tick. A unit of the line, 1/110 s, is 2,000,000 of them: times on it are whole."""
HALF_UNIT = 1_000_000
"""Parts of a tick that half a unit takes."""
EIGHTH = HALF_UNIT // 4
"""Parts of a tick from one pulse of the receiver's clock to the next."""

_STOP_UNITS = 0o3000
_MARKS = 0o777 << 11
"""The marks that the line shows after a character, for as many units as are shifted in."""
_MARKER = 0o400

# The receiver's clock, in pulses: eight a unit.
UNIT = 8
PULSES = 11 * UNIT
"""Pulses of the receiver's clock in a frame."""
FIRST_SHIFT = 3
"""From ACTIVE to the first shift; eight more follow, a unit apart."""
NINTH_SHIFT = FIRST_SHIFT + 8 * UNIT
LOOKS_AGAIN = FIRST_SHIFT + 10 * UNIT + 1
"""From ACTIVE to the first pulse that can begin the next character: STOP 2 comes one before it."""


def tick_of(time: int) -> int:
    """Return the first tick that is not before `time`, which is in parts of a tick."""
    return (time + PARTS - 1) // PARTS


def half_units(count: int) -> int:
    """Return the ticks that `count` half units of the line take: 17 take 1 545 455, 18 take 1 636 364."""
    return tick_of(HALF_UNIT * count)


def eighths(count: int) -> int:
    """Return the ticks that `count` eighths of a unit of the line take."""
    return tick_of(EIGHTH * count)


_NINE_UNITS = half_units(18)
_FALLS, _RISES = eighths(1 + FIRST_SHIFT), eighths(1 + NINTH_SHIFT)
"""Ticks from a start unit that sets the clock until the flag falls, and until it rises."""


class Reader:
    """The tape reader: a tape, which frame is under the head, and the lever."""

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
        """Gives further frames of a tape that is still being made; none at its end."""

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
        **dict.fromkeys(("flag", "tested", "reader_run", "active"), BIT),
        **dict.fromkeys(("due", "step", "edge", "now", "start", "free", "origin"), TICK),
        buffer="377",
        line="3777",
        pulses=0o377,
        shifts=9,
        lost=COUNT,
        lost_at=TICK,
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
        """The shift register, BIT 1 lowest."""
        self.line = 0o3777
        """The units of the character on the line, the start unit lowest."""
        self.start = 0
        """The tick at which its start unit began."""
        self.free = 0
        """The tick from which the line is free."""
        self.active = 0
        """Set from PRESET to the ninth shift."""
        self.shifts = 0
        """How many shifts there were since PRESET."""
        self.origin = 0
        """The tick from which the pulses of the clock are counted."""
        self.pulses = 0
        """The pulse that set ACTIVE; while ACTIVE is clear, the first pulse that may find a start unit."""
        self.edge = NEVER
        """The tick at which the next character begins on the line."""
        self.step = NEVER
        """The tick of the next thing that happens here; `due` is the next that changes the flag."""
        self.lost = 0
        """How many characters came in over one that was not read since START, the first at `lost_at`."""
        self.lost_at = 0

    def look(self) -> None:
        """Note that a key, tape or lever has changed; `advance` looks whether the line has to begin."""
        if self.step == self.edge:
            self.step = NEVER
        self.edge = NEVER
        self.due = AT_ONCE

    def restored(self) -> None:
        """Set what happens next."""
        self.plan()

    def plan(self) -> None:
        """Set `step` to the next event here and `due` to the next that changes the flag."""
        self.edge = NEVER
        if self.active:
            ninth = self.tick(self.pulses + NINTH_SHIFT)
            if self.free <= ninth:
                self.edge = self.next_edge()
            self.step = self.due = ninth if self.shifts else self.tick(self.pulses + FIRST_SHIFT)
            if not self.flag:
                self.due = ninth
        elif (pulse := self.start_seen()) >= 0:
            self.step = self.tick(pulse)
            self.due = self.tick(pulse + (FIRST_SHIFT if self.flag else NINTH_SHIFT))
        else:
            self.edge = self.step = self.due = self.next_edge()
            if self.edge != NEVER:
                self.due += _FALLS if self.flag else _RISES
        self.step = min(self.step, self.edge)

    def next_edge(self) -> int:
        """Return the tick at which the reader or the keyboard begins a character, NEVER if neither will."""
        if self.keyboard.waiting or (self.reader_run and self.reader.ready()):
            return self.free if self.free > self.now else self.now
        return NEVER

    def tick(self, pulse: int) -> int:
        """Return the tick of a pulse of the clock."""
        return self.origin + eighths(pulse)

    def beaten(self, pulse: int, now: int) -> bool:
        """Tell whether a pulse of the clock has come by tick `now`."""
        return EIGHTH * pulse <= PARTS * (now - self.origin)

    def pulse_after(self, now: int) -> int:
        """Return the first pulse of the clock after tick `now`."""
        since = now - self.origin
        return since // FRAME * PULSES + PARTS * (since % FRAME) // EIGHTH + 1

    def start_seen(self) -> int:
        """Return the pulse that will take a space of this character for a start unit, -1 if none will."""
        last = self.start + _NINE_UNITS
        if not self.beaten(self.pulses, last):
            return -1
        pulse = self.pulse_after(self.start) if self.beaten(self.pulses, self.start) else self.pulses
        while self.beaten(pulse, last):
            if not self.units(pulse) & 1:
                return pulse
            pulse += 1
        return -1

    def units(self, pulse: int) -> int:
        """Return the line's units as bits, that which `pulse` sees the lowest; mark follows the last."""
        since = PARTS * (self.origin - self.start) + EIGHTH * pulse
        return (self.line | _MARKS) >> min(max(since - 1, 0) // (2 * HALF_UNIT), 11)

    def advance(self, now: int) -> None:
        """Let the line and the reader run up to tick `now`."""
        looks = self.due == AT_ONCE
        while self.step <= now:
            self.now = self.step
            if self.step == self.edge:
                self.sample(self.now)
                self.begin()
            elif self.active:
                self.shift(9 if self.shifts else 1)
            else:
                self.preset()
            self.plan()
        self.now = now
        if looks:
            self.plan()
            self.advance(now)
        elif self.active:
            self.sample(now)

    def begin(self) -> None:
        """Begin the next character's start unit; the clock restarts if no character is being received."""
        if self.keyboard.waiting:
            self.line = self.keyboard.waiting.pop(0)
        else:
            self.line = self.reader.tape[self.reader.position]
            self.reader.position += 1
        self.line = self.line << 1 | _STOP_UNITS
        self.start = self.now
        self.free = self.now + FRAME
        if not self.active and self.beaten(self.pulses - 1, self.now):
            self.origin = self.now
            self.pulses = 1

    def preset(self) -> None:
        """Set ACTIVE: the clock has seen a start unit."""
        self.pulses = self.start_seen()
        self.active = 1
        self.shifts = 0
        self.buffer = 0o377
        self.reader_run = 0

    def sample(self, now: int) -> None:
        """Shift in what the line showed at each shift up to tick `now`."""
        first = self.pulses + FIRST_SHIFT
        self.shift((PARTS * (now - self.origin) // EIGHTH - first + UNIT) // UNIT)

    def shift(self, shifts: int) -> None:
        """Shift in the line's units until there were `count` shifts since PRESET, 9 at most."""
        count = shifts - self.shifts
        if self.active and count > 0:
            first = self.pulses + FIRST_SHIFT
            units = self.units(first + UNIT * self.shifts) << 8 | self.buffer
            if self.flag:
                self.lost += 1
                self.lost_at = self.lost_at or self.tick(first)
            self.flag = ~units >> count - 1 & 1
            self.buffer = units >> count & 0o377
            self.shifts = shifts
            if self.flag:
                self.stop(self.pulses + LOOKS_AGAIN)
            elif shifts == 1 and self.buffer & 0o200:
                self.stop(first + 1)

    def stop(self, pulse: int) -> None:
        """Clear ACTIVE; from `pulse` on a space is a start unit."""
        self.active = 0
        self.pulses = pulse
        while self.pulses >= PULSES:
            self.pulses -= PULSES
            self.origin += FRAME

    def pulse(self, iop: int, ac: int, now: int) -> int:
        """KSF at IOP1; clear AC and flag, set READER RUN at IOP2; the buffer into AC 4-11 at IOP4."""
        if iop == 1:
            return SKIP if self.flag else 0
        self.advance(now)
        if iop == 4:
            return self.buffer
        self.flag = 0
        self.reader_run = 1
        self.plan()
        return CLEAR_AC

    def initialize(self, now: int) -> None:
        """Clear the flag and ACTIVE, set READER RUN."""
        if self.now < now:  # else what begins now begins as time goes on
            self.advance(now)
        self.flag = self.lost = self.lost_at = 0
        self.reader_run = 1
        if self.active:
            self.stop(self.pulse_after(now))
        self.plan()

    def out_of_tape(self) -> bool:
        """Tell whether READER RUN is set and the tape has run out."""
        return self.reader_run == 1 and self.reader.empty()


_ACTED_ON = bytes((0o007, 0o012, 0o015, *range(0o040, 0o175)))
PASSED_OVER = bytes(frame for frame in range(0o400) if frame & 0o177 not in _ACTED_ON)
"""The frames that do nothing in a printer."""
TYPES = bytes(code - 0o40 if code >= 0o140 else code for code in range(0o200)) * 2
"""The code that each frame types that is not passed over."""


def printed(frames: bytes) -> bytes:
    """What a Model 33 acts on: its 64 characters, in capitals, BELL, LF and CR; channel 8 is ignored."""
    return frames.translate(TYPES, PASSED_OVER)


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
        **dict.fromkeys(("flag", "tested", "mark"), BIT),
        **dict.fromkeys(("start", "free", "began", "lost"), COUNT),
        **dict.fromkeys(("sent", "ahead"), 1 << 30),
        **dict.fromkeys(("due", "lost_at"), TICK),
        register="777",
        selected="377",
        unit=9,
        printer=PART,
        punch=PART,
    )

    def __init__(self) -> None:
        super().__init__()
        self.printer = Printer()
        self.punch = Punch()
        self.register = 0
        """What is still to be sent, the next unit lowest, the end marker highest; 0 when idle."""
        self.mark = 1
        """What the line shows: 1 for mark, 0 for space."""
        self.start = 0
        """When the start unit begins, in parts of a tick."""
        self.sent = 0
        """How many units have begun, the start unit among them."""
        self.free = 0
        """From when on the line is free, in parts of a tick."""
        self.unit = 0
        """The data unit the selector takes next, 1 to 8; 9 until it stops, then 0 until a start unit."""
        self.began = 0
        """When the selector's start unit began, in parts of a tick."""
        self.selected = 0
        """The data units that the selector has taken."""
        self.ahead = 0
        """How many of the next frames the printer has finished already, beside a halted processor."""
        self.lost = 0
        """How many characters were loaded over another since START, the first at `lost_at`."""
        self.lost_at = 0

    def restored(self) -> None:
        """Set what happens next."""
        self.plan()

    def plan(self) -> None:
        """Set `due` to the next event: a raised flag falls at the first shift and rises at the last."""
        if self.register == 0:
            self.due = NEVER
            if self.unit in (0, 9):
                self.ahead = 0
        elif self.flag:
            self.due = tick_of(self.start + 2 * HALF_UNIT)
        else:
            self.due = tick_of(self.start + 2 * HALF_UNIT * (max(self.sent, 1) - 1 + self.units_to_send()))

    def units_to_send(self) -> int:
        """Return how many units are still to be sent, including the end marker."""
        units = 1
        while self.register >> units:
            units += 1
        return units

    def next_unit(self) -> int:
        """Return when the next unit goes out, in parts of a tick, NEVER if there is none."""
        return self.start + 2 * HALF_UNIT * self.sent if self.register else NEVER

    def next_step(self) -> int:
        """Return when the line or the selector does something next, in parts of a tick, or NEVER."""
        unit = self.next_unit()
        return min(unit, self.began + HALF_UNIT * min(2 * self.unit + 1, 18)) if self.unit else unit

    def advance(self, now: int) -> None:
        """Let the line and the selector run up to tick `now`."""
        while (time := self.next_step()) <= PARTS * now:
            if self.step(time):
                if self.ahead:
                    self.ahead -= 1
                else:
                    self.deliver(self.selected)
        self.plan()

    def step(self, time: int) -> bool:
        """Let the line change or the selector sample the middle of a unit; return whether it has a frame."""
        has_frame = False
        if time == self.next_unit():
            self.send()
        elif self.unit < 9:
            self.selected |= self.mark << self.unit - 1
            self.unit += 1
            has_frame = self.unit == 9
        else:
            self.unit = 0
        if self.unit == 0 and not self.mark:
            self.began = time
            self.selected = 0
            self.unit = 1
        return has_frame

    def send(self) -> None:
        """Put the next unit on the line; the flag rises with the end marker, the first of two stop units."""
        if self.sent == 0:
            self.mark = 0
        else:
            self.mark = self.register & 1
            self.register >>= 1
            self.flag = 0 if self.register else 1
        self.sent += 1
        if self.register == 0:
            self.free = self.start + HALF_UNIT * (2 * self.sent + 2)

    def deliver(self, frame: int) -> None:
        """Let printer and punch have a frame that the selector has taken."""
        try:
            self.printer.take(frame)
        finally:
            self.punch.take(frame)

    def line(self) -> "Transmitter":
        """Return a second transmitter with what is on the line, and nothing that prints or punches."""
        line = Transmitter()
        line.register, line.start, line.sent, line.mark = self.register, self.start, self.sent, self.mark
        line.unit, line.began, line.selected = self.unit, self.began, self.selected
        return line

    def finish(self) -> None:
        """The processor has stopped: print and punch what is on the line. Flag and line keep their times."""
        line = self.line()
        frames = 0
        while (time := line.next_step()) < NEVER:
            if line.step(time):
                frames += 1
                if frames > self.ahead:
                    self.ahead = frames
                    self.deliver(line.selected)

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
        """OR `character` and an end marker into the shift register and begin a start unit if it was empty."""
        if self.register == 0:
            self.start = max(self.free, PARTS * now)
            self.sent = 0
        else:
            self.lost += 1
            self.lost_at = self.lost_at or now
        self.register |= _MARKER | character

    def initialize(self, now: int) -> None:
        """Clear the flag and the shift register: the line goes to mark."""
        self.advance(now)
        if self.register and self.sent:
            edges = (PARTS * now - self.start) // HALF_UNIT
            self.free = self.start + HALF_UNIT * (edges + 4 if edges else 1)
        self.register = self.flag = self.lost = self.lost_at = 0
        self.mark = 1
        self.plan()


class Teletype:
    """The whole ASR-33, on line, its punch on and its reader's lever at START."""

    NAME = "teletype"
    CODE = 0o03

    def __init__(self) -> None:
        self.receiver = Receiver()
        self.transmitter = Transmitter()
        self.reader = self.receiver.reader
        self.keyboard = self.receiver.keyboard
        self.printer = self.transmitter.printer
        self.punch = self.transmitter.punch

    def connect(self, bus: Bus) -> None:
        """Connect both interfaces to the bus, under CODE and the next."""
        bus.connect(self.CODE + 1, self.transmitter)
        bus.connect(self.CODE, self.receiver)
