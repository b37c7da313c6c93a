"""A machine's state, and what it has done.

state        a whole machine as text, and back
oldstate     states as they were written before version 2
snapshot     a machine's state in memory, taken and put back
history      what a machine has done, kept so that it can be undone
rewind       undoing it, in instructions, cycles, seconds, characters, to an event
"""
