"""The reference PDP-8/L, compiled and called from Python."""

import ctypes
from collections.abc import Iterable
from ctypes import POINTER, Structure, c_int, c_int32, c_int64, c_uint8, c_uint16
from functools import cache
from pathlib import Path

from tests.reference.compiling import compiled, numbers
from tests.reference.gates import Gates

FOLDER = Path(__file__).parent
SOURCES = [FOLDER / name for name in ("processor.c", "devices.c", "teletype_gates.c")]
HEADERS = [FOLDER / name for name in ("pdp8l.h", "parts.h", "teletype_gates.h")]

NEVER = (1 << 63) - 1
REASONS = ("limit", "stopped", "breakpoint")


@cache
def library() -> ctypes.CDLL:
    """Return the compiled reference."""
    loaded = compiled(SOURCES, HEADERS)
    loaded.pdp8l_run.argtypes = [POINTER(Reference), c_int64, c_int64, ctypes.c_char_p]
    loaded.pdp8l_wait.argtypes = [POINTER(Reference), c_int64]
    loaded.pdp8l_next.restype = c_int64
    return loaded


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


class Counts(Structure):
    """What was done in runs."""

    _fields_ = [
        ("executed", c_int32 * 4096),
        ("written", c_int32 * 4096),
        *numbers(c_int32, "interrupts cycles"),
        ("ticks", c_int64),
    ]

    def by_address(self, name: str) -> dict[int, int]:
        """Return {address: number} of what is `executed` or `written`, where it is not 0."""
        return {address: number for address, number in enumerate(getattr(self, name)) if number}


class Reference(Structure):
    """The state of the reference, as pdp8l.h has it."""

    _fields_ = [
        ("core", c_uint16 * 4096),
        *numbers(c_int32, "ac link pc ma mb ir sr state next run ion ion_ready mem_prot protect fast"),
        *numbers(c_int64, "now instructions"),
        ("teletype", Gates),
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
        self._call("power_up", c_int(fast))

    def _call(self, name: str, *arguments: object) -> int:
        result: int = getattr(library(), f"pdp8l_{name}")(ctypes.byref(self), *arguments)
        return result

    def press(self, key: str) -> None:
        """Press START, STOP, LOAD ADD, EXAM or DEP: `start`, `stop`, `load_add`, `exam`, `dep`."""
        self._call(key)

    def cycle(self) -> None:
        """Run one memory cycle."""
        self._call("cycle")

    def run_to(
        self, until: int, last: int, breakpoints: Iterable[int] = (), writes: Iterable[int] = ()
    ) -> str:
        """Run to tick `until` or `last` instructions in all; return which of the REASONS ended it."""
        marks = bytearray(4096)
        for address in breakpoints:
            marks[address] |= 1
        for address in writes:
            marks[address] |= 2
        return REASONS[self._call("run", until, last, bytes(marks) if any(marks) or self.counts else None)]

    def count(self, counts: Counts | None = None) -> Counts:
        """Count from now on, on `counts` or from 0; return the counts."""
        counts = counts or Counts()
        self.counts = ctypes.pointer(counts)
        return counts

    def copied(self) -> "Reference":
        """Return another that does the same from here on; counts are shared."""
        return Reference.from_buffer_copy(self)

    def endless(self) -> bool:
        """Tell whether the program, left alone, goes round for ever and no device will do anything."""
        return bool(self._call("endless"))

    def wait(self, ticks: int) -> None:
        """Let time pass while the processor stands still."""
        self._call("wait", ticks)

    def settle(self) -> None:
        """Let all happen that happens now."""
        self._call("settle")

    def next_event(self) -> int:
        """Return the tick at which a device does something next, be it that nobody sees it."""
        return self._call("next")

    def finish(self) -> None:
        """Let the mechanisms finish what they have begun."""
        self._call("finish")

    def type(self, frames: bytes) -> None:
        """Press the keys that send `frames`."""
        self._call("type", frames, len(frames))

    def load_tape(self, frames: bytes, fast: bool = False) -> None:
        """Put a tape in one of the readers."""
        self._call("tape", c_int(fast), frames, len(frames))

    def throw_lever(self, start: bool, fast: bool = False) -> None:
        """Put a reader's lever to START or STOP."""
        self._call("lever", c_int(fast), c_int(start))
