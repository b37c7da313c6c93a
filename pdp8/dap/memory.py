"""Core as bytes, for an editor's memory view, and as instructions.

A word is two bytes, the more significant first; a reference is the number of its first byte in hexadecimal,
as the protocol has it: word 0200 is 0x0100. Its octal address stands in the instruction's own text.
"""

import base64
import binascii

from pdp8.computer.hardware.core import SIZE
from pdp8.computer.machine import Machine
from pdp8.computer.use.trace import Listing, instruction
from pdp8.dap.wire import Body
from tapes.errors import WorkError

BYTES = 2
"""Of a word."""
MOST = SIZE
"""Instructions in one answer."""


class CoreError(WorkError):
    """A place that is not in core, or bytes that are no words."""


def reference(address: int) -> str:
    """Return what an editor calls the word at `address`."""
    return f"0x{BYTES * address:04x}"


def byte(text: str, offset: int = 0) -> int:
    """Return the number of a byte by a reference, `offset` bytes on. Raises CoreError."""
    try:
        return int(text, 0) + offset
    except ValueError:
        raise CoreError(f"{text}: a reference to memory is a number such as 0x0100") from None


def place(text: str, offset: int = 0) -> int:
    """Return the address of a word by its reference, `offset` bytes on. Raises CoreError."""
    at = byte(text, offset)
    if at % BYTES:
        raise CoreError(f"{text}: no word begins at byte {at:x}")
    return at // BYTES


def read(machine: Machine, start: int, count: int) -> Body:
    """Return up to `count` bytes from byte `start` on, for readMemory."""
    content = image(machine)
    begin = min(max(start, 0), len(content))
    found = content[begin : begin + max(count, 0)]
    return {
        "address": f"0x{begin:04x}",
        "data": base64.b64encode(found).decode(),
        "unreadableBytes": max(count, 0) - len(found),
    }


def write(machine: Machine, start: int, data: str) -> int:
    """Put bytes into core from byte `start` on; return how many. Raises CoreError, and then writes none."""
    try:
        given = base64.b64decode(data, validate=True)
    except binascii.Error as error:
        raise CoreError(f"the bytes to write are not in base64: {error}") from error
    content = image(machine)
    if not 0 <= start <= len(content) - len(given):
        raise CoreError(f"bytes {start:x} to {start + len(given):x}: core has 0 to {len(content):x}")
    content[start : start + len(given)] = given
    first, last = start // BYTES, -(-(start + len(given)) // BYTES)
    words = [int.from_bytes(content[BYTES * at : BYTES * at + BYTES], "big") for at in range(first, last)]
    for address, word in enumerate(words, first):
        if word > 0o7777:
            raise CoreError(f"{word:o} into {address:04o}: a word is 0000 to 7777")
    machine.core[first:last] = words
    return len(given)


def image(machine: Machine) -> bytearray:
    return bytearray(b"".join(word.to_bytes(BYTES, "big") for word in machine.core))


def disassembled(machine: Machine, listing: Listing, address: int) -> Body:
    """Return the DisassembledInstruction at `address`; one outside core is invalid."""
    if not 0 <= address < SIZE:
        return {"address": str(BYTES * address), "instruction": "", "presentationHint": "invalid"}
    word = machine.core[address]
    text = f"{address:04o}  {instruction(address, word)}"
    names = [name for name, value in listing.symbols.items() if value == address and address in listing.words]
    described = {"address": reference(address), "instructionBytes": f"{word:04o}", "instruction": text}
    return described | ({"symbol": names[0]} if names else {})
