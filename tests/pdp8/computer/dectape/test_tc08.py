"""The DECtape beside DEC's description of it: registers, flags, words and times, by programs in octal."""

import copy
import random

import pytest

from pdp8.computer.dectape.tc08 import TC08, turned
from pdp8.computer.dectape.tu55 import STOPPED
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind, state
from pdp8.computer.past.history import History
from pdp8.computer.use.bootstrap import boot
from tapes.dectape import WORDS
from tests.pdp8.computer.bench import core
from tests.pdp8.computer.dectape.reel import machine, reel
from tests.pdp8.web.node import in_node, needs_node
from tests.sampling import some

MOVE, SEARCH, READ, READ_ALL, WRITE, WRITE_ALL = (0o10 * function for function in range(6))
GO, BACKWARDS, CONTINUOUS = 0o200, 0o400, 0o100
COMMAND = "1020 6766 6771 5202 6772 7402"
"""TAD 20, DTCA DTXA, DTSF, JMP .-1, DTRB, HLT: what A is given, until a flag; status B is in AC then."""
LINE = 1 / 30_000


def command(
    m: Machine, a: int, count: int = 0, address: int = 0o777, clears: bool = True
) -> tuple[int, float]:
    """Let the control do `a`; return status B, and how long it took."""
    m.load(core(COMMAND if clears else COMMAND.replace("6766", "6764")))
    m.core[0o20] = a
    m.core[0o7754], m.core[0o7755] = -count & 0o7777, address
    m.stop()
    m.pc, m.ac = 0o200, 0
    before = m.elapsed
    assert m.run(10).reason == "halt"
    return m.ac, m.elapsed - before


def at_block(number: int) -> tuple[Machine, TC08]:
    """Return a machine whose tape goes forward, and has just found a block."""
    m, control = machine()
    m.start(0o200)
    assert command(m, BACKWARDS | GO)[0] == 0o5000  # the end zone
    assert command(m, GO | SEARCH | CONTINUOUS, number + 1, 0o100)[0] & 0o7707 == 1
    assert m.core[0o100] == number
    assert m.core[0o7755] == 0o100  # CA is not counted
    return m, control


@pytest.mark.parametrize("memory", [0o10000, 0o20000, 0o100000])
def test_our_own_tape_boots(memory: int) -> None:
    m, _ = machine(memory)
    boot(m)
    assert m.run(5).reason == "halt"
    assert bytes(m.teletype.printer.frames) == b"\317\313"
    assert m.core[0o7600:0o7754] == list(reel().words[:0o154])


def test_words_come_each_after_four_lines_and_the_flag_with_the_checksum() -> None:
    m, _ = at_block(5)
    b, time = command(m, SEARCH ^ READ, WORDS, clears=False)  # the tape goes on, and block 5 is read
    assert b & 0o7707 == 1
    assert m.core[0o1000:0o1201] == [5] * WORDS
    assert time == pytest.approx((18 + 4 * 129 + 3.5) * LINE, abs=20e-6)


def test_a_block_is_19_2_milliseconds() -> None:
    m, _ = at_block(3)
    for number in (4, 5, 6):
        b, time = command(m, 0, 1, 0o100, clears=False)  # the flag off, and the next block is found
        assert (b & 0o7707, m.core[0o100]) == (1, number)
        assert time == pytest.approx(0.0192, abs=150e-6)


def test_backwards_a_word_is_the_complement_of_its_lines_turned() -> None:
    assert [turned(word) for word in (0, 0o1234, 0o7000)] == [0o7777, 0o3456, 0o7770]
    m, _ = at_block(5)
    assert command(m, BACKWARDS | GO | SEARCH | CONTINUOUS, 3, 0o100)[0] & 0o7707 == 1
    number = m.core[0o100]
    b, _ = command(m, SEARCH ^ READ, WORDS, clears=False)
    assert (b & 0o7707, m.core[0o1000]) == (1, turned(number))


def test_what_is_written_is_read_and_the_rest_of_the_block_is_zeros() -> None:
    m, control = at_block(5)
    m.core[0o1000:0o1004] = [1, 2, 3, 4]
    assert command(m, SEARCH ^ WRITE, 3, clears=False)[0] & 0o7707 == 1
    written = control.drives[0].written()
    assert written is not None
    block = list(written.words[5 * WORDS : 6 * WORDS])
    assert block == [1, 2, 3, *[0] * 126]
    assert list(written.words[6 * WORDS : 7 * WORDS]) == [6] * WORDS


BETWEEN = (
    "7200 0 0 0 0027 7777 7777 7700 0 0 0600 0 0 0 0",
    "7777 7777 7777 7777 7717 7777 7777 7700 0 0 0577 7777 7777 7777 7750",
)
"""From the words of a block to those of the next, as the gates of drovak/verilogpdp read what DEC's formatter
writes: blocks 5 and 6, whose words are 5 and 6, and backwards 6 and 5.
"""


def test_read_all_reads_every_line_in_groups_of_four() -> None:
    m, _ = at_block(5)
    assert command(m, SEARCH ^ READ_ALL, 0o225, clears=False)[0] & 0o7707 == 1
    assert m.core[0o1000:0o1005] == [0o500, 0, 0, 0, 0]
    assert m.core[0o1005:0o1206] == [5] * WORDS
    assert m.core[0o1206:0o1225] == [int(word, 8) for word in BETWEEN[0].split()]
    command(m, BACKWARDS | GO | SEARCH, 1, 0o100)
    while m.core[0o100] != 6:
        command(m, 0, 1, 0o100, clears=False)
    assert command(m, SEARCH ^ READ_ALL ^ CONTINUOUS, 0o225, clears=False)[0] & 0o7707 == 1
    assert m.core[0o1000:0o1005] == [0o677, 0o7777, 0o7777, 0o7777, 0o7760]
    assert m.core[0o1005:0o1206] == [turned(6)] * WORDS
    assert m.core[0o1206:0o1225] == [int(word, 8) for word in BETWEEN[1].split()]


def test_a_block_changed_by_write_all_is_a_parity_error_until_it_is_written() -> None:
    m, control = at_block(5)
    assert command(m, SEARCH ^ WRITE_ALL, 0o20, clears=False)[0] & 0o7707 == 1
    assert list(control.drives[0].blocks[5]) == [*[0] * 13, *[5] * 116, 0o72]
    for function, status in ((READ, 0o4201), (WRITE, 1), (READ, 1)):
        command(m, BACKWARDS | GO)
        command(m, GO | SEARCH | CONTINUOUS, 6, 0o100)
        assert command(m, SEARCH ^ function, WORDS, clears=False)[0] & 0o7707 == status
        assert control.a & GO  # a parity error does not stop the tape


@pytest.mark.parametrize("way", [0, BACKWARDS])
def test_write_all_writes_the_words_and_both_checksums_as_read_all_reads_them(way: int) -> None:
    """Its first group is the third that READ ALL reads: so the header's last three, of which the last ends in
    a checksum, 129 words, and one that begins in a checksum.
    """
    groups = random.Random(8).choices(range(4096), k=133)
    m, control = at_block(5)
    for function, count in ((WRITE_ALL, 133), (READ_ALL, 135)):
        m.core[0o1000:0o1207] = groups + [0] * 2 if function == WRITE_ALL else [0] * 135
        command(m, BACKWARDS | GO)
        command(m, GO | SEARCH | CONTINUOUS, 8 if way else 6, 0o100)
        if way:
            command(m, BACKWARDS | GO | SEARCH | CONTINUOUS, 3, 0o100)
        assert m.core[0o100] == 5
        assert command(m, SEARCH ^ function, count, clears=False)[0] & 0o7707 == 1
    assert [*control.drives[0].blocks] == [5]
    assert m.core[0o1005:0o1206] == groups[3:132]
    assert (m.core[0o1004] & 0o77, m.core[0o1206] >> 6) == (groups[2] & 0o77, groups[132] >> 6)


def test_read_and_write_are_too_late_within_a_block() -> None:
    for function in (READ, WRITE):
        m, _ = at_block(5)
        m.load(core("5200"))
        m.pc = 0o200
        m.run(0.004)
        assert command(m, SEARCH ^ function, WORDS, clears=False)[0] & 0o7707 == 0o4100


def test_a_block_may_be_read_on_at_the_flag_of_the_one_before() -> None:
    """DTXA follows DTSF at once, as PS/8's loader does it."""
    m, control = at_block(5)
    m.load(core("1020 6764 6771 5202 6764 6771 5205 6772 7402"))
    m.core[0o20], m.core[0o7754], m.core[0o7755] = SEARCH ^ READ ^ CONTINUOUS, -0o300 & 0o7777, 0o777
    m.stop()
    m.pc, m.ac = 0o200, 0
    assert m.run(1).reason == "halt"
    assert (m.ac & 0o7707, control.block) == (1, 7)


def test_power_off_at_any_moment_of_a_block_leaves_the_words_taken_by_then() -> None:
    """Then reading it is a parity error, but not of its image, which has no checksums."""
    draw = random.Random(0)
    for moment in (0.0002, 0.0007, *(draw.uniform(0.0006, 0.0178) for _ in range(8)), 0.0178, 0.0185):
        m, control = at_block(5)
        m.core[0o1000:0o1201] = range(0o100, 0o301)
        m.load(core("1020 6764 5202"))
        m.core[0o20], m.core[0o7754], m.core[0o7755] = SEARCH ^ WRITE, -WORDS & 0o7777, 0o777
        m.stop()
        m.pc, m.ac = 0o200, 0
        m.run(moment)
        taken = min(max(int((moment / LINE - 17.5) / 4 + 1), 0), WORDS)
        reel = control.drives[0].written()
        assert reel is not None
        block = list(reel.words[5 * WORDS : 6 * WORDS])
        on_tape = next((word for word in range(WORDS) if block[word] == 5), WORDS)
        assert block == [*range(0o100, 0o100 + on_tape), *[5] * (WORDS - on_tape)]
        assert abs(on_tape - taken) < 2, moment
        m.power_up()
        total = 0
        for word in block:
            total ^= word >> 6 ^ word & 0o77
        status = 1 if total == 5 or moment > 0.0179 else 0o4201  # 5: as before, by chance
        for expected in (status, 1):
            m.start(0o200)
            command(m, BACKWARDS | GO)
            command(m, GO | SEARCH | CONTINUOUS, 6, 0o100)
            assert command(m, SEARCH ^ READ, WORDS, clears=False)[0] & 0o7707 == expected, moment
            assert m.core[0o1000:0o1201] == block
            control.drives[0].mount(reel)


def test_a_flag_that_stays_up_is_a_timing_error() -> None:
    m, control = at_block(3)
    m.load(core("5200"))
    m.pc = 0o200
    m.run(0.015)
    assert control.b & 0o7707 == 1
    m.run(0.005)  # the next block has begun
    assert control.b & 0o7707 == 0o4101


def test_select_errors() -> None:
    for a in (GO | 0o1000, GO | 0o60, GO | 0o70):
        m, _ = machine()
        m.start(0o200)
        assert command(m, a)[0] == 0o4400, f"{a:o}"
    m, control = machine()
    m.start(0o200)
    control.drives[0].locked = 1
    for function in (WRITE, WRITE_ALL):
        assert command(m, GO | function)[0] == 0o4400


def test_a_change_of_unit_direction_or_go_and_no_other_is_waited_for() -> None:
    for bit in range(2, 12):
        control = machine()[1]
        control.pulse(4, 0o3 | 1 << bit, 1000)
        assert control.settled == (2_401_000 if bit > 6 else 0), f"{1 << bit:o}"


def test_another_reel_has_nothing_of_the_one_before() -> None:
    drive = machine()[1].drives[0]
    drive.write(3, 0, 0o7070)
    drive.mount(reel())
    assert (drive.read(3, 0), drive.blocks) == (3, {})


def test_a_reel_that_is_stopped_while_it_turns_comes_to_rest() -> None:
    drive = machine()[1].drives[0]
    drive.go(0, 0)
    drive.go(1, 10_000_000)
    drive.stop(10_000_001)
    assert drive.position(20_000_000) == drive.position(40_000_000)


def test_stopping_carries_the_tape_further_than_starting_uses_up() -> None:
    """A handler that stops after a block, and turns twice, comes to one before it."""
    m, _ = at_block(100)
    m.load(core("6762 7402"))
    m.stop()
    m.pc = 0o200
    m.run(1)
    m.wait(1)
    assert command(m, BACKWARDS | GO | SEARCH, 1, 0o100)[0] & 0o7707 == 1
    found = m.core[0o100]
    assert found in (99, 100)
    assert command(m, GO | SEARCH, 1, 0o100)[0] & 0o7707 == 1
    assert m.core[0o100] <= found + 1


BUSY = "7300 1020 6766 6771 5203 6772 7200 1021 6764 6771 5211 6772 5200"
"""Back and forth, searching, reading and writing, whatever comes of it."""


def some_machine(seed: int) -> tuple[Machine, random.Random]:
    """Return a machine somewhere in the work of a DECtape."""
    draw = random.Random(seed)
    m, _ = machine(draw.choice((0o10000, 0o20000, 0o100000)))
    m.load(core(f"177/ {draw.choice(('7000', '6001'))} {BUSY} 0/ 0 7300 6772 6001 5400"))
    m.core[0o20] = GO | draw.choice((MOVE, SEARCH, READ, WRITE, READ_ALL)) | draw.choice((0, CONTINUOUS, 4))
    m.core[0o21] = draw.choice((BACKWARDS, SEARCH ^ READ, SEARCH ^ WRITE, CONTINUOUS, GO, 4, WRITE_ALL))
    m.core[0o7754], m.core[0o7755] = draw.randrange(0o10000), draw.randrange(0o1000, 0o7000)
    m.start(0o177)
    m.run(draw.choice((0.02, 0.4, 0.8)) * draw.random())
    if draw.random() < 0.3:
        m.run(cycles=draw.randrange(20))
    return m, draw


def same_from_here(seed: int) -> bool:
    """Whether the tape moves there: saved, copied and taken back the machine goes on as it does."""
    m, draw = some_machine(seed)
    control = m.devices[-1]
    assert isinstance(control, TC08)
    moves = control.drives[0].phase != STOPPED
    fresh = TC08()
    fresh.drives[0].mount(reel())
    text = state.save(m)
    copies = [copy.deepcopy(m), state.restore(text, [fresh])]
    assert all(state.save(each) == text for each in copies), seed
    history, number = History(m), m.instructions
    seconds = draw.choice((0.0003, 0.01, 0.2))
    for each in (m, *copies):
        each.run(seconds)
    after, clock = state.save(m), m.processor.clock
    assert all(state.save(each) == after for each in copies), seed
    m.run(0.001)
    rewind.instructions(history, m.instructions - number)
    assert m.instructions == number, seed
    m.run((clock - m.processor.clock) / TICKS_PER_SECOND)
    assert state.save(m) == after, seed
    return moves


def test_states_of_a_tape_in_motion() -> None:
    moves = [same_from_here(seed) for seed in range(12)]
    assert sum(moves) > 6


@pytest.mark.slow("2,000 states by WHOLE=1")
def test_many_states_of_a_tape_in_motion() -> None:
    for seed in range(12, 12 + some(2000)):
        same_from_here(seed)


IN_JAVASCRIPT = """async ([image, cases]) => {
  const { Machine } = await import("@/pdp8/computer/machine.mjs");
  const { TC08 } = await import("@/pdp8/computer/dectape/tc08.mjs");
  const { Teletype } = await import("@/pdp8/computer/hardware/teletype.mjs");
  const { restore, save } = await import("@/pdp8/computer/past/state.mjs");
  const { decode } = await import("@/tapes/dectape.mjs");
  const [reel] = decode(image);
  const fitted = () => { const control = new TC08(); control.drives[0].mount(reel); return control; };
  return cases.map(([words, seconds]) => {
    const m = new Machine([new Teletype(), fitted()], 0o20000);
    m.load(words);
    m.start(0o200);
    return seconds.map((each) => { m.run(each); return save(restore(save(m), [fitted()])); });
  });
}"""


@needs_node
def test_the_page_moves_the_tape_as_python_does() -> None:
    """Several functions, from one state to the next."""
    cases, expected, written = [], [], set[int]()
    for first, then in ((READ, BACKWARDS), (SEARCH, SEARCH ^ WRITE), (WRITE_ALL, READ_ALL)):
        words = core(f"{BUSY} 0/ 0 7300 6772 6001 5400")
        words |= {0o20: GO | first, 0o21: then, 0o7754: 0o7600, 0o7755: 0o2000}
        m, control = machine(0o20000)
        m.load(words)
        m.start(0o200)
        cases.append((list(words.items()), (0.3, 0.017)))
        expected.append([(m.run(seconds), state.save(m))[1] for seconds in (0.3, 0.017)])
        written.update(control.drives[0].blocks)
    assert written
    assert in_node(IN_JAVASCRIPT, (reel().content(), cases)) == expected


def test_back_across_a_written_block() -> None:
    m, control = at_block(5)
    m.core[0o1000:0o1201] = range(0o100, 0o301)
    history = History(m)
    command(m, SEARCH ^ WRITE, WORDS, clears=False)
    assert list(control.drives[0].blocks) == [5]
    number = m.instructions
    after = state.save(m)
    m.run(0.5)
    rewind.instructions(history, m.instructions - number)
    assert state.save(m) == after
    rewind.seconds(history, history.seconds)
    assert control.drives[0].blocks == {}
