"""Photographs of tape become frames, sure or doubtful. All of it needs OpenCV, the extra `vision`.

reader      a photograph becomes frames
pixels      a picture's file becomes light
sprockets   rows of small round holes in a picture
sheet       where each place of a tape lies in a picture
flat        a picture of a sheet as if it lay flat
holes       the holes of a sheet, and where they say it is
edges       its edges: which way it is read
paper       a row of holes becomes a tape, or is refused
cells       how dark each place of a hole is, and what makes it doubtful
stitch      photographs of one long tape become one
correction  what was read, and the page to correct it
"""

from tapes.photograph.cells import UNSEEN
from tapes.photograph.reader import Frame, Strip, read, strips

__all__ = ["UNSEEN", "Frame", "Strip", "read", "strips"]
