"""The model of the M706 and M707 does what DEC's modules do, at the times that follow from their clocks."""

import random

import pytest

from tests.reference.gates import PARTS, UNIT, Gates

EIGHTH = UNIT // 8
KRS, TPC, TLS = 0o6034, 0o6044, 0o6046
IOP4 = 65
phases = pytest.mark.parametrize("d", [1, EIGHTH // 3, EIGHTH])


def tick(units: float, parts: int = 0) -> int:
    """Return the first tick at or after so many units and parts."""
    return -(-(round(units * UNIT) + parts) // PARTS)


def changes(gates: Gates, until: int) -> list[tuple[int, int, int, int]]:
    """Run to `until`; return each change: its tick, then both flags and READER RUN as they are then."""
    seen = []
    while (now := gates.run(until)) < until:
        seen.append((now, gates.receiver.flag, gates.transmitter.flag, gates.receiver.reader_run))
    return seen


def printer_flag(gates: Gates, until: int) -> list[tuple[int, int]]:
    """Run to `until`; return the ticks at which something changes, and the printer's flag then."""
    return [(now, flag) for now, _, flag, _ in changes(gates, until)]


def received(d: int, frames: bytes, wide_pulse: bool = False) -> Gates:
    """Return the model with keys pressed at tick 0, its clocks at phase `d`."""
    gates = Gates(phase=d, wide_pulse=wide_pulse)
    gates.type(frames)
    return gates


def line(gates: Gates, *edges: tuple[float, int]) -> None:
    """Put the receiver's line at a level at each of these times, in units."""
    for units, level in edges:
        changes(gates, tick(units))
        gates.sender.line = level


@phases
def test_a_character_is_received(d: int) -> None:
    seen = changes(received(d, b"\xff\x00"), 4_000_000)
    assert seen[:2] == [(tick(0, d), 0, 0, 0), (tick(8.375, d), 1, 0, 0)]
    assert [change[:2] for change in seen[2:]] == [(tick(11.375, d), 0), (tick(19.375, d), 1)]


@phases
@pytest.mark.parametrize("frame", [0o377, 0o000, 0o301, 0o125])
def test_the_start_unit_is_shifted_in_first(d: int, frame: int) -> None:
    gates = received(d, bytes([frame]))
    for shifts in range(10):
        at = tick(shifts - 1 + 3 / 8, d) if shifts else tick(0, d)
        if shifts:
            assert gates.iot(KRS, 0, at - 1 - IOP4) == ((frame << 9 | 0o377) >> shifts - 1) & 0o377
        assert gates.iot(KRS, 0o7000, at - IOP4) == 0o7000 | ((frame << 9 | 0o377) >> shifts) & 0o377


@phases
def test_stop_units(d: int) -> None:
    gates = received(d, b"\x55")
    r = gates.receiver
    seen: list[tuple[int, tuple[int, ...]]] = []
    for eighth in range(88):
        changes(gates, tick(eighth / 8, d))
        state = (r.active, r.spike, r.in_last_unit, r.stop_1, r.stop_2)
        if not seen or state != seen[-1][1]:
            seen.append((eighth, state))
    assert seen == [
        (0, (1, 1, 0, 0, 0)),
        (7, (1, 0, 0, 0, 0)),
        (67, (1, 0, 1, 0, 0)),
        (71, (0, 0, 1, 0, 0)),
        (75, (0, 0, 1, 1, 0)),
        (83, (0, 0, 0, 1, 1)),
    ]


def test_a_false_start() -> None:
    d = 1000
    gates = received(d, b"\x00")
    changes(gates, tick(10.7))
    r = gates.receiver
    assert r.flag
    r.reader_run = 1
    r.pulse_at = tick(20) * PARTS + d
    line(gates, (20, 0), (20.3, 1))
    assert (r.reader_run, r.flag, r.bits) == (0, 1, 0o377)
    assert changes(gates, tick(30)) == [(tick(20.375, d), 0, 0, 0)]
    assert (r.bits, r.active) == (0o377, 0)


@pytest.mark.parametrize("wide_pulse", [False, True])
@pytest.mark.parametrize("g", [9.1, 9.875, 10.125, 10.375])
def test_a_character_that_follows_early(g: float, wide_pulse: bool) -> None:
    """Its shifts come at n - 1 + 10 7/8 + d."""
    d = 2000
    gates = received(d, b"\x00", wide_pulse)
    line(gates, (9, 1), (g, 0))
    assert changes(gates, tick(10.875, d)) in ([(tick(10.875, d), 0, 0, 0)], [])
    line(gates, (g + 1, 1))
    assert changes(gates, tick(25))[-1][:2] == (tick(8 + 10.875, d), 1)
    assert gates.receiver.bits == 0o377


@phases
def test_initialize_in_a_character(d: int) -> None:
    gates = received(d, b"\xef")  # a space in unit 5, 5.0 to 6.0
    changes(gates, tick(3.2))
    gates.initialize(tick(3.2))
    r = gates.receiver
    assert (r.active, r.flag, r.reader_run, r.bits) == (0, 0, 1, ((0o357 << 9 | 0o377) >> 3) & 0o377)
    start = 5 * UNIT + d  # the eighths of a unit before it keep their phase
    assert changes(gates, tick(30)) == [(tick(0, start), 0, 0, 0), (tick(8.375, start), 1, 0, 0)]
    assert r.bits == 0o377


def test_initialize_in_the_stop_units() -> None:
    d = 100
    gates = received(d, b"\xef")
    changes(gates, tick(8.5))
    gates.initialize(tick(8.5))
    for until, last in ((tick(8.5), 1), (tick(10.375, d) - 1, 1), (tick(10.375, d), 0)):
        changes(gates, until)
        assert gates.receiver.in_last_unit == last


def loaded(word: int, *loads: tuple[float, int]) -> Gates:
    """Return the model after IOT `word`, with another frame each time, at these times in units."""
    gates = Gates()
    for units, frame in loads:
        changes(gates, tick(units))
        gates.iot(word, frame, tick(units) - IOP4)
    return gates


def sent(gates: Gates, since: float, units: int) -> list[int]:
    """Return the line's level in the middle of each unit."""
    levels = []
    for number in range(units):
        changes(gates, tick(since + number + 0.5))
        levels.append(gates.transmitter.line)
    return levels


def bits(frame: int) -> list[int]:
    return [frame >> place & 1 for place in range(8)]


@pytest.mark.parametrize("delay", [0.01, 0.25, 0.49])
def test_a_character_is_sent(delay: float) -> None:
    gates = Gates(phase=round(delay * UNIT) + IOP4 * PARTS)
    gates.iot(TLS, 0o7123, 0)
    start = delay + IOP4 * PARTS / UNIT
    assert sent(gates, start, 9) == [0, *bits(0o123)]
    assert changes(gates, tick(start + 10)) == [(tick(start + 9), 0, 1, 1)]
    gates.iot(TPC, 0o045, tick(start + 10.9))  # at rest for the clock only from 11.0 on
    assert sent(gates, start + 10, 12) == [1, 0, *bits(0o045), 1, 1]
    assert gates.printed() == bytes([0o123, 0o045])


def test_a_flag_that_stands_falls_at_the_first_shift() -> None:
    gates = loaded(TPC, (0, 0), (22, 0))
    assert gates.transmitter.flag
    assert printer_flag(gates, tick(35)) == [(tick(23), 0), (tick(31), 1)]


@pytest.mark.parametrize("again", [9.0, 9.3, 10.4, 10.6, 10.99])
def test_back_to_back(again: float) -> None:
    assert printer_flag(loaded(TLS, (0, 0), (again, 0)), tick(30))[-1] == (tick(20), 1)


@pytest.mark.parametrize("shifts", range(9))
def test_a_load_while_busy(shifts: int) -> None:
    for _ in range(20):
        old, new = random.randrange(256), random.randrange(256)
        garbled = ((0, old), (shifts + 0.6, new))
        rest = (old | 0o400) >> shifts | new
        assert sent(loaded(TPC, *garbled), shifts, 12)[1:] == [*bits(rest), 1, 1, 1]
        assert printer_flag(loaded(TPC, *garbled), tick(30)) == [(tick(9 + shifts), 1)]
        assert sent(loaded(TPC, *garbled, (9.5 + shifts, 0)), 10 + shifts, 3) == [1, 0, 0]


@pytest.mark.parametrize(
    ("at", "next_start"),
    [(0.2, 0.5), (0.49, 0.5), (0.51, 2.5), (0.99, 2.5), (1.01, 3), (8.9, 10.5), (9.1, 11), (10.9, 11)],
)
def test_initialize_while_sending(at: float, next_start: float) -> None:
    gates = loaded(TPC, (0, 0))
    changes(gates, tick(at))
    gates.initialize(tick(at))
    assert gates.transmitter.line == 1
    gates.iot(TPC, 0, tick(at) - IOP4)
    changes(gates, tick(next_start) - 1)
    assert gates.transmitter.line == 1
    changes(gates, tick(next_start))
    assert gates.transmitter.line == 0
    assert printer_flag(gates, tick(30)) == [(tick(next_start + 9), 1)]
