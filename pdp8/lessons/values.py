"""A sheet's answer held against what is right: numbers by value and unit, texts by what matters.

In what way a number is written does not matter: -035, minus 35 and `-35 octal`, where octal is asked for,
are -35; 2 4 6 8 is 2,4,6,8. Nor do the articles and the words of the question: of `block 100`, the block.
"""

from collections.abc import Sequence

from pdp8.lessons.exercise import Question

UNITS = {
    "s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0, "h": 3600.0,
    "in": 1.0, "mil": 1e-3, "ft": 12.0, "mm": 1 / 25.4, "cm": 1 / 2.54, "m": 1 / 0.0254,
}  # fmt: skip
"""Each in seconds or inches."""
_TIMES = ("s", "ms", "us", "min", "h")
_ALSO = {
    "\u00b5s": "us", "\u03bcs": "us", "microsecond": "us", "microseconds": "us", "microsec": "us",
    "usec": "us", "msec": "ms",
    "millisecond": "ms", "milliseconds": "ms", "sec": "s", "second": "s", "seconds": "s",
    "minute": "min", "minutes": "min", "hour": "h", "hours": "h",
    "inch": "in", "inches": "in", '"': "in", "mils": "mil", "thou": "mil",
    "foot": "ft", "feet": "ft", "'": "ft",
}  # fmt: skip
_MINUS = ("-", "minus", "negative")
_DASHES = "\u2010\u2011\u2012\u2013\u2014\u2212"
_FILLERS = ("a", "an", "the", "it", "is", "its", "are", "about", "number", "no.", "of", "from", "on")
_NUMBERS = {
    "one": "1", "two": "2", "three": "3", "four": "4", "five": "5", "six": "6", "seven": "7", "eight": "8",
    "nine": "9", "ten": "10", "1/1000": "0.001", "thousandth": "0.001",
}  # fmt: skip
"""Numbers in words, and one thousandth."""
_ORDINALS = ("st", "nd", "rd", "th")
OCTAL = "octal"
"""The unit of answers that are read in octal."""
WRONG_UNIT = "The number is right; its unit is not."
DECIMAL = "That is decimal; it is asked for in octal."


def known(unit: str) -> bool:
    """Tell whether `unit` is one of ours."""
    return _ALSO.get(unit, unit) in UNITS


def right(question: Question, given: str) -> bool:
    """Tell whether `given` answers the question."""
    if question.number is not None:
        return _is(question, given, question.number, question.tolerance)
    return _one_of(question, given, question.answer)


def hint(question: Question, given: str) -> str:
    """Return the hint for a wrong answer: that of its slip, or of the question."""
    for slip, said in question.slips.items():
        if _same(question, given, slip):
            return said
        value, unit = _parted(slip)
        if question.number is not None and not unit and len(value) == 1 and _is(question, given, value[0], 0):
            return said
    if question.number is not None and any(_near(question, value, question.number, question.tolerance)
                                           for value in _parted(_bare(given))[0]):  # fmt: skip
        return WRONG_UNIT
    if question.unit == OCTAL and _one_of(question, given, [str(int(each, 8)) for each in question.answer]):
        return DECIMAL
    return question.hint


def _one_of(question: Question, given: str, answers: Sequence[str]) -> bool:
    return any(_same(question, given, answer) for answer in answers)


def _is(question: Question, given: str, number: float, tolerance: float) -> bool:
    """Tell whether `given` equals `number` in the question's unit, which may be omitted."""
    known = _known(question)
    words = _plain(_bare(given[given.rfind("=") + 1 :])).split()
    while words and words[0] in known and not _number(words[0]):
        words = words[1:]
    whole = _summed(" ".join(words), question.unit)
    if whole:
        return _near(question, whole[0], number, tolerance)
    found, unit = _parted(_grouped(words))
    unit = " ".join([word for word in unit.split() if word not in _FILLERS])
    own = _ALSO.get(question.unit, question.unit)
    unit = _ALSO.get(unit, unit)
    factor = 1.0
    if unit and unit != own and own in UNITS:
        if unit not in UNITS or (unit in _TIMES) != (own in _TIMES):
            return False
        factor = UNITS[unit] / UNITS[own]
    elif unit and unit != own and unit not in known:
        return False
    return any(_near(question, value * factor, number, tolerance) for value in found)


def _grouped(words: list[str]) -> str:
    """Return number and unit with digit groups joined: 2 789."""
    text = words[0] if words else ""
    for at in range(1, len(words)):
        before, word = words[at - 1], words[at]
        thousands = before.lstrip("-").isdigit() and len(before) < 4 and len(word) == 3 and word.isdigit()
        text += word if thousands else f" {word}"
    return text


def _summed(text: str, unit: str) -> list[float]:
    """Return what a text of several units says in another, as `4 min 30 s` is 270 s; [] for any other."""
    own = _ALSO.get(unit, unit)
    total = 0.0
    parts = 0
    while text:
        values, rest = _parted(text)
        name, _, text = rest.replace(",", "").partition(" ")
        found = _ALSO.get(name, name)
        if len(values) != 1 or own not in UNITS or found not in UNITS or (found in _TIMES) != (own in _TIMES):
            return []
        total += values[0] * UNITS[found] / UNITS[own]
        parts += 1
        text = text.removeprefix("and ")
    return [total] if parts > 1 else []


def _bare(text: str) -> str:
    """Return a text without brackets, quotes, exclamation marks and signs for "about"."""
    for mark in "()[]`*!~\u2248":
        text = text.replace(mark, " ")
    return text


def _near(question: Question, value: float, number: float, tolerance: float) -> bool:
    return abs(value - number) <= tolerance + 1e-9 * max(1.0, abs(number))


def _parted(text: str) -> tuple[list[float], str]:
    """Return the possible numbers that a text begins with, as 1,798 has two, and the unit after it."""
    plain = _plain(text)
    end = 0
    while end < len(plain) and plain[end] in "+-.,0123456789":
        end += 1
    digits, unit = plain[:end].rstrip(".,"), plain[end:].strip().removesuffix(".")
    forms = [digits.replace(",", "")]
    if digits.count(",") == 1 and "." not in digits:
        after = len(digits) - digits.find(",") - 1
        forms = [digits.replace(",", "."), *forms] if after == 3 else [digits.replace(",", ".")]
    return [float(form) for form in forms if _number(form)], unit


def _number(form: str) -> bool:
    whole = form[1:] if form[:1] in ("+", "-") else form
    left, _, after = whole.partition(".")
    return (left + after).isdigit() and (left + after).isascii()


def _same(question: Question, given: str, answer: str) -> bool:
    one, other = _words(given), _words(answer)
    known = [word for word in _known(question) if word not in other or not _number(word)]
    few = [word for word in one if word not in known]
    return one == other or (few != [] and few == [word for word in other if word not in known])


def _known(question: Question) -> list[str]:
    """Return the words that an answer may contain in addition."""
    return [word for word in [*_words(question.ask), *_FILLERS, question.unit] if word != "not"]


def _plain(text: str) -> str:
    """Return a text in small letters, a number's minus before its digits, `0o35` as `35 octal`."""
    plain = text.lower().replace("#", " ").replace("(8)", " octal").replace("one thousandth", "thousandth")
    for dash in _DASHES:
        plain = plain.replace(dash, "-")
    found: list[str] = []
    for item in plain.split():
        word = _NUMBERS.get(item, item)
        if word[-2:] in _ORDINALS and _number(word[:-2]):
            word = word[:-2]
        if word[:1] == "n" and _number(word[1:]):
            word = word[1:]
        if word.lstrip("+-")[:2] == "0o":
            word = f"{word.replace('0o', '')} octal"
        if found and found[-1] in _MINUS and word[:1].isdigit():
            found[-1] = f"-{word}"
        else:
            found.append(word)
    return " ".join(found)


def _words(text: str) -> list[str]:
    """Return a text's words without case, marks, leading zeros, or blanks and commas within numbers."""
    plain = _plain(text)
    for mark in ",?!;:()[]`'\"":
        plain = plain.replace(mark, " ")
    found: list[str] = []
    run: list[str] = []
    for word in [*plain.split(), ""]:
        item = word.rstrip(".")
        if _number(item):
            run.append(item)
            continue
        if run and item == "and":
            continue
        found += _joined(run)
        run = []
        if item:
            found.append(item)
    return found


def _joined(numbers: list[str]) -> list[str]:
    """Return a row of digits or thousands as one number, and other numbers without leading zeros."""
    whole = [number.partition(".")[0] for number in numbers]
    digits = all(len(number) == 1 for number in numbers)
    if digits or (len(whole[0]) < 4 and all(len(each) == 3 and each.isdigit() for each in whole[1:])):
        numbers = ["".join(numbers)] if numbers else []
    found = []
    for number in numbers:
        sign = "-" if number[0] == "-" else ""
        found.append(sign + (number.lstrip("+-0") or "0"))
    return found
