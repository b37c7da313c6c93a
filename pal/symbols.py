"""The permanent symbols of PAL III: what the assembler knows before it reads a source.

One table for both ways: the assembler looks names up in it, the disassembler words. It is that of the
edition of February 1967: the PDP-8's own instructions, the Teletype, the high-speed reader and punch,
DECtape and memory parity, and no OPR, no IOT, nothing of the extended arithmetic element and nothing of a
later PDP-8.

The order of the alphabet in all of PAL III's tables is that of its internal code, A to Z = 1 to 26, 0 to 9
= 27 to 36, blank = 0; so letters come before digits and M60 after M6.

Not here: the floating-point names (FEXT to FNOR) and the rest of the 552 DECtape names (MMLM, MMLF ...)
that the manual of 1969 lists; whether the edition of 1967 had them is not known.

Sources: the listing of a probe of 137 names by DEC-08-ASB1; DEC-08-ASAC-D, appendix; Small Computer
Handbook (meanings).
"""

from typing import NamedTuple

SIGNIFICANT = 6  # characters of a symbol that count


class Permanent(NamedTuple):
    """One permanent symbol: name, word, what it does, and whether it is a memory-reference instruction."""

    mnemonic: str
    octal: int
    meaning: str
    memory_reference: bool = False


MEMORY_REFERENCE = (
    Permanent("AND", 0o0000, "AND the word to the AC", True),
    Permanent("TAD", 0o1000, "add the word to the AC, two's complement", True),
    Permanent("ISZ", 0o2000, "increment the word, skip if it becomes zero", True),
    Permanent("DCA", 0o3000, "deposit the AC, then clear it", True),
    Permanent("JMS", 0o4000, "jump to a subroutine", True),
    Permanent("JMP", 0o5000, "jump", True),
)
GROUP_1 = (
    Permanent("NOP", 0o7000, "no operation"),
    Permanent("CLA", 0o7200, "clear the AC"),
    Permanent("CLL", 0o7100, "clear the link"),
    Permanent("CMA", 0o7040, "complement the AC"),
    Permanent("CML", 0o7020, "complement the link"),
    Permanent("RAR", 0o7010, "rotate AC and link right"),
    Permanent("RAL", 0o7004, "rotate AC and link left"),
    Permanent("RTR", 0o7012, "rotate AC and link right twice"),
    Permanent("RTL", 0o7006, "rotate AC and link left twice"),
    Permanent("IAC", 0o7001, "increment the AC"),
)
GROUP_2 = (
    Permanent("SMA", 0o7500, "skip on minus AC"),
    Permanent("SZA", 0o7440, "skip on zero AC"),
    Permanent("SPA", 0o7510, "skip on plus AC"),
    Permanent("SNA", 0o7450, "skip on non-zero AC"),
    Permanent("SNL", 0o7420, "skip on non-zero link"),
    Permanent("SZL", 0o7430, "skip on zero link"),
    Permanent("SKP", 0o7410, "skip"),
    Permanent("OSR", 0o7404, "OR the switch register into the AC"),
    Permanent("HLT", 0o7402, "halt"),
)
COMBINED = (
    Permanent("CIA", 0o7041, "complement and increment the AC"),
    Permanent("LAS", 0o7604, "load the AC from the switch register"),
    Permanent("STL", 0o7120, "set the link"),
    Permanent("GLK", 0o7204, "get the link into the AC"),
    Permanent("STA", 0o7240, "set the AC to minus one"),
)
INPUT_OUTPUT = (
    Permanent("ION", 0o6001, "interrupt on"),
    Permanent("IOF", 0o6002, "interrupt off"),
    Permanent("RSF", 0o6011, "skip on the high-speed reader's flag"),
    Permanent("RRB", 0o6012, "read the high-speed reader's buffer"),
    Permanent("RFC", 0o6014, "clear the high-speed reader's flag and fetch a frame"),
    Permanent("PSF", 0o6021, "skip on the high-speed punch's flag"),
    Permanent("PCF", 0o6022, "clear the high-speed punch's flag"),
    Permanent("PPC", 0o6024, "punch a frame"),
    Permanent("PLS", 0o6026, "clear the high-speed punch's flag and punch a frame"),
    Permanent("KSF", 0o6031, "skip on the keyboard's flag"),
    Permanent("KCC", 0o6032, "clear the keyboard's flag and the AC, run the reader"),
    Permanent("KRS", 0o6034, "OR the keyboard's buffer into the AC"),
    Permanent("KRB", 0o6036, "read the keyboard's buffer, run the reader"),
    Permanent("TSF", 0o6041, "skip on the teleprinter's flag"),
    Permanent("TCF", 0o6042, "clear the teleprinter's flag"),
    Permanent("TPC", 0o6044, "print a character"),
    Permanent("TLS", 0o6046, "clear the teleprinter's flag and print a character"),
    Permanent("SMP", 0o6101, "skip if there is no memory parity error"),
    Permanent("CMP", 0o6104, "clear the memory parity flag"),
    Permanent("DTRA", 0o6761, "DECtape TC01: read status register A"),
    Permanent("DTCA", 0o6762, "DECtape TC01: clear status register A"),
    Permanent("DTXA", 0o6764, "DECtape TC01: load status register A by exclusive OR"),
    Permanent("DTSF", 0o6771, "DECtape TC01: skip on flags"),
    Permanent("DTRB", 0o6772, "DECtape TC01: read status register B"),
    Permanent("DTLB", 0o6774, "DECtape TC01: load status register B"),
    Permanent("MMLS", 0o6751, "DECtape 552: load the unit select register"),
    Permanent("MMCC", 0o6762, "DECtape 552: clear the memory address counter"),
    Permanent("MMCF", 0o6772, "DECtape 552: clear flags"),
)

PERMANENT: tuple[Permanent, ...] = MEMORY_REFERENCE + GROUP_1 + GROUP_2 + COMBINED + INPUT_OUTPUT

PSEUDO_OPERATORS = ("DECIMAL", "OCTAL", "FIELD", "EXPUNGE", "FIXTAB", "FIXMRI", "PAUSE", "I", "Z")

_ALPHABET = str.maketrans("0123456789", "[\\]^_`abcd")  # the ten codes after Z


def internal_order(name: str) -> str:
    """Return a key that sorts names as PAL III's internal code does: blank, A to Z, 0 to 9."""
    return name.translate(_ALPHABET)
