"""What a part program refuses."""

from tapes.errors import WorkError


class PartError(WorkError):
    """A part that cannot be made as asked; the message names the parameter, or the block that cannot be."""
