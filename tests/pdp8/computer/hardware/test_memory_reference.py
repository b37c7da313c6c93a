"""The memory-reference instructions at the edges of pages, core and autoindexing, as the books have it."""

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
