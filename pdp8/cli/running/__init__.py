"""What `pdp8 run` puts around the machine.

feed      the tapes for the Teletype's reader
outputs   where the frames of a punch go
pacing    a run at its pace, slice by slice
keyboard  a terminal as the Teletype
line      a serial port or a pty as the Teletype
watching  a run traced or counted
"""
