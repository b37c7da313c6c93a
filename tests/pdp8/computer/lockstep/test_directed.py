"""Situations written by hand, each for one thing that random ones seldom meet."""

import pytest

from tests.pdp8.computer.lockstep.play import play
from tests.pdp8.computer.lockstep.situations import Act, Situation
from tests.pdp8.computer.speed.forms import FORMS
from tests.reference.compiling import compiler

pytestmark = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")

PROGRAMS = {
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
    "DCA I, ISZ I and JMS I into 7600": {
        **dict(enumerate((0o3420, 0o2420, 0o4420, 0o3421, 0o2421, 0o4421, 0o5200), 0o200)),
        **{0o20: 0o7577, 0o21: 0o7600, 0o7600: 0o5606},
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


@pytest.mark.parametrize("first", [1, 1000])
@pytest.mark.parametrize("mem_prot", [False, True])
@pytest.mark.parametrize("program", PROGRAMS)
@pytest.mark.parametrize("form", FORMS)
def test_machine_and_reference_differ_in_nothing(form: str, program: str, mem_prot: bool, first: int) -> None:
    runs = tuple(Act("run", piece) for piece in ((None, first), *PIECES))
    on = (Act("mem_prot", (mem_prot,)), Act("set", ("pc", 0o200)))
    situation = Situation(False, PROGRAMS[program], (*on, *runs, Act("press", ("stop",)), *on, *runs))
    played = play(situation, form)
    assert not played.difference, played.difference


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("words", [0, 1, 2, 7])
def test_an_interrupt_that_is_due_in_a_program_that_computes(form: str, words: int) -> None:
    """TLS, ION, some words, then ISZ 30, NOP, JMP .-2: the service routine counts, clears and returns."""
    core = {0o200: 0o6046, 0o201: 0o6001, **dict.fromkeys(range(0o202, 0o202 + words), 0o7001)}
    core |= {0o202 + words: 0o2030, 0o203 + words: 0o7000, 0o204 + words: 0o5202 + words}
    core |= dict(enumerate((0, 0o2031, 0o6042, 0o6046, 0o6001, 0o5400)))
    runs = tuple(Act("run", (ticks, 100_000)) for ticks in (1_630_000, 9_000, 17, 31, 32, 33, 3_900_000))
    played = play(Situation(False, core, (Act("set", ("pc", 0o200)), *runs)), form)
    assert not played.difference, played.difference
