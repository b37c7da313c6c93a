"""Statements, as lines of JavaScript; a chain of `if x == 1: ... elif x == 2: ...` becomes a `switch`.

A function's names are declared at its beginning, since in Python they are the whole function's.
"""

import ast

from pdp8.web.translator.expressions import Expressions, named
from pdp8.web.translator.types import NUMBERS, PLAIN, STR, WORD, own, whole


class Statements(Expressions):
    """Writes the statements of one module."""

    loops: list[tuple[str, str]]
    """The loops around, each with its label and the flag of its `else`; ("", "") is a switch."""

    def block(self, nodes: list[ast.stmt]) -> list[str]:
        """Return statements, one after another."""
        return [line for node in nodes for line in self.s(node)]

    def s(self, node: ast.stmt) -> list[str]:
        """Return one statement."""
        match node:
            case (
                ast.Expr(ast.Constant())
                | ast.Pass()
                | ast.Import()
                | ast.ImportFrom()
                | ast.Nonlocal()
                | ast.Assert()
            ):
                return []
            case ast.Expr(value):
                return [self.e(value) + ";"]
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if self._independent(targets, values):
                return [
                    line
                    for pair in zip(targets, values, strict=True)
                    for line in self.put(pair[0], self.e(pair[1]))
                ]
            case ast.Assign([target], value):
                return self.put(target, self.e(value))
            case ast.Assign(targets, value):
                if all(isinstance(target, ast.Name | ast.Attribute) for target in targets):
                    return [f"{' = '.join(map(self.target, targets))} = {self.e(value)};"]
                once = self.temp()
                return [
                    f"{once} = {self.e(value)};",
                    *(line for target in targets for line in self.put(target, once)),
                ]
            case ast.AnnAssign(target, _, value):
                return self.put(target, self.e(value)) if value else []
            case ast.AugAssign(target, operator, value):
                return self._changed(node, target, operator, value)
            case ast.If(test, body, other):
                return self._switch(node) or self._branches(test, body, other)
            case ast.While(test, body, other):
                return self._loop(f"while ({self.test(test)})", [], body, other)
            case ast.For(target, iterable, body, other):
                return self._for(target, iterable, body, other)
            case ast.Return(value):
                return [f"return {self.e(value)};" if value else "return null;"]
            case ast.Break():
                return self._leave(node)
            case ast.Continue():
                return ["continue;"]
            case ast.Raise(None):
                return ["throw $e;"]
            case ast.Raise(ast.Name(name)) if name in self.program.errors:
                return [f"throw new {self.e(ast.Name(name))}();"]
            case ast.Raise(ast.expr() as error):
                return [f"throw {self.e(error)};"]
            case ast.Delete([ast.Subscript(value, ast.Slice(lower, upper, None))]):
                return [f"$.put_slice({self.e(value)}, {self._or_null(lower)}, {self._or_null(upper)}, []);"]
            case ast.Delete([ast.Subscript(value, index)]):
                return [f"$.remove({self.e(value)}, {self.e(index)});"]
            case ast.FunctionDef():
                return self.inner(node)
            case ast.Try(body, handlers, other, final):
                return self._try(body, handlers, other, final)
            case ast.With([item], body):
                return self._with(item, body)
            case ast.Match(subject, cases):
                return self._match(subject, cases)
        self.fail(node)

    def inner(self, node: ast.FunctionDef) -> list[str]:
        """Return a function within a function."""
        raise NotImplementedError

    def _independent(self, targets: list[ast.expr], values: list[ast.expr]) -> bool:
        """Tell whether one may be assigned after the other: no later value reads what was set before."""
        if len(targets) != len(values) or not all(
            isinstance(each, ast.Name | ast.Attribute) for each in targets
        ):
            return False
        before = {ast.unparse(each) for each in targets[:-1]}
        later = [part for value in values[1:] for part in ast.walk(value)]
        return not any(isinstance(part, ast.Call) or ast.unparse(part) in before for part in later)

    def target(self, node: ast.expr) -> str:
        """Return what is assigned to."""
        if isinstance(node, ast.Attribute):
            return f"{self.e(node.value)}.{node.attr}"
        return named(node.id) if isinstance(node, ast.Name) else self.fail(node)

    def put(self, target: ast.expr, value: str) -> list[str]:
        """Return the assignment of what is written as `value`."""
        match target:
            case ast.Name() | ast.Attribute():
                return [f"{self.target(target)} = {value};"]
            case ast.Subscript(of, ast.Slice(lower, upper, None)):
                return [
                    f"$.put_slice({self.e(of)}, {self._or_null(lower)}, {self._or_null(upper)}, {value});"
                ]
            case ast.Subscript(of, index):
                kind = self.infer(of).name
                direct = kind == "words" or (kind in ("list", "bytearray") and self.infer(index) == WORD)
                if direct and (whole(index) or 0) >= 0:
                    return [f"{self.e(of)}[{self.e(index)}] = {value};"]
                return [f"$.put({self.e(of)}, {self.e(index)}, {value});"]
            case ast.Tuple(targets):
                if all(isinstance(each, ast.Name | ast.Attribute) for each in targets):
                    return [f"[{', '.join(map(self.target, targets))}] = {value};"]
                once = self.temp()
                lines = [f"{once} = [...{value}];"]
                for at, each in enumerate(targets):
                    starred = isinstance(each, ast.Starred)
                    if starred and at < len(targets) - 1:
                        self.fail(target)
                    text = f"{once}.slice({at})" if starred else f"{once}[{at}]"
                    lines += self.put(each.value if starred else each, text)  # type: ignore[attr-defined]
                return lines
        self.fail(target)

    def _or_null(self, node: ast.expr | None) -> str:
        return self.e(node) if node else "null"

    def _changed(
        self, node: ast.AugAssign, target: ast.expr, operator: ast.operator, value: ast.expr
    ) -> list[str]:
        kind, added = self.infer(target), self.infer(value)
        if isinstance(operator, ast.Add | ast.BitOr) and kind not in PLAIN:
            return self.put(target, f"$.grown({self.e(target)}, {self.e(value)})")
        simple = (kind in NUMBERS and added in NUMBERS) or kind == added == STR
        if (
            simple
            and isinstance(operator, ast.Add | ast.Sub)
            and isinstance(target, ast.Name | ast.Attribute)
        ):
            sign = "+" if isinstance(operator, ast.Add) else "-"
            return [f"{self.target(target)} {sign}= {self.e(value)};"]
        return self.put(target, self.binary(operator, (self.e(target), target), (self.e(value), value), node))

    def _branches(self, test: ast.expr, body: list[ast.stmt], other: list[ast.stmt]) -> list[str]:
        lines = [f"if ({self.test(test)}) {{", *self.block(body)]
        if len(other) == 1 and isinstance(other[0], ast.If) and not self._cases(other[0]):
            first, *rest = self.s(other[0])
            return [*lines, f"}} else {first}", *rest]
        return [*lines, *(["} else {", *self.block(other)] if other else []), "}"]

    def _cases(self, node: ast.If) -> list[tuple[str, list[ast.stmt]]]:
        """Return number and statements of a long `if x == 1: ... elif x == 2: ... else: ...`."""
        found, subject = [], ast.unparse(getattr(node.test, "left", node.test))
        while True:
            match node.test:
                case ast.Compare(ast.Name() as left, [ast.Eq()], [right]) if ast.unparse(left) == subject:
                    number = self.constant(right)
                    if number is None:
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
        self.loops.append(("", ""))
        lines = [f"switch ({self.e(node.test.left)}) {{"]  # type: ignore[attr-defined]
        for head, body in cases:
            lines += [f"{head} {{", *self.block(body), "break; }"]
        self.loops.pop()
        return [*lines, "}"]

    def _leave(self, node: ast.stmt) -> list[str]:
        """Return `break` out of a loop, whose flag says whether it has come to its end."""
        label, flag = next((each for each in reversed(self.loops) if each[0]), None) or self.fail(node)
        return [f"{flag} = false;" if flag else "", f"break {label};"]

    def _loop(self, head: str, first: list[str], body: list[ast.stmt], other: list[ast.stmt]) -> list[str]:
        label, flag = f"$l{len(self.loops)}", self.temp() if other else ""
        self.loops.append((label, flag))
        inner = self.block(body)
        self.loops.pop()
        labelled = any(line.endswith(f" {label};") for line in inner)
        lines = [f"{label + ': ' if labelled else ''}{head} {{", *first, *inner, "}"]
        return [f"{flag} = true;", *lines, f"if ({flag}) {{", *self.block(other), "}"] if other else lines

    def _for(
        self, target: ast.expr, iterable: ast.expr, body: list[ast.stmt], other: list[ast.stmt]
    ) -> list[str]:
        match iterable:
            case ast.Call(ast.Name("range"), [*bounds], []) if len(bounds) < 3 and isinstance(
                target, ast.Name
            ):
                set_inside = {
                    part.id
                    for part in own(body)
                    if isinstance(part, ast.Name) and isinstance(part.ctx, ast.Store)
                }
                low, high = bounds if len(bounds) == 2 else (ast.Constant(0), bounds[0])
                if target.id not in set_inside:
                    name, at, end = named(target.id), self.temp(), self.temp()
                    head = f"for ({at} = {self.e(low)}, {end} = {self.e(high)}; {at} < {end}; {at}++)"
                    return self._loop(head, [f"{name} = {at};"], body, other)
        if isinstance(target, ast.Name):
            return self._loop(f"for ({named(target.id)} of {self.e(iterable)})", [], body, other)
        once = self.temp()
        return self._loop(f"for ({once} of {self.e(iterable)})", self.put(target, once), body, other)

    def _try(
        self,
        body: list[ast.stmt],
        handlers: list[ast.ExceptHandler],
        other: list[ast.stmt],
        final: list[ast.stmt],
    ) -> list[str]:
        well = self.temp() if other else ""
        lines = [*([f"{well} = false;"] if well else []), "try {", *self.block(body)]
        lines += [f"{well} = true;"] if well else []
        if handlers:
            lines.append("} catch ($raised) { const $e = $.raised($raised);")
            for at, handler in enumerate(handlers):
                test = f"$.isinstance($e, {self.e(handler.type)})" if handler.type else "true"
                lines.append(f"{'} else ' if at else ''}if ({test}) {{")
                lines += [f"{named(handler.name)} = $e;"] if handler.name else []
                lines += self.block(handler.body)
            lines.append("} else throw $e;")
        lines += ["} finally {", *self.block(final)] if final else []
        return [*lines, "}", *([f"if ({well}) {{", *self.block(other), "}"] if well else [])]

    def _with(self, item: ast.withitem, body: list[ast.stmt]) -> list[str]:
        """A context manager is a generator: what comes after its `yield` is done with the error, if any."""
        if item.optional_vars:
            self.fail(item.context_expr)
        once = self.temp()
        begin = f"{once} = {self.e(item.context_expr)}; {once}.next();"
        end = f"{once}.throw($.raised($raised)); }} finally {{ {once}.next(); }}"
        return [begin, "try {", *self.block(body), f"}} catch ($raised) {{ {end}"]

    def _match(self, subject: ast.expr, cases: list[ast.match_case]) -> list[str]:
        once = self.temp()
        lines = [f"{once} = {self.e(subject)};"]
        for at, case in enumerate(cases):
            test = self._pattern(case.pattern, once, subject)
            test += f" && {self.test(case.guard)}" if case.guard else ""
            lines += [f"{'} else ' if at else ''}if ({test}) {{", *self.block(case.body)]
        return [*lines, "}"]

    def _pattern(self, pattern: ast.pattern, once: str, subject: ast.expr) -> str:
        match pattern:
            case ast.MatchValue(value):
                return self.comparison(ast.Eq(), (once, subject), (self.e(value), value))
            case ast.MatchOr(patterns):
                return f"({' || '.join(self._pattern(each, once, subject) for each in patterns)})"
            case ast.MatchAs(None, None):
                return "true"
            case ast.MatchAs(inner, str(name)):
                test = self._pattern(inner, once, subject) if inner else "true"
                return f"({test} && (({named(name)} = {once}), true))"
        self.fail(pattern)
