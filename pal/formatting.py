"""A source in columns: tags at the margin, statements at the first stop, comments below each other.

    LOOP,   TAD I POINT     /NEXT CHARACTER
            SNA
            HLT             /THE END

Only blanks and TABs before a statement, before a comment and at the end of a line change. A line with a text
or with a form feed in it does not change, nor does a source that would then give other words.
"""

import re

from pal.assembler import HIGH_SPEED_SYMBOLS
from pal.assembling import assemble

_ENDS = re.compile(r"(\r\n|\r|\n)")
_LINE = re.compile(
    r"(?P<feeds>[ \t]*[\f\v])*[ \t]*(?P<tag>[A-Za-z][A-Za-z0-9]*[ \t]*,)?[ \t]*"
    r"(?P<rest>[^/\f\v]*?)[ \t]*(?P<comment>/[^\f\v]*)?"
)
_AT_THE_MARGIN = re.compile(r"[*$]|[A-Za-z][A-Za-z0-9]*[ \t]*=")
_TEXTS = re.compile(r'"|\b(?:TEXT|FILENAME|DEVICE)\b', re.IGNORECASE)
_STOP = 8
_COMMENTS = 24


def formatted(source: str, dialect: str) -> str:
    """Return `source` in columns, or unchanged if that would change its words."""
    text = "".join(part if _ENDS.fullmatch(part) else _line(part) for part in _ENDS.split(source))
    before, after = assemble(source, dialect=dialect), assemble(text, dialect=dialect)
    same = before.words == after.words and before.symbols == after.symbols
    return text if same and len(before.diagnostics) >= len(after.diagnostics) else source


def silenced(source: str) -> str:
    """Return a source in which each line with a note has a comment that silences it."""
    lines = source.split("\n")
    for found in assemble(source, capacity=HIGH_SPEED_SYMBOLS).diagnostics:
        line = lines[found.line - 1]
        if not found.error and "pal:" in line:
            lines[found.line - 1] = f"{line} {found.code}"
        elif not found.error:
            lines[found.line - 1] = f"{line}{' ' if '/' in line else '/'}pal: {found.code}"
    return "\n".join(lines)


def _line(line: str) -> str:
    found = _LINE.fullmatch(line)
    if found is None or _TEXTS.search(line):
        return line
    feeds = line[: found.end("feeds")] if found["feeds"] else ""
    tag, rest, comment = (found[name] or "" for name in ("tag", "rest", "comment"))
    if not tag and not rest:
        return line.rstrip(" \t")
    margin = not tag and _AT_THE_MARGIN.match(rest)
    code = rest if margin else f"{tag}\t{rest}".rstrip(" \t")
    if comment:
        width = len(code.expandtabs(_STOP))
        code += "\t" * max(1, -(-(_COMMENTS - width) // _STOP)) + comment
    return feeds + code
