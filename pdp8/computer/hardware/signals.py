"""The times and signals on which processor, bus and devices agree.

Time is in ticks of 0.05 us since power-up. This file is not compiled: what is imports C numbers from it.

Sources: Small Computer Handbook 1970, chapter 9 (I/O bus); PDP-8/I instruction card.
"""

TICKS_PER_SECOND = 20_000_000
NEVER = 1 << 62
AT_ONCE = -1

CYCLE = 32
IO_TICKS = 85 - CYCLE
"""What an IOT takes beyond its cycle."""
IOP1, IOP2, IOP4 = -3, 15, 33
"""The pulses of an IOT after its memory cycle: at 1.45 us, still in the cycle, 2.35 and 3.25 us."""
FRAME = TICKS_PER_SECOND // 10
"""A character on the Teletype's line."""

# What a device answers to a pulse: data for AC 4-11 in the low bits, and
SKIP = 0o10000
CLEAR_AC = 0o20000

TP1 = 10
"""When in a cycle a break that is requested is seen."""

INTERRUPT = 3
"""What follows an instruction when an interrupt is taken: an EXECUTE cycle that does JMS 0."""
PROTECTED = 0o7600
"""The first address that MEM PROT keeps."""
