"""What a source does otherwise on another model of the PDP-8: a note at each such word.

Only what is written as an instruction is looked at: a statement with a symbol other than a tag.
"""

from collections.abc import Iterable

from pal.assembler import Listed, Message, Punched, Written
from pal.models import differs
from pal.notes import MODEL, Note
from pal.source import Source


def portability(
    source: Source, output: Iterable[Message | Punched | Written | Listed], model: str
) -> list[Note]:
    """Return a note for each word in the output of pass 3 that another model than `model` does otherwise.

    Raises ValueError for a model that is not one of models.MODELS.
    """
    tags = {name for name, mark in source.items if mark == ","}
    notes = []
    for piece in output:
        if not isinstance(piece, Listed) or piece.word is None:
            continue
        difference = differs(piece.word, model)
        if not difference:
            continue
        at = source.first_symbol(piece.at)
        name = source.items[at][0]
        if name[:1].isalpha() and name not in tags:
            message = f"{piece.word:04o} {difference}"
            notes.append(Note(MODEL, at, message, "a program for all models does without"))
    return notes
