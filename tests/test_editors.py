"""The folder of the VS Code extension: its grammar is the lexer's, its debugger takes what ours takes."""

import json
from dataclasses import fields
from pathlib import Path

from pdp8.dap.launch import Launch
from release import grammar

EXTENSION = Path(__file__).parents[1] / "editors" / "vscode"


def test_the_grammar_is_made_from_the_lexer() -> None:
    assert (EXTENSION / "syntaxes").samefile(grammar.FILE.parent)
    assert grammar.FILE.read_text() == grammar.text()


def test_the_extension_names_files_and_settings_that_there_are() -> None:
    contributed = json.loads((EXTENSION / "package.json").read_text())["contributes"]
    assert (EXTENSION / contributed["grammars"][0]["path"]).exists()
    assert (EXTENSION / contributed["languages"][0]["configuration"]).exists()
    taken = {field.name for field in fields(Launch)} - {"noDebug"}
    assert contributed["debuggers"][0]["configurationAttributes"]["launch"]["properties"].keys() == taken
