"""What is expected in the exercise `itself`."""

from random import Random
from typing import Any


def itself(random: Random, case: dict[str, Any]) -> dict[str, Any]:
    """Return that the tape must be the program, whatever has been drawn."""
    return {**case, "itself": True, "seconds": 60}
