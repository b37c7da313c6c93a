"""The smallest situation that still fails: leave out acts and words, shorten runs, as long as it does."""

from collections.abc import Callable, Iterator, Sequence
from typing import Any, TypeVar

from tests.pdp8.computer.lockstep.situations import Act, Situation

Fails = Callable[[Situation], bool]
T = TypeVar("T")


def shrink(situation: Situation, fails: Fails) -> Situation:
    """Return a situation that fails as `situation` does, and of which nothing can be left out alone."""
    before = None
    while situation != before:
        before = situation
        situation = _fewer_acts(situation, fails)
        situation = _shorter_runs(situation, fails)
        situation = _fewer_words(situation, fails)
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


def _shorter_runs(situation: Situation, fails: Fails) -> Situation:
    for number, act in enumerate(situation.acts):
        if act.name != "run":
            continue
        for values in _shorter(*act.values):
            acts = (*situation.acts[:number], Act("run", values), *situation.acts[number + 1 :])
            shorter = situation._replace(acts=acts)
            if fails(shorter):
                situation = shorter
                break
    return situation


def _shorter(ticks: int | None, instructions: int) -> Iterator[tuple[Any, ...]]:
    """Yield shorter pieces, the shortest first."""
    counts = [count for count in (1, 2, 3, 5, 10, 30, 100, 1000, 10_000) if count < instructions]
    yield from ((None, count) for count in counts)
    if ticks is not None:
        yield None, instructions
        yield from ((ticks, count) for count in counts)
