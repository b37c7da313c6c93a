"""What words mean, by literal octal from the PDP-8/I instruction card and the Users Handbook."""

from pal import isa

NUMBERS = """
AND 0 TAD 1 ISZ 2 DCA 3 JMS 4 JMP 5 IOT 6 OPR 7  FETCH 0 DEFER 1 EXECUTE 2
NO_STATE 3 WORD_COUNT 4 CURRENT_ADDRESS 5 BREAK 6
CLA 200 CLL 100 CMA 40 CML 20 RAR 10 RAL 4 TWICE 2 IAC 1
GROUP_2 400 GROUP_3 401 SMA 100 SZA 40 SNL 20 REVERSED 10 OSR 4 HLT 2
"""
ADDRESSES = {
    (0o1000, 0o7777): 0o0000,
    (0o1177, 0o7777): 0o0177,  # page zero, wherever it is fetched from
    (0o1377, 0o0000): 0o0177,
    (0o1377, 0o0377): 0o0377,  # the page of the instruction, not that of the next
    (0o5200, 0o7777): 0o7600,
    (0o5777, 0o0200): 0o0377,
}


def test_names_stand_for_the_books_numbers() -> None:
    names, numbers = NUMBERS.split()[::2], NUMBERS.split()[1::2]
    assert [f"{getattr(isa, name):o}" for name in names] == numbers
    assert [*isa.OPERATIONS, *isa.STATES] == [*names[:11], "no state", "WORD COUNT", "CURR ADDR", "BREAK"]


def test_the_address_is_on_page_zero_or_on_the_page_of_the_instruction() -> None:
    assert {(word, at): isa.refers_to(word, at) for word, at in ADDRESSES} == ADDRESSES


def test_0010_to_0017_are_autoindexed() -> None:
    assert [pointer for pointer in range(0o10000) if isa.autoindexed(pointer)] == [*range(0o10, 0o20)]


def test_a_jump_is_direct_and_goes_to_the_address() -> None:
    assert isa.jumps_to(0o0200, 0o5200, 0o0201)
    assert isa.jumps_to(0o0007, 0o5007, 0o7400)
    assert not isa.jumps_to(0o0200, 0o5200, 0o0400)
    assert not isa.jumps_to(0o0200, 0o5600, 0o0201)  # JMP I
    assert not isa.jumps_to(0o0200, 0o4200, 0o0201)  # JMS


def test_a_flag_is_tested_by_iop_1_alone() -> None:
    assert [word for word in range(0o10000) if isa.tests_flag(word)] == [*range(0o6011, 0o7000, 0o10)]


def test_hlt_is_of_group_2() -> None:
    assert all(isa.halts(word) for word in (0o7402, 0o7602, 0o7406, 0o7772))
    assert not any(isa.halts(word) for word in (0o7400, 0o7002, 0o7403, 0o7777, 0o3402))
