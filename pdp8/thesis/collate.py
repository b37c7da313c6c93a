"""What a rescan of the thesis would settle (conjectures.txt), the letter that asks for it, and the answers.

    name | what the page has | who looked, where, when         a line of an answer; # opens a comment

An answer in scan/answers.txt turns the row of evidence that hangs on it from `conjecture` to `read`, with the
page's words. An input, or an item of the catalogue, is no longer fitted if the page has what we took for it.
"""

from functools import cache
from typing import Any, NamedTuple

from pdp8.thesis.table import Table, cells, text_of
from tapes.errors import WorkError
from tapes.text import lines_of

_FORM = "NAME | WHAT THE PAGE HAS | WHO LOOKED, WHERE, WHEN"


class Conjecture(NamedTuple):
    """An unsettled reading; `rivals` are the others, with what each would change."""

    name: str
    page: str
    place: str
    ours: str
    rivals: dict[str, str]
    targets: str


@cache
def conjectures() -> dict[str, Conjecture]:
    """Return the conjectures by name, in the order of the file."""
    found = {}
    for name, page, place, ours, rivals, targets in cells(text_of("conjectures.txt")):
        changes = dict(each.split(" = ") for each in rivals.split(" // "))
        found[name] = Conjecture(name, page, place, ours, changes, targets)
    return found


def answers(text: str | None = None) -> dict[str, str]:
    """Return what pages have for each conjecture, by default of scan/answers.txt. Raises WorkError."""
    known, given = conjectures(), dict[str, str]()
    for number, line in enumerate(lines_of(text_of("scan/answers.txt") if text is None else text), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        given_as = [cell.strip() for cell in line.split("|")]
        if len(given_as) != 3 or not all(given_as):
            raise WorkError(f"line {number}: {line}: an answer is {_FORM}")
        name, reading, _ = given_as
        if name not in known:
            raise WorkError(f"line {number}: {name}: no such conjecture; there are {', '.join(known)}")
        if not alike(given.setdefault(name, reading), reading):
            raise WorkError(f"line {number}: {name}: {reading}; an earlier line has {given[name]}")
    return given


def alike(one: str, other: str) -> bool:
    """Whether two readings are the same but for spaces and capitals."""
    return "".join(one.split()).casefold() == "".join(other.split()).casefold()


def settled(target: str) -> bool:
    """Whether the conjectures behind `target` were looked up and found as ours."""
    given, on = answers(), [each for each in conjectures().values() if target in each.targets.split(", ")]
    return bool(on) and all(alike(given.get(each.name, ""), each.ours) for each in on)


def as_read(row: Any, artefact: str) -> Any:
    """Return a row of evidence with the page's words and the class `read`, if it was looked up."""
    for each in conjectures().values() if row.kind == "conjecture" else ():
        words = answers().get(each.name, "")
        if words and artefact == each.targets and each.ours in row.ours:
            line = row.ours.replace(each.ours, each.ours if alike(words, each.ours) else words)
            line = line.partition(" /")[0] if artefact.endswith(".pal") else line  # notes in PAL are ours
            return row._replace(kind="read", ours=line)
    return row


def table(given: dict[str, str], places: dict[str, str]) -> Table:
    """Return each conjecture with its place, its rivals, and its state after the answers `given`."""
    rows = []
    for name, page, place, ours, rivals, _ in conjectures().values():
        changes = "; ".join(f"{reading}: {change}" for reading, change in rivals.items())
        state_ = state(conjectures()[name], given.get(name))
        rows.append((name, page, place + places.get(name, ""), ours, state_, changes))
    return Table(("name", "page", "place", "ours", "state", "rivals: what each would change"), tuple(rows))


def state(conjecture: Conjecture, answer: str | None) -> str:
    """Return `conjectured`, `read` if the page agrees, or its reading and what that changes."""
    if answer is None or alike(answer, conjecture.ours):
        return "conjectured" if answer is None else "read"
    changes = (change for reading, change in conjecture.rivals.items() if alike(answer, reading))
    return f"read: {answer}; {next(changes, 'not foreseen, so not computed')}"


def letter() -> str:
    """Return a letter to the library that has the thesis: which pages, and what on each."""
    known = sorted(conjectures().values(), key=lambda one: int(one.page))
    form = "page {0.page:>3}  {0.place}. Name: {0.name}. Our reading: {0.ours}\n"
    places = "".join(form.format(each) for each in known)
    return text_of("letter.txt").format(places=places, form=_FORM)
