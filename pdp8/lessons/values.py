"""A sheet's answer held against what is right: numbers by value and unit, texts by what matters."""

from pdp8.lessons.exercise import Question

UNITS = {
    "s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0, "h": 3600.0,
    "in": 1.0, "mil": 1e-3, "ft": 12.0, "mm": 1 / 25.4, "cm": 1 / 2.54, "m": 1 / 0.0254,
}  # fmt: skip
"""Each in seconds or inches."""
_TIMES = ("s", "ms", "us", "min", "h")
_ALSO = {
    "\u00b5s": "us", "\u03bcs": "us", "microsecond": "us", "microseconds": "us", "microsec": "us",
    "millisecond": "ms", "milliseconds": "ms", "sec": "s", "second": "s", "seconds": "s",
    "minute": "min", "minutes": "min", "hour": "h", "hours": "h",
    "inch": "in", "inches": "in", '"': "in", "mils": "mil", "thou": "mil",
    "foot": "ft", "feet": "ft", "'": "ft",
}  # fmt: skip
_FILLERS = ("a", "an", "the", "it", "is", "its", "are", "about")
WRONG_UNIT = "The number is right; its unit is not."


def known(unit: str) -> bool:
    """Tell whether `unit` is one of ours."""
    return _ALSO.get(unit, unit) in UNITS


def right(question: Question, given: str) -> bool:
    """Tell whether `given` answers the question."""
    if question.number is not None:
        return _is(question, given, question.number, question.tolerance)
    if not question.answer:
        return bool(given.strip())
    return any(_same(question, given, answer) for answer in question.answer)


def hint(question: Question, given: str) -> str:
    """Return what is said to a wrong answer: its slip's hint, or the question's."""
    for slip, said in question.slips.items():
        if _same(question, given, slip):
            return said
        value, unit = _parted(slip)
        if question.number is not None and not unit and len(value) == 1 and _is(question, given, value[0], 0):
            return said
    if question.number is not None and any(_near(question, value, question.number, question.tolerance)
                                           for value in _parted(given)[0]):  # fmt: skip
        return WRONG_UNIT
    return question.hint


def _is(question: Question, given: str, number: float, tolerance: float) -> bool:
    """Tell whether `given` is `number` in the question's unit; a unit may be left out."""
    found, unit = _parted(given)
    own = _ALSO.get(question.unit, question.unit)
    unit = _ALSO.get(unit, unit)
    factor = 1.0
    if unit and unit != own and own in UNITS:
        if unit not in UNITS or (unit in _TIMES) != (own in _TIMES):
            return False
        factor = UNITS[unit] / UNITS[own]
    elif unit and unit != own and unit not in question.ask.lower().replace("?", " ").split():
        return False
    return any(_near(question, value * factor, number, tolerance) for value in found)


def _near(question: Question, value: float, number: float, tolerance: float) -> bool:
    return abs(value - number) <= tolerance + 1e-9 * max(1.0, abs(number))


def _parted(text: str) -> tuple[list[float], str]:
    """Return what number a text begins with, and the rest, its unit; 1,798 may be meant in two ways."""
    plain = text.strip().lower().replace("\u2212", "-")
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
    known = [*_words(question.ask), *_FILLERS]
    few = [word for word in one if word not in known]
    return one == other or (few != [] and few == [word for word in other if word not in known])


def _words(text: str) -> list[str]:
    """Return the words of a text without what does not matter: case, marks, commas, leading zeros."""
    plain = text.lower().replace(",", "")
    for mark in "?!;:()[]`'\"":
        plain = plain.replace(mark, " ")
    words = [word.rstrip(".") for word in plain.split()]
    return [word.lstrip("0") or "0" for word in words if word]
