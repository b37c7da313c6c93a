"""What a legible line of the scan says: the six rules by which misread characters are read.

1  A zero is printed with a slash, and the scan has `Ø`, `Q`, `N`, `@` or `O` for it.
2  A point is read as `•`; `$...$`, `\\emptyset` and `\\bullet` are formulas that the scan's reader saw.
3  Spaces within a number or a statement come and go.
4  `**` around a line number or a note is boldface the scan's reader saw; an exponent's `**` follows a name.
5  A mark by itself is dirt: in PAL `-`, `/`, `=`, `,`, `•`; in FORTRAN `.`, `·` and `۰.`.
6  A line number behind its statement, and a note before it, are moved to their places.

A line that needs more than these is damaged. Nothing here knows what the programs should say.
"""

import re

_ZEROS = str.maketrans("ØQN@O", "00000")
_PAL_DIRT = frozenset("-/=,")
_FORTRAN_DIRT = frozenset((".", "·", "۰."))
_PLACES = 8  # four octal digits of the address, four of the word

_FORMULA = re.compile(r"\$([^$]*)\$")
_BOLD = re.compile(r"(?<![A-Z0-9)])\*\*([^*]+)\*\*")
_NOTE = re.compile(r"(?:^| )(/[A-Z].*?)(?= \d{3} |$)")
_LINE_NUMBER = re.compile(r"^(\d{3})(?: |$)|(?:^| )(\d{3})$")
_NEEDLESS = re.compile(r"(?<!PRINT)(?<!\)) ")
_LABEL = re.compile(r"(\d{2,3}) (?=\S)")


def pal_line(scan: str) -> tuple[str, str]:
    """Return a PAL listing's line as eight octal digits, "" if it opens with `/` or `*`, and its source."""
    words = [word for word in scan.split() if word not in _PAL_DIRT and word.strip("•")]
    if words and words[0][0] in "/*":
        return "", " ".join(words)
    digits = ""
    while words and len(digits) < _PLACES:
        digits += words.pop(0).translate(_ZEROS)
    return digits, " ".join(words)


def fortran_line(scan: str) -> str:
    """Return a FORTRAN listing's line as number, label, statement and note, on whichever side they are."""
    text = _FORMULA.sub(lambda formula: formula[1].replace(" ", ""), scan)
    text = _BOLD.sub(r"\1", text.replace("\\emptyset", "Ø").replace("\\bullet", "•"))
    text = " ".join(word for word in text.replace("Ø", "0").split() if word not in _FORTRAN_DIRT)
    text = text.replace("•", ".")
    if re.match(r"\d{3}C ", text):
        return text
    text, note = _taken(_NOTE, text)
    text, number = _taken(_LINE_NUMBER, text)
    label = _LABEL.match(text)
    statement = text[label.end() :] if label else text
    statement = _NEEDLESS.sub("", statement)
    return " ".join(part for part in (number, label[1] if label else "", statement, note) if part)


def _taken(pattern: re.Pattern[str], text: str) -> tuple[str, str]:
    """Return `text` without the match of `pattern`, and that match."""
    found = pattern.search(text)
    if not found:
        return text, ""
    rest = f"{text[: found.start()]} {text[found.end() :]}".strip()
    return rest, next(group for group in found.groups() if group)
