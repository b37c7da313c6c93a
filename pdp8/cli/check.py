"""`pdp8 check`: the answers of a class to an exercise, marked."""

import sys
from collections.abc import Sequence

import click

from pdp8.computer.use.program import DIALECTS, FOUND
from pdp8.lessons import answer as answers
from pdp8.lessons import exercise as exercises
from pdp8.lessons import marking, proof
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Result
from tapes import command
from tapes.arguments import Command, Source, Target
from tapes.errors import WorkError

_SHOWN = ("task", "solution")


@click.command(cls=Command)
@click.argument("exercise", type=Source(exercises.bundled), required=False)
@click.argument("answer", type=Source(), nargs=-1)
@click.option("--list", "listed", is_flag=True, help="List the bundled exercises.")
@click.option(
    "--show", type=click.Choice(_SHOWN), help="Show the exercise's task, or the teacher's solution."
)
@click.option("--prove", is_flag=True, help="Mark the exercise's own solution and its known mistakes.")
@click.option("--dialect", type=click.Choice(DIALECTS), default=FOUND, help="That of PAL source.")
@click.option("--json", type=Target("JSON"), metavar="FILE", help="Write the marks as JSON.")
@click.option("--junit", type=Target("XML"), metavar="FILE", help="Write the marks as JUnit does.")
@click.pass_context
def check(
    ctx: click.Context,
    exercise: str | None,
    answer: tuple[str, ...],
    listed: bool,
    show: str | None,
    prove: bool,
    dialect: str,
    json: str | None,
    junit: str | None,
) -> None:
    """Mark each ANSWER to EXERCISE: run it on the exercise's cases, or compare a sheet of answers.

    EXERCISE is a file in TOML, or the name of a bundled one; docs/lessons.md of the sources says how to write
    your own. An ANSWER is PAL III source, a BIN or RIM tape, or a text with a line for each question; - is
    standard input. An answer gets a bounded time, core and tape, whatever it does. The table of marks goes to
    standard output, unless --json - or --junit - does.

    Exit status: 0 every answer is right, 1 one is not.

    \b
    Examples:
      pdp8 check --list
      pdp8 check add --show task
      pdp8 check add ana.pal ben.pal
      pdp8 check homework.toml answers/*.pal --json marks.json
      pdp8 check homework.toml --prove
    """
    if listed:
        _list()
        return
    if exercise is None:
        raise click.UsageError("Give an EXERCISE; --list has the bundled ones.")
    read = exercises.read(exercise)
    if show:
        command.echo((read.task if show == "task" else read.solution).strip("\n"))
    elif prove:
        _prove(read)
    elif not answer:
        raise click.UsageError("Give an ANSWER, or --show task, or --prove.")
    else:
        results = [marking.mark(read, answers.read(name), dialect) for name in answer]
        _write(read, results, json, junit)
        ctx.exit(0 if all(result.right for result in results) else 1)


def _list() -> None:
    for name in exercises.bundled():
        command.echo(f"{name:18} {exercises.read(name).title}")


def _write(exercise: Exercise, results: Sequence[Result], json: str | None, junit: str | None) -> None:
    from pdp8.lessons import records

    if junit is not None:
        command.put(junit, records.as_junit(exercise, results))
    if json is not None:
        command.put(json, records.as_json(exercise, results))
    if "-" not in (json, junit):
        _show(exercise, results)


def _show(exercise: Exercise, results: Sequence[Result]) -> None:
    from rich.console import Console

    from pdp8.lessons import scores

    command.echo(f"{exercise.title}\n")
    console = Console(file=sys.stdout, highlight=False)
    with console.capture() as table:
        console.print(scores.table(exercise, results))
    click.echo(table.get(), nl=False)
    for result in results:
        said = "\n".join(scores.details(result))
        if said:
            command.echo(f"\n{said}")


def _prove(exercise: Exercise) -> None:
    """Say whether the exercise tells its known mistakes from its solution. Raises WorkError if not."""
    from pdp8.lessons import scores

    solved = proof.solution(exercise)
    if not solved.right:
        said = "\n".join(scores.details(solved))
        raise WorkError(f"{exercise.name}: its own solution is not right\n{said}")
    marked = list(proof.mistakes(exercise))
    passed = [what for what, result in marked if result.right]
    if passed:
        raise WorkError(f"{exercise.name}: taken for right: {'; '.join(passed)}")
    command.echo(f"{exercise.name}: the solution has {solved.of} points; {len(marked)} mistakes, all noticed")
