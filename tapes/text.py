r"""Lines of text, as PAL, tapes and the pages have them.

A line ends at CR LF, CR or LF. A form feed, a vertical tab or a separator of Unicode, which end lines for
`str.splitlines`, is a character like any other.
"""

import re

_BYTE_ORDER_MARK = b"\xef\xbb\xbf"
_LITTLE, _BIG = b"\xff\xfe", b"\xfe\xff"
_NO_CHARACTER = 0xFFFD
_ENDED = re.compile(r"[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+")


def with_ends(text: str) -> list[str]:
    """Return the lines of `text` with their ends."""
    found: list[str] = _ENDED.findall(text)
    return found


def lines_of(text: str) -> list[str]:
    """Return the lines of `text` without their ends; an empty rest is no line."""
    found = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    return found if found[-1] else found[:-1]


def without_mark(content: bytes) -> bytes:
    """Return the content of a text file without the byte order mark that an editor put there."""
    return content[3:] if content.startswith(_BYTE_ORDER_MARK) else content


def in_ascii(content: bytes) -> str:
    """Return a file as text, without a byte order mark and CP/M's ^Z at the end; "" if not all ASCII."""
    text = without_mark(content).rstrip(b"\x1a")
    return "" if not text.isascii() or b"\0" in text else text.decode("ascii")


def is_utf16(content: bytes) -> bool:
    """Whether a file is UTF-16, as PowerShell's > writes it: its mark, then a quarter or more Latin-1."""
    if content[:2] not in (_LITTLE, _BIG):
        return False
    low, high = (0, 1) if content[:2] == _LITTLE else (1, 0)
    codes = [content[at + high] << 8 | content[at + low] for at in range(2, len(content) - 1, 2)]
    plain = sum(code < 0x100 or code == _NO_CHARACTER for code in codes)
    return 0 < len(codes) <= 4 * plain
