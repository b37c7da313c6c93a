"""SIMH's words: every line of the table in docs/simh.md, and what it says stands for it."""

import re
from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.prompt import Monitor
from tapes import binary, dectape, rim
from tests.pdp8.monitor import do

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
    (tmp_path / "echo.pal").write_text(ECHO)


def played(lines: list[str]) -> tuple[list[int], bytes, list[str]]:
    """Return core and registers that lines lead to, the page, and what is said but for the times."""
    said: list[str] = []
    monitor = Monitor(said.append)
    first = lines[0].split()[0]
    echoes = first in ("send", "type", "expect")
    for line in (
        ["load echo.pal", "go 200 1"] if echoes else ["load eia.pal", "reader circle.asc", "go 200 2"]
    ):
        do(monitor, line)
    if first == "expect":
        do(monitor, 'keyboard now "text"')
    if first in ("c", "cont", "continue", "send"):
        do(monitor, "key stop")
    said.clear()
    for line in lines:
        runs = line.split()[0] in ("go", "g", "cont", "continue", "c", "boot")
        do(monitor, line + " 1" * runs)
    machine = monitor.machine
    if first in ("send", "type"):
        do(monitor, "cont 2")
        said.clear()
    state = [*machine.core, machine.ac, machine.sr, *([] if echoes else [machine.pc])]
    return state, bytes(machine.teletype.printer.frames), [line.partition(";")[0] for line in said]


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


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("e MQ", "no EAE"),
        ("e if", "4K of core"),
        ("set rf enabled", "an RF08 disk"),
        ("attach rk0 os8.rk05", "an RK8 disk"),
        ("dump core.bin", "punch 0-7577"),
        ("run 200", "go A starts it"),
        ("if not exist x goto y", "no conditions"),
    ],
)
def test_what_is_not_here_says_what_is(line: str, said: str) -> None:
    with pytest.raises(MonitorError, match=re.escape(said)):
        do(Monitor(print), line)


def test_core_becomes_a_tape() -> None:
    said: list[str] = []
    monitor = Monitor(said.append)
    for line in ("load eia.pal", "punch 0-7577 core.bin", "deposit 200 0", "load core.bin"):
        do(monitor, line)
    assert said[1] == "wrote core.bin: 3,968 words in BIN format"
    words = shelf.program("eia.pal").words
    assert {at: monitor.machine.core[at] for at in words} == words
