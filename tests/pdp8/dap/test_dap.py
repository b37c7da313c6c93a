"""`pdp8 dap` as an editor sees it: Microsoft's debug client holds the conversation.

Addresses, words and lines are those of add_and_type.pal, worked out by hand.
"""

import base64
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.commands import BIN
from tests.pdp8.dap.editor import Seen, Step, launched, play

PROGRAM = "add_and_type.pal"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the program."""
    shutil.copy(Path(__file__).parent / PROGRAM, tmp_path)
    return tmp_path


def console(line: str) -> Step:
    """Return the step that enters a line at the debug console."""
    return ["evaluate", {"expression": line, "context": "repl"}]


WHERE: Step = ["stackTrace", {"threadId": 1}]


def where(answer: dict[str, Any]) -> list[tuple[str, int]]:
    """Return the frames of a stack trace, each with its line."""
    return [(frame["name"], frame["line"]) for frame in answer["body"]["stackFrames"]]


def stops(seen: Seen) -> list[str]:
    """Return why the machine stopped, each time that it did."""
    return [answer["event"]["reason"] for answer in seen.answers if (answer.get("event") or {}).get("reason")]


def test_breakpoints_and_steps_in_both_directions(folder: Path) -> None:
    lines = [{"line": 12}, {"line": 13}, {"line": 16}, {"line": 99}]
    moves = ("next", "stepIn", "stepOut", "stepBack", "stepOut", *["continue"] * 4, *["reverseContinue"] * 4)
    seen = play(
        folder,
        *launched(
            {"program": PROGRAM},
            ["setBreakpoints", {"source": {"path": str(folder / PROGRAM)}, "breakpoints": lines}],
            ["setBreakpoints", {"source": {"path": "/other.pal"}, "breakpoints": [{"line": 1}]}],
            ["setFunctionBreakpoints", {"breakpoints": [{"name": "TYPE"}, {"name": "206"}, {"name": "NIX"}]}],
        ),
        *(step for move in moves for step in ([move, {"threadId": 1}, "stopped"], WHERE)),
        ["stepBack", {"threadId": 1}],
    )
    points = seen.answers[2]["body"]["breakpoints"]
    placed = [(point["verified"], point["line"]) for point in points]
    assert placed == [(True, 12), (True, 13), (True, 17), (False, 99)]
    assert not seen.answers[3]["body"]["breakpoints"][0]["verified"]
    assert [point["verified"] for point in seen.answers[4]["body"]["breakpoints"]] == [True, True, False]
    assert [where(answer) for answer in seen.answers[7::2]] == [
        [("0201  main program", 6)],
        [("0214  ADD", 18), ("0201  main program", 6)],
        [("0203  main program", 8)],
        [("0216  ADD", 20), ("0201  main program", 6)],
        [("0203  main program", 8)],
        [("0207  main program", 12)],
        [("0220  TYPE", 22), ("0207  main program", 12)],
        [("0210  main program", 13)],
        [("0207  main program", 12)],
        [("0210  main program", 13)],
        [("0220  TYPE", 22), ("0207  main program", 12)],
        [("0207  main program", 12)],
        [("0214  ADD", 18), ("0201  main program", 6)],
    ]
    kinds = ["breakpoint", "function breakpoint", "breakpoint", "breakpoint"]
    assert stops(seen) == ["entry", *["step"] * 5, *kinds * 2]
    assert seen.page == "H"
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
    words = base64.b64encode(bytes([0o7402 >> 8, 0o7402 & 0xFF])).decode()
    seen = play(
        folder,
        *launched({"program": PROGRAM, "sr": "4321"}),
        ["setVariable", {"variablesReference": 1, "name": "AC", "value": "1234"}],
        ["setVariable", {"variablesReference": 1, "name": "AC", "value": "12345"}],
        ["setVariable", {"variablesReference": 3, "name": "SUM", "value": "0007"}],
        ["setVariable", {"variablesReference": 2, "name": "RUN", "value": "1"}],
        ["variables", {"variablesReference": 1}],
        ["variables", {"variablesReference": 2}],
        ["variables", {"variablesReference": 4}],
        ["writeMemory", {"memoryReference": "0x0100", "offset": 2, "data": words}],
        ["writeMemory", {"memoryReference": "0x0100", "data": base64.b64encode(b"\xff\xff").decode()}],
        ["readMemory", {"memoryReference": "0x0100", "offset": 0, "count": 4}],
        ["readMemory", {"memoryReference": "0x0000", "offset": 8190, "count": 4}],
        ["disassemble", {"memoryReference": "0x0100", "instructionOffset": 1, "instructionCount": 2}],
        ["disassemble", {"memoryReference": "0x0000", "instructionOffset": -1, "instructionCount": 1}],
        ["dataBreakpointInfo", {"variablesReference": 3, "name": "SUM"}],
        ["setDataBreakpoints", {"breakpoints": [{"dataId": "0212"}]}],
        ["setVariable", {"variablesReference": 1, "name": "PC", "value": "0210"}],
        ["continue", {"threadId": 1}, "stopped"],
        ["evaluate", {"expression": "SUM", "context": "hover"}],
        ["reverseContinue", {"threadId": 1}, "stopped"],
        ["evaluate", {"expression": "SUM", "context": "watch"}],
        ["evaluate", {"expression": "CUONT", "context": "hover"}],
        console("examine SUM"),
    )
    answers = seen.answers[3:]
    assert answers[0]["body"]["value"] == "1234"
    assert "12345" in answers[1]["error"]
    assert answers[2]["body"]["value"] == "0007"
    assert "lamps only show" in answers[3]["error"]
    registers = {each["name"]: each["value"] for each in answers[4]["body"]["variables"]}
    assert (registers["AC"], registers["SR"], registers["PC"]) == ("1234", "4321", "0200")
    lamps = {each["name"]: each["value"] for each in answers[5]["body"]["variables"]}
    assert lamps["AC"] == "○○● ○●○ ○●● ●○○"
    assert [each["name"] for each in answers[6]["body"]["variables"]] == ["03 Receiver", "04 Transmitter"]
    assert answers[7]["body"] == {"bytesWritten": 2}
    assert "177777 into 0200" in answers[8]["error"]
    assert base64.b64decode(answers[9]["body"]["data"]) == bytes([0o7300 >> 8, 0o300, 0o7402 >> 8, 0o2])
    assert answers[10]["body"]["unreadableBytes"] == 2
    instructions = [each["instruction"] for each in answers[11]["body"]["instructions"]]
    assert instructions == ["0201  HLT", "0202  AND 0005"]
    assert answers[12]["body"]["instructions"][0]["presentationHint"] == "invalid"
    assert answers[13]["body"]["dataId"] == "0212"
    assert answers[16]["event"]["reason"] == "data breakpoint"
    assert answers[17]["body"]["result"].split() == ["0212", "0010", "AND", "0010"]
    assert answers[18]["event"]["reason"] == "data breakpoint"
    assert answers[19]["body"]["result"].split() == ["0212", "0007", "AND", "0007"]
    assert "CUONT" in answers[20]["error"]
    assert answers[21]["body"]["result"] == answers[19]["body"]["result"]


def test_a_program_that_waits_is_typed_to_paused_and_restarted(folder: Path) -> None:
    seen = play(
        folder,
        *launched({"program": "echo.pal"}),
        ["continue", {"threadId": 1}],
        ["next", {"threadId": 1}],
        console("keyboard PAL"),
        console("expect PAL"),
        ["pause", {"threadId": 1}, "stopped"],
        ["restart", {}, "stopped"],
        ["evaluate", {"expression": "PC"}],
        ["terminate", {}, "terminated"],
    )
    assert seen.answers[4]["error"] == "the machine runs: pause comes first"
    assert [answer["error"] for answer in seen.answers if "error" in answer] == [seen.answers[4]["error"]]
    assert seen.page == "PAL"
    assert stops(seen) == ["entry", "pause", "entry"]
    assert seen.answers[-2]["body"]["result"] == "0200"


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
    subprocess.run([BIN / "pal", PROGRAM, "-o", "program.bin"], cwd=folder, check=True, capture_output=True)
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
