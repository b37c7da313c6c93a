"""Expressions: each as one JavaScript expression, in parentheses where it is more than a name or a call.

Where both types are known JavaScript's own operators do it; else the runtime, `$`, looks at what comes.
A generator expression is a list, made whole at once. A function's `*args` are one array, its `**kwargs` one
Dict; keyword arguments stand in the places that the function's own parameters have.
"""

import ast
import json
from typing import TYPE_CHECKING, NoReturn

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

if TYPE_CHECKING:
    from pdp8.web.translator.types import Callee

_NAMES = {
    ast.Add: ("add", "+"), ast.Sub: ("sub", "-"), ast.Mult: ("mul", "*"), ast.Div: ("div", ""),
    ast.FloorDiv: ("floordiv", ""), ast.Mod: ("mod", ""), ast.Pow: ("pow", "**"), ast.LShift: ("shl", ""),
    ast.RShift: ("shr", ""), ast.BitAnd: ("and_", "&"), ast.BitOr: ("or_", "|"), ast.BitXor: ("xor", "^"),
}  # fmt: skip
_ORDER = {ast.Lt: ("lt", "<"), ast.LtE: ("le", "<="), ast.Gt: ("gt", ">"), ast.GtE: ("ge", ">=")}
_WORDS = (
    "arguments await break case catch class const continue debugger default delete do else enum eval export "
    "extends false finally for function if implements import in instanceof interface let new null package "
    "private protected public return static super switch this throw true try typeof undefined var void while "
    "with yield"
)
_RESERVED = frozenset(_WORDS.split())
RENAMED = {"split": "split_", "replace": "replace_", "pop": "pop_", "sort": "sort_"}
"""Methods that Python's and JavaScript's own types both have, and mean otherwise."""
_LIBRARY = {
    **dict.fromkeys(("sorted", "min", "max"), ("of", "key", "reverse", "default")),
    **{"accumulate": ("of", "by", "initial"), "enumerate": ("of", "start"), "sort": ("key", "reverse")},
    **{"zip": ("strict",), "dumps": ("of", "indent"), "split": ("by", "maxsplit"), "next": ("of", "default")},
    **{"bisect_left": ("of", "value", "lo", "hi", "key")},
}
"""The parameters of Python's own functions that are called with keywords."""


def named(name: str) -> str:
    """Return a name as JavaScript may have it."""
    return name + "$" if name in _RESERVED else name


class Untranslated(Exception):
    """A construct that has no translation, with its file and line."""


class Expressions(Types):
    """Writes the expressions of one module."""

    temporary: list[list[str]]

    def fail(self, node: ast.AST, why: str = "no translation") -> NoReturn:
        """Raise Untranslated for a node."""
        line = getattr(node, "lineno", "?")
        raise Untranslated(f"{self.module.path}:{line}: {why}: {ast.unparse(node)[:80]}")

    def temp(self) -> str:
        """Return a new name for a value that is used twice."""
        count = sum(map(len, self.temporary))
        self.temporary[-1].append(f"$t{count}")
        return f"$t{count}"

    def test(self, node: ast.expr) -> str:
        """Return an expression whose truth in JavaScript is that of `node` in Python."""
        match node:
            case ast.BoolOp(operator, values):
                sign = " && " if isinstance(operator, ast.And) else " || "
                return f"({sign.join(map(self.test, values))})"
            case ast.UnaryOp(ast.Not(), value):
                return f"!{self.test(value)}"
        return self.truth(self.e(node), node)

    def truth(self, text: str, node: ast.expr) -> str:
        """Return the test of what has been written as `text`."""
        kind = self.infer(node)
        if kind in PLAIN:
            return text
        if kind.name in ("bytes", "bytearray", "list", "dict", "set"):
            return f"({text}?.length > 0)"
        plain = kind.name in self.program.classes and not self.of_class(kind.name, "__len__")[1]
        return text if plain and not self.fields(kind) else f"$.truth({text})"

    def e(self, node: ast.expr) -> str:
        """Return an expression."""
        match node:
            case ast.Constant(value):
                return self._constant(node, value)
            case ast.BinOp() if (number := whole(node)) is not None:
                return self._number(number)
            case ast.BinOp(left, operator, right):
                return self.binary(operator, (self.e(left), left), (self.e(right), right), node)
            case ast.UnaryOp(ast.Not()):
                return self.test(node)
            case ast.UnaryOp(operator, value):
                return self._signed(operator, value)
            case ast.BoolOp(operator, values):
                return self._choice(isinstance(operator, ast.And), values)
            case ast.IfExp(test, one, other):
                return f"({self.test(test)} ? {self.e(one)} : {self.e(other)})"
            case ast.Compare(left, operators, rights):
                return self._compared(left, operators, rights)
            case ast.NamedExpr(target, value):
                return f"({self.e(target)} = {self.e(value)})"
            case ast.Name(name):
                return self._named(node, name)
            case ast.Attribute(value, name):
                return self._attributed(node, value, name)
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
                return f"(yield* $.iter({self.e(value)}))"
            case ast.Lambda(arguments, body):
                return self._function(arguments, body)
            case ast.JoinedStr(values):
                return self._text(values)
            case ast.ListComp(value, generators) | ast.GeneratorExp(value, generators):
                return self._comprehension(generators, (value,), "[]", "push")
            case ast.SetComp(value, generators):
                return self._comprehension(generators, (value,), "$.set()", "add")
            case ast.DictComp(key, value, generators):
                return self._comprehension(generators, (key, value), "$.dict()", "set")
            case ast.Call():
                return self._call(node)
        self.fail(node)

    def all(self, nodes: list[ast.expr]) -> str:
        """Return expressions, one after another."""
        return ", ".join(map(self.e, nodes))

    def _constant(self, node: ast.Constant, value: object) -> str:
        match value:
            case None:
                return "null"
            case bool():
                return str(value).lower()
            case int():
                return self._number(value)
            case bytes():
                return f"$.bytes([{', '.join(map(str, value))}])"
            case str() | float():
                return json.dumps(value)
        self.fail(node)

    def _number(self, value: int) -> str:
        if int(float(value)) != value:
            raise Untranslated(f"{self.module.path}: {value} is no number of JavaScript's, exact to 2^53")
        return f"({value})" if value < 0 else str(value)

    def _signed(self, operator: ast.unaryop, value: ast.expr) -> str:
        if isinstance(operator, ast.Invert):
            return f"(-{self.e(value)} - 1)"
        native = self.infer(value) in NUMBERS
        if isinstance(operator, ast.UAdd):
            return self.e(value) if native else self.fail(value, "a sign + before what may be no number")
        return f"(-{self.e(value)})" if native else f"$.neg({self.e(value)})"

    def binary(
        self, operator: ast.operator, left: tuple[str, ast.expr], right: tuple[str, ast.expr], node: ast.AST
    ) -> str:
        """Return `left operator right`, each as it is written and as it was."""
        name, sign = _NAMES.get(type(operator)) or self.fail(node)
        (a, one), (b, other) = left, right
        kinds, number = (self.infer(one), self.infer(other)), whole(other)
        numbers = kinds[0] in NUMBERS and kinds[1] in NUMBERS
        known = numbers or (kinds == (STR, STR) and name == "add")
        match operator:
            case ast.BitAnd() if WORD in kinds and numbers:
                return f"({a} & {b})"
            case ast.BitOr() | ast.BitXor() if kinds == (WORD, WORD):
                return f"({a} {sign} {b})"
            case ast.RShift() if kinds == (WORD, WORD) and (number is None or number < 32):
                return f"({a} >> {b})"
            case ast.LShift() if numbers:
                return f"({a} * {2**number})" if number is not None else f"({a} * 2 ** {b})"
            case ast.RShift() if numbers and number is not None:
                return f"Math.floor({a} / {2**number})"
            case ast.Div() if numbers and isinstance(other, ast.Constant) and other.value:
                return f"({a} / {b})"
            case ast.Mod() if kinds == (WORD, WORD) and number:
                return f"({a} % {b})"
            case ast.FloorDiv() if numbers and number and number & (number - 1) == 0:
                return f"Math.floor({a} / {b})"
            case ast.Add() | ast.Sub() | ast.Mult() | ast.Pow() if known:
                return f"({a} {sign} {b})"
        return f"$.{name}({a}, {b})"

    def _choice(self, both: bool, values: list[ast.expr]) -> str:
        """Return `and` or `or` as a value: the operand that decides."""
        text = self.e(values[-1])
        for value in reversed(values[:-1]):
            if self.truth("", value) == "":
                text = f"({self.e(value)} {'&&' if both else '||'} {text})"
            else:
                once = self.temp()
                test = self.truth(f"({once} = {self.e(value)})", value)
                text = f"({test} ? {text} : {once})" if both else f"({test} ? {once} : {text})"
        return text

    def _compared(self, left: ast.expr, operators: list[ast.cmpop], rights: list[ast.expr]) -> str:
        parts, a = [], self.e(left)
        for operator, right in zip(operators, rights, strict=True):
            b = self.e(right)
            if operator is not operators[-1] and not isinstance(right, ast.Name | ast.Constant):
                once = self.temp()
                b, following = f"({once} = {b})", once
            else:
                following = b
            parts.append(self.comparison(operator, (a, left), (b, right)))
            a, left = following, right
        return parts[0] if len(parts) == 1 else f"({' && '.join(parts)})"

    def comparison(self, operator: ast.cmpop, left: tuple[str, ast.expr], right: tuple[str, ast.expr]) -> str:
        """Return one comparison."""
        (a, one), (b, other) = left, right
        kinds = self.infer(one), self.infer(other)
        numbers = kinds[0] in NUMBERS and kinds[1] in NUMBERS
        same = numbers or (kinds[0] == kinds[1] and kinds[0] in PLAIN)
        no = "!" if isinstance(operator, ast.IsNot | ast.NotEq | ast.NotIn) else ""
        match operator:
            case ast.Is() | ast.IsNot():
                loose = isinstance(other, ast.Constant) and other.value is None
                return f"({a} {no or '='}={'' if loose else '='} {b})"
            case ast.Eq() if isinstance(one, ast.Tuple) and isinstance(other, ast.Tuple):
                parts = zip(one.elts, other.elts, strict=True)
                each = (self.comparison(operator, (self.e(x), x), (self.e(y), y)) for x, y in parts)
                return f"({' && '.join(each)})"
            case ast.Eq() | ast.NotEq() if same:
                return f"({a} {no or '='}== {b})"
            case ast.Eq() | ast.NotEq():
                return f"{no}$.eq({a}, {b})"
            case ast.In() | ast.NotIn():
                return no + self._held(a, kinds[0], b, other)
        name, sign = _ORDER[type(operator)]
        return f"({a} {sign} {b})" if same else f"$.{name}({a}, {b})"

    def _held(self, a: str, kind: object, b: str, container: ast.expr) -> str:
        of = self.infer(container)
        if of.name in ("set", "dict"):
            return f"{b}.has({a})"
        words = of.name in ("list", "tuple") and kind in PLAIN and of.item in PLAIN
        return f"{b}.includes({a})" if words or (of == STR and kind == STR) else f"$.has({b}, {a})"

    def _named(self, node: ast.Name, name: str) -> str:
        if name == "self":
            return "this"
        if name == "cls":
            return "this"
        if any(name in scope for scope in self.scopes) or name in self.module.defined:
            return named(name)
        if name in self.module.imports:
            module, real = self.module.imports[name]
            if self.program.find(self.module, name):
                return named(name)
            if module.split(".")[0] in self.program.packages:
                self.fail(node, f"{module} is not among the modules that are translated")
            name = real or module
        if RENAMED.get(name, name) not in self.program.runtime and named(name) not in self.program.runtime:
            self.fail(node, f"the runtime has no {name}")
        return f"$.{named(name)}"

    def _attributed(self, node: ast.Attribute, value: ast.expr, name: str) -> str:
        if name == "__name__":
            return f"{self.e(value)}.name"
        if isinstance(value, ast.Call) and leaf(value.func) == "super":
            return f"super.{name}"
        kind = self.infer(value).name
        method = self.of_class(kind, name)[1]
        properties = ("property", "cached_property")
        if (
            method and not any(leaf(each) in properties for each in method.decorator_list)
        ) or kind in METHODS:
            return f"((...$a) => {self.e(value)}.{RENAMED.get(name, name)}(...$a))"
        return f"{self.e(value)}.{named(name) if self._is_module(value) else name}"

    def _is_module(self, node: ast.expr) -> bool:
        if not isinstance(node, ast.Name) or any(node.id in scope for scope in self.scopes):
            return False
        found = self.program.find(self.module, node.id)
        return found is not None and found[1] is None

    def _indexed(self, value: ast.expr, index: ast.expr) -> str:
        if leaf(value) in ("frozenset", "set", "list", "dict", "tuple"):
            return self.e(value)  # frozenset[int]() is frozenset()
        kind, text = self.infer(value), self.e(value)
        match index:
            case ast.Slice(lower, upper, None) if kind.name in SEQUENCES:
                start = self.e(lower) if lower else "0" if upper else ""
                return f"{text}.slice({start}{', ' + self._bound(upper) if upper else ''})"
            case ast.Slice(lower, upper, step):
                parts = (self.e(each) if each else "null" for each in (lower, upper, step))
                return f"$.slice({text}, {', '.join(parts)})"
        if (number := whole(index)) is not None and self.fields(kind):
            body = self.program.classes[kind.name][1].body
            return f"{text}.{[leaf(each.target) for each in body if isinstance(each, ast.AnnAssign)][number]}"
        at = self.e(index)
        if kind.name == "words":
            return f"{text}[{at}]"
        if kind.name in SEQUENCES and (number or 0) >= 0 and self._simple(value, index):
            return f"({text}[{at}] ?? $.at({text}, {at}))"
        return f"$.at({text}, {at})"

    def _bound(self, upper: ast.expr) -> str:
        """Return the end of a slice; None is the end."""
        return self.e(upper) if self.infer(upper) in (WORD, INT) else f"({self.e(upper)} ?? undefined)"

    def _simple(self, *nodes: ast.expr) -> bool:
        """Tell whether expressions may be evaluated twice, and cost little."""
        plain = ast.Name | ast.Constant | ast.Attribute | ast.expr_context
        return all(isinstance(each, plain) for node in nodes for each in ast.walk(node))

    def _text(self, values: list[ast.expr]) -> str:
        """Return an f-string."""
        pieces = []
        for value in values:
            match value:
                case ast.Constant(str(text)):
                    pieces.append(
                        json.dumps(text)[1:-1].replace('\\"', '"').replace("`", "\\`").replace("${", "\\${")
                    )
                case ast.FormattedValue(inner, conversion, spec):
                    kind, text = self.infer(inner), self.e(inner)
                    if conversion == ord("r"):
                        text, kind = f"$.repr({text})", STR
                    if kind == FLOAT:
                        text = f"$.floating({text})"
                    if spec is not None:
                        text = f"$.format({text}, {self.e(spec)})"
                    elif kind not in (WORD, STR):
                        text = f"$.str({text})"
                    pieces.append(f"${{{text}}}")
        return f"`{''.join(pieces)}`"

    def _function(self, arguments: ast.arguments, body: ast.expr) -> str:
        self.scopes.append({each.arg: ANY for each in arguments.args})
        text = f"(({', '.join(named(each.arg) for each in arguments.args)}) => {self.e(body)})"
        self.scopes.pop()
        return text

    def _comprehension(
        self, generators: list[ast.comprehension], values: tuple[ast.expr, ...], start: str, take: str
    ) -> str:
        loops = []
        scope: dict[str, object] = {}
        for at, generator in enumerate(generators):
            source = self.e(generator.iter)
            if at == 0:
                self.scopes.append(scope)  # type: ignore[arg-type]
            self.bind_all(generator)
            loops.append(f"for (const {self.e(generator.target)} of {source})")
            loops += [f"if ({self.test(each)})" for each in generator.ifs]
        text = ", ".join(map(self.e, values))
        self.scopes.pop()
        return f"(() => {{ const $r = {start}; {' '.join(loops)} $r.{take}({text}); return $r; }})()"

    def bind_all(self, generator: ast.comprehension) -> None:
        """Enter the names of a comprehension's target in the last scope."""
        for node in ast.walk(generator.target):
            if isinstance(node, ast.Name):
                self.scopes[-1][node.id] = ANY
        self.bind(generator)

    def _call(self, node: ast.Call) -> str:
        function, name = node.func, leaf(node.func)
        if isinstance(function, ast.Name) and not any(name in scope for scope in self.scopes):
            special = self._built_in(node, name)
            if special:
                return special
        if isinstance(function, ast.Attribute) and leaf(getattr(function.value, "func", None)) == "super":
            return f"super.{name}({self.all(node.args)})"
        if name in ("_replace", "replace") and node.keywords:
            of = node.args[0] if node.args else getattr(function, "value", None) or self.fail(node)
            fields = (f"{keyword.arg}: {self.e(keyword.value)}" for keyword in node.keywords)
            return f"$.replaced({self.e(of)}, {{ {', '.join(fields)} }})"
        found = self.callee(function)
        arguments = self._placed(node, self._signature(found)) if found else self._library(node, name)
        if found and isinstance(found[1], ast.ClassDef):
            if self.program.is_enum(found[1]):
                return f"{self.e(function)}.of({arguments})"
            return f"new {self.e(function)}({arguments})"
        if isinstance(function, ast.Attribute):
            return self._method_called(node, function, arguments, found is not None)
        if isinstance(function, ast.Call) and leaf(function.func) == "type":
            return f"$.made({self.e(function.args[0])}, {arguments})"
        text = self.e(function)
        return f"new {text}({arguments})" if name in self.program.errors else f"{text}({arguments})"

    def _method_called(self, node: ast.Call, function: ast.Attribute, arguments: str, ours: bool) -> str:
        name, kind = function.attr, self.infer(function.value)
        known = " ".join(METHODS.get(kind.name, {}).values()).split()
        if known and not ours and name not in known:
            self.fail(node, f"{kind.name} has no {name}")
        text = self.e(function.value)
        if isinstance(function.value, ast.Name) and f"$.{function.value.id}" == text:
            return f"{text}.{name}({arguments})"
        if self._is_module(function.value):
            return f"{text}.{named(name)}({arguments})"
        return f"{text}.{RENAMED.get(name, name)}({arguments})"

    def _built_in(self, node: ast.Call, name: str) -> str:
        """Return a call of those of Python's own functions that JavaScript has a shorter word for."""
        args = node.args
        kinds = [self.infer(each) for each in args]
        match name, args:
            case "cast", [_, value]:
                return self.e(value)
            case "len", [value]:
                return f"{self.e(value)}.length"
            case "bool", [value]:
                text = self.test(value)
                return text if text.startswith("!") or kinds == [BOOL] else f"Boolean({text})"
            case "int", [value] if kinds[0] in (WORD, INT):
                return self.e(value)
            case "int", [value] if kinds[0] == BOOL:
                return f"Number({self.e(value)})"
            case "str", [value] if kinds[0] == STR:
                return self.e(value)
            case (("str" | "repr"), [value]) if kinds[0] == FLOAT:
                return f"$.{name}($.floating({self.e(value)}))"
            case (("min" | "max"), [_, _, *_]) if all(kind in NUMBERS for kind in kinds):
                if not any(isinstance(each, ast.Starred) for each in args):
                    return f"Math.{name}({self.all(args)})"
            case (("min" | "max"), [_, _, *_]):
                return f"$.{name}([{self.all(args)}]{self._keywords(node, name, 1)})"
            case "isinstance", [value, ast.BinOp(left, ast.BitOr(), right)]:
                either = [ast.Call(node.func, [value, kind], []) for kind in (left, right)]
                return f"({' || '.join(map(self.e, either))})"
            case "type", [value]:
                return f"{self.e(value)}.constructor"
            case "super", _:
                self.fail(node)
        return ""

    def _library(self, node: ast.Call, name: str) -> str:
        """Return the arguments of a function that is not ours."""
        if not node.keywords:
            return self.all(node.args)
        if name not in _LIBRARY:
            self.fail(node, f"keywords of {name}")
        if name == "zip":
            return self.all(node.args)
        skip = len(node.args) + (1 if name == "split" and not node.args else 0)
        first = "null" if skip > len(node.args) else self.all(node.args)
        return (first + self._keywords(node, name, skip)).removeprefix(", ")

    def _keywords(self, node: ast.Call, name: str, given: int) -> str:
        """Return the keyword arguments of a library function after the first `given`, each with a comma."""
        if not node.keywords:
            return ""
        places = _LIBRARY[name]
        values = {keyword.arg: self.e(keyword.value) for keyword in node.keywords}
        last = max(places.index(each) if each in places else self.fail(node) for each in values)
        return "".join(f", {values.get(places[at], 'undefined')}" for at in range(given, last + 1))

    def _signature(self, found: "Callee") -> ast.arguments | None:
        node = found[1]
        return self.program.made_with(found[0], node) if isinstance(node, ast.ClassDef) else node.args

    def _placed(self, node: ast.Call, signature: ast.arguments | None) -> str:
        """Return the arguments of a function of ours in the order of its parameters."""
        if signature is None:
            return self.all(node.args) if not node.keywords else self.fail(node, "keywords")
        names = [each.arg for each in (*signature.posonlyargs, *signature.args)]
        names = names[1:] if names[:1] in (["self"], ["cls"]) else names
        starred = any(isinstance(each, ast.Starred) for each in node.args)
        values = [self.e(each) for each in node.args]
        if signature.vararg:
            values = [*values[: len(names)], f"[{', '.join(values[len(names) :])}]"]
        elif not starred and len(values) > len(names):
            self.fail(node, "too many arguments")
        places = [*names, *(["*"] if signature.vararg else []), *(each.arg for each in signature.kwonlyargs)]
        if starred and not signature.vararg and node.keywords:
            self.fail(node, "an unpacked argument before keywords")
        given = {keyword.arg: self.e(keyword.value) for keyword in node.keywords if keyword.arg in places}
        rest = [keyword for keyword in node.keywords if keyword.arg not in places]
        if rest and not signature.kwarg:
            if len(node.keywords) != len(rest) or any(each.arg for each in rest) or len(rest) > 1:
                self.fail(node, "keywords that are no parameters")
            return f"...$.spread([{', '.join(values)}], {json.dumps(places)}, {self.e(rest[0].value)})"
        if given:
            last = max(map(places.index, given))
            values += [given.get(places[at], "undefined") for at in range(len(values), last + 1)]
        if signature.kwarg:
            pairs = (
                f"[{json.dumps(each.arg)}, {self.e(each.value)}]"
                if each.arg
                else f"...{self.e(each.value)}.items()"
                for each in rest
            )
            values += ["undefined"] * (len(places) - len(values)) + [f"$.dict([{', '.join(pairs)}])"]
        return ", ".join(values)
