"""What the commands do that a session does not show."""

from pathlib import Path
from typing import Any

import pytest

from pdp8.computer.hardware.bus import Peripheral
from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.hardware.signals import TICKS_PER_SECOND
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.monitor import commands, rack
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.commands import find
from pdp8.monitor.prompt import Monitor
from tapes import rim
from tests.pdp8.monitor import do

pytestmark = pytest.mark.usefixtures("here")


def test_a_tape_in_the_high_speed_reader_and_one_off_the_punch() -> None:
    """RFC; RSF; JMP .-1; RRB; PLS; HLT (the user's handbook) copies the first frame of hello.pal, its `*`."""
    monitor = Monitor(lambda line: None, Machine(one_of_each()))
    for line in ("deposit 200 6014 6011 5201 6012 6026 7402", "fast-reader hello.pal", "go 200 1", "wait 1"):
        do(monitor, line)
    do(monitor, "fast-punch x")
    assert Path("x").read_bytes() == b"*"


def test_a_command_may_be_shortened() -> None:
    names = {
        "b": "boot", "s": "step", "c": "cont", "d": "deposit", "g": "go", "e": "examine", "ex": "examine",
        "l": "load", "w": "watch", "SE": "set",
    }  # fmt: skip
    assert {word: find(word).name for word in names} == names


def test_what_ctrl_c_sets_is_the_stop_key_once() -> None:
    """It is set as the second tape goes in."""
    said: list[str] = []

    def say(line: str) -> None:
        said.append(line)
        made.stopping = line.endswith("goes into the reader")

    made = Monitor(say)
    Path("a").write_bytes(b"\x81" * 20)
    do(made, "deposit 200 6031 5200 6036 5200", "reader a a", "go 200")
    assert said[-1].startswith("stop key; ")
    do(made, "cont")
    assert said[-1].startswith("waits for a tape; ")
    for line in ("go 300 3", "step 4"):
        made.stopping = True  # before the run: it ends none
        before = len(said)
        do(made, "deposit 300 2310 5300 5300", line)
        assert not said[-1].startswith("stop key; ")
    assert len(said) - before == 4


def test_all_points_of_all_fields_are_forgotten_and_those_of_a_field_that_is_taken_out() -> None:
    said: list[str] = []
    points = "set cpu 8k", "break 10000 7777", "watch 10300"
    do(Monitor(said.append), *points, "forget", "break", "watch", *points, "set cpu 4k", "break", "watch")
    assert said == ["none", "none", "not watched any more, beyond 7777: 10000, 10300", "7777", "none"]


def test_a_traced_step_is_the_last_after_ctrl_c_and_the_last_line_of_a_script() -> None:
    said: list[str] = []

    def say(line: str) -> None:
        said.append(line)
        made.stopping = len(said) in (2, 4)
        assert len(said) < 9

    made = Monitor(say)
    do(made, "step 5")
    assert len(said) == 2
    do(made, "deposit 0:40 7000", "set sing_step 1")
    Path("loop").write_text(":L\nstep\ngoto L\n")
    with pytest.raises(MonitorError, match="loop, line 2: stopped"):
        do(made, "do loop")
    assert len(said) == 4
    do(made, "step 3")
    assert len(said) == 7


def test_a_wait_is_ended_by_ctrl_c_and_the_next_is_not() -> None:
    def say(line: str) -> None:
        made.stopping = made.stopping or line.endswith("goes into the reader")

    made = Monitor(say)
    Path("a").write_bytes(b"\x81" * 20)
    do(made, "deposit 200 6031 5200 6036 5200", "reader a a", "go 200 0.1", "wait 60")
    assert made.stopping
    assert made.machine.elapsed < 10
    before = made.machine.ticks
    do(made, "wait 1")
    assert made.machine.ticks - before == TICKS_PER_SECOND


def test_a_tape_out_of_the_high_speed_reader_leaves_those_of_the_teletype() -> None:
    monitor = Monitor(lambda line: None, Machine(one_of_each()))
    for name, waits in (("ptr", ["ellipse.asc"]), ("tti", [])):
        do(monitor, "reader circle.asc ellipse.asc", "attach ptr eia.bin", f"detach {name}")
        assert monitor.machine.highspeed.reader.loaded == (name == "tti")
        assert monitor.waiting_tapes == waits


def test_a_second_reader_command_takes_the_place_of_the_first() -> None:
    monitor = Monitor(lambda line: None, Machine())
    for name in "abc":
        Path(name).write_bytes(b"\x80x")
    do(monitor, "reader a b")
    assert monitor.waiting_tapes == ["b"]
    do(monitor, "reader c")
    assert monitor.waiting_tapes == []


def test_tapes_that_went_in_wait_again_after_back() -> None:
    monitor = Monitor(lambda line: None, Machine())
    for name, frames in zip("abc", (b"\x80\x81", b"\x82\x83", b"\x84\x85"), strict=True):
        Path(name).write_bytes(frames)
    do(monitor, "deposit 200 6031 5200 6036 6046 5200", "reader a b c", "go 200 3")
    for count in (1, 2, 3, 4, 5):
        do(monitor, f"back {count} characters", "cont 3")
        assert monitor.machine.teletype.punch.tape == b"\x80\x81\x82\x83\x84\x85"
        assert monitor.waiting_tapes == []


def test_a_session_keeps_its_settings_with_another_machine_or_device() -> None:
    """After `restore` and `set cpu` page and time are the other machine's; a device fitted leaves these."""
    said: list[str] = []
    monitor = Monitor(said.append)
    do(monitor, "load hello.pal", "set hands 0.5", "break 205", "watch 300", "save s")
    do(monitor, "go 200 3", "forget 205")
    monitor.machine.teletype.printer.on_frame = print

    def kept() -> list[object]:
        machine, watch = monitor.machine, monitor.machine.watch
        own = [monitor.operator.pace, monitor.listing, monitor.dialect, machine.teletype.printer.on_frame]
        return [*own, watch.breakpoints, watch.writes]

    before = kept()
    do(monitor, "page", "set df enabled", "page more")
    assert (said[-1], kept()) == ("", before)
    assert monitor.machine.elapsed > 1
    do(monitor, "set cpu 32k")
    assert monitor.shown == len(monitor.machine.teletype.printer.frames)
    for line in ("set cpu 8k", "set cpu 4k", "restore s"):
        do(monitor, line, "page more")
        assert (said[-1], kept()) == ("", before), line
    do(monitor, "go 200 3", "save printed")
    other = Monitor(said.append)
    other.machine.teletype.printer.frames.extend(b"OTHER")
    for line in ("page more", "restore printed", "page more"):
        do(other, line)
    assert "HELLO, WORLD." in said[-3:]


@pytest.mark.parametrize("kind", rack.RACK)
def test_what_a_device_does_that_was_fitted_on_the_way_is_undone(kind: str, monitor: Monitor) -> None:
    do(monitor, "load hello.pal", "go 200 0.1", f"set {kind} enabled", "step 2")
    device: Any = monitor.machine.devices[-1]
    device.flag = 1
    do(monitor, "step 2", "back 3")
    assert device.flag == 0


RUNS = {
    **dict.fromkeys(("cont", "run", "wait"), ".3"),
    **dict.fromkeys(("until", "expect"), "A 1"),
    **{
        "go": "200 .3",
        "boot": "hello.pal",
        "type": "A",
        "send": "A",
        "keyboard": '"A"',
        "step": "5",
        "cycle": "5",
    },
}


def test_whatever_lets_the_machine_run_is_counted(monitor: Monitor, said: list[str]) -> None:
    """Every instruction of it; each of the program takes one cycle, but those of the loaders."""
    assert {*commands._RUNS} <= RUNS.keys()
    for name, words in RUNS.items():
        do(
            monitor,
            "deposit 200 6031 5200 6036 6046 5200",
            "go 200 .1",
            "keyboard now AB",
            "cont .1",
            "count on",
        )
        before, page = monitor.machine.instructions, monitor.machine.teletype.printer.frames
        page.append(0o332)
        printed = len(page)
        do(monitor, f"{name} {words}", "count")
        assert monitor.expected >= printed or name in ("wait", "expect"), "what was printed before it"
        found = next(line for line in reversed(said) if " instructions, " in line)
        assert found.startswith(f"{monitor.machine.instructions - before:,} instructions"), name
        assert monitor.machine.instructions > before
    assert "undone" not in found
    do(monitor, "back", "count")
    assert any(line.endswith(", with what was undone") for line in said)


def test_a_trace_has_the_listing_of_what_is_loaded_after_it(monitor: Monitor, said: list[str]) -> None:
    do(monitor, "trace on", "load hello.pal", "go 200 0.000001")
    assert "START,  CLA CLL" in said[-2]


def test_who_counts_the_run_counts_on_beside_the_monitor(monitor: Monitor) -> None:
    with monitor.machine.count() as count:
        do(monitor, "step", "count on", "step", "count off", "step", "count")
    assert count.instructions == 3


def test_no_field_is_left_that_is_taken_out(monitor: Monitor) -> None:
    extension = monitor.machine.processor.extension
    fields = [name for name, kind in extension.fields.items() if kind == "70000"]
    do(monitor, "set cpu 32k")
    for name in fields:
        setattr(monitor.machine.processor.extension, name, 0o70000)
    do(monitor, "set cpu 8k", "key load_add")
    assert {getattr(monitor.machine.processor.extension, name) for name in fields} == {0o10000}


@pytest.mark.parametrize("devices", [[Teletype()], one_of_each()])
def test_a_loader_is_where_it_is_said_to_be(devices: list[Peripheral], said: list[str]) -> None:
    """Whatever runs, and wherever lever and switches are: `boot` sets them, RIM goes by the fields."""
    monitor = Monitor(said.append, Machine(devices))
    Path("rim").write_bytes(rim.encode({0o200: 0o7402}))
    so = "deposit 0 5000", "go 0 .1", "set mem_prot 1", "set inst_field 1", "set data_field 1", "reader stop"
    do(monitor, "set cpu 8k", *so, "boot hello.pal", "assert 205 7402")
    assert all("not in core" not in line for line in said)
    do(monitor, *so, "rim", "reader start", "attach ptr rim", "boot ptr0", "assert 10200 7402")
    assert said.count("RIM loader in 17756-17776, 18 keys") == 2
    with pytest.raises(MonitorError, match="MEM PROT is up: 7756 holds 0000"):
        do(monitor, *so, "deposit 7756 0", "set inst_field 0", "rim")


def test_what_is_shown_and_expected_is_what_is_new() -> None:
    said: list[str] = []
    monitor = Monitor(said.append, Machine())
    monitor.machine.teletype.printer.frames.extend(b"XAXB")
    for line in ("page", "page more", "expect XA", "page more"):
        do(monitor, line)
    assert said == ["XAXB", "", ""]
    with pytest.raises(MonitorError, match="'XA' was not printed"):
        do(monitor, "expect XA --from-start")
    with pytest.raises(MonitorError, match="'XB' was not printed"):
        do(monitor, "go 200 0", "expect XB 0")
    do(monitor, "expect XB --from-start")
    monitor.machine.teletype.printer.frames.extend(b"C")
    do(monitor, "page more")
    do(monitor, "back 0 seconds")
    del monitor.machine.teletype.printer.frames[1:]
    do(monitor, "back 0 seconds")
    assert all(value < 2 for value in vars(monitor).values() if isinstance(value, int)), "places on the page"
    monitor.machine.teletype.printer.frames.extend(b"D")
    do(monitor, "page more")
    assert said[-1] == "D"


def test_with_sing_step_a_run_until_a_text_is_printed_is_not_content_with_a_cycle() -> None:
    made = Monitor(lambda line: None)
    do(made, "set sing_step 1", "deposit 200 7001 5200", "go 200")
    with pytest.raises(MonitorError, match="'X' was not printed"):
        do(made, "go 200 until X 0.1")
