"""The numbers and names of the page's scripts: all from the Python tables, none of their own."""

import re

from pdp8.web import facts
from tapes import eia, hydrapoint
from tests.pdp8.conftest import Ask
from tests.pdp8.web.node import MODULES, in_node, needs_node

_TABLE = re.compile(r"^(?:export )?const (\w+) = [\[{].*\b\d", re.MULTILINE)
_STRING = re.compile(r'"[^"]*"')


def test_the_file_is_made_from_the_tables() -> None:
    """facts.mjs is what `python -m pdp8.web.facts` writes: no number in it is changed by itself."""
    assert (MODULES / facts.FILE).read_text(encoding="utf-8") == facts.module()


def test_a_block_has_its_fields() -> None:
    """Twenty rows: the fields in the order of a Block, and the end of block."""
    assert tuple(hydrapoint.FIELDS) == hydrapoint.Block._fields
    assert sum(hydrapoint.FIELDS.values()) == hydrapoint.DIGITS
    assert hydrapoint.Block(1, 2, 3, 4, 5, 6, 7).digits == "".join(
        f"{number:0{width}}" for number, width in enumerate(hydrapoint.FIELDS.values(), 1)
    )


_SIGNS = """async () => {
  const { sign, meaning } = await import("@/tape.mjs");
  const frames = [...Array(256).keys()];
  const shown = (code) => frames.map((frame) => [sign(frame, code), meaning(frame, code)]);
  return ["ascii", "eia", "bin"].map(shown);
}"""


_SIGN = {"\n": "↓", "\r": "↵", " ": "␣", "\x7f": "×"}
_MEANING = {"↓": "line feed", "↵": "carriage return", "␣": "space", "×": "rubout", "": "blank"}


@needs_node
def test_every_frame_is_written_in_its_code() -> None:
    """All 256 frames beside a tape, as a sign and in words: ASCII, EIA, octal."""
    shown = in_node(_SIGNS)
    for frame in range(0o400):
        character = chr(frame & 0o177)
        in_ascii = _SIGN.get(character, character)
        character = eia.CHARACTERS.get(frame, "?" if frame else "")
        in_eia = "↵" if frame == eia.EOB else character
        expected = [[sign, _MEANING.get(sign, sign)] for sign in (in_ascii, in_eia, f"{frame:03o}")]
        assert [code[frame] for code in shown] == expected, f"frame {frame:03o}"


_TRACKS = """async () => {
  const { drawTape } = await import("@/tape.mjs");
  return [...Array(8).keys()].map((bit) => {
    const holes = [];
    const arc = (x, y, radius) => holes.push([radius, x]);
    const context = new Proxy({}, { get: (at, name) => (name === "arc" ? arc : () => {}), set: () => true });
    drawTape(context, { frames: [1 << bit], head: 0, code: "bin" }, 230, 330, { ratio: 1 });
    const [[, sprocket], [, hole]] = holes.sort(([one], [other]) => one - other);
    return (hole - sprocket) / 15;
  });
}"""


@needs_node
def test_the_channels_lie_from_8_to_1_beside_the_sprocket() -> None:
    """Channels 1 to 3 right of the sprocket hole, 4 to 8 left of it, a pitch apart."""
    assert in_node(_TRACKS) == [3, 2, 1, -1, -2, -3, -4, -5]


_BLOCK = """(afternoon, names) => {
  const { sheets, mill } = afternoon.record;
  return [names.map((name) => sheets[name].lines.map(([, , text]) => text)), mill.diameter];
}"""


def test_the_blocks_of_the_sheet_are_cut_into_their_fields(ask: Ask) -> None:
    """The circle's first blocks and its cutter, in the digits of the thesis."""
    (lines,), diameter = ask(_BLOCK, ["blocks"])
    assert lines[:2] == ["001 0 19000 00000 0 00 02", "002 0 00000 00000 0 01 86"]
    assert diameter == 500


_HELD = {"tape.mjs": {"TRACKS"}, "brightness.mjs": {"WORDS"}, "clock.mjs": {"SPEEDS"}}


def test_no_script_has_a_table_of_numbers_but_the_picture_of_a_tape() -> None:
    """What is a fact is in facts.mjs, but for what the assembler types, which test_pal.py holds."""
    for path in sorted({*MODULES.rglob("*.mjs")} - {*MODULES.glob("pal/*.mjs")}):
        tables = (
            []
            if path.name == facts.FILE
            else _TABLE.findall(_STRING.sub("", path.read_text(encoding="utf-8")))
        )
        assert set(tables) <= _HELD.get(path.name, set()), path.name


_MNEMONICS = """async () => {
  const { mnemonic, inWords } = await import("@/meaning.mjs");
  return [0o1102, 0o1777, 0o5776, 0o7300, 0o7640, 0o7012, 0o7401, 0o6036, 0o6502, 0o7402].map(
    (word) => [mnemonic(word, 0o400), inWords(word, 0o400)]);
}"""


@needs_node
def test_an_instruction_in_words() -> None:
    """As PAL III names it, and what the table of symbols says that it does."""
    assert in_node(_MNEMONICS) == [
        ["TAD 0102", "add the word to the AC, two's complement: 0102"],
        ["TAD I 0577", "add the word to the AC, two's complement: address in 0577"],
        ["JMP I 0576", "jump: address in 0576"],
        ["CLA CLL", "clear the AC, clear the link"],
        ["SZA CLA", "skip on zero AC, clear the AC"],
        ["RTR", "rotate AC and link right twice"],
        ["7401", "no operation"],
        ["KRB", "read the keyboard's buffer, run the reader"],
        ["6502", "no operation"],
        ["HLT", "halt"],
    ]


def test_the_times_are_those_of_the_books() -> None:
    """1.6 us a cycle, 4.25 us an IOT, 100 ms a frame: as literal ticks of 0.05 us."""
    times = facts.facts()["TIMES"]
    assert (times["CYCLE"], times["CYCLE"] + times["IO_TICKS"], times["FRAME"]) == (32, 85, 2_000_000)
