"""Which part programs there are: the registry that the commands and the replay ask.

A new part program is a file with a function `part(...)` and an entry here.

Sources: thesis, Chapter 3 and Chapters 6 to 8.
"""

from collections.abc import Callable, Mapping
from importlib import import_module
from inspect import signature
from types import SimpleNamespace
from typing import Any, Final, NamedTuple

from tapes.errors import WorkError
from tapes.nominal import Nominal

NO_VALUES: Final[Mapping[str, Any]] = {}


class Part(NamedTuple):
    """A part program with examples of its options; `instrument` measured it in the thesis, `cutter` is its
    path's diameter in inches, `file` describes a file that may replace an expression.
    """

    name: str
    summary: str
    examples: tuple[str, ...]
    instrument: str | None = None
    cutter: float = 0.5
    has_defaults: bool = True
    file: str = ""

    def program(self) -> Callable[..., str]:
        """Import the part program and return its function: its constants as keywords, to its printout."""
        program: Callable[..., str] = import_module(f"programs.{self.name}").part
        return program

    def nominal(self, values: Mapping[str, Any] = NO_VALUES) -> Nominal | None:
        """Return the curve that the part follows, None if it is no single curve. Raises WorkError."""
        from programs.nominals import NOMINALS

        if self.name not in NOMINALS:
            return None
        defaults = {name: each.default for name, each in signature(self.program()).parameters.items()}
        made = NOMINALS[self.name](SimpleNamespace(**{**defaults, **values}))
        return made._replace(cutter=made.cutter or self.cutter) if made else None


PARTS: Final = {
    part.name: part
    for part in (
        Part(
            "circle",
            "The 4 in circle of Appendix C.",
            ("> circle.asc", "--radius 1 --tolerance 0.003", "--spindle 35 -o fast.asc"),
            instrument="Talyrond",
        ),
        Part(
            "ellipse",
            "The 6 x 4 1/2 in ellipse of Appendix D.",
            ("> ellipse.asc", "--arithmetic ge635", "--minor 1.5 --technique piece"),
        ),
        Part(
            "polynomial",
            "The third degree polynomial of Chapters 6 and 7.",
            ("> polynomial.asc", "--b 1.5 --c 5 --to 5", "--cutter 0.5 --side above --technique piece"),
        ),
        Part(
            "slope",
            "A slope, by default that of Chapter 3: 30 degrees, 5 in long.",
            ("> slope.asc", "--to-x 6 --to-y 9", "--technique piece --feed-error 10"),
        ),
        Part(
            "curve",
            "Any function of x.",
            ("'sin(x)' --to 6.283 > sine.asc", "'x**2/4' --from -2 --to 2 --tolerance 0.01 --cutter 0.5"),
            has_defaults=False,
        ),
        Part(
            "profile",
            "A closed profile, such as a cam: the radius as a function of the angle.",
            (
                "'1.5+0.25*cos(x)' --cutter 0.25 > cam.asc",
                "'1.2+0.1*sin(3*x)' --cutter 0.125 --side inside",
                "outline.csv --cutter 0.25 --stop inside > outline.asc",
            ),
            has_defaults=False,
            file="a file of the outline's points, x and y from the centre on each line, as a spreadsheet or "
            "CAD program writes it, with straight lines between them",
        ),
        Part(
            "die",
            "The die of Chapter 7: ellipses of three sets of axes.",
            ("> opening.asc", "--cut groove", "--technique piece --fastest 8"),
        ),
        Part(
            "drill",
            "The four-hole tape of Chapter 3, or other holes.",
            ("> holes.asc", "--holes '1,1 2.5,1 4,1' --z-depth 3.25"),
        ),
        Part(
            "fluidic",
            "The fluidic element of Chapter 8, with our outline.",
            ("> element.asc", "--program control --control 0.8", "--tolerance 0.005"),
            instrument="Talysurf",
            cutter=0.125,
        ),
    )
}
"""Every part by its name."""


def find(name: str) -> Part:
    """Return the part of that name. Raises WorkError with the names that there are."""
    if name not in PARTS:
        raise WorkError(f"{name}: no such part program; there are {', '.join(PARTS)}")
    return PARTS[name]


def part(name: str, *expression: str, **constants: Any) -> str:
    """Return the printout of the part program `name`: blocks of 19 characters, each ended by a line feed.

    `constants` are the options of its command, `pdp8 part NAME --help`, in the same units: lengths in inches,
    as numbers or as text, part("circle", radius=1.5, tolerance=".003", technique="piece"). The parts "curve"
    and "profile" take an expression, part("curve", "sin(x)", from_=0, to=6.283), "profile" also a text of
    lines, x and y of a point on each. Raises WorkError.
    """
    program = find(name).program()
    if not constants:
        return program(*expression)
    from programs.constants import taken

    try:
        return program(*expression, **taken(program, constants))
    except ValueError as error:
        raise WorkError(f"{name}: {error}") from error
