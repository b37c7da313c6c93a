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
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from pdp8.web.translator.modules import Found, Module, Program

    Callee = tuple[Module, ast.FunctionDef | ast.ClassDef]


class Type(NamedTuple):
    """The type of an expression, and of what is in it."""

    name: str
    of: tuple["Type", ...] = ()

    @property
    def item(self) -> "Type":
        """What an iteration yields."""
        return self.of[0] if self.of and (self.name != "tuple" or len(set(self.of)) == 1) else ANY


ANY, NONE, UNSEEN = Type("?"), Type("None"), Type("unseen")
WORD, INT, FLOAT, BOOL, STR = Type("word"), Type("int"), Type("float"), Type("bool"), Type("str")
BYTES, BYTEARRAY, WORDS = Type("bytes", (WORD,)), Type("bytearray", (WORD,)), Type("words", (WORD,))
NUMBERS = (WORD, INT, FLOAT)
PLAIN = (*NUMBERS, BOOL, STR)
SEQUENCES = ("list", "tuple", "words", "bytes", "bytearray", "str")

_ANNOTATIONS = {"int": INT, "float": FLOAT, "bool": BOOL, "str": STR, "bytes": BYTES, "bytearray": BYTEARRAY}
_GENERIC = {
    **dict.fromkeys(("list", "Sequence"), "list"),
    **dict.fromkeys(("set", "frozenset", "Set"), "set"),
    **dict.fromkeys(("dict", "Mapping", "Counter"), "dict"),
    **dict.fromkeys(("Iterable", "Iterator", "Collection"), "iterable"),
    **dict.fromkeys(("array", "MutableSequence"), "words"),
}
_TEXTS = Type("list", (STR,))

# What the methods of Python's own types return; a method that does not stand here has no translation.
_TEXT_AND_BYTES = {
    "same": "strip lstrip rstrip replace translate join ljust rjust removesuffix removeprefix lower upper",
    "int": "find rfind index rindex count",
    "bool": "startswith endswith isalnum isascii isdigit isdecimal isalpha isspace islower isprintable",
    "list same": "split partition splitlines",
}
_SEQUENCE = {"int": "index count", "None": "append extend insert clear remove reverse sort", "item": "pop"}
METHODS: dict[str, dict[str, str]] = {
    "str": {**_TEXT_AND_BYTES, "bytes": "encode", "same": _TEXT_AND_BYTES["same"] + " expandtabs"},
    "bytes": {**_TEXT_AND_BYTES, "str": "decode hex", "bytes": "tobytes"},
    "bytearray": {**_SEQUENCE, "int": "find index count"},
    "words": {"bytes": "tobytes", "list": "tolist"},
    "list": {**_SEQUENCE, "same": "copy"},
    "tuple": {"int": "index count"},
    "set": {"None": "add discard remove clear update", "bool": "isdisjoint issubset", "item": "pop",
            "same": "union"},
    "dict": {"value": "get pop setdefault", "list item": "keys", "list value": "values", "pairs": "items",
             "None": "update clear"},
    "word": {"word": "bit_count bit_length"},
    "int": {"word": "bit_count bit_length"},
    "float": {"bool": "is_integer"},
}  # fmt: skip
_CALLS = {
    **dict.fromkeys(("len", "ord"), WORD),
    **dict.fromkeys(("int", "round", "isqrt"), INT),
    **dict.fromkeys(("float", "dist", "hypot", "sqrt", "cos", "sin", "copysign", "fsum"), FLOAT),
    **dict.fromkeys(("bool", "isinstance", "any", "all", "hasattr", "callable"), BOOL),
    **dict.fromkeys(("str", "chr", "repr", "format"), STR),
    **{"bytes": BYTES, "bytearray": BYTEARRAY, "array": WORDS, "floor": INT, "ceil": INT},
}


def leaf(node: ast.AST | None) -> str:
    """Return the last name of a dotted or subscripted expression, "" if it is another one."""
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


def whole(node: ast.AST) -> int | None:
    """Return the value of an expression of whole numbers alone, None for any other."""
    if isinstance(node, ast.Constant | ast.Name | ast.Attribute | ast.Call | ast.Subscript):
        value = getattr(node, "value", None)
        return value if isinstance(node, ast.Constant) and type(value) is int else None
    allowed = (ast.BinOp, ast.UnaryOp, ast.Constant, ast.operator, ast.unaryop)
    if not isinstance(node, ast.expr) or not all(isinstance(each, allowed) for each in ast.walk(node)):
        return None
    try:
        value = eval(compile(ast.Expression(node), "<constant>", "eval"))
    except ArithmeticError:
        return None
    return value if type(value) is int else None


def element(of: Type, index: ast.expr) -> Type:
    """Return the type of an item of a sequence or a dict."""
    if isinstance(index, ast.Slice):
        return of if of.name != "tuple" else Type("list", (of.item,))
    if of.name == "tuple" and isinstance(number := whole(index), int) and number < len(of.of):
        return of.of[number]
    if of.name == "dict":
        return of.of[1] if len(of.of) == 2 else ANY
    return STR if of == STR else of.item


def bits(node: ast.expr) -> int:
    """Return how many bits a word has at most."""
    if (number := whole(node)) is not None:
        return number.bit_length()
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.BitAnd):
        return min(bits(node.left), bits(node.right))
    return 31


def arithmetic(operator: ast.operator, left: Type, right: Type, node: ast.BinOp | ast.AugAssign) -> Type:
    """Return the type of `left operator right`."""
    places = whole(node.right) if isinstance(operator, ast.LShift) and isinstance(node, ast.BinOp) else None
    if places is not None and left == WORD and bits(node.left) + places <= 31:  # type: ignore[union-attr]
        return WORD
    left, right = (INT if each == BOOL else each for each in (left, right))
    if isinstance(operator, ast.BitAnd) and WORD in (left, right):
        return WORD
    if left in NUMBERS and right in NUMBERS:
        if isinstance(operator, ast.Div) or FLOAT in (left, right):
            return FLOAT
        same = left == right == WORD and isinstance(operator, ast.BitOr | ast.BitXor | ast.RShift | ast.Mod)
        return WORD if same or (left == WORD and isinstance(operator, ast.RShift)) else INT
    if isinstance(operator, ast.Mult) and (right in NUMBERS or left in NUMBERS):
        return left if right in NUMBERS else right
    if isinstance(operator, ast.Mod) and left == STR:
        return STR
    known = UNSEEN not in (left, right)
    return left if left.name == right.name else UNSEEN if not known else left if left.name == "set" else ANY


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

    def annotated(self, node: ast.AST | None, module: "Module | None" = None) -> Type:
        """Return the type that an annotation names."""
        module = module or self.module
        match node:
            case ast.Constant(str(text)):
                return self.annotated(ast.parse(text, mode="eval").body, module)
            case ast.Constant(None):
                return NONE
            case ast.BinOp(left, ast.BitOr(), right):
                return join(self.annotated(left, module), self.annotated(right, module))
            case ast.Name(name) if name in _ANNOTATIONS:
                return _ANNOTATIONS[name]
            case ast.Subscript(base, ast.Tuple([*items])) if leaf(base) in ("tuple", "dict", "Mapping"):
                of = tuple(self.annotated(item, module) for item in items)
                if leaf(base) != "tuple":
                    return Type("dict", of)
                return Type("list", of[:1]) if isinstance(items[-1], ast.Constant) else Type("tuple", of)
            case ast.Subscript(base, ast.Tuple([first, *_])) if leaf(base) == "Annotated":
                return self.annotated(first, module)
            case ast.Subscript(base, item) if leaf(base) in ("Final", "ClassVar"):
                return self.annotated(item, module)
            case ast.Subscript(base, item) if leaf(base) in _GENERIC:
                name = _GENERIC[leaf(base)]
                return WORDS if name == "words" else Type(name, (self.annotated(item, module),))
            case ast.Name(name) | ast.Attribute(attr=name):
                found = self.program.find(module, name)
                if found and isinstance(found[1], ast.ClassDef):
                    return self.program.kind(found[0], found[1])
                if found and isinstance(found[1], ast.expr):
                    return self.annotated(found[1], found[0])
        return ANY

    def of_class(self, name: str, attribute: str) -> tuple[Type, ast.FunctionDef | None]:
        """Return the type of an attribute of a class, or what its method returns, and the method."""
        key = (name, attribute)
        if key not in self.program.attributes:
            self.program.attributes[key] = ANY, None
            self.program.attributes[key] = self._of_class(name, attribute)
        return self.program.attributes[key]

    def _of_class(self, name: str, attribute: str) -> tuple[Type, ast.FunctionDef | None]:
        if name not in self.program.classes:
            return ANY, None
        module, node = self.program.classes[name]
        for member in node.body:
            if isinstance(member, ast.FunctionDef) and member.name == attribute:
                return self.annotated(member.returns, module), member
            if isinstance(member, ast.AnnAssign) and leaf(member.target) == attribute:
                return self.annotated(member.annotation, module), None
        found = self._assigned_in(name, attribute)
        if found != UNSEEN:
            return (INT if found == WORD else found), None
        for base in node.bases:
            kind = self.annotated(base, module)
            if kind.name in self.program.classes:
                return self.of_class(kind.name, attribute)
        return ANY, None

    def _assigned_in(self, name: str, attribute: str) -> Type:
        """Return the type of what the methods of a class first assign to an attribute."""
        module, node = self.program.classes[name]
        inner = Types(self.program, module)
        inner.owner = name
        for method in (each for each in node.body if isinstance(each, ast.FunctionDef)):
            inner.scopes = [inner.parameters(method)]
            for part in ast.walk(method):
                match part:
                    case ast.AnnAssign(ast.Attribute(ast.Name("self"), attr), annotation) if (
                        attr == attribute
                    ):
                        return inner.annotated(annotation)
                    case ast.Assign(targets) if any(
                        isinstance(each, ast.Attribute)
                        and isinstance(each.ctx, ast.Store)
                        and each.attr == attribute
                        for target in targets
                        for each in ast.walk(target)
                    ):
                        inner.learn(method.body)
                        pairs = [
                            (target, kind)
                            for target, kind in inner._set_by(part)
                            if leaf(target) == attribute
                        ]
                        return pairs[0][1] if pairs else ANY
        return UNSEEN

    def parameters(self, function: ast.FunctionDef) -> dict[str, Type]:
        """Return the types of a function's parameters."""
        args = function.args
        types = {each.arg: self.annotated(each.annotation) for each in (*args.posonlyargs, *args.args)}
        types |= {each.arg: self.annotated(each.annotation) for each in args.kwonlyargs}
        if args.vararg:
            types[args.vararg.arg] = Type("list", (self.annotated(args.vararg.annotation),))
        if args.kwarg:
            types[args.kwarg.arg] = Type("dict", (STR, self.annotated(args.kwarg.annotation)))
        if "self" in types:
            types["self"] = Type(self.owner)
        return types

    def learn(self, body: list[ast.stmt]) -> None:
        """Find the types of the names that a function's statements set, in the last scope."""
        scope = self.scopes[-1]
        given = set(scope)
        self.known = None
        setting = [node for node in own(body) if isinstance(node, _SETTING)]
        for _ in range(3):
            for node in setting:
                for target, kind in self._set_by(node):
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
                kind = self.infer(value)
                return [pair for target in targets for pair in self._apart(target, kind)]
            case ast.AnnAssign(target, annotation):
                return [(target, self.annotated(annotation))]
            case ast.AugAssign(target, operator, value):
                return [(target, arithmetic(operator, self.infer(target), self.infer(value), node))]
            case ast.NamedExpr(target, value):
                return [(target, self.infer(value))]
            case ast.For(target, iterable) | ast.comprehension(target, iterable):
                return self._apart(target, self.yielded(iterable))
            case ast.ExceptHandler(name=str(name)) | ast.MatchAs(name=str(name)):
                return [(ast.Name(name), ANY)]
            case ast.withitem(_, ast.Name() as target):
                return [(target, ANY)]
        return []

    def _apart(self, target: ast.AST, kind: Type) -> list[tuple[ast.AST, Type]]:
        """Return each name of a target with its type."""
        if isinstance(target, ast.Starred):
            return [(target.value, Type("list", (ANY,)))]
        if not isinstance(target, ast.Tuple):
            return [(target, kind)]
        fixed = kind.name == "tuple" and len(kind.of) == len(target.elts)
        items = kind.of if fixed else self.fields(kind) or (kind.item,) * len(target.elts)
        return [
            pair for each, item in zip(target.elts, items, strict=False) for pair in self._apart(each, item)
        ]

    def fields(self, kind: Type) -> tuple[Type, ...]:
        """Return the types of a named tuple's fields; () for any other type."""
        if kind.name not in self.program.classes:
            return ()
        module, node = self.program.classes[kind.name]
        named = any(leaf(base) == "NamedTuple" for base in node.bases)
        members = [each for each in node.body if isinstance(each, ast.AnnAssign)]
        return tuple(self.annotated(each.annotation, module) for each in members) if named else ()

    def yielded(self, node: ast.expr) -> Type:
        """Return the type of what iterating over an expression yields."""
        match node:
            case ast.Call(ast.Name("range"), args):
                return (
                    WORD if all((whole(arg) or 0) >= 0 and self.infer(arg) == WORD for arg in args) else INT
                )
            case ast.Call(ast.Name("enumerate"), [of, *_]):
                return Type("tuple", (WORD, self.yielded(of)))
            case ast.Call(ast.Name("zip"), args):
                return Type("tuple", tuple(self.yielded(arg) for arg in args))
            case ast.Call(ast.Name("pairwise"), [of]):
                return Type("tuple", (self.yielded(of),) * 2)
            case ast.Call(ast.Name("reversed" | "iter" | "sorted"), [of, *_]):
                return self.yielded(of)
        kind = self.infer(node)
        return STR if kind == STR else kind.item

    def name(self, name: str) -> Type:
        """Return the type of a name."""
        for scope in reversed(self.scopes):
            if name in scope:
                return scope[name]
        found = self.program.find(self.module, name)
        if found and isinstance(found[1], ast.expr):
            key = (found[0].name, name)
            if key not in self.program.constants:
                self.program.constants[key] = ANY
                self.program.constants[key] = Types(self.program, found[0]).infer(found[1])
            return self.program.constants[key]
        if found and isinstance(found[1], ast.AnnAssign):
            return self.annotated(found[1].annotation, found[0])
        return ANY

    def infer(self, node: ast.AST | None) -> Type:
        """Return the type of an expression."""
        if self.known is None or node is None:
            return self._inferred(node)
        if node not in self.known:
            self.known[node] = self._inferred(node)
        return self.known[node]

    def _inferred(self, node: ast.AST | None) -> Type:
        match node:
            case ast.Constant(bool()):
                return BOOL
            case ast.Constant(int(value)):
                return WORD if 0 <= value < 1 << 31 else INT
            case ast.Constant(value):
                return _ANNOTATIONS.get(type(value).__name__, NONE if value is None else ANY)
            case ast.JoinedStr():
                return STR
            case ast.Compare() | ast.UnaryOp(ast.Not()):
                return BOOL
            case ast.UnaryOp(_, value):
                kind = self.infer(value)
                return FLOAT if kind == FLOAT else INT if kind in (WORD, INT) else ANY
            case ast.BinOp() if (number := whole(node)) is not None:
                return WORD if 0 <= number < 1 << 31 else INT
            case ast.BinOp(left, operator, right):
                return arithmetic(operator, self.infer(left), self.infer(right), node)
            case ast.BoolOp(_, values):
                kind = UNSEEN
                for value in values:
                    kind = join(kind, self.infer(value))
                return kind
            case ast.IfExp(_, one, other):
                return join(self.infer(one), self.infer(other))
            case ast.NamedExpr(_, value) | ast.Starred(value):
                return self.infer(value)
            case ast.Name(name):
                return self.name(name)
            case ast.Attribute(value, name):
                return self._attribute(value, name)
            case ast.Subscript(value, index):
                kind = self.infer(value)
                if (number := whole(index)) is not None and (fields := self.fields(kind)):
                    return fields[number]
                return element(kind, index)
            case ast.List(items) | ast.Tuple(items):
                kinds = tuple(self.infer(item) for item in items)
                if isinstance(node, ast.Tuple) and not any(isinstance(item, ast.Starred) for item in items):
                    return Type("tuple", kinds)
                kind = UNSEEN
                for each, item in zip(kinds, items, strict=True):
                    kind = join(kind, each.item if isinstance(item, ast.Starred) else each)
                return Type("list", (INT if kind == WORD else ANY if kind == UNSEEN else kind,))
            case ast.Dict():
                return Type("dict", (ANY, ANY))
            case ast.Set() | ast.SetComp():
                return Type("set", (ANY,))
            case ast.DictComp(key, value, generators):
                return Type("dict", (self._within(key, generators), self._within(value, generators)))
            case ast.ListComp(value, generators) | ast.GeneratorExp(value, generators):
                return Type("list", (self._within(value, generators),))
            case ast.Call(function, arguments):
                return self._called(function, arguments)
        return ANY

    def constant(self, node: ast.expr) -> int | None:
        """Return the whole number that an expression is, or a name of a module stands for."""
        if isinstance(node, ast.Name) and not any(node.id in scope for scope in self.scopes):
            found = self.program.find(self.module, node.id)
            return whole(found[1]) if found and found[1] is not None else None
        return whole(node)

    def _within(self, value: ast.expr, generators: list[ast.comprehension]) -> Type:
        """Return the type of an expression within a comprehension."""
        self.scopes.append({})
        for generator in generators:
            self.bind(generator)
        kind = self.infer(value)
        self.scopes.pop()
        return INT if kind == WORD else kind

    def bind(self, generator: ast.comprehension) -> None:
        """Enter what a comprehension's `for` sets in the last scope."""
        for target, kind in self._set_by(generator):
            self.scopes[-1][leaf(target)] = kind

    def _attribute(self, value: ast.expr, name: str) -> Type:
        if isinstance(value, ast.Name):
            found = self.program.find(self.module, value.id)
            if found and found[1] is None and not any(value.id in scope for scope in self.scopes):
                return Types(self.program, found[0]).name(name)
            if found and isinstance(found[1], ast.ClassDef) and self.program.is_enum(found[1]):
                return self.program.kind(found[0], found[1])
        kind = self.infer(value)
        if kind.name == "words" and name == "itemsize":
            return WORD
        return self.of_class(kind.name, name)[0]

    def _called(self, function: ast.expr, arguments: list[ast.expr]) -> Type:
        """Return the type of what a call returns."""
        name = leaf(function)
        if isinstance(function, ast.Attribute):
            if function.attr == "fromkeys":
                return Type("dict", (ANY, self.infer(arguments[1]) if len(arguments) > 1 else ANY))
            owner = self.infer(function.value)
            if owner.name in METHODS:
                return self._method(owner, name)
            kind, method = self.of_class(owner.name, name)
            if method is not None:
                return kind
        found = self.callee(function)
        if found:
            module, node = found
            if isinstance(node, ast.ClassDef):
                return self.program.kind(module, node)
            return self.annotated(node.returns, module)
        if isinstance(function, ast.Name) and name in ("min", "max", "sum", "abs"):
            if len(arguments) > 1 and name != "sum":
                kinds = [self.infer(argument) for argument in arguments]
                return join(kinds[0], kinds[1]) if kinds[0] != WORD or len(kinds) < 3 else INT
            kind = self.infer(arguments[0]) if name == "abs" else self.yielded(arguments[0])
            return INT if kind in (WORD, BOOL) and name in ("sum", "abs") else kind
        if name in ("list", "tuple", "sorted", "reversed", "set", "frozenset"):
            kind = self.yielded(arguments[0]) if arguments else ANY
            return Type("set" if "set" in name else "list", (kind,))
        if name == "dict":
            return self.infer(arguments[0]) if arguments else Type("dict", (ANY, ANY))
        if name == "cast":
            return self.annotated(arguments[0])
        if name in ("replace", "_replace"):
            return self.infer(arguments[0] if arguments else getattr(function, "value", None))
        return _CALLS.get(name, ANY)

    def _method(self, owner: Type, name: str) -> Type:
        """Return what a method of one of Python's own types returns."""
        value = owner.of[1] if owner.name == "dict" and len(owner.of) == 2 else ANY
        same = Type("list", (owner,))
        meant = {"same": owner, "item": owner.item, "value": value, "list same": same, "None": NONE}
        meant |= {"list item": Type("list", (owner.item,)), "list value": Type("list", (value,))}
        meant |= {"pairs": Type("list", (Type("tuple", (owner.item, value)),)), "list": Type("list", (INT,))}
        meant |= {"int": INT, "word": WORD, "bool": BOOL, "bytes": BYTES, "str": STR}
        return next(
            (meant[kind] for kind, names in METHODS[owner.name].items() if name in names.split()), ANY
        )

    def callee(self, function: ast.expr) -> "Callee | None":
        """Return what a call calls, with its module: a function, a method or a class of ours."""
        if isinstance(function, ast.Attribute):
            if isinstance(function.value, ast.Name) and not any(function.value.id in s for s in self.scopes):
                found = self.program.find(self.module, function.value.id)
                if found and found[1] is None:
                    found = self.program.find(found[0], function.attr)
                    return _callable(found)
                if found and isinstance(found[1], ast.ClassDef):
                    owner = f"{found[0].name}.{found[1].name}"
                    method = self.of_class(owner, function.attr)[1]
                    return (found[0], method) if method else None
            owner = self.infer(function.value).name
            method = self.of_class(owner, function.attr)[1]
            return (self.program.classes[owner][0], method) if method else None
        if isinstance(function, ast.Name):
            if function.id == "cls" and self.owner:
                return self.program.classes[self.owner]
            if not any(function.id in scope for scope in self.scopes):
                found = self.program.find(self.module, function.id)
                return _callable(found)
        return None


def _callable(found: "Found | None") -> "Callee | None":
    if found is None or not isinstance(found.node, ast.FunctionDef | ast.ClassDef):
        return None
    return found.module, found.node


def own(body: list[ast.stmt]) -> tuple[ast.AST, ...]:
    """Return all nodes of these statements but those of functions and classes inside."""
    return _own(*body)


@cache
def _own(*body: ast.AST) -> tuple[ast.AST, ...]:
    found: list[ast.AST] = []
    todo = list(reversed(body))
    while todo:
        node = todo.pop()
        found.append(node)
        if not isinstance(node, ast.FunctionDef | ast.Lambda | ast.ClassDef | ast.Constant | ast.Name):
            todo += reversed(list(ast.iter_child_nodes(node)))
    return tuple(each for each in found if not isinstance(each, ast.expr_context | ast.operator | ast.cmpop))


_SETTING = (
    ast.Assign,
    ast.AnnAssign,
    ast.AugAssign,
    ast.NamedExpr,
    ast.For,
    ast.ExceptHandler,
    ast.MatchAs,
    ast.withitem,
)
