"""Marks for machines: JSON with what is wrong in each answer, CSV for spreadsheets, the XML that JUnit writes
and every CI service shows, and what Gradescope reads.
"""

import csv
import io
import json
from collections.abc import Iterable, Mapping, Sequence
from xml.etree import ElementTree

from pdp8.lessons import scores
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Failure, Mark, Result
from tapes import errors


def as_csv(exercise: Exercise, results: Sequence[Result]) -> str:
    """Return the marks as CSV: a row an answer, a column a case or question."""
    rows = [["answer", *map(_cell, exercise.names), "points", "of", "fault"]]
    for result in results:
        points = [f"{mark.points}" for mark in result.marks] or ["0"] * len(exercise.names)
        sums = f"{result.points}", f"{result.of}"
        rows.append([_cell(result.answer), *points, *sums, _cell(result.fault)])
    return _rows(rows)


def _rows(rows: Iterable[Sequence[str]]) -> str:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()


def _cell(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula."""
    plain = scores.visible(text)
    return f"'{plain}" if plain[:1] in ("=", "+", "-", "@") else plain


def as_json(exercise: Exercise, results: Sequence[Result]) -> str:
    """Return the marks as JSON; tapes are lists of octal frames, as they are written elsewhere."""
    record = {
        "exercise": exercise.name,
        "title": exercise.title,
        "answers": [
            {
                "answer": result.answer,
                "right": result.right,
                "points": result.points,
                "of": result.of,
                "fault": result.fault or None,
                "marks": [_mark(mark) for mark in result.marks],
            }
            for result in results
        ],
    }
    return json.dumps(record, indent=2) + "\n"


def _mark(mark: Mark) -> dict[str, object]:
    return {
        "name": mark.name,
        "points": mark.points,
        "of": mark.of,
        "hidden": mark.hidden,
        "given": mark.given,
        "inputs": mark.inputs or None,
        "hint": mark.hint or None,
        "failures": [
            {
                "what": failure.what,
                "happened": failure.happened,
                "expected": _value(failure.expected),
                "got": _value(failure.got),
            }
            for failure in mark.failures
        ],
    }


def _value(value: str | bytes) -> str:
    return " ".join(f"{frame:03o}" for frame in value) if isinstance(value, bytes) else value


def as_junit(exercise: Exercise, results: Sequence[Result]) -> str:
    """Return the marks as JUnit's XML: a test suite an answer, a test case each case or question."""
    suites = ElementTree.Element("testsuites", name=exercise.name)
    for result in results:
        marks = result.marks or [
            Mark(name, 0, 0, (Failure("fault", "", result.fault),)) for name in exercise.names
        ]
        failed = sum(bool(mark.failures) for mark in marks)
        counts = {"tests": f"{len(marks)}", "failures": f"{failed}"}
        suite = ElementTree.SubElement(suites, "testsuite", {"name": result.answer, **counts})
        for mark in marks:
            case = ElementTree.SubElement(suite, "testcase", name=mark.name, classname=exercise.name)
            if mark.given:
                ElementTree.SubElement(case, "skipped", message=exercise.note)
            if mark.failures:
                what = ", ".join(failure.what for failure in mark.failures)
                failure = ElementTree.SubElement(case, "failure", message=f"not as expected: {what}")
                failure.text = "\n".join(_said(result, mark))
    for element in suites.iter():
        element.attrib.update({key: errors.visible(value) for key, value in element.attrib.items()})
        element.text = element.text and errors.visible(element.text)
    ElementTree.indent(suites)
    return f'<?xml version="1.0" encoding="utf-8"?>\n{ElementTree.tostring(suites, encoding="unicode")}\n'


def as_list(seeds: Mapping[str, int]) -> str:
    """Return CSV with the seed of each answer's random cases."""
    return _rows([["answer", "seed"], *([_cell(name), f"{seed}"] for name, seed in seeds.items())])


def as_gradescope(exercise: Exercise, result: Result) -> str:
    """Return the marks of one answer as the results.json that Gradescope's autograder reads."""
    tests = [
        {
            "name": mark.name,
            "score": mark.points,
            "max_score": mark.of,
            **({} if mark.given else {"status": "failed" if mark.failures else "passed"}),
            "output": "\n".join(_said(result, mark)),
        }
        for mark in result.marks
    ]
    found = {"score": result.points, "output": result.fault or exercise.note, "tests": tests}
    return json.dumps(found, indent=2, ensure_ascii=False) + "\n"


def _said(result: Result, mark: Mark) -> list[str]:
    if result.fault:
        return list(scores.fault(result))
    return [*scores.said(mark), *[f"hint: {mark.hint}"] * bool(mark.hint)]
