"""Text in UTF-16, as PowerShell's > writes it: told from tapes, and read by nothing here."""

_LITTLE, _BIG = b"\xff\xfe", b"\xfe\xff"
_NO_CHARACTER = 0xFFFD


def is_utf16(content: bytes) -> bool:
    """Whether a file is UTF-16: its byte order mark, then characters of Latin scripts or stray bytes."""
    if content[:2] not in (_LITTLE, _BIG):
        return False
    low, high = (0, 1) if content[:2] == _LITTLE else (1, 0)
    codes = [content[at + high] << 8 | content[at + low] for at in range(2, len(content) - 1, 2)]
    plain = sum(code < 0x100 or code == _NO_CHARACTER for code in codes)
    return 0 < len(codes) <= 4 * plain
