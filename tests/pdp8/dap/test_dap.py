"""`pdp8 dap` as an editor sees it: Microsoft's debug client holds the conversation.

Addresses, words and lines are those of add_and_type.pal, worked out by hand.
"""

import base64
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.commands import BIN, start
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
    assert [(point["verified"], point["line"]) for point in points] == [(True, 12), (True, 13), (True, 17), (False, 99)]
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
    assert stops(seen) == ["entry", *["step"] * 5, *kinds, "breakpoint", "function breakpoint", "breakpoint", "breakpoint"]
    assert seen.page == "H"
    assert [answer for answer in seen.answers if "error" in answer] == []
