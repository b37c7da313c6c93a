"""Expressions: each as one JavaScript expression, in parentheses where it is more than a name or a call.

Where both types are known JavaScript's own operators do it; else the runtime, `$`, looks at what comes.
A generator expression is a list, made whole at once. A function's `*args` are one array, its `**kwargs` one
Dict; keyword arguments stand in the places that the function's own parameters have.
"""

import ast
import json
import re
from typing import NoReturn

from pdp8.web.translator.program import Found, Untranslated, is_tuple
from pdp8.web.translator.types import (
    ANY,
    BOOL,
    FLOAT,
    INT,
    METHODS,
    NUMBERS,
    PLAIN,
    SEQUENCES,
    STR,
    WORD,
    Types,
    leaf,
    whole,
)

_NAMES = {
    ast.Add: ("add", "+"), ast.Sub: ("sub", "-"), ast.Mult: ("mul", "*"), ast.Div: ("div", "/"),
    ast.FloorDiv: ("floordiv", ""), ast.Mod: ("mod", "%"), ast.LShift: ("shl", ""), ast.RShift: ("shr", ">>"),
    ast.BitAnd: ("and_", "&"), ast.BitOr: ("or_", "|"), ast.BitXor: ("xor", "^"), ast.Pow: ("pow", "**"),
}  # fmt: skip
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
    **dict.fromkeys(("sorted", "min", "max"), ("of", "key", "reverse", "default")),
    **{"dumps": ("of", "indent"), "bisect_left": ("of", "value", "lo", "hi", "key")},
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
        kind = self.infer(node)
        if kind in PLAIN:
            return text
        if kind.name in (*SEQUENCES, "dict", "set"):
            return f"({text}?.length > 0)"
        ours = self.program.classes.get(kind.name)
        always = ours and not is_tuple(ours.node) and not self.of_class(kind.name, "__len__")[1]
        return text if always else f"$.truth({text})"

    def e(self, node: ast.expr) -> str:
        """Return an expression."""
        if (number := whole(node)) is not None:
            return self._number(node, number)
        match node:
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
            case ast.Name(name):
                return self._name(node, name)
            case ast.Attribute(value, name):
                return self._attribute(node, value, name)
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
            case ast.Lambda(arguments, body):
                return self._lambda([each.arg for each in arguments.args], body)
            case ast.JoinedStr(values):
                return f"`{''.join(map(self._piece, values))}`"
            case ast.ListComp(value, generators) | ast.GeneratorExp(value, generators):
                return self._comprehension(generators, value)
            case ast.SetComp(value, generators):
                return f"$.set({self._comprehension(generators, value)})"
            case ast.DictComp(key, value, generators):
                return f"$.dict({self._comprehension(generators, ast.Tuple([key, value]))})"
            case ast.Call():
                return self._call(node)
        self.fail(node)

    def all(self, nodes: list[ast.expr]) -> str:
        """Return expressions, one after another."""
        return ", ".join(map(self.e, nodes))

    def _number(self, node: ast.expr, value: int) -> str:
        if int(float(value)) != value:
            self.fail(node, f"{value} is beyond 2^53, to which JavaScript is exact")
        return f"({value})" if value < 0 else str(value)

    def binary(self, operator: ast.operator, left: tuple[str, ast.expr], right: tuple[str, ast.expr]) -> str:
        """Return `left operator right`, each as it is written and as it was."""
        (a, one), (b, other) = left, right
        name, sign = _NAMES.get(type(operator)) or self.fail(one, "no translation of the operator after")
        kinds, number = (self.infer(one), self.infer(other)), whole(other)
        numbers = kinds[0] in NUMBERS and kinds[1] in NUMBERS
        words = kinds == (WORD, WORD)
        match operator:
            case ast.Add() | ast.Sub() | ast.Mult() | ast.Pow():
                direct = numbers or (kinds == (STR, STR) and name == "add")
            case ast.BitAnd():
                direct = numbers and WORD in kinds
            case ast.BitOr() | ast.BitXor():
                direct = words
            case ast.RShift() if numbers and not (words and (number or 0) < 32):
                return f"Math.floor({a} / 2 ** {b})"
            case ast.RShift():
                direct = words
            case ast.LShift() if numbers:
                return f"({a} * 2 ** {b})"
            case ast.FloorDiv() if numbers and number:
                return f"Math.floor({a} / {b})"
            case _:
                direct = bool(number) and (words if name == "mod" else numbers and name == "div")
        return f"({a} {sign} {b})" if direct else f"$.{name}({a}, {b})"

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
            b = following = self.e(right)
            if operator is not operators[-1] and not isinstance(right, ast.Name | ast.Constant):
                following = self.temp()
                b = f"({following} = {b})"
            parts.append(self.comparison(operator, (a, left), (b, right)))
            a, left = following, right
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
                of = kinds[1]
                if of.name in ("set", "dict"):
                    return f"{no}{b}.has({a})"
                plain = of == STR or (of.name in ("list", "tuple") and of.item in PLAIN)
                return f"{no}{b}.includes({a})" if plain and kinds[0] in PLAIN else f"{no}$.has({b}, {a})"
        name, sign = _ORDER[type(operator)]
        return f"({a} {sign} {b})" if same else f"$.{name}({a}, {b})"

    def _name(self, node: ast.Name, name: str) -> str:
        if name == "self":
            return "this"
        if self.local(name) or name in self.module.defined or self.program.find(self.module, name):
            return named(name)
        module, real = self.module.imports.get(name, ("", name))
        if module.split(".")[0] in self.program.packages:
            self.fail(node, f"{module} is not among the modules that are translated")
        if (real or module) not in self.program.runtime:
            self.fail(node, f"the runtime has no {real or module}")
        return f"$.{real or module}"

    def _attribute(self, node: ast.Attribute, value: ast.expr, name: str) -> str:
        kind = self.infer(value).name
        method = self.of_class(kind, name)[1]
        if kind in METHODS or (method and not _PROPERTIES & set(map(leaf, method.node.decorator_list))):
            return f"((...$a) => {self.e(value)}.{RENAMED.get(name, name)}(...$a))"
        of = self.found(value)
        return f"{self.e(value)}.{named(name) if of and of.node is None else name}"

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
        direct = kind.name in SEQUENCES and re.fullmatch(r"[\w.$]+", text + at)  # it may stand there twice
        return f"({text}[{at}] ?? $.at({text}, {at}))" if direct else f"$.at({text}, {at})"

    def _piece(self, value: ast.expr) -> str:
        """Return a piece of an f-string."""
        if isinstance(value, ast.Constant):
            text = json.dumps(value.value)[1:-1]
            return text.replace('\\"', '"').replace("`", "\\`").replace("${", "\\${")
        assert isinstance(value, ast.FormattedValue)
        kind, text = self.infer(value.value), self.e(value.value)
        if value.conversion == ord("r"):
            text, kind = f"$.repr({text})", STR
        if kind == FLOAT:
            text = f"$.floating({text})"
        if value.format_spec is not None:
            if not _SPEC.fullmatch(ast.unparse(value.format_spec)):
                self.fail(value, "no translation of the format")
            text = f"$.format({text}, {self.e(value.format_spec)})"
        elif kind not in (WORD, STR):
            text = f"$.str({text})"
        return f"${{{text}}}"

    def _lambda(self, names: list[str], body: ast.expr) -> str:
        self.scopes.append(dict.fromkeys(names, ANY))
        text = f"(({', '.join(map(named, names))}) => {self.e(body)})"
        self.scopes.pop()
        return text

    def _comprehension(self, generators: list[ast.comprehension], value: ast.expr) -> str:
        loops = []
        for at, generator in enumerate(generators):
            source = self.e(generator.iter)
            if at == 0:
                self.scopes.append({})
            self.bind(generator)
            loops.append(f"for (const {self.e(generator.target)} of {source})")
            loops += [f"if ({self.test(each)})" for each in generator.ifs]
        text = self.e(value)
        self.scopes.pop()
        return f"(() => {{ const $r = []; {' '.join(loops)} $r.push({text}); return $r; }})()"

    def _call(self, node: ast.Call) -> str:
        function, name = node.func, leaf(node.func)
        if isinstance(function, ast.Name) and not self.local(name) and (text := self._built_in(node, name)):
            return text
        if leaf(getattr(getattr(function, "value", None), "func", None)) == "super":
            return f"super.{name}({self.all(node.args)})"
        if name in ("_replace", "replace") and node.keywords:
            of = node.args[0] if node.args else function.value  # type: ignore[attr-defined]
            fields = (f"{keyword.arg}: {self.e(keyword.value)}" for keyword in node.keywords)
            return f"$.replaced({self.e(of)}, {{ {', '.join(fields)} }})"
        found = self.callee(function)
        arguments = self._placed(node, found) if found else self._library(node, name)
        if found and found.is_class:
            return f"new {self.e(function)}({arguments})"
        if isinstance(function, ast.Attribute):
            return f"{self._method(node, function, found)}({arguments})"
        return f"{'new ' if name in self.program.errors else ''}{self.e(function)}({arguments})"

    def _method(self, node: ast.Call, function: ast.Attribute, ours: Found | None) -> str:
        """Return the method that is called."""
        name, kind, text = function.attr, self.infer(function.value), self.e(function.value)
        if kind.name in METHODS and name not in METHODS[kind.name]:
            self.fail(node, f"{kind.name} has no {name}")
        of = self.found(function.value)
        if of and of.node is None:
            return f"{text}.{named(name)}"
        return f"{text}.{name if text.startswith('$.') and text.isidentifier() else RENAMED.get(name, name)}"

    def _built_in(self, node: ast.Call, name: str) -> str:
        """Return a call of those of Python's own functions that JavaScript has a shorter word for."""
        kinds = [self.infer(each) for each in node.args]
        match name, node.args:
            case "len", [value]:
                return f"{self.e(value)}.length"
            case "int", [value] if kinds[0] in (BOOL, WORD, INT):
                return f"Number({self.e(value)})" if kinds[0] == BOOL else self.e(value)
            case (("str" | "repr"), [value]) if kinds[0] == FLOAT:
                return f"$.{name}($.floating({self.e(value)}))"
            case (("min" | "max"), [_, _, *_]) if node.keywords:
                self.fail(node)
            case (("min" | "max"), [_, _, *_]) if all(kind in NUMBERS for kind in kinds):
                return f"Math.{name}({self.all(node.args)})"
            case (("min" | "max"), [_, _, *_]):
                return f"$.{name}([{self.all(node.args)}])"
            case "isinstance", [_, ast.BinOp()]:
                self.fail(node)
        return ""

    def _library(self, node: ast.Call, name: str) -> str:
        """Return the arguments of a function that is not ours."""
        keywords = [] if name == "zip" else node.keywords  # it has `strict` alone
        return self._in_places(node, [self.e(each) for each in node.args], keywords, _LIBRARY.get(name, ()))

    def _placed(self, node: ast.Call, found: Found) -> str:
        """Return the arguments of a function of ours in the order of its parameters."""
        signature = getattr(found.node, "args", None) or self.program.made_with(found)
        if signature is None:
            return self._library(node, "")
        values, keywords = [self.e(each) for each in node.args], node.keywords
        names = [each.arg for each in signature.args if each.arg != "self"]
        if signature.vararg:
            values = [*values[: len(names)], f"[{', '.join(values[len(names) :])}]"]
            names.append("*")
        elif len(values) > len(names):
            self.fail(node, "too many arguments")
        elif keywords and any(isinstance(each, ast.Starred) for each in node.args):
            self.fail(node, "an unpacked argument before keywords")
        names += [each.arg for each in signature.kwonlyargs]
        if signature.kwarg:
            others = [each for each in keywords if each.arg not in names]
            keys: list[ast.expr | None] = [ast.Constant(each.arg) if each.arg else None for each in others]
            rest = ast.keyword("**", ast.Dict(keys, [each.value for each in others]))
            names, keywords = [*names, "**"], [*(each for each in keywords if each.arg in names), rest]
        return self._in_places(node, values, keywords, tuple(names))

    def _in_places(
        self, node: ast.Call, values: list[str], keywords: list[ast.keyword], places: tuple[str, ...]
    ) -> str:
        """Return `values`, and what is given by keywords in the `places` of the names."""
        given = {each.arg: self.e(each.value) for each in keywords}
        if given.keys() - set(places):
            self.fail(node, "keywords that are no parameters")
        last = max((places.index(each) for each in given if each), default=-1)
        return ", ".join(values + [given.get(place, "undefined") for place in places[len(values) : last + 1]])
