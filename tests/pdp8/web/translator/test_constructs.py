"""What a translated module does is what Python does; what has no translation is an error with its place."""

import json
from pathlib import Path
from typing import Any

import pytest

from pdp8.web.translator import runtime
from pdp8.web.translator.modules import translate
from pdp8.web.translator.program import Untranslated
from tests.pdp8.web.node import in_node, needs_node, write
from tests.pdp8.web.translator import constructs

_RUN = """async (names) => {
  const module = await import("@/constructs.mjs");
  const { Dict, PySet } = await import("@/pdp8/web/translator/runtime.mjs");
  const plain = (of) =>
    of instanceof Dict ? Object.fromEntries(of.items().map(([k, v]) => [String(k), plain(v)]))
    : of !== null && typeof of === "object" && of[Symbol.iterator] ? Array.from(of, plain)
    : of instanceof Number ? of.valueOf() : of;
  return names.map((name) => { try { return plain(module[name]()); } catch (error) { return error.stack; } });
}"""


def _plain(value: Any) -> Any:
    """Return a value as JSON has it in both languages."""
    if isinstance(value, dict):
        return {str(name): _plain(item) for name, item in value.items()}
    return (
        [_plain(item) for item in value]
        if not isinstance(value, str) and hasattr(value, "__iter__")
        else value
    )


@needs_node
def test_every_construct_does_as_in_python(tmp_path: Path) -> None:
    """Each function of constructs.py returns the same in both."""
    path = Path(constructs.__file__)
    modules = {"constructs": (str(path), path.read_text(encoding="utf-8"))}
    write(tmp_path, translate(modules, {}, runtime()))
    functions = constructs.FUNCTIONS
    returned = in_node(_RUN, [function.__name__ for function in functions], tmp_path)
    for function, there in zip(functions, returned, strict=True):
        here = json.loads(json.dumps(_plain(function())))
        if isinstance(here, list) and isinstance(there, list):
            for number, (one, other) in enumerate(zip(here, there, strict=True)):
                assert other == one, f"{function.__name__}, value {number}"
        assert there == here, function.__name__


@pytest.mark.parametrize(
    ("source", "said"),
    [
        (
            "def f(x: int) -> int:\n    import os\n    return os.getpid()\n",
            "m.py:3: nothing has a method getpid",
        ),
        ("async def f() -> None:\n    pass\n", "m.py:1: no translation"),
        ("def f(x: str) -> str:\n    return x.swapcase()\n", "m.py:2: nothing has a method swapcase"),
        ("X = 1\nX = 2\n", "m.py:2: X is set twice"),
        ("X = (1 << 60) + 1\n", "m.py:1: 1152921504606846977 is beyond 2^53"),
        ("class A:\n    @functools.lru_cache\n    def f(self) -> None: ...\n", "m.py:3: decorator"),
        ("from pal import cli\nX = cli\n", "m.py:2: the runtime has no cli"),
        ("def f() -> None:\n    def g():\n        yield 1\n", "m.py:2: a generator within a function"),
        ("X = print('a', end='')\n", "m.py:1: the runtime has no print"),
        ("def f(x: int) -> None:\n    global y\n    y = x\n", "m.py:2: no translation"),
        ("def f(a: int) -> int:\n    return f(a, b=1)\n", "m.py:2: keywords that are no parameters"),
        (
            "def f(a: str) -> None:\n    for x in a:\n        pass\n    else:\n        f(a)\n",
            "m.py:2: no translation",
        ),
        ("def f(a: str) -> str:\n    return a[::-1]\n", "m.py:2: a slice by steps"),
        ("X = f'{1:<5}'\n", "m.py:1: no translation of the format"),
        ("def f(a: list[int]) -> None:\n    a[1:] = []\n", "m.py:2: no translation"),
        ("def f(a: object) -> bool:\n    return isinstance(a, int | str)\n", "m.py:2: no translation"),
    ],
)
def test_what_has_no_translation_is_an_error_with_its_place(source: str, said: str) -> None:
    """It is never passed over."""
    with pytest.raises(Untranslated) as raised:
        translate({"m": ("m.py", source)}, {}, runtime())
    assert str(raised.value).startswith(said)
