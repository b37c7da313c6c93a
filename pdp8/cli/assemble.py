"""The commands `pal` and `dis`: the assembler as one types it, and its inverse."""

import os
import re
import sys
from collections.abc import Callable, Iterable
from functools import partial

import click

from pal.assembler import HIGH_SPEED_SYMBOLS, TELETYPE_SYMBOLS
from pal.assembling import DIALECTS, FOUND, assemble
from pal.assembly import MOST, PAL8, SPELLED, Assembly
from pal.diagnostics import Diagnostic
from pal.models import MODELS
from pdp8 import shelf
from pdp8.cli.shared import arguments, command
from pdp8.cli.shared.arguments import Command, Folder, Source, Target, output
from pdp8.cli.shared.frames import unspelled
from pdp8.cli.shared.parameters import address
from pdp8.cli.shared.progress import Busy
from pdp8.cli.shared.rules import flag, option
from tapes.errors import WorkError, called, naming, visible
from tapes.quantities import counted

_TEXT = Target("text")
_SYMBOL = re.compile(r"([A-Z][A-Z0-9]{0,5})[\s=]+([0-7]{1,5})")
_PASSES = ("pass1", "pass2", "pass3")


class AssemblyError(WorkError):
    """A source with errors: the last line of what is said about it."""


@click.command(cls=Command)
@click.argument("sources", type=Source(), nargs=-1, metavar="SOURCE...")
@output(
    Target("tape"),
    "FILE",
    None,
    "Where to.  [default: SOURCE's name with .bin; no tape where --listing, --symbols, --json or --tty is "
    "asked for without -o, --rim and --force]",
)
@flag("--rim", "Punch a RIM tape instead of DEC's BIN tape.")
@option("--listing", "Write what pass 3 typed, with its symbol table.", _TEXT, metavar="FILE")
@option("--symbols", "Write the symbol table.", _TEXT, metavar="FILE")
@option("--json", "Write words, symbols, lines and diagnostics as JSON.", Target("JSON"), metavar="FILE")
@option("--tty", "Write NAME.pass1, .pass2, .pass3: the raw frames of an ASR-33.", Folder(), metavar="FOLDER")
@flag("--force", "Punch the tape in spite of errors, as DEC's assembler did.", excludes="--check")
@flag("--strict", "Treat notes as errors.")
@flag(
    "--check",
    "Say what is wrong, and write nothing.",
    excludes="--out --rim --listing --symbols --json --tty --no-clobber",
)
@option(
    "--dialect",
    "DEC's PAL III of 1967, or the later PAL8; auto takes PAL8 for a source by what it has.",
    click.Choice(DIALECTS),
    default=FOUND,
)
@flag("--w wipe", "PAL8's /W: forget the literals of a page that was left, so that an overlay may go there.")
@flag("--lsp", "Serve an editor on standard input and output (docs/editors.md).", only="--dialect")
@flag("--modern", "Read lower case as capitals; nothing else differs.")
@option(
    "--for model",
    "Note each word that other models of the PDP-8 execute differently.",
    click.Choice(MODELS),
)
@flag(
    "--high-speed-reader",
    f"Room for {HIGH_SPEED_SYMBOLS} symbols, not the ASR-33's {TELETYPE_SYMBOLS}; "
    "PAUSE loses the rest of its line.",
)
@click.version_option(package_name="pdp8", prog_name="pal", message="%(prog)s, version %(version)s")
def pal(
    *,
    sources: tuple[str, ...],
    output: str | None,
    rim: bool,
    listing: str | None,
    symbols: str | None,
    json: str | None,
    tty: str | None,
    force: bool,
    strict: bool,
    check: bool,
    dialect: str,
    wipe: bool,
    lsp: bool,
    modern: bool,
    model: str | None,
    high_speed_reader: bool,
) -> None:
    """Assemble PAL III source as DEC's assembler of 1967 did, the same tape, the same listing; or PAL8.

    SOURCE is a file, a bundled program's name, or - for standard input; several are read one after the
    other, as tapes that end with PAUSE were. Exit status 1 if there is any error; then no tape is written
    without --force, and nothing at all where DEC's assembler would never end or would destroy itself. Notes
    say where a source means something else to PAL III than it seems to.

    \b
    Examples:
      pal eia.pal                          # the tape eia.bin
      pal eia.pal -o - | pdp8 tape show -  # its holes
      pal eia.pal --listing -              # Appendix B again
      pal one.pal two.pal -o both.bin --symbols both.sym
      pal old.pal --force --tty tapes      # what the Teletype punched
      pal eia.pal --for 8/L                # what other models do otherwise
      pal game.pa --dialect pal8           # literals, PAGE, TEXT, conditions
      pal eia.pal --check --strict         # for an editor, or CI
    """
    if lsp:
        _serve(dialect)
        return
    if not sources:
        raise click.UsageError("no SOURCE: name a file, or - for standard input")
    asked = bool(output or rim or force) or not (check or listing or symbols or json or tty)
    tape = (output or _beside(sources[0])) if asked else None
    passes = _passes(tty, sources[0])
    written = [tape, listing, symbols, json, *filter(os.path.exists, passes)]
    if tape == sources[0] != "-" and not output:
        _check_kinds(sources[:1], [_read(sources[0])], False)
    arguments.check_files(sources, written)
    capacity = HIGH_SPEED_SYMBOLS if high_speed_reader else TELETYPE_SYMBOLS
    contents = [_read(source) for source in sources]
    names = [called(source) for source in sources]
    with Busy("assembling", wanted=True):
        assembly = assemble(
            *contents, names=names, modern=modern, capacity=capacity, model=model, dialect=dialect, wipe=wipe
        )
        diagnostics = sorted(assembly.diagnostics, key=lambda diagnostic: not diagnostic.error)
    _check_kinds(sources, contents, assembly.ok)
    if assembly.dialect == PAL8:
        _check_options_of_pal3(tty, modern, high_speed_reader)
    elif wipe:
        raise click.UsageError("--w is PAL8's /W; this is PAL III: --dialect pal8 makes it PAL8")
    for diagnostic in diagnostics[:MOST]:
        command.tell(_coloured(diagnostic), styled=True)
    more = [diagnostic.error for diagnostic in diagnostics[MOST:]]
    kinds = ((sum(more), "more errors"), (more.count(False), "more notes"))
    if more:
        command.tell("and " + ", ".join(counted(number, kind) for number, kind in kinds if number))
    errors = sum(diagnostic.error or strict for diagnostic in diagnostics)
    if assembly.stopped:
        dialect = SPELLED[assembly.dialect]
        raise AssemblyError(f"{_counted(errors)}: {dialect} goes no further, nothing is written")
    writes: list[Callable[[], None]] = []
    if listing:
        writes.append(partial(_put_listing, listing, assembly))
    if symbols:
        writes.append(partial(command.put, symbols, assembly.symbol_table))
    if json:
        from pal.reports import as_json

        writes.append(partial(command.put, json, as_json(assembly)))
    if tty:
        punched = zip(map(os.path.basename, passes), assembly.teletype, strict=True)
        writes.append(partial(command.put_all, tty, punched))
    if tape:
        writes.append(partial(_punch, tape, rim, force, errors, assembly))
    _write_each(writes)
    if errors:
        raise AssemblyError(_counted(errors))


def _write_each(writes: Iterable[Callable[[], None]]) -> None:
    """Write every file, even if one fails; then raise the last error."""
    failed: WorkError | None = None
    for write in writes:
        try:
            write()
        except WorkError as error:
            if failed:
                command.say(str(failed))
            failed = error
    if failed:
        raise failed


def _check_options_of_pal3(tty: str | None, modern: bool, high_speed_reader: bool) -> None:
    """Raise UsageError for an option that means nothing for PAL8."""
    if tty:
        raise click.UsageError("--tty writes the frames of PAL III's three passes; this is PAL8")
    if modern:
        raise click.UsageError("--modern means nothing for PAL8, which reads small letters as capitals")
    if high_speed_reader:
        raise click.UsageError("--high-speed-reader means nothing for PAL8: its symbols have room")


def _coloured(diagnostic: Diagnostic) -> str:
    """Return a diagnostic in colours, which click leaves out where there is no terminal."""
    place, severity, message = visible(diagnostic.headline).partition(f" {diagnostic.severity}: ")
    severity = click.style(severity.strip(), fg="red" if diagnostic.error else "cyan", bold=True)
    headline = f"{click.style(place, bold=True)} {severity} {click.style(message, bold=True)}"
    shown = [visible(line) for line in diagnostic.excerpt]
    carets = [click.style(line, fg="green") for line in shown[1:]]
    return "\n".join([headline, *shown[:1], *carets, *map(visible, diagnostic.sentences)])


def _read(name: str) -> bytes:
    from tapes import codes, dectape

    content = shelf.read(name)
    if (what := dectape.image(len(content))) and codes.recognise(content) is not codes.ASCII:
        cure = "; `pdp8 tape show` lists its files" * dectape.is_image(content)
        raise AssemblyError(f"{called(name)}: {what}, not PAL source{cure}")
    if not content.strip(b"\0\x80\xff\r\n\x8d\x8a"):
        raise AssemblyError(f"{called(name)}: the source is empty")
    return content


def _check_kinds(names: tuple[str, ...], contents: list[bytes], ok: bool) -> None:
    """Raise AssemblyError for a tape of data, or for another kind of tape that does not assemble."""
    from tapes import ascii, codes, spelled
    from tapes.loaders import Words

    for name, content in zip(names, contents, strict=True):
        if ascii.only_figures(content):
            raise AssemblyError(f"{called(name)}: nothing but figures: data, and no PAL source")
        if what := shelf.no_source(content):
            cure = "; `pdp8 dis` takes a saved state" * (what == shelf.JSON)
            raise AssemblyError(f"{called(name)}: {what}, not PAL source{cure}")
        if (words := spelled.found(content)) and words.title == spelled.LISTING:
            raise AssemblyError(f"{called(name)}: a listing, not PAL source; `pdp8 dis` makes a source of it")
        code = codes.recognise(content)
        if not ok and (isinstance(code, Words) or code is codes.EIA):
            cure = "; `pdp8 dis` makes a source of it" * isinstance(code, Words)
            raise AssemblyError(f"{called(name)}: a tape in {code.name.upper()}, not PAL source{cure}")
        if not ok and code is codes.ASCII and (titled := codes.ASCII.titled(content, "source")):
            raise AssemblyError(f"{called(name)}: {titled}")


def _counted(errors: int) -> str:
    return f"{errors} error{'s' * (errors != 1)}"


def _punch(name: str, rim: bool, force: bool, errors: int, assembly: Assembly) -> None:
    if errors and not force:
        raise AssemblyError(f"{_counted(errors)}: no tape; --force punches it as DEC's assembler did")
    if rim:
        from tapes.rim import encode

        command.put(name, encode(assembly.words))
    else:
        command.put(name, assembly.tape)
    if errors:
        where = "standard output" if name == "-" else name
        raise AssemblyError(f"{_counted(errors)}; {where} punched all the same")


def _serve(dialect: str) -> None:
    """Run the language server until the editor ends it, and forward pygls's log."""
    import logging

    try:
        from pal import server
        from pal.workspace import Workspace
    except ImportError:
        from pdp8.cli.shared.extras import hint

        raise AssemblyError(f"--lsp needs pygls: {hint('lsp')}") from None
    logging.getLogger("pygls").addHandler(logging.NullHandler())
    with command.conversation() as (reader, writer):
        server.made(Workspace(dialect, server.read)).start_io(reader, writer)


def _beside(source: str) -> str:
    return "-" if source == "-" else os.path.splitext(source)[0] + ".bin"


def _put_listing(name: str, assembly: Assembly) -> None:
    if name == "-" and sys.stdout.isatty():
        from rich.console import Console
        from rich.syntax import Syntax

        from pal.lexer import PalLexer

        coloured = Syntax("", PalLexer(stripnl=False), theme="ansi_dark").highlight(visible(assembly.listing))
        Console().print(coloured, soft_wrap=True)
    else:
        command.put(name, assembly.listing)


def _passes(folder: str | None, source: str) -> list[str]:
    """Return the files of the three passes, none if no folder is given."""
    name = os.path.splitext(os.path.basename(source))[0] if source != "-" else "stdin"
    return [os.path.join(folder, f"{name}.{ending}") for ending in _PASSES] if folder else []


@click.command(cls=Command)
@click.argument("tape", type=Source(), default="-")
@option("--symbols", "Take the tags from a symbol table of pal.", Source(), metavar="FILE")
@option(
    "--entry",
    "Take what is reached from here for code, the rest for numbers. Several may be given.",
    address,
    multiple=True,
    metavar="OCTAL",
)
@flag("--force", "Take what can be read of a damaged tape.")
@output(Target("source"))
def dis(*, tape: str, symbols: str | None, entry: tuple[int, ...], force: bool, output: str) -> None:
    """Disassemble a BIN or RIM tape to PAL III source that assembles to the same words and fields.

    TAPE is a file, a bundled tape's name, or - for standard input. A tape that PAL III punched comes back
    frame for frame, one of PAL8 word for word.

    \b
    Examples:
      pdp8 dis eia.bin
      pdp8 dis eia.bin | pal - -o again.bin
      pal add.pal -o add.bin --symbols add.sym; pdp8 dis add.bin --symbols add.sym --entry 200
    """
    from pal.disassembler import disassemble_tape, field_of
    from pal.formatting import silenced
    from tapes import binary, codes, dectape
    from tapes.code import Characters
    from tapes.loaders import Words

    frames, note = unspelled(tape, shelf.read(tape))
    tags = _symbols(symbols)
    said = [note] * bool(note)
    with naming(tape):
        code = codes.recognise(frames)
        if isinstance(code, Characters):
            raise WorkError(f"a tape in {code.name.upper()}, not in BIN or RIM")
        if isinstance(code, Words):
            notes = code.left_out(frames)
            held = code.readable(frames) if entry else {}
            if bare := [f"{each:04o}" for each in entry if field_of(held) | each not in held]:
                raise WorkError(f"--entry {bare[0]}: the tape has no word there")
            if force and (damage := code.damage(frames)):
                frames = binary.encode(code.readable(frames))
                said.append(f"{damage}; disassembled as far as it can be read")
            said += notes
        elif what := dectape.image(len(frames)):
            raise WorkError(f"{what}, not a tape in BIN or RIM")
        source = silenced(disassemble_tape(frames, tags, entry))
    command.put(output, source)
    command.say_of(tape, said)


def _symbols(name: str | None) -> dict[str, int]:
    """Return {name: address} of a symbol table as `pal --symbols` writes it, or of definitions."""
    found: dict[str, int] = {}
    for number, line in enumerate(shelf.read_text(name).split("\n") if name else [], 1):
        match = _SYMBOL.fullmatch(line.strip())
        if match:
            found[match[1]] = int(match[2], 8)
        elif line.strip():
            raise WorkError(f"{name}: line {number}: {line.strip()!r} is no name with an octal number")
    return found


def main() -> None:
    """Run the `pal` command."""
    command.run(pal, "pal")
