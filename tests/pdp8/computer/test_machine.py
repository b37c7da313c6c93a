"""The machine as a whole: what may be looked at and set, and that nothing an operator does makes it raise."""

import re
import sys
from collections.abc import Callable
from importlib.metadata import version
from typing import Any

import pytest

import pdp8
from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.fields import all_fields, take
from pdp8.computer.hardware.highspeed import PunchControl, ReaderControl
from pdp8.computer.hardware.processor import Processor
from pdp8.computer.hardware.signals import NEVER
from pdp8.computer.hardware.teletype import Receiver, Transmitter
from pdp8.computer.machine import LoadError, Machine
from pdp8.computer.speed.waiting import Waiting
from pdp8.fitting import known
from tests import commands
from tests.pdp8.computer.bench import machine


@pytest.mark.parametrize(
    ("name", "most"),
    [*((name, 0o7777) for name in ("ac", "pc", "ma", "mb", "sr")), ("link", 1), ("ir", 7)],
)
def test_registers_are_words(name: str, most: int) -> None:
    m = machine(ac=0o1234, link=1)
    for value in (most, 0):
        setattr(m, name, value)
        assert getattr(m, name) == value
        assert (m.ac, m.link) == (value if name == "ac" else 0o1234, value if name == "link" else 1)
    wrong: tuple[Any, ...] = (most + 1, -1, 70000, "7", 5.0, None)
    for each in wrong:
        with pytest.raises(ValueError, match=r"(allowed|is not a number)$"):
            setattr(m, name, each)
        assert getattr(m, name) == 0


def test_addresses_of_8k_have_their_field_and_the_program_goes_on_there() -> None:
    """JMP 201 in field 1, where PC was set."""
    m = Machine(memory=0o20000)
    m.load({0o10200: 0o5201})
    m.pc, m.ma = 0o10200, 0o17777
    assert (m.pc, m.ma) == (0o10200, 0o17777)
    m.run(instructions=1)
    assert m.pc == 0o10201
    for name in ("pc", "ma"):
        with pytest.raises(ValueError, match="17777"):
            setattr(m, name, 0o20000)


def test_what_is_no_word_and_no_address_is_refused_where_a_hand_sets_it() -> None:
    m = machine("5200")
    refused: tuple[tuple[Callable[..., object], *tuple[Any, ...]], ...] = (
        *((m.load, {0o200: 1, **words}) for words in ({0o201: 70000}, {0o201: -1}, {0o10000: 0})),
        *((m.panel.load_address, 0o10000), (m.start, -1), (setattr, m.panel, "sr", 0o10000)),
        *((m.core.__setitem__, 0o200, 0o10000), (m.core.__setitem__, slice(0o200, 0o202), [1, -1])),
    )
    for call, *given in refused:
        with pytest.raises((ValueError, LoadError), match="7777"):
            call(*given)
    assert m.core[0o200:0o202] == [0o5200, 0]
    places: Any
    for places in (m.watch.breakpoints, m.watch.writes, m.watch.reads):
        for place in ("0200", 0o10000, -1):
            places.add(place)
            with pytest.raises(ValueError, match="a breakpoint "):
                m.run(instructions=1)
            places.clear()
    assert m.run(instructions=1).reason == "limit"


@pytest.mark.parametrize(
    ("word", "written", "read"),
    [
        ("0210", set(), {0o210}),  # AND 210
        ("1210", set(), {0o210}),  # TAD 210
        ("2210", {0o210}, {0o210}),  # ISZ 210
        ("3210", {0o210}, set()),  # DCA 210
        ("4210", {0o210}, set()),  # JMS 210
        ("5210", set(), set()),  # JMP 210
        ("1611", set(), {0o210, 0o211}),  # TAD I 211
        ("3611", {0o210}, {0o211}),  # DCA I 211
        ("5611", set(), {0o211}),  # JMP I 211
        ("3410", {0o10, 0o210}, {0o10}),  # DCA I 10, which counts on to 210
        ("7200", set(), set()),  # CLA
    ],
)
def test_what_an_instruction_reads_and_writes(word: str, written: set[int], read: set[int]) -> None:
    """An operand and a pointer are read; the instruction itself, at 200, is not."""
    watched = {0o10, 0o200, 0o210, 0o211}
    m = machine(word)
    m.load({0o10: 0o207, 0o210: 0o7000, 0o211: 0o210})
    m.watch.reads = m.watch.writes = watched
    reason = m.run(instructions=2).reason
    assert (m.watch.written, m.watch.read) == (written, read)
    assert reason == ("breakpoint" if written or read else "limit")


def test_all_is_0_at_power_up_but_few_things_and_initialize_leaves_it_so() -> None:
    bus = Bus()
    p = Processor(bus)
    devices = {"03": Receiver(), "04": Transmitter(), "01": ReaderControl(), "02": PunchControl()}
    parts = all_fields([("p", p), ("bus", bus), ("waiting", Waiting(p)), *devices.items()])
    made = take(parts)
    assert {name: value for name, value in made.items() if value not in (0, b"", NEVER)} == {
        **{"03 reader_run": 1, "03 line": 0o3777, "03 reader on": True, "04 mark": 1, "04 punch on": True},
        **{"01 reader on": True, "02 punch on": True},
        **{"p state": 3, "waiting tries": 8, "waiting core": None, "waiting left clock": -1},
    }
    assert [name for name, value in made.items() if value == NEVER] == [
        *("waiting quiet_until", "03 due", "03 step", "03 edge", "04 due", "01 due", "02 due"),
    ]
    p.initialize()
    for device in devices.values():
        device.initialize(0)
    assert take(parts) == made | {"bus actions": 1}
    assert not Machine().watch.reached


LEFT = """\
Processor clock instructions ir ma mb mem_prot pc protect run sing_step sr writes
Bus actions
Extension data_field data_switch field inst_buffer inst_field inst_switch left remembered \
saved_data saved_inst
DF32 buffer into_core locks over tested
Door tested
KW8 tested
LP08 tested
Receiver buffer free line origin pulses shifts start tested
Transmitter began free selected sent start tested
Reader loaded on position
Punch on
ReaderControl tested
PunchControl tested
TC08 block buffer counts_address into_core settled tested word
Transport locked phase place reverse since
"""
"""What INITIALIZE leaves: what is set at the panel or in the devices, the tape in motion, free clocks."""


def test_initialize_clears_each_field_of_each_device_but_these() -> None:
    m = Machine(known(), 0o20000)
    m.wait(1)
    m.processor.initialize()
    found: dict[str, set[str]] = {}
    usual = m.values()
    del usual["core"]
    for key, part, name, _ in m.fields():
        if isinstance(usual[key], int) and not re.match("waiting|devices 76 drive[1-7]", key):
            m.put({**usual, key: int(not usual[key])})
            m.processor.initialize()
            left = found.setdefault(type(part).__name__, set())
            left |= {name} if m.values()[key] != usual[key] else set()
    assert found == {name: {*names} for name, *names in map(str.split, LEFT.splitlines())}


def test_start_is_load_add_and_start_at_the_panel_and_counts_time_from_zero() -> None:
    """LAS, HLT; the switches stay."""
    called, pressed = machine("7604 7402", sr=0o1234), machine("7604 7402", sr=0o1234)
    for m in (called, pressed):
        m.run()
        assert (m.ac, m.ticks) == (0o1234, 64)
        m.run(instructions=1)
        m.stop()
    called.start(0o200)
    pressed.panel.sr = 0o200
    pressed.panel.load_add()
    pressed.panel.start()
    assert called.panel.lamps == pressed.panel.lamps
    assert (called.pc, called.ticks, called.ma, called.sr) == (pressed.pc, 0, 0o200, 0o1234)
    called.run(instructions=1)
    called.start()
    assert (called.pc, called.ticks, called.ac) == (0o201, 0, 0)


def test_core_in_slices() -> None:
    words = Machine().core
    words[0o200:0o204] = [1, 2, 3, 4]
    assert words[0o177:0o205] == [0, 1, 2, 3, 4, 0]
    assert words[0o7776:] == [0, 0]
    assert words[0o200:0o204:2] == [1, 3]
    assert len(words[:]) == len(words) == len(list(words)) == 4096
    for given in ([1], [1, 2, 3]):
        with pytest.raises(ValueError, match=f"{len(given)} words for 2 addresses"):
            words[0:2] = given
    assert words[0] == 0


@pytest.mark.parametrize(
    "address", [-1, 0o10000, slice(-1, None), slice(0, 0o10001), slice(0o20000, None), slice(0, -1)]
)
def test_there_is_no_core_beyond_7777(address: int | slice) -> None:
    with pytest.raises(IndexError, match=r"core has addresses 0000 to 7777, not -?[12]"):
        Machine().core[address]
    if isinstance(address, int):
        with pytest.raises(IndexError):
            Machine().core[address] = 0
        m = Machine()
        with pytest.raises(
            LoadError, match=f"^address {address:05o}: a PDP-8/L with 4K of core ends at 07777"
        ):
            m.load({0o300: 1, address: 0})
        assert list(m.core) == [0] * 0o10000


@pytest.mark.parametrize("breakpoints", [set(), {0o7000}])
def test_short_runs_find_an_endless_loop_too(breakpoints: set[int]) -> None:
    m = machine("7001 7041 7041 5201")
    m.watch.breakpoints |= breakpoints
    assert {m.run(seconds=0.005).reason for _ in range(20)} == {"limit", "idle"}


@pytest.mark.parametrize("seconds", [-5.0, -1e-9, float("nan"), float("-inf")])
def test_no_time_is_less_than_nothing(seconds: float) -> None:
    m = machine("7001 5200")
    for act in (m.wait, m.run, lambda seconds: next(m.slices(seconds))):
        with pytest.raises(ValueError, match="seconds: 0 or more is allowed"):
            act(seconds)
    with pytest.raises(ValueError, match="a limit of -1 instructions: 0 or more is allowed"):
        m.run(instructions=-1)
    assert (m.ticks, m.instructions) == (0, 0)


def test_a_time_without_end_is_one_of_31_years() -> None:
    assert machine("7402").run(seconds=float("inf")).reason == "halt"
    m = machine("7402")
    m.wait(float("inf"))
    assert m.elapsed == 1e9


def test_repr_says_where_it_stands() -> None:
    m = machine("7001 7402")
    assert repr(m) == "<Machine at 0200: L 0 AC 0000, running, 0.000000 s>"
    m.run()
    m.run(instructions=0)
    assert repr(m) == "<Machine at 0202: L 0 AC 0001, stopped, 0.000003 s>"


def test_the_names_of_the_package() -> None:
    assert {"Machine", "Stop", "__version__"} <= set(dir(pdp8))
    assert pdp8.__version__ == version("pdp8")
    with pytest.raises(AttributeError, match="no attribute 'Mill'"):
        pdp8.Mill  # noqa: B018
    done = commands.run(sys.executable, "-m", "pdp8", "--version")
    assert done.stdout.decode().startswith(f"pdp8, version {pdp8.__version__}, ")


@pytest.mark.parametrize("given", ["prog.pal", b"\x80\x41"])
def test_what_is_no_words_says_what_to_type(given: str | bytes) -> None:
    """The two calls that the message names load a source and a tape."""
    machine = Machine()
    with pytest.raises(LoadError) as refused:
        machine.load(given)  # type: ignore[arg-type]
    calls = re.findall(r"load\(\S+", str(refused.value))
    for call, name in zip(calls, ("eia.pal", "eia.bin"), strict=True):
        machine.core[0o200] = 0
        exec(f"machine.{call.replace('NAME', repr(name))}", {"machine": machine, "pdp8": pdp8})
        assert machine.core[0o200] == 0o6046
