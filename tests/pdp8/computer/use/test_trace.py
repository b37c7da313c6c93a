"""The trace follows the listing; breakpoints stop where they should."""

import pytest

import pal
from pdp8.computer.machine import Machine
from pdp8.computer.use.trace import Listing, Trace, instruction
from tests.pdp8.computer.bench import machine
from tests.pdp8.computer.use.test_operator import assembly


def traced(m: Machine, cycles: bool = False, listing: Listing | None = None) -> list[str]:
    lines: list[str] = []
    m.watch.observer = Trace(lines.append, listing or Listing(), cycles)
    return lines


def test_an_instruction_a_line() -> None:
    m = Machine()
    m.load(assembly("hello").words)
    m.start(0o200)
    lines = traced(m, listing=Listing.of(assembly("hello")))
    m.run(instructions=7)
    assert lines == [
        "          0.00 us  0 0000  0200 7300  0200  7300  START,  CLA CLL",
        "          1.60 us  0 0213  0213 0213  0201  1213          TAD FIRST",
        "          4.80 us  0 0000  0010 0213  0202  3010          DCA POINT       "
        "/ONE BEFORE THE TEXT: IT STEPS FIRST",
        "          8.00 us  0 0215  0214 0215  0203  1410  NEXT,   TAD I POINT",
        "         12.80 us  0 0215  0204 7450  0204  7450          SNA",
        "         14.40 us  0 0215  0206 6046  0206  6046          TLS",
        "         18.65 us  0 0215  0207 6041  0207  6041          TSF",
    ]


def test_a_listing_is_the_assemblys() -> None:
    listing = Listing.of(pal.assemble("/A\n*200\nB,\tHLT\t/C\n$\n"))
    assert listing.lines == [f"{'':12}/A", f"{'':12}*200", "0200  7402  B,      HLT     /C"]
    assert (listing.words, listing.places, listing.numbers) == ({0o200: 0o7402}, {0o200: 2}, {0o200: 3})
    assert listing.symbols == {"B": 0o200}


def test_a_cycle_a_line() -> None:
    m = machine("1410 7402 10/ 277 300/ 1234", link=1)
    m.stop()
    m.wait(0.001)
    m.panel.load_address(0o200)
    m.panel.start()
    m.link = 1
    lines = traced(m, cycles=True)
    m.run()
    assert lines == [
        "          0.00 us  FETCH    1 0000  0200 1410  0200  1410          TAD I 0010",
        "          1.60 us  DEFER    1 0000  0010 0300  0200  1410          TAD I 0010",
        "          3.20 us  EXECUTE  1 1234  0300 1234  0200  1410          TAD I 0010",
        "          4.80 us  FETCH    1 1234  0201 7402  0201  7402          HLT",
    ]


def test_of_an_instruction_that_began_before_the_end_is_told() -> None:
    m = machine("1300")
    m.processor.cycle()
    lines = traced(m)
    m.run(instructions=1)
    assert lines[0] == f"{0:14.2f} us  0 0000  0300 0000  "


def test_an_interrupt_and_a_wait_are_told() -> None:
    m = machine("6001 5201 1/ 7402", b"\1")
    lines = traced(m)
    m.run()
    assert lines[0].endswith("6001          ION")
    (again,) = [line for line in lines if "the same again" in line]
    turns = int(again.split()[4].replace(",", ""))
    assert again == f"{' ' * 16}  ... the same again: {turns:,} instructions, {turns * 0.0016:,.3f} ms"
    assert lines[-2:] == [
        f"{(m.ticks - 64) / 20:14,.2f} us  0 0000  0000 0201              JMS 0: an interrupt",
        f"{(m.ticks - 32) / 20:14,.2f} us  0 0000  0001 7402  0001  7402          HLT",
    ]
    assert len(lines) < 20_000


def test_a_word_that_is_not_as_assembled_is_disassembled() -> None:
    listing = Listing.of(assembly("hello"))
    assert listing.line(0o200, 0o7300) == "0200  7300  START,  CLA CLL"
    assert listing.line(0o200, 0o3611) == "0200  3611          DCA I 0211"
    assert instruction(0o377, 0o5200) == "JMP 0200"
    assert instruction(0, 0o7401) == "7401"


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
