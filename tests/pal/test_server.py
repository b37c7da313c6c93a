"""`pal --lsp`, and the document that knows its answers.

editor.txt is a conversation as the protocol's specification has it: a line asks, the next is the answer, or
what is published then; of completions the first four. A real client (pytest-lsp) holds it.
"""

import asyncio
import json
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types as lsp
from lsprotocol.converters import get_converter
from pygls.exceptions import JsonRpcException
from pytest_lsp import make_test_lsp_client

import pal
from pal.document import Document, formatted
from pdp8 import shelf
from tests.commands import environment
from tests.conftest import awaited, case

URI = "file:///tmp/loop.pal"


async def _answers(asked: list[str]) -> list[Any]:
    """Return what the server answers, as JSON has it; to a notification, what it publishes."""
    client = make_test_lsp_client()
    await client.start_io("pal", "--lsp", env=environment())
    begun = await client.initialize_session(lsp.InitializeParams(capabilities=lsp.ClientCapabilities()))
    assert begun.server_info == lsp.ServerInfo("pal", "1")
    protocol: Any = client.protocol
    convert: Any = get_converter()
    answers: list[Any] = []
    for question in asked:
        feature, _, given = question.partition(" ")
        params = json.loads(given)
        method = f"textDocument/{feature}"
        content = {**params, "textDocument": {"uri": URI, **params.get("textDocument", {})}}
        request = convert.structure(content, lsp.METHOD_TO_TYPES[method][2])
        try:
            if feature.startswith("did"):
                protocol.notify(method, request)
                await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
                answers.append(client.diagnostics[URI])
            else:
                answers.append(await protocol.send_request_async(method, request))
        except JsonRpcException as error:
            answers.append(error.message)
    await client.shutdown_session()
    assert client._server
    assert client._server.returncode == 0
    await client.stop()  # type: ignore[no-untyped-call]
    return [convert.unstructure(answer) for answer in answers]


CONVERSATION = (Path(__file__).parent / "editor.txt").read_text("utf-8").splitlines()


def test_an_editor_is_answered(capsys: pytest.CaptureFixture[str]) -> None:
    asked = CONVERSATION[::2]
    answers = awaited(asyncio.wait_for(_answers(asked), 120))
    for question, expected, answer in zip(asked, CONVERSATION[1::2], answers, strict=True):
        with case(question):
            assert (answer[:4] if "completion" in question else answer) == json.loads(expected)
    assert capsys.readouterr().err == "", "what the client passes on"


def test_what_is_known_is_the_dialects() -> None:
    first, later = (Document(f"*200\n\tTAD {five}\n\tRAR\n$\n", "a.pa") for five in ("5", "(5)"))
    only = later.known.keys() - first.known.keys()
    assert {"PAGE", "TEXT", "IFDEF", "BSW", "CDF", "SKON"} <= only
    assert first.known.keys() - later.known.keys() == {name for name in first.known if name[:2] == "MM"}
    assert later.known["BSW"] == "7002, no instruction of a PDP-8/L"
    assert later.hover(2, 2) == first.hover(2, 2)
    assert later.hover(1, 2).startswith("`1000  TAD: add the word")


DOCUMENT = """\
A1,1;B= 5
/ONE
  /TWO
*200
CIA /A1 IS
LONGNAME1,\tb
*300
*400
A1;7041
/3
/4
"""


def test_a_document_knows_what_stands_where() -> None:
    known = Document(DOCUMENT.rstrip().replace("\n", "\r\n"), "x.pal", "pal8")
    assert [known.name_at(0, column) for column in range(9)] == ["A1", "A1", "A1", "", "", "B", "B", "", ""]
    assert [known.name_at(*at) for at in ((4, 5), (5, 9), (5, 11), (12, 0))] == ["", "LONGNA", "B", ""]
    defined = [(each.name, each.kind, each.value) for each in known.definitions]
    assert defined == [("A1", "tag", 0o200), ("B", "value", 5), ("LONGNA", "tag", 0o201)]
    assert known.folds() == [(3, 5, False), (7, 10, False), (1, 2, True), (9, 10, True)]
    assert known.hover(0, 5) == "`B` = 0005, defined in line 1, used 1 time  \n`A1,1;B= 5`  \n`0200  0001`"
    assert known.hover(8, 1).endswith("used 1 time  \n`A1,1;B= 5`  \n`0400  0200`  \n`0401  7041`")
    assert known.hover(5, 0).startswith("`LONGNA` = 0201, defined in line 6, used 0 times  \n`LONGNAME1,\tb`")
    assert (
        Document("A=1\nA=2\n\tA\n$\n", "x.pal").hover(2, 1).endswith("used 1 time  \n`A=1`  \n`0200  0002`")
    )
    assert (known.hover(3, 0), Document("*200\n", "x.pal").folds()) == ("", [])


COLUMNS = {
    "  /C": "  /C",
    "*200 /X": "*200\t\t\t/X",
    "A , TAD 5/Y": "A ,\tTAD 5\t\t/Y",
    " CLA CLL CMA CML RAL/L?": "\tCLA CLL CMA CML RAL\t/L?",
    " CLA CLL CMA CML /L": "\tCLA CLL CMA CML\t/L",
    " \t": "",
    "BB = 6/W": "BB = 6\t\t\t/W",
    "TEXTS, 5/Y": "TEXTS,\t5\t\t/Y",
    "LONGTAG,LONGER,5": "LONGTAG,\tLONGER,5",
    "\tHLT  \r": "\tHLT\r",
    "1234567/Q": "\t1234567\t\t/Q",
    "12345670 /R": "\t12345670\t/R",
    "$": "$",
}
"""Lines, and what they are in columns of eight."""


def test_each_line_is_put_in_columns_and_no_word_changes() -> None:
    assert formatted("\n".join(COLUMNS), "pal3").split("\n") == list(COLUMNS.values())
    for name in ("eia.pal", "echo.pal", "hello.pal"):
        spaced = shelf.read(name).decode().replace("\t", "  ")
        text = formatted(spaced, "pal3")
        assert text != spaced
        assert formatted(text, "pal3") == text
        assert pal.assemble(text).words == pal.assemble(spaced).words


def test_columns_leave_texts_alone() -> None:
    texts = '*200\n  CLA  /X\n TEXT "A / B"\n$\n'
    assert formatted(texts, "pal8") == '*200\n\tCLA\t\t/X\n TEXT "A / B"\n$\n'
    other_words = "*200\n CLA\n ASCII .A /B.\n$\n"
    assert formatted(other_words, "pal8") == other_words
