"""The operator's room in a terminal: panel, Teletype and tapes, for one person at one machine.

session     the operator's time: machine, pace, tapes at hand, the RIM loader toggled in
opening     the room as the operator finds it
lamps       the rows of lamps, each as bright as its share of the time
switches    the switch register and the keys, for mouse and hand
strips      a tape under the reader's head or coming out of the punch
pages       paper, listing, core, and the card: the operator's or a drill's
dialogs     asking for a tape, or for the name of a file
app         the layout, the keys of the keyboard, the clock
room.tcss   colours and sizes

Session and opening can be used without Textual, which the extra `panel` brings.
"""
