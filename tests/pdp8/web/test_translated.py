"""What runs in the pages is our own Python: here each part of it once in Node.js, beside Python itself."""

import random
from types import ModuleType
from typing import Any

import pal
from nc import machine
from pdp8.computer.past import state
from tapes import kinds, shelf
from tests.pal.random_pal8 import PAL8, written
from tests.pdp8.web.node import HOUSE, in_node, needs_node, plain

pytestmark = needs_node

_MADE = "tape words listing lines symbols stopped"
_ASSEMBLE = """async ([made, sources]) => {
  const { assemble } = await import("@/pal/assembling.mjs");
  const { bytes } = await import("@/pdp8/web/translator/runtime.mjs");
  return sources.map(([dialect, tapes]) => {
    const others = [undefined, undefined, undefined, undefined, dialect];
    const assembly = assemble(tapes.map((tape) => bytes(tape)), ...others);
    const said = assembly.diagnostics.map(String);
    const typed = assembly.dialect === "pal3" ? assembly.teletype : [];
    return [assembly.dialect, typed, said, ...made.split(" ").map((name) => assembly[name])];
  });
}"""
_PIECES = (
    *"+-.; \t\n($IZAB*5,=/!?\f",
    *("TAD", "CLA", "A,", "B=", "FIELD", "FIXMRI", "EXPUNGE", "FIXTAB"),
    *("DECIMAL", "OCTAL", "PAUSE", "LONGNAME"),
    *("189", "7777", "400", "1A", "/X\n", "DCA I ", "JMP .-1\n", "LOOP,", "*200\n", "\n", "\n"),
)


def _same(dialect: str, sources: list[list[bytes]]) -> None:
    """Assemble each source's tapes in both; compare tape, words, what is typed, listing, diagnostics."""
    there = in_node(_ASSEMBLE, [_MADE, [[dialect, [list(tape) for tape in tapes]] for tapes in sources]])
    for tapes, found in zip(sources, there, strict=True):
        assembly = pal.assemble(*tapes, dialect=dialect)
        said = [str(each) for each in assembly.diagnostics]
        typed = assembly.teletype if assembly.dialect == "pal3" else ()
        made = [getattr(assembly, name) for name in _MADE.split()]
        assert found == plain([assembly.dialect, typed, said, *made]), tapes


def _source(draw: random.Random) -> bytes:
    text = "".join(draw.choice(_PIECES) + draw.choice(("", " ", "\t")) for _ in range(draw.randrange(60)))
    code = text.encode("ascii")
    return bytes(frame | 0o200 for frame in code) if draw.random() < 0.2 else code


def test_the_assembler() -> None:
    """Every source of the project and 1,000 random ones."""
    draw = random.Random(33)
    sources = [[path.read_bytes()] for path in (*HOUSE.glob("programs/*.pal"), *HOUSE.glob("tests/**/*.pal"))]
    assert len(sources) > 40
    sources += [[_source(draw) for _ in range(draw.choice((1, 1, 1, 2)))] for _ in range(900)]
    sources += [[draw.randbytes(draw.randrange(120))] for _ in range(100)]
    _same("pal3", sources)


def test_the_assembler_in_pal8() -> None:
    """Random sources in PAL8, some damaged; numbers beyond 2^53; what is found to be PAL8 and what is not."""
    whole = [written(PAL8, seed) for seed in range(60)]
    draw = random.Random(8)
    spoiled = [_spoiled(draw, text, '()[]<>,=;"$%^&!?\x0c\xb2\xe9') for text in whole]
    large = ["*200\n\t99999999999999999999\nDECIMAL\n\t99999999999999999999\n$\n"]
    for n in ("16777217", "9007199254740993", "123456789012345678", "99999999999999999999"):
        large.append(f"*200\nDUBL\n\t{n}\n\t-{n}\nFLTG\n\t{n}\n\t-{n[:9]}.{n[9:]}\n$\n")
    sources = [[text.encode("latin-1", "replace")] for text in whole + spoiled + large]
    _same("pal8", sources)
    _same("auto", sources[::3] + [[_source(draw)] for _ in range(100)])


def _spoiled(draw: random.Random, text: str, by: str) -> str:
    """Return a text with a few characters replaced, taken away or put in."""
    for _ in range(draw.randrange(1, 5)):
        at = draw.randrange(len(text))
        text = text[:at] + draw.choice(("", draw.choice(by))) + text[at + draw.randrange(2) :]
    return text


def _damaged(draw: random.Random, tape: bytes) -> bytes:
    part = tape[: draw.choice((300, 3000, len(tape)))].decode("latin-1")
    return _spoiled(draw, part, "".join(map(chr, range(256)))).encode("latin-1")


_BOTH = """async (calls) => {
  const { bytes } = await import("@/pdp8/web/translator/runtime.mjs");
  const modules = {
    kinds: await import("@/tapes/kinds.mjs"),
    machine: await import("@/nc/machine.mjs"),
    state: await import("@/pdp8/computer/past/state.mjs"),
  };
  return calls.map(([module, name, given]) => {
    try { return modules[module][name](Array.isArray(given) ? bytes(given) : given); }
    catch (error) { return `${error.constructor.name}: ${error}`; }
  });
}"""


def _in_both(calls: list[tuple[ModuleType, str, Any]]) -> list[Any]:
    """Return what each call returns, or the error it raises, the same in both."""
    asked = [(module.__name__.rpartition(".")[2], name, plain(given)) for module, name, given in calls]
    expected = []
    for module, name, given in calls:
        try:
            expected.append(plain(getattr(module, name)(given)))
        except ValueError as error:
            expected.append(f"{type(error).__name__}: {error}")
    for (_, name, given), there, here in zip(calls, in_node(_BOTH, asked), expected, strict=True):
        assert there == here, f"{name} {given[:60]!r}"
    return expected


def test_tapes_and_the_milling_machine() -> None:
    """The bundled tapes, whole and damaged: kind, start, every move to the last digit, every refusal."""
    draw = random.Random(7)
    whole = [shelf.read_bundled(name) for name in ("circle.asc", "circle.eia", "ellipse.eia", "eia.bin")]
    tapes = whole + [_damaged(draw, tape) for tape in whole for _ in range(12)]
    names = ((kinds, "classify"), (kinds, "start"), (machine, "cut"))
    _in_both([(module, name, tape) for tape in tapes for module, name in names])


_PARTS = (
    *(f'"processor": {{"clock": {clock}}}' for clock in ('"abc"', "-500", "1e20", "1.5", "true", 1 << 70)),
    *('"processor": {"run": 2}', '"processor": {"x": 2}', '"waiting": {"clock": 5}', '"cpu": {}'),
    *('"devices": {"03": {"reader": {"position": 7}}}', '"devices": {"05": {}}'),
    *('"core": {"0200": "9"}', '"core": {"0200": 5}'),
)


def test_a_state_is_refused_with_the_same_words() -> None:
    """A clock that is none, a reader beyond its tape, an unknown part, a word that is none."""
    texts = ["[]", "pdp8 state 1", *(f'{{"format": "pdp8 state", "version": 2, {part}}}' for part in _PARTS)]
    said = _in_both([(state, "restore", text) for text in texts])
    assert all(each.startswith("StateError: ") for each in said)
