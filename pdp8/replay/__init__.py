"""The whole 1971 afternoon, done again.

afternoon     from part program to milled part, in one call
figures       the thesis's figures beside the afternoon's
implied       what the thesis's figures imply: feed, range, size, allowance
desk          what it leaves: tapes, listings, pictures
"""

from pdp8.replay.afternoon import Act, Afternoon, clock, replay

__all__ = ["Act", "Afternoon", "clock", "replay"]
