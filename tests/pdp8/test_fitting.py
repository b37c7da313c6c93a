"""A device in a file of anybody's: the clock of docs/pdp8.md, fitted, saved, restored; what is refused."""

import copy
import json
import re
from io import BytesIO
from pathlib import Path

import pytest

from pdp8 import fitting
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.computer.use import program
from pdp8.dap.breakpoints import Breakpoints
from pdp8.dap.debuggee import Debuggee, Halt
from pdp8.dap.launch import Launch
from pdp8.dap.session import Session
from pdp8.monitor.arguments import MonitorError
from pdp8.web import translator
from pdp8.web.translator.modules import translate
from tests.conftest import Call
from tests.pdp8.dap.test_wire import framed, spoken
from tests.pdp8.monitor import do
from tests.pdp8.web.node import in_node, needs_node, write
from tests.test_readme import FILE, HOUSE

NEEDED = "devices 13: the state needs a Clock, not a KW8; --device FILE:CLASS fits one"
SECOND = "pdp8 run: HLT at 0207; no frames read, no frames punched; 1.0 s in 1971\n"


@pytest.fixture(autouse=True)
def clock(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder with the files of the recipe."""
    monkeypatch.chdir(tmp_path)
    for name, content in FILE.findall((HOUSE / "docs/pdp8.md").read_text()):
        (tmp_path / name).write_text(content)


def test_it_runs_and_a_saved_state_needs_it(call: Call) -> None:
    assert call("pdp8 run --device clock.py:Clock ticks.pal") == (0, "", SECOND)
    call("pdp8 run --device clock.py:Clock ticks.pal --max-time 0.5 --save half.state")
    assert json.loads(Path("half.state").read_text())["devices"]["13"]["device"] == "Clock"
    assert call("pdp8 run --restore half.state") == (1, "", f"pdp8 run: half.state: {NEEDED}\n")
    assert call("pdp8 run --restore half.state --device clock.py:Clock") == (0, "", SECOND)
    without = call("pdp8 run ticks.pal")
    assert "It waits for device 13 at 0202 (WAIT, 6131): no such device is fitted." in without[2]


@pytest.mark.slow("makes a page of its own")
@needs_node
def test_with_one_line_it_comes_with_the_machine_and_the_page_has_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The steps of docs/pdp8.md, in a copy of the sources; the clock counts a second in JavaScript."""
    listed = translator._sources()
    path, text = listed["pdp8.computer.hardware.devices"]
    text = text.replace("HighSpeed(),", "HighSpeed(), Clock(),")
    listed["pdp8.computer.hardware.devices"] = (
        path,
        text.replace("from", "from pdp8.computer.hardware.clock import Clock\nfrom", 1),
    )
    listed["pdp8.computer.hardware.clock"] = ("clock.py", Path("clock.py").read_text())
    made = translate(listed, translator.OMITTED, trusted=translator.TRUSTED)
    write(tmp_path / "page", made)
    machine, clock = Machine(), fitting.devices(["clock.py:Clock"])[0]
    machine.fit(clock())
    machine.load(program.read(Path("ticks.pal").read_bytes(), "ticks.pal").words)
    machine.start(0o200)
    machine.run(seconds=0.5)
    went_on = """async (text) => {
        const { restore } = await import("@/pdp8/computer/past/state.mjs");
        const machine = restore(text);
        const stop = machine.run();
        return [String(stop.reason), stop.pc, machine.processor.clock];
    }"""
    text = state.save(machine)
    assert in_node(went_on, text, tmp_path / "page") == [*machine.run()[:2], machine.processor.clock]


def test_the_monitor_fits_it_restores_it_and_steps_back(call: Call) -> None:
    Path("script").write_text(
        "load ticks.pal\ngo 200 0.5\nsave half.state\nexamine count\nrun 0.4\nback 1000\nrestore half.state\n"
        "examine count\nrun\nassert pc 210\n"
    )
    status, out, said = call("pdp8 monitor script --device clock.py:Clock")
    assert (status, said) == (0, "")
    first, second = [line for line in out.splitlines() if line.startswith("0210")]
    assert first == second
    Path("script").write_text("restore half.state\n")
    assert NEEDED in call("pdp8 monitor script")[2]


def test_a_device_in_place_of_the_fast_reader_is_restored_as_itself() -> None:
    (clock,) = fitting.devices(["clock.py:Clock"])
    clock.CODE = 0o01
    made = Machine()
    made.fit(clock())
    text = state.save(made)
    for again in (state.restore(text, [clock()]), copy.deepcopy(made)):
        assert type(again.bus.device(0o01)) is clock
        assert state.save(again) == text


WRONG = "from pdp8.computer.hardware.bus import Device\n"
BODY = (
    " def advance(self, now): pass\n def initialize(self, now): pass\n"
    " def pulse(self, iop, ac, now): return 0\n"
)
REFUSED = {
    "clock.py": f"clock.py: {', '.join(device.NAME for device in fitting.known())} are devices; your own are",
    "highspeed --device highspeed": "highspeed: HighSpeed has device code 01 too",
    "teletype": "Teletype: device 04 is fitted already",
    "none.py:KW8": "none.py: no such file",
    "ticks.pal:KW8": "ticks.pal: a device is in a Python file, NAME.py",
    "clock.py:KW9": "clock.py: there is no class KW9 in it",
    "wrong.py:Other": "wrong.py: Other is no class derived from Device of pdp8.computer.hardware.bus",
    "clock.py:PERIOD": "clock.py: PERIOD is no class derived from Device of pdp8.computer.hardware.bus",
    "broken.py:X": "broken.py, line 2: ZeroDivisionError: division by zero",
    "syntax.py:X": "syntax.py, line 1: SyntaxError: ",
    "nul.py:X": "nul.py: ",
    "leaves.py:X": "leaves.py, line 1: SystemExit: 3",
    "wrong.py:Bare": "Bare: it has no method pulse, which a device has to have",
    "wrong.py:Half": "Half: it has no method initialize, which a device has to have",
    "wrong.py:Nowhere": "Nowhere: device code 0: 01 to 77 are allowed",
    "wrong.py:Beyond": "Beyond: device code 100: 01 to 77 are allowed",
    "wrong.py:Text": "wrong.py: Text.CODE is '13', not a device code",
    "wrong.py:Text --device wrong.py:Text": "wrong.py: Text.CODE is '13', not a device code",
    "wrong.py:Printer": "Printer: device 04 is fitted already",
    "wrong.py:Asks": "Asks: Asks.__init__() missing 1 required positional argument: 'what'",
    "wrong.py:Forgets": "Forgets: fields names period, and it has no such attribute",
    "wrong.py:Counts": "Counts: its pulse 1 changes seen: pulse 1 only tests",
    "wrong.py:Sets": "Sets: its pulse 1 changes lamps: pulse 1 only tests",
    "clock.py:Clock --device clock.py:Clock": "clock.py:Clock: Clock has device code 13 too",
}


def test_what_is_no_device_is_refused(call: Call) -> None:
    Path("broken.py").write_text("\n1 / 0\n")
    Path("syntax.py").write_text("class :\n")
    Path("nul.py").write_text("\0")
    Path("leaves.py").write_text("raise SystemExit(3)\n")
    Path("wrong.py").write_text(
        f"{WRONG}class Other: pass\nclass Bare(Device):\n CODE = 0o13\n"
        "class Half(Device):\n CODE = 0o13\n"
        " def advance(self, now): pass\n def pulse(self, iop, ac, now): return 0\n"
        f"class Nowhere(Device):\n{BODY}"
        f"class Beyond(Device):\n CODE = 0o100\n{BODY}"
        f"class Text(Device):\n CODE = '13'\n{BODY}"
        f"class Printer(Device):\n CODE = 4\n{BODY}"
        f"class Asks(Device):\n CODE = 0o13\n def __init__(self, what): super().__init__()\n{BODY}"
        "class Counts(Device):\n CODE = 0o13\n fields = {'seen': 9999}\n seen = 0\n"
        f"{BODY[: BODY.rindex('return')]}self.seen += 1; return 0\n"
        "class Sets(Device):\n CODE = 0o13\n fields = {'lamps': '7777'}\n lamps = 0\n"
        f"{BODY[: BODY.rindex('return')]}self.lamps = ac; return 0\n"
        f"class Forgets(Device):\n CODE = 0o13\n fields = {{'period': 1}}\n{BODY}"
    )
    call("pdp8 run hello.pal --save own.state")
    for name, message in REFUSED.items():
        for begun in ("ticks.pal", "--restore own.state"):
            status, out, said = call(f"pdp8 run {begun} --device {name}")
            misuse = "are devices" in message or message.endswith(" too")
            assert (status, out) == (2 if misuse else 1, ""), (name, said)
            assert message in said, (name, said)


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("1 / 0", "clock.py, line {}: ZeroDivisionError: division by zero"),
        (
            "return",
            "a device of your own: its pulse returned no number; 0, SKIP, CLEAR_AC and words are answers",
        ),
    ],
)
def test_an_error_in_a_device_names_its_line(fault: str, said: str, call: Call) -> None:
    """Who debugs it stays at the monitor and in the debugger."""
    clock = Path("clock.py").read_text()
    pulse = "    def pulse(self, iop: int, ac: int, now: int) -> int:\n"
    assert pulse in clock
    Path("clock.py").write_text(clock.replace(pulse, f"{pulse}        if ac == 1:\n            {fault}\n"))
    said = said.format(clock[: clock.index(pulse)].count("\n") + 3)
    Path("own.pal").write_text("*200\n\tCLA IAC\n\t6131\n$\n")
    assert call("pdp8 run --device clock.py:Clock own.pal") == (1, "", f"pdp8 run: {said}\n")
    debuggee = Debuggee(Launch.of({"program": "own.pal", "device": ["clock.py:Clock"]}), Breakpoints())
    with pytest.raises(MonitorError, match=re.escape(said)):
        do(debuggee.monitor, "go 200")
    do(debuggee.monitor, "deposit 201 7402", "go 200", "deposit 201 6131", "set pc 200")
    debuggee.run()
    assert debuggee.advance() == Halt("exception", said)
    asked = {"program": "own.pal", "device": "clock.py:Clock", "stopOnEntry": True}
    told = BytesIO()
    Session(
        BytesIO(
            framed(
                *(
                    {"type": "request", "command": name, "arguments": asked}
                    for name in ("launch", "configurationDone", "next", "next")
                )
            )
        ),
        told,
    ).serve()
    assert spoken(told.getvalue())[-1]["message"] == said


def test_an_error_of_ours_is_not_hidden(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(machine: Machine) -> str:
        raise KeyError("ours")

    monkeypatch.setattr(state, "save", broken)
    with pytest.raises(KeyError, match="ours"):
        call("pdp8 run hello.pal --save a.state")
