"""The kinds of files that a command takes, one click type each, and what holds for them in every command.

Source    a file that is read, or a bundled name      completed by both
Target    a file that is written                      never one that was read, nor one of another kind
Folder    where several files go

`Command` and `Group` are click's, with what all of ours have: --no-clobber where something is written,
options that act or are refused (rules.py), files compared as files before anything is opened, names that are
nearly right, whole lines of help.
"""

import os
import sys
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any, TypeVar

import click
from click.core import augment_usage_errors

from pdp8 import shelf
from pdp8.cli.shared import command, rules
from tapes.errors import visible

if TYPE_CHECKING:
    from click.shell_completion import CompletionItem

    _Type = click.ParamType[str]
else:
    _Type = click.ParamType  # before click 8.5 it takes no argument

_Function = TypeVar("_Function", bound=Callable[..., Any])


def _completed(names: Iterable[str], kind: str = "plain") -> list["CompletionItem"]:
    from click.shell_completion import CompletionItem

    return [CompletionItem(name, type=kind) for name in names]


class Source(_Type):
    """A file that is read: its name, a bundled one, or `-`; also completed by what `more` names."""

    name = "file"

    def __init__(self, more: Callable[[], Iterable[str]] = lambda: ()) -> None:
        self._more = more

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list["CompletionItem"]:
        """Complete with the folder's files and bundled names, or leave it to the shell."""
        names = [name for name in (*shelf.bundled(), *self._more()) if name.startswith(incomplete)]
        if not names:
            return _completed([incomplete], "file")
        here = [f"{entry.name}{'/' * entry.is_dir()}" for entry in os.scandir() if entry.name[:1] != "."]
        found = {*names, *(name for name in here if name.startswith(incomplete))}
        return _completed(sorted(found))


class _Written(_Type):
    """What is written; the shell itself completes its name."""

    completes = "file"

    def shell_complete(
        self, ctx: click.Context, param: click.Parameter, incomplete: str
    ) -> list["CompletionItem"]:
        """Leave it to the shell."""
        return _completed([incomplete], self.completes)


class Target(_Written):
    """A file that is written, `-` for standard output; `makes` is a kind of `shelf.check_kind` or ""."""

    name = "file"

    def __init__(self, makes: str = "") -> None:
        self._makes = makes

    def check(self, name: str) -> None:
        """Raise a UsageError if file `name` exists and is not of this kind."""
        try:
            shelf.check_kind(name, self._makes)
        except shelf.ShelfError as error:
            raise click.UsageError(str(error)) from error


class Folder(_Written):
    """A folder that files are written into; it is made."""

    name, completes = "folder", "dir"
    _of_files = (".svg", ".html", ".pdf", ".png", ".json", ".csv", ".txt", ".zip", ".gz")

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> str:
        """Return the name; fail for that of a file which is not there."""
        if value.lower().endswith(self._of_files) and not os.path.exists(value):
            self.fail(f"{value} is the name of a file, not of a folder for files", param, ctx)
        return str(value)


def output(
    kind: _Type,
    metavar: str | None = None,
    default: str | None = "-",
    help: str = "Where to.  [default: standard output]",
    **settings: Any,
) -> Callable[[_Function], _Function]:
    """Return the decorator that adds `-o`, `--out`: where a command's product goes, a file or a folder."""
    if default is not None:  # click takes a given None for an answer, even where one is required
        settings["default"] = default
    return rules.option("-o --out output", help, kind, metavar=metavar, **settings)


class Command(click.Command):
    """A command that checks its options' rules and compares its files before it begins."""

    def get_params(self, ctx: click.Context) -> list[click.Parameter]:
        """Return the parameters, with --no-clobber before --help where something is written."""
        params = super().get_params(ctx)
        if any(map(_writes, params)):
            params.insert(-1, self._no_clobber)
        return params

    _no_clobber = click.Option(
        ["--no-clobber"], is_flag=True, expose_value=False, callback=command.keep, help="Replace no file."
    )

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Parse, then hold the options to their rules and compare the files that are named."""
        with augment_usage_errors(ctx):
            rest = super().parse_args(ctx, args)
            if not ctx.resilient_parsing:
                rules.check(ctx)
                self._check_no_clobber(ctx)
                self._check(ctx)
        return rest

    def _check_no_clobber(self, ctx: click.Context) -> None:
        """Raise a UsageError where --no-clobber was given and no file is to be written."""
        if not command.keeps(ctx):
            return
        written = {param.name: param for param in self.params if _writes(param)}
        values = {name: ctx.params[name or ""] for name in written}
        writes_unasked = "output" in values and values["output"] is None  # beside the source, as pal does
        if not writes_unasked and all(value in (None, "-", False, ()) for value in values.values()):
            asked = " or ".join(rules.words(param)[0] for param in written.values())
            raise click.UsageError(f"--no-clobber means nothing without {asked}.")

    def _check(self, ctx: click.Context) -> None:
        sources, outputs, made, kinds = [], [], [], []
        for param, name in _named(self, ctx):
            if isinstance(param.type, _Written):
                shelf.check_named(name)
            if isinstance(param.type, Source) and (name == "-" or shelf.has(name)):
                sources.append(name)
            elif isinstance(param.type, Target):
                outputs.append(name)
                kinds.append(param.type)
            elif isinstance(param.type, Folder):
                made.append(os.path.realpath(name))
                if os.path.exists(name) and not os.path.isdir(name):
                    raise shelf.ShelfError(f"{name}: File exists")
        in_made = [name for name in outputs if os.path.dirname(os.path.realpath(name)) in made]
        check_files(sources, [name for name in outputs if name not in in_made or os.path.exists(name)])
        for name, kind in zip(outputs, kinds, strict=True):
            kind.check(name)
        for name in sources:
            if shelf.hides(name):
                command.say(f"{name} {shelf.HIDES}")
        if "-" in sources and sys.stdin.isatty():
            command.say("waits for standard input, which is this terminal; Ctrl-D ends it, --help tells more")


def _writes(param: click.Parameter) -> bool:
    """Whether files are written where this parameter is given."""
    return isinstance(param.type, _Written) or getattr(param, "writes", False)


def _named(command: click.Command, ctx: click.Context) -> Iterator[tuple[click.Parameter, str]]:
    """Yield each name of a file that a command was given, with its parameter."""
    for param in command.params:
        value = ctx.params.get(param.name or "")
        for name in value if isinstance(value, tuple) else (value,):
            if isinstance(name, str):
                yield param, name


class Group(click.Group):
    """A group of commands that lists whole lines and suggests similar names."""

    command_class = Command

    def lines(self, ctx: click.Context) -> list[tuple[str, str]]:
        """Return the name of each command, and what it does in one line."""
        found = [(name, self.get_command(ctx, name)) for name in self.list_commands(ctx)]
        return [(name, command.get_short_help_str(200)) for name, command in found if command]

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands."""
        with formatter.section("Commands"):
            formatter.write_dl(self.lines(ctx))

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command; where there is none, name those that are spelled much alike."""
        name = args[0]
        if self.get_command(ctx, name) is None and not ctx.resilient_parsing:
            from difflib import get_close_matches

            near = get_close_matches(name, self.list_commands(ctx))
            meant = f"; did you mean {' or '.join(near)}?" if near else ""
            ctx.fail(f"there is no command {visible(name)!r}{meant}")
        return super().resolve_command(ctx, args)


def check_files(sources: Iterable[str | None], outputs: Iterable[str | None]) -> None:
    """Raise UsageError for standard input read twice, one file for two outputs or for source and output;
    ShelfError for a missing source or an output that cannot be written. Nothing is opened.
    """
    read = [name for name in sources if name is not None]
    if read.count("-") > 1:
        raise click.UsageError("standard input can be read only once")
    files = [name for name in read if name != "-"]
    taken = {shelf.identity(shelf.find(name)): f"{name} is the source; name another file" for name in files}
    for name in outputs:
        if name is None:
            continue
        if name in files:
            raise click.UsageError(f"{name} is the source; name another file")
        if opened := shelf.stream(name):
            raise click.UsageError(f"{name} is {opened}; name another file")
        command.check_output(name)
        if os.path.exists(name) and not os.path.isfile(name):
            continue
        identity = shelf.identity(name)
        if identity in taken:
            raise click.UsageError(taken[identity])
        taken[identity] = f"two outputs go to {'standard output' if name == '-' else name}"
