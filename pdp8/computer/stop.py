"""Why, where and when a run ended."""

from enum import StrEnum
from typing import NamedTuple


class Reason(StrEnum):
    """Why a run ended."""

    HALT = "halt"
    """HLT."""
    TAPE_OUT = "tape out"
    """The program waits for a reader whose tape has run out; everything is punched."""
    IDLE = "idle"
    """The program is in a loop that no event will ever end."""
    LIMIT = "limit"
    """The time or the number of instructions the run was given is over."""
    STOP_KEY = "stop key"
    """STOP was pressed, or SING STEP stopped the machine after one cycle."""
    BREAKPOINT = "breakpoint"
    PROTECT = "protect"
    """MEM PROT stopped a write."""


class Why(NamedTuple):
    """One thing that went wrong, or that the program waits for; `use.ending` says it as a sentence.

    `what` is a name of `use.ending`, `address` that of the instruction; `other` where it led to, or whence,
    `through` the pointer, `code` the device, `number` how many.
    """

    what: str
    address: int
    other: int = -1
    through: int = -1
    code: int = 0
    number: int = 0


class Stop(NamedTuple):
    """How a run ended: `pc` comes next, `elapsed` seconds since START, `why` of `use.ending`."""

    reason: Reason
    pc: int
    elapsed: float
    why: tuple[Why, ...] = ()
