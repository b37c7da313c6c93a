"""A tape of our own: its first block boots and types OK, each other block says its number in every word."""

from array import array
from pathlib import Path

from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from tapes.dectape import BLOCKS, WORDS, Image

_BOOT = {
    **{0o7616: 0o6771, 0o7617: 0o5216},  # DTSF, JMP .-1, where the bootstrap waits
    **{0o7620: 0o7200, 0o7621: 0o6762},  # CLA, DTCA
    **{0o7622: 0o1240, 0o7623: 0o6046, 0o7624: 0o6041, 0o7625: 0o5224},  # O: TAD, TLS, TSF, JMP .-1
    **{0o7626: 0o7200, 0o7627: 0o1241, 0o7630: 0o6046, 0o7631: 0o6041, 0o7632: 0o5231, 0o7633: 0o7402},
    **{0o7640: 0o317, 0o7641: 0o313},
    **{0o7754: 0o7754, 0o7755: 0o7755},  # WC and CA as they are when these words come
}


def reel() -> Image:
    """Return the tape."""
    words = array("H", [block for block in range(BLOCKS) for _ in range(WORDS)])
    for word in range(WORDS):
        words[word] = _BOOT.get(0o7600 + word, 0)
    return Image(words)


def file(path: Path) -> Path:
    """Write the tape into a file."""
    path.write_bytes(reel().content())
    return path


def machine(memory: int = 0o10000) -> tuple[Machine, TC08]:
    """Return a machine with the tape on drive 0."""
    control = TC08()
    made = Machine([Teletype(), control], memory)
    control.drives[0].mount(reel())
    return made, control
