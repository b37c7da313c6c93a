"""The documents of an editor: those that are open, and the tapes of the programs that its settings name.

A source belongs to the first program of the settings that lists it; any other is a program of one tape.
"""

from collections.abc import Callable, Iterable, Sequence
from os.path import abspath, join
from pathlib import Path
from urllib.parse import unquote, urlsplit

from pal.document import Document
from pal.text import UTF16, Text, path_of


class Workspace:
    """An editor's open texts and their programs; `read` returns the text of a tape that is not open."""

    def __init__(self, dialect: str, read: Callable[[str], str]) -> None:
        self.dialect = dialect
        self.unit = UTF16
        self.open: dict[str, Text] = {}
        self.chosen: dict[str, str] = {}
        """The dialect that the editor chose for a source, by the first tape of its program."""
        self._programs: list[list[str]] = []
        self._read = read
        self._made: dict[tuple[str, ...], tuple[tuple[str, ...], str, Document]] = {}

    def name_programs(self, programs: object, root: str) -> None:
        """Set the programs: lists of tapes, as paths relative to `root`; other values name none."""
        lists = programs if isinstance(programs, list) else []
        self._programs = [
            [Path(abspath(join(root, name))).as_uri() for name in names]
            for names in lists
            if isinstance(names, list) and all(isinstance(name, str) for name in names)
        ]

    def tapes(self, uri: str) -> list[str]:
        """Return the tapes of the program that a source belongs to, in order."""
        here, as_spelled = _plain(uri), {_plain(each): each for each in self.open}
        for program in self._programs:
            if here in program:
                return [as_spelled.get(tape, tape) for tape in program]
        return [uri]

    def document(self, uri: str) -> tuple[Document, int]:
        """Return the program that a source belongs to, assembled, and which of its tapes the source is."""
        tapes = tuple(self.tapes(uri))
        texts = [self.open.get(tape) or Text(self._read(tape), self.unit) for tape in tapes]
        contents = tuple(text.content for text in texts)
        dialect = self.chosen.get(tapes[0], self.dialect)
        made = self._made.get(tapes)
        if made is None or made[:2] != (contents, dialect):
            made = self._made[tapes] = contents, dialect, Document(texts, _names(tapes), dialect)
        return made[2], tapes.index(uri)

    def close(self, uri: str) -> None:
        """Forget the text of a source that the editor has closed."""
        self.open.pop(uri, None)
        self._made = {tapes: made for tapes, made in self._made.items() if self.open.keys() & set(tapes)}

    def documents(self) -> Iterable[tuple[Sequence[str], Document]]:
        """Yield each program of which a tape is open, with its tapes."""
        for tapes in dict.fromkeys(tuple(self.tapes(uri)) for uri in self.open):
            yield tapes, self.document(tapes[0])[0]


def _plain(uri: str) -> str:
    """Return a file's URI as Python spells it; another as it is."""
    parts = urlsplit(uri)
    return Path(path_of(uri)).as_uri() if parts.scheme == "file" and not parts.netloc else uri


def _names(uris: Sequence[str]) -> list[str]:
    """Return what to call the tapes: the names of their files, or their URIs where two have one name."""
    names = [unquote(uri.rpartition("/")[2]) for uri in uris]
    return names if len(set(names)) == len(names) else list(uris)
