"""The unit of what is written of a path: inches, as in 1971, or millimetres."""

from typing import Final, NamedTuple

from tapes.quantities import inches


class Unit(NamedTuple):
    """A unit of length: its name, how many make .001 in, its word in RS-274, its number in DXF, and what a
    small division of an instrument's graph is.
    """

    name: str
    scale: float
    places: int
    word: str
    dxf: int
    small: float

    @property
    def division(self) -> float:
        """A small division, in thousandths of an inch."""
        return self.small / self.scale

    @property
    def named_division(self) -> str:
        """A small division as a graph names it: .001, .02."""
        return f"{self.small:g}".lstrip("0")

    def of(self, thousandths: float) -> float:
        """Return a length in this unit."""
        return round(thousandths * self.scale, 6) + 0.0

    def said(self, thousandths: float, places: int = 0) -> str:
        """Return a length as it is written beside others, with so many places: 1.750, 44.450."""
        return f"{self.of(thousandths):.{places or self.places}f}"

    def place(self, x: float, y: float) -> str:
        """Return a place of the table."""
        return f"X {self.said(x)} Y {self.said(y)}"

    def size(self, thousandths: float) -> str:
        """Return a size, with a fourth place if it needs one: 0.500, 0.0625."""
        return self.said(thousandths, 4).removesuffix("0")

    def error(self, thousandths: float) -> str:
        """Return an error, without its sign: .0106, 0.2692."""
        return inches(abs(thousandths)) if self is INCH else self.said(abs(thousandths), 4)

    def signed(self, thousandths: float) -> str:
        """Return an error with its sign; one that is written as zero has a plus."""
        error = self.error(thousandths)
        return f"{'-' if thousandths < 0 and error.strip('.0') else '+'}{error}"


INCH: Final = Unit("in", 0.001, 3, "G20", 1, 0.001)
MM: Final = Unit("mm", 0.0254, 3, "G21", 4, 0.02)
