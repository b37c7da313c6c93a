"""What a machine has done is undone exactly: over tapes, waits, interrupts, and whatever was set between."""

import json
from collections.abc import Callable
from contextlib import suppress
from itertools import pairwise
from typing import Any, NamedTuple

import pytest

from pdp8.computer.count import Count
from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind, state
from pdp8.computer.past.history import History, HistoryError
from pdp8.computer.stop import Reason, Stop
from pdp8.computer.use import goals
from pdp8.monitor import debugging
from pdp8.monitor.prompt import Monitor
from tests.conftest import case
from tests.pdp8.computer.bench import machine

# CLA, TAD 30, CMA, DCA 30, TAD 30, TLS, TSF, JMP .-1, JMS 220, JMP 200: prints and punches 200 and 177 in
# turn, and counts them at 0031; a key is read, KRB
PRINTS = "7200 1030 7040 3030 1030 6046 6041 5206 4220 6031 5200 6036 5200 220/ 0 2031 5620 30/ 7577"
COUNTER = "7001 2040 5201 2041 5201 5200"  # IAC, ISZ 40, JMP .-1, ISZ 41, JMP .-3, JMP 0200


def saved(machine: Machine) -> dict[str, Any]:
    """Return the saved state; `writes` is a stamp, of which it matters only whether waiting has the same."""
    saved: dict[str, Any] = json.loads(state.save(machine))
    saved["unwritten"] = saved["processor"].pop("writes") == saved["waiting"].pop("writes")
    return saved


def recorded(words: str, memory: int = 1 << 26) -> tuple[Machine, History]:
    made = machine(words)
    return made, History(made, memory)


class Moment(NamedTuple):
    """What there was to see after so many instructions as the moment's place in its list has it."""

    clock: int
    pc: int
    core: tuple[int, int]
    printed: int
    blocks: int
    keyboard_flag: int


def moment(m: Machine) -> Moment:
    blocks = m.teletype.punch.frames.count(0o200)
    seen = len(m.teletype.printer.frames), blocks, m.teletype.receiver.flag
    return Moment(m.processor.clock, m.pc, (m.core[0o30], m.core[0o31]), *seen)


@pytest.fixture(scope="module")
def moments() -> list[Moment]:
    """PRINTS for 0.35 s, instruction by instruction; a key is pressed at 0.15 s, a tape cut off at 0.19 s."""
    m = machine(PRINTS)
    found = [moment(m)]
    while m.ticks < 7_000_000:
        if found[-2:][0].clock < 3_000_000 <= m.ticks:
            m.teletype.keyboard.press(b"A")
            m.bus.advance(m.processor.clock)
        if found[-2:][0].clock < 3_800_000 <= m.ticks:
            m.teletype.punch.frames.clear()
        m.processor.instruction()
        m.bus.advance(m.processor.clock)
        found.append(moment(m))
    return found


def printed_and_recorded() -> tuple[Machine, History]:
    m, history = recorded(PRINTS)
    for until in (2_000_000, 3_000_000, 3_800_000, 6_000_000, 7_000_000):
        m.run(seconds=(until - m.ticks) / 20_000_000)
        m.teletype.keyboard.press(b"A" if until == 3_000_000 else b"")
        if until == 3_800_000:
            m.teletype.punch.frames.clear()
    return m, history


def test_each_way_back_ends_at_its_moment(moments: list[Moment]) -> None:
    """One is undone where no number is named."""
    now, end = len(moments) - 1, moments[-1]

    def last(matches: Callable[[Moment, Moment], bool]) -> int:
        return next(n for n in range(now - 1, -1, -1) if matches(moments[n], moments[n + 1]))

    def fewer(name: str, undone: int) -> int:
        return last(lambda one, _: getattr(one, name) <= getattr(end, name) - undone)

    def first(clock: float) -> int:
        return next(number for number, one in enumerate(moments) if one.clock >= clock)

    ways: list[tuple[Callable[..., None], Any, int]] = [
        *((rewind.instructions, n, now - n) for n in (0, 1, 2, 1000, now - 1, now)),
        *((rewind.characters, n, fewer("printed", n)) for n in (1, 2, 3)),
        (rewind.blocks, 1, fewer("blocks", 1)),
        *((rewind.seconds, s, first(end.clock - s * 20_000_000)) for s in (0.0, 0.05, 0.151, 0.3)),
        (rewind.characters, 0, now),
        (rewind.until_left, 0o206, last(lambda one, _: one.pc == 0o206)),
        (rewind.until_left, 0o210, last(lambda one, _: one.pc == 0o210)),
        (rewind.until_left, 0o220, last(lambda one, _: one.pc == 0o210) + 1),
        (rewind.until_written, 0o30, last(lambda one, after: one.core[0] != after.core[0])),
        (rewind.until_written, 0o31, last(lambda one, after: one.core[1] != after.core[1])),
        (rewind.until_flag, 0o03, last(lambda one, after: one.keyboard_flag < after.keyboard_flag) + 1),
    ]
    for way, value, number in ways:
        with case(way.__name__, value):
            m, history = printed_and_recorded()
            assert moment(m) == end
            way(history, *([] if value == 1 else [value]))
            assert (m.instructions, moment(m)) == (number, moments[number])
            m.run(instructions=now - number)
            assert moment(m) == end or moments[number].clock <= 3_800_000


def test_what_cannot_be_undone_leaves_the_machine_as_it_is() -> None:
    m, history = printed_and_recorded()
    was = saved(m)
    for way, value, message in (
        (
            rewind.instructions,
            10**9,
            r"1,000,000,000 instructions cannot be undone: the history goes back \d",
        ),
        (rewind.cycles, 10**9, r"1,000,000,000 cycles cannot be undone: the history goes back \d"),
        (rewind.seconds, 9, r"9 seconds cannot be undone: the history goes back 0\.35"),
        (rewind.characters, 9, r"9 characters cannot be undone: the history goes back \d"),
        (rewind.blocks, 3, r"3 blocks cannot be undone: the history goes back 1"),
        (rewind.blocks, -1, r"-1 blocks cannot be undone"),
        (rewind.until_written, 0o7000, "nothing was written at 7000 as far as the history goes back"),
        (rewind.until_left, 0o7000, "nothing was executed at 7000 as far"),
        (rewind.until_flag, 0o01, "device 01 is not fitted"),
    ):
        with pytest.raises(HistoryError, match=f"^{message}"):
            way(history, value)
        assert saved(m) == was
    with pytest.raises(HistoryError, match=r"^1 instruction cannot be undone: the history goes back 0$"):
        rewind.instructions(History(Machine()), 1)


def test_characters_are_undone_over_many_snapshots_and_no_further_than_the_history_goes() -> None:
    m = machine(PRINTS)
    m.run(seconds=1)
    before = len(m.teletype.printer.frames)
    history = History(m)
    for _ in range(16):
        m.run(seconds=1)
    assert len(history.snapshots()) > 2
    printed = len(m.teletype.printer.frames)
    with pytest.raises(
        HistoryError, match="characters cannot be undone: the history does not go back so far"
    ):
        rewind.characters(history, printed - before + 1)
    for count in (1, 60, printed - before - 61):
        printed -= count
        rewind.characters(history, count)
        assert len(m.teletype.printer.frames) == printed
        m.run(instructions=1)
        assert len(m.teletype.printer.frames) == printed + 1
        rewind.instructions(history)


def test_cycles_back_stand_within_an_instruction() -> None:
    m, history = recorded(PRINTS)
    m.run(seconds=0.1)
    stood = []
    for _ in range(12):
        stood.append(saved(m)["processor"])
        m.processor.cycle()
    rewind.cycles(history, 5)
    within, done = saved(m), m.instructions
    assert within["processor"] == stood[7]
    m.run(instructions=3)
    rewind.instructions(history, m.instructions - done)
    assert saved(m) == within
    for undone, at in ((0, 7), (1, 6), (6, 0)):
        rewind.cycles(history, undone)
        assert saved(m)["processor"] == stood[at]
    m, history = recorded("2030")  # ISZ 30
    m.run(instructions=1)
    rewind.cycles(history, 2)
    assert (m.instructions, m.core[0o30]) == (0, 0)


def test_a_search_runs_no_further_than_to_where_cycles_back_led() -> None:
    """DCA 30, IAC, JMP .-2: the second DCA is left in the middle."""
    m, history = recorded("3030 7001 5200")
    m.run(instructions=2)
    for _ in range(3):
        m.processor.cycle()
    rewind.cycles(history, 1)
    m.pc = 0o201
    m.run(instructions=1)
    rewind.until_written(history, 0o30)
    assert m.instructions == 0


@pytest.mark.parametrize(("back", "ticks"), [(10 * 32 + 5, 10 * 32), (10 * 32 - 1, 11 * 32)])
def test_what_was_set_as_an_instruction_ended_is_set_there_again(back: int, ticks: int) -> None:
    m, history = recorded("7000 " * 30)
    for sr in (0o17, 0o4000):
        m.run(instructions=10)
        m.sr = sr
    rewind.seconds(history, back / 20_000_000)
    assert (m.ticks, m.sr) == (ticks, 0o17)


def counted(monitor: Monitor) -> None:
    with monitor.machine.count():
        monitor.machine.run(instructions=3)


LOOKS: dict[str, Callable[[Monitor], object]] = {
    "instructions": lambda monitor: rewind.instructions(monitor.history, 50_000),
    "cycles": lambda monitor: rewind.cycles(monitor.history, 3),
    "seconds": lambda monitor: rewind.seconds(monitor.history, 0.1),
    "characters": lambda monitor: rewind.characters(monitor.history),
    "until_left": lambda monitor: rewind.until_left(monitor.history, 0o206),
    "until_written": lambda monitor: rewind.until_written(monitor.history, 0o30),
    "until_flag": lambda monitor: rewind.until_flag(monitor.history, 0o04),
    "back to nothing": lambda monitor: rewind.until_left(monitor.history, 0o7000),
    "explained": lambda monitor: monitor.explained(Stop(Reason.LIMIT, monitor.machine.pc, 0.0)),
    "step": lambda monitor: debugging.step(monitor, "2"),
    "cycle": lambda monitor: debugging.cycle(monitor, "2"),
    "a goal": lambda monitor: goals.until(monitor.machine, "address", 0o206).over(),
    "a goal at a breakpoint": lambda monitor: goals.until(monitor.machine, "address", 0o205).over(),
    "a word": lambda monitor: goals.until(monitor.machine, "word", 0o30).over(),
    "count": counted,
}
"""What uses a machine's watch, or lets it run where nobody is to notice."""


def test_who_looks_on_is_there_again_after_another_has_looked() -> None:
    """Breakpoints, watched words, an observer, the history, and who hears what is printed and punched."""
    for name, look in LOOKS.items():
        monitor = Monitor(lambda line: None, machine(PRINTS))
        m, watch = monitor.machine, monitor.machine.watch
        m.run(seconds=0.25)
        heard: list[int] = []
        m.teletype.punch.on_frame = m.teletype.printer.on_frame = heard.append
        watch.breakpoints, watch.writes, watch.observer = {0o205}, {0o40}, Count()

        def seen(m: Machine = m) -> list[object]:
            points = [{*each} for each in (m.watch.breakpoints, m.watch.writes, m.watch.reads)]
            listeners = [m.teletype.punch.on_frame, m.teletype.printer.on_frame]
            return [m.watch, m.watch.observer, m.recorder, *points, *listeners]

        before = seen()
        with case(name), suppress(HistoryError):
            look(monitor)
        with case(name):
            assert (seen(), [*heard], m.run().pc) == (before, [], 0o205)


def test_after_an_error_within_runs_that_are_one_what_follows_is_recorded() -> None:
    m, history = recorded(COUNTER)

    def fails() -> str:
        m.run(instructions=3)
        raise ValueError("an error")

    with pytest.raises(ValueError, match="an error"):
        history.together(fails)
    m.sr = 0o1234
    m.run(instructions=2)
    was = saved(m)
    m.run(instructions=2)
    rewind.instructions(history, 2)
    assert saved(m) == was


def test_the_memory_is_bounded_and_the_oldest_past_forgotten() -> None:
    m, history = recorded(COUNTER, memory=200_000)
    for _ in range(400):
        m.run(seconds=1)
    assert 100_000 < history.size <= 200_000
    assert 10 < history.seconds < 110
    was = saved(m)
    rewind.seconds(history, history.seconds)
    with pytest.raises(HistoryError, match="1 instruction cannot be undone: the history goes back 0"):
        rewind.instructions(history)
    assert saved(m) != was
    m, history = recorded(COUNTER, memory=1)  # the newest snapshot is kept, whatever it takes
    m.run(seconds=6)
    m.run(seconds=1)
    assert history.seconds == pytest.approx(1, abs=1e-5)
    assert len(history.snapshots()) == 1


def test_many_snapshots_are_thinned_out() -> None:
    m, history = recorded(COUNTER)
    m.run(instructions=1000)
    was = saved(m)

    def apart() -> list[float]:
        return [(late.clock - soon.clock) / 20_000_000 for late, soon in pairwise(history.snapshots())]

    while len(history.snapshots()) < 128:
        m.run(seconds=0.5)
    assert 5 <= min(apart()) <= max(apart()) < 5.6
    rewind.seconds(history, 20)  # as far apart go those that come after
    while len(history.snapshots()) < 128:
        m.run(seconds=0.5)
    assert 4.9 <= min(apart()) <= max(apart()) < 5.6
    while len(history.snapshots()) == 128:
        m.run(seconds=0.5)
    assert len(history.snapshots()) == 65
    assert 9.9 <= min(apart()) <= max(apart()) < 11.2
    rewind.instructions(history, m.instructions - 1000)
    assert saved(m) == was


def test_runs_between_which_nothing_was_set_take_no_memory() -> None:
    m, history = recorded(COUNTER)
    size = history.size
    for _ in range(3000):
        m.run(instructions=1)
    assert history.size == size
    rewind.instructions(history, 2999)
    assert m.instructions == 1


def test_what_is_set_between_two_snapshots_keeps_to_the_memory() -> None:
    m, history = recorded(COUNTER, memory=100_000)
    for number in range(1000):
        m.sr = number
        m.run(instructions=1)
        assert history.size <= 100_000
    rewind.instructions(history, 40)
    assert (m.instructions, m.sr) == (960, 960)


def test_what_a_breakpoint_has_finished_is_there_again() -> None:
    """TLS, IAC: the frame on its way is out when the run has ended, though no time has passed for it."""
    m, history = recorded("6046 7001 5201")
    m.watch.breakpoints.add(0o202)
    m.run()
    m.watch.breakpoints.clear()
    was = saved(m)
    was["waiting"] |= {"marks": [], "actions": -1}  # the breakpoint is no more as the next run begins
    assert m.teletype.punch.tape == b"\0"
    m.run(instructions=4)
    rewind.instructions(history, 4)
    assert saved(m) == was


def test_a_search_begins_before_where_the_machine_stands() -> None:
    m, history = recorded("7001 7001 5200")
    m.run(instructions=9)
    for number in (6, 3, 0):
        rewind.until_left(history, 0o200)
        assert (m.pc, m.instructions) == (0o200, number)


def test_a_history_that_is_closed_records_nothing() -> None:
    m, history = recorded("7001 5200")
    m.run(instructions=10)
    history.close()
    assert (m.recorder, history.size) == (None, 0)
    m.run(instructions=10)
    assert history.size == 0


def test_going_back_passes_what_is_idle() -> None:
    """Core of AND 0 and one JMP I 27 waits in vain, which the run that goes back may see sooner."""
    m = Machine()
    m.load({0o3521: 0o5427})
    history = History(m)
    m.watch.writes = {0o20}
    for instructions in (1000, 2000, 2000):
        assert m.run(instructions=instructions).reason == "limit"
    m.panel.stop()
    m.run(instructions=2)
    rewind.instructions(history, 2)
    assert (m.instructions, m.pc, m.processor.run) == (5000, 0o2344, 0)
