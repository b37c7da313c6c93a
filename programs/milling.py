"""A curve made into blocks, by either technique of Chapter 3.

Lengths of the parts that have no listing are inches, as the chapters give them; the tape has thousandths.

Source: thesis, Chapters 3 and 6; sequence numbers follow the header's six.
"""

from dataclasses import dataclass
from typing import Annotated, Final, Literal

from programs import stepwise
from programs.format import Overflow
from programs.header import Header
from programs.piecewise import Feeds, Technique
from programs.printout import Printout, check_feed
from programs.stretches import Axis, Curve, Point
from programs.units import CODE, FRACTION, THOUSANDTHS
from tapes.hydrapoint import Miscellaneous, Preparatory

_FEED_FUNCTION: Final[dict[Axis, Miscellaneous]] = {"X": Miscellaneous.X_FEED, "Y": Miscellaneous.Y_FEED}

STEP, PIECE = "technique=step", "technique=piece"
"""What has to be chosen for a constant of one technique to have a meaning."""
AS_LISTED = (STEP, "not stop=inside")
"""What has to be chosen for a constant of the listings' own method to have a meaning."""
NO_CUTTER = "not cutter"
"""What a constant needs that means nothing for a path beside the surface."""
OF_CENTRE = (THOUSANDTHS, NO_CUTTER)
"""A length of the path of the cutter's centre."""


@dataclass(frozen=True)
class Milling:
    """How a contour is milled. Raises WorkError for feeds that the machine does not have."""

    technique: Annotated[Literal["step", "piece"], "step-wise or piece-wise linear technique"] = "step"
    feed_code: Annotated[int, "feed code of Table 2.4, step-wise technique (AT)", CODE, STEP] = 1
    fastest: Annotated[int, "fastest feed code used, piece-wise technique", CODE, PIECE] = 5
    stop: Annotated[
        stepwise.Stop, "where a cut stops, step-wise technique: at the limit, or just inside", STEP
    ] = "boundary"
    feed_error: Annotated[float, "how far feeds may be wrong, piece-wise technique", FRACTION, PIECE] = 0.2

    def __post_init__(self) -> None:
        check_feed(self.feed_code)
        Technique(self.fastest, self.feed_error)

    @property
    def is_of_the_listings(self) -> bool:
        """Whether it is that of Appendices C and D: step-wise, each cut to its limit."""
        return (self.technique, self.stop) == ("step", "boundary")

    def printout(self, curve: Curve, header: Header, overflow: Overflow) -> str:
        """Return the printout of a part that is one curve. Raises WorkError as `print` does."""
        printout = Printout(overflow)
        printout.header(header, *curve.start)
        self.print(printout, curve)
        return printout.text

    def print(self, printout: Printout, curve: Curve) -> None:
        """Print the blocks that mill along `curve` from its start. Raises WorkError if it cannot."""
        if self.technique == "step":
            for cut in stepwise.cuts(curve, self.stop):
                mill(printout, cut.stop, self.feed_code, cut.axis)
        else:
            _print_piecewise(printout, curve, Technique(self.fastest, self.feed_error))


SLOWEST: Final = Milling()
"""Step-wise at 1 inch a minute, feed code 01."""


def position(printout: Printout, stop: Point) -> None:
    """Print a block that goes to `stop` with the spindle up."""
    printout.print_30(printout.blocks + 1, Preparatory.POSITION, *stop, 0, Miscellaneous.NO_CHANGE)


def _print_piecewise(printout: Printout, curve: Curve, technique: Technique) -> None:
    at, force = curve.start, Feeds(0, 0)
    for ray in technique.rays(curve):
        changes_x, changes_y = ray.feeds.x not in (0, force.x), ray.feeds.y not in (0, force.y)
        if changes_x and changes_y:
            mill(printout, at, ray.feeds.y, "Y")
        force = Feeds(ray.feeds.x or force.x, ray.feeds.y or force.y)
        if changes_x or (force.x and not changes_y):
            mill(printout, ray.stop, force.x, "X")
        else:
            mill(printout, ray.stop, force.y, "Y")
        at = ray.stop


def mill(printout: Printout, stop: Point, code: int, axis: Axis) -> None:
    """Print a block that mills to `stop`, `axis` at the feed of tool code `code`."""
    printout.print_30(printout.blocks + 1, Preparatory.MILL, *stop, code, _FEED_FUNCTION[axis])
