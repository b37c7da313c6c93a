"""The answers of docs/tutorial.md, worked out again: what stands in bold in an answer is compared."""

import re
from pathlib import Path

import programs.circle
import programs.ellipse
from programs.arithmetic import ARITHMETICS
from tapes import ascii, eia
from tests.programs import test_eia

PAGE = (Path(__file__).parent.parent / "docs" / "tutorial.md").read_text()


def answers(exercise: int) -> list[str]:
    """Return what is bold in the answer to an exercise."""
    section = PAGE.split("\n## ")[exercise]
    assert section.startswith(f"{exercise}. ")
    answer = re.search(r"<summary>Answer</summary>(.*?)</details>", section, re.DOTALL)
    assert answer
    return re.findall(r"\*\*(.+?)\*\*", answer[1])


def translated(text: str, patch: dict[int, int] | None = None) -> bytes:
    return test_eia.translated(ascii.encode(text), patch=patch)


def test_1_read_a_frame() -> None:
    frame = sum(1 << channel - 1 for channel in (8, 6, 5, 4))
    inches = len(ascii.encode(programs.circle.part())) / 10
    assert answers(1) == [f"{frame:o}", ascii.name(frame), f"{inches:.1f}"]


def microseconds_in_chk(character: str) -> float:
    """Count the time from the JMS to CHK until it has returned, on a machine that reads the character."""
    machine = test_eia.started(character.encode("latin-1"))
    while machine.pc != 0o206:
        machine.run(instructions=1)
    before = machine.ticks
    while machine.pc != 0o207:
        machine.run(instructions=1)
    return (machine.ticks - before) * 0.05


def test_2_one_digit_through_chk() -> None:
    assert answers(2) == [f"{microseconds_in_chk(character):.1f}" for character in "39\377"]


def delayed(passes: int, clear: int) -> dict[int, int]:
    """Patch `passes` delays of 19.66 ms in before the KCC, or what stands in its place."""
    delays = [word for at in range(passes) for word in (0o2377, 0o5360 + 2 * at)]
    return {0o201: 0o5360, **dict(enumerate([*delays, clear, 0o5202], 0o360))}


def test_3_kcc_loses_nothing_within_a_character_and_every_other_one_after_it() -> None:
    digits = "123456789\n"
    assert answers(3) == ["100", "as long as it likes"]
    on_leader = "\177" + digits  # START reads the first frame, 77 ms before its flag: no KRB has been then
    assert translated(on_leader, delayed(4, 0o6032)) == translated(digits)  # 79 ms, and 5 for the punch
    assert eia.decode(translated(digits, delayed(6, 0o6032))) == "2468\n"
    assert translated(digits, delayed(6, 0o7000)) == translated(digits)


def test_4_spaces() -> None:
    text = programs.circle.part()
    blanks, same = answers(4)
    assert int(blanks) == text.count(" ")
    assert same == "the same"
    assert len(translated("1 2\n", {0o127: 1})) == len(translated("1 2\n")) - 1


def test_5_truncation() -> None:
    exact, truncated = (
        programs.ellipse.part(arithmetic=ARITHMETICS[how]).splitlines() for how in ("exact", "ge635")
    )
    differ = [
        number for number, pair in enumerate(zip(exact, truncated, strict=True), 1) if len(set(pair)) > 1
    ]
    lines = [(exact[at - 1], truncated[at - 1]) for at in differ]
    most = max(abs(int(one[a:b]) - int(two[a:b])) for one, two in lines for a, b in ((4, 9), (9, 14)))
    ours, theirs = (translated("\n".join(lines) + "\n") for lines in (exact[:600], truncated[:600]))
    frame = next(at for at, pair in enumerate(zip(ours, theirs, strict=True)) if pair[0] != pair[1])
    assert answers(5) == [str(differ[0]), str(len(differ)), f".{most:03}", str(frame)]


def test_6_the_checksum() -> None:
    assert answers(6) == [f"-{-(0o7743 - 0o10000):o}"]
    assert 0o001 - 0o036 == 0o7743 - 0o10000
