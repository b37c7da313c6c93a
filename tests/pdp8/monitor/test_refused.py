"""What the monitor refuses leaves machine, session and files as they were: every command, in every way.

refused argument             nothing of the line is done
file that cannot be written  what was to be written is still there
end of input                 a script may end after any line, also without a line feed
signal                       Ctrl-C or SIGTERM ends a script: no file is half done
"""

import os
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.monitor.commands import COMMANDS
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError
from tests import commands
from tests.pdp8.monitor import do, session

REEL = bytes(380_292)
REFUSED = {
    "examine": "|9|200 9|20:17|CHK-CHK|NOPE|7777/2|200/10001|200/0",
    "deposit": "|200|200 7402 9|200 1 10000|203-200 1|200-203 1 2|7777 1 2|2 -1|-m 300|-m 2 *3;4|2 -A|cpu 2",
    "set": "|ac|ac 10000|ir 10|mq 0|mem_prot maybe|cpu 5k|inst_field 1|hands soon|ac 1 2|hands -1|dt0 locked",
    "registers": "now",
    "load": "|nowhere.pal|wrong.pal|cut.bin|eia.pal twice|.|in.asc",
    "boot": "|nowhere.pal|wrong.pal|eia.pal twice|dt0|dt8|ptr soon",
    "listing": "|nowhere.pal|in.asc|eia.pal more",
    "rim": "now",
    "key": "|kick|stop kick|load_add dep kick",
    "go": "NOPE|200 soon|200 -1|until|200-203|200 1 2|200 until X 0 times",
    "cont": "soon|-1|until|until X 1 2 3",
    "run": "soon|nan|1e10|until",
    "until": '|X soon|X 0 times|X -1|""',
    "expect": '|X soon|X 1 2|"X|""',
    "assert": "|ac|ac 10000|NOPE 0|ac 1 2",
    "wait": "|soon|-1|1 2",
    "step": "9|-1|10000|1 2",
    "cycle": "9|-1|10000|1 2",
    "back": "soon|1 fortnights|until|until NOPE|until 200 twice|777777 cycles|until 77 flag",
    "break": "9|200 9|20:17|NOPE",
    "watch": "9|200 9|20:17|NOPE",
    "forget": "9|200 9|20:17|NOPE",
    "trace": "|maybe|on off",
    "count": "maybe||listing|on off",
    "reader": "|nowhere.asc|in.asc nowhere.asc|none in.asc",
    "punch": '|no/out|.|locked/out|kept|in.asc|soft|out more|-|/dev/full|""',
    "fast-reader": "|nowhere.asc|in.asc more",
    "fast-punch": "|no/out|.|locked/out|kept|in.asc|soft|out more|-|/dev/full",
    "type": "\u00e9",
    "keyboard": '|\u00e9|A \u00e9|now A \u00e9|"A',
    "page": "less|more more",
    "save": "|no/out|.|locked/out|kept|in.asc|wrong.pal|-|/dev/full|out more",
    "restore": "|nowhere|in.asc|wrong.pal|cut.state|kept.state more",
    "attach": (
        "ptr|rk0 x|ptr missing|ptp missing/x|lpt missing/x|lpt in.asc|dt0|dt8 reel.tu56|dt0 nowhere|"
        "dt0 in.asc|-r dt0|dt0 big.tu56"
    ),
    "detach": "|ptp|rk0|dt0|dt9|dt0 out.tu56|dt0 forget|all out.tu56",
    "send": "|{",
    "do": "|missing|fails|leaps",
    "goto": "|NOWHERE",
    "if": "|exist|AC == 0 quit|exist in.asc go soon",
    "echo": "",
    "reset": "",
    "show": "",
    "on": "",
    "help": "nothing|load nothing",
    "quit": "now",
    "exit": "now",
}
"""For each command what is refused, between bars."""

NEAREST = {
    "examine": ("7777", "0-7777", "7777/1", "0/10000"),
    "deposit": ("7777 1", "7776 1 2", "0 7777", "200-200 1"),
    "set": ("ac 7777", "ir 7", "mem_prot 1", "hands 0"),
    "go": ("200 0",),
    "cont": ("0",),
    "assert": ("sr 7070",),
    "wait": ("0",),
    "step": ("1", "7"),
    "cycle": ("1", "7"),
    "back": ("1 cycles",),
    "break": ("0", "7777"),
    "watch": ("0", "7777"),
}
"""The values beside those refused that are accepted."""

WORKS = {
    "punch": ("out", "on", "off"),
    "fast-punch": ("fast", "on"),
    "save": ("saved",),
    "restore": ("kept.state",),
    "reader": ("in.asc in.asc", "none", "stop"),
    "key": ("stop",),
    "go": ("200 0.05",),
    "back": ("",),
    "set": ("ac 7",),
    "deposit": ("200-203 7402",),
    "examine": ("200-203",),
    "forget": ("", "all"),
    "trace": ("on",),
    "count": ("on",),
    "page": ("more",),
    "wait": ("0.1",),
    "load": ("eia.pal",),
}


@pytest.fixture
def monitor(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Monitor]:
    """A session in which everything is there that could be lost."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in.asc").write_bytes(b"\xb1\xb2\x8d\x8a")
    (tmp_path / "wrong.pal").write_text("*200\n\tQQ\n$\n")
    (tmp_path / "cut.bin").write_bytes(shelf.read_bundled("eia.bin")[:200])
    (tmp_path / "cut.state").write_text(state.save(Machine())[:300])
    (tmp_path / "kept.state").write_text(state.save(Machine()))
    (tmp_path / "kept").write_bytes(b"kept")
    (tmp_path / "fails").write_text("echo\ndo missing\n")
    (tmp_path / "leaps").write_text("goto NOWHERE\n")
    (tmp_path / "reel.tu56").write_bytes(REEL)
    (tmp_path / "big.tu56").write_bytes(b"\xff" * len(REEL))
    (tmp_path / "kept").chmod(0o444)
    (tmp_path / "soft").symlink_to("in.asc")
    (tmp_path / "locked").mkdir(mode=0o555)
    made = Monitor(lambda _: None, Machine(one_of_each()))
    with shelf.watched():
        do(
            made,
            "load eia.pal",
            "reader in.asc in.asc",
            "break CHK",
            "watch HOLD",
            "set sr 7070",
            "go 200 0.5",
        )
        do(made, "go 200 0.7", "page", "set hands 0.2", "fast-reader in.asc", "keyboard now A", "trace on")
        made.machine.teletype.punch.frames += b"abc"
        made.machine.highspeed.punch.frames += b"fast"
        yield made


def files() -> dict[str, bytes]:
    return {str(path): path.read_bytes() for path in Path().rglob("*") if path.is_file()}


@pytest.mark.parametrize(
    "line", [f"{name} {words}" for table in (NEAREST, WORKS) for name in table for words in table[name]]
)
def test_the_nearest_value_is_accepted_and_what_a_line_does_is_undone(monitor: Monitor, line: str) -> None:
    do(monitor, "forget", "trace off", "step 2")
    history, before, number = monitor.history, state.save(monitor.machine), monitor.machine.instructions
    do(monitor, line)
    if monitor.history is history:  # `restore` begins another
        do(monitor, "step 1")
        do(monitor, f"back {monitor.machine.instructions - number + 1:o}", "step 1")
        assert state.save(monitor.machine) == before


def test_every_command_has_its_refusals() -> None:
    assert list(REFUSED) == list(COMMANDS)


@pytest.mark.parametrize("stands", [False, True])
@pytest.mark.parametrize("name", REFUSED)
def test_what_is_refused_changes_nothing(name: str, stands: bool, monitor: Monitor) -> None:
    if stands:
        do(monitor, "key stop")
    before = session(monitor), files()
    for arguments in REFUSED[name].split("|") if REFUSED[name] else ():
        line = f"{name} {arguments}"
        with pytest.raises(WorkError):
            do(monitor, line)
        assert (session(monitor), files()) == before, line


def test_a_tape_that_is_missing_when_its_turn_comes_is_still_awaited(monitor: Monitor) -> None:
    monitor.machine.watch.breakpoints.clear()
    monitor.machine.watch.writes.clear()
    do(monitor, "trace off", "reader in.asc in.asc")
    os.unlink("in.asc")
    with pytest.raises(WorkError, match=r"in\.asc: no such file"):
        do(monitor, "go 200 10")
    assert monitor.waiting_tapes == ["in.asc"]


@pytest.mark.slow("a script a line")
def test_a_script_may_end_after_any_line_whole_or_not(tmp_path: Path, monitor: Monitor) -> None:
    for name, lines in WORKS.items():
        for arguments in lines:
            script = f"load hello.pal\ngo 200\n{name} {arguments}"
            for path in ("out", "fast", "saved"):
                (tmp_path / path).unlink(missing_ok=True)
            ran = commands.run("pdp8", "monitor", "--highspeed", folder=tmp_path, stdin=script.encode())
            assert (ran.returncode, ran.stderr) == (0, b""), script
            assert not list(tmp_path.glob("*.part"))


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("line", ["go 200", "until NEVER 1e6", "wait 1e6", "expect NEVER 1e6"])
def test_a_signal_ends_a_script_and_leaves_the_files_that_were_whole(
    line: str, number: signal.Signals, tmp_path: Path
) -> None:
    (tmp_path / "out").write_bytes(b"before")
    (tmp_path / "loop.pal").write_text("*200\n\tISZ 10\n\tJMP 200\n\tJMP 200\n$\n")
    script = f"load loop.pal\nsave saved\ngo 200 0.01\n{line}\npunch out\nsave saved\n"
    run = commands.start("pdp8", "monitor", "-", "--echo", folder=tmp_path, stdin=-1, stdout=-1, stderr=-1)
    assert run.stdin is not None
    assert run.stdout is not None
    run.stdin.write(script.encode())
    run.stdin.close()
    for shown in run.stdout:
        if shown == f"* {line}\n".encode():
            break
    run.send_signal(number)
    assert run.wait(30) in (130, 143)
    assert (tmp_path / "out").read_bytes() == b"before"
    state.restore((tmp_path / "saved").read_text())
    assert sorted(path.name for path in tmp_path.iterdir()) == ["loop.pal", "out", "saved"]
