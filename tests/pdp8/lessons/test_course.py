"""The order of a class has every bundled exercise once."""

from pdp8.lessons import form
from pdp8.lessons.course import COURSE
from pdp8.lessons.page import task


def test_every_exercise_has_its_place() -> None:
    names = [name for level in COURSE.values() for name in level.split()]
    assert sorted(names) == sorted(form.bundled())
    assert all(form.read(name).questions for name in COURSE["An hour in 1971: sheets"].split())


def test_a_task_keeps_the_lines_of_its_author() -> None:
    """A line that was ended because it was full goes on; one that was ended before stays a line."""
    full = "a" * 40 + " " + "b" * 29 + "\nand on, then\nwell before its end.\n\nNext:\n1. one\n2. two\n"
    lines = task(full).removeprefix('<p class="task">').removesuffix("</p>").split("\n")
    assert lines == [
        "a" * 40 + " " + "b" * 29 + " and on, then", "well before its end.", "", "Next:", "1. one", "2. two",
    ]  # fmt: skip
    for length, joint in ((66, "\n"), (67, " ")):
        assert f">{'c' * length}{joint}and<" in task(f"{'c' * length}\nand")
