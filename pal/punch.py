"""The object tape of pass 2, as the high-speed punch has it.

    000            from the start-up of the punch
    200 x 64       leader
    102 000        the origin 0200, always
    ...            each word, each origin (equal ones too); FIELD 1: 310
    0cc 0cc        checksum, in which the frames of FIELD do not count
    200 x 64       trailer

Source: tapes of DEC-08-ASB1.
"""

from pal.assembler import Output, Punched, Written
from tapes import binary, frames

START_UP = b"\0"
BLOCK = "block"
"""What DTORG of PAL8 punches."""


def tape(output: Output) -> bytes:
    """Return the tape from leader to trailer."""
    body = b"".join([frames_of(piece) for piece in output if isinstance(piece, (Written, Punched))])
    return frames.leader() + body + frames.leader()


def frames_of(piece: Written | Punched) -> bytes:
    """Return what stands on the tape for it."""
    if isinstance(piece, Written):
        return binary.word(piece.word)
    if piece.kind == binary.FIELD:
        return binary.field(piece.value)
    if piece.kind == BLOCK:
        return bytes((0o300 | piece.value >> 6, piece.value & 0o77))
    if piece.kind == binary.ORIGIN:
        return binary.origin(piece.value)
    return binary.word(piece.value)


def words(output: Output) -> dict[int, int]:
    """Return {address: word}, field n from n0000 on; where an address comes twice, the later word."""
    return {piece.address: piece.word for piece in output if isinstance(piece, Written)}
