"""The notes on a PAL III source after its passes: on its words, names, lines and end.

The notes that are found during the passes are in `pal.watched`.
"""

from collections.abc import Sequence

from pal.assembler import Entry, Listed, Message, Output, Written
from pal.dialects import hint
from pal.listing import LONGEST
from pal.messages import COLON, NO_SLASH
from pal.notes import (
    Note,
    note,
    of_model,
    of_names,
    of_overlays,
    of_undefined,
    of_words,
)
from pal.pal8.symbols import INSTRUCTIONS
from pal.source import Source
from pal.symbols import PERMANENT, SIGNIFICANT
from pal.watched import NAMES, Watched

_INSTRUCTIONS = {symbol.mnemonic: symbol.octal for symbol in PERMANENT}


def notes(
    source: Source,
    tapes: int,
    watched: Watched,
    messages: Sequence[Message],
    punched: Output,
    table: Sequence[Entry],
) -> list[Note]:
    """The other notes on a source after passes 1 and 2; `table` has the symbols as pass 1 left them."""
    ended = watched.ended
    items = source.items
    words = [piece for piece in punched if isinstance(piece, Written)]
    found = [
        each._replace(at=source.first_symbol(each.at))
        for each in [*of_overlays(words), *of_words(words, _INSTRUCTIONS)]
    ]
    undefined = [entry for entry in table if not entry.defined]
    if undefined:
        found += _undefined(source, undefined, [entry.name for entry in table if entry.defined])
    if watched.cuts:
        long = [(item, at) for at, (item, _) in enumerate(items[:ended]) if len(item) >= SIGNIFICANT]
        found += of_names([(item, at) for item, at in long if item[0].isalpha()], NAMES)
    return [
        *found,
        *_illegal(source, messages),
        *_overlong(source, ended),
        *_of_the_end(source, tapes, ended),
    ]


def _undefined(source: Source, table: list[Entry], known: list[str]) -> list[Note]:
    """Note undefined symbols that another PDP-8 has, that are misspelled, or that are text."""
    notes = []
    others = []
    names = {*NAMES, *(entry.name for entry in table)}
    for entry in sorted(table, key=lambda entry: entry.at):
        octal = INSTRUCTIONS.get(entry.name)
        if octal is not None:
            notes.append(note("PN34", entry.at, name=entry.name, octal=f"{octal:04o}"))
        elif not hint("UA", entry.name):
            before, blank = source.items[entry.at - 1] if entry.at else ("", "")
            if blank in (" ", "\t") and before and before[:SIGNIFICANT] not in names:
                notes.append(note(NO_SLASH, entry.at))
                continue
            if source.bare_tag(entry.name) is None:
                others.append((entry.name, entry.at, source.begun(entry.at)))
    return notes + of_undefined(others, [*known, *_INSTRUCTIONS])


def _illegal(source: Source, messages: Sequence[Message]) -> list[Note]:
    """Note colons after tags, and the first of the small letters."""
    illegal = [(chr(int(said.subject, 8) & 0o177), said.at) for said in messages if said.code == "IC"]
    notes = [note(COLON, at) for character, at in illegal if character == ":" and source.items[at][0]]
    small = [at for character, at in illegal if "a" <= character <= "z"]
    if small:
        notes.append(note("PN35", small[0], count=f"{len(small):,}"))
    return notes


def _overlong(source: Source, ended: int) -> list[Note]:
    """Note the first line that is too long for pass 3."""
    for line, text in enumerate(source.text.split("\r")):
        if len(text) > LONGEST and source.line_ends[line] in range(ended):
            end = source.line_ends[line]
            return [note("PN28", end, length=str(len(text)), longest=str(LONGEST))]
    return []


def _of_the_end(source: Source, tapes: int, ended: int) -> list[Note]:
    if ended == len(source.items) - 1:
        return [note("PN27", max(ended - 1, 0))]
    notes = []
    for at in range(ended + 1, len(source.items) - 1):
        item, mark = source.items[at]
        if item or mark not in "\r \t\x1a":
            if source.place(at).tape == source.place(ended).tape:
                notes = [note("PN03", at)]
            break
    unread = tapes - 1 - source.place(ended).tape
    if unread:
        notes.append(note("PN27 tapes", ended, tapes=f"{unread} more tape{'s' * (unread > 1)}"))
    return notes


def of_pass_3(punched: Output, listed: Output) -> list[Note]:
    """Note the first word that pass 2 and pass 3 see differently."""
    on_tape = [piece for piece in punched if isinstance(piece, Written)]
    words = [piece for piece in listed if isinstance(piece, Listed) and piece.word is not None]
    for word, piece in zip(on_tape, words, strict=False):
        if piece.word is not None and piece.word != word.word:
            return [note("PN24", piece.at, word=f"{word.word:04o}", listed=f"{piece.word:04o}")]
    return []


def on_models(source: Source, punched: Output, model: str) -> list[Note]:
    """Note what other models do otherwise, of words that are written with a symbol other than a tag."""
    tags = {name for name, mark in source.items if mark == ","}
    words = [piece for piece in punched if isinstance(piece, Written)]
    written = [word for word in words if word.names and word.names[0] not in tags]
    return [each._replace(at=source.first_symbol(each.at)) for each in of_model(written, model)]
