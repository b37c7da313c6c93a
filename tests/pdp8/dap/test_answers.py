"""A debugger's answers within one process: both sides of each limit, each setting beside its effect."""

import base64
import os
import re
from contextlib import nullcontext
from io import BytesIO
from itertools import cycle
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from pdp8 import shelf
from pdp8.computer.hardware.fields import FRAMES, TICK, walk
from pdp8.computer.hardware.signals import AT_ONCE, NEVER
from pdp8.computer.machine import Machine
from pdp8.dap import calls, expressions, requests, scopes, wire
from pdp8.dap.breakpoints import ADDRESSES, LINES, Breakpoints, Point
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.launch import Launch
from pdp8.dap.places import Places
from pdp8.dap.session import Session
from pdp8.monitor import debugging
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.prompt import Monitor
from tapes import binary
from tapes.errors import WorkError
from tests.pdp8.computer.dectape import reel
from tests.pdp8.dap.test_wire import FIELDS, PROTOCOL, console, held
from tests.pdp8.monitor import do

SOURCE = "*200\n\tJMS SUB\n\tHLT\n*300\nSUB,\t0\n\tISZ N\nLAST,\tJMP I SUB\nN,\t7775\nHALF=1234\n$\n"


@pytest.fixture
def program(tmp_path: Path) -> str:
    path = tmp_path / "own.pal"
    path.write_text(SOURCE)
    return str(path)


def asked(program: str, *requests: tuple[str, dict[str, Any]], **more: str) -> list[Any]:
    """Return the body of each answer, or its message, of a program that is stopped at its entry."""
    launch = ("launch", {"program": program, "stopOnEntry": True, **more})
    heard = [
        each for each in held(launch, ("configurationDone", {}), *requests) if each["type"] == "response"
    ]
    return [each.get("body") if each["success"] else each["message"] for each in heard[2:]]


def words(*of: int) -> str:
    return base64.b64encode(b"".join(word.to_bytes(2, "big") for word in of)).decode()


@pytest.mark.parametrize(
    ("offset", "data", "answer"),
    [
        (0, words(0o7777), {"bytesWritten": 2}),
        (0, words(0o10000), "10000 into 0200: a word is 0000 to 7777"),
        (0x1EFE, words(1), {"bytesWritten": 2}),
        (0x1EFE, words(1, 2), "bytes 1ffe to 2002: core has 0 to 2000"),
        (-0x100, words(3), {"bytesWritten": 2}),
        (-0x102, words(3), "bytes -2 to 0: core has 0 to 2000"),
        (0, "A", "the bytes to write are not in base64: "),
        (0, "AA*=", "the bytes to write are not in base64: "),
    ],
)
def test_bytes_are_written_within_core(offset: int, data: str, answer: Any, program: str) -> None:
    (found,) = asked(program, ("writeMemory", {"memoryReference": "0x100", "offset": offset, "data": data}))
    assert found.startswith(answer) if isinstance(answer, str) else found == answer


@pytest.mark.parametrize(
    ("offset", "count", "address", "bytes_", "unreadable"),
    [
        (0, 0, "0x0100", 0, 0),
        (1, 3, "0x0101", 3, 0),
        (0x1EFE, 2, "0x1ffe", 2, 0),
        (0x1EFF, 2, "0x1fff", 1, 1),
        (0x1F00, 1, "0x2000", 0, 1),
        (0x2000, 1, "0x2000", 0, 1),
        (-0x101, 2, "0x0000", 2, 0),
        (0, -1, "0x0100", 0, 0),
    ],
)
def test_bytes_are_read_as_far_as_there_are_any(
    offset: int, count: int, address: str, bytes_: int, unreadable: int, program: str
) -> None:
    given = {"memoryReference": "0x100", "offset": offset, "count": count}
    (found,) = asked(program, ("readMemory", given))
    length = len(base64.b64decode(found["data"]))
    assert (found["address"], length, found["unreadableBytes"]) == (address, bytes_, unreadable)


def test_instructions_have_their_names_and_are_within_core(program: str) -> None:
    def listed(reference: str, count: int, **more: int) -> tuple[str, dict[str, Any]]:
        return "disassemble", {"memoryReference": reference, "instructionCount": count, **more}

    named, moved, ends, odd, all_, defined = asked(
        program,
        listed("0x0180", 3),
        listed("0x0180", 1, offset=2, instructionOffset=-1),
        listed("0x1ffe", 2),
        listed("0x0181", 1),
        listed("0x0000", 5000),
        listed("0x0538", 1),
    )
    names = ("address", "symbol", "instructionBytes")
    shown = [tuple(map(each.get, names)) for each in named["instructions"]]
    assert shown == [
        ("0x0180", "SUB", "0000"), ("0x0182", None, "2303"), ("0x0184", "LAST", "5700"),
    ]  # fmt: skip
    assert [each["address"] for each in moved["instructions"]] == ["0x0180"]
    assert [each.get("presentationHint") for each in ends["instructions"]] == [None, "invalid"]
    assert odd == "0x0181: no word begins at byte 181"
    assert len(all_["instructions"]) == 4096
    assert "symbol" not in defined["instructions"][0], "HALF is a value, and no place"


@pytest.mark.parametrize(
    ("condition", "stood"),
    [
        ("3", [3]), ("==3", [3]), (" > 3 ", [4, 5, 6]), (">= 3", [3, 4, 5, 6]), ("< 3", [1, 2]),
        ("<= 3", [1, 2, 3]),
        ("% 3", [3, 6]), ("% 1", [1, 2, 3, 4, 5, 6]), ("% 0", []),
    ],
)  # fmt: skip
def test_a_breakpoint_stops_at_the_hits_that_are_asked_for(condition: str, stood: list[int]) -> None:
    monitor, places = Monitor(lambda line: None, Machine()), Places(shelf.program("hello.pal"))
    point = Point(1, ADDRESSES, "200", {"name": "200", "hitCondition": condition})
    point.place(monitor, places)
    assert [hit for hit in range(1, 7) if point.stops(10 * hit, [])] == stood
    assert [hit for hit in range(1, 7) if point.stopped(10 * hit)] == stood
    assert not any(point.stopped(10 * hit + 1) for hit in range(7)), "there was no hit"


@pytest.mark.parametrize("depth", [0, 1, 63, 64, 65])
def test_the_innermost_64_calls_are_shown(depth: int) -> None:
    core = [0o7000] * 4096
    for number in range(depth):
        place = 0o1000 + 3 * number
        caller = place - 2 if number else 0o200
        core[0o20 + number], core[place], core[caller] = place, caller + 1, 0o4420 + number
    found = calls.frames(core, 0o1001 + 3 * (depth - 1) if depth else 0o200, 1)
    assert len(found) == min(depth, 64) + 1
    assert [frame.entry for frame in found] == [*[0o1000 + 3 * n for n in range(depth)][::-1][:64], None]


@pytest.mark.parametrize(
    ("core", "pc", "ion", "entries"),
    [
        ({0: 0o201, 1: 0o7000}, 1, 0, [0, None]),
        ({0: 0o201, 1: 0o7000}, 1, 1, [None]),
        ({0: 0, 1: 0o7000}, 1, 0, [None]),
        ({0: 0o201, 1: 0}, 1, 0, [None]),
        ({0o100: 0o4210, 0o210: 0o101, 0o211: 0o7000}, 0o212, 1, [None]),  # JMS 0010
        ({0o200: 0o4210, 0o210: 0o201}, 0o212, 1, [0o210, None]),
        ({0o200: 0o4210, 0o210: 0o204}, 0o212, 1, [0o210, None]),  # three arguments
        ({0o200: 0o4210, 0o210: 0o205}, 0o212, 1, [None]),
        ({0o200: 0o4210, 0o210: 0o200}, 0o212, 1, [None]),
        ({0o10: 0o210, 0o200: 0o4410, 0o210: 0o201}, 0o212, 1, [None]),  # JMS I 10
        ({0o2200: 0o4210, 0o2210: 0o2201, 0o2211: 0o5210}, 0o2212, 1, [None]),  # JMP to the entry itself
        # a routine begins at 0001 and goes through the first word of what was interrupted
        ({0: 0o300, 1: 0o5020, 0o20: 0o201, 0o21: 0o5040, 0o30: 0o202, 0o31: 0o5430, 0o200: 0o4020,
          0o201: 0o4030}, 0o40, 0, [0, None]),
        # a skip may pass the return: ISZ, IOT, SZA, and SKP; CLA has none
        *(({0o200: 0o4210, 0o210: 0o201, 0o211: word, 0o212: 0o5610}, 0o213, 1, [0o210, None])
          for word in (0o2010, 0o6031, 0o7440, 0o7410)),
        *(({0o200: 0o4210, 0o210: 0o201, 0o211: word, 0o212: 0o5610}, 0o213, 1, [None])
          for word in (0o7200, 0o7600, 0o7421, 0o1010)),
    ],
)  # fmt: skip
def test_who_called_is_what_the_words_in_core_say(
    core: dict[int, int], pc: int, ion: int, entries: list[int | None]
) -> None:
    words = [core.get(address, 0o7000 if address > 1 else 0) for address in range(4096)]
    assert [frame.entry for frame in calls.frames(words, pc, ion)] == entries


def test_what_a_command_at_the_console_says_is_said_once(program: str) -> None:
    """In its answer, and not among the notes of another one."""
    lines = ("registers", "examine 200-202", "step", "cycle", "show", "break")
    launch = ("launch", {"program": program, "stopOnEntry": True})
    heard = held(launch, ("configurationDone", {}), *map(console, lines), ("threads", {}))
    answers = [each["body"]["result"] for each in heard if "result" in each.get("body", {})]
    noted = "".join(each["body"]["output"] for each in heard if each.get("event") == "output")
    assert (len(answers), all(answers)) == (len(lines), True)
    assert not [line for answer in answers for line in answer.splitlines() if line in noted]


def test_a_tape_is_written_at_each_stop_and_said_once(program: str, tmp_path: Path) -> None:
    tape = tmp_path / "out.tape"
    debuggee = Debuggee(Launch.of({"program": program, "punch": str(tape)}), Breakpoints())
    for frames in (b"", b"A", b"AB", b"AB", b"ABC"):
        debuggee.monitor.machine.teletype.punch.frames[:] = frames
        debuggee.take_off()
        assert (tape.read_bytes() if tape.exists() else b"") == frames
    assert debuggee.notes() == f"wrote {tape}\n"


def test_a_breakpoint_goes_with_its_line_through_each_edit(program: str) -> None:
    points = Breakpoints()
    for edits in range(4):
        Path(program).write_text(SOURCE.replace("*200\n", "*200\n" + "\tCLA\n" * edits))
        monitor, places = Monitor(lambda line: None, Machine()), Places(shelf.program(program))
        if edits:
            assert len(points.place_anew(monitor, places)) == 1
        else:
            asked = {"line": 6, "source": {"path": program}}
            points.put(monitor, places, LINES, program, [(6, asked)])
        assert [(point.line, point.address) for point in points] == [(6 + edits, 0o301)]


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"memory": "8k"}, None),
        ({"memory": "9k"}, "memory: 9k; 4k, 8k"),
        ({"boot": True, "program": ["own.pal", "own.pal"]}, "boot: the program is one tape"),
        ({"program": ["own.pal", "-"]}, "-: standard input and output are the debugger's own"),
        ({"punch": "-"}, "-: standard input"),
        ({"reader": ["-"]}, "-: standard input"),
        ({"boot": 1}, "boot: true or false expected, not 1"),
        ({"sr": 7}, "sr: a text in quotes expected, not 7"),
        ({"commands": ["step", 1]}, "commands: a text or a list of texts expected"),
        ({"sr": None, "unknown": 1, "commands": "deposit SR 1"}, None),
    ],
)
def test_a_configuration_is_taken_or_refused(
    given: dict[str, Any], said: str | None, program: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(Path(program).parent)
    (answer,) = [
        each for each in held(("launch", {"program": "own.pal", **given})) if each["type"] == "response"
    ]
    assert answer["success"] is (said is None)
    assert (said or "") in answer.get("message", "")


def test_a_program_may_have_words_in_all_of_core(tmp_path: Path) -> None:
    first, second = (str(tmp_path / name) for name in ("first.pal", "second.pal"))
    Path(first).write_text("*200\n\tHLT\n")
    Path(second).write_text("FIELD 1\n*200\n\tHLT\n$\n")
    for program in ([second], [first, second]):
        monitor, _ = Launch.of({"program": program, "memory": "8k"}).ready(lambda line: None)
        assert monitor.machine.core[0o10200] == 0o7402
        with pytest.raises(WorkError, match="4K of core ends at 07777"):
            Launch.of({"program": program}).ready(lambda line: None)


@pytest.mark.parametrize("end", ["terminate", "disconnect", "restart", "launch", ""])
def test_what_a_machine_leaves_is_saved_however_it_ends(
    end: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The tapes in its punches, and a reel that was written and not saved, even where a tape cannot be."""
    monkeypatch.chdir(tmp_path)
    reel.file(tmp_path / "reel.tu56")
    given = {"program": "hello.pal", "punch": "out", "dectape": ["0=reel.tu56"], "highspeed": True}
    given["commands"] = ["attach ptp fast"]
    session = Session(BytesIO(), BytesIO())
    session._requests["launch"](given)
    monitor = session._loaded.monitor
    monitor.machine.teletype.punch.frames += b"X"
    monitor.machine.highspeed.punch.frames += b"Y"
    place: Any = monitor.reels.places["dt0"]
    place.drive.write(5, 7, 1)
    session._requests[end or "disconnect"](given if end == "launch" else {})
    for action in session._after:
        action()
    if not end:
        Path("out").mkdir()
    with nullcontext() if end else pytest.raises(WorkError):
        session.serve()
    assert not end or Path("out").read_bytes() == b"X"
    assert Path("fast").read_bytes() == b"Y"
    assert [each.name for each in tmp_path.glob("*changed*")] == ["reel-changed.tu56"]


@pytest.mark.parametrize("request_", sorted(requests._NEEDED))
def test_what_a_request_needs_is_all_it_needs(request_: str) -> None:
    values: dict[type, Any] = {int: 1, str: "x", dict: {}, list: []}
    needed = {name: values[requests._TYPES.get(name, list)] for name in requests._NEEDED[request_]}
    assert requests.checked(request_, needed) == needed
    for name in needed:
        with pytest.raises(WorkError, match=f"{request_}: {name} is missing"):
            requests.checked(request_, {each: needed[each] for each in needed if each != name})


@pytest.mark.skipif(not FIELDS, reason="the protocol is not installed: npm ci --prefix tests/node")
def test_a_request_needs_what_the_protocol_has() -> None:
    interfaces = dict(re.findall(r"interface (\w+) \{(.*?)\n\t\}", PROTOCOL.read_text(), re.DOTALL))
    of_each = {f"{name.removeprefix('set')[:-1]}": (field,) for name, field in requests._OF_EACH.items()}
    of_each["SourceBreakpoint"] = of_each.pop("Breakpoint")
    needed = {f"{name[0].upper()}{name[1:]}Arguments": names for name, names in requests._NEEDED.items()}
    for interface, names in (needed | of_each).items():
        required = re.findall(r"^\t\t(\w+): ", interfaces[interface], re.MULTILINE)
        assert set(names) <= {*required, "line"}, interface
    assert set(requests._TYPES) <= FIELDS


def test_notes_of_a_tape_are_said(tmp_path: Path) -> None:
    (tmp_path / "own.bin").write_bytes(b"AB" + binary.encode({0o200: 0o7402}))
    heard = held(("launch", {"program": str(tmp_path / "own.bin")}))
    said = [each["body"]["output"] for each in heard if each.get("event") == "output"]
    assert said == [f"{tmp_path / 'own.bin'}: a label of 2 frames from frame 0 on, left out\n"]


def test_the_scopes_and_what_the_editor_may_do(program: str) -> None:
    able, scopes, registers, devices, words_ = asked(
        program, ("initialize", {}), ("scopes", {"frameId": 0}),
        *(("variables", {"variablesReference": number}) for number in (1, 4, 3)),
    )  # fmt: skip
    assert set(able.values()) == {True}
    assert [each.get("presentationHint") for each in scopes["scopes"]] == ["registers", None, None, None]
    assert not any(each["expensive"] for each in scopes["scopes"])
    values = {each["name"]: (each["value"], each.get("memoryReference")) for each in registers["variables"]}
    assert values["PC"] == ("0200", "0x0100")
    assert values["AC"] == ("0000", None)
    assert all(each["variablesReference"] >= 100 for each in devices["variables"])
    assert [(each["name"], each["value"]) for each in words_["variables"]] == [
        ("LAST", "5700"), ("N", "7775"), ("SUB", "0000"),
    ]  # fmt: skip


def test_a_frame_has_its_place_and_each_row_its_lamps(program: str) -> None:
    stack, lamps, source = asked(
        program, ("stackTrace", {"threadId": 1}), ("variables", {"variablesReference": 2}), ("source", {})
    )
    own = {"name": "own.pal", "path": str(Path(program).resolve())}
    place = {"instructionPointerReference": "0x0100", "source": own, "line": 2, "column": 1}
    assert stack["stackFrames"] == [{"id": 0, "name": "0200  main program", **place}]
    assert stack["totalFrames"] == 1
    assert source["content"].count("JMS SUB") == 1
    *rows, time = lamps["variables"]
    widths = {each["name"]: len(each["value"].replace(" ", "")) for each in rows}
    assert widths == dict.fromkeys(widths, 1) | {"MA": 12, "MB": 12, "AC": 12, "IR": 3}
    assert (time["name"], time["value"]) == ("TIME", "0.00000000 s")


def test_each_register_and_switch_is_shown_and_set(program: str) -> None:
    scope = {"variablesReference": scopes.REGISTERS}
    (shown,) = asked(program, ("variables", scope), memory="8k")
    names = [each["name"] for each in shown["variables"]]
    own = (*debugging.REGISTERS, *debugging.EXTENSION, *debugging.SWITCHES, *debugging.FIELDS)
    assert names == [name.upper().replace("_", " ") for name in own]
    set_ = (("setVariable", {**scope, "name": name, "value": "1"}) for name in names)
    complete = ("completions", {"text": "I", "column": 2})
    *answers, found, field = asked(program, *set_, complete, console("IF"), memory="8k")
    assert [int(answer["value"], 8) for answer in answers] == [1] * len(names)
    assert {"IR", "ION", "IB"} <= {each["label"] for each in found["targets"]}
    assert field["result"] == "1"


def test_all_fields_of_a_device_are_shown_and_those_that_can_be_set_are(program: str) -> None:
    (devices,) = asked(program, ("variables", {"variablesReference": 4}))
    for device in devices["variables"]:
        at = device["variablesReference"]
        (fields,) = asked(program, ("variables", {"variablesReference": at}))
        for field in fields["variables"]:
            if field["variablesReference"] or not field["value"].isdecimal():
                continue
            fixed = "presentationHint" in field
            given = {"variablesReference": at, "name": field["name"], "value": "1"}
            set_, again, bad = asked(
                program, ("setVariable", given), ("variables", {"variablesReference": at}),
                ("setVariable", given | {"value": "-1"}),
            )  # fmt: skip
            assert isinstance(bad, str)
            if not fixed:
                now = {each["name"]: each["value"] for each in again["variables"]}
                assert int(set_["value"]) == int(now[field["name"]]) == 1


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2 + 3 == 5 && 2 < 3", 1), ("0 - 1", 0o7777), ("7777 + 2", 1), ("17 & 12 | 1", 0o13), ("1 || 0", 1),
        ("0 || 0", 0), ("2 && 4", 1), ("2 && 0", 0), ("!2", 0), ("!0", 1), ("3 != 3", 0), ("3 <= 3", 1),
        ("3 >= 4", 0), ("3 > 3", 0), ("3 < 3", 0), (" ( 7 ) ", 7), ("sub", 0), ("N", 0o7775),
        ("core[N]", 0o7775),
        ("core[SUB+3]", 0o7775), ("core[7777 + SUB + 4]", 0o7775), ("core[core[300]]", 0), ("PC", 0o200),
        ("ac", 0), ("HALF", 0),
    ],
)  # fmt: skip
def test_an_expression_has_12_bits_and_a_comparison_one(text: str, value: int, program: str) -> None:
    monitor, _ = Launch.of({"program": [program]}).ready(lambda line: None)
    assert expressions.read(text, monitor)() == value
    assert expressions.message(f"is {{{text}}}, {{N}}.", monitor)() == f"is {value:04o}, 7775."


def test_an_address_has_its_field_in_an_expression(tmp_path: Path) -> None:
    """And a number is as large as core, in 4K as well."""
    (tmp_path / "x.pal").write_text("*200\nHLT\nFIELD 1\n*200\nN, 1234\n5\n$\n")
    monitor, _ = Launch.of({"program": str(tmp_path / "x.pal"), "memory": "8k"}).ready(print)
    for line in ("set pc N", "assert pc N", "set ac N", "assert ac 200", "deposit 300 N", "assert 300 N"):
        do(monitor, line)
    for text, value in (
        ("N", 0o1234), ("core[N+1]", 5), ("core[10200]", 0o1234), ("core[200]", 0o7402), ("AC", 0o200),
        ("PC & 10000", 0o10000), ("PC | 1", 0o10201), ("core[300]", 0o200),
    ):  # fmt: skip
        assert expressions.read(text, monitor)() == value, text
    for each, most in ((monitor, 0o17777), (Monitor(print), 0o7777)):
        assert expressions.read(f"core[{most:o}]", each)() == 0
        with pytest.raises(MonitorError, match=f"{most + 1:o}: not between 0+ and {most:o}"):
            expressions.read(f"core[{most + 1:o}]", each)


@pytest.mark.parametrize("tagged", [False, True])
def test_a_name_is_one_thing_in_each_place(tagged: bool, tmp_path: Path) -> None:
    """For a tag that is called as a register is; the monitor's `examine` and `deposit` have it too."""
    names = (*debugging.REGISTERS, *debugging.EXTENSION, "l")
    tags = "".join(f"{name.upper()}, 7{number:03o}\n" for number, name in enumerate(names))
    (tmp_path / "x.pal").write_text(f"*200\nBEGIN, HLT\n{tags * tagged}$\n")
    debuggee = Debuggee(Launch(program=[str(tmp_path / "x.pal")], memory="8k"), Breakpoints())
    for name in names:
        do(debuggee.monitor, f"set {name} 1" if not tagged else "step", f"examine {name}")
        shown = debuggee.said[-1].removeprefix(f"{debugging.register(name).upper()} ")
        shown = shown.removeprefix(f"{name.upper()} ")
        found = scopes.evaluate(debuggee, {"expression": name})["result"]
        value = expressions.read(name, debuggee.monitor)()
        if tagged:
            assert (found, found[6:10]) == (shown, f"{value:04o}")
            assert (
                scopes.set_expression(debuggee, {"expression": name, "value": "17"})["value"][6:10] == "0017"
            )
        else:
            assert int(found, 8) == int(shown, 8) == value == 1
    do(debuggee.monitor, "deposit 300 BEGIN", "assert 300 200")
    listed = {each["name"] for each in scopes.variables(debuggee, {"variablesReference": 1})["variables"]}
    assert {name.upper() for name in debugging.EXTENSION} <= listed


HEAD = b"Content-Length: 2\r\n\r\n"


@pytest.mark.parametrize(
    ("sent", "found"),
    [
        (b"", None),
        (HEAD + b"{}", {}),
        (b"Content-Length: 2\n\n{}", {}),
        (b"content-length : 2 \r\nContent-Type: x\r\n\r\n{}", {}),
        (b"Content-Type: x\r\n\r\n{}", "has no Content-Length"),
        (b"Content-Length: x\r\n\r\n{}", "has no Content-Length"),
        (HEAD + b"{", "ends after 1 of the 2 bytes"),
        (HEAD + b"[]", "not a JSON object"),
        (HEAD + b"{x", "is not JSON"),
        (b"Content-Length: 16777216\r\n\r\n{}", "ends after 2 of the 16,777,216 bytes"),
        (b"Content-Length: 16777217\r\n\r\n{}", "of at most 16,777,216 bytes"),
        (bytes(4096 - len(HEAD) - 2) + b"\r\n" + HEAD + b"{}", {}),
        (bytes(4096 - len(HEAD) - 1) + b"\r\n" + HEAD + b"{}", "longer than 4,096 bytes"),
        (bytes(10_000), "longer than 4,096 bytes"),
    ],
)
def test_a_message_has_a_length(sent: bytes, found: Any) -> None:
    if isinstance(found, str):
        with pytest.raises(WorkError, match=found):
            wire.read(BytesIO(sent))
    else:
        assert wire.read(BytesIO(sent)) == found


@pytest.mark.parametrize(
    ("edited", "lines"),
    [
        ("ABCDEF", [1, 2, 3, 4, 5, 6]),
        ("xABCDEF", [2, 3, 4, 5, 6, 7]),
        ("ABxyEF", [1, 2, 3, 4, 5, 6]),
        ("ABxEF", [1, 2, 3, 3, 4, 5]),
        ("ABEF", [1, 2, 3, 3, 3, 4]),
        ("ABCxDEF", [1, 2, 3, 5, 6, 7]),
    ],
)
@pytest.mark.parametrize("first", [0, 1])
def test_a_line_is_found_again_after_an_edit(edited: str, lines: list[int], first: int, program: str) -> None:
    path = Path(program)
    path.write_text("".join(f"/{letter}\n" for letter in "ABCDEF") + "HLT\n$\n")
    places, source = Places(shelf.program(program), first), {"path": program}
    before = places.text(source)
    assert places.changed() == []
    path.write_text("".join(f"/{letter}\n" for letter in edited) + "HLT\n$\n")
    os.utime(path, (1, 1))
    assert [places.went(source, line + first, before) - first + 1 for line in range(6)] == lines
    assert (places.changed(), places.changed()) == ([str(path.resolve())], [])
    path.unlink()
    assert places.changed() == [str(path.resolve())]
    assert places.text(source) == []


def test_values_are_shown_by_what_they_are(program: str) -> None:
    monitor, _ = Launch.of({"program": [program]}).ready(lambda line: None)
    now = monitor.machine.processor.clock
    given: list[tuple[int | str, Any]] = [
        (FRAMES, b""), (FRAMES, b"1"), (TICK, NEVER), (TICK, AT_ONCE), (TICK, now), (TICK, now + 20_001),
        (1, True), (9, 9), ("7777", 0o17), ("7", 5),
    ]  # fmt: skip
    shown = [scopes._shown(monitor.machine, kind, value) for kind, value in given]
    assert shown == [
        "no frames",
        "1 frame",
        "never",
        "at once",
        "in 0.00000 ms",
        "in 1.00005 ms",
        "1",
        "9",
        "0017",
        "5",
    ]
    word, before, listed, none, all_, one = asked(
        program, ("evaluate", {"expression": "N", "context": "hover"}), ("evaluate", {"expression": "N-1"}),
        ("evaluate", {"expression": "show", "context": "repl"}),
        ("gotoTargets", {"source": {"path": program}, "line": 99}),
        ("completions", {"text": "", "column": 0}), ("completions", {"text": "examine n", "column": 10}),
    )  # fmt: skip
    for found, result, memory in (
        (word, "0303  7775  N,      7775", 6),
        (before, "0302  5700  LAST,   JMP I SUB", 4),
    ):
        assert found == {"variablesReference": 0, "result": result, "memoryReference": f"0x018{memory}"}
    assert listed == {"variablesReference": 0, "result": "PDP-8/L, 4K of core, ASR-33 Teletype; no EAE"}
    assert none == {"targets": []}
    assert {"examine", "AC", "N"} <= {each["label"] for each in all_["targets"]}
    assert one == {"targets": [{"label": "N"}]}


@pytest.mark.parametrize(
    ("kind", "text", "given"),
    [
        (5, "5", 5), (5, "6", None), (5, "0", 0), (5, "-1", None), (5, "x", None), ("7777", "7777", 0o7777),
        ("7777", "10000", None), ("7", "7", 7), ("7", "10", None), ("7", "8", None), (None, "1", None),
        (TICK, "1", None), (FRAMES, "1", None),
    ],
)  # fmt: skip
def test_a_field_takes_numbers_up_to_its_greatest(kind: Any, text: str, given: int | None) -> None:
    with pytest.raises(WorkError) if given is None else nullcontext():
        assert scopes._given("field", kind, text) == given


def test_a_routine_has_its_name_or_its_address(program: str) -> None:
    monitor, _ = Launch.of({"program": [program]}).ready(lambda line: None)
    debuggee: Any = SimpleNamespace(monitor=monitor)
    names = [scopes._routine(debuggee, entry) for entry in (None, 0, 0o300, 0o17)]
    assert names == ["main program", "interrupt", "SUB", "0017"]


@pytest.mark.parametrize(("line", "reasons"), [(3, ["breakpoint"]), (5, [])])
def test_a_breakpoint_set_while_the_machine_runs_stops_it(
    line: int, reasons: list[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    turns = cycle([False, True])
    monkeypatch.setattr(wire.Wire, "holds", property(lambda self: next(turns)))
    path = tmp_path / "turns.pal"
    path.write_text("*200\n\tCLA\n\tIAC\n\tJMP .-1\n\tHLT\n$\n")
    points = {"source": {"path": str(path)}, "breakpoints": [{"line": line}]}
    begun: tuple[str, dict[str, Any]] = ("configurationDone", {})
    heard = held(("launch", {"program": str(path)}), begun, ("setBreakpoints", points), ("threads", {}))
    assert [each["body"]["reason"] for each in heard if each.get("event") == "stopped"] == reasons


def test_a_breakpoint_of_an_instruction_and_one_asked_for_twice(program: str) -> None:
    def placed(answer: dict[str, Any]) -> list[Any]:
        return [
            (each["id"], each.get("instructionReference", each.get("message")))
            for each in answer["breakpoints"]
        ]

    places: list[dict[str, Any]] = [
        {"instructionReference": "0x0100"}, {"instructionReference": "0x0100", "offset": 2},
        {"instructionReference": "0x0101"},
    ]  # fmt: skip
    source = {"path": program}
    instructions, names, lines, none = asked(
        program,
        ("setInstructionBreakpoints", {"breakpoints": places}),
        ("setFunctionBreakpoints", {"breakpoints": [{"name": "SUB"}, {"name": "SUB"}]}),
        ("setBreakpoints", {"source": source, "breakpoints": [{"line": 2}]}),
        ("setBreakpoints", {"source": source}),
    )
    wanted = [(1, "0x0100"), (2, "0x0102"), (3, "0x0101: no word begins at byte 101")]
    assert placed(instructions) == wanted
    assert placed(names) == [(4, "0x0180")] * 2
    assert (placed(lines), placed(none)) == ([(5, "0x0100")], [])


def test_breakpoints_in_the_listing_of_a_tape(program: str, tmp_path: Path) -> None:
    tape = tmp_path / "own.bin"
    tape.write_bytes(binary.encode({0o200: 0o7402}))
    of: list[dict[str, Any]] = [{"sourceReference": 1}, {"sourceReference": 2}, {"path": str(tape)}]
    points = [("setBreakpoints", {"source": each, "breakpoints": [{"line": 1}]}) for each in of]
    answers = [*asked(str(tape), *points), *asked(program, points[0])]
    assert [each["breakpoints"][0]["verified"] for each in answers] == [True, False, False, False]


def test_where_the_program_has_no_word_there_is_no_line(program: str) -> None:
    _, stack, whole, beyond = asked(
        program,
        ("setVariable", {"variablesReference": 1, "name": "PC", "value": "7000"}),
        ("stackTrace", {"threadId": 1, "startFrame": None, "levels": None}),
        ("stackTrace", {"threadId": 1, "levels": 0}),
        ("stackTrace", {"threadId": 1, "startFrame": 1}),
    )
    place = {"instructionPointerReference": "0x1c00", "line": 0, "column": 0}
    assert stack["stackFrames"] == [{"id": 0, "name": "7000  main program", **place}]
    assert (whole, beyond["stackFrames"]) == (stack, [])


def test_the_parts_have_the_numbers_from_100_on(program: str) -> None:
    count = len([*walk(Machine().parts())])
    *parts, none, field = asked(
        program,
        *(("variables", {"variablesReference": 100 + number}) for number in range(count + 1)),
        ("setVariable", {"variablesReference": 100, "name": "nothing", "value": "1"}),
    )
    shown = [each["name"] for part in parts for each in part["variables"]]
    assert "clock" in shown
    assert "core" not in shown
    assert none == f"{100 + count}: no scope has this number"
    assert field == "nothing cannot be set"


def test_what_is_no_expression_is_a_command_at_the_console_only(program: str) -> None:
    empty, hovered, entered, restarted, sr = asked(
        program,
        ("evaluate", {"expression": " "}),
        ("evaluate", {"expression": "nix"}),
        console("nix"),
        ("restart", {"arguments": {"program": program, "sr": "1234"}}),
        ("evaluate", {"expression": "SR"}),
    )
    assert empty == "a register, a symbol or an address expected"
    assert hovered == "nix: neither a register nor a symbol of the program"
    assert entered == "'nix': no such command; help tells which there are"
    assert (restarted, sr["result"]) == (None, "1234")


def test_a_source_is_known_by_each_way_to_it(tmp_path: Path) -> None:
    (tmp_path / "own.pal").write_text("*200\n\tHLT\n$\n")
    (tmp_path / "way").symlink_to(tmp_path, target_is_directory=True)
    places = Places(shelf.program(str(tmp_path / "own.pal")))
    for path, known in (("own.pal", True), ("way/own.pal", True), ("other.pal", False)):
        assert places.is_of({"path": str(tmp_path / path)}) == known, path
