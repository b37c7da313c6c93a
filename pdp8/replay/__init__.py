"""The whole 1971 afternoon, done again and shown.

operator     what the operator did at the PDP-8/L, tick by tick
afternoon    from part program to milled part, in one call
figures      the thesis's figures beside the afternoon's
page         the afternoon as one HTML file, with page.html, page.css and the scripts *.mjs beside it

machine.mjs  a small PDP-8/L       tape.mjs    tapes under their heads     panel.mjs  lamps and switches
afternoon.mjs  any instant again   cutter.mjs  the staircase in its band   paper.mjs  the listing
"""

from pdp8.replay.afternoon import Act, Afternoon, replay
from pdp8.replay.page import page

__all__ = ["Act", "Afternoon", "page", "replay"]
