"""All modules that are translated: what each defines and imports, and where a name leads."""

import ast
import itertools
import re
from collections.abc import Iterable, Iterator
from typing import Any, NamedTuple

from pdp8.web.translator.types import Type, leaf

_MEMBER = re.compile(r"\b(?:def|class) (\w+)|self\.(\w+)|^    (\w+): ", re.MULTILINE)


class Untranslated(Exception):
    """A construct that has no translation, with its file and line."""


class Found(NamedTuple):
    """Where a name leads: the module it is defined in, and there what defines it; None for a module."""

    module: "Module"
    node: Any

    @property
    def is_class(self) -> bool:
        """Whether it leads to a class."""
        return isinstance(self.node, ast.ClassDef)

    @property
    def kind(self) -> Type:
        """The type of a class's instances."""
        return Type(f"{self.module.name}.{self.node.name}")

    @property
    def fields(self) -> list[ast.AnnAssign] | None:
        """The fields of a named tuple or dataclass; None for any other class."""
        marks = [getattr(each, "func", each) for each in self.node.decorator_list]
        if {"dataclass", "NamedTuple"}.isdisjoint(map(leaf, [*marks, *self.node.bases])):
            return None
        return [each for each in self.node.body if isinstance(each, ast.AnnAssign)]


class Module:
    """One module's syntax tree, what it defines and what it imports."""

    def __init__(self, name: str, path: str, text: str, omitted: Iterable[str]) -> None:
        self.name = name
        self.path = path
        self.text = text
        self.tree = ast.parse(text)
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


class Program:
    """All modules that are translated."""

    def __init__(self, modules: Iterable[Module], runtime: str) -> None:
        self.modules = {module.name: module for module in modules}
        exports = re.findall(r"^export (?:const|class) (\w+|{.*?})", runtime, re.MULTILINE)
        self.runtime = frozenset(re.findall(r"\w+", " ".join(exports)))
        self.errors = frozenset(name for name in self.runtime if name.endswith(("Error", "Exception")))
        own = (each for module in self.modules.values() for each in _MEMBER.findall(module.text))
        self.members = {*re.findall(r"(\w+?)_?(?=: |\(| = )", runtime), *itertools.chain(*own)}
        """The names of all methods and attributes that anything has."""
        self.classes = {
            f"{module.name}.{name}": Found(module, node)
            for module in self.modules.values()
            for name, node in module.defined.items()
            if isinstance(node, ast.ClassDef)
        }
        self.attributes: dict[tuple[str, str], tuple[Type, Found | None]] = {}
        self.constants: dict[ast.AST, Type] = {}

    def find(self, module: Module, name: str) -> Found | None:
        """Return where a name leads from a module; None out of the modules that are translated."""
        if name in module.defined:
            return Found(module, module.defined[name])
        source, real = module.imports.get(name, ("", ""))
        whole = f"{source}.{real}" if real else source
        if whole in self.modules:
            return Found(self.modules[whole], None)
        return self.find(self.modules[source], real) if source in self.modules else None

    def lineage(self, of: Found) -> Iterator[Found]:
        """Yield a class and its base classes, as far as they are ours."""
        yield of
        for base in of.node.bases:
            if (found := self.find(of.module, leaf(base))) and found.is_class:
                yield from self.lineage(found)

    def signature(self, of: Found | None) -> ast.arguments | None:
        """Return the parameters of a function or a class."""
        if of and isinstance(of.node, ast.FunctionDef):
            return of.node.args
        for each in self.lineage(of) if of and of.is_class else ():
            for member in each.node.body:
                if isinstance(member, ast.FunctionDef) and member.name == "__init__":
                    return member.args
            if each.fields is not None:
                args = [ast.arg(leaf(field.target)) for field in each.fields]
                return ast.arguments([], args, None, [], [], None, [])
        return None
