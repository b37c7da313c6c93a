"""A program slower than the reader loses nothing, however it reads: READER RUN waits for it."""

import pytest

from tests.pdp8.computer.bench import machine

TAPE = bytes([0o201, 0o102, 0o303, 0o004])
# KSF, JMP .-1, a delay of turns * 4096 * 3 cycles, read, DCA I 10, ISZ 17, JMP 200, HLT
LOOP = {
    0o10: 0o377, 0o17: 0o7774, 0o20: 0, 0o21: 0,
    0o200: 0o6031, 0o201: 0o5200, 0o202: 0o1022, 0o203: 0o3021,
    0o204: 0o2020, 0o205: 0o5204, 0o206: 0o2021, 0o207: 0o5204,
    0o210: 0o6036, 0o211: 0o7000, 0o212: 0o3410, 0o213: 0o2017, 0o214: 0o5200, 0o215: 0o7402,
}  # fmt: skip


@pytest.mark.parametrize("turns", [1, 2, 4, 5, 6, 16, 64])
@pytest.mark.parametrize("reading", [(0o6036, 0o7000), (0o6034, 0o6032)], ids=["KRB", "KRS, then KCC"])
def test_no_character_is_lost_to_a_slow_program(turns: int, reading: tuple[int, int]) -> None:
    m = machine({**LOOP, 0o22: -turns & 0o7777, 0o210: reading[0], 0o211: reading[1]})
    if reading[0] == 0o6034:  # KRS ors into AC, KCC clears it: store in between
        m.load({0o211: 0o3410, 0o212: 0o6032})
    m.teletype.reader.load(TAPE)
    m.start(0o200)
    stop = m.run(seconds=60)
    assert stop.reason == "halt"
    assert bytes(m.core[0o400 + at] for at in range(4)) == TAPE
