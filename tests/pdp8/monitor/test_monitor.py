"""The monitor: a script with its expected answers, every command misused, and nothing that raises."""

import re
from pathlib import Path

import pytest

from pdp8.computer.machine import Machine
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.commands import COMMANDS, do, find
from pdp8.monitor.prompt import Monitor
from tests.conftest import Shell

FOLDER = Path(__file__).parent
LINE = bytes(0o200 | code for code in b" 19\r\n")


@pytest.mark.parametrize("name", ["lesson", "session"])
def test_a_script_and_its_answers(shell: Shell, tmp_path: Path, name: str) -> None:
    (tmp_path / "line.asc").write_bytes(LINE)
    (tmp_path / "script").write_bytes((FOLDER / f"{name}.txt").read_bytes())
    ran = shell("pdp8 monitor script --echo")
    assert ran.stderr == b""
    assert ran.stdout.decode().splitlines() == (FOLDER / f"{name}.expected").read_text().splitlines()
    assert ran.returncode == 0


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


def test_help_names_every_command() -> None:
    said: list[str] = []
    do(Monitor(said.append), "help")
    assert [line.split()[0] for line in said if line[0] != " "] == list(COMMANDS)
    assert max(map(len, said)) < 80
    assert "until TEXT [N times] [SECONDS] Go on until TEXT" in "\n".join(said)
    said.clear()
    do(Monitor(said.append), "HELP Set")
    assert said[0].startswith("set NAME WORD               Set a register, a switch (0 or 1)")


def test_a_limit_that_is_no_round_number_of_ticks_ends() -> None:
    monitor = Monitor(lambda line: None)
    do(monitor, "deposit 200 2210 5200 5200")
    do(monitor, "go 200 0.7")
    for seconds in ("0.1", "0.0773", "1e-9", "0.333333333", "0"):
        do(monitor, f"cont {seconds}")
    assert monitor.machine.elapsed == pytest.approx(0.7 + 0.1 + 0.0773 + 0.333333333, abs=20e-6)


@pytest.mark.parametrize(("value", "position"), [("1", True), ("on", True), ("0", False), ("OFF", False)])
def test_a_switch_is_put_up_and_down(value: str, position: bool) -> None:
    monitor = Monitor(lambda line: None)
    for name in ("mem_prot", "sing_step"):
        setattr(monitor.machine.panel, name, not position)
        do(monitor, f"set {name} {value}")
        assert getattr(monitor.machine.panel, name) is position


def test_under_sing_step_a_key_does_one_cycle() -> None:
    """TAD I 210 takes three: START does FETCH, each CONT another."""
    said: list[str] = []
    monitor = Monitor(said.append)
    do(monitor, "deposit 200 1610 7402")
    do(monitor, "deposit 210 300")
    do(monitor, "deposit 300 1234")
    do(monitor, "set sing_step on")
    panel, lamps = monitor.machine.panel, []
    for command in ("go 200", "cont", "cont", "cont"):
        do(monitor, command)
        now = panel.lamps
        lamps.append((now.fetch, now.defer, now.execute, now.ma, now.mb, now.ac, now.run))
    assert lamps == [
        (1, 0, 0, 0o200, 0o1610, 0, 0),
        (0, 1, 0, 0o210, 0o300, 0, 0),
        (0, 0, 1, 0o300, 0o1234, 0o1234, 0),
        (1, 0, 0, 0o201, 0o7402, 0o1234, 0),
    ]
    assert "stop key" in said[-1]


def test_go_stops_a_program_that_runs() -> None:
    """START does nothing while RUN is lit; after STOP it clears the AC."""
    monitor = Monitor(lambda line: None)
    do(monitor, "deposit 200 7001 5200")
    do(monitor, "deposit 300 5300")
    do(monitor, "go 200 0.01")
    assert monitor.machine.ac
    do(monitor, "go 300 0.01")
    assert (monitor.machine.pc, monitor.machine.ac) == (0o300, 0)
