"""The object tape of pass 2, as the high-speed punch has it.

    000            from the start-up of the punch
    200 x 64       leader
    102 000        the origin 0200, always
    ...            each word, each origin (equal ones too); a field, then the origin once more
    0cc 0cc        checksum
    200 x 64       trailer

Sources: tapes of DEC-08-ASB1; DEC-08-ASAC-D for FIELD.
"""

from collections.abc import Iterable

from pal.assembler import FIELD, NOTHING, START, WORD, Result
from tapes import binary

START_UP = b"\0"


def tape(results: Iterable[Result]) -> bytes:
    """Return the whole tape."""
    return START_UP + binary.tape(*body(results))


def body(results: Iterable[Result]) -> tuple[bytes, int]:
    """Return what stands between leader and checksum, and that checksum."""
    frames = bytearray(binary.origin(START))
    fields = 0
    for result in results:
        piece = frames_of(result)
        frames += piece
        if result.kind == FIELD:
            fields += piece[0]
    return bytes(frames), sum(frames) - fields & 0o7777


def frames_of(result: Result) -> bytes:
    """Return what one statement punches."""
    kind = result.kind
    if kind == WORD:
        return binary.word(result.value)
    if kind == NOTHING:
        return b""
    if kind == FIELD:
        return binary.field(result.value) + binary.origin(result.location)
    return binary.origin(result.location)


def words(results: Iterable[Result]) -> dict[int, int]:
    """Return {address: word}, field n from n0000 on; where an address comes twice, the later word."""
    core = {}
    bank = 0
    for result in results:
        if result.kind == WORD:
            core[bank | result.location] = result.value
        elif result.kind == FIELD:
            bank = (result.value & 7) << 12
    return core
