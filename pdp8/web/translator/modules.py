"""Modules: imports, constants, classes and functions, and what is known of all modules together."""

import ast
import re
from collections.abc import Iterable
from typing import NamedTuple

from pdp8.web.translator.expressions import RENAMED, Untranslated, named
from pdp8.web.translator.statements import Statements
from pdp8.web.translator.types import ANY, INT, STR, Type, leaf, own

_ENUMS = {"IntEnum": INT, "StrEnum": STR}
_ABSTRACT = ("Protocol", "NamedTuple", "Enum", *_ENUMS)
_ONLY_TYPES = ("typing", "collections.abc")
_ALIASES = ("Callable", "Annotated", "Literal", "dict", "tuple", "list", "Sequence", "Mapping")


class Found(NamedTuple):
    """Where a name leads: the module it is defined in, and there what defines it; None for a module."""

    module: "Module"
    node: ast.AST | None


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
        for node in self._statements(self.tree.body):
            self._take(node)

    def _statements(self, body: list[ast.stmt]) -> Iterable[ast.stmt]:
        """Yield the statements of the module, and the imports within its functions."""
        for node in body:
            if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
                yield from (each for each in node.body if isinstance(each, ast.ImportFrom))
            else:
                yield node
        for part in ast.walk(self.tree):
            if isinstance(part, ast.FunctionDef) and part.name not in self.omitted:
                yield from (each for each in own(part.body) if isinstance(each, ast.Import | ast.ImportFrom))

    def _take(self, node: ast.stmt) -> None:
        match node:
            case ast.Import(names):
                self.imports |= {each.asname or each.name: (each.name, "") for each in names}
            case ast.ImportFrom(module, names):
                self.imports |= {each.asname or each.name: (module or "", each.name) for each in names}
            case ast.FunctionDef(name) | ast.ClassDef(name):
                self.defined[name] = node
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)):
                self.defined |= {leaf(t): v for t, v in zip(targets, values, strict=True)}
            case ast.Assign([ast.Name(name)], value):
                if name in self.defined:
                    raise Untranslated(f"{self.path}:{node.lineno}: {name} is set twice")
                self.defined[name] = value
            case ast.AnnAssign(ast.Name(name)):
                self.defined[name] = node
        for name in self.omitted:
            self.defined.pop(name, None)


class Program:
    """All modules that are translated."""

    def __init__(self, modules: Iterable[Module], runtime: str) -> None:
        self.modules = {module.name: module for module in modules}
        self.packages = {name.split(".")[0] for name in self.modules}
        self.runtime = frozenset(
            re.findall(r"^export (?:const|function\*?|class) (\w+\$?)", runtime, re.MULTILINE)
        )
        self.errors = frozenset(
            name for name in self.runtime if name.endswith(("Error", "Exception", "Iteration"))
        )
        self.classes = {
            f"{module.name}.{name}": (module, node)
            for module in self.modules.values()
            for name, node in module.defined.items()
            if isinstance(node, ast.ClassDef)
        }
        self.attributes: dict[tuple[str, str], tuple[Type, ast.FunctionDef | None]] = {}
        self.constants: dict[tuple[str, str], Type] = {}

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

    def kind(self, module: Module, node: ast.ClassDef) -> Type:
        """Return the type of a class's instances; an enumeration's are plain numbers and texts."""
        for base in node.bases:
            if leaf(base) in _ENUMS:
                return _ENUMS[leaf(base)]
        return Type(f"{module.name}.{node.name}")

    def is_enum(self, node: ast.ClassDef) -> bool:
        """Tell whether a class is an enumeration."""
        return any(leaf(base) in _ENUMS for base in node.bases)

    def fields(self, module: Module, node: ast.ClassDef) -> list[ast.AnnAssign] | None:
        """Return the fields of a named tuple or dataclass; None for any other class."""
        marks = {leaf(each.func if isinstance(each, ast.Call) else each) for each in node.decorator_list}
        bases = [found for base in node.bases if (found := self.find(module, leaf(base)))]
        inherited = [
            field
            for found in bases
            if isinstance(found.node, ast.ClassDef)
            for field in self.fields(found.module, found.node) or []
        ]
        if "dataclass" not in marks and not any(leaf(base) == "NamedTuple" for base in node.bases):
            return inherited or None
        return [*inherited, *(each for each in node.body if isinstance(each, ast.AnnAssign))]

    def made_with(self, module: Module, node: ast.ClassDef) -> ast.arguments | None:
        """Return the parameters of a class."""
        for member in node.body:
            if isinstance(member, ast.FunctionDef) and member.name == "__init__":
                return member.args
        fields = self.fields(module, node)
        if fields is not None:
            args = [ast.arg(leaf(field.target)) for field in fields]
            return ast.arguments([], args, None, [], [], None, [])
        for base in node.bases:
            found = self.find(module, leaf(base))
            if found and isinstance(found.node, ast.ClassDef):
                return self.made_with(found.module, found.node)
        return None


class Writer(Statements):
    """Writes one module as JavaScript."""

    def __init__(self, program: Program, module: Module) -> None:
        super().__init__(program, module)
        self.temporary = [[]]
        self.loops = []

    def text(self) -> str:
        """Return the module."""
        body = [line for node in self.module.tree.body for line in self._top(node)]
        used = set(re.findall(r"[\w$]+", "\n".join(body)))
        head = [line for line in self._imports(used)]
        if self.temporary[0]:
            head.append(f"let {', '.join(self.temporary[0])};")
        return "\n".join([*head, *body, ""])

    def _imports(self, used: set[str]) -> Iterable[str]:
        up = "../" * self.module.name.count(".") or "./"
        yield f'import * as $ from "{up}pdp8/web/translator/runtime.mjs";'
        for name, (_, real) in self.module.imports.items():
            found = self.program.find(self.module, name)
            if not found or named(name) not in used:
                continue
            path = up + found.module.name.replace(".", "/") + ".mjs"
            if found.node is None:
                yield f'import * as {named(name)} from "{path}";'
            else:
                there = named(real) if named(real) == named(name) else f"{named(real)} as {named(name)}"
                yield f'import {{ {there} }} from "{path}";'

    def _top(self, node: ast.stmt) -> list[str]:
        match node:
            case ast.Expr(ast.Constant()) | ast.Import() | ast.ImportFrom() | ast.AnnAssign(value=None):
                return []
            case ast.Expr(ast.Call(ast.Attribute(ast.Call(ast.Name("globals"))))):
                return []
            case ast.If(test) if "TYPE_CHECKING" in ast.unparse(test):
                return []
            case ast.FunctionDef(name) | ast.ClassDef(name) if name in self.module.omitted:
                return []
            case ast.Assign([ast.Name(name)]) | ast.AnnAssign(ast.Name(name)) if name in self.module.omitted:
                return []
            case ast.Assign([ast.Name(name)], value) | ast.AnnAssign(ast.Name(name), _, value):
                alias = isinstance(value, ast.Subscript) and leaf(value.value) in _ALIASES
                return [] if alias or value is None else [f"export const {named(name)} = {self.e(value)};"]
            case ast.Assign([ast.Tuple(targets)], ast.Tuple(values)):
                pairs = zip(targets, values, strict=True)
                return [f"export const {named(leaf(target))} = {self.e(value)};" for target, value in pairs]
            case ast.FunctionDef():
                head, *rest = self.function(node, "function ")
                return [f"export {head}", *rest]
            case ast.ClassDef():
                return self._class(node)
        self.fail(node)

    def inner(self, node: ast.FunctionDef) -> list[str]:
        """Return a function within a function."""
        if any(isinstance(part, ast.Yield | ast.YieldFrom) for part in own(node.body)):
            self.fail(node, "a generator within a function")
        head, *rest = self.function(node, "")
        return [
            f"{named(node.name)} = {head.replace(') {', ') => {', 1).removeprefix(named(node.name))}",
            *rest[:-1],
            "};",
        ]

    def function(self, node: ast.FunctionDef, how: str) -> list[str]:
        """Return a function; `how` is what stands before its name."""
        if how == "function ":
            for mark in node.decorator_list:
                if leaf(mark) not in ("contextmanager", "cache"):
                    self.fail(mark, "decorator")
        parameters = self._parameters(node.args)
        self.scopes.append(self.parameters(node))
        given = set(self.scopes[-1])
        self.scopes[-1] |= {part.name: ANY for part in own(node.body) if isinstance(part, ast.FunctionDef)}
        self.learn(node.body)
        self.temporary.append([])
        loops, self.loops = self.loops, []
        lines = self.block(node.body)
        self.loops = loops
        outer = {name for part in own(node.body) if isinstance(part, ast.Nonlocal) for name in part.names}
        local = [named(name) for name in self.scopes[-1] if name not in given | outer]
        local += self.temporary.pop()
        self.scopes.pop()
        yields = any(isinstance(part, ast.Yield | ast.YieldFrom) for part in own(node.body))
        star = "*" if yields else ""
        name = how + star + named(node.name) if how == "function " else star + how + node.name
        head = f"{name.replace('function *', 'function* ')}({', '.join(parameters)}) {{"
        return [head, *([f"let {', '.join(local)};"] if local else []), *lines, "}"]

    def _parameters(self, args: ast.arguments) -> list[str]:
        positional = [*args.posonlyargs, *args.args]
        defaults = [None] * (len(positional) - len(args.defaults)) + list(args.defaults)
        pairs = [
            pair for pair in zip(positional, defaults, strict=True) if pair[0].arg not in ("self", "cls")
        ]
        pairs += [(args.vararg, None)] if args.vararg else []
        pairs += list(zip(args.kwonlyargs, args.kw_defaults, strict=True))
        pairs += [(args.kwarg, None)] if args.kwarg else []
        return [named(each.arg) + (f" = {self.e(default)}" if default else "") for each, default in pairs]

    def _class(self, node: ast.ClassDef) -> list[str]:
        if any(leaf(base) == "Protocol" for base in node.bases):
            return []
        self.owner = f"{self.module.name}.{node.name}"
        bases = [base for base in node.bases if leaf(base) not in _ABSTRACT]
        fields = self.program.fields(self.module, node)
        base = self.e(bases[0]) if bases else self._base(node, fields)
        lines = [f"export class {named(node.name)}{' extends ' + base if base else ''} {{"]
        after: list[str] = []
        if fields is not None:
            lines += self._record(fields)
        if self.program.is_enum(node):
            members = [
                f"static {leaf(part.targets[0])} = {self.e(part.value)};"
                for part in node.body
                if isinstance(part, ast.Assign)
            ]
            return [*lines, *members, "}"]
        for member in node.body:
            match member:
                case ast.Expr(ast.Constant()) | ast.Pass() | ast.Assign([ast.Name("__slots__")]):
                    pass
                case ast.FunctionDef(name):
                    if name not in self.module.omitted and not any(
                        leaf(d) == "overload" for d in member.decorator_list
                    ):
                        lines += self._member(member, node, base, after)
                case ast.Assign([ast.Name(name)], value) | ast.AnnAssign(ast.Name(name), _, value):
                    if fields is None and value is not None:
                        after.append(f"{node.name}.prototype.{name} = {node.name}.{name} = {self.e(value)};")
                case _:
                    self.fail(member)
        self.owner = ""
        return [*lines, "}", *after]

    def _base(self, node: ast.ClassDef, fields: object) -> str:
        if self.program.is_enum(node):
            return "$.Enumeration"
        return (
            ""
            if fields is None
            else "$.NamedTuple"
            if any(leaf(b) == "NamedTuple" for b in node.bases)
            else "$.Record"
        )

    def _started(self, module: Module, node: ast.ClassDef) -> bool:
        """Tell whether the constructor of a base class calls `__init__`."""
        for base in node.bases:
            found = self.program.find(module, leaf(base))
            if found is None or not isinstance(found.node, ast.ClassDef):
                return leaf(base) in self.program.errors
            if self.program.made_with(found.module, found.node) or self._started(found.module, found.node):
                return True
        return False

    def _record(self, fields: list[ast.AnnAssign]) -> list[str]:
        names = [leaf(field.target) for field in fields]
        parameters = []
        for name, field in zip(names, fields, strict=True):
            value = field.value
            if isinstance(value, ast.Call) and leaf(value.func) == "field":
                value = ast.Call(value.keywords[0].value, [], [])
            parameters.append(named(name) + (f" = {self.e(value)}" if value else ""))
        sets = " ".join(f"this.{name} = {named(name)};" for name in names)
        listed = ", ".join(f'"{name}"' for name in names)
        after = "this.__post_init__(); " if self.of_class(self.owner, "__post_init__")[1] else ""
        made = f"constructor({', '.join(parameters)}) {{ super(); {sets} {after}}}"
        return [f"static $fields = [{listed}];", made]

    def _member(self, node: ast.FunctionDef, owner: ast.ClassDef, base: str, after: list[str]) -> list[str]:
        marks = {leaf(mark) for mark in node.decorator_list}
        if strange := marks - {
            "property",
            "setter",
            "cached_property",
            "contextmanager",
            "staticmethod",
            "classmethod",
        }:
            self.fail(node, f"decorator {strange}")
        if node.name == "__init__":
            begins = "super(...$a); " if base else ""
            made = (
                []
                if self._started(self.module, owner)
                else [f"constructor(...$a) {{ {begins}this.__init__(...$a); }}"]
            )
            return [*made, *self.function(node, "")]
        if "property" in marks:
            return self.function(node, "get ")
        if "setter" in marks:
            return self.function(node, "set ")
        if marks & {"staticmethod", "classmethod"}:
            if "staticmethod" in marks:
                after.append(f"{owner.name}.prototype.{node.name} = {owner.name}.{node.name};")
            return self.function(node, "static ")
        lines = self.function(node, "")
        lines[0] = lines[0].replace(node.name, RENAMED.get(node.name, node.name), 1)
        if "cached_property" in marks:
            lines[0] = lines[0].replace(node.name, f"$made_{node.name}", 1)
            return [
                f'get {node.name}() {{ return $.kept(this, "{node.name}", this.$made_{node.name}()); }}',
                *lines,
            ]
        extra = {
            "__len__": "get length() { return this.__len__(); }",
            "__str__": "toString() { return this.__str__(); }",
        }
        extra["__iter__"] = "[Symbol.iterator]() { return $.iter(this.__iter__()); }"
        return [*lines, *([extra[node.name]] if node.name in extra else [])]


def translate(modules: dict[str, tuple[str, str]], omitted: dict[str, str], runtime: str) -> dict[str, str]:
    """Return the JavaScript of each of the `modules`, {name: (path, text)}, but for what is `omitted`.

    Raises Untranslated, with file and line.
    """
    program = Program(
        [Module(name, *source, omitted.get(name, "").split()) for name, source in modules.items()], runtime
    )
    return {name: Writer(program, module).text() for name, module in program.modules.items()}
