"""y = f(x) as a command takes it: sin(x)/x, 0.2*x*(x-2)*(x-6).

LANGUAGE says what it has; capitals, as FORTRAN writes them, are the same. Python's parser makes a
tree of it; each node of the tree that is listed here becomes a function, any other is refused with its
column. Nothing is evaluated as Python.
"""

import ast
import math
import operator
from collections.abc import Callable
from typing import Final

from tapes.errors import WorkError

FUNCTIONS: Final[dict[str, Callable[[float], float]]] = {
    name: getattr(math, name)
    for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh")
} | {"abs": abs}
CONSTANTS: Final = {"pi": math.pi, "e": math.e}
LANGUAGE: Final = f"numbers, x, {', '.join(CONSTANTS)}, + - * / ** ( ) and {', '.join(FUNCTIONS)}"

_OPERATORS: Final[dict[type[ast.operator], Callable[[float, float], float]]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Pow: math.pow,
}
_LONGEST = 500
_LARGEST = 1e6

Function = Callable[[float], float]


def function(text: str) -> Function:
    """Return the function. Raises WorkError with the column of what is not in the language.

    The function raises WorkError where it has no value.
    """
    if len(text) > _LONGEST:
        raise WorkError(f"expression of {len(text)} characters: at most {_LONGEST} are allowed")
    try:
        text = text.strip()
        inner = _node(_tree(text), text)
    except OverflowError:
        raise WorkError(f"a number of {text[:20]!r}... is too large") from None
    except (RecursionError, MemoryError):
        raise WorkError(f"{text[:20]!r}... is nested too deeply") from None

    def value(x: float) -> float:
        try:
            found = inner(float(x))
        except (ArithmeticError, ValueError, RecursionError) as error:
            raise WorkError(f"at x = {x:g} the expression {text!r} has no value: {error}") from None
        if not abs(found) < _LARGEST:
            raise WorkError(f"at x = {x:g} the expression {text!r} is {found:g}: must be within {_LARGEST:g}")
        return found

    return value


def _tree(text: str) -> ast.expr:
    try:
        return ast.parse(text.lower() if text.isascii() else text, mode="eval").body
    except (SyntaxError, ValueError) as error:
        column = getattr(error, "offset", None) or 1
        raise WorkError(f"column {column}: {text!r} is not an expression in x: {LANGUAGE}") from None


def _node(node: ast.expr, text: str) -> Function:
    match node:
        case ast.Constant(value=int() | float() as number) if not isinstance(number, bool):
            constant = float(number)
            return lambda x: constant
        case ast.Name(id="x"):
            return lambda x: x
        case ast.Name(id=name) if name in CONSTANTS:
            named = CONSTANTS[name]
            return lambda x: named
        case ast.UnaryOp(op=ast.UAdd(), operand=operand):
            return _node(operand, text)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            negated = _node(operand, text)
            return lambda x: -negated(x)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            join, one, other = _OPERATORS[type(op)], _node(left, text), _node(right, text)
            return lambda x: join(one(x), other(x))
        case ast.Call(func=ast.Name(id=name), args=[argument], keywords=[]) if name in FUNCTIONS:
            outer, inner = FUNCTIONS[name], _node(argument, text)
            return lambda x: outer(inner(x))
    said = ast.get_source_segment(text, node) or text
    hint = (
        "; a power is written **" if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitXor) else ""
    )
    raise WorkError(
        f"column {node.col_offset + 1}: {said!r} is not in the language of expressions: {LANGUAGE}{hint}"
    )
