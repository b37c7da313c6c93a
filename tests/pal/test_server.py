"""`pal --lsp`, and the document that knows its answers.

A real client (pytest-lsp) holds the conversations of editor/ with the server.
"""

import asyncio
import json
import random
import re
from io import BytesIO
from itertools import product
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lsprotocol import types as lsp
from lsprotocol.converters import get_converter
from pygls.exceptions import JsonRpcException
from pytest_lsp import make_test_lsp_client

import pal
from pal import server
from pal.document import Document
from pal.fixes import fixes
from pal.formatting import formatted
from pal.messages import COLON, MEANT, NO_SLASH, NOT_OCTAL
from pal.text import Text
from pal.workspace import Workspace
from pdp8 import shelf
from tests.commands import environment, run
from tests.conftest import awaited, case

FOLDER = "file:///tmp"
URI = f"{FOLDER}/loop.pal"
CONVERSATIONS = Path(__file__).parent / "editor"
"""A file is a conversation with one server. Its first line says how it begins. Then each line asks, and the
next is the answer, or what is published; of completions the first four."""


async def _answers(began: dict[str, Any], asked: list[str]) -> list[Any]:
    """Return what the server answers, as JSON has it; to a notification, what it publishes."""
    client = make_test_lsp_client()
    await client.start_io("pal", "--lsp", *began.pop("arguments", ()), env=environment())
    convert: Any = get_converter()
    start = {"processId": None, "rootUri": FOLDER, "capabilities": {}, **began}
    begun = await client.initialize_session(convert.structure(start, lsp.InitializeParams))
    assert begun.server_info == lsp.ServerInfo("pal", "1")
    protocol: Any = client.protocol
    answers: list[Any] = []
    for question in asked:
        feature, _, given = question.partition(" ")
        params = json.loads(given)
        method = feature if feature.startswith("workspace/") else f"textDocument/{feature}"
        if method.startswith("textDocument/"):
            params["textDocument"] = {"uri": URI, **params.get("textDocument", {})}
        uri = params.get("textDocument", {}).get("uri", URI)
        request = convert.structure(params, lsp.METHOD_TO_TYPES[method][2])
        try:
            if "did" in feature or feature == "workspace/executeCommand":
                (protocol.notify if "did" in feature else protocol.send_request)(method, request)
                await protocol.send_request_async(lsp.WORKSPACE_SYMBOL, lsp.WorkspaceSymbolParams("?"))
                answers.append(client.diagnostics[uri])
            else:
                answers.append(await protocol.send_request_async(method, request))
        except JsonRpcException as error:
            answers.append(error.message)
    await client.shutdown_session()
    assert client._server
    assert client._server.returncode == 0
    await client.stop()  # type: ignore[no-untyped-call]
    return [convert.unstructure(answer) for answer in answers]


@pytest.mark.parametrize("name", sorted(file.stem for file in CONVERSATIONS.glob("*.txt")))
def test_an_editor_is_answered(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    began, *lines = (CONVERSATIONS / f"{name}.txt").read_text("utf-8").split("\n")[:-1]
    asked = lines[::2]
    answers = awaited(asyncio.wait_for(_answers(json.loads(began), asked), 120))
    for question, expected, answer in zip(asked, lines[1::2], answers, strict=True):
        with case(question):
            assert (answer[:4] if "completion" in question else answer) == json.loads(expected)
    assert capsys.readouterr().err == "", "what the client passes on"


def one(text: str, dialect: str = "pal3") -> Document:
    """Return the document of a program of one tape."""
    return Document([Text(text)], ["x.pal"], dialect)


def test_what_is_known_is_the_dialects() -> None:
    first, later = (one(f"*200\n\tTAD {five}\n\tRAR\n$\n", "auto") for five in ("5", "(5)"))
    only = later.known.keys() - first.known.keys()
    assert {"PAGE", "TEXT", "IFDEF", "BSW", "CDF", "SKON"} <= only
    assert first.known.keys() - later.known.keys() == {name for name in first.known if name[:2] == "MM"}
    assert later.known["BSW"] == "7002, no instruction of a PDP-8/L"
    assert later.hover(0, 2, 2) == first.hover(0, 2, 2)
    assert later.hover(0, 1, 2).startswith("`1000  TAD: add the word")
    for known in (first, later):
        for name, _, said in known.completions(0, 1, 0):
            assert said in one(f"\t{name}\n", known.dialect).hover(0, 0, 1), name


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
    known = one(DOCUMENT.rstrip().replace("\n", "\r\n"), "pal8")
    named = [known.name_at(0, 0, column) for column in range(9)]
    assert named == ["A1", "A1", "A1", "", "", "B", "B", "", ""]
    assert [known.name_at(0, *at) for at in ((4, 5), (5, 9), (5, 11), (12, 0))] == ["", "LONGNA", "B", ""]
    defined = [(each.name, each.kind, each.value) for each in known.definitions]
    assert defined == [("A1", "tag", 0o200), ("B", "value", 5), ("LONGNA", "tag", 0o201)]
    assert known.folds(0) == [(3, 5, False), (7, 10, False), (1, 2, True), (9, 10, True)]
    assert known.hover(0, 0, 5) == "`B` = 0005, defined in line 1, used 1 time  \n`A1,1;B= 5`  \n`0200  0001`"
    assert known.hover(0, 8, 1).endswith("used 1 time  \n`A1,1;B= 5`  \n`0400  0200`  \n`0401  7041`")
    assert known.hover(0, 5, 0).startswith(
        "`LONGNA` = 0201, defined in line 6, used 0 times  \n`LONGNAME1,\tb`"
    )
    assert one("A=1\nA=2\n\tA\n$\n").hover(0, 2, 1).endswith("used 1 time  \n`A=1`  \n`0200  0002`")
    assert (known.hover(0, 3, 0), one("*200\n").folds(0)) == ("", [])


TAPES = (
    "*200\n\tJMS A\n\tHLT\n/ONE\n/TWO\nA,\t0\n\tTAD N\n\tJMP I A\nN,\t5\nX=3\nPAUSE\n",
    "*400\nB,\t0\n\tJMS B\n/END\n\tJMP I B\nPAUSE\n",
)


def test_of_a_tape_beside_another_is_known_what_is_known_of_it_alone() -> None:
    """Whichever comes first, as they share no symbol."""
    alone = [one(text) for text in TAPES]
    for order in ((0, 1), (1, 0)):
        both = Document([Text(TAPES[at]) for at in order], [f"{at}" for at in order])
        for tape, at in enumerate(order):
            with case(order, at):
                other = alone[at]
                assert both.folds(tape) == other.folds(0)
                assert [*both.hints(tape)] == [*other.hints(0)]
                tokens = [(span[1:], *more) for span, *more in both.tokens(tape)]
                assert tokens == [(span[1:], *more) for span, *more in other.tokens(0)]
                for line, text in enumerate(other.tapes[0]):
                    for column in range(len(text)):
                        assert both.hover(tape, line, column) == other.hover(0, line, column)


MARKED = """\
*200
\tJMS SUB
\tJMS V
\tTAD NIX
SUB,\t0
\tHLT
V=300
/ <a
/ b>
\tTEXT '<'
\tTEXT '>'; BSW
IFZERO 0 < /C
\tTEXT 'A' >
>
>
Q=R
$
"""


def test_a_document_knows_what_is_no_code_and_what_is_not_defined() -> None:
    known = one(MARKED, "pal8")
    assert [each.name for each in known.definitions] == ["SUB", "V"], "Q gets no value"
    assert [(each.entry.name, each.first, each.last) for each in known.routines] == [("SUB", 4, 4)]
    assert known.folds(0) == [(0, 16, False), (11, 12, False), (7, 8, True)]
    places = [(3, 8), (7, 2), (9, 9), (10, 9), (10, 10), (18, 0)]
    assert [bool(known.completions(0, *at)) for at in places] == [True, False, False, False, True, True]
    tokens = {MARKED.split("\n")[at.line][at.start : at.end]: kind for at, kind, _ in known.tokens(0)}
    assert (tokens["NIX"], tokens["V"], tokens["HLT"]) == ("function", "variable", "keyword")
    assert known.hover(0, 10, 12).startswith("`BSW: 7002, no instruction of a PDP-8/L`")
    assert known.hover(0, 3, 6).startswith("`0202  1000`"), "nothing is known of NIX"
    assert one("*200\n\tTAD B\n$\n").hover(0, 1, 5).startswith("`B` = 0377, used 1 time  \n`0200  1377`")
    two = Document([Text("*200\n\tTAD NIX\n"), Text("\tHLT\n$\n")], ["a.pal", "b.pal"])
    assert [[each.code for each in two.found(tape)] for tape in (0, 1)] == [["UA"], []]


def test_a_new_name_is_what_its_first_six_characters_are() -> None:
    source = one("*200\nCOUNTA,\t0\nB,\tTAD COUNTA\n$\n")
    assert source.refusal("B", "COUNTAX") == "COUNTA is taken: it is in line 2"
    assert source.refusal("B", "EXPUNGE") == "EXPUNG is taken: it is a permanent symbol of PAL III"
    assert source.refusal("COUNTA", "COUNTAX") == ""


def test_a_line_of_another_tape_is_named_with_it() -> None:
    both = Document([Text("*200\nA,\t0\nPAUSE\n"), Text("B,\tJMS A\n$\n")], ["a.pal", "b.pal"])
    for tape, other, place in ((0, "B", "line 1 of b.pal"), (1, "B", "line 1"), (1, "A", "line 2 of a.pal")):
        assert both.refusal("AB"[other == "A"], other, tape) == f"{other} is taken: it is in {place}"
    assert both.hover(1, 0, 7).startswith("`A` = 0200, defined in line 2 of a.pal, used 1 time")
    assert both.hover(0, 1, 1).startswith("`A` = 0200, defined in line 2, used 1 time")


def test_a_place_behind_a_text_is_its_end() -> None:
    text = Text("A\nB")
    assert [text.column(line, 9) for line in range(3)] == [1, 1, 0]
    assert text.edited((2, 0), (9, 9), "C").content == "A\nBC"


def test_a_program_is_of_the_tapes_that_settings_name(tmp_path: Path) -> None:
    workspace = Workspace("pal3", lambda uri: "*200\n\tTAD NIX\n")
    workspace.name_programs([["a.pal", "b/a.pal"], ["x", 5], 7, "yz"], "/tmp")
    tapes = [f"{FOLDER}/a.pal", f"{FOLDER}/b/a.pal"]
    assert workspace.tapes(tapes[1]) == tapes
    document, tape = workspace.document(tapes[1])
    assert (tape, {each.file for each in document.assembly.diagnostics}) == (1, {*tapes})
    for uri in (f"{FOLDER}/x", f"{FOLDER}/y", "untitled:a.pal", "file://host/tmp/a.pal"):
        assert workspace.tapes(uri) == [uri]
    workspace.name_programs([["a.pal", "b.pal"]], "/tmp")
    document, _ = workspace.document(tapes[0])
    assert {each.file for each in document.assembly.diagnostics} == {"a.pal", "b.pal"}
    workspace.name_programs({"programs": [["a.pal"]]}, "/tmp")
    assert workspace.tapes(tapes[0]) == tapes[:1]
    (tmp_path / "a%20 b").symlink_to(tmp_path, target_is_directory=True)
    (tmp_path / "b.pal").write_text("A=5\n$\n")
    workspace = Workspace("pal3", server.read)
    workspace.name_programs([["a.pal", "../a%20 b/b.pal"]], f"{tmp_path}/a%20 b")
    tapes = [(tmp_path / "a%20 b" / name).as_uri() for name in ("a.pal", "b.pal")]
    assert workspace.tapes(tapes[0]) == tapes, "an editor does not follow links"
    assert workspace.document(tapes[0])[0].assembly.symbols == {"A": 5}


class Asked:
    """A server without an editor: it keeps the answers to each request."""

    def __init__(self, **texts: str) -> None:
        self.answers: dict[str, Any] = {}
        self.published: list[str] = []
        self.read: list[str] = []
        self.workspace = SimpleNamespace(root_path="/tmp")
        workspace = Workspace("pal3", self._reads)
        workspace.open = {f"{FOLDER}/{name}.pal": Text(text) for name, text in texts.items()}
        server.Answers(cast(Any, self), workspace)

    def _reads(self, uri: str) -> str:
        self.read.append(uri)
        return ""

    def text_document_publish_diagnostics(self, params: lsp.PublishDiagnosticsParams) -> None:
        self.published.append(params.uri.rpartition("/")[2] + "!" * len(params.diagnostics))

    def feature(self, method: str, *_: object) -> Any:
        return lambda answer: self.answers.update({method: answer})

    command = feature

    def __call__(self, method: str, **given: Any) -> Any:
        document = lsp.TextDocumentIdentifier(f"{FOLDER}/a.pal")
        return self.answers[method](SimpleNamespace(text_document=document, **given))


def test_what_an_editor_need_not_send() -> None:
    """Settings of another kind, a change of a text that is not open, the tapes that are not open."""
    asked = Asked(a="*200\n\tTAD B\n", c="*200\n\tHLT\n$\n")
    configured, changed = asked.answers[lsp.WORKSPACE_DID_CHANGE_CONFIGURATION], lsp.TEXT_DOCUMENT_DID_CHANGE
    others: tuple[Any, ...] = (None, 7, {"pdp8": {}})
    for settings in others:
        configured(SimpleNamespace(settings=settings))
    assert asked.published == ["a.pal!!", "c.pal"] * 3
    asked.workspace.root_path = None
    configured(SimpleNamespace(settings={"programs": [[f"/tmp/{name}.pal" for name in "abc"]]}))
    asked.published.clear()
    asked(lsp.TEXT_DOCUMENT_DID_CLOSE)
    assert asked.published == ["a.pal", "c.pal"]
    insert = lsp.TextDocumentContentChangePartial(
        lsp.Range(lsp.Position(0, 0), lsp.Position(0, 0)), "\tTAD D\n"
    )
    asked(changed, content_changes=[insert])
    assert asked.published[2:] == ["a.pal!", "c.pal!"], "C's word lies on A's"


def test_a_program_of_which_no_tape_is_open_any_more_is_not_read() -> None:
    asked = Asked(a="*200\n\tHLT\n$\n")
    programs = {"programs": [["/tmp/a.pal", "/tmp/b.pal"]]}
    asked.answers[lsp.WORKSPACE_DID_CHANGE_CONFIGURATION](SimpleNamespace(settings=programs))
    assert asked.read == [f"{FOLDER}/b.pal"]
    asked(lsp.TEXT_DOCUMENT_DID_CLOSE)
    assert asked.read == [f"{FOLDER}/b.pal"]


def test_another_dialect_is_offered_for_what_has_an_error() -> None:
    everything = lsp.Range(lsp.Position(0, 0), lsp.Position(9, 0))
    for word, offered in (("HLT", []), ("TAD (5", ["Assemble it as PAL8"])):
        found = Asked(a=f"*200\n\t{word}\n")(lsp.TEXT_DOCUMENT_CODE_ACTION, range=everything)
        assert [each.title for each in found if isinstance(each, lsp.Command)] == offered


def test_what_is_within_a_subroutine_is_below_it_in_the_outline() -> None:
    """Each tag and value of its lines, the first and the last ones too, and no other."""
    sources = [shelf.read_bundled(name).decode() for name in shelf.bundled() if name.endswith(".pal")]
    for text in (*sources, "*200\nX,\tJMS A\n\tHLT\nA,\t0; P=1\nR,\tCLA\nB,\tJMP I A; Q=2 /😀\nC,\t5\n$\n"):
        outline = Asked(a=text)(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
        routines = [each for each in outline if each.kind == lsp.SymbolKind.Function]
        for each in (each for each in outline if each not in routines):
            assert not any(
                of.range.start.line <= each.range.start.line <= of.range.end.line for of in routines
            )
        for of in routines:
            lines = [each.range.start.line for each in of.children]
            assert all(of.range.start.line <= line <= of.range.end.line for line in lines), of.name
            end = of.range.end
            assert end.character == len(Text(text).lines[end.line].encode("utf-16-le")) / 2, of.name
        names = [each.name for of in outline for each in (of, *(of.children or ()))]
        assert sorted(names) == sorted(one(text).written(each.name) for each in one(text).definitions)


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


@pytest.mark.parametrize(
    ("lines", "dialect"), [("FIELD/\n\tHLT", "pal3"), ("\tHLT\nA=FIXMRI/PAGE", "pal3"), ("A +", "pal8")]
)
def test_what_columns_would_change_is_left(lines: str, dialect: str) -> None:
    """Its words, its symbols or what is said of it."""
    source = f"*200\n{lines}\n$\n"
    assert formatted(source, dialect) == source


def test_columns_leave_texts_alone() -> None:
    texts = '*200\n  CLA  /X\n TEXT "A / B"\n$\n'
    assert formatted(texts, "pal8") == '*200\n\tCLA\t\t/X\n TEXT "A / B"\n$\n'


ENDS = ("\n", "\r\n", "\r")
WORDS = st.text("A7 ,/\t\f\v\x85\u2028é€😀", max_size=6)
UNITS = {"utf-8": 1, "utf-16-le": 2, "utf-32-le": 4}
"""Python's codecs, which judge: bytes of a unit."""


@pytest.mark.parametrize("codec", UNITS)
def test_edits_that_an_editor_sends_change_the_text_as_they_change_a_string(codec: str) -> None:
    """The messages themselves, 300 of them: a library that changes them on the way is judged too."""
    assert edited_otherwise(codec, 300, 8) == ""


def edited_otherwise(codec: str, count: int, seed: int) -> str:
    """Send so many random edits of a source as JSON; return the first that went wrong, or ""."""
    draw = random.Random(seed)
    workspace = Workspace("pal3", lambda uri: "")
    protocol: Any = server.made(workspace).protocol
    protocol.set_writer(BytesIO())

    def send(method: str, params: dict[str, Any], **more: int) -> None:
        asked = {"jsonrpc": "2.0", "method": method, "params": params, **more}
        protocol.handle_message(protocol.structure_message(json.loads(json.dumps(asked))))

    encodings = {"general": {"positionEncodings": [codec.removesuffix("-le")]}}
    send("initialize", {"processId": None, "rootUri": None, "capabilities": encodings}, id=1)
    plain = ""
    document = {"uri": URI, "languageId": "pal", "version": 1, "text": plain}
    send("textDocument/didOpen", {"textDocument": document})
    changes: list[dict[str, Any]] = []
    for version in range(2, count + 2):
        first = draw.randint(0, len(plain))
        last = min(len(plain), first + draw.choice([draw.randint(0, 9), len(plain)]))
        if any(plain[at - 1 : at + 1] == "\r\n" for at in (first, last)):
            continue
        new = "".join(draw.choice([*ENDS, *"A7 ,/\t\f\v\x85\u2028é€😀"]) for _ in range(draw.randint(0, 20)))
        ends = [
            dict(zip(("line", "character"), place(plain, at, codec), strict=True)) for at in (first, last)
        ]
        changes.append({"range": {"start": ends[0], "end": ends[1]}, "text": new})
        if version % 20 == 0:  # an editor may send the whole text
            first, last, changes[-1] = 0, len(plain), {"text": new}
        plain = plain[:first] + new + plain[last:]
        if version % 3:  # else it is sent with the next
            told = {"textDocument": {"uri": URI, "version": version}, "contentChanges": changes}
            send("textDocument/didChange", told)
            if workspace.open[URI].content != plain:
                return f"{changes} made {workspace.open[URI].content!r}, not {plain!r}"
            changes = []
    return ""


def place(plain: str, at: int, codec: str) -> tuple[int, int]:
    """Return the line and the character of a place in a string, as an editor counts."""
    before = plain[:at].replace("\r\n", "\n").replace("\r", "\n")
    line = before.rpartition("\n")[2]
    return before.count("\n"), len(line.encode(codec)) // UNITS[codec]


@pytest.mark.parametrize("codec", UNITS)
@given(line=WORDS, data=st.data())
def test_a_column_and_back(codec: str, line: str, data: st.DataObject) -> None:
    text, column = Text(line, codec.removesuffix("-le")), data.draw(st.integers(0, len(line)))
    character = text.character(0, column)
    assert character == len(line[:column].encode(codec)) // UNITS[codec]
    assert text.column(0, character) == column


SPACED = st.lists(st.text('A7 ,/;=*$"\t\f\v(', max_size=12), max_size=8)


@given(lines=SPACED, dialect=st.sampled_from(["pal3", "pal8"]))
def test_formatting_moves_blanks_alone_and_once(lines: list[str], dialect: str) -> None:
    source = "\r\n".join(lines)
    once = formatted(source, dialect)
    blanks = {ord(" "): None, ord("\t"): None}
    assert once.translate(blanks) == source.translate(blanks)
    assert formatted(once, dialect) == once
    assert pal.assemble(once, dialect=dialect).words == pal.assemble(source, dialect=dialect).words


def test_what_is_no_request_is_answered_as_an_error_and_the_session_goes_on() -> None:
    requests: list[dict[str, Any]] = [
        {"id": 1, "method": "initialize", "params": {"processId": None, "rootUri": None, "capabilities": {}}},
        {"id": 2, "method": "textDocument/hover", "params": {"textDocument": 7}},
        {"id": 3, "method": "textDocument/definition"},
        {"method": "textDocument/didOpen", "params": {"textDocument": 7}},
        {"id": 9},
        {"id": 4, "method": "textDocument/foldingRange", "params": {"textDocument": {"uri": URI}}},
        {"id": 5, "method": "shutdown"},
        {"method": "exit"},
    ]
    contents = [json.dumps({"jsonrpc": "2.0", **each}).encode() for each in requests]
    contents[1:1] = [b"{", b"[]"]
    sent = b"".join(b"Content-Length: %d\r\n\r\n%b" % (len(content), content) for content in contents)
    done = run("pal", "--lsp", stdin=sent)
    assert (done.returncode, done.stderr) == (0, b"")
    answers = re.findall(
        r'"code": (-?\d+).*?"id": (\d)|"id": (\d), "jsonrpc": "2.0", "result"', done.stdout.decode()
    )
    assert answers == [("", "", "1"), ("-32602", "2", ""), ("-32602", "3", ""), ("", "", "4"), ("", "", "5")]


FIXES: dict[str, dict[str, list[str]]] = {
    "START CLA": {"UA": ["Write START, as a tag", "Define START"]},
    "START\tCLA": {"UA": ["Write START, as a tag", "Define START"]},
    "START(CLA": {"UA": ["Define START"]},
    " START CLA": {"UA": ["Define START"]},
    "\tTDA 200": {"UA": ["Define TDA"], MEANT: ["Write TAD"]},
    "\t\x7fTDA 200": {"UA": [], MEANT: ["Write TAD"]},
    "\tTAD 18": {NOT_OCTAL: ["Write 22, octal for 18"]},
    "\tTAD 1\x7f8": {NOT_OCTAL: []},
    "NIX ONE OR TWO": {NO_SLASH: ["Make it a comment"]},
    "A:\tCLA": {COLON: ["End the tag with a comma"]},
    "\tJMP FAR": {"IR": ["Go through a pointer, PFAR"]},
    "\tJMP  FAR ; CLA": {"IR": ["Go through a pointer, PFAR"]},
    "\tJMP 400\t/FAR": {"IR": ["Go through a pointer, P400"]},
    "\tJMP FAR+1": {"IR": []},
    "\tJMP .+200": {"IR": []},
    "\tJMP FAR 1": {"IR": []},
    "\tJMP I FAR": {"IR": []},
}


@pytest.mark.parametrize("line", FIXES)
def test_what_mends_a_line_is_offered(line: str) -> None:
    document = one(f"*200\n{line}\n*400\nFAR,\tHLT\n$\n")
    for code, titles in FIXES[line].items():
        found = next(each for each in document.found(0) if each.code == code)
        assert [each.title for each in fixes(document, 0, found)] == titles


def test_a_pointer_is_offered_unless_its_name_is_taken() -> None:
    for name, offered in (("QFAR", 1), ("PFAR", 0)):
        document = one(f"*200\n\tJMP FAR\n{name},\t0\n*400\nFAR,\tHLT\n$\n")
        (found,) = (each for each in document.found(0) if each.code == "IR")
        assert len([*fixes(document, 0, found)]) == offered


PAGES = (
    "*200\n{}\n\tHLT\n*400\nFAR,\tHLT\n$\n",
    "*200\n{}\n\tHLT\nPAGE\nFAR,\tHLT\n$\n",
    "*400\nFAR,\tHLT\n*200\n{}\nPAGE,\tCLA\n\tHLT\n$\n",
    "*400\nFAR,\tHLT\n*200; {}\n\tHLT\n$\n",
    "*400\nFAR,\tHLT\n*200\n{}\n\tHLT",
    "*400\nFAR,\tHLT\n*200\n\tHLT\n{}",
    "*400\nFAR,\tHLT\n*200\n{}\n\tHLT\t/5 $\n\tHLT;$",
)
"""Where the page of a line ends: at an origin, at PAGE, which may be a tag, at the $, at nothing."""


@pytest.mark.parametrize("dialect", ["pal3", "pal8"])
def test_what_is_offered_mends_the_line_and_moves_no_other(dialect: str) -> None:
    for page, line in product(PAGES, (*FIXES, "\tTAD NIX")):
        before = one(page.format(line.replace("\x7f", "")), dialect)
        words, said = before.assembly.words, [each.code for each in before.found(0)]
        for found in before.found(0):
            own = {each.address for each in before.assembly.lines if each.number == found.line}
            for title, edits in fixes(before, 0, found):
                with case(page, line, title):
                    text = before.texts[0]
                    for span, new in sorted(edits, reverse=True):
                        text = text.edited((span.line, span.start), (span.line, span.end), new)
                    after = one(text.content, dialect)
                    left = [each.code for each in after.found(0)]
                    assert left.count(found.code) < said.count(found.code)
                    assert len(after.assembly.words) <= len(words) + 1, "no link is needed"
                    assert {code for code in left if code[:2] == "PN"} <= {*said, "PN36"}
                    if found.code == NO_SLASH:
                        assert found.line not in [each.line for each in after.found(0) if each.error]
                    else:
                        there = after.assembly.words.items()
                        assert {(at, word) for at, word in words.items() if at not in own} <= {*there}
