"""A run in slices is the run at once, and whoever looks on in between can end it."""

from itertools import count, islice

import pytest

from pdp8.computer.stop import Reason
from tests.pdp8.computer.bench import machine

COUNT = "7001 5200"
DELAY = "2300 5200 5200"
WAIT = "6031 5200 7402"


def test_in_slices_as_at_once() -> None:
    whole, sliced = (machine("6031 5200 6036 6046 6041 5204 5200", bytes(range(1, 40))) for _ in range(2))
    stops = list(sliced.slices(longest=0.5))
    assert stops[-1] == whole.run()
    assert {stop.reason for stop in stops[:-1]} == {Reason.LIMIT}
    assert len(stops) > 5
    assert (sliced.ticks, sliced.instructions) == (whole.ticks, whole.instructions)


@pytest.mark.parametrize("longest", [0.01, 0.3, 60.0])
def test_the_limit_is_that_of_all_slices_together(longest: float) -> None:
    m = machine(DELAY)
    *_, stop = m.slices(1.5, longest=longest)
    assert stop.reason is Reason.LIMIT
    assert m.ticks == pytest.approx(30_000_000, abs=64)


@pytest.mark.parametrize(
    ("seconds", "bounds", "elapsed"),
    [
        (0, (0.05, 60), (1, 3, 7, 15)),
        (1, (0.05, 60), (1, 1.5, 1.75, 1.875)),
        (1, (0.05, 0.01), (0.01, 0.02, 0.03, 0.04)),
    ],
)
def test_a_slice_is_twice_or_half_as_long_after_one_that_took_so_many_seconds(
    seconds: int, bounds: tuple[float, float], elapsed: tuple[float, ...], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pdp8.computer.machine.monotonic", count(0, seconds).__next__)
    m = machine(DELAY)
    ends = [m.elapsed for _ in islice(m.slices(None, *bounds), 4)]
    assert ends == pytest.approx(elapsed, abs=1e-4)


def test_stop_between_two_slices_ends_the_run_with_the_frame_on_its_way_printed() -> None:
    """TLS, IAC, JMP .-1."""
    m = machine("6046 7001 5201")
    reasons = []
    for stop in m.slices(longest=0.01):
        reasons.append(str(stop.reason))
        if len(reasons) == 3:
            m.stop()
    assert reasons == ["limit", "limit", "limit", "stop key"]
    assert m.teletype.punch.tape == b"\0"


@pytest.mark.parametrize("first", [0o200, 0o201])
def test_a_breakpoint_where_a_slice_ends(first: int) -> None:
    """In slices of one instruction: a slice ends before each of both."""
    m = machine(COUNT)
    m.watch.breakpoints.add(first)
    *_, stop = m.slices(longest=1e-6, shortest=1e-6)
    assert (stop.reason, stop.pc) == (Reason.BREAKPOINT, first)


def test_a_wait_for_a_key_ends_the_run_or_is_waited_through() -> None:
    m, reasons = machine(WAIT), []
    assert [stop.reason for stop in m.slices()] == [Reason.IDLE]
    for stop in m.slices(through_waits=True):
        reasons.append(stop.reason)
        if len(reasons) == 3:
            m.teletype.keyboard.press(b"\301")
    assert reasons == [Reason.IDLE] * 3 + [Reason.HALT]


def test_a_run_through_waits_ends_with_its_time() -> None:
    m, seen = machine(WAIT), 0
    for _ in m.slices(2.0, through_waits=True):
        seen += 1
        m.wait(0.3)
    assert m.elapsed == pytest.approx(2.1, abs=0.2)
    assert seen == 7
