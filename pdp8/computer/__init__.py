"""The machine itself: it prints nothing and knows no front end.

processor    AC L PC MA MB IR, one memory cycle at a time: the one to read
engine       the same for long runs: core decoded once, compiled where it can be
piece        the engine's inner loop, which setup.py translates to C
operate      the OPR groups as pure functions
bus          IOP pulses, SKIP, interrupt request: what processor and devices say to each other
teletype     ASR-33: keyboard and reader (03), printer and punch (04)
highspeed    PC8/L: the high-speed reader (01) and punch (02)
panel        lamps, switches and keys
waiting      loops that only wait, passed over exactly
watch        breakpoints, words being written, observers
trace        an instruction or a cycle a line, as in the listing
count        how often words were executed and written
machine      the one place that knows every part and wires it
core         the words of core, examined and deposited from outside
keys         what a key of the Teletype sends
program      a program from a tape's bytes: its kind, words, tape and listing
operator     who sets switches, presses keys and loads tapes, at a pace
stop         why, where and when a run ended
snapshot     a machine's state in memory, taken and put back
history      what a machine has done, kept so that it can be undone
rewind       undoing it, in instructions, cycles, seconds, characters, to an event
fields       how a part says what a saved state holds of it
state        a whole machine as text, and back
oldstate     states as they were written before version 2
"""
