"""From one code to another: characters to characters, words to words, and any tape to octal and back.

    text, ascii, eia, ita2    characters     text is a file's, its lines ended by LF
    bin, rim                  words
    octal                     the frames themselves, spelled out; they come back by the target "frames"

Channel 8 of a tape that stays ASCII is punched again and nothing else changes, unless the fill is given too
or it has LF without CR, as a text file has.
"""

from typing import Final

from tapes import ascii, codes, doubts, eia, frames, octal, redundancy, spelled
from tapes.code import Characters
from tapes.errors import TapeError, TextError
from tapes.loaders import Words
from tapes.text import without_mark

TEXT, OCTAL, FRAMES = "text", "octal", "frames"
FORMS: Final = (TEXT, *(code.name for code in codes.CODES), OCTAL)
"""What a tape is converted from and to."""
TARGETS: Final = (*FORMS, FRAMES, *spelled.FORMATS)
"""What it is converted to: also its frames, or its words spelled out."""


def convert(
    content: bytes,
    source: str,
    target: str,
    parity: str = "mark",
    fill: int | None = None,
    *,
    accept: bool = False,
    force: bool = False,
) -> bytes:
    """Convert `content` from `source`, one of FORMS, to `target`, one of TARGETS. Raises TapeError or
    TextError for what cannot be, for doubtful frames without `accept`, and for damage without `force`.
    """
    code = codes.named(source)
    if code is codes.ASCII and ascii.utf_8(content):
        source, code = TEXT, codes.UNKNOWN
    if source == OCTAL:
        content = octal.encode(typed(content))
        code = codes.recognise(content)
    if target == FRAMES:
        return content
    if target == OCTAL:
        return octal.decode(content).encode()
    if isinstance(code, Words) and target in spelled.FORMATS:
        words = _words(code, content, force)
        if not words:
            raise TapeError("no word to spell out")
        return spelled.FORMATS[target].spell(words).encode()
    made = codes.named(target)
    title = b""
    if isinstance(code, Characters):
        title, content = _without_title(content, code, accept)
    is_file = b"\n" in content and b"\r" not in content.translate(frames.PARITIES["none"])
    if code is made is codes.ASCII and fill is None and not is_file:
        leader, body, trailer = frames.strip(content)
        return title + (leader + frames.with_parity(body, parity) + trailer)[len(title) :]
    if isinstance(code, Words) and isinstance(made, Words):
        return made.encode(_words(code, content, force))
    if (source == TEXT or isinstance(code, Characters)) and (target == TEXT or isinstance(made, Characters)):
        text = code.decode(content) if isinstance(code, Characters) else typed(content)
        punched = 6 if fill is None else fill
        return made.encode(text, parity, punched) if isinstance(made, Characters) else text.encode()
    if not content:
        raise TapeError("empty tape", 0)
    _check_way(content)
    raise TapeError(
        f"{TEXT if source == TEXT else code.article} cannot become {target}; octal takes any tape"
    )


def _words(code: Words, content: bytes, force: bool) -> dict[int, int]:
    return code.readable(content) if force else code.decode(content)


def _check_way(content: bytes) -> None:
    """Raise TapeError for a tape that has to be turned."""
    way = redundancy.turned(content)
    if way:
        raise TapeError(f"the tape is {redundancy.TURNED[way]}: `pdp8 tape cut {way}` turns it")


def _without_title(content: bytes, code: Characters, accept: bool) -> tuple[bytes, bytes]:
    """Return the title of a tape, and the tape, blank in its place. Raises TapeError for doubtful frames."""
    if not accept:
        doubts.check(content, code)
        _check_way(content)
    for gap in code.gaps(content):
        content = content[: gap.start] + bytes([eia.DELETE]) * len(gap) + content[gap.stop :]
    end = max([label.stop for label in code.labels(content)], default=0)
    return content[:end], bytes(end) + content[end:]


def typed(content: bytes) -> str:
    r"""Return the text of a file, its lines ended by "\n". Raises TextError where it is not UTF-8."""
    content = without_mark(content)
    try:
        return _with_line_feeds(content)
    except UnicodeDecodeError as error:
        before = _with_line_feeds(content[: error.start])
        raise TextError(f"byte {content[error.start]:03o} is no text", before, len(before)) from None


def _with_line_feeds(content: bytes) -> str:
    return content.decode().replace("\r\n", "\n").replace("\r", "\n")
