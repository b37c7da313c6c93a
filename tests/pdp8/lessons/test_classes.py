"""A class: random and hidden cases, hints by what happened, numbers with units, bounds, and its results."""

import csv
import json
import pickle
import signal
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from pdp8.lessons import alike, bounded, form, handed, marking, page, records, scores, student, values
from pdp8.lessons.answer import Answer, parted
from pdp8.lessons.diagnosis import HINTS, JUMP, sequence, word
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.form import parse
from pdp8.lessons.marking import Result
from pdp8.lessons.tables import ExerciseError
from tests.conftest import Call
from tests.pdp8.lessons import DOUBLE, HEAD, PUNCH, exercise, mark

DOCS = Path(__file__).parents[3] / "docs" / "lessons.md"
RANDOM = HEAD + DOUBLE + "[[random]]\nname='r'\ntrials=5\ndeposit={A={from=1,to=0o3777}}\ncompare=['B']\n"


def test_a_seed_draws_the_same_and_another_seed_others() -> None:
    text = RANDOM.replace("trials=5", "")
    one, same, other = (parse(text, "e", seed).cases[0].trials for seed in (1, 1, 2))
    assert len(one) == 20
    assert one == same != other
    assert all(trial.core["B"] == 2 * int(trial.deposit["A"]) for trial in one)


def test_inputs_are_drawn_by_ranges_and_kinds() -> None:
    text = RANDOM.replace("trials=5", "trials=40").replace(
        "deposit={", 'sr={pick=[3,5]}\n'
        'reader=[0o200,{length=[2,4],pick="01"},{length=0,from=0,to=0},"A"]\nkeys={length=2,from=1,to=3}\n'
        'deposit={"0300-0302"={from=7,to=7},"0310"={pick=[5]},"0311"={from=-1,to=-1},',
    )  # fmt: skip
    trials = parse(text, "e").cases[0].trials
    assert {trial.sr for trial in trials} == {3, 5}
    assert {trial.reader[0] for trial in trials} == {0o200}
    assert {len(trial.reader) for trial in trials} == {4, 5, 6}
    assert {frame for trial in trials for frame in trial.reader[1:-1]} == {0o260, 0o261}
    assert {trial.reader[-1] for trial in trials} == {0o301}
    assert {frame for trial in trials for frame in trial.keys} == {1, 2, 3}
    for trial in trials:
        drawn = {place: word for place, word in trial.deposit.items() if place[0] == "0"}
        assert drawn == {"0300": 7, "0301": 7, "0302": 7, "0310": 5, "0311": 0o7777}


def test_a_quarter_of_the_words_lies_at_an_edge() -> None:
    text = RANDOM.replace("trials=5", "trials=200").replace("to=0o3777", "to=0o7777")
    words = [int(trial.deposit["A"]) for trial in parse(text, "e").cases[0].trials]
    edges = [word for word in words if word in (1, 0o3777, 0o4000, 0o4001, 0o7777)]
    assert (40 < len(edges) < 60, len(set(edges))) == (True, 5)
    text = text.replace("from=1,to=0o7777", "from=-3,to=0o77")
    words = [int(trial.deposit["A"]) for trial in parse(text, "e").cases[0].trials]
    assert {0o7775, 0o7777, 0, 1, 0o77} < set(words) <= {*range(0o7775, 0o10000), *range(0o100)}
    assert words.count(0o77) > 5


def test_a_trial_is_started_again_with_other_inputs() -> None:
    made = parse(RANDOM.replace("trials=5", "trials=5\nagain=true"), "e")
    for trial in made.cases[0].trials:
        (again,) = trial.again
        assert again.core["B"] == 2 * int(again.deposit["A"]) != trial.core["B"]
    once = made.solution.replace("DCA B\n", "DCA B\n\tDCA 200\n")
    assert mark(made, made.solution).right
    (found,) = mark(made, once).marks
    assert found.inputs == f"start 2, A = {made.cases[0].trials[0].again[0].deposit['A']:04o}"


def test_all_that_is_compared_is_what_the_solution_left() -> None:
    text = RANDOM.replace("'B'", "'AC', 'L', '0203', 'instructions'").replace(
        "trials=5", "trials=1\nwithin=0.5"
    )
    (trial,) = parse(text, "e").cases[0].trials
    assert (trial.ac, trial.link, trial.core, trial.instructions) == (0, 0, {"0203": 0o7402}, 2)
    solution = f'solution="""{PUNCH.format("301")}"""'
    text = f'{HEAD}{solution}\n[[random]]\nname="r"\ntrials=1\ncompare=["tape", "page"]'
    (trial,) = parse(text, "e").cases[0].trials
    assert (trial.tape, trial.page, trial.ac, trial.link, trial.core) == (b"\301", "A", None, None, {})


def test_a_python_function_is_the_oracle(tmp_path: Path) -> None:
    (tmp_path / "own.py").write_text(
        "def triple(random, case):\n    return {**case, 'core': {'B': 3 * case['deposit']['A']}}\n"
    )
    (tmp_path / "own.pal").write_text(form.parse(RANDOM, "e").solution)
    text = RANDOM.replace("compare=['B']", "python='own.py:triple'").replace("to=0o3777", "to=100")
    text = text.replace(DOUBLE, "solution={file='own.pal'}\n")
    made = parse(text, "e", folder=str(tmp_path))
    with pytest.raises(ExerciseError, match="e: random 1: drawn trial 1: core: a number from -2048 to 4095"):
        parse(text.replace("to=100", "to=0o3777"), "e", folder=str(tmp_path))
    with pytest.raises(ExerciseError, match=r"own\.py has no function 'double'"):
        parse(text.replace(":triple", ":double"), "e", folder=str(tmp_path))
    assert not mark(made, made.solution).right
    assert all(trial.core["B"] == 3 * int(trial.deposit["A"]) for trial in made.cases[0].trials)


def test_nothing_of_a_hidden_case_is_written() -> None:
    given = exercise("hidden=true\ndeposit={A=0o6543}\ncore={A=0o3456}\ntape=[0o123]\nsr=0o4567")
    result = mark(given, "*200\n\tTAD A\n\tDCA 300\n\tTAD 300\n\tTLS\n\tHLT\nA,\t0\n$\n")
    said = [
        *scores.details(result), records.as_json(given, [result]), records.as_csv(given, [result]),
        records.as_junit(given, [result]), page.html(given, result), student.form(given),
    ]  # fmt: skip
    assert [(found.points, found.hidden, bool(found.failures)) for found in result.marks] == [(0, True, True)]
    assert not any(word in each for word in ("6543", "3456", "123", "103", "4567") for each in said)


DIFFERENCES: dict[str, list[tuple[Any, Any]]] = {
    "nothing came": [("1234", "")], "too short": [("1234", "123")], "too long": [("1234", "12345")],
    "the first is wrong": [("1234", "2234"), (b"A", b"\322")],
    "one lost or doubled": [("1234", "124"), ("1234", "12234")],
    "wrong": [("1234", "1244"), ("1234", "123X"), ("1234", "12X4"), (b"AB", b"AC"), (5, 3)],
    "parity": [(b"AB", b"A\302"), (b"AB", b"AR")],
    "one off": [(2, 1), (1, 2), (0, 0o7777)],
    "the negative": [(5, 0o7773)],
}  # fmt: skip


@pytest.mark.parametrize("found", DIFFERENCES)
def test_in_which_way_a_tape_a_page_or_a_word_differs(found: str) -> None:
    for one, two in DIFFERENCES[found]:
        differs = word(one, two) if isinstance(one, int) else sequence(one, two)
        assert differs == found, (one, two)


def test_a_hint_is_said_where_it_fits() -> None:
    one = exercise("ac=1\nhint='look at AC'")
    halt, idle = (mark(one, f"*200\n\t{word}\n$").marks[0] for word in ("HLT", "JMP ."))
    assert halt.hint == "look at AC"
    assert ("look at AC" in idle.hint, idle.hidden) == (False, False)
    each = exercise("ac=1\nhint={'jumps to itself'='no JMP .', AC='look'}")
    hints = [mark(each, f"*200\n\t{word}\n$").marks[0].hint for word in ("JMP .", "HLT")]
    assert hints == ["no JMP .", "look"]
    over = exercise("ac=1\nhint={'wrote over itself'='B is no data'}")
    assert mark(over, "*200\n\tDCA B\nB,\tIAC\n\tJMP .\n$").marks[0].hint == "B is no data"
    each = exercise("ac=1\nhint={AC='look'}")
    assert mark(each, "*200\n\tJMP .\n$").marks[0].hint == HINTS[JUMP], "the end is wrong"
    again = exercise("starts=2\ncore={A=5}\nhint='again'")
    hints = [mark(again, f"*200\n\tISZ A\n\tHLT\nA,\t{first}\n$").marks[0].hint for first in (4, 1)]
    assert hints == ["again", ""], "the first START was right, and was not"


SHEET = "title='t'\ntask='t'\n[[question]]\nname='a'\nask='How many, in octal, of block 4? Not 5'\n"


@pytest.mark.parametrize(
    ("answer", "right", "wrong"),
    [
        ("43.2\nunit='us'", "43.2 43.20 43,2 43.2us 43.2_us 43.2_µs 0.0432_ms",
         "4.32e1 43.3 -43.2 43.2_ms 43.2_in us"),
        ("43.2\nunit='us'\ntolerance=0.1", "43.3 43.1", "43.4"),
        ("1798.2\nunit='in'", "1,798.2 1798,2 149.85_ft 1798.2_in. 1798.2_inches 1798,200", ""),
        ("17982", "17,982 17982", "17.982 17982_frames"),
        ("1234567", "1_234_567 1,234,567", "1234_567 12_34_567"),
        ("2789", "2_789 2,789 of_2_789 1_+_2_=_2789", "2_7_89 27_89 2789_="),
        ("43.2\nunit='us'", "43.2_usec 27_cycles_=_43.2_us", "43.2_us_=_27_cycles"),
        ("0.001\nunit='in'", "1/1000 a_thousandth one_thousandth_of_an_inch 1_mil", "1/100 a_thousand"),
        ("3", "three N3 no._3 3rd number_three 3_many", "thirty N13 13th three_words"),
        ("'-35'", "-35(8)", "-35(9)"),
        ("5", "+5 5. 5", "5- +-5 -5 ٥"),
        ("-5", "-5 −5", "5 +5"),
        ("1\nunit='h'", "1_hour 1_hours 60_min 60_minute 60_minutes 3600_sec", "3.6e3_s 61_min"),
        ("2\nunit='ms'", "2000_us 2000_μs 2000_microsec 2000_microsecond 2000_microseconds", ""),
        ("270\nunit='s'", "4_min_30_s 4min_30s 4_min,_30_s 4_min_and_30_s ~270 (270) 4_min(30_s) `270` 270!",
         "4_min_31_s 4_min_30 4_min_30_in"),
        ("2\nunit='ms'", "2_millisecond 2_milliseconds 0.002_second 0.002_seconds", "2_mil"),
        ("12\nunit='in'", "1_ft 1_foot 1_feet 1_' 12_\" 12_inch 12000_mil 12000_mils", "12_s"),
        ("12\nunit='in'", "12000_thou 304.8_mm 30.48_cm 0.3048_m", "1_mm"),
        ("2", "2 2nd 2_many", "2_words 22nd"),
        ("'no'", "no No.", "yes"),
        ("'many'", "many 'many' (many) many? `many`", "how"),
        ("'0'", "0 00 000.", "1"),
        ("'1,000 words'", "1000_words 1000_(words) the_1000_words 1_000_words", "0100_words words_1000"),
        ("100", "block_100 100th 0o100 100_octal the_100", "block_99 row_100 not_100 block_4 100_decimal"),
        ("'-35'", "-035 –35 minus_35 Negative_35 -0o35 -35_octal 4_is_-35 4:_-35",
         "35 --35 -36_octal 4_35 -3_5 not_-35"),
        ("'270'", "0270 0o270 #270 octal_270 +270 2_7_0 block_270", "0o271 27_0 octal 184_octal 270_decimal"),
        ("'2468'", "2_4_6_8 2,4,6,8 2;_4;_6;_8 [2,_4,_6,_8] 2,_4,_6_and_8", "24_68 2_6_8 268 4_8 2_4_6_8_10"),
        ("'1000, 357'", "1000_357", "1000357 1_000_357"),
        ("'negative'", "negative Negative_block", "positive minus"),
        ("'10, 4, 20'", "10_4_20 010,4,20", "10_20 1_04_20 10420"),
        ("'35'\nunit='octal'", "35 035 35_octal 0o35", "29 -35 29_decimal 35_decimal"),
        ("['the same','same']", "same the_same!", "not_the_same"),
        ("'same'", "about_the_same it_is_a_same its_same are_an_same", "not_same"),
    ],
)  # fmt: skip
def test_numbers_are_right_by_value_and_unit_and_texts_by_what_matters(
    answer: str, right: str, wrong: str
) -> None:
    (question,) = parse(f"{SHEET}answer={answer}\n", "e").questions
    given = [each.replace("_", " ") for each in f"{right} {wrong}".split()]
    assert [each for each in given if values.right(question, each)] == given[: len(right.split())]


def test_a_wrong_unit_is_told() -> None:
    (question,) = parse(f"{SHEET}answer=43.2\nunit='us'\nslips={{ '27' = 'cycles' }}\n", "e").questions
    assert question.points == 1
    given = "43.2 ms", "43.2?", "(43.2) ms", "27.0", "27", "28"
    hints = [values.hint(question, each) for each in given]
    assert hints == [*[values.WRONG_UNIT] * 3, "cycles", "cycles", ""]


def test_the_decimal_form_of_an_octal_answer_is_named() -> None:
    (question,) = parse(f"{SHEET}answer='-35'\nunit='octal'\nhint='no'\n", "e").questions
    assert [values.hint(question, given) for given in ("-29", "minus 29", "29", "-034")] == [
        values.DECIMAL, values.DECIMAL, "no", "no"]  # fmt: skip


FORK = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no fork")


@FORK
def test_an_answer_that_takes_too_long_is_ended_and_the_next_is_marked() -> None:
    loop = handed.of(b"*200\nL,\tTLS\n\tJMP L\n$\n", "loop.pal")
    good = handed.of(b"*200\n\tCLA CLL IAC\n\tHLT\n$\n", "good.pal")
    before = signal.signal(signal.SIGPROF, signal.SIG_IGN)
    results = bounded.marked(exercise("seconds=3600\nac=1"), [good, loop, good], 0.3)
    signal.signal(signal.SIGPROF, before)
    assert [result.right for result in results] == [True, False, True]
    assert results[1].fault == "it took more than 0.3 s of processor time, and was ended"
    assert f"{bounded.SECONDS} s of processor time is all it gets" in DOCS.read_text()


@FORK
def test_an_answer_that_takes_too_much_memory_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    def hungry(exercise: Exercise, answer: Answer, dialect: str) -> Result:
        bytearray(int(answer.name) << 20)
        return Result(answer.name, (), 0)

    monkeypatch.setattr(marking, "mark", hungry)
    results = bounded.marked(exercise(""), [Answer("300"), Answer("5000")])
    assert [result.fault for result in results] == ["", "it took more than 512 MiB of memory, and was ended"]


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="this system bounds no address space")
def test_memory_is_bounded_within_the_bounds_that_there_are(monkeypatch: pytest.MonkeyPatch) -> None:
    import resource

    none = resource.RLIM_INFINITY  # -1, or since Python 3.15 the largest number
    bounds: list[tuple[int, int]] = []
    monkeypatch.setattr(resource, "setrlimit", lambda _, pair: bounds.append(pair))
    for there in ((1 << 20, 1 << 21), (1 << 20, none), (none, 1 << 20), (none, none)):
        monkeypatch.setattr(resource, "getrlimit", lambda _, there=there: there)
        bounded._bound_memory()
    assert bounds[:3] == [(1 << 20, 1 << 21), (1 << 20, none), (1 << 20, 1 << 20)]
    words = Path("/proc/self/status").read_text().split()
    more = bounds[3][0] - 1024 * int(words[words.index("VmSize:") + 1])
    assert (round(more / (1 << 20)), bounds[3][1]) == (512, none)
    assert "512 MiB of memory" in bounded._fault(-9, 1), "killed by the system"


@FORK
def test_an_answers_marks_have_at_most_a_mebibyte(monkeypatch: pytest.MonkeyPatch) -> None:
    spare = (1 << 21) - len(pickle.dumps(Result("a", (), 0, "x" * (1 << 20))))
    made = [Result("a", (), 0, "x" * size) for size in (spare, spare + 1)]
    monkeypatch.setattr(marking, "mark", lambda exercise, answer, dialect: made[int(answer.name)])
    results = bounded.marked(exercise(""), [Answer("0"), Answer("1")])
    too_many = "its tapes and pages have more than 1,048,576 bytes"
    assert [result.fault for result in results] == [made[0].fault, too_many]


def test_an_error_of_ours_is_no_fault_of_an_answer(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def broken(exercise: Exercise, answer: Answer, dialect: str) -> Result:
        raise KeyError(answer.name)

    monkeypatch.setattr(marking, "mark", broken)
    for error in (RuntimeError, KeyError):
        with pytest.raises(error):
            bounded.marked(exercise(""), [Answer("a")])
        monkeypatch.delattr("os.fork", raising=False)
    assert capfd.readouterr().err.endswith("KeyError: 'a'\n")


def test_answers_that_differ_in_names_and_comments_look_alike() -> None:
    source = form.read("decimal").solution
    other = source.replace("TAKE", "AGAIN").replace("REST", "LEFT").replace("HLT", "HLT  / ALL MY OWN WORK")
    answers = [handed.of(text.encode(), name) for name, text in
               (("a", source), ("b", other), ("c", form.read("step-wise").solution))]  # fmt: skip
    assert alike.pairs(answers) == [alike.Pair("a", "b", 1.0)]
    assert parted("LOOP,\tjmp .-1") == ["LOOP", ",", "JMP", ".", "-", "1"]


def numbers(length: int, *others: int, first: int = 0) -> Answer:
    """Return an answer of different numbers, in order, of which those at `others` are not as usual."""
    items = range(first, first + length)
    return Answer(
        f"{length} {others} {first}", source="\n".join(f"{at + 500 * (at in others)}" for at in items)
    )


def a_class(size: int, same: int) -> list[Answer]:
    """Return the answers of so many, of whom `same` have the same."""
    others = [numbers(20, first=1000 * each) for each in range(1, 1 + size - same)]
    return [*[numbers(20, 99 + each) for each in range(same)], *others]


@pytest.mark.parametrize(
    ("answers", "shared"),
    [
        ([numbers(38), numbers(38, 18, 19)], [28 / 40]),  # of 34 runs of five, six have an item that changed
        ([numbers(38), numbers(38, 18, 19), numbers(38, 98)], [1.0, 28 / 40, 28 / 40]),
        ([numbers(38), numbers(38, 18, 19, 20)], []),
        *(([numbers(16), numbers(16, 99)], [1.0]), ([numbers(15), numbers(15, 99)], [])),
        # what more than a third of a class of six have says nothing
        *((a_class(5, 5), [1.0] * 10), (a_class(6, 2), [1.0]), (a_class(6, 3), [])),
        *((a_class(9, 3), [1.0] * 3), (a_class(9, 4), [])),
    ],
)
def test_how_alike_answers_are_is_by_the_runs_they_share(answers: list[Answer], shared: list[float]) -> None:
    assert [pair.shared for pair in alike.pairs(answers)] == shared


def test_copies_of_a_long_answer_are_named_however_many_they_are() -> None:
    others = [numbers(40, first=1000 * each) for each in range(1, 21)]
    for length, named in ((29, 10), (28, 0)):
        copies = [numbers(length, 99 + each) for each in range(11)]
        found = alike.pairs([*others, *copies])
        assert found == [alike.Pair(copies[0].name, copy.name, 1.0) for copy in copies[1:]][:named]


@pytest.mark.parametrize("name", form.bundled())
def test_a_students_form_marks_without_the_solution(name: str) -> None:
    whole = form.read(name, student.SEED)
    read = parse(json.dumps(student.whole(whole)), name)
    assert (read, read.asked) == (replace(whole, task=whole.asked, solution="", mistakes={}), whole.asked)
    text = student.form(whole)
    given = parse(text, name)
    assert given.solution == ""
    assert not any(case.hidden or len(case.trials) > 3 for case in given.cases)
    assert all(question.answer == () and question.number is None for question in given.questions)
    result = mark(given, whole.solution)
    assert not any(found.failures for found in result.marks)
    assert (result.right, result.of > 0) == (bool(given.cases), bool(given.cases)), "no sheet is marked right"
    assert given.others == sum(case.hidden for case in whole.cases)


def test_a_students_form_has_what_is_not_as_usual() -> None:
    given = exercise("hint='\u00fc'\nac=1\n[[case]]\nname='h'\nhidden=true")
    assert student.form(given) == json.dumps(
        {"title": "t", "task": "t", "case": [{"name": "c", "hint": [["", "\u00fc"]], "trial": [{"ac": 1}]}],
         "others": 1}, indent=1, ensure_ascii=False,
    ) + "\n"  # fmt: skip
    again = parse(student.form(given), "e")
    assert again.note == "1 of 2 cases were tried; the teacher tries the others too."
    assert student.form(again) == student.form(given)


def test_a_students_form_of_a_sheet_says_what_is_given() -> None:
    sheet = parse(f"{SHEET}answer=5\n[[question]]\nname='b'\nask='?'\nanswer=6\n", "e")
    given = parse(student.form(sheet), "e")
    result = mark(given, "a: 5")
    columns = scores.table(given, [result]).columns
    assert [str(cell) for column in columns for cell in column.cells] == ["a.pal", "given", "-", "-"]
    assert records.as_junit(given, [result]).count("<skipped ") == 1
    written = page.html(given, result)
    assert all(said in written for said in ("not marked", "<td>given</td>", f"<p>{given.note}</p>"))


def test_gradescope_gets_each_case_and_no_figure_of_a_hidden_one() -> None:
    text = f"{HEAD}{DOUBLE}[[case]]\nname='c'\ndeposit={{A=2}}\ncore={{B=4}}\n"
    given = parse(
        f"{text}[[case]]\nname='h'\nhidden=true\npoints=3\ndeposit={{A=0o1234}}\ncore={{B=0o2470}}\n", "e"
    )
    read = json.loads(records.as_gradescope(given, mark(given, given.solution.replace("CLL RAL", "IAC"))))
    assert read["score"] == sum(test["score"] for test in read["tests"]) == 0
    assert [(test["name"], test["max_score"], test["status"]) for test in read["tests"]] == [
        ("c", 1, "failed"), ("h", 3, "failed"),
    ]  # fmt: skip
    assert "expected 0004" in read["tests"][0]["output"]
    assert read["tests"][1]["output"] == "B            wrong"
    right = json.loads(records.as_gradescope(given, mark(given, given.solution)))
    assert (right["score"], {test["output"] for test in right["tests"]}) == (4, {""})
    assert json.loads(records.as_gradescope(given, mark(given, b"")))["output"] == "an empty file"


def test_answers_of_one_name_have_a_page_each(call: Call, tmp_path: Path) -> None:
    for folder in "abc":
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "same.pal").write_text(f"*200\n\tJMP Q{folder}\n$\n")
    call("pdp8 check add a/same.pal b/same.pal c/same.pal --pages pages")
    pages = {path.name: path.read_text() for path in (tmp_path / "pages").iterdir()}
    names = ["same.html", "same-2.html", "same-3.html"]
    assert [f"JMP Q{folder}" in pages[name] for folder, name in zip("abc", names, strict=True)] == [True] * 3
    assert len(pages) == 3


def test_each_name_has_cases_of_its_own(call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The seed that is listed marks an answer as it was marked in the class."""
    monkeypatch.chdir(tmp_path)
    Path("e.toml").write_text(RANDOM)
    Path("cy").mkdir()
    names = ["ana,b.pal", "ben.pal", "cy/ben.pal"]
    for name in names:
        Path(name).write_text(parse(RANDOM, "e").solution.replace("RAL", "RAR"))
    assert call(f"pdp8 check e.toml {' '.join(names)} --variants seeds.csv --json all.json")[0] == 1
    head, *rows = csv.reader(Path("seeds.csv").read_text().splitlines())
    seeds = dict(rows)
    assert (head, [*seeds], len({*seeds.values()})) == (["answer", "seed"], names, 3)
    marked = json.loads(Path("all.json").read_text())["answers"]
    assert len({each["marks"][0]["inputs"] for each in marked}) == 3
    call(f"pdp8 check e.toml ben.pal --seed {seeds['ben.pal']} --json ben.json")
    assert json.loads(Path("ben.json").read_text())["answers"] == marked[1:2]
