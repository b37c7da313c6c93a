"""Modules as JavaScript: imports, constants, classes and functions."""

import ast
import gc
import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from types import MappingProxyType

from pdp8.web.translator.expressions import member, named
from pdp8.web.translator.program import Found, Module, Program, Untranslated, own, set_in
from pdp8.web.translator.statements import Statements
from pdp8.web.translator.types import INT, STR, leaf, whole

_ALIASES = ("Callable", "Annotated", "Literal", "dict", "tuple", "list", "Sequence", "Mapping")
_TYPES = ("str", "bytes", "int", "float", "bool", "list", "dict")
_PROTOCOLS = {
    "__len__": "get length() { return this.__len__(); }",
    "__str__": "toString() { return this.__str__(); }",
    "__iter__": "[Symbol.iterator]() { return $.iter(this.__iter__()); }",
}
"""What JavaScript asks of an object that has one of Python's methods."""
_BASES = ("NamedTuple", "StrEnum", "IntEnum")
_TAKEN = (
    "length", "constructor", "prototype", "toString", "valueOf", "toJSON", "hasOwnProperty", "toLocaleString",
)  # fmt: skip
"""Names that JavaScript's own objects have."""
_ERRORS = ("message", "name", "stack", "cause", "args")
_DUNDERS = ("__init__", "__post_init__", "__str__", "__len__", "__iter__", "__getitem__", "__setitem__")
"""What the runtime asks an object for."""


@contextmanager
def _telling(say: Callable[[str], object] | None) -> Iterator[None]:
    """Call `say` with a fault that the block raises, and continue after it; without `say` raise it."""
    try:
        yield
    except Untranslated as fault:
        if say is None:
            raise
        say(f"{fault}")


class Writer(Statements):
    """Writes one module as JavaScript."""

    def __init__(
        self,
        program: Program,
        module: Module,
        checked: bool = True,
        trusted: str = "",
        say: Callable[[str], object] | None = None,
    ) -> None:
        super().__init__(program, module)
        self.checked = checked
        self.dynamic = frozenset(trusted.split())
        self.say = say
        self.temporary = [[]]
        self.loops = []
        self.declared = {}

    def text(self) -> str:
        """Return the module."""
        body: list[str] = []
        for name, node in self.module.defined.items():
            with _telling(self.say):
                body += self._top(name, node)
        head = self._imports(set(re.findall(r"[\w$]+", "\n".join(body))))
        own_names = [f"let {', '.join(self.temporary[0])};"] if self.temporary[0] else []
        return "\n".join([*head, *own_names, *body, ""])

    def _imports(self, used: set[str]) -> Iterable[str]:
        up = "../" * self.module.name.count(".") or "./"
        yield f'import * as $ from "{up}pdp8/web/translator/runtime.mjs";'
        for name, (_, real) in self.module.imports.items():
            found = self.program.find(self.module, name)
            if not found or not found.ours or named(name) not in used:
                continue
            there = named(real) if real == name else f"{named(real)} as {named(name)}"
            what = f"* as {named(name)}" if found.is_module else f"{{ {there} }}"
            yield f'import {what} from "{up}{found.module.name.replace(".", "/")}.mjs";'

    def _top(self, name: str, node: ast.AST) -> list[str]:
        """Return what a module defines as `name`."""
        self.trusted = name in self.dynamic
        self.held, self.owner = {}, ""
        value = node.value if isinstance(node, ast.AnnAssign) else node
        if value and not isinstance(node, ast.FunctionDef | ast.ClassDef):
            names = [*self.module.defined]
            self._after(names[names.index(name) :], value)
        match node:
            case ast.ClassDef():
                return self._class(Found(self.module, node))
            case ast.FunctionDef():
                star, head, *rest = self.function(node)
                if "cache" in Found(self.module, node).marks:
                    return self._cached(node, head, rest)
                return [f"export function{star} {named(name)}{head} {{", *rest]
            case ast.Subscript() | ast.BinOp() | ast.Name() if self._names_types(node):
                return []
            case ast.AnnAssign(_, annotation, ast.expr() as value):
                text = self.accepted(value, self.annotated(annotation))
            case _:
                text = self.e(node)  # type: ignore[arg-type]
        return [f"export const {named(name)} = {text};"]

    def _after(self, later: list[str], node: ast.AST) -> None:
        """Refuse a value of the module that is made of a name defined later."""
        for each in own([node]):
            if isinstance(each, ast.Name) and each.id in later:
                self.fail(each, "it has no value yet", "its definition above")

    def _cached(self, node: ast.FunctionDef, head: str, rest: list[str]) -> list[str]:
        """Return a function that keeps what it has returned."""
        kinds = [*self.parameters(node).values()]
        if len(kinds) > 1 or any(kind not in (STR, INT) for kind in kinds):
            self.fail(node, "cache of a function of other than one text or int", "a dict")
        return [f"export const {named(node.name)} = $.cache({head} => {{", *rest[:-1], "});"]

    def _names_types(self, node: ast.AST) -> bool:
        """Whether a value is a name for types: `str | bytes`."""
        match node:
            case ast.BinOp(left, ast.BitOr(), right):
                return self._names_types(left) and self._names_types(right)
            case ast.Constant(None):
                return True
            case ast.Name(name):
                found = self.found(node)
                return bool(found and found.is_class) or name in _TYPES
        return isinstance(node, ast.Subscript) and leaf(node) in _ALIASES

    def _class(self, of: Found) -> list[str]:
        if "Protocol" in of.marks:
            return []
        node, self.owner = of.node, of.kind.name
        self._declared(of)
        base = next(map(self._base, node.bases), "$.Instance" if of.fields is None else "$.Record")
        lines = [f"export class {named(node.name)} extends {base} {{"]
        lines += self._record(of) if of.fields is not None else []
        after: list[str] = []
        for part in node.body:
            match part:
                case ast.Expr(ast.Constant()) | ast.Pass() | ast.Assign([ast.Name("__slots__")]):
                    pass
                case ast.FunctionDef(name):
                    method = of._replace(node=part)
                    if name not in self.module.omitted and "overload" not in method.marks:
                        with _telling(self.say):
                            lines += self._member(method, node.name)
                case ast.AnnAssign() if part in (of.fields or []):
                    pass
                case ast.Assign([ast.Name(name)], value) | ast.AnnAssign(ast.Name(name), _, value):
                    if value is not None:
                        self._apart_from(node, value)
                        lines.append(f"static {name} = {self.e(value)};")
                        after.append(f"{node.name}.prototype.{name} = {node.name}.{name};")
                case _:
                    self.fail(part)
        self.owner = ""
        return [*lines, "}", *after]

    def _base(self, node: ast.expr) -> str:
        if not isinstance(node, ast.Name):
            self.fail(node, "such a base class", "its own name")
        found = self.program.find(self.module, leaf(node))
        if found and found.is_class and found.ours:
            return named(leaf(node))
        if not (found and found.is_class) and leaf(node) not in _BASES:
            self.fail(node, "such a base class")
        return f"$.{leaf(node)}"

    def _declared(self, of: Found) -> None:
        """Refuse classes of other kinds, and names that JavaScript's own objects have."""
        node = of.node
        if len(node.bases) > 1 or node.keywords:
            self.fail(node, "a class with several bases or with keywords", "one base class")
        for mark in node.decorator_list:
            if leaf(getattr(mark, "func", mark)) != "dataclass":
                self.fail(mark, "a decorator of a class")
            for option in getattr(mark, "keywords", []):
                if option.arg not in ("frozen", "slots", "repr"):
                    self.fail(mark, f"dataclass({option.arg}=)")
        functions = [each for each in node.body if isinstance(each, ast.FunctionDef)]
        methods = [each for each in functions if each.name not in self.module.omitted]
        names = {each.name for each in methods}.union(*map(set_in, methods))
        names |= {leaf(field.target) for field in of.fields or []}
        taken = {*_TAKEN} - ({"length"} if not self.of_class(of.kind.name, "__len__")[1] else set())
        if any(each.kind.name == "BaseException" for each in self.program.lineage(of)):
            taken |= {*_ERRORS}
            init, own_text = of.declared.get("__init__"), self.of_class(of.kind.name, "__str__")[1]
            if init and "super().__init__(" not in ast.unparse(init) and not (own_text and own_text.ours):
                self.fail(init, "an error without its text", "super().__init__(...)")
        for each in methods:
            if each.name[:2] == "__" and each.name not in _DUNDERS:
                self.fail(each, "a method that nothing would call", f"one of {', '.join(_DUNDERS)}")
        taken |= {name for name in names if name[:2] == "__" and name not in _DUNDERS}
        for name in sorted(names & taken):
            why = f"{name} is something else in JavaScript, or of a class of Python's own"
            self.fail(node, why, "another name")
        self._as_in_its_bases(of)
        lineage = [*self.program.lineage(of)]
        if of.fields is None and not any("__init__" in each.declared for each in lineage):
            unset = {name for name, part in of.declared.items() if getattr(part, "value", part) is None}
            for name in sorted(unset | {*of.members}.difference(*(each.declared for each in lineage))):
                self.fail(node, f"nothing sets {name} first", "it in __init__")
        if of.is_enum:
            for method in methods:
                self.fail(method, "a method of an enumeration", "a function")
            self._constants_only(of)

    def _as_in_its_bases(self, of: Found) -> None:
        """Refuse a method or an attribute that is used in another way than that of a base class."""
        for base in [*self.program.lineage(of)][1:]:
            for name in sorted(of.members & base.members - {"__init__"}) if base.ours else ():
                if not self.used_alike(of.kind, base.kind, name):
                    why = f"{name} is not as in {base.node.name}"
                    self.fail(of.declared.get(name, of.node), why, "the same parameters and types")

    def _constants_only(self, of: Found) -> None:
        """Refuse an enumeration whose members are not constants, all different."""
        members = [each for each in of.node.body if isinstance(each, ast.Assign)]
        if len({ast.unparse(each.value) for each in members}) < len(members):
            self.fail(of.node, "two members of one value")
        for each in members:
            if not isinstance(each.value, ast.Constant) and whole(each.value) is None:
                self.fail(each, "a member that is no constant")

    def _apart_from(self, node: ast.ClassDef, value: ast.expr) -> None:
        """Refuse an attribute of a class whose value uses another attribute of that class."""
        own_names = {
            leaf(target) for each in node.body if isinstance(each, ast.Assign) for target in each.targets
        }
        for each in ast.walk(value):
            if isinstance(each, ast.Name) and each.id in own_names:
                self.fail(value, "an attribute of a class made of another", "it as a constant of the module")

    def _record(self, of: Found) -> list[str]:
        fields, parameters = self.program.fields(of), []
        for each in fields:
            match value := each.default:
                case ast.Call(func, args, keywords) if leaf(func) == "field":
                    options = {option.arg: option.value for option in keywords}
                    if args or len(options) != 1 or not {*options} <= {"default_factory", "default"}:
                        self.fail(value, "a field with such options", "default or default_factory")
                    [(option, made)] = options.items()
                    value = ast.copy_location(ast.Call(made, [], []), value) if option != "default" else made
                case ast.expr():
                    self.fixed(value, each.annotation)
            if value:
                self.accept(value, self.annotated(each.annotation, each.module))
            parameters.append(named(each.name) + (f" = {self.e(value)}" if value else ""))
        given = ", ".join(named(each.name) for each in fields)
        sets = " ".join(f"this.{member(each.name)} = {named(each.name)};" for each in fields)
        bases = [*self.program.lineage(of)][1:]
        body = f"super(); {sets} this.__post_init__();"
        if any(each.fields is not None for each in bases):
            body = f"super({given}); {sets}"
        return [
            f"static $fields = [{', '.join(repr(member(each.name)) for each in fields)}];",
            f"constructor({', '.join(parameters)}) {{ {body} }}",
        ]

    def _member(self, of: Found, owner: str) -> list[str]:
        node, marks = of.node, of.marks
        if "cache" in marks or ("contextmanager" in marks and of.is_static):
            self.fail(node, "cache of a method", "cached_property")
        if not of.is_static and [each.arg for each in node.args.args][:1] != ["self"]:
            self.fail(node, "a method whose first parameter is not self", "self, or @staticmethod")
        name, self.held = member(node.name), {}
        trusted, self.trusted = self.trusted, self.trusted or f"{owner}.{node.name}" in self.dynamic
        star, head, *rest = self.function(node)
        self.trusted = trusted
        made = [f"{star}{name}{head} {{", *rest]
        if "cached_property" in marks:
            kept = f'$.kept(this, "{name}", this.$made_{name}())'
            return [f"get {name}() {{ return {kept}; }}", f"$made_{made[0]}", *rest]
        if of.is_static:
            made.append(f"{name}(...$a) {{ return {owner}.{name}(...$a); }}")
        before = {"property": "get ", "setter": "set ", "staticmethod": "static "}
        made[0] = "".join(before.get(mark, "") for mark in marks) + made[0]
        return [*made, *([_PROTOCOLS[name]] if name in _PROTOCOLS else [])]


def translate(
    modules: dict[str, tuple[str, str]],
    omitted: dict[str, str],
    say: Callable[[str], object] | None = None,
    unchecked: Collection[str] = (),
    trusted: Mapping[str, str] = MappingProxyType({}),
) -> dict[str, str]:
    """Return the JavaScript of each of the `modules`, {name: (path, text)}, but for what is `omitted`.

    Raises Untranslated, with file and line; with `say`, passes it the message and continues. The modules that
    are `unchecked` trust their numbers and indexes, the functions and classes that are `trusted` their types.
    """
    collecting = gc.isenabled()
    gc.disable()  # nothing of the trees is garbage before the end: a fifth of the time
    try:
        read, written = [], {}
        for name, source in modules.items():
            with _telling(say):
                read.append(Module(name, *source, omitted.get(name, "").split()))
        program = Program(read)
        for name, module in program.modules.items():
            with _telling(say):
                written[name] = Writer(
                    program, module, name not in unchecked, trusted.get(name, ""), say
                ).text()
        return written
    finally:
        if collecting:
            gc.enable()
