"""A program by name with all that is known of it: its tape, and its listing if it is source."""

from pdp8.cli.program import assembled, words
from pdp8.computer.trace import Listing
from pdp8.monitor.prompt import Program
from tapes import binary, kinds, shelf
from tapes.errors import naming


def open_program(name: str) -> Program:
    """Return the program called `name`: a file, a bundled name. Raises WorkError saying what is wrong with
    it.
    """
    frames = shelf.read(name)
    with naming(name):
        if kinds.classify(frames) != kinds.ASCII:
            return Program(words(frames, name), frames, Listing())
        assembly = assembled(frames, name)
        return Program(assembly.words, assembly.tape or binary.encode(assembly.words), Listing.of(assembly))
