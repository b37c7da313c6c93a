"""A page in one file: its script of many modules, its style, and what it may do.

    entry.mjs ──imports──► modules by hand ──┐
                              │ import       ├──► one script, each module in a scope of its own
              pal/assembler.py as .mjs ──────┘    style, data as compressed JSON, Content-Security-Policy

A module X.mjs is the one by hand, or the translation of X.py (see translator/). A page from disk cannot
import modules, so they stand in one script, each after those it imports from, without their comments.
"""

import base64
import hashlib
import json
import posixpath
import re
import zlib
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.resources import files
from typing import Any

from pdp8.web import translator

_HERE = "pdp8/web/"
_IMPORT = re.compile(r'^import (\{[^}]*\}|\* as [\w$]+) from "(\.[\w./-]+)\.mjs";$', re.MULTILINE)
_EXPORT = re.compile(
    r"^export (?=(?:class|const|function\*?|async function) ([\w$]+|\{[^}]*\}))", re.MULTILINE
)
_INCLUDED = re.compile(r"<!-- ([\w/]+\.html) -->")
_COMMENT = re.compile(r"^\s*(?://.*|/\*\*(?s:.*?)\*/)\n|^[ \t]+|^\n", re.MULTILINE)


@cache
def source(name: str) -> str:
    """Return the text of a file of this package."""
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


def module(name: str) -> str:
    """Return a module, by its path from the house, such as pdp8/web/workbench or pal/isa."""
    python = translator.translated().get(name.replace("/", "."))
    return python if python is not None else source(f"{name.removeprefix(_HERE)}.mjs")


def modules(entry: str) -> dict[str, str]:
    """Return the module `entry` of this package and all it imports, {path: text}, each after its imports."""
    found: dict[str, str] = {}
    _collect(_HERE + entry, found)
    return found


def script(entry: str) -> str:
    """Return the module `entry` and all it imports as one script; what `entry` does stands at its end."""
    return "\n".join(_scope(name, text, name == _HERE + entry) for name, text in modules(entry).items())


def _collect(name: str, found: dict[str, str]) -> None:
    if name in found:
        return
    text = module(name)
    for imported in _imported(name, text):
        _collect(imported, found)
    found[name] = text


def _imported(name: str, text: str) -> Iterator[str]:
    """Yield the modules that `text` imports from."""
    for _, path in _IMPORT.findall(text):
        yield posixpath.normpath(posixpath.join(posixpath.dirname(name), path))


def exports(text: str) -> list[str]:
    """Return the names that a module exports, each declared by itself."""
    return [name for names in _EXPORT.findall(text) for name in re.findall(r"[\w$]+", names)]


def _scope(name: str, text: str, bare: bool) -> str:
    """Return `text` as a constant that holds what it exports; its imports come from those before."""
    exported = ", ".join(exports(text))

    def constant(match: re.Match[str]) -> str:
        names = match[1].removeprefix("* as ").replace(" as ", ": ")
        path = posixpath.normpath(posixpath.join(posixpath.dirname(name), match[2]))
        return f"const {names} = {_identifier(path)};"

    body = _EXPORT.sub("", _IMPORT.sub(constant, _COMMENT.sub("", text)))
    return (
        body if bare else f"const {_identifier(name)} = (() => {{\n{body}\nreturn {{ {exported} }};\n}})();"
    )


def _identifier(name: str) -> str:
    return re.sub(r"\W", "_", name.removeprefix(_HERE)) + "_module"


def page(title: str, body: str, styles: Iterable[str], entry: str, data: Any) -> str:
    """Return the page with the HTML file `body`, its styles, script and data inside, and the policy for them.

    Script and data are compressed. The policy lets the page run its own script and style, and ask for
    nothing.
    """
    code, start = script(entry), source("start.js")
    written = json.dumps(data, separators=(",", ":"), ensure_ascii=False)
    parts = {
        "title": title,
        "policy": _policy(code, start),
        "body": _INCLUDED.sub(lambda part: source(part[1]).rstrip(), source(body)),
        "style": "".join(map(source, ("base.css", *styles))),
        "record": _packed(written),
        "code": _packed(code),
        "start": start,
    }
    return re.sub(r"<!-- (\w+) -->", lambda part: parts[part[1]], source("shell.html"))


def _packed(text: str) -> str:
    """Return `text` compressed (deflate) and in base64."""
    return base64.b64encode(zlib.compress(text.encode(), 9, wbits=-15)).decode("ascii")


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
