"""What the machine is before an instruction: the same states for every word.

The first are edges: ends of pages and of core, autoindexes, sums that carry; the others are by chance, from a
fixed seed. Four states in a row differ in link and ION only, which keeps the files small. MEM PROT has states
of its own.
"""

import random
from collections.abc import Iterator
from typing import NamedTuple

LINK_AND_ION = ((0, 0), (1, 0), (1, 1), (0, 1))
_SEED = 1971


class State(NamedTuple):
    """The registers, and what the address refers to."""

    pc: int
    ac: int
    sr: int
    target: int
    """What an indirect address leads to."""
    operand: int
    """The word an instruction reads."""
    link: int = 0
    ion: int = 0


EDGES = (
    State(pc=0o0377, ac=0o0001, sr=0o5252, target=0o7600, operand=0o7777),
    State(pc=0o7777, ac=0o0000, sr=0o0001, target=0o0010, operand=0o0001),
    State(pc=0o0177, ac=0o4000, sr=0o7777, target=0o7577, operand=0o7776),
    State(pc=0o0010, ac=0o7777, sr=0o0000, target=0o7777, operand=0o7777),
    State(pc=0o7600, ac=0o3777, sr=0o4000, target=0o0000, operand=0o4000),
    State(pc=0o7577, ac=0o7776, sr=0o2525, target=0o0177, operand=0o0000),
    State(pc=0o0000, ac=0o5252, sr=0o7000, target=0o7777, operand=0o2525),
    State(pc=0o7770, ac=0o0100, sr=0o0377, target=0o7600, operand=0o3777),
    State(pc=0o0371, ac=0o0010, sr=0o0020, target=0o0377, operand=0o7770),
    State(pc=0o0017, ac=0o2000, sr=0o1000, target=0o0017, operand=0o6000),
    State(pc=0o0400, ac=0o6001, sr=0o3777, target=0o7677, operand=0o1777),
    State(pc=0o7776, ac=0o4001, sr=0o4001, target=0o7576, operand=0o7777),
)

PROTECTED = (
    State(pc=0o7600, ac=0o1234, sr=0, target=0o7577, operand=0o7777),
    State(pc=0o7777, ac=0o7777, sr=0, target=0o7600, operand=0o0000, link=1),
    State(pc=0o7776, ac=0o4000, sr=0, target=0o0000, operand=0o0000),
    State(pc=0o7640, ac=0o3777, sr=0, target=0o7677, operand=0o7776, ion=1),
    State(pc=0o7577, ac=0o5252, sr=0, target=0o7600, operand=0o0000, ion=1),
    State(pc=0o0200, ac=0o0001, sr=0, target=0o7777, operand=0o7777, link=1, ion=1),
    State(pc=0o0177, ac=0o0000, sr=0, target=0o7577, operand=0o7777, link=1, ion=1),
    State(pc=0o0010, ac=0o2525, sr=0, target=0o7616, operand=0o4000, link=1),
)
"""States with MEM PROT up: four in the page that it protects, and four beside it."""


def states(count: int) -> Iterator[list[State]]:
    """Yield `count` states, or up to three more, in lists of four that differ in link and ION only."""
    draw = random.Random(_SEED)
    for number in range(-(-count // len(LINK_AND_ION))):
        by_chance = number >= len(EDGES)
        state = State(*[draw.getrandbits(12) for _ in range(5)]) if by_chance else EDGES[number]
        yield [state._replace(link=link, ion=ion) for link, ion in LINK_AND_ION]
