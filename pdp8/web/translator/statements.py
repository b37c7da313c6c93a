"""Statements, as lines of JavaScript; a chain of `if x == 1: ... elif x == 2: ...` becomes a `switch`.

A function's names are declared at its beginning, since in Python they are the whole function's.
"""

import ast
from collections.abc import Iterable

from pdp8.web.translator.assigned import Assigned
from pdp8.web.translator.calls import Calls, one_or_several
from pdp8.web.translator.expressions import MOST, named
from pdp8.web.translator.program import Found, own
from pdp8.web.translator.types import (
    ANY,
    NONE,
    NUMBERS,
    UNSEEN,
    WHOLE,
    Type,
    either,
    join,
    leaf,
    whole,
    widened,
    without_none,
)

_MARKS = {"property", "setter", "cached_property", "contextmanager", "staticmethod", "cache"}
_CHANGEABLE = ast.List | ast.Dict | ast.Set | ast.ListComp | ast.DictComp | ast.SetComp | ast.GeneratorExp
_FEW = 5
"""Cases that are left to `if`."""


class Statements(Calls):
    """Writes the statements of one module."""

    loops: list[str]
    """The labels of the loops around."""
    catching = False
    """Whether an error is being handled."""
    returns: Type = ANY
    """What the function returns."""
    declared: dict[str, Type]
    """What names are annotated as."""

    def block(self, nodes: list[ast.stmt]) -> list[str]:
        """Return statements, one after another."""
        return [line for node in nodes for line in self.s(node)]

    def s(self, node: ast.stmt) -> list[str]:
        """Return one statement."""
        match node:
            case ast.Expr(ast.Constant()) | ast.Pass():
                return []
            case ast.Import() | ast.ImportFrom() | ast.Nonlocal() | ast.AnnAssign(value=None):
                return []
            case ast.Assert(test, message):
                why = self.e(message) if message else ""
                text = self.test(test)
                self.held |= self.said(test, True)
                return [f"if (!{text}) throw new $.AssertionError({why});"]
            case ast.Expr(ast.Yield(value)):
                return [f"yield {self.accepted(value, self.item(self.returns)) if value else 'null'};"]
            case ast.Expr(ast.YieldFrom(value)):
                text = self.iterated(value)
                self.accept(value, Type("iterable", (self.item(self.returns),)))
                return [f"yield* {text};"]
            case ast.Expr(value):
                return [self.done(value) + ";"]
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if len(targets) == len(
                values
            ) and not any(isinstance(each, ast.Starred) for each in (*targets, *values)):
                return self._all(targets, values)
            case ast.Assign([target], value) if not self.in_order(value, target):
                return [self.put(target, self.e(value), value)]
            case ast.AnnAssign(target, annotation, ast.expr() as value):
                self.expect(value, self.annotated(annotation))
                return [self.put(target, self.e(value), value)]
            case ast.Assign(targets, value):
                once = self.temp()
                return [f"{once} = {self.e(value)};", *(self.put(target, once, value) for target in targets)]
            case ast.AugAssign(target, _, value):
                return self._changed(node, target, value)
            case ast.If(ast.Compare(ast.Name(name) as left)) if (
                self.plain(self.infer(left)) in NUMBERS and len(cases := self._cases([node], name)) > _FEW
            ):
                return self._switch(name, cases)
            case ast.If(test, body, other):
                return self._if(test, body, other)
            case ast.While(test, body, []):
                return self._while(test, body)
            case ast.For(ast.Name() | ast.Tuple() as target, source, body, []):
                return self._for(node, target, source, body)
            case ast.Return(value):
                return [f"return {self.accepted(value, self.returns) if value else 'null'};"]
            case ast.Break():
                return [f"break {self.loops[-1]};"]  # by its label, out of a switch too
            case ast.Continue():
                return ["continue;"]
            case ast.Raise(error):
                return [f"throw {self._raised(node, error)};"]
            case ast.FunctionDef():
                star, head, *rest = self.function(node)
                if star:
                    self.fail(node, "a generator within a function", "a function of the module")
                return [f"{named(node.name)} = {head} => {{", *rest[:-1], "};"]
            case ast.Try(orelse=[]):
                return self._try(node)
            case ast.With([ast.withitem(context, None)], body):
                return self._with(context, body)
            case ast.Delete([ast.Subscript(of, key)]) if self.infer(of).name == "dict":
                self.index(of, key, self.infer(of))
                return [f"{self.e(of)}.pop_({self.e(key)});"]
        self.fail(node, instead=_INSTEAD.get(type(node), ""))

    def _raised(self, node: ast.Raise, error: ast.expr | None) -> str:
        if error is None:
            if not self.catching:
                self.fail(node, "raise without an error outside of except")
            return "$e"
        found = self.found(error)
        if found and found.is_class:
            error = ast.copy_location(ast.Call(error, [], []), error)
        return self.e(error)

    def accepted(self, value: ast.expr, wanted: Type) -> str:
        """Return a value; refuse what is not of the type that is wanted."""
        self.expect(value, wanted)
        text = self.e(value)
        self.accept(value, wanted)
        return text

    def _if(self, test: ast.expr, body: list[ast.stmt], other: list[ast.stmt]) -> list[str]:
        lines = [f"if ({self.test(test)}) {{"]
        before, yes, no = dict(self.held), self.said(test, True), self.said(test, False)
        self.held = before | yes
        lines += [*self.block(body), "}"]
        after, self.held = self.held, before | no
        if other:
            lines += ["else {", *self.block(other), "}"]
        if self._ends(other):
            self.held = after
        elif not self._ends(body):
            self.held = {key: join(kind, after[key]) for key, kind in self.held.items() if key in after}
        return lines

    def _ends(self, body: list[ast.stmt]) -> bool:
        """Whether nothing comes after these statements."""
        match body[-1:]:
            case [ast.Return() | ast.Raise() | ast.Continue() | ast.Break()]:
                return True
            case [ast.If(_, one, other)]:
                return self._ends(one) and self._ends(other)
            case [ast.Expr(ast.Call() as call)]:
                return self.never(call)
        return False

    def _set_in(self, body: Iterable[ast.AST]) -> None:
        """Forget what tests said of the names that these statements set."""
        for node in own(body):
            if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Store):
                self.forget(ast.unparse(node))

    def _while(self, test: ast.expr, body: list[ast.stmt]) -> list[str]:
        self._set_in(body)
        head = f"while ({self.test(test)})"
        before = dict(self.held)
        self.held = before | self.said(test, True)
        lines = self._loop(head, body)
        breaks = any(isinstance(each, ast.Break) for each in own(body))
        self.held = before if breaks else before | self.said(test, False)
        return lines

    def _for(self, node: ast.For, target: ast.expr, source: ast.expr, body: list[ast.stmt]) -> list[str]:
        counted = self._counted_in(source) if isinstance(target, ast.Name) else None
        text = "" if counted else self.iterated(source)
        self.taking(target, self.item(self.infer(source)), source)
        self._set_in([node])
        held = dict(self.held)
        if counted:
            count, before, end = counted
            head = f"for (; {count} < {end}; {count}++)"
            lines = [before, *self._loop(head, body, f"{self.e(target)} = {count};")]
        else:
            lines = self._loop(self.looped(target, text, source, ""), body)
        self.held = held
        return lines

    def _counted_in(self, source: ast.expr) -> tuple[str, str, str] | None:
        """Return the counter of a loop over a range, its assignments before it, its end; None for others."""
        match source:
            case ast.Call(ast.Name("range"), [_] | [_, _], []):
                first, last = source.args if len(source.args) == 2 else (ast.Constant(0), *source.args)
                found = self.found(source.func)
                if not found or found.ours or not all(self.infer(each) in WHOLE for each in (first, last)):
                    return None
                count = self.temp()
                before = f"{count} = {self.e(first)};"
                if whole(last) is not None:
                    return count, before, self.e(last)
                end = self.temp()
                return count, f"{before} {end} = {self.e(last)};", end
        return None

    def function(self, node: ast.FunctionDef) -> list[str]:
        """Return a function: a * if it is a generator, its parameters, its statements and a brace."""
        of = Found(self.module, node)
        if marks := {*of.marks} - _MARKS:
            self.fail(node, f"decorator {marks}")
        if node.args.posonlyargs:
            self.fail(node, "parameters by place only", "them without /")
        head = f"({', '.join(self._parameters(of))})"
        body = own(node.body)
        outside = {name for part in body if isinstance(part, ast.Nonlocal) for name in part.names}
        around = {name: self.scope[name] for name in outside}
        star = "*" if any(isinstance(part, ast.Yield | ast.YieldFrom) for part in body) else ""
        notes = [part for part in body if isinstance(part, ast.AnnAssign)]
        outer = self.declared, self.returns, self.loops, self.catching, self.shared
        inner = (each.names for each in ast.walk(node) if isinstance(each, ast.Nonlocal))
        self.shared = self.shared.union(*inner)
        self.declared = self.parameters(node)
        given = {*self.declared, *outside}
        self.declared |= {ast.unparse(each.target): self.annotated(each.annotation) for each in notes}
        self.returns = self.annotated(node.returns)
        self.loops, self.catching = [], False
        if star and "contextmanager" not in of.marks:
            self._lazy(body)
        with self.naming(self.parameters(node)):
            scope = self.scope.maps[0]
            for part in body:
                if isinstance(part, ast.FunctionDef):
                    takes = self._takes(Found(self.module, part))
                    scope[part.name] = Type("call", (self.annotated(part.returns), *takes))
                    self.inner[part.name] = part
            scope.update(around)
            self.learn(node.body)
            local = [name for name in scope if name not in given]
            end = Assigned(local, self).after(node.body, frozenset())
            self.temporary.append([])
            lines = self.block(node.body)
            if end is not None and not star and self.returns not in (ANY, NONE):
                self.refuse(node, "it may end without return", "return None, or raise")
            local = [named(name) for name in scope if name not in given and name[0] != "$"]
        local += self.temporary.pop()
        self.declared, self.returns, self.loops, self.catching, self.shared = outer
        return [star, head, *([f"let {', '.join(local)};"] if local else []), *lines, "}"]

    def _lazy(self, body: list[ast.AST]) -> None:
        """Refuse a generator that would have something left to do if it is never finished."""
        for part in body:
            if isinstance(part, ast.Try | ast.With) and any(
                isinstance(each, ast.Yield | ast.YieldFrom) for each in own(ast.iter_child_nodes(part))
            ):
                self.fail(part, "yield within try or with", "the list of what it yields")

    def _parameters(self, of: Found) -> list[str]:
        found = []
        for each in of.parameters:
            if each.name == "self" and self.owner:
                continue
            default = ""
            if each.default is not None:
                self.fixed(each.default, each.annotation)
                self.accept(each.default, self.annotated(each.annotation))
                default = f" = {self.e(each.default)}"
            found.append(named(each.name) + default)
        return found

    def fixed(self, node: ast.expr, annotation: ast.expr | None) -> None:
        """Refuse a default that Python makes once and JavaScript at each call, unless it is only read."""
        if leaf(annotation) == "Mapping" and isinstance(node, ast.Dict) and not node.keys:
            return
        for each in ast.walk(node):
            if isinstance(each, ast.Name) and each.id in self.scope:
                self.fail(node, "a default of a name that may change", "None and the value in the function")
            if isinstance(each, _CHANGEABLE):
                self.fail(node, "a default that may change", "None and the value in the function")
            if isinstance(each, ast.Call):
                found = self.found(each.func)
                frozen = found and found.is_class and found.is_frozen
                if not frozen and leaf(each.func) not in ("frozenset", "bytes", "float", "int"):
                    self.fail(node, "a call as a default", "None and the value in the function")

    def put(self, target: ast.expr, value: str, node: ast.expr | None = None) -> str:
        """Return the assignment of an expression, in JavaScript `value`, in Python `node`."""
        if node is not None:
            self.taking(target, self.infer(node), node)
        match target:
            case ast.Subscript(of, index) if not isinstance(index, ast.Slice):
                kind = self.known(of)
                direct = kind.name in ("list", "words", "bytearray")
                if not direct and kind.name != "dict" and not self.ours(kind):
                    self.refuse(target, f"an item of {kind} is set", "a list")
                self.index(of, index, kind)
                if kind.name == "dict":
                    self.accept(index, kind.of[0])
                    return f"{self.e(of)}.set({self.e(index)}, {value});"
                if self.checked or not direct or (whole(index) or 0) < 0:
                    return f"$.put({self.e(of)}, {self.e(index)}, {value});"
                return f"{self.e(of)}[{self.e(index)}] = {value};"
            case ast.Name(name):
                self._now(name, node, self.scope.get(name, ANY))
                return f"{self.e(target)} = {value};"
            case ast.Attribute(of):
                self._changeable(target, of)
                self._now(ast.unparse(target), node, self._attribute_type(target, None))
                return f"{self.target(target)} = {value};"
            case ast.Tuple() if not any(isinstance(each, ast.Subscript) for each in ast.walk(target)):
                self._set_in([target])
                kind = self.infer(node) if node else ANY
                if not self.fits_target(target, kind):
                    value = f"$.unpack({value}, {self.counted(target, kind)})"
                    if not self.fits(kind, Type("iterable", (ANY,))):
                        self.refuse(target, f"{kind} is unpacked", "an annotation")
                return f"{self.target(target)} = {value};"
        self.fail(target, instead="an assignment to a name or an item")

    def taking(self, target: ast.expr, kind: Type, node: ast.AST) -> None:
        """Refuse to assign a value of `kind`, which is `node`, to what has another type."""
        held, self.held = self.held, {}
        for each, part in self.apart(target, kind):
            if not isinstance(each, ast.Name) or each.id in self.scope:
                self.accept(node, widened(self.infer(each)), part)
        self.held = held

    def _now(self, key: str, node: ast.expr | None, declared: Type) -> None:
        """Learn the type that a name or an attribute has from here on."""
        loose = declared.name in ("|", "SupportsInt", "tuple")
        kind = self.infer(node) if node is not None and loose else ANY
        self.forget(key)
        if kind != ANY and (declared.name != "|" or all(each in declared.of for each in either(kind))):
            self.held[key] = kind

    def _changeable(self, target: ast.Attribute, of: ast.expr) -> None:
        """Refuse to set what cannot be set, or is set in another way in JavaScript."""
        found = self.found(of)
        if found is not None and (found.is_module or found.is_class):
            self.fail(target, "an attribute of a class or module is set", "an attribute of an instance")
        self.attributed(target)
        for each in either(self.known(of)):
            known = self.ours(each)
            if known and not self._is_set(known, target.attr):
                self.refuse(target, "a property without a setter is set")
            if not known or known.is_frozen:
                self.refuse(target, "a field of what is frozen is set", "replace(...)")

    def _is_set(self, of: Found, name: str) -> bool:
        """Whether an attribute of a class can be set: it is no property, or has a setter."""
        there = (each.node.body for each in self.program.lineage(of) if name in each.declared)
        defined = [
            part for part in next(there, []) if isinstance(part, ast.FunctionDef) and part.name == name
        ]
        return not defined or any("setter" in Found(of.module, part).marks for part in defined)

    def _all(self, targets: list[ast.expr], values: list[ast.expr]) -> list[str]:
        """Return `a, b = x, y`: all values are there before any is assigned."""
        given = []
        for target, value in zip(targets, values, strict=True):
            given.append((target, self.temp(), self.e(value), value))
        before = [f"{once} = {text};" for _, once, text, _ in given]
        return before + [self.put(target, once, value) for target, once, _, value in given]

    def _changed(self, node: ast.AugAssign, target: ast.expr, value: ast.expr) -> list[str]:
        """Return `target += value`; what leads to the target is evaluated once."""
        before, target = self._once(target)
        kind = without_none(self.infer(target))
        result = ast.copy_location(ast.BinOp(target, node.op, node.value), node)
        if kind.name not in ("list", "bytearray", "set", "dict"):
            self.taking(target, self.infer(result), node)
            text = self.binary(node, node.op, self.operand(target), self.operand(value))
            return [*before, self.put(target, text)]
        is_sum, is_union = isinstance(node.op, ast.Add), isinstance(node.op, ast.BitOr)
        if not is_sum and not is_union:
            self.fail(node, f"{kind} is changed by this operator")
        is_list = kind.name in ("list", "bytearray")
        if not is_list and self.infer(value).name != kind.name:
            self.fail(node, f"{kind} grows")
        if UNSEEN in kind.of:
            self.refuse(node, "nothing says what it holds", "an annotation")
        by = self.iterated(value) if is_list else self.e(value)
        self.accept(value, Type("iterable", (self.item(kind),)) if is_list else kind)
        return [*before, self.put(target, f"$.grown({self.e(target)}, {by}, $.{'add' if is_sum else 'or_'})")]

    def _once(self, target: ast.expr) -> tuple[list[str], ast.expr]:
        """Return a target whose parts are names, and what sets these before."""
        before: list[str] = []

        def simple(part: ast.expr) -> ast.expr:
            if isinstance(part, ast.Name | ast.Constant) or whole(part) is not None:
                return part
            if isinstance(part, ast.Attribute) and not self.found(part):
                return ast.copy_location(ast.Attribute(simple(part.value), part.attr, ast.Load()), part)
            match part:
                case ast.BinOp(ast.Name(), _, right) if whole(right) is not None:
                    return part
            once = self.temp()
            before.append(f"{once} = {self.e(part)};")
            self.scope.maps[0][once] = self.infer(part)
            return ast.copy_location(ast.Name(once, ast.Load()), part)

        match target:
            case ast.Attribute(of, name):
                return before, ast.copy_location(ast.Attribute(simple(of), name, ast.Store()), target)
            case ast.Subscript(of, index) if not isinstance(index, ast.Slice):
                return before, ast.copy_location(
                    ast.Subscript(simple(of), simple(index), ast.Store()), target
                )
        return before, target

    def _cases(self, body: list[ast.stmt], name: str) -> list[tuple[str, list[ast.stmt]]]:
        """Return number and statements of each case of `if name == 1: ... elif name == 2: ... else: ...`."""
        match body:
            case [ast.If(ast.Compare(ast.Name(compared), [ast.Eq()], [right]), then, other)] if (
                compared == name
            ):
                number = whole(found.node if (found := self.found(right)) else right)
                if number is not None and abs(number) < MOST:
                    return [(f"case {number}:", then), *self._cases(other, name)]
        return [("default:", body)]

    def _switch(self, name: str, cases: list[tuple[str, list[ast.stmt]]]) -> list[str]:
        lines, held = [], dict(self.held)
        for head, body in cases:
            self.held = dict(held)
            lines += [f"{head} {{", *self.block(body), "break; }"]
        self.held = held
        self._set_in([each for _, body in cases for each in body])
        return [f"switch ({named(name)}) {{", *lines, "}"]

    def _loop(self, head: str, body: list[ast.stmt], first: str = "") -> list[str]:
        label = f"$l{len(self.loops)}"
        self.loops.append(label)
        lines = [f"{label}: {head} {{", *([first] if first else []), *self.block(body), "}"]
        self.loops.pop()
        return lines

    def _try(self, node: ast.Try) -> list[str]:
        held = dict(self.held)
        lines = ["try {", *self.block(node.body)]
        after, self.held = self.held, held
        self._set_in(node.body)
        held, ended = dict(self.held), True
        if node.handlers:
            lines.append("} catch ($raised) { const $e = $.raised($raised);")
            for handler in node.handlers:
                self.held = dict(held)
                lines.append(f"if ({self._caught(handler)}) {{")
                if handler.name and handler.type:
                    name = ast.copy_location(ast.Name(handler.name, ast.Store()), handler)
                    self.taking(name, self.caught(handler.type), handler)
                    lines.append(self.put(name, "$e"))
                catching, self.catching = self.catching, True
                lines += [*self.block(handler.body), "} else"]
                self.catching = catching
                ended = ended and self._ends(handler.body)
            lines.append("throw $e;")
        self.held = after if ended else held
        for handler in node.handlers:
            self._set_in(handler.body)
        lines += ["} finally {", *self.block(node.finalbody)] if node.finalbody else []
        return [*lines, "}"]

    def _caught(self, handler: ast.ExceptHandler) -> str:
        if handler.type is None:
            self.fail(handler, "except without an error", "except Exception")
        kinds = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type]
        texts = []
        for each in kinds:
            found = self.found(each)
            if not found or not found.is_class:
                self.fail(each, f"the table of what may be used has no error {leaf(each)}")
            texts.append(self.dotted(each) if found.ours else f"$.{leaf(each)}")
        return f"$.isinstance($e, {one_or_several(texts)})"

    def _with(self, context: ast.expr, body: list[ast.stmt]) -> list[str]:
        """A context manager is a generator: what comes after its `yield` is done with the error, if any."""
        found = self.found(context.func) if isinstance(context, ast.Call) else None
        if not found or "contextmanager" not in found.marks:
            self.fail(context, "a context manager that is no generator", "a function with @contextmanager")
        once = self.temp()
        begin = f"{once} = {self.e(context)}; {once}.next();"
        end = f"{once}.throw($.raised($raised)); }} finally {{ {once}.next(); }}"
        return [begin, "try {", *self.block(body), f"}} catch ($raised) {{ {end}"]


_INSTEAD: dict[type[ast.AST], str] = {
    ast.While: "a loop without else",
    ast.For: "a loop without else, over one name or several",
    ast.Match: "if and elif",
    ast.Global: "an attribute of an instance",
    ast.ClassDef: "the class in the module",
    ast.Delete: "a new list",
    ast.Try: "the rest after the try",
    ast.With: "one context manager without a name",
    ast.AsyncFunctionDef: "it without async",
}
