"""One reader of programs: what each kind of tape is, what is refused and in which words."""

import pytest

from pdp8 import shelf
from pdp8.computer.machine import Machine
from pdp8.computer.use import program
from pdp8.computer.use.operator import RIM, RIM_START, Operator
from tapes import ascii, binary, codes, rim, title
from tapes.errors import WorkError

WORDS = {0o200: 0o7001, 0o201: 0o7402}


@pytest.mark.parametrize("name", ["eia.pal", "eia.bin"])
def test_source_and_its_tape_are_the_same_program(name: str) -> None:
    found = shelf.program(name)
    assert found.words[0o200] == 0o6046
    assert len(found.words) == 131
    assert codes.recognise(found.tape) is codes.BIN
    assert found.listing.line(0o227, 0).startswith("0227  0000")


def test_a_rim_tape_is_its_own_tape() -> None:
    found = program.read(rim.encode(WORDS), "x.rim")
    assert (found.name, found.code, found.words) == ("x.rim", codes.RIM, WORDS)
    assert found.tape == rim.encode(WORDS)
    assert found.listing.symbols == {}
    assert found.listing.line(0o200, 0o7001) == "0200  7001          IAC             /0200 7001"


def test_a_rim_tape_that_changes_the_rim_loader_starts_itself() -> None:
    """As EduSystem 20-C does by 7774; the RIM loader's own tape does not."""
    for words, said in (
        ({0o7600: 0o7402, 0o7774: 0o5200}, True),
        ({0o7600: 0o7402, 0o7777: 0o5200}, False),
        (shelf.bundled_program("rim.pal").words, False),
    ):
        frames = rim.encode(words)
        assert any("starts itself" in note for note in program.read(frames, "x").notes) == said
        machine = Machine()
        boot = Operator(machine)
        list(boot.toggle(RIM_START, RIM))
        boot.mount("x", frames)
        boot.start(RIM_START, seconds=20)
        assert (machine.pc not in range(0o7756, 0o7777)) == said


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"*200\n\tJMP XX\n$\n", "x: not loaded: 1 error\nx:2:"),
        (b"*200\nFIELD 1\n*0\n1\n$\n", "x: address 10000: a PDP-8/L with 4K of core ends at 07777"),
        (bytes(9), "x: the program tape is blank"),
        (b"$\n", "x: no word in it goes into core"),
        (shelf.read_bundled("circle.eia"), "x: neither PAL source nor a BIN or RIM tape"),
        (binary.encode({0o10200: 1}), "x: frame 64: field 1: this PDP-8/L has 4K of core, only field 0"),
        (binary.encode({0o10200: 1, 0o10201: 2})[:72], "x: frame 72: the tape is cut short inside a word"),
        (binary.encode(WORDS)[:70], "x: frame 70: the tape is cut short: it has no trailer"),
    ],
)
def test_what_is_no_program_is_refused_by_name(content: bytes, said: str) -> None:
    with pytest.raises(WorkError) as refused:
        program.read(content, "x")
    assert str(refused.value).partition(said)[::2] == ("", str(refused.value)[len(said) :] * ("\n" in said))


def test_fields_beyond_core_are_refused_by_the_first_and_left_out() -> None:
    tape = binary.encode({0o7777: 1, 0o10000: 2, 0o17777: 3, 0o20000: 4, 0o30000: 5})
    for memory, last, words in ((4096, "only field 0", 1), (8192, "fields 0 to 1", 3)):
        with pytest.raises(WorkError, match=f"field {memory >> 12}: .* has {memory >> 10}K of core, {last}$"):
            program.read(tape, "x", memory=memory)
        found = program.read(tape, "x", force=True, memory=memory)
        assert [*found.words.values()] == [1, 2, 3][:words]
    assert len(program.read(tape, "x", memory=4 * 4096).words) == 5


def test_a_field_0_is_read_and_the_last_word_of_core() -> None:
    tape = binary.encode({0o200: 0o7402, 0o7777: 0o5200})
    leader = len(tape) - len(tape.lstrip(b"\200"))
    found = program.read(tape[:leader] + b"\300" + tape[leader:], "x")
    assert (found.words, found.notes) == ({0o200: 0o7402, 0o7777: 0o5200}, ())


def test_the_first_of_many_errors_are_shown_and_all_counted() -> None:
    with pytest.raises(WorkError) as refused:
        program.read(b"*200\n" + b"\tJMP 400\n" * 120 + b"$\n", "x", dialect="pal3")
    said = str(refused.value)
    assert said.startswith("x: not loaded: 120 errors\nx:2:2: ")
    assert said.count("JMP 400") == 3
    *_, more, other = said.splitlines()
    assert more == "and 117 more: `pal` shows them, with its notes"
    assert other.endswith("note: in PAL8 this has no error: --dialect pal8 [PN36]")


def test_force_loads_no_tape_without_a_word() -> None:
    with pytest.raises(WorkError, match="no word in it goes into core; frame 66: the tape is cut short"):
        program.read(binary.encode(WORDS)[:66], "x", force=True)


def test_of_several_tapes_the_one_with_a_title_is_named() -> None:
    titled = title.punch("TWO") + ascii.encode("HLT\n$\n")
    for tapes, said in (
        ([b"*200\n", titled], "^1 2: 2: frame 0: a title"),
        ([titled], "^1: frame 0: a title"),
    ):
        with pytest.raises(WorkError, match=said):
            program.read_sources(tapes, ["1", "2"][: len(tapes)])
