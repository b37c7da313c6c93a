"""What the commands do that a session does not show, and every way to misuse them."""

import re
from pathlib import Path

import pytest

from pdp8.computer.machine import Machine
from pdp8.monitor.arguments import MonitorError, Quoted
from pdp8.monitor.commands import find
from pdp8.monitor.prompt import Monitor
from pdp8.monitor.running import text_of
from tapes.errors import WorkError
from tests.pdp8.monitor import do

LONGEST = (
    "set ac 1; registers; load hello.pal force; boot hello.pal force; listing hello.pal; rim; assert ac 0; "
    "go 200 until X 2 times 5; run 5; cont until X 2 times 5; until X 2 times 5; expect X 5; "
    "wait 0; step 1; cycle 1; back 1 seconds; back until 200 written; trace off; count on; punch off; "
    "fast-reader hello.pal; fast-punch off; save x; restore x; quit; exit"
)


@pytest.mark.parametrize("line", LONGEST.split("; "))
def test_one_word_more_than_a_command_takes_is_refused(line: str) -> None:
    monitor = Monitor(lambda line: None, Machine(highspeed=True))
    with pytest.raises(MonitorError, match="SURPLUS"):
        do(monitor, f"{line} SURPLUS")
    assert (monitor.machine.ticks, monitor.machine.core[0o200], monitor.finished) == (0, 0, False)


def test_a_tape_in_the_high_speed_reader_and_one_off_the_punch(tmp_path: Path) -> None:
    """RFC; RSF; JMP .-1; RRB; PLS; HLT (the user's handbook) copies the first frame of hello.pal, its `/`."""
    monitor = Monitor(lambda line: None, Machine(highspeed=True))
    for line in ("deposit 200 6014 6011 5201 6012 6026 7402", "fast-reader hello.pal", "go 200 1", "wait 1"):
        do(monitor, line)
    do(monitor, f"fast-punch {tmp_path}/x")
    assert (tmp_path / "x").read_bytes() == b"/"


def test_a_command_may_be_shortened() -> None:
    names = {"b": "break", "e": "examine", "ex": "examine", "l": "load", "w": "watch", "SE": "set"}
    assert {word: find(word).name for word in names} == names
    for word in ("ba k", "\0"):
        with pytest.raises(MonitorError, match=re.escape(f"{word!r}: no such command")):
            find(word)


@pytest.mark.parametrize("name", ["mem_prot", "sing_step"])
def test_a_switch_is_put_up_and_down(name: str, monitor: Monitor) -> None:
    for value, position in (("1", True), ("OFF", False), ("on", True), ("0", False)):
        do(monitor, f"set {name} {value}")
        assert getattr(monitor.machine.panel, name) is position


def test_codes_by_their_names() -> None:
    codes = {"BEL": 7, "CR": 13, "LF": 10, "FF": 12, "RUBOUT": 127, "rubout": 127, "A": 65}
    assert {name: ord(text_of(name)) for name in codes} == codes
    assert text_of(Quoted("BEL")) == "BEL"


def test_a_diagnostic_that_rings_the_bell_at_each_pass(monitor: Monitor) -> None:
    words = "7300 1210 6046 6041 5203 5200 7402 0000 0207"  # CLA CLL; TAD BELL; TLS; TSF; JMP .-1; again
    monitor.machine.load({0o200 + at: int(word, 8) for at, word in enumerate(words.split())})
    do(monitor, "go 200 until BEL 3 times 5")
    assert list(monitor.machine.teletype.printer.frames) == [0o207] * 3
    do(monitor, "run until BEL 5", "until BEL 2 times", "until BEL 1 time")
    assert len(monitor.machine.teletype.printer.frames) == 7
    do(monitor, "set pc 200", "go until BEL 5")
    with pytest.raises(MonitorError, match=r"BEL was printed 10 times of 99: 1 s have passed"):
        do(monitor, "until BEL 99 times 1")
    with pytest.raises(MonitorError, match=r"BEL was printed 600 times of 999: 60 s have passed"):
        do(monitor, "until BEL 999 times")


def test_what_the_page_shows_already_is_expected_once(monitor: Monitor) -> None:
    do(monitor, "load hello.pal", "go 200", "expect CR", "expect HELLO")
    with pytest.raises(MonitorError, match="the machine stands still"):
        do(monitor, "expect HELLO")


def test_what_ctrl_c_sets_is_the_stop_key_once(tmp_path: Path) -> None:
    """It is set as the second tape goes in."""
    said: list[str] = []

    def say(line: str) -> None:
        said.append(line)
        made.stopping = line.endswith("goes into the reader")

    made = Monitor(say)
    (tmp_path / "a").write_bytes(b"\x81" * 20)
    do(made, "deposit 200 6031 5200 6036 5200", f"reader {tmp_path}/a {tmp_path}/a", "go 200")
    assert said[-1].startswith("stop key; ")
    do(made, "cont")
    assert said[-1].startswith("tape out; ")


def test_the_lever_leaves_the_tapes_that_wait(monitor: Monitor) -> None:
    do(monitor, "reader circle.asc ellipse.asc")
    for position in ("stop", "stop", "start", "start"):
        do(monitor, f"reader {position}")
        assert monitor.machine.teletype.reader.on == (position == "start")
        assert monitor.waiting_tapes == ["ellipse.asc"]
    do(monitor, "reader none")
    assert (monitor.waiting_tapes, monitor.machine.teletype.reader.tape) == ([], b"")


@pytest.mark.parametrize("command", ["load", "boot", "reader", "listing"])
def test_a_file_that_hides_a_bundled_one_is_named(
    monitor: Monitor, said: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    (tmp_path / "eia.pal").write_text("HLT\n$\n")
    monkeypatch.chdir(tmp_path)
    do(monitor, f"{command} eia.pal")
    assert said[0] == "eia.pal is the file in this folder, not the bundled one of that name"


@pytest.mark.parametrize("command", ["load", "boot"])
def test_what_is_odd_about_a_tape_is_said(
    monitor: Monitor, said: list[str], tmp_path: Path, command: str
) -> None:
    (tmp_path / "text").write_bytes(b"12\n34\n")
    (tmp_path / "bin").write_bytes(
        bytes([*[0o200] * 16, 0o102, 0o000, 0o074, 0o002, 0o000, 0o001, *[0o200] * 16])
    )
    do(monitor, f"reader {tmp_path}/text")
    assert said[-1].startswith(f"{tmp_path}/text has line feeds but no carriage returns")
    do(monitor, f"{command} {tmp_path}/bin force")
    assert ("RIM loader toggled in: 18 keys" in said) == (command == "boot")
    assert said[-1].startswith(f"{tmp_path}/bin: ")
    assert said[-1].endswith("; loaded as far as it can be read")
    assert monitor.machine.core[0o200] == 0o7402
    do(monitor, f"listing {tmp_path}/bin")


WRONG = {
    "registers, rim, run, reader, restore?": ["r"],
    "no such command; help tells which there are": ["frobnicate", "attach"],
    "no such command; did you mean cont?": ["continue"],
    "no such command; did you mean examine?": ["exmaine"],
    "no such file": ["load nothing.pal", "reader nothing.asc"],
    "Is a directory": ["load ."],
    "empty": ["load /dev/null"],
    "No such file or directory": ["punch /nowhere/x"],
    "No space left": ["save /dev/full"],
    "saved state begins with": ["restore eia.pal"],
    "circle.asc: byte 0: not UTF-8\n": ["restore circle.asc"],
    "an address expected": ["examine"],
    "nothing expected, and no more: now": ["rim now"],
    "9: neither an octal number nor a symbol": ["examine 9"],
    "NOPE: neither an octal number nor a symbol; a tape brings none, `listing SOURCE` does": ["e NOPE"],
    "not between 0000 and 7777": ["examine 10000"],
    "20:17: 0017 lies before 0020": ["examine 20:17"],
    "an address and words expected": ["deposit 200"],
    "there are ac link pc ma mb ir sr mem_prot sing_step hands\n": ["set mq 0"],
    "yes: mem_prot is 0 or 1, off or on": ["set mem_prot yes"],
    "77: not between 0 and 7": ["set ir 77"],
    "2: not between 0 and 1": ["set link 2"],
    "the keys are": ["key kick"],
    "seconds of machine time": ["cont soon"],
    "not between 0 and 1e9 seconds": ["cont nan", "wait -1", "wait 1000000001"],
    "seconds expected": ["wait"],
    "on, cycles or off": ["trace maybe"],
    "on, off or listing, or nothing": ["count maybe"],
    "nothing is counted: count on begins": ["count"],
    "É: a Model 33 has no such key": ["type É", 'keyboard now "É"'],
    "\uf800: a Model 33 has no such key": ["type \uf800"],
    "{: a Model 33 has no such key": ["type {"],
    "the program asks for no key: the machine stands still; no keys of 2 sent": ["type A"],
    'a quote (") has no other to end it': ['keyboard "A'],
    r"\x: the escapes are": [r'keyboard "\x"'],
    r"\4: the escapes are": [r'keyboard "\400"'],
    "a text expected": ["keyboard now", 'expect ""'],
    "no: how many times": ["until X no times"],
    "no high-speed reader and punch are fitted": ["fast-reader circle.asc", "fast-punch x"],
    "twice: after the name nothing but force": ["load eia.pal twice"],
    "nothing, or more, expected": ["page all"],
}


@pytest.mark.parametrize(("line", "message"), [(line, said) for said in WRONG for line in WRONG[said]])
def test_what_is_wrong_is_an_error_and_changes_nothing(monitor: Monitor, line: str, message: str) -> None:
    with pytest.raises(WorkError) as raised:
        do(monitor, line)
    assert message in f"{raised.value}\n"
    assert monitor.machine.ticks == 0


def test_the_first_page_more_is_all_of_it(monitor: Monitor, said: list[str], tmp_path: Path) -> None:
    do(monitor, "deposit 200 7300 1204 6046 7402 0301", "go 200", "wait 1")
    do(monitor, *["page more", "expect A", "page", f"save {tmp_path}/x", f"restore {tmp_path}/x"] * 2)
    assert [line for line in said if line == "A"] == ["A"] * 4


@pytest.mark.parametrize("command", ["load", "boot"])
def test_the_listing_stays_and_can_be_taken(
    monitor: Monitor, said: list[str], tmp_path: Path, command: str
) -> None:
    do(monitor, f"{command} eia.pal", f"save {tmp_path}/state", f"restore {tmp_path}/state", "e CHK")
    assert said[-1].startswith("0227  0000  CHK,")
    other = Monitor(said.append)
    do(other, f"restore {tmp_path}/state", "listing eia.pal", "e CHK", "exit")
    assert said[-1].startswith("0227  0000  CHK,")
    assert other.finished
