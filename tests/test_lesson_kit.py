"""The lesson kit: the notebook's cells run, and the cards say what the machine does."""

import json
from pathlib import Path
from typing import Any

import pytest

from pdp8.lessons import cards as drawn
from tests.pictures import assert_looked_at

DOCS = Path(__file__).parent.parent / "docs"


def test_the_notebook_runs_from_top_to_bottom() -> None:
    notebook = json.loads((DOCS / "afternoon.ipynb").read_text())
    names: dict[str, Any] = {}
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            assert cell["outputs"] == []
            exec("".join(cell["source"]), names)
    assert names["stop"].reason == "tape out"


DIGESTS = {
    "rim": "fa102400",
    "instructions": "adc79e48",
    "ascii": "6ea0432c",
    "eia": "872fe939",
    "afternoon": "c9a42da1",
}


@pytest.mark.parametrize("name", DIGESTS)
def test_a_card_is_the_one_that_was_looked_at(name: str) -> None:
    svg = drawn.CARDS[name]() if name in drawn.CARDS else drawn.afternoon([("1 s", "step", "done")] * 3, "t")
    assert_looked_at(f"card {name}", svg, DIGESTS[name])
