"""Keys pressed as the program asks for them: none is lost to one that does not listen while it prints."""

import pytest

import pal
from pdp8.monitor.arguments import MonitorError
from pdp8.monitor.prompt import Monitor
from tests.pdp8.monitor import do

STORE = """
*10
INTO,	277
*200
READ,	{wait}
	KRB
	DCA I INTO
{then}
	JMP READ
SEED,	0
COUNT,	0
TEN,	-12
HUNDRED,	-144
DOT,	256
$
"""
LISTEN = "KSF; JMP .-1"
INTERRUPTED = "ION; JMP ."
LISTEN_AND_COUNT = "ISZ SEED; NOP; KSF; JMP .-3"
DELAY = """	TAD HUNDRED
	DCA COUNT
	ISZ SEED; JMP .-1
	ISZ COUNT; JMP .-3
	CLA
"""
PRINT = """	TAD TEN
	DCA COUNT
	TAD DOT
	TLS
	TSF; JMP .-1
	ISZ COUNT; JMP .-4
	CLA
"""


def start(monitor: Monitor, wait: str, then: str = "") -> None:
    """Run a program that stores each key from 0300 on."""
    monitor.machine.load(pal.assemble(STORE.format(wait=wait, then=then)).words)
    do(monitor, "deposit 1 5402 202", "go 200 0.1")


def stored(monitor: Monitor) -> list[int]:
    words = monitor.machine.core[0o300:0o400]
    return list(words[: list(words).index(0)])


def frames(text: str) -> list[int]:
    return [0o200 | ord(character) for character in text]


@pytest.mark.parametrize(
    ("wait", "then"),
    [
        (LISTEN, ""),
        (LISTEN, PRINT),
        (LISTEN, DELAY),
        (INTERRUPTED, ""),
        (LISTEN_AND_COUNT, ""),
        (LISTEN_AND_COUNT, PRINT),
    ],
    ids=["at once", "printing", "slow", "interrupted", "counting", "counting and printing"],
)
def test_a_line_arrives_as_it_stands(monitor: Monitor, wait: str, then: str) -> None:
    start(monitor, wait, then)
    do(monitor, 'type  01.04 T "HI  there"! # 5 \\r ', "wait 9")
    assert stored(monitor) == frames(' 01.04 T "HI  THERE"! # 5 \\R \r')


def test_no_key_is_pressed_before_the_program_is_done_with_the_last(monitor: Monitor) -> None:
    start(monitor, LISTEN, PRINT)
    do(monitor, "type A")
    assert monitor.machine.teletype.printer.frames == b"\xae" * 10


def test_keys_pressed_without_waiting_are_lost_where_the_program_prints(monitor: Monitor) -> None:
    start(monitor, LISTEN, PRINT)
    do(monitor, 'keyboard now "ABCDEFGH"', "wait 5")
    assert 0 < len(stored(monitor)) < 8


def test_keys_alone_are_texts_and_codes(monitor: Monitor) -> None:
    start(monitor, LISTEN, PRINT)
    line = r'keyboard a "B c" CR "\n\f\177\e\a\"\\\003\301\034\r\t\377\200" # a comment'
    do(monitor, line, "wait 1")
    codes = "215 212 214 377 375 207 242 334 203 301 234 215 211 377 200"
    assert stored(monitor) == [*frames("AB C"), *(int(code, 8) for code in codes.split())]
    with pytest.raises(MonitorError, match="\uf800: a Model 33"):
        do(monitor, "type \uf800")


def test_return_is_pressed_only_if_it_is_asked_for(monitor: Monitor, said: list[str]) -> None:
    """KSF, JMP .-1, KRB, HLT: after one key the machine is stopped."""
    for loops, waiting in (("7402", b""), ("5200", b"\x8d")):
        do(monitor, f"deposit 200 6031 5200 6036 {loops}", "go 200 0.1", "type A")
        assert any("RETURN was not pressed" in line for line in said) == (not waiting)
        assert monitor.machine.teletype.keyboard.waiting == waiting
        said.clear()


def test_keys_come_after_what_is_on_the_tape(monitor: Monitor) -> None:
    start(monitor, LISTEN)
    monitor.machine.teletype.reader.load(b"\1\2\3")
    do(monitor, "type A", "wait 1")
    assert stored(monitor) == [1, 2, 3, *frames("A\r")]


def test_a_program_that_counts_in_eight_words_asks_at_the_eighth_glance(monitor: Monitor) -> None:
    do(monitor, "deposit 200 7001 5207 0 0 0 0 0 5200", "go 200 0.1", "keyboard A")
    assert monitor.machine.elapsed == pytest.approx(0.1 + 8 * 0.05, abs=1e-5)
