"""Who executes what: the processor no more than it has to, and of what only waits nobody more than needed."""

import pytest

from pdp8.computer.machine import Machine
from pdp8.computer.speed.piece import DELAY
from tests.conftest import case
from tests.pdp8.computer.bench import machine

OPERATE = [word for word in range(0o7000, 0o10000) if word & 0o403 != 0o402]
BOTH_ROTATES = {word for word in OPERATE if word & 0o414 == 0o014}
READS_SWITCHES = {word for word in OPERATE if word & 0o405 == 0o404}
REFERENCES = [code << 9 | address for code in range(6) for address in (0o22, 0o222, 0o422, 0o622, 0o410)]
LEFT = {0o410, 0o2410, 0o4410, 0o5410, 0o6000, *BOTH_ROTATES, *READS_SWITCHES}
"""What a piece leaves: autoindexing but that of TAD and DCA, IOT, both rotates, OSR."""
LEADS_ANYWHERE = {0o4422, 0o4622, 0o5422, 0o5622}
"""What it leaves too when there are breakpoints: JMS I, JMP I."""


def counted(words: str, tape: bytes = b"", ion: int = 0) -> tuple[Machine, list[int]]:
    """Return a plain machine, and the addresses at which its processor executes an instruction."""
    m = machine(words, tape, form="plain", ion=ion)
    executed: list[int] = []
    instruction = m.processor.instruction

    def counting() -> None:
        executed.append(m.pc)
        instruction()

    vars(m.processor)["instruction"] = counting
    return m, executed


@pytest.mark.parametrize(("ion", "breakpoints"), [(0, set()), (1, set()), (0, {0o7000})])
def test_a_piece_leaves_the_first_and_the_last_instruction_and_what_it_does_not_know(
    ion: int, breakpoints: set[int]
) -> None:
    """The word, JMP 200, so often: at the word every pointer leads to, and after a skip, is JMP 200 too."""
    back = "5200 " * 0o60
    left = LEFT | (LEADS_ANYWHERE if breakpoints else set())
    for word in (*REFERENCES, 0o6000, *(OPERATE[::16] if ion or breakpoints else OPERATE)):
        with case(f"{word:04o}"):
            m, executed = counted(
                f"{word:o} 5200 5200 10/ 300 22/ 230 222/ 230 5200 230/ 5200 5200 301/ {back}"
            )
            m.processor.ion = m.processor.ion_delayed = ion
            if word == 0o5222:
                m.core[0o222] = 0o5200
            m.watch.breakpoints |= breakpoints
            m.run(instructions=61)
            assert m.instructions == 61
            assert len(executed) == (31 if word in left else 2)
            assert (m.processor.forms[0o200] == DELAY) == (word in (0o2022, 0o2222)), "ISZ, JMP .-1"
            m.run(seconds=1e-3)
            assert word in left or len(executed) <= 5


@pytest.mark.parametrize(
    ("words", "most"),
    [
        *(("6031 5200", 6), ("6041 5200", 6), ("5200", 6), ("7000 5200", 8), ("6001 5201", 5)),
        *(("6031 7000 5200", 11), ("6031 7410 5202 5200", 11)),
    ],
)
def test_what_only_waits_is_passed_over(words: str, most: int) -> None:
    """In two runs, the first of which ends between PRESET and the first shift."""
    m, executed = counted(words, b"abc" if words[:2] == "60" else b"")
    m.run(0.002)
    m.run(0.02)
    assert len(executed) <= most
