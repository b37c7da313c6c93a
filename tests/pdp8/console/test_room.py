"""The panel in a terminal: keys and mouse do what they say, and the room looks as it should."""

from collections.abc import Callable
from contextlib import chdir
from functools import partial
from inspect import isawaitable
from itertools import product
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import pytest

pytest.importorskip("textual", reason="Textual, the extra `panel`, is not installed")

from textual.events import Paste
from textual.pilot import Pilot
from textual.widgets import OptionList

from pdp8 import shelf
from pdp8.computer.use.operator import RIM_START
from pdp8.console import lamps
from pdp8.console.app import Room
from pdp8.console.opening import opening
from pdp8.console.pages import Card, Core, ListingPage, Page
from pdp8.console.strips import ReaderStrip
from pdp8.console.switches import LOCKING, Rocker
from tapes import binary, rim
from tests.conftest import assert_same_tape, case
from tests.pdp8.console.pictures import assert_shows, scene, shown
from tests.pdp8.console.test_session import RIM_WORDS


async def press(pilot: Pilot[None], keys: str) -> None:
    """Press keys, and wait until what they do is drawn."""
    await pilot.press(*keys.split())
    await pilot.pause()


def turn(room: Room, seconds: float) -> None:
    """Let time pass in the room, a twentieth of a second at a time."""
    for _ in range(round(seconds * 20)):
        room.turn(0.05)


@pytest.mark.slow("hundreds of keys, each of which draws the panel")
@scene()
async def test_a_morning_by_keys_rim_bin_program_and_tape(room: Room, pilot: Pilot[None]) -> None:
    machine = room.session.machine
    keys = "7756l" + "".join(f"{word:04o}d" for word in RIM_WORDS.values())
    await pilot.press(*keys)
    assert {address: machine.core[address] for address in RIM_WORDS} == RIM_WORDS
    assert_shows(room, "rim toggled in, 100x30")
    await press(pilot, "p p p o enter 7 7 5 6 l s")
    turn(room, 0.5)
    assert room.session.said.startswith("the reader ran out of tape")
    await press(pilot, "t")
    assert machine.core[0o7777] == 0o5301  # JMP 7701, as BIN puts it there
    await press(pilot, "o down enter 7 7 7 7 l s")
    turn(room, 0.5)
    assert (machine.ma, machine.ac) == (0o7700, 0)
    assert_shows(room, "eia.bin loaded, 100x30")
    await press(pilot, "o down down enter 0 2 0 0 l s")
    for _ in range(4):
        room.turn(0.5)
    assert room.session.said.startswith("the reader ran out of tape")
    eia = Path(__file__).parents[3] / "tapes" / "circle.eia"
    assert_same_tape(machine.teletype.punch.tape, eia.read_bytes())


@pytest.mark.parametrize(
    ("name", "label", "switches"),
    [("x.pal", "x.bin", 7777), ("x.pa", "x.bin", 7777), ("x.bin", "x.bin", 7777), ("x.rim", "x.rim", 7756)],
)
def test_the_card_and_the_list_have_the_tapes_by_their_names(
    name: str, label: str, switches: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    contents = {"x.bin": binary.encode({0o200: 1}), "x.rim": rim.encode({0o200: 1})}
    (tmp_path / name).write_bytes(contents.get(name, b"*200\nHLT\n$\n"))
    (tmp_path / "circle.asc").write_bytes(b"\x81")
    session, programs = opening(name, "circle.asc")
    assert (
        Card(session, "card", programs[0], programs[-1]).steps[2].startswith(f"3 {label}: O, SR {switches} ")
    )
    assert [tape.name for tape in session.tapes] == ["bin.rim", label, "ellipse.asc", "circle.asc"]
    assert session.tapes[-1].frames == session.machine.teletype.reader.tape == b"\x81"


@scene(size=(80, 24))
async def test_r_toggles_rim_in(room: Room, pilot: Pilot[None]) -> None:
    await press(pilot, "R")
    turn(room, 1.0)
    assert_shows(room, "rim being toggled in, 80x24")
    turn(room, 1.0)
    core = room.session.machine.core
    assert {address: core[address] for address in RIM_WORDS} == RIM_WORDS


@scene()
async def test_switches_by_hand_and_by_mouse(room: Room, pilot: Pilot[None]) -> None:
    machine = room.session.machine
    await press(pilot, "up right up left left up")
    assert machine.sr == 0o6001
    await press(pilot, "down down right")
    assert machine.sr == 0o6000
    assert room.session.hand == 0
    await pilot.click("#sr3")
    await pilot.click("#sr0")
    assert machine.sr == 0o2400
    await pilot.click("#load_add")
    assert machine.ma == 0o2400
    await pilot.click("#dep")
    assert machine.core[0o2400] == 0o2400
    await pilot.click("#exam")
    assert machine.ma == 0o2401
    await pilot.click("#mem_prot")
    await pilot.click("#sing_step")
    assert (machine.panel.mem_prot, machine.panel.sing_step) == (True, True)
    assert [rocker.up for rocker in room.query(Rocker)].count(True) == 2


@scene(size=(80, 24), memory=0o20000)
async def test_the_switches_of_the_memory_extension(room: Room, pilot: Pilot[None]) -> None:
    machine = room.session.machine
    machine.core[0o10200] = 0o6211
    await press(pilot, "i r")
    turn(room, 3)
    assert "17776 0000✓" in shown(room)
    await press(pilot, "0 2 0 0 l")
    assert (machine.pc, machine.ma, machine.mb, machine.panel.data_field) == (0o10200, 0o10200, 0o6211, 0)
    assert_shows(room, "8K, in field 1, 80x24")
    while "core about the PC, 10200" not in shown(room):
        await press(pilot, "g")
    assert "10200  6211 0000" in shown(room)
    await press(pilot, "f I l")
    assert (machine.pc, machine.processor.extension.data_field) == (0o200, 0o10000)


@scene()
async def test_without_it_they_are_not_there(room: Room, pilot: Pilot[None]) -> None:
    await press(pilot, "i f l")
    assert (room.session.machine.panel.inst_field, shown(room).count("EMA")) == (0, 0)


@scene(program="eia.pal", reader="circle.asc")
async def test_sing_step_by_cycle_with_the_listing(room: Room, pilot: Pilot[None]) -> None:
    await press(pilot, "n s c c")
    assert room.session.said == "one cycle: FETCH"
    assert "▸0202  4214          JMS READ" in shown(room)
    await press(pilot, "c")
    assert room.session.said == "one cycle: EXECUTE"
    assert_shows(room, "single steps, 100x30")


@scene(program="eia.pal", reader="circle.asc")
async def test_the_room_in_terminals_of_three_sizes(room: Room, pilot: Pilot[None]) -> None:
    await press(pilot, "p p s")
    turn(room, 0.5)
    await press(pilot, "t")
    for size in ((160, 45), (100, 30), (80, 24)):
        await pilot.resize_terminal(*size)
        await pilot.pause()
        assert_shows(room, f"translating, {size[0]}x{size[1]}")
    for size, everything in (((150, 34), True), ((149, 34), False), ((150, 33), False)):
        await pilot.resize_terminal(*size)
        await pilot.pause()
        assert [page in shown(room) for page in ("RIM loader", "core about")] == [everything] * 2
    assert [lamps.columns(width).wide for width in (94, 95)] == [False, True]
    assert [lamps.lamp(brightness)[0] for brightness in (0.04, 0.05)] == ["○", "●"]


@scene(size=(60, 20))
async def test_a_terminal_too_small_says_so(room: Room, pilot: Pilot[None]) -> None:
    assert "80 columns and 24 lines" in shown(room)
    assert "MEM ADDR" not in shown(room)
    await press(pilot, "o")
    await pilot.resize_terminal(80, 24)
    await press(pilot, "escape")
    assert "MEM ADDR" in shown(room)
    for size in ((79, 24), (80, 23)):
        await pilot.resize_terminal(*size)
        await pilot.pause()
        assert "80 columns and 24 lines" in shown(room)


@scene(program="tests/pdp8/console/typewriter.pal")
async def test_typing_at_the_teletype(room: Room, pilot: Pilot[None]) -> None:
    machine = room.session.machine
    await press(pilot, "s tab h i 1 enter ctrl+c")
    turn(room, 1.0)
    assert machine.panel.lamps.run
    assert machine.sr == 0o200  # the 1 went to the Teletype
    assert bytes(machine.teletype.printer.frames) == bytes([0o310, 0o311, 0o261, 0o215, 0o203])
    assert "HI1" in shown(room)
    assert "ESC goes back" in shown(room)
    await press(pilot, "escape 7 tab up tab 7")
    assert machine.sr == 0o0077
    await press(pilot, "tab")
    room.post_message(Paste("ok\nA\r\n"))
    await pilot.pause()
    turn(room, 1.0)
    assert bytes(machine.teletype.printer.frames[5:]) == b"\xcf\xcb\x8d\xc1\x8d"


@scene()
async def test_pages_pace_lever_and_punch(room: Room, pilot: Pilot[None]) -> None:
    for width, statement in ((93, False), (94, True)):
        await pilot.resize_terminal(width, 30)
        await pilot.pause()
        assert ("KCC" in room.query_one(Card).render().plain) is statement
    assert "RIM loader" in shown(room)
    await press(pilot, "g")
    assert "listing of" in shown(room)
    await press(pilot, "g")
    assert "core about the PC" in shown(room)
    for width, words in ((89, 4), (90, 8)):
        await pilot.resize_terminal(width, 30)
        await pilot.pause()
        assert room.query_one(Core).render().plain.splitlines()[1] == f"{words:04o} " + " 0000" * words
    await press(pilot, "v u p")
    assert "STOP · reader" in shown(room)
    assert "punch OFF" in shown(room)
    assert "×10" in shown(room)
    assert "not quite" not in shown(room)
    room.session.behind = True
    await press(pilot, "x")
    assert "not quite ×10" in shown(room)


@scene(program="eia.pal", reader="circle.asc")
async def test_tearing_off_and_reading_again(room: Room, pilot: Pilot[None]) -> None:
    await press(pilot, "w")
    assert len(room.screen_stack) == 1  # nothing is punched yet
    await press(pilot, "p p s")
    turn(room, 0.5)
    punched = room.session.machine.teletype.punch.tape
    await press(pilot, "w")
    with TemporaryDirectory() as folder:
        own, mine = Path(folder, "own.pal"), Path(folder, "mine.eia")
        own.write_text("*200\n")
        for name, stays in ((folder, True), (own, True), (mine, False)):
            room.screen.query_one("Input").value = str(name)  # type: ignore[attr-defined]
            await press(pilot, "enter")
            assert bool(room.session.machine.teletype.punch.frames) == stays
            if stays:
                await press(pilot, "w")
        assert (own.read_text(), mine.read_bytes()) == ("*200\n", punched)
        with chdir(folder):
            for number, name in enumerate(("punched.tape", "punched-2.tape")):
                room.session.machine.teletype.punch.frames.append(number)
                await press(pilot, "w enter")
                assert Path(name).read_bytes() == bytes([number])
    assert room.session.tapes[-3].frames == punched


@scene(reader="circle.asc")
async def test_another_tape_of_the_same_length_has_captions_of_its_own(
    room: Room, pilot: Pilot[None]
) -> None:
    strip, reader = room.query_one(ReaderStrip), room.session.machine.teletype.reader
    for letter in "AB":
        reader.load(bytes([ord(letter) | 0o200]) * 20)
        strip.look()
        assert strip.captions[0] == letter


@scene()
async def test_leaving_asks_for_a_tape_that_is_not_torn_off(room: Room, pilot: Pilot[None]) -> None:
    room.session.machine.teletype.punch.frames += b"12"
    await press(pilot, "q")
    assert "2 frames punched and not torn off" in shown(room)
    await press(pilot, "n ctrl+q")
    assert len(room.screen_stack) == 2
    await press(pilot, "n")
    assert len(room.screen_stack) == 1
    assert room.is_running
    await press(pilot, "q y")
    assert not room.is_running or room._exit


@scene()
async def test_a_tape_that_is_not_there_is_named(room: Room, pilot: Pilot[None]) -> None:
    await press(pilot, "o n o enter")
    assert "no: no such file" in shown(room)
    await press(pilot, "t")
    assert "no such file" not in shown(room)
    await press(pilot, "escape")
    assert not room.session.machine.teletype.reader.loaded


@scene()
async def test_enter_takes_the_tape_whose_name_stands_on_the_line(room: Room, pilot: Pilot[None]) -> None:
    for keys, name in (
        ("x down up enter", "ellipse.asc"),
        ("x up up enter", "circle.asc"),
        ("down backspace b i n full_stop r i m enter", "bin.rim"),
        ("e i a full_stop p a l enter", "eia.pal"),
        ("e i a full_stop b i n tab enter", "eia.bin"),
    ):
        with case(keys):
            at_hand = {tape.name: tape.frames for tape in room.session.tapes}
            await press(pilot, "o " + keys)
            assert len(room.screen_stack) == 1
            assert room.session.reader_tape == name
            frames = at_hand.get(name) or shelf.read(name)
            assert_same_tape(room.session.machine.teletype.reader.tape, frames.lstrip(b"\0"))


@scene(size=(80, 24))
async def test_a_tape_at_hand_is_lit_while_its_name_stands_there_and_taken_by_a_click(
    room: Room, pilot: Pilot[None]
) -> None:
    await press(pilot, "o e i a full_stop b i n")
    assert_shows(room, "choosing a tape, 80x24")
    assert room.screen.query_one(OptionList).highlighted == 1
    await press(pilot, "x")
    assert room.screen.query_one(OptionList).highlighted is None
    await pilot.click(OptionList, offset=(2, 2))
    await pilot.pause()
    assert room.session.reader_tape == "circle.asc"


@scene(program="eia.pal", reader="circle.asc")
async def test_ctrl_c_is_the_stop_key(room: Room, pilot: Pilot[None]) -> None:
    session = room.session
    await press(pilot, "s")
    turn(room, 0.5)
    assert session.machine.panel.lamps.run
    await press(pilot, "ctrl+c")
    assert not session.machine.panel.lamps.run
    assert session.said.startswith("stopped before")
    before = session.machine.instructions
    await press(pilot, "b")
    assert session.machine.instructions == before - 1
    await press(pilot, "z")
    assert session.machine.elapsed == 0
    room.set_focus(None)
    await press(pilot, "ctrl+c")
    assert not room._notifications


@scene()
async def test_ctrl_c_leaves_a_question_as_escape_does(room: Room, pilot: Pilot[None]) -> None:
    room.session.machine.teletype.punch.frames += b"\x01"
    for question, leave in product("ow", ("ctrl+c", "escape")):
        await press(pilot, question)
        assert len(room.screen_stack) == 2
        await press(pilot, leave)
        assert len(room.screen_stack) == 1
    assert not room.session.machine.teletype.reader.loaded
    assert not room._notifications


@scene(size=(160, 45), program="eia.pal", reader="circle.asc", memory=0o20000)
async def test_a_page_that_would_be_drawn_otherwise_looks_otherwise(room: Room, pilot: Pilot[None]) -> None:
    """After each of three hundred steps, drawn from what changes a page; time runs back, too."""
    session, draw, other = room.session, Random(1), shelf.program("tests/pdp8/console/typewriter.pal")
    machine, programs = session.machine, room.query_one(ListingPage).programs
    programs.append(other)
    teletype, core, pages = machine.teletype, machine.core, list(room.query(Page))
    steps: list[Callable[[], object]] = [
        *(partial(session.press, key) for key in ("load_add", "exam", "dep", "start", "cont", "stop")),
        *(partial(session.lock, name) for name in LOCKING),
        *(partial(machine.load, each.words) for each in programs),
        *(partial(session.mount, tape) for tape in session.tapes),
        *(partial(session.back, seconds) for seconds in (0, 0.1)),
        *(partial(session.advance, seconds) for seconds in (0.05, 1)),
        *(partial(setattr, machine, name, 0o200) for name in ("ma", "sr", "ac")),
        *(partial(setattr, machine, "pc", at) for at in (0o200, RIM_START, RIM_START + 1)),
        *3 * [lambda: core.__setitem__(session.address, 0o7402)],
        *(partial(setattr, session, "hand", at) for at in (0, 5)),
        partial(session.dial, 7),
        partial(session.throw, 3),
        partial(setattr, teletype.punch, "on", False),
        partial(session.operator.throw_lever),
        partial(session.tear_off, "torn"),
        partial(teletype.keyboard.press, b"A"),
        partial(pilot.press, "tab"),
    ]

    def seen() -> dict[Page, tuple[object, object]]:
        return {page: (page.look(), page.render()) for page in pages}

    before = seen()
    for _ in range(300):
        step = draw.choice(steps)
        done = step()
        if isawaitable(done):
            await done
        now = seen()
        with case(step):
            same = [page for page in pages if now[page][0] == before[page][0]]
            assert [page for page in same if now[page][1] != before[page][1]] == []
            named = next(tape.frames for tape in session.tapes if tape.name == session.reader_tape)
            assert teletype.reader.tape == named.lstrip(b"\0"), "the reader's strip has its name"
        before = now
