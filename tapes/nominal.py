"""The nominal curve of a part: programs makes it with the tape, nc measures, draws and exports against it.

    kind       numbers                          besides
    line       X Y of one end, X Y of the other
    circle     X Y of the centre, radius
    ellipse    X Y of the centre, semi-axes along X and Y
    function   X Y of the origin, first x, last x   `expression`, y as a function of x
    profile    X Y of the centre                `expression`, the radius as a function of the angle,
                                                or `points`, the corners of the outline from the centre
All lengths are inches.
"""

from typing import Final, Literal, NamedTuple

Kind = Literal["line", "circle", "ellipse", "function", "profile"]

SIDES: Final[dict[str, tuple[str, ...]]] = {
    "line": (),
    "circle": ("outside", "inside"),
    "ellipse": ("outside", "inside"),
    "function": ("above", "below"),
    "profile": ("outside", "inside"),
}
"""The sides of a surface on which the cutter may be, by the kind of the curve."""


class Nominal(NamedTuple):
    """A curve that a part program follows.

    `side` is the side of the part's surface on which the cutter is; "" if the curve is not the surface but
    the path of the cutter's centre. `cutter` is the diameter of the cutter, `tolerance` the most that a wall
    may be off, `source` the command or option that made the curve.
    """

    kind: Kind
    numbers: tuple[float, ...]
    expression: str = ""
    points: tuple[tuple[float, float], ...] = ()
    side: str = ""
    cutter: float = 0.5
    tolerance: float = 0.005
    source: str = ""

    @property
    def closed(self) -> bool:
        """Whether the curve's end is its start."""
        return self.kind not in ("line", "function")
