"""`pdp8 replay` as a user runs it."""

import pytest

from pdp8.cli.replay import REPLAYED
from tests.conftest import Shell


@pytest.mark.slow("an afternoon of each part, 15 s")
@pytest.mark.parametrize("part", sorted(set(REPLAYED) - {"circle", "ellipse", "die", "drill"}))
def test_any_other_part(shell: Shell, part: str) -> None:
    """What no other test takes goes the whole way, the page too (the die is the ellipse's program)."""
    done = shell(f"pdp8 replay {part} --html - > page.html && wc -c < page.html")
    assert done.returncode == 0, done.stderr.decode()
    assert 100_000 < int(done.stdout) < 3_000_000
