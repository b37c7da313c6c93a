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
"""What separates columns, and the decimal mark; of two that read as much the first."""
_NUMBER = {
    point: re.compile(
        rf"[+-]?([1-9]\d{{0,2}}([{apart}'’ ]\d{{3}})+(?!\d)|\d+)?([{point}]\d*)?([ED][+-]?\d+)?",
        re.IGNORECASE,
    )
    for point, apart in (".,", ",.")
}
_WITH_UNIT = re.compile(r"(.*?[\d.,])\s*([^\W\d_]+|[\"°])?")
_THOUSANDS = re.compile(r"\d[.,'’ ]\d{3}(?!\d)")
_COMMENT = re.compile(
    r"^\s*(?://|[!%]|#(?!DIV|N/A|NV|REF|BEZUG|VALUE|WERT|NAME|NUM|ZAHL|NULL))+|\s(?:#|//)\s"
)
_KEY = re.compile(r"\b([xyz])\"?\s*[:=]\s*", re.IGNORECASE)
_BRACKETS = re.compile(r"[\[({]([^][(){}]*)[\])}]")
_NAMED = re.compile(r"^\s*[a-z_]\w*\s+(?=[-+.\d])", re.IGNORECASE)
_TITLE = re.compile(r"[\"'*;\s]*(?!nan|inf)[^\W\d_]", re.IGNORECASE)
_OTHERS = {
    b"PK": "a workbook: save its sheet as CSV",
    b"<": "XML or SVG: export the points as CSV",
    b"%PDF": "a PDF: export the points as CSV",
}
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


class _Line(NamedTuple):
    number: int
    text: str
    comment: bool = False


class _Row(NamedTuple):
    line: _Line
    cells: list[str]

    @property
    def names(self) -> list[set[str]]:
        """The words of each cell; "xcoord" and "PosX" are x."""
        return [{_AXIS.sub("", word) for word in _words(cell)} for cell in self.cells]

    def error(self, said: str) -> WorkError:
        """Return an error in this line."""
        return WorkError(f"line {self.line.number}: {said}")


def read(content: bytes, mm: bool = False) -> Points:
    """Return the points of a file, without unit in inches, or with `mm` millimetres. Raises WorkError."""
    lines = [line for at, text in enumerate(lines_of(_text(content)), 1) for line in _line(at, text)]
    given = next((line.text[4:5] for line in lines if line.text.lower().startswith("sep=")), "")
    lines = [line for line in lines if not line.text.lower().startswith("sep=")]
    styles = [style for style in _STYLES if given in ("", style[0])] or [(given, point) for point in ".,"]
    mark, point = max(styles, key=lambda style: _fits(lines, *style))
    return _Table([row for line in lines for row in _rows(line, mark, point)], mark, point).points(mm)


def _text(content: bytes) -> str:
    for begin, what in _OTHERS.items():
        if content.lstrip().startswith(begin):
            raise WorkError(f"it is {what}")
    if re.match(rb"\s*0\s*\r?\n\s*SECTION", content):
        raise WorkError("it is a DXF drawing: export the points as CSV")
    wide = content.startswith((b"\xff\xfe", b"\xfe\xff")) or b"\0" in content[:8]
    for code in ("utf-16-be" if content[:1] == b"\0" else "utf-16",) if wide else ("utf-8-sig", "cp1252"):
        with suppress(UnicodeDecodeError):
            return re.sub("[\ufeff\x1a]", "", content.decode(code)).translate(_PLAIN)
    raise WorkError("it is no text: save it as CSV in UTF-8")


_PLAIN = str.maketrans({"\u2212": "-", "\u00a0": " ", "\u202f": " "})


def _line(number: int, text: str) -> Iterator[_Line]:
    """Yield what there is to read in a line: no comment with digits, no line of marks alone."""
    said, *rest = _COMMENT.split(text, maxsplit=1)
    comment = bool(rest) and not said.strip()
    said = rest[0] if comment else said
    if said.strip(' \t,;:|"-') and not (comment and re.search(r"\d", said)):
        yield _Line(number, said, comment)


def _rows(line: _Line, mark: str, point: str) -> Iterator[_Row]:
    """Yield a row for the line, or for each pair of brackets that has two numbers or more."""
    inside = [_cells(text, mark) for text in _BRACKETS.findall(line.text)]
    found = [cells for cells in inside if _numbers(cells, point) > 1]
    outside = found and _numbers(_cells(_BRACKETS.sub("", line.text), mark), point)
    cells = found if found and not outside else [_cells(line.text, mark)]
    yield from (_Row(line, each) for each in cells)


def _cells(text: str, mark: str) -> list[str]:
    """Return a line's columns without a leading name, and empty ones at the end."""
    _, *keyed = _KEY.split(text)
    values = {
        key.lower(): value.strip(' \t,;"}]') for key, value in zip(keyed[::2], keyed[1::2], strict=True)
    }
    if {"x", "y"} <= values.keys():
        return [values[key] for key in sorted(values)]
    text = _NAMED.sub("", text).strip(" ")
    if mark in (" ", ", "):
        cells = [cell.strip('"') for cell in re.split(r"\s+" if mark == " " else r",\s+", text)]
    else:
        cells = [cell.strip() for cell in next(csv.reader([text], delimiter=mark, skipinitialspace=True), [])]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def _fits(lines: list[_Line], mark: str, point: str) -> tuple[int, int, int]:
    """How many rows fit this style: two numbers or more, the usual number of columns, less bad cells."""
    counts: Counter[int] = Counter()
    others = thousands = 0
    for cells in (row.cells for line in lines for row in _rows(line, mark, point)):
        numbers = _numbers(cells, point)
        if numbers > 1:
            counts[len(cells)] += 1
            others += len(cells) - numbers
            thousands += sum(bool(_THOUSANDS.search(cell)) and point not in cell for cell in cells)
    return max(counts.values(), default=0), -others, -thousands


def _words(text: str) -> list[str]:
    return re.findall(r"[^\W\d_]+", text.lower())


def _numbers(cells: list[str], point: str) -> int:
    return sum(_number(cell, point) is not None for cell in cells)


def _number(cell: str, point: str) -> tuple[float, str] | None:
    """Return the number that a cell says, and its unit or "°"; None if it says none."""
    found = _WITH_UNIT.fullmatch(cell.strip(" '"))
    if not found:
        return None
    text, unit = found[1], (found[2] or "").lower()
    if not (re.search(r"\d", text) and _NUMBER[point].fullmatch(text)) or unit not in {"", *_UNITS, *_TURNS}:
        return None
    apart = "[.'’ ]" if point == "," else "[,'’ ]"
    plain = re.sub(apart, "", text).replace(",", ".").lower().replace("d", "e")
    return (float(plain), unit) if isfinite(float(plain)) else None


class _Table:
    """The rows of a file, and where in them x and y are."""

    def __init__(self, rows: list[_Row], mark: str, point: str) -> None:
        self._mark, self._point = mark, point
        self._notes: list[str] = []
        self._unit, self._unit_line = "", 0
        self._rows = [row for row in rows if _numbers(row.cells, point) > 1]
        if not self._rows:
            first = next((row.line for row in rows if re.search(r"\d", row.line.text)), None)
            where = f"line {first.number}: {first.text.strip()[:60]!r}: " if first else ""
            raise WorkError(f"{where}no points: x and y are needed on each line")
        self._columns = len(self._rows[0].cells)
        self._x, self._y, self._turn = self._unnamed, self._unnamed + 1, 0.0
        named = [row for row in rows if _numbers(row.cells, point) < 2 and not self._is_skipped(row)]
        if named:
            self._find_columns(named[-1])
        elif sum(_number(cell, point) is not None for cell in self._rows[0].cells[self._x :]) > 3:
            raise self._rows[0].error(
                f"{self._columns} columns: which are x and y? A first line with their names, such as x,y, "
                "says it"
            )
        elif self._x and _number(self._rows[0].cells[0], point):
            self._notes.append("the first column numbers the points: x and y are the next two")

    @property
    def _unnamed(self) -> int:
        """The column of x without a header: after one that counts, or has no number."""
        numbers = [_number(row.cells[0], self._point) for row in self._rows]
        values = [number[0] for number in numbers if number]
        counts = len(values) > 2 and values[0] in (0, 1)
        counts = counts and values == [values[0] + at for at in range(len(numbers))]
        return int(self._columns > 2 and (counts or not numbers[0]))

    def _is_skipped(self, row: _Row) -> bool:
        """Whether a row without a point is a title, of which a unit is taken; else it is a header."""
        text, names = row.line.text.strip(), row.names
        for unit in (words[-1] for words in map(_words, row.cells) if words and words[-1] in _UNITS):
            if self._unit and _UNITS[unit] != _UNITS[self._unit] and self._unit_line == row.line.number:
                raise row.error(f"{text[:60]!r} has two units of length")
            self._unit, self._unit_line = unit, row.line.number
        alike = len(names) in (self._columns, self._columns - 1)
        if any(name & (_X_NAMES | _ANGLES) for name in names) and (alike or not row.line.comment):
            return False
        digits, first = re.search(r"\d", text), row.line.number < self._rows[0].line.number
        if first and alike and len(names) > 2 and not (digits or row.line.comment or self._mark == " "):
            return set().union(*names) <= _UNITS.keys()
        apart = self._mark in text and self._mark != " "
        if digits and not (first and _TITLE.match(text) and not (apart and _numbers(row.cells, self._point))):
            raise row.error(f"{text[:60]!r} is not x and y of a point")
        if not (row.line.comment or set(_words(text)) <= _UNITS.keys()):
            self._notes.append(f"line {row.line.number}: {text[:40]!r} is no point: skipped")
        return True

    def _find_columns(self, header: _Row) -> None:
        """Find the columns of x and y, or of a radius and an angle, by their names."""
        names = [set[str]()] * (len(header.cells) == self._columns - 1) + header.names
        for xs, ys, polar in ((_X_NAMES, _Y_NAMES, False), (_RADII, _ANGLES, True)):
            x, y = ([at for at, name in enumerate(names) if name & each] for each in (xs, ys))
            if len(x) == len(y) == 1:
                self._x, self._y = x[0], y[0]
                unit = next((word for word in names[y[0]] if word in _TURNS), "°")
                self._turn = _TURNS[unit] if polar else 0
                return
        raise header.error(f"which columns are x and y? {header.line.text!r}")

    def points(self, mm: bool) -> Points:
        """Return the points."""
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
            found = _number(cell, self._point)
            if found is None:
                raise row.error(f"{cell!r} is not the {name} of a point, {row.line.text.strip()[:60]!r}")
            number, unit = found
            if unit in _UNITS and unit != self._unit:
                if self._unit and _UNITS[unit] != _UNITS[self._unit]:
                    raise row.error(f"{cell!r} is not in {self._unit}, as the others are")
                self._unit, self._unit_line = unit, row.line.number
            pair.append(number)
        x, y = pair
        if not self._turn:
            return x, y
        angle = y * 2 * pi / self._turn
        return x * cos(angle), x * sin(angle)


def lines(points: Points) -> Iterator[str]:
    """Yield the points as a part program reads them."""
    yield from (f"{x!r},{y!r}" for x, y in points.places)
