"""`pdp8 dap` as an editor sees it: Microsoft's debug client holds the conversation.

Addresses, words and lines are those of add_and_type.pal, worked out by hand.
"""

import base64
import json
import shutil
from collections.abc import Sequence
from pathlib import Path
from subprocess import PIPE
from typing import Any, NamedTuple

import pytest

from tests import commands
from tests.pdp8.web.node import NODE

NPM = Path(__file__).parents[2] / "node"
PROGRAM = "add_and_type.pal"

Step = Sequence[Any]


class Seen(NamedTuple):
    """What an editor was answered, step by step, and what was put out, each with its category."""

    answers: list[dict[str, Any]]
    output: list[tuple[str, str]]


def play(folder: Path, *steps: Step) -> Seen:
    """Hold a conversation: each step is a request, its arguments, the event that is to come of it."""
    if NODE is None or not (NPM / "node_modules" / "@vscode").exists():
        pytest.skip("the debug client is not installed: npm ci --prefix tests/node")
    whole = [[*step, *({}, None)[len(step) - 1 :]] for step in steps]
    asked = json.dumps({"adapter": [str(commands.BIN / "pdp8"), "dap"], "steps": whole})
    client = commands.start(NODE, NPM / "debug_client.mjs", folder=folder, stdin=PIPE)
    answered, said = client.communicate(asked.encode(), timeout=60)
    assert client.returncode == 0, said
    return Seen(**json.loads(answered))


def page(seen: Seen) -> str:
    """Return what the Teletype has printed."""
    return "".join(text for category, text in seen.output if category == "stdout")


def launched(arguments: dict[str, Any], *breakpoints: Step) -> list[Step]:
    """Return the steps up to where the program stands before its first instruction."""
    return [
        ["initialize", {"adapterID": "pdp8", "linesStartAt1": True}],
        ["launch", {"stopOnEntry": True, **arguments}, "initialized"],
        *breakpoints,
        ["configurationDone", {}, "stopped"],
    ]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the program."""
    shutil.copy(Path(__file__).parent / PROGRAM, tmp_path)
    return tmp_path


def console(line: str) -> Step:
    """Return the step that enters a line at the debug console."""
    return ["evaluate", {"expression": line, "context": "repl"}]


def data(*words: int) -> str:
    """Return words as an editor has memory: two bytes each, in base 64."""
    return base64.b64encode(b"".join(word.to_bytes(2, "big") for word in words)).decode()


def assert_told(folder: Path, arguments: dict[str, Any], *asked: tuple[Step, str]) -> Seen:
    """Take each step once the program stands before its first instruction; its answer has the texts."""
    seen = play(folder, *launched(arguments), *(step for step, _ in asked))
    for answer, (step, texts) in zip(seen.answers[3:], asked, strict=True):
        told = json.dumps(answer, ensure_ascii=False)
        assert [text for text in texts.split(" ... ") if text not in told] == [], (step, told)
    return seen


WHERE: Step = ["stackTrace", {"threadId": 1}]


def where(answer: dict[str, Any]) -> list[tuple[str, int]]:
    """Return the frames of a stack trace, each with its line."""
    return [(frame["name"], frame["line"]) for frame in answer["body"]["stackFrames"]]


def test_breakpoints_and_steps_in_both_directions(folder: Path) -> None:
    lines = [{"line": 12}, {"line": 13}, {"line": 16}, {"line": 99}]
    moves = [
        ("next", [("0201  main program", 6)]),
        ("stepIn", [("0214  ADD", 18), ("0201  main program", 6)]),
        ("stepOut", [("0203  main program", 8)]),
        ("stepBack", [("0216  ADD", 20), ("0201  main program", 6)]),
        ("stepOut", [("0203  main program", 8)]),
        ("continue", [("0207  main program", 12)]),
        ("continue", [("0220  TYPE", 22), ("0207  main program", 12)]),
        ("continue", [("0210  main program", 13)]),
        ("continue", [("0207  main program", 12)]),
        ("reverseContinue", [("0210  main program", 13)]),
        ("reverseContinue", [("0220  TYPE", 22), ("0207  main program", 12)]),
        ("reverseContinue", [("0207  main program", 12)]),
        ("reverseContinue", [("0214  ADD", 18), ("0201  main program", 6)]),
    ]
    seen = play(
        folder,
        *launched(
            {"program": PROGRAM},
            ["setBreakpoints", {"source": {"path": str(folder / PROGRAM)}, "breakpoints": lines}],
            ["setBreakpoints", {"source": {"path": "/other.pal"}, "breakpoints": [{"line": 1}]}],
            ["setFunctionBreakpoints", {"breakpoints": [{"name": "TYPE"}, {"name": "206"}, {"name": "NIX"}]}],
        ),
        *(step for move, _ in moves for step in ([move, {"threadId": 1}, "stopped"], WHERE)),
        ["stepBack", {"threadId": 1}],
    )
    placed, other, functions = (answer["body"]["breakpoints"] for answer in seen.answers[2:5])
    verified = [(point["verified"], point["line"]) for point in placed]
    assert verified == [(True, 12), (True, 13), (True, 17), (False, 99)]
    assert [point["verified"] for point in (*other, *functions)] == [False, True, True, False]
    for (move, frames), answer in zip(moves, seen.answers[7::2], strict=True):
        assert where(answer) == frames, move
    kinds = ["breakpoint", "function breakpoint", "breakpoint", "breakpoint"]
    stops = [answer["event"]["reason"] for answer in seen.answers[5:] if answer.get("event")]
    assert stops == ["entry", *["step"] * 5, *kinds * 2]
    assert page(seen) == "H"
    assert [answer for answer in seen.answers if "error" in answer] == []


def test_a_subroutine_that_waits_right_behind_its_call_is_left(folder: Path) -> None:
    """At 10 characters a second it waits for 27,000 instructions, each of them where it might return to."""
    (folder / "behind.pal").write_text(
        "*200\n\tJMS TYPE\n\tHLT\nTYPE,\t0\n\tTLS\n\tTSF\n\tJMP .-1\n\tJMP I TYPE\nCOUNT,\t5\n$\n"
    )
    seen = play(
        folder,
        *launched({"program": "behind.pal"}),
        *(step for move in ("stepIn", "stepOut") for step in ([move, {"threadId": 1}, "stopped"], WHERE)),
        console("COUNT"),
    )
    assert where(seen.answers[-2]) == [("0201  main program", 3)]
    assert seen.answers[-1]["body"]["result"] == "0207  0005  COUNT,  5"  # no command of the monitor


def test_what_the_machine_holds_is_shown_and_set(folder: Path) -> None:
    def setting(scope: int, name: str, value: str) -> Step:
        return ["setVariable", {"variablesReference": scope, "name": name, "value": value}]

    def variables(scope: int) -> Step:
        return ["variables", {"variablesReference": scope}]

    def disassembled(address: str, offset: int, count: int) -> Step:
        return memory("disassemble", address, instructionOffset=offset, instructionCount=count)

    def memory(request: str, address: str, **more: object) -> Step:
        return [request, {"memoryReference": address, **more}]

    assert_told(
        folder,
        {"program": PROGRAM, "sr": "4321"},
        (setting(1, "AC", "1234"), '"value": "1234"'),
        (setting(1, "AC", "12345"), '"error": "12345: '),
        (setting(3, "SUM", "0007"), '"value": "0007"'),
        (setting(2, "RUN", "1"), "lamps only show"),
        (variables(1), '"AC", "value": "1234" ... "PC", "value": "0200" ... "SR", "value": "4321"'),
        (variables(2), '"AC", "value": "○○● ○●○ ○●● ●○○"'),
        (variables(4), '{"variables": [{"name": "03 Receiver", ... "name": "04 Transmitter", '),
        (memory("writeMemory", "0x0100", offset=2, data=data(0o7402)), '"bytesWritten": 2'),
        (memory("writeMemory", "0x0100", data=data(0o177777)), "177777 into 0200"),
        (memory("readMemory", "0x0100", offset=0, count=4), f'"data": "{data(0o7300, 0o7402)}"'),
        (memory("readMemory", "0x0000", offset=8190, count=4), '"unreadableBytes": 2'),
        (disassembled("0x0100", 1, 2), '"0201  HLT" ... "0202  AND 0005"'),
        (disassembled("0x0000", -1, 1), '"invalid"'),
        (["dataBreakpointInfo", {"variablesReference": 3, "name": "SUM"}], '"dataId": "0212"'),
        (["setDataBreakpoints", {"breakpoints": [{"dataId": "0212"}]}], '"verified": true'),
        (setting(1, "PC", "0210"), '"value": "0210"'),
        (["continue", {"threadId": 1}, "stopped"], '"reason": "data breakpoint"'),
        (["evaluate", {"expression": "SUM", "context": "hover"}], '"0212  0010          AND 0010"'),
        (["reverseContinue", {"threadId": 1}, "stopped"], '"reason": "data breakpoint"'),
        (["evaluate", {"expression": "SUM", "context": "watch"}], '"0212  0007          AND 0007"'),
        (["evaluate", {"expression": "CUONT", "context": "hover"}], '"error": "CUONT: '),
        (console("examine SUM"), '"0212  0007          AND 0007"'),
    )


def test_a_program_that_waits_is_typed_to_paused_and_restarted(folder: Path) -> None:
    seen = assert_told(
        folder,
        {"program": "echo.pal"},
        (["continue", {"threadId": 1}], ""),
        (["next", {"threadId": 1}], '{"error": "the machine runs: pause comes first"}'),
        (console("keyboard PAL"), '"body"'),
        (console("expect PAL"), '"body"'),
        (["pause", {"threadId": 1}, "stopped"], '"reason": "pause"'),
        (["restart", {}, "stopped"], '"reason": "entry"'),
        (["evaluate", {"expression": "PC"}], '"result": "0200"'),
        (["terminate", {}, "terminated"], '"body"'),
    )
    assert page(seen) == "PAL"


def test_tapes_of_the_configuration_and_a_run_without_debugging(folder: Path) -> None:
    (folder / "three.asc").write_bytes(bytes(0o200 | code for code in b"3\r\n"))
    (folder / "four.asc").write_bytes(bytes(0o200 | code for code in b"4\r\n"))
    (folder / "own.pal").write_text("*200\n\tHLT\n$\n")
    tapes = {"reader": ["three.asc", "four.asc"], "punch": "out.eia"}
    seen = play(
        folder,
        ["initialize", {"adapterID": "pdp8"}],
        ["launch", {"program": "eia.pal", "punch": "three.asc", "reader": "three.asc"}],
        ["launch", {"program": "eia.pal", "punch": "own.pal"}],
        ["launch", {"program": "eia.pal", "noDebug": True, **tapes}, "initialized"],
        ["setFunctionBreakpoints", {"breakpoints": [{"name": "CHK"}]}],
        ["configurationDone", {}, "terminated"],
    )
    assert "three.asc is read too" in seen.answers[1]["error"]
    assert "own.pal is there, and is no tape" in seen.answers[2]["error"]
    said = "".join(text for _, text in seen.output)
    assert "four.asc goes into the reader\n" in said
    assert said.count("wrote out.eia\n") == 1
    assert (folder / "out.eia").read_bytes().strip(b"\0") == bytes([0o023, 0o200, 0o004, 0o200])


def test_a_tape_shows_its_listing_and_stops_at_its_lines(folder: Path) -> None:
    commands.run("pal", PROGRAM, "-o", "program.bin", folder=folder)
    listing = {"sourceReference": 1, "name": "program.bin"}
    seen = play(
        folder,
        *launched(
            {"program": "program.bin", "boot": True}, ["source", {"source": listing, "sourceReference": 1}]
        ),
        WHERE,
    )
    lines = seen.answers[2]["body"]["content"].splitlines()
    frame = seen.answers[-1]["body"]["stackFrames"][0]
    assert lines[frame["line"] - 1].split()[:4] == ["0200", "7300", "CLA", "CLL"]
    assert frame["source"]["sourceReference"] == 1
