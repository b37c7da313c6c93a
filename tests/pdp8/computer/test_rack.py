"""The small devices by programs in octal: the clock, the printer, the second Teletype, the disk."""

import random
from array import array
from pathlib import Path
from unittest.mock import patch

import pytest

from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.computer.rack.df32 import DF32, DISC
from pdp8.computer.rack.kw8 import KW8
from pdp8.computer.rack.lp08 import LP08
from pdp8.computer.rack.pt08 import PT08
from pdp8.fitting import known
from tapes.errors import WorkError
from tests.conftest import Call
from tests.pdp8.computer.bench import core

LATE, REFUSED = 4, 2


def rack(words: str, *devices: KW8 | LP08 | PT08 | DF32, memory: int = 0o10000) -> Machine:
    """Return a machine with these devices, started at 0200."""
    made = Machine([Teletype(), *devices], memory)
    made.load(core(words))
    made.start(0o200)
    return made


def test_the_clock_interrupts_sixty_times_a_second() -> None:
    """CECI, ION, JMP .; at 0001: ISZ 10, CSCF, HLT, ION, JMP I 0. Then CCEC without interrupt; CCFF."""
    m = rack("6137 6001 5202 1/ 2010 6133 7402 6001 5400", KW8())
    m.run(1.001)
    assert m.core[0o10] == 60
    m = rack("6136 6133 5201 2010 6132 6133 5205 7402", KW8())
    m.run(0.5)
    assert (m.core[0o10], m.pc in (0o205, 0o206)) == (1, True)
    m = rack("6134 6133 5201 7402", KW8())  # no such instruction of the clock, which stays off
    m.run(0.5)
    assert m.pc in (0o201, 0o202)


def test_a_line_is_printed_in_a_fifth_of_a_second() -> None:
    """TAD I 10, SNA, HLT, PSTB, PSKF, JMP .-1, PCLF, CLA, JMP 200: HI, a small i, line feed."""
    m = rack("1410 7450 7402 6666 6661 5204 6662 7200 5200 10/ 377 400/ 110 311 151 12 0", LP08())
    stop = m.run(10)
    printer = next(each for each in m.devices if isinstance(each, LP08))
    assert (stop.reason, printer.paper) == ("halt", "HII\n")
    assert m.elapsed == pytest.approx(0.2, abs=0.001)


def test_a_full_line_is_printed_by_the_character_behind_it() -> None:
    """132 characters go into the buffer; small letters are printed as capitals, from a to z only."""
    m = rack("1030 6664 6661 5202 6662 7200 2020 5200 7402 20/ 7573 30/ 172", printer := LP08())
    assert m.run(10).reason == "halt"
    assert (printer.paper, printer.column, m.elapsed < 0.05) == ("Z" * 133, 0, False)
    m = rack("1030 6664 6661 5202 6662 7200 2020 5200 7402 20/ 7574 30/ 173", printer := LP08())
    assert m.run(10).reason == "halt"
    assert (printer.paper, printer.column, m.elapsed < 0.05) == ("{" * 132, 132, True)
    m.start(0o200)
    assert printer.column == 0


def test_the_printer_interrupts_only_when_it_is_let() -> None:
    """PSIE or PCIE or PSKE, ION, PSTB, JMP .; at 0001 HLT. PSKE never skips, and changes nothing."""
    for enable, reason in (("6665", "halt"), ("6667", "idle"), ("6663", "idle")):
        assert rack(f"{enable} 6001 6664 5203 1/ 7402", LP08()).run(0.1).reason == reason


@pytest.mark.parametrize(
    ("digit", "skips", "flag", "enabled"),
    [(1, 1, 1, 1), (2, 0, 0, 1), (3, 0, 1, 1), (4, 0, 1, 1), (5, 0, 1, 1), (6, 0, 0, 1), (7, 0, 1, 0)],
)
def test_what_each_instruction_does_to_the_printers_flag_and_its_interrupt(
    digit: int, skips: int, flag: int, enabled: int
) -> None:
    """As SIMH's pdp8_lp.c has it: 666x, at 0200, with flag and interrupt on."""
    m = rack(f"666{digit} 7402 7402", printer := LP08())
    printer.flag = printer.enabled = 1
    m.run()
    assert (m.pc - 0o202, printer.flag, printer.enabled) == (skips, flag, enabled)


def test_two_teletypes_echo_each_its_own() -> None:
    """JMP .+5 where KSF of the one skips; each character goes back to where it came from."""
    m = rack("6031 5204 6036 6046 6401 5200 6406 6416 5200", PT08())
    second = next(each for each in m.devices if isinstance(each, PT08))
    assert m.teletype is not second
    m.teletype.keyboard.press(b"\301\302")
    second.keyboard.press(b"\303\304\305")
    m.run(2)
    assert bytes(m.teletype.printer.frames) == b"\301\302"
    assert bytes(second.printer.frames) == b"\303\304\305"


TRANSFER = "1020 6615 7200 1021 6603 6622 5205 6616 7402"
"""TAD 20, DEAL, CLA, TAD 21, DMAR, DFSC, JMP .-1, DEAC, HLT; DMAW in place of 6603 writes."""


def moved(m: Machine, at: int, core_at: int, count: int, write: bool = False) -> tuple[int, float]:
    """Move words between the disk and core; return the status, and the seconds it took."""
    m.load(core(TRANSFER.replace("6603", "6605" if write else "6603")))
    m.core[0o20], m.core[0o21] = at >> 6 & 0o3700 | core_at >> 9 & 0o70, at & 0o7777
    m.core[0o7750], m.core[0o7751] = -count & 0o7777, core_at - 1 & 0o7777
    m.stop()
    m.start(0o200)
    before = m.elapsed
    assert m.run(60).reason == "halt"
    return m.ac, m.elapsed - before


def disk(discs: int = 1) -> tuple[Machine, DF32]:
    """Return a machine of 8K with a disk of random words."""
    control = DF32()
    draw = random.Random(32)
    control.words = array("H", [draw.randrange(4096) for _ in range(discs * DISC)])
    return rack("", control, memory=0o20000), control


def test_what_is_written_is_read_again_across_discs_and_fields() -> None:
    m, control = disk(2)
    draw = random.Random(8)
    kept = control.words[:]
    for _ in range(8):
        count, at = draw.randrange(1, 300), draw.randrange(2 * DISC - 300)
        core_at = draw.choice((0o1000, 0o3000, 0o11000, 0o15000))
        words = [draw.randrange(4096) for _ in range(count)]
        for number, word in enumerate(words):
            m.core[core_at + number] = word
        assert moved(m, at, core_at, count, write=True)[0] & 7 == 0
        kept[at : at + count] = array("H", words)
        assert control.at == at + count - 1  # after a write that of the last word
        other = draw.randrange(2 * DISC - 300)
        assert moved(m, other, 0o12000, count)[0] & 7 == 0
        assert [m.core[0o12000 + number] for number in range(count)] == list(kept[other : other + count])
        assert control.at == other + count
    assert control.words == kept


def test_a_disk_has_one_to_four_discs_of_words() -> None:
    control = DF32()
    for discs in (1, 2, 3, 4):
        content = bytes(2 * DISC * discs - 2) + b"\xff\x0f"
        control.content = content
        assert control.content == content
    for wrong in (
        b"",
        bytes(2 * DISC - 2),
        bytes(2 * DISC - 1),
        bytes(2 * DISC + 2),
        bytes(10 * DISC),
        bytes(2 * DISC - 1) + b"\x10",
    ):
        with pytest.raises(ValueError, match="one to four discs of 65,536 bytes, words of 12 bits"):
            control.content = wrong
    assert control.content == content


def test_a_word_comes_within_a_turn_and_the_next_after_66_microseconds() -> None:
    """16.67 ms to a word on average, 66 µs from word to word (Small Computer Handbook 1970)."""
    m, _ = disk()
    waits = [moved(m, at, 0o1000, 1)[1] for at in random.Random(5).sample(range(DISC), 24)]
    assert 0.01 < sum(waits) / len(waits) < 0.024 < max(waits) < 0.034
    few, many = (sorted(moved(m, 0, 0o12000, count)[1] for _ in range(2))[0] for count in (1, 1024))
    assert many - few == pytest.approx(1023 * 66e-6, abs=0.035)


def test_a_locked_or_missing_disc_and_a_late_break() -> None:
    m, control = disk()
    before = control.words[:]
    control.locks = 0b10
    assert moved(m, 0o37777, 0o1000, 2, write=True)[0] & 7 == REFUSED
    assert control.words[0o40000:] == before[0o40000:]
    assert control.words[0o37777] == m.core[0o1000]
    assert moved(m, DISC - 1, 0o1000, 2)[0] & 7 == REFUSED
    assert moved(m, 0o40000, 0o1000, 2)[0] & 7 == 0
    m.load(core("6603 6621 7410 5201 7402"))  # DMAR; DFSE, SKP: until there is an error
    m.stop()
    m.start(0o200)
    m.run(instructions=1)
    m.stop()
    m.wait(0.05)
    assert m.run(1).reason == "halt"
    assert control.status == LATE


def test_a_state_holds_them_all() -> None:
    m = Machine([Teletype(), KW8(), LP08(), PT08(), DF32()])
    m.load(core(TRANSFER))
    m.start(0o200)
    m.run(0.001)
    text = state.save(m)
    assert state.save(state.restore(text, known=known())) == text


def test_the_commands_fill_and_save_a_disk_and_a_printer(call: Call, tmp_path: Path) -> None:
    """One word of the disk, 0111, is read, printed, and written one further on; AC has its address."""
    words = array("H", bytes(2 * DISC))
    words[5] = 0o111
    (tmp_path / "disk").write_bytes(words.tobytes())
    (tmp_path / "prog.pal").write_text(
        "*200\nTAD A\n6603\n6622\nJMP .-1\nTAD 300\n6664\n6661\nJMP .-1\nCLA CMA\nDCA 7750\n"
        "TAD C\nDCA 7751\nTAD B\n6605\n6622\nJMP .-1\nHLT\nA, 5\nB, 6\nC, 277\n*7750\n7777\n277\n$\n"
    )
    done = call("pdp8 run prog.pal --disk df32=disk --save-disk df32=after --printer out.txt")
    assert done[0] == 0, done
    assert (tmp_path / "after").read_bytes()[10:14] == b"\x49\0\x49\0"
    assert (tmp_path / "out.txt").read_text() == "I"
    said = call("pdp8 run prog.pal --disk df32=disk --printer out.txt")[2].splitlines()
    assert said[1] == "pdp8 run: df: 1 word of disk changed, and not saved: wrote disk-changed"
    assert (tmp_path / "disk-changed").read_bytes() == (tmp_path / "after").read_bytes()
    assert "not saved" not in call("pdp8 run prog.pal --disk df32=after --printer out.txt")[2]
    with patch("pdp8.reels.Reels.save", side_effect=WorkError("after was mounted; name another file")):
        done = call("pdp8 run prog.pal --disk df32=disk --save-disk df32=x --printer p.txt --save s.state")
        assert (done[0], "another file" in done[2], "pdp8 run: HLT" in done[2]) == (1, True, True)
        assert ((tmp_path / "p.txt").read_text(), (tmp_path / "s.state").exists()) == ("I", True)
    assert call("pdp8 run prog.pal --disk rk05=disk")[0] == 2
    (tmp_path / "short").write_bytes(b"\1\2\3")
    assert "3 bytes: one to four discs" in call("pdp8 run prog.pal --disk df32=short")[2]
