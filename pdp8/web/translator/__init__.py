"""Our Python as JavaScript modules: the typed subset in which the machine, PAL and the tapes are written.

    pal/assembler.py ──► syntax tree ──► types ──► expressions, statements, modules ──► pal/assembler.mjs
                                                                                           │ import
                                                                            runtime.mjs ───┘

types        the types of expressions
program      all modules: what each defines and imports, and where a name leads
library.pyi  what may be used of Python's own: functions, methods, their parameters
operators    for each operator: what it gives, and when JavaScript's own does it
inference    the type of each expression: from annotations, and from what is assigned
expressions  names, operators, comparisons, f-strings, comprehensions
calls        calls, and the functions of Python that are written in a way of their own
assigned     which names have a value
statements   assignments, loops, try
modules      imports, classes, functions
declarations what the modules declare, as TypeScript reads it
runtime.mjs  what Python has and JavaScript lacks

What has no translation is an error with its file and line. Names stay as they are. Numbers are exact to 2^53.
"""

from functools import cache
from importlib.resources import files

from pdp8.web.kept import kept
from pdp8.web.translator.declarations import declare
from pdp8.web.translator.modules import translate
from pdp8.web.translator.program import Untranslated
from tapes import codes

_CODES = sorted({type(code).__module__.removeprefix("tapes.") for code in codes.CODES})

MODULES = {
    "tapes": "binary code codes dectape dump errors expression frames hydrapoint quantities rim spelled text "
    + " ".join(_CODES),
    "pal": "assembler assembling assembly assembly3 diagnostics dialects disassembler isa listing meaning"
    " messages models notes punch recognition review source symbols table watched",
    "pal.pal8": "assembler assembly expressions lexer literals log operators output symbols table",
    "pdp8.computer": "machine stop watch",
    "pdp8.computer.hardware": "*",
    "pdp8.computer.dectape": "*",
    "pdp8.computer.speed": "engine piece waiting",
    "pdp8.computer.past": "history rewind state",
    "pdp8.computer.use": "bootstrap ending goals keys operator program trace",
    "pdp8.replay": "day script",
    "pdp8.lessons": "answer diagnosis drill evidence exercise hints marking minute page scores trial values"
    " where",
    "nc": "blocks machine path",
    "programs": "arithmetic circle curve die drawn drill ellipse fluidic format function header milling"
    " piecewise points polynomial printout profile slope stepwise stretches units",
    "pdp8.web": "findings loosened method passing translation",
}
"""What is translated: of each package some modules, or all."""

OMITTED = {
    "pal.assembly": "__iter__ __repr__ _repr_html_",
    "pal.meaning": "of_name names names8 _FIELDS _MARKS _PSEUDO _WORDS",
    "pdp8.computer.machine": "__reduce__ __repr__ _copied count slices",
    "pdp8.computer.past.history": "PipedHistory",
    "pdp8.computer.past.state": "core",
    "pdp8.computer.use.ending": "rerun",
    "pdp8.computer.use.program": "notes_on",
    "pdp8.replay.day": "Day PACE PROGRAMS WALK_SECONDS CLAMP_SECONDS MEASURE_SECONDS _SLICE Judgement",
    "nc.path": "__repr__ array efficiency",
    "pdp8.lessons.page": "html _STYLE",
    "pdp8.lessons.scores": "table _cell",
    "programs.arithmetic": "Float FloatingPoint IEEE32 CDC6400 GE635 PDP8 ARITHMETICS _word _half_up"
    " _magnitude_bits _normal _towards_zero _chopped _floored _nearest _quotient _root _EXTRA",
}
"""What is left out of the translation: code for notebooks, files and pickles, which a page does not have."""

COMPILED = frozenset(
    f"{package}.{name}"
    for package, names in {
        "pal": "assembler isa listing notes source table",
        "pal.pal8": "assembler expressions lexer literals log operators output table",
        "pdp8.computer.hardware": "bus processor teletype",
        "pdp8.computer.speed": "engine piece waiting",
    }.items()
    for name in names.split()
)
"""What is compiled to C too, with numbers of 64 bits, here of 53, and with unchecked indexes."""

TRUSTED = {
    "tapes.errors": "visible called",
    "tapes.dump": "_LIST",
    "pal.source": "_utf_8",
    "pal.pal8.assembly": "_TOKEN",
    "pal.listing": "object_tape listing _statement",
    "pal.review": "notes",
    "pdp8.computer.hardware.core": "allowed _addresses Core.__setitem__",
    "pdp8.computer.machine": "Machine.put Machine._check_watched",
    "pdp8.computer.hardware.fields": "walk take put changed",
    "pdp8.computer.hardware.panel": "shares",
    "pdp8.computer.speed.waiting": "Left",
    "pdp8.computer.dectape.tc08": "TC08.__init__",
    "pdp8.computer.past.state": "save _written restore _parsed _memory _check_device _fields _number"
    " _octal _frames _short",
    "pdp8.computer.past.rewind": "_check _before",
    "pdp8.computer.use.operator": "Operator",
    "pdp8.replay.script": "Script",
    "pdp8.lessons.diagnosis": "sequence first_difference _parity",
    "pdp8.lessons.drill": "Coach",
    "pdp8.lessons.page": "_WRAPPED",
    "programs.function": "centre_path offset_path",
    "programs.piecewise": "Technique._kept",
    "programs.profile": "beside_oval",
}
"""Functions in which values of unknown type (of JSON, of any field, any number) are checked at run time.
Tests compare what each of them does in both languages."""


@cache
def translated(checked: bool = False) -> dict[str, str]:
    """Return the JavaScript of all modules, {name: text}, from the cache if no source has changed.

    `checked`, the form that tests run: in what is COMPILED too every index and number is looked at.
    """
    sources, unchecked = _sources(), frozenset[str]() if checked else COMPILED
    content = repr((sources, OMITTED, TRUSTED, sorted(unchecked), _own()))
    name = "checked" if checked else "translated"
    made = lambda: translate(sources, OMITTED, unchecked=unchecked, trusted=TRUSTED)  # noqa: E731
    return dict(kept(name, content, made))


@cache
def declared() -> dict[str, str]:
    """Return what all modules and the runtime declare for TypeScript, {name: text}, from the same cache."""
    sources = _sources()
    content = repr((sources, OMITTED, _own()))
    return dict(kept("declared", content, lambda: declare(sources, OMITTED)))


def faults() -> list[str]:
    """Return the first fault of each definition: file, line, construct, what to write instead."""
    found: list[str] = []
    try:
        translated()  # there is nothing to do if no source has changed
    except Untranslated:
        translate(_sources(), OMITTED, found.append, COMPILED, TRUSTED)
    return found


def _own() -> list[str]:
    """Return what the translator itself is made of."""
    return [*(_source(__package__, name)[1] for name in _all(__package__)), _text("library.pyi")]


def _sources() -> dict[str, tuple[str, str]]:
    return {
        f"{package}.{name}": _source(package, name)
        for package, names in MODULES.items()
        for name in (_all(package) if names == "*" else names.split())
    }


def _all(package: str) -> list[str]:
    top, *within = package.split(".")
    names = [path.name for path in files(top).joinpath(*within).iterdir()]
    return sorted(name[:-3] for name in names if name.endswith(".py") and name != "__init__.py")


def _source(package: str, name: str) -> tuple[str, str]:
    """Return the path and the text of a module, wherever it is installed."""
    top, *within = package.split(".")  # what a package's __init__ imports is not needed here
    path = files(top).joinpath(*within, f"{name}.py")
    return str(path), path.read_text(encoding="utf-8")


def _text(name: str) -> str:
    return files(__package__).joinpath(name).read_text(encoding="utf-8")


@cache
def runtime() -> str:
    """Return the text of the runtime."""
    return _text("runtime.mjs")
