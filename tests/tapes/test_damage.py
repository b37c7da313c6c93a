"""Every damaged frame is named, none invented, none mended in silence, on tapes whose damage is known."""

import pytest

from tests.sampling import some
from tests.tapes.damage import survey


def _judge(count: int, seed: int) -> None:
    found, faults = survey(count, seed)
    assert faults == []
    assert found["damaged"] >= count / 4
    assert found["rightly"] >= 0.9 * found["proposed"] >= 0.7 * found["of a wrong hole"]


def test_some_tapes() -> None:
    _judge(200, 60)


@pytest.mark.slow("2,000 tapes by WHOLE=1")
def test_many_tapes() -> None:
    _judge(some(2000), 61)
