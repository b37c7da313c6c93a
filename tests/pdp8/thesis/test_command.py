"""`pdp8 thesis` as a user types it."""

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


def test_each_state_but_the_ordinary_one_has_its_colour(call: Call, monkeypatch: pytest.MonkeyPatch) -> None:
    ordinary = {"legible", "from the text", "computed", "not made here"}
    states = set[str]()

    def shown(rows: Table, title: str, coloured_by: int, output: str = "-") -> None:
        states.update(row[coloured_by] for row in rows.rows)

    monkeypatch.setattr(thesis, "_show", shown)
    for command in ("list", "numbers", "collate", "evidence eia.pal", "evidence circle.for"):
        assert call(f"pdp8 thesis {command}")[0] == 0
    assert states - ordinary == set(thesis._STYLES)
