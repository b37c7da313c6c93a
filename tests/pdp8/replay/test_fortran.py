"""The listings in DEC's 8K FORTRAN II: as source; run under PS/8 where PDP8_OS8 names a folder with it."""

import os
from pathlib import Path

import pytest

import pal
from pdp8 import shelf
from pdp8.computer.machine import Machine
from pdp8.replay.fortran import Own, Session, source
from programs.parts import PARTS
from tapes import dectape
from tapes.errors import WorkError
from tests.pdp8.cli.test_console import PROMPT


def test_the_three_changes_of_the_listing() -> None:
    """No sequence number, remark or mark; labels in columns 1 to 5; WRITE; F-formats a column wider."""
    lines = source(shelf.read("circle.for").decode()).splitlines()
    assert lines[0] == "      A1=1019."
    assert lines[24:31] == ["      WRITE (1,10) A1,A2,A3,A4".replace("A", letter) for letter in "ABCDEG"] + [
        "10    FORMAT(1X,F6.0,F5.0,F6.0,F5.0)"
    ]
    assert lines[31] == "      AS=7."
    assert "30    FORMAT(F4.0,F2.0,F6.0,F6.0,F4.0,F3.0)" in lines
    assert lines[-2:] == ["105   STOP", "      END"]
    assert all(line[:5].strip().isdigit() or line[:6] == " " * 6 for line in lines)


def test_a_session_waits_for_the_prompt_that_a_program_types() -> None:
    """An asterisk, what is typed, CR and LF; then a program that never waits."""
    machine = Machine()
    machine.load(pal.assemble(PROMPT, dialect="pal8").words)
    machine.start(0o200)
    session = Session(machine)
    with pytest.raises(WorkError, match=r"expected to type '\*'; idle after '\*'"):
        list(session.until("*"))  # at the begin of a line
    list(session.type("AB", "*"))
    assert session.paper == "*AB\r\n*"
    list(session.type("C"))
    assert session.paper == "*AB\r\n*"
    with pytest.raises(WorkError, match=r"expected to type '\.'; idle after '\*AB.*\*C"):
        list(session.until("."))
    machine.load({0o300: 0o2310, 0o301: 0o5300, 0o302: 0o5300})
    machine.start(0o300)
    slices = session.until(".", 25)
    assert [next(slices), next(slices)] == [None, None]
    with pytest.raises(WorkError, match="limit after"):
        next(slices)


@pytest.mark.slow("40 minutes of 1971, two minutes here")
@pytest.mark.skipif("PDP8_OS8" not in os.environ, reason="PDP8_OS8 names no folder with a DECtape of PS/8")
@pytest.mark.parametrize(("part", "blocks"), [("circle", 666), ("ellipse", 976)])
def test_the_tape_is_torontos(part: str, blocks: int) -> None:
    reel = Path(os.environ["PDP8_OS8"]) / "ps-8-master.tu56"
    day = Own(part, dectape.decode(reel.read_bytes())[0], lambda act: None)
    for _ in day.through():
        pass
    assert next(act.outcome for act in day.acts if act.name == "Run") == (
        f"{blocks} lines, 0 other than Toronto's"
    )
    assert day.tapes[f"{part}.eia"] == shelf.read(f"{part}.eia")
    assert day.text == PARTS[part].program()()
