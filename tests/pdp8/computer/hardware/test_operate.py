"""Every OPR word on every {L, AC}, through the processor, against a reference spelled out bit by bit.

The reference works on columns of bits, bit 0 the most significant, as the handbook's figures draw the
register; it shares nothing with pdp8.computer.hardware.operate.
"""

import numpy as np
import numpy.typing as npt
import pytest

from pdp8.computer.hardware.bus import Bus
from pdp8.computer.hardware.processor import Processor

Bits = npt.NDArray[np.bool_]
EVERY = np.arange(0o20000)
SWITCHES = 0o5252


def columns(lac: npt.NDArray[np.int_]) -> list[Bits]:
    """Return link, AC0 ... AC11, each a column of bits."""
    return [(lac >> (12 - position)) % 2 == 1 for position in range(13)]


def number(bits: list[Bits]) -> npt.NDArray[np.int_]:
    """Return the numbers whose bits are these columns."""
    return sum((bit.astype(np.int_) << (12 - position) for position, bit in enumerate(bits)), 0 * EVERY)


def group1(word: int) -> npt.NDArray[np.int_]:
    """Return {L, AC} after group 1 `word`, for every {L, AC} before."""
    link, *ac = columns(EVERY)
    if word & 0o200:
        ac = [np.zeros_like(link)] * 12
    if word & 0o100:
        link = np.zeros_like(link)
    if word & 0o040:
        ac = [~bit for bit in ac]
    if word & 0o020:
        link = ~link
    if word & 0o001:
        carry = np.ones_like(link)
        for position in range(11, -1, -1):
            ac[position], carry = ac[position] ^ carry, ac[position] & carry
        link = link ^ carry
    ring = [link, *ac]
    places = 2 if word & 0o002 else 1
    left = ring[places:] + ring[:places]
    right = ring[-places:] + ring[:-places]
    match word & 0o014:
        case 0o004:
            ring = left
        case 0o010:
            ring = right
        case 0o014:
            ring = [one & other for one, other in zip(left, right, strict=True)]
    return number(ring)


def group2(word: int) -> tuple[npt.NDArray[np.int_], Bits]:
    """Return {L, AC} after group 2 `word`, and where it skips, for every {L, AC} before."""
    link, *ac = columns(EVERY)
    zero = ~np.logical_or.reduce(ac)
    anything = np.zeros_like(link)
    if word & 0o100:
        anything |= ac[0]
    if word & 0o040:
        anything |= zero
    if word & 0o020:
        anything |= link
    skip = ~anything if word & 0o010 else anything
    if word & 0o200:
        ac = [np.zeros_like(link)] * 12
    if word & 0o004:
        ac = [bit | bool(SWITCHES >> (11 - position) & 1) for position, bit in enumerate(ac)]
    return number([link, *ac]), skip


def check(word: int, expected: npt.NDArray[np.int_], skips: Bits, runs: bool = True) -> None:
    """Execute `word` at 0200 from every {L, AC}; name the first from which it went wrong."""
    processor = Processor(Bus())
    processor.core[0o200] = word
    processor.sr = SWITCHES
    for before, (after, skip) in enumerate(zip(expected.tolist(), skips.tolist(), strict=True)):
        processor.pc, processor.lac, processor.run = 0o200, before, 1
        processor.instruction()
        if (processor.lac, processor.pc, processor.run) != (after, 0o201 + skip, runs):
            pytest.fail(
                f"{word:04o} from L={before >> 12} AC={before & 0o7777:04o}: {processor.lac:05o}, "
                f"not {after:05o}, PC {processor.pc:04o}, RUN {processor.run}"
            )
    assert processor.clock == 0o20000 * 32
    assert processor.core.tolist() == [0] * 0o200 + [word] + [0] * 0o7577


@pytest.mark.parametrize("rotate", range(0, 0o20, 2))
def test_group_1(rotate: int) -> None:
    for rest in range(0o20):
        for iac in (0, 1):
            word = 0o7000 | rest << 4 | rotate | iac
            check(word, group1(word), EVERY < 0)


@pytest.mark.parametrize("cla", [0, 0o200])
def test_group_2(cla: int) -> None:
    for rest in range(0, 0o200, 2):
        word = 0o7400 | cla | rest
        check(word, *group2(word), runs=not word & 2)


def test_group_3_does_nothing_not_even_its_cla() -> None:
    for word in range(0o7401, 0o10000, 2):
        check(word, EVERY, EVERY < 0)


@pytest.mark.parametrize(
    ("word", "before", "after"),
    [
        (0o7014, 0o11234, 0o00410),  # both rotates: the AND of the two, as on an 8/I's gates
        (0o7016, 0o11234, 0o00042),
        (0o7016, 0o07777, 0o15775),
        (0o7354, 0o00000, 0o13776),  # CLA CLL CMA RAR RAL: "8/I or 8/L" to Kermit-12 and FOCAL-69
        (0o7002, 0o11234, 0o11234),  # an 8/E would swap bytes
        (0o7042, 0o00000, 0o07777),
        (0o7203, 0o01234, 0o00001),
        (0o7601, 0o07777, 0o07777),  # an 8/I would clear
        (0o7344, 0o00000, 0o17776),
        (0o7041, 0o00000, 0o10000),  # CIA of 0 carries into the link
        (0o7205, 0o01234, 0o00002),
        (0o7604, 0o07777, 0o05252),  # LAS
    ],
)
def test_results_known_of_the_real_machine(word: int, before: int, after: int) -> None:
    processor = Processor(Bus())
    processor.core[0o200] = word
    processor.sr = SWITCHES
    processor.pc, processor.lac = 0o200, before
    processor.instruction()
    assert f"{processor.lac:05o}" == f"{after:05o}"
