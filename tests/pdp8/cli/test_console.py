"""The monitor with the Teletype attached, at a terminal, to the character."""

import re
import time

import pytest

from tests.commands import Terminal

pytestmark = [
    pytest.mark.slow("a person at a terminal, who looks before typing"),
    pytest.mark.rare("timed by the wall"),
]
_STYLE = re.compile(rb"\x1b\[[0-9;?]*[A-Za-z]|\x1b[=>]")


@pytest.mark.parametrize("escape", [b"\x1d", b"\x05"], ids=["Ctrl-]", "Ctrl-E"])
def test_into_the_program_out_and_in_again(escape: bytes) -> None:
    terminal = Terminal("pdp8", "monitor")
    terminal.until(b"pdp8>")
    terminal.type(b"load echo.pal\r")
    terminal.until(b" words")
    terminal.until(b"pdp8>")
    terminal.type(b"go 200\r")
    for keys in (b"HELLO", b"AGAIN"):
        time.sleep(2)
        terminal.type(keys)
        assert terminal.until(keys).endswith(keys)
        terminal.type(escape)
        said = _STYLE.sub(b"", terminal.until(b"pdp8>"))
        assert re.search(rb"^stop key; [\d.,]+ s; next 02", said, re.MULTILINE)
        terminal.type(b"cont\r")
    time.sleep(2)
    terminal.type(escape)
    terminal.until(b"pdp8>")
    terminal.type(b"quit\r")
    assert terminal.ended() == 0
