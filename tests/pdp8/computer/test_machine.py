"""The machine as a whole: what may be looked at and set, and that nothing an operator does makes it raise."""

import sys
from importlib.metadata import version

import pytest

import pdp8
from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.fields import all_fields, take
from pdp8.computer.hardware.highspeed import PunchControl, ReaderControl
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import NEVER
from pdp8.computer.hardware.teletype import Receiver, Transmitter
from pdp8.computer.machine import Machine
from pdp8.computer.speed.waiting import Waiting
from tests import commands
from tests.pdp8.computer.bench import octal, program


def test_the_calls_of_the_readme() -> None:
    m = pdp8.Machine()
    m.load({0o200: 0o6036, 0o201: 0o6046, 0o202: 0o7402})
    m.start(0o200)
    m.teletype.reader.load(b"\301")
    stop = m.run(seconds=5, instructions=100)
    assert stop == ("halt", 0o203, (85 + 85 + 32) / 20e6)
    assert m.teletype.punch.tape == b"\0"  # KRB came before PRESET


def test_registers_are_words() -> None:
    m = Machine()
    given_and_held = {
        "ac": (0o17777, 0o7777),
        "link": (3, 1),
        "pc": (0o10200, 0o200),
        "ma": (-1, 0o7777),
        "mb": (0o12345, 0o2345),
        "ir": (0o17, 7),
        "sr": (0o70001, 0o1),
    }
    for name, (value, held) in given_and_held.items():
        setattr(m, name, value)
        assert getattr(m, name) == held
    assert (m.ac, m.link) == (0o7777, 1)
    m.ac = 0
    assert m.link == 1
    m.core[0o200] = 0o12345
    assert m.core[0o200] == 0o2345
    assert len(m.core) == len(list(m.core)) == 4096


def test_all_is_0_at_power_up_but_few_things_and_initialize_leaves_it_so() -> None:
    bus = Bus()
    p = Processor(bus)
    devices = {"03": Receiver(), "04": Transmitter(), "01": ReaderControl(), "02": PunchControl()}
    parts = all_fields([("p", p), ("bus", bus), ("waiting", Waiting(p)), *devices.items()])
    made = take(parts)
    assert {name: value for name, value in made.items() if value not in (0, b"", NEVER)} == {
        **{"03 reader_run": 1, "03 line": 0o3777, "03 reader on": True, "04 mark": 1, "04 punch on": True},
        **{"01 reader on": True, "02 punch on": True},
        **{"waiting tries": 8, "waiting core": None, "waiting left clock": -1},
    }
    assert [name for name, value in made.items() if value == NEVER] == [
        *("waiting quiet_until", "03 due", "03 step", "03 edge", "04 due", "01 due", "02 due"),
    ]
    p.initialize()
    for device in devices.values():
        device.initialize(0)
    assert take(parts) == made | {"bus actions": 1}


@pytest.mark.parametrize("address", [-1, 0o10000])
def test_there_is_no_core_beyond_7777(address: int) -> None:
    with pytest.raises(IndexError, match="0000 to 7777"):
        Machine().core[address]
    with pytest.raises(IndexError):
        Machine().core[address] = 0


def test_start_counts_time_from_zero_and_switches_stay() -> None:
    m = program(*octal("7604 7402"))
    m.sr = 0o1234
    m.run()
    assert (m.ac, m.ticks) == (0o1234, 64)
    m.run(instructions=1)
    m.start(0o200)
    assert (m.ac, m.ticks, m.sr) == (0, 0, 0o1234)


def test_signatures_of_an_8l() -> None:
    # Kermit-12: 7354 is 3776 on an 8/I or 8/L; 7601 clears on an 8/I and does nothing on an 8/L.
    m = program(*octal("7354 7402"))
    m.run()
    assert m.ac == 0o3776
    m = program(*octal("7240 7601 7402"))
    m.run()
    assert m.ac == 0o7777


def test_waiting_time_passes_for_the_teletype() -> None:
    m = program(*octal("6046 7402 6041 5202 7402"))
    m.run()
    m.wait(0.2)
    before = m.ticks
    assert m.run().reason == "halt"
    assert m.ticks - before == 85 + 32


@pytest.mark.parametrize("breakpoints", [set(), {0o7000}])
def test_short_runs_find_an_endless_loop_too(breakpoints: set[int]) -> None:
    machine = Machine()
    machine.load({0o200: 0o7001, 0o201: 0o7041, 0o202: 0o7041, 0o203: 0o5201})
    machine.watch.breakpoints |= breakpoints
    machine.start(0o200)
    reasons = {machine.run(seconds=0.005).reason for _ in range(20)}
    assert reasons == {"limit", "idle"}


def test_a_breakpoint_in_a_waiting_loop_stops_every_turn() -> None:
    machine = Machine()
    machine.load({0o200: 0o6031, 0o201: 0o5200})
    machine.watch.breakpoints.add(0o200)
    machine.teletype.reader.load(b"\301")
    machine.start(0o200)
    ticks = []
    for _ in range(5):
        assert machine.run().reason == "breakpoint"
        ticks.append(machine.ticks)
    assert ticks == [117, 234, 351, 468, 585]


@pytest.mark.parametrize("seconds", [-5.0, -1e-9, float("nan"), float("-inf")])
def test_no_time_is_less_than_nothing(seconds: float) -> None:
    machine = program(*octal("7001 5200"))
    for act in (machine.wait, machine.run, lambda seconds: next(machine.slices(seconds))):
        with pytest.raises(ValueError, match="seconds: 0 or more is allowed"):
            act(seconds)
    with pytest.raises(ValueError, match="a limit of -1 instructions: 0 or more is allowed"):
        machine.run(instructions=-1)
    assert (machine.ticks, machine.instructions) == (0, 0)


def test_a_time_without_end_is_one_of_31_years() -> None:
    assert program(*octal("7402")).run(seconds=float("inf")).reason == "halt"


def test_load_and_core_take_a_word_in_the_same_way() -> None:
    loaded, deposited = Machine(), Machine()
    for word in (0o12345, -1, 0o7777, 1 << 40):
        loaded.load({0o200: word})
        deposited.core[0o200] = word
        assert loaded.core[0o200] == deposited.core[0o200] == word % 0o10000


def test_core_in_slices() -> None:
    core = Machine().core
    core[0o200:0o204] = [1, 2, 3, 0o10004]
    assert core[0o177:0o205] == [0, 1, 2, 3, 4, 0]
    assert core[0o7776:] == [0, 0]
    assert core[0o200:0o204:2] == [1, 3]
    assert len(core[:]) == 4096
    for words in ([1], [1, 2, 3]):
        with pytest.raises(ValueError, match=f"{len(words)} words for 2 addresses"):
            core[0:2] = words
    for bounds in (slice(-1, None), slice(0, 0o10001), slice(0o20000, None)):
        with pytest.raises(IndexError, match="0000 to 7777"):
            core[bounds]
    assert core[0] == 0


@pytest.mark.parametrize("sing_step", [False, True])
def test_start_is_load_add_and_start_at_the_panel(sing_step: bool) -> None:
    called, pressed = Machine(), Machine()
    for m in (called, pressed):
        m.load({0o200: 0o1250, 0o250: 0o1111})
        m.panel.sing_step = sing_step
    called.start(0o200)
    pressed.sr = 0o200
    pressed.panel.load_add()
    pressed.panel.start()
    assert called.panel.lamps == pressed.panel.lamps
    assert (called.pc, called.ticks, called.ma) == (pressed.pc, pressed.ticks, 0o200)
    assert called.panel.lamps.run == (not sing_step)
    assert called.sr == 0


def test_repr_says_where_it_stands() -> None:
    machine = program(*octal("7001 7402"))
    assert repr(machine) == "<Machine at 0200: L 0 AC 0000, running, 0.000000 s>"
    machine.run()
    assert repr(machine) == "<Machine at 0202: L 0 AC 0001, stopped, 0.000003 s>"


def test_the_names_of_the_package() -> None:
    assert {"Machine", "Stop", "__version__"} <= set(dir(pdp8))
    assert pdp8.__version__ == version("pdp8")
    with pytest.raises(AttributeError, match="no attribute 'Mill'"):
        pdp8.Mill  # noqa: B018
    done = commands.run(sys.executable, "-m", "pdp8", "--version")
    assert done.stdout.decode().startswith(f"pdp8, version {pdp8.__version__}, ")
