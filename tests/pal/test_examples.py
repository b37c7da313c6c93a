"""What DEC-08-ASB1, DEC's own PAL III of February 1967, made of each source in examples/.

NAME.bin is the tape of the high-speed punch, raw; NAME.passN.txt is what the Teletype printed in a pass,
without the codes that do not print and with CR LF as one line end. They were read by the high-speed reader,
each PAUSE at the end of a tape. stops/ has sources that it never finishes. asr/ has what the Teletype's punch
had in the three passes with the source in the ASR-33's reader, raw.
"""

import ast
from pathlib import Path

import pytest

import pal
from pal.assembler import HIGH_SPEED_SYMBOLS
from pal.assembly import Assembly
from tapes import binary
from tests.conftest import assert_same_tape, case

EXAMPLES = Path(__file__).parent / "examples"
NAMES = sorted(path.stem for path in EXAMPLES.glob("*.pal"))
FULL = {
    "full490": "".join(f"S{number}={number:o}\n" for number in range(490)) + "$\n",
    "full585": "*200\n" + "".join(f"A{number:04},\tHLT\n" for number in range(585)) + "$\n",
}
"""Sources that fill the symbol table."""


def source(name: str) -> bytes:
    path = Path(name)
    return FULL[path.name].encode() if path.name in FULL else (EXAMPLES / f"{name}.pal").read_bytes()


def assembled(name: str) -> Assembly:
    return pal.assemble(source(name), capacity=HIGH_SPEED_SYMBOLS)


def test_the_tape_is_decs_frame_for_frame() -> None:
    assert len(NAMES) == 56
    for name in NAMES:
        with case(name):
            assert_same_tape(assembled(name).tape, (EXAMPLES / f"{name}.bin").read_bytes())


def test_the_teletype_prints_what_it_printed() -> None:
    for number in [1, 2, 3]:
        for name in NAMES:
            with case(name, number):
                printed = (EXAMPLES / f"{name}.pass{number}.txt").read_text()
                assert assembled(name).text(number).split("\n") == printed.split("\n")


def test_the_frames_of_pass_3_with_a_form_feed() -> None:
    def typed(text: str) -> bytes:
        return bytes(ord(character) | 0o200 for character in text)

    leader, feed = b"\x80" * 64, bytes(6) + typed("\f") + bytes(6)
    message = typed("\x7f\r\nIR  0400  AT  0201\x7f\r\n0201  5200  \t\x7f1") + feed + typed(";JMP 400\r\n")
    table = typed("\x7f\r\n\x04\r\n\x7f")
    frames = b"\0" + leader + typed("\r\n0200  0001  ") + message + leader + table + leader
    assert_same_tape(pal.assemble("\t1\f;JMP 400\n$\n").teletype.pass3, frames)


@pytest.mark.parametrize("path", sorted((EXAMPLES / "asr").glob("*.tty1")), ids=lambda path: path.stem)
def test_the_frames_of_the_three_passes_by_the_asr_33s_reader(path: Path) -> None:
    teletype = pal.assemble(source(f"asr/{path.stem}")).teletype
    for number, frames in enumerate(teletype, 1):
        assert_same_tape(frames, path.with_suffix(f".tty{number}").read_bytes())


def test_some_words_of_page_zero_may_be_written_over() -> None:
    assert pal.assemble("\t14\n=5\n$\n").words == {0o200: 0o14}
    assert pal.assemble("=5\n\t5\n$\n").listing == "\n            =5\n0200  0005  \t5\n\n\n"
    assert pal.assemble("=5\n\t6\n$\n").listing == ""
    assert pal.assemble("A!AAZ\n$\n").values["IOQ@C"] == 0o7601  # ION, and A, A, Z thrice
    assert pal.assemble("A!A\n$\n").values["IOQ"] == 0o6001
    after_a_form_feed = pal.assemble("A=1\n\tA\n\f\tA\n=5\n\tA\n$\n")
    assert after_a_form_feed.listing.endswith("\n0202  0001  \tA\n\nA       0001\n\n")


def test_the_loader_skips_the_messages_on_the_asr_33s_tape() -> None:
    for name in NAMES:
        with case(name):
            assembly = assembled(name)
            tape = assembly.teletype.pass2
            assert binary.decode(tape).words == assembly.words
            without = b"".join(tape.split(b"\xff")[::2])
            assert_same_tape(without, (EXAMPLES / f"{name}.bin").read_bytes())


def test_the_form_of_the_source_tape_does_not_matter() -> None:
    for name in NAMES:
        text = (EXAMPLES / f"{name}.pal").read_bytes()
        tape = text.replace(b"\n", b"\r\n")
        forms = {
            **{"CR LF": tape, "CR": text.replace(b"\n", b"\r")},
            "mark": bytes(frame | 0o200 for frame in tape),
            "even": bytes(frame | 0o200 * (frame.bit_count() % 2) for frame in tape),
            "leader and rubouts": b"\0\x7f\x80" + text.replace(b"\n", b"\r\0\xff\n\xff\xff") + b"\x80",
        }
        for form, tape in forms.items():
            with case(name, form):
                assembly = pal.assemble(tape, capacity=HIGH_SPEED_SYMBOLS)
                assert_same_tape(assembly.tape, (EXAMPLES / f"{name}.bin").read_bytes())
                assert assembly.listing == (EXAMPLES / f"{name}.pass3.txt").read_text()


@pytest.mark.parametrize("name", ["chain3", "fieldchain2", "full490"])
def test_what_dec_never_finishes_is_an_error_and_makes_nothing(name: str) -> None:
    assembly = assembled(f"stops/{name}")
    assert (assembly.ok, assembly.tape, assembly.words, assembly.listing) == (False, b"", {}, "")
    assert any(diagnostic.error for diagnostic in assembly.diagnostics)
    before = ast.literal_eval(
        (EXAMPLES / "stops" / f"{name}.stops.txt").read_text().split("typed ")[1].split(" ...")[0]
    )
    assert before.startswith(assembly.text(1))
