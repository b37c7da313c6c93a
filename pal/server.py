"""The language server: what an editor asks of a source by the Language Server Protocol, on standard streams.

Started by `pal --lsp`; it needs pygls (pip install "pdp8[lsp]"). The answers are those of document.py.
"""

from lsprotocol import types as lsp
from pygls.exceptions import JsonRpcException
from pygls.lsp.server import LanguageServer

from pal.diagnostics import Diagnostic
from pal.document import TAG, VALUE, Document, Span, formatted

_VERSION = "1"
_Placed = lsp.HoverParams | lsp.DefinitionParams | lsp.ReferenceParams | lsp.RenameParams
_KINDS = {
    TAG: (lsp.CompletionItemKind.Function, lsp.SymbolKind.Function),
    VALUE: (lsp.CompletionItemKind.Constant, lsp.SymbolKind.Constant),
}
_SEVERITIES = {True: lsp.DiagnosticSeverity.Error, False: lsp.DiagnosticSeverity.Warning}


def made(dialect: str) -> LanguageServer:
    """Return a server that takes sources to be in `dialect`."""
    server = LanguageServer("pal", _VERSION)
    documents: dict[str, Document] = {}

    def document(uri: str) -> Document:
        source = server.workspace.get_text_document(uri)
        if uri not in documents or documents[uri].text != source.source:
            documents[uri] = Document(source.source, source.filename or uri, dialect)
        return documents[uri]

    def at(params: _Placed) -> tuple[Document, str]:
        found = document(params.text_document.uri)
        return found, found.name_at(params.position.line, params.position.character)

    def places(params: _Placed, defined: bool | None) -> list[lsp.Location]:
        found, name = at(params)
        return [lsp.Location(params.text_document.uri, _range(span)) for span in found.places(name, defined)]

    @server.feature(lsp.TEXT_DOCUMENT_DID_OPEN)
    @server.feature(lsp.TEXT_DOCUMENT_DID_CHANGE)
    def changed(params: lsp.DidOpenTextDocumentParams | lsp.DidChangeTextDocumentParams) -> None:
        uri = params.text_document.uri
        found = [_diagnostic(each) for each in document(uri).assembly.diagnostics]
        server.text_document_publish_diagnostics(lsp.PublishDiagnosticsParams(uri, found))

    @server.feature(lsp.TEXT_DOCUMENT_DID_CLOSE)
    def closed(params: lsp.DidCloseTextDocumentParams) -> None:
        documents.pop(params.text_document.uri, None)

    @server.feature(lsp.TEXT_DOCUMENT_HOVER)
    def hover(params: lsp.HoverParams) -> lsp.Hover | None:
        found, _ = at(params)
        said = found.hover(params.position.line, params.position.character)
        return lsp.Hover(lsp.MarkupContent(lsp.MarkupKind.Markdown, said)) if said else None

    @server.feature(lsp.TEXT_DOCUMENT_DEFINITION)
    def definition(params: lsp.DefinitionParams) -> list[lsp.Location]:
        return places(params, True)

    @server.feature(lsp.TEXT_DOCUMENT_REFERENCES)
    def references(params: lsp.ReferenceParams) -> list[lsp.Location]:
        return places(params, None if params.context.include_declaration else False)

    @server.feature(lsp.TEXT_DOCUMENT_RENAME)
    def rename(params: lsp.RenameParams) -> lsp.WorkspaceEdit:
        found, name = at(params)
        reason = found.refusal(name, params.new_name)
        if reason:
            raise JsonRpcException(reason, lsp.LSPErrorCodes.RequestFailed)
        edits = [lsp.TextEdit(_range(span), params.new_name) for span in found.places(name)]
        return lsp.WorkspaceEdit(changes={params.text_document.uri: edits})

    @server.feature(lsp.TEXT_DOCUMENT_COMPLETION)
    def completion(params: lsp.CompletionParams) -> list[lsp.CompletionItem]:
        found = document(params.text_document.uri)
        known = [
            lsp.CompletionItem(name, kind=lsp.CompletionItemKind.Keyword, detail=said)
            for name, said in found.known.items()
        ]
        own = [
            lsp.CompletionItem(each.name, kind=_KINDS[each.kind][0], detail=f"{each.value:04o}")
            for each in found.definitions
        ]
        return own + known

    @server.feature(lsp.TEXT_DOCUMENT_DOCUMENT_SYMBOL)
    def symbols(params: lsp.DocumentSymbolParams) -> list[lsp.DocumentSymbol]:
        return [
            lsp.DocumentSymbol(
                each.name,
                _KINDS[each.kind][1],
                _range(each.span),
                _range(each.span),
                detail=f"{each.value:04o}",
            )
            for each in document(params.text_document.uri).definitions
        ]

    @server.feature(lsp.TEXT_DOCUMENT_FOLDING_RANGE)
    def folding(params: lsp.FoldingRangeParams) -> list[lsp.FoldingRange]:
        kinds = {True: lsp.FoldingRangeKind.Comment, False: lsp.FoldingRangeKind.Region}
        return [
            lsp.FoldingRange(first, last, kind=kinds[comment])
            for first, last, comment in document(params.text_document.uri).folds()
        ]

    @server.feature(lsp.TEXT_DOCUMENT_FORMATTING)
    def formatting(params: lsp.DocumentFormattingParams) -> list[lsp.TextEdit]:
        found = document(params.text_document.uri)
        text = formatted(found.text, dialect)
        if text == found.text:
            return []
        return [lsp.TextEdit(lsp.Range(lsp.Position(0, 0), lsp.Position(len(found.lines), 0)), text)]

    return server


def _range(span: Span) -> lsp.Range:
    return lsp.Range(lsp.Position(span.line, span.start), lsp.Position(span.line, span.end))


def _diagnostic(found: Diagnostic) -> lsp.Diagnostic:
    span = Span(found.line - 1, found.column - 1, found.end_column - 1)
    said = "\n".join(each for each in (found.message, found.advice, found.hint) if each)
    return lsp.Diagnostic(_range(span), said, _SEVERITIES[found.error], code=found.code or None, source="pal")
