"""PAL III and its listings in colour, wherever Pygments is used.

Registered by entry point as `pal3` (also `pal`, and for *.pal), so that `pygmentize eia.pal`, Sphinx and
editors find it; `pal --listing -` uses it at a terminal.

Sources: DEC-08-ASAC-D for the language; the table of symbols.
"""

from typing import ClassVar

from pygments.lexer import RegexLexer, bygroups, words
from pygments.token import Comment, Error, Generic, Keyword, Name, Number, Operator, Punctuation, Whitespace

from pal.symbols import PERMANENT, PSEUDO_OPERATORS, REFERENCES

_MICROINSTRUCTIONS = tuple(symbol.mnemonic for symbol in PERMANENT if not symbol.memory_reference)
_INDIRECT = tuple(name for name in PSEUDO_OPERATORS if len(name) == 1)
_DIRECTIVES = tuple(name for name in PSEUDO_OPERATORS if len(name) > 1)


class PalLexer(RegexLexer):
    """The tokens of a source, or of a listing with its locations, words and messages."""

    name = "PAL III"
    url = "https://en.wikipedia.org/wiki/PDP-8"
    aliases: ClassVar[list[str]] = ["pal3", "pal"]
    filenames: ClassVar[list[str]] = ["*.pal"]
    mimetypes: ClassVar[list[str]] = ["text/x-pal3"]
    tokens: ClassVar = {
        "root": [
            (r"^(?:IC|RD|DT|ST|UA|IR)  .*$", Generic.Error),
            (
                r"^([0-7]{4})(  )([0-7]{4})(  )",
                bygroups(Comment, Whitespace, Number.Oct, Whitespace),  # type: ignore[no-untyped-call]
            ),
            (r"/.*$", Comment.Single),
            (r"[A-Z][A-Z0-9]*(?=[ \t]*,)", Name.Function),
            (r"[A-Z][A-Z0-9]*(?=[ \t]*=)", Name.Constant),
            (words(_DIRECTIVES, suffix=r"\b"), Keyword.Declaration),
            (words(_INDIRECT, suffix=r"\b"), Keyword.Pseudo),
            (words(REFERENCES, suffix=r"\b"), Keyword),
            (words(_MICROINSTRUCTIONS, suffix=r"\b"), Name.Builtin),
            (r"[A-Z][A-Z0-9]*", Name),
            (r"[0-9]+", Number.Oct),
            (r"[-+.*=]", Operator),
            (r"[,;]", Punctuation),
            (r"\$", Keyword.Declaration),
            (r"\s+", Whitespace),
            (r".", Error),
        ]
    }
