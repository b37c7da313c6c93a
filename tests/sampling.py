"""How many cases a slow test takes: a tenth of them in `make check`, all by `WHOLE=1 make check`."""

import os

WHOLE = bool(os.environ.get("WHOLE"))


def some(count: int) -> int:
    """Return `count` if the whole is asked for, else a tenth of it."""
    return count if WHOLE else count // 10
