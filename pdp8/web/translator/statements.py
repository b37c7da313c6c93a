"""Statements, as lines of JavaScript; a chain of `if x == 1: ... elif x == 2: ...` becomes a `switch`.

A function's names are declared at its beginning, since in Python they are the whole function's.
"""

import ast

from pdp8.web.translator.expressions import Expressions, named
from pdp8.web.translator.inference import own
from pdp8.web.translator.types import ANY, PLAIN, WORD, leaf, whole

_MARKS = {"property", "setter", "cached_property", "contextmanager", "staticmethod", "cache"}
_FEW = 5
"""Cases that are left to `if`."""


class Statements(Expressions):
    """Writes the statements of one module."""

    loops: list[str]
    """The labels of the loops around."""

    def block(self, nodes: list[ast.stmt]) -> list[str]:
        """Return statements, one after another."""
        return [line for node in nodes for line in self.s(node)]

    def s(self, node: ast.stmt) -> list[str]:
        """Return one statement."""
        match node:
            case ast.Expr(ast.Constant()) | ast.Pass() | ast.Assert():
                return []
            case ast.Import() | ast.ImportFrom() | ast.Nonlocal() | ast.AnnAssign(value=None):
                return []
            case ast.Expr(value):
                return [self.e(value) + ";"]
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if len(targets) == len(values):
                return self._all(targets, values)
            case ast.Assign([target], value) | ast.AnnAssign(target, _, ast.expr() as value):
                return [self.put(target, self.e(value))]
            case ast.Assign(targets, value):
                once = self.temp()
                return [f"{once} = {self.e(value)};", *(self.put(target, once) for target in targets)]
            case ast.AugAssign(target, operator, value):
                return [self._changed(target, operator, value)]
            case ast.If(ast.Compare(ast.Name(name))) if len(cases := self._cases([node], name)) > _FEW:
                return self._switch(name, cases)
            case ast.If(test, body, other):
                lines = [f"if ({self.test(test)}) {{", *self.block(body), "}"]
                return [*lines, "else {", *self.block(other), "}"] if other else lines
            case ast.While(test, body, []):
                return self._loop(f"while ({self.test(test)})", body)
            case ast.For(ast.Name() | ast.Tuple() as target, source, body, []):
                return self._loop(f"for ({self.e(target)} of {self.e(source)})", body)
            case ast.Return(value):
                return [f"return {self.e(value) if value else 'null'};"]
            case ast.Break():
                return [f"break {self.loops[-1]};"]  # by its label, out of a switch too
            case ast.Continue():
                return ["continue;"]
            case ast.Raise(error):
                text = self.e(error) if error else "$e"
                return [f"throw {f'new {text}()' if text.startswith('$.') else text};"]
            case ast.FunctionDef():
                star, head, *rest = self.function(node)
                if star:
                    self.fail(node, "a generator within a function")
                return [f"{named(node.name)} = {head} => {{", *rest[:-1], "};"]
            case ast.Try(orelse=[]):
                return self._try(node)
            case ast.With([ast.withitem(context, None)], body):
                return self._with(context, body)
        self.fail(node)

    def function(self, node: ast.FunctionDef) -> list[str]:
        """Return a function: a * if it is a generator, its parameters, its statements and a brace."""
        if marks := set(map(leaf, node.decorator_list)) - _MARKS:
            self.fail(node, f"decorator {marks}")
        head = f"({', '.join(self._parameters(node.args))})"
        body = own(node.body)
        scope = self.parameters(node)
        self.scope = self.scope.new_child(scope)
        given = {*scope, *(name for part in body if isinstance(part, ast.Nonlocal) for name in part.names)}
        scope |= {part.name: ANY for part in body if isinstance(part, ast.FunctionDef)}
        self.learn(node.body)
        self.temporary.append([])
        loops, self.loops = self.loops, []
        lines = self.block(node.body)
        self.loops = loops
        local = [named(name) for name in scope if name not in given] + self.temporary.pop()
        self.scope = self.scope.parents
        star = "*" if any(isinstance(part, ast.Yield | ast.YieldFrom) for part in body) else ""
        return [star, head, *([f"let {', '.join(local)};"] if local else []), *lines, "}"]

    def _parameters(self, args: ast.arguments) -> list[str]:
        defaults = [None] * (len(args.args) - len(args.defaults)) + list(args.defaults)
        pairs: list[tuple[ast.arg | None, ast.expr | None]] = [*zip(args.args, defaults, strict=True)]
        pairs += [(args.vararg, None), *zip(args.kwonlyargs, args.kw_defaults, strict=True)]
        given = {each.arg: default for each, default in [*pairs, (args.kwarg, None)] if each}
        given.pop("self", None)
        return [named(name) + (f" = {self.e(value)}" if value else "") for name, value in given.items()]

    def put(self, target: ast.expr, value: str) -> str:
        """Return the assignment of what is written as `value`."""
        match target:
            case ast.Subscript(of, index) if not isinstance(index, ast.Slice):
                kind = self.infer(of).name
                direct = kind == "words" or (kind == "list" and self.infer(index) == WORD)
                if not direct or (whole(index) or 0) < 0:
                    return f"$.put({self.e(of)}, {self.e(index)}, {value});"
                return f"{self.e(of)}[{self.e(index)}] = {value};"
            case ast.Name() | ast.Attribute():
                return f"{self.e(target)} = {value};"
            case ast.Tuple() if not any(isinstance(each, ast.Subscript) for each in ast.walk(target)):
                return f"{self.e(target)} = {value};"
        self.fail(target)

    def _all(self, targets: list[ast.expr], values: list[ast.expr]) -> list[str]:
        """Return `a, b = x, y`: all values are there before any is assigned."""
        given = [(self.temp(), self.e(value)) for value in values]
        before = [f"{once} = {value};" for once, value in given]
        return before + [self.put(target, once) for target, (once, _) in zip(targets, given, strict=True)]

    def _changed(self, target: ast.expr, operator: ast.operator, value: ast.expr) -> str:
        before, by = self.e(target), self.e(value)
        if isinstance(operator, ast.Add | ast.BitOr) and self.infer(target) not in PLAIN:
            by += ", $.add" if isinstance(operator, ast.Add) else ", $.or_"
            return self.put(target, f"$.grown({before}, {by})")
        return self.put(target, self.binary(operator, (before, target), (by, value)))

    def _cases(self, body: list[ast.stmt], name: str) -> list[tuple[str, list[ast.stmt]]]:
        """Return number and statements of each case of `if name == 1: ... elif name == 2: ... else: ...`."""
        match body:
            case [ast.If(ast.Compare(ast.Name(compared), [ast.Eq()], [right]), then, other)] if (
                compared == name
            ):
                if (number := whole(found.node if (found := self.found(right)) else right)) is not None:
                    return [(f"case {number}:", then), *self._cases(other, name)]
        return [("default:", body)]

    def _switch(self, name: str, cases: list[tuple[str, list[ast.stmt]]]) -> list[str]:
        lines = [line for head, body in cases for line in (f"{head} {{", *self.block(body), "break; }")]
        return [f"switch ({named(name)}) {{", *lines, "}"]

    def _loop(self, head: str, body: list[ast.stmt]) -> list[str]:
        label = f"$l{len(self.loops)}"
        self.loops.append(label)
        lines = [f"{label}: {head} {{", *self.block(body), "}"]
        self.loops.pop()
        return lines

    def _try(self, node: ast.Try) -> list[str]:
        lines = ["try {", *self.block(node.body)]
        if node.handlers:
            lines.append("} catch ($raised) { const $e = $.raised($raised);")
            for handler in node.handlers:
                caught = f"$.isinstance($e, {self.e(handler.type)})" if handler.type else "true"
                lines.append(f"if ({caught}) {{")
                lines += [f"{named(handler.name)} = $e;"] if handler.name else []
                lines += [*self.block(handler.body), "} else"]
            lines.append("throw $e;")
        lines += ["} finally {", *self.block(node.finalbody)] if node.finalbody else []
        return [*lines, "}"]

    def _with(self, context: ast.expr, body: list[ast.stmt]) -> list[str]:
        """A context manager is a generator: what comes after its `yield` is done with the error, if any."""
        once = self.temp()
        begin = f"{once} = {self.e(context)}; {once}.next();"
        end = f"{once}.throw($.raised($raised)); }} finally {{ {once}.next(); }}"
        return [begin, "try {", *self.block(body), f"}} catch ($raised) {{ {end}"]
