"""Files of PS/8 and OS/8 as OS/8's own PIP types them and its DIR lists them.

    PDP8_OS8=FOLDER pytest tests/pdp8/computer/dectape/test_files.py

FOLDER has os8.tu56, as docs/rack.md fetches it, and any other images *.tu56, whose texts are typed. The
handler of the Teletype types RUBOUT after a tab, and begins a new line after 72 columns: lines are not
compared.
"""

import os
import re
from pathlib import Path
from random import Random

import pytest

from pdp8.computer.dectape.tc08 import TC08
from tapes import os8
from tapes.dectape import Image, decode
from tests.pdp8.computer.dectape.test_systems import Ours

FOLDER = Path(os.environ.get("PDP8_OS8", ""))
SYSTEM = FOLDER / "os8.tu56"
IMAGES = sorted(FOLDER.glob("*.tu56")) if "PDP8_OS8" in os.environ else []
TEXTS = {"PA", "FT", "RA", "BA", "BI", "HL", "TX", "MA", "SB", "TE"}
"""Extensions of texts."""
INSERTS = 200
pytestmark = [
    pytest.mark.slow("minutes for each image"),
    pytest.mark.skipif(not SYSTEM.exists(), reason="PDP8_OS8=FOLDER names the folder with os8.tu56"),
]


class Operator:
    """OS/8 with a tape on drive 1."""

    def __init__(self, image: Image) -> None:
        self.system = Ours(SYSTEM, 0o100000)
        control = self.system.machine.devices[-1]
        assert isinstance(control, TC08)
        control.drives[1].mount(image)
        self.system.until(".")

    def typed(self, command: str, ending: str) -> str:
        """Return what is typed after the command until nothing comes for longer than a tape is wound."""
        system, frames = self.system, self.system.machine.teletype.printer.frames
        system.press(f"{command}\r")
        system.until("\n")
        begins, quiet = len(frames), 0
        while quiet < 150 and not (quiet > 20 and frames[-1] & 0o177 == ord(ending)):
            before = len(frames)
            system.machine.run(1)
            quiet = 0 if len(frames) > before else quiet + 1
        system.seen = len(frames)
        return bytes(frame & 0o177 for frame in frames[begins:-1]).decode()

    def piped(self, name: str) -> str:
        """Return what PIP types of a file, without ends of line and of page."""
        self.system.press("R PIP\r")
        self.system.until("*")
        typed = self.typed(f"TTY:<DTA1:{name}", "*")
        self.system.press("\x03")
        self.system.until("\n.")
        return _shown(typed)


def _shown(text: str) -> str:
    """Return what is typed of a text, without ends of line and of page."""
    controls = re.sub(
        "[\x01-\x08\x0e-\x1a\x1c-\x1f]", lambda control: f"^{chr(ord(control[0]) + 0o100)}", text
    )
    return re.sub("[\0\r\n\f\x7f]", "", controls).replace("\x1b", "$")


@pytest.mark.parametrize("file", IMAGES, ids=lambda file: file.stem)
def test_a_text_is_what_pip_types(file: Path) -> None:
    """PIP and `tape extract` read the same characters."""
    image = decode(file.read_bytes())[0]
    operator = Operator(image)
    for name in [each.name for each in os8.directory(image) if each.name]:
        if name.rpartition(".")[2] in TEXTS:
            assert operator.piped(name) == _shown(os8.text(os8.words(image, name))), name


def test_what_is_inserted_is_listed_by_dir_and_typed_by_pip() -> None:
    """Two hundred files in all segments of the directory; DIR has each with its length, PIP its text."""
    image = decode(SYSTEM.read_bytes())[0]
    random = Random(1)
    for number in range(INSERTS):
        name = f"T{number}.{random.choice(['PA', 'DA', 'LS', 'Z9', ''])}".rstrip(".")
        image = os8.insert(image, name, os8.from_text("NEVER A LINE\n" * random.randrange(1, 40)))
    operator = Operator(image)
    listed = operator.typed("DIR DTA1:", ".")
    files = [each for each in os8.directory(image) if each.name]
    found = re.findall(r"^(\w+) *\.(\w*) *(\d+)", listed, re.MULTILINE)
    assert found == [(*f"{each.name}.".split(".")[:2], str(each.length)) for each in files]
    free = sum(each.length for each in os8.directory(image) if not each.name)
    assert re.search(rf"^ *{free} FREE BLOCKS", listed, re.MULTILINE)
    for each in random.sample(files[-INSERTS:], 12):
        assert operator.piped(each.name) == _shown(os8.text(os8.words(image, each.name)))
