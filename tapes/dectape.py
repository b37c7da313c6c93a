"""DECtape images: what is on a reel of 1474 blocks of 129 words, as files have it.

    .tu56, .dt8   380,292 bytes    129 words a block, each in two bytes, the low one first
                  377,344 bytes    128 words a block, as some programs keep them; the last word is 0

A file that ends after a whole block is the beginning of a tape, as SIMH takes it: the rest is 0. Douglas
Jones' emulator writes `tu56` before the words (.dwj).
"""

from array import array
from functools import cached_property

from tapes.errors import TapeError

BLOCKS = 1474
WORDS = 129
_WIDTHS = (129, 128)
_LENGTHS = tuple(2 * BLOCKS * width for width in _WIDTHS)
"""Bytes of a whole image."""
_MARK = b"tu56"
_OTHERS = {
    591_872: "a DECtape of 18-bit words, of a PDP-7, 9 or 15",
    3_325_952: "an RK05 disk; no PDP-8/L had one",
    6_651_904: "an RK05 disk; no PDP-8/L had one",
    65_536: "a DF32 disk",
    131_072: "two DF32 disks",
    196_608: "three DF32 disks",
    262_144: "four DF32 disks",
    524_288: "an RF08 disk",
    256_256: "an RX01 diskette; no PDP-8/L had one",
}


def image(length: int) -> str:
    """Return what image a file of so many bytes may be, "" for none."""
    return "a DECtape image" if length in _LENGTHS else _OTHERS.get(length, "")


class Image:
    """The words of a tape, and how its file has them. It does not change."""

    def __init__(self, words: "array[int]", width: int = WORDS) -> None:
        self.words = words
        self.width = width
        """Words a block in its file."""

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the words, which names the image in a saved state."""
        from hashlib import sha256  # only for who saves a state

        return sha256(packed(self.words)).hexdigest()

    def content(self) -> bytes:
        """Return the image as a file has it: 128 words a block if it came so and the last words are 0."""
        last = any(self.words[at] for at in range(WORDS - 1, len(self.words), WORDS))
        width = WORDS if last else self.width
        rows = (self.words[at : at + width] for at in range(0, len(self.words), WORDS))
        return b"".join(packed(row) for row in rows)


def blank() -> Image:
    """Return a formatted tape with nothing on it."""
    return Image(array("H", bytes(2 * BLOCKS * WORDS)))


def decode(content: bytes) -> tuple[Image, list[str]]:
    """Return the image in a file, and notes about it. Raises TapeError for a file that is none."""
    content = _unmarked(content)
    width = next((each for each in _WIDTHS if len(content) == 2 * BLOCKS * each), WORDS)
    blocks, more = divmod(len(content), 2 * width)
    if more or not 0 < blocks <= BLOCKS:
        known = image(len(content))
        what = f": {known}" if known else ""
        lengths = " or ".join(f"{each:,}" for each in _LENGTHS)
        ends = f"a DECtape image has {lengths}, or ends after a block of {2 * WORDS}"
        raise TapeError(f"{len(content):,} bytes{what}; {ends}")
    rest = bytes(2 * (WORDS - width))
    rows = [content[at : at + 2 * width] + rest for at in range(0, len(content), 2 * width)]
    words = low_first(array("H", b"".join([*rows, bytes(2 * WORDS * (BLOCKS - blocks))])))
    if max(words) > 0o7777:
        at = next(at for at, word in enumerate(words) if word > 0o7777)
        raise TapeError(
            f"block {at // WORDS:o}, word {at % WORDS:o}: {words[at]:o} (octal) is no word of 12 bits: this "
            "is no DECtape image of a PDP-8"
        )
    notes = [] if blocks == BLOCKS else [f"{blocks} of {BLOCKS} blocks; the others are taken as 0"]
    made = Image(words, width)
    if is_for_td8e(made):
        notes.append("block 0 works a TD8E (6776, 6777), which no PDP-8/L had: its system does not boot")
    return made, notes


def is_for_td8e(of: Image) -> bool:
    """Whether block 0, which boots a system, has IOTs of a TD8E and none of a TC08."""
    first = of.words[:WORDS]
    return 0o6776 in first and 0o6777 in first and not any(0o6761 <= word <= 0o6766 for word in first)


def is_image(content: bytes, name: str = "") -> bool:
    """Whether a file is as long as a whole image, or is named as one."""
    return len(_unmarked(content)) in _LENGTHS or name.lower().endswith((".tu56", ".dt8"))


def _unmarked(content: bytes) -> bytes:
    """Return what is behind the mark of Jones' emulator."""
    return content[len(_MARK) :] if content[: len(_MARK)] == _MARK else content


def packed(words: "array[int]") -> bytes:
    """Return words as images have them: each in two bytes, the low one first."""
    return low_first(words).tobytes()


def low_first(words: "array[int]") -> "array[int]":
    """Return words of this computer with the low byte first, or such words as its own."""
    found = words[:]
    if array("H", b"\1\0")[0] != 1:
        found.byteswap()
    return found
