"""Random sessions of the debugger beside a plain reference: a machine that is stepped, all its moments kept.

A session steps into, back, restarts, asks for pages of the stack and for registers, and leaves anywhere.
"""

import io
import json
import random
from pathlib import Path
from typing import Any, NamedTuple

import pytest

import pal
import pdp8
from pdp8.dap.session import Session
from tests.conftest import case
from tests.pdp8.dap.test_dap import console, launched, page, play
from tests.pdp8.dap.test_wire import framed, spoken


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path


SOURCE = """*200
BEGIN,	TLS
NEXT,	CLA
	TAD L
	JMS OUT
	ISZ L
	ISZ N
	JMP NEXT
	HLT
OUT,	0
	TSF
	JMP .-1
	TLS
	CLA
	JMP I OUT
L,	301
N,	7774
$
"""


class Moment(NamedTuple):
    """The machine before an instruction: PC, AC, what was printed and punched so far."""

    pc: int
    ac: int
    printed: bytes
    punched: bytes


def moments() -> list[Moment]:
    """Return every moment of the program, as a machine without a debugger has it."""
    machine = pdp8.Machine()
    machine.load(pal.assemble(SOURCE).words)
    machine.start(0o200)
    found: list[Moment] = []
    while machine.panel.lamps.run and len(found) < 400:
        tty = machine.teletype
        found.append(Moment(machine.pc, machine.ac, bytes(tty.printer.frames), bytes(tty.punch.tape)))
        machine.run(instructions=1)
    return found


REFERENCE = moments()
STEPS = {"stepIn": 1, "stepBack": -1}


def session(seed: int) -> tuple[list[dict[str, Any]], list[int]]:
    """Return the requests of a session, and the moment at which each finds the machine."""
    drawn = random.Random(seed)
    asked: list[tuple[str, Any]] = [
        ("initialize", {}),
        ("launch", {"program": "letters.pal", "stopOnEntry": True, "punch": "out.tape"}),
        ("setBreakpoints", {"source": {"path": "other.pal"}, "breakpoints": [{"line": 1}]}),
        ("configurationDone", {}),
    ]
    at, where = 0, [0] * 4
    for _ in range(drawn.randrange(40)):
        name = drawn.choice(["stepIn"] * 6 + ["stepBack"] * 2 + ["stackTrace", "evaluate", "restart"])
        arguments: dict[str, Any] = {}
        if name == "stackTrace":
            arguments = {"startFrame": drawn.randrange(3), "levels": drawn.randrange(3)}
        elif name == "evaluate":
            arguments = {"expression": drawn.choice(["PC", "AC"]), "context": "watch"}
        asked.append((name, arguments))
        where.append(at)
        at = 0 if name == "restart" else max(at + STEPS.get(name, 0), 0)
    asked.append(("disconnect", {}))
    where.append(at)
    return [
        {"type": "request", "seq": n, "command": c, "arguments": a} for n, (c, a) in enumerate(asked)
    ], where


@pytest.mark.parametrize("first", range(0, 100, 25))
def test_a_random_session_is_as_the_machine_alone(
    first: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("letters.pal").write_text(SOURCE)
    for seed in range(first, first + 25):
        Path("out.tape").unlink(missing_ok=True)
        requests, where = session(seed)
        out = io.BytesIO()
        Session(io.BytesIO(framed(*requests)), out).serve()
        told = spoken(out.getvalue())
        answers = {each["request_seq"]: each for each in told if each["type"] == "response"}
        assert sorted(answers) == [each["seq"] for each in requests], "each is answered once"
        for request, at in zip(requests, where, strict=True):
            with case(f"seed {seed}: {json.dumps(request)}: {json.dumps(answers[request['seq']])}"):
                compare(request, answers[request["seq"]], REFERENCE[at], at)
        punched = Path("out.tape").read_bytes() if Path("out.tape").exists() else b""
        assert punched.strip(b"\0") == REFERENCE[where[-1]].punched.strip(b"\0"), f"seed {seed}"


def compare(request: dict[str, Any], answer: dict[str, Any], moment: Moment, at: int) -> None:
    """Compare an answer with the moment at which the request found the machine."""
    name, given = request["command"], request["arguments"]
    assert answer["success"] == (name != "stepBack" or at > 0)
    if name == "setBreakpoints":
        assert [point["verified"] for point in answer["body"]["breakpoints"]] == [False]
    elif name == "evaluate":
        assert answer["body"]["result"] == f"{moment.pc if given['expression'] == 'PC' else moment.ac:04o}"
    elif name == "stackTrace":
        inside = 0o210 < moment.pc <= 0o215
        whole = [moment.pc, 0o203][: 1 + inside]
        end = given["startFrame"] + (given["levels"] or len(whole))
        shown = [int(frame["name"].split()[0], 8) for frame in answer["body"]["stackFrames"]]
        assert (shown, answer["body"]["totalFrames"]) == (whole[given["startFrame"] : end], len(whole))


def test_what_is_printed_again_after_going_back_is_shown_again(folder: Path) -> None:
    go = ["continue", {"threadId": 1}, "stopped"]
    back = [*console("back 6 characters"), "stopped"]
    seen = play(folder, *launched({"program": "hello.pal"}), go, back, go)
    once = "\nHELLO, WORLD.\n"
    assert page(seen) == once + once[-5:], "CR and LF are two of the six"
