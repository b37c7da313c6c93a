"""Calls: of our own functions and classes, and of what library.pyi has of Python's.

A function's `*args` are one array, its `**kwargs` one Dict; keyword arguments take the places of the
function's parameters. What an argument of Python's own functions must be beside its type is marked in
library.pyi: `Ordered[...]`, `Literal[...]`.
"""

import ast
import re

from pdp8.web.translator.expressions import MOST, Expressions, member
from pdp8.web.translator.program import Found, Parameter
from pdp8.web.translator.types import (
    ANY,
    BOOL,
    FLOAT,
    INT,
    MUTABLE,
    NONE,
    NUMBERS,
    STR,
    UNSEEN,
    WHOLE,
    WORD,
    Type,
    either,
    filled,
    leaf,
    whole,
)

_AT_ONCE = (
    "sum", "list", "tuple", "set", "frozenset", "sorted", "join", "dict", "bytes", "bytearray", "max", "min",
)  # fmt: skip
"""Functions that take all of a generator before anything else happens: it is written as a list."""
_UNORDERED = ("set", "frozenset", "sorted", "sum")
"""Functions within which a generator may run over a set: its order does not matter."""
_KINDS = ("int", "float", "bool", "str", "list", "tuple", "bytes", "bytearray", "dict")
_UNSURE = {
    "int": {"float", "real", "?"},
    "float": {"int", "word", "real", "?"},
    "list": {"tuple", "row", "sequence", "iterable", "?"},
    "tuple": {"list", "sequence", "iterable", "?"},
}
"""For each class, the types of which JavaScript cannot say whether they are of that class."""


class Calls(Expressions):
    """Writes the calls of one module."""

    def call(self, node: ast.Call) -> str:
        """Return a call."""
        function, name = node.func, leaf(node.func)
        match node:
            case ast.Call(ast.Attribute(of, "_replace"), [], [_, *_]):
                return self._replaced(node, of)
            case ast.Call(ast.Name("replace"), [of], [_, *_]):
                return self._replaced(node, of)
            case ast.Call(ast.Name()) if name not in self.scope and (text := self._built_in(node, name)):
                return text
        found = self.found(function)
        if self.after_super(function):
            if found is None:
                self.fail(node, "no base class has such a method")
            return f"super.{name}({self._arguments(node, found)})"
        self.infer(node)  # what it says of the functions it is given
        if found and not found.ours and not found.is_module:
            return self._library(node, found)
        if isinstance(function, ast.Attribute):
            self.attributed(function)
        elif isinstance(function, ast.Name) and name not in self.scope and found is None:
            self.fail(node, f"the table of what may be used has no {name}")
        if found is None or not (found.is_function or found.is_class):
            found, kind = None, self.infer(function)
            if any(each.name != "call" for each in either(kind)):
                self.refuse(node, f"a call of {kind}", "an annotation")
            if node.keywords:
                self.fail(node, "keywords for a function of unknown parameters", "them by their places")
            for _, *takes in (each.of for each in either(kind) if each.of[1:]):
                args = self.arguments_of(node.args)
                inner = self.inner.get(name) if isinstance(function, ast.Name) else None
                fits = self.paired(Found(self.module, inner), node) if inner else len(takes) == len(args)
                if fits in (None, False):
                    self.refuse(node, "too many arguments, or too few")
                for value, wanted in zip(args, takes, strict=False):
                    self.accept(value, wanted)
        elif found.is_enum:
            self.fail(node, "a member of an enumeration by its value")
        elif isinstance(function, ast.Attribute) and len(kinds := either(self.infer(function.value))) > 1:
            for each in kinds:
                method = self.of_class(each.name, name)[1]
                if method and [*map(_called, method.parameters)] != [*map(_called, found.parameters)]:
                    self.refuse(node, f"{name} of {each} has other parameters", "a method for each")
                if method and method is not found:
                    self._typed(node, method)
        new = "new " if found and found.is_class else ""
        text = f"{new}{self.dotted(function)}({self._arguments(node, found)})"
        self.held = {key: kind for key, kind in self.held.items() if self._stays(key)}
        return text

    def _replaced(self, node: ast.Call, of: ast.expr) -> str:
        """Return a record with some of its fields replaced."""
        kind = self.infer(of)
        found = self.ours(kind)
        fields = dict(self.fields_of(found)) if found else {}
        for keyword in node.keywords:
            if keyword.arg not in fields:
                self.fail(node, f"{kind} has no field {keyword.arg}")
            self.accept(keyword.value, fields[keyword.arg])
        text = (f"{keyword.arg}: {self.e(keyword.value)}" for keyword in node.keywords)
        return f"$.replaced({self.e(of)}, {{ {', '.join(text)} }})"

    # What Python has of its own.

    def _built_in(self, node: ast.Call, name: str) -> str:
        """Return a call of one of Python's own functions that is written in its own way; "" of others."""
        found = self.found(node.func)
        if found:
            return "" if found.ours else self._of_the_table(node, name, found)
        match name, node.args:
            case "isinstance", [value, of]:
                return self._is_instance(node, value, of)
            case "getattr", [value, ast.Constant(str(attribute))]:
                return self.e(ast.copy_location(ast.Attribute(value, attribute, ast.Load()), node))
            case "getattr" | "setattr" | "type", _:
                self.refuse(node, f"{name}() of what is known only when it runs")
                return f"$.{name}({self.all(node.args)})"
        return ""

    def _of_the_table(self, node: ast.Call, name: str, found: Found) -> str:
        kinds = [self.infer(each) for each in node.args]
        match name, node.args:
            case "divmod", [_, _] if FLOAT in kinds:
                return f"$.divmod_({self.all(node.args)})"
            case "sum", [_] if self.infer(node) == INT:
                return self._library(node, found, "total")
            case "len", [value]:
                self.known(value)
                if self.bound(found, node) is None:
                    self.refuse(node, f"the length of {kinds[0]}")
                is_array = self.parts(kinds[0]) is None or kinds[0].name == "tuple"
                return f"{self.e(value)}.length" if is_array else f"$.len({self.e(value)})"
            case (("str" | "repr"), [value]) if not node.keywords:
                return self.shown(self.e(value), kinds[0], node, name == "repr")
            case "str", [] if not node.keywords:
                return '""'
            case "bool", [value]:
                text = self.test(value)
                return text if kinds[0] == BOOL else f"!!{text}" if text[0] in "!($" else f"!!({text})"
            case (("min" | "max"), [_, _, *_]) if not node.keywords:
                return self._least(node, name, kinds)
            case (("any" | "all"), [ast.GeneratorExp(value, generators)]):
                no, decides, else_ = ("", "true", "false") if name == "any" else ("!", "false", "true")
                put = f"if ({no}{{}}) return {decides};"
                loops = self.comprehended(generators, value, put, test=True, ordered=False)
                return f"(() => {{ {loops} return {else_}; }})()"
            case "next", [ast.GeneratorExp(value, generators), *rest] if all(map(_is_simple, rest)):
                after = f"return {self.e(rest[0])};" if rest else "throw new $.StopIteration();"
                return f"(() => {{ {self.comprehended(generators, value, 'return {};')} {after} }})()"
            case "chr", [value] if (code := whole(value) or 0) > 0xFFFF or 0xD800 <= code < 0xE000:
                self.fail(node, "a character beyond U+FFFF has another length in JavaScript")
            case "zip", _ if node.keywords:
                [strict] = node.keywords
                if not isinstance(strict.value, ast.Constant):
                    self.fail(node, "strict has to be True")
                plain = ast.copy_location(ast.Call(node.func, node.args, []), node)
                return self._library(plain, found, "zip_strict" if strict.value.value else "zip")
        return ""

    def _least(self, node: ast.Call, name: str, kinds: list[Type]) -> str:
        """Return the least or the largest of several arguments."""
        if any(isinstance(each, ast.Starred) for each in node.args):
            return ""
        if set(kinds) <= {*WHOLE} and not any(map(self._is_large, node.args)):
            return f"Math.{name}({self.all(node.args)})"
        kind = self._joined(node.args)
        self.orderable(node, kind, kind)
        if not self.checked and set(kinds) <= {*NUMBERS}:
            return f"Math.{name}({self.all(node.args)})"
        return f"$.{name}([{self.all(node.args)}])"

    def _is_large(self, node: ast.expr) -> bool:
        """Whether a whole number may be beyond 2^53."""
        return self.infer(node) != WORD and abs(whole(node) or MOST) >= MOST

    def _is_instance(self, node: ast.Call, value: ast.expr, of: ast.expr) -> str:
        kind, texts = self.infer(value), []
        names = {each.name for each in either(kind)}
        for each in of.elts if isinstance(of, ast.Tuple) else [of]:
            name, found = leaf(each), self.found(each)
            if not isinstance(each, ast.Name | ast.Attribute):
                self.fail(node, instead="a tuple of classes")
            if not found or not (found.is_class or (name in _KINDS and not found.ours)):
                self.fail(node, f"isinstance of {name}")
            ours = found.ours
            if found.is_enum or found.kind in self.program.protocols:
                self.fail(node, f"isinstance of {name}")
            is_tuple = name in ("tuple", "list") and any(self.parts(Type(one)) is not None for one in names)
            if is_tuple or names & _UNSURE.get(name, set()):
                why = f"JavaScript cannot tell isinstance({kind}, {name})"
                self.refuse(node, why, "an annotation")
            texts.append(self.dotted(each) if ours else f"$.{'list' if name == 'tuple' else name}")
        return f"$.isinstance({self.e(value)}, {one_or_several(texts)})"

    def _library(self, node: ast.Call, found: Found, instead: str = "") -> str:
        """Return a call of what Python has of its own, if its arguments are those of the table.

        `instead` is what the runtime has for it, if that has another name.
        """
        name, before, receiver = leaf(node.func), None, None
        if isinstance(node.func, ast.Attribute):
            before = self.found(node.func.value)
            if not before or (before.ours and not before.is_module):
                self.attributed(node.func)
                receiver = self.known(node.func.value)
            elif not before.is_module and not found.is_static:
                self.fail(node, "a method without what it is a method of")
        if found.is_class:
            if len(node.args) > 1 or node.keywords:
                self.fail(node, "an error of several arguments", "one text")
            if any(self.infer(each) != STR for each in node.args):
                self.refuse(node, "an error whose argument is no text", "a text")
            if name == "KeyError" and not node.args:
                self.fail(node, "a KeyError without a key", "a text")
            return f"new $.{name}({self.all(node.args)})"
        if any(isinstance(each, ast.Starred) for each in node.args):
            self.fail(node, f"unpacked arguments of {name}", "each by itself")
        for kind in either(receiver) if receiver else (ANY,):
            method = self.of_class(kind.name, name)[1] or found
            form, fitting = self.form(method, node, kind)
            if fitting is None:
                given = ", ".join(str(self.infer(each)) for each in node.args)
                forms = (ast.unparse(each.node.args) for each in self.program.variants(method))
                taken = " or ".join(f"{name}({each})" for each in forms)
                self.refuse(node, f"{name} of ({given}) is not in the table", taken)
            takes = self.of_receiver(form, kind)
            for value, parameter in self.paired(form, node) or []:
                self._marked(node, value, parameter, kind)
                if takes and leaf(parameter.annotation) not in ("Compared", "Key"):  # what is looked for
                    if kind.name in MUTABLE and UNSEEN in kind.of:
                        self.refuse(node, "nothing says what it holds", "an annotation")
                    self.accept(value, filled(self.annotated(parameter.annotation, form.module), takes))
        arguments = self._arguments(node, form)
        if isinstance(node.func, ast.Attribute):
            if receiver:
                return f"{self.before_the_dot(node.func.value)}.{member(name)}({arguments})"
            if before and before.is_module and before.module.table not in ("json", "re"):
                return f"$.{name}({arguments})"
            return f"$.{leaf(node.func.value)}.{name}({arguments})"
        return f"$.{instead or self.module.imports.get(name, ('', name))[1]}({arguments})"

    def _marked(self, node: ast.Call, value: ast.expr, parameter: Parameter, receiver: Type) -> None:
        """Refuse an argument that is not as the table marks its parameter."""
        kind = self.infer(value)
        annotation = parameter.annotation
        match leaf(annotation):
            case "Literal" if annotation:
                allowed = [each.value for each in ast.walk(annotation) if isinstance(each, ast.Constant)]
                if not isinstance(value, ast.Constant) or value.value not in allowed:
                    self.fail(value, "it has to be one of the table", " or ".join(map(repr, allowed)))
                if value.value == "backslashreplace" and getattr(node.args[0], "value", "") != "utf-8":
                    self.fail(value, "it has to be one of the table", "'replace', or encode to utf-8")
            case "Ordered":
                kind = kind.of[0] if kind.name == "call" else self.item(kind)
                self.orderable(node, kind, kind)
            case "Compared":
                self.comparable(node, kind, self.item(receiver))
            case "Key" | "New":
                self.key(node, kind, receiver)
            case "Keys":
                self.keyed(node, self.item(kind))
            case "JSON" if not self._is_json(kind):
                self.refuse(node, f"JSON of {kind}", "texts, whole numbers, lists and dicts")
            case "Character" if len(str(getattr(value, "value", ""))) != 1:
                self.fail(node, "what fills is not one character")
            case "Written" if not _is_read_alike(str(getattr(value, "value", ""))):
                self.refuse(node, "a pattern that JavaScript reads otherwise", "classes as [0-9]")
            case "Base" if whole(value) not in (None, 2, 8, 10, 16):
                self.fail(node, "a base other than 2, 8, 10 and 16")

    def _is_json(self, kind: Type) -> bool:
        """Whether both languages write a value of this type as the same JSON."""
        if kind.name in ("|", "list", "tuple", "row"):
            return all(map(self._is_json, kind.of))
        if kind.name == "dict":
            return kind.of[0] in (STR, UNSEEN) and self._is_json(kind.of[1])
        return kind in (WORD, INT, BOOL, NONE, STR, UNSEEN)

    # Arguments.

    def _arguments(self, node: ast.Call, found: Found | None) -> str:
        """Return the arguments of a call, those by keywords in the places of the parameters."""
        ours = found is not None and found.ours
        at_once = found is not None and not ours and leaf(node.func) in _AT_ONCE
        values = [self._argument(each, leaf(node.func) if at_once else "") for each in node.args]
        parameters = self.program.signature(found)
        if found:
            self._typed(node, found)
        starred = [at for at, each in enumerate(node.args) if isinstance(each, ast.Starred)]
        places = [each.name for each in parameters or [] if each.how in ("", "/")]
        rest = {each.how: each.name for each in parameters or []}
        names = [*places]
        if "*" in rest and ours:
            if starred and starred[0] < len(places):
                self.fail(node, "an unpacked argument before others")
            missing = len(places) - len(values)
            rest_of_all = ", ".join(values[len(places) :])
            values = [*values[: len(places)], *["undefined"] * missing, f"[{rest_of_all}]"]
            names.append(rest["*"])
        elif parameters is not None and len(values) > len(places):
            self.fail(node, "too many arguments")
        elif node.keywords and starred:
            self.fail(node, "an unpacked argument before keywords")
        names += [each.name for each in parameters or [] if each.how == "key"]
        given = {each.arg or "": each.value for each in node.keywords}
        if "**" in rest:
            more = [each for each in node.keywords if each.arg not in names]
            keys: list[ast.expr | None] = [ast.Constant(each.arg) if each.arg else None for each in more]
            if None in keys and not {*names[len(values) :]} <= given.keys():
                self.fail(node, "unpacked keywords, of which one may be a parameter")
            names.append(rest["**"])
            given = {name: value for name, value in given.items() if name in names}
            given[rest["**"]] = ast.Dict(keys, [each.value for each in more])
        if given.keys() - set(names):
            self.fail(node, "keywords that are no parameters")
        order = [names.index(each) for each in given]
        calling = sum(any(isinstance(part, ast.Call) for part in ast.walk(each)) for each in given.values())
        if order != sorted(order) and calling > 1:
            self.fail(node, "keywords in another order than the parameters", "them in that order")
        by_name = names[len(values) : max(order, default=-1) + 1]
        values += (self.e(given[name]) if name in given else "undefined" for name in by_name)
        return ", ".join(values)

    def _argument(self, node: ast.expr, at_once: str) -> str:
        """Return an argument: a generator as a list, for what takes it `at_once`."""
        if at_once and isinstance(node, ast.GeneratorExp):
            return self.listed(node.generators, node.elt, at_once not in _UNORDERED)
        return self.e(node)

    def _typed(self, node: ast.Call, found: Found) -> None:
        """Refuse too many arguments or too few, and values of other types than a record's fields have."""
        forms = self.program.variants(found) if found.is_function else [found]
        pairs = [self.paired(each, node) for each in forms]
        if not any(each is not None for each in pairs):
            parameters = [each for form in forms for each in self.program.signature(form) or []]
            names = {each.name for each in parameters}
            if "**" not in {each.how for each in parameters} and {each.arg for each in node.keywords} - names:
                self.refuse(node, "keywords that are no parameters")
            if any(isinstance(each, ast.Starred) for each in self.arguments_of(node.args)):
                self.refuse(node, "what is unpacked may have another length", "a tuple")
            self.refuse(node, "too many arguments, or too few")
        if found.ours:
            form = self.form(found, node, None)[0] if found.is_function else found
            for value, parameter in self.paired(form, node) or []:
                self.accept(value, self.annotated(parameter.annotation, parameter.module))


def _is_read_alike(pattern: str) -> bool:
    """Whether both languages read a regular expression alike."""
    plain = re.sub(r"\\[nrtf\\.*+?()\[\]{}|^$/]", "-", pattern)
    dots = re.sub(r"\[[^\]]*\]", "", plain)
    return (
        not re.search(r"\\|\(\?[^:=!<]|\(\?<[^=!]", plain)
        and not re.search("[.$]", dots)
        and not re.match(pattern, "")
    )


def _called(parameter: Parameter) -> tuple[str, str]:
    return parameter.how, parameter.name


def _is_simple(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant | ast.Name)


def one_or_several(texts: list[str]) -> str:
    """Return a text, or several as an array."""
    return texts[0] if len(texts) == 1 else f"[{', '.join(texts)}]"
