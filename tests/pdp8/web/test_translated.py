"""What runs in the pages is our own Python: here each part of it once in Node.js, beside Python itself."""

import random
from collections.abc import Callable
from typing import Any

import pytest

import pal
from nc import machine
from pdp8 import shelf
from tapes import codes, dump
from tests.pal.random_pal8 import PAL8, faulty, written
from tests.pdp8.cli.test_loading import FOUND
from tests.pdp8.web.node import HOUSE, called, in_node, needs_node, plain

pytestmark = needs_node

_MADE = "tape words listing lines symbols stopped"
_READ = """async (tapes) => {
  const { recognise } = await import("@/tapes/codes.mjs");
  const { unspelled } = await import("@/tapes/dump.mjs");
  return tapes.map((content) => {
    const [tape, note] = unspelled(content);
    const code = recognise(tape);
    return [code.name, code.captions(tape), code.labels(tape), note];
  });
}"""
_ASSEMBLE = """async ([made, sources]) => {
  const { assemble } = await import("@/pal/assembling.mjs");
  return sources.map(([dialect, ...tapes]) => {
    const assembly = assemble(tapes, undefined, undefined, undefined, undefined, dialect);
    const said = assembly.diagnostics.map(String);
    const typed = assembly.dialect === "pal3" ? assembly.teletype : [];
    return [assembly.dialect, typed, said, ...made.split(" ").map((name) => assembly[name])];
  });
}"""


def _same(dialect: str, sources: list[list[bytes]]) -> None:
    """Assemble each source's tapes in both; compare tape, words, what is typed, listing, diagnostics."""
    there = in_node(_ASSEMBLE, [_MADE, [[dialect, *tapes] for tapes in sources]])
    for tapes, found in zip(sources, there, strict=True):
        assembly = pal.assemble(*tapes, dialect=dialect)
        said = [str(each) for each in assembly.diagnostics]
        typed = assembly.teletype if assembly.dialect == "pal3" else ()
        made = [getattr(assembly, name) for name in _MADE.split()]
        assert found == plain([assembly.dialect, typed, said, *made]), tapes


def _spoiled(draw: random.Random, tape: bytes, by: bytes = bytes(range(256))) -> bytes:
    """Return a tape with a few frames replaced, taken away or put in."""
    for _ in range(draw.randrange(1, 5)):
        at = draw.randrange(len(tape))
        tape = tape[:at] + draw.choice((b"", bytes([draw.choice(by)]))) + tape[at + draw.randrange(2) :]
    return tape


@pytest.mark.slow("500 sources in Node.js")
def test_the_assembler() -> None:
    """Every source of the project, with channel 8 too, and 500 spoiled pieces; some are two tapes."""
    draw = random.Random(33)
    whole = [path.read_bytes() for path in (*HOUSE.glob("programs/*.pal"), *HOUSE.glob("tests/**/*.pal"))]
    assert len(whole) > 40
    by = b"+-.; \t\n($IZAB*5,=/!?\f\xb2\xe9"
    spoiled = [_spoiled(draw, draw.choice(whole)[:300], by) for _ in range(500)]
    marked = [bytes(frame | 0o200 for frame in source) for source in whole]
    pairs = [draw.sample(spoiled, 2) for _ in range(50)]
    _same("pal3", [[source] for source in whole + marked + spoiled] + pairs)
    _same("auto", [[source] for source in spoiled[:60]])


@pytest.mark.slow("500 sources in Node.js")
def test_the_assembler_in_pal8() -> None:
    """Random sources in PAL8, some damaged; numbers beyond 2^53; what is found to be PAL8 and what is not."""
    whole = [written(PAL8, seed).encode() for seed in range(60)]
    wrong = [faulty(seed).encode() for seed in range(100)]
    draw = random.Random(8)
    spoiled = [_spoiled(draw, source, b'()[]<>,=;"$%^&!?\x0c\xb2\xe9') for source in whole]
    large = ["*200\n\t99999999999999999999\nDECIMAL\n\t99999999999999999999\n$\n"]
    for n in ("16777217", "9007199254740993", "123456789012345678", "99999999999999999999"):
        large.append(f"*200\nDUBL\n\t{n}\n\t-{n}\nFLTG\n\t{n}\n\t-{n[:9]}.{n[9:]}\n$\n")
    sources = [[source] for source in whole + wrong + spoiled + [text.encode() for text in large]]
    _same("pal8", sources)
    _same("auto", sources[::3])


def _here(call: Callable[[bytes], Any], tape: bytes) -> Any:
    """Return what it returns, or the error it raises."""
    try:
        return plain(call(tape))
    except ValueError as error:
        return f"{type(error).__name__}: {error}"


@pytest.mark.slow("cuts every tape in both languages")
def test_tapes_and_the_milling_machine() -> None:
    """The bundled tapes, whole and damaged: code, captions and labels; start, every move, every refusal."""
    draw = random.Random(7)
    tapes = [shelf.read_bundled(name) for name in ("circle.asc", "circle.eia", "ellipse.eia", "eia.bin")]
    tapes += [
        _spoiled(draw, tape[: draw.choice((300, 3000, len(tape)))]) for tape in tapes for _ in range(12)
    ]
    calls = [(each, tape) for each in (codes.start, machine.cut) for tape in tapes]
    there = called(*((each.__module__.replace(".", "/"), each.__name__, tape) for each, tape in calls))
    for (call, tape), found in zip(calls, there, strict=True):
        assert found == _here(call, tape), (call.__name__, tape[:60])
    tapes += FOUND
    for content, read in zip(tapes, in_node(_READ, tapes), strict=True):
        tape, note = dump.unspelled(content)
        code = codes.recognise(tape)
        assert read == plain([code.name, code.captions(tape), code.labels(tape), note]), content[:60]
