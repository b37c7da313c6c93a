"""Options alone and in pairs: a tenth of what `make options` tries, the same whatever others there are."""

from zlib import crc32

from tests.options.pairs import ACT, HIDDEN, REFUSED, Pair, declared, pairs, tried

OF_EVERY_PART = frozenset(declared()["part circle"])


def test_an_option_acts_or_is_refused_alone_and_beside_another() -> None:
    tenth = [pair for pair in pairs() if crc32(repr(pair).encode()) % 10 == 0 and not of_the_circle_too(pair)]
    found = {pair: tried(pair) for pair in tenth}
    assert {pair: how for pair, how in found.items() if how not in (ACT, REFUSED, HIDDEN)} == {}
    assert REFUSED in found.values()


def of_the_circle_too(pair: Pair) -> bool:
    """Whether `part circle` has these options, declared once for all parts."""
    part = pair.command.startswith("part ") and pair.command != "part circle"
    return part and OF_EVERY_PART.issuperset(pair.options)
