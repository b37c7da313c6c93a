"""What the translated modules declare, as TypeScript reads it: a .d.mts for each, and one for the runtime.

The types are those that the translator reads (`inference`), so that the modules by hand are checked against
them. A whole number is a `number`, though beyond 2^53 it is a BigInt; a member of an enumeration is its
value.
"""

import ast
import re
from collections.abc import Iterable, Iterator

from pdp8.web.translator.expressions import member, named
from pdp8.web.translator.inference import Types
from pdp8.web.translator.program import Found, Module, Program, targets
from pdp8.web.translator.types import Type, leaf

_NAMES = {
    "?": "unknown", "unseen": "never", "None": "null", "word": "number", "int": "number", "float": "number",
    "real": "number", "bool": "boolean", "str": "string", "bytes": "$.Bytes", "bytearray": "$.ByteArray",
    "words": "$.Words", "SupportsInt": "number", "never": "never", "sized": "{ length: number }",
}  # fmt: skip
_OF = {
    "list": "({})[]", "row": "({})[]", "tuple": "[{}]", "sequence": "$.Sequence<{}>", "view": "$.View<{}>",
    "iterable": "Iterable<{}>", "unordered": "Iterable<{}>", "collection": "Iterable<{}>",
    "iterator": "Generator<{}>", "dict": "$.Dict<{}>", "set": "$.PySet<{}>", "range": "$.Sequence<{}>",
    "Pattern": "RegExp", "type": "typeof {}",
}  # fmt: skip
_JAVASCRIPT = {"__len__": "readonly length", "__str__": "toString()", "__iter__": "[Symbol.iterator]()"}
_RUNTIME = """import type * as $ from "./runtime.mjs";
export type Sequence<T> = ArrayLike<T> & Iterable<T>;
export type View<T> = Iterable<T> & { readonly length: number };
export class slice {}
export class Fraction {}
export class Match {}
export class BaseException extends Error {}
"""
_CLASSES = {
    "str": "declare global { interface String", "list": "declare global { interface Array<T>",
    "bytes": "export class Bytes extends Uint8Array<ArrayBuffer>",
    "bytearray": "export class ByteArray extends Array<number>",
    "words": "export class Words extends Uint16Array<ArrayBuffer>",
    "dict": "export class Dict<K, V>", "set": "export class PySet<T>",
}  # fmt: skip
"""How the runtime declares the classes of library.pyi; JavaScript's own classes are extended."""
_ELSEWHERE = {"dict": ("fromkeys",), "bytes": ("find", "join"), "list": ("index",)}
"""Methods that are static, or that JavaScript's own arrays have with other types."""
_SIZED = """
readonly length: number;
readonly size: number;
[Symbol.iterator](): IterableIterator<KEY>;
has(key: KEY): boolean;
delete(key: KEY): boolean;"""
_ALSO = {
    "set": _SIZED.replace("KEY", "T"),
    "dict": _SIZED.replace("KEY", "K") + "\nat(key: K): V;\nset(key: K, value: V): this;",
}


class Declarations(Types):
    """Writes what one module declares."""

    def __init__(self, program: Program, module: Module) -> None:
        super().__init__(program, module)
        self.used = set[str]()
        """The modules of the classes that are named."""
        self.own = set[str]()
        """The type variables of the class."""

    def text(self) -> str:
        """Return the declarations."""
        up = "../" * self.module.name.count(".")
        lines = [line for name, node in self.module.defined.items() for line in self._top(name, node)]
        head = [f'import type * as $ from "{up}pdp8/web/translator/runtime.mjs";']
        for name in sorted(self.used):
            path = f"{up}{name.replace('.', '/')}.mjs"
            head.append(f'import type * as {name.replace(".", "_")} from "{path}";')
        return "\n".join([*head, *lines, "export {};", ""])

    def runtime(self) -> str:
        """Return the declarations of the runtime, of the table of Python's own."""
        lines = []
        for node in self.module.tree.body:
            if isinstance(node, ast.ClassDef) and node.bases:
                lines.append(f"export class {node.name} extends {leaf(node.bases[0])} {{}}")
            elif isinstance(node, ast.ClassDef) and (head := _CLASSES.get(node.name)):
                self.own = set(re.findall(r"\b[A-Z]\b", head))
                body = self._methods(Found(self.module, node), _ELSEWHERE.get(node.name, ()))
                close = "} }" if head.startswith("declare") else "}"
                lines.append("\n".join([f"{head} {{", *body, _ALSO.get(node.name, ""), close]))
        self.own = set()
        lines += (
            f"export function {node.name}{self._signature(node)};"
            for node in self.module.tree.body
            if isinstance(node, ast.FunctionDef) and node.name in ("bytes", "dict")
        )
        return _RUNTIME + "\n".join(lines)

    def _top(self, name: str, node: ast.AST) -> Iterator[str]:
        if isinstance(node, ast.ClassDef):
            of = Found(self.module, node)
            yield from self._enumeration(of) if of.is_enum else self._class(of)
        elif isinstance(node, ast.FunctionDef):
            yield f"export function {named(name)}{self._signature(node)};"
        else:
            yield f"export const {named(name)}: {self.written(self._named_type(ast.Name(name)))};"

    def _enumeration(self, of: Found) -> Iterator[str]:
        names = " | ".join(f'"{name}"' for each in of.node.body for name in targets(each))
        value = self.written(self.plain(of.kind))
        yield f"export type {of.node.name} = {value};"
        yield f"export const {of.node.name}: Iterable<{value}> & {{ readonly [name in {names}]: {value} }};"

    def _class(self, of: Found) -> Iterator[str]:
        node, self.owner = of.node, of.kind.name
        protocol = of.kind in self.program.protocols
        bases = (self.program.find(self.module, leaf(each)) for each in node.bases)
        extends = "".join(f" extends {self._named(each)}" for each in bases if each)
        yield f"export {'interface' if protocol else 'class'} {named(node.name)}{extends} {{"
        fields = dict(self.fields_of(of)) if of.fields is not None else {}
        if of.fields is not None:
            own = [(each.name, fields[each.name], each.default) for each in self.program.fields(of)]
            yield f"constructor({self._parameters(own)});"
        if of.is_tuple:
            of_all = " | ".join(dict.fromkeys(map(self.written, fields.values())))
            yield f"[Symbol.iterator](): ArrayIterator<{of_all}>;"
        inherited = {name for each in [*self.program.lineage(of)][1:] for name in each.members}
        static = () if fields or protocol else {name for part in node.body for name in targets(part)}
        methods = {part.name for part in node.body if isinstance(part, ast.FunctionDef)}
        for name in sorted(of.members - methods - inherited):
            if name[0] != "_":
                attribute = f"{member(name)}: {self.written(self.of_class(self.owner, name)[0])};"
                yield attribute
                if name in static:
                    yield f"static {attribute}"
        yield from self._methods(of, self.module.omitted)
        yield "}"
        self.owner = ""

    def _methods(self, of: Found, omitted: Iterable[str]) -> Iterator[str]:
        """Yield the methods of a class, overloaded ones in each of their forms."""
        for name, node in of.declared.items():
            if not isinstance(node, ast.FunctionDef) or name in omitted:
                continue
            method = of._replace(node=node)
            forms = self.program.variants(method)
            returned = self.written(self.annotated(node.returns))
            if name == "__init__":
                yield f"constructor{self._signature(forms[-1].node).rpartition(':')[0]};"
            elif name in _JAVASCRIPT:
                yield f"{_JAVASCRIPT[name]}: {returned};"
            elif method.is_property:
                yield f"{'readonly ' if method in forms else ''}{member(name)}: {returned};"
            elif name[0] != "_" or name in ("__getitem__", "__setitem__"):
                for form in forms:
                    signature = f"{member(name)}{self._signature(form.node)};"
                    yield signature
                    if method.is_static:
                        yield f"static {signature}"

    def _signature(self, node: ast.FunctionDef) -> str:
        kinds = self.parameters(node)
        own = [each for each in Found(self.module, node).parameters if each.name != "self"]
        written = self._parameters([(each.name, kinds[each.name], each.default) for each in own])
        returned = self.written(self.annotated(node.returns))
        text = f"({written}): {'void' if returned == 'null' else returned}"
        free = sorted({*re.findall(r"\b[A-Z]\b", text)} - self.own)
        return f"<{', '.join(free)}>{text}" if free else text

    def _parameters(self, given: list[tuple[str, Type, ast.expr | None]]) -> str:
        """Return parameters, of (name, type, default): the last ones that have a default may be left out."""
        found, last = list[str](), True
        for name, kind, default in reversed(given):
            last = last and default is not None
            text = self.written(kind) + (" | undefined" if default is not None and not last else "")
            found.append(f"{named(name)}{'?' * last}: {text}")
        return ", ".join(reversed(found))

    def written(self, kind: Type) -> str:
        """Return a type as TypeScript has it."""
        if kind.name[0] == "~":
            return kind.name[1:]
        of = self.program.classes.get(kind.name)
        if of and of.ours:
            return self._named(of)
        inner = [*map(self.written, kind.of)]
        if kind.name == "|":
            return " | ".join(dict.fromkeys(inner))
        if kind.name == "call":
            takes = (f"a{at}: {each}" for at, each in enumerate(inner[1:]))
            return f"(({', '.join(takes)}) => {'void' if inner[0] == 'null' else inner[0]})"
        if kind.name in _OF:
            return _OF[kind.name].format(", ".join(inner))
        return _NAMES.get(kind.name) or self._named(self.program.classes[kind.name])

    def _named(self, of: Found) -> str:
        """Return the name of a class, through its module if it is another's."""
        name = named(of.node.name)
        if not of.ours:
            return f"$.{name}"
        if of.module is self.module:
            return name
        self.used.add(of.module.name)
        return f"{of.module.name.replace('.', '_')}.{name}"


def declare(modules: dict[str, tuple[str, str]], omitted: dict[str, str]) -> dict[str, str]:
    """Return the declarations of each of the `modules` and of the runtime, {name: text}; see `translate`."""
    read = [Module(name, *source, omitted.get(name, "").split()) for name, source in modules.items()]
    program = Program(read)
    found = {name: Declarations(program, module).text() for name, module in program.modules.items()}
    own = Declarations(program, program.library["builtins"])
    return found | {"pdp8.web.translator.runtime": own.runtime()}
