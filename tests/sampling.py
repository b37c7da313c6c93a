"""How many cases a slow test takes: a tenth of them in `make check`, all by `WHOLE=1 make check`."""

import os


def some(count: int) -> int:
    """Return `count` if the whole is asked for, else a tenth of it."""
    return count if os.environ.get("WHOLE") else count // 10
