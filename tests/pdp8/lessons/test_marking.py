"""Marks: what each expectation notices, what a hostile answer can do, and how marks are written."""

import io
import json
import re
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from rich.console import Console

import pal
from pdp8.lessons import handed, marking, page, records, scores
from pdp8.lessons.form import parse
from tests.conftest import Call, case
from tests.pdp8.lessons import HEAD, exercise, mark

IAC = "*200\n\tCLA CLL IAC\n\tDCA A\n\tTAD A\n\tHLT\nA,\t0\n$\n"


def test_what_an_expectation_notices_is_told() -> None:
    """told.txt has the keys of each case, the answer, if it is not the last again, and what is told of it."""
    source = ""
    for section in (Path(__file__).parent / "told.txt").read_text().removeprefix("== ").split("\n== "):
        lines = section.splitlines()
        asked, another, text = "\n".join(line for line in lines if line[0] != ">").partition("\n*")
        source = another + text or source
        with case(section):
            (found,) = mark(exercise(asked), source).marks
            why = [f"{failure.what}: {failure.happened}" for failure in found.failures]
            hints = [f"hint: {hint}" for hint in found.hint.splitlines()]
            told = [line.removeprefix("> ") for line in lines if line[0] == ">"]
            assert told == [*scores.said(found), *why, *hints]


@pytest.mark.parametrize(
    ("looked", "said"),
    [
        ("executed={A=2}", "A is executed or called 2 times at least."),
        ("callers={A=2}", "A is called from 2 places at least."),
        ("indirect=['A']", "One of the words A serves as a pointer, by I."),
        ("unchanged=['A']", "The program leaves A unchanged."),
        ("unchanged=['A','B+1','B+2']", "The program leaves A, B+1 to B+2 unchanged."),
        ("tape='A'\nnul='ignored'", "Blank frames that are punched do not count."),
    ],
)
def test_the_task_names_what_is_looked_at_besides_the_results_once(looked: str, said: str) -> None:
    """After the first START, after a further one, and after both."""
    first, again = f"core={{B=1}}\n{looked}", f"[[case.again]]\n{looked}"
    for form in (looked, f"core={{B=1}}\n{again}", f"{first}\n{again}"):
        assert exercise(form).asked == f"t\n- {said}"


def test_the_inputs_of_the_trial_that_failed_are_told() -> None:
    keys, deposit = f'keys="{"A" * 24}"', 'deposit={"300"=7,"301"="A"}'
    second = f"ac=2\nsr=0o17\nreader={[0o200, 1] + [2] * 23}\n{keys}\n{deposit}"
    (found,) = mark(exercise(f"[[case.trial]]\nac=1\n[[case.trial]]\n{second}"), IAC).marks
    assert found.inputs == (
        f"0300 = 0007, 0301 = A, switches 0017, tape 200 001 {'002 ' * 22}..., keys {' '.join(['301'] * 24)}"
    )


def test_the_start_that_failed_and_its_inputs_are_told() -> None:
    for inputs, told in (("sr=5", "start 2, switches 0005"), ("", "start 2")):
        (found,) = mark(exercise(f"ac=1\n[[case.again]]\nac=3\n{inputs}"), IAC).marks
        assert found.inputs == told
    (found,) = mark(exercise("ac=3\nsr=5"), IAC).marks
    assert found.inputs == "", "a case of one START says its own"


TAPE = pal.assemble(IAC).tape
NO_SOURCE = "this exercise looks at the source: hand in PAL, not a tape"


@pytest.mark.parametrize(
    ("rule", "answer", "fault"),
    [
        ("words=4", IAC, "5 words of core; at most 4 are allowed"),
        ("words=5", IAC, ""),
        ("words=5", TAPE, ""),
        ("required=['ISZ']", IAC.replace("HLT", "HLT /ISZ"), "this exercise requires ISZ"),
        ("required=['IAC']", IAC, ""),
        ("required=['A']", TAPE, NO_SOURCE),
        ("forbidden=['IAC']", IAC, "this exercise forbids IAC"),
        ("forbidden=['A']", TAPE, NO_SOURCE),
        ("", IAC.replace("A,", "B,").replace(" A", " B"), "the tag A is missing; the exercise looks for it"),
        ("", "/nothing\n$\n", "no word for core in it"),
        ("", "*200\nFIELD 1\n*200\n1\n$\n", "address 10200: a PDP-8/L with 4K of core ends at 07777"),
    ],
)
def test_an_answer_that_breaks_a_rule_has_no_points(rule: str, answer: str | bytes, fault: str) -> None:
    result = mark(exercise("ac=1" if rule else "core={A=1}", f"[program]\n{rule}"), answer)
    assert (result.fault, result.points, result.right) == (fault, int(not fault), not fault)


@pytest.mark.parametrize(("count", "more"), [(5, []), (6, ["and 1 more"]), (15, ["and 10 more"])])
def test_five_errors_of_a_source_are_told(count: int, more: list[str]) -> None:
    wrong = "".join(f"\tJMP Q{at}\n" for at in range(count))
    assert mark(exercise("ac=1"), f"*200\n{wrong}$\n").fault.splitlines()[20:] == more


def test_a_line_of_a_sheet_is_marked_by_its_name() -> None:
    sheet = parse(f"{HEAD}[[question]]\nname='A'\nask='?'\nanswer='1234 or 7'\n", "e")
    assert mark(sheet, "a) 01,234 OR  007").right
    for given, got in (("a: 8", "8"), ("a:", "nothing")):
        (found,) = mark(sheet, given).marks
        assert [failure.got for failure in found.failures] == [got]
    form = "no line begins with the name of a question; write a line for each, such as A: ..."
    assert mark(sheet, "7\nb: 7").fault == form


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        ((b"/" * 199 + b"\n") * 81 + b"/" * 184, ""),
        ((b"/" * 199 + b"\n") * 81 + b"/" * 185, "more than 16,384 bytes"),
        (b"/" * 200, ""),
        (b"", "an empty file"),
        (b"\xef\xbb\xbf*200\r\n", ""),
        ("*200".encode("utf-16"), "text in UTF-16: save it as UTF-8 or ASCII, or write it with an editor"),
        (b"\x89PNG\r\n" + bytes(range(256)) * 4, "neither text, such as PAL source, nor a BIN or RIM tape"),
        (b"\n{ }", "JSON: an answer is plain text, or a tape"),
        (rb"{\rtf1\ansi" + bytes(20_000), "a word processor's file: an answer is plain text, or a tape"),
        (b"PK\3\4\x14\0\6\0", "a word processor's file: an answer is plain text, or a tape"),
        (b"%PDF-1.7\n*200", "PDF: an answer is plain text, or a tape"),
        (b"<!DOCTYPE html>", "a web page: an answer is plain text, or a tape"),
        (("*200 /" + "\N{CYRILLIC SMALL LETTER A}" * 90).encode(), ""),
        (b"\n" + b"/" * 201, "line 2 has 201 characters; at most 200 can be"),
    ],
)
def test_an_answer_has_16_kib_in_lines_of_200(
    content: bytes, fault: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert handed.of(content, "a.pal").fault == fault
    (tmp_path / "a.pal").write_bytes(content)
    with open(tmp_path / "a.pal", encoding="ascii") as given:
        monkeypatch.setattr(sys, "stdin", given)
        assert handed.read("-").fault == fault
    assert handed.read(str(tmp_path / "a.pal")).fault == fault


HOSTILE = [
    b"", b"\0" * 1000, b"\xff" * 16_000, (b"\xff" * 100 + b"\n") * 150, b"x" * 70_000, bytes(range(256)) * 60,
    b"*200\n\tTLS\n\tJMP .-1\n$\n",  # punches for ever
    b"*200\n\tJMS .\n\tJMP .-1\n$\n",
    b"*0\n" + b"A,B;" * 12 + b"A" * 150 + b"\n$\n",
    b"*200\n" + b"\tJMP Q\n" * 2000 + b"$\n",
    b"*200\n" + b"".join(b"A%d,\tA%d+1\n" % (n, n + 1) for n in range(1000)) + b"$\n",
    b"*200\n\tDCA I 10\n\tJMP .-1\n$\n",  # writes all of core, itself too
    b"\x80" * 10 + b"\x41\x00\x02" + b"\x80" * 10,
    "*200 \N{RIGHT-TO-LEFT OVERRIDE}\x1b[2J\n$".encode(),
]  # fmt: skip


@pytest.mark.parametrize("content", HOSTILE, ids=range(len(HOSTILE)))
def test_a_hostile_answer_is_marked_like_any_other(content: bytes) -> None:
    given = exercise("ac=1\nseconds=10\ntape='AB'\npage='x'")
    result = marking.mark(given, handed.of(content, "a\x1b[2J.pal"))
    said = "\n".join(scores.details(result))
    ElementTree.fromstring(records.as_junit(given, [result]).partition("\n")[2])
    assert json.loads(as_json := records.as_json(given, [result]))["exercise"] == "e"
    assert as_json.startswith('{\n  "exercise"')
    assert not result.right
    assert len(said) < 10_000
    assert "\x1b" not in said.partition("\n")[2]


def test_two_texts_have_a_caret_under_their_first_difference() -> None:
    texts = ("a" * 40 + "X" + "b" * 30, "a" * 40 + "Y" + "b" * 29)
    assert list(scores.lines(marking.Failure("the page", *texts))) == [
        f"the page     expected {'a' * 30}X{'b' * 29}...",
        f"                  got {'a' * 30}Y{'b' * 29}",
        f"                      {'-' * 30}^",
    ]


def test_two_long_tapes_are_shown_where_they_differ() -> None:
    good = bytes(5000)
    shown = "\n".join(scores.lines(marking.Failure("the tape", good, good[:4000] + b"\x01" + good)))
    assert "9,001 frames, 5,000 expected; the first difference is frame 4000" in shown
    assert [line.split()[0] for line in shown.splitlines()[2:]] == [str(at) for at in range(3998, 4005)]


CLASS = Path(__file__).parent / "class"
GIVEN = parse(
    "title='t'\ntask=''' `o  .<` has\nholes.\n\na: how\nmany?\nb: `where '''\nsolution='x'\n"
    "[[case]]\nname='sum'\n[[case]]\nname='A<B'\npoints=2\n",
    "e",
)
FAILURES = (
    *(marking.Failure("SUM", "0001", "0000"), marking.Failure("the time", "", "", "10 s")),
    *(marking.Failure("instructions", "", "7"), marking.Failure("the tape", b"\1\2\3", b"\1\2")),
    *(marking.Failure("the end", "a", "b"), marking.Failure("AC", "1", "2"), marking.Failure("L", "1", "0")),
)
MARKS = (marking.Mark("sum", 1, 1), marking.Mark("A<B", 0, 2, FAILURES, "l<k\x1b", "A <1"))
ANA, BEN = marking.Result("ana\n", MARKS, 3), marking.Result("=b\x1b", (), 3, "no\tword\ntwo")
FORMULAS = [marking.Result(name, MARKS[:1], 1) for name in ("+c", "-d", "@e")]


def test_marks_for_people_and_machines() -> None:
    shown = io.StringIO()
    for width in (20, 40):
        Console(file=shown, width=width).print(scores.table(GIVEN, [ANA, BEN]))
    details = [line for result in (ANA, BEN) for line in scores.details(result)]
    written = {
        "marks.xml": records.as_junit(GIVEN, [ANA, BEN]),
        "marks.csv": records.as_csv(GIVEN, [ANA, BEN, *FORMULAS]),
        "marks.json": records.as_json(GIVEN, [ANA, BEN]),
        "ana.html": re.sub(r"(?s)<style>.*</style>", "<style></style>", page.html(GIVEN, ANA)),
        "table.txt": shown.getvalue(),
        "details.txt": "\n".join(details) + "\n",
    }
    for name, text in written.items():
        assert text == (CLASS / name).read_text("utf-8"), name
    assert not any("more" in line for line in scores.said(marking.Mark("six", 0, 2, FAILURES[:6])))
    assert list(page.body(GIVEN, BEN)) == ["<h2>It was not tried</h2><pre>no      word\ntwo</pre>"]


def test_what_is_no_file_has_no_points() -> None:
    faults = {"/dev/zero": "not a file", ".": "not a file", "missing.pal": "No such file or directory"}
    faults["a\0b"] = "NUL in the name of a file"
    assert {name: marking.mark(exercise("ac=1"), handed.read(name)).fault for name in faults} == faults


@pytest.mark.parametrize(
    ("arguments", "status", "says"),
    [
        ("add .", 1, ".: a folder; name the answers in it: ./*"),
        ("ana.pal add.toml", 1, "; an exercise in TOML is wanted first, then the answers"),
        ("open.toml --prove", 1, "open: question 'a': answer is missing"),
        ("bad.toml a.pal", 1, "bad.toml: byte 0: not UTF-8"),
        ("add.toml --prove", 1, "add: accepted as right: halts for the wrong reason"),
    ],
)
def test_the_command_says_what_is_wrong(
    arguments: str, status: int, says: str, call: Call, tmp_path: Path
) -> None:
    (tmp_path / "ana.pal").write_text("*200\n\tHLT\n$\n")
    (tmp_path / "bad.toml").write_bytes(b"\xff")
    (tmp_path / "open.toml").write_text(f"{HEAD}solution='a: 1'\n[[question]]\nname='a'\nask='?'\n")
    mistake = "[[case]]\nname='a'\n[mistakes]\n'halts for the wrong reason'=['HLT', 'CLA HLT']\n"
    (tmp_path / "add.toml").write_text(f'{HEAD}solution="*200\\n\\tHLT\\n$"\n{mistake}')
    done, _, said = call(f"pdp8 check {arguments}")
    assert (done, says in said) == (status, True)
