"""The columns of a disassembly: a tab reaches the comment from the eighth character on."""

import pytest

from pal.disassembler import disassemble


@pytest.mark.parametrize(
    ("word", "line"),
    [
        (0o5420, "\tJMP I 20\t/0200 5420"),  # eight characters
        (0o5407, "\tJMP I 7\t\t/0200 5407"),  # seven
        (0o7641, "\t7641\t\t/0200 7641"),
        (0o7300, "\tCLA CLL\t\t/0200 7300"),
        (0o7640, "\tSZA CLA\t\t/0200 7640"),
        (0o7340, "\tCLA CLL CMA\t/0200 7340"),
    ],
)
def test_the_comment_stands_in_its_column(word: int, line: str) -> None:
    assert disassemble({0o200: word}).splitlines()[1] == line
