"""The tapes of the exercise `loader`: any address, any words, and their sum, now and then a wrong one."""

from collections.abc import Sequence
from random import Random
from typing import Any


def tape(random: Random, case: dict[str, Any]) -> dict[str, Any]:
    """Return a tape in the reader, and what it leaves in core and in the AC."""
    address = random.randrange(0o1000, 0o7000)
    words = [random.getrandbits(12) for _ in range(random.randint(1, 12))]
    short = random.choice((0, 0, random.getrandbits(12)))
    frames = _frames((address, len(words), *words, sum(words) + short & 0o7777))
    around = {f"{address - 1:04o}": 0o1111, f"{address + len(words):04o}": 0o1111}
    core = {f"{address + at:04o}": word for at, word in enumerate(words)}
    leader = [0o200] * random.randint(0, 5)
    return {**case, "reader": leader + frames, "deposit": around, "core": around | core, "ac": short}


def _frames(words: Sequence[int]) -> list[int]:
    return [half for word in words for half in (word >> 6, word & 0o77)]
