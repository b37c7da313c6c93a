"""The Teletype's line, unit by unit: when flags move, what the buffer holds, what is lost, what garbled."""

from itertools import pairwise

import pytest

from pdp8.computer.hardware.teletype import Receiver, Transmitter, half_units, printed
from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import machine, octal, program

UNIT = 2_000_000 / 11


def receiver(tape: bytes, run: int = 1) -> Receiver:
    """Return a receiver with `tape` in its reader, at tick 0."""
    made = Receiver()
    made.reader.load(tape)
    made.initialize(0)
    made.reader_run = run
    made.plan()
    return made


def flag_at(device: Receiver | Transmitter, tick: int) -> int:
    device.advance(tick)
    return device.flag


def test_the_ticks_of_the_line() -> None:
    assert [half_units(n) for n in (1, 2, 17, 18, 22)] == [90_910, 181_819, 1_545_455, 1_636_364, 2_000_000]


def test_initialize_reads_one_frame_and_no_more() -> None:
    r = receiver(b"\123\124")
    assert [flag_at(r, tick) for tick in (0, 1_545_454, 1_545_455)] == [0, 0, 1]
    assert (r.buffer, r.reader.position, r.reader_run) == (0o123, 1, 0)
    r.advance(100_000_000)
    assert (r.buffer, r.reader.position, r.flag) == (0o123, 1, 1)


def test_the_buffer_is_the_shift_register() -> None:
    """PRESET at 1/8 unit, and nine shifts: the start unit comes in first."""
    r = receiver(b"\001")
    units = (0, 0.12, 0.13, 0.49, 0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5, 8.49, 8.5)
    seen = [f"{r.pulse(4, 0, round(at * UNIT) + 2):03o}" for at in units]
    expected = "000 000 377 377 177 277 137 057 027 013 005 002 002 001"
    assert seen == expected.split()


def test_the_line_shows_eight_pulses_a_unit_just_before_each() -> None:
    r = receiver(b"\123")
    r.advance(0)
    assert "".join(str(r.units(pulse) & 1) for pulse in range(1, 90)) == (
        "".join(unit * 8 for unit in "01100101011") + "1"
    )


def test_the_next_frame_comes_at_eleven_units_at_the_earliest() -> None:
    r = receiver(b"\1\2\3")
    r.pulse(2, 0, 1_545_455)
    assert [flag_at(r, tick) for tick in (3_545_454, 3_545_455)] == [0, 1]
    late = 5_000_000
    r.pulse(2, 0, late)
    assert [flag_at(r, late + tick) for tick in (1_545_454, 1_545_455)] == [0, 1]
    assert r.buffer == 3


def test_kcc_between_two_characters_loses_none() -> None:
    # The thesis's program: KRB for one, and a millisecond later KCC before it waits for the next.
    r = receiver(b"\1\2")
    r.pulse(2, 0, 1_545_500)
    r.pulse(2, 0, 1_565_500)
    assert flag_at(r, 3_545_455) == 1
    assert r.buffer == 2


def test_kcc_during_a_character_harms_nothing_and_lets_the_next_one_follow_at_full_speed() -> None:
    r = receiver(b"\1\2\3")
    r.pulse(2, 0, 1_545_500)
    r.pulse(2, 0, 2_700_000)
    assert flag_at(r, 3_545_455) == 1
    assert r.buffer == 2
    assert flag_at(r, 5_545_454) == 0  # it fell half a unit into the third
    assert flag_at(r, 5_545_455) == 1
    assert r.buffer == 3


def test_a_start_unit_takes_the_flag_down_half_a_unit_later() -> None:
    r = receiver(b"\1\2", run=1)
    r.pulse(2, 0, 100_000)  # during the first: the second follows without being asked for
    assert [flag_at(r, tick) for tick in (1_545_455, 2_000_000, 2_090_909, 2_090_910)] == [1, 1, 1, 0]


def test_a_flag_unread_for_more_than_two_and_five_eighths_units_has_lost_its_character() -> None:
    for delay, seen in ((477_272, 0o125), (477_273, 0o377)):  # 23.9 ms
        r = receiver(b"\125\252")
        r.pulse(2, 0, 100_000)
        assert flag_at(r, 1_545_455) == 1
        assert r.pulse(4, 0, 1_545_455 + delay) == seen


@pytest.mark.parametrize(("tick", "run"), [(22_727, 0), (22_728, 1)])
def test_kcc_before_preset_is_undone_by_it(tick: int, run: int) -> None:
    """READER RUN is still set at the start edge; PRESET clears it an eighth of a unit later."""
    r = receiver(b"\1\2")
    r.advance(0)
    assert r.reader_run == 1
    r.pulse(2, 0, tick)
    r.advance(100_000)
    assert r.reader_run == run


def test_initialize_in_a_space_makes_a_false_character_of_the_rest() -> None:
    """377 & 001: INITIALIZE 4.4 units after the start of 001; at 4.5 the clock finds a space again."""
    r = receiver(b"\001")
    r.advance(800_000)  # 4.4 units
    r.initialize(800_000)
    assert (r.flag, r.reader_run, r.active) == (0, 1, 0)
    r.advance(818_182)  # 4.5 units: PRESET
    assert (r.reader_run, r.active, r.buffer) == (0, 1, 0o377)
    # its shifts stand at 4 7/8, 5 7/8 ... 12 7/8: the spaces of units 4 to 8, then marks
    assert [flag_at(r, tick) for tick in (2_340_909, 2_340_910)] == [0, 1]
    assert f"{r.buffer:03o}" == "360"


def test_initialize_among_marks_leaves_the_receiver_free() -> None:
    r = receiver(b"\377\2")
    r.advance(1_000_000)
    r.initialize(1_000_000)
    assert flag_at(r, 1_545_455) == 0
    assert flag_at(r, 3_545_455) == 1
    assert r.buffer == 2


def test_a_false_start() -> None:
    """177: INITIALIZE at 0.8 units; the clock finds the start unit at 7/8 and a mark at 1 1/4. The space of
    unit 8 is found at 8 1/8: a character of marks.
    """
    r = receiver(b"\177")
    r.advance(145_454)
    r.initialize(145_454)
    r.advance(250_000)
    assert (r.active, r.reader_run, r.buffer) == (0, 0, 0o377)
    assert [flag_at(r, tick) for tick in (2_999_999, 3_000_000)] == [0, 1]
    assert r.buffer == 0o377


def test_a_transmission_takes_nine_units_and_the_next_starts_after_eleven() -> None:
    t = Transmitter()
    t.pulse(4, 0o101, 0)
    assert [flag_at(t, tick) for tick in (1_636_363, 1_636_364)] == [0, 1]
    t.pulse(2, 0, 1_636_400)
    t.pulse(4, 0o102, 1_636_418)
    assert [flag_at(t, tick) for tick in (3_636_363, 3_636_364)] == [0, 1]
    assert t.punch.tape == b"\101\102"
    t.pulse(2, 0, 9_000_000)
    t.pulse(4, 0o103, 9_000_018)
    assert [flag_at(t, tick) for tick in (10_636_381, 10_636_382)] == [0, 1]


def test_tpc_with_the_flag_up_drops_it_at_the_first_shift() -> None:
    t = Transmitter()
    t.pulse(4, 0o101, 0)
    t.advance(5_000_000)
    assert t.flag == 1
    t.pulse(4, 0o102, 5_000_000)
    ticks = (5_000_000, 5_181_818, 5_181_819, 6_636_363, 6_636_364)
    assert [flag_at(t, tick) for tick in ticks] == [1, 1, 0, 0, 1]


def test_loading_while_busy_garbles_and_lengthens() -> None:
    # 101 is 1 0 0 0 0 0 1 0 and its marker 1 on the line; after four units 0 0 1 0 1 is left. Or-ed with 102
    # and a new marker, 0 1 0 0 0 0 1 0 1, that is 0 1 1 0 1 0 1 0 1: so 1 0 0 0 0 1 1 0, mark, a space that
    # starts another character, 1 0 1, and rest.
    t = Transmitter()
    t.pulse(4, 0o101, 0)
    t.pulse(4, 0o102, half_units(8))
    assert [flag_at(t, tick) for tick in (1_636_364, half_units(26) - 1, half_units(26))] == [0, 0, 1]
    t.advance(half_units(37))  # 10 + 8.5 units
    assert [f"{frame:03o}" for frame in t.punch.tape] == ["141", "375"]


def test_an_overrun_is_printed_as_what_the_line_shows() -> None:
    """The second frame begins with what is left of the overrun; the next character's units come into it."""
    t = Transmitter()
    t.pulse(4, 0o101, 0)
    t.pulse(4, 0o102, half_units(8))
    t.advance(half_units(26))
    t.pulse(4, 0o000, half_units(27))  # its start unit begins at 15: data unit 6 of the second frame
    t.advance(half_units(60))
    assert [f"{frame:03o}" for frame in t.punch.tape] == ["141", "015", "360"]


def test_loading_for_ever_never_ends() -> None:
    m = program(0o6046, 0o5200)  # TLS, JMP .-1
    stop = m.run(seconds=0.2)
    assert stop.reason == "limit"
    assert m.teletype.transmitter.flag == 0
    assert m.teletype.transmitter.register < 0o1000


@pytest.mark.parametrize(
    ("units", "frame", "next_start"), [(3.0, 0o374, 5), (3.6, 0o370, 5.5), (0.4, 0o377, 0.5)]
)
def test_initialize_sends_the_line_to_mark(units: float, frame: int, next_start: float) -> None:
    """The printer goes on with marks; the next character waits for the fourth edge of the clock, or in the
    first half unit for the next.
    """
    t = Transmitter()
    t.pulse(4, 0o000, 0)
    t.initialize(round(units * UNIT) + 1)
    t.advance(half_units(17))
    assert t.punch.tape == bytes([frame])
    t = Transmitter()
    t.pulse(4, 0o000, 0)
    t.initialize(round(units * UNIT) + 1)
    t.pulse(4, 0o000, round(units * UNIT) + 2)
    flag = half_units(round(2 * next_start) + 18)
    assert [flag_at(t, tick) for tick in (flag - 1, flag)] == [0, 1]


def test_a_halt_lets_the_printer_finish() -> None:
    m = program(0o7604, 0o6046, 0o7402, 0o6041, 0o5203, 0o7402)  # LAS TLS HLT, TSF, JMP .-1, HLT
    m.sr = 0o301
    assert m.run().reason == "halt"
    assert m.ticks == 32 + 85 + 32
    assert m.teletype.punch.tape == b"\301"
    assert m.run().reason == "halt"
    assert m.teletype.punch.tape == b"\301"
    assert m.ticks >= 32 + 65 + 1_636_364


def test_ten_characters_a_second_out() -> None:
    # TLS, TSF, JMP .-1, ISZ COUNT, JMP 0200, HLT: 100 characters of 0 with the flag asked for each time.
    m = program(*octal("6046 6041 5201 2210 5200 7402"))
    m.core[0o210] = -100
    times: list[int] = []
    m.teletype.punch.on_frame = lambda frame: times.append(m.teletype.transmitter.start // 11)
    m.run()
    assert len(times) == 100
    assert [after - before for before, after in pairwise(times)] == [2_000_000] * 99


def test_ten_characters_a_second_both_ways_together() -> None:
    # A copy: KSF, JMP .-1, KRB, TLS, TSF, JMP .-1, JMP 0200. Reading and printing overlap, so it still takes
    # 100 ms each.
    m = program(0o6031, 0o5200, 0o6036, 0o6046, 0o6041, 0o5204, 0o5200)
    tape = bytes(range(256))
    m.teletype.reader.load(tape)
    stop = m.run()
    assert stop.reason == "tape out"
    assert m.teletype.punch.tape == tape
    # each frame waits for the printer: flag to flag 9 units, then the read flag is already up
    assert m.ticks == pytest.approx(255 * 2_000_000 + 1_545_455 + 1_636_364, abs=2_000)


def slow_reader(turns: int) -> Machine:
    """Return a program that asks for the next frame at once (KCC), dawdles, and then reads the buffer (KRS).

    0200 KSF; JMP .-1; KCC; two delay loops of 96 ticks a turn, 2000 turns the first; KRS; DCA I 10; JMP 0200.
    """
    words = octal("6031 5200 6032 1220 3222 1221 3223 2222 5207 2223 5211 6034 3410 5200")
    counts = {0o220: -2000 & 0o7777, 0o221: 2000 - turns & 0o7777, 0o10: 0o377}
    m = machine(dict(enumerate(words, 0o200)) | counts)
    m.teletype.reader.load(bytes(range(1, 11)))
    return m


@pytest.mark.parametrize(("turns", "kept"), [(3000, True), (4950, True), (4975, False), (6000, False)])
def test_a_program_too_slow_by_two_and_five_eighths_units_loses_characters(turns: int, kept: bool) -> None:
    # 23.864 ms are 477 272 ticks: 4950 turns and the rest of the program stay below, 4975 turns are above.
    m = slow_reader(turns)
    m.run()
    assert ([m.core[0o400 + n] for n in range(9)] == list(range(1, 10))) is kept


def test_what_a_model_33_prints() -> None:
    """64 characters; the codes of lower case print them too, ALT MODE and ESCAPE (175, 176) print nothing."""
    rows = printed(bytes(range(0o400))).decode()
    figures, letters = " !\"#$%&'()*+,-./0123456789:;<=>?", "@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_"
    assert rows == ("\a\n\r" + figures + letters + letters[:29]) * 2


@pytest.mark.parametrize("before", [(), (0.0,)])
@pytest.mark.parametrize("source", ["key", "tape", "fast tape"])
def test_a_frame_begins_when_it_comes_not_when_the_wait_ends(source: str, before: tuple[float, ...]) -> None:
    machine = Machine(highspeed=True)
    machine.load({0o200: 0o6014, 0o201: 0o7402})
    machine.start(0o200)
    machine.run()
    if source == "key":
        machine.teletype.keyboard.press(b"\301")
    elif source == "tape":
        machine.teletype.reader.load(b"\301")
    else:
        machine.highspeed.reader.load(b"\301")
    device = machine.bus.device(0o01 if source == "fast tape" else 0o03)
    assert device is not None
    rises = 66_667 if source == "fast tape" else 1_545_455  # 1/300 s; 8.5 units of 1/110 s
    for seconds in before:
        machine.wait(seconds)
    machine.wait((rises - 1) / 20e6)
    assert device.flag == 0
    machine.wait(1 / 20e6)
    assert device.flag == 1


def test_krb_reads_its_character_around_the_edge_at_which_the_line_falls_free() -> None:
    """The next frame begins with KRB's own second pulse, or up to the third: IOP4 comes 18 ticks later."""
    for offset in range(-90, 90):
        machine = Machine()
        machine.load({0o200: 0o7402, 0o201: 0o6036})
        machine.teletype.reader.load(b"\301\302")
        machine.start(0o200)
        machine.run()
        machine.wait(0.08)  # the first frame is in, the line falls free at 2,000,000
        machine.processor.clock = 2_000_000 + offset - 47  # IOP2 comes 47 ticks into an IOT
        machine.processor.instruction()
        assert f"{machine.ac:04o}" == "0301", f"IOP2 {offset} ticks after the line fell free"
        machine.processor.clock = 4_000_000 - 47
        machine.pc = 0o201
        machine.processor.instruction()
        assert f"{machine.ac:04o}" == "0302", f"IOP2 {offset} ticks after the line fell free"


def test_a_character_that_comes_in_reads_as_a_mixture_a_little_later() -> None:
    """KRS an eighth of a unit after the start unit: the shift register has been set to 377."""
    machine = Machine()
    machine.load({0o200: 0o7402, 0o201: 0o6032, 0o202: 0o6034})
    machine.teletype.reader.load(b"\301\302")
    machine.start(0o200)
    machine.run()
    machine.wait(0.08)
    machine.processor.clock = 2_000_000 - 50
    machine.processor.instruction()
    for clock, read in ((2_022_662, "0301"), (2_022_663, "0377")):  # IOP4 comes 65 ticks into an IOT
        machine.processor.clock = clock
        machine.processor.instruction()
        assert f"{machine.ac:04o}" == read
        machine.ac, machine.pc = 0, 0o202
