"""Python's operators: the type of what each gives, what JavaScript and the runtime have for it, and when."""

import ast
from typing import NamedTuple

from pdp8.web.translator.types import (
    ANY,
    BOOL,
    FLOAT,
    INT,
    NUMBERS,
    REAL,
    WHOLE,
    WORD,
    Type,
    item_of,
    join,
    widened,
)


class Operator(NamedTuple):
    """The ways to write an operator in JavaScript."""

    direct: str
    """JavaScript's own."""
    runtime: str
    """The runtime's, of any two types."""
    exact: str
    """The runtime's, of whole numbers of any size."""
    floats: str = ""
    """The runtime's, of numbers of which one is a float; "" if JavaScript's own does it, or none."""


class Operand(NamedTuple):
    """An operand: as it is written, its type, and its value if it is a constant whole number."""

    text: str
    kind: Type
    number: int | None


OPERATORS: dict[type[ast.operator], Operator] = {
    ast.Add: Operator("({} + {})", "add", "plus"),
    ast.Sub: Operator("({} - {})", "sub", "minus"),
    ast.Mult: Operator("({} * {})", "mul", "times"),
    ast.Div: Operator("({} / {})", "div", "div", "div_"),
    ast.FloorDiv: Operator("Math.floor({} / {})", "floordiv", "floordiv", "floordiv_"),
    ast.Mod: Operator("({} % {})", "mod", "mod", "mod_"),
    ast.LShift: Operator("({} * 2 ** {})", "shl", "shl"),
    ast.RShift: Operator("({} >> {})", "shr", "shr"),
    ast.Pow: Operator("({} ** {})", "power_", "power", "power_"),
    ast.BitAnd: Operator("({} & {})", "and_", "and_"),
    ast.BitOr: Operator("({} | {})", "or_", "or_"),
    ast.BitXor: Operator("({} ^ {})", "xor", "xor"),
}


def is_direct(operator: ast.operator, left: Operand, right: Operand, checked: bool) -> bool:
    """Whether JavaScript's own operator gives what Python's does, of numbers below 2^53 if not `checked`."""
    words, second = left.kind == right.kind == WORD, right.number
    match operator:
        case ast.Add() | ast.Sub():
            return words or not checked
        case ast.Mult():
            small = any(each.number is not None and each.number < 1 << 22 for each in (left, right))
            return (words and small) or not checked
        case ast.Div() | ast.FloorDiv():
            return bool(second) and (words or not checked)
        case ast.Mod():
            return bool(second) and words
        case ast.RShift():
            return words and second is not None and second < 32
        case ast.LShift():
            return (left.kind == WORD and second is not None and 0 <= second <= 21) or not checked
        case ast.Pow():
            return not checked
        case ast.BitAnd():
            return words or (WORD in (left.kind, right.kind) and not checked)
    return words


def arithmetic(operator: ast.operator, left: Type, right: Type) -> Type:
    """Return the type of `left operator right`."""
    if left == right == BOOL:
        return BOOL if isinstance(operator, ast.BitAnd | ast.BitOr | ast.BitXor) else INT
    left, right = (INT if each == BOOL else each for each in (left, right))
    if isinstance(operator, ast.BitAnd) and WORD in (left, right):
        return WORD
    if left in NUMBERS and right in NUMBERS:
        return _of_numbers(operator, left, right)
    if isinstance(operator, ast.Mult) and INT in map(widened, (left, right)):
        of = right if left in WHOLE else left
        if of.name == "tuple":
            return Type("row", (item_of(of),))
        return of if of.name in ("str", "bytes", "list", "row") else ANY
    if left.name == right.name == "tuple":
        return Type("tuple", left.of + right.of)
    if {left.name, right.name} <= {"tuple", "row"}:
        return Type("row", (join(item_of(left), item_of(right)),))
    if left.name == "Fraction":
        return left
    joined = join(left, right)
    return joined if joined.name == left.name == right.name else ANY


def _of_numbers(operator: ast.operator, left: Type, right: Type) -> Type:
    match operator:
        case ast.Div():
            return FLOAT
        case _ if FLOAT in (left, right):
            return FLOAT
        case ast.Pow():
            return ANY if right != WORD else REAL if left == REAL else INT
        case _ if REAL in (left, right):
            return REAL
        case ast.BitOr() | ast.BitXor() | ast.Mod() | ast.FloorDiv():
            return WORD if left == right == WORD else INT
        case ast.RShift():
            return WORD if left == WORD else INT
    return INT
