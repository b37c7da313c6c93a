"""Hints that rest on all trials of an answer: each mistake by hand, and what it shows."""

from dataclasses import replace

import pytest

from pdp8.lessons import form
from pdp8.lessons.evidence import Text, Word, of_characters, of_words
from pdp8.lessons.form import parse
from pdp8.lessons.tables import ExerciseError
from tests.pdp8.lessons import HEAD, mark

INPUTS = [(5, 7), (0o1234, 0o2345), (0o7777, 3), (0o400, 0o401)]


@pytest.mark.parametrize(
    ("got", "said"),
    [
        (lambda a, b: a, "SUM is A in each trial."),
        (lambda a, b: 2 * a, "SUM is A + A in each trial."),
        (lambda a, b: b - a, "SUM is B - A in each trial."),
        (lambda a, b: a & b, "SUM is A AND B, bit by bit, in each trial."),
        (lambda a, b: -b, "SUM is -B in each trial."),
        (lambda a, b: ~a, "SUM is the complement of A in each trial."),
        (lambda a, b: b * b, "SUM is B times B wherever it is wrong."),
        (lambda a, b: a + b + 1, "SUM is 1 more than is wanted in each trial."),
        (lambda a, b: a + b - 0o12, "SUM is 12 less than is wanted in each trial."),
        (lambda a, b: b + 6, "SUM is B + 6 in each trial."),
        (lambda a, b: a + b + 0o20, "SUM is 20 more than is wanted in each trial."),
        (lambda a, b: a + b - 0o20, "SUM is 20 less than is wanted in each trial."),
        (lambda a, b: a + b + 0o21, ""),
        (lambda a, b: a + b - 0o21, ""),
        (lambda a, b: a + b + a, "SUM is more than is wanted by A in each trial."),
        (lambda a, b: -(a + b), "SUM is the negative of what is wanted in each trial."),
        (lambda a, b: (a + b) << 1, "SUM is twice what is wanted in each trial."),
        (lambda a, b: 0o17, "SUM is 0017 in each trial, whatever is put in."),
        (lambda a, b: a + b if a == 5 else a, "SUM is A wherever it is wrong."),
        (lambda a, b: a + b if a < 0o1000 else a, ""),
        (lambda a, b: a ^ 0o2525 ^ b << 3, ""),
        (lambda a, b: a + b, ""),
    ],
)  # fmt: skip
def test_a_word_that_is_wrong_in_one_way_in_all_trials(got: object, said: str) -> None:
    assert callable(got)
    seen = [Word({"A": a, "B": b}, 0, a + b & 0o7777, got(a, b) & 0o7777) for a, b in INPUTS]
    assert of_words("SUM", seen) == said


def test_pairs_of_more_than_three_inputs_are_not_looked_at() -> None:
    for names, said in (("ABC", "SUM is A - B in each trial."), ("ABCD", "")):
        seen = [Word({n: a * ord(n) & 0o7777 for n in names}, 0, b, -a & 0o7777) for a, b in INPUTS]
        assert of_words("SUM", seen) == said


def test_a_word_that_nobody_wrote() -> None:
    seen = [Word({}, before, 5, before) for before in (1, 2, 3)]
    assert of_words("B", seen) == "B is as it was before START in each trial: nothing is put there."
    assert of_words("B", seen[:2]) == "", "two trials are too few"


WORDS = ("ABC", "XY", "BACK")


@pytest.mark.parametrize(
    ("got", "said"),
    [
        (lambda text: text[::-1], "They come in the opposite order."),
        (lambda text: "Z" * 4, "The same character comes again and again."),
        (lambda text: text.lower(), "They come out as they went in."),
        (lambda text: text[:-1], "The last is missing."),
        (lambda text: text[1:], "The first is missing."),
        (lambda text: text[:-2], "The last 2 are missing."),
        (lambda text: text[2:], "The first 2 are missing."),
        (lambda text: "ZZ" if text == "XY" else "Z", ""),
        (lambda text: "?" + text, "1 too many come before the first."),
        (lambda text: text + "?!", "2 too many come after the last."),
        (lambda text: text + text, "Some too many come after the last."),
        (lambda text: text.replace("A", "E"), "105 comes in place of 101, and all else is right."),
        (lambda text: text.replace("A", ""), "Each 101 is missing, and all else is right."),
        (lambda text: "".join(chr(ord(each) ^ 0o200) for each in text),
         "Channel 8 is wrong in every frame, and all else is right."),
        (lambda text: text, ""),
        (lambda text: "QRS", ""),
    ],
)  # fmt: skip
def test_characters_that_are_wrong_in_one_way_in_all_trials(got: object, said: str) -> None:
    assert callable(got)
    codes = [[list(map(ord, each)) for each in (text.lower(), text, got(text))] for text in WORDS]
    assert of_characters([Text(*each) for each in codes], codes=True) == said
    said = "" if "Channel" in said else said.replace("105", "E").replace("101", "A")
    assert of_characters([Text(*each) for each in codes], codes=False) == said


def test_digits_in_octal_are_known() -> None:
    seen = [
        Text([], list(map(ord, f"{number:04}")), list(map(ord, f"{number:04o}")))
        for number in (1234, 7, 4095)
    ]
    assert of_characters(seen, codes=False) == "These are the digits in octal."
    for other in "189X":
        assert of_characters([seen[0], seen[2], seen[2]._replace(got=[ord(other)])], codes=False) == ""


def test_a_hint_to_any_result_waits_for_the_first_case() -> None:
    """What fails at the first case does not fail others for what is special to them."""
    add = form.read("add")
    wrong = add.solution.replace("TAD B", "TAD A")
    assert {mark.hint for mark in mark(add, wrong).marks} == {"SUM is A + A in each trial."}
    last = add.solution.replace("\tHLT", "\tTAD SUM\n\tHLT")
    assert [found.hint for found in mark(add, last).marks if found.failures] == ["DCA deposits and clears."]


def test_no_pattern_tells_of_a_hidden_case() -> None:
    add = form.read("add")
    wrong = add.solution.replace("TAD B", "TAD A")
    for hidden in (False, True):
        given = replace(add, cases=tuple(replace(each, hidden=hidden) for each in add.cases))
        assert any("A + A" in mark.hint for mark in mark(given, wrong).marks) != hidden


def test_a_hint_that_nothing_brings_about_is_an_error() -> None:
    for key in ("too short", "left the program", "AC", "L", "the time", "SUM"):
        parse(f"{HEAD}[[case]]\nname='c'\ncore={{SUM=1}}\nhint={{'{key}'='h'}}\n", "e")
    with pytest.raises(ExerciseError, match="e: c: hint: nothing is called 'to short'; there are no word at"):
        parse(f"{HEAD}[[case]]\nname='c'\nac=1\nhint={{'to short'='h'}}\n", "e")
