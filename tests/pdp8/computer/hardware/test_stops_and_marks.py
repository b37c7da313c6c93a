"""Why a run stops, what the PROTECT lamp shows, where breakpoints and watched words stop it."""

import pytest

from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import octal


def machine(words: str, **others: int) -> Machine:
    """Return a machine started at 0200 with `words` there; `at_20=0o7600` puts a word at 0020."""
    m = Machine()
    m.load(dict(enumerate(octal(words), 0o200)))
    m.load({int(address.removeprefix("at_"), 8): word for address, word in others.items()})
    m.start(0o200)
    return m


@pytest.mark.parametrize("word", ["7402", "7406", "7606", "7412", "7502"])
def test_every_word_with_the_hlt_bit_of_group_2_is_a_halt(word: str) -> None:
    assert machine(word).run().reason == "halt"


def test_a_stop_after_a_word_of_group_3_is_no_halt() -> None:
    """7403 has HLT's bit, in group 3."""
    m = machine("7403 5200")

    class Stopper:
        def cycle(self, processor: object, interrupt: bool) -> None:
            m.stop()

        def waited(self, processor: object, instructions: int, ticks: int) -> None:
            """Nothing is passed over."""

    m.watch.observer = Stopper()
    assert m.run().reason == "stop key"
    assert m.mb == 0o7403


def protected(by: str) -> Machine:
    """Return a machine that MEM PROT has stopped at DCA I 20, a NOP after it."""
    m = machine("3420 7000 7000 5203", at_20=0o7700)
    m.panel.mem_prot = True
    assert m.run().reason == "protect"
    assert m.panel.lamps.protect == 1
    if by == "cycles":
        m.panel.sing_step = True
    return m


@pytest.mark.parametrize("by", ["instructions", "cycles"])
def test_protect_goes_out_with_the_next_cycle(by: str) -> None:
    m = protected(by)
    m.run(instructions=1)
    assert m.panel.lamps.protect == 0


@pytest.mark.parametrize("key", ["load_add", "exam", "dep"])
def test_protect_goes_out_with_a_key(key: str) -> None:
    m = protected("instructions")
    getattr(m.panel, key)()
    assert m.panel.lamps.protect == 0


def stopped_by(m: Machine, *writes: int) -> str:
    m.watch.writes = set(writes)
    return m.run(instructions=3).reason.value


@pytest.mark.parametrize(
    ("words", "watched", "reason"),
    [
        ("3021 7000 7000", 0o21, "breakpoint"),  # DCA 21
        ("2021 7000 7000", 0o21, "breakpoint"),  # ISZ 21
        ("4021 7000 7000", 0o21, "breakpoint"),  # JMS 21
        ("1021 7000 7000", 0o21, "limit"),  # TAD 21 reads
        ("0021 7000 7000", 0o21, "limit"),  # AND 21 reads
        ("1421 7000 7000", 0o21, "limit"),  # TAD I 21 reads the pointer
        ("1410 7000 7000", 0o10, "breakpoint"),  # TAD I 10 increments it
        ("3410 7000 7000", 0o10, "breakpoint"),  # DCA I 10 writes the pointer first, then another word
    ],
)
def test_a_watched_word_stops_where_it_is_written(words: str, watched: int, reason: str) -> None:
    m = machine(words, at_10=0o300)
    assert stopped_by(m, watched) == reason
    assert m.instructions == (1 if reason == "breakpoint" else 3)


def test_a_watch_stops_once() -> None:
    m = machine("3021 7000 7000 7000 7000 5205")
    assert stopped_by(m, 0o21) == "breakpoint"
    assert stopped_by(m, 0o21) == "limit"


@pytest.mark.parametrize("observed", [False, True])
def test_a_jms_to_a_breakpoint_stops(observed: bool) -> None:
    """JMS 210: its first word, where the return address goes, is never executed."""
    m = machine("4210 7000", at_211=0o7000, at_212=0o5212)
    m.watch.breakpoints = {0o210}
    m.watch.writes = {0o7777} if observed else set()
    assert m.run(instructions=5).reason == "breakpoint"
    assert m.pc == 0o211


def test_a_tape_put_in_after_rfc_takes_its_time_from_then() -> None:
    """RFC at once, RSF, JMP .-1, HLT; the tape 3 ms later: a frame takes 3.3 ms."""
    m = Machine(highspeed=True)
    m.load(dict(enumerate(octal("6014 6011 5201 7402"), 0o200)))
    m.start(0o200)
    m.run(seconds=0.003)
    at = m.ticks
    m.highspeed.reader.load(b"a")
    assert m.run().reason == "halt"
    assert 66_667 <= m.ticks - at < 66_667 + 300


@pytest.mark.parametrize("at", [0o203, 0o7775, 0o7776, 0o7777])
@pytest.mark.parametrize("skip", [0o7410, 0o7440, 0o2020, 0o7610])
def test_a_breakpoint_after_a_skip_stops(skip: int, at: int) -> None:
    """NOP, the skip, and past the word it skips the breakpoint; after 7777 comes 0000."""
    m = Machine()
    m.load({at - 1: 0o7000, at: skip, **{at + on & 0o7777: 0o7001 for on in range(1, 4)}, 0o20: 0o7777})
    m.start(at - 1)
    m.watch.breakpoints = {at + 2 & 0o7777}
    assert m.run(seconds=0.01).reason == "breakpoint"
    assert (m.pc, m.instructions, m.ac) == (at + 2 & 0o7777, 2, 0)


def test_setting_pc_begins_with_a_fetch() -> None:
    """In the middle of TAD I 20."""
    m = machine("1420", at_20=0o30, at_30=5, at_300=0o7402)
    m.panel.sing_step = True
    m.run()
    m.panel.sing_step = False
    m.pc = 0o300
    assert m.run().reason == "halt"
    assert (m.ac, m.mb) == (0, 0o7402)


def test_a_protected_write_writes_nothing() -> None:
    m = machine("3420 7000", at_20=0o7700)
    m.panel.mem_prot = True
    m.watch.writes = {0o7700}
    m.watch.instruction(m.processor)
    assert not m.watch.reached
