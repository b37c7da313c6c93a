"""The type of each expression of a module: from annotations, and from what is assigned.

Where nothing is known the type is ANY, and the runtime looks when it runs.
"""

import ast
from collections import ChainMap
from functools import cache, reduce

from pdp8.web.translator.program import Found, Module, Program
from pdp8.web.translator.types import (
    ANY,
    BOOL,
    BYTES,
    FLOAT,
    INT,
    NONE,
    NUMBERS,
    STR,
    UNSEEN,
    WORD,
    WORDS,
    Type,
    join,
    leaf,
    whole,
)

_PLAIN = {"int": INT, "float": FLOAT, "bool": BOOL, "str": STR, "bytes": BYTES, "bytearray": BYTES}
_SEQUENCES = ("list", "tuple", "Sequence", "Iterable", "Iterator")
_CALLS = _PLAIN | {"len": WORD, "ord": WORD, "round": INT, "isinstance": BOOL, "chr": STR}
_CALLS |= {"isqrt": INT, "array": WORDS}
_SETTING = ast.Assign | ast.AnnAssign | ast.AugAssign | ast.NamedExpr | ast.For | ast.ExceptHandler
_CLOSED = (
    ast.FunctionDef | ast.Lambda | ast.ClassDef | ast.Constant | ast.Name | ast.expr_context | ast.operator
)


def _arithmetic(operator: ast.operator, left: Type, right: Type) -> Type:
    """Return the type of `left operator right`."""
    if isinstance(operator, ast.BitAnd) and WORD in (left, right):
        return WORD
    if left not in NUMBERS or right not in NUMBERS:
        return left if right in (left, UNSEEN) else ANY
    if isinstance(operator, ast.Div) or FLOAT in (left, right):
        return FLOAT
    same = left == right == WORD and isinstance(operator, ast.BitOr | ast.BitXor | ast.Mod)
    return WORD if same or (left == WORD and isinstance(operator, ast.RShift)) else INT


class Types:
    """The types of expressions in one module."""

    def __init__(self, program: Program, module: Module, owner: str = "") -> None:
        self.program = program
        self.module = module
        self.owner = owner
        """The class whose body this is, as `module.Class`."""
        self.scope = ChainMap[str, Type]()
        """The names of the functions around, and their types."""

    def annotated(self, node: ast.AST | None, module: Module | None = None) -> Type:
        """Return the type that an annotation names."""
        module = module or self.module
        name = leaf(node)
        match node:
            case ast.BinOp(left, ast.BitOr(), right):
                return join(self.annotated(left, module), self.annotated(right, module))
            case ast.Constant(None):
                return NONE
            case ast.Subscript(_, inner):
                items = inner.elts if isinstance(inner, ast.Tuple) else [inner]
                if name == "Annotated":
                    return self.annotated(items[0], module)
                kinds = {self.annotated(item, module) for item in items if not isinstance(item, ast.Constant)}
                if name in _SEQUENCES:
                    return Type("list", kinds.pop() if len(kinds) == 1 else ANY)
                return WORDS if name in ("array", "MutableSequence") else ANY
            case ast.Name() | ast.Attribute() if name not in _PLAIN:
                found = self.program.find(module, name)
                if found and found.is_class:
                    return found.kind
                return self.annotated(found.node, found.module) if found else ANY
        return _PLAIN.get(name, ANY)

    def of_class(self, name: str, attribute: str) -> tuple[Type, Found | None]:
        """Return the type of an attribute of a class, or what its method returns, and the method."""
        key = (name, attribute)
        if key not in self.program.attributes:
            self.program.attributes[key] = ANY, None
            if name in self.program.classes:
                self.program.attributes[key] = self._of_class(self.program.classes[name], attribute)
        return self.program.attributes[key]

    def _of_class(self, of: Found, attribute: str) -> tuple[Type, Found | None]:
        for each in self.program.lineage(of):
            inner = Types(self.program, each.module, each.kind.name)
            for member in each.node.body:
                if isinstance(member, ast.FunctionDef) and member.name == attribute:
                    return inner.annotated(member.returns), each._replace(node=member)
                if isinstance(member, ast.AnnAssign) and leaf(member.target) == attribute:
                    return inner.annotated(member.annotation), None
            for method in each.node.body:
                if isinstance(method, ast.FunctionDef) and attribute in _set_in(method):
                    inner.scope = ChainMap(inner.parameters(method))
                    inner.learn(method.body)
                    sets = (pair for node in own(method.body) for pair in inner._set_by(node))
                    kinds = (kind for target, kind in sets if getattr(target, "attr", "") == attribute)
                    return next((_kept(kind), None) for kind in kinds)
        return ANY, None

    def parameters(self, function: ast.FunctionDef) -> dict[str, Type]:
        """Return the types of a function's parameters."""
        args = function.args
        types = {each.arg: self.annotated(each.annotation) for each in (*args.args, *args.kwonlyargs)}
        types |= {each.arg: ANY for each in (args.vararg, args.kwarg) if each}
        return types | {"self": Type(self.owner)} if "self" in types else types

    def learn(self, body: list[ast.stmt]) -> None:
        """Find the types of the names that a function's statements set."""
        scope, given = self.scope.maps[0], set(self.scope.maps[0])
        setting = [node for node in own(body) if isinstance(node, _SETTING)]
        before = None
        while before != scope:
            before = dict(scope)
            for target, kind in (pair for node in setting for pair in self._set_by(node)):
                if isinstance(target, ast.Name) and target.id not in given:
                    scope[target.id] = join(scope.get(target.id, UNSEEN), kind)
        scope.update((name, ANY) for name, kind in scope.items() if kind in (UNSEEN, NONE))

    def _set_by(self, node: ast.AST) -> list[tuple[ast.AST, Type]]:
        """Return the targets that a node sets, and to what."""
        match node:
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)) if len(targets) == len(values):
                return [(target, self.infer(value)) for target, value in zip(targets, values, strict=True)]
            case ast.Assign(targets, value):
                return [pair for target in targets for pair in _apart(target, self.infer(value))]
            case ast.AnnAssign(target, annotation):
                return [(target, self.annotated(annotation))]
            case ast.AugAssign(target, operator, value):
                return [(target, _arithmetic(operator, self.infer(target), self.infer(value)))]
            case ast.NamedExpr(target, value):
                return [(target, self.infer(value))]
            case ast.For(ast.Tuple([number, target]), ast.Call(ast.Name("enumerate"), [of, *_])):
                return [(number, WORD), *_apart(target, self.infer(of).item)]
            case ast.For(target, iterable) | ast.comprehension(target, iterable):
                return _apart(target, self.infer(iterable).item)
            case ast.ExceptHandler(name=str(name)):
                return [(ast.Name(name), ANY)]
        return []

    def found(self, node: ast.AST) -> Found | None:
        """Return what a name or an attribute of a module or class of ours is defined as."""
        if isinstance(node, ast.Name) and node.id not in self.scope:
            return self.program.find(self.module, node.id)
        if not isinstance(node, ast.Attribute):
            return None
        of = self.found(node.value)
        if of and of.node is None:
            return self.program.find(of.module, node.attr)
        kind = of.kind if of and of.is_class else self.infer(node.value)
        return self.of_class(kind.name, node.attr)[1]

    def infer(self, node: ast.AST) -> Type:
        """Return the type of an expression."""
        match node:
            case ast.Name(name) if name in self.scope:
                return self.scope[name]
            case ast.Name() | ast.Attribute():
                return self._named_type(node)
            case ast.Call(function, arguments):
                return self._called(function, arguments)
            case ast.Constant(bool()) | ast.Compare() | ast.UnaryOp(ast.Not()):
                return BOOL
            case ast.Constant() | ast.BinOp() | ast.UnaryOp() if (number := whole(node)) is not None:
                return WORD if 0 <= number < 1 << 31 else INT
            case ast.Constant(value):
                return _PLAIN.get(type(value).__name__, NONE)
            case ast.JoinedStr():
                return STR
            case ast.UnaryOp(_, value):
                return INT if (kind := self.infer(value)) == WORD else kind
            case ast.BinOp(left, operator, right):
                return _arithmetic(operator, self.infer(left), self.infer(right))
            case ast.BoolOp(_, values):
                return self._joined(values)
            case ast.IfExp(_, one, other):
                return self._joined([one, other])
            case ast.Subscript(value, index):
                kind = self.infer(value)
                return kind if isinstance(index, ast.Slice) else kind.item
            case ast.List(items) | ast.Tuple(items):
                return Type("list", _kept(self._joined(items)))
        return ANY

    def _joined(self, nodes: list[ast.expr]) -> Type:
        return reduce(join, map(self.infer, nodes), UNSEEN)

    def _named_type(self, node: ast.Name | ast.Attribute) -> Type:
        """Return the type of a name of a module, or of an attribute."""
        found = self.found(node)
        if isinstance(node, ast.Attribute) and (found is None or isinstance(found.node, ast.FunctionDef)):
            return self.of_class(self.infer(node.value).name, node.attr)[0]
        if found and isinstance(found.node, ast.AnnAssign):
            return self.annotated(found.node.annotation, found.module)
        if not found or not isinstance(found.node, ast.expr):
            return ANY
        if found.node not in self.program.constants:
            self.program.constants[found.node] = ANY
            self.program.constants[found.node] = Types(self.program, found.module).infer(found.node)
        return self.program.constants[found.node]

    def _called(self, function: ast.expr, arguments: list[ast.expr]) -> Type:
        """Return the type of what a call returns."""
        found, name = self.found(function), leaf(function)
        if found and found.is_class:
            return found.kind
        if found and isinstance(found.node, ast.FunctionDef):
            return self.annotated(found.node.returns, found.module)
        if not isinstance(function, ast.Name):
            return ANY
        if name == "range":
            return Type("list", self._joined(arguments))
        if name in ("min", "max", "abs"):
            return kind if (kind := self._joined(arguments)) in NUMBERS else ANY
        return _CALLS.get(name, ANY)


@cache
def _set_in(method: ast.FunctionDef) -> frozenset[str]:
    """Return the attributes that a method assigns to."""
    attributes = (node for node in own(method.body) if isinstance(node, ast.Attribute))
    return frozenset(each.attr for each in attributes if isinstance(each.ctx, ast.Store))


def _kept(kind: Type) -> Type:
    """Return the type of an attribute or an item that begins as `kind`."""
    return {WORD: INT, NONE: ANY, UNSEEN: ANY}.get(kind, kind)


def _apart(target: ast.AST, kind: Type) -> list[tuple[ast.AST, Type]]:
    """Return each name of a target with its type."""
    if isinstance(target, ast.Starred):
        return [(target.value, ANY)]
    if not isinstance(target, ast.Tuple):
        return [(target, kind)]
    return [pair for each in target.elts for pair in _apart(each, kind.item)]


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
