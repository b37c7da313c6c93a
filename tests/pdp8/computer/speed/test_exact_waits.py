"""A wait that is passed over ends in the very tick, with the very instruction, of one that is executed.

The oracle is the processor alone, one instruction after the other: nothing is passed over there.
"""

from collections.abc import Callable, Mapping

import pytest

from pdp8.computer.machine import Machine
from tests.pdp8.computer.bench import octal

ION, HLT, JMP_SELF = 0o6001, 0o7402, 0o5000


def pair(words: Mapping[int, int], tape: bytes = b"") -> tuple[Machine, Machine]:
    """Return the same machine twice, started at 0200."""
    machines = []
    for _ in range(2):
        machine = Machine()
        machine.load(words)
        machine.teletype.reader.load(tape)
        machine.start(0o200)
        machines.append(machine)
    return machines[0], machines[1]


def alone(machine: Machine, going_on: Callable[[], bool]) -> None:
    """Run the processor by itself until it stops, or as long as it is to go on."""
    while machine.processor.run and going_on():
        machine.processor.instruction()
    machine.bus.advance(machine.processor.clock)


def seen(machine: Machine) -> dict[str, object]:
    p = machine.processor
    registers = {
        name: getattr(p, name) for name in ("pc", "lac", "ma", "mb", "next", "clock", "instructions")
    }
    return registers | {"core": list(machine.core), "flags": [device.flag for device in machine.bus]}


@pytest.mark.parametrize("before", range(32))
def test_an_interrupt_a_whole_number_of_turns_away(before: int) -> None:
    """IOTs that do nothing, ION, JMP .: 85 ticks each, so that one `before` in 32 has the flag rise as a turn
    of 32 ticks ends.
    """
    words = dict.fromkeys(range(0o200, 0o200 + before), 0o6000)
    end = 0o200 + before
    words |= {end: ION, end + 1: JMP_SELF | 0o200 | end + 1 & 0o177, 1: HLT}
    fast, plain = pair(words, b"a")
    assert fast.run(seconds=1).reason == "halt"
    alone(plain, lambda: True)
    assert seen(fast) == seen(plain)


@pytest.mark.parametrize("before", range(0, 117, 4))
def test_a_flag_a_whole_number_of_turns_away(before: int) -> None:
    """KSF, JMP .-1 after so many ticks that its turns of 117 end at every distance from the flag."""
    words = dict.fromkeys(range(0o200, 0o200 + before), 0o7000)
    words |= dict.fromkeys(range(0o200, 0o200 + before // 2), 0o6000)
    end = 0o200 + before
    words |= {end: 0o6031, end + 1: 0o5200 | end & 0o177, end + 2: HLT}
    fast, plain = pair(words, b"a")
    assert fast.run(seconds=1).reason == "halt"
    alone(plain, lambda: True)
    assert seen(fast) == seen(plain)


RINGS = {
    "KSF, JMP .-1": "6031 5200",
    "JMP .": "5200",
    "KSF, NOP, JMP": "6031 7000 5200",
    "NOP, JMP .-1": "7000 5200",
}


@pytest.mark.parametrize("ring", RINGS)
def test_no_limit_of_instructions_is_passed(ring: str) -> None:
    fast, plain = pair(dict(enumerate(octal(RINGS[ring]), 0o200)), b"a")
    for count in (*range(1, 12), 99, 1000, 9_999, 10_000):
        fast.run(instructions=count)
        target = plain.instructions + count
        alone(plain, lambda target=target: plain.instructions < target)  # type: ignore[misc]
        assert seen(fast) == seen(plain)


@pytest.mark.parametrize("ring", RINGS)
def test_no_limit_of_time_is_passed(ring: str) -> None:
    fast, plain = pair(dict(enumerate(octal(RINGS[ring]), 0o200)), b"a")
    for ticks in (*range(20_000, 20_120, 7), 117, 234, 96, 32):
        target = fast.processor.clock + ticks
        fast.run(seconds=ticks / 20_000_000)
        alone(plain, lambda target=target: plain.processor.clock < target)  # type: ignore[misc]
        assert seen(fast) == seen(plain)


@pytest.mark.parametrize(
    "words",
    [
        {
            0o375: 0o7000,
            0o376: 0o7000,
            0o377: 0o6031,
            0o400: 0o5377,
            0o577: HLT,
        },  # JMP 0577: the same place of another page
        {0o375: 0o7000, 0o376: 0o7000, 0o377: 0o6031, 0o400: 0o5177, 0o177: HLT},  # JMP 0177: of page zero
        {0o200: 0o7000, 0o201: 0o7000, 0o202: 0o6031, 0o203: 0o5602, 0o6031: HLT},  # JMP I 0202
        {0o200: 0o7000, 0o201: 0o7000, 0o202: 0o5602, 0o5602: HLT},  # JMP I .
    ],
)
def test_what_only_looks_like_a_wait(words: dict[int, int]) -> None:
    """NOPs, a flag test and a jump that is not to it: no time is passed over."""
    fast, plain = pair(words, b"a")
    for machine in (fast, plain):
        machine.pc = min(address for address in words if address >= 0o200)
    assert fast.run(seconds=1).reason == "halt"
    alone(plain, lambda: True)
    assert seen(fast) == seen(plain)


def test_a_loop_that_counts_in_core_is_executed() -> None:
    """CLA, TAD 20, IAC, DCA 20, KSF, JMP 200: the same AC and PC each time, and another word in core."""
    fast, plain = pair(dict(enumerate(octal("7200 1020 7001 3020 6031 5200"), 0o200)), b"a")
    for _ in range(20):
        fast.run(seconds=0.005)
        alone(plain, lambda: plain.processor.clock < fast.processor.clock)
        assert seen(fast) == seen(plain)
    assert fast.core[0o20] > 0o1000


@pytest.mark.parametrize("after", range(200, 230))
def test_a_key_pressed_between_two_runs_is_not_waited_past(after: int) -> None:
    """KSF, SKP, HLT, NOP, JMP 200: nothing can end it, until a key is pressed."""
    fast, plain = pair(dict(enumerate(octal("6031 7410 7402 7000 5200"), 0o200)))
    fast.run(instructions=after)
    alone(plain, lambda: plain.instructions < fast.instructions)
    for machine in (fast, plain):
        machine.teletype.keyboard.press(b"A")
        machine.bus.advance(machine.processor.clock)
    assert fast.run(seconds=1).reason == "halt"
    alone(plain, lambda: True)
    assert seen(fast) == seen(plain)


def test_a_ring_that_writes_the_same_word_again_is_idle() -> None:
    """JMS 210, JMP .-1; at 0210 the return address, JMP I 210."""
    words = dict(enumerate(octal("4210 5200"), 0o200)) | {0o211: 0o5610}
    assert pair(words)[0].run(seconds=10).reason == "idle"


COUNTING = {
    "ISZ": "2020",
    "ISZ I": "2421",
    "DCA": "7201 1020 3020",
    "DCA I": "7201 1020 3421",
    "TAD I, autoindexed": "1410 7200",
    "DCA I, autoindexed": "3410",
}
"""Instructions that leave AC 0 and another core each time, whether they skip or not."""


@pytest.mark.parametrize("counting", COUNTING.values(), ids=COUNTING)
def test_a_ring_that_counts_does_not_only_wait(counting: str) -> None:
    """CLA, then KSF, SKP, HLT, a word that is counted, NOP, JMP 201, until the reader's second character."""
    words = octal(f"7200 6031 7410 7402 {counting} 7000 5201")
    fast, plain = pair(dict(enumerate(words, 0o200)) | {0o10: 0o1000, 0o21: 0o20}, b"ab")
    assert fast.run(seconds=1).reason == "halt"
    alone(plain, lambda: True)
    assert seen(fast) == seen(plain)


def test_a_flag_that_is_up_is_not_waited_for() -> None:
    """NOP, NOP, TLS, NOP, KSF, JMP .-1, HLT with the keyboard's flag up: the printer's is the next event."""
    fast, plain = pair(dict(enumerate(octal("7000 7000 6046 7000 6031 5204 7402"), 0o200)))
    for machine in (fast, plain):
        machine.teletype.receiver.flag = 1
    assert fast.run(seconds=1).reason == "halt"
    alone(plain, lambda: True)
    assert seen(fast)["clock"] == seen(plain)["clock"]
