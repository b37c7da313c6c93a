"""The operator loads from cold: RIM toggled in, BIN read by RIM, programs read by BIN, and wrong tapes."""

from functools import cache
from pathlib import Path

import pytest

import pal
from pdp8.computer.machine import LoadError, Machine
from pdp8.computer.use import operator
from pdp8.computer.use.operator import Operator
from tapes import binary, rim
from tests.pdp8.computer.bench import octal

PROGRAMS = Path(__file__).parents[4] / "programs"
# The PDP-8/I instruction card's two RIM loaders, from 7756.
CARD = "6032 6031 5357 6036 7106 7006 7510 5357 7006 6031 5367 6034 7420 3776 3376 5356 0000"
CARD_HIGH_SPEED = "6014 6011 5357 6016 7106 7006 7510 5374 7006 6011 5367 6016 7420 3776 3376 5357 0000"


@cache
def assembly(name: str) -> pal.Assembly:
    """Return one of our programs, assembled without a word from the assembler."""
    made = pal.assemble((PROGRAMS / f"{name}.pal").read_text())
    assert made.ok, made.diagnostics
    return made


def bin_tape() -> bytes:
    return rim.encode(assembly("bin").words)


def bin_machine(highspeed: bool = False) -> Machine:
    """Return a machine that has only the BIN loader in core."""
    machine = Machine(highspeed)
    machine.load(assembly("bin").words)
    return machine


def test_rim_is_the_cards() -> None:
    assert list(operator.RIM) == octal(CARD)
    assert list(operator.RIM_HIGH_SPEED) == octal(CARD_HIGH_SPEED)
    assert assembly("rim").words == dict(enumerate(octal(CARD), 0o7756))


def test_bin_lives_below_rim() -> None:
    assert set(assembly("bin").words) <= {*range(0o7622, 0o7756), 0o7777}
    assert assembly("bin").words[0o7700] == 0o7402


def test_toggling() -> None:
    machine = Machine()
    assert sum(1 for _ in Operator(machine).toggle(0o7756, operator.RIM)) == 18
    assert [machine.core[address] for address in range(0o7756, 0o7777)] == octal(CARD)


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


def test_boot_from_cold() -> None:
    program = assembly("eia")
    machine = Machine()
    machine.panel.mem_prot = True
    steps = list(Operator(machine).boot(bin_tape(), program.tape, "eia.bin"))
    assert {address: machine.core[address] for address in program.words} == program.words
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
    assert machine.panel.lamps.run == 0


@pytest.mark.parametrize("after", ["200 000 000", "200 " * 64 + "000 000 000 000 101 076 076 101 000 177"])
def test_what_follows_a_rim_tapes_trailer_stays_out_of_core(after: str) -> None:
    """The RIM loader knows no end: to it blank tape is 0000 for 0000, and 101 076 076 101 a word for 0176."""
    machine = Machine()
    tape = rim.encode({0: 0o2222, 0o176: 0o1111, 0o200: 0o7402}).rstrip(b"\200")
    done = list(Operator(machine).boot(bin_tape(), tape + bytes(octal(after))))[-1]
    assert [machine.core[address] for address in (0, 0o176, 0o200)] == [0o2222, 0o1111, 0o7402]
    assert (done.frames, done.words, done.missing) == (len(tape) + after.count("200"), 3, 0)
    assert done.what == "program read by RIM"


@pytest.mark.parametrize("gap", ["000 000", "000 000 200 000 000 000", "200"])
def test_blank_tape_between_sections_is_passed_over(gap: str) -> None:
    """The loader would take it for words of 0000 and its leader for their trailer."""
    machine = bin_machine()
    machine.core[0o201] = 0o5252
    first, second = binary.encode({0o200: 0o1111}), binary.encode({0o300: 0o2222})
    done = Operator(machine).read_bin(first + bytes(octal(gap)) + second)
    assert list(machine.core)[0o200:0o202] == [0o1111, 0o5252]
    assert machine.core[0o300] == 0o2222
    skipped = len(first) - len(first.rstrip(b"\200")) - 1 if "000" in gap else -len(octal(gap))
    frames = len(first) + len(second.rstrip(b"\200")) + 1 - skipped
    assert (done.frames, done.sections, done.words) == (frames, 2, 2)
    assert " frames, 2 sections, 2 words; " in str(done)


def test_the_switches_are_set_anew_before_start() -> None:
    machine = Machine()
    machine.load({0o200: 0o7604, 0o201: 0o7402})  # LAS, HLT
    assert Operator(machine).start(0o200, 0o1234).reason == "halt"
    assert machine.ac == 0o1234


def test_a_word_where_the_loader_keeps_its_own_is_counted_as_missing() -> None:
    """7622 is where FRAME of the BIN loader keeps the address it returns to."""
    done = Operator(bin_machine()).read_bin(binary.encode({0o200: 0o1111, 0o7622: 0o5252}), "low.bin")
    assert (done.words, done.missing) == (1, 1)
    assert ", 1 word, 1 more not in core; " in str(done)


def test_words_to_the_end_of_core_and_messages_between_rubouts() -> None:
    tape = binary.encode({0o7577: 1, 0o17: 0o7777, 0: 0o4000})
    at = len(tape) - 64 - 2  # before the checksum
    noisy = tape[:at] + b"\377 IR  0307\377" + tape[at:]
    machine = bin_machine()
    Operator(machine).read_bin(noisy)
    assert (machine.core[0o7577], machine.core[0o17], machine.core[0]) == (1, 0o7777, 0o4000)


@pytest.mark.parametrize("frame", range(64, 74))
def test_a_wrong_hole_shows_in_the_checksum(frame: int) -> None:
    tape = bytearray(binary.encode({0o200: 0o1234, 0o201: 0o4321, 0o202: 0o7402}))
    tape[frame] ^= 0o001
    with pytest.raises(LoadError, match="wrong checksum"):
        Operator(bin_machine()).read_bin(bytes(tape), "torn.bin")


@pytest.mark.parametrize("tape", [binary.encode({0o200: 0o1234, 0o201: 0o4321})[:68], b"\0", b""])
def test_a_tape_cut_short(tape: bytes) -> None:
    with pytest.raises(LoadError, match=r"torn.bin: the BIN loader ended with tape out"):
        Operator(bin_machine()).read_bin(tape, "torn.bin")
    with pytest.raises(LoadError, match=r"^tape: the BIN loader ended with tape out"):
        Operator(bin_machine()).read_bin(tape)
    with pytest.raises(LoadError, match=r"^tape: the RIM loader ended with idle"):
        Operator(Machine()).read_rim(tape)


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


@pytest.mark.parametrize(("frames", "loaded"), [(72, 2), (70, 1), (66, 0)])
def test_a_tape_cut_short_is_loaded_as_far_as_the_loader_got_if_forced(frames: int, loaded: int) -> None:
    """The loader keeps a word back until the frames after it show that it is not the checksum."""
    tape = binary.encode({0o200: 0o1234, 0o201: 0o4321})
    machine = bin_machine()
    done = Operator(machine).read_bin(tape[:frames], "torn.bin", force=True)
    assert (done.frames, done.words) == (frames, loaded)
    assert not machine.panel.lamps.run
    assert list(machine.core)[0o200:0o202] == [0o1234, 0o4321][:loaded] + [0] * (2 - loaded)


def test_a_second_section_without_an_end_is_read_if_forced() -> None:
    first, second = binary.encode({0o200: 0o1111}), binary.encode({0o300: 0o2222})
    machine = bin_machine()
    assert Operator(machine).read_bin(first + second[:70], force=True).sections == 2
    assert machine.core[0o300] == 0o2222


@pytest.mark.parametrize("force", [False, True])
def test_a_loader_that_does_not_read_has_loaded_nothing(force: bool) -> None:
    """The words of another program are no loader; where they halt with AC = 0, the sum seems good."""
    machine = Machine()
    machine.load({0o7777: 0o5300, 0o7700: 0o7402})
    with pytest.raises(LoadError, match="halted and had not read the tape"):
        Operator(machine).read_bin(binary.encode({0o200: 0o1234}), "x.bin", force)


def test_a_loader_slower_than_its_limit_is_named_with_the_limit_and_the_way_on() -> None:
    tape = binary.encode({0o200: 0o1234})
    machine = Machine()
    machine.load({0o7777: 0o5300, 0o7700: 0o2010, 0o7701: 0o5300, 0o7702: 0o5300})
    with pytest.raises(LoadError) as error:
        Operator(machine).read_bin(tape, "slow.bin")
    seconds = 60 + 2 * len(tape) / 10
    said = str(error.value)
    assert f"did not end within 1 min {seconds - 60:.1f} s, a minute and twice what its tape takes" in said
    assert "pdp8 run LOADER --start 7777 --sr 7777 --reader TAPE --save FILE" in said


def test_the_high_speed_reader_by_switch_0_down() -> None:
    machine = bin_machine(highspeed=True)
    machine.highspeed.reader.load(binary.encode({0o200: 0o1234}))
    machine.sr = operator.HIGH_SPEED_READER
    machine.start(operator.BIN_START)
    assert machine.run().reason == "halt"
    assert (machine.ma, machine.ac, machine.core[0o200]) == (0o7700, 0, 0o1234)
    assert machine.elapsed < 1


@pytest.mark.parametrize("words", [{0o10000: 0}, {-1: 0}])
def test_what_does_not_fit_into_core(words: dict[int, int]) -> None:
    machine = Machine()
    with pytest.raises(LoadError):
        machine.load({0o300: 1} | words)
    assert list(machine.core) == [0] * 0o10000
