"""Which names of a function have a value where they are read.

In Python a name without one is an error when it is read, in JavaScript it is `undefined`. So a name that may
have none is refused: one that is set only in a branch, or in a loop that may not run.
"""

import ast
from collections.abc import Iterable
from functools import reduce

from pdp8.web.translator.expressions import Expressions
from pdp8.web.translator.types import whole

_Names = frozenset[str] | None
"""The names that have a value; None where control never comes."""


class Assigned:
    """Goes through a function's statements; `known` are its parameters, `local` all names that it sets."""

    def __init__(self, local: Iterable[str], expressions: Expressions) -> None:
        self._local = frozenset(local)
        self._expressions = expressions
        self._breaks: list[list[frozenset[str]]] = []
        self._continues: list[list[frozenset[str]]] = []

    def after(self, body: list[ast.stmt], known: _Names) -> _Names:
        """Return the names that have a value after these statements; None if control never comes there."""
        for node in body:
            if known is None:
                return None
            known = self._statement(node, known)
        return known

    def _statement(self, node: ast.stmt, known: frozenset[str]) -> _Names:
        match node:
            case ast.If(test, body, other):
                where_true = self._if_true(test, known)
                return _both(self.after(body, where_true), self.after(other, self._read(test, known)))
            case ast.While(test, body):
                where_true, known = self._if_true(test, known), self._read(test, known)
                endless = isinstance(test, ast.Constant) and bool(test.value)
                return self._loop(body, where_true, None if endless else known)
            case ast.For(target, source, body):
                known = self._read(source, known)
                runs = _runs(self._expressions.constant(source))
                return self._loop(body, known | _set_in(target), known, runs)
            case ast.Try(body, handlers, _, last):
                found = self.after(body, known)
                for handler in handlers:
                    own = frozenset({handler.name or ""})  # it has no value after the handler
                    end = self.after(handler.body, known | own)
                    found = _both(found, end if end is None else end - own)
                end = self.after(last, known)
                return found | (end - known) if found is not None and end is not None else None
            case ast.With(items, body):
                for item in items:
                    known = self._read(item.context_expr, known)
                return self.after(body, known)
            case ast.Return() | ast.Raise():
                self._read(node, known)
                return None
            case ast.Break():
                self._breaks[-1].append(known)
                return None
            case ast.Continue():
                self._continues[-1].append(known)
                return None
            case ast.FunctionDef(name):
                return known | {name}
            case ast.AugAssign(target, _, value):
                if isinstance(target, ast.Name):
                    self._read(ast.Name(target.id, ast.Load(), lineno=node.lineno), known)
                return self._read(value, self._read(target, known))
            case ast.Expr(ast.Call() as call) if self._expressions.never(call):
                self._read(node, known)
                return None
        return self._read(node, known) | _set_in(node)

    def _loop(
        self, body: list[ast.stmt], inside: frozenset[str], after: _Names, runs: bool = False
    ) -> _Names:
        """Return the names that have a value after a loop; `runs`: its body does so at least once."""
        self._breaks.append([])
        self._continues.append([])
        end = self.after(body, inside)
        end = reduce(_both, self._continues.pop(), end)
        return reduce(_both, self._breaks.pop(), end if runs else after)

    def _if_true(self, test: ast.expr, known: frozenset[str]) -> frozenset[str]:
        """Return what is known where a test is true."""
        parts = test.values if isinstance(test, ast.BoolOp) and isinstance(test.op, ast.And) else [test]
        for part in parts:
            known = self._read(part, known)
        return known

    def _read(self, node: ast.AST, known: frozenset[str]) -> frozenset[str]:
        """Refuse a name that may have no value; return what is known behind the expression."""
        match node:
            case ast.Name(name, ast.Load()) if name in self._local - known:
                self._expressions.fail(node, "it may have no value here")
            case ast.Lambda():
                pass
            case ast.ListComp() | ast.SetComp() | ast.DictComp() | ast.GeneratorExp():
                inner = known
                for generator in node.generators:
                    inner = self._read(generator.iter, inner) | _set_in(generator.target)
                    for test in generator.ifs:
                        inner = self._read(test, inner)
                made = (node.key, node.value) if isinstance(node, ast.DictComp) else (node.elt,)
                for part in filter(None, made):  # {**a for a in b} of Python 3.15 has no value
                    self._read(part, inner)
            case ast.NamedExpr(target, value):
                return self._read(value, known) | _set_in(target)
            case ast.BoolOp(_, [first, *rest]):
                known = inner = self._read(first, known)
                for value in rest:
                    inner = self._read(value, inner)
            case ast.IfExp(test, body, other):
                self._read(body, self._if_true(test, known))
                known = self._read(test, known)
                self._read(other, known)
            case _:
                for child in ast.iter_child_nodes(node):
                    known = self._read(child, known)
        return known


def _both(one: _Names, other: _Names) -> _Names:
    if one is None or other is None:
        return other if one is None else one
    return one & other


def _set_in(node: ast.AST) -> frozenset[str]:
    """Return the names that a target or a plain statement sets; a comprehension's are its own."""
    inner = [each.target for each in ast.walk(node) if isinstance(each, ast.comprehension)]
    own = {*ast.walk(node)}.difference(*map(ast.walk, inner))
    return frozenset(
        each.id for each in own if isinstance(each, ast.Name) and isinstance(each.ctx, ast.Store)
    )


def _runs(source: ast.AST) -> bool:
    """Whether a loop over this runs at least once: over a display, or a range of constants."""
    match source:
        case ast.Tuple(items) | ast.List(items):
            return any(not isinstance(each, ast.Starred) for each in items)
        case ast.Call(ast.Name("enumerate"), [ast.Tuple() | ast.List() as inner, *_]):
            return _runs(inner)
        case ast.Call(ast.Name("range"), [_] | [_, _] | [_, _, _] as args):
            numbers = [number for each in args if (number := whole(each)) is not None]
            return len(numbers) == len(args) and 0 not in numbers[2:] and bool(range(*numbers))
    return False
