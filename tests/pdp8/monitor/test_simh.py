"""SIMH's words: every line of the table in docs/simh.md, and what it says stands for it."""

import os
import re
import sys
from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.computer.hardware.highspeed import HighSpeed
from pdp8.computer.machine import Machine
from pdp8.monitor import rack
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.prompt import Monitor
from tapes import binary, dectape, rim
from tests.pdp8.monitor import do, session

TABLE = (Path(__file__).parents[3] / "docs" / "simh.md").read_text("utf-8").partition("|---")[2]
ROWS = [row.split("|")[1:3] for row in TABLE.partition("\n\n")[0].splitlines()[1:]]
ECHO = "*200\n\tCLA\n\tTLS\n\tTAD X\nL,\tKSF\n\tJMP L\n\tKRB\n\tTLS\n\tTSF\n\tJMP .-1\n\tJMP L\nX,\t324\n$\n"


def codes(cell: str) -> list[str]:
    return re.findall("`(.*?)`", cell)


@pytest.fixture(autouse=True)
def files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "program.bin").write_bytes(binary.encode({0o200: 0o7001, 0o201: 0o7402}))
    (tmp_path / "tape").write_bytes(b"ABC")
    (tmp_path / "script").write_text("echo one\ndeposit 300 1\n")
    (tmp_path / "bin.rim").write_bytes(rim.encode(shelf.bundled_program("bin.pal").words))
    (tmp_path / "ps8.tu56").write_bytes((0o7402).to_bytes(2, "little") * dectape.BLOCKS * dectape.WORDS)
    (tmp_path / "discs").write_bytes((0o7402).to_bytes(2, "little") * 0o100000)
    (tmp_path / "echo.pal").write_text(ECHO)


def played(lines: list[str]) -> tuple[list[object], dict[str, object], list[str]]:
    """Return core, registers and page that lines lead to, the session, and what is said but for the times."""
    said: list[str] = []
    monitor = Monitor(said.append)
    first = lines[0].split()[0]
    echoes = first in ("send", "type", "expect")
    for line in (
        ["load echo.pal", "go 200 1"]
        if echoes
        else ["load eia.pal", "reader circle.asc circle.asc", "go 200 2"]
    ):
        do(monitor, line)
    if first == "expect":
        do(monitor, 'keyboard now "text"')
    if first in ("c", "cont", "continue", "run", "send"):
        do(monitor, "key stop")
    said.clear()
    for line in lines:
        runs = line.split()[0] in ("go", "g", "run", "cont", "continue", "c", "boot")
        do(monitor, line + " 1" * runs)
    machine = monitor.machine
    if first in ("send", "type"):
        do(monitor, "cont 2")
        said.clear()
    frames = bytes(machine.teletype.printer.frames)
    state = [*machine.core, machine.ac, machine.sr, *([] if echoes else [machine.pc]), frames]
    own = ("machine", "history", "listing", "say", "echo", "expected")  # of one run only
    kept = {name: each for name, each in session(monitor).items() if name not in own}
    return state, kept, [line.partition(";")[0] for line in said]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0].strip())
def test_a_line_of_the_table(row: list[str]) -> None:
    """What is on the left does what is on the right; where there are as many, each does its own."""
    left, right = map(codes, row)
    pairs = [([one], [other]) for one, other in zip(left, right, strict=len(left) == len(right))]
    if len(left) != len(right):
        pairs = [([each], right) for each in left]
    if left[0].startswith("attach"):
        pairs = [(left, right)]
    for typed, meant in pairs:
        state = played(typed)
        Path("punched").unlink(missing_ok=True)
        if meant and typed != ["e all"]:
            assert played(meant) == state


def test_core_becomes_a_tape() -> None:
    said: list[str] = []
    monitor = Monitor(said.append)
    for line in ("load eia.pal", "punch 0-7577 core.bin", "deposit 200 0", "load core.bin"):
        do(monitor, line)
    assert said[1] == "wrote core.bin: 3,968 words in BIN format"
    words = shelf.program("eia.pal").words
    assert {at: monitor.machine.core[at] for at in words} == words


def test_a_throttle_is_set_and_taken_off_again() -> None:
    monitor = Monitor(lambda line: None)
    for word in ("throttle 1M", "nothrottle", "throttle 100/1", "nothrottle"):
        do(monitor, f"set {word}")
        assert monitor.realtime == word.startswith("throttle")


def test_a_script_asks_for_files_and_ends_with_quit() -> None:
    """By names in quotes too, of any bytes; after it nothing is done, nor in the script that called it."""
    said: list[str] = []
    name = os.fsdecode(b"a f\xefle") if sys.platform == "linux" else "a file"
    Path(name).write_text("")
    inner = f'if exist "{name}" echo 1\nif not exist "{name}" echo no\nquit\necho no\n'
    Path("inner").write_bytes(os.fsencode(inner))
    outer = 'if exist "none" echo no\nif not exist "none" echo 0\nif exist inner do inner\necho no\n'
    Path("outer").write_text(outer)
    monitor = Monitor(said.append)
    do(monitor, "do outer")
    assert ([line for line in said if len(line) < 3], monitor.finished) == (["0", "1"], True)


def test_a_script_of_simh() -> None:
    """Devices by name, switches, jumps, conditions; RUN is START; what a PDP-8/L has not ends it."""
    said: list[str] = []
    lines = """\
        set cpu 32k|set df dis|set dt dis|set rk dis|deposit int-throttle -m THROT_DELAY 3|set -q tti ksr
        dep -qm 200 CLA CMA|d -m 201 HLT|d cpu pc 0|if exist program.bin goto there|echo no|:there
        if not exist none run 200|e -om cpu ac|attach rx0 os8.dsk"""
    Path("boot.ini").write_text("\n".join(each.strip() for each in re.split(r"[|\n]", lines)))
    with pytest.raises(MonitorError, match=r"boot\.ini, line 15: rx0: an RX8E floppy, which no PDP-8/L had"):
        do(Monitor(said.append), "do boot.ini")
    assert said[0] == "no PDP-8/L had 32K, nor three bits of field"
    assert said[-2:] == ["halt; 0.000003 s; next 0202  0000          AND 0000", "AC 7777"]
    assert "no" not in said


def test_a_disk_and_a_printer_are_fitted_as_they_are_attached() -> None:
    said: list[str] = []
    before = Path("discs").read_bytes()
    monitor = Monitor(said.append)
    do(
        monitor,
        "attach df0 discs",
        "attach lpt text",
        "d 200 1300 6664 1301 6605 6622 5204 7402",
        "d 300 0301 0007",
    )
    do(monitor, "d 7750 7777 0277", "go 200", "wait 1", "show", "detach lpt")
    assert said[-2:] == ["df   discs, 1 word written", "wrote text"]
    do(monitor, "attach lpt more", "detach lpt")
    assert (Path("text").read_text(), Path("more").read_text()) == ("A", "")
    with pytest.raises(MonitorError, match="df: 1 word of discs changed; detach df FILE saves them"):
        do(monitor, "detach df")
    rack.leave(monitor)
    assert said[-1] == "df: 1 word of discs changed, and not saved: wrote discs-changed"
    assert Path("discs-changed").read_bytes()[0o310 * 2 :][:2] == b"\xc1\0"
    do(monitor, "detach df after")
    assert Path("after").read_bytes() == Path("discs-changed").read_bytes()
    assert Path("discs").read_bytes() == before


def test_each_punch_is_written_to_the_file_that_was_attached_for_it() -> None:
    said: list[str] = []
    monitor = Monitor(said.append, Machine())
    monitor.machine.fit(HighSpeed())
    do(
        monitor,
        "attach tto slow",
        "attach ptp fast",
        "deposit 210 301 302",
        "deposit 200 7200 1210 6046 6026 7402",
        "go 200",
        "wait 1",
    )
    do(monitor, "attach ptp faster", "deposit 201 1211 6026 7402", "go 200", "wait 1")
    do(monitor, "detach tto", "detach ptp")
    do(monitor, "attach tto slow", "attach ptp new", "attach lpt faster", "quit")
    assert said[-3:] == [
        "slow stays as it is: nothing was punched",
        "wrote new: no frames",
        "faster stays as it is: nothing was printed",
    ]
    names = ("slow", "fast", "faster", "new")
    assert [Path(name).read_bytes() for name in names] == [b"\xc1", b"\xc1", b"\xc2", b""]
