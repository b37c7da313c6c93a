"""Scripts that wait for prompts, type, and fail where a program does not behave."""

from pathlib import Path

import pytest

from pdp8.computer.past import state
from pdp8.computer.use import program
from pdp8.monitor import commands
from pdp8.monitor.arguments import MonitorError, Quoted
from pdp8.monitor.prompt import Monitor
from pdp8.monitor.running import text_of
from tapes.errors import WorkError
from tests.conftest import Shell

SOURCE = Path(__file__).parent / "dialogue.pal"


@pytest.fixture
def said() -> list[str]:
    return []


@pytest.fixture
def monitor(said: list[str]) -> Monitor:
    """A monitor with the dialogue in core."""
    made = Monitor(said.append)
    made.machine.load(program.find(str(SOURCE)).words)
    return made


def do(monitor: Monitor, *lines: str) -> None:
    for line in lines:
        commands.do(monitor, line)


DIALOGUE = r"""
load dialogue.pal
go 200 until "PROCEED."
type SET X = 3
expect "X = 3" 5
expect BEL 5
assert pc 223
cont 0.01
type TYPE X
expect "DONE"
wait 1
assert 200 7300
"""


def test_a_dialogue_is_a_test(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "dialogue.pal").write_text(SOURCE.read_text())
    (tmp_path / "script").write_text(DIALOGUE)
    done = shell("pdp8 monitor script")
    assert done.returncode == 0, done.stderr
    assert done.stderr == b""


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ('expect "READY" 5', "'READY' was not printed: idle; the page shows 'PROCEED.'"),
        ("expect BEL 5", "BEL was not printed: idle; the page shows 'PROCEED.'"),
        ("assert pc 0", "PC is 02"),
        ("assert 200 1", "200 is 7300, not 0001"),
        ('until "04" 2 times 5', "'04' was printed no times of 2: idle; the page shows ''"),
    ],
)
def test_what_fails_ends_a_script_with_status_1(
    shell: Shell, tmp_path: Path, line: str, message: str
) -> None:
    (tmp_path / "dialogue.pal").write_text(SOURCE.read_text())
    (tmp_path / "script").write_text(f"load dialogue.pal\ngo 200 1\n{line}\npage\n")
    done = shell("pdp8 monitor script")
    assert done.returncode == 1
    assert done.stderr.decode().startswith(f"pdp8 monitor: script, line 3: {message}")


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


def test_a_key_press_takes_its_time(monitor: Monitor) -> None:
    monitor.machine.load({0o200: 0o7402, 0o201: 0o7402})
    do(monitor, "go 200")
    before = monitor.machine.ticks
    do(monitor, "cont")
    assert monitor.machine.ticks - before == 2_000_000 + 32
    do(monitor, "set hands 0.5", "key cont")
    assert monitor.machine.ticks - before == 2_000_000 + 32 + 10_000_000


def test_every_key_of_the_panel(monitor: Monitor, said: list[str]) -> None:
    do(monitor, "set sr 200", "key load_add", "set sr 5200", "key dep", "assert 200 5200", "assert pc 201")
    do(monitor, "key exam", "assert pc 202", "set pc 200", "key start", "key stop cont", "wait 0.1", "run 0")
    assert monitor.machine.panel.lamps.run
    assert said[-1].startswith("limit; ")


def test_waiting_takes_its_time_whether_the_program_runs_or_stands(monitor: Monitor) -> None:
    do(monitor, "wait 0.1")
    assert monitor.machine.ticks == 2_000_000
    do(monitor, "deposit 200 2210 5200 5200", "go 200 0")
    other = Monitor(lambda line: None, state.restore(state.save(monitor.machine)))
    do(monitor, "wait 0.1")
    do(other, "run 0.1")
    assert monitor.machine.ticks == other.machine.ticks


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


def test_a_tape_put_in_at_a_standstill_loses_no_frame(monitor: Monitor, tmp_path: Path) -> None:
    (tmp_path / "a").write_bytes(b"\x81\x82")
    (tmp_path / "b c").write_bytes(b"\x83")
    echo = {0o200: 0o6031, 0o201: 0o5200, 0o202: 0o6036, 0o203: 0o3410, 0o204: 0o5200}
    monitor.machine.load(echo)
    monitor.machine.core[0o10] = 0o277
    do(monitor, f'reader "{tmp_path}/a" "{tmp_path}/b c"', "wait 1", "go 200")
    assert [monitor.machine.core[0o300 + at] for at in range(4)] == [0o201, 0o202, 0o203, 0]


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


def test_an_address_is_a_symbol_by_its_first_six_letters_plus_or_minus(
    monitor: Monitor, said: list[str]
) -> None:
    do(monitor, f"load {SOURCE}", "examine SECONDLY SECOND-1 SECOND-1+2 0-1")
    assert [line[:10] for line in said[-4:]] == ["0243  0254", "0242  0243", "0244  0320", "7777  0000"]


def test_a_wrong_state_is_named(monitor: Monitor) -> None:
    with pytest.raises(WorkError, match=r"^circle\.asc: byte 0: not UTF-8$"):
        do(monitor, "restore circle.asc")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("r", "registers, rim, run, reader, restore?"),
        ("frobnicate", "no such command; help tells which there are"),
        ("continue", "no such command; did you mean cont?"),
        ("exmaine", "no such command; did you mean examine?"),
        ("attach", "no such command; help tells which there are"),
        ("load nothing.pal", "no such file"),
        ("load .", "Is a directory"),
        ("load /dev/null", "empty"),
        ("reader nothing.asc", "no such file"),
        ("punch /nowhere/x", "No such file or directory"),
        ("save /dev/full", "No space left"),
        ("restore eia.pal", "saved state begins with"),
        ("examine", "an address expected"),
        ("rim now", "nothing expected, and no more: now"),
        ("examine 9", "9: neither an octal number nor a symbol"),
        ("examine 10000", "not between 0000 and 7777"),
        ("deposit 200", "an address and words expected"),
        ("set mq 0", "there are ac link pc ma mb ir sr mem_prot sing_step hands\n"),
        ("key kick", "the keys are"),
        ("cont soon", "seconds of machine time"),
        ("cont nan", "not between 0 and 1e9 seconds"),
        ("trace maybe", "on, cycles or off"),
        ("count maybe", "on, off or listing, or nothing"),
        ("count", "nothing is counted: count on begins"),
        ("type É", "É: a Model 33 has no such key"),
        ("type \uf800", "\uf800: a Model 33 has no such key"),
        ("type {", "{: a Model 33 has no such key"),
        ("type A", "the program asks for no key: the machine stands still; no keys of 2 sent"),
        ('keyboard now "É"', "É: a Model 33 has no such key"),
        ('keyboard "A', 'a quote (") has no other to end it'),
        (r'keyboard "\x"', r"\x: the escapes are"),
        (r'keyboard "\400"', r"\4: the escapes are"),
        ("keyboard now", "a text expected"),
        ("set mem_prot yes", "yes: mem_prot is 0 or 1, off or on"),
        ("set ir 77", "77: not between 0 and 7"),
        ("set link 2", "2: not between 0 and 1"),
        ("fast-reader circle.asc", "no high-speed reader and punch are fitted"),
        ("fast-punch x", "no high-speed reader and punch are fitted"),
        ("load eia.pal twice", "twice: after the name nothing but force"),
        ('expect ""', "a text expected"),
        ("until X no times", "no: how many times"),
        ("page all", "nothing, or more, expected"),
        (
            "examine NOPE",
            "NOPE: neither an octal number nor a symbol; a tape brings none, `listing SOURCE` does",
        ),
        ("examine 20:17", "20:17: 0017 lies before 0020"),
        ("wait", "seconds expected"),
        ("wait -1", "-1: not between 0 and 1e9 seconds"),
        ("wait 1000000001", "1000000001: not between 0 and 1e9 seconds"),
    ],
)
def test_what_is_wrong_is_an_error_and_changes_nothing(monitor: Monitor, line: str, message: str) -> None:
    with pytest.raises(WorkError) as raised:
        commands.do(monitor, line)
    assert message in f"{raised.value}\n"
    assert monitor.machine.ticks == 0


def test_the_page_shows_marks_and_goes_on(monitor: Monitor, said: list[str]) -> None:
    do(monitor, "go 200 1", "page", "keyboard AB RUBOUT CR", "run 2")
    said.clear()
    do(monitor, "page more")
    assert said == ["AB<RUBOUT>", "DONE<BEL>"]
    said.clear()
    do(monitor, "page")
    assert said == ["PROCEED.AB<RUBOUT>", "DONE<BEL>"]


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
