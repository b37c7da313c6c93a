"""The tables of docs/thesis.md and docs/restoration.md, and the sources in programs/, made from our tables.

    <!-- items 7 -->      a chapter's figures, tables, listings and programs, with anchors; A: appendices
    <!-- numbers 7 -->    its numbers, each with a link to what makes it
    <!-- variants 106 -->    which other words would do the work of that page's, and why ours are preferred
    <!-- evidence eia.pal 105 106 107 -->     the rows of these pages; and of these classes, if any are named
    <!-- rescan all -->   the conjectures, and what another reading would change
    <!-- end -->          what is between is replaced

`make evidence` runs this as a program, in the project's folder.
"""

import json
import re
from collections.abc import Callable, Iterator
from pathlib import Path

from pdp8.thesis import collate, measures, numbers
from pdp8.thesis.catalogue import Item, catalogue
from pdp8.thesis.evidence import ARTEFACTS, CLASSES, source, table
from pdp8.thesis.table import cells, text_of

_SECTION = re.compile(r"(<!-- (\w+) (.+?) -->\n).*?(<!-- end -->)", re.DOTALL)
_HEADINGS = {
    "items": "| what | page | state | here |\n|---|--:|---|---|\n",
    "numbers": "| page | the thesis | number | ours | state | made from | made by |\n"
    "|--:|---|--:|--:|---|---|---|\n",
    "variants": "| ours | others | of these with a name of the program | why ours |\n|---|--:|---|---|\n",
    "rescan": "| page | place | ours | others, and what each would change |\n|--:|---|---|---|\n",
    "evidence": "| page | the scan | ours | evidence | reason |\n|--:|---|---|---|---|\n",
}
_Maker = Callable[..., Iterator[tuple[str, ...]]]


def page(text: str) -> str:
    """Return `text` with every generated table renewed."""
    return _SECTION.sub(lambda found: found[1] + _table(found[2], found[3].split()) + found[4], text)


def _table(what: str, wanted: list[str]) -> str:
    makers: dict[str, _Maker] = {
        "items": _items, "numbers": _numbers, "evidence": _evidence, "variants": _variants, "rescan": _rescan
    }  # fmt: skip
    rows = makers[what](*wanted)
    return _HEADINGS[what] + "".join(f"| {' | '.join(row)} |\n" for row in rows)


def _items(chapter: str) -> Iterator[tuple[str, ...]]:
    for item in catalogue():
        if item.chapter == chapter:
            made = f" `pdp8 thesis make {item.number}`" if item.maker else ""
            name = f'<a id="{item.stem}"></a>{item.name}. {item.title}'
            yield name, str(item.page), item.state, f"{item.note}{made}"


def _numbers(chapter: str) -> Iterator[tuple[str, ...]]:
    names = {item.number: item for item in catalogue()}
    for page_, words, said, ours, state, made_from, by in numbers.table(int(chapter)).rows:
        yield page_, f"`{words}`", said, ours, state, made_from, _link(by, names)


def _link(by: str, names: dict[str, Item]) -> str:
    """Return what makes a number as a link: to the item on this page, to a page; or the command."""
    if by in names:
        return f"[{names[by].name}](#{names[by].stem})"
    if by.startswith("pdp8 "):
        return f"`{by}`"
    return f"[{by}]({by}.md)" if by else ""


def _evidence(artefact: str, *wanted: str) -> Iterator[tuple[str, ...]]:
    classes = [word for word in wanted if word in CLASSES] or CLASSES
    for row in table(artefact):
        if row.page in wanted and row.kind in classes:
            scan, ours = (f"`{text}`" if text else "" for text in (row.scan, row.ours))
            yield row.page, scan, ours, row.kind, row.reason


def _variants(page_: str) -> Iterator[tuple[str, ...]]:
    """Yield each word of a page that another could replace, with the reason for ours."""
    others = {address: (count, names) for address, count, names in cells(text_of("scan/variants.txt"))}
    for row in table("eia.pal"):
        if row.page == page_ and others[row.ours[:4]][0] != "0":
            count, names = others[row.ours[:4]]
            named = ", ".join(f"`{name}`" for name in names.split(", ") if name)
            yield f"`{row.ours}`", count, named, row.reason


def _rescan(_: str) -> Iterator[tuple[str, ...]]:
    for row in collate.table({}, {}).rows:
        yield row[1], row[2], row[3], row[5]


def main() -> None:
    """Write the measures, the pages and the sources again."""
    kept = measures.computed(one.measure for one in numbers.numbers())
    Path("pdp8/thesis", measures.KEPT).write_text(json.dumps(kept, indent=1) + "\n")
    for path in (Path("docs/thesis.md"), Path("docs/restoration.md")):
        path.write_text(page(path.read_text()))
    for artefact in ARTEFACTS:
        Path("programs", artefact).write_text(source(artefact))


if __name__ == "__main__":
    main()
