"""Expressions: each as one JavaScript expression, in parentheses where it is more than a name or a call.

Where both types are known JavaScript's own operators do it; else the runtime, `$`, looks at what comes.
What would be another thing in JavaScript is refused, with what to write instead. A function's `*args` are one
array, its `**kwargs` one Dict; keyword arguments stand in the places that the function's own parameters have.

A module that is not `checked` trusts its types, as its compiled form does: its numbers stay below 2^53, its
indexes are within their arrays.
"""

import ast
import json
import re
from collections.abc import Callable
from typing import NoReturn

from pdp8.web.translator.inference import DUNDERS, Types
from pdp8.web.translator.program import Found, Untranslated
from pdp8.web.translator.types import (
    ANY,
    BOOL,
    BYTES,
    FLOAT,
    FLOATS,
    INT,
    NONE,
    NUMBERS,
    REAL,
    STR,
    UNSEEN,
    WHOLE,
    WORD,
    Type,
    either,
    join,
    leaf,
    whole,
    without_none,
)

_OPERATORS = {
    ast.Add: ("add", "({} + {})"), ast.Sub: ("sub", "({} - {})"), ast.Mult: ("mul", "({} * {})"),
    ast.Div: ("div", "({} / {})"), ast.FloorDiv: ("floordiv", "Math.floor({} / {})"),
    ast.Mod: ("mod", "({} % {})"),
    ast.LShift: ("shl", "({} * 2 ** {})"), ast.RShift: ("shr", "({} >> {})"),
    ast.Pow: ("power_", "({} ** {})"),
    ast.BitAnd: ("and_", "({} & {})"), ast.BitOr: ("or_", "({} | {})"), ast.BitXor: ("xor", "({} ^ {})"),
}  # fmt: skip
"""The runtime's name of an operator, and what JavaScript has for it where the types allow that."""
_EXACT = {
    ast.Add: "plus", ast.Sub: "minus", ast.Mult: "times", ast.FloorDiv: "floordiv", ast.Mod: "mod",
    ast.LShift: "shl", ast.RShift: "shr", ast.Pow: "power", ast.BitAnd: "and_", ast.BitOr: "or_",
    ast.BitXor: "xor", ast.Div: "div",
}  # fmt: skip
"""The same for whole numbers of any size."""
_ORDER = {ast.Lt: ("lt", "<"), ast.LtE: ("le", "<="), ast.Gt: ("gt", ">"), ast.GtE: ("ge", ">=")}
_WORDS = (
    "arguments await case catch const debugger default delete do enum eval export extends false function "
    "implements instanceof interface let new null package private protected public static super switch this "
    "throw true typeof undefined var void Math Number NaN Infinity Symbol Object"
)
_RESERVED = frozenset(_WORDS.split())
RENAMED = {"split": "split_", "replace": "replace_", "pop": "pop_"}
"""Methods that Python's and JavaScript's own types both have, and mean otherwise."""
_SPEC = re.compile(r"(\+)?(0)?(\d*|\{\})(,)?(?:\.(\d+|\{\}))?([oxfg])?")
_AT_ONCE = [
    "sum",
    "list",
    "tuple",
    "set",
    "frozenset",
    "sorted",
    "join",
    "dict",
    "bytes",
    "bytearray",
    "max",
    "min",
]
"""They take all that a generator yields before anything else happens: it may be a list."""
MOST = 1 << 53
"""From here on not every whole number is a float."""
_UNORDERED = ["set", "frozenset", "sorted", "sum"]
_LISTS = ("list", "tuple", "row", "sequence", "str", "bytes", "bytearray")
_KINDS = {"int", "float", "bool", "str", "list", "tuple", "bytes", "bytearray", "dict"}


def named(name: str) -> str:
    """Return a name as JavaScript may have it."""
    return name + "$" if name in _RESERVED else name


def member(name: str) -> str:
    """Return the name of an attribute or method as JavaScript may have it."""
    return RENAMED.get(name, name)


class Expressions(Types):
    """Writes the expressions of one module."""

    temporary: list[list[str]]
    checked = True
    trusted = False
    """Whether values of unknown type are looked at when the module runs."""

    def fail(self, node: ast.AST, why: str = "no translation", instead: str = "") -> NoReturn:
        """Raise Untranslated for a node."""
        line = getattr(node, "lineno", "?")
        source = " ".join(ast.unparse(node).split())[:80]
        raise Untranslated(
            f"{self.module.path}:{line}: {why}: {source}{'; write ' if instead else ''}{instead}"
        )

    def temp(self) -> str:
        """Return a new name for a value that is used twice."""
        name = f"$t{sum(map(len, self.temporary))}"
        self.temporary[-1].append(name)
        return name

    def known(self, node: ast.expr) -> Type:
        """Return the type of an expression that is not None; refuse one of which too little is known."""
        kind = self.infer(node)
        if self.trusted:
            return without_none(kind)
        if ANY in either(kind):
            self.fail(node, "its type is unknown", "an annotation")
        if NONE in either(kind) and kind != NONE:
            self.fail(node, "it may be None", "a test that it is not")
        return kind

    def accept(self, value: ast.expr, wanted: Type, node: ast.AST | None = None) -> None:
        """Refuse what is not of the type that is wanted: the translation relies on annotations."""
        if isinstance(value, ast.Lambda) or wanted == ANY:
            return
        kind = self.infer(value)
        if not self.trusted and not self._may_be(kind, wanted):
            self.fail(node or value, f"{kind} where {wanted} is annotated")

    def _may_be(self, kind: Type, wanted: Type) -> bool:
        if kind.name == "|":
            return all(self._may_be(each, wanted) for each in kind.of)
        if wanted.name == "|":
            return any(self._may_be(kind, each) for each in wanted.of)
        if kind == BOOL and wanted in NUMBERS:
            return True
        if kind.name == "call" or wanted.name in ("call", "never", "type") or kind.name == "never":
            return True
        if wanted in self.program.protocols or kind.name == "type":
            return True
        if kind.name == "view" and wanted.name in ("set", "iterable"):
            return True
        if UNSEEN in (kind, wanted):
            return True
        if kind.name == wanted.name and kind.of:
            return all(self._may_be(a, b) for a, b in zip(kind.of, wanted.of, strict=False))
        return self.fits(kind, wanted)

    # Truth.

    def test(self, node: ast.expr) -> str:
        """Return an expression whose truth in JavaScript is that of `node` in Python."""
        match node:
            case ast.BoolOp(operator, [first, *rest]):
                sign = " && " if isinstance(operator, ast.And) else " || "
                text = self.test(first)
                with self.holding(first, isinstance(operator, ast.And)):
                    after = self.test(ast.BoolOp(operator, rest) if len(rest) > 1 else rest[0])
                return f"({text}{sign}{after.removeprefix('(').removesuffix(')') if False else after})"
            case ast.UnaryOp(ast.Not(), value):
                return f"!{self.test(value)}"
        return self._truth(self.e(node), node)

    def _truth(self, text: str, node: ast.expr) -> str:
        """Return the test of what has been written as `text`."""
        kind = self.infer(node)
        if kind in (WORD, INT, BOOL, STR) or (kind in FLOATS and not self.checked):
            return text
        if "iterator" in [each.name for each in either(kind)]:
            self.fail(node, "an iterator is always true", "a list")
        return f"$.truth({text})"

    def e(self, node: ast.expr) -> str:
        """Return an expression."""
        if (number := whole(node)) is not None:
            if abs(number) >= MOST and (abs(number) >= 1 << 1000 or int(float(number)) != number):
                return f"({number}n)" if number < 0 else f"{number}n"
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
            case ast.Constant(str(value)) if any(
                "\ud800" <= each <= "\udfff" or each > "\uffff" for each in value
            ):
                self.fail(node, "a character beyond U+FFFF has another length in JavaScript")
            case ast.Constant(bool() | str() | float() as value):
                return json.dumps(value)
            case ast.BinOp(left, operator, right):
                return self.binary(node, operator, (self.e(left), left), (self.e(right), right))
            case ast.UnaryOp(ast.Not()):
                return self.test(node)
            case ast.UnaryOp(operator, value):
                return self._unary(node, operator, value)
            case ast.BoolOp(operator, values):
                return self._choice(isinstance(operator, ast.And), values)
            case ast.IfExp(test, one, other):
                text = self.test(test)
                with self.holding(test, True):
                    first = self.e(one)
                with self.holding(test, False):
                    return f"({text} ? {first} : {self.e(other)})"
            case ast.Compare(left, operators, rights):
                return self._compared(node, left, operators, rights)
            case ast.NamedExpr(target, value):
                return f"({self.e(target)} = {self.e(value)})"
            case ast.Subscript(value, index):
                return self._indexed(value, index)
            case ast.Tuple(items) | ast.List(items):
                return f"[{self.all(items)}]"
            case ast.Set(items):
                self.keyed(node, self._joined(items))
                each = (
                    f"...{self.iterated(item.value, False)}"
                    if isinstance(item, ast.Starred)
                    else self.e(item)
                    for item in items
                )
                return f"$.set([{', '.join(each)}])"
            case ast.Dict(keys, values):
                self.keyed(node, self.infer(node).of[0])
                pairs = zip(keys, values, strict=True)
                each = (f"[{self.e(k)}, {self.e(v)}]" if k else f"...{self.e(v)}.items()" for k, v in pairs)
                return f"$.dict([{', '.join(each)}])"
            case ast.Starred(ast.GeneratorExp(value, generators)):
                return f"...{self._comprehension(generators, value)}"
            case ast.Starred(value):
                return f"...{self.iterated(value)}"
            case ast.Lambda(
                ast.arguments(args=parameters, defaults=[], vararg=None, kwarg=None, kwonlyargs=[])
            ):
                names = [each.arg for each in parameters]
                kinds = self.lambdas.get(node, [])
                self.scope = self.scope.new_child(
                    {name: kinds[at] if at < len(kinds) else ANY for at, name in enumerate(names)}
                )
                text = f"(({', '.join(map(named, names))}) => {self.e(node.body)})"
                self.scope = self.scope.parents
                return text
            case ast.JoinedStr(values):
                return f"`{''.join(map(self._piece, values))}`"
            case ast.ListComp(value, generators):
                return self._comprehension(generators, value)
            case ast.GeneratorExp(value, generators):
                return self._generator(generators, value)
            case ast.SetComp(value, generators):
                self.keyed(node, self.infer(node).of[0])
                return f"$.set({self._comprehension(generators, value, ordered=False)})"
            case ast.DictComp(key, value, generators):
                self.keyed(node, self.infer(node).of[0])
                return f"$.dict({self._comprehension(generators, ast.Tuple([key, value]))})"
        self.fail(node, instead=_INSTEAD.get(type(node), ""))

    def all(self, nodes: list[ast.expr]) -> str:
        """Return expressions, one after another."""
        return ", ".join(map(self.e, nodes))

    # Keys, iterations.

    def keyed(self, node: ast.AST, kind: Type) -> None:
        """Refuse keys that JavaScript tells apart otherwise: all but numbers, texts, None and objects."""
        kinds = either(kind)
        mixed = BOOL in kinds and any(each in NUMBERS for each in kinds)
        for each in kinds:
            of = self.program.classes.get(each.name)
            instance = of is not None and of.module.table == "" and (of.is_enum or of.fields is None)
            fine = each in (*NUMBERS, STR, BOOL, NONE, UNSEEN) or instance or each.name in ("type", "call")
            if (not fine or mixed) and not self.trusted:
                self.fail(node, f"{kind} as a key", "a text or a number")

    def iterated(self, node: ast.expr, ordered: bool = True) -> str:
        """Return what is iterated over; refuse what has another order in JavaScript, or none."""
        if not self.trusted:
            kind = self.infer(node)
            for each in either(kind):
                if each.name == "set" and not ordered:
                    continue
                if each.name in ("set", "unordered"):
                    self.fail(node, "a set has another order in JavaScript", "sorted(...)")
                if not self.fits(each, Type("iterable", (ANY,))) or self._mentions(each):
                    self.fail(node, f"iteration over {each}", "an annotation")
        return self.e(node)

    @staticmethod
    def _mentions(kind: Type) -> bool:
        return kind == ANY

    # Operators.

    def _unary(self, node: ast.expr, operator: ast.unaryop, value: ast.expr) -> str:
        kind, text = self.known(value), self.e(value)
        if kind not in (*NUMBERS, BOOL) and not self.trusted:
            self.fail(node, f"the operator on {kind}")
        if not self.checked or (kind in FLOATS and isinstance(operator, ast.USub)):
            return {ast.Invert: f"(-{text} - 1)", ast.USub: f"(-{text})"}.get(type(operator), text)
        if isinstance(operator, ast.UAdd):
            return f"$.plus({text}, 0)" if kind == BOOL else text
        name = "invert" if isinstance(operator, ast.Invert) else "neg"
        if kind in FLOATS:
            self.fail(node, f"the operator on {kind}")
        if kind == WORD:
            return f"(-1 - {text})" if name == "invert" else f"(0 - {text})"
        return f"$.{name}({text})"

    def _kind_in_arithmetic(self, node: ast.expr) -> Type:
        kind = self.infer(node)
        kind = self._enumerated(kind) or kind
        if NONE in either(kind) and not self.trusted:
            self.fail(node, "it may be None", "a test that it is not")
        if kind.name == "|" and all(each in (*NUMBERS, BOOL) for each in kind.of):
            kind = join(*(INT if each == BOOL else each for each in kind.of))
        return without_none(kind)

    def binary(
        self, node: ast.AST, operator: ast.operator, left: tuple[str, ast.expr], right: tuple[str, ast.expr]
    ) -> str:
        """Return `left operator right`, each as it is written and as it was."""
        (a, one), (b, other) = left, right
        if type(operator) not in _OPERATORS:
            self.fail(node, "no such operator")
        name, direct = _OPERATORS[type(operator)]
        kinds = self._kind_in_arithmetic(one), self._kind_in_arithmetic(other)
        number = whole(other)
        if set(kinds) <= {*NUMBERS, BOOL}:
            if not self.checked and BOOL not in kinds:
                return self._plain(operator, kinds, number, direct, name, a, b)
            return self._exact(node, operator, kinds, (whole(one), number), direct, a, b)
        if kinds == (STR, STR) and isinstance(operator, ast.Add):
            return direct.format(a, b)
        if not self.trusted and not self._operable(operator, *kinds):
            self.fail(
                node, f"{kinds[0]} and {kinds[1]} with this operator", "it another way, or an annotation"
            )
        return f"$.{name}({a}, {b})"

    def _operable(self, operator: ast.operator, one: Type, other: Type) -> bool:
        """Whether the runtime does the operator on these types as Python does."""
        if ANY in (one, other):
            return isinstance(operator, ast.Add | ast.Sub | ast.Mult | ast.Div | ast.Pow)
        if one.name == "|" or other.name == "|":
            return all(
                self._operable(operator, a, b) or {a, b} <= {*NUMBERS, BOOL}
                for a in either(one)
                for b in either(other)
            )
        names = {one.name, other.name}
        match operator:
            case ast.Add() if names <= {"tuple", "row"} or (
                len(names) == 1 and names <= {"list", "bytes", "bytearray", "str"}
            ):
                return True
            case ast.Mult() if one in (*WHOLE, BOOL) or other in (*WHOLE, BOOL):
                of = other if one in (*WHOLE, BOOL) else one
                return of.name in ("str", "list", "tuple", "row", "bytes")
            case ast.BitOr() if names == {"dict"}:
                return True
            case ast.BitOr() | ast.BitAnd() | ast.Sub() if names <= {"set", "view"}:
                return True
        if one.name == "Fraction":
            return (other in WHOLE or other.name == "Fraction") and isinstance(
                operator, ast.Add | ast.Sub | ast.Mult | ast.Div | ast.Pow
            )
        own = self.program.classes.get(one.name)
        dunder = DUNDERS.get(type(operator))
        return bool(own and own.module.table == "" and dunder and self.of_class(one.name, dunder)[1])

    @staticmethod
    def _plain(
        operator: ast.operator,
        kinds: tuple[Type, Type],
        number: int | None,
        direct: str,
        name: str,
        a: str,
        b: str,
    ) -> str:
        """Return an operation on numbers below 2^53."""
        words = kinds == (WORD, WORD)
        match operator:
            case ast.Add() | ast.Sub() | ast.Mult() | ast.Pow() | ast.LShift():
                fits = True
            case ast.Div() | ast.FloorDiv():
                fits = bool(number)
            case ast.Mod():
                fits = words and bool(number)
            case ast.RShift():
                fits = words and number is not None and number < 32
            case ast.BitAnd():
                fits = WORD in kinds
            case _:
                fits = words
        return direct.format(a, b) if fits else f"$.{name}({a}, {b})"

    def _exact(
        self,
        node: ast.AST,
        operator: ast.operator,
        kinds: tuple[Type, Type],
        numbers: tuple[int | None, int | None],
        direct: str,
        a: str,
        b: str,
    ) -> str:
        """Return an operation on numbers of any size."""
        words, number = kinds == (WORD, WORD), numbers[1]
        if FLOAT in kinds or REAL in kinds:
            if isinstance(operator, ast.Add | ast.Sub | ast.Mult):
                a, b = (
                    f"Number({text})" if kind in (INT, BOOL) and value is None else text
                    for text, kind, value in zip((a, b), kinds, numbers, strict=True)
                )
                return direct.format(a, b)
            names = {ast.Div: "div_", ast.FloorDiv: "floordiv_", ast.Mod: "mod_", ast.Pow: "power_"}
            if type(operator) not in names:
                self.fail(node, "an operator of whole numbers on a float")
            if isinstance(operator, ast.Pow) and kinds[1] not in WHOLE and not self.trusted:
                self.fail(node, "a power that may be a complex number", "math.pow(...)")
            if isinstance(operator, ast.Div) and number:
                return direct.format(f"Number({a})" if kinds[0] == INT else a, b)
            return f"$.{names[type(operator)]}({a}, {b})"
        if isinstance(operator, ast.Pow) and kinds[1] != WORD and not (number or 0) < 0:
            self.fail(
                node, "a power whose exponent may be negative is an int or a float", "a float, or x ** 2"
            )
        small = [value is not None and 0 <= value < 1 << 22 for value in numbers]
        match operator:
            case ast.Add() | ast.Sub():
                fits = words
            case ast.Mult():
                fits = words and any(small)
            case ast.Div() | ast.FloorDiv() | ast.Mod():
                fits = words and bool(number)
            case ast.RShift():
                fits = words and number is not None and number < 32
            case ast.LShift():
                fits = kinds[0] == WORD and number is not None and 0 <= number <= 21
            case ast.Pow():
                fits = False
            case _:
                fits = words
        return direct.format(a, b) if fits else f"$.{_EXACT[type(operator)]}({a}, {b})"

    def _choice(self, both: bool, values: list[ast.expr]) -> str:
        """Return `and` or `or` as a value: the operand that decides."""
        first, *rest = values
        text = self.e(first)
        if not rest:
            return text
        with self.holding(first, both):
            after = self._choice(both, rest)
        if self._truth("", first) == "":
            return f"({text} {'&&' if both else '||'} {after})"
        once = self.temp()
        test = self._truth(f"({once} = {text})", first)
        return f"({test} ? {after} : {once})" if both else f"({test} ? {once} : {after})"

    def _compared(
        self, node: ast.expr, left: ast.expr, operators: list[ast.cmpop], rights: list[ast.expr]
    ) -> str:
        parts, a = [], self.e(left)
        for operator, right in zip(operators, rights, strict=True):
            b = again = self.e(right)
            if right is not rights[-1]:
                again = self.temp()
                b = f"({again} = {b})"
            parts.append(self.comparison(node, operator, (a, left), (b, right)))
            a, left = again, right
        return parts[0] if len(parts) == 1 else f"({' && '.join(parts)})"

    def comparison(
        self, node: ast.expr, operator: ast.cmpop, left: tuple[str, ast.expr], right: tuple[str, ast.expr]
    ) -> str:
        """Return one comparison."""
        (a, one), (b, other) = left, right
        kinds = self.infer(one), self.infer(other)
        values = tuple(self._enumerated(kind) or kind for kind in kinds)
        numbers = all(each in (*NUMBERS, BOOL) for each in values)
        same = numbers or values == (STR, STR)
        no = "!" if isinstance(operator, ast.IsNot | ast.NotEq | ast.NotIn) else ""
        match operator:
            case ast.Is() | ast.IsNot():
                loose = isinstance(other, ast.Constant) and other.value is None
                if not loose and not self._has_identity(kinds[0], kinds[1]):
                    self.fail(node, "the identity of what has none in JavaScript", "==")
                return f"({a} {no or '='}={'' if loose else '='} {b})"
            case ast.Eq() | ast.NotEq():
                if values in ((WORD, WORD), (STR, STR), (BOOL, BOOL)):
                    return f"({a} {no or '='}== {b})"
                if numbers:
                    strict = "" if self.checked or BOOL in values else "="
                    return f"({a} {no or '='}={strict} {b})"
                self.comparable(node, *kinds)
                return f"{no}$.eq({a}, {b})"
            case ast.In() | ast.NotIn():
                return no + self._contained(node, (a, kinds[0]), (b, kinds[1]))
        name, sign = _ORDER[type(operator)]
        if not same:
            self._orderable(node, kinds[0], kinds[1])
        return f"({a} {sign} {b})" if same else f"$.{name}({a}, {b})"

    def _has_identity(self, one: Type, other: Type) -> bool:
        """Whether `is` tells in JavaScript what it tells in Python."""

        def sure(kind: Type) -> bool:
            of = self.program.classes.get(kind.name)
            return (
                kind in (BOOL, NONE)
                or bool(of and of.module.table == "")
                or kind.name in ("list", "dict", "set", "type")
            )

        return self.trusted or all(map(sure, (*either(one), *either(other))))

    def comparable(self, node: ast.AST, one: Type, other: Type) -> None:
        """Refuse to compare what only Python tells apart: a list and a tuple, or what is unknown."""
        if not self.trusted and not all(self._equatable(a, b) for a in either(one) for b in either(other)):
            self.fail(node, f"{one} compared with {other}", "both as lists, or an annotation")

    def _equatable(self, one: Type, other: Type) -> bool:
        scalars = (*NUMBERS, STR, BOOL, NONE)
        a, b = (self._enumerated(each) or each for each in (one, other))
        if a in scalars or b in scalars:
            return True
        if UNSEEN in (one, other):
            return True
        if ANY in (one, other):
            return False
        names = {one.name, other.name}
        if names <= {"bytes", "bytearray"} or names == {"words"}:
            return True
        parts, others = self.parts(one), self.parts(other)
        if parts is not None and others is not None:
            return len(parts) != len(others) or all(map(self._both, parts, others))
        if names <= {"tuple", "row"}:
            return self._both(self.item(one), self.item(other))
        if (parts is not None and other.name == "row") or (others is not None and one.name == "row"):
            return self._both(self.item(one), self.item(other))
        if len(names) == 1 and names <= {"list", "set", "dict"}:
            return all(map(self._both, one.of, other.of))
        of, to = (self._own_class(each) for each in (one, other))
        if one.name == other.name == "Fraction":
            return True
        if of and to:
            return (parts is None) == (others is None)
        lists, ours = (
            {"list", "tuple", "row", "dict", "set", "bytes", "bytearray", "words"},
            bool(of) or bool(to),
        )
        return ours and bool(names & lists) and parts is None and others is None and not (of and to)

    def _own_class(self, kind: Type) -> Found | None:
        of = self.program.classes.get(kind.name)
        return of if of and not of.module.table else None

    def _both(self, one: Type, other: Type) -> bool:
        return all(self._equatable(a, b) for a in either(one) for b in either(other))

    def _orderable(self, node: ast.AST, one: Type, other: Type) -> None:
        if not self.trusted and not self._ordered(one, other):
            self.fail(node, f"the order of {one} and {other}", "a key, or an annotation")

    def _ordered(self, one: Type, other: Type) -> bool:
        values = [self._enumerated(each) or each for each in (one, other)]
        if all(each in (*NUMBERS, BOOL) for each in values) or values == [STR, STR] or UNSEEN in values:
            return True
        numbers = all(each in (*NUMBERS, BOOL, ANY) for each in values) or one.name == "Fraction"
        if numbers and values != [ANY, ANY]:
            return True
        parts, others = self.parts(one), self.parts(other)
        if parts is not None and others is not None:
            return all(map(self._ordered, parts, others))
        names = {one.name, other.name}
        if names <= {"tuple", "row"} or names in ({"list"}, {"bytes"}):
            return self._ordered(self.item(one), self.item(other))
        return False

    def _contained(self, node: ast.expr, item: tuple[str, Type], of: tuple[str, Type]) -> str:
        """Return `item in of`."""
        (a, kind), (b, all_) = item, of
        if not self.trusted:
            for each in either(all_):
                inner = self.item(each)
                if each.name in ("dict", "set"):
                    if ANY in either(kind) or (
                        (BOOL in either(kind)) != (BOOL in either(each.of[0])) and UNSEEN not in each.of
                    ):
                        self.fail(node, f"{kind} as a key", "a text or a number")
                    self.keyed(node, kind)
                elif each == STR or each.name == "bytes":
                    if (each == STR and (self._enumerated(kind) or kind) != STR) or kind == ANY:
                        self.fail(node, f"{kind} in {each}")
                elif each == ANY or not (
                    each.name == "collection" or self.fits(each, Type("collection", (ANY,)))
                ):
                    self.fail(node, f"something in {each}", "an annotation")
                else:
                    self.comparable(node, kind, inner)
        item_ = self.item(all_)
        same = kind == item_ or (not self.checked and kind in WHOLE and item_ in WHOLE)
        plain = kind in (STR, WORD, INT) and same and all_.name in _LISTS
        return f"{b}.includes({a})" if plain else f"$.has({b}, {a})"

    # Names, attributes, items.

    def _name(self, node: ast.Name, name: str) -> str:
        if name == "self" and self.owner:
            return "this"
        if not name.isascii():
            self.fail(node, "a name with other letters than ASCII's")
        if name in self.scope:
            return named(name)
        found = self.program.find(self.module, name)
        if found is None:
            module, real = self.module.imports.get(name, ("", name))
            self.fail(node, f"the table of what may be used has no {real or module}")
        if found.module.table:
            if found.node is None:
                return f"$.{found.module.table}"
            if isinstance(found.node, ast.FunctionDef) or found.is_class:
                return self._as_value(node, found)
            return f"$.{found.node.target.id}"
        if found.is_class and not found.is_enum and not self.trusted:
            self.fail(node, "a class as a value", "a function that makes one")
        if isinstance(found.node, ast.FunctionDef):
            of = found.node.args
            if of.vararg or of.kwarg or of.kwonlyargs:
                self.fail(node, "a function with * as a value", "a lambda")
        return named(name)

    def _as_value(self, node: ast.expr, found: Found) -> str:
        """Return a function of Python's own, or a class, that is given to another."""
        takes = self.lambdas.get(node)
        if takes is None and len(variants := self.program.variants(found)) == 1:
            takes = [
                self.annotated(each.annotation, found.module) for each in variants[0].node.args.posonlyargs
            ]
        if not takes or any(each.name[0] == "~" or each.of for each in takes):
            self.fail(node, "a function of Python's own as a value", "a lambda")
        names = [f"$a{at}" for at in range(len(takes))]
        self.scope = self.scope.new_child(dict(zip(names, takes, strict=True)))
        text = self.e(
            ast.copy_location(
                ast.Call(node, [ast.copy_location(ast.Name(each, ast.Load()), node) for each in names], []),
                node,
            )
        )
        self.scope = self.scope.parents
        return f"(({', '.join(names)}) => {text})"

    def attributed(self, node: ast.Attribute) -> None:
        """Refuse an attribute that is not known."""
        of = self.found(node.value)
        if self.trusted or (of and of.node is None):
            return
        if isinstance(node.value, ast.Call) and leaf(node.value.func) == "super":
            return
        if of and of.is_class and of.module.table == "":
            declared = any(
                node.attr in map(leaf, [getattr(each, "target", None), *getattr(each, "targets", [])])
                or getattr(each, "name", "") == node.attr
                for one in self.program.lineage(of)
                for each in one.node.body
            )
            if not declared:
                self.fail(node, f"{leaf(node.value)} has no {node.attr}")
            return
        if (of and of.is_class) or (of and of.module.table and isinstance(of.node, ast.FunctionDef)):
            kind = Type(leaf(node.value))
        else:
            kind = self.known(node.value)
        for each in either(kind):
            if not self.has(each, node.attr):
                self.fail(node, f"{each} has no {node.attr}")

    def _attribute(self, node: ast.Attribute, value: ast.expr, name: str) -> str:
        self.attributed(node)
        of = self.found(value)
        if of and of.node is None:
            inner = self.program.find(of.module, name)
            if inner is None:
                self.fail(node, f"the table of what may be used has no {name}")
            if of.module.table:
                if not isinstance(inner.node, ast.AnnAssign):
                    return self._as_value(node, inner)
                return f"$.{name}"
            return f"{self.dotted(node, name)}"
        method = self.found(node)
        if method and isinstance(method.node, ast.FunctionDef) and not method.is_property:
            if of and of.is_class:
                if "staticmethod" not in map(leaf, method.node.decorator_list):
                    self.fail(node, "a method of a class as a value", "a lambda")
                return self.dotted(node, name)
            return f'$.bound({self.e(value)}, "{member(name)}")'
        return self.dotted(node, name)

    def _indexed(self, value: ast.expr, index: ast.expr) -> str:
        kind, text = self.known(value), self.e(value)
        if isinstance(index, ast.Slice):
            return self._sliced(value, index, kind, text)
        if not self.trusted:
            self._index(value, index, kind)
        at = self.e(index)
        if kind.name == "dict":
            return f"{text}.at({at})"
        parts, number = self.parts(kind), whole(index)
        if parts is not None and kind.name == "tuple" and number is not None and 0 <= number < len(parts):
            return f"{text}[{number}]"
        if kind.name == "words" and not self.checked:
            return f"{text}[{at}]"
        twice = re.fullmatch(r"[\w.$]+", text + at)  # it may stand there twice
        direct = twice and kind.name in (*_LISTS, "words")
        named_ = ', "tuple index"' if kind.name in ("tuple", "row") and self.checked else ""
        safe = f"$.at({text}, {at}{named_})"
        return f"({text}[{at}] ?? {safe})" if direct else safe

    def _index(self, value: ast.expr, index: ast.expr, kind: Type) -> None:
        """Refuse an index that is neither a whole number nor a key."""
        for each in either(kind):
            by = self.infer(index)
            of = self.program.classes.get(each.name)
            if each.name == "dict":
                if (BOOL in either(by)) != (BOOL in either(each.of[0])) or ANY in either(by):
                    self.fail(index, f"{by} as a key of {each}")
                self.keyed(index, by)
            elif each.name in (*_LISTS, "words", "range") or self.parts(each) is not None:
                if (self._enumerated(by) or by) not in WHOLE:
                    self.fail(index, f"{by} as an index", "an int")
            elif not (of and self.of_class(each.name, "__getitem__")[1]):
                self.fail(value, f"an item of {each}", "a list, or an annotation")

    def _sliced(self, value: ast.expr, index: ast.Slice, kind: Type, text: str) -> str:
        if index.step:
            self.fail(index, "a slice by steps", "a comprehension over range")
        of = self.program.classes.get(kind.name)
        own = of is not None and of.module.table == ""
        if not self.trusted and not own and any(each.name not in (*_LISTS, "words") for each in either(kind)):
            self.fail(value, f"a slice of {kind}")
        for each in (index.lower, index.upper):
            bound = self.infer(each) if each else NONE
            if not self.trusted and without_none(bound) not in (*WHOLE, NONE):
                self.fail(index, f"{bound} as a bound of a slice", "an int or None")
        lower = self._bound(index.lower) if index.lower else "0"
        end = f", {self._bound(index.upper)}" if index.upper else ""
        if index.upper and self.infer(index.upper) not in WHOLE:
            end += " ?? undefined"  # None is the end
        return f"{text}.slice({lower}{end})"

    def _bound(self, node: ast.expr) -> str:
        """Return a bound of a slice: a BigInt is none in JavaScript."""
        text = self.e(node)
        plain = not self.checked or self.infer(node) != INT or (abs(whole(node) or MOST) < MOST)
        return text if plain else f"Number({text})"

    # Text.

    def shown(self, text: str, kind: Type, node: ast.AST, quoted: bool) -> str:
        """Return the str of what is written as `text`, or its repr, as a text in JavaScript."""
        name = "repr" if quoted else "str"
        kinds = either(kind)
        if self.trusted and not set(kinds) <= {INT, WORD, BOOL, NONE, STR, FLOAT}:
            return f"$.{name}({text})"
        if REAL in kinds or (FLOAT in kinds and any(each in WHOLE for each in kinds)):
            self.fail(node, "it may be an int or a float, which Python writes otherwise", "float(...)")
        simple = {INT, WORD, BOOL, NONE, STR, BYTES}
        if kind == STR and not quoted:
            return text
        if set(kinds) <= simple or (
            not quoted and all(self._writes_itself(each) or each in simple for each in kinds)
        ):
            return f"$.{name}({text})"
        if set(kinds) <= {*simple, FLOAT}:
            return f"$.{name}($.floating({text}))"
        if len(kinds) == 1 and kind.name in ("list", "tuple", "row", "dict", "set"):
            return self._displayed(text, kind, node)
        of = self.program.classes.get(kind.name)
        if of and self._displays_its_fields(of):
            parts = (f"(($v) => {self.shown('$v', inner, node, True)})" for _, inner in self.fields_of(of))
            return f"$.displayed({text}, {', '.join(parts)})"
        self.fail(node, f"{kind} as a text", "its parts")

    def _displays_its_fields(self, of: Found) -> bool:
        """Whether its text is that of all its fields: a record no other is made from."""
        if of.fields is None or of.module.table or of.node.name in self.program.inherited:
            return False
        own = any(self.of_class(of.kind.name, name)[1] for name in ("__str__", "__repr__"))
        return not own and not any("repr" in ast.unparse(each) for each in of.node.decorator_list)

    def _writes_itself(self, kind: Type) -> bool:
        if self._enumerated(kind):
            return True
        of = self.program.classes.get(kind.name)
        return bool(of) and bool(self.of_class(kind.name, "__str__")[1])

    def _displayed(self, text: str, kind: Type, node: ast.AST) -> str:
        inner = [f"(($v) => {self.shown('$v', each, node, True)})" for each in kind.of]
        if UNSEEN in kind.of:
            inner = ["$.repr"] * len(kind.of)
        if kind.name == "set":
            self.fail(node, "a set has another order in JavaScript", "sorted(...)")
        if kind.name == "dict":
            return f"$.shown_dict({text}, {', '.join(inner)})"
        if kind.name == "tuple":
            return f"$.shown_tuple({text}, [{', '.join(inner)}])"
        return f"$.shown_{kind.name}({text}, {inner[0]})"

    def _piece(self, value: ast.expr) -> str:
        """Return a piece of an f-string."""
        if isinstance(value, ast.Constant):
            text = self.e(value)[1:-1]
            return text.replace('\\"', '"').replace("`", "\\`").replace("${", "\\${")
        assert isinstance(value, ast.FormattedValue)
        kind, text = self.infer(value.value), self.e(value.value)
        if value.conversion == ord("a"):
            self.fail(value, "ascii()", "!r")
        quoted = value.conversion == ord("r")
        if value.format_spec is None:
            if kind == WORD:
                return f"${{{text}}}"
            return f"${{{self.shown(text, kind, value, quoted)}}}"
        assert isinstance(value.format_spec, ast.JoinedStr)
        if quoted or value.conversion == ord("s"):
            text, kind = self.shown(text, kind, value, quoted), STR
        self._spec(value, kind, value.format_spec)
        if kind == FLOAT:
            text = f"$.floating({text})"
        return f"${{$.format({text}, {self.e(value.format_spec)})}}"

    def _spec(self, node: ast.FormattedValue, kind: Type, spec: ast.JoinedStr) -> None:
        """Refuse a format that the runtime does not have for this type."""
        kind = self._enumerated(kind) or kind
        parts = (str(each.value) if isinstance(each, ast.Constant) else "{}" for each in spec.values)
        written = "".join(parts)
        match = _SPEC.fullmatch(written)
        inner = [each for each in spec.values if isinstance(each, ast.FormattedValue)]
        whole_parts = all(self.infer(each.value) in WHOLE and each.format_spec is None for each in inner)
        fits = match is not None and whole_parts
        if fits and match:
            plus, zero, _, comma, places, letter = match.groups()
            kinds = set(either(kind))
            if kind == STR:
                fits = not (plus or zero or comma or places or letter)
            elif kind in WHOLE:
                fits = (not places or letter in ("f", "g")) and not (comma and (zero or letter))
            elif kind == FLOAT:
                fits = (
                    letter in ("f", "g", None)
                    and bool(letter or not places)
                    and not (comma and (zero or letter == "g"))
                )
            elif kind == REAL or kinds <= {FLOAT, REAL, WORD, INT}:
                fits = letter in ("f", "g") and not comma
        if not fits and not self.trusted:
            self.fail(node, f"no translation of the format {written!r} of {kind}")

    # Comprehensions.

    def _loops(
        self, generators: list[ast.comprehension], first: str = "", ordered: bool = True
    ) -> tuple[list[str], list[str]]:
        """Return the loops of a comprehension and the names it sets; within `comprehending`."""
        loops, names = [], list[str]()
        for generator in generators:
            source = first or self.iterated(generator.iter, ordered)
            first = ""
            sets = self._set_by(generator)
            self.scope |= {leaf(target): kind for target, kind in sets}
            for target, _ in sets:
                self.forget(leaf(target))
            names += [named(leaf(target)) for target, _ in sets]
            loops.append(self.looped(generator.target, source, generator.iter))
            for test in generator.ifs:
                loops.append(f"if ({self.test(test)})")
                self.held = self.held | self.said(test, True)
        return loops, names

    def looped(self, target: ast.expr, source: str, of: ast.expr, declare: str = "const ") -> str:
        """Return the head of a loop over what is written as `source`; "const " or "" before the target."""
        item = self.item(self.infer(of))
        if isinstance(target, ast.Tuple) and not self.fits_target(target, item):
            count, star = self._counted(target, item)
            source = f"$.unpacked({source}, {count}{star})"
        return f"for ({declare}{self.target(target)} of {source})"

    def target(self, node: ast.expr) -> str:
        """Return a target: a name, an attribute or several of them."""
        if isinstance(node, ast.Tuple | ast.List):
            parts = (each.value if isinstance(each, ast.Starred) else each for each in node.elts)
            return f"[{', '.join(map(self.target, parts))}]"
        if isinstance(node, ast.Attribute):
            return f"{self.e(node.value)}.{member(node.attr)}"
        if not isinstance(node, ast.Name):
            self.fail(node, "such a target within others")
        return self.e(node)

    def fits_target(self, target: ast.Tuple, kind: Type) -> bool:
        """Whether what is unpacked has as many items as there are targets, at each level."""
        if any(isinstance(each, ast.Starred) for each in target.elts):
            return False
        for one in either(kind):
            parts = self.parts(one)
            if parts is None or len(parts) != len(target.elts):
                return False
            for each, part in zip(target.elts, parts, strict=True):
                if isinstance(each, ast.Tuple) and not self.fits_target(each, part):
                    self.fail(target, "an inner target of another length")
        return True

    def _counted(self, target: ast.Tuple, item: Type) -> tuple[int, str]:
        star = [at for at, each in enumerate(target.elts) if isinstance(each, ast.Starred)]
        inner = [each for each in target.elts if isinstance(each, ast.Tuple)]
        if not all(self.fits_target(each, self.item(item)) for each in inner):
            self.fail(target, "targets within targets of unknown length")
        return len(target.elts), f", {star[0]}" if star else ""

    def _comprehension(
        self, generators: list[ast.comprehension], value: ast.expr, ordered: bool = True
    ) -> str:
        put = ("const $r = [];", lambda text: f"$r.push({text});", "return $r;")
        return self._comprehended_as(generators, value, *put, ordered=ordered)

    def _comprehended_as(
        self,
        generators: list[ast.comprehension],
        value: ast.expr,
        before: str,
        put: Callable[[str], str],
        after: str,
        test: bool = False,
        ordered: bool = True,
    ) -> str:
        """Return a comprehension as a function that is called at once."""
        self.scope = self.scope.new_child()
        held = dict(self.held)
        loops, names = self._loops(generators, ordered=ordered)
        text = self.test(value) if test else self.e(value)
        self.scope, self.held = self.scope.parents, held
        late = any(isinstance(each, ast.Lambda) for one in (value, *generators) for each in ast.walk(one))
        if late:  # its variable is one for all turns
            before = f"let {', '.join(names)}; {before}"
            loops = [each.replace("for (const ", "for (", 1) for each in loops]
        return f"(() => {{ {before} {' '.join(loops)} {put(text)} {after} }})()"

    def _generator(self, generators: list[ast.comprehension], value: ast.expr) -> str:
        """Return a generator expression: its first iterable is there at once, all else when it is wanted."""
        first = self.iterated(generators[0].iter)
        self.scope = self.scope.new_child()
        held = dict(self.held)
        loops, names = self._loops(generators, "$of")
        text = self.e(value)
        self.scope, self.held = self.scope.parents, held
        loops = [each.replace("for (const ", "for (", 1) for each in loops]
        body = f"let {', '.join(names)}; {' '.join(loops)} yield {text};"
        return f"(function* ($of) {{ {body} }}).call(this, {first})"

    # Calls.

    def _call(self, node: ast.Call) -> str:
        function, name = node.func, leaf(node.func)
        if (
            name in ("_replace", "replace")
            and node.keywords
            and (isinstance(function, ast.Name) or name == "_replace")
        ):
            return self._replaced(node)
        if isinstance(function, ast.Name) and name not in self.scope and (text := self._built_in(node, name)):
            return text
        if isinstance(function, ast.Attribute) and leaf(getattr(function.value, "func", None)) == "super":
            found = self.found(function)
            return f"super.{name}({self._arguments(node, found)})"
        found = self.found(function)
        self.infer(node)  # what it says of the functions it is given
        if found and found.module.table and found.node is not None:
            return self._library(node, found)
        if isinstance(function, ast.Attribute):
            self.attributed(function)
        elif isinstance(function, ast.Name) and name not in self.scope and found is None:
            self.fail(
                node,
                f"the table of what may be used has no {name}",
            )
        if found is None or found.node is None or not isinstance(found.node, ast.FunctionDef | ast.ClassDef):
            kind = self.infer(function)
            if any(each.name != "call" for each in either(kind)) and not self.trusted:
                self.fail(node, f"a call of {kind}", "an annotation")
            if node.keywords:
                self.fail(node, "keywords for a function of unknown parameters", "them by their places")
            return f"{self.dotted(function, name)}({self._arguments(node, None)})"
        if found.is_class and found.is_enum:
            self.fail(node, "a member of an enumeration by its value")
        new = "new " if found.is_class else ""
        return f"{new}{self.dotted(function, name)}({self._arguments(node, found)})"

    def _replaced(self, node: ast.Call) -> str:
        of = node.args[0] if node.args else node.func.value  # type: ignore[attr-defined]
        kind = self.infer(of)
        found = self.program.classes.get(kind.name)
        fields = dict(self.fields_of(found)) if found and found.fields is not None else {}
        for keyword in node.keywords:
            if keyword.arg not in fields:
                self.fail(node, f"{kind} has no field {keyword.arg}")
            self.accept(keyword.value, fields[keyword.arg])
        text = (f"{keyword.arg}: {self.e(keyword.value)}" for keyword in node.keywords)
        return f"$.replaced({self.e(of)}, {{ {', '.join(text)} }})"

    def dotted(self, node: ast.expr, name: str) -> str:
        """Return a name, or a member of what is before it."""
        if isinstance(node, ast.Name):
            return named(name)
        if not isinstance(node, ast.Attribute):
            return self.e(node)
        of = self.found(node.value)
        number = re.fullmatch(r"\d+n?", text := self._owner_text(node.value, of))
        before = f"({text})" if number else text
        return f"{before}.{named(name) if of and of.node is None else member(name)}"

    def _owner_text(self, node: ast.expr, of: Found | None) -> str:
        if of and of.is_class and isinstance(node, ast.Name):
            return named(node.id)
        if of and of.is_class and isinstance(node, ast.Attribute):
            return self.dotted(node, node.attr)
        return self.e(node)

    def _library(self, node: ast.Call, found: Found) -> str:
        """Return a call of what Python has of its own, if its arguments are those of the table."""
        function, name = node.func, leaf(node.func)
        receiver = None
        if (
            isinstance(function, ast.Attribute)
            and self._owner_class(function) is None
            and self.found(function.value) is None
        ) or (
            isinstance(function, ast.Attribute)
            and getattr(self.found(function.value), "node", 1) is not None
            and self._owner_class(function) is None
        ):
            self.attributed(function)
            receiver = self.known(function.value)
        if found.is_class and not self.program.variants(found):
            if len(node.args) > 1 or node.keywords:
                self.fail(node, "an error of several arguments", "one text")
            for each in node.args:
                if self.infer(each) != STR and not self.trusted:
                    self.fail(node, "an error whose argument is no text", "a text")
            return f"new $.{name}({self.all(node.args)})"
        chosen = None
        kinds = either(receiver) if receiver else (None,)
        for kind in kinds:
            method = found if kind is None else (self.of_class(kind.name, name)[1] or found)
            fitting = (
                each
                for each in self.program.variants(method)
                if self.bound(each, node.args, node.keywords, kind) is not None
            )
            chosen = next(fitting, None)
            if chosen is None and not self.trusted:
                given = ", ".join(str(self.infer(each)) for each in node.args)
                forms = " or ".join(
                    f"{name}({ast.unparse(each.node.args)})" for each in self.program.variants(method)
                )
                self.fail(node, f"{name} of ({given}) is not in the table", forms)
            self._constants(node, chosen or method)
        if name == "dumps" and not self.trusted and not self._is_json(self.infer(node.args[0])):
            self.fail(node, f"JSON of {self.infer(node.args[0])}", "texts, whole numbers, lists and dicts")
        if (
            name in ("ljust", "rjust")
            and len(node.args) > 1
            and len(str(getattr(node.args[1], "value", ""))) != 1
        ):
            self.fail(node, "what fills is not one character")
        if name == "int" and len(node.args) == 2 and whole(node.args[1]) not in (None, 2, 8, 10, 16):
            self.fail(node, "a base other than 2, 8, 10 and 16")
        if any(isinstance(each, ast.Starred) for each in node.args) and not self.trusted:
            self.fail(node, f"unpacked arguments of {name}", "each by itself")
        target = chosen or self.program.variants(found)[0]
        self._sorted(node, name, receiver)
        arguments = self._arguments(node, target, typed=False)
        if (
            isinstance(function, ast.Attribute)
            and (owner := self.found(function.value))
            and owner.node is None
        ):
            return (
                f"$.{owner.module.table}.{name}({arguments})"
                if owner.module.table in ("json", "re")
                else f"$.{name}({arguments})"
            )
        if isinstance(function, ast.Attribute):
            of = self._owner_class(function)
            text = f"$.{of}" if of else self.e(function.value)
            return f"{f'({text})' if re.fullmatch(r'[0-9]+n?', text) else text}.{member(name)}({arguments})"
        real = self.module.imports.get(name, ("", name))[1]
        return f"$.{real}({arguments})"

    def _owner_class(self, function: ast.Attribute) -> str | None:
        """Return the class of Python's own before the dot: `dict.fromkeys`."""
        of = self.found(function.value) if isinstance(function.value, ast.Name) else None
        return (
            leaf(function.value)
            if of and of.module.table and isinstance(of.node, ast.FunctionDef | ast.ClassDef)
            else None
        )

    def _constants(self, node: ast.Call, found: Found) -> None:
        """Refuse another value than the table has for a parameter with a Literal."""
        receiver = isinstance(node.func, ast.Attribute) and "staticmethod" not in map(
            leaf, found.node.decorator_list
        )
        for value, annotation in self.paired(found, node.args, node.keywords, receiver) or []:
            if leaf(annotation) == "Literal":
                allowed = [each.value for each in ast.walk(annotation) if isinstance(each, ast.Constant)]  # type: ignore[arg-type]
                if not isinstance(value, ast.Constant) or value.value not in allowed:
                    self.fail(value, "it has to be one of the table", " or ".join(map(repr, allowed)))

    def _sorted(self, node: ast.Call, name: str, receiver: Type | None) -> None:
        """Refuse keys, orders and comparisons within calls that JavaScript has otherwise."""
        if self.trusted:
            return
        if name in ("sorted", "min", "max", "bisect_left") and receiver is None and node.args:
            key = next((each.value for each in node.keywords if each.arg == "key"), None)
            of = self.infer(node.args[0])
            kind = self._joined(node.args) if len(node.args) > 1 and name in ("min", "max") else self.item(of)
            if key is not None:
                kind = self.infer(key).of[0] if self.infer(key).name == "call" else ANY
            for one in either(kind):
                for other in either(kind):
                    self._orderable(node, one, other)
        elif (
            name in ("index", "count", "remove")
            and receiver
            and receiver.name in ("list", "row", "tuple", "sequence")
        ):
            self.comparable(node, self.infer(node.args[0]), self.item(receiver))
        elif receiver and receiver.name in ("dict", "set") and node.args and name not in ("update",):
            by, own = self.infer(node.args[0]), receiver.of[0]
            self.keyed(node, by)
            if ((BOOL in either(by)) != (BOOL in either(own)) and own != UNSEEN) or ANY in either(by):
                self.fail(node, f"{by} as a key of {receiver}")
        elif name in ("set", "frozenset", "fromkeys") and node.args and not receiver:
            self.keyed(node, self.item(self.infer(node.args[0])))

    def _built_in(self, node: ast.Call, name: str) -> str:
        """Return a call of one of Python's own functions that is written in its own way."""
        found = self.found(node.func)
        if found is None and name not in ("isinstance", "getattr", "setattr", "type", "super"):
            return ""
        if found and not found.module.table:
            return ""
        kinds = [self.infer(each) for each in node.args]
        match name, node.args:
            case "isinstance", [value, of]:
                return self._is_instance(node, value, of)
            case "getattr", [value, ast.Constant(str(attribute))]:
                return self.e(ast.copy_location(ast.Attribute(value, attribute, ast.Load()), node))
            case "divmod", [_, _] if FLOAT in kinds:
                return f"$.divmod_({self.all(node.args)})"
            case "sum", [_] if self.infer(node) == INT:
                return self._call_as(node, "total")
            case "getattr" | "setattr" | "type", _:
                if not self.trusted:
                    self.fail(node, f"{name}() of what is known only when it runs")
                return f"$.{name}({self.all(node.args)})"
            case "len", [value]:
                self.known(value)
                parts = self.parts(kinds[0])
                if parts is not None and kinds[0].name != "tuple":
                    return f"$.len({self.e(value)})"
                if self.bound(found, node.args, []) is None and not self.trusted:  # type: ignore[arg-type]
                    self.fail(node, f"the length of {kinds[0]}")
                text = self.e(value)
                return f"{text}.length"
            case (("str" | "repr"), [value]) if not node.keywords:
                return self.shown(self.e(value), kinds[0], node, name == "repr")
            case "str", [] if not node.keywords:
                return '""'
            case "bool", [value]:
                text = self.test(value)
                return (
                    text
                    if kinds[0] == BOOL
                    else f"!!{text}"
                    if text.startswith(("!", "(", "$"))
                    else f"!!({text})"
                )
            case (("min" | "max"), [_, _, *_]) if (
                not node.keywords and set(kinds) <= set(WHOLE) and not self._large(node.args)
            ):
                return f"Math.{name}({self.all(node.args)})"
            case (("min" | "max"), [_, _, *_]) if not node.keywords and not any(
                isinstance(each, ast.Starred) for each in node.args
            ):
                self._sorted(node, name, None)
                if not self.trusted:
                    for each in node.args:
                        self.known(each)
                if not self.checked and set(kinds) <= set(NUMBERS):
                    return f"Math.{name}({self.all(node.args)})"
                return f"$.{name}([{self.all(node.args)}])"
            case (("any" | "all"), [ast.GeneratorExp(value, generators)]):
                decides = name == "any"
                no = "" if decides else "!"
                return self._comprehended_as(
                    generators,
                    value,
                    "",
                    lambda text: f"if ({no}{text}) return {str(decides).lower()};",
                    f"return {str(not decides).lower()};",
                    test=True,
                    ordered=False,
                )
            case "next", [ast.GeneratorExp(value, generators), *rest] if all(
                isinstance(each, ast.Constant | ast.Name) for each in rest
            ):
                after = f"return {self.e(rest[0])};" if rest else "throw new $.StopIteration();"
                return self._comprehended_as(generators, value, "", lambda text: f"return {text};", after)
            case "chr", [value] if (code := whole(value)) is not None and (
                code > 0xFFFF or 0xD800 <= code < 0xE000
            ):
                self.fail(node, "a character beyond U+FFFF has another length in JavaScript")
            case "zip", _ if node.keywords:
                [strict] = node.keywords
                if not isinstance(strict.value, ast.Constant):
                    self.fail(node, "strict has to be True")
                plain = ast.copy_location(ast.Call(node.func, node.args, []), node)
                return self._call_as(plain, "zip_strict" if strict.value.value else "zip")
        return ""

    def _is_json(self, kind: Type) -> bool:
        """Whether JSON of it is the same in both languages."""
        if kind.name in ("|", "list", "tuple", "row"):
            return all(map(self._is_json, kind.of))
        if kind.name == "dict":
            return kind.of[0] in (STR, UNSEEN) and self._is_json(kind.of[1])
        return kind in (WORD, INT, BOOL, NONE, STR, UNSEEN)

    def _call_as(self, node: ast.Call, name: str) -> str:
        """Return the call of a function of Python's own by another of the runtime."""
        found = self.found(node.func)
        assert found is not None
        self.infer(node)
        return (
            self._library(node, found)
            .replace("$.", f"$.{name}(", 1)
            .replace(f"{name}({leaf(node.func)}(", f"{name}(", 1)
        )

    def _large(self, nodes: list[ast.expr]) -> bool:
        """Whether Math.min and Math.max may meet a number beyond 2^53."""
        return self.checked and any(
            self.infer(each) != WORD and abs(whole(each) or MOST) >= MOST for each in nodes
        )

    def _is_instance(self, node: ast.Call, value: ast.expr, of: ast.expr) -> str:
        kind = self.infer(value)
        classes = of.elts if isinstance(of, ast.Tuple) else [of]
        texts = []
        names = {each.name for each in either(kind)}
        for each in classes:
            name, found = leaf(each), self.found(each)
            if not isinstance(each, ast.Name | ast.Attribute) or (
                found is None and name not in _KINDS and name != "slice"
            ):
                self.fail(node, instead="a tuple of classes")
            ours = bool(found) and found.is_class and found.module.table == ""  # type: ignore[union-attr]
            if not ours and name not in _KINDS and not (found and found.is_class) and name != "slice":
                self.fail(node, f"isinstance of {name}")
            if ours and (found.is_enum or "Protocol" in map(leaf, found.node.bases)):  # type: ignore[union-attr]
                self.fail(node, f"isinstance of {name}")
            unsure = {
                "int": {"float", "real", "?"}, "float": {"int", "word", "real", "?"}, "bool": set[str](),
                "list": {"tuple", "row", "sequence", "iterable", "?"},
                "tuple": {"list", "sequence", "iterable", "?"},
            }.get(name, set())  # fmt: skip
            tuples = name in ("tuple", "list") and any(self.parts(Type(one)) is not None for one in names)
            if (names & unsure or tuples) and not self.trusted:
                self.fail(
                    node, f"isinstance({kind}, {name}) is not to be told in JavaScript", "an annotation"
                )
            texts.append(self.dotted(each, name) if ours else f"$.{'list' if name == 'tuple' else name}")
        return (
            f"$.isinstance({self.e(value)}, {texts[0] if len(texts) == 1 else '[' + ', '.join(texts) + ']'})"
        )

    def _arguments(self, node: ast.Call, found: Found | None, typed: bool = True) -> str:
        """Return the arguments of a call, those by keywords in the places of the parameters."""
        at_once = found and found.module.table and leaf(node.func) in _AT_ONCE
        values = [
            self._comprehension(each.generators, each.elt, leaf(node.func) not in _UNORDERED)
            if at_once and isinstance(each, ast.GeneratorExp)
            else self._argument(each)
            for each in node.args
        ]
        names: list[str] = []
        given = {each.arg: each.value for each in node.keywords}
        signature = self.program.signature(found)
        if (found and found.is_class and not found.module.table and signature and typed) or (
            found and isinstance(found.node, ast.FunctionDef) and not found.module.table and typed
        ):
            self._typed(node, found)
        starred = any(isinstance(each, ast.Starred) for each in node.args)
        if signature:
            names = [each.arg for each in (*signature.posonlyargs, *signature.args) if each.arg != "self"]
            if not found.module.table and signature.vararg:  # type: ignore[union-attr]
                values = [*values[: len(names)], f"[{', '.join(values[len(names) :])}]"]
                if starred and any(isinstance(each, ast.Starred) for each in node.args[: len(names)]):
                    self.fail(node, "an unpacked argument before others")
                missing = len(names) - (len(values) - 1)
                values[-1:-1] = ["undefined"] * max(0, missing)
                names.append("*")
            elif not signature.vararg and len(values) > len(names):
                self.fail(node, "too many arguments")
            elif node.keywords and starred:
                self.fail(node, "an unpacked argument before keywords")
            names += [each.arg for each in signature.kwonlyargs]
            if signature.kwarg:
                rest = [each for each in node.keywords if each.arg not in names]
                keys = [each.arg and ast.Constant(each.arg) for each in rest]
                given = {name: value for name, value in given.items() if name in names}
                names.append(signature.kwarg.arg)
                given[signature.kwarg.arg] = ast.Dict(keys, [each.value for each in rest])  # type: ignore[arg-type]
        elif starred and node.keywords:
            self.fail(node, "an unpacked argument before keywords")
        if given.keys() - set(names):
            self.fail(node, "keywords that are no parameters")
        order = [names.index(each) for each in given if each]
        if (
            order != sorted(order)
            and sum(any(isinstance(part, ast.Call) for part in ast.walk(each)) for each in given.values()) > 1
        ):
            self.fail(node, "keywords in another order than the parameters", "them in that order")
        last = max(order, default=-1)
        missing_names = names[len(values) : last + 1]
        return ", ".join(
            values + [self._argument(given[name]) if name in given else "undefined" for name in missing_names]
        )

    def _argument(self, node: ast.expr) -> str:
        """Return an argument: a class or a function of Python's own is given as a function."""
        found = self.found(node) if isinstance(node, ast.Name) else None
        ours = found and found.is_class and not found.module.table and not found.is_enum
        if ours and node in self.lambdas:
            return f"((...$a) => new {named(leaf(node))}(...$a))"
        return self.e(node)

    def _typed(self, node: ast.Call, found: Found) -> None:
        """Refuse arguments of other types than the parameters have."""
        if found.is_class:
            init = self.of_class(found.kind.name, "__init__")[1]
            if init is None:
                fields = self.fields_of(found)
                names = [name for name, _ in fields]
                if len(node.args) > len(names) and not any(
                    isinstance(each, ast.Starred) for each in node.args
                ):
                    self.fail(node, "too many arguments")
                for value, (_, wanted) in zip(node.args, fields, strict=False):
                    if isinstance(value, ast.Starred):
                        break
                    self.accept(value, wanted)
                for keyword in node.keywords:
                    if keyword.arg in names:
                        self.accept(keyword.value, dict(fields)[keyword.arg])
                return
            if init.module.table:
                return
            found = init
        method = (
            isinstance(node.func, ast.Attribute)
            and getattr(self.found(node.func.value), "node", 1) is not None
        )
        variants = [
            each
            for each in self.program.variants(found)
            if self.paired(each, node.args, node.keywords, method) is not None
        ]
        if not variants:
            if any(isinstance(each, ast.Starred) for each in node.args) or self.trusted:
                return
            of = found.node.args
            names = [each.arg for each in (*of.posonlyargs, *of.args, *of.kwonlyargs)]
            if not of.kwarg and any(each.arg not in names for each in node.keywords):
                self.fail(node, "keywords that are no parameters")
            self.fail(node, "too many arguments, or too few")
        if len(variants) > 1 or found is not variants[0]:
            return
        if isinstance(node.func, ast.Attribute) and self.found(node.func) is None:
            return
        for value, annotation in self.paired(variants[0], node.args, node.keywords, method) or []:
            inner = Types(self.program, variants[0].module, self.owner)
            wanted = inner.annotated(annotation)
            if annotation is not None:
                self.accept(value, wanted)


_INSTEAD = {
    ast.Await: "it without async",
    ast.Yield: "yield as a statement",
    ast.YieldFrom: "yield from as a statement",
    ast.Lambda: "a lambda without defaults and *",
}
