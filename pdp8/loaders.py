"""Loading: words put straight into core, and the RIM and BIN loaders as an operator used them."""

from collections.abc import Mapping

from tapes.errors import WorkError


class LoadError(WorkError):
    """Words that do not go into 4K of core, or a tape that did not load."""


def check(words: Mapping[int, int]) -> None:
    """Raise LoadError unless every address of `words` lies in 4K of core and every word has 12 bits."""
    for address, word in words.items():
        if not 0 <= address <= 0o7777:
            raise LoadError(f"address {address:05o}: a PDP-8/L with 4K of core ends at 07777")
        if not 0 <= word <= 0o7777:
            raise LoadError(f"address {address:04o}: {word:o} is no word of 12 bits")
