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
from tapes.frames import LEADER, RUBOUT

START_UP = b"\0"
BLOCK = "block"
"""What DTORG of PAL8 punches."""


def tape(output: Output) -> bytes:
    """Return the tape from leader to trailer."""
    body = b"".join([frames_of(piece) for piece in output if isinstance(piece, (Written, Punched))])
    return frames.leader() + body + frames.leader()


def frames_of(piece: Written | Punched) -> bytes:
    """Return the frames that punch one item."""
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


def loaded(frames: bytes) -> dict[int, int]:
    """Return {address: word} as DEC's BIN loader leaves core, without words before any origin."""
    core: dict[int, int] = {}
    address = -1
    field = bank = 0
    halves: list[int] = []
    passed_over = False
    for frame in frames:
        if frame == RUBOUT:
            passed_over = not passed_over
        elif passed_over:
            continue
        elif frame >= 0o300:
            field = (frame >> 3 & 7) << 12
        elif len(halves) == 1:
            halves.append(frame)
            if halves[0] & 0o100:
                address = _word(halves)
                halves = []
        elif halves and frame == LEADER:
            break  # the last word is the checksum
        elif halves or frame != LEADER:
            if halves and address >= 0:
                core[bank | address] = _word(halves)
                address = address + 1 & 0o7777
            halves = [frame]
            bank = field
    return core


def _word(halves: list[int]) -> int:
    return (halves[0] << 6 & 0o7700) + halves[1] & 0o7777
