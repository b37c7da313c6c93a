"""What a command reads as frames: a tape, or a dump, words spelled out as text, or a saved state."""

from pdp8 import shelf
from tapes.errors import naming
from tapes.text import without_mark


def unspelled(file: str, content: bytes) -> tuple[bytes, str]:
    """Return the frames that a file of this content spells, and a note on it; else `content` and ""."""
    from tapes import binary, dump

    if shelf.no_source(content) != shelf.JSON:
        return dump.unspelled(content)
    from pdp8.computer.past import state

    with naming(file):
        core = state.core(without_mark(content).decode("utf-8", "replace"))
    words = {address: word for address, word in enumerate(core) if word}
    return binary.encode(words), "a saved state, of whose core all words but 0000 are taken"
