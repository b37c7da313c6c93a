"""The mutants of a small source, one by one; and that those which change nothing are still there."""

from textwrap import dedent

from tests.mutation.mutants import mutants
from tests.mutation.packages import ROOT, equal

SOURCE = '''
    """A docstring."""
    LIMIT: int = 7

    def f(a: int, b: "word" = 2) -> str | None:
        if a < b and not g():
            raise ValueError("too small, by far")
        match a:
            case 3 if b:
                return f"{a - 1:03} of {LIMIT}"
        g(a.encode("ascii"), encoding="utf-8", strict=True, help="words")
'''


def test_each_change_is_made_once() -> None:
    found = [(mutant.lines[-1], mutant.scope, mutant.text) for mutant in mutants(dedent(SOURCE))]
    assert found == [
        (3, "", "7 → 8"),
        (5, "f", "2 → 3"),
        (6, "f", "a < b and (not g()) → a < b or not g()"),
        (6, "f", "a < b and (not g()) → not g()"),
        (6, "f", "a < b and (not g()) → a < b"),
        (6, "f", "a < b → a <= b"),
        (6, "f", "a < b → a >= b"),
        (6, "f", "not g() → g()"),
        (7, "f", "raise ValueError('too small, by far') → (nothing)"),
        (9, "f", "3 → 4"),
        (9, "f", "b → True"),
        (10, "f", "return f'{a - 1:03} of {LIMIT}' → return None"),
        (10, "f", "a - 1 → a + 1"),
        (10, "f", "1 → 2"),
        (11, "f", "g(a.encode('ascii'), encoding='utf-8', strict=True, help='words') → (nothing)"),
    ]


def test_what_changes_nothing_is_still_there() -> None:
    for file in {file for file, _, _ in equal()}:
        here = {(file, mutant.scope, mutant.text) for mutant in mutants((ROOT / file).read_text())}
        assert {entry for entry in equal() if entry[0] == file} <= here
