"""Who called: a PDP-8 has no stack, but each subroutine's first word holds where it will return.

    0207  4240          JMS TYPE         ◄── the call: one to four words before the return
    0210  ...                  ▲
    0240  0210  TYPE,   0  ────┘             the entry, which holds the return
    0241  6046          TLS              ◄── PC: control comes here from the word after the entry

An entry is live while its word still names a place behind a JMS to it. A subroutine is the words that control
can come to from its entry, forwards and up to the next live entry. Behind a CIF, a JMS or JMP goes to its
field. What the words in core do not say is not known: a routine that is left by JMP, a return that was moved.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from pal.isa import (
    GROUP_2,
    GROUP_3,
    INDIRECT,
    IOT,
    ISZ,
    JMP,
    JMS,
    OPR,
    autoindexed,
    changes_field,
    in_field,
    refers_to,
)
from pdp8.computer.machine import Machine

ARGUMENTS = 4
"""Words behind a JMS, its arguments and skips included, among which it returns."""
_CIF = 3
"""Words before a JMS or JMP among which a CIF is looked for."""
_DEEPEST = 64
_SKIPS = 0o170  # SMA, SZA, SNL and the sense reversed
_INTERRUPT = 0


class Frame(NamedTuple):
    """The next instruction, or a call under way; and the entry of the subroutine it is in, or None."""

    address: int
    entry: int | None


def of(machine: Machine) -> list[Frame]:
    """Return a machine's call stack."""
    return frames(list(machine.core), machine.pc, machine.ion, machine.processor.extension.saved_inst)


def frames(core: Sequence[int], pc: int, ion: int, interrupted: int = 0) -> list[Frame]:
    """Return the call stack, innermost first; it may be in the interrupt routine, which returns to the field
    `interrupted`, if ION is off.
    """
    live = _live(core)
    if not ion and core[_INTERRUPT] and core[_INTERRUPT + 1]:
        live[_INTERRUPT] = interrupted | core[_INTERRUPT]
    found: list[Frame] = []
    come = set[int]()
    while len(found) < _DEEPEST:
        entry = _entry(core, live, pc)
        if entry is None or entry in come:
            break
        found.append(Frame(pc, entry))
        come.add(entry)
        pc = live[entry]
    return [*found, Frame(pc, None)]


def _live(core: Sequence[int]) -> dict[int, int]:
    """Return the active subroutines' entries, each with the address of its JMS."""
    live: dict[int, int] = {}
    for location, word in enumerate(core):
        if word >> 9 == JMS:
            entry = _target(core, word, location)
            if entry is not None and 1 <= core[entry] - (location & 0o7777) <= ARGUMENTS:
                live[entry] = location
    return live


def _target(core: Sequence[int], word: int, location: int) -> int | None:
    """Return the target of a JMS or JMP, None if its pointer was changed."""
    address = refers_to(word, location)
    if word & INDIRECT:
        if autoindexed(address):
            return None
        address = core[address]
    before = (core[place] for place in range(location - 1, max(location - 1 - _CIF, -1), -1))
    field = next(((word & 0o70) << 9 for word in before if changes_field(word)), location)
    return in_field(field if field < len(core) else location, address)


def _entry(core: Sequence[int], live: Mapping[int, int], pc: int) -> int | None:
    below = max((entry for entry in live if entry < pc), default=_INTERRUPT)
    above = min((entry for entry in live if entry > below), default=len(core))
    for entry, end in ((below, above), (_INTERRUPT, len(core))):
        if entry in live and _reaches(core, live, entry, end, pc):
            return entry
    return None


def _reaches(core: Sequence[int], live: Mapping[int, int], entry: int, end: int, pc: int) -> bool:
    """Whether control passes from `entry` to `pc` without leaving `entry` up to `end`."""
    come, ahead = set[int](), [entry + 1]
    while ahead:
        at = ahead.pop()
        if at in come or not entry < at < end:
            continue
        if at == pc:
            return True
        come.add(at)
        ahead += _followers(core, live, at)
    return False


def _followers(core: Sequence[int], live: Mapping[int, int], at: int) -> list[int]:
    """Return the addresses to which the instruction at `at` can pass control; none for a return."""
    word = core[at]
    code = word >> 9
    if code == JMP:
        returns = word & INDIRECT and refers_to(word, at) in live
        target = None if returns else _target(core, word, at)
        return [] if target is None else [target]
    group_2 = code == OPR and word & GROUP_3 == GROUP_2 and word & _SKIPS
    skips = code in (ISZ, JMS, IOT) or group_2
    return [at + 1, at + 2] if skips else [at + 1]
