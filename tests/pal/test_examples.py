"""What DEC-08-ASB1, DEC's own PAL III of February 1967, made of each source in examples/.

NAME.bin is the tape of the high-speed punch, raw; NAME.passN.txt is what the Teletype printed in a pass,
without the codes that do not print and with CR LF as one line end. They were read by the high-speed reader,
each PAUSE at the end of a tape. stops/ has sources that it never finishes. asr/ has what the Teletype's punch
had in the three passes with the source in the ASR-33's reader, raw.
"""

import ast
from itertools import zip_longest
from pathlib import Path

import pytest

import pal
from pal.assembler import HIGH_SPEED_SYMBOLS
from pal.assembly import Assembly
from tapes import binary
from tapes.frames import draw
from tests.conftest import case

EXAMPLES = Path(__file__).parent / "examples"
NAMES = sorted(path.stem for path in EXAMPLES.glob("*.pal"))


def assembled(name: str) -> Assembly:
    return pal.assemble((EXAMPLES / f"{name}.pal").read_bytes(), capacity=HIGH_SPEED_SYMBOLS)


def assert_same_tape(ours: bytes, theirs: bytes) -> None:
    for number, (our, their) in enumerate(zip_longest(ours, theirs)):
        if our != their:
            shown = " and ".join(
                "no frame" if frame is None else f"[{draw(frame)}]" for frame in (our, their)
            )
            pytest.fail(f"frame {number}: ours and DEC's are {shown}")


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


def typed(text: str) -> bytes:
    return bytes(ord(character) | 0o200 for character in text)


LEADER = b"\x80" * 64


def test_the_frames_of_pass_3() -> None:
    frames = pal.assemble("\t1\f;JMP 400\n$\n").teletype.pass3
    feed = bytes(6) + typed("\f") + bytes(6)
    assert frames == b"".join(
        (
            b"\0" + LEADER + typed("\r\n0200  0001  "),
            typed("\x7f\r\nIR  0400  AT  0201\x7f"),
            typed("\r\n0201  5200  \t\x7f1") + feed + typed(";JMP 400"),
            typed("\r\n") + LEADER + typed("\x7f\r\n\x04\r\n\x7f") + LEADER,
        )
    )


@pytest.mark.parametrize("path", sorted((EXAMPLES / "asr").glob("*.pal")), ids=lambda path: path.stem)
def test_the_frames_of_the_three_passes_by_the_asr_33s_reader(path: Path) -> None:
    teletype = pal.assemble(path.read_bytes()).teletype
    for number, frames in enumerate(teletype, 1):
        assert_same_tape(frames, path.with_suffix(f".tty{number}").read_bytes())


@pytest.mark.parametrize(
    ("number", "types"),
    [("1A!B!C!D", "A!!!"), ("1AB!5C6", "A!"), ("1A!5!B!5", "A!5!!"), ("1!A!B!5C6", "!A!!"), ("9M", "M")],
)
def test_after_a_second_letter_the_rest_of_a_number_is_passed_over(number: str, types: str) -> None:
    """As DEC-08-ASB1 does by the ASR-33's reader; so the word is 0, unless digits come first."""
    assembly = pal.assemble(f"*200\n{number}\n$\n")
    codes = [0o241 if character == "!" else ord(character) & 0o77 for character in types]
    assert [int(message.subject, 8) for message in assembly.messages] == codes
    assert assembly.words == {0o200: 0o11 if number == "9M" else 0}


@pytest.mark.parametrize(
    ("source", "line"),
    [("\tCLA\nI=5\n\tTAD I 5\n", 2), ("DECIMAL=5\n\t1\nDECIMAL\n", 1), ("=5\n\tCLA\n", 1), ("\t15\n=5\n", 2)],
)
def test_where_pal_iii_is_wrecked_the_definition_is_to_blame(source: str, line: int) -> None:
    assembly = pal.assemble(source + "$\n")
    (error,) = [diagnostic for diagnostic in assembly.diagnostics if diagnostic.code == "PS01"]
    assert (error.line, error.column) == (line, 1)


def test_a_name_may_have_a_digit_where_it_is_mentioned() -> None:
    mentions = pal.assemble("B1,\tJMP B1\n\tCLA\n$\n").mentions
    assert [(mention.name, mention.defined) for mention in mentions] == [
        ("B1", True),
        ("JMP", False),
        ("B1", False),
        ("CLA", False),
    ]


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
            "leader and rubouts": b"\0\x80\x80" + text.replace(b"\n", b"\r\0\xff\n\xff\xff") + b"\x80",
        }
        for form, tape in forms.items():
            with case(name, form):
                assembly = pal.assemble(tape, capacity=HIGH_SPEED_SYMBOLS)
                assert_same_tape(assembly.tape, (EXAMPLES / f"{name}.bin").read_bytes())
                assert assembly.listing == (EXAMPLES / f"{name}.pass3.txt").read_text()


@pytest.mark.parametrize("name", ["chain3", "fieldchain2", "full490"])
def test_what_dec_never_finishes_is_an_error_and_makes_nothing(name: str) -> None:
    source = (EXAMPLES / "stops" / f"{name}.pal").read_bytes()
    assembly = pal.assemble(source, capacity=HIGH_SPEED_SYMBOLS)
    assert (assembly.ok, assembly.tape, assembly.words, assembly.listing) == (False, b"", {}, "")
    assert any(diagnostic.error for diagnostic in assembly.diagnostics)
    before = ast.literal_eval(
        (EXAMPLES / "stops" / f"{name}.stops.txt").read_text().split("typed ")[1].split(" ...")[0]
    )
    assert before.startswith(assembly.text(1))


def test_nested_expressions_of_seven_places_are_the_most() -> None:
    assert pal.assemble("A=B=5\n\tA\n$\n").words == {0o200: 5}
    assert pal.assemble("*A=B=300\n\t7\n$\n").words == {0o300: 7}
    assert pal.assemble("A=B=TAD 400\n$\n").stopped  # IR takes three
    assert pal.assemble("FIELD A=B=1\n$\n").stopped


def test_a_table_just_full_is_overwritten_by_the_high_speed_readers_buffer() -> None:
    source = "".join(f"A{number}=1\n" for number in range(HIGH_SPEED_SYMBOLS)) + "$\n"
    assert pal.assemble(source).ok
    assert pal.assemble(source, capacity=HIGH_SPEED_SYMBOLS).stopped


def test_pause_by_either_reader() -> None:
    source = "\t1\nPAUSE;5\n\t2\n$\n"
    assert pal.assemble(source).words == {0o200: 1, 0o201: 5, 0o202: 2}
    assert pal.assemble(source, capacity=HIGH_SPEED_SYMBOLS).words == {0o200: 1, 0o201: 2}


def test_a_tapes_end_ends_neither_a_symbol_nor_a_line() -> None:
    assembly = pal.assemble("\tCL", "A\n$\n")
    assert assembly.words == {0o200: 0o7200}
    assert "0200  7200  \tCLA\n" in assembly.listing
