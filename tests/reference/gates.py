"""The Teletype made of flip-flops, compiled and called from Python."""

import ctypes
from ctypes import POINTER, Structure, byref, c_int, c_int32, c_int64, c_uint8
from functools import cache
from pathlib import Path

from tests.reference.compiling import compiled, numbers

FOLDER = Path(__file__).parent
QUEUE = 4096

PARTS = 11
"""Parts of a tick: a unit of the line is 2,000,000 of them."""
UNIT = 2_000_000


@cache
def library() -> ctypes.CDLL:
    """Return the compiled model."""
    loaded = compiled([FOLDER / "teletype_gates.c"], [FOLDER / "teletype_gates.h"])
    loaded.gates_run.argtypes = [POINTER(Gates), c_int64]
    loaded.gates_run.restype = c_int64
    loaded.gates_iot.argtypes = [POINTER(Gates), c_int, c_int, c_int64]
    loaded.gates_initialize.argtypes = [POINTER(Gates), c_int64]
    loaded.gates_power_up.argtypes = [POINTER(Gates), c_int, c_int, c_int64]
    return loaded


class _Receiver(Structure):
    _fields_ = [
        ("pulse_at", c_int64),
        *numbers(c_int32, "wide_pulse divider active spike in_last_unit stop_1 stop_2 bits flag reader_run"),
    ]


class _Transmitter(Structure):
    _fields_ = [
        ("edge_at", c_int64),
        *numbers(c_int32, "active freq_div stop_1 stop_1_5 stop_2 enable bits line flag"),
    ]


class _Sender(Structure):
    _fields_ = [
        ("at", c_int64),
        *numbers(c_int32, "units shifting line keys keys_sent lever length position"),
        *numbers(c_uint8 * QUEUE, "keyboard tape"),
    ]


class _Selector(Structure):
    _fields_ = [("at", c_int64), *numbers(c_int32, "unit frame printed"), ("page", c_uint8 * QUEUE)]


class Gates(Structure):
    """The state of the model, as teletype_gates.h has it. Times are in ticks, but `phase` in parts of one."""

    _fields_ = [
        ("now", c_int64),
        ("free_clocks", c_int32),
        ("receiver", _Receiver),
        ("transmitter", _Transmitter),
        ("sender", _Sender),
        ("selector", _Selector),
    ]

    def __init__(self, phase: int | None = None, wide_pulse: bool = False) -> None:
        """Power up; with `phase` both clocks run free, with an edge of both at that time."""
        super().__init__()
        library().gates_power_up(byref(self), phase is not None, wide_pulse, phase or 0)

    def run(self, until: int) -> int:
        """Run to tick `until`, or to the first at which a flag or READER RUN changes; return which."""
        reached: int = library().gates_run(byref(self), until)
        return reached

    def iot(self, word: int, ac: int, began: int) -> int:
        """Do an IOT; return AC, and 0o10000 if it skips."""
        answer: int = library().gates_iot(byref(self), word, ac, began)
        return answer

    def initialize(self, now: int) -> None:
        """INITIALIZE at tick `now`."""
        library().gates_initialize(byref(self), now)

    def type(self, frames: bytes) -> None:
        """Press the keys that send `frames`."""
        for frame in frames:
            library().gates_type(byref(self), frame)

    def load_tape(self, frames: bytes) -> None:
        """Put a tape of at most QUEUE frames in the reader."""
        library().gates_load_tape(byref(self), frames, len(frames))

    def printed(self, since: int = 0) -> bytes:
        """Return the frames printed after the first `since`."""
        return bytes(self.selector.page[number % QUEUE] for number in range(since, self.selector.printed))
