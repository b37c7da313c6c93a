"""Points from a file as spreadsheets and CAD programs write it: x and y of each, wherever its columns are.

    sep=;                        what separates the columns
    Nr;X [mm];Y [mm]             a header: its names say which columns are x and y, and in which unit
    1;38,1;0,0                   a point: decimal commas or points, thousands apart, quoted or not
    # made on Monday             comments and titles, which are skipped

The separator and the decimal mark are those by which most lines are numbers. Without a header x and y are the
first two columns, after a column that only counts. An angle and a radius in the header are polar coordinates.
Not read: workbooks (.xlsx, .ods), drawings (.dxf, .svg).
"""

import csv
import re
from collections import Counter
from collections.abc import Iterator
from contextlib import suppress
from math import cos, isfinite, radians, sin
from typing import Final, NamedTuple

from tapes.errors import WorkError
from tapes.hydrapoint import X_TRAVEL
from tapes.text import lines_of

Place = tuple[float, float]

_INCHES: Final = {"in": 1.0, "inch": 1.0, "inches": 1.0, "zoll": 1.0, "mm": 25.4, "cm": 2.54, "m": 0.0254}
"""How many of a unit are an inch."""
_UNITS = _INCHES | {'"': 1.0, "°": 1.0, "deg": 1.0}
_STYLES = [(mark, point) for mark in ("\t", ";", "|", ", ", ",", " ") for point in ".,"]
"""What separates columns, and the decimal mark; of two that read as much the first."""
_NUMBER = {
    ".": re.compile(r"[+-]?([1-9]\d{0,2}([,'’ ]\d{3})+(?!\d)|\d+)?(\.\d*)?([ED][+-]?\d+)?", re.IGNORECASE),
    ",": re.compile(r"[+-]?([1-9]\d{0,2}([.'’ ]\d{3})+(?!\d)|\d+)?(,\d*)?([ED][+-]?\d+)?", re.IGNORECASE),
}
_THOUSANDS = re.compile(r"\d[.,'’ ]\d{3}(?!\d)")
_COMMENT = re.compile(r"^\s*(//|!|%|#(?!(DIV|N/A|NV|REF|BEZUG|VALUE|WERT|NAME|NUM|ZAHL|NULL)))|\s+#\s")
_KEYS = re.compile(r"\b([xyz])\s*[:=]\s*([-+\d.,e]+)", re.IGNORECASE)
_NAMED = re.compile(r"^\s*[a-z_]\w*\s+(?=[-+.\d])", re.IGNORECASE)
_OTHERS = {b"PK": "a workbook: save its sheet as CSV", b"<": "XML or SVG: export the points as CSV"}
_RADIANS = {"rad", "radian", "radians"}
_X_NAMES, _Y_NAMES, _ANGLES, _RADII = (
    {"x", "rechtswert", "easting"},
    {"y", "hochwert", "northing"},
    {"angle", "theta", "phi", "winkel", "deg"},
    {"r", "radius", "rho"},
)


class Points(NamedTuple):
    """The points of a file, inches, and what to say of it."""

    places: list[Place]
    notes: list[str]


class _Row(NamedTuple):
    number: int
    text: str
    cells: list[str]


def read(content: bytes, mm: bool = False) -> Points:
    """Return the points of a file, without unit in inches, or with `mm` millimetres. Raises WorkError."""
    every = enumerate((_COMMENT.split(line)[0] for line in lines_of(_text(content))), 1)
    lines = [(at, line) for at, line in every if line.strip(' \t,;|"-\ufeff')]
    given = next((line[4:5] for _, line in lines if line.lower().startswith("sep=")), "")
    lines = [(at, line) for at, line in lines if not line.lower().startswith("sep=")]
    styles = [style for style in _STYLES if given in ("", style[0])] or [(given, point) for point in ".,"]
    mark, point = max(styles, key=lambda style: _fits(lines, *style))
    rows = [_Row(at, line, _cells(line, mark)) for at, line in lines]
    return _Table(rows, point).points(mm)


def _text(content: bytes) -> str:
    for begin, what in _OTHERS.items():
        if content.lstrip().startswith(begin):
            raise WorkError(f"it is {what}")
    if re.match(rb"\s*0\s*\r?\n\s*SECTION", content):
        raise WorkError("it is a DXF drawing: export the points as CSV")
    wide = content.startswith((b"\xff\xfe", b"\xfe\xff")) or b"\0" in content[:8]
    for code in ("utf-16",) if wide else ("utf-8-sig", "cp1252"):
        with suppress(UnicodeDecodeError):
            return content.decode(code).replace("\r\n", "\n").replace("\r", "\n")
    raise WorkError("it is no text: save it as CSV in UTF-8")


def _cells(line: str, mark: str) -> list[str]:
    """Return a line's columns without brackets, a leading name, and empty ones at the end."""
    line = _NAMED.sub("", re.sub(r"[\[\](){}]", " ", line.replace("\ufeff", "")))
    if len(keys := {key.lower(): value for key, value in _KEYS.findall(line)}) > 1:
        return [keys[key] for key in sorted(keys)]
    line = line.replace("\u2212", "-").replace("\u00a0", " ").replace("\u202f", " ").strip(" ")
    if mark in (" ", ", "):
        found = re.split(r"\s+" if mark == " " else r",\s+", line)
        cells = [cell.strip('"') for cell in found]
    else:
        cells = [cell.strip() for cell in next(csv.reader([line], delimiter=mark, skipinitialspace=True), [])]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def _fits(lines: list[tuple[int, str]], mark: str, point: str) -> tuple[int, int, int]:
    """How many lines fit this style: two numbers or more, the usual number of columns, less bad cells."""
    counts: Counter[int] = Counter()
    others = thousands = 0
    for _, line in lines:
        cells = _cells(line, mark)
        numbers = sum(_number(cell, point) is not None for cell in cells)
        if numbers > 1:
            counts[len(cells)] += 1
            others += len(cells) - numbers
            thousands += sum(bool(_THOUSANDS.search(cell)) and point not in cell for cell in cells)
    return max(counts.values(), default=0), -others, -thousands


def _number(cell: str, point: str) -> tuple[float, str] | None:
    """Return the number that a cell says, and its unit or "°"; None if it says none."""
    text, unit = cell.strip(" '"), ""
    for name in sorted(_UNITS, key=len, reverse=True):
        if text.lower().endswith(name) and text[: -len(name)].strip()[-1:].isdigit():
            text, unit = text[: -len(name)].strip(), name
            break
    if not (re.search(r"\d", text) and _NUMBER[point].fullmatch(text)):
        return None
    apart = "[.'’ ]" if point == "," else "[,'’ ]"
    plain = re.sub(apart, "", text).replace(",", ".").lower().replace("d", "e")
    return (float(plain), unit) if isfinite(float(plain)) else None


class _Table:
    """The rows of a file, and where in them x and y are."""

    def __init__(self, rows: list[_Row], point: str) -> None:
        self._point = point
        self._notes: list[str] = []
        self._unit, self._unit_line = "", 0
        self._polar = False
        self._x, self._y = 0, 1
        self._header: _Row | None = None
        self._rows = [row for row in rows if self._is_point(row)]
        if not self._rows:
            first = next((row for row in rows if re.search(r"\d", row.text)), None)
            where = f"line {first.number}: {first.text.strip()[:60]!r}: " if first else ""
            raise WorkError(f"{where}no points: x and y are needed on each line")

    def _is_point(self, row: _Row) -> bool:
        """Whether a row has numbers; names and units are taken from a header row."""
        numbers = sum(_number(cell, self._point) is not None for cell in row.cells)
        names = [set(re.findall(r"[a-z]+", cell.lower())) for cell in row.cells]
        words = [word for cell in row.cells for word in re.findall(r"[a-z]+", cell.lower())]
        for unit in (word for word in words if word in _INCHES and numbers < 2):  # of "X in mm" the last
            self._unit, self._unit_line = unit, row.number
        if numbers > 1:
            return True
        if any(map(_X_NAMES.__and__, names)) or any(map(_ANGLES.__and__, names)):
            self._header = row
        elif not re.search(r"\d", row.text):
            if not names or not set.union(*names) <= _INCHES.keys():
                self._notes.append(f"line {row.number}: {row.text.strip()[:40]!r} is no point: skipped")
        elif self._header is None and numbers == 0:
            self._notes.append(f"line {row.number}: {row.text.strip()[:40]!r} is no point: skipped")
        else:
            raise WorkError(f"line {row.number}: {row.text.strip()[:60]!r} is not x and y of a point")
        return False

    def points(self, mm: bool) -> Points:
        """Return the points."""
        self._find_columns()
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
        scale = _UNITS[self._unit] if self._unit else _UNITS["mm"] if mm else 1.0
        return Points([(x / scale, y / scale) for x, y in places], self._notes)

    def _find_columns(self) -> None:
        """Find the columns of x and y by the header, or after a numbering column."""
        first = self._rows[0]
        columns = len(first.cells)
        if self._header:
            names = [set(re.findall(r"[a-z]+", cell.lower())) for cell in self._header.cells]
            names = [set[str]()] * (columns - len(names) if len(names) == columns - 1 else 0) + names
            for xs, ys, polar in ((_X_NAMES, _Y_NAMES, False), (_RADII, _ANGLES, True)):
                x, y = ([at for at, name in enumerate(names) if name & each] for each in (xs, ys))
                if x and y:
                    self._x, self._y, self._polar = x[0], y[0], polar
                    self._turn = 1.0 if names[y[0]] & _RADIANS else radians(1)
                    return
            raise WorkError(f"line {self._header.number}: which columns are x and y? {self._header.text!r}")
        if columns > 2 and self._counts():
            self._x, self._y = 1, 2
            self._notes.append("the first column numbers the points: x and y are the next two")
        elif columns > 2 and _number(first.cells[0], self._point) is None:
            self._x, self._y = 1, 2
        elif columns > 3 and _number(first.cells[3], self._point):
            raise WorkError(
                f"line {first.number}: {columns} columns: which are x and y? A first line with their names, "
                "such as x,y, says it"
            )

    def _counts(self) -> bool:
        numbers = [_number(row.cells[0], self._point) for row in self._rows]
        values = [number[0] for number in numbers if number]
        start = values[0] if values else 2
        return len(values) > 2 and start in (0, 1) and values == [start + at for at in range(len(numbers))]

    def _place(self, row: _Row) -> Place:
        pair = []
        for column, name in ((self._x, "x"), (self._y, "y")):
            cell = row.cells[column] if column < len(row.cells) else ""
            found = _number(cell, self._point)
            if found is None:
                said = row.text.strip()[:60]
                raise WorkError(f"line {row.number}: {cell!r} is not the {name} of a point, {said!r}")
            number, unit = found
            if unit not in ("", "°", "deg", self._unit):
                if self._unit and _UNITS[unit] != _UNITS[self._unit]:
                    raise WorkError(f"line {row.number}: {cell!r} is not in {self._unit}, as the others are")
                self._unit, self._unit_line = unit, row.number
            pair.append(number)
        x, y = pair
        return (x * cos(y * self._turn), x * sin(y * self._turn)) if self._polar else (x, y)


def lines(points: Points) -> Iterator[str]:
    """Yield the points as a part program reads them."""
    yield from (f"{x!r},{y!r}" for x, y in points.places)
