"""Instructions with flags up: when an interrupt comes, and when not.

A vector of these has "flags" in "initial", the devices whose flag is up; the PC8/L is fitted. An interrupt
that follows the last instruction belongs to the vector.
"""

from collections.abc import Iterator

from pdp8.vectors.record import Recorder, Vector
from pdp8.vectors.states import states

ION, IOF, NOP, HLT, JMP_I_0 = 0o6001, 0o6002, 0o7000, 0o7402, 0o5400
WORDS = (
    *(code << 9 | mode for code in range(6) for mode in (0o020, 0o277, 0o420, 0o412, 0o677)),
    *range(0o6000, 0o6010),
    *(0o6000 | device << 3 | pulses for device in (1, 2, 3, 4) for pulses in (1, 2, 4, 6, 7)),
    *(NOP, HLT, 0o7001, 0o7410, 0o7600, 0o7604, 0o7402, 0o7412, 0o7601, 0o7014),
)
PROGRAMS = (
    *((ION, word) for word in (NOP, ION, IOF, JMP_I_0, HLT, 0o6032, 0o6042, 0o1020, 0o2020, 0o4020, 0o6003)),
    *((ION, word, NOP) for word in (ION, IOF, JMP_I_0, 0o6032, 0o6000)),
    *((word, NOP) for word in (IOF, 0o6003, 0o6005, 0o6006, 0o6007)),
)
FLAGS = ((3,), (4,), (1,), (2,), (3, 4), (1, 2, 3, 4))
_STATES = 16


def vectors(recorder: Recorder) -> Iterator[Vector]:
    """Yield the vectors of single instructions, then those of short programs."""
    some = list(enumerate(state for four in states(_STATES) for state in four))
    for number, state in some:
        for word in WORDS:
            flags, said = _flags(number + word)
            yield recorder.vector(f"{word:04o} {number} flags {said}", state, word, flags)
    for number, state in some:
        for program in PROGRAMS:
            flags, said = _flags(number + program[1])
            name = " ".join(f"{word:04o}" for word in program)
            core = {0o20: state.operand, 0: state.target}
            core |= {state.pc + place & 0o7777: word for place, word in enumerate(program)}
            yield recorder.run(f"{name} {number} flags {said}", state, core, len(program), flags)


def _flags(number: int) -> tuple[tuple[int, ...], str]:
    flags = FLAGS[number % len(FLAGS)]
    return flags, " ".join(map(str, flags))
