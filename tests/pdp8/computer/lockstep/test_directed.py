"""Situations written by hand, each for one thing that random ones seldom meet."""

import random

import pytest

from tests.pdp8.computer.bench import core, octal
from tests.pdp8.computer.lockstep.play import listing, play
from tests.pdp8.computer.lockstep.sides import FORMS
from tests.pdp8.computer.lockstep.situations import (
    EIGHTH,
    LOAD_ADD,
    SINGLE_CYCLE,
    START,
    STOP,
    Act,
    Situation,
    call,
    load_tape,
    put,
)
from tests.reference.compiling import compiler

pytestmark = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")
STARTED = (put("sr", 0o200), LOAD_ADD, START)
TYPED = call("teletype.keyboard.press", b"AA")


def runs(*pieces: tuple[int | None, int]) -> tuple[Act, ...]:
    return tuple(Act("run", piece) for piece in pieces)


def same(words: dict[int, int], *acts: Act, name: str = "", fast: bool = False) -> None:
    situation = Situation(fast, words, acts)
    difference = play(situation, FORMS).difference
    assert not difference, f"{name}: {difference}\n{listing(situation)}"


# A loop through 0210, where a NOP stands at first; what 0202 makes of it is an AND.
EXECUTED = "7240 5210 {} {} {} 5210 210/ 7000 2025 5202 5210 24/ 210 7776"
PROGRAMS = {
    "JMS 210 over a word that was executed": EXECUTED.format("4210", "0", "0"),
    "JMS I 24 over it": EXECUTED.format("4424", "0", "0"),
    "ISZ 210, JMP .-1": EXECUTED.format("2210", "5202", "7000"),
    "KSF and JMP to the same place of another page": "5375 375/ 7000 7000 6031 5377 577/ 7402",
    "KSF and JMP to the same place of page zero": "5375 375/ 7000 7000 6031 5177 177/ 7402",
    "ISZ I writes at 7600": "7201 2421 5200 21/ 7600 200 10/ 7577 7601/ 5422",
    "DCA I writes at 7600": "7201 3421 5200 21/ 7600 200 10/ 7577 7601/ 5422",
    "JMS I writes at 7600": "7201 4421 5200 21/ 7600 200 10/ 7577 7601/ 5422",
    "DCA I 10 writes at 7600": "7201 3410 5200 21/ 7600 200 10/ 7577 7601/ 5422",
    "a ring of KSF and HLT": "6031 7402 5200",
    "an interrupt that is due when the wait begins": "6046 6041 5201 6032 6001 6031 5205 1/ 7402",
    "JMS I to the end of a page: IAC follows on the next": "4420 20/ 377 400/ 7001 5577 577/ 5200",
    "JMS to the end of page zero": "4177 7001 7402",
    "TAD at the end of a page": "5377 377/ 1020 20/ 5 400/ 7001 5200",
    "DCA I 10 over words that were executed": "5205 7200 1030 3410 5205 7040 5201 5201 7402 10/ 204 30/ 7001",
    "DCA into the word that ISZ counts": "2030 7201 3030 2030 1030 2030 5200",
    "DCA I into the word that ISZ counts": "2030 7201 3431 2030 1030 2030 5200 31/ 30",
    "ISZ that counts itself": "2200 5200",
    "ISZ that counts its JMP": "2201 5200",
    "ISZ that counts itself, after its JMP": "5202 2201 5201",
    "ISZ that counts its JMP, after it": "5202 2202 5201",
    "a delay loop whose JMP is changed": "2030 5200 7200 1031 3201 5200 30/ 7770 7000",
    "a delay loop at the end of core": "7776/ 2030 5376 7001 7402 200/ 5020 20/ 5421 7776",
    "every instruction through 0017": "1417 417 2417 3417 1417 5517 4417 17/ 177 117/ 206",
    "JMS I and JMP I through an autoindex": "4410 10/ 277 301/ 5411 11/ 177",
    "AND I through an autoindex": "7240 412 5200 7070 707 12/ 202",
}
PIECES = (
    (None, 1),
    (None, 2),
    (None, 3),
    (None, 50),
    (2000, 10**5),
    (None, 1000),
    (97, 10**5),
    (None, 20_000),
)

WAITS = {
    "KSF, JMP .-1": "6031 5200",
    "JMP .": "5200",
    "KSF, JMP I .-1": "6031 5600",
    "ISZ, JMP I .-1": "2220 5600",
    "KSF, NOP, JMP": "6031 7000 5200",
    "NOP, JMP .-1": "7000 5200",
    "TLS, JMP .-1": "6046 5200",
    "TPC, JMP .-1": "6044 5200",
    "KSF, SKP, JMP, TSF, JMP, TCF, JMP, KRB, TLS, JMP": "6031 7410 5207 6041 5200 6042 5200 6036 6046 5200",
    "KSF, JMP .-1, KRB, TLS, TSF, JMP .-1, JMP": "6031 5200 6036 6046 6041 5204 5200",
    "KSF, JMP and NOPs that only look like a wait: JMP 0": "7000 7000 6031 5002",
    "KSF, JMP I .": "7000 7000 6031 5603",
    "JMP I .": "7000 7000 5602",
    "CLA, JMP .-1": "7200 5200",
    "a subroutine": "4210 7440 6046 5200 0 0 0 0 0 6031 7410 6036 5610",
    "a subroutine that only returns": "4210 5200 0 0 0 0 0 0 0 5610",
    "a count in core": "7200 1020 7001 3020 6031 5200",
    "ISZ while it waits": "7200 6031 7410 7402 2020 7000 5201",
    "ISZ I while it waits": "7200 6031 7410 7402 2421 7000 5201",
    "DCA while it waits": "7200 6031 7410 7402 7201 1020 3020 7000 5201",
    "DCA I while it waits": "7200 6031 7410 7402 7201 1020 3421 7000 5201",
    "TAD I, autoindexed, while it waits": "7200 6031 7410 7402 1410 7200 7000 5201",
    "DCA I, autoindexed, while it waits": "7200 6031 7410 7402 3410 7000 5201",
}
"""Loops that wait for the keyboard, and some that seem to."""


def test_programs_written_for_one_thing() -> None:
    for name, words in PROGRAMS.items():
        for mem_prot in (False, True):
            for first in (1, 1000):
                acts = (put("panel.mem_prot", mem_prot), put("pc", 0o200), *runs((None, first), *PIECES))
                same(core(words), *acts, STOP, *acts, name=name)


def test_no_limit_is_passed_by_a_wait() -> None:
    """Pieces limited in instructions, in ticks, and a key that comes between two."""
    counts = [(None, count) for count in (*range(1, 12), 99, 1000, 9_999, 10_000)]
    ticks = [(ticks, 100_000) for ticks in (*range(20_000, 20_120, 7), 117, 234, 96, 32, 2_000_000)]
    for name, words in WAITS.items():
        acts = (load_tape(False, b"ab"), *STARTED, *runs(*counts, *ticks), TYPED, *runs((None, 3), *ticks))
        given = core(f"{words} 10/ 1000 21/ 20 2/ 7402")
        same(given, *acts, Act("save_and_restore"), *runs(*counts), name=name)


def test_events_at_every_distance_from_the_turn_of_a_wait() -> None:
    """After words that do nothing a wait begins: 85 ticks an IOT, 32 a turn of JMP ., 117 of KSF, JMP .-1."""
    acts = (load_tape(False, b"a"), *STARTED, *runs((None, 10**6)))
    for before in range(32):
        same(core(f"{'6000 ' * before} 6001 {0o5201 + before:o} 1/ 7402"), *acts)
    for before in range(0, 117, 4):
        words = "6000 " * (before // 2) + "7000 " * (before // 2)
        same(core(f"{words} 6031 {0o5200 + before:o} 7402"), *acts)


def test_hands_between_the_turns_of_a_loop() -> None:
    """A key, a jump, a switch up and down, START, after every number of instructions: that is no turn."""
    ring, by_switch = "6031 7000 7000 7000 5200", "6031 7604 7640 7410 5200 7000 5200"
    for words, hands in (
        (ring, (Act("wait", (20_000,)),)),
        (ring, (put("pc", 0o200),)),
        ("7000 6041 7402 7000 5200", (STOP, START)),
        ("7000 7000 6046 7000 6031 5204 7402", (STOP, Act("wait", (3_000_000,)))),
        ("6031 7410 7402 7000 5200", (TYPED,)),
        (by_switch, (put("sr", 1), *runs((None, 2)), put("sr", 0))),
    ):
        for before in range(30, 60):
            same(core(words), TYPED, *STARTED, *runs((None, before)), *hands, *runs((None, 2000)))


def test_an_interrupt_that_is_due_in_a_program_that_computes() -> None:
    for wait in ("6031 5205", "5205", "7000 5205"):  # TLS, TSF, JMP .-1, KCC, ION, and a loop
        words = core(f"6046 6041 5201 6032 6001 {wait} 1/ 7402")
        same(words, load_tape(False, b"abc"), *STARTED, *runs((20_000_000, 10**6)))
    for more in (0, 1, 2, 7):  # TLS, ION, IAC, ISZ 30, NOP, JMP .-2; the service routine counts and returns
        words = core(f"6046 6001 {'7001 ' * more} 2030 7000 {0o5202 + more:o} 0/ 0 2031 6042 6046 6001 5400")
        pieces = [(ticks, 100_000) for ticks in (1_630_000, 9_000, 17, 31, 32, 33, 3_900_000)]
        same(words, put("pc", 0o200), *runs(*pieces))


@pytest.mark.parametrize(
    "observed",
    [False, pytest.param(True, marks=[pytest.mark.slow, pytest.mark.rare("100,000 words, 1 min")])],
)
@pytest.mark.parametrize("first", [0o6000, 0o7000])
def test_every_iot_and_every_opr(first: int, observed: bool) -> None:
    """TAD I 10 twice, the word, IAC, DCA I 11, RAL, DCA I 12: AC, link and whether it skipped go to core.

    After a HLT the next run goes on.
    """
    draw = random.Random(first)
    for start in range(first, first + 0o1000, 0o100):
        tried = " ".join(f"1410 1410 {start + at:o} 7001 3411 7004 3412" for at in range(0o100))
        words = core(f"{tried} 1100/ 5600 1/ 6001 5400 10/ 5777 6777 7177")
        often = (0, 1, 0o3777, 0o4000, 0o7777, 0o7777)
        words |= {0o6000 + at: draw.choice((*often, draw.randrange(0o10000))) for at in range(0o600)}
        acts = [load_tape(False, b"abc"), load_tape(True, b"abc"), *STARTED]
        for sr in (0, 0o7777, 0o5252):
            acts += [put("sr", sr), put("pc", 0o200), *runs(*[(None, 97)] * 24)]
        watched = Act("watch", (frozenset(), observed))
        same(words, watched, *acts, name=f"{start:04o}", fast=start % 0o200 == 0)


def test_marks_and_protected_words() -> None:
    """Each word that writes, reads or skips where it can meet a breakpoint, a watched word, MEM PROT."""
    skips = octal("7410 7440 2022 7610")
    for word in (*octal("3021 2021 4021 1021 21 1421 1410 3410 4210 3420"), *skips):
        for start in (0o200, 0o7775, 0o7776, 0o7777) if word in skips else (0o200,):
            before = start - 1
            words = core(
                f"{before:o}/ 7000 {word:o} 7001 7001 7001 5200 10/ 300 20/ 7700 30 7777 210/ 0 7001 5200"
            )
            begin = (put("pc", before), put("ac", 0), *runs((None, 6)))
            acts: list[Act] = []
            for mark in (0o10, 0o21, 0o210, 0o7700, *(start + on & 0o7777 for on in range(1, 4))):
                marks = frozenset({mark})
                acts += [Act("breakpoints", (marks,)), *begin]
                for writes in (frozenset({0o17}), marks):
                    acts += [Act("watch", (writes, False)), *begin, *runs((None, 3))]
                acts += [Act("breakpoints", (frozenset(),)), *begin, Act("watch", (frozenset(), False))]
            for watched in (frozenset[int](), frozenset({0o7700})):
                acts += [put("panel.mem_prot", True), Act("watch", (watched, False))]
                for after in (call("panel.exam"), call("panel.dep"), LOAD_ADD, SINGLE_CYCLE):
                    acts += [*begin, after, *runs((None, 1))]
            same(words, *acts, name=f"{word:04o} at {start:04o}")


def test_hands_within_an_instruction() -> None:
    """TAD I 20 in 3 cycles, after ION, with a flag up: STOP and its kin in any of them, then single steps."""
    words = core("6046 6041 5201 6001 1420 7001 5204 20/ 30 30/ 1111 1/ 7402 300/ 7402")
    for hand in (put("pc", 0o300), STOP, call("panel.dep"), put("panel.mem_prot", True), START):
        for before in (27_974, 27_975, 27_976):
            for cycles in range(5):
                within = [SINGLE_CYCLE] * cycles
                acts = (*runs((None, before)), *within, hand, *runs(*[(None, 1)] * 4))
                same(words, *STARTED, *acts)


def test_the_iots_of_the_pc8l_while_it_works() -> None:
    """Twenty of them by chance, a delay of 20 ms, the same again; now and then START."""
    draw = random.Random(1971)
    for _ in range(6):
        tried = " ".join(f"{draw.choice((0o6010, 0o6020)) + draw.randrange(8):o} 7001" for _ in range(20))
        acts = [load_tape(True, draw.randbytes(9)), *STARTED]
        for _ in range(10):
            acts += [
                *runs((draw.randrange(500_000), 20_000)),
                *draw.choice(((), (), (STOP, LOAD_ADD, START))),
            ]
        same(core(f"{tried} 2100 5250 5200"), *acts, fast=True)


def test_false_characters_of_the_teletype() -> None:
    """INITIALIZE in a character makes the receiver begin a false one: a key's units meet its shifts within a
    tick, then KRS; or KCC comes before its first shift.
    """
    iots, done = core("6034 6032"), [Act("wait", (int(EIGHTH),))] * 200
    for unit in range(4):
        for aside in range(-1, 3):
            pressed = int((15 - unit) * 8 * EIGHTH) + aside
            waits = (1_200_000, pressed - 1_200_000, int(120 * EIGHTH) + 10 - pressed)
            first, second, third = (Act("wait", (ticks,)) for ticks in waits)
            keys = [call("teletype.keyboard.press", frame) for frame in (b"\0", b"\x55")]
            acts = (keys[0], first, STOP, START, second, keys[1], third, put("pc", 0o200), *runs((None, 1)))
            same(iots, *STARTED, *acts, *done)
    for eighth in range(17, 25):
        before = Act("wait", (int(eighth * EIGHTH) - 10,)), STOP, START, Act("wait", (int(EIGHTH) + 10,))
        key = call("teletype.keyboard.press", b"\x55")
        same(iots, *STARTED, key, *before, put("pc", 0o201), *runs((None, 1)), *done)


def test_back_to_a_run_that_began_among_breaks() -> None:
    words = core("24/ 402 0 1572 371 34/ 5427 371/ 6714 0 4600")  # a break each 11 ticks
    acts = (Act("record"), *runs((19038, 100_000), (31836, 1), (390, 3)), Act("back", (2,)))
    difference = play(Situation(False, words, acts, 0o20000), FORMS).difference
    assert not difference, difference
