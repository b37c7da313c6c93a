"""The mutants of a source: one change each, of the kinds that people make.

    a < b     a <= b, a >= b        not a     a            return a     return None
    a + b     a - b                 a and b   a or b, a, b f(a)         (nothing)
    7         8                     if a      if not a     x.y = a      (nothing)
    "word"    "word?"               case a if b   if True  raise E      (nothing)

Not changed: docstrings, annotations, decorators, imports, assertions (`strict` of zip is one), texts with a
space or in an f-string (what messages say), help and metavar, what stands only for a type checker, and the
name of a codec, of which Python reads letters and digits alone.
"""

import ast
from collections.abc import Iterator
from types import CodeType
from typing import Any, NamedTuple

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
_FIELDS_FOR_READERS = {"annotation", "returns", "decorator_list", "format_spec"}


class Mutant(NamedTuple):
    """One change: `after` for `before`, which stands at `key` of a list or of the fields of a node.

    `lines`: of its statement, up to it.
    """

    tree: ast.Module
    holder: Any
    key: int | str
    before: ast.expr | ast.stmt
    after: ast.expr | ast.stmt
    lines: range
    scope: str

    @property
    def text(self) -> str:
        """Return the change in one line."""
        after = "(nothing)" if isinstance(self.after, ast.Pass) else ast.unparse(self.after)
        return " ".join(f"{ast.unparse(self.before)} → {after}".split())

    def code(self, path: str) -> CodeType:
        """Return the module, from `path`, with the change."""
        self.holder[self.key] = ast.copy_location(self.after, self.before)
        code: CodeType = compile(ast.fix_missing_locations(self.tree), path, "exec")
        self.holder[self.key] = self.before
        return code


def mutants(source: str) -> list[Mutant]:
    tree = ast.parse(source)
    return list(_mutants(tree, tree, (), 0))


def _mutants(tree: ast.Module, parent: ast.AST, scope: tuple[str, ...], statement: int) -> Iterator[Mutant]:
    """Yield the mutants within a node, which is of the statement on a line."""
    for field, value in ast.iter_fields(parent):
        if field in _FIELDS_FOR_READERS:
            continue
        holder, nodes = (
            (value, enumerate(value)) if isinstance(value, list) else (vars(parent), [(field, value)])
        )
        for key, node in nodes:
            if not isinstance(node, ast.AST) or _for_readers(parent, node):
                continue
            first = node.lineno if isinstance(node, ast.stmt) else statement
            if isinstance(node, ast.expr | ast.stmt):
                lines = range(first, node.lineno + 1)
                for after in (*_conditions(field, node), *_changes(node)):
                    yield Mutant(tree, holder, key, node, after, lines, ".".join(scope))
            inner = (*scope, node.name) if isinstance(node, ast.FunctionDef | ast.ClassDef) else scope
            yield from _mutants(tree, node, inner, first)


def _for_readers(parent: ast.AST, node: ast.AST) -> bool:
    match parent, node:
        case _, ast.Expr(ast.Constant()) | ast.Import() | ast.ImportFrom() | ast.Assert():
            return True
        case ast.JoinedStr(), ast.Constant():
            return True
        case ast.Call(), ast.keyword("strict" | "help" | "metavar" | "encoding"):
            return True
        case ast.Call(ast.Attribute(attr="encode" | "decode")), ast.Constant():
            return True
        case _, ast.If(ast.Name("TYPE_CHECKING")) | ast.Assign([ast.Name("__all__")]):
            return True
    return False


def _conditions(field: str, node: ast.expr | ast.stmt) -> Iterator[ast.expr]:
    """Yield what may stand for the condition of an if, a while or a case, if the field is that."""
    match field, node:
        case "guard", ast.expr():
            yield ast.Constant(True)
        case "test", ast.Compare() | ast.UnaryOp() | ast.BoolOp():
            return  # changed as a comparison, or by its `not`
        case "test", ast.expr():
            yield ast.UnaryOp(ast.Not(), node)


def _changes(node: ast.expr | ast.stmt) -> Iterator[ast.expr | ast.stmt]:
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
            for left_out in range(len(values)):
                rest = values[:left_out] + values[left_out + 1 :]
                yield rest[0] if len(rest) == 1 else ast.BoolOp(junction, rest)
        case ast.UnaryOp(ast.Not() | ast.USub(), operand):
            yield operand
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
