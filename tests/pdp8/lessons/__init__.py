"""Tests of the lessons: exercises, marks, and what hostile answers can do."""

from pdp8.lessons import handed, marking
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.form import parse
from pdp8.lessons.marking import Result

HEAD = "title='t'\ntask='t'\n"
PUNCH = "*200\n\tTAD A\n\tTLS\n\tTSF\n\tJMP .-1\n\tHLT\nA,\t{}\n$"
DOUBLE = 'solution="""*200\n\tTAD A\n\tCLL RAL\n\tDCA B\n\tHLT\nA,\t0\nB,\t0\n$\n"""\n'


def exercise(case: str, head: str = "") -> Exercise:
    """Return an exercise of one case."""
    return parse(f"{HEAD}{head}\n[[case]]\nname='c'\n{case}\n", "e")


def mark(exercise: Exercise, source: str | bytes) -> Result:
    content = source.encode() if isinstance(source, str) else source
    return marking.mark(exercise, handed.of(content, "a.pal"))
