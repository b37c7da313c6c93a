"""Marks: what each expectation notices, what a hostile answer can do, and how marks are written."""

import io
import json
import re
import sys
from html import escape
from pathlib import Path
from xml.etree import ElementTree

import pytest
from rich.console import Console

import pal
from pdp8.lessons import handed, marking, page, records, scores
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.form import parse
from pdp8.lessons.marking import Result
from tests.conftest import Shell


def exercise(case: str, program: str = "") -> Exercise:
    head = f"title='t'\ntask='t'\nsolution='x'\n{program}\n[[case]]\nname='the case'\n"
    return parse(head + case, "e")


def mark(case: str, source: str, program: str = "") -> Result:
    return marking.mark(exercise(case, program), handed.of(source.encode(), "a.pal"))


def failed(case: str, source: str) -> list[tuple[str, str | bytes]]:
    return [(failure.what, failure.got) for failure in mark(case, source).marks[0].failures]


IAC = "*200\n\tCLA CLL IAC\n\tDCA A\n\tTAD A\n\tHLT\nA,\t0\n$\n"
PUNCH = "*200\n\tTAD A\n\tTLS\n\tTSF\n\tJMP .-1\n\tHLT\nA,\t301\n$\n"
LOOP = "*200\n\tJMP .\n$\n"


@pytest.mark.parametrize(
    ("case", "source", "wrong"),
    [
        ("ac=1", IAC, []),
        ("ac=2", IAC, [("AC", "0001")]),
        ("start=0o202\nac=0\ninstructions=2\nstop='any'", IAC, []),
        ("link=1", IAC, [("L", "0")]),
        ("core={A=3}", IAC, [("A", "0001")]),
        ('core={"0204"=3}', IAC, [("0204", "0001")]),
        ('core={"0"=3}', "*0\n\t3\n*200\n\tHLT\n$\n", []),
        ('changed=["0", "1"]', "*0\n\t0\n*200\n\tISZ 0\n\tHLT\n$\n", [("0001", "5200, as before")]),
        ('changed=["A", "0200"]', IAC, [("0200", "7301, as before")]),
        ("stop='tape out'", IAC, [("the end", "a halt at 0203")]),
        ("instructions=4", IAC, []),
        ("instructions=3", IAC, [("instructions", "4")]),
        ("tape=[0o301]\npage='A'", PUNCH, []),
        ("tape='B'", PUNCH, [("the tape", b"\xc1")]),
        ("page='AB'", PUNCH, [("the page", "A")]),
        ("tape=''", PUNCH, [("the tape", b"\xc1")]),
        ("stop='idle'", LOOP, []),
        ("takes=[9.6e-6, 9.6e-6]", IAC, []),
        ("takes=[9.7e-6, 1]", IAC, [("the time", "9.6e-06 s")]),
        ("takes=[0, 9.5e-6]", IAC, [("the time", "9.6e-06 s")]),
        ("ac=0o5200", "*200\n\tCLA CLL\n\tTAD 300\n\tHLT\n$\n", []),
        ("starts=2\ninstructions=4", IAC, []),
        ("starts=2\ntape=[0o301]\npage='A'", PUNCH, []),
        ("seconds=0.1\nstop='limit'", "*200\n\tISZ 300\n\tJMP 200\n\tJMP 200\n$\n", []),
    ],
)  # fmt: skip
def test_an_expectation_notices_what_differs(
    case: str, source: str, wrong: list[tuple[str, str | bytes]]
) -> None:
    assert failed(case, source) == wrong


def test_the_inputs_of_the_trial_that_failed_are_told() -> None:
    keys, deposit = f'keys="{"A" * 24}"', 'deposit={"300"=7,"301"="A"}'
    second = f"ac=2\nsr=0o17\nreader={[0o200, 1] + [2] * 23}\n{keys}\n{deposit}"
    (found,) = mark(f"[[case.trial]]\nac=1\n[[case.trial]]\n{second}", IAC).marks
    assert found.inputs == (
        f"0300 = 0007, 0301 = A, switches 0017, tape 200 001 {'002 ' * 22}..., keys {' '.join(['301'] * 24)}"
    )


TAPE = pal.assemble(IAC).tape
NO_SOURCE = "this exercise looks at the source: hand in PAL, not a tape"


@pytest.mark.parametrize(
    ("rule", "answer", "fault"),
    [
        ("words=4", IAC, "5 words of core; at most 4 are allowed"),
        ("words=5", IAC, ""),
        ("words=5", TAPE, ""),
        ("required=['ISZ']", IAC.replace("HLT", "HLT /ISZ"), "ISZ is to be used, and is not"),
        ("required=['IAC']", IAC, ""),
        ("required=['A']", TAPE, NO_SOURCE),
        ("forbidden=['IAC']", IAC, "IAC is not to be used"),
        ("forbidden=['A']", TAPE, NO_SOURCE),
        ("", IAC.replace("A,", "B,").replace(" A", " B"), "the tag A is missing; the exercise looks for it"),
        ("", "/nothing\n$\n", "no word for core in it"),
        ("", "*200\nFIELD 1\n*200\n1\n$\n", "address 10200: a PDP-8/L with 4K of core ends at 07777"),
    ],
)
def test_an_answer_that_breaks_a_rule_has_no_points(rule: str, answer: str | bytes, fault: str) -> None:
    content = answer.encode() if isinstance(answer, str) else answer
    case = "ac=1" if rule else "core={A=1}"
    result = marking.mark(exercise(case, f"[program]\n{rule}"), handed.of(content, "a"))
    assert (result.fault, result.points, result.right) == (fault, int(not fault), not fault)


@pytest.mark.parametrize(("count", "more"), [(5, []), (6, ["and 1 more"]), (15, ["and 10 more"])])
def test_five_errors_of_a_source_are_told(count: int, more: list[str]) -> None:
    wrong = "".join(f"\tJMP Q{at}\n" for at in range(count))
    assert mark("ac=1", f"*200\n{wrong}$\n").fault.splitlines()[20:] == more


def test_a_line_of_a_sheet_is_marked_by_its_name() -> None:
    sheet = parse("title='t'\ntask='t'\n[[question]]\nname='A'\nask='?'\nanswer='1234 or 7'\n", "e")
    assert marking.mark(sheet, handed.of(b"a) 01,234 OR  007", "a.txt")).right
    for given, got in (("a: 8", "8"), ("b: 7", "nothing")):
        (found,) = marking.mark(sheet, handed.of(given.encode(), "a.txt")).marks
        assert [failure.got for failure in found.failures] == [got]


@pytest.mark.parametrize(
    ("content", "fault"),
    [
        ((b"/" * 199 + b"\n") * 81 + b"/" * 184, ""),
        ((b"/" * 199 + b"\n") * 81 + b"/" * 185, "more than 16,384 bytes"),
        (b"/" * 200, ""),
        (b"", "an empty file"),
        (b"\xef\xbb\xbf*200\r\n", ""),
        ("*200".encode("utf-16"), "text in UTF-16: save it as UTF-8 or ASCII, or write it with an editor"),
        (
            b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 4,
            "neither text, such as PAL source, nor a BIN or RIM tape",
        ),
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


GIVEN = parse(
    "title='t'\ntask=' do '\nsolution='x'\n[[case]]\nname='sum'\n[[case]]\nname='A<B'\npoints=2\n", "e"
)
FAILURES = (
    *(marking.Failure("SUM", "0001", "0000"), marking.Failure("the time", "", "", "10 s")),
    *(marking.Failure("instructions", "", "7"), marking.Failure("the tape", b"\1\2\3", b"\1\2")),
    *(marking.Failure("the end", "a", "b"), marking.Failure("AC", "1", "2"), marking.Failure("L", "1", "0")),
)
MARKS = (marking.Mark("sum", 1, 1), marking.Mark("A<B", 0, 2, FAILURES, "l<k\x1b", "A <1"))
CLASS = [
    marking.Result("ana\n", MARKS, 3),
    marking.Result("=b\x1b", (), 3, "no\tword"),
    *(marking.Result(name, MARKS[:1], 1) for name in ("+c", "-d", "@e")),
]
SAID = """\
SUM          expected 0001
                  got 0000
                      ---^
the time     10 s
instructions got 7
the tape: 2 frames, 3 expected; the first difference is frame 2
   frame    expected               got
       0    |     .  o| 001      |     .  o| 001
       1    |     . o | 002      |     . o | 002
       2    |     . oo| 003      no frame           <--
the end      expected a
                  got b
AC           expected 1
                  got 2
                      ^
and 1 more"""
WRONG = "SUM, the time, instructions, the tape, the end, AC, L"
XML = f"""\
<?xml version="1.0" encoding="utf-8"?>
<testsuites name="e">
  <testsuite name="ana&#10;" tests="2" failures="1">
    <testcase name="sum" classname="e" />
    <testcase name="A&lt;B" classname="e">
      <failure message="not as expected: {WRONG}">{escape(SAID)}
hint: l&lt;k\u241b</failure>
    </testcase>
  </testsuite>
  <testsuite name="=b\u241b" tests="2" failures="2">
    <testcase name="sum" classname="e">
      <failure message="not as expected: fault">no      word</failure>
    </testcase>
    <testcase name="A&lt;B" classname="e">
      <failure message="not as expected: fault">no      word</failure>
    </testcase>
  </testsuite>
</testsuites>
"""
CSV = """\
answer,sum,A<B,points,of,fault
ana\u240a,1,0,1,3,
'=b\u241b,0,0,0,3,no\u2409word
'+c,1,1,1,
'-d,1,1,1,
'@e,1,1,1,
"""
TABLE = """\
answer  \u2026  \u2026  points
ana\u240a    1  -   1 / 3
=b\u241b     -  -   0 / 3
answer  sum  A<B  points
ana\u240a     1    -    1 / 3
=b\u241b      -    -    0 / 3
"""
HTML = f"""\
<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>t: ana\u240a</title>
<meta name="viewport" content="width=device-width"><style></style></head><body>
<h1>t</h1>
<p><strong>ana\u240a: 1 of 3 points</strong></p>
<p>do</p>
<table><tr><th>tried</th><th>points</th><th></th></tr>
<tr><td>sum</td><td>1 of 1</td><td>right</td></tr>
<tr><td>A&lt;B</td><td>0 of 2</td><td>not yet</td></tr>
</table>
<h2>A&lt;B</h2>
<p>Tried with A &lt;1.</p>
<pre>{escape(SAID)}</pre>
<p class="hint">l&lt;k\x1b</p>
</body></html>
"""


def test_marks_for_people_and_machines() -> None:
    assert records.as_junit(GIVEN, CLASS[:2]) == XML
    assert records.as_csv(GIVEN, CLASS) == CSV
    shown = io.StringIO()
    for width in (20, 40):
        Console(file=shown, width=width).print(scores.table(GIVEN, CLASS[:2]))
    assert shown.getvalue() == TABLE
    assert re.sub(r"(?s)<style>.*</style>", "<style></style>", page.html(GIVEN, CLASS[0])) == HTML
    assert list(page.body(CLASS[1])) == ["<h2>It was not tried</h2><pre>no      word</pre>"]
    lines = [line for result in CLASS[:2] for line in scores.details(result)]
    assert lines == [
        *("ana\n: A<B, with A <1", *(f"  {line}" for line in SAID.splitlines()), "  hint: l<k\x1b"),
        *("=b\x1b: no points", "  no      word"),
    ]
    failures = [
        {"what": each.what, "happened": each.happened, "expected": each.expected, "got": each.got}
        for each in FAILURES
    ]
    failures[3] |= {"expected": "001 002 003", "got": "001 002"}
    right = {"name": "sum", "points": 1, "of": 1, "hidden": False, "inputs": None, "hint": None}
    wrong = right | {"name": "A<B", "points": 0, "of": 2, "inputs": "A <1", "hint": "l<k\x1b"}
    marks = [right | {"failures": []}, wrong | {"failures": failures}]
    ana = {"answer": "ana\n", "right": False, "points": 1, "of": 3, "fault": None, "marks": marks}
    ben = {"answer": "=b\x1b", "right": False, "points": 0, "of": 3, "fault": "no\tword", "marks": []}
    record = {"exercise": "e", "title": "t", "answers": [ana, ben]}
    assert records.as_json(GIVEN, CLASS[:2]) == json.dumps(record, indent=2) + "\n"


@pytest.mark.parametrize(
    ("name", "fault"),
    [
        *(("/dev/zero", "not a file"), (".", "not a file")),
        *(("missing.pal", "No such file or directory"), ("a\0b", "NUL in the name of a file")),
    ],
)
def test_what_is_no_file_has_no_points(name: str, fault: str) -> None:
    assert marking.mark(exercise("ac=1"), handed.read(name)).fault == fault


@pytest.mark.parametrize(
    ("arguments", "status", "says"),
    [
        ("", 2, "Give an EXERCISE"),
        ("add", 2, "Give an ANSWER"),
        ("nothing a.pal", 1, "nothing: no such file, and no bundled exercise (add, "),
        ("add .", 1, ".: a folder; name the answers in it: ./*"),
        ("ana.pal loose.toml", 1, "; an exercise in TOML is wanted first, then the answers"),
        ("bad.toml a.pal", 1, "bad.toml: byte 0: not UTF-8"),
        ("loose.toml --prove", 1, "loose: taken for right: halts for the wrong reason"),
    ],
)
def test_the_command_says_what_is_wrong(
    arguments: str, status: int, says: str, shell: Shell, tmp_path: Path
) -> None:
    (tmp_path / "ana.pal").write_text("*200\n\tHLT\n$\n")
    (tmp_path / "bad.toml").write_bytes(b"\xff")
    (tmp_path / "loose.toml").write_text(
        "title='t'\ntask='t'\nsolution='*200\\n\\tHLT\\n$'\n[[case]]\nname='a'\n[mistakes]\n"
        "'halts for the wrong reason'=['HLT', 'CLA HLT']\n".replace("'*200", '"*200').replace("$'", '$"')
    )
    done = shell(f"pdp8 check {arguments}")
    assert done.returncode == status
    assert says in done.stderr.decode()
