"""Marks for machines: JSON with everything, and the XML that JUnit writes, which every CI service shows."""

import json
from collections.abc import Sequence
from xml.etree import ElementTree

from pdp8.lessons import scores
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Failure, Mark, Result
from tapes import errors


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
        "hint": mark.hint or None,
        "failures": [
            {"what": failure.what, "expected": _value(failure.expected), "got": _value(failure.got)}
            for failure in mark.failures
        ],
    }


def _value(value: str | bytes) -> str:
    return " ".join(f"{frame:03o}" for frame in value) if isinstance(value, bytes) else value


def as_junit(exercise: Exercise, results: Sequence[Result]) -> str:
    """Return the marks as JUnit's XML: a test suite an answer, a test case each case or question."""
    suites = ElementTree.Element("testsuites", name=exercise.name)
    for result in results:
        marks = result.marks or (Mark("the answer", 0, result.of, (Failure("fault", "", result.fault),)),)
        failed = sum(bool(mark.failures) for mark in marks)
        counts = {"tests": f"{len(marks)}", "failures": f"{failed}"}
        suite = ElementTree.SubElement(suites, "testsuite", {"name": result.answer, **counts})
        for mark in marks:
            case = ElementTree.SubElement(suite, "testcase", name=mark.name, classname=exercise.name)
            if mark.failures:
                what = ", ".join(failure.what for failure in mark.failures)
                failure = ElementTree.SubElement(case, "failure", message=f"not as expected: {what}")
                failure.text = "\n".join(_said(result, mark))
    for element in suites.iter():
        element.attrib.update({key: errors.visible(value) for key, value in element.attrib.items()})
        element.text = element.text and errors.visible(element.text)
    ElementTree.indent(suites)
    return f'<?xml version="1.0" encoding="utf-8"?>\n{ElementTree.tostring(suites, encoding="unicode")}\n'


def _said(result: Result, mark: Mark) -> list[str]:
    if result.fault:
        return list(scores.fault(result))
    said = [line for failure in mark.failures for line in scores.lines(failure)]
    return [*said, *[f"hint: {mark.hint}"] * bool(mark.hint)]
