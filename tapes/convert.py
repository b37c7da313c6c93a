"""From one code to another: characters to characters, words to words, and any tape to octal and back.

    text, ascii, eia    characters     text is a file's, its lines ended by LF
    bin, rim            words
    octal               the frames themselves, spelled out; they come back by the target "frames"

Channel 8 of a tape that stays ASCII is punched again and nothing else changes, unless the fill is given too
or it has LF without CR, as a text file has.
"""

from tapes import ascii, binary, eia, frames, kinds, octal, rim
from tapes.errors import TapeError, TextError

CHARACTERS = ("text", "ascii", "eia")
WORDS = ("bin", "rim")
CODES = (*CHARACTERS, *WORDS, "octal")
FRAMES = "frames"


def convert(content: bytes, source: str, target: str, parity: str = "mark", fill: int | None = None) -> bytes:
    """Convert the tape or file `content` from the code `source` to `target`, which is FRAMES or of CODES.

    `parity` and `fill` say how ASCII is punched. Raises TapeError or TextError: characters cannot become
    words.
    """
    if source == "octal":
        content = octal.encode(typed(content))
        source = kinds.classify(content)
    if target == FRAMES:
        return content
    if target == "octal":
        return octal.decode(content).encode()
    if source == target == "ascii" and fill is None and not _is_file(content):
        leader, body, trailer = frames.strip(content)
        return leader + frames.with_parity(body, parity) + trailer
    if source in CHARACTERS and target in CHARACTERS:
        return _punch(_characters(content, source), target, parity, 6 if fill is None else fill)
    if source in WORDS and target in WORDS:
        words = binary.decode(content).words if source == "bin" else rim.decode(content)
        return binary.encode(words) if target == "bin" else rim.encode(words)
    if not content:
        raise TapeError("empty tape", 0)
    raise TapeError(f"{_named(source)} cannot become {target}; octal takes any tape")


def typed(content: bytes) -> str:
    r"""Return the text of a file, its lines ended by "\n". Raises TextError where it is not UTF-8."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        found = f"byte {content[error.start]:03o} is no text"
        raise TextError(found, content.decode("latin-1"), error.start) from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _named(source: str) -> str:
    return {kinds.BLANK_TAPE: "a blank tape", kinds.UNKNOWN: "a tape of no known code"}.get(source, source)


def _is_file(content: bytes) -> bool:
    return b"\n" in content and b"\r" not in content.translate(frames.PARITIES["none"])


def _characters(content: bytes, source: str) -> str:
    if source == "text":
        return typed(content)
    return ascii.decode(content) if source == "ascii" else eia.decode(content)


def _punch(text: str, target: str, parity: str, fill: int) -> bytes:
    if target == "text":
        return text.encode()
    return ascii.encode(text, parity, fill) if target == "ascii" else eia.encode(text)
