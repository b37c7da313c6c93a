"""The commands `pal` and `dis` as processes: what they write, what they say, how they end."""

import json
import re
import sys
from pathlib import Path

import pytest

import pal
from pal import cli
from pal.cli import AssemblyError
from tests import commands
from tests.conftest import case

EXAMPLES = Path(__file__).parent / "examples"
GOOD = "*200\nA,\tCLA\n\tTAD A\n\tHLT\n$\n"
BAD = "*200\n\tJMP 400\n$\n"
BOLD, PLAIN = "\033[1m", "\033[0m"
LITERAL = "*200\n\tTAD (5)\n\tHLT\n$\n"


def run(*arguments: str | Path, folder: Path, source: bytes = b"") -> commands.Done:
    return commands.run("pal", *arguments, folder=folder, stdin=source)


def dis(*arguments: str | Path, folder: Path) -> commands.Done:
    return commands.run("pdp8", "dis", *arguments, folder=folder)


def assert_one_line(result: commands.Done, status: int, saying: str) -> None:
    error = result.stderr.decode()
    assert result.returncode == status, error
    assert saying in error
    assert "Traceback" not in error
    assert error.count("\n") == 1


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "good.pal").write_text(GOOD)
    (tmp_path / "bad.pal").write_text(BAD)
    return tmp_path


def test_force_gives_decs_tape_and_decs_listing(folder: Path) -> None:
    source = EXAMPLES / "errors.pal"
    run(source, "-o", "X.bin", "--listing", "X.lst", "--force", "--high-speed-reader", folder=folder)
    assert (folder / "X.bin").read_bytes() == source.with_suffix(".bin").read_bytes()
    assert (folder / "X.lst").read_text() == source.with_suffix(".pass3.txt").read_text()


def test_every_source_through_a_pipe_gives_the_same_tape(folder: Path) -> None:
    """DEC's tape of each example; of our cases, which DEC's assembler did not see, ours of the file."""
    for path in [*sorted(EXAMPLES.glob("*.pal")), *sorted(Path(__file__).parent.glob("cases/*.pal"))]:
        with case(path.stem):
            words = ("-", "-o", "-", "--force", "--high-speed-reader", "--dialect", "pal3")
            tape = run(*words, folder=folder, source=path.read_bytes()).stdout
            decs = path.with_suffix(".bin")
            assert tape == (decs.read_bytes() if decs.exists() else pal.assemble(path.read_text()).tape)


def test_the_tape_takes_the_name_of_the_source_or_goes_where_that_came_from(folder: Path) -> None:
    result = run("good.pal", folder=folder)
    assert (result.returncode, result.stdout, result.stderr) == (0, b"", b"wrote good.bin\n")
    assert (folder / "good.bin").read_bytes() == pal.assemble(GOOD).tape
    assert run("-", folder=folder, source=GOOD.encode()).stdout == pal.assemble(GOOD).tape


def test_with_errors_there_is_no_tape_but_with_force(folder: Path) -> None:
    (folder / "bad.bin").write_bytes(b"before")
    result = run("bad.pal", folder=folder)
    assert result.returncode == 1
    assert result.stderr.decode().splitlines() == [
        "bad.pal:2:2: error: IR  0400  AT  0200",
        "    \tJMP 400",
        "    \t^^^",
        "  illegal reference: 0400 is neither on page zero nor on the page of 0200; 0200 is used; "
        "go through a pointer on this page, with I",
        "pal: 1 error: no tape; --force punches it as DEC's assembler did",
    ]
    assert (folder / "bad.bin").read_bytes() == b"before"
    forced = run("bad.pal", "--force", folder=folder)
    assert forced.returncode == 1
    assert forced.stderr.endswith(b"\npal: 1 error; bad.bin punched all the same\n")
    assert (folder / "bad.bin").read_bytes() == pal.assemble(BAD).tape


def test_several_sources_are_one_program(folder: Path) -> None:
    (folder / "one.pal").write_text("*200\n\tJMP B\nPAUSE\n")
    (folder / "two.pal").write_text("B,\tHLT\n\tTAD 400\n$\n")
    result = run("one.pal", "two.pal", "-o", "both.bin", "--force", "--xref", "-", folder=folder)
    assert result.stdout.splitlines()[0] == b"B       0201  two.pal:1         one.pal:2"
    assert b"two.pal:2:2: error: IR  0400  AT  0202" in result.stderr
    assert (folder / "both.bin").read_bytes()[65:75].hex(" ") == "42 00 42 00 2a 01 3c 02 0a 00"


def test_the_reports(folder: Path) -> None:
    options = ["--symbols", "a.sym", "--xref", "a.xref", "--json", "a.json", "--listing", "-"]
    result = run("good.pal", *options, folder=folder)
    assert result.stdout.decode() == pal.assemble(GOOD).listing
    assert (folder / "a.sym").read_text() == "A       0200\n"
    assert (folder / "a.xref").read_text() == (
        "A       0200  2                 3\n"
        "CLA     7200  permanent         2\n"
        "HLT     7402  permanent         4\n"
        "TAD     1000  permanent         3\n"
    )
    report = json.loads((folder / "a.json").read_text())
    assert report["words"] == {"0200": "7200", "0201": "1200", "0202": "7402"}
    assert report["symbols"] == {"A": "0200"}
    line = {"file": "good.pal", "line": 2, "address": "0200", "word": "7200", "source": "A,\tCLA"}
    assert report["lines"][1] == line
    assert report["diagnostics"] == []


def test_rim(folder: Path) -> None:
    run("good.pal", "--rim", folder=folder)
    assert (folder / "good.bin").read_bytes().strip(b"\x80").hex(" ") == "42 00 3a 00 42 01 0a 00 42 02 3c 02"


def test_the_teletypes_tapes(folder: Path) -> None:
    source = EXAMPLES / "asr" / "undefinedletters.pal"
    run(source, "--tty", "tapes", folder=folder)
    for number in (1, 2, 3):
        frames = (folder / "tapes" / f"undefinedletters.pass{number}").read_bytes()
        assert frames == source.with_suffix(f".tty{number}").read_bytes()


def test_modern_folds_small_letters_and_lists_them_as_typed(folder: Path) -> None:
    (folder / "small.pal").write_text("*200\nloop,\tcla cll\n\tJmp Loop\n$\n")
    result = run("small.pal", "--modern", "--listing", "-", folder=folder)
    assert result.returncode == 0
    assert b"0201  5200  \tJmp Loop\n" in result.stdout
    assert b"`pal --modern` reads them as capitals" in run("small.pal", folder=folder).stderr


def test_the_symbol_table_is_full(folder: Path) -> None:
    symbols = "".join(f"A{number}=1\n" for number in range(586))
    (folder / "many.pal").write_text(symbols + "$\n")
    result = run("many.pal", "--force", folder=folder)
    assert b"many.pal:586:1: error: ST  A585    AT  0200\n" in result.stderr
    assert result.stderr.decode().endswith("pal: 1 error: PAL III goes no further, nothing is written\n")
    assert not (folder / "many.bin").exists()
    (folder / "fits.pal").write_text("".join(symbols.splitlines(keepends=True)[:585]) + "$\n")
    assert run("fits.pal", folder=folder).returncode == 0
    assert b"ST  A489" in run("fits.pal", "--high-speed-reader", folder=folder).stderr


def test_strict_takes_notes_for_errors(folder: Path) -> None:
    (folder / "space.pal").write_text("A ,5\n$\n")
    assert run("space.pal", folder=folder).returncode == 0
    (folder / "space.bin").unlink()
    result = run("space.pal", "--strict", folder=folder)
    assert result.returncode == 1
    assert b"space.pal:1:3: note: what stands before this comma is part of the word" in result.stderr
    assert not (folder / "space.bin").exists()


def test_what_pal_iii_never_finishes_writes_nothing(folder: Path) -> None:
    (folder / "deep.pal").write_text("A=B=C=5\n$\n")
    result = run("deep.pal", "--force", "--listing", "deep.lst", "--tty", "tapes", folder=folder)
    assert result.returncode == 1
    assert b"deep.pal:1:7: error: " in result.stderr
    assert sorted(path.name for path in folder.iterdir()) == ["bad.pal", "deep.pal", "good.pal"]


def test_misuse(folder: Path) -> None:
    (folder / "five.pal").write_text(LITERAL)
    for words in ("", "good.pal -o - --listing -", "good.pal -o good.pal", "five.pal --tty tapes"):
        assert run(*words.split(), folder=folder).returncode == 2
    for output in ("-o", "--listing", "--symbols", "--xref", "--json", "--tty"):
        assert b"--check writes nothing" in run("five.pal", "--check", output, "x", folder=folder).stderr
    assert (folder / "good.pal").read_text() == GOOD


def test_without_pygls_an_editor_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delattr(pal, "server", raising=False)
    monkeypatch.setitem(sys.modules, "pal.server", None)
    with pytest.raises(AssemblyError, match=r"^--lsp needs pygls: .*pip install .*lsp"):
        cli.pal.main(["--lsp"], standalone_mode=False)


@pytest.mark.parametrize(
    ("name", "content", "saying"),
    [
        ("empty.pal", b"", "pal: empty.pal: the source is empty"),
        ("blank.pal", b"\0" * 100, "pal: blank.pal: the source is empty"),
        ("data.pal", b"1 2\n3\n", "pal: data.pal: nothing but figures: data, and no PAL source"),
        ("tape.bin", pal.assemble(GOOD).tape, "pal: tape.bin: a tape in BIN, not PAL source"),
    ],
)
def test_what_is_no_source_is_an_error(name: str, content: bytes, saying: str, folder: Path) -> None:
    (folder / name).write_bytes(content)
    assert_one_line(run(name, "-o", "x", folder=folder), 1, saying)
    assert not (folder / "x").exists()


def test_files_that_cannot_be_read_or_written(folder: Path) -> None:
    assert_one_line(run("none.pal", folder=folder), 1, "none.pal: no such file")
    assert_one_line(run(".", folder=folder), 1, "Is a directory")
    assert_one_line(run("good.pal", "-o", "no/where.bin", folder=folder), 1, "no/where.bin")
    assert_one_line(run("good.pal", "--tty", "bad.pal", folder=folder), 1, "bad.pal")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no /dev/full here")
def test_a_full_disk(folder: Path) -> None:
    assert_one_line(run("good.pal", "-o", "/dev/full", folder=folder), 1, "/dev/full: No space left")
    assert_one_line(run("good.pal", "--listing", "/dev/full", folder=folder), 1, "/dev/full: No space left")


def test_dis_and_back(folder: Path) -> None:
    run("good.pal", folder=folder)
    result = dis("good.bin", folder=folder)
    assert result.stdout.decode().splitlines()[:2] == ["*200", "L0200,\t7200\t\t/0200 7200"]
    assert pal.assemble(result.stdout).tape == (folder / "good.bin").read_bytes()


@pytest.mark.parametrize(
    ("content", "saying"),
    [
        (b"", "dis: x.bin: frame 0: empty tape"),
        (b"\x80\x42\x00\x3a", "dis: x.bin: frame 4: the tape is cut short inside a word"),
        (b"\x80\x42\x00\x3a\x00\x00\x00\x80", "dis: x.bin: frame 5: checksum: computed 0174, punched 0000"),
        (b"TEXT", "dis: x.bin: a tape in ASCII, not in BIN or RIM"),
    ],
)
def test_dis_of_a_damaged_tape(content: bytes, saying: str, folder: Path) -> None:
    (folder / "x.bin").write_bytes(content)
    assert_one_line(dis("x.bin", folder=folder), 1, saying)


def test_a_listing_at_a_terminal_is_coloured(folder: Path) -> None:
    terminal = commands.Terminal(
        "env", "-u", "NO_COLOR", "pal", "good.pal", "--listing", "-", folder=folder, TERM="xterm-256color"
    )
    assert terminal.ended() == 0
    shown = terminal.seen.decode()
    assert "\x1b[94mTAD" in shown
    plain = re.sub(r"\x1b\[[0-9;]*m", "", shown).replace("\r\n", "\n")
    plain = plain.removesuffix("wrote good.bin\n")
    assert plain.rstrip() == pal.assemble(GOOD).listing.expandtabs(8).rstrip()


def test_a_pipe_that_is_closed_early_is_no_catastrophe(folder: Path) -> None:
    (folder / "long.pal").write_text("\tCLA\n" * 20_000 + "$\n")
    process = commands.start("pal", "long.pal", "--listing", "-", folder=folder)
    assert process.stdout
    assert process.stderr
    process.stdout.close()
    assert b"Traceback" not in process.stderr.read()
    process.stderr.close()
    process.wait()


def test_check_says_what_is_wrong_and_writes_nothing(folder: Path) -> None:
    (folder / "five.pal").write_text(LITERAL)
    result = run("five.pal", "--check", folder=folder)
    assert (result.returncode, (folder / "five.bin").exists()) == (0, False)
    assert result.stderr.startswith(b"five.pal:1:1: note: taken for PAL8")
    assert run("five.pal", "--check", "--strict", folder=folder).returncode == 1
    refused = run("five.pal", "--check", "--dialect", "pal3", folder=folder)
    assert refused.returncode == 1
    assert refused.stderr.startswith(b"five.pal:2:6: error: IC  0250  AT  0200\n")


def test_colours_are_for_a_terminal_that_may_have_them(folder: Path) -> None:
    (folder / "five.pal").write_text(LITERAL)
    assert b"\033[" not in run("five.pal", "--check", folder=folder).stderr
    for variables, coloured in (({}, True), ({"NO_COLOR": "1"}, False)):
        terminal = commands.Terminal("pal", "five.pal", "--check", folder=folder, TERM="xterm", **variables)
        assert terminal.ended() == 0
        assert (b"\033[" in terminal.seen) is coloured
    shown = run("bad.pal", "--check", "--color", "always", folder=folder).stderr.decode().splitlines()
    assert (
        shown[0] == f"{BOLD}bad.pal:2:2:{PLAIN} \033[31m{BOLD}error:{PLAIN} {BOLD}IR  0400  AT  0200{PLAIN}"
    )
    assert shown[1:3] == ["    \tJMP 400", f"\033[32m    \t^^^{PLAIN}"]
    note = run("five.pal", "--check", "--color", "always", folder=folder).stderr
    assert note.decode().startswith(
        f"{BOLD}five.pal:1:1:{PLAIN} \033[36m{BOLD}note:{PLAIN} {BOLD}taken for PAL8"
    )
