"""`pal --lsp`, asked by a real client (pytest-lsp): what an editor shows is what `pal` says."""

import asyncio
import json
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pytest_lsp import make_test_lsp_client

import pal
from pal.document import Document, formatted
from tapes import shelf
from tests.commands import run, warm_environment
from tests.conftest import awaited

SOURCE = """\
/ TWO COMMENTS
/ ABOVE
COUNT=20
*200
START, CLA CMA IAC
\tDCA COUNT /KEEP
LOOP,\tTAD I 10
\tISZ COUNT
\tJMP LOOP
\tJMP CUONT
$
"""
URI = "file:///tmp/loop.pal"
HERE = lsp.TextDocumentIdentifier(URI)


async def _ask(folder: Path) -> dict[str, Any]:
    client = make_test_lsp_client()
    await client.start_io("pal", "--lsp", env=warm_environment())
    await client.initialize_session(
        lsp.InitializeParams(capabilities=lsp.ClientCapabilities(), root_uri=folder.as_uri())
    )
    client.text_document_did_open(lsp.DidOpenTextDocumentParams(lsp.TextDocumentItem(URI, "pal", 1, SOURCE)))
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    found: dict[str, Any] = {"diagnostics": list(client.diagnostics[URI])}

    def at(line: int, column: int) -> dict[str, Any]:
        return {"text_document": HERE, "position": lsp.Position(line, column)}

    for name, line, column in (("or", 4, 9), ("tad", 6, 6), ("count", 5, 7), ("comment", 5, 12)):
        hover = await client.text_document_hover_async(lsp.HoverParams(**at(line, column)))
        found[f"hover {name}"] = hover and hover.contents.value  # type: ignore[union-attr]
    found["definition"] = await client.text_document_definition_async(lsp.DefinitionParams(**at(8, 6)))
    context = lsp.ReferenceContext(include_declaration=True)
    found["references"] = await client.text_document_references_async(
        lsp.ReferenceParams(context=context, **at(5, 6))
    )
    found["rename"] = await client.text_document_rename_async(lsp.RenameParams(new_name="TALLY", **at(5, 6)))
    with pytest.raises(JsonRpcException, match="LOOP is taken: it stands in line 7"):
        await client.text_document_rename_async(lsp.RenameParams(new_name="LOOP", **at(5, 6)))
    found["completion"] = await client.text_document_completion_async(lsp.CompletionParams(**at(8, 1)))
    found["symbols"] = await client.text_document_document_symbol_async(lsp.DocumentSymbolParams(HERE))
    found["folding"] = await client.text_document_folding_range_async(lsp.FoldingRangeParams(HERE))
    options = lsp.FormattingOptions(tab_size=8, insert_spaces=False)
    found["format"] = await client.text_document_formatting_async(lsp.DocumentFormattingParams(HERE, options))
    client.text_document_did_change(
        lsp.DidChangeTextDocumentParams(
            lsp.VersionedTextDocumentIdentifier(2, URI),
            [lsp.TextDocumentContentChangeWholeDocument("*200\n\tHLT\n$\n")],
        )
    )
    await client.wait_for_notification(lsp.TEXT_DOCUMENT_PUBLISH_DIAGNOSTICS)
    found["mended"] = list(client.diagnostics[URI])
    await client.shutdown_session()
    await client.stop()  # type: ignore[no-untyped-call]
    return found


REFUSED = {
    "START": "START is taken: it stands in line 5",
    "CUONT": "CUONT is taken: it stands in line 10",
    "TAD": "TAD is taken: it is a permanent symbol of PAL III",
    "EXPUNG": "EXPUNG is taken: it is a permanent symbol of PAL III",
    "9X": "'9X' is no symbol: a letter, then letters and digits",
    "A B": "'A B' is no symbol: a letter, then letters and digits",
    "tally": "tally has small letters: PAL III knows capitals only",
    "LOOP": "",
    "BSW": "",
}


def test_a_name_that_is_taken_or_none_is_refused_by_name() -> None:
    document = Document(SOURCE, "loop.pal")
    assert {new: document.refusal("LOOP", new) for new in REFUSED} == REFUSED
    assert document.refusal("TAD", "X") == "TAD is no symbol that this source defines"
    later = Document("*200\nLOOPER,\tTAD (5)\n\tJMP LOOPER\n$\n", "loop.pa")
    assert later.refusal("LOOPER", "BSW") == "BSW is taken: it is a permanent symbol of PAL8"
    assert [later.refusal("LOOPER", new) for new in ("loop", "LOOPERS")] == ["", ""]


def test_what_is_known_is_the_dialects() -> None:
    first, later = (Document(f"*200\n\tTAD {five}\n\tRAR\n$\n", "a.pa") for five in ("5", "(5)"))
    only = later.known.keys() - first.known.keys()
    assert {"PAGE", "TEXT", "IFDEF", "BSW", "CDF", "SKON"} <= only
    assert first.known.keys() - later.known.keys() == {name for name in first.known if name[:2] == "MM"}
    assert later.known["BSW"] == "7002, no instruction of a PDP-8/L"
    assert later.hover(2, 2) == first.hover(2, 2)
    assert later.hover(1, 2).startswith("`1000  TAD: add the word")


def test_a_session_ends_in_silence() -> None:
    messages: list[dict[str, Any]] = [
        {"id": 1, "method": "initialize", "params": {"processId": None, "rootUri": None, "capabilities": {}}},
        {"method": "initialized", "params": {}},
        {"id": 2, "method": "shutdown"},
        {"method": "exit"},
    ]
    sent = [json.dumps({"jsonrpc": "2.0", **message}) for message in messages]
    ended = run("pal", "--lsp", stdin="".join(f"Content-Length: {len(m)}\r\n\r\n{m}" for m in sent).encode())
    assert (ended.returncode, ended.stderr) == (0, b"")
    assert b'"id": 2' in ended.stdout


def spans(places: list[Any]) -> list[tuple[int, int, int]]:
    ranges = [place.range for place in places]
    return [(each.start.line, each.start.character, each.end.character) for each in ranges]


def test_an_editor_asks_for_all_there_is(tmp_path: Path) -> None:
    found = awaited(asyncio.wait_for(_ask(tmp_path), 120))
    (tmp_path / "loop.pal").write_text(SOURCE)
    run("pal", "loop.pal", "--force", "--json", "loop.json", folder=tmp_path)
    said = json.loads((tmp_path / "loop.json").read_text())["diagnostics"]
    starts = [(each.range.start, each.code) for each in found["diagnostics"]]
    shown = [(start.line + 1, start.character + 1, code) for start, code in starts]
    assert shown == [(each["line"], each["column"], each["code"]) for each in said]
    assert shown[0] == (10, 6, "UA")
    assert {each.source for each in found["diagnostics"]} == {"pal"}
    assert "complement the AC; increment the AC" in found["hover or"]
    assert "1 cycle, 1.6 µs" in found["hover or"]
    assert "0010 holds the address, and is incremented first" in found["hover tad"]
    assert "3 cycles, 4.8 µs" in found["hover tad"]
    assert "`COUNT` = 0020, defined in line 3, used 2 times" in found["hover count"]
    assert found["hover comment"] is None
    assert spans(found["definition"]) == [(6, 0, 4)]
    places = [(2, 0, 5), (5, 5, 10), (7, 5, 10)]
    assert spans(found["references"]) == places
    assert spans(found["rename"].changes[URI]) == places
    offered = {
        item.label: (lsp.CompletionItemKind(item.kind).name, item.detail) for item in found["completion"]
    }
    assert [offered["LOOP"], offered["COUNT"]] == [("Function", "0202"), ("Constant", "0020")]
    assert offered["I"] == ("Keyword", "indirect: the word there holds the address")
    assert {"TAD", "FIELD", "Z"} <= offered.keys()
    assert [(each.name, each.detail, lsp.SymbolKind(each.kind).name) for each in found["symbols"]] == [
        ("COUNT", "0020", "Constant"),
        ("START", "0200", "Function"),
        ("LOOP", "0202", "Function"),
    ]
    assert [(each.start_line, each.end_line) for each in found["folding"]] == [(3, 10), (0, 1)]
    assert found["format"][0].new_text.splitlines()[4:6] == ["START,\tCLA CMA IAC", "\tDCA COUNT\t/KEEP"]
    assert found["mended"] == []


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
    assert (known.hover(3, 0), Document("*200\n", "x.pal").folds()) == ("", [])


@pytest.mark.parametrize("name", ["eia.pal", "echo.pal", "hello.pal"])
def test_columns_change_no_word(name: str) -> None:
    source = shelf.read(name).decode().replace("\t", "  ")
    text = formatted(source, "pal3")
    assert text != source
    assert pal.assemble(text).words == pal.assemble(source).words
    assert formatted(text, "pal3") == text


def test_columns_leave_texts_alone() -> None:
    source = '*200\n  CLA  /X\n TEXT "A / B"\n$\n'
    assert formatted(source, "pal8") == '*200\n\tCLA\t\t/X\n TEXT "A / B"\n$\n'


COLUMNS = {
    "  /C": "  /C",
    "*200 /X": "*200\t\t\t/X",
    "A , TAD 5/Y": "A ,\tTAD 5\t\t/Y",
    " CLA CLL CMA CML RAL/L?": "\tCLA CLL CMA CML RAL\t/L?",
    " CLA CLL CMA CML /L": "\tCLA CLL CMA CML\t/L",
    " \t": "",
    "BB = 6/W": "BB = 6\t\t\t/W",
    "LONGTAG,LONGER,5": "LONGTAG,\tLONGER,5",
    "\tHLT  \r": "\tHLT\r",
    "1234567/Q": "\t1234567\t\t/Q",
    "12345670 /R": "\t12345670\t/R",
    "$": "$",
}
"""Lines, and what they are in columns of eight."""


def test_each_line_is_put_in_columns() -> None:
    assert formatted("\n".join(COLUMNS), "pal3").split("\n") == list(COLUMNS.values())
