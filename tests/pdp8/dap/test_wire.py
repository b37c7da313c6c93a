"""What is no message, and requests that no editor should send: an answer each, and no traceback."""

import json
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import fields as fields_of
from io import BytesIO
from itertools import cycle, product
from pathlib import Path
from typing import Any

import pytest

from pdp8.dap import requests, session
from pdp8.dap.breakpoints import Breakpoints
from pdp8.dap.debuggee import Debuggee, Halt
from pdp8.dap.launch import Launch
from pdp8.dap.session import Session
from pdp8.dap.wire import Wire
from tapes import binary
from tests.commands import run
from tests.pdp8.dap.test_dap import NPM


def framed(*requests: Any) -> bytes:
    """Return messages as they go over the wire."""
    contents = [json.dumps(request).encode() for request in requests]
    return b"".join(b"Content-Length: %d\r\n\r\n%b" % (len(content), content) for content in contents)


def test_what_is_no_message_ends_the_session() -> None:
    done = run("pdp8", "dap", stdin=b"Content-Length: 5\r\n")
    assert (done.returncode, done.stdout) == (1, b"")
    assert done.stderr.startswith(b"pdp8 dap: the input ends within the head")


def spoken(stdout: bytes) -> list[dict[str, Any]]:
    """Return the messages that were sent, in order."""
    return [json.loads(part[part.index(b"{") :]) for part in stdout.split(b"Content-Length: ")[1:]]


@pytest.mark.parametrize(
    ("content", "said"), [(b"{", "not JSON"), (b"[]", "not a JSON object"), (b"7", "not a")]
)
def test_a_message_that_is_no_object_is_passed_over(content: bytes, said: str) -> None:
    sent = b"Content-Length: %d\r\n\r\n%b" % (len(content), content)
    done = run("pdp8", "dap", stdin=sent + framed({"type": "request", "command": "threads"}))
    assert (done.returncode, done.stderr) == (0, b"")
    output, answer = spoken(done.stdout)
    assert said in output["body"]["output"]
    assert answer["body"]["threads"][0]["name"] == "PDP-8/L"


def test_a_fault_of_the_debugger_is_said_to_be_one(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(debuggee: object, arguments: object) -> dict[str, Any]:
        raise KeyError("body")

    monkeypatch.setitem(session._OF_THE_MACHINE, "scopes", fails)
    asked = [("launch", {"program": "hello.pal"}), ("scopes", {}), ("threads", {})]
    sent = framed(*({"type": "request", "command": name, "arguments": given} for name, given in asked))
    out = BytesIO()
    Session(BytesIO(sent), out).serve()
    failed, *rest = [each for each in spoken(out.getvalue()) if each.get("command") in ("scopes", "threads")]
    assert failed["message"] == "scopes: a fault of the debugger, please report it: KeyError('body')"
    assert [each["success"] for each in rest] == [True]


ODD: dict[type, list[Any]] = {
    int: [-1, 0, 1, 3, 100, 0o20000, 1 << 40],
    str: ["", " ", "-1", "7", "X", "12345", "77777", "0x4001", "core[", "é", "a=b", "AC", "repl"],
    bool: [False, True],
    dict: [{}, {"path": ""}, {"sourceReference": 9}],
}
"""Values that a protocol's types allow: those of a machine of 8K, below them and beyond."""


def test_a_value_of_the_right_type_is_never_a_fault_of_the_debugger(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """In what any request needs or may have, in each breakpoint, in each field of a configuration."""
    monkeypatch.chdir(tmp_path)
    Path("x.pal").write_text("FIELD 1\n*200\nX,\t0\n\tHLT\n$\n")
    launch = {"program": "x.pal", "memory": "8k", "start": "10201", "stopOnEntry": True}
    draw = random.Random(8)

    def odd(name: str) -> Any:
        if name == "breakpoints":
            return [{each: odd(each) for each in (*requests._OF_EACH.values(), "condition", "hitCondition")}]
        return draw.choice(ODD[requests._TYPES[name]])

    asked: list[tuple[str, dict[str, Any]]] = [("launch", launch), ("configurationDone", {})]
    for name, needed in requests._NEEDED.items():
        kinds = [ODD.get(requests._TYPES.get(each, list), []) for each in needed]
        for values in product(*(kind or [odd("breakpoints") for _ in range(24)] for kind in kinds)):
            more = draw.sample(sorted(requests._TYPES), 3)
            asked.append((name, {each: odd(each) for each in more} | dict(zip(needed, values, strict=True))))
    for field in fields_of(Launch):
        for value in ODD.get(type(field.default), ODD[str]):
            asked.append(("launch", launch | {field.name: value}))
    assert [each for each in held(*asked) if "a fault of the debugger" in str(each)] == []


PROTOCOL = NPM / "node_modules/@vscode/debugprotocol/lib/debugProtocol.d.ts"
FIELDS = set(re.findall(r"(\w+)\??: ", PROTOCOL.read_text())) if PROTOCOL.exists() else set()


def fields(of: object) -> Iterator[str]:
    """Yield the names of all fields of a message but those that a text of its own names."""
    if isinstance(of, dict):
        yield from of
        of = [each for name, each in of.items() if name != "variables" or isinstance(each, list)]
    for each in of if isinstance(of, list) else ():
        yield from fields(each)


def held(*asked: tuple[str, dict[str, Any]]) -> list[dict[str, Any]]:
    """Return what a debugger says, in the protocol's words, to requests that all stand in its input."""
    out = BytesIO()
    sent = framed(*({"type": "request", "command": name, "arguments": given} for name, given in asked))
    Session(BytesIO(sent), out).serve()
    heard = spoken(out.getvalue())
    assert not FIELDS or set(fields(heard)) <= FIELDS
    assert [each["seq"] for each in heard] == [*range(1, len(heard) + 1)]
    return heard


def console(line: str) -> tuple[str, dict[str, Any]]:
    return "evaluate", {"expression": line, "context": "repl"}


def test_a_session_ends_once() -> None:
    """Emacs's dape answers `terminated` with `terminate`."""
    launch = {"program": "hello.pal", "stopOnEntry": True}
    heard = held(("launch", launch), ("terminate", {}), ("terminate", {}), ("restart", {}), ("terminate", {}))
    told = [each.get("command") or each["event"] for each in heard]
    ended = ["terminate", "exited", "terminated"]
    assert [each for each in told if each in ended] == [*ended, "terminate", *ended]


@pytest.mark.parametrize(
    ("launch", "asked", "ends"),
    [
        (None, ("terminate", {}), True),
        ({}, ("configurationDone", {}), False),
        ({"noDebug": True}, ("configurationDone", {}), False),
        ({}, console("quit"), True),
    ],
)
def test_what_ends_a_session(
    launch: dict[str, Any] | None, asked: tuple[str, dict[str, Any]], ends: bool
) -> None:
    """Without debugging there is no entry to stop at."""
    whole = {"program": "hello.pal", "stopOnEntry": True}
    heard = held(*[("launch", whole | launch)] if launch is not None else [], asked)
    events = [each["event"] for each in heard if each["type"] == "event"]
    assert (events[-2:] == ["exited", "terminated"]) is ends


@pytest.mark.parametrize("leaves", ["terminate", "disconnect"])
def test_a_tape_is_written_when_an_editor_leaves_a_run(leaves: str, tmp_path: Path) -> None:
    source, punch = tmp_path / "letters.pal", tmp_path / "out.eia"
    source.write_text("*200\nS,\tTAD A\n\tTLS\n\tCLA\n\tTSF\n\tJMP .-1\n\tJMP S\nA,\t301\n$\n")
    launch = {"program": str(source), "punch": str(punch)}
    heard = held(("launch", launch), ("configurationDone", {}), console("run 1"), (leaves, {}))
    assert set(punch.read_bytes()) == {0o301}
    events = [each for each in heard if "event" in each]
    assert "stopped" not in [each["event"] for each in events]
    if leaves == "terminate":
        wrote = [each["event"] for each in events if str(punch) in str(each)]
        assert wrote == ["output"], events
        assert events[-1]["event"] == "terminated"


def test_a_source_that_has_changed_is_named_once_before_the_stop(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    program = tmp_path / "own.pal"
    program.write_text("*200\n\tNOP\n\tHLT\n$\n")
    edits = iter(["*200\n\tHLT\n$\n"])
    monkeypatch.setattr(Debuggee, "pause", lambda debuggee: [*map(program.write_text, edits)])
    launch = {"program": str(program), "stopOnEntry": True}
    heard = held(("launch", launch), ("configurationDone", {}), ("stepIn", {}))
    events = [
        each["event"] for each in heard if "stopped" in str(each) or "was changed: restart" in str(each)
    ]
    assert events == ["output", "stopped", "stopped"]


def test_a_second_launch_waits_for_its_breakpoints(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    turns = cycle([False, True])
    monkeypatch.setattr(Wire, "holds", property(lambda self: next(turns)))
    for name, source in (
        ("runs.pal", "*200\n\tISZ 10\n\tJMP .-1\n\tJMP 200\n$\n"),
        ("halts.pal", "*200\n\tHLT\n$\n"),
    ):
        (tmp_path / name).write_text(source)
    runs, halts = (("launch", {"program": str(tmp_path / name)}) for name in ("runs.pal", "halts.pal"))
    heard = held(runs, ("configurationDone", {}), halts, ("threads", {}), ("threads", {}))
    assert "stopped" not in [each.get("event") for each in heard]


def test_a_pause_while_the_machine_stands_is_not_remembered() -> None:
    launch = {"program": "hello.pal", "stopOnEntry": True}
    pause = ("pause", {"threadId": 1})
    heard = held(("launch", launch), ("configurationDone", {}), pause, console("step 3"), console("PC"))
    assert [each["body"]["reason"] for each in heard if each.get("event") == "stopped"] == ["entry", "pause"]
    *_, stepped, at = [each for each in heard if each.get("command") == "evaluate"]
    assert len(stepped["body"]["result"].splitlines()) == 3
    assert at["success"]


def test_a_command_that_moves_the_machine_is_not_stopped_by_what_was_used_before(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(Wire, "holds", False)
    monkeypatch.chdir(tmp_path)
    Path("x.pal").write_text("*200\n\tDCA W\n\tISZ W\n\tCLA\n\tCLA\n\tHLT\nW,\t0\n$\n")
    points = ("setDataBreakpoints", {"breakpoints": [{"dataId": "W", "accessType": "readWrite"}]})
    launch = ("launch", {"program": "x.pal", "stopOnEntry": True})
    for lines, reasons in ((["back 1"], ["pause"]), (["step", "cycle"], ["pause"] * 2), (["run"], ["halt"])):
        go = ("continue", {"threadId": 1})
        heard = held(launch, points, ("configurationDone", {}), go, go, *map(console, lines))
        stops = [each["body"]["reason"] for each in heard if each.get("event") == "stopped"]
        assert stops == ["entry", "data breakpoint", "data breakpoint", *reasons], lines


def test_a_program_that_waits_is_told_once_and_again_after_continue(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """However often the editor asks something meanwhile: here the machine runs between any two requests."""
    monkeypatch.setattr(Wire, "holds", False)
    (tmp_path / "waits.pal").write_text("*200\n\tKSF\n\tJMP .-1\n\tHLT\n$\n")
    launch = ("launch", {"program": str(tmp_path / "waits.pal")})
    then: list[tuple[str, dict[str, Any]]] = [("threads", {}), ("threads", {}), ("pause", {"threadId": 1})]
    heard = held(launch, ("configurationDone", {}), *then, ("continue", {"threadId": 1}), *then)
    assert [each["event"] for each in heard if "the program waits" in str(each)] == ["output"] * 2
    assert [each["body"]["reason"] for each in heard if each.get("event") == "stopped"] == ["pause"] * 2


def test_what_has_no_word_of_core_is_not_watched(tmp_path: Path) -> None:
    (tmp_path / "own.pal").write_text("*200\nAC,\tHLT\n$\n")
    launch = ("launch", {"program": str(tmp_path / "own.pal"), "stopOnEntry": True})
    of = [("dataBreakpointInfo", {"name": "AC", "variablesReference": at}) for at in (1, 3)]
    *_, register, symbol, expression = held(launch, *of, ("dataBreakpointInfo", {"name": "AC"}))
    assert [each["body"]["dataId"] for each in (register, symbol, expression)] == [None, "0200", "0200"]


def test_every_request_is_answered(tmp_path: Path) -> None:
    (tmp_path / "far.pal").write_text("*200\n\tJMP FAR\n$\n")
    (tmp_path / "halt.pal").write_text("*200\nSTART,\tHLT\n$\n")
    asked = [
        ("next", {}, "launch comes first"),
        ("launch", {}, "the name of a PAL source or of a tape"),
        ("launch", {"program": "-"}, "standard input and output"),
        ("launch", {"program": "far.pal"}, "far.pal:2:6: error: UA"),
        ("launch", {"program": "halt.pal", "reader": 3}, "a text or a list of texts expected, not 3"),
        ("launch", {"program": "halt.pal", "start": "NIX"}, "NIX: neither an octal number nor a symbol"),
        ("launch", {"program": "halt.pal"}, ""),
        ("fly", {}, "no such request"),
        ("stepOut", {}, "no way out"),
        ("stepBack", {}, "nothing to undo"),
        ("initialize", {"linesStartAt1": float("inf")}, "linesStartAt1: true or false expected, not inf"),
        ("setBreakpoints", [], "an object expected, not []"),
        ("setBreakpoints", {}, "source is missing"),
        ("setBreakpoints", {"source": {}, "breakpoints": [{}]}, "a breakpoint has no line"),
        (
            "setBreakpoints",
            {"source": {}, "breakpoints": [{"line": "1"}]},
            "whole number expected, not '1'",
        ),
        ("setBreakpoints", {"source": {}, "breakpoints": 7}, "a list expected, not 7"),
        ("setDataBreakpoints", {"breakpoints": [3]}, "an object expected, not 3"),
        ("evaluate", {"expression": 7}, "expression: a text expected, not 7"),
        ("readMemory", {"memoryReference": "core", "count": 1}, "a number such as 0x0100"),
        ("setVariable", {"variablesReference": 104, "name": "flag", "value": "7"}, "flag is 0 to 1"),
        ("variables", {"variablesReference": 99}, "no scope"),
        ("disconnect", {}, ""),
    ]
    requests = [{"type": "request", "command": name, "arguments": given} for name, given, _ in asked]
    done = run(
        "pdp8",
        "dap",
        stdin=framed({"type": "event"}, {"type": "request", "command": 7}, *requests),
        folder=tmp_path,
    )
    assert done.stderr == b""
    none, number, *said = [
        answer.get("message", "") for answer in spoken(done.stdout) if answer["type"] == "response"
    ]
    assert none == "a request was expected, not 'event' None"
    assert number == "a request was expected, not 'request' 7"
    assert len(said) == len(asked)
    for (name, _, expected), message in zip(asked, said, strict=True):
        assert (expected in message) if expected else message == "", f"{name}: {message}"


@pytest.mark.parametrize(
    ("lines", "columns"), [({}, {}), ({"linesStartAt1": True}, {"columnsStartAt1": False}),
                           ({"linesStartAt1": False}, {"columnsStartAt1": True})]
)  # fmt: skip
@pytest.mark.parametrize("tape", [False, True])
def test_lines_and_columns_begin_at_1_unless_an_editor_says_0(
    tape: bool, lines: dict[str, Any], columns: dict[str, Any], tmp_path: Path
) -> None:
    line, column = 2 - (False in lines.values()), 1 - (False in columns.values())
    own = tmp_path / "own"
    own.write_bytes(binary.encode({0o200: 0o7200, 0o201: 0o7402}) if tape else b"*200\n\tCLA\n\tHLT\n$\n")
    source = {"sourceReference": 1} if tape else {"path": str(own)}
    launch = ("launch", {"program": str(own), "stopOnEntry": True})
    points = ("setBreakpoints", {"source": source, "breakpoints": [{"line": line}]})
    asked = ("stackTrace", {"threadId": 1}), ("completions", {"text": "detail", "column": 3 + column})
    *_, placed, frames, found = held(("initialize", lines | columns), launch, points, *asked)
    (point,) = placed["body"]["breakpoints"]
    assert (point["line"], point["instructionReference"]) == (line, "0x0100")
    (frame,) = frames["body"]["stackFrames"]
    assert (frame["line"], frame["column"]) == (line, column)
    assert found["body"]["targets"] == [{"label": "detach"}]


@pytest.mark.parametrize(("shows", "every"), [(True, -1), (False, -1), (True, 99)])
def test_the_way_back_is_shown_to_editors_that_can(
    shows: bool, every: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def back_to(self: Debuggee, look: Callable[[float], None]) -> Halt:
        look(0.2)
        look(0.7)
        return Halt("entry")

    monkeypatch.setattr(session, "_PROGRESS", every)
    monkeypatch.setattr(Debuggee, "back_to", back_to)
    launch = {"program": "hello.pal", "stopOnEntry": True}
    back = ("reverseContinue", {"threadId": 1})
    heard = held(("initialize", {"supportsProgressReporting": shows}), ("launch", launch), back, back)
    events = [each for each in heard if each.get("event", "").startswith("progress")]
    told = [(each["event"][8:], each["body"].get("percentage")) for each in events]
    assert told == [("Start", None), ("Update", 20), ("Update", 70), ("End", None)] * (
        2 if shows and every < 0 else 0
    )


def test_a_pause_ends_one_search_and_not_the_next(monkeypatch: pytest.MonkeyPatch) -> None:
    searches: list[object] = []

    def back_to(self: Debuggee, look: Callable[[float], None]) -> Halt:
        searches.append(look)
        if len(searches) == 1:
            made._heard({"command": "pause"})
        look(0.5)
        return Halt("entry")

    monkeypatch.setattr(Debuggee, "back_to", back_to)
    back = {"type": "request", "command": "reverseContinue", "arguments": {"threadId": 1}}
    launch = {"type": "request", "command": "launch", "arguments": {"program": "hello.pal"}}
    out = BytesIO()
    made = Session(BytesIO(framed(launch, back, back)), out)
    made.serve()
    first, second = [each for each in spoken(out.getvalue()) if each.get("command") == "reverseContinue"]
    assert (first["message"], second["success"]) == ("paused: the machine is where it was", True)


@pytest.mark.parametrize("undebugged", [False, True])
@pytest.mark.parametrize(
    ("name", "loop", "reason"), [("eia.pal", "", "tape out"), ("waits.pal", "KSF\n\tJMP .-1", "")]
)
def test_without_debugging_a_run_ends_where_its_tape_does(
    name: str, loop: str, reason: str, undebugged: bool, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It waits for a key as it does under a debugger."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "waits.pal").write_text(f"*200\n\t{loop}\n$\n")
    (tmp_path / "in.asc").write_bytes(b"1")
    launch = Launch.of({"program": name, "noDebug": undebugged, "reader": "in.asc"})
    debuggee = Debuggee(launch, Breakpoints())
    debuggee.run()
    halt = next(filter(None, (debuggee.advance() for _ in range(100))))
    assert halt.reason == (reason if undebugged else "")
