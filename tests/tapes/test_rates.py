"""Table 2.4 of the thesis, number by number: X and Y feed, Z feed, spindle, for tool functions 01 to 18."""

import pytest

from tapes.hydrapoint import TOOL_FUNCTION

XY = (1.0, 1.9, 2.7, 4.0, 5.5, 7.2, 9.1, 11.2, 13.3, 16.0, 18.6, 21.5, 24.7, 27.9, 31.5, 35.6, 39.7, 44.0)
Z = (1.0, 2.1, 3.6, 5.3, 8.1, 10.3, 13.3, 16.4, 20.0, 25.0, 28.0, 32.0, 37.0, 42.0, 48.0, 53.0, 59.0, 64.0)
SPINDLE = (65, 75, 91, 105, 120, 140, 155, 175, 195, 215, 240, 270, 300, 330, 375, 415, 465, 495)


@pytest.mark.parametrize("code", range(1, 19))
def test_a_line_of_table_2_4(code: int) -> None:
    assert tuple(TOOL_FUNCTION[code]) == (XY[code - 1], Z[code - 1], SPINDLE[code - 1])
