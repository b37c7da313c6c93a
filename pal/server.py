"""The language server: answers an editor about sources, by the Language Server Protocol, on standard streams.

`pal --lsp` starts it. It needs pygls (pip install "pdp8[lsp]"), which reads and writes the messages. The
answers come from document.py, about the texts of workspace.py.

The setting `programs` lists the tapes of each program of several tapes, [["main.pal", "tables.pal"]]. It
is read from initializationOptions, or from `pdp8` of workspace/didChangeConfiguration.
"""

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer
from pygls.protocol import LanguageServerProtocol, lsp_method

from pal.assembly import PAL3, PAL8
from pal.diagnostics import Diagnostic
from pal.document import KINDS, TAG, VALUE, Definition, Document, Span
from pal.fixes import fixes
from pal.formatting import formatted
from pal.text import Text, path_of
from pal.workspace import Workspace

_VERSION = "1"
_TAKE_AS = "pal.dialect"
_Placed = (
    lsp.HoverParams
    | lsp.DefinitionParams
    | lsp.ReferenceParams
    | lsp.RenameParams
    | lsp.PrepareRenameParams
    | lsp.DocumentHighlightParams
)
_COMPLETED = {
    TAG: lsp.CompletionItemKind.Function,
    VALUE: lsp.CompletionItemKind.Constant,
    "": lsp.CompletionItemKind.Keyword,
}
_SYMBOLS = {TAG: lsp.SymbolKind.Field, VALUE: lsp.SymbolKind.Constant}
_SEVERITIES = {True: lsp.DiagnosticSeverity.Error, False: lsp.DiagnosticSeverity.Warning}
_LEGEND = lsp.SemanticTokensLegend(token_types=list(KINDS), token_modifiers=["declaration"])


class _Protocol(LanguageServerProtocol):
    """Messages as pygls reads them; a request with parameters of another shape is answered as an error."""

    def structure_message(self, data: dict[str, Any]) -> Any:
        try:
            return super().structure_message(data)
        except JsonRpcException as error:
            if "method" in data and "id" in data:
                self._send_response(data["id"], error=error.to_response_error())
            raise

    @lsp_method(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def lsp_text_document__did_change(self, params: lsp.DidChangeTextDocumentParams) -> Iterator[Any]:
        """Leave the text to Answers: pygls ends lines at form feeds too, and moves the places into those."""
        yield self.fm.features[lsp.TEXT_DOCUMENT_DID_CHANGE], (params,), None


def made(workspace: Workspace) -> LanguageServer:
    """Return a server of the documents that a workspace has."""
    server = LanguageServer("pal", _VERSION, protocol_cls=_Protocol)
    Answers(server, workspace)
    return server


def read(uri: str) -> str:
    """Return the text of a file that is not open; of one that cannot be read, none."""
    try:
        return Path(path_of(uri)).read_bytes().decode("utf-8", "replace")
    except OSError:
        return ""


_Answer = Callable[[Any], Any]


class Answers:
    """What the server answers to each request."""

    def __init__(self, server: LanguageServer, workspace: Workspace) -> None:
        self._server = server
        self._workspace = workspace
        answers: dict[str, _Answer] = {
            lsp.INITIALIZE: self._initialize,
            lsp.WORKSPACE_DID_CHANGE_CONFIGURATION: self._configured,
            lsp.TEXT_DOCUMENT_DID_OPEN: self._opened,
            lsp.TEXT_DOCUMENT_DID_CHANGE: self._changed,
            lsp.TEXT_DOCUMENT_DID_CLOSE: self._closed,
            lsp.TEXT_DOCUMENT_HOVER: self._hover,
            lsp.TEXT_DOCUMENT_DEFINITION: lambda params: self._locations(params, True),
            lsp.TEXT_DOCUMENT_REFERENCES: self._references,
            lsp.TEXT_DOCUMENT_DOCUMENT_HIGHLIGHT: self._highlights,
            lsp.TEXT_DOCUMENT_PREPARE_RENAME: self._prepare_rename,
            lsp.TEXT_DOCUMENT_RENAME: self._rename,
            lsp.TEXT_DOCUMENT_COMPLETION: self._completion,
            lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL: self._outline,
            lsp.WORKSPACE_SYMBOL: self._symbols,
            lsp.TEXT_DOCUMENT_FOLDING_RANGE: self._folding,
            lsp.TEXT_DOCUMENT_INLAY_HINT: self._hints,
            lsp.TEXT_DOCUMENT_FORMATTING: self._formatting,
        }
        for method, answer in answers.items():
            server.feature(method)(partial(answer))
        server.feature(lsp.TEXT_DOCUMENT_SEMANTIC_TOKENS_FULL, _LEGEND)(partial(self._tokens))
        kinds = lsp.CodeActionOptions(code_action_kinds=[lsp.CodeActionKind.QuickFix])
        server.feature(lsp.TEXT_DOCUMENT_CODE_ACTION, kinds)(partial(self._actions))
        server.command(_TAKE_AS)(partial(self._take_as))

    def _initialize(self, params: lsp.InitializeParams) -> None:
        """Take over the agreed settings: how characters are counted, and which programs exist."""
        workspace = self._server.workspace
        self._workspace.unit = str(getattr(workspace.position_encoding, "value", workspace.position_encoding))
        self._name_programs(params.initialization_options)

    def _configured(self, params: lsp.DidChangeConfigurationParams) -> None:
        settings: Any = params.settings
        self._name_programs(settings.get("pdp8", settings) if isinstance(settings, dict) else None)
        self._publish(self._workspace.open)

    def _name_programs(self, settings: Any) -> None:
        if isinstance(settings, dict) and "programs" in settings:
            self._workspace.name_programs(settings["programs"], self._server.workspace.root_path or ".")

    def _opened(self, params: lsp.DidOpenTextDocumentParams) -> None:
        given = params.text_document
        self._workspace.open[given.uri] = Text(given.text, self._workspace.unit)
        self._publish([given.uri])

    def _changed(self, params: lsp.DidChangeTextDocumentParams) -> None:
        uri = params.text_document.uri
        text = self._workspace.open.get(uri) or Text("", self._workspace.unit)
        for change in params.content_changes:
            if isinstance(change, lsp.TextDocumentContentChangePartial):
                start, end = ((at.line, at.character) for at in (change.range.start, change.range.end))
                text = text.edited(start, end, change.text)
            else:
                text = Text(change.text, text.unit)
        self._workspace.open[uri] = text
        self._publish([uri])

    def _closed(self, params: lsp.DidCloseTextDocumentParams) -> None:
        uri = params.text_document.uri
        others = [tape for tape in self._workspace.tapes(uri) if tape != uri and tape in self._workspace.open]
        self._workspace.close(uri)
        self._server.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, []))
        self._publish(others)

    def _publish(self, uris: Iterable[str]) -> None:
        """Send the diagnostics of the programs of these sources, to each of their tapes that is open."""
        for tapes in dict.fromkeys(tuple(self._workspace.tapes(uri)) for uri in uris):
            document, _ = self._workspace.document(tapes[0])
            for tape, uri in enumerate(tapes):
                if uri in self._workspace.open:
                    found = [self._diagnostic(document, tape, each) for each in document.found(tape)]
                    self._server.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, found))

    def _take_as(self, uri: str, dialect: str) -> None:
        """Carry out a quick fix: assemble a source in this dialect from now on."""
        self._workspace.chosen[self._workspace.tapes(uri)[0]] = dialect
        self._publish([uri])

    def _diagnostic(self, document: Document, tape: int, found: Diagnostic) -> lsp.Diagnostic:
        span = Span(tape, found.line - 1, found.column - 1, found.end_column - 1)
        said = "\n".join(each for each in (found.message, found.advice, found.hint) if each)
        where, severity = self._range(document, span), _SEVERITIES[found.error]
        return lsp.Diagnostic(where, said, severity, code=found.code, source="pal")

    def _range(self, document: Document, span: Span) -> lsp.Range:
        first, last = document.characters(span)
        return lsp.Range(lsp.Position(span.line, first), lsp.Position(span.line, last))

    def _here(self, uri: str, at: lsp.Position) -> tuple[Document, int, int, int]:
        """Return the program of a source, and the tape, line and column of a place in it."""
        document, tape = self._workspace.document(uri)
        return document, tape, at.line, document.texts[tape].column(at.line, at.character)

    def _at(self, params: _Placed) -> tuple[Document, int, str]:
        document, tape, line, column = self._here(params.text_document.uri, params.position)
        return document, tape, document.name_at(tape, line, column)

    def _places(self, params: _Placed, defined: bool | None) -> Iterator[tuple[str, lsp.Range]]:
        """Yield each place of the symbol at a position, in all tapes of the program."""
        document, _, name = self._at(params)
        tapes = self._workspace.tapes(params.text_document.uri)
        for span in document.places(name, defined):
            yield tapes[span.tape], self._range(document, span)

    def _locations(self, params: _Placed, defined: bool | None) -> list[lsp.Location]:
        return [lsp.Location(uri, where) for uri, where in self._places(params, defined)]

    def _references(self, params: lsp.ReferenceParams) -> list[lsp.Location]:
        return self._locations(params, None if params.context.include_declaration else False)

    def _highlights(self, params: lsp.DocumentHighlightParams) -> list[lsp.DocumentHighlight]:
        kinds = {True: lsp.DocumentHighlightKind.Write, False: lsp.DocumentHighlightKind.Read}
        return [
            lsp.DocumentHighlight(where, kinds[defined])
            for defined in (True, False)
            for uri, where in self._places(params, defined)
            if uri == params.text_document.uri
        ]

    def _hover(self, params: lsp.HoverParams) -> lsp.Hover | None:
        document, *place = self._here(params.text_document.uri, params.position)
        said = document.hover(*place)
        return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, said)) if said else None

    def _prepare_rename(self, params: lsp.PrepareRenameParams) -> lsp.Range:
        document, tape, line, column = self._here(params.text_document.uri, params.position)
        name, span = document.name_at(tape, line, column), document.written_at(tape, line, column)
        reason = document.refusal(name, name)
        if span is None or reason:
            raise JsonRpcException(reason, lsp.LSPErrorCodes.RequestFailed)
        return self._range(document, span)

    def _rename(self, params: lsp.RenameParams) -> lsp.WorkspaceEdit:
        document, tape, name = self._at(params)
        if reason := document.refusal(name, params.new_name, tape):
            raise JsonRpcException(reason, lsp.LSPErrorCodes.RequestFailed)
        changes: dict[str, list[lsp.TextEdit]] = {}
        for uri, where in self._places(params, None):
            changes.setdefault(uri, []).append(lsp.TextEdit(where, params.new_name))
        return lsp.WorkspaceEdit(changes=changes)

    def _completion(self, params: lsp.CompletionParams) -> list[lsp.CompletionItem]:
        document, *place = self._here(params.text_document.uri, params.position)
        return [
            lsp.CompletionItem(name, kind=_COMPLETED[kind], detail=said)
            for name, kind, said in document.completions(*place)
        ]

    def _outline(self, params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol]:
        """Return the symbols that a tape defines; those within a subroutine are its children."""
        uri = params.text_document.uri
        document, tape = self._workspace.document(uri)
        routines = {each.entry.name: each for each in document.routines}
        outline: list[lsp.DocumentSymbol] = []
        last = -1
        for each in document.definitions:
            if each.span.tape == tape:
                symbol = self._symbol(document, each)
                if each.name in routines:
                    last = routines[each.name].last
                    column = len(document.line(tape, last))
                    end = self._range(document, Span(tape, last, column, column)).end
                    symbol.kind, symbol.children = lsp.SymbolKind.Function, []
                    symbol.range = lsp.Range(symbol.range.start, max(symbol.range.end, end))
                    outline.append(symbol)
                elif each.span.line <= last:
                    outline[-1].children = [*(outline[-1].children or []), symbol]
                else:
                    outline.append(symbol)
        return outline

    def _symbol(self, document: Document, each: Definition) -> lsp.DocumentSymbol:
        where, name = self._range(document, each.span), document.written(each.name)
        return lsp.DocumentSymbol(name, _SYMBOLS[each.kind], where, where, detail=f"{each.value:04o}")

    def _symbols(self, params: lsp.WorkspaceSymbolParams) -> list[lsp.WorkspaceSymbol]:
        """Return the symbols of all programs that are open whose names contain the query."""
        return [
            lsp.WorkspaceSymbol(
                lsp.Location(tapes[each.span.tape], self._range(document, each.span)),
                document.written(each.name),
                _SYMBOLS[each.kind],
            )
            for tapes, document in self._workspace.documents()
            for each in document.definitions
            if params.query.upper() in each.name
        ]

    def _folding(self, params: lsp.FoldingRangeParams) -> list[lsp.FoldingRange]:
        document, tape = self._workspace.document(params.text_document.uri)
        kinds = {True: lsp.FoldingRangeKind.Comment, False: lsp.FoldingRangeKind.Region}
        return [lsp.FoldingRange(first, last, kind=kinds[what]) for first, last, what in document.folds(tape)]

    def _hints(self, params: lsp.InlayHintParams) -> list[lsp.InlayHint]:
        document, tape = self._workspace.document(params.text_document.uri)
        return [
            lsp.InlayHint(lsp.Position(line, 0), said, padding_right=True)
            for line, said in document.hints(tape)
            if params.range.start.line <= line <= params.range.end.line
        ]

    def _tokens(self, params: lsp.SemanticTokensParams) -> lsp.SemanticTokens:
        """Return the pieces of a tape, each relative to the previous one."""
        uri = params.text_document.uri
        document, tape = self._workspace.document(uri)
        data: list[int] = []
        line = character = 0
        for span, kind, defined in document.tokens(tape):
            first, end = document.characters(span)
            if span.line != line:
                character = 0
            data += [span.line - line, first - character, end - first, KINDS.index(kind), int(defined)]
            line, character = span.line, first
        return lsp.SemanticTokens(data)

    def _actions(self, params: lsp.CodeActionParams) -> list[lsp.CodeAction | lsp.Command]:
        """Return what mends the diagnostics in a range, and the other dialect for a source in error."""
        uri = params.text_document.uri
        document, tape = self._workspace.document(uri)
        found: list[lsp.CodeAction | lsp.Command] = []
        for each in document.found(tape):
            if params.range.start.line <= each.line - 1 <= params.range.end.line:
                shown = [self._diagnostic(document, tape, each)]
                for title, edits in fixes(document, tape, each):
                    changes = [lsp.TextEdit(self._range(document, span), new) for span, new in edits]
                    edit = lsp.WorkspaceEdit(changes={uri: changes})
                    found.append(lsp.CodeAction(title, lsp.CodeActionKind.QuickFix, shown, edit=edit))
        if not document.assembly.ok:
            other, name = (PAL3, "PAL III") if document.dialect == PAL8 else (PAL8, "PAL8")
            found.append(lsp.Command(f"Assemble it as {name}", _TAKE_AS, arguments=[uri, other]))
        return found

    def _formatting(self, params: lsp.DocumentFormattingParams) -> list[lsp.TextEdit]:
        document, tape = self._workspace.document(params.text_document.uri)
        before = document.texts[tape].content
        after = formatted(before, document.dialect)
        whole = lsp.Range(lsp.Position(0, 0), lsp.Position(len(document.tapes[tape]), 0))
        return [] if after == before else [lsp.TextEdit(whole, after)]
