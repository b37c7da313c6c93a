"""The operator's room in a terminal: panel, Teletype and tapes, for one person at one machine.

session     the operator's time: machine, pace, tapes at hand, the RIM loader toggled in
opening     the room as the operator finds it
programs    which listing fits what is in core where the PC points
lamps       the rows of lamps, as bright as they were often on
switches    the switch register and the keys, for mouse and hand
strips      a tape under the reader's head or coming out of the punch
edges       what is written on the edges of a frame
pages       paper, listing, core, and the operator's card
dialogs     asking for a tape, or for the name of a file
app         the layout, the keys of the keyboard, the clock
room.tcss   colours and sizes

Session, opening and programs can be used without Textual, which the extra `panel` brings.
"""
