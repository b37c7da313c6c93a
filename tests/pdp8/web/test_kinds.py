"""Where the page sets a tape in its reader, as `tapes.kinds` does: blank tape, labels, leaders."""

import random

from tapes import ascii, binary, kinds, rim, shelf
from tapes.frames import leader
from tests.pdp8.web.node import in_node, needs_node

pytestmark = needs_node

_START = """async (tapes) => {
  const { codeOf, start } = await import("@/bench/kinds.mjs");
  return tapes.map((frames) => Uint8Array.from(frames)).map((frames) => [start(frames), codeOf(frames)]);
}"""
_WORDS = {0o200: 0o7300, 0o201: 0o7402, 0o400: 0o1234}


def _in_the_page(tapes: list[bytes]) -> list[tuple[int, str]]:
    return [(at, code) for at, code in in_node(_START, [list(tape) for tape in tapes])]


def _tape(chance: random.Random) -> bytes:
    """Return blank tape, a label or text or nothing, blank tape, leader, and words or text or nothing."""
    letters, text = bytes([0o265, 0o011, 0o377, 0o001, 0, 0o176, 0o101]), ascii.encode("A\nB")
    label = chance.choice((letters, text, b"\xff" * 4, b""))
    gap, before = (bytes(chance.choice((0, 1, 2, 3, 9))) for _ in range(2))
    words = chance.choice((binary.encode(_WORDS), rim.encode(_WORDS), ascii.encode("*200\nHLT\n$\n"), b""))
    return before + label + gap + leader(chance.choice((0, 1, 7, 8, 20))) + words.lstrip(b"\x80")


def test_a_tape_is_set_on_the_frame_that_the_package_sets_it_on() -> None:
    chance = random.Random(8)
    tapes = [_tape(chance) for _ in range(2_000)]
    starts = [at for at, _ in _in_the_page(tapes)]
    for tape, at in zip(tapes, starts, strict=True):
        assert at == kinds.start(tape), tape.hex(" ")
    assert {at > 9 for at in starts} == {True, False}


def test_the_code_that_a_tape_is_shown_in() -> None:
    label = bytes([0o177, 0o101, 0o076, 0, 0, 0])
    names = ("circle.asc", "circle.eia", "eia.bin")
    tapes = [shelf.read_bundled(name) for name in names] + [label + binary.encode(_WORDS), b""]
    assert [code for _, code in _in_the_page(tapes)] == ["ascii", "eia", "bin", "bin", "bin"]
