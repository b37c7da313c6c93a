r"""The reader: frames of source tapes to the items PAL III reads, each with the character that ends it.

    ``A,<TAB>TAD I B+1  /COMMENT<CR>``
    ("A", ",") ("", TAB) ("TAD", " ") ("I", " ") ("B", "+") ("1", " ") ("", " ") ("", CR)

An item is a run of letters and digits, perhaps empty. Any other character ends it, one that PAL III does not
know too. A comment, from ``/`` to CR, is not read.

Channel 8 is set on every frame of a tape of DEC's and not in a file of a text editor; here it does not
matter. Blank frames, leader (0200), RUBOUT, line feed and form feed are passed over; a form feed stays in
`text`, since pass 3 types it. A line feed without channel 8 is the end of a line in a text file, so it counts
as CR, LF, unless a CR is just before.

Sources: DEC-08-ASAC-D, "Characters"; the output of DEC-08-ASB1.
"""

import re
from collections.abc import Sequence
from contextlib import suppress
from functools import cached_property
from itertools import accumulate
from typing import NamedTuple

from tapes.frames import PARITIES

_PASSED_OVER = bytes((0o000, 0o200, 0o177, 0o377, 0o212))
_ITEM = re.compile(r"([A-Z0-9\f]*)(?:/[^\r]*)?([^A-Z0-9\f])")


class Place(NamedTuple):
    """An item in its source: tape and line, counted from 0 and 1; the line's text; the item's columns."""

    tape: int
    line: int
    text: str
    start: int
    end: int


class Source:
    """The source tapes, read one after the other as if they were one.

    text     what is on them, each line ended by CR; a CR and a `$` are added at the end
    items    [(letters and digits, the character that ends them), ...]
    feeds    the items in which, or in the comment after which, there is a form feed
    """

    def __init__(self, tapes: Sequence[bytes], modern: bool = False) -> None:
        texts = [_characters(tape) for tape in tapes]
        text = "".join(texts)
        self._starts = [0, *accumulate(map(len, texts))][: len(texts)]
        self.text = text + ("$" if text.endswith("\r") or not text else "\r$")
        self._code = self.text.upper() if modern else self.text
        self.items: list[tuple[str, str]] = _ITEM.findall(self._code)
        self.feeds: list[int] = []
        if "\f" in text:
            self.items = [(item.replace("\f", ""), mark) for item, mark in self.items]
            self.feeds = [at for at, span in enumerate(self.spans) if "\f" in self.text[slice(*span)]]

    @cached_property
    def spans(self) -> list[tuple[int, int]]:
        """For each item where in `text` it begins and where the character that ends it stands."""
        return [(match.start(), match.start(2)) for match in _ITEM.finditer(self._code)]

    @cached_property
    def _ends(self) -> list[int]:
        """Where in `text` each line ends."""
        return [match.start() for match in re.finditer("\r", self.text)]

    def place(self, at: int) -> Place:
        """Return where item `at` stands; for an empty one, the character that ends it."""
        start, mark = self.spans[at]
        end = start + len(self.items[at][0])
        if start == end:
            start, end = mark, mark + 1
        from bisect import bisect_left

        tape = max(sum(begin <= start for begin in self._starts) - 1, 0)
        line = bisect_left(self._ends, start)
        number = line - bisect_left(self._ends, self._starts[tape]) + 1
        first = self._ends[line - 1] + 1 if line else 0
        text = self.text[first : self._ends[line]] if line < len(self._ends) else self.text[first:-1]
        return Place(tape, number, text, start - first, end - first)


def _characters(tape: bytes) -> str:
    r"""Return the characters of a source tape but for those that are passed over; each line ends with ``\r``.

    A character beyond ASCII in a text (UTF-8, which no tape with channel 8 happens to be) becomes a ``?``.
    """
    if not tape.isascii():
        with suppress(UnicodeDecodeError):
            tape = tape.decode("utf-8-sig").encode("ascii", "replace")
    text = tape.translate(PARITIES["none"], _PASSED_OVER).decode("ascii")
    return text.replace("\r\n", "\r").replace("\n", "\r")
