"""All modules that are translated: what each defines and imports, and where a name leads."""

import ast
import re
from collections.abc import Iterable, Iterator
from functools import cache
from typing import Any, NamedTuple

from pdp8.web.translator.types import Type, leaf


class Untranslated(Exception):
    """A construct that has no translation, with its file and line."""


PROPERTIES = frozenset(("property", "cached_property"))


class Found(NamedTuple):
    """Where a name leads: the module it is defined in, and there what defines it; None for a module."""

    module: "Module"
    node: Any

    @property
    def is_class(self) -> bool:
        """Whether it leads to a class."""
        return isinstance(self.node, ast.ClassDef)

    @property
    def is_tuple(self) -> bool:
        """Whether it leads to a named tuple."""
        return "NamedTuple" in self._marks

    @property
    def is_enum(self) -> bool:
        """Whether it leads to an enumeration."""
        return self.is_class and not {"StrEnum", "IntEnum"}.isdisjoint(self._marks)

    @property
    def is_property(self) -> bool:
        """Whether it leads to a method that is read as an attribute."""
        return isinstance(self.node, ast.FunctionDef) and not PROPERTIES.isdisjoint(self._marks)

    @property
    def _marks(self) -> set[str]:
        marks = [getattr(each, "func", each) for each in self.node.decorator_list]
        return {*map(leaf, [*marks, *getattr(self.node, "bases", ())])}

    @property
    def kind(self) -> Type:
        """The type of a class's instances."""
        return Type(self.node.name if self.module.table else f"{self.module.name}.{self.node.name}")

    @property
    def fields(self) -> list[ast.AnnAssign] | None:
        """The fields of a named tuple or dataclass; None for any other class."""
        if {"dataclass", "NamedTuple"}.isdisjoint(self._marks):
            return None
        return [
            each
            for each in self.node.body
            if isinstance(each, ast.AnnAssign) and leaf(each.annotation) != "ClassVar"
        ]


class Module:
    """One module's syntax tree, what it defines and what it imports."""

    def __init__(self, name: str, path: str, text: str, omitted: Iterable[str]) -> None:
        self.name = name
        self.path = path
        self.text = text
        self.tree = ast.parse(text)
        self.table = ""
        """The name of a module of Python's library, of which this is what may be used."""
        self.omitted = frozenset(omitted)
        self.defined: dict[str, ast.AST] = {}
        self.imports: dict[str, tuple[str, str]] = {}
        """{name: (module, its name there)}; "" is the module itself."""
        within = re.search(r"^ +(from|import) ", text, re.MULTILINE)  # imports stand within functions too
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
            case ast.FunctionDef(name, decorator_list=[ast.Name("overload"), *_]):
                self.defined.setdefault(name, node)
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
        super().__init__(name, "library.pyi", "", ())
        self.table = name
        self.tree.body = body
        for node in body:
            if isinstance(node, ast.AnnAssign):
                self.defined[leaf(node.target)] = node
            elif isinstance(node, ast.ClassDef):
                self.defined.setdefault(node.name, node)
            elif isinstance(node, ast.FunctionDef) and not isinstance(
                self.defined.get(node.name), ast.FunctionDef
            ):
                self.defined[node.name] = node


@cache
def libraries(table: str) -> dict[str, Library]:
    """Return the modules of the library, {name: module}, as the text of library.pyi has them."""
    body = ast.parse(table).body
    found = {"builtins": [each for each in body if not isinstance(each, ast.If)]}
    for each in body:
        if isinstance(each, ast.If) and isinstance(each.test, ast.Compare):
            found[each.test.comparators[0].value] = each.body  # type: ignore[attr-defined]
    return {name: Library(name, nodes) for name, nodes in found.items()}


class Program:
    """All modules that are translated."""

    def __init__(self, modules: Iterable[Module], table: str, runtime: str) -> None:
        self.modules = {module.name: module for module in modules}
        self.library = libraries(table)
        exports = re.findall(r"^export (?:const|class) (\w+|{.*?}|.*? = .*?, \w+)", runtime, re.MULTILINE)
        self.runtime = frozenset(re.findall(r"\w+", " ".join(exports)))
        self.classes = {
            (f"{module.name}.{node.name}" if module.table == "" else node.name): Found(module, node)
            for module in (*self.library.values(), *self.modules.values())
            for node in module.tree.body
            if isinstance(node, ast.ClassDef) and node.name not in module.omitted
        }
        self.protocols = frozenset(
            each.kind for each in self.classes.values() if "Protocol" in map(leaf, each.node.bases)
        )
        self.annotations: dict[tuple[ast.AST, str, str], Type] = {}
        self.present: dict[tuple[str, str], bool] = {}
        self.attributes: dict[tuple[str, str], tuple[Type, Found | None]] = {}
        self.constants: dict[ast.AST, Type] = {}
        self.overloaded: dict[ast.AST, list[Found]] = {}
        bases = (leaf(base) for found in self.classes.values() for base in found.node.bases)
        self.inherited = frozenset(bases)
        """The names of all classes that others are made from."""

    def find(self, module: Module, name: str) -> Found | None:
        """Return where a name leads from a module; None out of the modules that are translated."""
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
        """Return the forms of a function: the overloaded ones, or itself."""
        if of.node not in self.overloaded:
            bodies = [
                of.module.tree.body,
                *(each.body for each in of.module.tree.body if isinstance(each, ast.ClassDef)),
            ]
            same = [
                each
                for body in bodies
                if of.node in body
                for each in body
                if isinstance(each, ast.FunctionDef) and each.name == of.node.name
            ]
            forms = [each for each in same if "overload" in map(leaf, each.decorator_list)] or same[-1:]
            self.overloaded[of.node] = [of._replace(node=each) for each in forms]
        return self.overloaded[of.node]

    def lineage(self, of: Found) -> Iterator[Found]:
        """Yield a class and its base classes, as far as they are known."""
        yield of
        for base in of.node.bases:
            if (found := self.find(of.module, leaf(base))) and found.is_class:
                yield from self.lineage(found)

    def signature(self, of: Found | None) -> ast.arguments | None:
        """Return the parameters of a function or a class."""
        if of and isinstance(of.node, ast.FunctionDef):
            return of.node.args
        if not of or not of.is_class:
            return None
        names: list[str] = []
        for each in self.lineage(of):
            for member in each.node.body:
                if isinstance(member, ast.FunctionDef) and member.name == "__init__":
                    return member.args
            if each.fields is not None:
                names = [leaf(field.target) for field in each.fields] + names
        return ast.arguments([], [ast.arg(name) for name in names], None, [], [], None, [])
