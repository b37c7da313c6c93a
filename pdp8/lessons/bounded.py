"""The answers of a class marked in another process, each within bounds of processor time, memory and output.

    command ── fork ──► marks answer after answer ──► pipe ──► command
       ▲                  SIGPROF ends it where one takes too long; the next process goes on after it

Where there is no fork (Windows) the answers are marked here, and nothing but machine time bounds them.
"""

import os
import sys
from collections.abc import Sequence

from pdp8.computer.use.program import FOUND
from pdp8.lessons import marking
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Result

SECONDS = 10
"""Of processor time an answer."""


def marked(
    exercise: Exercise, answers: Sequence[Answer], seconds: float = SECONDS, dialect: str = FOUND
) -> list[Result]:
    """Return the marks of each answer; those of one that takes more than `seconds` are a fault."""
    if sys.platform != "win32" and hasattr(os, "fork"):
        from pdp8.lessons.process import fault, process

        done: list[Result] = []
        while len(done) < len(answers):
            results, status = process(exercise, answers[len(done) :], seconds, dialect)
            done += results
            if len(done) < len(answers):
                done.append(Result(answers[len(done)].name, (), exercise.points, fault(status, seconds)))
        return done
    return [marking.mark(exercise, answer, dialect) for answer in answers]
