"""What a translated module does is what Python does; what has no translation is an error with its place."""

import gc
from inspect import isfunction
from pathlib import Path

import pytest

from pdp8.web.translator.modules import translate
from pdp8.web.translator.program import Untranslated
from tests.pdp8.web.node import called, needs_node, plain, write
from tests.pdp8.web.translator import constructs


@needs_node
def test_every_construct_does_as_in_python(tmp_path: Path) -> None:
    own = (each for each in vars(constructs).values() if isfunction(each) and "constructs" in each.__module__)
    functions = [each for each in own if not each.__name__.startswith("_")]
    path = Path(constructs.__file__)
    modules = {"constructs": (str(path), path.read_text(encoding="utf-8"))}
    write(tmp_path, translate(modules, {}))
    returned = called(*(("constructs", function.__name__) for function in functions), folder=tmp_path)
    for function, there in zip(functions, returned, strict=True):
        for number, (other, one) in enumerate(zip(there, plain(function()), strict=True)):
            assert other == one, f"{function.__name__}, value {number}"


@needs_node
def test_a_class_of_another_module_by_its_dotted_name(tmp_path: Path) -> None:
    there = "from math import floor\nTWO = 2\nclass A(ValueError):\n    pass\n"
    here = (
        "from pal import there\ndef f(x: there.A | str) -> bool:\n"
        "    try:\n        raise there.A('b')\n    except there.A:\n        return isinstance(x, there.A)\n"
        "def g() -> int:\n    return there.floor(2.5) + there.TWO\n"
    )
    modules = {"pal.there": ("there.py", there), "pal.here": ("here.py", here)}
    write(tmp_path, translate(modules, {}))
    assert called(("pal/here", "f", "x"), ("pal/here", "g"), folder=tmp_path) == [False, 4]


@pytest.mark.parametrize(
    ("source", "said"),
    [
        ("async def f() -> None:\n    pass\n", "1: no translation"),
        ("def f(x: str) -> str:\n    return x.swapcase()\n", "2: str has no swapcase"),
        ("X = 1\nX = 2\n", "2: X is set twice"),
        ("class A:\n    @functools.lru_cache\n    def f(self) -> None: ...\n", "3: decorator"),
        ("from . import cli\nX = cli\n", "2: the table of what may be used has no cli"),
        ("from pal import cli\nX = cli\n", "2: the table of what may be used has no cli"),
        ("def f() -> None:\n    def g():\n        yield 1\n", "2: a generator within a function"),
        ("X = print('a', end='')\n", "1: the table of what may be used has no print"),
        ("def f(x: int) -> None:\n    global y\n    y = x\n", "2: no translation"),
        ("def f(a: int) -> int:\n    return f(a, b=1)\n", "2: keywords that are no parameters"),
        ("def f(a: int) -> int:\n    return f(a, a)\n", "2: too many arguments"),
        ("def f(a: int) -> int:\n    return f(*[a], a=1)\n", "2: too many arguments, or too few"),
        ("def f(a: int, b: int) -> int:\n    return f(*[a], b=1)\n", "2: an unpacked argument before"),
        ("def f(a: str) -> None:\n    for x in a: ...\n    else: ...\n", "2: no translation"),
        ("def f(a: str) -> str:\n    return a[::-1]\n", "2: a slice by steps"),
        ("X = f'{1:<5}'\n", "1: no translation of the format"),
        ("def f(a: list[int]) -> None:\n    a[1:] = []\n", "2: no translation"),
        ("def f(a: list[int]) -> None:\n    a[1:] += []\n", "2: no translation: a[1:]; write an assignment"),
        ("class A(json.B):\n    pass\n", "1: such a base class"),
        ("def f(a: object) -> bool:\n    return isinstance(a, int | str)\n", "2: no translation"),
    ],
)
def test_what_has_no_translation_is_an_error_with_its_place(source: str, said: str) -> None:
    with pytest.raises(Untranslated) as raised:
        translate({"m": ("m.py", source)}, {})
    assert str(raised.value).startswith(f"m.py:{said}")
    assert gc.isenabled()  # it is off while modules are translated
    gc.disable()
    translate({}, {})
    try:
        assert not gc.isenabled()
    finally:
        gc.enable()
