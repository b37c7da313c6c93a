"""Core as bytes, for an editor's memory view, and as instructions.

A word is two bytes, the more significant first; a reference is the number of its first byte in hexadecimal,
as the protocol has it: word 0200 is 0x0100. Its octal address is in the instruction's own text.
"""

import base64
import struct

from pdp8.computer.use.trace import instruction
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.places import BYTES, byte, place, reference
from pdp8.dap.wire import Body
from tapes.errors import WorkError


def read_memory(debuggee: Debuggee, arguments: Body) -> Body:
    """Return the bytes that were asked for, or as many as there are."""
    content = _bytes(debuggee)
    begin = min(max(_first(arguments), 0), len(content))
    count = max(arguments["count"], 0)
    found = content[begin : begin + count]
    return {
        "address": f"0x{begin:04x}",
        "data": base64.b64encode(found).decode(),
        "unreadableBytes": count - len(found),
    }


def write_memory(debuggee: Debuggee, arguments: Body) -> Body:
    """Put bytes into core; return how many. Raises WorkError, and then writes none."""
    try:
        given = base64.b64decode(arguments["data"], validate=True)
    except ValueError as error:
        raise WorkError(f"the bytes to write are not in base64: {error}") from error
    core = debuggee.monitor.machine.core
    content, start = bytearray(_bytes(debuggee)), _first(arguments)
    if not 0 <= start <= len(content) - len(given):
        raise WorkError(f"bytes {start:x} to {start + len(given):x}: core has 0 to {len(content):x}")
    content[start : start + len(given)] = given
    words = struct.unpack(f">{len(core)}H", content)
    for address, word in enumerate(words):
        if word > 0o7777:
            raise WorkError(f"{word:o} into {address:04o}: a word is 0000 to 7777")
    core[:] = words
    return {"bytesWritten": len(given)}


def _bytes(debuggee: Debuggee) -> bytes:
    core = debuggee.monitor.machine.core
    return struct.pack(f">{len(core)}H", *core)


def _first(arguments: Body) -> int:
    return byte(arguments["memoryReference"], arguments.get("offset") or 0)


def disassemble(debuggee: Debuggee, arguments: Body) -> Body:
    start = place(arguments["memoryReference"], arguments.get("offset") or 0)
    start += arguments.get("instructionOffset") or 0
    addresses = range(start, start + min(arguments["instructionCount"], len(debuggee.monitor.machine.core)))
    return {"instructions": [_disassembled(debuggee, address) for address in addresses]}


def _disassembled(debuggee: Debuggee, address: int) -> Body:
    """Return the DisassembledInstruction at `address`; one outside core is invalid."""
    if not 0 <= address < len(debuggee.monitor.machine.core):
        return {"address": str(BYTES * address), "instruction": "", "presentationHint": "invalid"}
    machine, listing = debuggee.monitor.machine, debuggee.monitor.listing
    word = machine.core[address]
    text = f"{address:04o}  {instruction(address, word, machine.processor)}"
    names = [name for name, value in listing.symbols.items() if value == address and address in listing.words]
    described = {"address": reference(address), "instructionBytes": f"{word:04o}", "instruction": text}
    return described | ({"symbol": names[0]} if names else {})
