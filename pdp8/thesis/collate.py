"""What a rescan of the thesis would settle, the letter that asks for it, and the answers.

conjectures.txt has a line for each: name, page, place on it, our reading, its rivals with what each would
change, and what hangs on it: a file of evidence, an input, or an item of the catalogue.

    name | what the page has | who looked, where, when         a line of an answer; # opens a comment

An answer in scan/answers.txt turns the row of evidence that hangs on it from `conjecture` to `read`, with the
page's words. An input, or an item of the catalogue, is no longer fitted if the page has what we took for it.
"""

from functools import cache
from importlib.resources import files
from typing import Any, NamedTuple

from pdp8.thesis.table import Table
from tapes.errors import WorkError
from tapes.text import lines_of

_FORM = "NAME | WHAT THE PAGE HAS | WHO LOOKED, WHERE, WHEN"


class Conjecture(NamedTuple):
    """A reading that is not settled; `rivals` are the others with what each would change."""

    name: str
    page: str
    place: str
    ours: str
    rivals: dict[str, str]
    targets: list[str]


def _text(name: str) -> str:
    return (files("pdp8.thesis") / name).read_text(encoding="utf-8")


@cache
def conjectures() -> dict[str, Conjecture]:
    """Return the conjectures by name, in the order of the file."""
    found = {}
    for line in lines_of(_text("conjectures.txt")):
        if not line.startswith("#"):
            name, page, place, ours, rivals, targets = (cell.strip() for cell in line.split("|"))
            changes = dict(each.strip().split(" = ") for each in rivals.split("//"))
            found[name] = Conjecture(name, page, place, ours, changes, targets.split(", "))
    return found


def answers(text: str | None = None) -> dict[str, str]:
    """Return what the pages have by the names of the conjectures; without `text`, from scan/answers.txt.

    Raises WorkError for a line that is no answer.
    """
    known, given = conjectures(), dict[str, str]()
    for number, line in enumerate(lines_of(_text("scan/answers.txt") if text is None else text), 1):
        if not line.strip() or line.startswith("#"):
            continue
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) != 3 or not all(cells):
            raise WorkError(f"line {number}: {line}: an answer is {_FORM}")
        name, reading, _ = cells
        if name not in known:
            raise WorkError(f"line {number}: {name}: no such conjecture; there are {', '.join(known)}")
        if not alike(given.setdefault(name, reading), reading):
            raise WorkError(f"line {number}: {name}: {reading}; an earlier line has {given[name]}")
    return given


def alike(one: str, other: str) -> bool:
    """Whether two readings are the same but for spaces and capitals."""
    return "".join(one.split()).casefold() == "".join(other.split()).casefold()


def settled(target: str) -> bool:
    """Whether what `target` hangs on was read, and the page has what we took for it."""
    given, on = answers(), [each for each in conjectures().values() if target in each.targets]
    return bool(on) and all(alike(given.get(each.name, ""), each.ours) for each in on)


def as_read(row: Any, artefact: str) -> Any:
    """Return a row of evidence; if it is a conjecture that was read, with the page's words, class `read`."""
    given = answers() if row.kind == "conjecture" else {}
    for each in conjectures().values():
        if artefact in each.targets and each.name in given and each.ours in row.ours:
            words = each.ours if alike(given[each.name], each.ours) else given[each.name]
            line = row.ours.replace(each.ours, words)
            line = line.partition(" /")[0] if artefact.endswith(".pal") else line  # notes in PAL are ours
            return row._replace(kind="read", ours=line)
    return row


def table(given: dict[str, str], places: dict[str, str]) -> Table:
    """Return each conjecture with its place, its rivals, and its state after the answers `given`."""
    rows = []
    for each in conjectures().values():
        rivals = "; ".join(f"{reading}: {change}" for reading, change in each.rivals.items())
        place = f"{each.place}{places.get(each.name, '')}"
        rows.append((each.name, each.page, place, each.ours, state(each, given.get(each.name)), rivals))
    return Table(("name", "page", "place", "ours", "state", "rivals: what each would change"), tuple(rows))


def state(conjecture: Conjecture, answer: str | None) -> str:
    """Return `conjectured`, `read` if the page has ours, or what it has and what that changes."""
    if answer is None or alike(answer, conjecture.ours):
        return "conjectured" if answer is None else "read"
    changes = [change for reading, change in conjecture.rivals.items() if alike(answer, reading)]
    return f"read: {answer}; {changes[0] if changes else 'not foreseen, so not computed'}"


def letter() -> str:
    """Return a letter to the library that has the thesis: which pages, and what on each."""
    known = sorted(conjectures().values(), key=lambda one: int(one.page))
    places = "".join(
        f"page {each.page:>3}  {each.place}. Name: {each.name}. Our reading: {each.ours}\n" for each in known
    )
    return _text("letter.txt").format(places=places, form=_FORM)
