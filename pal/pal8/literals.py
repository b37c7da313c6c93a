"""The literals and links of PAL8: at the end of each page, from 0177 downward, each value once.

A value is found again for as long as the source stays on the page; those of page zero, until FIELD. When the
source leaves a page its literals are punched; when it returns, the same value is stored again, below.
"""

from pal.pal8.log import Log

END = 0o200  # of a page
_PAGES = 32
_LEAST_IN_PAGE, _LEAST_IN_ZERO = 0o100, 0o20  # DEC's stores no literal below


class Literals:
    """The literals of a field.

    bottom    the lowest literal of each page, END if it has none
    top       one past the highest word of each page
    end       where the literals of this page end that were stored since the source came to it
    words     [(value, place)] of this page; `zero_words`, of page zero
    """

    def __init__(self, log: Log) -> None:
        self._log = log

    def clear(self) -> None:
        """Begin a field."""
        self.bottom = [END] * _PAGES
        self.top = [0] * _PAGES
        self._here: dict[int, int] = {}
        self._zero: dict[int, int] = {}
        self.words = [(0, 0)] * END
        self.zero_words = [(0, 0)] * END
        self._left: list[set[int]] = [set() for _ in range(_PAGES)]  # values of pages that were left

    def enter(self, page: int) -> None:
        """Start a page; its earlier literals are not reused."""
        self.end = self.bottom[page]
        self._here = {}

    def leave(self, page: int) -> None:
        """Remember the literals of a page."""
        self._left[page].update(self._here)

    def wipe(self, page: int) -> None:
        """Forget what is on a page, so that another overlay may go there."""
        self.bottom[page] = max(self.bottom[page], self.end)
        self.top[page] = 0

    def pass_word(self, page: int, below: int) -> None:
        """Store a word at an offset of a page; it replaces literals there."""
        if below >= self.top[page]:
            self.top[page] = below + 1
        if below >= self.bottom[page]:
            self._say_full(page, -1)
            self.bottom[page] = below + 1

    def find(self, value: int, page: int, start: int) -> int:
        """Return the address of a literal of a page, stored if new; `start` is its column."""
        known = self._here if page else self._zero
        bottom = self.bottom[page]
        found = known.get(value)
        if found is not None and found >= bottom:
            return page << 7 | found
        place = bottom - 1
        least = _LEAST_IN_PAGE if page else _LEAST_IN_ZERO
        words = self.words if page else self.zero_words
        if self.top[page] >= bottom or place < least:
            self._say_full(page, start)
        else:
            self.bottom[page] = place
            known[value] = place
            if self.end < END and page and value in self._left[page]:
                self._log.note("PN46", start, value=f"{value:04o}")
        words[place] = (value, self._log.keep_word(start))
        return (page << 7) + place & 0o7777

    def _say_full(self, page: int, start: int) -> None:
        """Report that the words and the literals of a page meet."""
        words, literals = (page << 7) + max(self.top[page] - 1, 0), (page << 7) + self.bottom[page]
        self._log.say("PE" if page else "ZE", start, words=f"{words:04o}", literals=f"{literals:04o}")
