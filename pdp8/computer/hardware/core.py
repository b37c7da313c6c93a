"""The 4096 words of core as they are examined and deposited from outside: addresses and words are checked."""

from collections.abc import Iterable, Iterator
from typing import overload

from pdp8.computer.hardware.processor import Processor

SIZE = 0o10000
WORD = 0o7777


def allowed(value: int, what: str, most: int = WORD) -> int:
    """Return `value`, set by a hand. Raises ValueError, with `what` it is, unless it is from 0 to `most`."""
    if not isinstance(value, int):
        raise ValueError(f"{what} {value!r} is not a number")
    if not 0 <= value <= most:
        raise ValueError(f"{what} {value:o} (octal): 0 to {most:o} are allowed")
    return value


class Core:
    """The core of one processor: `core[0o200]` is a word, `core[0o200:0o210]` a list of eight.

    Raises IndexError for an address that is not one of 0000 to 7777, ValueError for a word that is none.
    """

    def __init__(self, processor: Processor) -> None:
        self._processor = processor

    @overload
    def __getitem__(self, address: int) -> int: ...
    @overload
    def __getitem__(self, address: slice) -> list[int]: ...
    def __getitem__(self, address: int | slice) -> int | list[int]:
        if isinstance(address, slice):
            return [self._processor.core[each] for each in _addresses(address)]
        return self._processor.core[_checked(address)]

    @overload
    def __setitem__(self, address: int, word: int) -> None: ...
    @overload
    def __setitem__(self, address: slice, word: Iterable[int]) -> None: ...
    def __setitem__(self, address: int | slice, word: int | Iterable[int]) -> None:
        if isinstance(address, slice):
            assert not isinstance(word, int), "a range of addresses takes a word for each"
            addresses, words = _addresses(address), list(word)
            if len(words) != len(addresses):
                raise ValueError(f"{len(words)} words for {len(addresses)} addresses of core")
        else:
            assert isinstance(word, int), "one address takes one word"
            addresses, words = range(_checked(address), address + 1), [word]
        for value in words:
            allowed(value, "a word")
        for each, value in zip(addresses, words, strict=True):
            self._processor.deposit(each, value)

    def __len__(self) -> int:
        return SIZE

    def __iter__(self) -> Iterator[int]:
        return iter(self._processor.core)


def _checked(address: int) -> int:
    if not 0 <= address < SIZE:
        raise IndexError(f"core has addresses 0000 to 7777, not {address:o}")
    return address


def _addresses(part: slice) -> range:
    """Return the addresses of a slice, whose bounds are addresses or that after the last."""
    for bound in (part.start, part.stop):
        if bound is not None and not 0 <= bound <= SIZE:
            raise IndexError(f"core has addresses 0000 to 7777, not {bound:o}")
    return range(SIZE)[part]
