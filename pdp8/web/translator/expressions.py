"""Expressions: each as one JavaScript expression, in parentheses where it is more than a name or a call.

Where both types are known JavaScript's own operators do it; else the runtime, `$`, looks at what comes.
What would be another thing in JavaScript is refused, with what to write instead.

A module that is not `checked` trusts its types, as its compiled form does: its numbers stay below 2^53, its
indexes are within their arrays.
"""

import ast
import json
import re
from collections.abc import Callable, Iterable
from typing import NoReturn

from pdp8.web.translator.inference import Types, rebound
from pdp8.web.translator.operators import OPERATORS, Operand, Operator, is_direct
from pdp8.web.translator.program import Found, Untranslated
from pdp8.web.translator.types import (
    ANY,
    BOOL,
    BYTES,
    FLOAT,
    FLOATS,
    INT,
    MUTABLE,
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

_ORDER = {ast.Lt: ("lt", "<"), ast.LtE: ("le", "<="), ast.Gt: ("gt", ">"), ast.GtE: ("ge", ">=")}
_WORDS = (
    "arguments await case catch const debugger default delete do enum eval export extends false function "
    "implements instanceof interface let new null package private protected public static super switch this "
    "throw true typeof undefined var void Math Number NaN Infinity Symbol Object"
)
_RESERVED = frozenset(_WORDS.split())
RENAMED = {"split": "split_", "replace": "replace_", "pop": "pop_"}
"""Methods that Python's and JavaScript's own types both have, and mean otherwise."""
_WIDTH, _PLACES = r"(?:[1-9]\d*|\{\})?", r"(?:\.(?:\d+|\{\}))?"
_FORMATS = {
    "text": _WIDTH,
    "whole": rf"\+?(?:{_WIDTH},|0?{_WIDTH}(?:[ox]|{_PLACES}[fg])?)",
    "float": rf"\+?(?:{_WIDTH},(?:{_PLACES}f)?|0?{_WIDTH}(?:{_PLACES}[fg])?)",
    "any number": rf"\+?0?{_WIDTH}{_PLACES}[fg]",
}
"""The formats that the runtime has; {} is a value that is put into the format."""
MOST = 1 << 53
"""From here on not every whole number is a float."""
_LISTS = ("list", "tuple", "row", "sequence", "str", "bytes", "bytearray")
_SCALARS = (*NUMBERS, STR, BOOL, NONE)
_TABLES = ("list", "row", "bytes", "bytearray", "words", "dict", "set")
_THERE = ast.Name | ast.Attribute | ast.Subscript
_IDENTICAL = ("list", "dict", "set", "bool", "None")


def named(name: str) -> str:
    """Return a name as JavaScript may have it."""
    return name + "$" if name in _RESERVED else name


def member(name: str) -> str:
    """Return the name of an attribute or method as JavaScript may have it."""
    return RENAMED.get(name, name)


class Expressions(Types):
    """Writes the expressions of one module."""

    temporary: list[list[str]]
    checked: bool
    trusted: bool
    """Whether values of unknown type are looked at when the module runs."""

    def fail(self, node: ast.AST, why: str = "no translation", instead: str = "") -> NoReturn:
        """Raise Untranslated for a node."""
        line = getattr(node, "lineno", "?")
        source = " ".join(ast.unparse(node).split())[:80]
        write = f"; write {instead}" if instead else ""
        raise Untranslated(f"{self.module.path}:{line}: {why}: {source}{write}")

    def refuse(self, node: ast.AST, why: str, instead: str = "") -> None:
        """Raise Untranslated for a node, unless what comes is looked at when the module runs."""
        if not self.trusted:
            self.fail(node, why, instead)

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
            of = node.func if isinstance(node, ast.Call) else node
            if isinstance(of, ast.Attribute):
                self.attributed(of)
            self.fail(node, "its type is unknown", "an annotation")
        if NONE in either(kind) and kind != NONE:
            self.fail(node, "it may be None", "a test that it is not")
        return kind

    def accept(self, value: ast.AST, wanted: Type, kind: Type | None = None) -> None:
        """Refuse a value of another type than the annotation says: the translation relies on it."""
        if wanted != ANY:
            kind = kind or self.infer(value)
            if not self._may_be(kind, wanted, isinstance(value, _THERE)):
                copied = "a copy, or annotate a Sequence" if self._may_be(kind, wanted) else ""
                self.refuse(value, f"{kind} where {wanted} is annotated", copied)

    def _may_be(self, kind: Type, wanted: Type, there: bool = False) -> bool:
        """Whether a value may be where `wanted` is; if it is `there` already, what it takes is the same."""
        if kind.name == "|":
            return all(self._may_be(each, wanted, there) for each in kind.of)
        if wanted.name == "|":
            return any(self._may_be(kind, each, there) for each in wanted.of)
        if UNSEEN in (kind, wanted) or kind.name in ("never", "type"):
            return True
        if kind.name == wanted.name == "call":
            return self._may_be_called(kind, wanted)
        if wanted in self.program.protocols:
            return self._is_as(kind, wanted)
        if kind.name == "view" and wanted.name in ("set", "iterable"):
            return True
        if kind.name == wanted.name and len(kind.of) == len(wanted.of):
            same = there and kind.name in MUTABLE
            return all(
                self._may_be(one, other, there) and (not same or self._may_be(other, one, there))
                for one, other in zip(kind.of, wanted.of, strict=True)
            )
        return self.fits(kind, wanted)

    def _is_as(self, kind: Type, protocol: Type) -> bool:
        """Whether a class has what a protocol has."""
        of = self.ours(kind)
        if of and (kind, protocol) not in self.program.fitting:
            self.program.fitting[kind, protocol] = True  # while its methods are looked at
            bases = self.program.lineage(self.program.classes[protocol.name])
            names = {name for base in bases if base.ours for name in base.members}
            fitting = all(self.has(kind, name) and self.used_alike(kind, protocol, name) for name in names)
            self.program.fitting[kind, protocol] = fitting
        return of is not None and self.program.fitting[kind, protocol]

    def used_alike(self, kind: Type, other: Type, name: str) -> bool:
        """Whether a member of a class may be used as that of another one."""
        (names, one), (others, wanted) = (self._used(each, name) for each in (kind, other))
        return names[: len(others)] == others and self._may_be(one, wanted)

    def _used(self, of: Type, name: str) -> tuple[list[tuple[str, str]], Type]:
        """Return the parameters of a method, and the type of a member."""
        kind, method = self.of_class(of.name, name)
        if not method or method.is_property:
            return [], kind
        takes = [self.annotated(each.annotation, each.module) for each in method.parameters[1:]]
        return [(each.how, each.name) for each in method.parameters], Type("call", (kind, *takes))

    def _may_be_called(self, kind: Type, wanted: Type) -> bool:
        """Whether a function takes what `wanted` does, and returns what it does."""
        (returned, *takes), (result, *given) = kind.of, wanted.of
        if takes and given:
            fitting = (each == ANY or self._may_be(each, to) for each, to in zip(given, takes, strict=False))
            if len(takes) != len(given) or not all(fitting):
                return False
        return result in (NONE, ANY) or self._may_be(returned, result)

    def in_order(self, one: ast.expr, other: ast.expr) -> bool:
        """Whether it may be seen which of two expressions is evaluated first."""
        sides = [*ast.walk(one)], [*ast.walk(other)]
        both = sides, sides[::-1]
        return any(any(map(self._acts, a)) and any(map(self._changes, b)) for a, b in both)

    def _changes(self, node: ast.AST) -> bool:
        """Whether it reads what a call may change."""
        if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load):
            found = self.found(node)
            return node.attr in self.program.rebound or (found is not None and found.is_property)
        return self._acts(node) or (isinstance(node, ast.Subscript) and isinstance(node.ctx, ast.Load))

    def _acts(self, node: ast.AST) -> bool:
        """Whether it is a call that may change something."""
        if not isinstance(node, ast.Call):
            return False
        found = self.found(node.func)
        if found and found.is_class and found.fields is not None:
            return self.of_class(found.kind.name, "__post_init__")[1] is not None
        return found is None or found.ours or leaf(node.func) in ("next", "pop", "setdefault")

    # Truth.

    def test(self, node: ast.expr) -> str:
        """Return an expression whose truth in JavaScript is that of `node` in Python."""
        match node:
            case ast.BoolOp(operator, [first, *rest]):
                both = isinstance(operator, ast.And)
                text = self.test(first)
                with self.holding(first, both):
                    after = self.test(ast.BoolOp(operator, rest) if len(rest) > 1 else rest[0])
                return f"({text} {'&&' if both else '||'} {after})"
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
            exact = abs(number) < MOST or (abs(number) < 1 << 1000 and int(float(number)) == number)
            text = f"{number}" if exact else f"{number}n"
            return f"({text})" if number < 0 else text
        match node:
            case ast.Name():
                return self._name(node)
            case ast.Attribute():
                return self._attribute(node)
            case ast.Call():
                text, found = self.call(node), self.found(node.func)
                may_be_none = found and found.is_function and isinstance(found.node.returns, ast.BinOp)
                if self.infer(node) == NONE and not may_be_none:
                    self.refuse(node, "a call that returns nothing, as a value", "None")
                return text
            case ast.Constant(None):
                return "null"
            case ast.Constant(bytes(value)):
                return f"$.bytes([{', '.join(map(str, value))}])"
            case ast.Constant(str(value)) if re.search("[\ud800-\udfff\U00010000-\U0010ffff]", value):
                self.fail(node, "a character beyond U+FFFF has another length in JavaScript")
            case ast.Constant(bool() | str() | float() as value):
                return json.dumps(value)
            case ast.BinOp(left, operator, right):
                return self.binary(node, operator, self.operand(left), self.operand(right))
            case ast.UnaryOp(ast.Not()):
                return self.test(node)
            case ast.UnaryOp(operator, value):
                return self._unary(node, operator, value)
            case ast.BoolOp(operator, values):
                return self._choice(isinstance(operator, ast.And), values)
            case ast.IfExp():
                return self._either(node, self.e)
            case ast.Compare(left, operators, rights):
                return self._compared(node, left, operators, rights)
            case ast.NamedExpr(target, value):
                text = f"({self.e(target)} = {self.e(value)})"
                self.accept(value, self.scope.get(target.id, ANY))
                self.forget(*rebound(node))
                return text
            case ast.Subscript(value, index):
                return self._indexed(value, index)
            case ast.Tuple(items) | ast.List(items):
                return f"[{self.all(items)}]"
            case ast.Set(items):
                self.keyed(node, self._joined(items))
                return f"$.set([{', '.join(self._unordered(each) for each in items)}])"
            case ast.Dict(keys, values):
                self.keyed(node, self.infer(node).of[0])
                pairs = [*zip(keys, values, strict=True)]
                for unpacked in (v for k, v in pairs if k is None):
                    if self.known(unpacked).name != "dict":
                        self.refuse(unpacked, "unpacked into a dict", "a dict")
                each = (f"[{self.e(k)}, {self.e(v)}]" if k else f"...{self.e(v)}.items()" for k, v in pairs)
                return f"$.dict([{', '.join(each)}])"
            case ast.Starred(ast.GeneratorExp(value, generators)):
                return f"...{self.listed(generators, value)}"
            case ast.Starred(value):
                return f"...{self.iterated(value)}"
            case ast.Lambda(ast.arguments(defaults=[], vararg=None, kwarg=None, kwonlyargs=[]), body):
                names = self.taken(node)
                with self.naming(names):
                    return f"(({', '.join(map(named, names))}) => {self.done(body)})"
            case ast.JoinedStr(values):
                return f"`{''.join(map(self._piece, values))}`"
            case ast.ListComp(value, generators):
                return self.listed(generators, value)
            case ast.GeneratorExp(value, generators):
                first = self.iterated(generators[0].iter)  # it is there at once, all else when it is wanted
                loops = self.comprehended(generators, value, "yield {};", "$of")
                return f"(function* ($of) {{ {loops} }}).call(this, {first})"
            case ast.SetComp(value, generators):
                self.keyed(node, self.infer(node).of[0])
                return f"$.set({self.listed(generators, value, ordered=False)})"
            case ast.DictComp(key, ast.expr() as value, generators):
                self.keyed(node, self.infer(node).of[0])
                return f"$.dict({self.listed(generators, ast.Tuple([key, value]))})"
        self.fail(node, instead=_INSTEAD.get(type(node), ""))

    def done(self, node: ast.expr) -> str:
        """Return an expression whose value may be unused."""
        if isinstance(node, ast.IfExp):
            return self._either(node, self.done)
        return self.call(node) if isinstance(node, ast.Call) else self.e(node)

    def _either(self, node: ast.IfExp, write: Callable[[ast.expr], str]) -> str:
        text = self.test(node.test)
        with self.holding(node.test, True):
            first = write(node.body)
        with self.holding(node.test, False):
            return f"({text} ? {first} : {write(node.orelse)})"

    def call(self, node: ast.Call) -> str:
        """Return a call."""
        raise NotImplementedError

    def all(self, nodes: list[ast.expr]) -> str:
        """Return expressions, one after another."""
        return ", ".join(map(self.e, nodes))

    # Keys, iterations.

    def keyed(self, node: ast.AST, kind: Type) -> None:
        """Refuse keys that JavaScript compares unlike Python: all but numbers, texts, None and objects."""
        kinds = either(kind)
        mixed = BOOL in kinds and any(each in NUMBERS for each in kinds)
        for each in kinds:
            of = self.ours(each)
            instance = of is not None and (of.is_enum or of.fields is None)
            if not (each in (*_SCALARS, UNSEEN) or instance) or mixed:
                self.refuse(node, f"{kind} as a key", "a text or a number")

    def key(self, node: ast.AST, kind: Type, of: Type) -> None:
        """Refuse a key that JavaScript compares with the keys of the Dict or set `of` unlike Python."""
        if UNSEEN not in of.of and (BOOL in either(kind)) != (BOOL in either(of.of[0])):
            self.fail(node, f"{kind} as a key of {of}")
        self.keyed(node, kind)

    def iterated(self, node: ast.expr, ordered: bool = True) -> str:
        """Return what is iterated over; refuse what has another order in JavaScript, or none."""
        for each in either(self.infer(node)):
            if each.name == "set":
                if ordered:
                    self.refuse(node, "a set has another order in JavaScript", "sorted(...)")
            elif each == ANY or not self.fits(each, Type("iterable", (ANY,))):
                self.refuse(node, f"iteration over {each}", "an annotation")
        return self.e(node)

    def _unordered(self, node: ast.expr) -> str:
        """Return an item of a set: what is unpacked into it may be a set."""
        return f"...{self.iterated(node.value, False)}" if isinstance(node, ast.Starred) else self.e(node)

    # Operators.

    def _unary(self, node: ast.expr, operator: ast.unaryop, value: ast.expr) -> str:
        kind, text = self.known(value), self.e(value)
        inverted = isinstance(operator, ast.Invert)
        if inverted and kind in (*FLOATS, BOOL):  # of a truth, Python 3.16 has it no more
            self.fail(node, f"the operator on {kind}")
        if kind not in (*NUMBERS, BOOL):
            self.refuse(node, f"the operator on {kind}")
        if isinstance(operator, ast.UAdd):
            return f"$.plus({text}, 0)" if kind == BOOL and self.checked else text
        if not self.checked or kind in FLOATS:
            return f"(-{text} - 1)" if inverted else f"(-{text})"
        if kind == WORD:
            return f"(-1 - {text})" if inverted else f"(0 - {text})"
        return f"$.{'invert' if inverted else 'neg'}({text})"

    def operand(self, node: ast.expr) -> Operand:
        """Return an operand: it is not None; what may be a truth or a whole number is an INT."""
        text, kind = self.e(node), self.plain(self.infer(node))
        if NONE in either(kind):
            self.refuse(node, "it may be None", "a test that it is not")
        if kind.name == "|" and all(each in (*NUMBERS, BOOL) for each in kind.of):
            kind = join(*(INT if each == BOOL else each for each in kind.of))
        return Operand(text, without_none(kind), whole(node))

    def binary(self, node: ast.AST, operator: ast.operator, left: Operand, right: Operand) -> str:
        """Return `left operator right`."""
        if type(operator) not in OPERATORS:
            self.fail(node, "no such operator")
        made, kinds = OPERATORS[type(operator)], {left.kind, right.kind}
        if kinds <= {*NUMBERS, BOOL}:
            checked = self.checked or BOOL in kinds
            if checked and kinds & {*FLOATS}:
                return self._of_floats(node, made, left, right)
            if checked and isinstance(operator, ast.Pow) and right.kind != WORD and right.number is None:
                why = "a power whose exponent may be negative is an int or a float"
                self.fail(node, why, "a float, or x ** 2")
            if is_direct(operator, left, right, checked):
                return made.direct.format(left.text, right.text)
            return f"$.{made.exact if checked else made.runtime}({left.text}, {right.text})"
        if kinds == {STR} and isinstance(operator, ast.Add):
            return made.direct.format(left.text, right.text)
        if not self._operable(operator, left.kind, right.kind):
            why = f"{left.kind} and {right.kind} with this operator"
            self.refuse(node, why, "it another way, or an annotation")
        for each in (left.kind, right.kind):
            if each.name == "view":
                self.keyed(node, self.item(each))
        return f"$.{made.runtime}({left.text}, {right.text})"

    def _of_floats(self, node: ast.AST, made: Operator, left: Operand, right: Operand) -> str:
        """Return an operation on a float and another number, which becomes one if it may be a BigInt."""
        if made.exact in ("plus", "minus", "times"):
            return made.direct.format(*map(self._as_float, (left, right)))
        if not made.floats:
            self.fail(node, "an operator of whole numbers on a float")
        if made.exact == "power" and right.kind not in WHOLE:
            self.refuse(node, "a power that may be a complex number", "math.pow(...)")
        if made.exact == "div" and right.number:
            return made.direct.format(left.text, self._as_float(right))
        return f"$.{made.floats}({left.text}, {right.text})"

    @staticmethod
    def _as_float(of: Operand) -> str:
        return f"Number({of.text})" if of.kind in (INT, BOOL) else of.text

    def _operable(self, operator: ast.operator, one: Type, other: Type) -> bool:
        """Whether the runtime does the operator on these types as Python does."""
        of_numbers = isinstance(operator, ast.Add | ast.Sub | ast.Mult | ast.Div | ast.Pow)
        if ANY in (one, other):
            return of_numbers
        if "|" in (one.name, other.name):
            return all(
                self._operable(operator, a, b) or {a, b} <= {*NUMBERS, BOOL}
                for a in either(one)
                for b in either(other)
            )
        names = {one.name, other.name}
        match operator:
            case ast.Add() if names <= {"tuple", "row"}:
                return True
            case ast.Add() if one.name == other.name in ("list", "bytes", "bytearray", "str"):
                return True
            case ast.Mult() if {one, other} & {*WHOLE, BOOL}:
                return bool(names & {"str", "list", "tuple", "row", "bytes"})
            case ast.BitOr() if names == {"dict"}:
                return True
            case ast.BitOr() | ast.BitAnd() | ast.Sub() if names <= {"set", "view"}:
                return True
            case ast.Pow() if one.name == "Fraction":
                return other == WORD
        return of_numbers and one.name == "Fraction" and (other in WHOLE or other.name == "Fraction")

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

    # Comparisons.

    def _compared(
        self, node: ast.expr, left: ast.expr, operators: list[ast.cmpop], rights: list[ast.expr]
    ) -> str:
        parts, a = [], self.e(left)
        for operator, right in zip(operators, rights, strict=True):
            b = again = self.e(right)
            if right is not rights[-1]:
                again = self.temp()
                b = f"({again} = {b})"
            parts.append(self._comparison(node, operator, (a, left), (b, right)))
            a, left = again, right
        return parts[0] if len(parts) == 1 else f"({' && '.join(parts)})"

    def _comparison(
        self, node: ast.expr, operator: ast.cmpop, left: tuple[str, ast.expr], right: tuple[str, ast.expr]
    ) -> str:
        (a, one), (b, other) = left, right
        kinds = self.infer(one), self.infer(other)
        values = tuple(map(self.plain, kinds))
        numbers = all(each in (*NUMBERS, BOOL) for each in values)
        no = "!" if isinstance(operator, ast.IsNot | ast.NotEq | ast.NotIn) else ""
        match operator:
            case ast.Is() | ast.IsNot():
                loose = isinstance(other, ast.Constant) and other.value is None
                if not loose and not all(map(self._has_identity, kinds)):
                    self.refuse(node, "the identity of what has none in JavaScript", "==")
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
                before = ""
                if self.in_order(one, other):
                    a, before = (once := self.temp()), f"{once} = {a}, "
                text = no + self._contained(node, (a, kinds[0]), (b, kinds[1]))
                return f"({before}{text})" if before else text
        name, sign = _ORDER[type(operator)]
        if numbers or values == (STR, STR):
            return f"({a} {sign} {b})"
        self.orderable(node, *kinds)
        return f"$.{name}({a}, {b})"

    def _has_identity(self, kind: Type) -> bool:
        """Whether `is` means in JavaScript what it means in Python."""
        return all(each.name in _IDENTICAL or self.ours(each) is not None for each in either(kind))

    def comparable(self, node: ast.AST, one: Type, other: Type) -> None:
        """Refuse a comparison that JavaScript does otherwise: a list with a tuple, or what is unknown."""
        if not self._equatable(one, other):
            self.refuse(node, f"{one} compared with {other}", "both as lists, or an annotation")

    def _equatable(self, one: Type, other: Type) -> bool:
        if "|" in (one.name, other.name):
            return all(self._equatable(a, b) for a in either(one) for b in either(other))
        if UNSEEN in (one, other) or self.plain(one) in _SCALARS or self.plain(other) in _SCALARS:
            return True
        names = {one.name, other.name}
        if names <= {"bytes", "bytearray"} or names in ({"words"}, {"Fraction"}):
            return True
        parts, others = self.parts(one), self.parts(other)
        if parts is not None and others is not None:
            return len(parts) != len(others) or all(map(self._equatable, parts, others))
        if all(each.name == "row" or self.parts(each) is not None for each in (one, other)):
            return self._equatable(self.item(one), self.item(other))
        if names in ({"list"}, {"set"}, {"dict"}):
            return all(map(self._equatable, one.of, other.of))
        ours = [each for each in (one, other) if self.ours(each)]
        if len(ours) == 1:  # an object and a list are never equal
            return not names.isdisjoint(_TABLES) and parts is None and others is None
        return len(ours) == 2 and (parts is None) == (others is None)

    def orderable(self, node: ast.AST, one: Type, other: Type) -> None:
        """Refuse to order what JavaScript orders unlike Python, or what is unknown."""
        if not self._ordered(one, other):
            self.refuse(node, f"the order of {one} and {other}", "a key, or an annotation")

    def _ordered(self, one: Type, other: Type) -> bool:
        if "|" in (one.name, other.name):
            return all(self._ordered(a, b) for a in either(one) for b in either(other))
        values = [self.plain(one), self.plain(other)]
        if values == [STR, STR] or UNSEEN in values:
            return True
        if one.name == "Fraction" or all(each in (*NUMBERS, BOOL, ANY) for each in values):
            return values != [ANY, ANY]
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
        for each in either(all_):
            if each.name in ("dict", "set"):
                self.key(node, kind, each)
            elif each.name in ("str", "bytes"):
                if kind == ANY or (each == STR and self.plain(kind) != STR):
                    self.refuse(node, f"{kind} in {each}")
            elif each == ANY or not self.fits(each, Type("collection", (ANY,))):
                self.refuse(node, f"something in {each}", "an annotation")
            else:
                self.comparable(node, kind, self.item(each))
        inner = self.item(all_)
        same = kind == inner or (not self.checked and inner in WHOLE)
        plain = kind in (STR, WORD, INT) and same and all_.name in _LISTS
        return f"{b}.includes({a})" if plain else f"$.has({b}, {a})"

    # Names, attributes, items.

    def _name(self, node: ast.Name) -> str:
        name = node.id
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
        if not found.ours:
            return self._as_value(node, found)
        if found.is_class and not found.is_enum:
            self.refuse(node, "a class as a value", "a function that makes one")
        self._by_place(node, found)
        return named(name)

    def _by_place(self, node: ast.expr, found: Found) -> None:
        """Refuse a function as a value that does not take all by place."""
        if found.is_function and any(each.how in ("*", "key", "**") for each in found.parameters):
            self.fail(node, "a function with * as a value", "a lambda")

    def _as_value(self, node: ast.expr, found: Found) -> str:
        """Return a built-in function or a class that is passed as an argument."""
        takes = self.lambdas.get(node)
        if takes is None and len(variants := self.program.variants(found)) == 1:
            takes = self._takes(variants[0])
        if not takes or any(each.of for each in takes):
            self.fail(node, "a function of Python's own as a value", "a lambda")
        with self.applied(node, takes) as call:
            return f"(({', '.join(map(leaf, call.args))}) => {self.e(call)})"

    def attributed(self, node: ast.Attribute) -> None:
        """Refuse an attribute that is not known."""
        of = self.found(node.value)
        if self.trusted or (of and of.is_module):
            return
        if of and of.is_class:
            if not any(node.attr in each.declared for each in self.program.lineage(of)):
                self.fail(node, f"{leaf(node.value)} has no {node.attr}")
            return
        own = of and not of.ours
        for each in either(Type(leaf(node.value)) if own else self.known(node.value)):
            if not self.has(each, node.attr):
                self.fail(node, f"{each} has no {node.attr}")

    def _attribute(self, node: ast.Attribute) -> str:
        self.attributed(node)
        of, found = self.found(node.value), self.found(node)
        if of and of.is_module:
            if found is None:
                self.fail(node, f"the table of what may be used has no {node.attr}")
            return self.dotted(node) if of.ours else self._as_value(node, found)
        if not found or found.is_property:
            return self.dotted(node)
        if of and of.is_class:
            self.fail(node, "a method of a class as a value", "a lambda")
        self._by_place(node, found)
        return f'$.bound({self.e(node.value)}, "{member(node.attr)}")'

    def dotted(self, node: ast.expr) -> str:
        """Return a name, or a member of what is before it."""
        if isinstance(node, ast.Name):
            return named(node.id)
        if not isinstance(node, ast.Attribute):
            return self.e(node)
        of = self.found(node.value)
        before = self.dotted(node.value) if of and of.is_class else self.before_the_dot(node.value)
        return f"{before}.{named(node.attr) if of and of.is_module else member(node.attr)}"

    def before_the_dot(self, node: ast.expr) -> str:
        """Return an expression with which a name begins: a number is in parentheses."""
        text = self.e(node)
        return f"({text})" if re.fullmatch(r"\d+n?", text) else text

    def _indexed(self, value: ast.expr, index: ast.expr) -> str:
        kind, text = self.known(value), self.e(value)
        if isinstance(index, ast.Slice):
            return self._sliced(value, index, kind, text)
        self.index(value, index, kind)
        at = self.e(index)
        if kind.name == "dict":
            return f"{text}.at({at})"
        number = whole(index)
        if kind.name == "tuple" and number is not None and 0 <= number < len(kind.of):
            return f"{text}[{number}]"
        if kind.name == "words" and not self.checked:
            return f"{text}[{at}]"
        twice = re.fullmatch(r"[\w.$]+", text + at)  # it may be written twice
        direct = twice and kind.name in (*_LISTS, "words")
        named_ = ', "tuple index"' if kind.name in ("tuple", "row") and self.checked else ""
        safe = f"$.at({text}, {at}{named_})"
        return f"({text}[{at}] ?? {safe})" if direct else safe

    def index(self, value: ast.expr, index: ast.expr, kind: Type) -> None:
        """Refuse an index that is neither a whole number nor a key."""
        by = self.infer(index)
        for each in either(kind):
            if each.name == "dict":
                self.key(index, by, each)
            elif each.name in (*_LISTS, "words", "range") or self.parts(each) is not None:
                if self.plain(by) not in WHOLE:
                    self.refuse(index, f"{by} as an index", "an int")
            elif not self.of_class(each.name, "__getitem__")[1]:
                self.refuse(value, f"an item of {each}", "a list, or an annotation")

    def _sliced(self, value: ast.expr, index: ast.Slice, kind: Type, text: str) -> str:
        if index.step:
            self.fail(index, "a slice by steps", "a comprehension over range")
        if any(each.name not in (*_LISTS, "words") for each in either(kind)):
            self.refuse(value, f"a slice of {kind}")
        for each in filter(None, (index.lower, index.upper)):
            bound = self.infer(each)
            if without_none(bound) not in (*WHOLE, NONE):
                self.refuse(index, f"{bound} as a bound of a slice", "an int or None")
        lower = self._bound(index.lower) if index.lower else "0"
        end = f", {self._bound(index.upper)}" if index.upper else ""
        if index.upper and self.infer(index.upper) not in WHOLE:
            end += " ?? undefined"  # None is the end
        return f"{text}.slice({lower}{end})"

    def _bound(self, node: ast.expr) -> str:
        """Return a bound of a slice as a Number, because `slice` takes no BigInt."""
        text = self.e(node)
        large = self.checked and self.infer(node) == INT and abs(whole(node) or MOST) >= MOST
        return f"Number({text})" if large else text

    # Text.

    def shown(self, text: str, kind: Type, node: ast.AST, quoted: bool) -> str:
        """Return the str of what is written as `text`, or its repr, as a text in JavaScript."""
        name, kinds = "repr" if quoted else "str", {*either(kind)}
        simple = {INT, WORD, BOOL, NONE, STR}
        if self.trusted and not kinds <= {*simple, FLOAT}:
            return f"$.{name}({text})"
        if REAL in kinds:
            self.fail(node, "it may be an int or a float, which Python writes otherwise", "float(...)")
        if kind == STR and not quoted:
            return text
        if all(each in (*simple, BYTES) or (self._writes_itself(each) and not quoted) for each in kinds):
            return f"$.{name}({text})"
        if kind == FLOAT:
            return f"$.{name}($.floating({text}))"
        if kind.name == "set":
            self.fail(node, "a set has another order in JavaScript", "sorted(...)")
        of = self.ours(kind)
        if of and self._displays_its_fields(of):
            return f"$.displayed({text}, {self._each_shown([each for _, each in self.fields_of(of)], node)})"
        if kind.name not in ("list", "tuple", "row", "dict"):
            self.fail(node, f"{kind} as a text", "a test of what it is" if kind.name == "|" else "its parts")
        inner = self._each_shown(kind.of, node)
        return f"$.shown_{kind.name}({text}, {f'[{inner}]' if kind.name == 'tuple' else inner})"

    def _each_shown(self, kinds: Iterable[Type], node: ast.AST) -> str:
        """Return functions that return the repr of something of each of these types."""
        return ", ".join(f"(($v) => {self.shown('$v', kind, node, True)})" for kind in kinds)

    def _displays_its_fields(self, of: Found) -> bool:
        """Whether a class is a record without subclasses, whose text is that of all its fields."""
        if of.fields is None or of.node.name in self.program.inherited:
            return False
        own = any(self.of_class(of.kind.name, name)[1] for name in ("__str__", "__repr__"))
        return not own and not any("repr" in ast.unparse(each) for each in of.node.decorator_list)

    def _writes_itself(self, kind: Type) -> bool:
        """Whether it is a member of an enumeration, or has a method that returns its text."""
        return self.plain(kind) != kind or self.of_class(kind.name, "__str__")[1] is not None

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
        if not isinstance(value.format_spec, ast.JoinedStr) or not value.format_spec.values:
            return f"${{{text if kind == WORD else self.shown(text, kind, value, quoted)}}}"
        if quoted or value.conversion == ord("s"):
            text, kind = self.shown(text, kind, value, quoted), STR
        self._spec(value, kind, value.format_spec)
        if kind == FLOAT:
            text = f"$.floating({text})"
        return f"${{$.format({text}, {self.e(value.format_spec)})}}"

    def _spec(self, node: ast.FormattedValue, kind: Type, spec: ast.JoinedStr) -> None:
        """Refuse a format that the runtime does not have for this type."""
        written = "".join(str(each.value) if isinstance(each, ast.Constant) else "{}" for each in spec.values)
        inner = [each for each in spec.values if isinstance(each, ast.FormattedValue)]
        simple = all(self.infer(each.value) in WHOLE and each.format_spec is None for each in inner)
        plain = self.plain(kind)
        name = "text" if plain == STR else "whole" if plain in WHOLE else "float" if plain == FLOAT else ""
        if all(each in NUMBERS for each in either(plain)):
            name = name or "any number"
        if not simple or not name or not re.fullmatch(_FORMATS[name], written):
            self.refuse(node, f"no translation of the format {written!r} of {plain}")

    # Comprehensions.

    def listed(self, generators: list[ast.comprehension], value: ast.expr, ordered: bool = True) -> str:
        """Return a comprehension as a list."""
        loops = self.comprehended(generators, value, "$r.push({});", ordered=ordered)
        return f"(() => {{ const $r = []; {loops} return $r; }})()"

    def comprehended(
        self,
        generators: list[ast.comprehension],
        value: ast.expr,
        put: str,
        first: str = "",
        *,
        test: bool = False,
        ordered: bool = True,
    ) -> str:
        """Return the loops of a comprehension, and in them `put` with its value, or with the test of it.

        `first` is what a generator's first loop runs over. In a generator, and around a lambda, a variable is
        the same in all turns, as in Python.
        """
        if isinstance(value, ast.Starred):
            self.fail(value)
        loops, names = list[str](), list[str]()
        parts = (part for each in (value, *generators) for part in ast.walk(each))
        late = bool(first) or any(isinstance(each, ast.Lambda) for each in parts)
        for each in (value, *generators):
            self.forget(*rebound(each))
        with self.naming({}):
            for at, generator in enumerate(generators):
                sets = set().union(*(_names_in(each.target) for each in generators[at:]))
                if not first and sets & _names_in(generator.iter):
                    self.fail(generator.iter, "a comprehension over a name that it sets", "another name")
                source = first or self.iterated(generator.iter, ordered)
                first = ""
                names += map(named, self.entered(generator))
                loops.append(self.looped(generator.target, source, generator.iter, "" if late else "const "))
                for each in generator.ifs:
                    loops.append(f"if ({self.test(each)})")
                    self.held |= self.said(each, True)
            loops.append(put.replace("{}", self.test(value) if test else self.e(value)))
        return " ".join([f"let {', '.join(names)};", *loops] if late else loops)

    def looped(self, target: ast.expr, source: str, of: ast.expr, declare: str = "const ") -> str:
        """Return the head of a loop over what is written as `source`; "const " or "" before the target."""
        item = self.item(self.infer(of))
        if isinstance(target, ast.Tuple) and not self.fits_target(target, item):
            source = f"$.unpacked({source}, {self.counted(target, item)})"
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

    def counted(self, target: ast.Tuple, item: Type) -> str:
        """Return how many items are unpacked, and the place of the starred one, as arguments."""
        inner = [each for each in target.elts if isinstance(each, ast.Tuple)]
        if not all(self.fits_target(each, self.item(item)) for each in inner):
            self.fail(target, "targets within targets of unknown length")
        star = (at for at, each in enumerate(target.elts) if isinstance(each, ast.Starred))
        return ", ".join(map(str, [len(target.elts), *star]))


def _names_in(node: ast.expr) -> set[str]:
    return {each.id for each in ast.walk(node) if isinstance(each, ast.Name)}


_INSTEAD = {
    ast.Await: "it without async",
    ast.Yield: "yield as a statement",
    ast.YieldFrom: "yield from as a statement",
    ast.Lambda: "a lambda without defaults and *",
}
