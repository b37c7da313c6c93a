"""Tapes as they are: of several sections, with labels, damaged; through every way of loading them."""

import re
from pathlib import Path

import pytest

import pal
from pdp8 import shelf
from pdp8.computer.hardware.core import Core
from pdp8.computer.past import state
from pdp8.console.opening import opening
from pdp8.dap.breakpoints import Breakpoints
from pdp8.dap.debuggee import Debuggee
from pdp8.dap.launch import Launch
from tapes import binary, rim
from tests.conftest import Call, case

FIRST = {0o200: 0o7001, 0o201: 0o7402}
SECOND = {0o300: 0o1234, 0o301: 0o4321}
BOTH = FIRST | SECOND
SECTIONS = binary.encode(FIRST) + binary.encode(SECOND)
LABEL = bytes(8) + bytes([0o265, 0o011, 0o377, 0o001, 0, 0o176, 0o101, 0o101, 0o076])
BAD = binary.encode(BOTH).replace(b"\x38\x01", b"\x3a\x01")
"""Its first word is 7201; the checksum is in frame 76."""

BODY, GROUPS = (tape.strip(b"\200") for tape in (binary.encode(FIRST), rim.encode(FIRST)))
LEADER, TITLE = bytes([0o200]) * 32, b"\xc8\xc5\xcc\xcc\xcf\x8d\x8a"
FOUND = {  # on people's disks, and what is said of each
    BODY + LEADER: "no leader",
    bytes(40) + BODY + bytes(40): "40 blank frames instead of leader, passed over",
    TITLE + LEADER + BODY + LEADER: "a label of 7 frames from frame 0 on, left out",
    LEADER + TITLE + LEADER + BODY + LEADER: "a label of 7 frames from frame 32 on, left out",
    LEADER + BODY + LEADER + b"\x15": "a label of 1 frame from frame 72 on, left out",
    GROUPS: "no leader",
    bytes(20) + GROUPS + bytes(20): "20 blank frames instead of leader, passed over",
    b"102\r\n000\r\n070\r\n001\r\n074\r\n002\r\n103\r\n000\r\n000\r\n000\r\n": "octal frames, one a line",
    b"@080 // start\nE01\nf02\n": "read as Verilog's $readmemh",
    b"EP:080\n080:E01\n081:f02\n": "read as EP, entry point and hexadecimal words; it starts at 0200",
    b"\xef\xbb\xbf0200 7001\r\n\r\n0201 7402\r\n": "read as octal addresses and words",
    b"; a script\nd 200 7001\ndep 201 7402\ngo 200\n": "read as deposits of a SIMH script",
    (LEADER + BODY).hex(" ").encode(): "a dump in hexadecimal, read as 40 frames",
}
TAPES = {  # what is on it, what goes into core, and what is said of it
    "labels": (LABEL + bytes(8) + SECTIONS + LABEL, BOTH, "a label of 9 frames from frame 8 on, left out"),
    "rim": (rim.encode(FIRST) + LABEL, FIRST, "a label of 9 frames from frame 144 on, left out"),
    "apart": (
        SECTIONS + bytes.fromhex("007f09090100") + SECTIONS,
        BOTH,
        f"after the label, from frame {len(SECTIONS) + 6} on, a good section: a tape of its own, left out",
    ),
}


def loaded(call: Call, tape: bytes, way: str, force: bool = False) -> tuple[int, str]:
    """Load x.bin by `run` or in the monitor, save the machine as x; return the status and what is said."""
    Path("x.bin").write_bytes(tape)
    if way.startswith("run"):
        status, shown, said = call(f"pdp8 {way} x.bin {'--force' * force} --save x")
    else:
        status, shown, said = call("pdp8 monitor -", f"{way} x.bin {'force' * force}\nsave x\n".encode())
    return status, shown + said


def at_the_debugger(*boot: str) -> tuple[Core | list[int], str]:
    said: list[str] = []
    monitor, program = Launch.of({"program": "x.bin", "boot": bool(boot)}).ready(said.append)
    return monitor.machine.core, " ".join((*said, *program.notes))


def at_the_panel(*cold: str) -> tuple[Core | list[int], str]:
    session, _ = opening("x.bin", cold=bool(cold))
    if cold:
        loader, tape, *_ = session.tapes
        assert list(session.operator.boot(loader.frames, tape.frames))
    return session.machine.core, session.said


def by_command(call: Call, line: str) -> tuple[Core | list[int], str]:
    status, shown, said = call(line)
    assert status == 0
    words = (
        pal.assemble(shown).words if "dis" in line else rim.decode(shown.encode("utf-8", "surrogateescape"))
    )
    return [words.get(address, 0) for address in range(0o10000)], said


def in_the_machine(call: Call, tape: bytes, way: str) -> tuple[Core | list[int], str]:
    status, said = loaded(call, tape, way)
    assert status == 0
    return state.restore(Path("x").read_text()).core, said


def test_a_start_without_a_word_is_said_by_all_who_start_a_program(call: Call) -> None:
    Path("x.bin").write_bytes(binary.encode({0o400: 0o7402}))
    debuggee = Debuggee(Launch.of({"program": "x.bin"}), Breakpoints())
    for said in (call("pdp8 run x.bin")[2], " ".join(debuggee.said), at_the_panel()[1]):
        assert "x.bin: no word at 0200, where it is started; it has 0400, and " in said


def test_every_way_takes_a_program_of_field_1_where_there_is_one(call: Call) -> None:
    """As source, on two tapes, and as a tape: by `run`, the monitor, the debugger and the panel."""
    first, second = "*200\nHLT\n", "FIELD 1\n*300\n1234\n$\n"
    for name, content in (("a.pal", first), ("b.pal", second), ("x.pal", first + second)):
        Path(name).write_text(content)
    assert call("pdp8 pal x.pal -o x.bin")[0] == 0
    wanted = {0o200: 0o7402, 0o10300: 0o1234}
    for names in (["x.pal"], ["x.bin"], ["a.pal", "b.pal"]):
        monitor, _ = Launch.of({"program": names, "memory": "8k"}).ready(print)
        cores: list[Core | list[int]] = [monitor.machine.core]
        if len(names) == 1:
            cores.append(opening(names[0], memory=0o20000)[0].machine.core)
            for line, typed in (
                (f"pdp8 run {names[0]} --memory 8k --save x", ""),
                ("pdp8 monitor -", f"set cpu 8k\nload {names[0]}\nsave x\n"),
            ):
                assert call(line, typed.encode())[0] == 0
                cores.append(state.restore(Path("x").read_text()).core)
        for core in cores:
            assert {address: word for address, word in enumerate(core) if word} == wanted


@pytest.mark.parametrize("tape", FOUND, ids=FOUND.values())
def test_every_command_reads_it(tape: bytes, call: Call) -> None:
    Path("x.bin").write_bytes(tape)
    for way in (
        "run",
        "run --boot",
        "load",
        "boot",
        "dap",
        "dap boot",
        "panel",
        "panel --cold",
        "dis",
        "convert",
    ):
        name, *more = way.split()
        if name == "dap":
            core, said = at_the_debugger(*more)
        elif name == "panel":
            core, said = at_the_panel(*more)
        elif name in ("dis", "convert"):
            core, said = by_command(call, f"pdp8 {way.replace('convert', 'tape convert --to rim')} x.bin")
        else:
            core, said = in_the_machine(call, tape, way)
        with case(way, said):
            assert {address: core[address] for address in FIRST} == FIRST
            assert FOUND[tape] in said
    assert re.search("tape +(BIN|RIM)", call("pdp8 tape info x.bin")[1])


@pytest.mark.parametrize("way", ["run", "run --boot", "load", "boot"])
@pytest.mark.parametrize("name", TAPES)
def test_all_of_a_tape_goes_into_core(name: str, way: str, call: Call) -> None:
    tape, words, noted = TAPES[name]
    status, said = loaded(call, tape, way)
    assert (status, noted in said) == (0, True), said
    core = state.restore(Path("x").read_text()).core
    assert {address: core[address] for address in words} == words
    if (name, way) == ("labels", "run --boot"):
        for step in (
            "pdp8 run: RIM loader toggled in: 18 keys",
            "pdp8 run: x.bin read by BIN: 209 frames, 2 sections, 4 words; 20.9 s",
            "pdp8 run: loaded in 1 min 10.1 s of tape; switches and keys not counted",
        ):
            assert step in said.splitlines()


@pytest.mark.parametrize("way", ["run", "run --boot", "load", "boot"])
def test_a_damaged_tape_stops_it_unless_forced(way: str, call: Call) -> None:
    status, said = loaded(call, BAD, way)
    assert (status, "checksum" in said) == (1, True), said
    status, said = loaded(call, BAD, way, force=True)
    assert (status, "x.bin: frame 76: checksum" in said) == (0, True), said
    if way.startswith("run"):
        assert "x.bin: frame 76: checksum" in loaded(call, BAD, f"{way} --quiet", force=True)[1]
    assert state.restore(Path("x").read_text()).core[0o200] == 0o7201


def test_the_loader_judges_a_damaged_tape(call: Call) -> None:
    said = loaded(call, BAD, "run --boot")[1]
    assert "x.bin: the BIN loader halted with AC = 0002 after 79 frames: wrong checksum" in said
    said = loaded(call, binary.encode(BOTH)[:74], "run --boot")[1]
    assert "x.bin: the BIN loader ended with tape out at" in said
    instead_of_ksf = {0o7757: 0o2010}  # ISZ 10: the RIM loader reads for ever
    status, said = loaded(call, rim.encode({0o200: 0o7402, 0o300: 1} | instead_of_ksf), "run --boot")
    assert status == 1
    assert "x.bin: the RIM loader did not end within 1 min" in said
    assert "; STOP was pressed at 77" in said


def test_another_loader(call: Call, tmp_path: Path) -> None:
    words = pal.assemble(shelf.read_bundled("bin.pal")).words
    (tmp_path / "bin.pal").write_text("nonsense\n")  # is not taken for the bundled one
    (tmp_path / "ours.rim").write_bytes(rim.encode(words))
    (tmp_path / "halts.rim").write_bytes(rim.encode({0o7777: 0o7402}))
    for loader, loads in (("", True), ("--loader ours.rim", True), ("--loader halts.rim", False)):
        assert ("HLT at 0201" in loaded(call, SECTIONS, f"run --boot {loader}")[1]) == loads


LATE = "*200\n\tTLS\n\tTSF\n\tJMP .-1\n\tKCC\nL,\tKSF\n\tJMP .-1\n\tKRB\n\tTLS\n\tJMP L\n$\n"
"""Clears the reader only when a character is typed, as PAL III does: READER RUN is set since START."""
COUNTS = "*200\n\tISZ 10\n\tJMP .-1\n\tISZ 11\n\tJMP .-3\n\tHLT\n$\n"
"""For 80 s, and asks for nothing."""
ASKS = "*200\nL,\tKSF\n\tJMP .-1\n\tKRB\n\tTLS\n\tJMP L\n$\n"


@pytest.mark.parametrize(
    ("source", "leader", "warned", "punched"),
    [
        (LATE, 0, True, "\0BC"),
        (LATE, 3, False, "\0\0\0ABC\0\0\0"),
        ("*200\n\tHLT\n$\n", 0, True, ""),
        ("*200\n\tHLT\n$\n", 3, False, ""),
        (COUNTS, 0, True, ""),
        (ASKS, 0, False, "ABC"),
    ],
)
def test_a_first_frame_that_may_be_lost_is_named(
    call: Call, tmp_path: Path, source: str, leader: int, warned: bool, punched: str
) -> None:
    (tmp_path / "p.pal").write_text(source)
    (tmp_path / "abc.asc").write_bytes(bytes(leader) + b"ABC" + bytes(leader))
    _, shown, said = call("pdp8 run p.pal --reader abc.asc")
    assert said.count("the first frame of abc.asc came in with START") == warned
    assert shown.replace("\0\0\0\0", "\0\0\0") == punched
    assert "first frame" not in call("pdp8 run p.pal --reader abc.asc --quiet")[2]
