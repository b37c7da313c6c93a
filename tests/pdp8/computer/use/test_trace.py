"""The trace follows the listing; breakpoints stop where they should."""

from itertools import pairwise

import pytest

import pal
from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.machine import Machine
from pdp8.computer.use.trace import Listing, Trace, instruction
from tests.pdp8.computer.bench import machine
from tests.pdp8.computer.use.test_operator import assembly


def test_a_listing_is_the_assemblys() -> None:
    listing = Listing.of(pal.assemble("/A\n*200\nB,\tHLT\t/C\n$\n"))
    assert listing.lines == [f"{'':12}/A", f"{'':12}*200", "0200  7402  B,      HLT     /C"]
    assert (listing.words, listing.places, listing.numbers) == ({0o200: 0o7402}, {0o200: 2}, {0o200: 3})
    assert listing.symbols == {"B": 0o200}


def test_a_tag_has_the_field_of_its_word() -> None:
    """A symbol's value has twelve bits: what is typed for a tag, `break TAG`, is the address of its word."""
    fields = (
        "A,\tHLT\nFIELD 1\n*200\nB,\tCLA; C,\tHLT /A, B\nD,\n\nEND1234,\tHLT\nK=201\nFIELD 2\n*300\n\tHLT\n"
    )
    listing = Listing.of(pal.assemble(f"*200\n{fields}LAST,\n$\n"))
    assert listing.symbols == {
        **{"A": 0o200, "B": 0o10200, "C": 0o10201, "D": 0o10202, "END123": 0o10202},
        **{"K": 0o201, "LAST": 0o301},
    }


def test_an_interrupt_and_a_wait_are_told() -> None:
    m = machine("6001 5201 1/ 7402", b"\1")
    lines: list[str] = []
    m.watch.observer = Trace(lines.append, Listing(), cycles=False)
    m.run()
    assert lines[0].endswith("6001          ION")
    (again,) = [line for line in lines if "the same again" in line]
    turns = int(again.split()[4].replace(",", ""))
    assert again == f"{' ' * 16}  ... the same again: {turns:,} instructions, {turns * 0.0016:,.3f} ms"
    assert len(lines) < 20_000


def test_a_line_has_the_time_at_which_its_instruction_or_interrupt_begins() -> None:
    """TAD I 10, ISZ 11, DCA 20, ION, JMP 200; at 0001 TCF, ION, JMP I 0: by the lines of each cycle."""
    program = "1410 2011 3020 6001 5200 0/ 0 6042 6001 5400"
    lines: dict[bool, list[str]] = {False: [], True: []}
    for cycles, said in lines.items():
        m = machine(program)
        m.watch.observer = Trace(said.append, Listing(), cycles=cycles)
        for _ in range(3):
            m.teletype.transmitter.flag = 1
            m.run(instructions=20)
    begin = [line[:14] for line in lines[True] if "  FETCH" in line or "an interrupt" in line]
    assert [line[:14] for line in lines[False]] == begin
    assert sum("an interrupt" in line for line in lines[False]) == 3
    times = [float(line[:14].replace(",", "")) for line in lines[True]]
    assert {round(after - before, 2) for before, after in pairwise(times)} <= {1.6, 4.25}


def test_a_word_that_is_not_as_assembled_is_disassembled() -> None:
    listing = Listing.of(assembly("hello"))
    assert listing.line(0o200, 0o7300) == "0200  7300  START,  CLA CLL"
    assert listing.line(0o200, 0o3611) == "0200  3611          DCA I 0211"
    assert instruction(0o377, 0o5200) == "JMP 0200"
    assert instruction(0, 0o7401) == "7401"


def test_the_racks_iots_have_names_where_it_is_fitted() -> None:
    plain, rack = Machine(), Machine([TC08()], memory=0o20000)
    for word, name in ((0o6211, "CDF 10"), (0o6203, "CIF CDF 00"), (0o6234, "RIB"), (0o6766, "DTLA")):
        assert instruction(0o200, word, rack.processor) == name
        assert instruction(0o200, word, plain.processor) != name
    rack.load({0o10200: 0o6211, 0o10201: 0o7402})
    lines: list[str] = []
    rack.watch.observer = Trace(lines.append, Listing(), cycles=False)
    rack.pc = 0o10200
    rack.run()
    assert [line[19:] for line in lines] == [
        "0 0000  10200 6211  10200  6211          CDF 10",
        "0 0000  10201 7402  10201  7402          HLT",
    ]


@pytest.mark.parametrize("instructions", [46, 47])
def test_a_word_watched_in_the_middle_of_a_wait_stops_at_its_next_writing(instructions: int) -> None:
    """DCA 0220, two NOPs, KSF, JMP 0200: known for a wait, and past the DCA, when the word is watched."""
    m = machine("3220 7000 7000 6031 5200")
    m.teletype.keyboard.press(b"A")
    m.run(instructions=instructions)
    m.watch.writes.add(0o220)
    for _ in range(2):
        before = m.instructions
        assert m.run(seconds=1).reason == "breakpoint"
        assert m.instructions - before <= 5
