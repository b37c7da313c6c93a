"""Points from a file as spreadsheets and CAD programs write it: x and y of each, wherever its columns are.

    sep=;                        what separates the columns
    Nr;X [mm];Y [mm]             a header: its names say which columns are x and y, and in which unit
    1;38,1;0,0                   a point: decimal commas or points, thousands apart, quoted or not
    X = 1.5  Y = 0.0             a point by its names; so is {"x": 1.5, "y": 0}
    [(1.5, 0), (0, 1.5)]         points in brackets, any number on a line
    # made on Monday             comments and titles, which are skipped

The separator and the decimal mark are those by which most lines are numbers. Without a header x and y are the
first two columns, after a column that only counts or names. An angle and a radius in the header are polar
coordinates. Not read: workbooks (.xlsx, .ods), drawings (.dxf, .svg), G-code.
"""

import csv
import re
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from math import cos, isfinite, pi, sin
from typing import Final, NamedTuple

from tapes.errors import WorkError
from tapes.hydrapoint import X_TRAVEL
from tapes.text import lines_of

Place = tuple[float, float]

_IN_AN_INCH: Final = {
    'in inch inches zoll "': 1.0,
    "mm millimeter millimeters millimetre millimetres": 25.4,
    "cm centimeter centimeters centimetre centimetres": 2.54,
    "m meter meters metre metres": 0.0254,
    "µm μm um micron microns": 25400.0,
    "thou mil mils": 1000.0,
    "ft foot feet": 1 / 12,
}
_UNITS: Final = {name: count for names, count in _IN_AN_INCH.items() for name in names.split()}
_TURNS: Final = {"°": 360, "deg": 360, "rad": 2 * pi, "radian": 2 * pi, "radians": 2 * pi, "gon": 400}
"""How many of a unit are a turn."""
_STYLES = [(mark, point) for mark in ("\t", ";", "|", ", ", ",", " ") for point in ".,"]
"""What separates columns, and the decimal mark; of two that fit equally well the first is taken."""
_NUMBER = {
    point: re.compile(
        rf"([+-]?(?=[{point}]?\d)(?:[1-9]\d{{0,2}}(?:[{apart}'’ ]\d{{3}})+(?!\d)|\d*)(?:[{point}]\d*)?"
        r"(?:[ED][+-]?\d+)?)\s*([^\W\d_]+|[\"°])?",
        re.IGNORECASE,
    )
    for point, apart in (".,", ",.")
}
"""A number and its unit."""
_THOUSANDS = re.compile(r"\d[.,'’ ]\d{3}(?!\d)")
_JOINED = re.compile(r"\d[.,;]\d")
"""A mark in a cell that is no number: the cell may be two numbers."""
_COMMENT = re.compile(
    r"^\s*(?://|[!%]|#(?!DIV|N/A|NV|REF|BEZUG|VALUE|WERT|NAME|NUM|ZAHL|NULL))+|\s(?:#|//)\s"
)
_KEY = re.compile(r"\b([xyz])\"?\s*[:=]\s*", re.IGNORECASE)
_BRACKETS = re.compile(r"[\[({]([^][(){}]*)[\])}]")
_NAMED = re.compile(r"^\s*[a-z_]\w*\s+(?=[-+.\d])", re.IGNORECASE)
_TITLE = re.compile(r"[\"'*;\s]*(?!nan|inf)[^\W\d_]", re.IGNORECASE)
_PLAIN = str.maketrans({"\u2212": "-", "\u00a0": " ", "\u202f": " ", "\ufeff": None, "\x1a": None})
_OTHERS = {
    rb"PK": "a workbook: save its sheet as CSV",
    rb"<": "XML or SVG: export the points as CSV",
    rb"%PDF": "a PDF: export the points as CSV",
    rb"0\s*\r?\n\s*SECTION": "a DXF drawing: export the points as CSV",
    rb"(?s:.*\n)?v[ \t]+[-+.\d][^\n]*\n(?s:.*\n)?[lf] ": "a mesh (OBJ): export the points as CSV",
}
csv.field_size_limit(1 << 30)  # a list of all points may be one line
_LISTED = 10
"""Points at least in each of two lists (Lednicer's airfoils), the numbers of which are above them."""
_AXIS = re.compile("coord(inate)?s?|pos(ition)?|value|axis|wert|achse")
_X_NAMES, _Y_NAMES, _ANGLES, _RADII = (
    {"x", "rechts", "easting"},
    {"y", "hoch", "northing"},
    {"angle", "theta", "phi", "winkel", "deg"},
    {"r", "radius", "rho"},
)


class Points(NamedTuple):
    """The points of a file, inches, and what to say of it."""

    places: list[Place]
    notes: list[str]


class _Row(NamedTuple):
    """A line, or one of the points in it: its columns, and the number and unit of each that is a number."""

    number: int
    text: str
    comment: bool
    cells: list[str] = []  # noqa: RUF012  # never changed
    values: list[tuple[float, str] | None] = []  # noqa: RUF012

    @property
    def numbers(self) -> int:
        return len(self.values) - self.values.count(None)

    @property
    def names(self) -> list[set[str]]:
        """The words of each cell; "xcoord" and "PosX" are x."""
        return [{_AXIS.sub("", word) for word in _words(cell)} for cell in self.cells]

    def error(self, said: str) -> WorkError:
        return WorkError(f"line {self.number}: {said}")


def read(content: bytes, mm: bool = False) -> Points:
    """Return the points of a file, without unit in inches, or with `mm` millimetres. Raises WorkError."""
    lines = [line for at, text in enumerate(lines_of(_text(content)), 1) for line in _line(at, text)]
    given = next((line.text[4:5] for line in lines if line.text.lower().startswith("sep=")), "")
    lines = [line for line in lines if not line.text.lower().startswith("sep=")]
    styles = [style for style in _STYLES if given in ("", style[0])] or [(given, point) for point in ".,"]
    tables = ([row for line in lines for row in _rows(line, *style)] for style in styles)
    best = max(zip(styles, tables, strict=True), key=lambda each: _fit(each[1], each[0][1]))
    return _Table(best[1], best[0][0]).points(mm)


def _text(content: bytes) -> str:
    for begin, what in _OTHERS.items():
        if re.match(begin, content.lstrip()):
            raise WorkError(f"it is {what}")
    wide = content.startswith((b"\xff\xfe", b"\xfe\xff")) or b"\0" in content[:8]
    for code in ("utf-16-be" if content[:1] == b"\0" else "utf-16",) if wide else ("utf-8-sig", "cp1252"):
        with suppress(UnicodeDecodeError):
            return content.decode(code).translate(_PLAIN)
    raise WorkError("it is no text: save it as CSV in UTF-8")


def _line(number: int, text: str) -> Iterator[_Row]:
    """Yield the line, unless it is a comment with digits or has marks only."""
    said, *rest = _COMMENT.split(text, maxsplit=1)
    comment = bool(rest) and not said.strip()
    said = rest[0] if comment else said
    if said.strip(' \t,;:|"-') and not (comment and re.search(r"\d", said)):
        yield _Row(number, said, comment)


def _rows(line: _Row, mark: str, point: str) -> Iterator[_Row]:
    """Yield the line with its columns, or a row for each pair of brackets that has two numbers or more."""

    def row(text: str) -> _Row:
        cells = _cells(text, mark)
        return line._replace(cells=cells, values=[_number(cell, point) for cell in cells])

    found = [each for each in map(row, _BRACKETS.findall(line.text)) if each.numbers > 1]
    outside = found and row(_BRACKETS.sub("", line.text)).numbers
    yield from found if found and not outside else [row(line.text)]


def _cells(text: str, mark: str) -> list[str]:
    """Return a line's columns without a leading name, and empty ones at the end."""
    _, *keyed = _KEY.split(text)
    values = {
        key.lower(): value.strip(' \t,;"}]') for key, value in zip(keyed[::2], keyed[1::2], strict=True)
    }
    if {"x", "y"} <= values.keys():
        return [values[key] for key in sorted(values)]
    text = _NAMED.sub("", text).strip(" ").rstrip(" ,;|\t")
    if mark in (" ", ", "):
        return [cell.strip('"') for cell in re.split(r"\s+" if mark == " " else r",\s+", text)]
    return [cell.strip() for cell in next(csv.reader([text], delimiter=mark, skipinitialspace=True), [])]


def _number(cell: str, point: str) -> tuple[float, str] | None:
    """Return the number that a cell says, and its unit or "°"; None if it says none."""
    found = _NUMBER[point].fullmatch(cell.strip(" '"))
    unit = (found[2] or "").lower() if found else ""
    if not found or unit not in {"", *_UNITS, *_TURNS}:
        return None
    apart = "[.'’ ]" if point == "," else "[,'’ ]"
    number = float(re.sub(apart, "", found[1]).replace(",", ".").lower().replace("d", "e"))
    return (number, unit) if isfinite(number) else None


def _fit(rows: list[_Row], point: str) -> tuple[float, int, int]:
    """How well a style fits: rows of two numbers or more and the usual columns, less what is bad in them."""
    good = [row for row in rows if row.numbers > 1]
    counts = Counter(len(row.cells) for row in good)
    bad = [[cell for cell, value in zip(row.cells, row.values, strict=True) if not value] for row in good]
    joined = sum(any(map(_JOINED.search, cells)) for cells in bad)
    thousands = sum(bool(_THOUSANDS.search(cell)) and point not in cell for row in good for cell in row.cells)
    return max(counts.values(), default=0) - joined / 2, -sum(map(len, bad)), -thousands


def _words(text: str) -> list[str]:
    return re.findall(r"[^\W\d_]+", text.lower())


class _Table:
    """The rows of a file, and where in them x and y are."""

    def __init__(self, rows: list[_Row], mark: str) -> None:
        self._mark = mark
        self._notes: list[str] = []
        self._unit, self._unit_line = "", 0
        self._rows = [row for row in rows if row.numbers > 1]
        if not self._rows:
            first = next((row for row in rows if re.search(r"\d", row.text)), None)
            where = f"line {first.number}: {first.text.strip()[:60]!r}: " if first else ""
            raise WorkError(f"{where}no points: x and y are needed on each line")
        counts = [value[0] for value in self._rows[0].values if value]
        if min(counts) >= _LISTED and sum(counts) == len(self._rows) - 1:
            raise self._rows[0].error(
                "the numbers of points of two lists: make one list of them, in order around the outline"
            )
        odd = [row for row in self._rows if row.values[0] is None]
        if len(odd) == 1 < len(self._rows) - 2:  # such as a sum
            raise odd[0].error(f"{odd[0].text.strip()[:60]!r} is not x and y of a point")
        self._columns = len(self._rows[0].cells)
        self._x = self._unnamed
        self._y, self._turn = self._x + 1, 0.0
        named = [row for row in rows if row.numbers < 2 and not self._is_skipped(row)]
        if named:
            self._find_columns(named[-1])
        elif self._rows[0].numbers - (self._x and self._rows[0].values[0] is not None) > 3:
            raise self._rows[0].error(
                f"{self._columns} columns: which are x and y? A first line with their names, such as x,y, "
                "says it"
            )
        elif self._x and self._rows[0].values[0]:
            self._notes.append("the first column numbers the points: x and y are the next two")

    @property
    def _unnamed(self) -> int:
        """Return the column of x without a header: the second if the first counts or is empty."""
        first = [row.values[0] and row.values[0][0] for row in self._rows]
        counts = (
            len(first) > 2 and first[0] in (0, 1) and first == [first[0] + at for at in range(len(first))]
        )
        return int(self._columns > 2 and (counts or first[0] is None))

    def _is_skipped(self, row: _Row) -> bool:
        """Whether a row without a point is a title, of which a unit is taken; else it is a header."""
        text, names = row.text.strip(), self._names(row)
        for unit in (words[-1] for words in map(_words, row.cells) if words and words[-1] in _UNITS):
            if self._unit and _UNITS[unit] != _UNITS[self._unit] and self._unit_line == row.number:
                raise row.error(f"{text[:60]!r} has two units of length")
            self._unit, self._unit_line = unit, row.number
        alike = len(names) in (self._columns, self._columns - 1)
        digits, first = re.search(r"\d", text), row.number < self._rows[0].number
        named = any(name & (_X_NAMES | _ANGLES) for name in names)
        if named and (alike or not row.comment) and (first or not digits):
            return False
        if first and alike and len(row.cells) > 2 and not (digits or row.comment or self._mark == " "):
            return set().union(*names) <= _UNITS.keys()
        apart = self._mark in text and self._mark != " "
        if digits and not (first and _TITLE.match(text) and not (apart and row.numbers)):
            raise row.error(f"{text[:60]!r} is not x and y of a point")
        if not (row.comment or set(_words(text)) <= _UNITS.keys()):
            self._notes.append(f"line {row.number}: {text[:40]!r} is no point: skipped")
        return True

    def _names(self, row: _Row) -> list[set[str]]:
        """Return the words of each cell, or each word, if other marks part them than part the numbers."""
        words = [{_AXIS.sub("", word)} for word in _words(row.text) if word not in _UNITS]
        return words if len(words) == self._columns != len(row.cells) else row.names

    def _find_columns(self, header: _Row) -> None:
        """Find the columns of x and y, or of a radius and an angle, by their names."""
        found = self._names(header)
        names = [set[str]()] * (len(found) == self._columns - 1) + found
        for xs, ys, polar in ((_X_NAMES, _Y_NAMES, False), (_RADII, _ANGLES, True)):
            x, y = ([at for at, name in enumerate(names) if name & each] for each in (xs, ys))
            if len(x) == len(y) == 1 and x != y and max(*x, *y) < self._columns:
                self._x, self._y = x[0], y[0]
                self._turn = self._turn_of(names[y[0]]) if polar else 0
                return
        raise header.error(f"which columns are x and y? {header.text!r}")

    def _turn_of(self, names: set[str]) -> float:
        """Return how many of the angles are a turn, by their unit or, without one, their size."""
        angles = [row.values[self._y] for row in self._rows if self._y < len(row.values)]
        for unit in (*names, *(angle[1] for angle in angles if angle)):
            if unit in _TURNS:
                return _TURNS[unit]
        if any(angle and abs(angle[0]) > _TURNS["rad"] + 1 for angle in angles):
            return _TURNS["°"]
        self._notes.append("the angles are taken for radians: none is greater than 2 pi")
        return _TURNS["rad"]

    def points(self, mm: bool) -> Points:
        places = [self._place(row) for row in self._rows]
        across = max(max(each) - min(each) for each in zip(*places, strict=True))
        if self._unit:
            if mm and _UNITS[self._unit] != _UNITS["mm"]:
                raise WorkError(f"line {self._unit_line}: the unit is {self._unit}: leave out --mm")
            self._notes.append(f"lengths are in {self._unit}, as line {self._unit_line} says")
        elif not mm and across * 1000 > X_TRAVEL:
            raise WorkError(
                f"the points are {across:g} across, and the table is {X_TRAVEL / 1000:g} in: if they are "
                "millimetres, give --mm"
            )
        scale = _UNITS[self._unit or ("mm" if mm else "in")]
        return Points([(x / scale, y / scale) for x, y in places], self._notes)

    def _place(self, row: _Row) -> Place:
        pair = []
        for column, name in ((self._x, "x"), (self._y, "y")):
            cell = row.cells[column] if column < len(row.cells) else ""
            found = row.values[column] if column < len(row.cells) else None
            if found is None:
                raise row.error(f"{cell!r} is not the {name} of a point, {row.text.strip()[:60]!r}")
            number, unit = found
            if unit in _UNITS and unit != self._unit:
                if self._unit and _UNITS[unit] != _UNITS[self._unit]:
                    raise row.error(f"{cell!r} is not in {self._unit}, as the others are")
                self._unit, self._unit_line = unit, row.number
            pair.append(number)
        x, y = pair
        if not self._turn:
            return x, y
        angle = y * 2 * pi / self._turn
        return x * cos(angle), x * sin(angle)
