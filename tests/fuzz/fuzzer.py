"""Call every command with hostile inputs, in this process, and see that it ends as a command may.

    python -m tests.fuzz.fuzzer --count 1000000 --seed 1

Every 10,000 calls it says how many there were, and how many failures. Parts are called with options alone,
never as they are: a whole circle costs as much as a hundred other calls. What takes long is called seldom, as
RARE says. `panel` has no terminal here: only its arguments are tried, and its own tests sit down at it.

A call is a failure where it raises anything but an exit, shows a traceback or a warning of Python's, ends
with a status other than 0, 1, 2 or 130, takes ten seconds of processor time or two minutes, changes a source,
or leaves a file it was still writing. Each failure is printed with the seed that makes it again:
`--seed SEED --count 1`.
"""

import argparse
import errno
import io
import os
import random
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
import zlib
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from pdp8.cli.root import pdp8
from tapes import ascii, binary, command, rim, shelf

SECONDS = 10
MEMORY = 2 << 30
STATUSES = (0, 1, 2, 130)
LONGEST = 3000
LOOK = 10_000
MEMORY_DISK = "/dev/shm"

WORDS = {0o200 + at: word for at, word in enumerate((0o7300, 0o1205, 0o6046, 0o6041, 0o5203, 0o7402))}
NUMBERS = (
    "0",
    "1",
    "-1",
    "7777",
    "10000",
    "9",
    "1e9",
    "1e308",
    "nan",
    "inf",
    "-inf",
    "0.001",
    "",
    "1,1",
    "é",
)
SCRIPT = (
    *(
        "go 200 0.1",
        "cont 0.1",
        "step 3",
        "cycle 5",
        "registers",
        "page",
        "page more",
        "rim",
        "help",
        "forget",
    ),
    *(
        "examine 200:210",
        "deposit 200 7402",
        "set ac 7777",
        "set hands 0",
        "break 203",
        "watch 200",
        "trace on",
    ),
    *(
        'expect "A" 0.1',
        "until BEL 2 times 0.1",
        "assert ac 0",
        "wait 0.5",
        'type A "B" # C',
        'keyboard "A\\r"',
        "keyboard now abc",
        "key stop",
    ),
    *(
        "reader tape",
        "load tape",
        "load tape force",
        "boot tape",
        "listing tape",
        "restore tape",
        "save state",
    ),
    *("punch out", "punch off", "reader none", "reader stop", "fast-reader tape", "quit", "exit", "run 0.1"),
    *("reader tape\npunch hard", "load soft\npunch tape", "restore tape\nsave no/../tape", "listing -"),
    *("punch script", "save script", "save kept", "punch locked/out", "save no/out", "punch /dev/full"),
    *("punch .", "save -", 'save ""', "reader /dev/zero", 'load "a\0b"', "save \x1b[2J", "watch 0:7777"),
)
OPTIONS = {
    "run": ("--start", "--sr", "--quiet", "--boot", "--force", "--cycles", "--realtime"),
    "tape show": ("--from", "--to", "--code"),
    "tape punch": ("--fill", "--leader", "--code", "--parity", "--drop-spaces", "--keep-spaces"),
    "tape convert": ("--parity", "--fill", "--code"),
    "tape clean": (),
    "tape info": (),
    "dis": (),
    "nc list": ("--modes", "--strict", "--feed-error", "--feed-code"),
    "nc cut": ("--strict", "--feed-error", "--feed-code", "--peck", "--tool-change"),
    "nc plot": ("--block", "--at", "--zoom", "--cutter", "--tolerance", "--circle", "--ellipse", "--line"),
    "nc inspect": ("--cutter", "--tolerance", "--circle", "--function", "--range"),
    "nc export": ("--gcode", "--dxf", "--cutter", "--tolerance"),
    "part fit": ("--degree",),
    "part mirror": ("--across", "--about", "--fill", "--parity"),
    "pal": ("--rim", "--force", "--modern", "--high-speed-reader", "--strict"),
    "nc view": (),
    "tape read": ("--underside",),
    "check": ("--prove", "--show", "--seed", "--cpu"),
    "cards": ("--pdf",),
    "thesis make": (),
    "thesis evidence": (),
    "thesis numbers": ("--chapter",),
    "part compare": ("--major", "--outer", "--cut", "--degree"),
    "vectors": ("--states",),  # of numbers that it refuses: what it writes takes half a minute
    "replay": (),
    "workbench": (),
    "panel": ("--start", "--sr", "--drill", "--kiosk", "--cold"),
}
NAMES = {  # what stands before the tape, or in its place
    "check": ("add", "read-a-frame", "loader", "nothing"),
    "cards": ("rim", "ascii", "afternoon", "nothing"),
    "thesis make": ("2.2", "5.3", "ch2-block", "all.", ""),
    "thesis evidence": ("eia.pal", "circle.for", "tape", "nothing"),
    "part compare": ("circle", "polynomial", "nothing"),
    "replay": ("slope", "drill", "circle", "nothing"),
}
AWKWARD = ("\x1b[31mname", os.fsdecode(b"\xff\xfe"), "n" * 300, "a\0b", " ", "-x", "CON")
"""Names that a file may have, or that a careless program breaks at."""
LINKS = ("hard", "soft", "no/../tape")
"""Other names of the tape; soft is a link to it, hard the same file."""
KEPT = b"kept"
INSTEAD = (
    "-",
    ".",
    "nowhere",
    "no/where",
    "hello.pal",
    "/dev/null",
    "/dev/zero",
    "",
    *AWKWARD,
)  # of the tape, one call in twenty
OUTPUTS = ("out", "out", "tape", "no/out", "/dev/full", ".", *LINKS, *AWKWARD, "kept", "locked/out")
WRITES = (
    *(
        "pal",
        "tape punch",
        "tape read",
        "nc plot",
        "tape convert",
        "tape clean",
        "part mirror",
        "nc view",
        "cards",
    ),
    *("thesis make", "thesis evidence", "thesis numbers", "vectors", "replay", "workbench"),
)
RECORDS = {  # what else is written
    "pal": ("--json", "--listing", "--symbols", "--xref"),
    "check": ("--json", "--junit", "--csv", "--pages", "--export-student"),
    "run": ("--punch", "--count-json", "--save"),
    "tape show": ("--svg",),
    "nc inspect": ("--talyrond", "--talysurf"),
}
RARE = {  # which part of their calls is made
    **dict.fromkeys(
        ("check", "cards", "nc view", "thesis make", "part compare", "vectors", "tape read"), 0.1
    ),
    "workbench": 0.03,
    "replay": 0.01,
}
NO_TAPE = (
    "cards",
    "part compare",
    "thesis numbers",
    "vectors",
    "replay",
    "workbench",
    "thesis make",
    "thesis evidence",
)
PARTS = {
    "circle": (
        "--radius",
        "--outer",
        "--inner",
        "--start-x",
        "--centre-y",
        "--sequence",
        "--arithmetic",
    ),
    "ellipse": ("--major", "--minor", "--outer-major", "--start-y", "--x-feed"),
    "die": ("--major", "--minor", "--centre-x", "--cut"),
    "drill": ("--holes", "--z-depth", "--spindle", "--z-feed"),
    "slope": ("--from-x", "--to-y", "--park-x", "--tool"),
    "polynomial": ("--a", "--b", "--from", "--to", "--cutter", "--side"),
    "fluidic": ("--control", "--axis-x", "--program"),
    "nothing": (),
    "--help": (),
}
MILLING = ("--tolerance", "--technique", "--feed-code", "--fastest", "--feed-error", "--fill", "--parity")
FLAGS = {
    *("--quiet", "--boot", "--force", "--cycles", "--drop-spaces", "--keep-spaces", "--modes", "--strict"),
    *("--gcode", "--dxf", "--rim", "--modern", "--high-speed-reader"),
    *("--prove", "--pdf", "--kiosk", "--cold", "--no-clobber", "--underside"),
}
EXPRESSIONS = (
    "sin(x)",
    "x**2/4",
    "1/x",
    "x",
    "((x",
    "x**x**x",
    "exp(x**9)",
    "__import__('os')",
    "1e999",
    "0*x",
)


class TooLong(BaseException):
    """A call that takes too long."""


def seeds() -> list[bytes]:
    """Return the good inputs that the others are made from."""
    import programs  # noqa: F401 - its files go on the shelf

    section = binary.encode(WORDS)
    names = ("eia.pal", "hello.pal", "echo.pal", "circle.asc", "circle.eia", "eia.bin", "circle.for")
    from pdp8.computer.machine import Machine
    from pdp8.computer.past import state

    return [
        *(shelf.read_bundled(name)[:LONGEST] for name in names),
        section + section,
        section + bytes(9) + b"\x7f\x11\x11\x7f",
        rim.encode(WORDS),
        ascii.encode("001 0 00000 00000 0 35 88\n002 9 03000 00000 0 00 00\n"),
        b"001 0 00000 00000 0 35 88\n\n002 9 03000 00000 0 00 00\n",
        b"*200\n\tCLA CLL\nL,\tISZ 10\n\tJMP L\n\tHLT\n$\n",
        state.save(Machine()).encode(),
        b"",
        b'{"a": ' + b"[" * 20_000,
        b"a = " + b"{a = " * 20_000,
        b"[" + b"a." * 3000 + b"a]",
        b"\xef\xbb\xbf*200\n\tHLT\n$\n",
        "*200\r\n\tHLT / \x1b[2J\r\n$\r\n".encode("utf-16"),
        b"*200\n\tQQ / \x1b[2J\x9b2J\n$\n",
        _picture(40_000, 40_000),
        _picture(64, 64),
    ]


def _picture(width: int, height: int) -> bytes:
    """Return a PNG whose header tells of so many pixels; there are none."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        body = kind + content
        return len(content).to_bytes(4) + body + zlib.crc32(body).to_bytes(4)

    size = width.to_bytes(4) + height.to_bytes(4) + bytes([8, 0, 0, 0, 0])
    picture = chunk(b"IHDR", size) + chunk(b"IDAT", zlib.compress(bytes(1000))) + chunk(b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + picture


def mutated(content: bytes, chance: random.Random) -> bytes:
    """Return `content` cut, doubled, with holes added, pieces moved, or something random instead."""
    frames = bytearray(content)
    for _ in range(chance.choice((0, 1, 1, 2, 5))):
        at = chance.randrange(len(frames) + 1)
        match chance.randrange(8):
            case 0:
                del frames[at:]
            case 1:
                frames = frames + frames
            case 2 if at < len(frames):
                frames[at] ^= 1 << chance.randrange(8)
            case 3:
                frames[at:at] = chance.randbytes(chance.randrange(20))
            case 4:
                del frames[at : at + chance.randrange(50)]
            case 5:
                frames[at:at] = bytes(
                    [chance.choice((0, 0o177, 0o200, 0o377, 10, 13, 0o44))]
                ) * chance.randrange(99)
            case 6:
                return chance.randbytes(chance.randrange(400))
            case _:
                frames = frames[at:] + frames[:at]
    return bytes(frames[: 2 * LONGEST])


def arguments(chance: random.Random) -> list[str]:
    """Return a command line whose input is the file `tape`."""
    name = chance.choice((*OPTIONS, "monitor", "part", "curve", "run"))
    if chance.random() > RARE.get(name, 1):
        name = "run"
    if name == "monitor":
        return ["monitor", "script"]
    if name == "curve":
        line = ["part", "curve", chance.choice(EXPRESSIONS)]
        return line + _options(chance, ("--from", "--to", "--cutter", *MILLING), at_least=1)
    if name == "part":
        part = chance.choice(list(PARTS))
        return ["part", part, *_options(chance, (*PARTS[part], *MILLING), at_least=1)]
    tape = [] if name in NO_TAPE else [chance.choice(INSTEAD) if chance.random() < 0.05 else "tape"]
    outputs = [
        path for path in OUTPUTS if path not in ("tape", *LINKS) or "tape" in tape
    ]  # no source, no damage
    options = _options(chance, OPTIONS.get(name, ()), at_least=name == "vectors")
    line = [*name.split(), *_named(chance, name), *tape, *options]
    if name == "run":
        line = ["run", *tape, "--max-time", "0.2", *line[2:]]
        line += chance.choice(([], ["--reader", "reader"], ["--reader", "reader", "--reader", "tape"]))
        line += chance.choice(
            (
                *([], [], ["--trace", "out.trace"], ["--save", "out.state"], ["--fast-punch", "out.fast"]),
                *(["--fast-reader", "reader"], ["--annotate", "out.counts"], ["--count-json", "out.json"]),
                *(["--count"], ["--loader", "reader"], ["--tty", chance.choice(outputs)]),
            )
        )
        if chance.random() < 0.1:
            line[1:2] = ["--restore", *tape]
    if name == "tape convert":
        line += ["--to", chance.choice(("text", "ascii", "eia", "bin", "rim", "octal", "frames"))]
    if name == "nc export" and chance.random() < 0.7:
        line += ["--gcode"]
    if name in WRITES and chance.random() < 0.8:
        line += ["-o", chance.choice(outputs)]
    if name in RECORDS and chance.random() < 0.5:
        line += [chance.choice(RECORDS[name]), chance.choice(outputs)]
    if name in WRITES and chance.random() < 0.1:
        line += ["--no-clobber"]
    if name == "replay":
        line += chance.choice(([], ["--html", chance.choice(outputs)]))
    return line


def _named(chance: random.Random, name: str) -> list[str]:
    return [chance.choice(NAMES[name])] if name in NAMES else []


def _options(chance: random.Random, options: tuple[str, ...], at_least: int = 0) -> list[str]:
    line: list[str] = []
    for option in chance.sample(options, min(len(options), max(at_least, chance.choice((0, 0, 1, 2))))):
        line += [option] if option in FLAGS or chance.random() < 0.02 else [option, chance.choice(NUMBERS)]
    return [word for word in line if word != "--realtime"]


def prepare(chance: random.Random, good: list[bytes]) -> dict[str, bytes]:
    """Return the files of one call."""
    lines = "\n".join(chance.choice(SCRIPT) for _ in range(chance.randrange(8)))
    if chance.random() < 0.3:
        lines += "\n" + "".join(
            chr(chance.choice((chance.randrange(128), 0o42, 0o134, 0xE9))) for _ in range(30)
        )
    return {
        "tape": mutated(chance.choice(good), chance),
        "reader": mutated(chance.choice(good), chance),
        "script": lines.encode("utf-8", "replace"),
    }


@contextmanager
def limited() -> Iterator[None]:
    """Raise TooLong inside after SECONDS of processor time, or of silence twelve times as long."""

    def over(*_: object) -> None:
        raise TooLong

    timers = (
        (signal.SIGPROF, signal.ITIMER_PROF, SECONDS),
        (signal.SIGALRM, signal.ITIMER_REAL, 12 * SECONDS),
    )
    before = [signal.signal(number, over) for number, _, _ in timers]
    for _, timer, seconds in timers:
        signal.setitimer(timer, seconds)
    try:
        yield
    finally:
        for (number, timer, _), handler in zip(timers, before, strict=True):
            signal.setitimer(timer, 0)
            signal.signal(number, handler)


class Stream(io.TextIOWrapper):
    """A stream kept in memory, or a pipe that nobody reads."""

    closed_pipe = False

    def __init__(self) -> None:
        super().__init__(_Kept(self), encoding="utf-8", write_through=True)


class _Kept(io.BytesIO):
    """What a stream was given."""

    def __init__(self, stream: Stream) -> None:
        super().__init__()
        self._stream = stream

    def write(self, content: Any) -> int:
        if self._stream.closed_pipe:
            raise BrokenPipeError(errno.EPIPE, "Broken pipe")
        return super().write(content)


@cache
def streams() -> tuple[Stream, Stream]:
    """Return a standard output and error for all calls: click keeps every stream it has written to."""
    return Stream(), Stream()


def called(line: list[str], closed: bool = False) -> tuple[int | str, str]:
    """Call the command, with nobody to read its output where `closed`; return its status, or what it raised,
    and what it said.
    """
    before = sys.stdin, sys.stdout, sys.stderr
    out, said = streams()
    for stream in (out, said):
        stream.seek(0)
        stream.truncate()
    out.closed_pipe = closed
    status: int | str
    with open("reader") as stdin, limited():
        sys.stdin, sys.stdout, sys.stderr = stdin, out, said
        try:
            status = command.status(pdp8, "pdp8", line)
        except TooLong:
            status = f"longer than {SECONDS} s"
        except BaseException:
            status = traceback.format_exc()
        finally:
            sys.stdin, sys.stdout, sys.stderr = before
    assert isinstance(said.buffer, io.BytesIO)
    return status, said.buffer.getvalue().decode("utf-8", "replace")


def fault(seed: int, good: list[bytes]) -> str:
    """Make the call of `seed` in the current, empty folder; return what is wrong with it, "" for nothing."""
    chance = random.Random(seed)
    files = prepare(chance, good)
    for name, content in files.items():
        Path(name).write_bytes(content)
    line = arguments(chance)
    os.link("tape", "hard")
    os.symlink("tape", "soft")
    os.mkdir("locked")
    os.chmod("locked", 0o555)
    Path("kept").write_bytes(KEPT)
    os.chmod("kept", 0o444)
    status, said = called(line, closed=chance.random() < 0.1)
    wrong = ""
    if status not in STATUSES or "Traceback" in said or "Warning: " in said or "\x1b" in said:
        wrong = f"ended with {status}\n{said[-500:]}"
    if Path("kept").read_bytes() != KEPT or os.listdir("locked"):
        wrong += "\nwrites where it has no permission"
    for name in os.listdir():
        if name.endswith(".part"):
            wrong += f"\nleaves {name}"
        if os.path.isdir(name):
            shutil.rmtree(name)
        elif name not in files:
            os.unlink(name)
    for name, content in files.items():
        if Path(name).read_bytes() != content:
            wrong += f"\nchanges {name}"
    return f"seed {seed}: pdp8 {' '.join(line)}: {wrong}" if wrong else ""


def fuzz(
    count: int, seed: int, say: Callable[[str], object], progress: Callable[[int, int], object] | None = None
) -> int:
    """Make `count` calls from `seed` on; `say` each failure; return how many there were.

    `progress` is called every LOOK calls with the calls and the failures so far.
    """
    good = seeds()
    home, failures = os.getcwd(), 0
    with tempfile.TemporaryDirectory(dir=MEMORY_DISK if os.path.isdir(MEMORY_DISK) else None) as folder:
        os.chdir(folder)
        try:
            for done in range(1, count + 1):
                wrong = fault(seed + done - 1, good)
                if wrong:
                    failures += 1
                    say(wrong)
                if progress and done % LOOK == 0:
                    progress(done, failures)
        finally:
            os.chdir(home)
    return failures


def main() -> None:
    """Fuzz from the command line."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    began = time.monotonic()
    kinds: Counter[str] = Counter()

    def say(wrong: str) -> None:
        kinds[wrong.strip().splitlines()[-1][:100]] += 1
        print(wrong, flush=True)

    def progress(calls: int, failures: int) -> None:
        print(f"{calls:,} calls in {time.monotonic() - began:.0f} s: {failures} failures", flush=True)

    progress(given.count, fuzz(given.count, given.seed, say, progress))
    for kind, times in kinds.most_common(20):
        print(f"{times:7}  {kind}")
    sys.exit(bool(kinds))


if __name__ == "__main__":
    main()
