"""The times of the exercise `delay`."""

from random import Random
from typing import Any


def time(random: Random, case: dict[str, Any]) -> dict[str, Any]:
    """Draw hundredths of a second for the switches; the delay may be one percent shorter or longer."""
    hundredths = random.randint(1, 40)
    return {**case, "sr": hundredths, "takes": [hundredths * 0.0099, hundredths * 0.0101]}
