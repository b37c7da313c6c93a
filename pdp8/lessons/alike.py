"""Which answers of a class look alike: a hint to the teacher, and no proof.

Comments, blanks and the names of tags do not count: tags are numbered as they come. How alike two answers are
is the share of runs of five items that both have, of all that either has. In a class of six or more, a run
that more than a third of the answers have is left out: the exercise asks for it. Long answers that are
identical are named in any class, each with the first of them.

Source: Schleimer, Wilkerson, Aiken: Winnowing, SIGMOD 2003, for the runs and for leaving out the common ones.
"""

from collections import Counter
from collections.abc import Sequence
from itertools import combinations
from typing import NamedTuple

from pal.symbols import PERMANENT
from pdp8.lessons.answer import Answer, parted
from tapes.text import lines_of

_RUN = 5
_LEAST = 12
"""Runs that an answer must have beside the common ones: short programs are all alike."""
_LONG = 25
"""Runs of an answer of a dozen lines: two answers as long are not identical by chance."""
_CLASS = 6
_ALIKE = 0.7
_OWN = frozenset(each.mnemonic for each in PERMANENT)


class Pair(NamedTuple):
    """Two answers, and the share of them that is the same, 0 to 1."""

    one: str
    other: str
    shared: float


def pairs(answers: Sequence[Answer]) -> list[Pair]:
    """Return the pairs that look alike, the likest first."""
    runs = {answer.name: _runs(answer.source) for answer in answers if answer.source}
    first: dict[frozenset[tuple[str, ...]], str] = {}
    long = {name: frozenset(found) for name, found in runs.items() if len(found) >= _LONG}
    copied = {name: first.setdefault(found, name) for name, found in long.items()}
    pairs = [Pair(one, name, 1.0) for name, one in copied.items() if one != name]
    if len(runs) >= _CLASS:
        often = Counter(run for found in runs.values() for run in found)
        common = {run for run, count in often.items() if count > max(2, len(runs) // 3)}
        runs = {name: found - common for name, found in runs.items()}
    for one, other in combinations([name for name in runs if len(runs[name]) >= _LEAST], 2):
        shared = len(runs[one] & runs[other]) / len(runs[one] | runs[other])
        if shared >= _ALIKE and copied.get(one, one) != copied.get(other, other):
            pairs.append(Pair(one, other, shared))
    return sorted(pairs, key=lambda pair: -pair.shared)


def _runs(source: str) -> set[tuple[str, ...]]:
    items = _plain(source)
    return {tuple(items[at : at + _RUN]) for at in range(len(items) - _RUN + 1)}


def _plain(source: str) -> list[str]:
    """Return the items of a source, its tags as they come: t0, t1, ..."""
    tags: dict[str, str] = {}
    items = []
    for line in lines_of(source):
        for item in parted(line.partition("/")[0]):
            tag = item[0].isalpha() and item not in _OWN
            items.append(tags.setdefault(item, f"t{len(tags)}") if tag else item)
    return items
