"""The permanent symbols of PAL III: what the assembler knows before it reads a source.

One table for both ways: the assembler looks names up in it, the disassembler words. It is that of the
edition of February 1967, in its order, which FIXMRI sees: pseudo-operators, then memory references. There is
no OPR and no IOT, nothing of the extended arithmetic element and nothing of a later PDP-8.

Sources: DEC-08-ASB1; DEC-08-ASAC-D, appendix; Small Computer Handbook (meanings).
"""

from typing import NamedTuple

SIGNIFICANT = 6  # characters of a symbol that count


class Permanent(NamedTuple):
    """One permanent symbol: name, word, what it does, and whether it is a memory-reference instruction."""

    mnemonic: str
    octal: int
    meaning: str
    memory_reference: bool = False


PERMANENT = (
    Permanent("AND", 0o0000, "AND the word to the AC", True),
    Permanent("TAD", 0o1000, "add the word to the AC, two's complement", True),
    Permanent("ISZ", 0o2000, "increment the word, skip if it becomes zero", True),
    Permanent("DCA", 0o3000, "deposit the AC, then clear it", True),
    Permanent("JMS", 0o4000, "jump to a subroutine", True),
    Permanent("JMP", 0o5000, "jump", True),
    Permanent("FEXT", 0o0000, "floating point package: leave it", True),
    Permanent("FADD", 0o1000, "floating point package: add", True),
    Permanent("FSUB", 0o2000, "floating point package: subtract", True),
    Permanent("FMPY", 0o3000, "floating point package: multiply", True),
    Permanent("FDIV", 0o4000, "floating point package: divide", True),
    Permanent("FGET", 0o5000, "floating point package: get the operand", True),
    Permanent("FPUT", 0o6000, "floating point package: put the result", True),
    Permanent("FNOR", 0o7000, "floating point package: normalize", True),
    Permanent("ION", 0o6001, "interrupt on"),
    Permanent("IOF", 0o6002, "interrupt off"),
    Permanent("SMP", 0o6101, "skip if there is no memory parity error"),
    Permanent("CMP", 0o6104, "clear the memory parity flag"),
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
    Permanent("TLS", 0o6046, "clear the teleprinter's flag and print a character"),
    Permanent("TPC", 0o6044, "print a character"),
    Permanent("NOP", 0o7000, "no operation"),
    Permanent("IAC", 0o7001, "increment the AC"),
    Permanent("RAL", 0o7004, "rotate AC and link left"),
    Permanent("RTL", 0o7006, "rotate AC and link left twice"),
    Permanent("RAR", 0o7010, "rotate AC and link right"),
    Permanent("RTR", 0o7012, "rotate AC and link right twice"),
    Permanent("CML", 0o7020, "complement the link"),
    Permanent("CMA", 0o7040, "complement the AC"),
    Permanent("CLL", 0o7100, "clear the link"),
    Permanent("CLA", 0o7200, "clear the AC"),
    Permanent("HLT", 0o7402, "halt"),
    Permanent("OSR", 0o7404, "OR the switch register into the AC"),
    Permanent("SKP", 0o7410, "skip"),
    Permanent("SNL", 0o7420, "skip on non-zero link"),
    Permanent("SZL", 0o7430, "skip on zero link"),
    Permanent("SZA", 0o7440, "skip on zero AC"),
    Permanent("SNA", 0o7450, "skip on non-zero AC"),
    Permanent("SMA", 0o7500, "skip on minus AC"),
    Permanent("SPA", 0o7510, "skip on plus AC"),
    Permanent("CIA", 0o7041, "complement and increment the AC"),
    Permanent("LAS", 0o7604, "load the AC from the switch register"),
    Permanent("STL", 0o7120, "set the link"),
    Permanent("GLK", 0o7204, "get the link into the AC"),
    Permanent("STA", 0o7240, "set the AC to minus one"),
    Permanent("DTRA", 0o6761, "DECtape TC01: read status register A"),
    Permanent("DTCA", 0o6762, "DECtape TC01: clear status register A"),
    Permanent("DTXA", 0o6764, "DECtape TC01: load status register A by exclusive OR"),
    Permanent("DTSF", 0o6771, "DECtape TC01: skip on flags"),
    Permanent("DTRB", 0o6772, "DECtape TC01: read status register B"),
    Permanent("DTLB", 0o6774, "DECtape TC01: load status register B"),
    Permanent("MMMM", 0o6757, "DECtape 552: load unit, motion and function together"),
    Permanent("MMMF", 0o6756, "DECtape 552: load motion and function"),
    Permanent("MMML", 0o6766, "DECtape 552: clear and load the memory address counter"),
    Permanent("MMLS", 0o6751, "DECtape 552: load the unit select register"),
    Permanent("MMLM", 0o6752, "DECtape 552: load the motion register"),
    Permanent("MMLF", 0o6754, "DECtape 552: load the function register"),
    Permanent("MMSF", 0o6761, "DECtape 552: skip on flags"),
    Permanent("MMCF", 0o6772, "DECtape 552: clear flags"),
    Permanent("MMSC", 0o6771, "DECtape 552: skip on no error"),
    Permanent("MMRS", 0o6774, "DECtape 552: read the status register"),
    Permanent("MMCC", 0o6762, "DECtape 552: clear the memory address counter"),
    Permanent("MMLC", 0o6764, "DECtape 552: load the memory address counter"),
)

REFERENCES = tuple(symbol.mnemonic for symbol in PERMANENT if symbol.memory_reference)

PSEUDO_OPERATORS = {
    "FIELD": 0o2157,
    "EXPUNGE": 0o1556,
    "FIXMRI": 0o2200,
    "PAUSE": 0o0372,
    "FIXTAB": 0o0561,
    "DECIMAL": 0o0167,
    "OCTAL": 0o0172,
    "I": 0o1174,
    "Z": 0o0535,
}
"""Their values are the addresses of their routines in PAL III itself; that of I is of a later edition."""


def codes(name: str) -> tuple[int, int, int]:
    """Return `name` as three words of two characters each, which sort letters before digits."""
    padded = name[:SIGNIFICANT].ljust(SIGNIFICANT, "@")
    first, second, third, fourth, fifth, sixth = (ord(character) & 0o77 for character in padded)
    return first << 6 | second, third << 6 | fourth, fifth << 6 | sixth


def spelled(words: tuple[int, ...]) -> str:
    """Return the name whose `codes` are these words; 40 to 77 are the characters from space to ``?``."""
    six = [code for word in words for code in (word >> 6, word & 0o77)]
    return "".join([chr(code + 0o100 if code < 0o40 else code) for code in six]).rstrip("@")


def typed(name: str) -> str:
    r"""Return what the Teletype types for a `spelled` name: six characters; 43 is ``\n`` and 45 ``\r``."""
    return f"{name:6}".translate(_TYPED)


_TYPED = {ord("@"): " ", ord("#"): "\n", ord("%"): "\r"}
