"""Breakpoints that look: at a condition, at a count of hits, with a message; and after a program was edited.

Most tests speak the protocol, through Microsoft's debug client; words and lines are worked out by hand.
"""

from pathlib import Path
from typing import Any

import pytest

from pdp8 import shelf
from pdp8.computer.machine import Machine
from pdp8.dap import session
from pdp8.dap.breakpoints import ADDRESSES, Breakpoints, Point
from pdp8.dap.debuggee import Debuggee, Halt
from pdp8.dap.launch import Launch
from pdp8.dap.places import Places
from pdp8.dap.wire import Body
from pdp8.monitor.prompt import Monitor
from tests.pdp8.dap.test_dap import console, launched, play

COUNTS = "*200\nL,\tISZ N\n\tISZ M\n\tJMP L\n\tHLT\nN,\t7770\nM,\t7760\nCOUNTER=M\n$\n"
"""N and M count up; N reaches 0 in the eighth turn, and JMP L (line 4) is passed over then."""
SOURCE = {"path": "counts.pal"}


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "counts.pal").write_text(COUNTS)
    return tmp_path


def lines(*points: dict[str, Any]) -> list[Any]:
    return ["setBreakpoints", {"source": SOURCE, "breakpoints": list(points)}]


def stops(folder: Path, **words: str) -> tuple[Body, Halt, int, str]:
    """Run to the first stop at a point of line 3; return the point, the stop, M and what is said."""
    program = str(folder / "counts.pal")
    debuggee = Debuggee(Launch.of({"program": program}), Breakpoints())
    asked = {"source": {"path": program}, "breakpoints": [{"line": 3, **words}]}
    (point,) = session._OF_THE_MACHINE["setBreakpoints"](debuggee, asked)["breakpoints"]
    debuggee.run()
    halt = next(filter(None, (debuggee.advance() for _ in range(1000))))
    return point, halt, debuggee.monitor.machine.core[0o205], debuggee.notes()


@pytest.mark.parametrize(
    ("words", "m"),
    [
        ({}, 0o7760),
        ({"condition": "M == 7763"}, 0o7763),
        ({"condition": "core[N+1] > 7764 && !(PC == 0)"}, 0o7765),
        ({"condition": "N - M == 11 || L == 7"}, 0o7760),
        ({"condition": "N & 7 == 3 | 0"}, 0o7762),
        ({"condition": "COUNTER == 7763"}, 0o7763),
        ({"hitCondition": "3"}, 0o7762),
        ({"hitCondition": ">= 2"}, 0o7761),
        ({"hitCondition": "% 4"}, 0o7763),
        ({"condition": "M > 7761", "hitCondition": "2"}, 0o7763),
    ],
)
def test_a_run_stops_where_the_condition_holds(words: dict[str, str], m: int, folder: Path) -> None:
    point, halt, found, _ = stops(folder, **words)
    assert (halt, found) == (Halt("breakpoint", "", (point["id"],)), m)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ({"condition": "M =="}, "an expression such as"),
        ({"condition": "NIX == 1"}, "NIX: neither a register nor a symbol"),
        ({"condition": "M == 9"}, "9: neither an octal number"),
        ({"condition": "M ** 2"}, "* is not an operator"),
        ({"condition": "__import__('os')"}, "_ is not an operator"),
        ({"hitCondition": "often"}, "often: a decimal number of hits expected"),
        ({"logMessage": "at {NIX}"}, "NIX: neither"),
    ],
)
def test_what_cannot_be_looked_at_is_not_verified(words: dict[str, str], said: str, folder: Path) -> None:
    point, *_ = stops(folder, **words)
    assert (point["verified"], point["line"], said in point["message"]) == (False, 3, True), point


def test_a_log_message_is_said_and_the_run_goes_on(folder: Path) -> None:
    _, halt, _, said = stops(folder, logMessage="M is {M}, then {core[N]}", condition="M < 7762")
    assert halt.reason == "halt"
    assert said.startswith("M is 7760, then 7771\nM is 7761, then 7772\n")
    assert said.count("M is") == 2


def test_an_expression_is_watched_and_set(folder: Path) -> None:
    evaluated = ["evaluate", {"expression": "N + 2 == 7772", "context": "watch"}]
    seen = play(
        folder,
        *launched({"program": "counts.pal"}),
        evaluated,
        ["setExpression", {"expression": "M", "value": "17"}],
        ["setExpression", {"expression": "AC", "value": "77777"}],
        ["completions", {"text": "exa", "column": 4}],
        ["completions", {"text": "examine L", "column": 10}],
        ["completions", {"text": "examine L", "column": 9}],
        ["completions", {"text": "examine I", "column": 10}],
        ["gotoTargets", {"source": {"path": (folder / "counts.pal").as_uri()}, "line": 4}],
        ["goto", {"threadId": 1, "targetId": 0o203}, "stopped"],
        console("PC"),
    )
    value, word, refused, commands, names, before, fields, targets, moved, pc = seen.answers[3:]
    assert value["body"]["result"] == "0001"
    assert "0017" in word["body"]["value"]
    assert "77777" in refused["error"]
    assert commands["body"]["targets"] == [{"label": "examine"}]
    assert {each["label"] for each in names["body"]["targets"]} == {"LINK", "L"}
    assert {"AC", "N"} < {each["label"] for each in before["body"]["targets"]}, "all: nothing is typed yet"
    shown = {each["label"] for each in fields["body"]["targets"]}
    assert not shown & {"IF", "IB"}, "they are of 8K"
    assert targets["body"]["targets"] == [{"id": 0o202, "label": "0202", "line": 4}]
    assert moved["event"]["reason"] == "goto"
    assert pc["body"]["result"] == "0203"


DIFFERENT: dict[str, list[Body]] = {
    "setBreakpoints": [{"line": 3}, {"line": 4}],
    "setFunctionBreakpoints": [{"name": "L"}, {"name": "N"}],
    "setInstructionBreakpoints": [
        {"instructionReference": "0x0100"},
        {"instructionReference": "0x0100", "offset": 2},
        {"instructionReference": "0x0102"},
    ],
    "setDataBreakpoints": [
        {"dataId": "N", "accessType": "read"},
        {"dataId": "N", "accessType": "write"},
        {"dataId": "M", "accessType": "write"},
    ],
    "setExceptionBreakpoints": [],
}
"""For each request breakpoints that differ in one field."""


def test_breakpoints_that_differ_in_a_field_are_two_and_keep_their_numbers(folder: Path) -> None:
    assert [name for name in session._OF_THE_MACHINE if name.endswith("Breakpoints")] == [*DIFFERENT]
    program = str(folder / "counts.pal")
    debuggee = Debuggee(Launch.of({"program": program}), Breakpoints())
    numbers: set[int] = set()
    for name, points in DIFFERENT.items():

        def ids(points: list[Body], name: str = name) -> list[int]:
            asked = {"source": {"path": program}, "breakpoints": points}
            found = session._OF_THE_MACHINE[name](debuggee, asked).get("breakpoints", ())
            assert all(each["verified"] for each in found)
            return [each["id"] for each in found]

        given = ids(points)
        assert (len({*given}), numbers & {*given}) == (len(points), set()), name
        assert ids([{**point, "condition": "M"} for point in points[::-1]]) == given[::-1]
        numbers |= {*given}


@pytest.mark.parametrize(
    ("access", "stood"),
    [
        ("read", ["0201 [1, 2]", "0203 [1]", "0204 [1]"]),
        ("write", ["0202 [1]", "0203 [1]", "0202 [1]"]),
        ("readWrite", ["0201 [1, 2]", "0202 [1]", "0203 [1]"]),
    ],
)
def test_a_word_is_watched_for_what_was_asked(access: str, stood: list[str], folder: Path) -> None:
    """TAD I P reads P, then W; DCA writes W; ISZ reads and writes it; AND reads it. Back the same way."""
    (folder / "counts.pal").write_text(
        "*200\n\tTAD I P\n\tDCA W\n\tISZ W\n\tAND W\n\tJMP 200\nP,\tW\nW,\t1\n$\n"
    )
    points = [{"dataId": name, "accessType": access} for name in ("W", "P")]
    go = (["continue", {"threadId": 1}, "stopped"], console("PC"))
    back = (["reverseContinue", {"threadId": 1}, "stopped"], console("PC"))
    asked = ["setDataBreakpoints", {"breakpoints": points}]
    seen = play(folder, *launched({"program": "counts.pal"}, asked), *go * 3, *back * 3)
    events = [answer["event"] for answer in seen.answers[-12::2]]
    assert {event["reason"] for event in events} == {"data breakpoint"}
    places = [answer["body"]["result"] for answer in seen.answers[-11::2]]
    found = zip(places, events[:3], strict=False)
    assert [f"{place} {event['hitBreakpointIds']}" for place, event in found] == stood
    before = {"0201": "0200", "0202": "0201", "0203": "0202", "0204": "0203"}
    assert places[3:] == [before[place[:4]] for place in reversed(stood)], "before the instruction"


def test_an_instruction_that_writes_two_words_stops_for_both(folder: Path) -> None:
    """DCA I 10 counts 0010 in DEFER and writes 0300 in EXECUTE."""
    (folder / "counts.pal").write_text("*10\n\t277\n*200\n\tDCA I 10\n\tHLT\n$\n")
    points = [{"dataId": place, "accessType": "write"} for place in ("10", "300")]
    asked = ["setDataBreakpoints", {"breakpoints": points}]
    seen = play(folder, *launched({"program": "counts.pal"}, asked), ["continue", {"threadId": 1}, "stopped"])
    assert seen.answers[-1]["event"]["hitBreakpointIds"] == [1, 2]


def test_breakpoints_look_at_the_machine_that_is_there(folder: Path) -> None:
    """`set cpu` and `restore` put another one there; what lies beyond its core stops nothing."""
    beyond = ["setFunctionBreakpoints", {"breakpoints": [{"name": "10200"}]}]
    places = [{"instructionReference": "0x4000"}, {"instructionReference": "0x0", "offset": -2}]
    word = {"dataId": "N", "accessType": "execute"}
    seen = play(
        folder,
        *launched({"program": "counts.pal"}, lines({"line": 3, "condition": "M == 7763"})),
        ["setInstructionBreakpoints", {"breakpoints": places}],
        ["setDataBreakpoints", {"breakpoints": [word]}],
        *(console("set cpu 8k"), beyond, console("break 10300")),
        [*console("set cpu 4k"), "breakpoint"],
        *(console("save s"), [*console("step"), "stopped"], [*console("restore s"), "stopped"]),
        ["continue", {"threadId": 1}, "stopped"],
        console("M"),
    )
    nowhere, unused, _, there, _, gone, *_, stopped, m = seen.answers[4:]
    assert [each["message"] for of in (nowhere, unused) for each in of["body"]["breakpoints"]] == [
        *("20000: no address of core", "-1: no address of core"),
        "execute: a word is watched for read, write or readWrite",
    ]
    assert there["body"]["breakpoints"][0]["verified"]
    assert "not between 0000 and 7777" in gone["event"]["breakpoint"]["message"]
    assert stopped["event"]["hitBreakpointIds"] == [1]
    assert m["body"]["result"].split()[1] == "7763"


EDITED = "*200\n\tCLA\n" + COUNTS.removeprefix("*200\n")


def test_after_an_edit_breakpoints_go_where_their_names_went(folder: Path) -> None:
    """Restart loads the program as it is now, one line and one word longer."""
    points = (
        ["setFunctionBreakpoints", {"breakpoints": [{"name": "M"}, {"name": "NIX"}]}],
        lines({"line": 4}),
        ["setDataBreakpoints", {"breakpoints": [{"dataId": "N"}]}],
    )
    begun = play(folder, *launched({"program": "counts.pal"}, *points))
    before = [point for answer in begun.answers[2:5] for point in answer["body"]["breakpoints"]]
    edit = f"import pathlib; pathlib.Path('counts.pal').write_text({EDITED!r})"
    seen = play(
        folder,
        *launched({"program": "counts.pal"}, *points),
        ["edit", edit],
        ["restart", {}, "breakpoint"],
        points[0],
        lines({"line": 5}),
        points[2],
        ["continue", {"threadId": 1}, "stopped"],
    )
    moved = seen.answers[-5]["event"]["breakpoint"]
    after = [point for answer in seen.answers[-4:-1] for point in answer["body"]["breakpoints"]]
    assert [point["id"] for point in after] == [point["id"] for point in before]
    assert [point.get("instructionReference") for point in before] == ["0x010a", None, "0x0104", "0x0108"]
    assert [point.get("instructionReference") for point in after] == ["0x010c", None, "0x0106", "0x010a"]
    assert (moved["id"], moved["instructionReference"]) == (1, "0x010c")
    assert seen.answers[-1]["event"]["hitBreakpointIds"] == [4], "after ISZ N"


def test_after_an_edit_a_breakpoint_goes_where_its_line_went(folder: Path) -> None:
    """Neovim and Emacs move it in their windows, and do not set it again."""
    edit = f"import pathlib; pathlib.Path('counts.pal').write_text({EDITED.replace('JMP L', 'JMP  L')!r})"
    seen = play(
        folder,
        *launched({"program": "counts.pal"}, lines({"line": 4}, {"line": 5})),
        ["edit", edit],
        ["restart", {}, "breakpoint"],
        ["threads", {}],
        ["continue", {"threadId": 1}, "stopped"],
        ["stackTrace", {"threadId": 1}],
        lines({"line": 5}, {"line": 6}),
    )
    moved, _, stopped, stack, again = seen.answers[-5:]
    assert (moved["event"]["breakpoint"]["id"], moved["event"]["breakpoint"]["line"]) == (1, 5)
    assert stopped["event"]["hitBreakpointIds"] == [1]
    assert stack["body"]["stackFrames"][0]["line"] == 5
    assert [point["id"] for point in again["body"]["breakpoints"]] == [1, 2]


def test_a_command_that_halts_the_machine_is_told_as_a_stop(folder: Path) -> None:
    (folder / "key.pal").write_text("*200\nS,KSF;JMP .-1;KRB;HLT;ISZ F;JMP S;F,0\n$\n")
    for line, said in (("type A", "RETURN was not pressed"), ('keyboard "AB"', "1 key of 2 sent")):
        seen = play(
            folder,
            *launched({"program": "key.pal"}),
            ["continue", {"threadId": 1}],
            [*console(line), "stopped"] if line == "type A" else console(line),
            console("PC"),
            console("F"),
        )
        answer, pc, f = seen.answers[-3:]
        assert said in (answer.get("error") or answer["body"]["result"] + "".join(t for _, t in seen.output))
        assert pc["body"]["result"] == "0204", "it stands behind the HLT"
        assert f["body"]["result"].split()[1] == "0000"


def test_a_program_of_two_tapes_has_breakpoints_in_both(folder: Path) -> None:
    (folder / "one.pal").write_text("*200\n\tJMS SUB\n\tHLT\nPAUSE\n")
    (folder / "two.pal").write_text("SUB,\t0\n\tISZ SUB\n\tJMP I SUB\n$\n")
    seen = play(
        folder,
        *launched(
            {"program": ["one.pal", "two.pal"]},
            ["setBreakpoints", {"source": {"path": "two.pal"}, "breakpoints": [{"line": 3}]}],
            ["setBreakpoints", {"source": {"path": "other.pal"}, "breakpoints": [{"line": 3}]}],
        ),
        ["continue", {"threadId": 1}, "stopped"],
        ["stackTrace", {"threadId": 1}],
    )
    good, other = (answer["body"]["breakpoints"][0] for answer in seen.answers[2:4])
    assert (good["verified"], good["line"], good["source"]["name"]) == (True, 3, "two.pal")
    assert (other["verified"], other["message"]) == (False, "the program that runs is one.pal two.pal")
    top, *_, last = seen.answers[-1]["body"]["stackFrames"]
    assert (top["line"], top["source"]["name"], last["source"]["name"]) == (3, "two.pal", "one.pal")


def test_hits_are_counted_anew_when_the_program_is_loaded_again() -> None:
    monitor, places = Monitor(lambda line: None, Machine()), Places(shelf.program("hello.pal"))
    point = Point(1, ADDRESSES, "200", {"name": "200", "hitCondition": "2"})
    for now in (5, 7):
        point.place(monitor, places)
        assert not point.stops(now, [])
    assert point.stops(9, [])
