"""The mutants of a source: one change each, of the kinds that people make.

    a < b     a <= b, a >= b        not a     a            return a    return None
    a + b     a - b                 a and b   a or b       f(a)        (nothing)
    7         8                     if a      if not a     x.y = a     (nothing)
    "word"    "word?"               case a if b   case a   raise E     (nothing)

Not changed: docstrings, annotations, decorators, imports, assertions (`strict` of zip is one), texts with a
space or in an f-string (what messages say), help and metavar, what stands only for a type checker, and the
name of a codec, of which Python reads letters and digits alone.
"""

import ast
from collections.abc import Iterator
from typing import NamedTuple

_COMPARE: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.GtE),
    ast.LtE: (ast.Lt, ast.Gt),
    ast.Gt: (ast.GtE, ast.LtE),
    ast.GtE: (ast.Gt, ast.Lt),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
}
_OPERATOR: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Add,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.Mod: ast.FloorDiv,
    ast.Pow: ast.Mult,
    ast.LShift: ast.RShift,
    ast.RShift: ast.LShift,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
    ast.BitXor: ast.BitOr,
}
_FOR_READERS = (ast.Import, ast.ImportFrom, ast.Assert)
_FIELDS_FOR_READERS = {"annotation", "returns", "decorator_list", "format_spec"}


class Mutant(NamedTuple):
    """One change. `lines`: of its statement, up to it; `whole`: it works outside every function."""

    number: int
    lines: range
    scope: str
    before: str
    after: str
    whole: bool
    tree: ast.Module

    @property
    def text(self) -> str:
        """Return the change in one line."""
        return f"{' '.join(self.before.split())} → {' '.join(self.after.split())}"


class _Place(NamedTuple):
    """A node that may change: the field of its parent that holds it, and which element of a list."""

    parent: ast.AST
    field: str
    element: int | None
    node: ast.expr | ast.stmt
    scope: tuple[str, ...]
    statement: int
    inside: bool

    def put(self, node: ast.AST) -> None:
        if self.element is None:
            setattr(self.parent, self.field, node)
        else:
            getattr(self.parent, self.field)[self.element] = node


def mutants(source: str) -> Iterator[Mutant]:
    """Yield the mutants of a source in order; `tree` has the change until the next is asked for."""
    tree = ast.parse(source)
    number = 0
    for place in _places(tree, (), 0, inside=False):
        for after in _changes(place.node):
            put = ast.copy_location(after, place.node)
            place.put(ast.fix_missing_locations(put))
            yield Mutant(
                number,
                range(place.statement, place.node.lineno + 1),
                ".".join(place.scope),
                *_shown(place.node, after),
                not place.inside,
                tree,
            )
            number += 1
        place.put(place.node)


def _shown(node: ast.AST, after: ast.AST) -> tuple[str, str]:
    """Return the text of what changes, and of what it becomes."""
    match node, after:
        case ast.If(test) | ast.While(test), ast.If(other) | ast.While(other):
            return f"if {ast.unparse(test)}", f"if {ast.unparse(other)}"
        case ast.Match(cases=cases), ast.Match(cases=others):
            case = next(case for case, changed in zip(cases, others, strict=True) if case is not changed)
            assert case.guard
            return f"if {ast.unparse(case.guard)}", "(always)"
        case _, ast.Pass():
            return ast.unparse(node), "(nothing)"
    return ast.unparse(node), ast.unparse(after)


def _places(parent: ast.AST, scope: tuple[str, ...], statement: int, inside: bool) -> Iterator[_Place]:
    """Yield every node that may change, each before what is in it."""
    for field, value in ast.iter_fields(parent):
        if field in _FIELDS_FOR_READERS:
            continue
        within = inside or (isinstance(parent, ast.FunctionDef) and field == "body")
        children = enumerate(value) if isinstance(value, list) else ((None, value),)
        for index, node in children:
            if not isinstance(node, ast.AST) or _for_readers(parent, node):
                continue
            if isinstance(node, ast.stmt):
                statement = node.lineno
            if isinstance(node, ast.expr | ast.stmt):
                yield _Place(parent, field, index, node, scope, statement, within)
            deeper = (*scope, node.name) if isinstance(node, ast.FunctionDef | ast.ClassDef) else scope
            yield from _places(node, deeper, statement, within)


def _for_readers(parent: ast.AST, node: ast.AST) -> bool:
    match parent, node:
        case _, ast.Expr(ast.Constant()):
            return True
        case ast.JoinedStr(), ast.Constant():
            return True
        case ast.Call(), ast.keyword("strict" | "help" | "metavar" | "encoding"):
            return True
        case ast.Call(ast.Attribute(attr="encode" | "decode")), ast.Constant():
            return True
        case _, ast.If(ast.Name("TYPE_CHECKING")) | ast.Assign([ast.Name("__all__")]):
            return True
    return isinstance(node, _FOR_READERS)


def _changes(node: ast.expr | ast.stmt) -> Iterator[ast.AST]:
    """Yield what may stand in place of a node."""
    match node:
        case ast.Compare(left, [comparison, *others], right):
            for other in _COMPARE[type(comparison)]:
                yield ast.Compare(left, [other(), *others], right)
        case ast.BinOp(left, operator, value) if type(operator) in _OPERATOR:
            yield ast.BinOp(left, _OPERATOR[type(operator)](), value)
        case ast.AugAssign(target, operator, value) if type(operator) in _OPERATOR:
            yield ast.AugAssign(target, _OPERATOR[type(operator)](), value)
            yield ast.Pass()
        case ast.BoolOp(junction, values):
            yield ast.BoolOp(ast.Or() if isinstance(junction, ast.And) else ast.And(), values)
        case ast.UnaryOp(ast.Not() | ast.USub(), operand):
            yield operand
        case ast.IfExp(test, body, orelse) if _truth(test):
            yield ast.IfExp(ast.UnaryOp(ast.Not(), test), body, orelse)
        case ast.If(test, then, other_then) if _truth(test):
            yield ast.If(ast.UnaryOp(ast.Not(), test), then, other_then)
        case ast.While(test, loop, after) if _truth(test):
            yield ast.While(ast.UnaryOp(ast.Not(), test), loop, after)
        case ast.Constant(bool() as flag):
            yield ast.Constant(not flag)
        case ast.Constant(int() | float() as figure):
            yield ast.Constant(figure + 1)
        case ast.Constant(str() as word) if word and " " not in word:
            yield ast.Constant(f"{word}?")
        case ast.Constant(bytes() as frames) if frames:
            yield ast.Constant(frames + b"?")
        case ast.Return(ast.expr() as found) if ast.unparse(found) not in ("None", "False"):
            yield ast.Return(ast.Constant(None))
        case ast.Expr() | ast.Raise() | ast.Delete() | ast.Assign([ast.Attribute() | ast.Subscript()]):
            yield ast.Pass()
        case ast.Break():
            yield ast.Continue()
        case ast.Continue():
            yield ast.Break()
        case ast.Match(subject, cases):
            for index, case in enumerate(cases):
                if case.guard is not None:
                    free = ast.match_case(case.pattern, None, case.body)
                    yield ast.Match(subject, [*cases[:index], free, *cases[index + 1 :]])


def _truth(test: ast.expr) -> bool:
    """Tell whether a condition is not changed already, as a comparison or by its `not`."""
    return not isinstance(test, ast.Compare | ast.UnaryOp | ast.BoolOp)
