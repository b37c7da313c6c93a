"""The whole 1971 afternoon, done again.

day           the operator's hands: from part program to milled part, act by act
script        any instant of a day again
story         a sentence for each act, for a reader who has never seen one
afternoon     the whole day in one call, measured
fortran       the same with the part program in DEC's FORTRAN, on the 8/L itself
figures       the thesis's figures beside the afternoon's
implied       what the thesis's figures imply: feed, range, size, allowance
desk          what it leaves: tapes, listings, pictures
"""

from pdp8.replay.afternoon import Afternoon, replay
from pdp8.replay.day import Act, clock

__all__ = ["Act", "Afternoon", "clock", "replay"]
