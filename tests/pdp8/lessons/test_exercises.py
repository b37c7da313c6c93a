"""Every bundled exercise does its work: the solution has all points, and twenty usual mistakes do not."""

import re
import tomllib
from collections import Counter
from operator import attrgetter
from pathlib import Path
from random import Random

import pytest

import pal
from pdp8 import shelf
from pdp8.lessons import form, handed, proof, values
from pdp8.lessons.answer import Answer
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.exercises import delay, loader, short_block, step_wise
from pdp8.lessons.form import parse
from pdp8.lessons.tables import ExerciseError
from tests.conftest import case
from tests.pdp8.lessons import DOUBLE, HEAD, exercise, mark

TUTORIAL = (
    "read-a-frame", "follow-a-digit", "no-character-lost", "spaces-are-zeros", "truncation", "break-a-tape",
)  # fmt: skip
PAGE = Path(__file__).parents[3] / "docs" / "tutorial.md"

LONG = ("larger", "octal", "step-wise", "decimal", "fast-multiply", "table", "message", "subroutine")


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=pytest.mark.slow("marks some hundred answers")) if name in LONG else name
        for name in form.bundled()
    ],
)
def test_an_exercise_tells_its_mistakes_from_its_solution(name: str) -> None:
    given = form.read(name)
    solved = proof.solution(given)
    assert (solved.right, solved.points) == (True, given.points)
    assert list(proof.untold(given)) == []
    assert [how for how, result in proof.restated(given) if not result.right] == []
    marked = list(proof.mistakes(given))
    assert [what for what, result in marked if result.right or result.points >= result.of] == []
    inputs = attrgetter("start", "starts", "deposit", "sr", "reader", "keys")
    shown = [inputs(case.trials[0]) for case in given.cases if not case.hidden and len(case.trials) == 1]
    others = [trial for case in given.cases for trial in case.trials if inputs(trial) not in shown]
    assert bool(others) == bool(given.cases), "a table of the shown cases answers them all"


@pytest.mark.slow
@pytest.mark.rare("a hundred slips of each of 20 solutions, 2 min")
@pytest.mark.parametrize("name", form.bundled())
def test_no_slip_is_taken_for_right_by_luck(name: str) -> None:
    slips = proof.slips(lambda seed: form.read(name, seed), 1)
    assert slips.lucky == []
    assert len(slips.survivors) <= slips.tried // 4


@pytest.mark.slow("marks some hundred answers")
def test_what_another_oracle_says_of_an_answer_is_said_here_too() -> None:
    """answers.toml has edits of solutions, judged by the words of the tasks alone."""
    judged = tomllib.loads((Path(__file__).parent / "answers.toml").read_text())
    for name, edits in judged.items():
        given = form.read(name)
        for what, edit in edits.items():
            source = given.solution
            for piece, instead in zip(edit[1::2], edit[2::2], strict=True):
                assert source.count(piece) == 1, (name, what, piece)
                source = source.replace(piece, instead)
            with case(f"{name}: {what}"):
                assert mark(given, source).right == (edit[0] == "right")


def test_a_folder_hides_no_bundled_exercise(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "add").mkdir()
    assert form.title("add") == form.read("add").title


@pytest.mark.parametrize(("number", "name"), list(enumerate(TUTORIAL, 1)))
def test_a_sheet_says_what_the_tutorial_says(number: int, name: str) -> None:
    section = PAGE.read_text().split("\n## ")[number]
    bold = re.findall(r"\*\*(.+?)\*\*", section.split("<summary>Answer</summary>")[1])
    sheet = form.read(name)
    assert [
        said for said in bold if not any(values.right(question, said) for question in sheet.questions)
    ] == []


def test_what_functions_draw_is_right_by_another_way() -> None:
    draws = [Random(seed) for seed in range(1200)]
    delays = {case["sr"]: case["takes"] for case in (delay.time(draw, {}) for draw in draws)}
    assert sorted(delays) == list(range(1, 41))
    assert all(pair == pytest.approx([sr * 0.0099, sr * 0.0101]) for sr, pair in delays.items())
    leaders, counts, good, sums = set(), set(), set(), Counter[int]()
    for draw in draws:
        case = loader.tape(draw, {"name": "x"})
        rows = bytes(case["reader"]).lstrip(b"\200")
        first, count, *words, total = (
            high << 6 | low for high, low in zip(rows[::2], rows[1::2], strict=True)
        )
        around = {f"{first - 1:04o}": 0o1111, f"{first + count:04o}": 0o1111}
        core = around | {f"{first + at:04o}": word for at, word in enumerate(words)}
        short = (total - sum(words)) % 4096
        assert case == {"name": "x", "reader": case["reader"], "deposit": around, "core": core, "ac": short}
        assert 0o1000 <= first < 0o7000
        leaders.add(len(case["reader"]) - len(rows))
        counts.add((count, len(words)))
        sums[short] += 1
        deposit = dict(
            zip(("RISE", "RUN", "BAND", "LENGTH"), (draw.randint(1, 30) for _ in range(4)), strict=True)
        )
        rise, run, length = deposit["RISE"], deposit["RUN"], deposit["LENGTH"]
        band = deposit["BAND"] = max(deposit.values())
        cuts = [*step_wise.cuts(draw, {"deposit": deposit})["core"].values()]
        ends = [rise * sum(cuts[0:at:2]) - run * sum(cuts[1:at:2]) for at in range(1, len(cuts))]
        assert (cuts.pop(), len(cuts) % 2, sum(cuts[::2])) == (0, 1, length)
        assert all(-band <= end <= band for end in ends)
        assert all(end + rise > band for end in ends[:-1:2])
        assert all(end - run < -band for end in ends[1::2])
        case = short_block.tape(draw, {"name": "x"})
        *blocks, none = bytes(case["reader"]).split(b"\200")
        lengths, at = [len(block) + 1 for block in blocks], case["ac"]
        assert (lengths[: at - 1], lengths[at:], none) == ([20] * (at - 1), [20], b"")
        good.add(lengths[at - 1])
        assert set(b"".join(blocks)) <= set(b"\40\1\2\23\4\25\26\7\10\31")
    assert leaders == set(range(6))
    assert (700 < sums[0] < 900, len(sums) > 100) == (True, True)
    assert counts == {(count, count) for count in range(1, 13)}
    assert good == set(range(1, 101)) - {20}


PROGRAM = 'title="t"\ntask="t"\nsolution="*200\\n\\tHLT\\n$\\n"\n'


def test_a_wrong_file_is_named_with_its_place() -> None:
    """refused.txt has each, with the message. After PROGRAM or DOUBLE, the rest follows on that."""
    for refused in (Path(__file__).parent / "refused.txt").read_text().removeprefix("== ").split("\n== "):
        message, _, text = refused.partition("\n")
        first, _, rest = text.partition("\n")
        name, _, instead = first.partition(" with ")
        head = {"PROGRAM": PROGRAM, "DOUBLE": HEAD + DOUBLE}.get(name)
        with case(message), pytest.raises(ExerciseError) as raised:
            parse(head.replace("HLT", instead or "HLT") + rest if head else text, "e")
        assert str(raised.value).splitlines()[0] == message
    for text in ('{"a":' + "[" * 100_000, "[" + "a." * 33 + "a]"):
        with pytest.raises(ExerciseError, match="e: nested too deeply"):
            parse(text, "e")


@pytest.mark.parametrize(
    ("key", "least", "most"),
    [
        ("ac", -0o4000, 0o7777), ("link", 0, 1), ("points", 0, 1000), ("seconds", 1, 3600), ("starts", 1, 10),
        ("instructions", 1, 1 << 40), ("words", 1, 4096),
    ],
)  # fmt: skip
def test_a_number_lies_within_its_bounds(key: str, least: int, most: int) -> None:
    def given(value: int | str) -> Exercise:
        line = f"{key}={value}"
        return exercise("", f"[program]\n{line}") if key == "words" else exercise(line)

    for value in (least, most):
        given(value)
    for wrong in (least - 1, most + 1, "true"):
        with pytest.raises(ExerciseError, match=rf"{key}: .*(from {least} |up |){most}"):
            given(wrong)


def test_a_tape_is_a_text_or_frames_or_eia_or_a_file() -> None:
    frames = {"[0, 0o377]": b"\0\377", '{ eia = "12\\n" }': b"\1\2\200", '"A\\n"': b"\301\215\212"}
    frames['{ file = "eia.bin" }'] = shelf.read("eia.bin")
    assert {tape: exercise(f"tape={tape}").cases[0].trials[0].tape for tape in frames} == frames


def test_a_solution_may_be_a_file_beside_the_exercise(tmp_path: Path) -> None:
    (tmp_path / "s.pal").write_text("*200\n\tHLT\n$\n")
    text = 'title="t"\ntask="t"\nsolution={file="s.pal"}\n[[case]]\nname="a"\n'
    assert parse(text, "e", folder=str(tmp_path)).solution == "*200\n\tHLT\n$\n"


def test_a_mistake_must_change_one_place_of_the_solution() -> None:
    for pair, times in (('"NOP", "CLA"', "'NOP' stands 0"), ('"HLT", "HLT"', "'HLT' stands 1")):
        given = parse(f'{PROGRAM}[mistakes]\nx=[{pair}]\n[[case]]\nname="a"', "e")
        with pytest.raises(ExerciseError, match=f"e: mistake 'x': {times} times in the solution, not once"):
            list(proof.mistakes(given))


def test_a_sheet_is_read_however_its_lines_are_written() -> None:
    sheet = "\ufeffA: 270\r\n b) the digit 8\nc = 1,798.2\n\n d 5 \ne:6\nf=−7 µs\ng? 8\n"
    sheet += "(h) 9\n- **i**: 1\n> [j]: (2)\nk .5\nA note: b was a guess"
    read = handed.of(sheet.encode(), "s").lines()
    assert list(read) == [*"abcdef", "g?", *"hijk"]
    said = ["270", "the digit 8", "1,798.2", "5", "6", "−7 µs", "8", "9", "1", "(2)", ".5"]
    assert list(read.values()) == said
    numbers = handed.of(b"1: 0270\n2: 0377\n", "s")
    assert numbers.lines() == {f"{at:o}": f"{word:04o}" for at, word in numbers.words.items()} != {}


def test_a_sheet_with_control_characters_is_no_tape_but_a_dump_and_a_spoilt_tape_are() -> None:
    sheet = handed.of(b"a: 5\x1e8\x1e7\nb\x10: 9\nc: .001\nd\x14\x13: 11734\n", "s")
    assert (sheet.fault, list(sheet.lines())[:1]) == ("", ["a"])
    tape = pal.assemble("*200\n\tCLA CLL IAC\n\tHLT\n$\n").tape.strip(b"\200")
    assert handed.of(tape.hex(" ").encode(), "t.txt").words == handed.of(tape, "t.bin").words != {}
    spoilt = handed.of(tape[:-1] + bytes([tape[-1] ^ 1]), "t.bin")
    assert spoilt.fault.startswith("t.bin: frame ")


UNTOLD = """title='t'
task='Starts at 0200, puts 5 into the word at A and halts.'
solution='''*200\n\tCLA CLL\n\tTAD C5\n\tDCA A\n\tDCA 310\n\tTAD A\n\tHLT\nC5,\t5\nA,\t0\nB,\t0\n$\n'''
[[case]]
name='a'
starts=2
ac=5
core={A=5, B=0, "0310"=0}
instructions=9
tests='puts 6 into'
"""


def test_what_a_task_does_not_say_is_listed() -> None:
    told = list(proof.untold(parse(UNTOLD, "e")))
    assert told == [
        "a: tests = 'puts 6 into' is no quotation from the task",
        "a: B is not mentioned", "a: 0310 is not mentioned",
        "a: it is started again, which is not mentioned", "a: ac is checked or used, and not mentioned",
        "a: instructions is checked or used, and not mentioned",
    ]  # fmt: skip
    task = "at A and halts, again and again, within 9 instructions, 5 in the AC, B and 0300 to 0317 0."
    text = UNTOLD.replace("at A and halts.", task).replace("puts 6", "puts 5")
    assert list(proof.untold(parse(text, "e"))) == []


PUT = f"""{HEAD}solution='''*200\n\tCLA OSR\n\tDCA A\n\tHLT\nA,\t0\n$\n'''
[[random]]
name='r'
tests='t'
trials=1
sr={{pick=[0, 1]}}
compare=['A']
"""


def test_a_slip_that_one_seed_does_not_notice_is_found_by_another() -> None:
    """Without OSR the word is 0, which is right where 0 is drawn."""
    drawn = {seed: parse(PUT, "e", seed).cases[0].trials[0].sr for seed in range(9)}
    seed = next(seed for seed in range(8) if drawn[seed] == 0 != drawn[seed + 1])
    found = proof.slips(lambda number: parse(PUT, "e", number), seed)
    assert "line 2: CLA NOP for CLA OSR" in found.lucky
    assert "line 2: NOP OSR for CLA OSR" in found.survivors
    assert found.tried == found.number
    for most in (found.number, found.number - 1):
        again = proof.slips(lambda number: parse(PUT, "e", number), seed, most)
        assert (again.number, again.tried) == (found.number, most)


def test_words_that_are_given_are_looked_at_beside_those_of_the_solution() -> None:
    drawn = parse(PUT + 'core={"0300"=0}\n', "e", 1).cases[0].trials[0]
    assert drawn.core == {"A": drawn.sr, "0300": 0}


def test_an_exercise_that_wants_one_way_of_writing_is_found_out() -> None:
    """The symbols that must be used stay in all ways; a word that must lie at 0206 does not."""
    text = UNTOLD.replace("instructions=9\n", "").replace("starts=2", 'unchanged=["0212"]')
    given = parse(text.replace("\n[[case]]", "\n[program]\nrequired=['HLT', 'CLL']\n[[case]]"), "e")
    ways = {how: result.right for how, result in proof.restated(given)}
    assert ways["in lower case"]
    assert not {"7402 for HLT", "CLL CLA for CLA CLL"} & set(ways)
    refused = parse(text.replace('core={A=5, B=0, "0310"=0}', 'core={"0206"=5}'), "e")
    assert not dict((how, result.right) for how, result in proof.restated(refused))["at another place"]


def test_a_tag_with_an_offset_is_an_address_of_12_bits() -> None:
    answer = Answer("a.pal", symbols={"A": 0, "B": 0o7777})
    places = {"A": 0, "A+2": 2, "A-1": 0o7777, "B": 0o7777, "B+1": 0, "17": 0o17}
    assert {place: answer.address(place) for place in places} == places
