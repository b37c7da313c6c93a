"""What is known of an expression before it runs: its type, from annotations and from what is assigned.

    word    a whole number from 0 to 2^31: JavaScript's operators of 32 bits are right for it
    int     any other whole number, exact to 2^53
    float, bool, str
    list    any sequence, and words, an array of numbers, each with the type of its items
    a class by `module.Class`
    ?       nothing is known: the runtime looks when it runs

`X | None` counts as X. An attribute is an int at least, whatever it begins with. Types make the machine fast;
without one an expression means the same.
"""

import ast
from functools import cache
from typing import NamedTuple


class Type(NamedTuple):
    """The type of an expression, and of the items in it."""

    name: str
    of: "Type | None" = None

    @property
    def item(self) -> "Type":
        """What an iteration yields."""
        return self if self == STR else self.of or ANY


ANY, NONE, UNSEEN = Type("?"), Type("None"), Type("unseen")
WORD, INT, FLOAT, BOOL, STR = Type("word"), Type("int"), Type("float"), Type("bool"), Type("str")
BYTES, WORDS = Type("list", WORD), Type("words", WORD)
NUMBERS = (WORD, INT, FLOAT)
PLAIN = (*NUMBERS, BOOL, STR)


def leaf(node: ast.AST | None) -> str:
    """Return the last name of a dotted, called or subscripted expression, "" if it is another one."""
    if isinstance(node, ast.Subscript):
        return leaf(node.value)
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def join(one: Type, other: Type) -> Type:
    """Return the type of what is one or the other."""
    if one == other or other in (NONE, UNSEEN):
        return one
    if one in (NONE, UNSEEN):
        return other
    return max(one, other, key=NUMBERS.index) if one in NUMBERS and other in NUMBERS else ANY


@cache
def whole(node: ast.AST | None) -> int | None:
    """Return the value of an expression of whole numbers alone, None for any other."""
    match node:
        case ast.Constant(value):
            return value if type(value) is int else None
        case ast.BinOp(left, _, right) if whole(left) is not None and whole(right) is not None:
            pass
        case ast.UnaryOp(_, operand) if whole(operand) is not None:
            pass
        case _:
            return None
    try:
        value = eval(compile(ast.Expression(node), "<constant>", "eval"))
    except (ArithmeticError, ValueError):  # it raises when it runs
        return None
    return value if type(value) is int else None
