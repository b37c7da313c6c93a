"""Expressions: each as one JavaScript expression, in parentheses where it is more than a name or a call.

Where both types are known JavaScript's own operators do it; else the runtime, `$`, looks at what comes.
A generator expression is a list, made whole at once. A function's `*args` are one array, its `**kwargs` one
Dict; keyword arguments stand in the places that the function's own parameters have.
"""

import ast
import json
import re
from typing import NoReturn

from pdp8.web.translator.inference import Types
from pdp8.web.translator.program import Found, Untranslated
from pdp8.web.translator.types import ANY, FLOAT, INT, NUMBERS, PLAIN, STR, WORD, leaf, whole

_OPERATORS = {
    ast.Add: ("add", "({} + {})"), ast.Sub: ("sub", "({} - {})"), ast.Mult: ("mul", "({} * {})"),
    ast.Div: ("div", "({} / {})"), ast.FloorDiv: ("floordiv", "Math.floor({} / {})"),
    ast.Mod: ("mod", "({} % {})"),
    ast.LShift: ("shl", "({} * 2 ** {})"), ast.RShift: ("shr", "({} >> {})"), ast.Pow: ("pow", "({} ** {})"),
    ast.BitAnd: ("and_", "({} & {})"), ast.BitOr: ("or_", "({} | {})"), ast.BitXor: ("xor", "({} ^ {})"),
}  # fmt: skip
"""The runtime's name of an operator, and what JavaScript has for it where the types allow that."""
_ORDER = {ast.Lt: ("lt", "<"), ast.LtE: ("le", "<="), ast.Gt: ("gt", ">"), ast.GtE: ("ge", ">=")}
_WORDS = (
    "arguments await case catch const debugger default delete do enum eval export extends false function "
    "implements instanceof interface let new null package private protected public static super switch this "
    "throw true typeof undefined var void"
)
_RESERVED = frozenset(_WORDS.split())
RENAMED = {"split": "split_", "replace": "replace_", "pop": "pop_"}
"""Methods that Python's and JavaScript's own types both have, and mean otherwise."""
_SPEC = re.compile(r"f'\+?0?(\d*|{.*}),?(\.\d+[fg]|[oxfg])?'")
_PROPERTIES = {"property", "cached_property"}
_LIBRARY = {
    "sorted": ("of", "key", "reverse"),
    "dumps": ("of", "indent"),
    "bisect_left": ("of", "value", "lo", "hi", "key"),
}
"""The parameters of Python's own functions that are called with keywords."""


def named(name: str) -> str:
    """Return a name as JavaScript may have it."""
    return name + "$" if name in _RESERVED else name


class Expressions(Types):
    """Writes the expressions of one module."""

    temporary: list[list[str]]

    def fail(self, node: ast.AST, why: str = "no translation") -> NoReturn:
        """Raise Untranslated for a node."""
        line = getattr(node, "lineno", "?")
        raise Untranslated(f"{self.module.path}:{line}: {why}: {ast.unparse(node)[:80]}")

    def temp(self) -> str:
        """Return a new name for a value that is used twice."""
        name = f"$t{sum(map(len, self.temporary))}"
        self.temporary[-1].append(name)
        return name

    def test(self, node: ast.expr) -> str:
        """Return an expression whose truth in JavaScript is that of `node` in Python."""
        match node:
            case ast.BoolOp(operator, values):
                sign = " && " if isinstance(operator, ast.And) else " || "
                return f"({sign.join(map(self.test, values))})"
            case ast.UnaryOp(ast.Not(), value):
                return f"!{self.test(value)}"
        return self._truth(self.e(node), node)

    def _truth(self, text: str, node: ast.expr) -> str:
        """Return the test of what has been written as `text`."""
        return text if self.infer(node) in PLAIN else f"$.truth({text})"

    def e(self, node: ast.expr) -> str:
        """Return an expression."""
        if (number := whole(node)) is not None:
            if int(float(number)) != number:
                self.fail(node, f"{number} is beyond 2^53, to which JavaScript is exact")
            return f"({number})" if number < 0 else str(number)
        match node:
            case ast.Name(name):
                return self._name(node, name)
            case ast.Attribute(value, name):
                return self._attribute(node, value, name)
            case ast.Call():
                return self._call(node)
            case ast.Constant(None):
                return "null"
            case ast.Constant(bytes(value)):
                return f"$.bytes([{', '.join(map(str, value))}])"
            case ast.Constant(bool() | str() | float() as value):
                return json.dumps(value)
            case ast.BinOp(left, operator, right):
                return self.binary(operator, (self.e(left), left), (self.e(right), right))
            case ast.UnaryOp(ast.Not()):
                return self.test(node)
            case ast.UnaryOp(ast.Invert(), value):
                return f"(-{self.e(value)} - 1)"
            case ast.UnaryOp(ast.USub(), value):
                return f"(-{self.e(value)})"
            case ast.BoolOp(operator, values):
                return self._choice(isinstance(operator, ast.And), values)
            case ast.IfExp(test, one, other):
                return f"({self.test(test)} ? {self.e(one)} : {self.e(other)})"
            case ast.Compare(left, operators, rights):
                return self._compared(left, operators, rights)
            case ast.NamedExpr(target, value):
                return f"({self.e(target)} = {self.e(value)})"
            case ast.Subscript(value, index):
                return self._indexed(value, index)
            case ast.Tuple(items) | ast.List(items):
                return f"[{self.all(items)}]"
            case ast.Set(items):
                return f"$.set([{self.all(items)}])"
            case ast.Dict(keys, values):
                pairs = zip(keys, values, strict=True)
                each = (f"[{self.e(k)}, {self.e(v)}]" if k else f"...{self.e(v)}.items()" for k, v in pairs)
                return f"$.dict([{', '.join(each)}])"
            case ast.Starred(value):
                return f"...{self.e(value)}"
            case ast.Yield(value):
                return f"(yield {self.e(value) if value else 'null'})"
            case ast.YieldFrom(value):
                return f"(yield* {self.e(value)})"
            case ast.Lambda(ast.arguments(args=parameters), body):
                names = [each.arg for each in parameters]
                self.scope = self.scope.new_child(dict.fromkeys(names, ANY))
                text = f"(({', '.join(map(named, names))}) => {self.e(body)})"
                self.scope = self.scope.parents
                return text
            case ast.JoinedStr(values):
                return f"`{''.join(map(self._piece, values))}`"
            case ast.ListComp(value, generators) | ast.GeneratorExp(value, generators):
                return self._comprehension(generators, value)
            case ast.SetComp(value, generators):
                return f"$.set({self._comprehension(generators, value)})"
            case ast.DictComp(key, value, generators):
                return f"$.dict({self._comprehension(generators, ast.Tuple([key, value]))})"
        self.fail(node)

    def all(self, nodes: list[ast.expr]) -> str:
        """Return expressions, one after another."""
        return ", ".join(map(self.e, nodes))

    def binary(self, operator: ast.operator, left: tuple[str, ast.expr], right: tuple[str, ast.expr]) -> str:
        """Return `left operator right`, each as it is written and as it was."""
        (a, one), (b, other) = left, right
        name, direct = _OPERATORS.get(type(operator)) or self.fail(one, "no operator as that after")
        kinds, number = (self.infer(one), self.infer(other)), whole(other)
        numbers, words = set(kinds) <= set(NUMBERS), kinds == (WORD, WORD)
        match operator:
            case ast.Sub() | ast.Mult() | ast.Pow() | ast.LShift():
                fits = numbers
            case ast.Add():
                fits = numbers or kinds == (STR, STR)
            case ast.Div() | ast.FloorDiv():
                fits = numbers and bool(number)
            case ast.Mod():
                fits = words and bool(number)
            case ast.RShift():
                fits = words and number is not None and number < 32
            case ast.BitAnd():
                fits = numbers and WORD in kinds
            case _:
                fits = words
        return direct.format(a, b) if fits else f"$.{name}({a}, {b})"

    def _choice(self, both: bool, values: list[ast.expr]) -> str:
        """Return `and` or `or` as a value: the operand that decides."""
        text = self.e(values[-1])
        for value in reversed(values[:-1]):
            if self._truth("", value) == "":
                text = f"({self.e(value)} {'&&' if both else '||'} {text})"
            else:
                once = self.temp()
                test = self._truth(f"({once} = {self.e(value)})", value)
                text = f"({test} ? {text} : {once})" if both else f"({test} ? {once} : {text})"
        return text

    def _compared(self, left: ast.expr, operators: list[ast.cmpop], rights: list[ast.expr]) -> str:
        parts, a = [], self.e(left)
        for operator, right in zip(operators, rights, strict=True):
            b = again = self.e(right)
            if right is not rights[-1]:
                again = self.temp()
                b = f"({again} = {b})"
            parts.append(self.comparison(operator, (a, left), (b, right)))
            a, left = again, right
        return parts[0] if len(parts) == 1 else f"({' && '.join(parts)})"

    def comparison(self, operator: ast.cmpop, left: tuple[str, ast.expr], right: tuple[str, ast.expr]) -> str:
        """Return one comparison."""
        (a, one), (b, other) = left, right
        kinds = self.infer(one), self.infer(other)
        same = (kinds[0] in NUMBERS and kinds[1] in NUMBERS) or (kinds[0] == kinds[1] and kinds[0] in PLAIN)
        no = "!" if isinstance(operator, ast.IsNot | ast.NotEq | ast.NotIn) else ""
        match operator:
            case ast.Is() | ast.IsNot():
                loose = isinstance(other, ast.Constant) and other.value is None
                return f"({a} {no or '='}={'' if loose else '='} {b})"
            case ast.Eq() | ast.NotEq():
                return f"({a} {no or '='}== {b})" if same else f"{no}$.eq({a}, {b})"
            case ast.In() | ast.NotIn():
                plain = kinds[0] in PLAIN and kinds[1].item in PLAIN
                return f"{no}{b}.includes({a})" if plain else f"{no}$.has({b}, {a})"
        name, sign = _ORDER[type(operator)]
        return f"({a} {sign} {b})" if same else f"$.{name}({a}, {b})"

    def _name(self, node: ast.Name, name: str) -> str:
        if name == "self":
            return "this"
        if name in self.scope or name in self.module.defined or self.program.find(self.module, name):
            return named(name)
        module, real = self.module.imports.get(name, ("", name))
        if (real or module) not in self.program.runtime:
            self.fail(node, f"the runtime has no {real or module}")
        return f"$.{real or module}"

    def _attribute(self, node: ast.Attribute, value: ast.expr, name: str) -> str:
        kind = self.infer(value).name
        method = self.of_class(kind, name)[1]
        decorators = map(leaf, method.node.decorator_list) if method else ()
        if kind in ("list", "str") or (method and _PROPERTIES.isdisjoint(decorators)):
            return f"((...$a) => {self._dotted(node, name)}(...$a))"
        return self._dotted(node, name)

    def _indexed(self, value: ast.expr, index: ast.expr) -> str:
        kind, text = self.infer(value), self.e(value)
        if isinstance(index, ast.Slice):
            if index.step:
                self.fail(index, "a slice by steps")
            end = f", {self.e(index.upper)}" if index.upper else ""
            if index.upper and self.infer(index.upper) not in (WORD, INT):
                end += " ?? undefined"  # None is the end
            return f"{text}.slice({self.e(index.lower) if index.lower else 0}{end})"
        at = self.e(index)
        if kind.name == "words":
            return f"{text}[{at}]"
        twice = re.fullmatch(r"[\w.$]+", text + at)  # it may stand there twice
        direct = twice and kind.name in ("list", "str")
        return f"({text}[{at}] ?? $.at({text}, {at}))" if direct else f"$.at({text}, {at})"

    def _piece(self, value: ast.expr) -> str:
        """Return a piece of an f-string."""
        if isinstance(value, ast.Constant):
            text = json.dumps(value.value)[1:-1]
            return text.replace('\\"', '"').replace("`", "\\`").replace("${", "\\${")
        assert isinstance(value, ast.FormattedValue)
        kind, text = self.infer(value.value), self.e(value.value)
        if kind == FLOAT:
            text = f"$.floating({text})"
        if value.conversion == ord("r"):
            text, kind = f"$.repr({text})", STR
        if value.format_spec is not None:
            if not _SPEC.fullmatch(ast.unparse(value.format_spec)):
                self.fail(value, "no translation of the format")
            text = f"$.format({text}, {self.e(value.format_spec)})"
        elif kind not in (WORD, STR):
            text = f"$.str({text})"
        return f"${{{text}}}"

    def _comprehension(self, generators: list[ast.comprehension], value: ast.expr) -> str:
        loops = []
        self.scope = self.scope.new_child()
        for generator in generators:
            source, sets = self.e(generator.iter), self._set_by(generator)
            self.scope |= {leaf(target): kind for target, kind in sets}
            loops.append(f"for (const {self.e(generator.target)} of {source})")
            loops += [f"if ({self.test(each)})" for each in generator.ifs]
        text = self.e(value)
        self.scope = self.scope.parents
        return f"(() => {{ const $r = []; {' '.join(loops)} $r.push({text}); return $r; }})()"

    def _call(self, node: ast.Call) -> str:
        function, name = node.func, leaf(node.func)
        if isinstance(function, ast.Name) and name not in self.scope and (text := self._built_in(node, name)):
            return text
        if leaf(getattr(getattr(function, "value", None), "func", None)) == "super" and not node.keywords:
            return f"super.{name}({self.all(node.args)})"
        if name in ("_replace", "replace") and node.keywords:
            of = node.args[0] if node.args else function.value  # type: ignore[attr-defined]
            fields = (f"{keyword.arg}: {self.e(keyword.value)}" for keyword in node.keywords)
            return f"$.replaced({self.e(of)}, {{ {', '.join(fields)} }})"
        if isinstance(function, ast.Attribute) and name not in self.program.members:
            self.fail(node, f"nothing has a method {name}")
        found = self.found(function)
        new = "new " if (found and found.is_class) or name in self.program.errors else ""
        return f"{new}{self._dotted(function, name)}({self._arguments(node, found)})"

    def _dotted(self, node: ast.expr, name: str) -> str:
        """Return a name, or a member of what is before it."""
        if not isinstance(node, ast.Attribute):
            return self.e(node)
        of = self.found(node.value)
        return f"{self.e(node.value)}.{named(name) if of and of.node is None else RENAMED.get(name, name)}"

    def _built_in(self, node: ast.Call, name: str) -> str:
        """Return a call of one of Python's own functions for which JavaScript has a shorter word."""
        kinds = [self.infer(each) for each in node.args]
        match name, node.args:
            case "len", [value]:
                return f"{self.e(value)}.length"
            case (("str" | "repr"), [value]) if kinds[0] == FLOAT:
                return f"$.{name}($.floating({self.e(value)}))"
            case (("min" | "max"), [_, _, *_]) if set(kinds) <= set(NUMBERS):
                return f"Math.{name}({self.all(node.args)})"
            case (("min" | "max"), [_, _, *_]):
                return self.e(ast.Call(node.func, [ast.List(node.args)], []))
            case "isinstance", [_, ast.BinOp()]:
                self.fail(node)
        return ""

    def _arguments(self, node: ast.Call, found: Found | None) -> str:
        """Return the arguments of a call, those by keywords in the places of the parameters."""
        values, names = [self.e(each) for each in node.args], list(_LIBRARY.get(leaf(node.func), ()))
        given = {each.arg: each.value for each in node.keywords if each.arg != "strict"}
        signature = self.program.signature(found)
        if signature:
            names = [each.arg for each in signature.args if each.arg != "self"]
            if signature.vararg:
                values = [*values[: len(names)], f"[{', '.join(values[len(names) :])}]"]
                names.append("*")
            elif len(values) > len(names):
                self.fail(node, "too many arguments")
            elif node.keywords and any(isinstance(each, ast.Starred) for each in node.args):
                self.fail(node, "an unpacked argument before keywords")
            names += [each.arg for each in signature.kwonlyargs]
            if signature.kwarg:
                rest = [each for each in node.keywords if each.arg not in names]
                keys = [each.arg and ast.Constant(each.arg) for each in rest]
                given = {name: value for name, value in given.items() if name in names}
                names.append(signature.kwarg.arg)
                given[signature.kwarg.arg] = ast.Dict(keys, [each.value for each in rest])  # type: ignore[arg-type]
        if given.keys() - set(names):
            self.fail(node, "keywords that are no parameters")
        last = max((names.index(each) for each in given if each), default=-1)
        missing = names[len(values) : last + 1]
        return ", ".join(values + [self.e(given[name]) if name in given else "undefined" for name in missing])
