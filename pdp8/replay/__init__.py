"""The whole 1971 afternoon, done again and shown.

operator      what the operator did at the PDP-8/L, tick by tick
afternoon     from part program to milled part, in one call
figures       the thesis's figures beside the afternoon's
desk          what it leaves: tapes, listings, pictures
page          the afternoon as one HTML file, of which these are the pieces:

page.html     what stands where           page.css       how it looks
machine.mjs   a small PDP-8/L             panel.mjs      its lamps and switches
afternoon.mjs any instant again           paper.mjs      listing, printed page, blocks
tape.mjs      tapes under their heads     cutter.mjs     the staircase in its band
scene.mjs     all of it at one instant    written.mjs    how it is written
page.mjs      slider, buttons and keys
"""

from pdp8.replay.afternoon import Act, Afternoon, clock, replay

__all__ = ["Act", "Afternoon", "clock", "replay"]
