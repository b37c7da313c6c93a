"""Instructions as the books have them, at the edges of pages, core, autoindexing; OPR as on real machines,
and whole.
"""

from ctypes import byref

import pytest

from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.processor import Processor
from tests.conftest import case
from tests.pdp8.computer.bench import core
from tests.reference.compiling import compiler
from tests.reference.model import Reference, library

SWITCHES = 0o5252


def test_the_books() -> None:
    for what, words, pc, lac, after, next_pc, lac_after, cycles in [
        ("TAD on page 0", "1050 50/ 1234", 0o200, 0o1111, "", 0o201, 0o2345, 2),
        ("TAD on its page", "250/ 1377 377/ 1", 0o250, 0o7777, "", 0o251, 0o10000, 2),
        ("its page, not the next one's", "377/ 1200 200/ 5 400/ 6", 0o377, 0, "", 0o400, 5, 2),
        ("TAD carries into L", "1050 50/ 2", 0o200, 0o17777, "", 0o201, 1, 2),
        ("AND keeps the link", "50 50/ 7070", 0o200, 0o13333, "", 0o201, 0o13030, 2),
        ("DCA keeps the link", "3050", 0o200, 0o11234, "50/ 1234", 0o201, 0o10000, 2),
        ("ISZ", "2050 50/ 7776", 0o200, 0, "50/ 7777", 0o201, 0, 2),
        ("ISZ skips at 0", "2050 50/ 7777", 0o200, 0, "50/ 0", 0o202, 0, 2),
        ("a skip from 7776 lands on 0", "7776/ 2050 50/ 7777", 0o7776, 0, "50/ 0", 0, 0, 2),
        ("a skip from 7777 lands on 1", "7777/ 2050 50/ 7777", 0o7777, 0, "50/ 0", 1, 0, 2),
        ("7777 is followed by 0", "7777/ 1050", 0o7777, 0, "", 0, 0, 2),
        ("JMP", "5300", 0o200, 0, "", 0o300, 0, 1),
        ("JMP I", "5650 250/ 4321", 0o200, 0, "", 0o4321, 0, 2),
        ("JMP I autoindexed", "5410 10/ 207", 0o200, 0, "10/ 210", 0o210, 0, 2),
        ("JMS", "4300", 0o200, 0, "300/ 201", 0o301, 0, 2),
        ("JMS to the end of a page", "4377", 0o200, 0, "377/ 201", 0o400, 0, 2),
        ("JMS to 7777", "4650 250/ 7777", 0o200, 0, "7777/ 201", 0, 0, 3),
        ("JMS to itself", "4200", 0o200, 0, "201", 0o201, 0, 2),
        ("JMS I 0 from 7777", "7777/ 4400 0/ 50", 0o7777, 0, "50/ 0", 0o51, 0, 3),
        ("JMS I to 0 from 7776", "7776/ 4450 50/ 0", 0o7776, 0, "0/ 7777", 1, 0, 3),
        ("autoindex", "1410 10/ 277 300/ 7", 0o200, 0, "10/ 300", 0o201, 7, 3),
        ("autoindex wraps, no skip", "1417 17/ 7777 0/ 7", 0o200, 0, "17/ 0", 0o201, 7, 3),
        ("and keeps L", "3417 17/ 7777", 0o200, 0o10003, "17/ 0 0/ 3", 0o201, 0o10000, 3),
        ("autoindex from page 0", "20/ 1610 10/ 277 300/ 7", 0o20, 0, "10/ 300", 0o21, 7, 3),
        ("210 is not autoindex", "1610 210/ 300 300/ 7", 0o200, 0, "", 0o201, 7, 3),
        ("7 is none", "1407 7/ 300 300/ 7", 0o200, 0, "", 0o201, 7, 3),
        ("20 is none", "1420 20/ 300 300/ 7", 0o200, 0, "", 0o201, 7, 3),
        ("direct ISZ 12 is plain", "2012 12/ 7777", 0o200, 0, "12/ 0", 0o202, 0, 2),
        ("a pointer to itself", "1410 10/ 7", 0o200, 0, "10/ 10", 0o201, 0o10, 3),
        ("ISZ I of the pointer itself", "2411 11/ 10", 0o200, 0, "11/ 12", 0o201, 0, 3),
        ("ISZ I 10 counts both", "2410 10/ 277 300/ 7777", 0o200, 0, "10/ 300 300/ 0", 0o202, 0, 3),
        ("only one level", "1450 50/ 451 451/ 7", 0o200, 0, "", 0o201, 7, 3),
        ("DCA over itself", "3200", 0o200, 0o7402, "7402", 0o201, 0, 2),
        ("ISZ of itself", "2200", 0o200, 0, "2201", 0o201, 0, 2),
        ("both rotates: the AND of the two", "7014", 0o200, 0o11234, "", 0o201, 0o00410, 1),
        ("both rotates twice", "7016", 0o200, 0o11234, "", 0o201, 0o00042, 1),
        ("both rotates twice", "7016", 0o200, 0o07777, "", 0o201, 0o15775, 1),
        ("8/I or 8/L to Kermit-12 and FOCAL-69", "7354", 0o200, 0, "", 0o201, 0o13776, 1),
        ("an 8/E would swap bytes", "7002", 0o200, 0o11234, "", 0o201, 0o11234, 1),
        ("an 8/I would clear", "7601", 0o200, 0o07777, "", 0o201, 0o07777, 1),
        ("CIA of 0 carries into L", "7041", 0o200, 0, "", 0o201, 0o10000, 1),
        ("CLA CLL CMA RAL", "7344", 0o200, 0, "", 0o201, 0o17776, 1),
        ("CLA IAC RAL", "7205", 0o200, 0o01234, "", 0o201, 0o00002, 1),
        ("LAS", "7604", 0o200, 0o07777, "", 0o201, SWITCHES, 1),
    ]:
        with case(what, words):
            p = Processor(Bus())
            for address, word in core(words).items():
                p.core[address] = word
            p.pc, p.lac, p.run, p.sr = pc, lac, 1, SWITCHES
            p.instruction()
            for address, word in {**core(words), **core(after)}.items():
                assert f"{address:04o}: {p.core[address]:04o}" == f"{address:04o}: {word:04o}"
            assert f"{p.pc:04o} {p.lac:05o}" == f"{next_pc:04o} {lac_after:05o}"
            assert p.clock == cycles * 32


@pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")
@pytest.mark.parametrize("first", range(0o7000, 0o10000, 0o100))
def test_every_opr_on_every_link_and_ac(first: int) -> None:
    p, reference, step = Processor(Bus()), Reference(), library().pdp8l_step
    there = byref(reference)
    p.sr = reference.sr = SWITCHES
    for word in range(first, first + 0o100):
        p.core[0o200] = reference.core[0o200] = word
        for lac in range(0o20000):
            p.pc = reference.pc = 0o200
            p.lac, (reference.link, reference.ac) = lac, divmod(lac, 0o10000)
            p.run = reference.run = 1
            p.instruction()
            step(there)
            if (p.lac, p.pc, p.run) != (reference.link << 12 | reference.ac, reference.pc, reference.run):
                pytest.fail(f"{word:04o} from {lac:05o}: {p.lac:05o}, PC {p.pc:04o}, RUN {p.run}")
    assert p.clock == 0o100 * 0o20000 * 32
    assert {*p.core} == {0, word}
