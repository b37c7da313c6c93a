"""Where an answer goes wrong: the instruction, by hand from each mistake; and its state and link."""

import base64
import json
import zlib
from pathlib import Path

import pytest

from pdp8.computer.past import state
from pdp8.lessons import form, handed, link, marking, where
from pdp8.lessons.answer import Answer, assembled
from pdp8.lessons.exercise import Trial
from pdp8.lessons.where import Place
from tests.conftest import Call
from tests.pdp8.lessons import exercise

LOOP = "*200\n\tCLA CLL\n\tTAD A\n{}\n\tHLT\nA,\t301\nB,\t0\n$\n"


def found(case: str, source: str) -> tuple[Answer, Trial, Place]:
    """Return the answer, the trial of one case, and the place where it goes wrong."""
    answer = assembled(handed.of(source.encode(), "a.pal"))
    (whole,) = exercise(case).cases[0].trials
    failed = marking.first_failed(answer, whole)
    assert failed is not None
    return answer, whole, where.find(answer, whole, failed)


PRINT = "\tTLS\n\tTSF\n\tJMP .-1"
FIRST_WRONG = "character {} is sent, the first that is wrong"
UNDER_WAY = "a character is sent while the one before is still under way"


@pytest.mark.parametrize(
    ("case", "code", "address", "says"),
    [
        ("core={B=5}", "\tDCA B", 0o202, "B becomes 0301; 0005 is wanted"),
        ("core={B=5}", "\tDCA B\n\tTAD A\n\tDCA B", 0o204, "B becomes 0301; 0005 is wanted"),
        ("core={B=5}", "", 0o202, "it ends, and nothing has written B"),
        ("core={B=5}", "\tKSF\n\tJMP .-1", 0o202, "it waits, and nothing has written B"),
        ("core={B=5}\ndeposit={A=-92}", "\tISZ B\n\tJMP .-1\n\tISZ A\n\tJMP .-3", 0o206, "it ends, B: 0000"),
        ("ac=5", "\tIAC\n\tNOP", 0o202, "AC becomes 0302; 0005 is wanted"),
        ("link=1", "\tSTL\n\tCLL", 0o203, "L becomes 0; 1 is wanted"),
        ("", "\tJMP 300", 0o300, "it leaves the program, from 0202 to 0300"),
        ("core={A=5}", "\tISZ B\n\tJMP .-1\n\tJMP .-2", 0o202, "it comes to a loop that it does not leave"),
        ("", "\tKSF\n\tJMP .-1", 0o202,
         "it waits, the end: the reader ran out of tape, and the program waits for it at 0202"),
        ("tape='A'", f"\tIAC\n{PRINT}", 0o203, FIRST_WRONG.format(1)),
        ("page='A'", "", 0o202, "it ends, the page: nothing"),
        ("page='AB'", f"{PRINT}\n{PRINT}", 0o205, FIRST_WRONG.format(2)),
        ("tape='AA'", f"\tTLS\n{PRINT}", 0o203, UNDER_WAY),
        ("tape='AA'", PRINT, 0o205, "it ends, the tape: 1 frame"),
        ("instructions=2", "", 0o202, "it ends, instructions: 3"),
        ("core={B=2}\n[[case.again]]\ncore={B=2}", "\tCLA\n\tISZ B\n\tISZ B", 0o204,
         "B becomes 0004; 0002 is wanted"),
    ],
)  # fmt: skip
def test_it_stands_before_the_instruction_that_is_wrong(
    case: str, code: str, address: int, says: str
) -> None:
    answer, whole, place = found(f"seconds=2\n{case}", LOOP.format(code).replace("\n\n", "\n"))
    assert (place.says, f"{place.address:04o}") == (says, f"{address:04o}")
    number = 1 if "again" in case else 0
    machine = where.standing(answer, whole, number)
    assert not machine.processor.run
    machine.run(instructions=place.instructions)
    assert machine.pc == place.address


def test_the_state_and_the_link_lead_there(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    source = form.read("add").solution.replace("DCA SUM", "DCA B")
    Path("ben.pal").write_text(source)
    done, out, said = call("pdp8 check add ben.pal --where")
    assert (done, "wrote ben.state" in said) == (1, True)
    *_, sentence, address = out.splitlines()
    assert sentence == "ben.pal: 5 and 7: at 0203, 3 instructions after START: B becomes 0014; 0007 is wanted"
    machine = state.restore(Path("ben.state").read_text())
    assert (machine.pc, machine.ac, machine.processor.run) == (0o203, 0o14, 0)
    page, _, packed = address.partition("#s=")
    shared = json.loads(zlib.decompress(base64.urlsafe_b64decode(f"{packed}==="), -15))
    assert (page, shared["program"], shared["until"]) == (link.PAGE, {"name": "ben.pal", "text": source}, 3)
    machine = state.restore(json.dumps(shared["machine"]))
    machine.run(instructions=shared["until"])
    assert (machine.pc, machine.ac, len(address) < 8000) == (0o203, 0o14, True)


def test_of_a_hidden_case_no_place_is_shown(
    call: Call, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("e.toml").write_text("title='t'\ntask='t'\n[[case]]\nname='c'\nhidden=true\nac=1\n")
    Path("a.pal").write_text("*200\n\tHLT\n$\n")
    done, out, _ = call("pdp8 check e.toml a.pal --where")
    assert (done, "START" in out, Path("a.state").exists()) == (1, False, False)
