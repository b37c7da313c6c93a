"""Single-step vectors of the PDP-8/L, for any emulator.

states      what the machine is before an instruction: about a hundred states, the same for every word
record      one instruction of the processor, written down
interrupts  instructions with flags up
hands       keys and switches of the panel, also for a real 8/L (pipan8l.tcl)
devices     the Teletype and the PC8/L against the clock
folder      all files of a set: vectors, README, differences of the other models, runners
runner.py   plays vectors on an emulator in Python; runner.c the same in C, runner_test.go in Go
"""
