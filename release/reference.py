"""The page of all commands: each `--help` as click has it, in the order and the groups of `pdp8 --help`.

python -m release.reference > reference.md
"""

from collections.abc import Iterator

import click

from pdp8.cli.root import pdp8

_WIDTH = 84


def commands(context: click.Context) -> Iterator[click.Context]:
    """Yield the context of a command and of all below it."""
    yield context
    if isinstance(context.command, click.Group):
        for name in context.command.list_commands(context):
            found = context.command.get_command(context, name)
            if found and not found.hidden:
                yield from commands(_context(found, name, context))


def reference() -> str:
    """Return the page."""
    found = commands(_context(pdp8, "pdp8"))
    return "# Every command\n\n" + "\n".join(_section(context) for context in found)


def _context(found: click.Command, name: str, parent: click.Context | None = None) -> click.Context:
    return click.Context(
        found, info_name=name, parent=parent, terminal_width=_WIDTH, max_content_width=_WIDTH
    )


def _section(context: click.Context) -> str:
    level = "#" * min(4, context.command_path.count(" ") + 1 + 1)
    return f"{level} `{context.command_path}`\n\n```text\n{context.get_help()}\n```\n"


if __name__ == "__main__":
    print(reference())
