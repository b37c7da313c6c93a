"""The page of all items: what the thesis says of each, beside what was made. One file, without scripts.

Pictures are inside the page, which needs no other file; long printouts are cut short and name their file.
"""

from base64 import b64encode
from collections import Counter
from collections.abc import Mapping
from html import escape
from itertools import groupby

from pdp8.thesis.catalogue import STATES, Item, catalogue
from pdp8.thesis.making import Made
from pdp8.thesis.supplied import html
from pdp8.thesis.table import Table, text_of
from tapes.text import lines_of

_LONGEST = 300
_EXCERPT = 24


def page(made: Mapping[str, Made]) -> str:
    """Return the page; `made` has everything that is not lost, by its number."""
    contents = chapters = ""
    for chapter, group in groupby(catalogue(), key=_chapter):
        items = list(group)
        links = " ".join(map(_link, items))
        articles = "".join(_article(item, made.get(item.number)) for item in items)
        contents += f"<li>{chapter}: {links}</li>\n"
        chapters += f"<section>\n<h2>{chapter}</h2>\n{articles}</section>\n"
    counts = Counter(item.state for item in catalogue())
    states = "".join(f"<li>{_badge(state)} {counts[state]}</li>" for state in STATES)
    template = text_of("gallery.html")
    with_states = template.replace("{{counts}}", states).replace("{{contents}}", contents)
    return with_states.replace("{{chapters}}", chapters)


def _chapter(item: Item) -> str:
    return f"Chapter {item.chapter}" if item.chapter.isdigit() else "Appendices"


def _link(item: Item) -> str:
    title = escape(f"{item.name}. {item.title}", quote=True)
    return f'<a href="#{item.stem}" title="{title}">{escape(item.number)}</a>'


def _badge(state: str) -> str:
    return f'<span class="state {state.split(maxsplit=1)[0]}">{state}</span>'


def _article(item: Item, made: Made | None) -> str:
    shown, links = '<p class="lost-item">Lost.</p>', ""
    if made:
        names = ", ".join(f'<a href="{name}">{name}</a>' for name, _ in made.files)
        shown, links = _shown(made), f'<p class="files">{names}</p>\n'
    return (
        f'<article id="{item.stem}">\n'
        f"<h3>{item.name}. {escape(item.title)} {_badge(item.state)}</h3>\n"
        f'<div class="words">\n<h4>The thesis, page {item.page}</h4>\n'
        f"<blockquote>{escape(item.says)}</blockquote>\n"
        f"<h4>Here</h4>\n<p>{_with_code(item.note)}</p>\n{links}</div>\n"
        f"{shown}</article>\n"
    )


def _with_code(text: str) -> str:
    """Return text as HTML, with the words between back quotes as code."""
    parts = escape(text).split("`")
    return "".join(f"<code>{part}</code>" if number % 2 else part for number, part in enumerate(parts))


def _shown(made: Made) -> str:
    if made.is_drawn:
        data = b64encode(made.text.encode()).decode()
        said = escape(f"{made.item.name}: {made.item.title}. {made.item.note}", quote=True)
        return f'<figure><img src="data:image/svg+xml;base64,{data}" alt="{said}"></figure>\n'
    if made.table:
        return _table(made.item, made.table)
    return _text(made)


def _table(item: Item, table: Table) -> str:
    heads = "".join(f'<th scope="col">{escape(cell)}</th>' for cell in table.headings)
    rows = "".join(
        "<tr>" + "".join(f"<td>{html(cell)}</td>" for cell in row) + "</tr>\n" for row in table.rows
    )
    caption = f"<caption>{item.name}. {escape(item.title)}</caption>"
    return f'<div class="wide" tabindex="0"><table>{caption}<tr>{heads}</tr>\n{rows}</table></div>\n'


def _text(made: Made) -> str:
    lines, more = lines_of(made.text)[3:], ""
    if len(lines) > _LONGEST:
        more = f"<p>{len(lines) - _EXCERPT} more lines in {made.name}.</p>"
        lines = lines[:_EXCERPT]
    text = html("\n".join(lines))
    label = escape(f"{made.item.name}: {made.item.title}", quote=True)
    return f'<div><pre tabindex="0" role="region" aria-label="{label}">{text}</pre>{more}</div>\n'
