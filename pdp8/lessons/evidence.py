"""What is wrong with the results of an answer, if all its trials that end as expected show it.

words        SUM is A + A in each trial; SUM is as it was before the start; AC is 1 more than is wanted
characters   the same comes again and again; 020 comes in place of 040, and all else is right; the last 2
             are missing
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

_TRIALS = 3
"""Trials that must show it."""
_NONE = -1
_FEW = 0o20
"""A word that is wrong by at most so much is called so."""


class Word(NamedTuple):
    """An observed word: the inputs beside it, its old value, its expected value and its value."""

    inputs: Mapping[str, int]
    before: int
    expected: int
    got: int


class Text(NamedTuple):
    """Printed or punched characters: those read, those expected and those that came, as codes."""

    read: Sequence[int]
    expected: Sequence[int]
    got: Sequence[int]


def of_words(place: str, seen: Sequence[Word]) -> str:
    """Return the pattern that all wrong words show, "" if none."""
    wrong = [each for each in seen if each.got != each.expected]
    if len(wrong) < _TRIALS:
        return ""
    where = "in each trial" if len(wrong) == len(seen) else "wherever it is wrong"
    if all(each.got == each.before for each in wrong) and len({each.before for each in wrong}) > 1:
        return f"{place} is as it was before START {where}: nothing is put there."
    if len({each.got for each in wrong}) == 1 and len({each.expected for each in wrong}) > 1:
        return f"{place} is {wrong[0].got:04o} {where}, whatever is put in."
    wanted = len({each.expected for each in wrong}) > 1
    names = [name for name in wrong[0].inputs if all(name in each.inputs for each in wrong)]
    for what, formula in _formulas(wrong[0], names, wrong[0], wanted).items():
        values = [_formulas(each, names, wrong[0], wanted).get(what, -1) for each in wrong]
        if formula == wrong[0].got and values == [each.got for each in wrong]:
            return f"{place} is {what} {where}."
    return ""


def _formulas(seen: Word, names: Sequence[str], first: Word, by_wanted: bool) -> dict[str, int]:
    """Return {formula: value} of inputs, `by_wanted` of the expected word too; # is a number by `first`."""
    found: dict[str, int] = {}
    wanted, values = seen.expected, seen.inputs
    for name in names:
        value = values[name]
        found[name] = value
        found[f"{name} + {name}"] = 2 * value
        found[f"-{name}"] = -value
        found[f"{name} times {name}"] = value * value
        found[f"the complement of {name}"] = 0o7777 - value
    for one in names:
        for two in names if len(names) < 4 else []:
            if one != two:
                found[f"{one} - {two}"] = values[one] - values[two]
            if one < two:
                found[f"{one} + {two}"] = values[one] + values[two]
                found[f"{one} AND {two}, bit by bit,"] = values[one] & values[two]
                found[f"the other of {one} and {two}"] = values[one] + values[two] - wanted
    for name in names:
        _near(found, f"{name} + #", f"{name} - #", first.got - first.inputs[name], values[name])
    if not by_wanted:
        return {what: value & 0o7777 for what, value in found.items()}
    _near(found, "# more than is wanted", "# less than is wanted", first.got - first.expected, wanted)
    for name in names:
        found[f"more than is wanted by {name}"] = wanted + values[name]
        found[f"less than is wanted by {name}"] = wanted - values[name]
    found["the negative of what is wanted"] = -wanted
    found["twice what is wanted"] = 2 * wanted
    found["half of what is wanted"] = wanted >> 1
    return {what: value & 0o7777 for what, value in found.items()}


def _near(found: dict[str, int], if_more: str, if_less: str, number: int, to: int) -> None:
    """Add formula `if_more` if `number` is small, `if_less` if -`number` is; its value is `to` + `number`."""
    more, less = number & 0o7777, -number & 0o7777
    if more <= _FEW:
        found[if_more.replace("#", f"{more:o}")] = to + more
    elif less <= _FEW:
        found[if_less.replace("#", f"{less:o}")] = to - less


def of_characters(seen: Sequence[Text], codes: bool) -> str:
    """Return the pattern that all show, "" if none; `codes` says whether to name them by their codes."""
    wrong = [each for each in seen if list(each.got) != list(each.expected)]
    several = [each for each in seen if len(each.got) > 1]
    if len(seen) < _TRIALS or len(wrong) < 2:
        return ""
    rules = (
        (len(several) > 1 and all(len(set(each.got)) == 1 for each in several),
         "The same character comes again and again."),
        (all(list(each.got) == list(reversed(each.expected)) for each in seen),
         "They come in the opposite order."),
        (all(list(each.got) == list(each.read) for each in seen), "They come out as they went in."),
        (not codes and all(_in_octal(each) for each in seen), "These are the digits in octal."),
    )  # fmt: skip
    plain = [said for applies, said in rules if applies]
    return plain[0] if plain else _too_many(seen) or _missing(seen) or _one_code(wrong, codes)


def _too_many(seen: Sequence[Text]) -> str:
    for said, front in (("after the last", True), ("before the first", False)):
        more = [_rest(each.expected, each.got, front) for each in seen]
        if min(more) > 0:
            count = f"{more[0]}" if len(set(more)) == 1 else "Some"
            return f"{count} too many come {said}."
    return ""


def _missing(seen: Sequence[Text]) -> str:
    for said, front in (("last", True), ("first", False)):
        fewer = [_rest(each.got, each.expected, front) for each in seen]
        if len(set(fewer)) == 1 and fewer[0] > 0:
            return f"The {said} is missing." if fewer[0] == 1 else f"The {said} {fewer[0]} are missing."
    return ""


def _in_octal(seen: Text) -> bool:
    """Tell whether the digits are the octal form of a number that is expected in decimal."""
    wanted, found = ("".join(chr(code) for code in codes) for codes in (seen.expected, seen.got))
    digits = wanted.isdigit() and found.isdigit() and "8" not in found and "9" not in found
    return digits and int(wanted) == int(found, 8)


def _rest(short: Sequence[int], long: Sequence[int], front: bool) -> int:
    """Return how much longer `long` is if it begins or ends with `short`, else -1."""
    more = len(long) - len(short)
    same = list(long[: len(short)] if front else long[more:]) == list(short)
    return more if more >= 0 and same else -1


def _one_code(wrong: Sequence[Text], codes: bool) -> str:
    """Return the only character that comes out wrong, or the only wrong channel."""
    wants: set[int] = set()
    gots: set[int] = set()
    masks: set[int] = set()
    every = 0
    for each in wrong:
        if len(each.got) != len(each.expected):
            gone = [
                code for code in sorted(set(each.expected)) if _without(each.expected, code) == list(each.got)
            ]
            if not gone:
                return ""
            wants.add(gone[0])
            gots.add(_NONE)
            continue
        both = list(zip(each.expected, each.got, strict=True))
        every += all(one != two for one, two in both)
        for one, two in both:
            if one != two:
                wants.add(one)
                gots.add(two)
                masks.add(one ^ two)
    if len(wants) == 1 and len(gots) == 1:
        said = _called(min(wants), codes)
        if _NONE in gots:
            return f"Each {said} is missing, and all else is right."
        return f"{_called(min(gots), codes)} comes in place of {said}, and all else is right."
    if len(wants) == 1:
        return f"All is right but what comes in place of {_called(min(wants), codes)}."
    if len(gots) == 1 and _NONE not in gots:
        return f"{_called(min(gots), codes)} comes where others belong, and all else is right."
    channels = [channel for channel in range(1, 9) if masks == {1 << channel - 1}]
    if channels and codes:
        where = "every frame" if every == len(wrong) else "some frames"
        return f"Channel {channels[0]} is wrong in {where}, and all else is right."
    return ""


def _without(codes: Sequence[int], code: int) -> list[int]:
    return [each for each in codes if each != code]


def _called(code: int, codes: bool) -> str:
    return f"{code:03o}" if codes else chr(code)
