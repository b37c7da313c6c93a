"""Call every command with hostile inputs, in this process, and see that it ends as a command may.

    python -m tests.fuzz.fuzzer --count 1000000 --seed 1

Commands and options are those that there are, as click has them. Parts are never called as they are: a whole
circle costs as much as a hundred other calls; what takes long is called seldom, as RARE says. `panel` has no
terminal here.

A call is a failure where it raises anything but an exit, shows a traceback or a warning of Python's, ends
with a status other than 0, 1, 2 or 130, takes ten seconds of processor time or two minutes, changes a source
or the file on its standard input, or leaves a file it was still writing. Each failure is printed with the
seed that makes it again: `--seed SEED --count 1`.
"""

import argparse
import errno
import io
import os
import random
import resource
import signal
import sys
import tempfile
import traceback
from collections.abc import Iterator, Sequence
from contextlib import ExitStack, chdir, contextmanager
from functools import cache
from pathlib import Path
from typing import Any
from unittest.mock import patch

import click
from PIL import Image

from pdp8 import shelf
from pdp8.cli.root import pdp8
from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Folder, Source, Target
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from release.reference import commands as walk
from tapes import ascii, binary, rim

SECONDS = 10
MEMORY = 2 << 30
STATUSES = (0, 1, 2, 130)
LONGEST = 3000

WORDS = {0o200 + at: word for at, word in enumerate((0o7300, 0o1205, 0o6046, 0o6041, 0o5203, 0o7402))}
NUMBERS = ["0", "1", "-1", "7777", "10000", "9", "1e9", "1e308", "nan", "inf", "-inf", "0.01", "1,1", "é", ""]
SCRIPT = (
    *r"""
    go 200 0.1; cont 0.1; run 0.1; step 3; cycle 5; registers; page; page more; rim; help; forget; quit; exit
    examine 200:210; deposit 200 7402; set ac 7777; set hands 0; break 203; watch 200; watch 0:7777; trace on
    expect "A" 0.1; until BEL 2 times 0.1; assert ac 0; wait 0.5; type A "B" # C; keyboard "A\r"; key stop
    keyboard now abc; reader tape; load tape; load tape force; boot tape; listing tape; listing -
    restore tape; save state; punch out; punch off; reader none; reader stop; fast-reader tape
    punch script; save script; save kept; punch locked/out; save no/out; punch /dev/full; punch .; save -
    save ""; reader /dev/zero
    """.replace("\n", ";").split(";"),
    *("reader tape\npunch hard", "load soft\npunch tape", "restore tape\nsave no/../tape"),
    *('load "a\0b"', "save \x1b[2J"),
)
NAMES = {  # what a command takes that is no file
    "check": ("add", "read-a-frame", "loader", "nothing"),
    "cards": ("rim", "ascii", "afternoon", "nothing"),
    "thesis make": ("2.2", "5.3", "ch2-block", "all.", ""),
    "thesis evidence": ("eia.pal", "circle.for", "nothing"),
    "part compare": ("circle", "polynomial", "nothing"),
    "part curve": (
        *("sin(x)", "x**2/4", "1/x", "((x", "x**x**x", "exp(x**9)", "__import__('os')", "1e999", "0*x"),
    ),
    "replay": ("slope", "drill", "circle", "nothing"),
    "monitor": ("script",),
}
AWKWARD = ("\x1b[31mname", os.fsdecode(b"\xff\xfe"), "n" * 300, "a\0b", " ", "-x", "CON")
"""Names that a file may have, or that a careless program breaks at."""
LINKS = ("hard", "soft", "no/../tape")
"""Other names of the tape; soft is a link to it, hard the same file."""
AGAIN = ("again", "round")
"""Other names of the file on standard input, which is called reader."""
KEPT = b"kept"
INSTEAD = ("-", ".", "nowhere", "no/where", "hello.pal", "/dev/null", "/dev/zero", "", *AWKWARD)
"""What stands in the place of a source, one time in twenty."""
OUTPUTS = (
    *("out", "out", "tape", "no/out", "/dev/full", ".", *LINKS, *AWKWARD, "kept", "locked/out"),
    *("reader", "again", "./reader", "round"),
)
RARE = {  # which part of their calls is made
    **dict.fromkeys(("check", "cards", "part compare", "tape read"), 0.1),
    **{"thesis make": 0.1, "workbench": 0.03, "thesis page": 0.03, "replay": 0.01},
}
NEVER = ("dap", "vectors", "--realtime", "--lsp", "--version", "--help")
"""Commands and options that are not called: they wait for an editor or the clock, or take long."""


class TooLong(BaseException):
    """A call that takes too long."""


def inputs() -> list[bytes]:
    """Return the good inputs that the others are made from."""
    section = binary.encode(WORDS)
    Image.new("L", (64, 64)).save(picture := io.BytesIO(), "PNG")
    names = ("eia.pal", "hello.pal", "echo.pal", "circle.asc", "circle.eia", "eia.bin", "circle.for")
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
        picture.getvalue(),
        picture.getvalue().replace((64).to_bytes(4) * 2, (40_000).to_bytes(4) * 2),
    ]


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
                hole = chance.choice((0, 0o177, 0o200, 0o377, 10, 13, 0o44))
                frames[at:at] = bytes([hole]) * chance.randrange(99)
            case 6:
                return chance.randbytes(chance.randrange(400))
            case _:
                frames = frames[at:] + frames[:at]
    return bytes(frames[: 2 * LONGEST])


@cache
def commands() -> dict[str, click.Command]:
    """Return every command by its name, as `tape show`."""
    found = {each.command_path[5:]: each.command for each in walk(click.Context(pdp8, info_name="pdp8"))}
    return {
        name: each for name, each in found.items() if not isinstance(each, click.Group) and name not in NEVER
    }


def arguments(chance: random.Random) -> list[str]:
    """Return a command line whose inputs are the files `tape` and `reader`."""
    name = chance.choice([*commands(), "run", "monitor"])
    if chance.random() > RARE.get(name, 1):
        name = "run"
    words = [chance.choice(NAMES[name])] if name in NAMES else []
    options: list[click.Option] = []
    for param in commands()[name].params[len(words) :]:
        if isinstance(param, click.Argument):
            words += _value(chance, param, OUTPUTS)
        elif isinstance(param, click.Option) and param.opts[-1] not in NEVER:
            options.append(param)
    no_source = () if "tape" in words else ("tape", *LINKS)  # and so no damage to it
    outputs = [path for path in OUTPUTS if path not in no_source]
    at_least = name.startswith("part")
    for option in chance.sample(options, min(len(options), max(at_least, chance.choice((0, 0, 1, 2, 3))))):
        words += [option.opts[-1], *([] if option.is_flag else _value(chance, option, outputs))]
    return [*name.split(), *words, *(("--max-time", "0.2") if name == "run" else ())]


def _value(chance: random.Random, param: click.Parameter, outputs: Sequence[str]) -> list[str]:
    """Return what a parameter is given: seldom nothing."""
    if chance.random() < 0.05:
        return []
    if isinstance(param.type, Source):
        return [chance.choice(INSTEAD if chance.random() < 0.05 else ("tape", "reader"))]
    if isinstance(param.type, Target | Folder):
        return [chance.choice(outputs)]
    if isinstance(param.type, click.Choice) and chance.random() < 0.5:
        return [str(chance.choice(param.type.choices))]
    return [chance.choice(NUMBERS) for _ in range(max(1, param.nargs))]


def prepare(chance: random.Random, good: list[bytes]) -> dict[str, bytes]:
    """Return the files of one call."""
    lines = "\n".join(chance.choice(SCRIPT) for _ in range(chance.randrange(8)))
    if chance.random() < 0.3:
        codes = [chance.choice((chance.randrange(128), 0o42, 0o134, 0xE9)) for _ in range(30)]
        lines += "\n" + "".join(map(chr, codes))
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

    with ExitStack() as stack:
        for number, timer, seconds in (
            (signal.SIGPROF, signal.ITIMER_PROF, SECONDS),
            (signal.SIGALRM, signal.ITIMER_REAL, 12 * SECONDS),
        ):
            stack.callback(signal.signal, number, signal.signal(number, over))
            stack.callback(signal.setitimer, timer, 0)
            signal.setitimer(timer, seconds)
        yield


class Kept(io.BytesIO):
    """What a stream was given, or a pipe that nobody reads."""

    closed_pipe = False

    def write(self, content: Any) -> int:
        if self.closed_pipe:
            raise BrokenPipeError(errno.EPIPE, "Broken pipe")
        return super().write(content)


OUT, SAID = Kept(), Kept()
STREAMS = [io.TextIOWrapper(kept, encoding="utf-8", write_through=True) for kept in (OUT, SAID)]
"""Standard output and error of all calls: click keeps all that it has written to."""


def called(line: list[str], closed: bool = False) -> tuple[int | str, str]:
    """Call the command, with nobody to read its output where `closed`; return its status, or what it raised,
    and what it said.
    """
    for kept in (OUT, SAID):
        kept.seek(0)
        kept.truncate()
    OUT.closed_pipe = closed
    status: int | str
    stdout, stderr = STREAMS
    with open("reader") as stdin, patch.multiple(sys, stdin=stdin, stdout=stdout, stderr=stderr), limited():
        try:
            status = command.status(pdp8, "pdp8", line)
        except TooLong:
            status = f"longer than {SECONDS} s"
        except BaseException:
            status = traceback.format_exc()
    return status, SAID.getvalue().decode("utf-8", "replace")


def fault(seed: int, good: list[bytes]) -> str:
    """Make the call of `seed` in the current, empty folder; return what is wrong with it."""
    chance = random.Random(seed)
    files = prepare(chance, good)
    for name, content in files.items():
        Path(name).write_bytes(content)
    line = arguments(chance)
    os.link("tape", "hard")
    os.symlink("tape", "soft")
    os.link("reader", AGAIN[0])
    os.symlink("reader", AGAIN[1])
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
    wrong += "".join(f"\nleaves {name}" for name in os.listdir() if name.endswith(".part"))
    wrong += "".join(f"\nchanges {name}" for name in files if Path(name).read_bytes() != files[name])
    return f"seed {seed}: pdp8 {' '.join(line)}: {wrong}" if wrong else ""


def failures(seeds: range) -> Iterator[str]:
    """Make the call of each seed in a folder of its own, in memory; yield what is wrong."""
    good = inputs()
    memory = "/dev/shm" if os.path.isdir("/dev/shm") else None
    for seed in seeds:
        with tempfile.TemporaryDirectory(dir=memory) as folder, chdir(folder):
            wrong = fault(seed, good)
        if wrong:
            yield wrong


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--count", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    wrong = 0
    for failure in failures(range(given.seed, given.seed + given.count)):
        print(failure, flush=True)
        wrong += 1
    print(f"{given.count:,} calls: {wrong} failures")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
