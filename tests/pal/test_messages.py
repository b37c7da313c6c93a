"""The table of messages: each is said, with what its braces ask for; each note has a paragraph in docs."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from pal import messages
from pal.messages import MESSAGES, worded

HOUSE = Path(__file__).parents[2]
_SAYS = ("worded", "note", "_note", "_add", "add_note", "say", "die")
_FILES = sorted((HOUSE / "pal").rglob("*.py"))
_TREES = [ast.parse(path.read_text(encoding="utf-8")) for path in _FILES]


def _asked(text: str) -> set[str]:
    return set(re.findall(r"\{(\w+)\}", text))


def _keys(of: ast.expr) -> Iterator[str]:
    """Yield the keys that an expression may be."""
    match of:
        case ast.Constant(str(key)):
            yield key
        case ast.IfExp():
            yield from (*_keys(of.body), *_keys(of.orelse))


def test_each_message_is_given_what_its_braces_ask_for() -> None:
    found = 0
    for call in (node for tree in _TREES for node in ast.walk(tree) if isinstance(node, ast.Call)):
        name = call.func.attr if isinstance(call.func, ast.Attribute) else getattr(call.func, "id", "")
        if name in _SAYS and call.args:
            given = {each.arg for each in call.keywords}
            for key in _keys(call.args[0]):
                assert _asked(" ".join(MESSAGES[key])) <= given, key
                found += 1
    assert found > 100


def test_each_line_of_the_table_is_said_and_stands_there_once() -> None:
    constants = {node.value for tree in _TREES for node in ast.walk(tree) if isinstance(node, ast.Constant)}
    by_token = {f"IC {token}" for token in "*)]>,=:"}
    by_code = {"DT", "IR", "RD", "ST", messages.STOPPED}
    assert set(MESSAGES) - constants - by_token - by_code == set()
    tables = (messages._OF_PAL3, messages._OF_PAL8, messages._OF_NOTES)
    assert sum(not line.startswith(" ") for table in tables for line in table.splitlines()) == len(MESSAGES)


def test_each_note_has_its_paragraph() -> None:
    text = (HOUSE / "docs/notes.md").read_text(encoding="utf-8")
    told = re.findall(r"^- \*\*(PN\d\d)\*\*", text, re.MULTILINE)
    assert sorted(told) == sorted({key[:4] for key in MESSAGES if key.startswith("PN")})


def test_a_value_is_said_as_it_is_though_it_has_braces() -> None:
    assert worded("PN09", name="{first}", first="B").message.startswith("{first} is the same symbol as B:")
    with pytest.raises(KeyError):
        worded("PN09", name="A")
