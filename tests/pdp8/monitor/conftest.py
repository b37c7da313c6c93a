"""A monitor, and what it says."""

import pytest

from pdp8.monitor.prompt import Monitor


@pytest.fixture
def said() -> list[str]:
    return []


@pytest.fixture
def monitor(said: list[str]) -> Monitor:
    return Monitor(said.append)
