"""The smallest situation that still fails: leave out acts and words as long as it does."""

from collections.abc import Callable, Sequence
from typing import TypeVar

from tests.pdp8.computer.lockstep.situations import Situation

Fails = Callable[[Situation], bool]
T = TypeVar("T")


def shrink(situation: Situation, fails: Fails) -> Situation:
    """Return a situation that fails as `situation` does, and of which nothing can be left out alone."""
    before = None
    while situation != before:
        before = situation
        situation = _fewer_words(_fewer_acts(situation, fails), fails)
    return situation


def _fewer_acts(situation: Situation, fails: Fails) -> Situation:
    acts = _fewer(situation.acts, lambda acts: fails(situation._replace(acts=tuple(acts))))
    return situation._replace(acts=tuple(acts))


def _fewer_words(situation: Situation, fails: Fails) -> Situation:
    words = _fewer(list(situation.words.items()), lambda words: fails(situation._replace(words=dict(words))))
    return situation._replace(words=dict(words))


def _fewer(items: Sequence[T], fails: Callable[[Sequence[T]], bool]) -> Sequence[T]:
    """Leave out halves of `items`, then quarters, and so on down to single ones."""
    size = len(items) // 2
    while size:
        start = 0
        while start < len(items):
            rest = [*items[:start], *items[start + size :]]
            if fails(rest):
                items = rest
            else:
                start += size
        size //= 2
    return items
