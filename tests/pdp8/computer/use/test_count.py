"""Counts add up to what the machine says it did, whatever was passed over, and name the words."""

from pathlib import Path

from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.machine import Machine
from pdp8.computer.use import counted as used
from pdp8.computer.use.trace import Listing
from tapes import ascii
from tests.conftest import Shell
from tests.pdp8.computer.bench import machine


def test_by_hand() -> None:
    """Three turns of ISZ 210, JMP .-1, then JMS 211, JMS 0, which no interrupt brings, then HLT."""
    m = machine("2210 5200 4211 210/ 7775 212/ 4000 1/ 7402")
    with m.count() as count:
        m.run()
    assert m.watch.observer is None
    assert count.interrupts == 0
    count.waiting, count.interrupts = 104, 1234
    listing = Listing()
    listing.words = {0o200: 0o2210, 0o213: 0}
    assert (count.instructions, count.cycles) == (8, 3 * 2 + 2 * 1 + 2 + 2 + 1)
    assert count.ticks == 208 * TICKS_PER_SECOND // 10**7
    assert count.operations == {"ISZ": 3, "JMP": 2, "JMS": 2, "HLT": 1}
    assert count.executed == {0o0001: 1, 0o0200: 3, 0o0201: 2, 0o0202: 1, 0o0212: 1}
    assert count.written == {0o0000: 1, 0o0210: 3, 0o0211: 1}
    assert used.never_executed(count, listing) == [0o0213]
    assert list(used.table(count, listing)) == [
        *("8 instructions, 13 cycles, 0.0 s", "waiting 25.00 %, 0.0 s", "interrupts 1,234"),
        *("    ISZ                        3   37.50 %", "    JMP                        2   25.00 %"),
        *("    JMS                        2   25.00 %", "    HLT                        1   12.50 %"),
        *("never executed: 0213", "written: 0000, 0210-0211"),
    ]


def test_a_wait_in_another_field_is_counted_where_it_is() -> None:
    counts = []
    for field in (0, 0o10000):
        m = Machine(memory=0o20000)
        for at, word in enumerate((0o7300, 0o6046, 0o6041, 0o5202, 0o7402), field | 0o200):
            m.processor.core[at] = word
        m.start(0o200)
        m.processor.extension.inst_field = m.processor.extension.inst_buffer = field
        with m.count() as count:
            m.run(seconds=1)
        counts.append({address & 0o7777: number for address, number in count.executed.items()})
        assert {address & 0o10000 for address in count.executed} == {field}
    assert counts[0] == counts[1]
    assert counts[0][0o200] == 1
    assert counts[0][0o203] > 1000


def test_what_a_wait_writes_is_counted_each_time_that_it_is_executed() -> None:
    """DCA 220, ISZ 221, SKP, NOP, KSF, JMP 200; and DCA 220, KSF, JMP 200, which is passed over; HLT."""
    for words, waits in (("3220 2221 7410 7000 6031 5200 7402", False), ("3220 6031 5200 7402", True)):
        m = machine(words)
        m.teletype.keyboard.press(b"A")
        with m.count() as count:
            m.run()
        assert (count.waiting > 0) == waits
        assert count.executed[0o200] > 1000
        assert count.written[0o220] == count.executed[0o200]
        assert count.instructions == count.executed.total()


def test_the_run_command_counts(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "in.asc").write_bytes(ascii.encode("7\n"))
    done = shell("pdp8 run eia.pal --annotate a --reader in.asc --punch out --quiet")
    assert (done.returncode, done.stderr) == (0, b"")
    listing = [line.split() for line in (tmp_path / "a").read_text().splitlines()]
    assert ["9", "0217", "6036"] in [words[:3] for words in listing]
    written = {words[2]: words[0] for words in listing if words[1:2] == ["w"]}
    assert written == {"0100": f"{9 + 2}", "0214": "10", "0221": "2", "0227": "9"}
    assert shell("pdp8 run eia.pal --reader in.asc --punch plain --quiet; cmp out plain").returncode == 0
    done = shell("pdp8 run hello.pal --count --trace t < /dev/null")
    assert (done.returncode, b"--count does not go with --trace" in done.stderr) == (2, True)
