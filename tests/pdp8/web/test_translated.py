"""What runs in the pages is our own Python: here each part of it once in Node.js, beside Python itself."""

import random
from collections.abc import Callable
from typing import Any

import pal
from nc import machine
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


_TAPES = """async (tapes) => {
  const { classify, start } = await import("@/tapes/kinds.mjs");
  const { cut } = await import("@/nc/machine.mjs");
  const { bytes } = await import("@/pdp8/web/translator/runtime.mjs");
  return tapes.map((tape) => [classify, start, cut].map((call) => {
    try { return call(bytes(tape)); }
    catch (error) { return `${error.constructor.name}: ${error}`; }
  }));
}"""


def _called(call: Callable[[bytes], Any], tape: bytes) -> Any:
    """Return what it returns, or the error it raises."""
    try:
        return plain(call(tape))
    except ValueError as error:
        return f"{type(error).__name__}: {error}"


def test_tapes_and_the_milling_machine() -> None:
    """The bundled tapes, whole and damaged: kind, start, every move to the last digit, every refusal."""
    draw = random.Random(7)
    whole = [shelf.read_bundled(name) for name in ("circle.asc", "circle.eia", "ellipse.eia", "eia.bin")]
    tapes = whole + [_damaged(draw, tape) for tape in whole for _ in range(12)]
    for tape, there in zip(tapes, in_node(_TAPES, plain(tapes)), strict=True):
        assert there == [_called(each, tape) for each in (kinds.classify, kinds.start, machine.cut)], tape[
            :60
        ]
