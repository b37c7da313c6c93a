"""The reference PDP-8/L, compiled and called from Python."""

import ctypes
from collections.abc import Iterable
from ctypes import POINTER, Structure, c_int32, c_int64, c_uint8, c_uint16
from functools import cache
from pathlib import Path

import numpy as np

from tests.reference.compiling import compiled, numbers

FOLDER = Path(__file__).parent
SOURCES = [FOLDER / name for name in ("processor.c", "panel.c", "devices.c", "breaks.c", "teletype_gates.c")]
HEADERS = [FOLDER / name for name in ("pdp8l.h", "parts.h", "teletype_gates.h")]

QUEUE = 4096
CORE = 1 << 15
"""The words of the largest core."""

NEVER = (1 << 63) - 1
KEYS = ("load_add", "start", "cont", "stop", "exam", "dep")
REASONS = ("limit", "stopped", "breakpoint")


@cache
def library() -> ctypes.CDLL:
    """Return the compiled reference."""
    loaded = compiled(SOURCES, HEADERS)
    loaded.pdp8l_run.argtypes = [POINTER(Reference), c_int64, c_int64, ctypes.c_char_p]
    loaded.pdp8l_wait.argtypes = [POINTER(Reference), c_int64]
    loaded.pdp8l_next.restype = c_int64
    return loaded


class _Receiver(Structure):
    _fields_ = [
        ("pulse_at", c_int64),
        *numbers(c_int32, "divider active spike in_last_unit stop_1 stop_2 bits flag reader_run"),
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


class _Gates(Structure):
    """The Teletype, as teletype_gates.h has it."""

    _fields_ = [
        ("now", c_int64),
        ("receiver", _Receiver),
        ("transmitter", _Transmitter),
        ("sender", _Sender),
        ("selector", _Selector),
    ]


class _Reader(Structure):
    _fields_ = [("tape", c_uint8 * 4096), *numbers(c_int32, "length position lever")]


class _Paper(Structure):
    _fields_ = [("frames", c_uint8 * (1 << 16)), ("count", c_int32)]

    def __bytes__(self) -> bytes:
        return bytes(self.frames[: self.count])


class _FastReader(Structure):
    _fields_ = [("at", c_int64), *numbers(c_int32, "flag buffer fetching")]


class _FastPunch(Structure):
    _fields_ = [("at", c_int64), *numbers(c_int32, "flag buffer ahead")]


class _Breaker(Structure):
    _fields_ = [
        *numbers(c_int64, "at asked"),
        *numbers(c_int32, "flag breaking three_cycle into_core counts_address increments"),
        *numbers(c_int32, "field address period word left"),
    ]


class Counts(Structure):
    """What was done in runs."""

    _fields_ = [
        ("executed", c_int32 * CORE),
        ("written", c_int32 * CORE),
        *numbers(c_int32, "interrupts cycles"),
        ("ticks", c_int64),
    ]

    def by_address(self, name: str) -> dict[int, int]:
        """Return {address: number} of what is `executed` or `written`, where it is not 0."""
        numbers = np.frombuffer(getattr(self, name), np.int32)
        there = np.flatnonzero(numbers)
        return dict(zip(there.tolist(), numbers[there].tolist(), strict=True))


class Reference(Structure):
    """The state of the reference, as pdp8l.h has it."""

    _fields_ = [
        ("core", c_uint16 * CORE),
        *numbers(c_int32, "size inst_field data_field inst_buffer saved_inst saved_data inhibit"),
        *numbers(c_int32, "inst_switch data_switch field ema breakers"),
        ("breaker", _Breaker * 2),
        *numbers(c_int32, "ac link pc ma mb ir sr state next"),
        *numbers(c_int32, "run ion ion_ready mem_prot sing_step protect stored fast"),
        *numbers(c_int64, "now instructions"),
        ("teletype", _Gates),
        ("printed", c_int32),
        ("fast_reader", _FastReader),
        ("fast_punch", _FastPunch),
        *numbers(c_int32, "punch_on fast_punch_on"),
        ("fast_tape", _Reader),
        ("page", _Paper),
        ("punched", _Paper),
        ("fast_punched", _Paper),
        ("counts", POINTER(Counts)),
    ]

    def __init__(self, fast: bool = False) -> None:
        super().__init__()
        self.do("power_up", fast)

    def do(self, name: str, *given: int | bytes) -> int:
        """Call pdp8l_NAME of pdp8l.h; bytes are followed by their length."""
        arguments = [
            each
            for value in given
            for each in ((value, len(value)) if isinstance(value, bytes) else (value,))
        ]
        result: int = getattr(library(), f"pdp8l_{name}")(ctypes.byref(self), *arguments)
        return result

    def press(self, key: str) -> None:
        """Press one of the KEYS."""
        self.do("key", KEYS.index(key))

    def run_to(
        self, until: int, last: int, breakpoints: Iterable[int] = (), writes: Iterable[int] = ()
    ) -> str:
        """Run to tick `until` or `last` instructions in all; return which of the REASONS ended it."""
        marks = bytearray(CORE)
        for address in breakpoints:
            marks[address] |= 1
        for address in writes:
            marks[address] |= 2
        looked_at = bytes(marks) if any(marks) or self.counts else None
        return REASONS[library().pdp8l_run(ctypes.byref(self), until, last, looked_at)]

    def count(self, counts: Counts | None = None) -> Counts:
        """Count from now on, on `counts` or from 0; return the counts."""
        counts = counts or Counts()
        self.counts = ctypes.pointer(counts)
        return counts

    def copied(self) -> "Reference":
        """Return another that does the same from here on; counts are shared."""
        return Reference.from_buffer_copy(self)
