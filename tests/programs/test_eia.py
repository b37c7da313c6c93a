"""eia.pal is the thesis's program, word for word; eia1 and eia2 do what Chapter 5 says they did."""

from pathlib import Path

import pal
import pdp8
import programs
from pdp8 import shelf
from tests.conftest import Shell, assert_same_tape

WORDS = """\
0200: 6046 6032 4214 0101 1102 3100 4227 7440 5201 1100 4221 5201
0214: 0000 6031 5215 6036 5614
0221: 0000 6041 5222 6046 7300 5621
0227: 0000 1100 7440 5236 1103 3100 5627
0236: 1116 7640 5244 1104 3100 5627
0244: 1100 1117 7640 5253 1105 3100 5627
0253: 1100 1120 7640 5262 1106 3100 5627
0262: 1100 1121 7640 5271 1107 3100 5627
0271: 1100 1122 7640 5300 1110 3100 5627
0300: 1100 1123 7640 5307 1111 3100 5627
0307: 1100 1124 7640 5316 1112 3100 5627
0316: 1100 1125 7640 5325 1113 3100 5627
0325: 1100 1126 7640 5334 1114 3100 5627
0334: 1100 1127 7640 5343 1103 3100 5627
0343: 1100 1130 7440 5627 1115 3100 5627
0100: 0000 0177 7720 0040 0001 0002 0023 0004 0025 0026 0007 0010 0031 0200
0116: 7777 7776 7775 7774 7773 7772 7771 7770 7767 0020 0043
"""


def source(name: str) -> str:
    return (Path(programs.__file__).parent / name).read_text()


def started(frames: bytes, program: str = "eia.pal", patch: dict[int, int] | None = None) -> pdp8.Machine:
    """Return a machine that reads a tape, its core patched."""
    machine = pdp8.Machine()
    machine.load(pal.assemble(source(program)).words | (patch or {}))
    machine.teletype.reader.load(frames)
    machine.start(0o200)
    return machine


def translated(frames: bytes, program: str = "eia.pal", patch: dict[int, int] | None = None) -> bytes:
    """Return what the machine punches."""
    machine = started(frames, program, patch)
    assert machine.run(seconds=4000).reason == "tape out"
    return machine.teletype.punch.tape


def test_the_131_words() -> None:
    book = {
        int(start, 8) + place: word
        for start, row in (line.split(":") for line in WORDS.splitlines())
        for place, word in enumerate(row.split())
    }
    assembly = pal.assemble(source("eia.pal"))
    assert not assembly.diagnostics
    assert len(book) == 131
    assert {f"{at:04o}": f"{word:04o}" for at, word in assembly.words.items()} == {
        f"{at:04o}": word for at, word in book.items()
    }


def test_a_1971_teletype_could_type_the_sources() -> None:
    for line in "".join(map(source, ("eia.pal", "eia1.pal", "eia2.pal"))).splitlines():
        assert line == line.upper()
        assert len(line.expandtabs(8)) <= 72, line


ASCII = bytes([0o260, 0o261, 0o262, 0o263, 0o264, 0o265, 0o266, 0o267, 0o270, 0o271, 0o240, 0o215])
EIA = bytes([0o040, 0o001, 0o002, 0o023, 0o004, 0o025, 0o026, 0o007, 0o010, 0o031, 0o040, 0o200])
EXTRANEOUS = bytes([0o212, 0o377, 0o000, 0o301, 0o257, 0o272])


def test_the_third_program_knows_twelve_characters_of_256_and_drops_the_others() -> None:
    known = {code & mask: out for code, out in zip(ASCII, EIA, strict=True) for mask in (0o177, 0o377)}
    expected = bytes(known[frame] for frame in range(256) if frame in known)
    assert translated(bytes(range(256))) == b"\0" + expected


def test_the_first_program_gives_the_pure_binary_of_a_numeral_and_the_end_of_block() -> None:
    expected = bytes([0o000, 0o001, 0o002, 0o003, 0o004, 0o005, 0o006, 0o007, 0o010, 0o011])
    assert translated(ASCII[:10] + b"\x8d", "eia1.pal") == b"\0" + expected + b"\x80"


def test_the_first_program_converts_everything_else_into_meaningless_codes() -> None:
    assert translated(EXTRANEOUS, "eia1.pal") == bytes([0, 0o012, 0o017, 0o000, 0o001, 0o017, 0o012])


def test_the_second_program_adds_parity_and_lets_the_rest_pass_masked_and_reduced() -> None:
    reduced = bytes((frame & 0o177) - 0o60 & 0o377 for frame in EXTRANEOUS)
    assert translated(ASCII + EXTRANEOUS, "eia2.pal") == b"\0" + EIA + reduced


def test_a_second_pass_makes_program_2s_tape_that_of_program_3(shell: Shell) -> None:
    """Chapter 5: the Flexowriter leaves out the characters that program 2 passed on."""
    done = shell("pdp8 run eia2.pal --quiet | pdp8 tape clean", shelf.read("circle.asc"))
    assert_same_tape(done.stdout, shelf.read("circle.eia"))
