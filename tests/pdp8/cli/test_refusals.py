"""What each command refuses, in a line that names the place; every file is left as it was.

A line of the tables: the command, ` -> `, and what it says of it. Status 2, misuse, ends with where help is.
"""

import os
import re
from pathlib import Path
from socket import AF_UNIX, socket

import pytest

from pdp8 import shelf
from tests.conftest import Call
from tests.pdp8.cli.test_root import EVERY
from tests.tapes.strips import FORMAT_BIN

FILES = {
    **dict.fromkeys(("ana.pal", "ben.pal", "ana.pass1", "ana.html"), b"*200\n\tHLT\n$\n"),
    **{"a.bin": FORMAT_BIN, "half": FORMAT_BIN[:100], "cut.bin": shelf.read_bundled("eia.bin")[:200]},
    **{
        "empty": b"",
        "locked": b"",
        "blank": bytes(1),
        "even": b"\n",
        "line": b"A",
        "shout": b"1!\n",
        "a.asc": b"12\r\n",
    },
    **{"mark": b"\xff\xfe", "accent": "1\né".encode(), "in.csv": b"A"},
    "own.toml": b'title = "t"\ntask = "t"\n[[case]]\nname = "a"\nreader = { file = "in.csv" }\n',
}

FAILS = """\
pdp8 tape show nowhere.asc -> : nowhere.asc: no such file, here or among the bundled ones
pdp8 tape show . -> : .: Is a directory
pdp8 tape show -> : standard input: frame 0: empty tape
pdp8 tape show --from 1 blank -> : blank: frame 1: the tape has only 1
pdp8 tape show --svg . blank -> : .: Is a directory
pdp8 tape convert --to rim half -> : half: frame 100: the tape is cut short inside a word
pdp8 tape convert --code eia --to text even -> : even: frame 0: 012 (channels 4 2) is no EIA
pdp8 tape convert --to octal -o no/x a.bin -> : no/x: No such file or directory
pdp8 tape punch mark -> : mark: line 1, column 1: byte 377 is no text
pdp8 tape punch accent -> : accent: line 2, column 1: 'é' is no ASCII character
pdp8 tape punch --code eia shout -> : shout: line 1, column 2: '!' has no EIA code
pdp8 tape punch -o socket line -> : socket: No such device or address
pdp8 run cut.bin -> : cut.bin: frame 200:
pdp8 run eia.pal --reader nowhere.asc -> : nowhere.asc: no such file
pdp8 run --restore empty -> : empty: a saved state begins with
pdp8 run hello.pal --trace . -> : .: Is a directory
pdp8 run hello.pal --punch a.bin --trace /nowhere/x -> : /nowhere/x: No such file or directory
pdp8 run hello.pal --punch a.bin --save /nowhere/x -> : /nowhere/x: No such file or directory
pdp8 run hello.pal --punch a.bin --fast-punch /nowhere/x -> : /nowhere/x: No such file or directory
pdp8 run hello.pal --punch locked -> : locked: Permission denied
pdp8 pal eia.pal -o locked -> : locked: Permission denied
pdp8 tape clean circle.eia -o locked -> : locked: Permission denied
pdp8 run /dev/zero -> : /dev/zero: longer than 2,097,152
pdp8 tape info /dev/zero -> : /dev/zero: longer than 2,097,152
pdp8 pal -o x /dev/zero -> : /dev/zero: longer than 2,097,152
pdp8 run hello.pal --save '' -> : the name of a file is empty
pdp8 dis 'a\0b' -> : a␀b: NUL in the name of a file
pdp8 run eia.pal --line 'a\0b' -> : a␀b: NUL in the name of a file
pdp8 run '\udcff\x1b[31m.pal' -> : \\udcff␛[31m.pal: no such file
pdp8 run eia.pal --reader '\udcff\x1b[31m.pal' -> : \\udcff␛[31m.pal: no such file
pdp8 run empty --boot -> : empty: the program tape is empty
pdp8 check own.toml ana.pal --csv in.csv -> : in.csv was read: it is not replaced
pdp8 cards rim -o line/sub -> : line/sub: Not a directory
pdp8 check add ana.html --pages . -> : ./ana.html was read: it is not replaced
"""

MISUSE = """\
pdp8 tape show --to -1 -> '--to': -1 is not in the range x>=0.
pdp8 tape show --to 1 --from 2 -> --to 1 lies before --from 2
pdp8 tape show --code x -> '--code': 'x' is not one of 'auto', 'bin', 'rim', 'ascii', 'eia',
pdp8 tape hang -> there is no command 'hang'
pdp8 monitr -> there is no command 'monitr'; did you mean monitor?
pdp8 check add --prove a.pal --json x -> is used with EXERCISE and --seed only: leave out ANSWER and --json
pdp8 run hello.pal --force -> --force means nothing for hello.pal: it is no tape that may be damaged.
pdp8 run hello.pal --nonsense -> No such option
pdp8 run a.bin --reader a.asc --punch a.asc -> a.asc is the source; name another file
pdp8 tape clean circle.eia -o circle.eia -> circle.eia is the source; name another file
pdp8 tape convert a.bin --to rim -o ./a.bin -> a.bin is the source; name another file
pdp8 run a.bin --punch hard.bin -> a.bin is the source; name another file
pdp8 run eia.pal --reader a.bin --fast-punch soft.bin -> a.bin is the source; name another file
pdp8 pal a.bin -o soft.bin -> a.bin is the source; name another file
pal ana.pass1 --tty . -> ana.pass1 is the source; name another file
pdp8 check add --junit ana.pal ben.pal -> ana.pal is there, and is no XML
pdp8 check add --json ana.pal ben.pal -> ana.pal is there, and is no JSON
pdp8 check add --export-student ana.pal -> ana.pal is there, and is no JSON
pal --json ana.pal ben.pal -> ana.pal is there, and is no JSON
pal --listing ana.pal ben.pal -> ana.pal is there, and is no text
pal -o ana.pal ben.pal -> ana.pal is there, and is no tape
pdp8 nc plot circle.eia -o ana.pal -> ana.pal is there, and is no SVG
pdp8 tape show --svg ana.pal circle.eia -> ana.pal is there, and is no SVG
"""


def refused(call: Call, row: str, folder: Path) -> tuple[int, str, str]:
    """Call what a row of a table says, in a folder of FILES; return its status, what it said and should."""
    for name, content in FILES.items():
        (folder / name).write_bytes(content)
    (folder / "locked").chmod(0o444)
    os.link("a.bin", "hard.bin")
    os.symlink("a.bin", "soft.bin")
    with socket(AF_UNIX) as device:
        device.bind("socket")
    line, expected = row.split(" -> ")
    status, shown, said = call(line)
    assert shown == ""
    links = dict.fromkeys(("hard.bin", "soft.bin"), FORMAT_BIN)
    left = {path.name: path.read_bytes() for path in folder.iterdir() if not path.is_socket()}
    assert left == FILES | links
    return status, said, expected


@pytest.mark.parametrize("row", FAILS.splitlines())
def test_what_fails_says_why_in_one_line(row: str, call: Call, tmp_path: Path) -> None:
    status, said, expected = refused(call, row, tmp_path)
    assert (status, said.count("\n")) == (1, 1), said
    assert said.startswith(f"{' '.join(row.split()[: 2 + row.startswith('pdp8 tape')])}{expected}")


@pytest.mark.parametrize("row", MISUSE.splitlines())
def test_misuse_is_told_with_where_help_is(row: str, call: Call, tmp_path: Path) -> None:
    status, said, expected = refused(call, row, tmp_path)
    assert status == 2
    assert expected in said.splitlines()[0]
    assert said.startswith(row.split(maxsplit=1)[0])
    assert "--help shows what there is" in said


@pytest.mark.parametrize(
    "path", [path for path, each in EVERY.items() for option in each.params if option.required]
)
def test_what_is_required_is_asked_for(path: str, call: Call) -> None:
    status, _, said = call(path)
    assert (status, ": Missing " in said) == (2, True)


def test_errors_on_one_long_line_are_excerpts_and_counted(call: Call, tmp_path: Path) -> None:
    far = ";".join(f"JMP {at * 128 % 4096:o}" for at in range(8000))
    (tmp_path / "long.pal").write_text(f"*200\n{far}\n$\n")
    status, _, said = call("pal long.pal")
    assert status == 1
    assert len(said) < 60_000
    assert max(map(len, said.splitlines())) < 200
    assert " more errors, " in said


def test_standard_input_has_one_name(call: Call) -> None:
    assert call("pdp8 dis", shelf.read_bundled("eia.bin"))[1].startswith("*200\n")
    for line in ("pdp8 run - --max-time 1", "pal - -o x.bin"):
        _, _, said = call(line, b"*200\n\tQQ\n$\n")
        assert re.search("^standard input:2:2: ", said, re.M), line
