"""Counts add up to what the machine says it did, whatever was passed over, and name the words."""

import json
from copy import copy
from pathlib import Path

from pdp8.computer.count import Count
from pdp8.computer.past import rewind
from pdp8.computer.past.history import History
from pdp8.computer.use import counted as used
from pdp8.computer.use.trace import Listing, Trace
from tapes import ascii
from tests.conftest import Shell, case
from tests.pdp8.computer.bench import machine


def test_a_ring_of_several_instructions_is_known_by_its_turn() -> None:
    """KSF, SKP, HLT, CLA, JMP 200: four instructions a turn, until a key comes."""
    m = machine("6031 7410 7402 7200 5200")
    m.wait(0)
    count = m.watch.observer = Count()
    m.teletype.keyboard.press(b"\xc1")
    m.run()
    turns = count.executed[0o203]
    assert turns > 8000
    assert [count.executed[0o200 + at] for at in range(5)] == [turns + 1, turns, 1, turns, turns]
    assert count.ticks == m.ticks
    assert count.waiting > 0.9 * count.ticks


def test_by_hand() -> None:
    """Three turns of ISZ 210, JMP .-1, then JMS 211, which is written, then HLT."""
    m = machine("2210 5200 4211 210/ 7775 212/ 7402")
    with m.count() as count:
        m.run()
    assert m.watch.observer is None
    count.waiting, count.interrupts = 88, 1234
    listing = Listing()
    listing.words = {0o200: 0o2210, 0o213: 0}
    assert used.record(count, listing) == {
        **{"instructions": 7, "cycles": 3 * 2 + 2 * 1 + 2 + 1, "interrupts": 1234},
        **{"seconds": 17.6e-6, "waiting_seconds": 4.4e-6},
        "operations": {"ISZ": 3, "JMP": 2, "JMS": 1, "HLT": 1},
        "executed": {"0200": 3, "0201": 2, "0202": 1, "0212": 1},
        **{"written": {"0210": 3, "0211": 1}, "never_executed": ["0213"]},
    }
    assert list(used.table(count, listing)) == [
        *("7 instructions, 11 cycles, 0.0 s", "waiting 25.00 %, 0.0 s", "interrupts 1,234"),
        *("    ISZ                        3   42.86 %", "    JMP                        2   28.57 %"),
        *("    JMS                        1   14.29 %", "    HLT                        1   14.29 %"),
        *("never executed: 0213", "written: 0210-0211"),
    ]
    assert list(used.table(Count(), Listing())) == [
        *("0 instructions, 0 cycles, 0.0 s", "waiting 0.00 %, 0.0 s"),
        *("never executed: none", "written: none"),
    ]


def test_an_interrupt_that_was_due_before_counts_too() -> None:
    """KSF, JMP .-1, ION, NOP: it is counted and traced whenever that begins."""
    m = machine("6031 5200 6001 7000 1/ 7402")
    m.teletype.keyboard.press(b"\xc1")
    m.watch.breakpoints = {0o203}
    assert m.run().pc == 0o203
    m.run(instructions=1)
    count, lines = Count(), list[str]()
    again = copy(m)
    m.watch.observer, again.watch.observer = count, Trace(lines.append, Listing(), False)
    assert m.run().pc == again.run().pc == 2
    assert (count.interrupts, dict(count.executed), dict(count.written)) == (1, {1: 1}, {0: 1})
    assert [line.split()[-1] for line in lines] == ["interrupt", "HLT"]


def test_what_was_undone_is_no_turn_of_a_loop() -> None:
    """TLS, then TSF, AND 0 twice, JMP 200: what is run is counted, before and after a step back."""
    for first in range(2, 12):
        m = machine("6041 203/ 5200 177/ 6046", pc=0o177)
        count = m.watch.observer = Count()
        m.run(instructions=first)
        history = History(m)
        m.run(instructions=1)
        rewind.instructions(history, 1)
        m.run(instructions=10)
        with case(first):
            assert count.instructions == m.instructions + 1 == first + 11
            assert count.cycles == count.instructions + count.executed[0o201] + count.executed[0o202]


def test_the_run_command_counts(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "in.asc").write_bytes(ascii.encode("7\n"))
    done = shell("pdp8 run eia.pal --annotate a --count-json j --reader in.asc --punch out --quiet")
    assert (done.returncode, done.stderr) == (0, b"")
    record = json.loads((tmp_path / "j").read_text())
    assert record["executed"]["0217"] == 9
    assert record["written"] == {"0100": 9 + 2, "0214": 10, "0221": 2, "0227": 9}
    assert 0.99 < record["waiting_seconds"] / record["seconds"] < 1
    (krb,) = [line for line in (tmp_path / "a").read_text().splitlines() if "KRB" in line]
    assert krb.split()[:3] == ["9", "0217", "6036"]
    assert shell("pdp8 run eia.pal --reader in.asc --punch plain --quiet; cmp out plain").returncode == 0
    done = shell("pdp8 run hello.pal --count --trace t < /dev/null")
    assert (done.returncode, b"--count and --trace" in done.stderr) == (2, True)
