"""The type of each expression of a module: from annotations, and from what is assigned.

Nothing is refused here: where nothing is known the type is ANY. What a test says of a name, `x is None`,
`isinstance(x, str)`, holds where the test does (`holding`).
"""

import ast
import re
from collections import ChainMap
from collections.abc import Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache

from pdp8.web.translator.operators import arithmetic
from pdp8.web.translator.program import Found, Module, Parameter, Program, own, set_in
from pdp8.web.translator.types import (
    ANY,
    BOOL,
    BYTEARRAY,
    BYTES,
    FLOAT,
    INT,
    NONE,
    NUMBERS,
    REAL,
    STR,
    UNSEEN,
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
    "array": WORDS, "words": WORDS, "range": Type("range", (INT,)),
    "slice": Type("slice"), "Word": WORD, "Float": FLOAT, "NoReturn": Type("never"),
    "SupportsInt": Type("SupportsInt"), "Sized": Type("sized"),
    **{name: Type(f"~{name}") for name in "TUVK"},
}  # fmt: skip
_GENERIC = {
    "list": "list", "set": "set", "frozenset": "set", "Set": "set", "dict": "dict", "Mapping": "dict",
    "Sequence": "sequence", "Iterable": "iterable", "Collection": "collection", "Unordered": "unordered",
    "Iterator": "iterator", "Generator": "iterator", "View": "view", "range": "range", "Pattern": "Pattern",
}  # fmt: skip
_MARKS = (
    "Annotated", "Final", "ClassVar", "Ordered", "Compared", "Key", "New", "Keys", "Character", "Base",
    "Written",
)  # fmt: skip
"""Annotations that have the type of what is in their brackets."""
_TABLE = {"word": "int", "real": "float", "row": "tuple", "sequence": "tuple"}
"""The class of library.pyi that has the methods of a type, if it has another name."""
_OPEN = {"dict": Type("dict", (STR, ANY))}
"""The types of instances of which nothing is known but their class, where that says more than its name."""
_SETTING = ast.Assign | ast.AnnAssign | ast.AugAssign | ast.NamedExpr | ast.For | ast.ExceptHandler | ast.Expr
_SEQUENCES = ("sequence", "list", "tuple", "row", "bytes", "bytearray", "words", "range", "str")
_ITERABLES = (*_SEQUENCES, "iterable", "iterator", "view", "dict")


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
        self.shared = frozenset[str]()
        """The names that functions within these functions set."""
        self.inner: dict[str, ast.FunctionDef] = {}
        """The functions within these functions."""
        self.lambdas: dict[ast.AST, list[Type]] = {}
        """The types of the parameters of functions that are given to others."""

    @contextmanager
    def naming(self, names: Mapping[str, Type]) -> Iterator[None]:
        """Give these names these types within the block; then forget them and what tests said in it."""
        scope, held = self.scope, self.held
        self.scope, self.held = scope.new_child(dict(names)), dict(held)
        self.forget(*names)
        try:
            yield
        finally:
            self.scope, self.held = scope, held

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
                found = self.program.find(of.module if of else module, name)
                if found and found.is_class and not found.module.table:
                    return found.kind
                if found and isinstance(found.node, ast.expr):
                    return self.annotated(found.node, found.module)
                if name in _PLAIN:
                    return _PLAIN[name]
                return Type(name) if name in self.program.classes else ANY
        return ANY

    def _generic(self, name: str, items: list[ast.expr], module: Module) -> Type:
        if name in _MARKS:
            return self.annotated(items[0], module)
        if name == "Literal":
            return join(*(_PLAIN.get(type(getattr(each, "value", None)).__name__, ANY) for each in items))
        if name == "Callable":
            taken, returned = items
            takes = taken.elts if isinstance(taken, ast.List) else []
            return Type("call", tuple(self.annotated(each, module) for each in (returned, *takes)))
        named = [each for each in items if getattr(each, "value", None) is not Ellipsis]
        kinds = [self.annotated(each, module) for each in named]
        if name == "tuple":
            return Type("row" if len(kinds) < len(items) else "tuple", tuple(kinds))
        if name in ("array", "MutableSequence"):
            return WORDS
        return made(_GENERIC[name], *kinds[: 1 + (name in ("dict", "Mapping"))]) if name in _GENERIC else ANY

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
            match member := each.declared.get(attribute):
                case ast.FunctionDef():
                    return inner.annotated(member.returns), each._replace(node=member)
                case ast.AnnAssign():
                    return inner.annotated(member.annotation), None
            if kind := inner._set_in_methods(each, attribute):
                return widened(kind), None
            if isinstance(member, ast.Assign):
                return (each.kind if each.is_enum else widened(inner.infer(member.value))), None
        return ANY, None

    def _set_in_methods(self, of: Found, attribute: str) -> Type | None:
        """Return the type of what methods assign to an attribute: the first of them, if it says enough."""
        kinds: list[Type] = []
        for method in of.node.body:
            if kinds and UNSEEN not in kinds[0].of:
                return kinds[0]
            if isinstance(method, ast.FunctionDef) and attribute in set_in(method):
                self.scope = ChainMap(self.parameters(method))
                self.learn(method.body)
                sets = (pair for node in own(method.body) for pair in self._set_by(node))
                found = [kind for target, kind in sets if getattr(target, "attr", "") == attribute]
                kinds += [kind for kind in found if kind != ANY]  # x += 1 needs what it is itself
        if not kinds:
            return None
        return join(*kinds) if UNSEEN in kinds[0].of else kinds[0]

    def ours(self, kind: Type) -> Found | None:
        """Return the class of the sources that `kind` is, None for any other type."""
        of = self.program.classes.get(kind.name)
        return of if of and of.ours else None

    def has(self, kind: Type, name: str) -> bool:
        """Whether something of `kind` has an attribute or method `name`."""
        of = self.program.classes.get(_TABLE.get(kind.name, kind.name))
        return bool(of and not of.is_enum and any(name in each.members for each in self.program.lineage(of)))

    def plain(self, kind: Type) -> Type:
        """Return what something of `kind` is in JavaScript: a member of an enumeration is its value."""
        of = self.ours(kind)
        return kind if not of or not of.is_enum else STR if "StrEnum" in of.marks else INT

    def parameters(self, function: ast.FunctionDef) -> dict[str, Type]:
        """Return the types of a function's parameters."""
        types = dict[str, Type]()
        for each in Found(self.module, function).parameters:
            kind = self.annotated(each.annotation)
            rest = {"*": Type("row", (kind,)), "**": made("dict", STR, kind)}
            types[each.name] = rest.get(each.how, kind)
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
                if isinstance(target, ast.Name) and target.id not in given:
                    scope[target.id] = join(scope.get(target.id, UNSEEN), kind)

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
                elif kind == made("list", UNSEEN):
                    kind = made("list", self.item(self.infer(value)))
                return [(target, kind)] if isinstance(target, ast.Name | ast.Attribute) else []
            case ast.NamedExpr(target, value):
                return [(target, self.infer(value))]
            case ast.For(target, iterable) | ast.comprehension(target, iterable):
                return self.apart(target, self.item(self.infer(iterable)))
            case ast.ExceptHandler(ast.expr() as kind, str(name)):
                return [(ast.Name(name), self.caught(kind))]
            case ast.Expr(ast.Call(ast.Attribute(ast.Name() as of, "append" | "add" as method), [value])):
                if of.id in self.scope.maps[0] and item_of(self.infer(of)) == UNSEEN:
                    return [(of, made("list" if method == "append" else "set", self.infer(value)))]
        return []

    def _put(self, target: ast.AST, kind: Type) -> list[tuple[ast.AST, Type]]:
        if isinstance(target, ast.Subscript) and isinstance(target.value, ast.Name):
            of = self.infer(target.value)
            if of.name == "dict" and UNSEEN in of.of:
                return [(target.value, made("dict", self.infer(target.slice), kind))]
        return self.apart(target, kind)

    def caught(self, node: ast.expr) -> Type:
        """Return the type of the errors that a handler catches."""
        errors = map(self.found, node.elts if isinstance(node, ast.Tuple) else [node])
        return join(*(each.kind if each and each.is_class else ANY for each in errors))

    def apart(self, target: ast.AST, kind: Type) -> list[tuple[ast.AST, Type]]:
        """Return each name of a target with its type."""
        if isinstance(target, ast.Starred):
            return [(target.value, made("list", kind))]
        if not isinstance(target, ast.Tuple | ast.List):
            return [(target, kind)]
        kind = without_none(kind)
        parts, count = self.parts(kind), len(target.elts)
        if parts is None or len(parts) != count:
            parts = (self.item(kind),) * count
        return [
            pair for each, part in zip(target.elts, parts, strict=True) for pair in self.apart(each, part)
        ]

    def parts(self, kind: Type) -> tuple[Type, ...] | None:
        """Return the types of the items of a tuple of known length, or of the fields of a named one."""
        if kind.name == "tuple":
            return kind.of
        of = self.program.classes.get(kind.name)
        return tuple(each for _, each in self.fields_of(of)) if of and of.is_tuple else None

    def fields_of(self, of: Found) -> list[tuple[str, Type]]:
        """Return the fields of a record, those of its base classes first."""
        return [(each.name, self.annotated(each.annotation, each.module)) for each in self.program.fields(of)]

    def item(self, kind: Type) -> Type:
        """Return what an iteration yields."""
        if kind.name == "|":
            return join(*map(self.item, kind.of))
        if not self.ours(kind):
            return item_of(kind)
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
        if of and of.is_module:
            return self.program.find(of.module, node.attr)
        if self.after_super(node):
            bases = [*self.program.lineage(self.program.classes[self.owner])][1:] if self.owner else []
            methods = (self.of_class(each.kind.name, node.attr)[1] for each in bases)
        else:
            kinds = either(self._before_the_dot(node.value, of))
            methods = (self.of_class(each.name, node.attr)[1] for each in kinds)
        return next(filter(None, methods), None)

    @staticmethod
    def after_super(node: ast.expr) -> bool:
        """Whether it is `super().name`."""
        return isinstance(node, ast.Attribute) and leaf(getattr(node.value, "func", None)) == "super"

    def _before_the_dot(self, node: ast.expr, of: Found | None) -> Type:
        if of and of.is_class:
            return of.kind
        if of and not of.ours:
            return Type(leaf(node))  # dict.fromkeys
        return without_none(self.infer(node))

    def constant(self, node: ast.expr) -> ast.AST:
        """Return the value of a constant's name."""
        found = self.found(node)
        return found.node if found else node

    def never(self, node: ast.expr) -> bool:
        """Whether nothing comes after a call."""
        return self.infer(node).name == "never"

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
                one, other, by = without_none(self.infer(left)), without_none(self.infer(right)), whole(right)
                if isinstance(operator, ast.Pow) and by is not None and by < 0:
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
                with self.naming(taken := self.taken(node)):
                    return Type("call", (self.infer(body), *taken.values()))
            case ast.ListComp() | ast.GeneratorExp() | ast.SetComp() | ast.DictComp():
                return self._comprehended(node)
        return ANY

    def _operated(self, operator: ast.operator, one: Type, other: Type) -> Type:
        if one.name == "view":
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
        return join(kind, other)

    def _always_true(self, kind: Type) -> bool:
        """Whether all of `kind` is true: an instance of a class of ours that has no length."""
        of = self.ours(kind)
        methods = (self.of_class(kind.name, name)[1] for name in ("__len__", "__bool__"))
        return of is not None and not of.is_enum and not any(methods)

    def _indexed_type(self, kind: Type, index: ast.expr) -> Type:
        if kind.name == "|":
            return join(*(self._indexed_type(each, index) for each in kind.of))
        of = self.ours(kind)
        if of and not of.is_tuple:
            method = self.of_class(kind.name, "__getitem__")[1]
            return self._returned(method, ast.Call(index, [index], []), kind) if method else ANY
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

    def entered(self, generator: ast.comprehension) -> list[str]:
        """Learn the types of the names that a comprehension's loop sets; return them."""
        sets = {leaf(target): kind for target, kind in self._set_by(generator)}
        self.scope |= sets
        self.forget(*sets)
        return [*sets]

    def _comprehended(self, node: ast.ListComp | ast.GeneratorExp | ast.SetComp | ast.DictComp) -> Type:
        with self.naming({}):
            self.forget(*rebound(node))
            for generator in node.generators:
                self.entered(generator)
                for test in generator.ifs:
                    self.held |= self.said(test, True)
            if isinstance(node, ast.DictComp):
                return made("dict", self.infer(node.key), self.infer(node.value or node.key))
            kind = self.infer(node.elt)
        names = {ast.ListComp: "list", ast.SetComp: "set", ast.GeneratorExp: "iterator"}
        return made(names[type(node)], kind)

    def taken(self, node: ast.Lambda) -> dict[str, Type]:
        """Return the parameters of a lambda with their types, ANY where nothing says the type."""
        kinds = self.lambdas.get(node, [])
        return {each.arg: kinds[at] if at < len(kinds) else ANY for at, each in enumerate(node.args.args)}

    def _joined(self, nodes: list[ast.expr]) -> Type:
        return join(*map(self.infer, nodes))

    def _named_type(self, node: ast.Name | ast.Attribute) -> Type:
        """Return the type of a name of a module, or of an attribute."""
        found = self.found(node)
        if isinstance(node, ast.Attribute) and (found is None or found.is_function):
            return self._attribute_type(node, found)
        if found is None:
            return ANY
        match found.node:
            case ast.AnnAssign(_, annotation, ast.expr() as value):
                kind = self.annotated(annotation, found.module)
                return self._constant(found, value) if kind == ANY and leaf(annotation) == "Final" else kind
            case ast.FunctionDef():
                return Type("call", (self.annotated(found.node.returns, found.module), *self._takes(found)))
            case ast.ClassDef():
                return Type("iterable" if found.is_enum else "type", (found.kind,))
            case ast.expr() as value:
                return self._constant(found, value)
        return ANY

    def _takes(self, found: Found) -> list[Type]:
        """Return the types of the parameters of a function or a method."""
        return [self.annotated(each.annotation, each.module) for each in self.program.signature(found) or []]

    def _constant(self, found: Found, node: ast.AST) -> Type:
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
            if result == ANY and len(kinds) > 1 and not self.has(kind, node.attr):
                continue
            if method and not method.is_property:
                result = Type("call", (result, *self._takes(method)))
            results.append(result)
        return join(*results)

    # Calls.

    def _called(self, node: ast.Call) -> Type:
        """Return the type of what a call returns."""
        found, name = self.found(node.func), leaf(node.func)
        if found and found.is_class:
            for value, parameter in self.paired(found, node) or []:
                self.expect(value, self.annotated(parameter.annotation, parameter.module))
            return found.kind
        if found and found.is_function:
            receiver = None
            if isinstance(node.func, ast.Attribute):
                receiver = without_none(self.infer(node.func.value))
            if receiver and receiver.name == "|":
                methods = [(each, self.of_class(each.name, name)[1]) for each in receiver.of]
                return join(*(self._returned(of, node, one) for one, of in methods if of))
            return self._returned(found, node, receiver)
        match node:
            case ast.Call(ast.Attribute(of, "_replace")) | ast.Call(ast.Name("replace"), [of, *_]):
                return self.infer(of)
            case ast.Call(ast.Name("isinstance")):
                return BOOL
        kind = without_none(self.infer(node.func))
        return kind.of[0] if kind.name == "call" else ANY

    def expect(self, value: ast.expr, wanted: Type) -> None:
        """Record the parameters' types of the lambdas in a value, which has to be of type `wanted`."""
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

    def _returned(self, found: Found, call: ast.Call, receiver: Type | None = None) -> Type:
        """Return the type that a call of a function returns, by the first of its forms that fits."""
        match call.args:
            case [ast.Constant(str(pattern))] if found.node.name == "compile" and not found.ours:
                groups = re.compile(pattern).groups
                return Type("Pattern", (STR if groups < 2 else Type("tuple", (STR,) * groups),))
        form, given = self.form(found, call, receiver)
        inner = Types(self.program, form.module, receiver.name if receiver and found.ours else "")
        return filled(inner.annotated(form.node.returns), given or {})

    def form(
        self, found: Found, call: ast.Call, receiver: Type | None
    ) -> tuple[Found, dict[str, Type] | None]:
        """Return the first form that takes the arguments, and its type variables; else the last, and None."""
        forms = self.program.variants(found)
        for form in forms:
            given = self.bound(form, call, receiver)
            if given is not None:
                return form, given
        return forms[-1], None

    def bound(self, found: Found, call: ast.Call, receiver: Type | None = None) -> dict[str, Type] | None:
        """Return the types of a function's type variables in a call; None if the arguments do not fit."""
        pairs = self.paired(found, call)
        if pairs is None:
            return None
        given = self.of_receiver(found, receiver)
        functions: list[tuple[ast.expr, Type]] = []
        for value, parameter in pairs:
            wanted = self.annotated(parameter.annotation, found.module)
            if isinstance(value, ast.Lambda) or wanted.name == "call":
                functions.append((value, wanted))
                continue
            kind = self.infer(value)
            if not self.fits(kind, wanted):
                return None
            self.unify(wanted, kind, given)
        for value, wanted in functions:  # when it is known what they take
            self._given(value, wanted, given)
        return given

    def of_receiver(self, method: Found, receiver: Type | None) -> dict[str, Type]:
        """Return the types of the type variables that the receiver of a method decides."""
        given: dict[str, Type] = {}
        for first in method.parameters[:1]:
            if receiver and first.name == "self" and first.annotation:
                self.unify(self.annotated(first.annotation, method.module), receiver, given)
        return given

    def _given(self, value: ast.expr, wanted: Type, given: dict[str, Type]) -> None:
        """Record the parameters' types of an argument that is a function, and what type its result is."""
        forms = [kind for kind in either(wanted) if kind.name == "call"]
        takes = self.lambdas[value] = [filled(each, given) for kind in forms for each in kind.of[1:]]
        kind, found = self.infer(value), self.found(value)
        if found and not found.ours:
            with self.applied(value, takes) as call:
                kind = Type("call", (self.infer(call),))
        for form in forms:
            self.unify(form.of[0], kind.of[0] if kind.name == "call" else ANY, given)

    @contextmanager
    def applied(self, function: ast.expr, takes: list[Type]) -> Iterator[ast.Call]:
        """Yield a call of a function with an argument, a new name, of each of these types."""
        kinds = {f"$a{at}": kind for at, kind in enumerate(takes)}
        names: list[ast.expr] = [ast.copy_location(ast.Name(name, ast.Load()), function) for name in kinds]
        with self.naming(kinds):
            yield ast.copy_location(ast.Call(function, names, []), function)

    def paired(self, found: Found, call: ast.Call) -> list[tuple[ast.expr, Parameter]] | None:
        """Return each argument with its parameter; None if there are too many or too few.

        What is unpacked is an item for each of its parts, or, if their number is unknown, for `*`.
        """
        parameters = self.program.signature(found) or []
        places = [each for each in parameters if each.how in ("", "/")]
        rest = {each.how: each for each in parameters}
        args = self.arguments_of(call.args)
        if any(isinstance(each, ast.Starred) for each in args[: len(places)]):
            return None
        if len(args) > len(places) and "*" not in rest:
            return None
        pairs = [*zip(args, places, strict=False)]
        pairs += [(each, rest["*"]) for each in args[len(places) :]]
        left = {each.name: each for each in parameters if each.how == "key" or each in places[len(args) :]}
        for keyword in call.keywords:
            parameter = left.get(keyword.arg or "")
            if parameter and parameter.how != "/":
                pairs.append((keyword.value, parameter))
            elif "**" in rest:
                value = keyword.value if keyword.arg else _item(keyword.value, None)
                pairs.append((value, rest["**"]))
            elif keyword.arg is not None:
                return None
        given = {each.arg for each in call.keywords}
        missing = any(each.default is None and each.name not in given for each in left.values())
        return None if missing else pairs

    def arguments_of(self, given: Iterable[ast.expr]) -> list[ast.expr]:
        """Return what is given, in place of what is unpacked each of its parts if their number is known."""
        return [part for each in given for part in self._unpacked(each)]

    def _unpacked(self, argument: ast.expr) -> list[ast.expr]:
        match argument:
            case ast.Starred(ast.Tuple(items) | ast.List(items)):
                return self.arguments_of(items)
            case ast.Starred(ast.GeneratorExp(made, [ast.comprehension(_, ast.Tuple(items), [])] as loops)):
                each = ast.copy_location(ast.ListComp(made, loops), argument)
                return [_item(each, at) for at, _ in enumerate(items)]
            case ast.Starred(value) if (parts := self.parts(self.infer(value))) is not None:
                return [_item(value, at) for at, _ in enumerate(parts)]
        return [argument]

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
        elif len(pattern.of) == len(kind.of):
            for one, other in zip(pattern.of, kind.of, strict=True):
                self.unify(one, other, given)

    def fits(self, kind: Type, wanted: Type) -> bool:
        """Whether something of `kind` may be given where `wanted` is."""
        if UNSEEN in (kind, wanted) or wanted == ANY or wanted.name[0] == "~":
            return True
        if kind.name == "|":
            return all(self.fits(each, wanted) for each in kind.of)
        if wanted.name == "|":
            return any(self.fits(kind, each) for each in wanted.of)
        if wanted in (*NUMBERS, STR):
            kind = self.plain(kind)
            return kind == wanted or (wanted, kind) == (INT, WORD) or (wanted == REAL and kind in NUMBERS)
        match wanted.name:
            case "SupportsInt":
                return self.plain(kind) in (ANY, BOOL, *NUMBERS) or kind.name in ("Fraction", "SupportsInt")
            case "sized":
                sized = kind.name in (*_SEQUENCES, "dict", "set", "view") or self.parts(kind) is not None
                return sized or self.of_class(kind.name, "__len__")[1] is not None
            case "iterable" | "unordered" | "sequence" | "collection":
                return self._iterates(kind, wanted.name) and self.fits(self.item(kind), wanted.of[0])
            case "row" if kind.name == "tuple":
                return all(self.fits(each, wanted.of[0]) for each in kind.of)
            case "tuple" if len(kind.of) != len(wanted.of):
                return False
            case kind.name:
                return all(map(self.fits, kind.of, wanted.of))
        of = self.program.classes.get(kind.name)
        return bool(of and wanted.name in (each.kind.name for each in self.program.lineage(of)))

    def _iterates(self, kind: Type, how: str) -> bool:
        """Whether something of `kind` is a sequence, or is iterated over in an order or in any."""
        if kind.name in ("set", "collection"):
            return how == "collection" or (kind.name, how) == ("set", "unordered")
        if kind.name in (_SEQUENCES if how == "sequence" else _ITERABLES) or self.parts(kind) is not None:
            return True
        return how != "sequence" and "." in kind.name and self.item(kind) != ANY

    # What tests say.

    @contextmanager
    def holding(self, test: ast.expr, positive: bool) -> Iterator[None]:
        """Within the block, use what the test implies if it is true, or if it is false."""
        held = self.held
        inside = _without(held, rebound(test)) | self.said(test, positive)
        self.held = dict(inside)
        try:
            yield
        finally:  # what was forgotten in the block stays so
            self.held = {key: kind for key, kind in held.items() if key in self.held or key not in inside}

    def forget(self, *names: str) -> None:
        """Forget what tests said of names, and of their attributes."""
        self.held = _without(self.held, names)

    def _stays(self, source: str) -> bool:
        """Whether a call leaves it as a test has found it: a local name, a field of what is frozen."""
        node = ast.parse(source, mode="eval").body
        while isinstance(node, ast.Attribute):
            of = self.ours(without_none(self.infer(node.value)))
            if not of or not of.is_frozen:
                return False
            node = node.value
        return isinstance(node, ast.NamedExpr | ast.Name) and leaf(node) not in self.shared

    def said(self, test: ast.expr, positive: bool) -> dict[str, Type]:
        """Return the types of names and attributes if a test is true, or if it is not: {source: type}."""
        match test:
            case ast.UnaryOp(ast.Not(), value):
                return self.said(value, not positive)
            case ast.BoolOp(operator, values):
                if isinstance(operator, ast.And) != positive:  # one of them, and nothing says which
                    said = [self.said(value, positive) for value in values]
                    names = [name for name in said[0] if all(name in one for one in said)]
                    return {name: join(*(one[name] for one in said)) for name in names}
                held, found = self.held, dict[str, Type]()
                for value in values:
                    found = _without(found, rebound(value)) | self.said(value, positive)
                    self.held = _without(self.held, rebound(value)) | found
                self.held = held
                return found
            case ast.Compare(
                left, [ast.Is() | ast.IsNot() | ast.Eq() | ast.NotEq() as sign], [ast.Constant(None)]
            ):
                same = isinstance(sign, ast.Is | ast.Eq) == positive
                kind = self.infer(left)
                if same:
                    return self._known(left, NONE) if NONE in either(kind) else {}
                return self._known(left, UNSEEN if kind == NONE else without_none(kind))
            case ast.Compare(left, [ast.Eq() | ast.In() as sign], [right]) if positive:
                kind, other = self.infer(left), self.infer(right)
                others = either(self.item(other) if isinstance(sign, ast.In) else other)
                there = kind.name == "|" and {NONE, ANY, UNSEEN}.isdisjoint(others)
                return self._known(left, without_none(kind)) if there else {}
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
        return {ast.unparse(node): kind}

    def _instances(self, kind: Type, of: ast.expr, positive: bool) -> Type:
        """Return the type of what is an instance of the classes `of`, or is none."""
        nodes = of.elts if isinstance(of, ast.Tuple) else [of]
        wanted = [self.annotated(each) for each in nodes]
        names = {*map(leaf, nodes), *(each.name for each in wanted)}
        if kind == ANY:
            return join(*(_OPEN.get(each.name, each) for each in wanted)) if positive else ANY
        inside = [each for each in either(kind) if not names.isdisjoint(self._ancestry(each))]
        others = [each for each in either(kind) if each not in inside]
        if not positive:
            return join(*others)
        found = inside + [one for each in others for one in wanted if each.name in self._ancestry(one)]
        if not found and (kind.name in ("iterable", "sequence") or kind in self.program.protocols):
            found = [_OPEN.get(each.name, each) for each in wanted]
        return join(*found)

    def _ancestry(self, kind: Type) -> set[str]:
        """Return the names of the classes of which something of `kind` is an instance."""
        of = self.program.classes.get(kind.name)
        names = {each.kind.name for each in self.program.lineage(of)} if of else set[str]()
        also = {"word": "int", "bool": "int", "row": "tuple"}
        return names | {kind.name, also.get(kind.name, kind.name), self.plain(kind).name}


@cache
def rebound(node: ast.AST) -> frozenset[str]:
    """Return the names that `:=` sets in an expression."""
    return frozenset(each.target.id for each in own([node]) if isinstance(each, ast.NamedExpr))


def _item(of: ast.expr, key: int | None) -> ast.expr:
    """Return the expression of an item."""
    return ast.copy_location(ast.Subscript(of, ast.Constant(key), ast.Load()), of)


def _without(held: dict[str, Type], names: Collection[str]) -> dict[str, Type]:
    """Return what tests said of other names than these and their attributes."""
    pattern = re.compile(rf"\b({'|'.join(map(re.escape, names))})\b")
    return {key: kind for key, kind in held.items() if not (names and pattern.search(key))}


def _of_constant(value: object) -> Type:
    if type(value) is int:
        return WORD if value < 1 << 31 else INT
    if value is None:
        return NONE
    return FLOAT if isinstance(value, float) else _PLAIN.get(type(value).__name__, ANY)
