"""The tapes of the fewest blocks by the piece-wise technique, NAME-fewest.eia: fewest.c proves them.

`python -m tests.reference.fewest`, or `make fewest`, searches again and writes them: some ten minutes. They
have feed codes 01 to 05. With more, fewest.c prints 128 for the slope (01 to 18), 215 for the circle (to 08).
"""

import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Final, NamedTuple

from programs.header import THESIS
from programs.milling import mill
from programs.printout import Printout
from programs.stretches import Axis, Point
from tapes import eia
from tests.reference.compiling import compile_c

_FEED_ERROR: Final = "20"
_AXES: Final[dict[str, Axis]] = {"X": "X", "Y": "Y"}
TAPES: Final = Path(__file__).parents[2] / "tapes"


class Shape(NamedTuple):
    """What fewest.c is asked for, and where its 0,0 lies on the table."""

    kind: str
    width: int
    height: int
    origin: Point


SHAPES: Final = {
    "slope": Shape("line", 4330, 2500, Point(4000, 4000)),
    "circle": Shape("oval", 1750, 1750, Point(4000, 4000)),
    "ellipse": Shape("oval", 3000, 2250, Point(4000, 4000)),
    "die": Shape("oval", 3000, 1500, Point(6000, 4000)),
}


def search(shape: Shape, fastest: int = 5, margin: int = 800) -> str:
    """Return the printout with the fewest blocks, feed codes 01 to `fastest`, after the listings' header."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder, "fewest")
        compile_c(program, Path(__file__).with_name("fewest.c"), "-lm")
        asked = [str(program), shape.kind, str(shape.width), str(shape.height)]
        asked += [_FEED_ERROR, str(margin), str(fastest)]
        found = subprocess.run(asked, check=True, capture_output=True, text=True).stdout
    count, *blocks = found.splitlines()
    assert int(count) == len(blocks)
    printout = Printout()
    start = shape.origin.x - (shape.width if shape.kind == "oval" else 0)
    printout.header(THESIS, start, shape.origin.y)
    for block in blocks:
        x, y, axis, code = block.split()
        stop = Point(shape.origin.x + int(x), shape.origin.y + int(y))
        mill(printout, stop, int(code), _AXES[axis])
    return printout.text


def main() -> None:
    """Search for all shapes and write their tapes; or print the least of one, `slope 6`: codes 01 to 06."""
    if len(sys.argv) == 3:
        print(search(SHAPES[sys.argv[1]], int(sys.argv[2]), margin=100).count("\n") - 6)
        return
    for name, shape in SHAPES.items():
        (TAPES / f"{name}-fewest.eia").write_bytes(eia.encode(search(shape).replace(" ", "0")))


if __name__ == "__main__":
    main()
