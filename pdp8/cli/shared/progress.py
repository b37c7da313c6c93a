"""A progress bar on work that lasts: it appears after a second, at a terminal, and leaves nothing behind."""

import sys
import time
from collections.abc import Iterable, Iterator
from types import TracebackType
from typing import TYPE_CHECKING, Self, TypeVar

if TYPE_CHECKING:
    from rich.progress import Progress, TaskID

_DELAY = 1.0
_Step = TypeVar("_Step")


class Bar:
    """A bar of `total` steps on standard error, if that is a terminal and it is `wanted`."""

    def __init__(self, label: str, total: int, wanted: bool = True) -> None:
        self._label = label
        self._total = total
        self._begin = time.monotonic() + _DELAY if wanted and total and sys.stderr.isatty() else None
        self._shown: tuple[Progress, TaskID] | None = None

    def __enter__(self) -> Self:
        return self

    def show(self, done: int) -> None:
        """Show that `done` of the steps are done."""
        if self._begin is None or time.monotonic() < self._begin:
            return
        if self._shown is None:
            self._shown = _open(self._label, self._total)
        progress, task = self._shown
        progress.update(task, completed=done)

    def along(self, steps: Iterable[_Step]) -> Iterator[_Step]:
        """Yield `steps`, and show that each is done."""
        for number, step in enumerate(steps, 1):
            yield step
            self.show(number)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._shown:
            self._shown[0].stop()


class Busy:
    """A moving bar for `wanted` work of unknown length."""

    def __init__(self, label: str, wanted: bool) -> None:
        self._label = label
        self._wanted = wanted and sys.stderr.isatty()
        self._shown: tuple[Progress, TaskID] | None = None

    def __enter__(self) -> None:
        if self._wanted:
            from threading import Timer

            self._timer = Timer(_DELAY, self._show)
            self._timer.start()

    def _show(self) -> None:
        self._shown = _open(self._label, None)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._wanted:
            self._timer.cancel()
            self._timer.join()
        if self._shown:
            self._shown[0].stop()


def _open(label: str, total: int | None) -> "tuple[Progress, TaskID]":
    from rich.console import Console
    from rich.progress import Progress

    progress = Progress(console=Console(stderr=True), transient=True)
    progress.start()
    return progress, progress.add_task(label, total=total)
