"""Quantities in words and on drawings."""

import pytest

from tapes.measure import duration, inches


@pytest.mark.parametrize(
    ("thousandths", "written"),
    [
        (0, ".0000"),
        (0.7, ".0007"),
        (10.6, ".0106"),
        (1250, "1.2500"),
        (10_600, "10.6000"),
        (20_000, "20.0000"),
        (10_500.04, "10.5000"),
        (-4.6, "-.0046"),
        (-10_600, "-10.6000"),
        (-0.01, "-.0000"),
    ],
)
def test_lengths_are_written_as_on_drawings(thousandths: float, written: str) -> None:
    assert inches(thousandths) == written


@pytest.mark.parametrize(
    ("seconds", "written"),
    [
        (0, "0.0 s"),
        (59.94, "59.9 s"),
        (60, "1 min 0.0 s"),
        (3599.96, "1 h 0 min 0.0 s"),
        (1798.2, "29 min 58.2 s"),
        (3723, "1 h 2 min 3.0 s"),
    ],
)
def test_durations_are_written_in_hours_minutes_and_seconds(seconds: float, written: str) -> None:
    assert duration(seconds) == written
