"""The types of expressions, as the translator infers them from annotations and from what is assigned.

    word    a whole number from 0 to 2^31: JavaScript's operators of 32 bits are right for it
    int     any other whole number
    float   a float for sure; real is what is annotated as one, which may be an int too
    list, tuple, row (a tuple of any length), sequence (any of them), iterator, iterable, dict, view, set
    words   an array of numbers below 2^16
    call    what can be called: what it returns, and what it takes
    |       one of several
    a class by `module.Class`
    ?       nothing is known
    unseen  nothing yet: the items of an empty list

JavaScript does not tell 1 from 1.0, a list from a tuple: where that would be seen, the type decides.
"""

import ast
from functools import cache
from typing import NamedTuple


class Type(NamedTuple):
    """The type of an expression, and of the items in it."""

    name: str
    of: tuple["Type", ...] = ()

    def __str__(self) -> str:
        if self.name == "|":
            return " | ".join(map(str, self.of))
        name = _READ.get(self.name, self.name.rpartition(".")[2])
        return f"{name}[{', '.join(map(str, self.of))}]" if self.of else name


_READ = {"?": "a value of unknown type", "word": "int", "real": "float", "row": "tuple", "unseen": "?"}

ANY, NONE, UNSEEN = Type("?"), Type("None"), Type("unseen")
WORD, INT, FLOAT, REAL = Type("word"), Type("int"), Type("float"), Type("real")
BOOL, STR = Type("bool"), Type("str")
BYTES, BYTEARRAY, WORDS = Type("bytes"), Type("bytearray"), Type("words")
WHOLE = (WORD, INT)
FLOATS = (FLOAT, REAL)
NUMBERS = (*WHOLE, *FLOATS)
MUTABLE = ("list", "dict", "set")
_ITEMS = {"bytes": WORD, "bytearray": WORD, "words": WORD, "str": STR}


def leaf(node: ast.AST | None) -> str:
    """Return the last name of a dotted, called or subscripted expression, "" if it is another one."""
    if isinstance(node, ast.Subscript):
        return leaf(node.value)
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def either(kind: Type) -> tuple[Type, ...]:
    """Return the types that something of `kind` may have."""
    return kind.of if kind.name == "|" else (kind,)


def join(*kinds: Type) -> Type:
    """Return the type of a value that has one of these types."""
    found: list[Type] = []
    for kind in (each for one in kinds for each in either(one)):
        if kind == ANY:
            return ANY
        if kind == UNSEEN or kind in found:
            continue
        for at, other in enumerate(found):
            if (both := _merged(other, kind)) is not None:
                found[at] = both
                break
        else:
            found.append(kind)
    return Type("|", tuple(found)) if len(found) > 1 else found[0] if found else UNSEEN


def _merged(one: Type, other: Type) -> Type | None:
    """Return the type that takes in both, None if there is none but their union."""
    if one in NUMBERS and other in NUMBERS:
        return INT if one in WHOLE and other in WHOLE else REAL
    names = {one.name, other.name}
    if names == {"tuple"} and len(one.of) == len(other.of):
        return Type("tuple", tuple(map(join, one.of, other.of)))
    if names <= {"tuple", "row"}:
        return Type("row", (join(*one.of, *other.of),))
    if len(names) == 1:
        return Type(one.name, tuple(map(join, one.of, other.of)))
    return None


def without_none(kind: Type) -> Type:
    """Return what `kind` is when it is not None."""
    return join(*(each for each in either(kind) if each != NONE)) if kind.name == "|" else kind


def widened(kind: Type) -> Type:
    """Return the type of an attribute or item whose first value has type `kind`, and which may change."""
    if kind == WORD:
        return INT
    return Type(kind.name, tuple(map(widened, kind.of)))


def made(name: str, *of: Type) -> Type:
    """Return the type of a list, set or dict of `of`."""
    return Type(name, tuple(map(widened, of)) if name in MUTABLE else of)


def item_of(kind: Type) -> Type:
    """Return the type of what an iteration yields; not for a class of ours."""
    if kind.name == "tuple":
        return join(*kind.of)
    return _ITEMS.get(kind.name) or (kind.of[0] if kind.of else ANY)


def filled(pattern: Type, given: dict[str, Type]) -> Type:
    """Return `pattern` with its type variables replaced."""
    if pattern.name[0] == "~":
        return given.get(pattern.name, UNSEEN)
    if pattern.name == "|":
        return join(*(filled(each, given) for each in pattern.of))
    return made(pattern.name, *(filled(each, given) for each in pattern.of)) if pattern.of else pattern


@cache
def whole(node: ast.AST | None) -> int | None:
    """Return the value of an expression that consists only of whole numbers; None for any other."""
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
        value = eval(compile(ast.Expression(node), "", "eval"))
    except (ArithmeticError, ValueError):  # it raises when it runs
        return None
    return value if type(value) is int else None
