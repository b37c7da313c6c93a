"""The assertions of CPython's own tests that are closed: of nothing but constants and built-in names.

Each becomes specimens: `main() -> str` that shows what is asserted, once as a text and once as its truth.
"""

import ast
import builtins
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

_MODULES = (
    "string_tests list_tests seq_tests test_array test_augassign test_bisect test_bool test_builtin"
    " test_bytes test_compare test_contains test_dict test_dictcomps test_enumerate test_float test_format"
    " test_fractions test_fstring test_grammar test_html test_index test_int test_int_literal"
    " test_isinstance test_itertools test_iter test_list test_listcomps test_long test_math test_operator"
    " test_pow test_range test_set test_setcomps test_slice test_str test_string test_tuple test_unicode"
    " test_unpack test_unpack_ex"
)
_TRUE = {
    "assertEqual": "{} == {}", "assertNotEqual": "{} != {}", "assertIs": "{} is {}",
    "assertIsNot": "{} is not {}",
    "assertIn": "{} in {}", "assertNotIn": "{} not in {}", "assertLess": "{} < {}",
    "assertLessEqual": "{} <= {}",
    "assertGreater": "{} > {}", "assertGreaterEqual": "{} >= {}", "assertListEqual": "{} == {}",
    "assertSequenceEqual": "{} == {}", "assertDictEqual": "{} == {}", "assertTupleEqual": "{} == {}",
    "eq": "{} == {}",
    "assertTrue": "{}", "assertFalse": "{}", "assertIsNone": "{}", "assertIsNotNone": "{}",
}  # fmt: skip
_KNOWN = frozenset(dir(builtins)) - {
    "open",
    "input",
    "exit",
    "quit",
    "breakpoint",
    "eval",
    "exec",
    "__import__",
}


class Assertion(NamedTuple):
    """An assertion, by its module and line, as programs: if any of them is accepted it has to be right."""

    name: str
    programs: list[str]


def assertions() -> Iterator[Assertion]:
    """Yield the closed assertions of the test suite, as far as it is installed."""
    for module in _MODULES.split():
        spec = find_spec(f"test.{module}") if find_spec("test") else None
        if spec is None or spec.origin is None:
            continue
        tree = ast.parse(Path(spec.origin).read_text(encoding="utf-8"))
        for number, call in enumerate(each for each in ast.walk(tree) if isinstance(each, ast.Call)):
            programs = [_program(body) for body in _shown(call)]
            if programs:
                yield Assertion(f"{module}_{call.lineno}_{number}", programs)


def _program(body: str) -> str:
    return f"def main() -> str:\n{body}\n"


def _shown(call: ast.Call) -> Iterator[str]:
    """Yield the statements that show what a call asserts; none if it is no assertion, or not closed."""
    name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
    args = call.args
    if call.keywords or any(isinstance(each, ast.Starred) for each in args):
        return
    if name == "checkequal" and len(args) >= 3 and isinstance(method := args[2], ast.Constant):
        result, of, _, *rest = args
        call_of = ast.Call(ast.Attribute(of, str(method.value), ast.Load()), rest, [])
        yield from _values("{} == {}", [call_of, result])
    elif name == "checkraises" and len(args) >= 3 and isinstance(method := args[2], ast.Constant):
        error, of, _, *rest = args
        yield from _errors(error, ast.Call(ast.Attribute(of, str(method.value), ast.Load()), rest, []))
    elif name == "assertRaises" and len(args) >= 2:
        error, function, *rest = args
        yield from _errors(error, ast.Call(function, rest, []))
    elif name in _TRUE and len(args) >= _TRUE[name].count("{}"):
        yield from _values(_TRUE[name], args[: _TRUE[name].count("{}")])


def _values(truth: str, args: list[ast.expr]) -> Iterator[str]:
    if all(map(_closed, args)):
        texts = [f"({ast.unparse(each)})" for each in args]
        yield f"    return repr(bool({truth.format(*texts)}))"
        yield from (f"    return repr({text})" for text in texts[:1])


def _errors(error: ast.expr, call: ast.Call) -> Iterator[str]:
    if _closed(call) and isinstance(error, ast.Name) and error.id in _KNOWN:
        for caught in (error.id, "Exception"):
            tried = f"    try:\n        return repr({ast.unparse(call)})\n"
            yield f"{tried}    except {caught}:\n        return 'raised'"


def _closed(node: ast.expr) -> bool:
    """Whether an expression has only constants, built-in names and names of its own."""
    own = {each.arg for each in ast.walk(node) if isinstance(each, ast.arg)}
    own |= {
        each.id for each in ast.walk(node) if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
    }
    names = {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}
    return names <= _KNOWN | own and not any(
        isinstance(each, ast.Await | ast.Yield) for each in ast.walk(node)
    )
