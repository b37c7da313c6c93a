"""The one page: the whole machine live, every bundled tape at hand, and the afternoon that plays on it.

first.html: a picture, a sentence, what is needed    ┐
record (JSON), made or kept: room, desk              │
bench.html and its parts, desk.css, room.css         ├──► one HTML file with everything inside
our Python, bench/ room/ workbench.mjs               ┘

Without its script the page is first.html alone: the rest is compressed with the data, and the script puts it
into the page. So there is never a control that nothing answers.
"""

from html import escape
from typing import TYPE_CHECKING, Any

from pdp8.web import bundle
from pdp8.web.kept import house, kept

if TYPE_CHECKING:
    from pdp8.replay import Afternoon

_FIRST = ("room/first.css",)
_STYLES = ("workbench.css", "bench/desk.css", "room/room.css")
_DESK = ("exercises", "figures", "graph", "parts")
"""What of the record the desk alone has."""


def page(view: tuple[str, bytes] | None = None, afternoon: "Afternoon | None" = None, url: str = "") -> str:
    """Return the whole page, opened with `view` (an EIA tape), or an `afternoon`; links begin with `url`."""
    first = record(view, afternoon) | {"url": url}
    more = {name: first.pop(name) for name in _DESK}
    first |= {"html": bundle.included("bench.html"), "style": "".join(map(bundle.source, _STYLES))}
    kind = "" if view else "room"
    html = bundle.page("PDP-8/L workbench", "room/first.html", _FIRST, "workbench", first, more, kind)
    return html.replace("<!-- story -->", escape(first["afternoon"]["story"][0][1]))


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
