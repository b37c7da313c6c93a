"""The words of core as they are examined and deposited from outside: addresses and words are checked."""

from collections.abc import Iterable, Iterator
from typing import overload

from pdp8.computer.hardware.processor import Processor

WORD = 0o7777


def allowed(value: int, what: str, most: int = WORD) -> int:
    """Return `value`. Raises ValueError, naming `what`, unless it is from 0 to `most`."""
    if not isinstance(value, int):
        raise ValueError(f"{what} {value!r} is not a number")
    if not 0 <= value <= most:
        raise ValueError(f"{what} {value:o} (octal): 0 to {most:o} are allowed")
    return value


class Core:
    """Core as a list of words and slices. Raises IndexError past its end, ValueError for what is no word."""

    def __init__(self, processor: Processor) -> None:
        self._processor = processor

    @overload
    def __getitem__(self, address: int) -> int: ...
    @overload
    def __getitem__(self, address: slice) -> list[int]: ...
    def __getitem__(self, address: int | slice) -> int | list[int]:
        if isinstance(address, slice):
            return [self._processor.core[each] for each in _addresses(self, address)]
        return self._processor.core[self._checked(address)]

    @overload
    def __setitem__(self, address: int, word: int) -> None: ...
    @overload
    def __setitem__(self, address: slice, word: Iterable[int]) -> None: ...
    def __setitem__(self, address: int | slice, word: int | Iterable[int]) -> None:
        if isinstance(address, slice):
            assert not isinstance(word, int), "a range of addresses takes a word for each"
            addresses, words = _addresses(self, address), list(word)
            if len(words) != len(addresses):
                raise ValueError(f"{len(words)} words for {len(addresses)} addresses of core")
        else:
            assert isinstance(word, int), "one address takes one word"
            addresses, words = range(self._checked(address), address + 1), [word]
        for value in words:
            allowed(value, "a word")
        for each, value in zip(addresses, words, strict=True):
            self._processor.deposit(each, value)

    def __len__(self) -> int:
        return self._processor.extension.size

    def __iter__(self) -> Iterator[int]:
        return iter(self._processor.core)

    def _checked(self, address: int) -> int:
        if not 0 <= address < len(self):
            raise IndexError(f"core has addresses 0000 to {len(self) - 1:o}, not {address:o}")
        return address


def _addresses(core: Core, part: slice) -> range:
    """Return the addresses of a slice; its end may be one past the last address."""
    for bound in (part.start, part.stop):
        if bound is not None and not 0 <= bound <= len(core):
            raise IndexError(f"core has addresses 0000 to {len(core) - 1:o}, not {bound:o}")
    return range(len(core))[part]
