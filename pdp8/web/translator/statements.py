"""Statements, as lines of JavaScript; a chain of `if x == 1: ... elif x == 2: ...` becomes a `switch`.

A function's names are declared at its beginning, since in Python they are the whole function's.
"""

import ast

from pdp8.web.translator.expressions import Expressions, named
from pdp8.web.translator.types import NUMBERS, PLAIN, STR, WORD, own, whole

_SIMPLE = ast.Name | ast.Attribute


class Statements(Expressions):
    """Writes the statements of one module."""

    loops: list[str]
    """The labels of the loops around; "" is a switch."""

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
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if _independent(targets, values):
                pairs = zip(targets, values, strict=True)
                return [line for target, value in pairs for line in self.put(target, self.e(value))]
            case ast.Assign([target], value) | ast.AnnAssign(target, _, ast.expr() as value):
                return self.put(target, self.e(value))
            case ast.Assign(targets, value) if all(isinstance(each, _SIMPLE) for each in targets):
                return [f"{' = '.join(map(self.target, targets))} = {self.e(value)};"]
            case ast.Assign(targets, value):
                once = self.temp()
                lines = (line for target in targets for line in self.put(target, once))
                return [f"{once} = {self.e(value)};", *lines]
            case ast.AugAssign(target, operator, value):
                return self._changed(target, operator, value)
            case ast.If(test, body, other):
                return self._switch(node) or self._branches(test, body, other)
            case ast.While(test, body, []):
                return self._loop(f"while ({self.test(test)})", [], body)
            case ast.For(orelse=[]):
                return self._for(node)
            case ast.Return(value):
                return [f"return {self.e(value) if value else 'null'};"]
            case ast.Break():
                return [f"break {next(filter(None, reversed(self.loops)))};"]
            case ast.Continue():
                return ["continue;"]
            case ast.Raise(None):
                return ["throw $e;"]
            case ast.Raise(ast.expr() as error):
                bare = isinstance(error, ast.Name) and error.id in self.program.errors
                return [f"throw {f'new $.{error.id}()' if bare else self.e(error)};"]  # type: ignore[attr-defined]
            case ast.FunctionDef():
                return self.inner(node)
            case ast.Try(orelse=[]):
                return self._try(node)
            case ast.With([ast.withitem(context, None)], body):
                return self._with(context, body)
        self.fail(node)

    def inner(self, node: ast.FunctionDef) -> list[str]:
        """Return a function within a function."""
        raise NotImplementedError

    def target(self, node: ast.expr) -> str:
        """Return what is assigned to."""
        return named(node.id) if isinstance(node, ast.Name) else self.e(node)

    def put(self, target: ast.expr, value: str) -> list[str]:
        """Return the assignment of what is written as `value`."""
        match target:
            case ast.Name() | ast.Attribute():
                return [f"{self.target(target)} = {value};"]
            case ast.Subscript(of, ast.Slice(lower, upper, None)):
                bounds = ", ".join(self.e(each) if each else "null" for each in (lower, upper))
                return [f"$.put_slice({self.e(of)}, {bounds}, {value});"]
            case ast.Subscript(of, index):
                kind = self.infer(of).name
                direct = kind == "words" or (kind in ("list", "bytearray") and self.infer(index) == WORD)
                if direct and (whole(index) or 0) >= 0:
                    return [f"{self.e(of)}[{self.e(index)}] = {value};"]
                return [f"$.put({self.e(of)}, {self.e(index)}, {value});"]
            case ast.Tuple(targets) if all(isinstance(each, _SIMPLE) for each in targets):
                return [f"[{', '.join(map(self.target, targets))}] = {value};"]
            case ast.Tuple(targets):
                once = self.temp()
                lines = [f"{once} = [...{value}];"]
                for at, each in enumerate(targets):
                    if isinstance(each, ast.Starred) and each is targets[-1]:
                        lines += self.put(each.value, f"{once}.slice({at})")
                    else:
                        lines += self.put(each, f"{once}[{at}]")
                return lines
        self.fail(target)

    def _changed(self, target: ast.expr, operator: ast.operator, value: ast.expr) -> list[str]:
        kind, added = self.infer(target), self.infer(value)
        if isinstance(operator, ast.Add | ast.BitOr) and kind not in PLAIN:
            return self.put(target, f"$.grown({self.e(target)}, {self.e(value)})")
        simple = (kind in NUMBERS and added in NUMBERS) or kind == added == STR
        if simple and isinstance(operator, ast.Add | ast.Sub) and isinstance(target, _SIMPLE):
            sign = "+" if isinstance(operator, ast.Add) else "-"
            return [f"{self.target(target)} {sign}= {self.e(value)};"]
        return self.put(target, self.binary(operator, (self.e(target), target), (self.e(value), value)))

    def _branches(self, test: ast.expr, body: list[ast.stmt], other: list[ast.stmt]) -> list[str]:
        lines = [f"if ({self.test(test)}) {{", *self.block(body)]
        return [*lines, *(["} else {", *self.block(other)] if other else []), "}"]

    def _cases(self, node: ast.If) -> list[tuple[str, list[ast.stmt]]]:
        """Return number and statements of a long `if x == 1: ... elif x == 2: ... else: ...`."""
        found, subject = [], ast.unparse(getattr(node.test, "left", node.test))
        while True:
            match node.test:
                case ast.Compare(ast.Name(name), [ast.Eq()], [right]) if name == subject:
                    if (number := self.constant(right)) is None:
                        return []
                    found.append((f"case {number}:", node.body))
                case _:
                    return []
            if len(node.orelse) != 1 or not isinstance(node.orelse[0], ast.If):
                return [*found, ("default:", node.orelse)] if len(found) > 4 else []
            node = node.orelse[0]

    def _switch(self, node: ast.If) -> list[str]:
        cases = self._cases(node)
        if not cases:
            return []
        self.loops.append("")
        lines = [f"switch ({self.e(node.test.left)}) {{"]  # type: ignore[attr-defined]
        for head, body in cases:
            lines += [f"{head} {{", *self.block(body), "break; }"]
        self.loops.pop()
        return [*lines, "}"]

    def _loop(self, head: str, first: list[str], body: list[ast.stmt]) -> list[str]:
        label = f"$l{len(self.loops)}"
        self.loops.append(label)
        lines = [f"{label}: {head} {{", *first, *self.block(body), "}"]
        self.loops.pop()
        return lines

    def _for(self, node: ast.For) -> list[str]:
        target, source = node.target, node.iter
        set_inside = {part.id for part in own(node.body) if isinstance(part, ast.Name) and _is_set(part)}
        match target, source:
            case ast.Name(name), ast.Call(ast.Name("range"), [_] | [_, _] as bounds) if (
                name not in set_inside
            ):
                low, high = bounds if len(bounds) == 2 else (ast.Constant(0), bounds[0])
                at, end = self.temp(), self.temp()
                head = f"for ({at} = {self.e(low)}, {end} = {self.e(high)}; {at} < {end}; {at}++)"
                return self._loop(head, [f"{named(name)} = {at};"], node.body)
        once = self.temp()
        return self._loop(f"for ({once} of {self.e(source)})", self.put(target, once), node.body)

    def _try(self, node: ast.Try) -> list[str]:
        lines = ["try {", *self.block(node.body)]
        if node.handlers:
            lines.append("} catch ($raised) { const $e = $.raised($raised);")
            for handler in node.handlers:
                lines.append(
                    f"if ({f'$.isinstance($e, {self.e(handler.type)})' if handler.type else 'true'}) {{"
                )
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


def _is_set(node: ast.Name) -> bool:
    return isinstance(node.ctx, ast.Store)


def _independent(targets: list[ast.expr], values: list[ast.expr]) -> bool:
    """Tell whether one may be assigned after the other: no later value reads what was set before."""
    if len(targets) != len(values) or not all(isinstance(each, _SIMPLE) for each in targets):
        return False
    before = {ast.unparse(each) for each in targets[:-1]}
    later = [part for value in values[1:] for part in ast.walk(value)]
    return not any(isinstance(part, ast.Call) or ast.unparse(part) in before for part in later)
