"""A page in one file: its scripts of many modules, its style, and what it may do.

    entry.mjs ──imports──► modules by hand ──┐
        │                     │ import       ├──► one script, each module in a scope of its own
        │     pal/assembler.py as .mjs ──────┘    style, data as compressed JSON, Content-Security-Policy
        └──import()──────► more modules ─────────► a second script, unpacked when it is wanted

A module X.mjs is the one by hand, or the translation of X.py (see translator/). A page from disk cannot
import modules, so they stand in scripts, each after those it imports from, without their comments.
"""

import base64
import hashlib
import json
import posixpath
import re
import zlib
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from importlib.resources import files
from typing import Any

from pdp8.web import translator
from pdp8.web.names import COMMENT, EXPORT, IMPORT, exported, exports, mentioned, needed
from pdp8.web.names import faults as faults_of

_HERE = "pdp8/web/"
_LATER = re.compile(r'\bimport\("(\.[\w./-]+)\.mjs"\)')
_INCLUDED = re.compile(r"<!-- ([\w/]+\.html) -->")
_INLINE = re.compile(r"<script>(.*?)</script>", re.DOTALL)
_RUNTIME = f"{_HERE}translator/runtime"


@cache
def source(name: str) -> str:
    """Return the text of a file of this package."""
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


def included(name: str) -> str:
    """Return the text of an HTML file with those that it includes."""
    return _INCLUDED.sub(lambda part: source(part[1]).rstrip(), source(name))


def module(name: str) -> str:
    """Return a module by its path in the repository, such as pdp8/web/workbench or pal/isa."""
    python = translator.translated().get(name.replace("/", "."))
    return python if python is not None else source(f"{name.removeprefix(_HERE)}.mjs")


def modules(entry: str) -> dict[str, str]:
    """Return the module `entry` of this package and all it imports, {path: text}, each after its imports."""
    found: dict[str, str] = {}
    _collect(_HERE + entry, found)
    return found


def scripts(entry: str) -> tuple[str, str]:
    """Return two scripts: `entry` with what it imports, which runs at once, and what it imports later."""
    first = modules(entry)
    text = first.pop(_HERE + entry)
    every = dict(first)
    for path in _LATER.findall(text):
        _collect(_path(_HERE + entry, path), every)
    every = _used(every, text)
    every[_RUNTIME] = _used_of_the_runtime(every[_RUNTIME], [text, *every.values()])
    first, later = {name: every.pop(name) for name in first}, every
    named = _LATER.sub(lambda match: f"pack.later(() => {_identifier(_path(_HERE + entry, match[1]))})", text)
    return _script(first, f"(() => {{\n{_body(_HERE + entry, named)}\n}})();"), _script(later)


def _used(every: dict[str, str], entry: str) -> dict[str, str]:
    """Return the modules, each after its imports; of those that are translated only what is used."""
    used = mentioned(entry)
    for name in reversed([*every]):
        if name.replace("/", ".") in translator.translated():
            every[name] = exported(every[name], used)
        used |= mentioned(every[name])
    return every


def _used_of_the_runtime(runtime: str, texts: Iterable[str]) -> str:
    """Return the runtime, as far as the modules `texts` need it."""
    used, called = set[str](), set[str]()
    for text in texts:
        if text is not runtime:
            used.update(re.findall(r"\$\.(\w+)", text))
            called.update(re.findall(r"\.(\w+)", text))
            used.update(
                *(re.findall(r"\w+", what) for what, path in IMPORT.findall(text) if "runtime" in path)
            )
    return needed(runtime, used, called)


def faults() -> list[str]:
    """Return what is wrong with the names of all modules: declared twice, or imported and not there."""
    folder = files(__package__)
    entries = (each.name.removesuffix(".mjs") for each in folder.iterdir() if each.name.endswith(".mjs"))
    texts: dict[str, str] = {}
    found: list[str] = []
    for entry in entries:
        _every(_HERE + entry, texts)
    for name, text in sorted(texts.items()):
        paths = {path: _path(name, path) for _, path in IMPORT.findall(text)}
        given = {path: exports(texts[at]) for path, at in paths.items() if at in texts}
        by_hand = name.replace("/", ".") not in translator.translated()
        found += faults_of(f"{name}.{'mjs' if by_hand else 'py'}", text, given, by_hand)
    return found


def _every(name: str, found: dict[str, str]) -> None:
    """Find the module `name` and all that it imports, at once or later, as far as they are there."""
    if name in found:
        return
    with suppress(OSError):
        found[name] = module(name)
        for path in (*(path for _, path in IMPORT.findall(found[name])), *_LATER.findall(found[name])):
            _every(_path(name, path), found)


def _script(texts: dict[str, str], end: str = "") -> str:
    return "\n".join(['"use strict";', *(_scope(name, text) for name, text in texts.items()), end])


def _collect(name: str, found: dict[str, str]) -> None:
    if name in found:
        return
    text = module(name)
    for _, path in IMPORT.findall(text):
        _collect(_path(name, path), found)
    found[name] = text


def _path(name: str, path: str) -> str:
    """Return the module that the module `name` calls `path`."""
    return posixpath.normpath(posixpath.join(posixpath.dirname(name), path))


def _scope(name: str, text: str) -> str:
    """Return `text` as a constant that contains its exports; private names stay within."""
    exported = ", ".join(each for each in exports(text) if not each.startswith("_"))
    return f"const {_identifier(name)} = (() => {{\n{_body(name, text)}\nreturn {{ {exported} }};\n}})();"


def _body(name: str, text: str) -> str:
    """Return `text` with its imports replaced by constants of earlier modules."""

    def constant(match: re.Match[str]) -> str:
        names = match[1].removeprefix("* as ").replace(" as ", ": ")
        return f"const {names} = {_identifier(_path(name, match[2]))};"

    return EXPORT.sub("", IMPORT.sub(constant, COMMENT.sub("", text)))


def _identifier(name: str) -> str:
    return re.sub(r"\W", "_", name.removeprefix(_HERE)) + "_module"


def page(
    title: str, body: str, styles: Iterable[str], entry: str, data: Any, more: Any = None, kind: str = ""
) -> str:
    """Return the page with HTML file `body`, compressed scripts and data inside, and a policy that forbids
    the network; `more` is data for the second script, `kind` the body's class.
    """
    code, later = scripts(entry)
    start = source("start.js")
    whole = included(body)
    parts = {
        "title": title,
        "kind": kind,
        "policy": _policy(code, later, start, *_INLINE.findall(whole)),
        "body": whole,
        "style": "".join(map(source, ("base.css", *styles))),
        "code": _packed(code),
        "record": _packed(_json(data)),
        "later": _packed(later),
        "more": _packed(_json(more)),
        "start": start,
    }
    return re.sub(r"<!-- (\w+) -->", lambda part: parts[part[1]], source("shell.html"))


def _json(data: Any) -> str:
    return json.dumps(data, separators=(",", ":"), ensure_ascii=False)


def _packed(text: str) -> str:
    """Return `text` compressed (deflate, in short blocks or long ones, as is shorter) and in base64."""
    data = text.encode()
    made = [zlib.compressobj(9, zlib.DEFLATED, -15, memory) for memory in (4, 8)]
    shortest = min((each.compress(data) + each.flush() for each in made), key=len)
    return base64.b64encode(shortest).decode("ascii")


def _policy(*scripts: str) -> str:
    digests = (base64.b64encode(hashlib.sha256(each.encode()).digest()).decode("ascii") for each in scripts)
    rules = (
        "default-src 'none'",
        "script-src " + " ".join(f"'sha256-{digest}'" for digest in digests),
        "style-src 'unsafe-inline'",
        "img-src data: blob:",
        "worker-src blob:",
        "base-uri 'none'",
        "form-action 'none'",
        "require-trusted-types-for 'script'",
        "trusted-types page start",
    )
    return f'<meta http-equiv="Content-Security-Policy" content="{"; ".join(rules)}">'
