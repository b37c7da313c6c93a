"""What the 4,096 words of a PDP-8 mean: operations, addresses, groups of microinstructions, major states.

         0   1   2   3   4   5   6   7   8   9  10  11
       ┌───────────┬───┬───┬───────────────────────────┐
    MRI│ operation │ I │ P │          address          │   AND TAD ISZ DCA JMS JMP
    IOT│     6     │     device code       │  pulses   │   IOP4 IOP2 IOP1
    OPR│     7     │ group │ CLA │ microinstructions   │   see operate.py
       └───────────┴───┴───┴───────────────────────────┘

The address of a memory-reference instruction (MRI) is on page zero, or with P set on the page that the
instruction itself was fetched from. With I set, the word there holds the address; if it is one of 0010 to
0017, it is incremented first.

Sources: PDP-8/L Users Handbook 1968; Small Computer Handbook 1970; PDP-8/I instruction card.
"""

AND, TAD, ISZ, DCA, JMS, JMP, IOT, OPR = 0, 1, 2, 3, 4, 5, 6, 7
OPERATIONS = ("AND", "TAD", "ISZ", "DCA", "JMS", "JMP", "IOT", "OPR")

ADDRESS = 0o0177
PAGE = 0o7600
CURRENT_PAGE = 0o0200
INDIRECT = 0o0400

# Group 2 has only GROUP_2 set, group 3 has all bits of GROUP_3, group 1 none.
GROUP_2, GROUP_3 = 0o400, 0o401
CLA = 0o200
CLL, CMA, CML, RAR, RAL, TWICE, IAC = 0o100, 0o40, 0o20, 0o10, 0o4, 0o2, 0o1
SMA, SZA, SNL, REVERSED, OSR, HLT = 0o100, 0o40, 0o20, 0o10, 0o4, 0o2

FETCH, DEFER, EXECUTE, NO_STATE, WORD_COUNT, CURRENT_ADDRESS, BREAK = 0, 1, 2, 3, 4, 5, 6
STATES = ("FETCH", "DEFER", "EXECUTE", "no state", "WORD COUNT", "CURR ADDR", "BREAK")
"""The major states, the last three a data break's; LOAD ADD, EXAM and DEP leave none of their lamps lit."""

_ADDRESS, _PAGE, _FIELD, _CURRENT_PAGE, _JMP = ADDRESS, 0o77600, 0o70000, CURRENT_PAGE, JMP
"""C numbers, where this file is compiled (isa.pxd); a page and a field with the field's three bits."""


def refers_to(word: int, location: int) -> int:
    """Return the address in the memory-reference instruction `word` fetched from `location`, in its field."""
    return word & _ADDRESS | location & (_PAGE if word & _CURRENT_PAGE else _FIELD)


def in_field(location: int, address: int) -> int:
    """Return `address`, of which twelve bits count, in the field of `location`."""
    return location & _FIELD | address & 0o7777


def autoindexed(pointer: int) -> bool:
    """Whether an indirect reference increments the word at `pointer` first."""
    return pointer & 0o7770 == 0o10


def jumps_to(target: int, word: int, location: int) -> bool:
    """Whether `word` at `location` is a direct JMP to `target`."""
    return word >> 8 == _JMP << 1 and refers_to(word, location) == target


def changes_field(word: int) -> bool:
    """Whether `word` is a CIF: the next JMP or JMS goes to the field that it names."""
    return word & 0o7702 == 0o6202


def tests_flag(word: int) -> bool:
    """Whether `word` is an IOT that sends a device only IOP1, such as KSF; not ION."""
    return word & 0o7007 == 0o6001 and word != 0o6001


def halts(word: int) -> bool:
    """Whether `word` has the HLT bit of group 2."""
    return word & 0o7403 == 0o7402
