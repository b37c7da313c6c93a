"""The `pdp8` command: every package's commands hung together, each loaded only when it is called."""

from importlib import import_module

import click

from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Group
from pdp8.cli.shared.rules import flag

_GROUPS = {
    "Run": {
        "run": ("pdp8.cli.run", "Run a program on the PDP-8/L."),
        "panel": ("pdp8.cli.panel", "The front panel, in the terminal."),
        "workbench": ("pdp8.cli.workbench", "Write the live machine as one page for a browser."),
        "monitor": ("pdp8.cli.monitor", "The operator's prompt: examine, step, break, trace."),
        "dap": ("pdp8.cli.dap", "A debugger for editors: the Debug Adapter Protocol."),
    },
    "Assemble": {
        "pal": ("pdp8.cli.assemble", "Assemble PAL III or PAL8 source."),
        "dis": ("pdp8.cli.assemble", "Disassemble a BIN or RIM tape."),
    },
    "Tapes": {"tape": ("pdp8.cli.tape", "Show, measure, convert and punch paper tapes; read photographs.")},
    "Parts and machine tool": {
        "part": ("pdp8.cli.part", "Run a FORTRAN part program: an ASCII tape for the translation."),
        "nc": ("pdp8.cli.nc", "The Moog Hydra-Point: list, cut, plot and inspect an EIA tape."),
    },
    "Teach": {
        "check": ("pdp8.cli.check", "Mark the answers of a class to an exercise."),
        "cards": ("pdp8.cli.cards", "Draw cards to print: loader, instructions, codes, timetable."),
    },
    "Research": {
        "replay": ("pdp8.cli.replay", "Do the whole afternoon of 1971 again; make a page of it."),
        "thesis": ("pdp8.cli.thesis", "The thesis page by page: its figures, tables and programs."),
        "vectors": ("pdp8.cli.vectors", "Write single-step vectors for any emulator."),
    },
}
"""The module of each command, which has it by its name, and one line of help, as README has them."""
_COMMANDS = {name: found for group in _GROUPS.values() for name, found in group.items()}


class _Lazy(Group):
    """A group that knows its commands by name and one line of help, and imports one when it is called."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(_COMMANDS)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Take `help COMMAND` for `COMMAND --help`."""
        if args[0] == "help":
            args = [*args[1:], "--help"]
            if len(args) == 1 and not ctx.resilient_parsing:
                click.echo(ctx.get_help())
                ctx.exit()
        return super().resolve_command(ctx, args)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in _COMMANDS:
            return None
        found: click.Command = getattr(import_module(_COMMANDS[cmd_name][0]), cmd_name)
        return found

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        column = max(map(len, _COMMANDS))
        for title, group in _GROUPS.items():
            with formatter.section(title):
                rows = [(name.ljust(column), line) for name, (_, line) in group.items()]
                formatter.write_dl(rows)


def _show_version(ctx: click.Context, _: click.Parameter, wanted: bool) -> None:
    if not wanted or ctx.resilient_parsing:
        return
    from importlib.metadata import version

    from pdp8.computer.speed import engine

    path = str(engine.__file__)
    form = "interpreted" if path.endswith(".py") else "compiled"
    click.echo(f"pdp8, version {version('pdp8')}, {form} core: {path}")
    ctx.exit()


@click.group(cls=_Lazy)
@flag(
    "--version",
    "Show the version, and from which file the core runs, compiled or interpreted.",
    is_eager=True,
    expose_value=False,
    callback=_show_version,
)
def pdp8() -> None:
    """A bit-exact PDP-8/L with its Teletype, PAL III, paper tapes and the N/C machine of one 1971 thesis.

    \b
    The 1971 chain:
      pdp8 part circle -o circle.asc
      pdp8 run eia.pal --reader circle.asc --punch circle.eia
      pdp8 nc plot circle.eia -o circle.svg
    """


def main() -> None:
    command.run(pdp8, "pdp8")
