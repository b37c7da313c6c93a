"""A source in columns: tags at the margin, statements at the first stop, comments below each other.

    LOOP,   TAD I POINT     /NEXT CHARACTER
            SNA
            HLT             /THE END

Only blanks and TABs before a statement and before a comment change: the words stay as they are.
"""

import re

from pal.assembling import assemble

_LINE = re.compile(
    r"[ \t]*(?P<tag>[A-Za-z][A-Za-z0-9]*[ \t]*,)?[ \t]*(?P<rest>[^/]*?)[ \t]*(?P<comment>/.*)?"
)
_AT_THE_MARGIN = re.compile(r"[*$]|[A-Za-z][A-Za-z0-9]*[ \t]*=")
_TEXTS = re.compile(r'"|\b(?:TEXT|FILENAME|DEVICE)\b', re.IGNORECASE)
_STOP = 8
_COMMENTS = 24


def formatted(source: str, dialect: str) -> str:
    """Return `source` in columns, or as it is where that would make other words of it."""
    text = "\n".join(map(_line, source.split("\n")))
    before, after = assemble(source, dialect=dialect), assemble(text, dialect=dialect)
    same = before.words == after.words and before.symbols == after.symbols
    return text if same and len(before.diagnostics) >= len(after.diagnostics) else source


def _line(line: str) -> str:
    end = "\r" if line.endswith("\r") else ""
    found = _LINE.fullmatch(line.rstrip("\r"))
    if found is None or _TEXTS.search(line):
        return line
    tag, rest, comment = (found[name] or "" for name in ("tag", "rest", "comment"))
    if not tag and not rest:
        return line.rstrip() + end
    margin = not tag and _AT_THE_MARGIN.match(rest)
    code = rest if margin else f"{tag}\t{rest}".rstrip()
    if not comment:
        return code + end
    width = len(code.expandtabs(_STOP))
    tabs = max(1, -(-(_COMMENTS - width) // _STOP))
    return code + "\t" * tabs + comment + end
