"""The lexer's rules as a TextMate grammar, for editors: VS Code, Sublime Text, and GitHub's Linguist.

    python -m release.grammar      writes editors/vscode/syntaxes/pal.tmLanguage.json

Small letters are coloured too: PAL8 takes them. Of a listing's columns an editor's grammar knows nothing.
"""

import json
from collections.abc import Iterator
from pathlib import Path

from pygments.lexer import words
from pygments.token import Comment, Keyword, Name, Number, Operator, Punctuation

from pal.lexer import PalLexer
from pal.pal8.symbols import INSTRUCTIONS, PSEUDO_OPERATORS

FILE = Path(__file__).parents[1] / "editors" / "vscode" / "syntaxes" / "pal.tmLanguage.json"

_SCOPES = {
    Comment.Single: "comment.line.slash",
    Name.Function: "entity.name.function",
    Name.Constant: "variable.other.constant",
    Keyword.Declaration: "keyword.control",
    Keyword.Pseudo: "storage.modifier",
    Keyword: "keyword.operator.word",
    Name.Builtin: "support.function",
    Name: "variable.other",
    Number.Oct: "constant.numeric.octal",
    Operator: "keyword.operator",
    Punctuation: "punctuation.separator",
}
_PAL8 = (
    (words(PSEUDO_OPERATORS, suffix=r"\b"), Keyword.Declaration),
    (words(tuple(INSTRUCTIONS), suffix=r"\b"), Name.Builtin),
)


def text() -> str:
    """Return the grammar as JSON."""
    grammar = {
        "name": "PAL III",
        "scopeName": "source.pal3",
        "fileTypes": ["pal", "pa"],
        "patterns": [{"name": f"{scope}.pal3", "match": f"(?i){match}"} for match, scope in _patterns()],
    }
    return json.dumps(grammar, indent=1) + "\n"


def _patterns() -> Iterator[tuple[str, str]]:
    """Yield each rule, PAL8's names before unknown names."""
    for pattern, token in PalLexer.tokens["root"]:
        if token is Name:
            for known, kind in _PAL8:
                yield f"\\b{known.get()}", _SCOPES[kind]  # type: ignore[no-untyped-call]
        if token in _SCOPES:
            yield pattern if isinstance(pattern, str) else f"\\b{pattern.get()}", _SCOPES[token]


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8")
