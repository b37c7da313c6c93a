"""The files, the calls that are tried, what an option is given in them, and what cannot show."""

from collections.abc import Mapping, Sequence
from typing import Final

import pdp8
from pdp8 import shelf
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from programs import parts
from tapes import ascii, dectape, eia, octal, os8
from tests.tapes.test_os8 import empty

WORK = """\
/ ECHOES SR, ITS START AND K, THEN THE TAPE IN ITS READER
*200
\tCLA IAC
\tOSR
\tTAD K
\t6131
\tTLS
\tTSF
\tJMP .-1
NEXT,\tKSF
\tJMP .-1
\tKRB
\tOSR
\t6131
\tTLS
\tTSF
\tJMP .-1
\tJMP NEXT
K,\t4
FIELD 0
\tCLA IAC RAL
$
"""
"""FIELD goes on where it stands in PAL III, and from 0200 in PAL8."""
FAST = """\
*200
NEXT,\tRFC
\tRSF
\tJMP .-1
\tRRB
\tPLS
\tPSF
\tJMP .-1
\tCLA
\tISZ COUNT
\tJMP NEXT
\tHLT
COUNT,\t-3
$
"""
LITERAL = "*200\n\tTAD (5)\n\tCLA IAC RAL RAR\n\tHLT\n$\n"
"""PAL8, or PAL III with an error; a word that models do differently."""
OWN = """\
from pdp8.computer.hardware.bus import Device
from pdp8.computer.hardware.fields import BIT, saved
from pdp8.computer.hardware.signals import CLEAR_AC

class Own(Device):
    CODE = 0o13
    fields = saved(flag=BIT)

    def pulse(self, iop, ac, now):
        return CLEAR_AC

    def advance(self, now):
        pass

    def initialize(self, now):
        self.flag = 0
"""
"""A device whose IOTs clear AC."""
_OVERLAY = "*200\n\tTAD (5)\n\tCLA CLL CMA RAL RAR\n*400\n\tTAD (6)\n*200\n\tTAD (7)\n"
"""PAL8 that comes back to a page with literals."""
CIRCLE = parts.part("circle", radius=0.25, tolerance=0.005, technique="piece").replace(" ", "0")
_HEADER = "".join(CIRCLE.splitlines(keepends=True)[:6])
_ALONG = "0076041000400000184\n0086041000403000285\n" + "".join(
    f"{at:03}6{3650 + 50 * at:05}{3994 + 4 * at:05}0{at % 3 + 1:02}{84 + at % 2}\n" for at in range(9, 25)
)
"""Cuts along both axes at once, near a line."""
_SHOP = (
    "900 0 00000 00000 0 02 86\n901 9 03000 03500 0 01 89\n"
    "902 4 06000 06000 0 01 89\n903 6 06000 06900 0 01 85\n904 6 06500 07500 0 03 84\n"
).replace(" ", "")
"""A tool change, a hole that is pecked, a cut along both axes."""
_TAP = "900 1 06000 06000 0 01 89\n901 6 06000 06900 0 01 85\n".replace(" ", "")


_BIN = pdp8.assemble(WORK).tape
_WORD = len(_BIN.rstrip(b"\x80")) - 3
"""A frame of its last word."""


def _tape(blocks: str) -> bytes:
    return eia.encode(blocks)


def _damaged(tape: bytes) -> bytes:
    """Return a tape with a blank row before its second block, which later controls did not read."""
    return tape[:20] + b"\0" + tape[20:]


def _narrow(image: bytes) -> bytes:
    """Return an image with 128 words of each block, as some programs keep it."""
    return b"".join(image[at : at + 256] for at in range(0, len(image), 258))


def _saved() -> bytes:
    machine = Machine()
    machine.load(pdp8.assemble(WORK).words)
    machine.start(0o200)
    machine.teletype.reader.load(b"ABCDEFGHIJKLMNOP")
    machine.run(seconds=0.25)
    return state.save(machine).encode()


FILES: Final[Mapping[str, bytes]] = {
    "work.pal": WORK.encode(),
    "w.pa": b"*200\n$\n",
    "os8.tu56": os8.insert(empty(), "add.pa", os8.from_text("*200")).content(),
    "fast.pal": FAST.encode(),
    "literal.pal": LITERAL.encode(),
    "small.pal": b"*200\n\tcla\n\thlt\n$\n",
    "models.pal": b"*200\n\tCLA CLL CMA RAL RAR\n\thlt\n$\n",
    "all.pal": b"*200\n\tCLA CLL CMA RAL RAR\nPAUSE; 5\n\tHLT\nFIELD 0\n\tCLA\n$\n",
    "wrong.pal": b"*200\n\tcla\nPAUSE; 5\n\tTAD UNDEF\n$\n",
    "overlay.pal": _OVERLAY.encode() + b"$\n",
    "missing.pal": _OVERLAY.encode() + b"\tTAD UNDEF\n$\n",
    "own.py": OWN.encode(),
    "reel.tu56": dectape.blank().content(),
    "os8.dt8": _narrow(os8.insert(empty(), "add.pa", os8.from_text("*200")).content()),
    "full.pal": ("".join(f"A{number}=1\n" for number in range(500)) + "$\n").encode(),
    "cut.bin": _BIN[:-40],
    "sum.bin": bytes([*_BIN[:_WORD], _BIN[_WORD] ^ 1, *_BIN[_WORD + 1 :]]),
    "work.bin": _BIN,
    "work.sym": pdp8.assemble(WORK).symbol_table.encode(),
    "work.state": _saved(),
    "loader.pal": shelf.read_bundled("bin.pal").replace(b"$", b"*7500\n\t1\n$"),
    "in.asc": ascii.encode("ABC\n"),
    "other.asc": b"XYZZYXXYZZYX",
    "typed.txt": b"001 0 00000 00000 0 35 88\n002 9 03000 03500 0 01 89\n",
    "small.eia": _tape(CIRCLE + _SHOP),
    "round.eia": _tape(CIRCLE),
    "hole.eia": _tape(_HEADER + _SHOP),
    "rows.eia": _damaged(_tape(CIRCLE + _SHOP)),
    "line.eia": _tape(_HEADER + _ALONG),
    "part.asc": ascii.encode(parts.part("slope", to_x=4.5, to_y=4.25)),
    "read.txt": b"0340 | TAD P0 | WS, Mills, 2026\n",
    "words.txt": b"A B\n",
    "digits.txt": octal.decode(ascii.encode("1\n")).encode(),
    "points.txt": b"0 0\n1 1\n2 4\n3 9.5\n",
    "outline.csv": b"-1 -1\n1 -1\n1 1\n-1 1\n",
    "tap.eia": _tape(_HEADER + _SHOP + _TAP),
    "answer.pal": shelf.read_bundled("hello.pal"),
    "script.txt": b"load literal.pal\nexamine 200:202\ndeposit 300 7001 6131 7402\ngo 300\nregisters\n"
    b"fast-reader in.asc\n",
}
STDIN: Final = {"run": FILES["in.asc"]}

ENDS: Final = ("--help", "--version", "--no-clobber")
"""Options that end a call before it begins, and one that ends it where a file is there."""

STOPS: Final = {"nc": "--strict"}
"""An option that ends a call where the tape has a fault, and is tried alone."""


def _quick(call: str) -> tuple[str, str]:
    """Return a call of a part program, and the same by the other technique."""
    return call, f"{call} --technique piece"


_FUNCTION = (
    "line.eia --function .08*x-.978 --range 0.1,0.8",
    "line.eia --function .08*x-.978",
    "line.eia --range 0.1,0.8",
)  # fmt: skip

CALLS: Final[Mapping[str, Sequence[str]]] = {
    "run": (
        "work.pal --punch out.tape",
        "work.pal",
        "cut.bin --punch out.tape",
        "sum.bin --save kept.state",
        "work.pal --dectape 0=reel.tu56",
        "sum.bin --punch out.tape",
        "sum.bin --boot --punch out.tape",
        "work.pal --boot --save kept.state",
        "sum.bin --boot --loader loader.pal --punch out.tape",
        "",
        "--restore work.state --punch out.tape",
        "work.pal --boot --punch out.tape",
        "work.pal --trace out.trace",
        "fast.pal",
        "fast.pal --fast-reader in.asc",
        "fast.pal --fast-reader in.asc --reader in.asc --reader other.asc --punch out.tape",
        "fast.pal --fast-punch out.fast --fast-reader in.asc",
    ),
    "monitor": ("script.txt", ""),
    "workbench": ("",),
    "pal": (
        "work.pal", "work.pal -o out.bin", "literal.pal", "small.pal", "full.pal", "literal.pal -o out.bin",
        "literal.pal --listing out.lst", "all.pal", "all.pal -o out.bin", "wrong.pal", "wrong.pal -o out.bin",
        "wrong.pal --dialect pal3", "wrong.pal --dialect pal3 -o out.bin", "overlay.pal",
        "overlay.pal -o out.bin",
        "overlay.pal --dialect pal8", "overlay.pal --dialect pal8 -o out.bin", "missing.pal",
        "missing.pal -o out.bin",
        "missing.pal --dialect pal8", "missing.pal --dialect pal8 -o out.bin", "models.pal", "",
    ),
    "dis": ("work.bin", "sum.bin", "cut.bin"),
    "tape clean": ("small.eia",),
    "tape extract": ("os8.tu56 add.pa",),
    "tape insert": ("os8.tu56 w.pa",),
    "tape cut": ("small.eia",),
    "tape convert": (
        "in.asc --to ascii",
        "in.asc --to text",
        "typed.txt --to ascii",
        "work.bin --to rim",
        "sum.bin --to rim",
        "in.asc",
        "digits.txt --to ascii",
    ),
    "tape punch": ("typed.txt", "words.txt"),
    "tape show": ("in.asc", "in.asc --svg out.svg"),
    "part circle": (
        *_quick("--radius .3"), *_quick("--tolerance .05"), *_quick("--tolerance .05 --cutter .1"),
        *_quick(""),
    ),
    "part ellipse": (
        *_quick("--major .6 --minor .45 --tolerance .05"), *_quick("--tolerance .05"),
        *_quick("--tolerance .05 --cutter .1"), *_quick("--major 2.7"), "--minor 2.1", *_quick(""),
    ),
    "part polynomial": (
        *_quick("--to .2"), *_quick("--tolerance .1"), *_quick("--tolerance .1 --cutter .1"), "--b 2.1", "",
    ),
    "part slope": (*_quick("--tolerance .05"), *_quick("--to-x 5 --to-y 5"), *_quick("")),
    "part curve": (
        *_quick("'x**2/4' --to 1 --tolerance .05"),
        *_quick("'x**2/4' --to 1 --tolerance .05 --cutter .1"),
        *_quick("'x**2/4' --to 1"),
        *_quick("'x**2/4' --tolerance .05"),
        "'x**2/4'",
    ),
    "part profile": (
        *_quick("'.3+0*x' --tolerance .05"), *_quick("'.3+0*x' --tolerance .05 --cutter .1"), "'.3+0*x'",
        "outline.csv", "outline.csv --tolerance .05",
    ),
    "part die": (
        *_quick("--tolerance .05"), "", "--cut rounding", "--cut groove", *_quick("--major .5 --minor .3"),
        "--technique piece", *_quick("--tolerance .05 --cutter .1"),
    ),
    "part fluidic": (
        *_quick("--tolerance .05"),
        *_quick("--tolerance .05 --program control"),
        *_quick("--program control"),
        "",
    ),
    "part drill": ("",),
    "part compare": ("ellipse",),
    "part fit": ("points.txt",),
    "part mirror": ("part.asc",),
    "nc list": ("small.eia", "rows.eia"),
    "nc cut": ("small.eia", "rows.eia", "hole.eia"),
    "nc plot": ("line.eia", "small.eia", "rows.eia", *_FUNCTION),
    "nc inspect": (
        "round.eia", "round.eia --circle 4,4,.25", "round.eia --talysurf out.svg",
        "line.eia", "small.eia", "rows.eia", "line.eia --talysurf out.svg", *_FUNCTION,
        "line.eia --function .08*x-.978 --range 0.1,0.8 --talysurf out.svg",
    ),
    "nc export": (
        "line.eia --gcode", "line.eia --dxf", "hole.eia --gcode", "small.eia --dxf", "rows.eia --gcode",
        "line.eia", "hole.eia", "tap.eia --gcode", "tap.eia --gcode --as-1971",
        *(f"{call} --dxf" for call in _FUNCTION),
        *(f"{call} --dxf".replace("line", "hole") for call in _FUNCTION),
    ),
    "check": (
        "message answer.pal", "message answer.pal --json out.json", "message", "", "decimal answer.pal",
        "decimal work.pal",
    ),
    "cards": ("rim",),
    "replay": ("drill",),
    "thesis make": ("B", ""),
    "thesis numbers": ("",),
    "thesis evidence": ("circle.for",),
    "thesis page": ("",),
    "thesis collate": ("",),
}  # fmt: skip
"""What each command is called with besides the options that are tried."""

_VALUES: Final = {
    "SCRIPT": "script.txt",
    "ANSWERS": "read.txt",
    "NUMBER": "B",
    "tape extract --as": "words",
    "tape insert --as": "tape",
    "--out": "out",
    "--start": "201",
    "--sr": "0102",
    "--reader": "other.asc",
    "--punch": "punched",
    "--fast-reader": "other.asc",
    "--fast-punch": "fast.out",
    "--max-time": "0.45",
    "--loader": "loader.pal",
    "--dialect": "pal8",
    "--device": "own.py:Own",
    "--memory": "8k",
    "--dectape": "0=reel.tu56",
    "--fortran": "reel.tu56",
    "--save-dectape": "0=reel.out",
    "--trace": "trace.out",
    "--annotate": "counts.out",
    "--save": "saved.out",
    "--restore": "work.state",
    "--listing": "listing.out",
    "--symbols": "symbols.out",
    "dis --symbols": "work.sym",
    "--entry": "200",
    "--json": "json.out",
    "--tty": "passes",
    "--for": "8/E",
    "--tape": "small.eia",
    "tape convert --code": "octal",
    "--mend": "1=043",
    "tape punch --title": "AB",
    "--paper": "letter",
    "tape show --cut": "cut.out",
    "--without": "3,5-6",
    "tape cut --from": "1",
    "tape cut --to": "30",
    "tape convert --to": "octal",
    "--parity": "even",
    "--fill": "3",
    "tape punch --code": "eia",
    "--leader": "5",
    "--svg": "svg.out",
    "tape show --code": "bin",
    "tape show --from": "1",
    "tape show --to": "2",
    "--degree": "1",
    "--across": "y",
    "--about": "5",
    "--arithmetic": "ge635",
    "pal --check --w": "an overlay that has no error has notes, with /W and without",
    "pal --strict --w": "the same",
    "part polynomial --arithmetic": "cdc6400",
    "--with": "ieee32",
    "--feed-error": "10",
    "nc cut --feed-error": "10,-10,0",
    "nc plot --feed-error": "10,-10,0",
    "nc inspect --feed-error": "10,-10,0",
    "nc export --feed-error": "10,-10,0",
    "--feed-code": "3",
    "--peck": "0.002",
    "--tool-change": "30",
    "--read-seconds": "1",
    "--passes": "2",
    "--url": "https://example.org/pdp8.html",
    "--circle": "4,4,.26",
    "--ellipse": "4,4,.26,.25",
    "--line": "4.1,4.03,4.8,4.08",
    "--function": ".08*x-.97",
    "--origin": "4.05,5",
    "--range": "0.2,.6",
    "--cutter": "0.25",
    "--tolerance": "0.006",
    "--block": "5",
    "--at": "4,4",
    "--zoom": "20",
    "--talyrond": "talyrond.svg",
    "--talysurf": "talysurf.svg",
    "--stretch": "0,.3",
    "--safe": ".5",
    "--shift": "1,1",
    "--tap": ".05",
    "--profile": ".26+0*x",
    "nc inspect --side": "outside",
    "nc plot --side": "outside",
    "part circle --side": "inside",
    "part ellipse --side": "inside",
    "part die --side": "inside",
    "--show": "task",
    "--csv": "csv.out",
    "--junit": "junit.out",
    "--gradescope": "results.out",
    "--variants": "seeds.out",
    "--pages": "pages",
    "thesis collate --pages": ".",
    "--seed": "5",
    "--cpu": "5",
    "--export-student": "student.out",
    "--html": "page.html",
    "--chapter": "7",
    "--technique": "piece",
    "--fastest": "2",
    "--stop": "inside",
    "--tool": "2",
    "--spindle": "32",
    "--z-feed-point": "2.9",
    "--z-depth": "3.6",
    "--side": "below",
    "part profile --side": "inside",
    "--holes": "2,2",
    "--cut": "rounding",
    "--program": "control",
    "--control": "0.8",
    "part drill --z-feed": "2",
}
"""What an option is given, for one command or for all."""
_LENGTHS: Final = {
    "part circle": {
        "--radius": "1.7", "--outer": "1.757", "--inner": "1.743", "--start-x": "1.5", "--start-y": ".9",
    },
    "part ellipse": {
        "--major": "2.7", "--minor": "2.1", "--outer-major": "3.01", "--outer-minor": "2.257",
        "--inner-major": "2.991", "--inner-minor": "2.243", "--start-x": "2.5", "--start-y": "1.2",
        "--tolerance": ".01",
    },
    "part polynomial": {
        "--a": ".19", "--b": "2.1", "--c": "5.9", "--from": "-.5", "--to": "6", "--tolerance": ".02",
    },
    "part slope": {"--from-x": "4.5", "--from-y": "4.5", "--to-x": "8", "--to-y": "6"},
    "part curve": {"--from": ".5", "--to": "2"},
    "part die": {"--major": "2.775", "--minor": "1.325", "--tolerance": ".01", "--centre-x": "6.5"},
    "part fluidic": {"--axis-x": "6.5", "--base-y": "2"},
}  # fmt: skip
_PLACES: Final = {"--centre-x": "4.5", "--centre-y": "4.5", "--origin-x": "4.5", "--origin-y": "5.5"}


def value(command: str, option: str) -> str:
    """Return what the option is given, nothing for a flag."""
    own = _LENGTHS.get(command, {}).get(option) or _VALUES.get(f"{command} {option}")
    found = own or _VALUES.get(option) or _PLACES.get(option) or ""
    return "" if f"{command} {option}" in _FLAGS else found


_FLAGS: Final = ("nc export --tool-change", "part circle --close", "part ellipse --close")

HIDDEN: Final = {
    "run PROGRAM": "all calls but one have it",
    "check EXERCISE": "the same",
    "thesis collate ANSWERS --pages": "needs pictures of pages: tests/pdp8/thesis/test_collate.py",
    "thesis collate --pages --out": "the same",
    "run --keyboard": "needs a terminal: tests/pdp8/cli/test_terminal.py",
    "run --line": "needs a serial line: tests/pdp8/cli/test_line.py",
    **{
        f"tape convert {two}": "one is for a damaged tape of words, the other is tried with characters"
        for two in (
            *("--code --force", "--to --force", "--parity --force", "--fill --force", "--accept --force"),
            "--mend --force",
        )
    },
    "run --line-bits": "the same",
    "run --line-speed": "the same",
    "run --realtime": "takes time, and changes nothing else",
    "panel": "needs a terminal: tests/pdp8/console/test_command.py",
    "pal --lsp": "serves an editor: tests/pal/test_server.py",
    "pal --check --w": "an overlay that has no error has notes, with /W and without",
    "pal --strict --w": "the same",
    "part polynomial --arithmetic": "few curves show how it rounds: --b 2.1 does, for cdc6400",
    "check --prove --seed": "draws other cases, which the solution does as well",
    "check --cpu": "bounds an answer that is not done: tests/pdp8/lessons/test_bounded.py",
    "tape convert --accept": "needs a tape with a doubtful frame: tests/tapes/test_damage.py",
    "tape clean --accept": "the same",
    "tape read": "photographs take seconds each: tests/tapes/photograph",
    "vectors": "80 MB: tests/pdp8/vectors",
    "run --disk": "needs a program for the disk: tests/pdp8/computer/test_rack.py",
    "run --save-disk": "the same",
    "run --memory --boot": "its program uses one field and no DECtape: tests/pdp8/computer/dectape",
    "run --dectape --boot": "the same",
    "run --dectape --restore": "the same",
    "run --printer": "needs a program that prints: tests/pdp8/computer/test_rack.py",
    "replay --fortran": "needs DEC's tape of PS/8: tests/pdp8/replay/test_fortran.py",
}
"""What cannot show, with the reason: a command, an option of it, or two."""
