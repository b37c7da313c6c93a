"""What words mean, by literal octal from the PDP-8/I instruction card and the Users Handbook."""

import pytest

from pal import isa


@pytest.mark.parametrize(
    ("word", "location", "address"),
    [
        (0o1000, 0o7777, 0o0000),
        (0o1177, 0o7777, 0o0177),  # page zero, wherever it is fetched from
        (0o1377, 0o0000, 0o0177),
        (0o1377, 0o0377, 0o0377),  # the page of the instruction, not that of the next
        (0o5200, 0o7777, 0o7600),
        (0o5777, 0o0200, 0o0377),
    ],
)
def test_refers_to(word: int, location: int, address: int) -> None:
    assert f"{isa.refers_to(word, location):04o}" == f"{address:04o}"


def test_autoindexed() -> None:
    assert [pointer for pointer in range(0o10000) if isa.autoindexed(pointer)] == [
        *(0o10, 0o11, 0o12, 0o13, 0o14, 0o15, 0o16, 0o17)
    ]


def test_jumps_to() -> None:
    assert isa.jumps_to(0o0200, 0o5200, 0o0201)
    assert not isa.jumps_to(0o0200, 0o5200, 0o0400)
    assert not isa.jumps_to(0o0200, 0o5600, 0o0201)  # JMP I
    assert not isa.jumps_to(0o0200, 0o4200, 0o0201)  # JMS
    assert isa.jumps_to(0o0007, 0o5007, 0o7400)


def test_tests_flag() -> None:
    assert [word for word in range(0o6000, 0o6060) if isa.tests_flag(word)] == [
        *(0o6001, 0o6011, 0o6021, 0o6031, 0o6041, 0o6051)
    ]
    assert not any(isa.tests_flag(word) for word in (*range(0o6000), *range(0o7000, 0o10000)))


def test_halts() -> None:
    assert all(isa.halts(word) for word in (0o7402, 0o7602, 0o7406, 0o7772))
    assert not any(isa.halts(word) for word in (0o7400, 0o7002, 0o7403, 0o7777, 0o3402))


def test_names_stand_where_the_codes_are() -> None:
    names = ["AND", "TAD", "ISZ", "DCA", "JMS", "JMP", "IOT", "OPR"]
    assert [(isa.OPERATIONS[code], getattr(isa, name)) for code, name in enumerate(names)] == [
        (name, code) for code, name in enumerate(names)
    ]
    assert [isa.STATES[state] for state in (isa.FETCH, isa.DEFER, isa.EXECUTE)] == [
        "FETCH",
        "DEFER",
        "EXECUTE",
    ]
    group_1 = (isa.CLA, isa.CLL, isa.CMA, isa.CML, isa.RAR, isa.RAL, isa.TWICE, isa.IAC)
    assert group_1 == (0o200, 0o100, 0o40, 0o20, 0o10, 0o4, 0o2, 0o1)
    group_2 = (isa.GROUP_2, isa.SMA, isa.SZA, isa.SNL, isa.REVERSED, isa.OSR, isa.HLT, isa.GROUP_3)
    assert group_2 == (0o400, 0o100, 0o40, 0o20, 0o10, 0o4, 0o2, 0o401)
