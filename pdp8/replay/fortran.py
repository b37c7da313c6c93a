"""The afternoon with the part program in DEC's own 8K FORTRAN II, where Toronto's terminal stood.

    listing ──► reader, PIP ──► FORT, SABR ──► LOADER ──► run, PUNCH ON ──► tape with points ──► eia.pal

PS/8 on an 8/L with 8K (MC8/L) and one DECtape. The listing is changed in three ways: sequence numbers and
remarks go, and labels stand in columns 1 to 5; PRINT n is WRITE (1,n); I-formats are F-formats a column
wider, because I prints the first word of a REAL. F prints a point behind each number, which eia.pal drops.

It is our experiment: nothing says that the 8/L of 1971 had 8K or a DECtape.
"""

import re
from collections.abc import Callable, Iterator
from itertools import zip_longest
from typing import Final

from pdp8 import shelf
from pdp8.computer.dectape.tc08 import TC08
from pdp8.computer.hardware.teletype import Teletype
from pdp8.computer.machine import Machine
from pdp8.computer.stop import Reason
from pdp8.computer.use import bootstrap
from pdp8.computer.use.keys import sent
from pdp8.replay.afternoon import Afternoon
from pdp8.replay.day import PACE, Act, Kind
from tapes import ascii
from tapes.dectape import Image
from tapes.errors import WorkError
from tapes.text import lines_of

LISTINGS: Final = ("circle", "ellipse")
"""The parts whose listing the thesis has."""

_MARK: Final = re.compile(r"\s+(RESTORED|DAMAGED|CONJECTURE)\s*$")
_LINE: Final = re.compile(r"\d+\s+(?:(\d+) )?\s*(.*?)(?:\s+/[A-Z].*)?$")
_FORMATS: Final = {
    "FORMAT(1X,I5,I4,I5,I4)": "FORMAT(1X,F6.0,F5.0,F6.0,F5.0)",
    "FORMAT(I3,I1,I5,I5,I3,I2)": "FORMAT(F4.0,F2.0,F6.0,F6.0,F4.0,F3.0)",
}
_PAUSE: Final = 0.5
"""Seconds before a line is typed: what comes while the line feed is printed is lost."""
_LOADING: Final = 20
"""Seconds after which PUNCH goes ON: the program is being loaded, and prints nothing yet."""
_CTRL_Z: Final = "\x1a"
_BOOTED: Final = 20
"""Seconds after which a tape that has not booted never will."""
_DOT: Final = "\r\n."
"""What PS/8 types when a program has ended."""


def source(listing: str) -> str:
    """Return a listing of the thesis as DEC's 8K FORTRAN II takes it."""
    lines = [_MARK.sub("", line) for line in lines_of(listing) if not re.match(r"\d+C", line)]
    found = [match.groups("") for match in map(_LINE.match, lines) if match]
    statements = [
        (label, _FORMATS.get(said, re.sub(r"^PRINT (\d+),", r"WRITE (1,\1) ", said))) for label, said in found
    ]
    return "".join(f"{label:5} {said}\n" for label, said in statements)


def rack(reel: Image) -> Machine:
    """Return an 8/L of 8K with a DECtape, and `reel` on drive 0."""
    machine = Machine([Teletype(), control := TC08()], memory=0o20000)
    control.drives[0].mount(reel)
    return machine


class Session:
    """A session with PS/8 at the Teletype of `machine`."""

    def __init__(self, machine: Machine) -> None:
        self.machine = machine
        self.teletype = machine.teletype

    @property
    def paper(self) -> str:
        """What was typed."""
        return bytes(frame & 0o177 for frame in self.teletype.printer.frames).decode("ascii")

    def type(self, line: str, prompt: str = "", ended: str = "\r") -> Iterator[None]:
        """Type a line, and run until the program has typed `prompt` and waits."""
        self.machine.wait(_PAUSE)
        self.teletype.keyboard.press(sent(line + ended))
        if prompt:
            yield from self.until(prompt)

    def until(self, prompt: str, most: float = 7200) -> Iterator[None]:
        """Run until the program waits. Raises WorkError if it has not typed `prompt` after `most` seconds."""
        ends = self.machine.elapsed + most
        while (reason := self.machine.run(10).reason) is Reason.LIMIT and self.machine.elapsed < ends:
            yield
        if not self.paper.endswith(f"\n{prompt}") and not self.paper.endswith(f"{_CTRL_Z}{prompt}"):
            last = self.paper[-60:].strip()
            raise WorkError(f"PS/8 on the DECtape is expected to type {prompt!r}; {reason} after {last!r}")


class Own(Afternoon):
    """The day of `part`, a circle or an ellipse, on an 8/L that has PS/8 on the DECtape `reel`."""

    def __init__(self, part: str, reel: Image, tell: Callable[[Act], object]) -> None:
        super().__init__(part, tell, rack(reel))
        self.session = Session(self.machine)
        self.program = source(shelf.read_bundled(f"{part}.for").decode())

    def _punch(self) -> Iterator[None]:
        """Make the ASCII tape by the FORTRAN of PS/8."""
        name, teletype = self.part[:6].upper(), self.machine.teletype
        teletype.punch.on = False
        for at, words in bootstrap.bootstrap().items():
            yield from self.operator.toggle(at, words)
        self.operator.begin(bootstrap.BOOT)
        yield from self.session.until(".", _BOOTED)
        self._done("PS/8 booted", "its dot")
        yield from self._enter(name)
        self._done("Source read", f"{len(lines_of(self.program))} lines into {name}.FT")
        yield from self.session.type("R FORT", "*")
        yield from self.session.type(f"{name}<{name}", ".")
        self._done("Compiled", "by FORT and SABR, no error")
        yield from self.session.type("R LOADER", "*")
        yield from self.session.type(f"{name}/G")
        self.machine.run(_LOADING)
        teletype.punch.on = True
        typed = len(self.session.paper)
        while len(self.session.paper) == typed:
            self.machine.run(1)
            yield
        self._done("Loaded", "PUNCH ON")
        yield from self.session.until(".")
        self._done("Run", self._tear_off())
        self.minutes["punch"] = self.minutes.pop("Run")
        self.operator.stop()

    def _enter(self, name: str) -> Iterator[None]:
        """Let PIP copy the source from the reader into a file, up to its CTRL/Z."""
        reader = self.machine.teletype.reader
        yield from self.session.type("R PIP", "*")
        yield from self.session.type(f"{name}.FT<TTY:", "")
        self.machine.run(PACE.mounting)
        tape = self.tapes[f"{name}.ft".lower()] = ascii.encode(self.program + _CTRL_Z, fill=0)
        reader.load(tape)
        yield from self.session.until("*")
        reader.remove()
        yield from self.session.type("\x03", ".", ended="")

    def _tear_off(self) -> str:
        """Remove the tape without the dot that PS/8 typed at its end; return its text."""
        tape = self.tapes[f"{self.part}.asc"] = self.machine.teletype.punch.tape[: -len(_DOT)]
        printed = lines_of(ascii.decode(tape).replace(".", "").lstrip("\n"))
        pairs = zip_longest(printed, lines_of(self.text))
        return f"{len(printed)} lines, {sum(one != two for one, two in pairs)} other than Toronto's"

    def _done(self, name: str, outcome: str) -> None:
        """Record an act, and the minutes it took."""
        self._act(Kind.TERMINAL, name, f"PS/8 on the 8/L itself: {outcome}.", outcome)
        self.minutes[name] = self.acts[-1].seconds / 60
