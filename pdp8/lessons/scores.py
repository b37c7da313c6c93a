"""Marks for people: one table for the class, and under it what failed, with carets and tapes as holes.

answer     add 5 and 7   wraps at 12 bits   points
ana.pal         2               2            4 / 4
ben.pal         2               -            2 / 4

ben.pal: wraps at 12 bits
  SUM        expected 0001
                  got 0000
                      ---^
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from pdp8.lessons.diagnosis import first_difference
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Failure, Mark, Result
from tapes import errors
from tapes.frames import draw
from tapes.quantities import counted
from tapes.text import lines_of

if TYPE_CHECKING:
    from rich.table import Table

_BEFORE, _AFTER = 2, 4
"""Frames of a tape shown before the first wrong one, and after it."""
_WIDEST = 60
_FAILURES = 6
_END = "the end"
"""Said in whole sentences."""
_NO_CARET = (_END, "the time", "instructions")
_ON_ONE_LINE = {0o11: "\u2409", 0o12: "\u240a"}


def table(exercise: Exercise, results: Sequence[Result]) -> "Table":
    """Return the table of a class: a row an answer, a column a case or question, their points."""
    from rich.table import Table
    from rich.text import Text

    made = Table(box=None, pad_edge=False)
    made.add_column("answer", no_wrap=True)
    for name in exercise.names:
        made.add_column(Text(visible(name)), justify="center")
    made.add_column("points", justify="right", no_wrap=True)
    for result in results:
        cells = [Text(_cell(mark)) for mark in result.marks] or [Text("-")] * len(exercise.names)
        points = f"{result.points} / {result.of}" if result.of else "-"
        made.add_row(Text(visible(result.answer)), *cells, Text(points))
    return made


def _cell(mark: Mark) -> str:
    return "-" if mark.failures else "given" if mark.given else f"{mark.points}"


def details(result: Result) -> Iterator[str]:
    """Yield the lines that say what failed, and the hints."""
    if result.fault:
        yield f"{result.answer}: no points"
        yield from (f"  {line}" for line in fault(result))
    for mark in result.marks:
        if mark.failures:
            yield f"{result.answer}: {mark.name}{', with ' * bool(mark.inputs)}{mark.inputs}"
        yield from (f"  {line}" for line in said(mark))
        if mark.hint:
            yield f"  hint: {mark.hint}"


def said(mark: Mark) -> Iterator[str]:
    """Yield the lines about failures, only the first few."""
    for failure in mark.failures[:_FAILURES]:
        yield from lines(failure)
    if len(mark.failures) > _FAILURES:
        yield f"and {len(mark.failures) - _FAILURES} more"


def fault(result: Result) -> Iterator[str]:
    """Yield the lines that say why an answer was not tried."""
    return (visible(line.expandtabs(8)) for line in lines_of(result.fault))


def lines(failure: Failure) -> Iterator[str]:
    """Yield what was expected, what was found, and a caret under the first difference; a tape as holes."""
    if not failure.expected and not failure.got:
        yield f"{failure.what:12} {failure.happened}"
        return
    if isinstance(failure.expected, bytes) and isinstance(failure.got, bytes):
        yield from _tapes(failure.what, failure.expected, failure.got)
        return
    expected, got = visible(str(failure.expected)), visible(str(failure.got))
    if not expected:
        yield f"{failure.what:12} got {_cut(got, 0)}"
        return
    at = first_difference(expected, got)
    start = max(0, at - _WIDEST // 2)
    yield f"{failure.what:12} expected {_cut(expected, start)}"
    yield f"{'':17} got {got if failure.what == _END else _cut(got, start)}"
    if failure.what not in _NO_CARET:
        yield f"{'':21} {'-' * (at - start)}^"


def visible(text: str) -> str:
    """Return a text on one line, its control codes as pictures."""
    return errors.visible(text).translate(_ON_ONE_LINE)


def _cut(text: str, start: int) -> str:
    return text[start : start + _WIDEST] + ("..." if len(text) > start + _WIDEST else "")


def _tapes(what: str, expected: bytes, got: bytes) -> Iterator[str]:
    at = first_difference(expected, got)
    start, stop = max(0, at - _BEFORE), at + _AFTER + 1
    came = counted(len(got), "frames")
    yield f"{what}: {came}, {len(expected):,} expected; the first difference is frame {at}"
    yield "   frame    expected               got"
    for number in range(start, min(stop, max(len(expected), len(got)))):
        mark = "  <--" if number == at else ""
        yield f"{number:8}    {_frame(expected, number)}    {_frame(got, number)}{mark}".rstrip()


def _frame(tape: bytes, number: int) -> str:
    return f"|{draw(tape[number])}| {tape[number]:03o}  " if number < len(tape) else f"{'no frame':17}"
