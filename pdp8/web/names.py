"""The names of JavaScript modules: what each declares, exports and imports; what of a module is needed.

A page's modules stand in one script, where a name that is declared twice, or imported and not there, is an
error that stops everything. It is found here, without Node.js or a browser.
"""

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from itertools import compress

IMPORT = re.compile(r'^import (\{[^}]*\}|\* as [\w$]+) from "(\.[\w./-]+)\.mjs";$', re.MULTILINE)
EXPORT = re.compile(
    r"^export (?=(?:class|const|function\*?|async function) ([\w$]+|\{[^}]*\}))", re.MULTILINE
)
COMMENT = re.compile(
    r"""/\*\* @type [^*\n]*\*/ |^\s*(?://.*|/\*\*(?:[^*]|\*(?!/))*\*/)\n"""
    r"""|^[ \t]+|^\n|(?<=[;,{}\[\])]) // [^"'`\n]*$""",
    re.MULTILINE,
)
_DECLARED = re.compile(
    r"^(?:export )?(?:const|let|class|function\*?|async function) ([\w$]+|\{[^}]*\})", re.MULTILINE
)
_WORD = re.compile(r"(?<![\w$])(?<!(?<!\.)\.)[A-Za-z_$][\w$]*(?!\w*:)")  # `...x`, but not `a.x` nor `x: 1`
_GIVEN = re.compile(r"^give\((?:String|Array), \{\n(.*?)^\}\);\n", re.MULTILINE | re.DOTALL)
_METHOD = re.compile(r"^(?=  \w+(?:\(|:)|\}\);)", re.MULTILINE)
_PART = re.compile(r"^(?=[^\s})/])", re.MULTILINE)
_EXPORTED = re.compile(r"^(?=export )", re.MULTILINE)


def exports(text: str) -> list[str]:
    """Return the names that a module exports, each declared by itself."""
    return list(_names(EXPORT.findall(text)))


def _names(found: Iterable[str]) -> Iterator[str]:
    """Yield the names of declarations: `a`, `{ b, c: d }`."""
    for names in found:
        yield from re.findall(r"([\w$]+)(?=\s*[,}]|$)", names)


def faults(path: str, text: str, given: Mapping[str, list[str]], by_hand: bool) -> Iterator[str]:
    """Yield what is wrong with the names of a module; `given` is what the modules it imports from export."""
    pattern = _DECLARED if by_hand else EXPORT  # what is translated has its functions' names at the margin
    declared = Counter(_names(pattern.findall(text)))
    for what, source in IMPORT.findall(text):
        if source not in given:
            yield f"{path}: there is no module {source}.mjs"
        elif what.startswith("* as "):
            declared[what[5:]] += 1
        else:
            for name, alias in re.findall(r"([\w$]+)(?: as ([\w$]+))?", what):
                declared[alias or name] += 1
                if name not in given[source]:
                    yield f"{path}: {source}.mjs exports no {name}"
    yield from (f"{path}: {name} is declared {times} times" for name, times in declared.items() if times > 1)


def _called(given: str, called: set[str]) -> Iterator[str]:
    """Yield the methods of a type that are called by their names, with what is around them."""
    for part in _METHOD.split(given):
        name = re.match(r"  (\w+)", part)
        if not name or name[1] in called:
            yield part


def needed(text: str, used: Iterable[str], called: Iterable[str]) -> str:
    """Return the runtime without functions that nothing uses and methods that are not `called`."""
    methods = {*re.findall(r"\.(\w+)", text), *called}
    text = _GIVEN.sub(lambda given: "".join(_called(given[0], methods)), text)
    return _needed(_PART.split(text), _DECLARED, used)


def exported(text: str, used: Iterable[str]) -> str:
    """Return a module that exports all it has, without what is not needed for `used`."""
    return _needed(_EXPORTED.split(text), EXPORT, used)


def _needed(parts: list[str], declared: re.Pattern[str], used: Iterable[str]) -> str:
    words = [frozenset(_WORD.findall(part)) for part in parts]
    own = [frozenset(_names(declared.findall(part))) for part in parts]
    wanted, before = set(used), set[str]()
    while wanted != before:
        before = set(wanted)
        kept = [not names or not names.isdisjoint(wanted) for names in own]
        wanted.update(*compress(words, kept))
    return "".join(compress(parts, kept))


def mentioned(text: str) -> set[str]:
    """Return every name in a module, those that it imports only as far as it uses them."""
    names = set(re.findall(r"[\w$]+", IMPORT.sub("", text)))
    given = (pair for what, _ in IMPORT.findall(text) for pair in re.findall(r"([\w$]+) as ([\w$]+)", what))
    return names | {name for name, alias in given if alias in names}
