"""A tape that a notebook draws: the `bytes` it is, with a picture.

    Tape(machine.teletype.punch.tape)[:80]      ->  its first 80 frames as SVG

A piece of a Tape is a Tape; whatever else one does with it gives `bytes`, as with any tape.
"""

from typing import SupportsIndex, overload

from tapes import codes, picture

_FRAMES = 320


class Tape(bytes):
    """Frames that a notebook shows as SVG, the first 320, and a terminal as rows of holes, in their code."""

    @overload
    def __getitem__(self, place: SupportsIndex) -> int: ...

    @overload
    def __getitem__(self, place: slice) -> "Tape": ...

    def __getitem__(self, place: SupportsIndex | slice) -> "int | Tape":
        """Return a frame, or a piece of the tape."""
        if isinstance(place, slice):
            return Tape(super().__getitem__(place))
        return super().__getitem__(place)

    def __str__(self) -> str:
        """Return the whole tape as rows of holes."""
        return picture.text(self, codes.recognise(self).name)

    def _repr_svg_(self) -> str:
        """Return its first frames as SVG, for a notebook."""
        return picture.svg(self, codes.recognise(self).name, stop=_FRAMES)
