"""Situations written by hand, each for one thing that random ones seldom meet."""

import random

import pytest

from tests.pdp8.computer.bench import octal
from tests.pdp8.computer.lockstep.play import listing, play
from tests.pdp8.computer.lockstep.situations import Act, Situation
from tests.pdp8.web.node import needs_node
from tests.reference.compiling import compiler

pytestmark = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")

ALL_FORMS = ("compiled", "plain", pytest.param("javascript", marks=needs_node))
STARTED = (Act("switches", (0o200,)), Act("press", ("load_add",)), Act("press", ("start",)))


def runs(*pieces: tuple[int | None, int]) -> tuple[Act, ...]:
    return tuple(Act("run", piece) for piece in pieces)


def same(situation: Situation, form: str, name: str = "") -> None:
    difference = play(situation, [form]).difference
    assert not difference, f"{name}: {difference}\n{listing(situation)}"


# A loop through 0210, where a NOP stands at first; what 0202 makes of it is an AND.
EXECUTED = {
    **{0o200: 0o7240, 0o201: 0o5210, 0o205: 0o5210},  # CLA CMA, JMP 210, JMP 210
    **{0o210: 0o7000, 0o211: 0o2025, 0o212: 0o5202, 0o213: 0o5210},  # NOP, ISZ 25, JMP 202, JMP 210
    **{0o24: 0o210, 0o25: 0o7776},
}
PROGRAMS = {
    "JMS 210 over a word that was executed": EXECUTED | {0o202: 0o4210},
    "JMS I 24 over it": EXECUTED | {0o202: 0o4424},
    "ISZ 210, JMP .-1": EXECUTED | {0o202: 0o2210, 0o203: 0o5202, 0o204: 0o7000},
    "KSF and JMP to the same place of another page": {
        **{0o200: 0o5375, 0o375: 0o7000, 0o376: 0o7000},
        **{0o377: 0o6031, 0o400: 0o5377, 0o577: 0o7402},
    },
    "KSF and JMP to the same place of page zero": {
        **{0o200: 0o5375, 0o375: 0o7000, 0o376: 0o7000},
        **{0o377: 0o6031, 0o400: 0o5177, 0o177: 0o7402},
    },
    **{
        f"{word:04o} writes at 7600": {
            **{0o200: 0o7201, 0o201: word, 0o202: 0o5200, 0o21: 0o7600, 0o22: 0o200, 0o10: 0o7577},
            **{0o7601: 0o5422},
        }
        for word in (0o3421, 0o2421, 0o4421, 0o3410)
    },
    "a ring of KSF and HLT": {0o200: 0o6031, 0o201: 0o7402, 0o202: 0o5200},
    "an interrupt that is due when the wait begins": {
        **dict(enumerate((0o6046, 0o6041, 0o5201, 0o6032, 0o6001, 0o6031, 0o5205), 0o200)),
        1: 0o7402,
    },
    "JMS I to the end of a page: IAC follows on the next": {
        0o200: 0o4420,
        0o20: 0o377,
        0o400: 0o7001,
        0o401: 0o5577,
        0o577: 0o5200,
    },
    "JMS to the end of page zero": {0o200: 0o4177, 0o201: 0o7001, 0o202: 0o7402},
    "TAD at the end of a page": {0o200: 0o5377, 0o377: 0o1020, 0o20: 5, 0o400: 0o7001, 0o401: 0o5200},
    "DCA I 10 over words that were executed": {
        **{0o200: 0o5205, 0o201: 0o7200, 0o202: 0o1030, 0o203: 0o3410, 0o204: 0o5205},
        **{0o205: 0o7040, 0o206: 0o5201, 0o207: 0o5201, 0o210: 0o7402, 0o10: 0o204, 0o30: 0o7001},
    },
    "DCA into the word that ISZ counts": dict(
        enumerate((0o2030, 0o7201, 0o3030, 0o2030, 0o1030, 0o2030, 0o5200), 0o200)
    ),
    "DCA I into the word that ISZ counts": dict(
        enumerate((0o2030, 0o7201, 0o3431, 0o2030, 0o1030, 0o2030, 0o5200), 0o200)
    )
    | {0o31: 0o30},
    "ISZ that counts itself": {0o200: 0o2200, 0o201: 0o5200},
    "ISZ that counts its JMP": {0o200: 0o2201, 0o201: 0o5200},
    "ISZ that counts itself, after its JMP": {0o200: 0o5202, 0o201: 0o2201, 0o202: 0o5201},
    "ISZ that counts its JMP, after it": {0o200: 0o5202, 0o201: 0o2202, 0o202: 0o5201},
    "a delay loop whose JMP is changed": {
        **{0o200: 0o2030, 0o201: 0o5200, 0o202: 0o7200, 0o203: 0o1031, 0o204: 0o3201, 0o205: 0o5200},
        **{0o30: 0o7770, 0o31: 0o7000},
    },
    "a delay loop at the end of core": {
        0o7776: 0o2030,
        0o7777: 0o5376,
        0: 0o7001,
        1: 0o7402,
        0o200: 0o5020,
        0o20: 0o5421,
        0o21: 0o7776,
    },
    "every instruction through 0017": {
        **dict(enumerate((0o1417, 0o417, 0o2417, 0o3417, 0o1417, 0o5517, 0o4417), 0o200)),
        **{0o17: 0o177, 0o117: 0o206},
    },
    "JMS I and JMP I through an autoindex": {0o200: 0o4410, 0o10: 0o277, 0o301: 0o5411, 0o11: 0o177},
    "AND I through an autoindex": {
        0o200: 0o7240,
        0o201: 0o412,
        0o202: 0o5200,
        0o12: 0o202,
        0o203: 0o7070,
        0o204: 0o707,
    },
}
PIECES = (
    (None, 1),
    (None, 2),
    (None, 3),
    (None, 50),
    (2000, 100_000),
    (None, 1000),
    (97, 100_000),
    (None, 20_000),
)


WAITS = {
    "KSF, JMP .-1": "6031 5200",
    "JMP .": "5200",
    "KSF, JMP I .-1": "6031 5600",
    "ISZ, JMP I .-1": "2220 5600",
    "KSF, NOP, JMP": "6031 7000 5200",
    "NOP, JMP .-1": "7000 5200",
    "KSF, SKP, JMP, TSF, JMP, TCF, JMP, KRB, TLS, JMP": "6031 7410 5207 6041 5200 6042 5200 6036 6046 5200",
    "KSF, JMP .-1, KRB, TLS, TSF, JMP .-1, JMP": "6031 5200 6036 6046 6041 5204 5200",
    "KSF, JMP and NOPs that only look like a wait: JMP 0": "7000 7000 6031 5002",
    "KSF, JMP I .": "7000 7000 6031 5603",
    "JMP I .": "7000 7000 5602",
    "CLA, JMP .-1": "7200 5200",
    "a subroutine": "4210 7440 6046 5200 0 0 0 0 0 6031 7410 6036 5610",
    "a subroutine that only returns": "4210 5200 0 0 0 0 0 0 0 5610",
    "a count in core": "7200 1020 7001 3020 6031 5200",
    **{
        f"{name} while it waits": f"7200 6031 7410 7402 {words} 7000 5201"
        for name, words in {
            "ISZ": "2020",
            "ISZ I": "2421",
            "DCA": "7201 1020 3020",
            "DCA I": "7201 1020 3421",
            "TAD I, autoindexed": "1410 7200",
            "DCA I, autoindexed": "3410",
        }.items()
    },
}
"""Loops that wait for the keyboard, and some that seem to."""


@pytest.mark.parametrize("form", ALL_FORMS)
def test_programs_written_for_one_thing(form: str) -> None:
    for name, words in PROGRAMS.items():
        for mem_prot in (False, True):
            on = (Act("mem_prot", (mem_prot,)), Act("set", ("pc", 0o200)))
            for first in (1, 1000):
                acts = (*on, *runs((None, first), *PIECES))
                same(Situation(False, words, (*acts, Act("press", ("stop",)), *acts)), form, name)


@pytest.mark.parametrize("form", ALL_FORMS)
def test_no_limit_is_passed_by_a_wait(form: str) -> None:
    """Pieces limited in instructions, in ticks, and a key that comes between two."""
    counts = [(None, count) for count in (*range(1, 12), 99, 1000, 9_999, 10_000)]
    ticks = [(ticks, 100_000) for ticks in (*range(20_000, 20_120, 7), 117, 234, 96, 32, 2_000_000)]
    for name, words in WAITS.items():
        core = dict(enumerate(octal(words), 0o200)) | {0o10: 0o1000, 0o21: 0o20, 2: 0o7402}
        acts = (Act("load_tape", (False, b"ab")), *STARTED, *runs(*counts, *ticks))
        acts += (Act("type", (b"A",)), *runs((None, 3), *ticks), Act("save_and_restore"), *runs(*counts))
        same(Situation(False, core, acts), form, name)


@pytest.mark.parametrize("form", ALL_FORMS)
def test_events_at_every_distance_from_the_turn_of_a_wait(form: str) -> None:
    """After words that do nothing a wait begins: 85 ticks an IOT, 32 a turn of JMP ., 117 of KSF, JMP .-1."""
    for before in range(32):
        jump = 0o5200 | 0o201 + before & 0o177
        words = dict.fromkeys(range(0o200, 0o200 + before), 0o6000)
        words |= {0o200 + before: 0o6001, 0o201 + before: jump, 1: 0o7402}
        same(Situation(False, words, (Act("load_tape", (False, b"a")), *STARTED, *runs((None, 10**6)))), form)
    for before in range(0, 117, 4):
        words = dict.fromkeys(range(0o200, 0o200 + before), 0o7000)
        words |= dict.fromkeys(range(0o200, 0o200 + before // 2), 0o6000)
        end = 0o200 + before
        words |= {end: 0o6031, end + 1: (0o5200 | end & 0o177), end + 2: 0o7402}
        same(Situation(False, words, (Act("load_tape", (False, b"a")), *STARTED, *runs((None, 10**6)))), form)


@pytest.mark.parametrize("form", ALL_FORMS)
def test_hands_between_the_turns_of_a_loop(form: str) -> None:
    """A key, a jump, a switch up and down, START, after every number of instructions: that is no turn."""
    ring, by_switch = "6031 7000 7000 7000 5200", "6031 7604 7640 7410 5200 7000 5200"
    for words, hands in (
        (ring, (Act("wait", (20_000,)),)),
        (ring, (Act("set", ("pc", 0o200)),)),
        ("7000 6041 7402 7000 5200", (Act("press", ("stop",)), Act("press", ("start",)))),
        ("7000 7000 6046 7000 6031 5204 7402", (Act("press", ("stop",)), Act("wait", (3_000_000,)))),
        ("6031 7410 7402 7000 5200", (Act("type", (b"A",)),)),
        (by_switch, (Act("switches", (1,)), *runs((None, 2)), Act("switches", (0,)))),
    ):
        for before in range(30, 60):
            acts = (Act("type", (b"AA",)), *STARTED, *runs((None, before)), *hands, *runs((None, 2000)))
            same(Situation(False, dict(enumerate(octal(words), 0o200)), acts), form, words)


@pytest.mark.parametrize("form", ALL_FORMS)
def test_an_interrupt_that_is_due_in_a_program_that_computes(form: str) -> None:
    """TLS, ION, some words, then ISZ 30, NOP, JMP .-2: the service routine counts, clears and returns."""
    tape, program = Act("load_tape", (False, b"abc")), (0o6046, 0o6041, 0o5201, 0o6032, 0o6001)
    for wait in ((0o6031, 0o5205), (0o5205,), (0o7000, 0o5205)):  # TLS, TSF, JMP .-1, KCC, ION, and a loop
        core = {1: 0o7402} | dict(enumerate((*program, *wait), 0o200))
        same(Situation(False, core, (tape, *STARTED, *runs((20_000_000, 10**6)))), form)
    for words in (0, 1, 2, 7):
        core = {0o200: 0o6046, 0o201: 0o6001, **dict.fromkeys(range(0o202, 0o202 + words), 0o7001)}
        core |= {0o202 + words: 0o2030, 0o203 + words: 0o7000, 0o204 + words: 0o5202 + words}
        core |= dict(enumerate((0, 0o2031, 0o6042, 0o6046, 0o6001, 0o5400)))
        pieces = [(ticks, 100_000) for ticks in (1_630_000, 9_000, 17, 31, 32, 33, 3_900_000)]
        same(Situation(False, core, (Act("set", ("pc", 0o200)), *runs(*pieces))), form)


@pytest.mark.parametrize("form", ALL_FORMS)
@pytest.mark.parametrize("first", [0o6000, 0o7000])
def test_every_iot_and_every_opr(first: int, form: str) -> None:
    """TAD I 10, the word, IAC, DCA I 11, RAL, DCA I 12: AC, link and whether it skipped go to core."""
    draw = random.Random(first)
    for start in range(first, first + 0o1000, 0o100):
        words = {1: 0o6001, 2: 0o5400, 0o10: 0o5777, 0o11: 0o6777, 0o12: 0o7177}
        words |= {0o6000 + at: draw.randrange(0o10000) for at in range(0o400)}
        for at in range(0o100):
            tried = (0o1410, start + at, 0o7001, 0o3411, 0o7004, 0o3412)
            words |= dict(enumerate(tried, 0o200 + 6 * at))
        words[0o1100] = 0o5600
        acts: tuple[Act, ...] = (
            Act("load_tape", (False, b"abc")),
            Act("load_tape", (True, b"abc")),
            *STARTED,
        )
        for sr in (0, 0o7777, 0o5252):
            acts += (Act("switches", (sr,)), Act("set", ("pc", 0o200)), *runs(*[(None, 97)] * 6))
        for observed in (False, True):
            watched = (Act("watch", (frozenset(), observed)),)
            same(Situation(start % 0o200 == 0, words, watched + acts), form, f"{start:04o}")
