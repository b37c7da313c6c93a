"""`pdp8 thesis` as a user types it."""

from pathlib import Path
from xml.etree import ElementTree as ET

import pytest

from pdp8.cli import thesis
from pdp8.cli.thesis import _show
from pdp8.thesis.catalogue import catalogue
from pdp8.thesis.numbers import numbers, table
from pdp8.thesis.table import Table
from tests.conftest import Call, Shell


@pytest.mark.parametrize(
    ("line", "firsts"),
    [
        ("list", [item.number for item in catalogue()]),
        ("numbers --chapter 9", [f"{one.page}" for one in numbers() if one.chapter == 9]),
    ],
)
def test_a_list_has_a_line_for_each(line: str, firsts: list[str], shell: Shell) -> None:
    lines = shell(f"pdp8 thesis {line}").stdout.decode().splitlines()
    assert [line.split()[0] for line in lines[1:]] == firsts


def test_evidence_is_a_table(shell: Shell) -> None:
    row = "107  damaged  0103 0040 PQ.40  0103 0040 P0,40  0 and a comma misread; P0, beside P1"
    assert shell("pdp8 thesis evidence eia.pal | grep PQ.40").stdout.decode().split() == row.split()


def test_evidence_as_tei_is_xml(shell: Shell) -> None:
    root = ET.fromstring(shell("pdp8 thesis evidence eia.pal --tei").stdout)
    assert root.tag == "{http://www.tei-c.org/ns/1.0}TEI"


@pytest.mark.parametrize(
    ("line", "made", "begins"),
    [
        ("make 4.1", "figure-4.1.svg", "<svg"),
        ("make b --facsimile", "facsimile-B.txt", "Facsimile of Appendix B"),
    ],
)
def test_what_is_made_is_left_in_a_folder(
    line: str, made: str, begins: str, shell: Shell, tmp_path: Path
) -> None:
    done = shell(f"pdp8 thesis {line} --out made")
    assert (done.returncode, done.stderr.decode()) == (0, f"wrote {made} in made\n")
    (file,) = (tmp_path / "made").iterdir()
    assert (file.name, file.read_text()[: len(begins)]) == (made, begins)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("make 4.2", "make: Figure 4.2: lost. Photograph, lost"),
        ("make 7.9", "make: 7.9: no such figure"),
        ("make 7.2 --facsimile", "make: 7.2: no facsimile; there is one of B, C, D\n"),
        ("evidence bin.pal", "evidence: bin.pal: no evidence; there is some of eia.pal"),
    ],
)
def test_what_there_is_not_is_said(line: str, said: str, shell: Shell) -> None:
    done = shell(f"pdp8 thesis {line}")
    assert done.returncode == 1
    assert done.stderr.decode().startswith(f"pdp8 thesis {said}")


def test_a_narrow_terminal_has_every_word(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("COLUMNS", "60")
    monkeypatch.setenv("NO_COLOR", "1")
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    rows = table(7)
    _show(rows, "", coloured_by=4)
    lines = [line.rstrip() for line in capsys.readouterr().out.splitlines()]
    assert max(map(len, lines)) <= 60
    assert all(
        " ".join(cell.split()) in " ".join(" ".join(lines).split()) for row in rows.rows for cell in row
    )


def test_a_terminal_of_80_columns_has_a_table(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.stdout.isatty", lambda: True)
    for width in (79, 80):
        monkeypatch.setenv("COLUMNS", str(width))
        _show(Table(("a",) * 5, (("1", "2", "3", "4", "lost"),)), "", coloured_by=4)
        assert ("│" in capsys.readouterr().out) == (width == 80)


def test_make_alone_says_where_the_numbers_are(call: Call) -> None:
    status, printed, said = call("pdp8 thesis make")
    assert (status, printed) == (2, "")
    assert "give a NUMBER, or all; pdp8 thesis list has the numbers" in said


def test_each_state_but_the_ordinary_one_has_its_colour(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    ordinary = {"legible", "from the text", "computed", "not made here"}
    states = set[str]()

    def shown(rows: Table, title: str, coloured_by: int, output: str = "-") -> None:
        states.update(row[coloured_by] for row in rows.rows)

    monkeypatch.setattr(thesis, "_show", shown)
    for command in ("list", "numbers", "collate", "evidence eia.pal", "evidence circle.for"):
        assert call(f"pdp8 thesis {command}")[0] == 0
    assert states - ordinary == set(thesis._STYLES)
