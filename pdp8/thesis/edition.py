"""The tables of docs/thesis.md, made from the catalogue and the numbers.

    <!-- items 7 -->      a chapter's figures, tables, listings and programs, with anchors; A: appendices
    <!-- numbers 7 -->    its numbers, each with a link to what makes it
    <!-- end -->          what stands between is replaced

`make evidence` runs this as a program, in the project's folder.
"""

import re
from collections.abc import Iterator
from pathlib import Path

from pdp8.thesis.catalogue import Item, catalogue
from pdp8.thesis.numbers import numbers, plain, shown

PAGE = Path("docs/thesis.md")
_SECTION = re.compile(r"(<!-- (items|numbers) (\w+) -->\n).*?(<!-- end -->)", re.DOTALL)
_ITEMS = "| what | page | state | here |\n|---|--:|---|---|\n"
_NUMBERS = "| page | the thesis | number | ours | state | made by |\n|--:|---|--:|--:|---|---|\n"


def page(text: str) -> str:
    """Return `text` with every table in it made again."""
    return _SECTION.sub(lambda found: found[1] + _table(found[2], found[3]) + found[4], text)


def _table(what: str, chapter: str) -> str:
    if what == "items":
        return _ITEMS + "".join(_item(item) for item in catalogue() if item.chapter == chapter)
    return _NUMBERS + "".join(_rows(int(chapter)))


def _item(item: Item) -> str:
    made = f" `pdp8 thesis make {item.number}`" if item.maker else ""
    return (
        f'| <a id="{item.kind}-{item.number}"></a>{item.name}. {item.title} | {item.page} | {item.state} | '
        f"{item.note}{made} |\n"
    )


def _rows(chapter: int) -> Iterator[str]:
    names = {item.number: item for item in catalogue()}
    for one in numbers():
        if one.chapter == chapter:
            cells = (str(one.page), f"`{one.words}`", plain(one.said), shown(one.ours), one.state)
            yield f"| {' | '.join((*cells, _link(one.by, names)))} |\n"


def _link(by: str, names: dict[str, Item]) -> str:
    """Return what makes a number as a link: to the item on this page, to a page; or the command."""
    if by in names:
        return f"[{names[by].name}](#{names[by].kind}-{by})"
    if by.startswith("pdp8 "):
        return f"`{by}`"
    return f"[{by}]({by}.md)" if by else ""


def main() -> None:
    """Write the page again."""
    PAGE.write_text(page(PAGE.read_text()))


if __name__ == "__main__":
    main()
