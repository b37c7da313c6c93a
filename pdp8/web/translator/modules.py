"""Modules as JavaScript: imports, constants, classes and functions."""

import ast
import gc
import re
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from pdp8.web.translator.expressions import RENAMED, named
from pdp8.web.translator.program import Found, Module, Program, Untranslated
from pdp8.web.translator.statements import Statements
from pdp8.web.translator.types import leaf

_ALIASES = ("Callable", "Annotated", "Literal", "dict", "tuple", "list", "Sequence", "Mapping")
_PROTOCOLS = {
    "__len__": "get length() { return this.__len__(); }",
    "__str__": "toString() { return this.__str__(); }",
    "__iter__": "[Symbol.iterator]() { return $.iter(this.__iter__()); }",
}
"""What JavaScript asks of an object that has one of Python's methods."""


class Writer(Statements):
    """Writes one module as JavaScript."""

    def __init__(self, program: Program, module: Module) -> None:
        super().__init__(program, module)
        self.temporary = [[]]
        self.loops = []

    def text(self) -> str:
        """Return the module."""
        body = [line for name, node in self.module.defined.items() for line in self._top(name, node)]
        head = self._imports(set(re.findall(r"[\w$]+", "\n".join(body))))
        own_names = [f"let {', '.join(self.temporary[0])};"] if self.temporary[0] else []
        return "\n".join([*head, *own_names, *body, ""])

    def _imports(self, used: set[str]) -> Iterable[str]:
        up = "../" * self.module.name.count(".") or "./"
        yield f'import * as $ from "{up}pdp8/web/translator/runtime.mjs";'
        for name, (_, real) in self.module.imports.items():
            found = self.program.find(self.module, name)
            if not found or named(name) not in used:
                continue
            there = named(real) if real == name else f"{named(real)} as {named(name)}"
            what = f"* as {named(name)}" if found.node is None else f"{{ {there} }}"
            yield f'import {what} from "{up}{found.module.name.replace(".", "/")}.mjs";'

    def _top(self, name: str, node: ast.AST) -> list[str]:
        """Return what a module defines as `name`."""
        if isinstance(node, ast.ClassDef):
            return self._class(node)
        if isinstance(node, ast.FunctionDef):
            star, head, *rest = self.function(node)
            return [f"export function{star} {named(name)}{head} {{", *rest]
        value = node.value if isinstance(node, ast.AnnAssign) else node
        alias = isinstance(value, ast.Subscript) and leaf(value) in _ALIASES
        return [] if alias else [f"export const {named(name)} = {self.e(value)};"]  # type: ignore[arg-type]

    def _class(self, node: ast.ClassDef) -> list[str]:
        if "Protocol" in map(leaf, node.bases):
            return []
        self.owner = f"{self.module.name}.{node.name}"
        fields = Found(self.module, node).fields
        base = next(map(self.e, node.bases), "$.Instance" if fields is None else "$.Record")
        lines = [f"export class {named(node.name)} extends {base} {{"]
        lines += self._record(fields) if fields is not None else []
        after: list[str] = []
        for member in node.body:
            match member:
                case ast.Expr(ast.Constant()) | ast.Pass() | ast.Assign([ast.Name("__slots__")]):
                    pass
                case ast.FunctionDef(name):
                    if name not in self.module.omitted and "overload" not in map(leaf, member.decorator_list):
                        lines += self._member(member, node.name)
                case ast.Assign([ast.Name(name)], value) | ast.AnnAssign(ast.Name(name), _, value):
                    if fields is None and value is not None:
                        lines.append(f"static {name} = {self.e(value)};")
                        after.append(f"{node.name}.prototype.{name} = {node.name}.{name};")
                case _:
                    self.fail(member)
        self.owner = ""
        return [*lines, "}", *after]

    def _record(self, fields: list[ast.AnnAssign]) -> list[str]:
        names = [leaf(field.target) for field in fields]
        parameters = []
        for name, field in zip(names, fields, strict=True):
            value = field.value
            if isinstance(value, ast.Call) and leaf(value.func) == "field":
                value = ast.Call(value.keywords[0].value, [], [])
            parameters.append(named(name) + (f" = {self.e(value)}" if value else ""))
        sets = " ".join(f"this.{name} = {named(name)};" for name in names)
        made = f"constructor({', '.join(parameters)}) {{ super(); {sets} this.__post_init__(); }}"
        return [f"static $fields = [{', '.join(map(repr, names))}];", made]

    def _member(self, node: ast.FunctionDef, owner: str) -> list[str]:
        marks = set(map(leaf, node.decorator_list))
        name = RENAMED.get(node.name, node.name)
        star, head, *rest = self.function(node)
        made = [f"{star}{name}{head} {{", *rest]
        if "cached_property" in marks:
            kept = f'$.kept(this, "{name}", this.$made_{name}())'
            return [f"get {name}() {{ return {kept}; }}", f"$made_{made[0]}", *rest]
        if "staticmethod" in marks:
            made.append(f"{name}(...$a) {{ return {owner}.{name}(...$a); }}")
        before = {"property": "get ", "setter": "set ", "staticmethod": "static "}
        made[0] = "".join(before.get(mark, "") for mark in marks) + made[0]
        return [*made, *([_PROTOCOLS[name]] if name in _PROTOCOLS else [])]


@contextmanager
def _telling(say: Callable[[str], object] | None) -> Iterator[None]:
    """Pass what has no translation to `say`, if there is one, and go on behind the block."""
    try:
        yield
    except Untranslated as fault:
        if say is None:
            raise
        say(f"{fault}")


def translate(
    modules: dict[str, tuple[str, str]],
    omitted: dict[str, str],
    runtime: str,
    say: Callable[[str], object] | None = None,
) -> dict[str, str]:
    """Return the JavaScript of each of the `modules`, {name: (path, text)}, but for what is `omitted`.

    Raises Untranslated, with file and line; with `say`, passes it the message and goes on.
    """
    collecting = gc.isenabled()
    gc.disable()  # nothing of the trees is garbage before the end: a fifth of the time
    try:
        read, written = [], {}
        for name, source in modules.items():
            with _telling(say):
                read.append(Module(name, *source, omitted.get(name, "").split()))
        program = Program(read, runtime)
        for name, module in program.modules.items():
            with _telling(say):
                written[name] = Writer(program, module).text()
        return written
    finally:
        if collecting:
            gc.enable()
