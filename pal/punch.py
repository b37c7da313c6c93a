"""The object tape of pass 2, as the high-speed punch has it.

    000            from the start-up of the punch
    200 x 64       leader
    102 000        the origin 0200, always
    ...            each word, each origin (equal ones too); FIELD 1: 310
    0cc 0cc        checksum, in which the frames of FIELD do not count
    200 x 64       trailer

Source: tapes of DEC-08-ASB1.
"""

from collections.abc import Iterable

from pal.assembler import FIELD, ORIGIN, WORD, Listed, Message, Punched
from tapes import binary, frames

START_UP = b"\0"


def tape(output: Iterable[Message | Punched | Listed]) -> bytes:
    """Return the whole tape."""
    body = b"".join([frames_of(piece) for piece in output if isinstance(piece, Punched)])
    return START_UP + frames.leader() + body + frames.leader()


def frames_of(punched: Punched) -> bytes:
    """Return what stands on the tape for it."""
    if punched.kind == FIELD:
        return binary.field(punched.value)
    if punched.kind == ORIGIN:
        return binary.origin(punched.value)
    return binary.word(punched.value)


def words(output: Iterable[Message | Punched | Listed]) -> dict[int, int]:
    """Return {address: word}, field n from n0000 on; where an address comes twice, the later word."""
    core = {}
    bank = 0
    for piece in output:
        if not isinstance(piece, Punched):
            continue
        if piece.kind == WORD:
            core[bank | piece.location] = piece.value
        elif piece.kind == FIELD:
            bank = piece.value << 12
    return core
