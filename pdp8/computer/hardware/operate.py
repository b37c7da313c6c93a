"""The operate instructions (OPR, op code 7) as pure functions of the 13 bits {L, AC}.

    group 1   7000-7377     | CLA | CLL | CMA | CML | RAR | RAL | 2 | IAC |
    group 2   7400-7776 even| CLA | SMA | SZA | SNL | sense | OSR | HLT | 0 |
    group 3   7401-7777 odd | no operation

{L, AC} is one word of 13 bits, the link its most significant: that is how the rotates and the carry see it.

On a PDP-8/L both rotates together (7014, 7016) give the AND of the two results, because every bit of the
register is fed through both shift gates at once (M220 module; 7354 = 3776 is how Kermit-12 and FOCAL-69 know
an 8/I or 8/L). Bit 10 alone (7002, the PDP-8/E's byte swap) rotates nothing. Group 3 does nothing at all, not
even its CLA bit: there is no multiplier quotient, and 7601 leaves the accumulator (Kermit-12 tells an 8/L
from an 8/I by it).

Sources: DEC PDP-8/I instruction card; Small Computer Handbook 1970; MAINDEC-08-D01, -D02.
"""

from pal.isa import CLA, CLL, CMA, CML, IAC, OSR, RAL, RAR, REVERSED, SMA, SNL, SZA, TWICE


def group1(word: int, lac: int) -> int:
    """Return {L, AC} after group 1 `word`: clear, complement, increment, rotate, in this order."""
    if word & CLA:
        lac &= 0o10000
    if word & CLL:
        lac &= 0o7777
    if word & CMA:
        lac ^= 0o7777
    if word & CML:
        lac ^= 0o10000
    if word & IAC:
        lac = lac + 1 & 0o17777
    if word & (RAR | RAL):
        places = 2 if word & TWICE else 1
        both = 0o17777
        if word & RAL:
            both &= lac << places | lac >> 13 - places
        if word & RAR:
            both &= lac >> places | lac << 13 - places
        lac = both
    return lac


def skips(word: int, lac: int) -> bool:
    """Whether group 2 `word` skips: SMA, SZA, SNL ORed; the sense bit inverts (SPA, SNA, SZL, SKP)."""
    condition = (
        (word & SMA != 0 and lac & 0o4000 != 0)
        or (word & SZA != 0 and lac & 0o7777 == 0)
        or (word & SNL != 0 and lac & 0o10000 != 0)
    )
    return condition != (word & REVERSED != 0)


def group2(word: int, lac: int, sr: int) -> int:
    """Return {L, AC} after the skip of group 2 `word`: CLA, then OSR ors the switches in."""
    if word & CLA:
        lac &= 0o10000
    if word & OSR:
        lac |= sr
    return lac
