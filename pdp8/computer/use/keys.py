"""What the keys of a Model 33 send: capitals, with channel 8 always set.

    key         at a terminal   sends
    RETURN      Enter           215
    LINE FEED   Ctrl-J          212
    FORM FEED   Ctrl-L          214
    RUBOUT      Backspace       377
    ALT MODE    Esc             375
    HERE IS     Ctrl-\\          twenty blank frames, from a drum that nobody has coded
    CTRL A-Z    Ctrl-A to -Z    201 to 232

A small letter presses the key of its capital. What has no key sends nothing: `{ | } ~`, the accent grave, and
all that is not ASCII.

Source: Teletype Model 33 keyboard; Small Computer Handbook 1970, appendix (ASR-33 codes).
"""

_SENDS = (
    {chr(code): bytes([0o200 | code]) for code in range(0o140)}
    | {chr(code): bytes([code + 0o140]) for code in range(0o141, 0o173)}
    | {"\x1b": b"\xfd", "\x7f": b"\xff", "\x1c": bytes(20)}
)


def sent(typed: str) -> bytes:
    """Return the frames that the keys send for what is typed at a terminal."""
    return b"".join(_SENDS.get(character, b"") for character in typed)
