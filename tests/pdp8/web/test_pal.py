"""The assembler in the page and the package's: the same tape, words, listing and passes, byte for byte."""

import base64
import random
from pathlib import Path
from typing import Any

import pytest

import pal
from pal.assembler import HIGH_SPEED_SYMBOLS
from pal.notes import notes
from pal.source import Source
from tests.pal import test_diagnostics, test_notes
from tests.pdp8.web.node import in_node, needs_node

HOUSE = Path(__file__).parents[3]
pytestmark = needs_node

_ASSEMBLE = """async (sources) => {
  const { assemble } = await import("@/pal.mjs");
  const { printed } = await import("@/pal/diagnostics.mjs");
  const bytes = (text) => Uint8Array.from(Buffer.from(text, "base64"));
  const text = (frames) => Buffer.from(frames).toString("base64");
  return sources.map((tapes) => {
    const { tape, words, passes, listing, symbols, messages, diagnostics } = assemble(...tapes.map(bytes));
    return {
      tape: text(tape), passes: passes.map(text), listing, symbols: Object.entries(symbols),
      words: Object.entries(words).map(([address, word]) => [Number(address), word]),
      messages,
      diagnostics: diagnostics.map((diagnostic) => printed(diagnostic, `tape ${diagnostic.tape + 1}`)),
    };
  });
}"""


def _in_the_page(sources: list[list[bytes]]) -> list[dict[str, Any]]:
    coded = [[base64.b64encode(tape).decode() for tape in tapes] for tapes in sources]
    found: list[dict[str, Any]] = in_node(_ASSEMBLE, coded)
    return found


def _here(tapes: list[bytes]) -> dict[str, Any]:
    names = [f"tape {number}" for number in range(1, len(tapes) + 1)]
    assembly = pal.assemble(*tapes, names=names)
    return {
        "tape": base64.b64encode(assembly.tape).decode(),
        "words": sorted([address, word] for address, word in assembly.words.items()),
        "passes": [base64.b64encode(frames).decode() for frames in assembly.teletype],
        "listing": assembly.printed(3),
        "symbols": [[name, value] for name, value in assembly.symbols.items()],
        "messages": [str(message) for message in assembly.messages],
        "diagnostics": [str(diagnostic) for diagnostic in assembly.diagnostics],
    }


def _compare(sources: list[list[bytes]]) -> None:
    for tapes, shown in zip(sources, _in_the_page(sources), strict=True):
        assert shown == _here(tapes), tapes


def test_every_source_of_the_project() -> None:
    """The bundled programs, and every source that the assembler's own tests have."""
    paths = [*HOUSE.glob("programs/*.pal"), *HOUSE.glob("tests/**/*.pal")]
    assert len(paths) > 40
    _compare([[path.read_bytes()] for path in paths])


def test_every_source_with_a_note() -> None:
    """All that the tests of the notes have, tapes after the end, empty tapes."""
    sources = [f"{source}\n$\n" for source, *_ in test_notes.NOTED]
    sources += [source for source, *_ in test_diagnostics.NOTED]
    several = [[b"1\n$\n", b"2\n"], [b"1\n", b"2\n$\n", b"3\n", b"4\n"], [b"", b""], [b"FIELD\0331\n$\n"]]
    _compare([[source.encode("ascii")] for source in sources] + several)


_NOTES = """async ([source, symbols]) => {
  const { notes } = await import("@/pal/notes.mjs");
  const { Source } = await import("@/pal/source.mjs");
  return notes(new Source([source]), 1, symbols);
}"""


@pytest.mark.parametrize("source", ["PAUSE;5\n$\n", "PAUSE;+\n$\n", "PAUSE \t/5\n$\n", "PAUSE,5 +\n+ 1\n$\n"])
def test_notes_with_the_high_speed_reader(source: str) -> None:
    """Which the page has not: PAUSE takes the rest of its line from the source."""
    expected = notes(Source([source.encode("ascii")]), 1, HIGH_SPEED_SYMBOLS)
    found = in_node(_NOTES, [source, HIGH_SPEED_SYMBOLS])
    assert [tuple(note.values()) for note in found] == expected


def test_a_form_feed_moves_the_pointer() -> None:
    """In pass 3, as it is typed; the = after it defines nothing."""
    _compare([[source] for source in (b"B=3\nTAD B\f\n=5\nB\n$\n", b"B=3\n7;TAD B /\f\n=5\nB\n$\n")])


_PIECES = (
    *"+-.; \t\n($IZAB*5,=/!?",
    *("TAD", "CLA", "A,", "B=", "FIELD", "FIXMRI", "EXPUNGE", "FIXTAB", "DECIMAL", "OCTAL", "PAUSE"),
    *(
        "189",
        "7777",
        "400",
        "1A",
        "/X\n",
        "DCA I ",
        "JMP .-1\n",
        "LOOP,",
        "*200\n",
        "\n",
        "\n",
        "\f",
        "LONGNAME",
    ),
)


def _random_source(draw: random.Random) -> bytes:
    text = "".join(draw.choice(_PIECES) + draw.choice(("", " ", "\t")) for _ in range(draw.randrange(60)))
    code = text.encode("ascii")
    return bytes(frame | 0o200 for frame in code) if draw.random() < 0.2 else code


def test_two_thousand_random_sources() -> None:
    """Statements good and bad, with channel 8 and without, on one tape or two; and bytes of any kind."""
    draw = random.Random(33)
    sources = [[_random_source(draw) for _ in range(draw.choice((1, 1, 1, 2)))] for _ in range(1800)]
    sources += [[draw.randbytes(draw.randrange(120))] for _ in range(200)]
    _compare(sources)


_ASSEMBLE_TEXT = """async (source) => {
  const { assemble } = await import("@/pal.mjs");
  const { words, messages, diagnostics } = assemble(source);
  return [words, messages, diagnostics];
}"""


def test_a_string_is_a_source_too() -> None:
    """`assemble(...sources)` takes strings, as the editor has them; what is not ASCII is illegal."""
    source = "*200\n\tCLA É\n\tHLT\n$\n"
    words, messages, diagnostics = in_node(_ASSEMBLE_TEXT, source)
    expected = pal.assemble(source)
    assert {int(address): word for address, word in words.items()} == expected.words
    assert messages == [str(message) for message in expected.messages]
    assert (diagnostics[0]["line"], diagnostics[0]["start"]) == (2, 5)
