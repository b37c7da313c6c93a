"""A machine's state in a file, and what it has done.

state        a whole machine as text, and back
history      what a machine has done, kept so that it can be undone
rewind       undoing it, in instructions, cycles, seconds, characters, to an event
"""
