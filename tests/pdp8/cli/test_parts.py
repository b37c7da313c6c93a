"""What commands are made of, piece by piece: both sides of each limit, and when a note is written."""

import os
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from unittest.mock import Mock

import click
import pytest

from pal.assembly import MOST
from pdp8 import cli, shelf
from pdp8.cli import assemble, check, monitor, nc, nc_options, replay, root, run, thesis
from pdp8.cli.assemble import pal
from pdp8.cli.root import pdp8
from pdp8.cli.running import feed, keyboard, pacing, watching
from pdp8.cli.shared import command, parameters
from pdp8.cli.shared.arguments import Folder
from pdp8.computer.machine import Machine
from pdp8.computer.past import rewind, state
from pdp8.computer.past.history import History
from pdp8.computer.use.trace import Listing
from pdp8.monitor.prompt import Monitor
from pdp8.replay.figures import COLUMNS
from tapes.errors import WorkError
from tests.conftest import Call
from tests.pdp8.cli.test_files import completed


def test_the_version_says_which_core_runs(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    from pdp8.computer.speed import engine

    for file, form in (("engine.py", "interpreted"), ("engine.so", "compiled")):
        monkeypatch.setattr(engine, "__file__", file)
        status, shown, said = call("pdp8 --version")
        assert (status, said) == (0, "")
        assert shown.endswith(f", {form} core: {file}\n")
        assert shown.startswith("pdp8, version ")


def test_the_figures_of_a_replay_are_a_table(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    lines = [("length", "1", "2", "same"), ("depth", "3", "4", "other")]
    monkeypatch.setattr("pdp8.replay.figures.compare", lambda afternoon: lines)
    for aside in (False, True):
        replay._show(SimpleNamespace(part="circle"), aside)  # type: ignore[arg-type]
        streams = capsys.readouterr()
        shown, nothing = (streams.err, streams.out) if aside else (streams.out, streams.err)
        assert "circle: thesis beside replay" in shown
        assert [word for word in (*COLUMNS, *lines[0], *lines[1]) if word not in shown] == []
        assert nothing == ""


@pytest.mark.parametrize(("number", "named"), [(1, "0"), (6, "0, 1, 2, 3, 4, 5"), (7, "7 files")])
def test_files_in_a_folder_are_named_or_counted(
    number: int, named: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with click.Context(pal):
        for again in ("", f"; {number} replaced"):
            command.put_all(str(tmp_path / "of"), ((str(each), b"x") for each in range(number)))
            assert capsys.readouterr().err == f"wrote {named} in {tmp_path / 'of'}{again}\n"
        command.put_all(str(tmp_path / "none"), [])
    assert capsys.readouterr().err == ""


def test_what_was_written_before_a_failure_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "b").mkdir()
    with click.Context(pal), pytest.raises(shelf.ShelfError):
        command.put_all(str(tmp_path), [("a", b""), ("b", b""), ("c", b"")])
    assert capsys.readouterr().err == f"wrote a in {tmp_path}\n"


def test_a_name_in_a_folder_is_left_to_the_shell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "eia-of").mkdir()
    assert completed(pdp8, ["run"], "eia-of/") == [("eia-of/", "file")]
    assert completed(pdp8, ["run"], "./eia") == [("./eia", "file")]
    assert completed(pdp8, ["run"], "eia-") == [("eia-", "file")], "it begins no bundled name"
    names = completed(pdp8, ["run"], "eia")
    assert ("eia-of/", "plain") in names
    assert names == sorted(names)


def test_the_name_of_a_file_is_no_folder_s_unless_it_is_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for name in ["a.svg", "a.html", "a.pdf", "a.PNG", "a.json", "a.csv", "a.txt", "a.zip", "a.tar.gz"]:
        with pytest.raises(click.BadParameter, match=f"{name} is the name of a file, not of a folder"):
            Folder().convert(name, None, None)
        Path(name).mkdir()
        assert Folder().convert(name, None, None) == name
    assert Folder().convert("a.v2", None, None) == "a.v2"


def test_which_tapes_are_read_as_pipes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "tape").write_bytes(b"x")
    assert feed._pipe(str(tmp_path / "tape")) == -1
    assert feed._pipe(str(tmp_path)) == -1
    with pytest.raises(shelf.ShelfError):
        feed._pipe(str(tmp_path / "none"))
    with open(tmp_path / "tape") as file:
        monkeypatch.setattr(sys, "stdin", file)
        assert feed._pipe("-") == -1
    if sys.platform == "win32":
        return
    reading, writing = os.pipe()
    with open(reading) as file:
        monkeypatch.setattr(sys, "stdin", file)
        assert feed._pipe("-") == reading
    os.close(writing)


def test_tapes_are_put_in_one_after_another(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It says which, how many frames were read before, and what is left; quiet it says nothing."""
    for name, frames in (("a", b"ab"), ("b", b"c"), ("c", b"")):
        (tmp_path / name).write_bytes(frames)
    for quiet in (False, True):
        reader = Machine().teletype.reader
        fed = feed.Feed(reader, [str(tmp_path / name) for name in "abc"], quiet)
        with click.Context(pal, info_name="pal"):
            assert fed.left.count(",") == 2
            assert fed.next_tape()
            assert (reader.tape, fed.read, fed.idle()) == (b"ab", 0, False)
            reader.position = 2
            assert fed.announce_next()
            assert (reader.tape, fed.read, fed.left) == (b"c", 2, str(tmp_path / "c"))
            reader.position = 1
            assert fed.announce_next()
            assert fed.read == 3
            assert not fed.announce_next()
            assert (fed.next_tape(), fed.left) == (False, "")
        said = capsys.readouterr().err
        assert said.count("goes into the reader after 2 frames") == (not quiet)
        assert said.count("goes into the reader after 3 frames") == (not quiet)
        assert (said == "") == quiet


def test_a_group_suggests_names_that_are_much_alike(call: Call) -> None:
    assert "there is no command 'tapes'; did you mean tape?" in call("pdp8 tapes")[2]
    status, _, said = call("pdp8 qqqq")
    assert (status, "did you mean" in said) == (2, False)
    assert command._path(root.pdp8, "pdp8", ["tape", "show", "x"]) == "pdp8 tape show"
    assert command._path(root.pdp8, "pdp8", ["--help", "tape"]) == "pdp8"
    assert command._path(root.pdp8, "pdp8", []) == "pdp8"


@pytest.mark.parametrize(
    ("optimize", "words", "restarted"),
    [(0, ["-OO"], None), (1, ["-O"], None), (2, ["-OO", "-m", "pdp8"], ["-m", "pdp8"]), (2, ["x"], ["x"])],
)
def test_python_without_docstrings_starts_again_with_them(
    optimize: int, words: list[str], restarted: list[str] | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    started = []
    monkeypatch.setenv("PYTHONOPTIMIZE", "2")
    monkeypatch.setattr(sys, "flags", SimpleNamespace(optimize=optimize))
    monkeypatch.setattr(sys, "orig_argv", ["python", *words])
    monkeypatch.setattr(os, "execv", lambda *of: started.append(of))
    cli._keep_docstrings()
    assert started == ([] if restarted is None else [(sys.executable, [sys.executable, *restarted])])
    assert os.environ["PYTHONOPTIMIZE"] == ("2" if restarted is None else "1")


def test_where_conjectures_are_on_pictures(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Only on the picture of their page; by rows of pixels, by about which, or on the whole page."""
    found = {"a": (3, 9, True), "b": (4, 8, False), "c": None, "d": (0, 1, True)}
    pages = {"a": "12", "b": "12", "c": "12", "d": "13"}
    known = {name: SimpleNamespace(name=name, page=page) for name, page in pages.items()}
    monkeypatch.setattr("pdp8.thesis.collate.conjectures", lambda: known)
    monkeypatch.setattr("pdp8.cli.shared.extras.need", lambda *of: None)
    fake = SimpleNamespace(find=lambda each, picture: found[each.name])
    monkeypatch.setitem(sys.modules, "pdp8.thesis.pages", fake)
    monkeypatch.setattr("pdp8.thesis.pages", fake, raising=False)
    for name in ("scan-012.png", "12.jpg", "x.png"):
        (tmp_path / name).touch()
    assert thesis._places(str(tmp_path)) == {
        "a": "; scan-012.png: rows 3 to 9 of pixels",
        "b": "; scan-012.png: by its number among the lines, about rows 4 to 8 of pixels",
        "c": "; scan-012.png: the whole page",
    }


@pytest.mark.parametrize(
    ("marks", "restated", "slips", "said"),
    [
        ([], [], (0, 0, []), "e: the solution has 5 points\n"),
        (
            [("m", False)],
            [("w", True)],
            (0, 0, []),
            "e: the solution has 5 points; 1 way to write it, all right; 1 mistake, all noticed\n",
        ),
        (
            [],
            [],
            (3, 9, ["s"]),
            "e: the solution has 5 points\n3 of 9 slips tried, 2 noticed; these seem right:\n  s\n",
        ),
        (
            [("m", True)],
            [("w", False)],
            (0, 0, []),
            "e: accepted as right: m\ne: the solution, w, loses points",
        ),
    ],
)
def test_what_a_proof_of_an_exercise_says(
    marks: list[tuple[str, bool]],
    restated: list[tuple[str, bool]],
    slips: tuple[int, int, list[str]],
    said: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    def results(of: list[tuple[str, bool]]) -> list[tuple[str, SimpleNamespace]]:
        return [(name, SimpleNamespace(right=right)) for name, right in of]

    tried = SimpleNamespace(tried=slips[0], number=slips[1], survivors=slips[2], lucky=[])
    fake = {
        "solution": lambda exercise: SimpleNamespace(right=True, of=5),
        "mistakes": lambda exercise: results(marks),
        "restated": lambda exercise: results(restated),
        "slips": lambda read, seed: tried,
        "untold": lambda exercise: [],
    }
    for name, instead in fake.items():
        monkeypatch.setattr(f"pdp8.lessons.proof.{name}", instead)
    exercise: Any = SimpleNamespace(name="e")
    if said.endswith("\n"):
        check._prove(exercise, "e", 0)
        assert capsys.readouterr().out == said
        return
    with pytest.raises(WorkError) as raised:
        check._prove(exercise, "e", 0)
    assert str(raised.value) == said


@pytest.mark.parametrize(
    ("line", "read"),
    [
        *(("A 1", {"A": 1}), ("ABCDE9\t17777", {"ABCDE9": 0o17777}), (" A  07 ", {"A": 7}), ("", {})),
        *(
            (line, None)
            for line in ("A", "A 8", "A 177777", "ABCDEFG 1", "1A 1", "a 1", "A 1 2", "A1", "A -1")
        ),
    ],
)
def test_a_line_of_a_symbol_table(line: str, read: dict[str, int] | None, tmp_path: Path) -> None:
    (tmp_path / "s").write_text(f"START 0200\n{line}\n")
    name = str(tmp_path / "s")
    if read is not None:
        assert assemble._symbols(name) == {"START": 0o200} | read
        return
    with pytest.raises(WorkError) as raised:
        assemble._symbols(name)
    assert str(raised.value) == f"{name}: line 2: {line!r} is no name with an octal number"


@pytest.mark.parametrize(
    ("number", "line", "more"),
    [
        (MOST, "5 + 3", ""),
        (MOST + 1, "5 + 3", "and 1 more note\n"),
        (MOST - 1, "JMP 600", ""),  # it has a note too
        (MOST, "JMP 600", "and 1 more note\n"),
        (MOST + 2, "JMP 600", "and 2 more errors, 1 more note\n"),
        (MOST + 2, "CLA!", "and 2 more errors, 1 more note\n"),
    ],
)
def test_so_many_diagnostics_are_written(number: int, line: str, more: str, call: Call) -> None:
    said = call("pal - --check --dialect pal3", ("*200\n" + f"\t{line}\n" * number + "$\n").encode())[2]
    assert ("\nand " in said) == bool(more)
    assert more in said


def test_seconds_of_this_computer_are_between_two_limits() -> None:
    assert [parameters.processor_seconds(text) for text in ("0.1", "3600", "5")] == [0.1, 3600.0, 5.0]
    for text in ("0.0999", "3600.1", "nan", "-1"):
        with pytest.raises(click.BadParameter, match=r"is not between 0\.1 and 3600 seconds"):
            parameters.processor_seconds(text)
    with pytest.raises(click.BadParameter, match="'x' is not a number of seconds"):
        parameters.processor_seconds("x")


def test_numbers_are_as_many_as_are_asked_for_and_lengths_in_their_unit() -> None:
    ctx = click.Context(nc.export)

    @click.command()
    @nc_options.lengths("--at", "X,Y", "Where.")
    def tried(at: object) -> None: ...

    [at] = tried.params
    assert at.callback is not None
    for mm, inches in ((True, (1.0, 2.0)), (False, (25.4, 50.8))):
        ctx.params = {"mm": mm}
        assert at.callback(ctx, at, "25.4,50.8") == inches
        assert nc_options.numbers("X,Y")(ctx, at, "25.4,50.8") == (25.4, 50.8)
        assert nc_options.numbers("X,Y,Z", one_for_all=True)(ctx, at, "5") == (5.0, 5.0, 5.0)
        assert at.callback(ctx, at, None) is None
        for wrong in ("1", "1,2,3", "a,b", "inf,1", ""):
            with pytest.raises(click.BadParameter, match="is not X,Y: 2 numbers separated by commas"):
                at.callback(ctx, at, wrong)


@pytest.mark.parametrize(("name", "doubt"), [("circle.eia", "is an EIA tape: "), ("circle.asc", "")])
def test_a_tape_that_its_owner_may_not_expect(
    name: str, doubt: str, capsys: pytest.CaptureFixture[str]
) -> None:
    for quiet in (False, True):
        with click.Context(pal, info_name="pal"):
            assert feed.Feed(Machine().teletype.reader, [name], quiet).next_tape()
        said = capsys.readouterr().err
        assert said.startswith(f"pal: {name} {doubt}") == bool(doubt and not quiet)
        assert bool(said) == bool(doubt and not quiet)


def test_the_page_of_a_replay_replaces_no_other_file_of_it() -> None:
    for name in ("of/drill.svg", "./of/../of/figures.txt"):
        with pytest.raises(click.UsageError, match="is the name of another file of the replay"):
            replay._check("drill", "of", name, in_fortran=False)
    replay._check("drill", "of", "of/other.html", in_fortran=False)


@pytest.mark.parametrize(("left", "shown"), [(False, []), (True, ["cont goes back into the program"])])
def test_the_way_back_into_the_program_is_said_once_who_left_it(
    left: bool, shown: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    lines = ["deposit 200 5200", "go 200 0.1", "cont 0.1", "quit"]
    terminal = Mock(wraps=keyboard.Terminal())
    terminal.run = lambda machine, seconds, *_: (machine.run(seconds or 1), left)
    terminal.say = print
    monkeypatch.setattr(keyboard, "Terminal", lambda: terminal)
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    monkeypatch.setattr(monitor, "_typed", lambda: iter(lines))
    monitor.converse(Monitor(print))
    said = capsys.readouterr().out.splitlines()
    assert [line for line in said if "goes back" in line] == shown


@pytest.mark.parametrize(
    ("lines", "frames"),
    {
        "quit": "0123456789",
        "cont .5|quit": "0123456789:;<=>",
        "back 3 characters|quit": "0123456",
        "back 3 characters|deposit 205 7000|cont .5|quit": "012345677777",
        "punch on|punch torn.tape|cont .5|quit": ":;<=>",
        "save then.state|cont 1|restore then.state|cont .5|quit": "0123456789:;<=>",
        "save then.state|punch torn.tape|cont .5|restore then.state|quit": "0123456789",
        "cont .5|restore no.state|quit": "0123456789:;<=>",
        "set cpu 8k|cont .5|quit": "0123456789:;<=>",
        "key stop|wait .2|quit": "0123456789:",
        "key stop|wait .2|quit|down a pipe": "0123456789:",
    }.items(),
)
def test_the_files_of_a_run_are_those_of_the_machine_that_the_monitor_leaves(
    lines: str, frames: str, call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    end = -1
    if "pipe" in lines:
        os.mkfifo("out.tape")
        end = os.open("out.tape", os.O_RDONLY | os.O_NONBLOCK)
    Path("count.pal").write_text(
        "*200\nLOOP,\tTAD X\n\tTLS\n\tTSF\n\tJMP .-1\n\tCLA\n\tISZ X\n\tJMP LOOP\nX,\t60\n$\n"
    )
    terminal = Mock(wraps=keyboard.Terminal())
    terminal.run = lambda machine, seconds, *_: (machine.run(seconds), True)
    monkeypatch.setattr(keyboard, "Terminal", lambda *_: terminal)
    monkeypatch.setattr(monitor, "_typed", lambda: iter(lines.split("|")))
    monkeypatch.setattr(sys, "stdin", Mock(isatty=lambda: True))
    asked = "pdp8 run count.pal --keyboard --punch out.tape --save end.state --max-time 1.05"
    assert call(asked, terminal=True)[0] == 0
    assert (Path("out.tape").read_bytes() if end < 0 else os.read(end, 99)) == frames.encode()
    if end >= 0:
        os.close(end)
    assert state.restore(Path("end.state").read_text()).teletype.punch.tape == frames.encode()


def test_the_monitor_at_a_terminal_says_how_much_core_there_is(
    call: Call, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(monitor, "converse", lambda made: None)
    said = "PDP-8/L, 4K. help tells what there is; quit leaves.\n"
    assert call("pdp8 monitor", terminal=True) == (0, said, "")


def test_a_run_leaves_ctrl_c_and_the_machine_as_they_were(tmp_path: Path) -> None:
    before, machine = signal.getsignal(signal.SIGINT), Machine()
    with pacing.ctrl_c() as interrupt:
        signal.raise_signal(signal.SIGINT)
        assert interrupt.pressed
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is before
    with click.Context(run.run):
        for name in ("-", str(tmp_path / "trace")):
            with watching.tracing(machine, name, Listing()):
                assert machine.watch.observer is not None
            assert machine.watch.observer is None


WITHIN: dict[str, Callable[[Machine, History], AbstractContextManager[object]]] = {
    "ctrl_c": lambda machine, history: pacing.ctrl_c(),
    "printing": lambda machine, history: keyboard.Terminal().printing(machine),
    "counting": lambda machine, history: watching.counting(machine, Listing(), False, None),
    "tracing": lambda machine, history: watching.tracing(machine, "-", Listing()),
    "count": lambda machine, history: machine.count(),
    "watched": lambda machine, history: shelf.watched(),
    "going back": lambda machine, history: history.going_back(),
    "looking back": lambda machine, history: rewind.looking_back(history),
}


@pytest.mark.parametrize("within", WITHIN)
def test_an_error_within_leaves_all_as_it_was(within: str) -> None:
    machine = Machine()
    history = History(machine)

    def changed(word: int) -> Iterator[tuple[int, int]]:
        machine.core[0o300] = word
        yield 0, 1 // 0

    def now() -> list[object]:
        parts = machine.watch, machine.watch.observer, machine.recorder, machine.teletype.printer.on_frame
        return [*parts, machine.core[0o300], len(shelf._watches), signal.getsignal(signal.SIGINT)]

    before = now()
    with pytest.raises(ZeroDivisionError), click.Context(run.run), WITHIN[within](machine, history):
        machine.load(changed(within.endswith("back")))
    assert now() == before


@pytest.mark.parametrize(
    ("line", "advised"),
    [
        ("a.pal", True),
        *((f"a.pal {with_one} a.asc", False) for with_one in ("--reader", "--fast-reader")),
        ("--restore kept", False),
    ],
)
def test_who_sits_at_a_terminal_hears_of_options_that_give_the_program_a_tape(
    line: str, advised: bool, call: Call, tmp_path: Path
) -> None:
    (tmp_path / "a.pal").write_text("*200\n\tKSF\n\tJMP .-1\n\tKRB\n\tJMP 200\n$\n")
    (tmp_path / "a.asc").write_bytes(b"ABC")
    if "kept" in line:
        assert call("pdp8 run a.pal --reader a.asc --save kept")[0] == 0
    _, _, said = call(f"pdp8 run {line}", terminal=True)
    assert "the reader ran out of tape" in said
    assert ("; --keyboard types at the Teletype" in said) == advised
