"""The memory-reference instructions at the edges of pages, of core and of autoindexing.

First the cases of the books, word by word in octal; then every shape of instruction word at every edge
address against a reference that is written the other way round from the processor: whole instructions, no
cycles.
"""

from array import array
from itertools import product

import pytest

from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.processor import Processor
from tests.conftest import case

Core = dict[int, int]


def executed(core: Core, pc: int, lac: int = 0) -> Processor:
    """Return the processor after one instruction."""
    processor = Processor(Bus())
    for address, word in core.items():
        processor.core[address] = word
    processor.pc, processor.lac, processor.run = pc, lac, 1
    processor.instruction()
    return processor


def test_the_books() -> None:
    for what, core, pc, lac, after, next_pc, lac_after, cycles in [
        ("TAD on page 0", {0o200: 0o1050, 0o50: 0o1234}, 0o200, 0o1111, {}, 0o201, 0o2345, 2),
        ("TAD on its page", {0o250: 0o1377, 0o377: 1}, 0o250, 0o7777, {}, 0o251, 0o10000, 2),
        ("its page, not the next one's", {0o377: 0o1200, 0o200: 5, 0o400: 6}, 0o377, 0, {}, 0o400, 5, 2),
        ("TAD carries into L", {0o200: 0o1050, 0o50: 2}, 0o200, 0o17777, {}, 0o201, 1, 2),
        ("AND keeps the link", {0o200: 0o0050, 0o50: 0o7070}, 0o200, 0o13333, {}, 0o201, 0o13030, 2),
        ("DCA keeps the link", {0o200: 0o3050}, 0o200, 0o11234, {0o50: 0o1234}, 0o201, 0o10000, 2),
        ("ISZ", {0o200: 0o2050, 0o50: 0o7776}, 0o200, 0, {0o50: 0o7777}, 0o201, 0, 2),
        ("ISZ skips at 0", {0o200: 0o2050, 0o50: 0o7777}, 0o200, 0, {0o50: 0}, 0o202, 0, 2),
        ("a skip from 7776 lands on 0", {0o7776: 0o2050, 0o50: 0o7777}, 0o7776, 0, {0o50: 0}, 0, 0, 2),
        ("a skip from 7777 lands on 1", {0o7777: 0o2050, 0o50: 0o7777}, 0o7777, 0, {0o50: 0}, 1, 0, 2),
        ("7777 is followed by 0", {0o7777: 0o1050}, 0o7777, 0, {}, 0, 0, 2),
        ("JMP", {0o200: 0o5300}, 0o200, 0, {}, 0o300, 0, 1),
        ("JMP I", {0o200: 0o5650, 0o250: 0o4321}, 0o200, 0, {}, 0o4321, 0, 2),
        ("JMP I autoindexed", {0o200: 0o5410, 0o10: 0o207}, 0o200, 0, {0o10: 0o210}, 0o210, 0, 2),
        ("JMS", {0o200: 0o4300}, 0o200, 0, {0o300: 0o201}, 0o301, 0, 2),
        ("JMS to the end of a page", {0o200: 0o4377}, 0o200, 0, {0o377: 0o201}, 0o400, 0, 2),
        ("JMS to 7777", {0o200: 0o4650, 0o250: 0o7777}, 0o200, 0, {0o7777: 0o201}, 0, 0, 3),
        ("JMS to itself", {0o200: 0o4200}, 0o200, 0, {0o200: 0o201}, 0o201, 0, 2),
        ("JMS I 0 from 7777", {0o7777: 0o4400, 0: 0o50}, 0o7777, 0, {0o50: 0}, 0o51, 0, 3),
        ("JMS I to 0 from 7776", {0o7776: 0o4450, 0o50: 0}, 0o7776, 0, {0: 0o7777}, 1, 0, 3),
        ("autoindex", {0o200: 0o1410, 0o10: 0o277, 0o300: 7}, 0o200, 0, {0o10: 0o300}, 0o201, 7, 3),
        ("autoindex wraps, no skip", {0o200: 0o1417, 0o17: 0o7777, 0: 7}, 0o200, 0, {0o17: 0}, 0o201, 7, 3),
        ("and keeps L", {0o200: 0o3417, 0o17: 0o7777}, 0o200, 0o10003, {0o17: 0, 0: 3}, 0o201, 0o10000, 3),
        ("autoindex from page 0", {0o20: 0o1610, 0o10: 0o277, 0o300: 7}, 0o20, 0, {0o10: 0o300}, 0o21, 7, 3),
        ("210 is not autoindex", {0o200: 0o1610, 0o210: 0o300, 0o300: 7}, 0o200, 0, {}, 0o201, 7, 3),
        ("7 and 20 are none", {0o200: 0o1407, 0o7: 0o300, 0o300: 7}, 0o200, 0, {}, 0o201, 7, 3),
        ("20 is none", {0o200: 0o1420, 0o20: 0o300, 0o300: 7}, 0o200, 0, {}, 0o201, 7, 3),
        ("direct ISZ 12 is plain", {0o200: 0o2012, 0o12: 0o7777}, 0o200, 0, {0o12: 0}, 0o202, 0, 2),
        ("a pointer to itself", {0o200: 0o1410, 0o10: 0o7}, 0o200, 0, {0o10: 0o10}, 0o201, 0o10, 3),
        ("ISZ I of the pointer itself", {0o200: 0o2411, 0o11: 0o10}, 0o200, 0, {0o11: 0o12}, 0o201, 0, 3),
        (
            "ISZ I through autoindex counts both",
            {0o200: 0o2410, 0o10: 0o277, 0o300: 0o7777},
            0o200,
            0,
            {0o10: 0o300, 0o300: 0},
            0o202,
            0,
            3,
        ),
        ("only one level", {0o200: 0o1450, 0o50: 0o451, 0o451: 0o7}, 0o200, 0, {}, 0o201, 7, 3),
        ("DCA over itself", {0o200: 0o3200}, 0o200, 0o7402, {0o200: 0o7402}, 0o201, 0, 2),
        ("ISZ of itself", {0o200: 0o2200}, 0o200, 0, {0o200: 0o2201}, 0o201, 0, 2),
    ]:
        with case(what, core, pc, lac, after, next_pc, lac_after, cycles):
            processor = executed(core, pc, lac)
            for address, word in {**core, **after}.items():
                assert f"{address:04o}: {processor.core[address]:04o}" == f"{address:04o}: {word:04o}", what
            assert f"{processor.pc:04o} {processor.lac:05o}" == f"{next_pc:04o} {lac_after:05o}", what
            assert processor.clock == cycles * 32, what


EDGES = (0o0, 0o7, 0o10, 0o17, 0o20, 0o177, 0o200, 0o376, 0o377, 0o7600, 0o7776, 0o7777)
OFFSETS = (0o0, 0o1, 0o7, 0o10, 0o17, 0o20, 0o176, 0o177)
WORDS = (0, 0o10, 0o17, 0o277, 0o4000, 0o7776, 0o7777)


def reference(core: "array[int]", pc: int, lac: int) -> tuple[int, int, int]:
    """Carry out the instruction at `pc` as the handbook says it; return PC, {L, AC} and the cycles."""
    word = core[pc]
    operation, indirect, this_page, offset = (
        word // 0o1000,
        word // 0o400 % 2,
        word // 0o200 % 2,
        word % 0o200,
    )
    address = offset + (pc - pc % 0o200 if this_page else 0)
    if indirect:
        if address in range(0o10, 0o20):
            core[address] = (core[address] + 1) % 4096
        address = core[address]
    following = (pc + 1) % 4096
    accumulator, link = lac % 4096, lac // 4096
    match operation:
        case 0:
            accumulator &= core[address]
        case 1:
            total = accumulator + core[address]
            accumulator, link = total % 4096, link ^ total // 4096
        case 2:
            core[address] = (core[address] + 1) % 4096
            following = (following + (core[address] == 0)) % 4096
        case 3:
            core[address], accumulator = accumulator, 0
        case 4:
            core[address], following = following, (address + 1) % 4096
        case 5:
            following = address
    return following, link * 4096 + accumulator, (1 if operation == 5 else 2) + indirect


@pytest.mark.parametrize("operation", range(6))
def test_every_shape_at_every_edge(operation: int) -> None:
    bus = Bus()
    for pc, indirect, this_page, offset in product(EDGES, (0, 0o400), (0, 0o200), OFFSETS):
        word = operation << 9 | indirect | this_page | offset
        pointer = offset + (pc & 0o7600 if this_page else 0)
        for content, lac in product(WORDS, (0, 0o7777, 0o10001)):
            start = {0o277: 0o7777, 0o300: 0o1234, 0: 0o7777, 0o7777: 0o20, pointer: content, pc: word}
            core = array("H", bytes(2 * 0o10000))
            for address, word_there in start.items():
                core[address] = word_there
            processor = Processor(bus)
            processor.core[:] = core
            processor.pc, processor.lac = pc, lac
            processor.instruction()
            following, lac_after, cycles = reference(core, pc, lac)
            where = f"{word:04o} at {pc:04o}, {pointer:04o} holding {content:04o}, L AC {lac:05o}"
            assert (processor.pc, processor.lac, processor.clock) == (following, lac_after, cycles * 32), (
                where
            )
            assert processor.core == core, where
