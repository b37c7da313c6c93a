"""What a part program is: a function whose parameters are its constants, which returns its printout."""

from typing import Any, Protocol


class PartProgram(Protocol):
    """A part program: its constants as keywords, each with a default; one may be positional."""

    def __call__(self, *arguments: Any, **constants: Any) -> str:
        """Return the printout."""
