"""The monitor with the Teletype attached, at a terminal, to the character."""

import os
import re
import time
from pathlib import Path

import pytest

from tests.commands import Terminal

pytestmark = [
    pytest.mark.slow("a person at a terminal, who looks before typing"),
    pytest.mark.rare("timed by the wall"),
]
_STYLE = re.compile(rb"\x1b\[[0-9;?]*[A-Za-z]|\x1b[=>]")


PROMPT = """*200
LINE,	CLA
	TAD ("*
	JMS TYPE
NEXT,	KSF
	JMP .-1
	KRB
	JMS TYPE
	TAD LAST
	TAD (-215
	SZA CLA
	JMP NEXT
	TAD (212
	JMS TYPE
	JMP LINE
TYPE,	0
	TLS
	DCA LAST
	TSF
	JMP .-1
	JMP I TYPE
LAST,	0
$
"""
"""Types an asterisk, and what is typed, line by line."""


def test_what_a_user_of_simh_does_who_reads_help(tmp_path: Path) -> None:
    """Loaded, run, interrupted, looked at, gone back in, saved, restored: to the character. PDP8_FOCAL=FILE
    is DEC's FOCAL-69, which answers too.
    """
    focal = os.environ.get("PDP8_FOCAL", "")
    answers = (b"=    6.0000\n", b"=    4.0000\n") if focal else (b"", b"")
    name = os.path.abspath(focal) if focal else "prompt.pal"
    (tmp_path / "prompt.pal").write_text(PROMPT)
    terminal = Terminal("pdp8", "monitor", folder=tmp_path)

    def command(line: bytes, until: bytes = b"pdp8> ") -> bytes:
        terminal.type(line + b"\r")
        seen = _STYLE.sub(b"", terminal.until(b"\n")).partition(b"\n")[2]
        seen += b"" if until in seen else _STYLE.sub(b"", terminal.until(until))
        seen = seen.replace(b"\r", b"").removesuffix(until)
        return seen.rpartition(line + b"\n")[2]  # a prompt may be drawn again

    def back(line: bytes) -> None:
        terminal.type(line + b"\r")
        terminal.until(b"\n")
        time.sleep(0.5)  # a person looks before typing

    def typed(line: bytes) -> bytes:
        page = b""
        for key in line:
            terminal.type(bytes([key]))
            page += terminal.until(b"*" if key == 13 else bytes([key]))
        page = _STYLE.sub(b"", page).replace(b"\r", b"")
        return page[page.index(line[:-1]) :]

    terminal.until(b"pdp8> ")
    assert b" words\n" in command(b"load " + name.encode())
    command(b"go 200", b"*")
    assert typed(b"TYPE 3+3,!\r") == b"TYPE 3+3,!\n" + answers[0] + b"*"
    terminal.type(b"\x05")
    said = _STYLE.sub(b"", terminal.until(b"pdp8> ")).replace(b"\r", b"")
    assert re.fullmatch(
        rb"\nstop key; [\d.]+ s; next [0-7]{4}  .*\ncont goes back into the program\npdp8> ", said
    )
    assert re.fullmatch(rb"AC [0-7]{4}\n", command(b"e ac"))
    assert command(b"e 200").startswith(b"0200  ")
    assert b"the machine is stopped; cont continues" in command(b"TYPE 3+3,!")
    back(b"cont")
    assert typed(b"TYPE 2*2,!\r") == b"TYPE 2*2,!\n" + answers[1] + b"*"
    terminal.type(b"\x1d")
    said = _STYLE.sub(b"", terminal.until(b"pdp8> "))
    assert b"goes back" not in said
    assert command(b"save f.state") == b"wrote f.state\n"
    assert command(b"deposit 0-7577 0") == b""
    assert command(b"restore f.state").startswith(b"restored; ")
    back(b"c")
    assert typed(b"TYPE 3+3,!\r") == b"TYPE 3+3,!\n" + answers[0] + b"*"
    terminal.type(b"\x05")
    terminal.until(b"pdp8> ")
    terminal.type(b"q\r")
    assert terminal.ended() == 0
