"""All modules that are translated: what each defines and imports, and where a name leads."""

import ast
import re
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.resources import files
from typing import Any, NamedTuple

from pdp8.web.translator.types import Type, leaf

_CLOSED = (
    ast.FunctionDef | ast.Lambda | ast.ClassDef | ast.Constant | ast.Name | ast.expr_context | ast.operator
)


class Untranslated(Exception):
    """A construct that has no translation, with its file and line."""


class Parameter(NamedTuple):
    """A parameter of a function, or a field as a parameter of its record's constructor."""

    name: str
    annotation: ast.expr | None
    default: ast.expr | None
    module: "Module"
    how: str = ""
    """"/" by place only, "*" all further places, "key" by name only, "**" all further names."""


class Found(NamedTuple):
    """What a name means: the module that defines it, and the defining statement there; None for a module."""

    module: "Module"
    node: Any

    @property
    def ours(self) -> bool:
        """Whether it is defined in a module that is translated, not in the table of Python's own."""
        return not self.module.table

    @property
    def is_module(self) -> bool:
        """Whether it is a module."""
        return self.node is None

    @property
    def is_class(self) -> bool:
        """Whether it is a class."""
        return isinstance(self.node, ast.ClassDef)

    @property
    def is_function(self) -> bool:
        """Whether it is a function or a method."""
        return isinstance(self.node, ast.FunctionDef)

    @property
    def is_tuple(self) -> bool:
        """Whether it is a named tuple."""
        return "NamedTuple" in self.marks

    @property
    def is_enum(self) -> bool:
        """Whether it is an enumeration."""
        return self.is_class and not {"StrEnum", "IntEnum"}.isdisjoint(self.marks)

    @property
    def is_property(self) -> bool:
        """Whether it is a method that is read as an attribute."""
        return not {"property", "cached_property"}.isdisjoint(self.marks)

    @property
    def is_frozen(self) -> bool:
        """Whether the fields of an instance cannot be set."""
        return self.is_tuple or "frozen=True" in "".join(map(ast.unparse, self.node.decorator_list))

    @property
    def is_static(self) -> bool:
        """Whether it is a static method."""
        return "staticmethod" in self.marks

    @property
    def marks(self) -> frozenset[str]:
        """The names of its decorators and base classes."""
        return _marks(self.node)

    @property
    def kind(self) -> Type:
        """The type of a class's instances."""
        return Type(f"{self.module.name}.{self.node.name}" if self.ours else self.node.name)

    @property
    def fields(self) -> list[ast.AnnAssign] | None:
        """The fields of a named tuple or dataclass; None for any other class."""
        if {"dataclass", "NamedTuple"}.isdisjoint(self.marks):
            return None
        noted = (each for each in self.node.body if isinstance(each, ast.AnnAssign))
        return [each for each in noted if leaf(each.annotation) != "ClassVar"]

    @property
    def declared(self) -> dict[str, ast.stmt]:
        """The names that the body of a class defines: {name: statement}."""
        return _declared(self.node)

    @property
    def members(self) -> frozenset[str]:
        """The names that a class itself has: those of its body, and the attributes that its methods set."""
        return _members(self.node)

    @property
    def parameters(self) -> list[Parameter]:
        """The parameters of a function, self among them."""
        return _parameters(self)


@cache
def _marks(node: ast.AST) -> frozenset[str]:
    marks = [getattr(each, "func", each) for each in getattr(node, "decorator_list", ())]
    return frozenset(map(leaf, [*marks, *getattr(node, "bases", ())]))


@cache
def _parameters(of: Found) -> list[Parameter]:
    args = of.node.args
    places = [*(("/", each) for each in args.posonlyargs), *(("", each) for each in args.args)]
    defaults = [*[None] * (len(places) - len(args.defaults)), *args.defaults]
    found = [(how, each, default) for (how, each), default in zip(places, defaults, strict=True)]
    keys = zip(args.kwonlyargs, args.kw_defaults, strict=True)
    found += [("*", args.vararg, None), *(("key", *each) for each in keys), ("**", args.kwarg, None)]
    own = ((how, each, default) for how, each, default in found if each)
    return [Parameter(each.arg, each.annotation, default, of.module, how) for how, each, default in own]


def targets(node: ast.AST) -> list[str]:
    """Return the names that a statement of a class or a module sets."""
    return [*map(leaf, [node.target] if isinstance(node, ast.AnnAssign) else getattr(node, "targets", []))]


@cache
def _declared(node: ast.ClassDef) -> dict[str, ast.stmt]:
    found: dict[str, ast.stmt] = {}
    for part in node.body:
        for name in [part.name] if isinstance(part, ast.FunctionDef) else targets(part):
            found.setdefault(name, part)
    return found


@cache
def _members(node: ast.ClassDef) -> frozenset[str]:
    methods = (part for part in node.body if isinstance(part, ast.FunctionDef))
    return frozenset(_declared(node)).union(*map(set_in, methods))


@cache
def set_in(method: ast.FunctionDef) -> frozenset[str]:
    """Return the attributes that a method assigns to."""
    attributes = (node for node in own(method.body) if isinstance(node, ast.Attribute))
    return frozenset(each.attr for each in attributes if isinstance(each.ctx, ast.Store))


def _first_set(node: ast.ClassDef) -> list[ast.AST]:
    """Return the attributes that `__init__` sets."""
    body = getattr(_declared(node).get("__init__"), "body", [])
    return [each for each in own(body) if leaf(getattr(each, "value", None)) == "self"]


def own(body: Iterable[ast.AST]) -> list[ast.AST]:
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


class Module:
    """One module's syntax tree, what it defines and what it imports."""

    def __init__(self, name: str, path: str, text: str, omitted: Iterable[str]) -> None:
        self.name = name
        self.path = path
        self.tree = ast.parse(text)
        self.table = ""
        """The name of a module of Python's library, of which this is what may be used."""
        self.omitted = frozenset(omitted)
        self.defined: dict[str, ast.AST] = {}
        self.imports: dict[str, tuple[str, str]] = {}
        """{name: (module, its name there)}; "" is the module itself."""
        within = re.search(r"^ +(from|import) ", text, re.MULTILINE)  # functions have imports too
        for node in ast.walk(self.tree) if within else self.tree.body:
            if isinstance(node, ast.ImportFrom):
                source = node.module or ""
                self.imports |= {each.asname or each.name: (source, each.name) for each in node.names}
            elif isinstance(node, ast.Import):
                self.imports |= {each.name: (each.name, "") for each in node.names}
        for node in self.tree.body:
            self._define(node)
        for left_out in self.omitted:
            self.defined.pop(left_out, None)

    def _define(self, node: ast.stmt) -> None:
        match node:
            case ast.FunctionDef(name) | ast.ClassDef(name):
                self.defined[name] = node
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)):
                self.defined |= {leaf(target): value for target, value in zip(targets, values, strict=True)}
            case ast.Assign([ast.Name(name)], value):
                if name in self.defined:
                    raise Untranslated(f"{self.path}:{node.lineno}: {name} is set twice")
                self.defined[name] = value
            case ast.AnnAssign(ast.Name(name), _, ast.expr()):
                self.defined[name] = node
            case (
                ast.Expr(ast.Constant()) | ast.Import() | ast.ImportFrom() | ast.If(ast.Name("TYPE_CHECKING"))
            ):
                pass
            case _:
                raise Untranslated(f"{self.path}:{node.lineno}: no translation: {ast.unparse(node)[:80]}")


class Library(Module):
    """What may be used of one module of Python's library."""

    def __init__(self, name: str, body: list[ast.stmt]) -> None:
        super().__init__(name, name, "", ())
        self.table = name
        self.tree.body = body
        for node in body:
            assert isinstance(node, ast.FunctionDef | ast.ClassDef)
            if not isinstance(self.defined.get(node.name), ast.FunctionDef):
                self.defined[node.name] = node


@cache
def libraries() -> dict[str, Library]:
    """Return what may be used of the modules of Python's library, {name: module}."""
    body = ast.parse(files(__package__).joinpath("library.pyi").read_text(encoding="utf-8")).body
    found = {"builtins": [each for each in body if not isinstance(each, ast.If)]}
    for each in body:
        if isinstance(each, ast.If):
            found[each.test.comparators[0].value] = each.body  # type: ignore[attr-defined]
    return {name: Library(name, nodes) for name, nodes in found.items()}


class Program:
    """All modules that are translated."""

    def __init__(self, modules: Iterable[Module]) -> None:
        self.modules = {module.name: module for module in modules}
        self.library = libraries()
        classes = (
            Found(module, node)
            for module in (*self.library.values(), *self.modules.values())
            for node in module.tree.body
            if isinstance(node, ast.ClassDef) and node.name not in module.omitted
        )
        self.classes = {each.kind.name: each for each in classes}
        self.protocols = frozenset(each.kind for each in self.classes.values() if "Protocol" in each.marks)
        self.annotations: dict[tuple[ast.AST, str, str], Type] = {}
        self.attributes: dict[tuple[str, str], tuple[Type, Found | None]] = {}
        self.constants: dict[ast.AST, Type] = {}
        self.fitting: dict[tuple[Type, Type], bool] = {}
        self.overloaded: dict[ast.AST, list[Found]] = {}
        bases = (leaf(base) for found in self.classes.values() for base in found.node.bases)
        self.inherited = frozenset(bases)
        """The names of all classes that others are made from."""
        trees = [module.tree for module in self.modules.values()]
        first = {part for found in self.classes.values() for part in _first_set(found.node)}
        self.rebound = frozenset(
            each.attr
            for tree in trees
            for each in ast.walk(tree)
            if isinstance(each, ast.Attribute) and not isinstance(each.ctx, ast.Load) and each not in first
        )
        """The attributes that may be set again after they have been set by `__init__`."""

    def find(self, module: Module, name: str) -> Found | None:
        """Return where a name leads from a module; None if it leaves the modules that are translated."""
        if name in module.defined:
            return Found(module, module.defined[name])
        if name not in module.imports:
            builtins = self.library["builtins"]
            return Found(builtins, builtins.defined[name]) if name in builtins.defined else None
        source, real = module.imports[name]
        whole = f"{source}.{real}" if real else source
        if whole in self.modules or whole in self.library:
            return Found(self.modules.get(whole) or self.library[whole], None)
        if source in self.library:
            library = self.library[source]
            return Found(library, library.defined[real]) if real in library.defined else None
        if source == module.name:
            return None
        if source in self.modules:
            return self.find(self.modules[source], real)
        inside = (each for name, each in self.modules.items() if name.startswith(f"{source}."))
        return next((Found(each, each.defined[real]) for each in inside if real in each.defined), None)

    def variants(self, of: Found) -> list[Found]:
        """Return the forms of a function: itself, or all that library.pyi or `@overload` gives it."""
        if of.node not in self.overloaded:
            top = of.module.tree.body
            bodies = [top, *(each.body for each in top if isinstance(each, ast.ClassDef))]
            forms = [
                of._replace(node=each)
                for body in bodies
                if of.node in body
                for each in body
                if isinstance(each, ast.FunctionDef) and each.name == of.node.name
            ]
            overloads = [each for each in forms if "overload" in each.marks] or forms[-1:]
            self.overloaded[of.node] = overloads if of.ours else forms
        return self.overloaded[of.node]

    def lineage(self, of: Found) -> Iterator[Found]:
        """Yield a class and its base classes, as far as they are known."""
        yield of
        for base in of.node.bases:
            if (found := self.find(of.module, leaf(base))) and found.is_class:
                yield from self.lineage(found)

    def fields(self, of: Found) -> list[Parameter]:
        """Return the fields of a record, those of its base classes first."""
        found: dict[str, Parameter] = {}
        for each in reversed([*self.lineage(of)]):
            for field in each.fields or []:
                name = leaf(field.target)
                found[name] = Parameter(name, field.annotation, field.value, each.module)
        return [*found.values()]

    def signature(self, of: Found | None) -> list[Parameter] | None:
        """Return the parameters of a function or a class, without self; None of anything else."""
        if of and of.is_class:
            inits = (each._replace(node=each.declared.get("__init__")) for each in self.lineage(of))
            init = next((each for each in inits if each.node), None)
            if init is None:
                return self.fields(of)
            of = init
        return [each for each in of.parameters if each.name != "self"] if of else None
