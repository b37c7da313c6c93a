"""How the parts of a machine say what a saved state holds of them.

    fields = saved(flag=BIT, due=TICK, buffer="377")

A class has `fields`: the name of each attribute, and how it is written.

    1, 2, ... an int    a decimal number, the largest it may be
    "377", "7777" ...   an octal number, the largest it may be
    TICK                a time in ticks of 0.05 us, `never`, or -1 for at once
    FRAMES              a tape, or whatever else is frames
    PART                an object with fields of its own
    CORE                a copy of core, or none
"""

from collections.abc import Mapping

BIT = 1
COUNT = 1 << 60
TICK, FRAMES, PART, CORE = "tick", "frames", "part", "core"


def saved(**fields: int | str) -> Mapping[str, int | str]:
    """Return the fields of a class."""
    return fields
