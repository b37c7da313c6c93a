"""Random expressions: JavaScript's value is Python's, as long as no number on the way is beyond 2^53."""

import ast
from pathlib import Path
from typing import Any

from hypothesis import Phase, assume, given, settings
from hypothesis import strategies as st

from pdp8.web.translator.modules import translate
from tests.pdp8.web.node import called, needs_node, write

EXACT = 1 << 53
NAMES = "a: int, b: int, x: float, p: bool, s: str, t: str, f: bytes, l: list[int]"
_CODE = {"__builtins__": {"len": len, "min": min, "max": max, "abs": abs, "bool": bool, "int": int}}

numbers = st.one_of(
    st.integers(0, 0o17777),
    st.sampled_from(
        [-1, 1 << 31, (1 << 31) - 1, -(1 << 31), 1 << 32, (1 << 53) - 1, 1 << 52, -(1 << 45) - 3]
    ),
    st.integers(-EXACT + 1, EXACT - 1),
)
values = st.fixed_dictionaries(
    {
        **{"a": numbers, "b": numbers, "x": st.floats(-1e6, 1e6, width=32), "p": st.booleans()},
        **{"s": st.text("aBc0", max_size=3), "t": st.text("aBc0", max_size=3)},
        **{"f": st.binary(max_size=3), "l": st.lists(st.integers(-9, 9), max_size=3)},
    }
)
_OPERATORS = st.sampled_from(["+", "-", "*", "//", "%", "&", "|", "^"])
wholes: st.SearchStrategy[str] = st.deferred(
    lambda: st.one_of(
        st.sampled_from(["a", "b", "len(s)", "len(l)", "(a & 0o7777)", "(b & 0o177)", "len(f)"]),
        numbers.map(lambda number: f"({number})"),
        st.builds("({} {} {})".format, wholes, _OPERATORS, wholes),
        st.builds("({} {} {})".format, wholes, st.sampled_from(["<<", ">>"]), st.integers(0, 34)),
        st.builds("({}{})".format, st.sampled_from("-~"), wholes),
        st.builds("({} if {} else {})".format, wholes, truths, wholes),
        st.builds("{}({}, {})".format, st.sampled_from(["min", "max"]), wholes, wholes),
        st.builds("(a {} b {} {})".format, st.sampled_from("&|^+"), st.sampled_from("&+-*"), wholes),
    )
)  # fmt: skip
signs = st.sampled_from(["<", "<=", "==", "!=", ">", ">="])
truths: st.SearchStrategy[str] = st.deferred(
    lambda: st.one_of(
        st.sampled_from(["p", "bool(l)", "not f", "s == t", "s < t", "s in t", "not s", "l == [1]"]),
        st.builds("({} {} {})".format, wholes, signs, wholes),
        st.builds("({} {} {} {} {})".format, wholes, signs, wholes, signs, wholes),
        st.builds("({} {} {})".format, truths, st.sampled_from(["and", "or"]), truths),
        st.builds("(not {})".format, truths),
        st.builds("({} in ({}, {}))".format, wholes, wholes, wholes),
        st.builds("(x {} {})".format, signs, wholes),
    )
)  # fmt: skip
others = st.one_of(
    st.builds("(s {} t)".format, st.sampled_from(["or", "and", "+"])),
    st.builds("(l {} [{}])".format, st.sampled_from(["or", "+"]), wholes),
    st.builds("f'{{{}:,}} {{{}:o}}'".format, wholes, wholes),
    st.builds("(x {} {})".format, st.sampled_from("+-*/"), wholes),
    st.builds("l[{}:{}]".format, st.integers(-4, 4), st.integers(-4, 4)),
    st.builds("(s * ({} & 3))".format, wholes),
)
expressions = st.one_of(wholes, truths, others)


def _value(expression: str, names: dict[str, Any]) -> Any:
    """Return what an expression is, or its error's kind; no number on the way is beyond 2^53."""
    for node in ast.walk(ast.parse(expression, mode="eval").body):
        if isinstance(node, ast.BinOp | ast.UnaryOp):
            try:
                part = eval(ast.unparse(node), _CODE, names)
            except ArithmeticError:
                continue
            assume(not isinstance(part, int) or abs(part) < EXACT)
    try:
        return eval(expression, _CODE, names)
    except ZeroDivisionError:
        return ZeroDivisionError


def _same(there: Any, wanted: Any) -> bool:
    """Whether a value that came through JSON is Python's.

    JSON writes a whole float without a point. Each Python words an error its own way: its kind is compared.
    """
    if wanted is ZeroDivisionError:
        return isinstance(there, str) and there.startswith("ZeroDivisionError: ")
    return bool(float(there) == wanted) if isinstance(wanted, float) else bool(there == wanted)


@needs_node
def test_expressions_have_the_same_value(tmp_path: Path) -> None:
    """All are gathered first and run in one Node.js; the shortest that differs is shown."""
    gathered: list[tuple[str, dict[str, Any], Any]] = []

    @settings(max_examples=100, database=None, phases=[Phase.generate])
    @given(expression=expressions, names=values)
    def gather(expression: str, names: dict[str, Any]) -> None:
        gathered.append((expression, names, _value(expression, names)))

    gather()
    text = "\n".join(f"def f{at}({NAMES}):\n    return {case[0]}\n" for at, case in enumerate(gathered))
    write(tmp_path, translate({"sample": ("sample.py", text)}, {}))
    calls = (
        ("sample", f"f{at}", *(names[each] for each in "abxpstfl"))
        for at, (_, names, _) in enumerate(gathered)
    )
    differ = [
        f"{expression} of {names} is {wanted}, in JavaScript {there}"
        for (expression, names, wanted), there in zip(gathered, called(*calls, folder=tmp_path), strict=True)
        if not _same(there, wanted)
    ]
    assert not differ, f"{len(differ)} of {len(gathered)}: {min(differ, key=len)}"


@needs_node
def test_an_item_is_set_within_a_list_only() -> None:
    put = "pdp8/web/translator/runtime", "put", [1, 2]
    *within, below, above = called(*((*put, index, 3) for index in (-2, 1, -3, 2)))
    assert within == [None, None]
    assert {below, above} == {"IndexError: list assignment index out of range"}
