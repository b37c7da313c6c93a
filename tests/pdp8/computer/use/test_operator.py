"""The operator loads from cold: RIM toggled in, BIN read by RIM, programs read by BIN, and wrong tapes."""

from functools import cache
from pathlib import Path

import pytest

import pal
from pdp8.computer.machine import LoadError, Machine
from pdp8.computer.use import operator
from pdp8.computer.use.operator import Operator
from tapes import binary, rim
from tests.pdp8.computer.bench import core, machine, octal

PROGRAMS = Path(__file__).parents[4] / "programs"
# The PDP-8/I instruction card's two RIM loaders, from 7756.
CARD = "6032 6031 5357 6036 7106 7006 7510 5357 7006 6031 5367 6034 7420 3776 3376 5356 0000"
CARD_HIGH_SPEED = "6014 6011 5357 6016 7106 7006 7510 5374 7006 6011 5367 6016 7420 3776 3376 5357 0000"
TWO_WORDS = binary.encode({0o200: 0o1234, 0o201: 0o4321})
FIRST, SECOND = binary.encode({0o200: 0o1111}), binary.encode({0o300: 0o2222})


@cache
def assembly(name: str) -> pal.Assembly:
    """Return one of our programs, assembled without a word from the assembler."""
    made = pal.assemble((PROGRAMS / f"{name}.pal").read_text())
    assert made.ok, made.diagnostics
    return made


def bin_tape() -> bytes:
    return rim.encode(assembly("bin").words)


@pytest.fixture
def hands() -> Operator:
    """An operator at a machine that has only the BIN loader in core."""
    made = Machine()
    made.load(assembly("bin").words)
    return Operator(made)


def test_rim_is_the_cards_and_bin_lives_below_it() -> None:
    assert list(operator.RIM) == octal(CARD)
    assert list(operator.RIM_HIGH_SPEED) == octal(CARD_HIGH_SPEED)
    assert assembly("rim").words == core(f"7756/ {CARD}")
    assert set(assembly("bin").words) <= {*range(0o7622, 0o7756), 0o7777}
    assert assembly("bin").words[0o7700] == 0o7402


def test_each_action_takes_its_time_and_is_noted() -> None:
    noted: list[operator.Action] = []
    pace = operator.Pace(setting=1, pressing=0.25, mounting=5, lever=0.01)
    hands = Operator(Machine(), pace, noted.append)
    hands.load_address(0o200)
    hands.deposit(0o5200)
    hands.mount("a tape", b"\x81")
    hands.begin(0o200, 0o17)
    hands.stop()
    hands.throw_lever()
    hands.press("cont")
    assert round(hands.machine.processor.clock / 20_000_000, 2) == 10.26
    assert [(round(at / 20_000_000, 2), *action) for at, *action in noted] == [
        (1.0, "sr", 0o200, "0200 into the switches."),
        (1.25, "load add", None, "0200, LOAD ADD."),
        (2.25, "sr", 0o5200, "5200 into the switches."),
        (2.5, "dep", None, "5200 into 0200, DEP."),
        (7.5, "mount", "a tape", "a tape goes into the reader."),
        (8.5, "sr", 0o200, "0200 into the switches."),
        (8.75, "load add", None, "0200, LOAD ADD."),
        (9.75, "sr", 0o17, "0017 into the switches."),
        (10.0, "start", None, "START at 0200."),
        (10.01, "lever", None, "The reader's lever to START."),
        (10.01, "stop", None, "The reader is empty: STOP."),
        (10.01, "lever", None, "The reader's lever to STOP."),
    ]
    clock = hands.machine.processor.clock
    for key in ("load_add", "exam", "dep", "start", "cont", "stop"):
        hands.press(key)
    assert hands.machine.processor.clock == clock, "it runs, and its time is not the operator's"


def test_boot_from_cold() -> None:
    program = assembly("eia")
    m = Machine()
    m.panel.mem_prot = m.panel.sing_step = True
    steps = list(Operator(m).boot(bin_tape(), program.tape, "eia.bin"))
    assert [m.core[address] for address in range(0o7756, 0o7777)] == octal(CARD)
    assert {address: m.core[address] for address in program.words} == program.words
    trailer = len(program.tape.rstrip(b"\0").rstrip(b"\x80")) - program.tape.index(0o200)
    frames = (len(bin_tape()), trailer + 1)
    seconds = [pytest.approx(count / 10, abs=0.1) for count in frames]
    assert steps == [
        ("RIM loader toggled in", 18, 0, 0, 0, 0, 0),
        ("BIN loader read by RIM", 2, frames[0], 1, 91, seconds[0], 0),
        ("eia.bin read by BIN", 2, frames[1], 1, 131, seconds[1], 0),
    ]
    assert [str(step).rpartition(";")[0] or str(step) for step in steps] == [
        "RIM loader toggled in: 18 keys",
        f"BIN loader read by RIM: {frames[0]} frames, 91 words",
        f"eia.bin read by BIN: {frames[1]} frames, 131 words",
    ]
    assert (m.panel.lamps.run, m.teletype.reader.loaded) == (0, False)


@pytest.mark.parametrize("after", ["200 000 000", "200 " * 64 + "000 000 000 000 101 076 076 101 000 177"])
def test_what_follows_a_rim_tapes_trailer_stays_out_of_core(after: str) -> None:
    """The RIM loader knows no end: to it blank tape is 0000 for 0000, and 101 076 076 101 a word for 0176."""
    m = Machine()
    tape = rim.encode({0: 0o2222, 0o176: 0o1111, 0o200: 0o7402}).rstrip(b"\200")
    done = list(Operator(m).boot(bin_tape(), tape + bytes(octal(after))))[-1]
    assert [m.core[address] for address in (0, 0o176, 0o200)] == [0o2222, 0o1111, 0o7402]
    assert done[:5] == ("program read by RIM", 2, len(tape) + after.count("200"), 1, 3)
    assert done.missing == 0


@pytest.mark.parametrize("gap", ["000 000", "000 000 200 000 000 000", "200"])
def test_blank_tape_between_sections_is_passed_over(hands: Operator, gap: str) -> None:
    """The loader would take it for words of 0000 and its leader for their trailer."""
    hands.machine.core[0o201] = 0o5252
    done = hands.read_bin(FIRST + bytes(octal(gap)) + SECOND)
    assert [hands.machine.core[address] for address in (0o200, 0o201, 0o300)] == [0o1111, 0o5252, 0o2222]
    skipped = len(FIRST) - len(FIRST.rstrip(b"\200")) - 1 if "000" in gap else -len(octal(gap))
    frames = len(FIRST) + len(SECOND.rstrip(b"\200")) + 1 - skipped
    assert (done.frames, done.sections, done.words) == (frames, 2, 2)
    assert " frames, 2 sections, 2 words; " in str(done)


def test_the_switches_are_set_anew_before_start() -> None:
    m = machine("7604 7402")
    m.stop()
    assert Operator(m).start(0o200, 0o1234).reason == "halt"
    assert m.ac == 0o1234


def test_a_word_where_the_loader_keeps_its_own_is_counted_as_missing(hands: Operator) -> None:
    """7622 is where FRAME of the BIN loader keeps the address it returns to."""
    done = hands.read_bin(binary.encode({0o200: 0o1111, 0o7622: 0o5252}), "low.bin")
    assert (done.words, done.missing) == (1, 1)
    assert ", 1 word, 1 more not in core; " in str(done)


def test_words_to_the_end_of_core_and_messages_between_rubouts(hands: Operator) -> None:
    tape = binary.encode({0o7577: 1, 0o17: 0o7777, 0: 0o4000})
    at = len(tape) - 64 - 2  # before the checksum
    hands.read_bin(tape[:at] + b"\377 IR  0307\377" + tape[at:])
    assert [hands.machine.core[address] for address in (0o7577, 0o17, 0)] == [1, 0o7777, 0o4000]


def refused(hands: Operator, tape: bytes, *, read: str = "read_bin") -> str:
    """Return why a loader's tape is not read; the reader is empty then."""
    with pytest.raises(LoadError) as error:
        getattr(hands, read)(tape)
    assert read == "read_rim" or not hands.reader.loaded
    return str(error.value)


@pytest.mark.parametrize("frame", range(64, 74))
def test_a_wrong_hole_shows_in_the_checksum(hands: Operator, frame: int) -> None:
    tape = bytearray(binary.encode({0o200: 0o1234, 0o201: 0o4321, 0o202: 0o7402}))
    tape[frame] ^= 0o001
    assert "wrong checksum" in refused(hands, bytes(tape))


def test_a_section_before_one_without_an_end_has_to_be_right(hands: Operator) -> None:
    wrong, unended = bytearray(SECOND), FIRST.rstrip(b"\200")
    wrong[66] ^= 1
    for tape in (bytes(wrong) + unended, FIRST + bytes(wrong) + unended):
        assert "wrong checksum" in refused(hands, tape)
    done = hands.read_bin(SECOND + FIRST + unended)
    assert (done.frames, done.sections) == (len(SECOND + FIRST + unended), 3)


@pytest.mark.parametrize("tape", [TWO_WORDS[:68], b"\0", b""])
def test_a_tape_cut_short(hands: Operator, tape: bytes) -> None:
    ended = "tape: the {} loader ended with {} at "
    assert refused(hands, tape).startswith(ended.format("BIN", "tape out"))
    assert refused(Operator(Machine()), tape, read="read_rim").startswith(ended.format("RIM", "idle"))


@pytest.mark.parametrize(("frames", "loaded"), [(72, 2), (70, 1), (66, 0)])
def test_a_tape_cut_short_is_loaded_as_far_as_the_loader_got_if_forced(
    hands: Operator, frames: int, loaded: int
) -> None:
    """The loader keeps a word back until the frames after it show that it is not the checksum."""
    done = hands.read_bin(TWO_WORDS[:frames], "torn.bin", force=True)
    assert (done.frames, done.words) == (frames, loaded)
    assert not hands.panel.lamps.run
    assert hands.machine.core[0o200:0o202] == [0o1234, 0o4321][:loaded] + [0] * (2 - loaded)


def test_a_second_section_without_an_end_is_read_if_forced(hands: Operator) -> None:
    assert hands.read_bin(FIRST + SECOND[:70], force=True).sections == 2
    assert hands.machine.core[0o300] == 0o2222


def test_start_at_once_runs_nothing_before_the_lever() -> None:
    hands = Operator(Machine())
    hands.mount("a tape", b"\x81")
    hands.begin(0o200, 0)
    assert (hands.machine.instructions, hands.machine.sr, hands.reader.on) == (0, 0, True)
    hands.mount("another", b"\x81")
    assert hands.reader.on, "it runs"
    hands.throw_lever()
    hands.panel.stop()
    hands.mount("a third", b"\x81")
    hands.begin(0o200)
    assert not hands.reader.on, "nobody threw it"


@pytest.mark.parametrize("force", [False, True])
def test_a_loader_that_does_not_read_has_loaded_nothing(force: bool) -> None:
    """The words of another program are no loader; where they halt with AC = 0, the sum seems good."""
    hands = Operator(machine("7777/ 5300 7700/ 7402"))
    hands.panel.stop()
    with pytest.raises(LoadError, match="halted and had not read the tape"):
        hands.read_bin(TWO_WORDS, "x.bin", force)
    assert not hands.reader.loaded


def test_a_loader_slower_than_its_limit_is_named_with_the_limit_and_the_way_on() -> None:
    hands = Operator(machine("7777/ 5300 7700/ 2010 5300 5300"))
    hands.panel.stop()
    said = refused(hands, TWO_WORDS)
    limit = f"1 min {2 * len(TWO_WORDS) / 10:.1f} s, a minute and twice what its tape takes"
    assert f"did not end within {limit}" in said
    assert "pdp8 run LOADER --start 7777 --sr 7777 --reader TAPE --save FILE" in said


def test_the_high_speed_reader_by_switch_0_down() -> None:
    m = Machine()
    m.fit(m.highspeed)
    m.load(assembly("bin").words)
    m.highspeed.reader.load(TWO_WORDS)
    m.sr = 0o3777
    m.start(operator.BIN_START)
    assert m.run().reason == "halt"
    assert (m.ma, m.ac, m.core[0o200]) == (0o7700, 0, 0o1234)
    assert m.elapsed < 1
