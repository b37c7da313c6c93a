"""The one page: the whole machine live, every bundled tape at hand, and the afternoon that plays on it.

record (JSON), made or kept: room, desk    ┐
our Python, bench/ room/ workbench.mjs     ├──► one HTML file with everything inside
base.css workbench.css desk.css room.css   ┘
"""

from typing import TYPE_CHECKING, Any

from pdp8.web import bundle
from pdp8.web.kept import house, kept

if TYPE_CHECKING:
    from pdp8.replay import Afternoon

_STYLES = ("workbench.css", "bench/desk.css", "room/room.css")
_DESK = ("exercises", "figures", "graph", "parts")
"""What of the record the desk alone has."""


def page(view: tuple[str, bytes] | None = None, afternoon: "Afternoon | None" = None) -> str:
    """Return the whole page; with `view`, the name and frames of an EIA tape, opened at the Hydra-Point; with
    an `afternoon`, opened at that.
    """
    first = record(view, afternoon)
    more = {name: first.pop(name) for name in _DESK}
    kind = "" if view else "room"
    return bundle.page("PDP-8/L workbench", "bench.html", _STYLES, "workbench", first, more, kind)


def record(view: tuple[str, bytes] | None = None, afternoon: "Afternoon | None" = None) -> dict[str, Any]:
    """Return what the page has at hand, ready for JSON; the usual afternoon is kept."""
    found = _made(afternoon) if afternoon else dict(kept("workbench", house(), _made))
    if view is not None:
        name, frames = view
        found |= {"tapes": found["tapes"] | {name: frames.decode("latin-1")}, "view": name}
    return found


def _made(afternoon: "Afternoon | None" = None) -> dict[str, Any]:
    from pdp8.web.record import record

    return record(afternoon)
