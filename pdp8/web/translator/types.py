"""What is known of an expression before it runs: its type, from annotations and from what is assigned.

    word    a whole number from 0 to 2^31: JavaScript's operators of 32 bits are right for it
    int     any other whole number, exact to 2^53
    float, bool, str, bytes, bytearray; list (tuples and other sequences too), tuple (each item a type of its
            own), words (arrays of numbers), dict, set, iterable; a class by `module.Class`
    ?       nothing is known: the runtime looks when it runs

`X | None` counts as X. An attribute is an int at least, whatever it begins with.
"""

import ast
from functools import cache
from typing import TYPE_CHECKING, NamedTuple, TypeVar

if TYPE_CHECKING:
    from pdp8.web.translator.program import Found, Module, Program


K = TypeVar("K")


class Type(NamedTuple):
    """The type of an expression, and of what is in it."""

    name: str
    of: tuple["Type", ...] = ()

    @property
    def item(self) -> "Type":
        """What an iteration yields."""
        if self.name == "str":
            return self
        return self.of[0] if self.of and (self.name != "tuple" or len(set(self.of)) == 1) else ANY


ANY, NONE, UNSEEN = Type("?"), Type("None"), Type("unseen")
WORD, INT, FLOAT, BOOL, STR = Type("word"), Type("int"), Type("float"), Type("bool"), Type("str")
BYTES, BYTEARRAY, WORDS = Type("bytes", (WORD,)), Type("bytearray", (WORD,)), Type("words", (WORD,))
NUMBERS = (WORD, INT, FLOAT)
PLAIN = (*NUMBERS, BOOL, STR)
SEQUENCES = ("list", "tuple", "words", "bytes", "bytearray", "str")

_SAME, _ITEM, _VALUE = Type("same"), Type("item"), Type("value")


def by_name(table: dict[K, str]) -> dict[str, K]:
    """Return {name: kind} of {kind: names}."""
    return {name: kind for kind, names in table.items() for name in names.split()}


def list_of(item: Type) -> Type:
    """Return the type of a list."""
    return Type("list", (item,))


_PLAIN = {"int": INT, "float": FLOAT, "bool": BOOL, "str": STR, "bytes": BYTES, "bytearray": BYTEARRAY}
_GENERIC = by_name({
    "list": "list Sequence", "tuple": "tuple", "iterable": "Iterable Iterator Collection",
    "set": "set frozenset Set", "dict": "dict Mapping",
})  # fmt: skip
_ARRAY = by_name({INT: "index count", NONE: "append extend clear", _ITEM: "pop"})
_NUMBER = by_name({WORD: "bit_count bit_length"})
_PAIRS = list_of(Type("tuple", (_ITEM, _VALUE)))
METHODS = {
    "str": by_name({
        _SAME: "strip lstrip rstrip translate join replace ljust rjust removesuffix lower upper expandtabs",
        BOOL: "startswith endswith isascii isdigit isdecimal isalpha isspace", BYTES: "encode",
        INT: "find rfind count", list_of(_SAME): "split partition splitlines",
    }),
    "bytes": by_name({
        _SAME: "strip lstrip rstrip translate join", BOOL: "startswith endswith isascii isdigit",
        INT: "find rfind count", STR: "decode",
    }),
    "bytearray": _ARRAY, "list": _ARRAY, "tuple": _ARRAY, "word": _NUMBER, "int": _NUMBER,
    "words": by_name({BYTES: "tobytes"}),
    "set": by_name({NONE: "add discard update clear"}),
    "dict": by_name({
        _VALUE: "get pop setdefault", NONE: "update clear",
        list_of(_ITEM): "keys", list_of(_VALUE): "values", _PAIRS: "items",
    }),
}  # fmt: skip
"""What the methods of Python's own types return; a method that does not stand here has no translation."""
_SETTING = ast.Assign | ast.AnnAssign | ast.AugAssign | ast.NamedExpr | ast.For | ast.ExceptHandler
_CONSTANT = ast.Constant | ast.BinOp | ast.UnaryOp | ast.operator | ast.unaryop
_CLOSED = (
    ast.FunctionDef | ast.Lambda | ast.ClassDef | ast.Constant | ast.Name | ast.expr_context | ast.operator
)
_CALLS = _PLAIN | by_name({
    WORD: "len ord", INT: "round isqrt floor ceil", FLOAT: "sqrt cos sin atan copysign",
    BOOL: "isinstance any all", STR: "chr repr", WORDS: "array",
})  # fmt: skip


def leaf(node: ast.AST | None) -> str:
    """Return the last name of a dotted, called or subscripted expression, "" if it is another one."""
    if isinstance(node, ast.Subscript):
        return leaf(node.value)
    return node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""


def join(one: Type, other: Type) -> Type:
    """Return the type of what is one or the other."""
    if one == other or other in (NONE, UNSEEN):
        return one
    if one in (NONE, UNSEEN):
        return other
    if one in NUMBERS and other in NUMBERS:
        return max(one, other, key=NUMBERS.index)
    if one.name == other.name and len(one.of) == len(other.of):
        return Type(one.name, tuple(map(join, one.of, other.of)))
    return ANY


@cache
def whole(node: ast.AST | None) -> int | None:
    """Return the value of an expression of whole numbers alone, None for any other."""
    if isinstance(node, ast.BinOp | ast.UnaryOp) and all(
        isinstance(each, _CONSTANT) for each in ast.walk(node)
    ):
        try:
            value = eval(compile(ast.Expression(node), "<constant>", "eval"))
        except ArithmeticError:  # it is raised when it runs
            return None
    else:
        value = getattr(node, "value", None) if isinstance(node, ast.Constant) else None
    return value if type(value) is int else None


def _element(of: Type, index: ast.expr) -> Type:
    """Return the type of an item of a sequence or a dict."""
    if isinstance(index, ast.Slice):
        return of if of.name != "tuple" else Type("list", (of.item,))
    if of.name == "tuple" and (at := whole(index)) is not None and at < len(of.of):
        return of.of[at]
    return of.of[-1] if of.name == "dict" else of.item


def _bits(node: ast.expr) -> int:
    """Return how many bits a word has at most."""
    if (number := whole(node)) is not None:
        return number.bit_length()
    masked = isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitAnd)
    return min(_bits(node.left), _bits(node.right)) if masked else 31  # type: ignore[attr-defined]


def _arithmetic(operator: ast.operator, left: Type, right: Type, node: ast.AST) -> Type:
    """Return the type of `left operator right`."""
    match node:
        case ast.BinOp(shifted, ast.LShift(), by) if left == WORD and (places := whole(by)) is not None:
            return WORD if _bits(shifted) + places <= 31 else INT
    left, right = (INT if each == BOOL else each for each in (left, right))
    if isinstance(operator, ast.BitAnd) and WORD in (left, right):
        return WORD
    if left in NUMBERS and right in NUMBERS:
        if isinstance(operator, ast.Div) or FLOAT in (left, right):
            return FLOAT
        same = left == right == WORD and isinstance(operator, ast.BitOr | ast.BitXor | ast.Mod)
        return WORD if same or (left == WORD and isinstance(operator, ast.RShift)) else INT
    if isinstance(operator, ast.Mult) and (right in NUMBERS or left in NUMBERS):
        return left if right in NUMBERS else right
    if UNSEEN in (left, right):
        return UNSEEN
    return left if left.name in (right.name, "set") else ANY


class Types:
    """The types of expressions in one module; `scopes` are those of the functions around them."""

    def __init__(self, program: "Program", module: "Module") -> None:
        self.program = program
        self.module = module
        self.scopes: list[dict[str, Type]] = []
        self.owner = ""
        """The class whose body this is, as `module.Class`."""
        self.known: dict[ast.AST, Type] | None = None
        """The types of expressions, once those of all names are known."""

    def local(self, name: str) -> bool:
        """Tell whether a name is a function's own."""
        return any(name in scope for scope in self.scopes)

    def annotated(self, node: ast.AST | None, module: "Module | None" = None) -> Type:
        """Return the type that an annotation names."""
        module = module or self.module
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
                if name in ("Annotated", "Final", "ClassVar"):
                    return self.annotated(items[0], module)
                if name not in _GENERIC:
                    return WORDS if name in ("array", "MutableSequence") else ANY
                if isinstance(items[-1], ast.Constant) and items[-1].value is ...:
                    return list_of(self.annotated(items[0], module))
                return Type(_GENERIC[name], tuple(self.annotated(item, module) for item in items))
            case ast.Name() | ast.Attribute() if name not in _PLAIN:
                found = self.program.find(module, name)
                if found and found.is_class:
                    return found.kind
                return self.annotated(found.node, found.module) if found else ANY
        return _PLAIN.get(name, ANY)

    def of_class(self, name: str, attribute: str) -> tuple[Type, "Found | None"]:
        """Return the type of an attribute of a class, or what its method returns, and the method."""
        key = (name, attribute)
        if key not in self.program.attributes:
            self.program.attributes[key] = ANY, None
            self.program.attributes[key] = self._of_class(name, attribute)
        return self.program.attributes[key]

    def _of_class(self, name: str, attribute: str) -> tuple[Type, "Found | None"]:
        if name not in self.program.classes:
            return ANY, None
        found = self.program.classes[name]
        inner = Types(self.program, found.module)
        inner.owner = name
        for member in found.node.body:
            if isinstance(member, ast.FunctionDef) and member.name == attribute:
                return inner.annotated(member.returns), found._replace(node=member)
            if isinstance(member, ast.AnnAssign) and leaf(member.target) == attribute:
                return inner.annotated(member.annotation), None
        for method in (each for each in found.node.body if isinstance(each, ast.FunctionDef)):
            setting = [each for each in own(method.body) if isinstance(each, ast.Assign | ast.AnnAssign)]
            if not any(_sets(each, attribute) for each in own(method.body)):
                continue
            inner.scopes = [inner.parameters(method)]
            inner.learn(method.body)
            for target, kind in (pair for each in setting for pair in inner._set_by(each)):
                if _sets(target, attribute):
                    return INT if kind == WORD else kind, None
        bases = self.program.bases(found)
        return next((self.of_class(base.kind.name, attribute) for base in bases), (ANY, None))

    def parameters(self, function: ast.FunctionDef) -> dict[str, Type]:
        """Return the types of a function's parameters."""
        args = function.args
        types = {each.arg: self.annotated(each.annotation) for each in (*args.args, *args.kwonlyargs)}
        if args.vararg:
            types[args.vararg.arg] = list_of(self.annotated(args.vararg.annotation))
        if args.kwarg:
            types[args.kwarg.arg] = Type("dict", (STR, self.annotated(args.kwarg.annotation)))
        return types | {"self": Type(self.owner)} if "self" in types else types

    def learn(self, body: list[ast.stmt]) -> None:
        """Find the types of the names that a function's statements set, in the last scope."""
        scope = self.scopes[-1]
        given = set(scope)
        self.known = None
        setting = [node for node in own(body) if isinstance(node, _SETTING)]
        for _ in range(3):
            for target, kind in (pair for node in setting for pair in self._set_by(node)):
                if isinstance(target, ast.Name) and target.id not in given:
                    scope[target.id] = join(scope.get(target.id, UNSEEN), kind)
        scope.update((name, ANY) for name, kind in scope.items() if kind in (UNSEEN, NONE))
        self.known = {}

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
                return [(target, _arithmetic(operator, self.infer(target), self.infer(value), node))]
            case ast.NamedExpr(target, value):
                return [(target, self.infer(value))]
            case ast.For(target, iterable) | ast.comprehension(target, iterable):
                return _apart(target, self._yielded(iterable))
            case ast.ExceptHandler(name=str(name)):
                return [(ast.Name(name), ANY)]
        return []

    def _yielded(self, node: ast.expr) -> Type:
        """Return the type of what iterating over an expression yields."""
        match node:
            case ast.Call(ast.Name("range"), args):
                return WORD if all(self.infer(arg) == WORD for arg in args) else INT
            case ast.Call(ast.Name("enumerate"), [of, *_]):
                return Type("tuple", (WORD, self._yielded(of)))
            case ast.Call(ast.Name("zip"), args):
                return Type("tuple", tuple(map(self._yielded, args)))
        return self.infer(node).item

    def found(self, node: ast.AST) -> "Found | None":
        """Return what a name or an attribute of a module or class of ours is defined as."""
        if isinstance(node, ast.Name) and not self.local(node.id):
            return self.program.find(self.module, node.id)
        if not isinstance(node, ast.Attribute):
            return None
        of = self.found(node.value)
        if of and of.node is None:
            return self.program.find(of.module, node.attr)
        kind = of.kind if of and of.is_class else self.infer(node.value)
        return self.of_class(kind.name, node.attr)[1]

    def callee(self, function: ast.expr) -> "Found | None":
        """Return what a call calls, if it is a function, a method or a class of ours."""
        found = self.found(function)
        return found if found and isinstance(found.node, ast.FunctionDef | ast.ClassDef) else None

    def constant(self, node: ast.expr) -> int | None:
        """Return the whole number that an expression is, or a name of a module stands for."""
        found = self.found(node)
        return whole(found.node) if found else whole(node)

    def infer(self, node: ast.AST) -> Type:
        """Return the type of an expression."""
        if self.known is None:
            return self._inferred(node)
        if node not in self.known:
            self.known[node] = self._inferred(node)
        return self.known[node]

    def _inferred(self, node: ast.AST) -> Type:
        match node:
            case ast.Constant(bool()) | ast.Compare() | ast.UnaryOp(ast.Not()):
                return BOOL
            case ast.Constant() | ast.BinOp() if (number := whole(node)) is not None:
                return WORD if 0 <= number < 1 << 31 else INT
            case ast.Constant(value):
                return _PLAIN.get(type(value).__name__, NONE)
            case ast.JoinedStr():
                return STR
            case ast.UnaryOp(_, value):
                kind = self.infer(value)
                return FLOAT if kind == FLOAT else INT if kind in (WORD, INT) else ANY
            case ast.BinOp(left, operator, right):
                return _arithmetic(operator, self.infer(left), self.infer(right), node)
            case ast.BoolOp(_, values):
                return self._joined(values)
            case ast.IfExp(_, one, other):
                return self._joined([one, other])
            case ast.NamedExpr(_, value):
                return self.infer(value)
            case ast.Starred(value):
                return self.infer(value).item
            case ast.Name(name) if self.local(name):
                return next(scope[name] for scope in reversed(self.scopes) if name in scope)
            case ast.Name() | ast.Attribute():
                return self._named_type(node)
            case ast.Subscript(value, index):
                return _element(self.infer(value), index)
            case ast.Tuple(items) if not any(isinstance(item, ast.Starred) for item in items):
                return Type("tuple", tuple(map(self.infer, items)))
            case ast.List(items) | ast.Tuple(items):
                kind = self._joined(items)
                return list_of(INT if kind == WORD else ANY if kind == UNSEEN else kind)
            case ast.Dict():
                return Type("dict", (ANY, ANY))
            case ast.Set() | ast.SetComp():
                return Type("set", (ANY,))
            case ast.DictComp(key, value, generators):
                return Type("dict", self._within([key, value], generators))
            case ast.ListComp(value, generators) | ast.GeneratorExp(value, generators):
                return Type("list", self._within([value], generators))
            case ast.Call(function, arguments):
                return self._called(function, arguments)
        return ANY

    def _joined(self, nodes: list[ast.expr]) -> Type:
        kind = UNSEEN
        for node in nodes:
            kind = join(kind, self.infer(node))
        return kind

    def _within(self, values: list[ast.expr], generators: list[ast.comprehension]) -> tuple[Type, ...]:
        """Return the types of expressions within a comprehension."""
        self.scopes.append({})
        for generator in generators:
            self.bind(generator)
        kinds = [self.infer(value) for value in values]
        self.scopes.pop()
        return tuple(INT if kind == WORD else kind for kind in kinds)

    def bind(self, generator: ast.comprehension) -> None:
        """Enter the names that a comprehension's `for` sets in the last scope."""
        for target, kind in self._set_by(generator):
            self.scopes[-1][leaf(target)] = kind

    def _named_type(self, node: ast.Name | ast.Attribute) -> Type:
        """Return the type of a name of a module, or of an attribute."""
        found = self.found(node)
        if isinstance(node, ast.Attribute) and (found is None or isinstance(found.node, ast.FunctionDef)):
            of = self.found(node.value)
            if of and of.is_class and of.kind in (INT, STR):
                return of.kind
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
        name = leaf(function)
        if isinstance(function, ast.Attribute) and (owner := self.infer(function.value)).name in METHODS:
            return _returned(owner, METHODS[owner.name].get(name, ANY))
        if found := self.callee(function):
            return found.kind if found.is_class else self.annotated(found.node.returns, found.module)
        match name, arguments:
            case "fromkeys", [_, value]:
                return Type("dict", (ANY, self.infer(value)))
            case (("replace" | "_replace"), _):
                return self.infer(arguments[0] if arguments else function.value)  # type: ignore[attr-defined]
            case (("min" | "max"), [_, _, *_]):
                return self._joined(arguments)
            case (("min" | "max"), [of]):
                return self._yielded(of)
            case "sum", [of, *_]:
                return INT if (kind := self._yielded(of)) in (WORD, BOOL) else kind
            case "abs", [of]:
                return INT if (kind := self.infer(of)) == WORD else kind
            case (("list" | "tuple" | "sorted" | "reversed" | "iter"), [of]):
                return list_of(self._yielded(of))
            case (("set" | "frozenset"), [of]):
                return Type("set", (self._yielded(of),))
            case "dict", [of]:
                return self.infer(of)
        return _CALLS.get(name, ANY)


def _returned(owner: Type, kind: Type) -> Type:
    """Return what a method of one of Python's own types returns, where `kind` is said of it."""
    if kind == _SAME:
        return owner
    if kind in (_ITEM, _VALUE):
        return owner.item if kind == _ITEM else owner.of[-1]
    return Type(kind.name, tuple(_returned(owner, each) for each in kind.of))


def _sets(node: ast.AST, attribute: str) -> bool:
    """Tell whether a node is an attribute of this name that is assigned to."""
    return isinstance(node, ast.Attribute) and node.attr == attribute and isinstance(node.ctx, ast.Store)


def _apart(target: ast.AST, kind: Type) -> list[tuple[ast.AST, Type]]:
    """Return each name of a target with its type."""
    if isinstance(target, ast.Starred):
        return [(target.value, list_of(ANY))]
    if not isinstance(target, ast.Tuple):
        return [(target, kind)]
    fixed = kind.name == "tuple" and len(kind.of) == len(target.elts)
    items = kind.of if fixed else (kind.item,) * len(target.elts)
    return [pair for each, item in zip(target.elts, items, strict=True) for pair in _apart(each, item)]


def own(body: list[ast.stmt]) -> list[ast.AST]:
    """Return all nodes of these statements but those of functions and classes inside."""
    return [part for node in body for part in _own(node)]


@cache
def _own(node: ast.AST) -> list[ast.AST]:
    inside = [] if isinstance(node, _CLOSED) else ast.iter_child_nodes(node)
    return [node, *(part for each in inside for part in _own(each))]
