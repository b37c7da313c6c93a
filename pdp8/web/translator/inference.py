"""The type of each expression of a module: from annotations, and from what is assigned.

Nothing is refused here: where nothing is known the type is ANY. What a test says of a name, `x is None`,
`isinstance(x, str)`, holds where the test does (`holding`).
"""

import ast
import re
from collections import ChainMap
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache

from pdp8.web.translator.program import Found, Module, Program
from pdp8.web.translator.types import (
    ANY,
    BOOL,
    BYTEARRAY,
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
    WORDS,
    Type,
    either,
    filled,
    item_of,
    join,
    leaf,
    made,
    whole,
    widened,
    without_none,
)

_PLAIN = {
    "int": INT, "float": REAL, "bool": BOOL, "str": STR, "bytes": BYTES, "bytearray": BYTEARRAY, "None": NONE,
    "array": WORDS, "MutableSequence": WORDS, "words": WORDS, "range": Type("range", (INT,)),
    "slice": Type("slice"), "Word": WORD, "Float": FLOAT, "NoReturn": Type("never"),
    "SupportsInt": Type("SupportsInt"), "Sized": Type("sized"),
    **{name: Type(f"~{name}") for name in "TUVK"},
}  # fmt: skip
_GENERIC = {
    "list": "list", "set": "set", "frozenset": "set", "Set": "set", "dict": "dict", "Mapping": "dict",
    "Sequence": "sequence", "Iterable": "iterable", "Collection": "collection", "Unordered": "unordered",
    "Iterator": "iterator", "Generator": "iterator", "View": "view", "range": "range", "Pattern": "Pattern",
}  # fmt: skip
_TABLE = {"word": "int", "real": "float", "row": "tuple"}
_SETTING = ast.Assign | ast.AnnAssign | ast.AugAssign | ast.NamedExpr | ast.For | ast.ExceptHandler | ast.Expr
_CLOSED = (
    ast.FunctionDef | ast.Lambda | ast.ClassDef | ast.Constant | ast.Name | ast.expr_context | ast.operator
)
_SEQUENCES = ("sequence", "list", "tuple", "row", "bytes", "bytearray", "words", "range", "str")
_ITERABLES = (*_SEQUENCES, "iterable", "iterator", "view", "dict")
DUNDERS: dict[type[ast.operator], str] = {
    ast.Add: "__add__",
    ast.Sub: "__sub__",
    ast.Mult: "__mul__",
    ast.Div: "__truediv__",
}
"""The methods of classes of ours that the runtime's operators call."""
_PLACED = ("list", "row", "sequence", "str", "bytes", "bytearray", "words", "range")


def arithmetic(operator: ast.operator, left: Type, right: Type) -> Type:
    """Return the type of `left operator right`."""
    left, right = (
        (INT if each == BOOL else each for each in (left, right)) if left != right else (left, right)
    )
    if isinstance(operator, ast.BitAnd) and WORD in (left, right):
        return WORD
    if left in NUMBERS and right in NUMBERS:
        if isinstance(operator, ast.Div) or FLOAT in (left, right):
            return FLOAT
        if isinstance(operator, ast.Pow):
            fits = right == WORD or left == right == REAL
            return ANY if not fits else REAL if REAL in (left, right) else INT
        if REAL in (left, right):
            return REAL
        same = left == right == WORD and isinstance(operator, ast.BitOr | ast.BitXor | ast.Mod | ast.FloorDiv)
        return WORD if same or (left == WORD and isinstance(operator, ast.RShift)) else INT
    if left == right == BOOL:
        return BOOL if isinstance(operator, ast.BitAnd | ast.BitOr | ast.BitXor) else INT
    if isinstance(operator, ast.Mult) and INT in map(widened, (left, right)):
        of = right if left in WHOLE else left
        if of.name == "tuple":
            return Type("row", (item_of(of),))
        return of if of.name in ("str", "bytes", "list", "row", "bytearray") else ANY
    if isinstance(operator, ast.Add) and left.name == right.name == "tuple":
        return Type("tuple", left.of + right.of)
    if isinstance(operator, ast.Add) and {left.name, right.name} <= {"tuple", "row"}:
        return Type("row", (join(item_of(left), item_of(right)),))
    if left.name == "Fraction" or right.name == "Fraction":
        return FLOAT if left in FLOATS else left if left.name == "Fraction" else ANY
    joined = join(left, right)
    return joined if joined.name == left.name == right.name else ANY


class Types:
    """The types of expressions in one module."""

    def __init__(self, program: Program, module: Module, owner: str = "") -> None:
        self.program = program
        self.module = module
        self.owner = owner
        """The class whose body this is, as `module.Class`."""
        self.scope = ChainMap[str, Type]()
        """The names of the functions around, and their types."""
        self.held: dict[str, Type] = {}
        """What tests have said of expressions: {source: type}."""
        self.lambdas: dict[ast.AST, list[Type]] = {}
        """The types of the parameters of functions that are given to others."""

    # Annotations.

    def annotated(self, node: ast.AST | None, module: Module | None = None) -> Type:
        """Return the type that an annotation names."""
        if node is None:
            return ANY
        module = module or self.module
        key = (node, module.name, self.owner)
        if key not in self.program.annotations:
            self.program.annotations[key] = self._annotated(node, module)
        return self.program.annotations[key]

    def _annotated(self, node: ast.AST, module: Module) -> Type:
        name = leaf(node)
        match node:
            case ast.Constant(str(text)):
                return self.annotated(ast.parse(text, mode="eval").body, module)
            case ast.Constant(None):
                return NONE
            case ast.BinOp(left, ast.BitOr(), right):
                return join(self.annotated(left, module), self.annotated(right, module))
            case ast.Subscript(_, inner):
                items = inner.elts if isinstance(inner, ast.Tuple) else [inner]
                return self._generic(name, items, module)
            case ast.Name() | ast.Attribute():
                of = self.program.find(module, leaf(node.value)) if isinstance(node, ast.Attribute) else None
                found = self.program.find(of.module if of and of.node is None else module, name)
                if found and found.is_class and not found.module.table:
                    return found.kind
                if found and isinstance(found.node, ast.expr):
                    return self.annotated(found.node, found.module)
                if name in _PLAIN:
                    return _PLAIN[name]
                if name == "Self":
                    return Type(self.owner)
                return Type(name) if name in self.program.classes else ANY
        return ANY

    def _generic(self, name: str, items: list[ast.expr], module: Module) -> Type:
        if name in ("Annotated", "Final", "ClassVar"):
            return self.annotated(items[0], module)
        if name == "Literal":
            return join(*(_PLAIN.get(type(getattr(each, "value", None)).__name__, ANY) for each in items))
        if name == "Callable":
            taken, returned = items
            takes = (
                [self.annotated(each, module) for each in taken.elts] if isinstance(taken, ast.List) else []
            )
            return Type("call", (self.annotated(returned, module), *takes))
        kinds = [
            self.annotated(each, module) for each in items if getattr(each, "value", None) is not Ellipsis
        ]
        if name == "tuple":
            return Type("row" if len(kinds) < len(items) else "tuple", tuple(kinds))
        if name in ("array", "MutableSequence"):
            return WORDS
        return made(_GENERIC[name], *kinds[: 1 + (_GENERIC[name] == "dict")]) if name in _GENERIC else ANY

    # Classes and what they have.

    def of_class(self, name: str, attribute: str) -> tuple[Type, Found | None]:
        """Return the type of an attribute of a class, or what its method returns, and the method."""
        key = (name, attribute)
        if key not in self.program.attributes:
            self.program.attributes[key] = ANY, None
            of = self.program.classes.get(_TABLE.get(name, name))
            if of:
                self.program.attributes[key] = self._of_class(of, attribute)
        return self.program.attributes[key]

    def _of_class(self, of: Found, attribute: str) -> tuple[Type, Found | None]:
        for each in self.program.lineage(of):
            inner = Types(self.program, each.module, each.kind.name)
            for member in each.node.body:
                if isinstance(member, ast.FunctionDef) and member.name == attribute:
                    return inner.annotated(member.returns), each._replace(node=member)
                if isinstance(member, ast.AnnAssign) and leaf(member.target) == attribute:
                    return inner.annotated(member.annotation), None
            kinds: list[Type] = []
            for method in each.node.body:
                if kinds and kinds[0] != ANY and UNSEEN not in kinds[0].of:
                    break
                if isinstance(method, ast.FunctionDef) and attribute in _set_in(method):
                    inner.scope = ChainMap(inner.parameters(method))
                    inner.learn(method.body)
                    sets = (pair for node in own(method.body) for pair in inner._set_by(node))
                    found = [kind for target, kind in sets if getattr(target, "attr", "") == attribute]
                    kinds += [kind for kind in found if kind != ANY]  # x += 1 needs what it is itself
            if kinds:
                return widened(join(*kinds) if UNSEEN in kinds[0].of else kinds[0]), None
            for member in each.node.body:
                if isinstance(member, ast.Assign) and attribute in map(leaf, member.targets):
                    return (each.kind if each.is_enum else widened(inner.infer(member.value))), None
        return ANY, None

    def has(self, kind: Type, name: str) -> bool:
        """Whether something of `kind` has an attribute or method `name`."""
        key = (kind.name, name)
        if key not in self.program.present:
            self.program.present[key] = self._has(kind, name)
        return self.program.present[key]

    def _has(self, kind: Type, name: str) -> bool:
        of = self.program.classes.get(
            {"word": "int", "real": "float", "row": "tuple"}.get(kind.name, kind.name)
        )
        if of is None:
            return False
        if self._enumerated(kind):
            return False
        for each in self.program.lineage(of):
            for node in each.node.body:
                if isinstance(node, ast.FunctionDef) and (node.name == name or name in _set_in(node)):
                    return True
                targets = [node.target] if isinstance(node, ast.AnnAssign) else getattr(node, "targets", [])
                if name in map(leaf, targets):
                    return True
        return False

    def parameters(self, function: ast.FunctionDef) -> dict[str, Type]:
        """Return the types of a function's parameters."""
        args = function.args
        types = {
            each.arg: self.annotated(each.annotation)
            for each in (*args.posonlyargs, *args.args, *args.kwonlyargs)
        }
        if args.vararg:
            types[args.vararg.arg] = Type("row", (self.annotated(args.vararg.annotation),))
        if args.kwarg:
            types[args.kwarg.arg] = made("dict", STR, self.annotated(args.kwarg.annotation))
        return types | {"self": Type(self.owner)} if "self" in types and self.owner else types

    def learn(self, body: list[ast.stmt]) -> None:
        """Find the types of the names that a function's statements set."""
        scope, given = self.scope.maps[0], set(self.scope.maps[0])
        setting = [node for node in own(body) if isinstance(node, _SETTING)]
        for node in setting:
            if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
                scope[node.target.id] = self.annotated(node.annotation)
                given.add(node.target.id)
        before = None
        while before != scope:
            before = dict(scope)
            for target, kind in (pair for node in setting for pair in self._set_by(node)):
                if (
                    isinstance(target, ast.Name)
                    and target.id not in given
                    and (target.id in scope or kind != UNSEEN)
                ):
                    scope[target.id] = join(scope.get(target.id, UNSEEN), kind)
                elif isinstance(target, ast.Name):
                    scope.setdefault(target.id, UNSEEN)

    def _set_by(self, node: ast.AST) -> list[tuple[ast.AST, Type]]:
        """Return the targets that a node sets, and to what."""
        match node:
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if len(targets) == len(values):
                pairs = zip(targets, values, strict=True)
                return [pair for target, value in pairs for pair in self._put(target, self.infer(value))]
            case ast.Assign(targets, value):
                return [pair for target in targets for pair in self._put(target, self.infer(value))]
            case ast.AnnAssign(target, annotation):
                return [(target, self.annotated(annotation))]
            case ast.AugAssign(target, operator, value):
                kind = self.infer(target)
                if without_none(kind).name not in ("list", "bytearray", "set", "dict"):
                    kind = self.infer(ast.BinOp(target, operator, value))
                return [(target, kind)] if isinstance(target, ast.Name | ast.Attribute) else []
            case ast.NamedExpr(target, value):
                return [(target, self.infer(value))]
            case ast.For(target, iterable) | ast.comprehension(target, iterable):
                return self._apart(target, self.item(self.infer(iterable)))
            case ast.ExceptHandler(kind, str(name)):
                kinds = kind.elts if isinstance(kind, ast.Tuple) else [kind]
                return [(ast.Name(name), join(*(self._error(each) for each in kinds)))]
            case ast.Expr(ast.Call(ast.Attribute(ast.Name() as of, "append" | "add" as method), [value])):
                if item_of(self.infer(of)) == UNSEEN:
                    return [(of, made("list" if method == "append" else "set", self.infer(value)))]
        return []

    def _put(self, target: ast.AST, kind: Type) -> list[tuple[ast.AST, Type]]:
        if isinstance(target, ast.Subscript) and isinstance(target.value, ast.Name):
            of = self.infer(target.value)
            if of.name == "dict" and UNSEEN in of.of:
                return [(target.value, made("dict", self.infer(target.slice), kind))]
        return self._apart(target, kind)

    def _error(self, node: ast.expr | None) -> Type:
        found = node and self.found(node)
        return found.kind if found and found.is_class else ANY

    def _apart(self, target: ast.AST, kind: Type) -> list[tuple[ast.AST, Type]]:
        """Return each name of a target with its type."""
        if not isinstance(target, ast.Tuple):
            return [(target, kind)]
        kind = without_none(kind)
        parts = self.parts(kind)
        fit = parts is not None and len(parts) == len(target.elts)
        found: list[tuple[ast.AST, Type]] = []
        for at, each in enumerate(target.elts):
            if isinstance(each, ast.Starred):
                found.append((each.value, made("list", self.item(kind))))
            else:
                fitting = (
                    parts is not None and fit and not any(isinstance(e, ast.Starred) for e in target.elts)
                )
                found += self._apart(each, parts[at] if fitting and parts else self.item(kind))
        return found

    def parts(self, kind: Type) -> tuple[Type, ...] | None:
        """Return the types of the items of a tuple of known length, or of the fields of a named one."""
        if kind.name == "tuple":
            return kind.of
        of = self.program.classes.get(kind.name)
        return tuple(each for _, each in self.fields_of(of)) if of and of.is_tuple else None

    def fields_of(self, of: Found) -> list[tuple[str, Type]]:
        """Return the fields of a record, those of its base classes first."""
        found: dict[str, Type] = {}
        for each in reversed([*self.program.lineage(of)]):
            inner = Types(self.program, each.module, each.kind.name)
            for field in each.fields or []:
                found[leaf(field.target)] = inner.annotated(field.annotation)
        return [*found.items()]

    def item(self, kind: Type) -> Type:
        """Return what an iteration yields."""
        if kind.name == "|":
            return join(*map(self.item, kind.of))
        of = self.program.classes.get(kind.name)
        if of is None or of.module.table:
            return STR if kind.name == "enum" else item_of(kind)
        if (parts := self.parts(kind)) is not None:
            return join(*parts)
        return item_of(self.of_class(kind.name, "__iter__")[0])

    # Names.

    def found(self, node: ast.AST) -> Found | None:
        """Return what a name or an attribute of a module or class is defined as."""
        if isinstance(node, ast.Name) and node.id not in self.scope:
            return self.program.find(self.module, node.id)
        if not isinstance(node, ast.Attribute):
            return None
        of = self.found(node.value)
        if of and of.node is None:
            return self.program.find(of.module, node.attr)
        if isinstance(node.value, ast.Call) and leaf(node.value.func) == "super":
            for each in [*self.program.lineage(self.program.classes[self.owner])][1:] if self.owner else []:
                if method := self.of_class(each.kind.name, node.attr)[1]:
                    return method
            return None
        kind = self._before_the_dot(node.value, of)
        methods = (self.of_class(each.name, node.attr)[1] for each in either(kind))
        return next(filter(None, methods), None)

    def _before_the_dot(self, node: ast.expr, of: Found | None) -> Type:
        if of and of.is_class:
            return of.kind
        if of and of.module.table and leaf(node) in self.program.classes:
            return Type(leaf(node))  # dict.fromkeys
        return without_none(self.infer(node))

    def constant(self, node: ast.expr) -> ast.AST:
        """Return the value of a constant's name."""
        found = self.found(node)
        return found.node if found and isinstance(found.node, ast.expr) else node

    def infer(self, node: ast.AST) -> Type:
        """Return the type of an expression."""
        if isinstance(node, ast.Constant):
            return _of_constant(node.value)
        if self.held and isinstance(node, ast.Name | ast.Attribute | ast.Subscript):
            kind = self.held.get(ast.unparse(node))
            if kind is not None:
                return kind
        match node:
            case ast.Name(name) if name in self.scope:
                return self.scope[name]
            case ast.Name() | ast.Attribute():
                return self._named_type(node)
            case ast.Call():
                return self._called(node)
            case ast.Compare() | ast.UnaryOp(ast.Not()):
                return BOOL
            case ast.BinOp() | ast.UnaryOp() if (number := whole(node)) is not None:
                return WORD if 0 <= number < 1 << 31 else INT
            case ast.JoinedStr():
                return STR
            case ast.UnaryOp(_, value):
                kind = self.infer(value)
                return INT if kind in (WORD, BOOL) else kind
            case ast.BinOp(left, operator, right):
                one, other = without_none(self.infer(left)), without_none(self.infer(right))
                if isinstance(operator, ast.Pow) and (whole(right) or 0) < 0 and one in WHOLE:
                    return FLOAT
                return self._operated(operator, one, other)
            case ast.BoolOp(operator, values):
                return self._decided(isinstance(operator, ast.And), values)
            case ast.IfExp(test, one, other):
                with self.holding(test, True):
                    first = self.infer(one)
                with self.holding(test, False):
                    return join(first, self.infer(other))
            case ast.Subscript(value, index):
                return self._indexed_type(without_none(self.infer(value)), index)
            case ast.List(items):
                return made("list", self._joined(items))
            case ast.Tuple(items):
                if any(isinstance(each, ast.Starred) for each in items):
                    return Type("row", (self._joined(items),))
                return Type("tuple", tuple(map(self.infer, items)))
            case ast.Set(items):
                return made("set", self._joined(items))
            case ast.Dict(keys, values):
                kinds = [self.infer(v) for k, v in zip(keys, values, strict=True) if k is None]
                inner = [each.of for each in kinds if each.name == "dict"]
                pairs = [(self.infer(k), self.infer(v)) for k, v in zip(keys, values, strict=True) if k]
                return made("dict", *(join(*(pair[at] for pair in (*pairs, *inner))) for at in (0, 1)))
            case ast.Starred(value):
                return self.item(self.infer(value))
            case ast.NamedExpr(_, value):
                return self.infer(value)
            case ast.Lambda(_, body):
                return Type("call", (self._in_lambda(node, body),))
            case ast.ListComp() | ast.GeneratorExp() | ast.SetComp() | ast.DictComp():
                return self._comprehended(node)
        return ANY

    def _operated(self, operator: ast.operator, one: Type, other: Type) -> Type:
        of = self.program.classes.get(one.name)
        if of and not of.module.table and (name := DUNDERS.get(type(operator))):
            return self.of_class(one.name, name)[0]
        if one.name == "dict" and other.name == "dict":
            return made("dict", *map(join, one.of, other.of))
        if one.name == "view" and other.name in ("set", "view"):
            return made("set", *one.of)
        return join(*(arithmetic(operator, a, b) for a in either(one) for b in either(other)))

    def _decided(self, both: bool, values: list[ast.expr]) -> Type:
        """Return the type of `and` or `or`."""
        first, *rest = values
        kind = self.infer(first)
        if not rest:
            return kind
        with self.holding(first, both):
            other = self._decided(both, rest)
        if not both:
            return join(without_none(kind), other)
        if without_none(kind) != kind and self._always_true(without_none(kind)):
            kind = NONE
        return join(kind, other)

    def _always_true(self, kind: Type) -> bool:
        """Whether all of `kind` is true: an instance of a class of ours that has no length."""
        of = self.program.classes.get(kind.name)
        if not of or of.module.table or of.is_enum:
            return False
        return not self.of_class(kind.name, "__len__")[1] and not self.of_class(kind.name, "__bool__")[1]

    def _indexed_type(self, kind: Type, index: ast.expr) -> Type:
        if kind.name == "|":
            return join(*(self._indexed_type(each, index) for each in kind.of))
        of = self.program.classes.get(kind.name)
        if of and not of.module.table and not of.is_tuple:
            method = self.of_class(kind.name, "__getitem__")[1]
            return self._returned(method, [index], kind) if method else ANY
        if isinstance(index, ast.Slice):
            if kind.name == "tuple":
                at = [whole(each) if each else None for each in (index.lower, index.upper)]
                if (index.lower and at[0] is None) or (index.upper and at[1] is None):
                    return Type("row", (item_of(kind),))
                return Type("tuple", kind.of[at[0] : at[1]])
            return kind if kind.name in _SEQUENCES else ANY
        if kind.name == "dict":
            return kind.of[1]
        parts, number = self.parts(kind), whole(index)
        if parts and number is not None and -len(parts) <= number < len(parts):
            return parts[number]
        return self.item(kind) if kind.name in _SEQUENCES or parts else ANY

    @contextmanager
    def comprehending(self, generators: list[ast.comprehension]) -> Iterator[None]:
        """Know the names of a comprehension, and what its tests say."""
        self.scope = self.scope.new_child()
        held = dict(self.held)
        try:
            for generator in generators:
                sets = self._set_by(generator)
                self.scope |= {leaf(target): kind for target, kind in sets}
                for target, _ in sets:
                    self.forget(leaf(target))
                for test in generator.ifs:
                    self.held |= self.said(test, True)
            yield
        finally:
            self.scope, self.held = self.scope.parents, held

    def _comprehended(self, node: ast.ListComp | ast.GeneratorExp | ast.SetComp | ast.DictComp) -> Type:
        with self.comprehending(node.generators):
            if isinstance(node, ast.DictComp):
                return made("dict", self.infer(node.key), self.infer(node.value))
            kind = self.infer(node.elt)
        names = {ast.ListComp: "list", ast.SetComp: "set", ast.GeneratorExp: "iterator"}
        return made(names[type(node)], kind)

    def _in_lambda(self, node: ast.Lambda, body: ast.expr) -> Type:
        names = [each.arg for each in node.args.args]
        kinds = self.lambdas.get(node, [])
        self.scope = self.scope.new_child(
            {name: kinds[at] if at < len(kinds) else ANY for at, name in enumerate(names)}
        )
        kind = self.infer(body)
        self.scope = self.scope.parents
        return kind

    def _joined(self, nodes: list[ast.expr]) -> Type:
        return join(*map(self.infer, nodes))

    def _named_type(self, node: ast.Name | ast.Attribute) -> Type:
        """Return the type of a name of a module, or of an attribute."""
        found = self.found(node)
        if isinstance(node, ast.Attribute) and (found is None or isinstance(found.node, ast.FunctionDef)):
            return self._attribute_type(node, found)
        if not found:
            return ANY
        if isinstance(found.node, ast.AnnAssign):
            kind = self.annotated(found.node.annotation, found.module)
            return (
                kind
                if leaf(found.node.annotation) != "Final" or kind != ANY
                else self._constant(found, found.node.value)
            )
        if isinstance(found.node, ast.FunctionDef):
            takes = [self.annotated(each.annotation, found.module) for each in found.node.args.args]
            return Type("call", (self.annotated(found.node.returns, found.module), *takes))
        if isinstance(found.node, ast.expr):
            return self._constant(found, found.node)
        if found.is_class:
            return Type("list", (found.kind,)) if found.is_enum else Type("type", (found.kind,))
        return ANY

    def _constant(self, found: Found, node: ast.AST | None) -> Type:
        if node is None:
            return ANY
        if node not in self.program.constants:
            self.program.constants[node] = ANY
            self.program.constants[node] = Types(self.program, found.module).infer(node)
        return self.program.constants[node]

    def _attribute_type(self, node: ast.Attribute, found: Found | None) -> Type:
        of = self.found(node.value)
        if of and of.is_class:
            kinds: tuple[Type, ...] = (of.kind,)
        else:
            kinds = either(without_none(self.infer(node.value)))
        results = []
        for kind in kinds:
            result, method = self.of_class(kind.name, node.attr)
            if result == ANY and method is None and len(kinds) > 1 and not self.has(kind, node.attr):
                continue
            if method and not method.is_property:
                takes = [self.annotated(each.annotation, method.module) for each in method.node.args.args[1:]]
                result = Type("call", (result, *takes))
            results.append(result)
        return join(*results)

    # Calls.

    def _called(self, node: ast.Call) -> Type:
        """Return the type of what a call returns."""
        found, name = self.found(node.func), leaf(node.func)
        if found and found.is_class and (not found.module.table or not self.program.variants(found)):
            self._fields_given(node, found)
            return found.kind
        if found and isinstance(found.node, ast.FunctionDef | ast.ClassDef):
            receiver = (
                without_none(self.infer(node.func.value)) if isinstance(node.func, ast.Attribute) else None
            )
            if receiver and receiver.name == "|":
                methods = [(each, self.of_class(each.name, name)[1]) for each in receiver.of]
                return join(*(self._returned(of, node.args, one, node.keywords) for one, of in methods if of))
            return self._special(node, name, found) or self._returned(
                found, node.args, receiver, node.keywords
            )
        if name == "_replace" and isinstance(node.func, ast.Attribute):
            return self.infer(node.func.value)
        if name == "replace" and isinstance(node.func, ast.Name) and node.args:
            return self.infer(node.args[0])
        if name in ("isinstance", "hasattr", "callable") and isinstance(node.func, ast.Name):
            return BOOL
        if name == "getattr" and isinstance(node.func, ast.Name) and len(node.args) == 2:
            of, attribute = node.args
            if isinstance(attribute, ast.Constant):
                return self.infer(ast.Attribute(of, str(attribute.value), ast.Load()))
        kind = without_none(self.infer(node.func))
        return kind.of[0] if kind.name == "call" else ANY

    def _fields_given(self, node: ast.Call, found: Found) -> None:
        """Know the functions that are given to a new instance of a class."""
        init = self.of_class(found.kind.name, "__init__")[1]
        if init:
            pairs = self.paired(init, node.args, node.keywords, True) or []
            wanted = [(value, self.annotated(annotation, init.module)) for value, annotation in pairs]
        else:
            fields = self.fields_of(found)
            wanted = [(value, kind) for value, (_, kind) in zip(node.args, fields, strict=False)]
            wanted += [(each.value, dict(fields).get(each.arg or "", ANY)) for each in node.keywords]
        for value, kind in wanted:
            self.expect(value, kind)

    def expect(self, value: ast.expr, wanted: Type) -> None:
        """Know the functions in a value of which the type is known."""
        match value:
            case ast.Lambda():
                takes = [each for kind in either(wanted) if kind.name == "call" for each in kind.of[1:]]
                self.lambdas[value] = takes
            case ast.Dict(_, values) if wanted.name == "dict":
                for each in values:
                    self.expect(each, wanted.of[1])
            case ast.List(items) | ast.Tuple(items) if wanted.name in ("list", "row", "sequence"):
                for each in items:
                    self.expect(each, wanted.of[0])

    def _special(self, node: ast.Call, name: str, found: Found) -> Type | None:
        if not found.module.table:
            return None
        if name == "compile" and node.args and isinstance(node.args[0], ast.Constant):
            groups = re.compile(str(node.args[0].value)).groups
            return Type("Pattern", (STR if groups < 2 else Type("tuple", (STR,) * groups),))
        if name in ("min", "max") and len(node.args) > 1:
            return self._joined(node.args)
        return None

    def _returned(
        self,
        found: Found,
        args: list[ast.expr],
        receiver: Type | None = None,
        keywords: list[ast.keyword] | None = None,
    ) -> Type:
        """Return what a function of ours or of the table returns, of the first form that fits."""
        variants = self.program.variants(found)
        for variant in variants:
            bound = self.bound(variant, args, keywords or [], receiver)
            if bound is not None or variant is variants[-1]:
                inner = Types(self.program, variant.module, self._owner_of(variant, receiver))
                kind = filled(inner.annotated(variant.node.returns), bound or {})
                return (
                    WORD
                    if kind == INT and found.module.table and leaf(variant.node.returns) == "Word"
                    else kind
                )
        return ANY

    @staticmethod
    def _owner_of(found: Found, receiver: Type | None) -> str:
        return receiver.name if receiver and not found.module.table else ""

    def bound(
        self, found: Found, args: list[ast.expr], keywords: list[ast.keyword], receiver: Type | None = None
    ) -> dict[str, Type] | None:
        """Return the types of a function's type variables in a call; None if the arguments do not fit."""
        pairs = self.paired(found, args, keywords, receiver is not None)
        if pairs is None:
            return None
        given: dict[str, Type] = {}
        static = "staticmethod" in map(leaf, found.node.decorator_list)
        if receiver and not static and found.node.args.args + found.node.args.posonlyargs:
            first = (*found.node.args.posonlyargs, *found.node.args.args)[0]
            if first.annotation:
                self.unify(self.annotated(first.annotation, found.module), receiver, given)
        later: list[tuple[ast.expr, Type]] = []
        for value, annotation in pairs:
            wanted = self.annotated(annotation, found.module)
            if isinstance(value, ast.Lambda) or wanted.name == "call":
                later.append((value, wanted))
                continue
            kind = self.infer(value)
            if not self.fits(kind, wanted):
                return None
            self.unify(wanted, kind, given)
        for value, wanted in later:
            self._given(value, wanted, given)
        return given

    def _given(self, value: ast.expr, wanted: Type, given: dict[str, Type]) -> None:
        """Know a function that is given as an argument."""
        takes = [
            filled(each, given) for kind in either(wanted) if kind.name == "call" for each in kind.of[1:]
        ]
        self.lambdas[value] = takes
        kind = self.infer(value)
        found = self.found(value) if isinstance(value, ast.Name | ast.Attribute) else None
        if (
            found
            and found.node is not None
            and found.module.table
            and isinstance(found.node, ast.FunctionDef | ast.ClassDef)
        ):
            names = [f"$a{at}" for at in range(len(takes))]
            self.scope = self.scope.new_child(dict(zip(names, takes, strict=True)))
            result = self.infer(ast.Call(value, [ast.Name(name, ast.Load()) for name in names], []))
            self.scope = self.scope.parents
            kind = Type("call", (result,))
        elif found and found.is_class:
            kind = Type("call", (found.kind,))
        for pattern in either(wanted):
            if pattern.name == "call" and kind.name == "call":
                self.unify(pattern.of[0], kind.of[0], given)

    def paired(
        self, found: Found, args: list[ast.expr], keywords: list[ast.keyword], method: bool
    ) -> list[tuple[ast.expr, ast.expr | None]] | None:
        """Return each argument with its parameter's annotation; None if there are too many or too few."""
        of = found.node.args
        places = [*of.posonlyargs, *of.args]
        static = "staticmethod" in map(leaf, found.node.decorator_list)
        if places and ((method and not static) or places[0].arg == "self"):
            places = places[1:]
        pairs: list[tuple[ast.expr, ast.expr | None]] = []
        starred = any(isinstance(each, ast.Starred) for each in args) or any(
            each.arg is None for each in keywords
        )
        for at, value in enumerate(args):
            if isinstance(value, ast.Starred):
                break
            if at < len(places):
                pairs.append((value, places[at].annotation))
            elif of.vararg:
                pairs.append((value, of.vararg.annotation))
            else:
                return None
        named = {each.arg: each.annotation for each in (*places[len(args) :], *of.kwonlyargs)}
        by_place = {each.arg for each in of.posonlyargs}
        for keyword in keywords:
            if keyword.arg in named and keyword.arg not in by_place:
                pairs.append((keyword.value, named[keyword.arg]))
            elif not of.kwarg and keyword.arg is not None:
                return None
        optional = {each.arg for each in places[len(places) - len(of.defaults) :]} if of.defaults else set()
        optional |= {each.arg for each, default in zip(of.kwonlyargs, of.kw_defaults, strict=True) if default}
        missing = {*named} - {each.arg for each in keywords} - optional
        return None if missing and not starred else pairs

    def unify(self, pattern: Type, kind: Type, given: dict[str, Type]) -> None:
        """Find the types of the type variables of `pattern`."""
        if pattern.name[0] == "~":
            given[pattern.name] = join(given.get(pattern.name, UNSEEN), kind)
        elif pattern.name == "|":
            for one in either(kind):
                fitting = [each for each in pattern.of if each.name == one.name]
                fitting = fitting or [each for each in pattern.of if self.fits(one, each)]
                for each in fitting[:1]:
                    self.unify(each, one, given)
        elif pattern.name in ("iterable", "unordered", "sequence", "iterator", "collection"):
            self.unify(pattern.of[0], self.item(kind), given)
        elif kind.name == "|":
            for each in kind.of:
                self.unify(pattern, each, given)
        elif pattern.name == "tuple" and kind.name in ("row", "sequence"):
            for each in pattern.of:
                self.unify(each, item_of(kind), given)
        elif len(pattern.of) == len(kind.of) or pattern.name == kind.name:
            for one, other in zip(pattern.of, kind.of, strict=False):
                self.unify(one, other, given)

    def fits(self, kind: Type, wanted: Type) -> bool:
        """Whether something of `kind` may be given where `wanted` is."""
        if kind == UNSEEN or wanted == ANY or wanted.name[0] == "~":
            return True
        if kind.name == "|":
            return all(self.fits(each, wanted) for each in kind.of)
        if wanted.name == "|":
            return any(self.fits(kind, each) for each in wanted.of)
        if wanted in NUMBERS:
            if self._enumerated(kind) == INT:
                return wanted != WORD
            return kind == wanted or (wanted == INT and kind == WORD) or (wanted == REAL and kind in NUMBERS)
        if wanted.name == "SupportsInt":
            return kind in (ANY, BOOL, *NUMBERS) or kind.name in ("Fraction", "SupportsInt")
        if wanted.name == "collection" and kind.name == "set":
            return self.fits(kind.of[0], wanted.of[0])
        if wanted.name == "sized":
            names = (*_SEQUENCES, "dict", "set", "view")
            return (
                kind.name in names or bool(self.parts(kind)) or bool(self.of_class(kind.name, "__len__")[1])
            )
        if wanted.name in ("iterable", "unordered", "sequence", "collection"):
            allowed = _SEQUENCES if wanted.name == "sequence" else _ITERABLES
            own_class = self.parts(kind) is not None or bool(
                wanted.name != "sequence" and self.item(kind) != ANY and "." in kind.name
            )
            if kind.name in allowed or own_class or (wanted.name == "unordered" and kind.name == "set"):
                return self.fits(self.item(kind), wanted.of[0])
            return False
        if kind.name == "row" and wanted.name == "tuple":
            return False
        if wanted.name == "row" and kind.name == "tuple":
            return all(self.fits(each, wanted.of[0]) for each in kind.of)
        if wanted == STR and self._enumerated(kind) == STR:
            return True
        if kind.name == wanted.name:
            return all(map(self.fits, kind.of, wanted.of))
        of = self.program.classes.get(kind.name)
        return bool(of) and wanted.name in (each.kind.name for each in self.program.lineage(of))  # type: ignore[arg-type]

    def _enumerated(self, kind: Type) -> Type | None:
        """Return what the members of an enumeration are in JavaScript."""
        of = self.program.classes.get(kind.name)
        if not of or not of.is_enum:
            return None
        return STR if "StrEnum" in map(leaf, of.node.bases) else INT

    # What tests say.

    @contextmanager
    def holding(self, test: ast.expr, positive: bool) -> Iterator[None]:
        """Know what a test says, where it is true or where it is not."""
        said = self.said(test, positive)
        if not said:
            yield
            return
        held, self.held = self.held, self.held | said
        try:
            yield
        finally:
            self.held = held

    def forget(self, name: str) -> None:
        """Forget what has been said of a name, and of what it leads to."""
        pattern = re.compile(rf"\b{re.escape(name)}\b")
        for each in [each for each in self.held if pattern.search(each)]:
            del self.held[each]

    def said(self, test: ast.expr, positive: bool) -> dict[str, Type]:
        """Return what a test says of names and attributes if it is true, or if it is not: {source: type}."""
        match test:
            case ast.UnaryOp(ast.Not(), value):
                return self.said(value, not positive)
            case ast.BoolOp(operator, values):
                if isinstance(operator, ast.And) == positive:
                    held, all_said = self.held, dict[str, Type]()
                    for value in values:
                        all_said |= self.said(value, positive)
                        self.held = held | all_said
                    self.held = held
                    return all_said
                each = [self.said(value, positive) for value in values]
                return {
                    key: join(*(one[key] for one in each))
                    for key in each[0]
                    if all(key in one for one in each)
                }
            case ast.Compare(
                left, [ast.Is() | ast.IsNot() | ast.Eq() | ast.NotEq() as sign], [ast.Constant(None)]
            ):
                same = isinstance(sign, ast.Is | ast.Eq) == positive
                kind = self.infer(left)
                if same:
                    return self._known(left, NONE) if NONE in either(kind) else {}
                return self._known(left, UNSEEN if kind == NONE else without_none(kind))
            case ast.Compare(left, [ast.Eq()], [right]) if positive and NONE not in either(self.infer(right)):
                kind = self.infer(left)
                return self._known(left, without_none(kind)) if kind.name == "|" else {}
            case ast.Call(ast.Name("isinstance"), [value, of]):
                return self._known(value, self._instances(self.infer(value), of, positive))
            case ast.Name() | ast.Attribute() | ast.NamedExpr() | ast.Subscript():
                kind = self.infer(test)
                if kind.name != "|" or NONE not in kind.of:
                    return {}
                rest = without_none(kind)
                if positive:
                    return self._known(test, rest)
                return self._known(test, NONE) if all(map(self._always_true, either(rest))) else {}
        return {}

    def _known(self, node: ast.expr, kind: Type) -> dict[str, Type]:
        if isinstance(node, ast.NamedExpr):
            return {ast.unparse(node.target): kind, ast.unparse(node): kind}
        return {ast.unparse(node): kind} if isinstance(node, ast.Name | ast.Attribute | ast.Subscript) else {}

    def _instances(self, kind: Type, of: ast.expr, positive: bool) -> Type:
        """Return the type of what is an instance of the classes `of`, or is none."""
        nodes = of.elts if isinstance(of, ast.Tuple) else [of]
        wanted = [self.annotated(each) for each in nodes]
        names = [leaf(each) for each in nodes]

        def inside(each: Type) -> bool:
            table = {"word": "int", "row": "tuple", "words": "array"}
            if each.name in names or table.get(each.name) in names or (each == BOOL and "int" in names):
                return True
            known = self.program.classes.get(each.name)
            enumerated = self._enumerated(each)
            if enumerated is not None and enumerated.name in names:
                return True
            return bool(known) and any(base.kind in wanted for base in self.program.lineage(known))  # type: ignore[arg-type]

        def below(each: Type) -> list[Type]:
            found = []
            for one in wanted:
                known = self.program.classes.get(one.name)
                if known and any(base.kind == each for base in self.program.lineage(known)):
                    found.append(one)
            return found

        if kind == ANY:
            generic = {
                "list": Type("list", (ANY,)),
                "dict": Type("dict", (STR, ANY)),
                "tuple": Type("row", (ANY,)),
            }
            return (
                join(*(generic.get(name, one) for name, one in zip(names, wanted, strict=True)))
                if positive
                else ANY
            )
        if not positive:
            return join(*(each for each in either(kind) if not inside(each)))
        found = [each for each in either(kind) if inside(each)]
        found += [one for each in either(kind) if not inside(each) for one in below(each)]
        if not found and (kind.name in ("iterable", "sequence") or kind in self.program.protocols):
            found = wanted
        return join(*found)


def _of_constant(value: object) -> Type:
    if type(value) is int:
        return WORD if 0 <= value < 1 << 31 else INT
    if value is None:
        return NONE
    return FLOAT if isinstance(value, float) else _PLAIN.get(type(value).__name__, ANY)


@cache
def _set_in(method: ast.FunctionDef) -> frozenset[str]:
    """Return the attributes that a method assigns to."""
    attributes = (node for node in own(method.body) if isinstance(node, ast.Attribute))
    return frozenset(each.attr for each in attributes if isinstance(each.ctx, ast.Store))


def own(body: list[ast.stmt]) -> list[ast.AST]:
    """Return all nodes of these statements but those of functions and classes inside."""
    return [part for node in body for part in _own(node)]


@cache
def _own(node: ast.AST) -> list[ast.AST]:
    found, left = [], [node]
    while left:
        found.append(part := left.pop())
        if not isinstance(part, _CLOSED):
            left += reversed([*ast.iter_child_nodes(part)])
    return found
