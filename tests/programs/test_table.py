"""Points as spreadsheets and CAD programs write them."""

from collections.abc import Iterable
from itertools import product
from math import cos, hypot, pi, sin

import pytest

from programs.table import read
from tapes.errors import WorkError

POINTS = [(1.5 * cos(2 * pi * at / 60), 1.2 * sin(2 * pi * at / 60)) for at in range(60)]


def lines(rows: Iterable[str], *header: str) -> str:
    return "\n".join([*header, *rows]) + "\n"


def rows(form: str, scale: float = 1) -> list[str]:
    return [form.format(scale * x, scale * y, number) for number, (x, y) in enumerate(POINTS)]


def german(form: str, scale: float = 1) -> list[str]:
    return [line.replace(".", ",") for line in rows(form, scale)]


FILES = {
    "Excel, German": lines(german("{0:.4f};{1:.4f}"), "X;Y").replace("\n", "\r\n"),
    "Excel, German, mm": lines(german("{0:.3f};{1:.3f}", 25.4), "X [mm];Y [mm]"),
    "Excel, a unit in words": lines(german("{0:.3f};{1:.3f}", 25.4), "X in mm;Y in mm"),
    "Excel, a row of units": lines(german("{0:.3f};{1:.3f}", 25.4), "X;Y", "mm;mm"),
    "Excel, sep=": lines(rows("{0:.4f},{1:.4f},,"), "sep=,"),
    "Excel, Unicode text": "\ufeff" + lines(german("{0:.4f}\t{1:.4f}"), "X\tY"),
    "LibreOffice, quoted": lines(german('"{0:.4f}","{1:.4f}"'), '"x","y"'),
    "FreeCAD": lines(rows("{0:.4f} {1:.4f} 0.0"), "# point cloud", "x y z"),
    "SolidWorks": lines(rows("{0:.4f}mm\t{1:.4f}mm\t0mm", 25.4)),
    "AutoCAD": lines(rows("X = {0:.4f}     Y = {1:.4f}     Z = 0.0000")),
    "pandas": lines(rows("{2},{0!r},{1!r}"), ",x,y"),
    "R": lines(rows('"{2}" {0!r} {1!r}'), '"x" "y"'),
    "gnuplot": "\n\n# Curve 0 of 1\n# x y type\n" + lines(rows("{0:.5f} {1:.5f}  i")),
    "numbered": lines(rows("{2},{0:.4f},{1:.4f},0")),
    "decimal commas by commas": lines(german("{0:.4f}, {1:.4f}")),
    "JSON": "[" + ",\n".join(rows("[{0:.4f}, {1:.4f}]")) + "]\n",
    "Excel, micrometres": lines(german("{0:.1f};{1:.1f}", 25400), "X [µm];Y [µm]"),
    "thousandths": lines(rows("{0:.1f} mil,{1:.1f} mil", 1000)),
    "FreeCAD, console": "[" + ", ".join(rows("Vector ({0:.6f}, {1:.6f}, 0.0)")) + "]\n",
    "Rhino, List": lines(rows("    CV[{2:2d}] ({0:.4f}, {1:.4f}, 0)"), "curve", "  Layer name: Default"),
    "AutoCAD, LIST": lines(
        rows("    at point  X={0:9.4f}  Y={1:9.4f}"), "   LWPOLYLINE  Layer: 0", "   area  5.6511"
    ),
    "AutoCAD, script": lines(rows("POINT {0:.4f},{1:.4f}")),
    "AutoCAD, extracted": lines(
        rows("1,Point,{0:.4f},{1:.4f},0"), "Count,Name,Position X,Position Y,Position Z"
    ),
    "Onshape": lines(rows("{0:.4f} mm, {1:.4f} mm, 0 mm", 25.4)),
    "Fusion": lines(rows("{0:.5f},{1:.5f},0", 2.54), "X(cm),Y(cm),Z(cm)"),
    "CATIA": lines(rows("{0:.4f};{1:.4f};0"), "StartLoft", "StartCurve") + "EndCurve\nEndLoft\nEnd\n",
    "Creo": lines(rows("{0:.4f} {1:.4f} 0"), "Closed Index arclength", "begin section ! 1"),
    "an airfoil": lines(rows(" {0:.6f} {1:.6f}"), "NACA 0012 AIRFOIL"),
    "Fortran": lines(f"{at:5d}{x:10.4f}{y:10.4f}" for at, (x, y) in enumerate(POINTS)),
    "Mathematica": "{" + ", ".join(rows("{{{0:.6f}, {1:.6f}}}")) + "}\n",
    "pgfplots": "\\addplot coordinates {" + " ".join(rows("({0:.6f},{1:.6f})")) + "};\n",
    "JSON by names": "[" + ", ".join(rows('{{"x": {0:.6f}, "y": {1:.6f}}}')) + "]\n",
    "names": lines(rows("X: {0:.4f} mm, Y: {1:.4f} mm", 25.4)),
    "a measuring machine": lines(rows("{2},{1:.4f},{0:.4f},0"), "PointID,PosY,XCoord,PosZ"),
    "a unit above": lines(rows("{0:.3f} {1:.3f} // top", 25.4), "% Units: millimeters"),
    "Matlab": lines(rows("  {0:.4f}, {1:.4f};"), "P = [ ...") + "];\n",
    "named E": lines(german("E{2};{0:.4f};{1:.4f}"), "Name;X;Y"),
    "a title in another unit": lines(rows("{0:.3f},{1:.3f}", 25.4), "Drawing in inch", "x [mm],y [mm]"),
    "a title": lines(german("{0:.4f};{1:.4f}"), "Nocken, Blatt 1", "", "X;Y"),
}


@pytest.mark.parametrize("name", FILES)
@pytest.mark.parametrize("code", ["utf-8", "utf-8-sig", "utf-16"])
def test_a_file_is_read(name: str, code: str) -> None:
    found = read(FILES[name].removeprefix("\ufeff").encode(code)).places
    assert [each for place in found for each in place] == pytest.approx(
        [each for place in POINTS for each in place], abs=1e-4
    )


MARKS = (",", ", ", " , ", ";", " | ", " ", "\t")


def test_names_may_stand_apart_by_another_mark_than_numbers() -> None:
    for mark, other, names, comment in product(MARKS, MARKS, ("yx", "zyx"), ("", "# ")):
        rows = (mark.join(each[-len(names) :]) for each in ("021", "043", "015"))
        found = read(lines(rows, comment + other.join(names)).encode())
        assert found.places == [(1, 2), (3, 4), (5, 1)], (mark, other, names)


def test_a_title_says_no_unit_by_chance() -> None:
    assert not any("lengths" in note for note in read(b"Cam made in Germany\n1,2\n3,4\n").notes)


NUMBERED = "the first column numbers the points: x and y are the next two"


@pytest.mark.parametrize(
    ("text", "notes"),
    [
        ("sep=/\n1/2\n3/4\n5/1\n", []),
        ("P1;1;2\nP2;3;4\nP3;5;1\n", []),
        ("1;1;2\n2;3;4\n3;5;1\n", [NUMBERED]),
        ("1,2\n3,4\nx,y\n5,1\n", []),
        ("# the x axis of it\n1 2\n3 4\n5 1\n", []),
        ("# made;by;hand\n1;1;2\n2;3;4\n3;5;1\n", [NUMBERED]),
        (
            "Nr. 7;Blatt 2;Nocken\nP1;1;2\nP2;3;4\nP3;5;1\n",
            ["line 1: 'Nr. 7;Blatt 2;Nocken' is no point: skipped"],
        ),
        ("1;2\n;;\n3;4\n5;1\n", []),
        ("# x y\n1 1 2\n2 3 4\n3 5 1\n", []),
        ("1;1;2\n2;3;4\n3;5;1\nA;B;C\n", ["line 4: 'A;B;C' is no point: skipped", NUMBERED]),
        (
            "Seite;Teil;Nocken;Werk\n1;2\n3;4\n5;1\n",
            ["line 1: 'Seite;Teil;Nocken;Werk' is no point: skipped"],
        ),
        ("Seite;Teil\n1;2\n3;4\n5;1\n", ["line 1: 'Seite;Teil' is no point: skipped"]),
        ("P1;1;2\n2;3;4\n3;5;1\n", []),
        ("1;2;0\n3;4;0\n5;1;0\n", []),
        ("NACA\n 9. 9.\n\n" + " 0.5 0.1\n" * 18, ["line 1: 'NACA' is no point: skipped"]),
    ],
)
def test_what_is_beside_the_points_is_said_or_skipped(text: str, notes: list[str]) -> None:
    found = read(text.encode())
    assert found.notes == notes
    assert found.places[:3] == [(1, 2), (3, 4), (5, 1)] or text.startswith("NACA")


def test_units_and_columns_are_as_most_lines_have_them() -> None:
    assert read(b"1 mm,2 mm\n3 mm,4 mm\n5 mm,1 mm\n").notes == ["lengths are in mm, as line 1 says"]
    assert read(b"X;Y\nmm;mm\n1;2\n3;4\n5;1\n").notes == ["lengths are in mm, as line 2 says"]
    assert read(b"1;1;2\n2;3;4\n").places == [(1, 1), (2, 3)]
    assert read(b"1;2\n2;4\n3;5\n").places == [(1, 2), (2, 4), (3, 5)]
    assert read(b"1,234;2\n3,456;4\n5,678;1\n").places == [(1.234, 2), (3.456, 4), (5.678, 1)]
    for code in ("utf-16-le", "utf-16-be"):
        assert read("1 2\n3 4\n5 1\n".encode(code)).places == [(1, 2), (3, 4), (5, 1)]
    assert read("Нокен\n1 2\n3 4\n5 1\n".encode("utf-16")).places == [(1, 2), (3, 4), (5, 1)]


def test_an_angle_and_a_radius_are_polar() -> None:
    text = "Winkel;Radius\n0°;1,5\n90°;2\n180°;1\n"
    found = read(text.encode()).places
    assert [hypot(*place) for place in found] == pytest.approx([1.5, 2, 1])
    assert found[1] == pytest.approx((0, 2))
    assert read("angle (gon),r [µm]\n100,25400\n200,1\n".encode()).places[0] == pytest.approx((0, 1))
    for name in (b"theta (rad)", b"theta"):
        polar = name + b",r\n1.570796,2\n3.141593,1\n6.2832,1\n"
        assert read(polar).places[0] == pytest.approx((0, 2), abs=1e-6)
        assert ("the angles are taken for radians: none is greater than 2 pi" in read(polar).notes) == (
            name == b"theta"
        )


def test_a_unit_has_several_names_and_angles_two_signs() -> None:
    assert read(b"1 in,2 inch\n3 inch,4 in\n0 in,1 in\n").places == [(1, 2), (3, 4), (0, 1)]
    for sign in "", "-":
        degrees = read(f"theta,r\n0,2\n{sign}90,1\n{sign}180,1\n".encode()).places
        assert degrees[1] == pytest.approx((0, -1 if sign else 1), abs=1e-9)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("1,2\n3,4\nNaN,5\n", "line 3: 'NaN,5' is not x and y of a point"),
        ("X;Y\n1,5;2\n1;1\n#DIV/0!;0,5\n", "line 4: '#DIV/0!;0,5' is not x and y of a point"),
        ("1,2\n3,4\n5\n", "line 3: '5' is not x and y of a point"),
        ("1,2,3,4\n5,6,7,9\n", "line 1: 4 columns: which are x and y?"),
        ("38.1 0\n0 38.1\n-38.1 0\n", "the points are 76.2 across, and the table is 20 in: if they are"),
        ("(1.25),2\n3,4\n5,6\n", "line 1: '(1.25),2' is not x and y of a point"),
        ("X= 0'-1 1/2\"  Y= 0'-2\"\n", "line 1: 'X= 0\\'-1 1/2\"  Y= 0\\'-2\"': no points"),
        ("1.0e+03 *\n1.5 2\n3 4\n", "line 1: '1.0e+03 *' is not x and y of a point"),
        ("G21\nG1 X1.5 Y2\nX2 Y3\n", "line 1: 'G21': no points"),
        ("X;1,5;2,5;3,5;4\nY;1,5;2,5;3,5;4\n", "line 1: 5 columns: which are x and y?"),
        ("NaN,5\n1,2\n3,4\n", "line 1: 'NaN,5' is not x and y of a point"),
        ("P,N,E\n1,2,3\n2,5,6\n", "line 1: which columns are x and y?"),
        ("X1;Y1;X2;Y2\n1;2;3;4\n", "line 1: which columns are x and y?"),
        ("x mm,y in\n1,2\n3,4\n", "line 1: 'x mm,y in' has two units of length"),
        ("X;Y\n" + "1,5;0,5\n" * 9 + "1,1m7;0,5\n", "line 11: '1,1m7;0,5' is not x and y of a point"),
        ("Nr;X;Y\n1;1;0\n2;0;1\n3;-1;0\nSumme;0;1\n", "line 5: 'Summe;0;1' is not x and y of a point"),
        ('TITLE = "a"\nVARIABLES = "X", "Y"\n1 2\n3 4\n', "line 2: which columns are x and y?"),
        ("NACA\n 12. 12.\n\n" + " 0.5 0.1\n" * 24, "line 2: the numbers of points of two lists"),
        ("%PDF-1.4\n1 2\n", "it is a PDF: export the points as CSV"),
        ("PK\x03\x04", "it is a workbook: save its sheet as CSV"),
        ("NACA\n 10. 10.\n\n" + " 0.5 0.1\n" * 20, "line 2: the numbers of points of two lists"),
        ("1 (2, 3)\n4 (5, 6)\n7 (8, 0)\n", "line 1: '1 (2, 3)'"),
        ("1,2\n3,4\n1e999,5\n", "line 3: '1e999,5' is not x and y of a point"),
        ("1,2\n3,4\nx1,y1\n5,6\n", "line 3: 'x1,y1' is not x and y of a point"),
        ("n;x;y\n1;2\n3;4\n5;1\n", "line 1: which columns are x and y?"),
        ("Sheet;2\n1;2\n3;4\n5;1\n", "line 1: 'Sheet;2' is not x and y of a point"),
        ("Seite;Teil;Nocken\n1;1;2\n2;3;4\n3;5;1\n", "line 1: which columns are x and y?"),
        ("n,x,y\n1,2,3\n2,3\n3,5,1\n", "line 3: '' is not the y of a point, '2,3'"),
        ("n,r,theta\n1,2,90\n2,3\n3,5,180\n", "line 3: '' is not the y of a point, '2,3'"),
        ("n,r,theta\n1,2,a\n2,3,90\n3,5,180\n", "line 2: 'a' is not the y of a point"),
        ("1 kg,2\n3,4\n5,1\n", "line 1: '1 kg,2' is not x and y of a point"),
        ("A;1;2\n2;3;4\n3;5;1\n4;0;0\n", "line 1: 'A;1;2' is not x and y of a point"),
        ("<svg/>", "it is XML or SVG: export the points as CSV"),
        ("  0\nSECTION\n", "it is a DXF drawing: export the points as CSV"),
        ("# O\no C\nv 0 0 0\nv 1 1 0\nl 1 2\n", "it is a mesh (OBJ): export the points as CSV"),
        ("", "no points: x and y are needed on each line"),
    ],
)
def test_what_is_no_point_is_named_with_its_line(text: str, says: str) -> None:
    with pytest.raises(WorkError) as raised:
        read(text.encode())
    assert str(raised.value).startswith(says)


def test_millimetres_are_asked_for_or_said() -> None:
    large = b"38.1 0\n0 38.1\n-38.1 0\n"
    for text in (large, b"x in mm,y in mm\n" + large.replace(b" ", b",")):
        assert read(text, mm=True).places[0] == pytest.approx((1.5, 0))
    with pytest.raises(WorkError, match="line 1: the unit is in: leave out --mm"):
        read(b"x in,y in\n1,2\n3,4\n", mm=True)
    assert read(b"10 0\n0 5\n-10 0\n").places[0] == (10, 0)  # 20 in, as wide as the table


def test_named_columns_are_x_and_y_in_any_order() -> None:
    for text in (b"X=1 Y=2\nX=3 Y=4\nX=5 Y=6\n", b"Y=2 X=1\nY=4 X=3\nY=6 X=5\n"):
        assert [*read(text).places] == [(1, 2), (3, 4), (5, 6)], text
