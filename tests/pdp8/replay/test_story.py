"""What is told of an afternoon: the thesis's and our own figures, for every part."""

import re

import pytest

from pdp8.cli.replay import REPLAYED
from pdp8.replay import Afternoon, replay
from pdp8.replay.figures import NOT_SAID, compare
from pdp8.replay.story import story
from tapes.quantities import inches


def test_the_circles(circle: Afternoon) -> None:
    """666 lines and 660 cuts (Chapter 7), the 17 words of DEC's card; the wall as `nc inspect` prints it."""
    told = {name: words for name, words in story(circle)}
    assert "McMaster" in told[""]
    assert "our arrangement" in told[""]
    assert "666 lines" in told["Print"]
    assert "Seventeen words" in told["Toggle"]
    assert "660 times" in told["Cut"]
    assert "two seconds" in told["Cut"]
    assert ".0173 inch" in told["Measure"]
    assert "outer wall, where the contour is left open. The thesis measured .009." in told["Measure"]
    cuts, worst = circle.path.cuts, circle.inspection and circle.inspection.worst
    assert cuts[0].start.y - cuts[-1].end.y == 156
    assert worst
    assert worst.place == "-X apex"  # where it starts and does not end


@pytest.mark.parametrize("part", REPLAYED)
def test_every_part_has_its_own(part: str) -> None:
    """An opening in 150 characters, seven acts in 110 each; only the circle's says circle."""
    afternoon = replay(part)
    told = story(afternoon)
    assert len(told) == 1 + len(afternoon.acts)
    assert len(told[0].words) <= 150
    assert max(len(words) for _, words in told[1:]) <= 110
    assert any("circle" in words for _, words in told) == (part == "circle")
    assert not re.search(r"\b0 |nan|None", " ".join(words for _, words in told))
    if afternoon.inspection:
        (worst,) = (line for line in compare(afternoon) if line.figure == "trough to peak at most, in")
        said = ".003 designed, .0028 measured (Ch. 8)" if part == "fluidic" else NOT_SAID
        assert (worst.thesis, worst.replay[:5]) == (said, inches(afternoon.inspection.worst.trough_to_peak))
