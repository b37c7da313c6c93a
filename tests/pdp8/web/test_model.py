"""Random steps at the page's controls beside a model; `python -m tests.pdp8.web.model 10000` does more."""

import pytest

from tests.pdp8.web.browsing import Page
from tests.pdp8.web.model import differ

_SEEDS = (
    pytest.param(0, marks=pytest.mark.slow("12 s")),
    *(pytest.param(n, marks=[pytest.mark.slow("more"), pytest.mark.rare("12 s each")]) for n in (1, 3, 4)),
)


@pytest.mark.parametrize("seed", [2, *_SEEDS])
def test_the_page_is_as_its_model_after_any_steps(page: Page, seed: int) -> None:
    assert differ(page, 120, seed) == ""
