"""PS/8 and OS/8 V3D at work, beside SIMH: what they type is the same to the character.

The images are DEC's and not here: PDP8_OS8=FOLDER names a folder with those that docs/rack.md fetches.
"""

import os
import pty
import re
import select
import shutil
import time
from pathlib import Path

import pytest

from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.hardware.extension import MEMORY
from pdp8.computer.hardware.teletype import Teletype, printed
from pdp8.computer.machine import Machine
from pdp8.computer.use.bootstrap import boot
from pdp8.monitor.commands import do
from pdp8.monitor.prompt import Monitor
from tapes import os8
from tapes.dectape import decode
from tests.pdp8.computer.hardware.test_simh import SIMH

DOCS = Path(__file__).parents[4] / "docs"
ROW = re.compile(r"^(\w.{5})\.(\w\w) +(\d+)", re.M)
"""A line of DIR."""
IMAGES = Path(os.environ.get("PDP8_OS8", ""))
SOURCE = "*200|CLA CLL|TAD L|TLS|TSF|JMP .-1|CLA|TAD M|TLS|TSF|JMP .-1|JMP I K|L, 310|M, 311|K, 7600|$|"
PIP_ENDS, LEAVES = "\x1a", "\x03"
SESSION = [
    ("R PIP\r", "*"),
    ("TEST.PA<TTY:\r", "\r\n"),
    *((f"{line}\r", "\n") for line in SOURCE.split("|")[:-1]),
    (PIP_ENDS, "*"),
    ("TTY:<TEST.PA\r", "$\r\n*"),
    (LEAVES, "."),
    ("R PAL8\r", "*"),
    ("TEST.BN<TEST.PA\r", "."),
    ("R ABSLDR\r", "*"),
    ("TEST.BN/G\x1b", "HI\r\n."),
]
"""What is typed, and what the system then ends with; the program that is assembled types HI."""


class System:
    """One that is typed at; `more` is what it types next, `send` presses a key."""

    def __init__(self) -> None:
        self.page = ""

    def more(self) -> str:
        raise NotImplementedError

    def send(self, key: str) -> None:
        raise NotImplementedError

    def until(self, ending: str) -> str:
        """Return what it types until that ends so."""
        while not self.page.endswith(ending):
            more = self.more()
            assert more, f"{ending!r} does not come: {self.page!r}"
            self.page += more.replace("\0", "")
        page, self.page = self.page, ""
        return page

    def press(self, keys: str) -> None:
        """Press each key once the one before was echoed."""
        page = ""
        for key in keys[:-1]:
            self.send(key)
            page += self.until(key)
        self.send(keys[-1])
        self.page = page


class Ours(System):
    """The system on our machine."""

    def __init__(self, image: Path, memory: int) -> None:
        super().__init__()
        control = TC08()
        control.drives[0].mount(decode(image.read_bytes())[0])
        self.machine = Machine([Teletype(), control], memory=memory)
        self.seen = 0
        boot(self.machine)

    def more(self) -> str:
        printed = self.machine.teletype.printer.frames
        for _ in range(3000):
            self.machine.run(0.1)
            if len(printed) > self.seen:
                break
        new, self.seen = printed[self.seen :], len(printed)
        return bytes(frame & 0o177 for frame in new).decode()

    def send(self, key: str) -> None:
        self.machine.run(0.3)  # what comes as a line feed is typed is lost
        self.machine.teletype.keyboard.press(bytes([ord(key) | 0o200]))


class Theirs(System):
    """The system on SIMH's PDP-8."""

    def __init__(self, image: Path, size: str) -> None:
        super().__init__()
        self.process, self.terminal = pty.fork()
        if not self.process:
            os.execv(SIMH, [SIMH])
        for line in (
            f"set cpu {size}",
            "set rk disabled",
            "set tto 7b",
            "set dt enabled",
            f"attach dt0 {image}",
            "boot dt0",
        ):
            self.until("sim> ")
            os.write(self.terminal, f"{line}\n".encode())

    def more(self) -> str:
        if not select.select([self.terminal], [], [], 60)[0]:
            return ""
        return bytes(frame & 0o177 for frame in os.read(self.terminal, 4096)).decode()

    def send(self, key: str) -> None:
        time.sleep(0.02)
        os.write(self.terminal, key.encode())

    def close(self) -> None:
        os.close(self.terminal)
        os.waitpid(self.process, 0)


@pytest.mark.slow("two systems at ten characters a second, and their tape")
@pytest.mark.parametrize(("name", "size"), [("ps8.tu56", "8k"), ("os8.tu56", "32k")])
@pytest.mark.skipif(not SIMH, reason="SIMH's pdp8 is not installed")
def test_a_session_is_typed_as_simh_types_it(name: str, size: str, tmp_path: Path) -> None:
    image = IMAGES / name
    if not (os.environ.get("PDP8_OS8") and image.exists()):
        pytest.skip("PDP8_OS8=FOLDER names the images")
    theirs = Theirs(Path(shutil.copy(image, tmp_path / "reel.tu56")), size)
    session = [*SESSION, ("DIR\r", "BLOCKS\r\n\f\r\n.")] if name == "os8.tu56" else SESSION
    expected = [theirs.until(".").removeprefix("boot dt0\r\n")]
    for keys, ending in session:
        theirs.press(keys)
        expected.append(theirs.until(ending))
    theirs.close()
    ours = Ours(image, MEMORY[size])
    assert ours.until(".") == expected[0]
    for (keys, ending), page in zip(session, expected[1:], strict=True):
        ours.press(keys)
        assert ours.until(ending) == page


@pytest.mark.slow("OS/8 builds a system on a disk: minutes of 1971")
@pytest.mark.skipif(not (IMAGES / "os8-2.tu56").exists(), reason="PDP8_OS8=FOLDER has no os8-2.tu56")
def test_os8_builds_itself_on_a_df32_as_the_sheet_has_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """By the script of docs/rack.md; the disk boots in half a second, and lists and types what was copied."""
    script = (DOCS / "rack.md").read_text("utf-8").partition("where `df32.txt` is")[2].split("```")[1]
    for name in ("os8.tu56", "os8-2.tu56"):
        shutil.copy(IMAGES / name, tmp_path)
    (tmp_path / "blank.df32").write_bytes(bytes(4 * 65_536))
    monkeypatch.chdir(tmp_path)
    builder = Monitor(lambda said: None)
    for line in script.splitlines()[1:]:
        do(builder, line)
    assert 60 < builder.machine.elapsed < 600
    monitor = Monitor(lambda said: None)
    for line in (
        *("set cpu 8k", "attach df os8.df32", "boot df", "type R PIP", 'expect "*"'),
        *(
            "type NEW.SV<PAL8.SV/I",
            'expect "*"',
            r'keyboard "\003"',
            "expect .",
            "type DIR",
            'expect "BLOCKS"',
        ),
    ):
        do(monitor, line)
        if line == "boot df":
            assert monitor.machine.elapsed < 1
    page = printed(bytes(monitor.machine.teletype.printer.frames)).decode()
    of_tape = os8.directory(decode((tmp_path / "os8.tu56").read_bytes())[0])
    files = {each.name: each.length for each in of_tape if each.name}
    files["NEW.SV"] = files["PAL8.SV"]
    assert {f"{name.strip()}.{kind}": int(length) for name, kind, length in ROW.findall(page)} == files
    assert f"{452 - sum(files.values())} FREE BLOCKS" in page
