"""An answer's marks as a page for the student who wrote it: HTML with nothing outside it."""

import re
from collections.abc import Iterator
from html import escape
from itertools import pairwise

from pdp8.lessons import scores
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Result

_STYLE = """
body { font: 1rem/1.5 system-ui, sans-serif; max-width: 46rem; margin: 2rem auto; padding: 0 1rem }
table { border-collapse: collapse } th, td { text-align: left; padding: .2rem 1rem .2rem 0 }
pre, code { background: #f4f2ea; color: #111 }
pre { padding: .8rem; overflow-x: auto }
code { display: inline-block; white-space: break-spaces }
.task { white-space: pre-line }
.hint { border-left: 4px solid #b8860b; padding-left: .8rem }
@media print { body { margin: 0 } }
"""
_CODE = re.compile(r"`([^`]+)`")
_FULL = 70
"""Characters, at least, of a line that was ended because the next word did not fit."""
_WRAPPED = re.compile(r"(?<=\S)\n(?!\s|[*-]|\w+: )")
"""Where a line may have been ended for that; what follows does not begin a list."""


def html(exercise: Exercise, result: Result) -> str:
    """Return the page of `result`."""
    name = escape(scores.visible(result.answer))
    title = f"{escape(exercise.title)}: {name}"
    points = f"{result.points} of {result.of} points" if result.of else "not marked"
    parts = [
        "<!doctype html>",
        f'<html lang="en"><head><meta charset="utf-8"><title>{title}</title>',
        f'<meta name="viewport" content="width=device-width"><style>{_STYLE}</style></head><body>',
        f"<h1>{escape(exercise.title)}</h1>",
        f"<p><strong>{name}: {points}</strong></p>",
        task(exercise.asked),
        *body(exercise, result),
        "</body></html>\n",
    ]
    return "\n".join(parts)


def task(text: str) -> str:
    """Return an exercise's task, its paragraphs and lists as they were written."""
    pieces = _WRAPPED.split(text.strip())
    whole = pieces[0]
    for before, piece in pairwise(pieces):
        line = before.split("\n")[-1]
        full = len(line) + 1 + len(piece.split(" ")[0]) > _FULL
        whole += (" " if full else "\n") + piece
    return f'<p class="task">{_coded(whole)}</p>'


def _coded(text: str) -> str:
    """Return a text in which what is within `` is code, its blanks kept."""
    parts = enumerate(_CODE.split(text))
    return "".join(f"<code>{escape(part)}</code>" if at % 2 else escape(part) for at, part in parts)


def body(exercise: Exercise, result: Result) -> Iterator[str]:
    """Yield what is said of an answer: its points, what failed, the hints."""
    if result.fault:
        yield f"<h2>It was not tried</h2><pre>{escape(chr(10).join(scores.fault(result)))}</pre>"
        return
    yield "<table><tr><th>tried</th><th>points</th><th></th></tr>"
    for mark in result.marks:
        right = "not yet" if mark.failures else "given" if mark.given else "right"
        yield f"<tr><td>{escape(mark.name)}</td><td>{mark.points} of {mark.of}</td><td>{right}</td></tr>"
    yield "</table>"
    if exercise.note:
        yield f"<p>{escape(exercise.note)}</p>"
    for mark in [each for each in result.marks if each.failures]:
        yield f"<h2>{escape(mark.name)}</h2>"
        if mark.inputs:
            yield f"<p>Tried with {escape(mark.inputs)}.</p>"
        yield f"<pre>{escape(chr(10).join(scores.said(mark)))}</pre>"
        if mark.hint:
            yield f'<p class="hint">{_coded(mark.hint)}</p>'
