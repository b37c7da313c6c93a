"""The Pygments lexer: found by its names, and blind to nothing."""

from pathlib import Path

from pygments import lex
from pygments.lexers import get_lexer_by_name, get_lexer_for_filename
from pygments.token import Comment, Error, Generic, Keyword, Name, Number

from pal.lexer import PalLexer
from tests.conftest import case

EXAMPLES = Path(__file__).parent / "examples"


def test_it_is_registered() -> None:
    assert isinstance(get_lexer_by_name("pal3"), PalLexer)
    assert isinstance(get_lexer_for_filename("eia.pal"), PalLexer)


def test_a_line_of_a_listing() -> None:
    line = "0201  5600  A,\tJMP I LOOP\t/AGAIN"
    found = [(kind, text) for kind, text in lex(line, PalLexer()) if text.strip()]
    assert found == [
        (Comment, "0201"),
        (Number.Oct, "5600"),
        (Name.Function, "A"),
        (found[3][0], ","),
        (Keyword, "JMP"),
        (Keyword.Pseudo, "I"),
        (Name, "LOOP"),
        (Comment.Single, "/AGAIN"),
    ]


def test_it_keeps_every_character() -> None:
    for path in sorted(EXAMPLES.glob("*.pass3.txt")):
        with case(path):
            text = path.read_text()
            pieces = list(lex(text, PalLexer(stripnl=False)))
            assert "".join(piece for _, piece in pieces) == text
            messages = [piece for kind, piece in pieces if kind is Generic.Error]
            assert messages == [line for line in text.splitlines() if line.startswith("IR  ")]


def test_illegal_characters_are_errors() -> None:
    assert [text for kind, text in lex("\tA!b", PalLexer()) if kind is Error] == ["!", "b"]
