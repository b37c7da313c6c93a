"""What people do with the machine.

program      a program from a tape's bytes: its kind, words, tape and listing
bootstrap    the words that an operator toggles in to boot a DECtape or a disk
operator     who sets switches, presses keys and loads tapes, at a pace
keys         what a key of the Teletype sends
goals        what a run goes on until, and steps forward by it
ending       why a program ended, or what it waits for that nothing will bring, in sentences
trace        an instruction or a cycle a line, as in the listing
counted      what was counted, as a table, in the listing, for machines
"""
