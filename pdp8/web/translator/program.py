"""All modules that are translated: what each defines and imports, and where a name leads."""

import ast
import re
from collections.abc import Iterable
from typing import Any, NamedTuple

from pdp8.web.translator.types import INT, STR, Type, leaf

_ENUMS = {"IntEnum": INT, "StrEnum": STR}


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
        """The type of a class's instances; an enumeration's are plain numbers and texts."""
        enums = (_ENUMS[leaf(base)] for base in self.node.bases if leaf(base) in _ENUMS)
        return next(enums, Type(f"{self.module.name}.{self.node.name}"))


class Module:
    """One module's syntax tree, what it defines and what it imports."""

    def __init__(self, name: str, path: str, text: str, omitted: Iterable[str]) -> None:
        self.name = name
        self.path = path
        self.tree = ast.parse(text)
        self.omitted = frozenset(omitted)
        self.defined: dict[str, ast.AST] = {}
        self.imports: dict[str, tuple[str, str]] = {}
        """{name: (module, its name there)}; "" is the module itself."""
        for node in self.tree.body:
            self._take(node)
        within = re.search(r"^ +(from|import) ", text, re.MULTILINE)  # imports stand within functions too
        for part in ast.walk(self.tree) if within else ():
            if isinstance(part, ast.Import | ast.ImportFrom):
                self._take(part)
        for left_out in self.omitted:
            self.defined.pop(left_out, None)

    def _take(self, node: ast.stmt) -> None:
        match node:
            case ast.Import(names):
                self.imports |= {each.asname or each.name: (each.name, "") for each in names}
            case ast.ImportFrom(module, names):
                self.imports |= {each.asname or each.name: (module or "", each.name) for each in names}
            case ast.FunctionDef(name) | ast.ClassDef(name):
                self.defined[name] = node
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)):
                self.defined |= {leaf(target): value for target, value in zip(targets, values, strict=True)}
            case ast.Assign([ast.Name(name)], value):
                if name in self.defined:
                    raise Untranslated(f"{self.path}:{node.lineno}: {name} is set twice")
                self.defined[name] = value
            case ast.AnnAssign(ast.Name(name)):
                self.defined[name] = node


def is_for_types(node: ast.AST) -> bool:
    """Tell whether a statement is `if TYPE_CHECKING:`."""
    return isinstance(node, ast.If) and leaf(node.test) == "TYPE_CHECKING"


def is_tuple(node: ast.ClassDef) -> bool:
    """Tell whether a class is a named tuple."""
    return "NamedTuple" in map(leaf, node.bases)


class Program:
    """All modules that are translated."""

    def __init__(self, modules: Iterable[Module], runtime: str) -> None:
        self.modules = {module.name: module for module in modules}
        self.packages = {name.split(".")[0] for name in self.modules}
        exports = re.findall(r"^export (?:const|class) (\w+|{.*?})", runtime, re.MULTILINE)
        self.runtime = frozenset(re.findall(r"\w+", " ".join(exports)))
        self.errors = frozenset(name for name in self.runtime if name.endswith(("Error", "Exception")))
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
        if name not in module.imports:
            return None
        source, real = module.imports[name]
        whole = f"{source}.{real}" if real else source
        if whole in self.modules:
            return Found(self.modules[whole], None)
        return self.find(self.modules[source], real) if source in self.modules else None

    def bases(self, of: Found) -> list[Found]:
        """Return those bases of a class that are ours."""
        found = (self.find(of.module, leaf(base)) for base in of.node.bases)
        return [each for each in found if each and each.is_class]

    def fields(self, of: Found) -> list[ast.AnnAssign] | None:
        """Return the fields of a named tuple or dataclass; None for any other class."""
        inherited = [field for base in self.bases(of) for field in self.fields(base) or []]
        marks = map(leaf, (getattr(each, "func", each) for each in of.node.decorator_list))
        if "dataclass" in marks or is_tuple(of.node):
            return [*inherited, *(each for each in of.node.body if isinstance(each, ast.AnnAssign))]
        return inherited or None

    def made_with(self, of: Found) -> ast.arguments | None:
        """Return the parameters of a class."""
        for member in of.node.body:
            if isinstance(member, ast.FunctionDef) and member.name == "__init__":
                return member.args
        fields = self.fields(of)
        if fields is not None:
            args = [ast.arg(leaf(field.target)) for field in fields]
            return ast.arguments([], args, None, [], [], None, [])
        return next(map(self.made_with, self.bases(of)), None)
