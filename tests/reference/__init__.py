"""A plain PDP-8/L in C, written from the books: it shares nothing with the package, which is held against it.

processor.c  the processor
panel.c      the keys and SING STEP
devices.c    the ASR-33, the PC8/L
df32.py      the DF32, with the few instructions that drive it
parts.h      what these know of each other
pdp8l.h      the machine's state, and what can be done to it
teletype_gates.c, .h     the Teletype's interface as the flip-flops of DEC's M706 and M707, their clocks, the
                         mechanisms at both ends of the line
model.py     compiles it and calls it from Python

And the Hydra-Point, from the thesis's Chapters 2 and 3:

hydrapoint.py   blocks, modes, moves and times; random tapes are held against it
"""
