"""The vectors for hands: the reference does as they say, by the runner and by the script for pipan8l."""

import shutil
import subprocess
from itertools import islice
from pathlib import Path
from typing import Any

import pytest

from pdp8.vectors import hands, runner
from tests.pdp8.vectors.emulators import ReferenceEmulator
from tests.reference.compiling import compiler

MATE = """
proc ask args {puts "? $args"; flush stdout; gets stdin}
foreach name {setsw getreg flicksw} {proc $name args "ask $name {*}\\$args"}
proc after ms {}
proc flushit {} {}
proc rdmem address {setsw sr $address; flicksw ldad; getreg mb}
proc wrmem {address word} {setsw sr $address; flicksw ldad; setsw sr $word; flicksw dep}
"""
OURS = {theirs: ours for ours, theirs in hands.PIPAN8L.items()}
pytestmark = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")


def test_they_press_every_key_and_name_what_the_sources_do_otherwise() -> None:
    made = list(hands.vectors())
    pressed = {one["hand"] for vector in made for one in vector["hands"]}
    assert pressed == {*hands.KEYS, *hands.SWITCHES, hands.RUN}
    lamps: dict[str, Any] = {vector["name"]: vector["hands"][-1]["lamps"] for vector in made}
    assert [lamps[f"{key} after ION, HLT with a flag up"]["ac"] for key in ("CONT", "EXAM, CONT")] == [0, 0]
    (dep,) = [vector["hands"] for vector in made if vector["name"] == "DEP at 7600 with MEM PROT up"]
    shown = [(one["lamps"]["mb"], one["lamps"]["protect"]) for one in dep if one["hand"] == "dep"]
    assert shown == [(0o1234, 1), (0o4321, 0)]
    assert {vector["models"][0] for vector in made} == {"8/L"}


def test_the_runner_names_the_lamp_that_differs() -> None:
    class Stays(ReferenceEmulator):
        def hand(self, what: str, value: int) -> dict[str, Any]:
            lamps = super().hand(what, value)
            return lamps if what != "exam" else lamps | {"state": "FETCH"}

    found = [runner.play(vector, Stays()) for vector in islice(hands.vectors(), 18)]
    assert "state after hand 8, exam, is FETCH, not " in found
    assert runner.play(next(hands.vectors()), object()) is None


class Pipan8l:
    """The reference as the commands of pipan8l see it: `ask` answers one."""

    def __init__(self) -> None:
        self.machine = ReferenceEmulator()
        self.machine.set(dict(runner.REGISTERS))

    def ask(self, command: str, name: str, value: str = "0") -> object:
        ours = OURS.get(name, name)
        lamps = self.machine.hand("run", 0)  # a hand takes long
        if command == "getreg":
            return lamps[ours][:1] if ours == "state" else lamps[ours]
        self.machine.hand(ours, int(value, 8 if value.startswith("0") else 10))
        return ""


@pytest.mark.skipif(shutil.which("tclsh") is None, reason="there is no tclsh")
@pytest.mark.parametrize("wrong", ["", "ion"])
def test_the_script_for_a_real_machine(wrong: str, tmp_path: Path) -> None:
    script = tmp_path / "hands.tcl"
    script.write_text(MATE + hands.pipan8l(islice(hands.vectors(), 60)))
    mate, said = Pipan8l(), []
    with subprocess.Popen(
        ["tclsh", script], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
    ) as tcl:
        assert tcl.stdin
        assert tcl.stdout
        for line in tcl.stdout:
            if line.startswith("? "):
                command, *given = line.split()[1:]
                answer = mate.ask(command, *given)
                if given[0] == wrong:
                    answer = 0
                print(answer, file=tcl.stdin, flush=True)
            else:
                said.append(line)
    if wrong:
        assert "ION in single cycles with a flag up: ion after hand 11, cont, is '0', not '1'\n" in said
    else:
        assert said == ["60 played, 0 differ\n"]


def test_the_script_is_short_and_plays_all() -> None:
    text = hands.pipan8l(hands.vectors())
    assert text.count("\nvector ") == len(list(hands.vectors()))
    assert text[: text.index("\nvector ")].count("\n") <= 60
