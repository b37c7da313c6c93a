"""One contract for files in every command: what is never replaced, what is said, and that nothing is lost."""

import json
import os
import signal
import sys
from pathlib import Path
from xml.etree import ElementTree

import click
import pytest

from pdp8 import companion, shelf
from pdp8.cli.assemble import pal
from pdp8.cli.os8 import _packed
from pdp8.cli.root import pdp8
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.lessons import form, student
from tapes import binary
from tapes.errors import WorkError
from tapes.nominal import Nominal
from tapes.text import is_utf16
from tests import commands
from tests.conftest import Call, Shell

RIGHT = form.read("add").solution


@pytest.mark.parametrize(
    ("lines", "said"),
    [
        ("reader own.bin; punch hard.bin", "hard.bin was read: it is not replaced"),
        ("load own.bin; punch script", "script was read: it is not replaced"),
    ],
)
def test_the_monitor_keeps_what_it_read(lines: str, said: str, call: Call, tmp_path: Path) -> None:
    (tmp_path / "own.bin").write_bytes(shelf.read_bundled("eia.bin"))
    os.link("own.bin", "hard.bin")
    (tmp_path / "script").write_text(lines.replace("; ", "\n"))
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    status, _, error = call("pdp8 monitor script")
    assert (status, said in error) == (1, True), error
    assert before == {path.name: path.read_bytes() for path in tmp_path.iterdir()}


def test_what_is_written_into_a_folder_or_a_device_is_said(call: Call) -> None:
    os.mkfifo("device")
    reader = os.open("device", os.O_RDWR | os.O_NONBLOCK)
    assert call("pdp8 part drill -o device")[2] == "wrote device\n"
    assert os.read(reader, 1 << 16) == call("pdp8 part drill")[1].encode("utf-8", "surrogateescape")
    os.close(reader)
    assert "wrote rim.svg, eia.svg in cards\n" in call("pdp8 cards rim eia -o cards")[2]
    assert "wrote rim.svg in cards; 1 replaced\n" in call("pdp8 cards rim -o cards")[2]


@pytest.mark.parametrize(
    "output", ["--punch", "--fast-punch", "--printer", "--trace", "--annotate", "--save"]
)
def test_what_could_not_be_written_is_not_named_as_written(output: str, call: Call) -> None:
    Path("x.pal").write_text("*200\nCLA CMA\nTLS\n6026\n6664\nHLT\n$\n")
    status, _, said = call(f"pdp8 run x.pal {output} /dev/full")
    assert (status, said.count("/dev/full"), "No space left" in said) == (1, 1, True), said


def test_nothing_is_made_in_a_locked_folder(call: Call, tmp_path: Path) -> None:
    (tmp_path / "locked").mkdir(mode=0o555)
    status, _, said = call("pdp8 cards rim -o locked/sub/cards")
    assert (status, "locked/sub/cards: Permission denied" in said) == (1, True)
    assert not list((tmp_path / "locked").iterdir())


def test_a_drawing_goes_to_standard_output_at_a_terminal_too_a_tape_does_not(
    call: Call, tmp_path: Path
) -> None:
    assert "standard output is a terminal: send it to a file" in call("pdp8 part drill", terminal=True)[2]
    drawn = call("pdp8 nc plot circle.eia")[1]
    assert drawn.startswith("<svg")
    assert call("pdp8 nc plot circle.eia", terminal=True)[1] == drawn
    assert not list(tmp_path.iterdir())


TEXTS = {
    "own.toml": Path(form.FOLDER, "add.toml").read_bytes(),
    "own.json": student.form(form.read("add")).encode(),
    "own.pal": RIGHT.encode(),
    "own.sym": b"START 0200\n",
    "own.state": state.save(Machine()).encode(),
    "script": b"assert ac 0\n",
    "answers": b"# seen\n0340 | TAD P0 | me, here, now\n",
    "points": b"0 0\n1 1\n2 4\n3 9\n",
    "curve.json": companion.written(Nominal("circle", (4, 4, 1.75)), "").encode(),
}
READ = (
    "check own.toml own.pal; check own.json own.pal; run own.pal; run --restore own.state --max-time 0; "
    "tape info own.state; dis eia.bin --symbols own.sym; monitor script; thesis collate answers; "
    "part fit points; nc plot slope-fewest.eia --profile curve.json; tape punch own.pal"
)


@pytest.mark.parametrize("line", READ.split("; "))
def test_how_an_editor_saves_a_text_means_nothing(line: str, call: Call, tmp_path: Path) -> None:
    """With a byte order mark, or CR LF; before JSON a line may be empty."""
    name = next(word for word in line.split() if word in TEXTS)
    forms = [b"\xef\xbb\xbf%s", b"\n%s"] if TEXTS[name].startswith(b"{") else [b"\xef\xbb\xbf%s"]
    made = [TEXTS[name], TEXTS[name].replace(b"\n", b"\r\n"), *(each % TEXTS[name] for each in forms)]
    seen = set()
    for content in made:
        for each in {**TEXTS, name: content}.items():
            (tmp_path / each[0]).write_bytes(each[1])
        seen.add(call(f"pdp8 {line}"))
    assert len(seen) == 1
    assert seen.pop()[0] < 2


@pytest.mark.parametrize("order", ["utf-16", "utf-16-be"])
def test_what_powershell_wrote_is_named(order: str, call: Call, tmp_path: Path) -> None:
    mark = b"\xfe\xff" if order == "utf-16-be" else b""
    tape = shelf.read_bundled("circle.asc")[:600].decode("cp437")
    (tmp_path / "x.asc").write_bytes(mark + tape.encode(order))
    (tmp_path / "x.pal").write_bytes(mark + RIGHT.replace("\n", "\r\n").encode(order))
    for line in ("run eia.pal --reader x.asc", "run x.pal", "tape info x.asc", "nc cut x.asc"):
        status, _, said = call(f"pdp8 {line}")
        assert status == 1
        assert ": UTF-16, as PowerShell's > writes it; " in said


def test_a_tape_that_begins_with_rubouts_is_not_utf16() -> None:
    assert not is_utf16(b"\xff\xff" * 50)
    assert not is_utf16(b"\xff\xfe" + shelf.read_bundled("circle.asc"))
    assert [is_utf16("A".encode("utf-16")[:count]) for count in (2, 4)] == [False, True]
    assert is_utf16("\u0100\u0100\u0100\xff".encode("utf-16") + b"x")
    assert not is_utf16("\u0100\u0100\u0100\u0100\xff".encode("utf-16"))
    assert is_utf16("\u0100\u0100\u0100\ufffd".encode("utf-16"))


def test_a_closed_pipe_loses_no_named_output(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "half.asc").write_bytes(shelf.read_bundled("circle.asc")[:3000])
    line = "pdp8 run eia.pal --reader half.asc --save s.st --trace t.tr --fast-punch f"
    done = shell(f"{line} | head -c 5 > five; echo ${{PIPESTATUS[0]}}")
    assert done.stdout == b"0\n"
    assert b"the reader of standard output has closed it" in done.stderr
    assert shell("pdp8 run eia.pal --reader half.asc --quiet | true").stderr == b""
    assert state.restore((tmp_path / "s.st").read_text()).instructions > 100
    assert (tmp_path / "t.tr").stat().st_size > 10_000
    assert (tmp_path / "five").read_bytes() == shelf.read_bundled("circle.eia")[:5]
    shell("pdp8 cards all -o c 2>&1 | true; pal eia.pal --listing - -o x.bin 2>&1 | true")
    assert len(list((tmp_path / "c").iterdir())) == 5
    assert (tmp_path / "x.bin").read_bytes() == shelf.read_bundled("eia.bin")


def test_a_word_of_a_file_of_os8s_has_12_bits() -> None:
    assert _packed(b"\xff\x0f", "words") == [0o7777]
    for content in (b"\0\x10", b"\0\0\0"):
        with pytest.raises(WorkError, match="no words of 12 bits"):
            _packed(content, "words")


def test_the_longest_tape_is_taken(call: Call) -> None:
    assert call("pdp8 tape info", bytes(2_097_152))[0] == 0
    assert "standard input: longer than 2,097,152 " in call("pdp8 tape info", bytes(2_097_153))[2]
    assert "/dev/zero: longer than " in call("pdp8 run eia.pal --quiet --reader /dev/zero")[2]


def test_escapes_are_shown_and_valid_in_records(call: Call, tmp_path: Path) -> None:
    escape = "\\u001b[2J\\u0000\\uffff"
    (tmp_path / "own.toml").write_text(
        f'title = "T{escape}"\ntask = "t{escape}"\nsolution = "x"\n[[question]]\nname = "a{escape}"\n'
        f'ask = "?"\nanswer = "1"\nhint = "h{escape}"\n'
    )
    name = "\x1b[31mana.txt"
    (tmp_path / name).write_text("a: 2\x1b[2J\n")
    for line in ("--show task", f"'{name}'"):
        _, out, said = call(f"pdp8 check own.toml {line}", terminal=True)
        assert "␛[2J" in out + said
        assert "\x1b[2J" not in out + said
        assert "\x1b[31m" not in out + said
    assert call(f"pdp8 check own.toml '{name}' --junit x.xml --json x.json")[0] == 1
    assert ElementTree.parse(tmp_path / "x.xml").getroot()[0].attrib["name"] == "␛[31mana.txt"
    assert json.loads((tmp_path / "x.json").read_text())["answers"][0]["answer"] == name
    (tmp_path / "own.pal").write_text("*200\n\tHLT / \x1b[2J\n\tQQ / \x1b[2J\n$\n")
    _, out, said = call("pal own.pal --force --listing -", terminal=True)
    assert "\x1b[2J" not in out + said


def completed(group: click.Command, words: list[str], incomplete: str) -> list[tuple[str, str]]:
    from click.shell_completion import ShellComplete

    found = ShellComplete(group, {}, "pdp8", "_X").get_completions(words, incomplete)
    return [(item.value, item.type) for item in found]


def test_completion_has_files_and_bundled_names(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "eia-mine.pal").touch()
    (tmp_path / "eia-tapes").mkdir()
    (tmp_path / ".hidden").touch()
    assert not [name for name, _ in completed(pdp8, ["run"], "") if name.startswith(".")]
    assert completed(pdp8, ["run"], "eia") == [
        (name, "plain")
        for name in ("eia-mine.pal", "eia-tapes/", "eia.bin", "eia.pal", "eia1.pal", "eia2.pal")
    ]
    assert completed(pal, [], "eia.") == [("eia.bin", "plain"), ("eia.pal", "plain")]
    assert completed(pdp8, ["run"], "mi") == [("mi", "file")]
    assert completed(pdp8, ["run", "eia.pal", "--punch"], "") == [("", "file")]
    assert completed(pdp8, ["cards", "-o"], "") == [("", "dir")]
    assert ("add", "plain") in completed(pdp8, ["check"], "ad")
    assert ("circle.eia", "plain") in completed(pdp8, ["nc", "cut"], "circ")
    for before in ("help", "--version", "nonsense"):
        assert completed(pdp8, [before], "ru") == [("run", "plain")]
    assert completed(pdp8, ["help", "tape"], "sh") == [("show", "plain")]


def test_a_command_that_waits_for_a_terminal_says_so(call: Call) -> None:
    for line in ("nc cut", "tape info", "dis", "tape punch"):
        said = call(f"pdp8 {line}", terminal="stdin")[2]
        assert "waits for standard input, which is this terminal" in said
        assert "waits" not in call(f"pdp8 {line}", terminal="stdout stderr")[2]


@pytest.mark.parametrize("module", ["pdp8.cli.root", "pdp8.cli.run", "pal.assembling"])
def test_ctrl_c_while_a_module_is_imported_is_quiet(module: str, tmp_path: Path) -> None:
    script = (
        "import os, signal, sys, pdp8.cli as cli\n"
        "class Ctrl:\n"
        "    def find_spec(name, path=None, target=None):\n"
        f"        if name == {module!r}: os.kill(os.getpid(), signal.SIGINT)\n"
        "sys.meta_path.insert(0, Ctrl)\n"
        "sys.argv = ['pdp8', 'run', 'hello.pal']\n"
        "cli.main()\n"
    )
    done = commands.run(sys.executable, "-c", script, folder=tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (130, b"", b"")


def test_a_file_keeps_its_mode_and_a_link_its_place(call: Call, tmp_path: Path) -> None:
    (tmp_path / "real.bin").write_bytes(b"")
    (tmp_path / "real.bin").chmod(0o640)
    (tmp_path / "link.bin").symlink_to("real.bin")
    assert call("pal hello.pal -o link.bin")[0] == 0
    assert (tmp_path / "link.bin").is_symlink()
    assert binary.decode((tmp_path / "real.bin").read_bytes()).words
    assert (tmp_path / "real.bin").stat().st_mode & 0o777 == 0o640


@pytest.mark.parametrize(
    ("number", "left"), [(signal.SIGINT, {"x.trace"}), (signal.SIGTERM, set()), (signal.SIGHUP, set())]
)
def test_a_signal_leaves_no_file_half_written(number: int, left: set[str], tmp_path: Path) -> None:
    (tmp_path / "busy.pal").write_text("*200\nL,\tISZ 10\n\tJMP L\n\tJMP L\n$\n")
    run = commands.start("pdp8", "run", "busy.pal", "--trace", "x.trace", folder=tmp_path)
    assert commands.eventually(lambda: any(part.stat().st_size for part in tmp_path.glob("*.part")))
    assert commands.signalled(run, number)[0] == 128 + number
    assert {path.name for path in tmp_path.iterdir()} == {"busy.pal", *left}


@pytest.mark.slow("the afternoon, whole")
def test_page_and_table_share_no_stream(call: Call) -> None:
    _, shown, said = call("pdp8 replay drill --html - --out desk")
    assert shown.startswith("<!DOCTYPE html>")
    assert "thesis beside replay" not in shown
    assert "thesis beside replay" in said


ALIASES = [
    ("pdp8 run eia.pal --punch c.asc", "c.asc is standard input; name another file"),
    ("pdp8 run eia.pal --trace c.asc > o", "c.asc is standard input; name another file"),
    ("pdp8 tape convert - --to eia -o soft", "soft is standard input; name another file"),
    ("pdp8 tape convert --to eia -o ./hard", "./hard is standard input; name another file"),
    ("pal hello.pal -o soft >> c.asc", "soft is standard output, whose name is -; name another file"),
    ("pal hello.pal -o soft 2>> c.asc", "soft is standard error; name another file"),
    ("pdp8 replay drill --out . --html c.asc", "c.asc is standard input; name another file"),
    ("pdp8 cards rim -o there", "there/rim.svg is standard input: it is not replaced; name another"),
    ("pdp8 monitor", "line 1: c.asc is standard input: it is not replaced; name another"),
]


@pytest.mark.parametrize(("line", "refusal"), ALIASES)
def test_a_file_on_a_standard_stream_is_not_replaced(
    line: str, refusal: str, shell: Shell, tmp_path: Path
) -> None:
    content = b"punch c.asc\n" if "monitor" in line else shelf.read_bundled("circle.asc")
    (tmp_path / "c.asc").write_bytes(content)
    (tmp_path / "there").mkdir()
    for name in ("hard", "there/rim.svg"):
        os.link(tmp_path / "c.asc", tmp_path / name)
    os.symlink("c.asc", tmp_path / "soft")
    ran = shell(line if ">>" in line else f"{line} < c.asc")
    assert ran.returncode in (1, 2)
    left = (tmp_path / "c.asc").read_bytes()
    assert left.startswith(content)
    added = left.removeprefix(content)
    assert refusal in (added if "2>>" in line else ran.stderr).decode()
    assert bool(added) == ("2>>" in line)
