"""`pdp8 check`: the answers of a class to an exercise, marked."""

import os
import sys
from collections.abc import Iterator, Sequence
from itertools import chain, count

import click

from pdp8.cli.shared import command
from pdp8.cli.shared.arguments import Command, Folder, Source, Target
from pdp8.cli.shared.parameters import dialect_option, processor_seconds
from pdp8.cli.shared.rules import flag, option
from pdp8.computer.past import state
from pdp8.lessons import (
    alike,
    bounded,
    form,
    handed,
    link,
    marking,
    page,
    proof,
    records,
    scores,
    student,
    where,
)
from pdp8.lessons.answer import Answer, assembled
from pdp8.lessons.exercise import Exercise
from pdp8.lessons.marking import Result
from tapes.errors import WorkError
from tapes.quantities import counted

_SHOWN = ("task", "solution")
_BYTE_ORDER_MARK = "\ufeff"
"""Without it Excel reads a CSV file in the system's own encoding, and names come out wrong."""


@click.command(cls=Command)
@click.argument("exercise", type=Source(form.bundled), required=False)
@click.argument("answer", type=Source(), nargs=-1)
@flag("--list listed", "List the bundled exercises.", only="")
@option(
    "--show", "Show the exercise's task, or the teacher's solution.", click.Choice(_SHOWN), only="EXERCISE"
)
@flag(
    "--prove",
    "Test the exercise: its solution, slips in it, and what the task says.",
    only="EXERCISE --seed",
)
@flag(
    "--where shows_where",
    "Say where each answer goes wrong; write the machine there, and a link for the workbench.",
    needs="ANSWER",
    excludes="--variants",
    writes=True,
)
@dialect_option()
@option("--json", "Write the marks as JSON.", Target("JSON"))
@option("--csv", "Write the marks for a spreadsheet.", Target("text"))
@option("--junit", "Write the marks as JUnit does.", Target("XML"))
@option("--gradescope", "Write the marks of one ANSWER for Gradescope's autograder.", Target("JSON"))
@option("--pages", "Write a page for each student into FOLDER.", Folder())
@option("--seed", "Draw random cases from this.", int, metavar="N", default=form.SEED)
@option(
    "--variants",
    "Give each ANSWER random cases of its own, by its name and --seed; write the seeds as CSV.",
    Target("text"),
)
@option(
    "--cpu",
    "Of processor time, the most an answer may take.",
    processor_seconds,
    default=bounded.SECONDS,
    metavar="SECONDS",
)
@option(
    "--export-student",
    "Write the exercise without what students must not have.",
    Target("JSON"),
    only="EXERCISE",
)
@click.pass_context
def check(
    ctx: click.Context,
    exercise: str | None,
    answer: tuple[str, ...],
    listed: bool,
    show: str | None,
    prove: bool,
    shows_where: bool,
    dialect: str,
    json: str | None,
    csv: str | None,
    junit: str | None,
    gradescope: str | None,
    variants: str | None,
    pages: str | None,
    seed: int,
    cpu: float,
    export_student: str | None,
) -> None:
    """Mark each ANSWER to EXERCISE: run it on the exercise's cases, or compare a sheet of answers.

    EXERCISE is a file in TOML, or the name of a bundled one; docs/lessons.md of the sources says how to write
    your own. An ANSWER is PAL III source, a BIN or RIM tape or its dump, or a text with a line for each
    question; - is standard input. An answer gets a bounded time, core and tape, whatever it does. The table
    of marks goes to standard output, unless --json, --csv or --junit does.

    Answers that look alike, but for comments and names, are named below the table: a hint, no proof.

    Exit status: 0 every answer is right, 1 one is not.

    \b
    Examples:
      pdp8 check --list
      pdp8 check add --show task
      pdp8 check add ana.pal ben.pal
      pdp8 check homework.toml answers/*.pal --json marks.json
      pdp8 check homework.toml answers/*.pal --csv marks.csv --pages marks --seed 3
      pdp8 check homework.toml --export-student homework-student.json
      pdp8 check homework.toml --prove
    """
    if listed:
        for name in form.bundled():
            command.echo(f"{name:18} {form.title(name)}")
        return
    if exercise is None:
        raise click.UsageError("Give an EXERCISE; --list has the bundled ones.")
    read = form.read(exercise, student.SEED if export_student else seed)
    if export_student:
        command.put(export_student, student.form(read))
    elif show == "task":
        command.echo(read.asked.strip("\n"))
    elif not read.solution and (show or prove):
        raise WorkError(f"{exercise}: solution is missing; a student's form has none")
    elif show:
        command.echo(read.solution.strip("\n"))
    elif prove:
        _prove(read, exercise, seed)
    elif not answer:
        raise click.UsageError("Give an ANSWER, or --show task, or --prove.")
    else:
        for name in answer:
            if os.path.isdir(name):
                raise WorkError(f"{name}: a folder; name the answers in it: {os.path.join(name, '*')}")
            if name != "-" and not os.path.exists(name):
                raise WorkError(f"{name}: no such file; no answer was marked")
        answers = [handed.read(name) for name in answer]
        if gradescope is not None and len(answers) > 1:
            raise click.UsageError(f"--gradescope is for one ANSWER, not {len(answers)}.")
        if variants is None:
            results = bounded.marked(read, answers, cpu, dialect)
        else:
            stems = [_stem(given.name) for given in answers]
            seeds = {
                given.name: form.variant(given.name if stems.count(stem) > 1 else stem, seed)
                for given, stem in zip(answers, stems, strict=True)
            }
            results = [
                result
                for given in answers
                for result in bounded.marked(form.read(exercise, seeds[given.name]), [given], cpu, dialect)
            ]
            command.put(variants, records.as_list(seeds))
        if pages is not None:
            command.put_all(pages, _pages(read, results))
        if csv is not None:
            mark = "" if csv == "-" else _BYTE_ORDER_MARK
            command.put(csv, mark + records.as_csv(read, results))
        if junit is not None:
            command.put(junit, records.as_junit(read, results))
        if json is not None:
            command.put(json, records.as_json(read, results))
        if gradescope is not None:
            command.put(gradescope, records.as_gradescope(read, results[0]))
        if "-" not in (csv, junit, json, gradescope, variants):
            _show(read, answers, results)
        if shows_where:
            _where(read, answers, results, dialect)
        ctx.exit(0 if all(result.right for result in results) else 1)


def _stem(name: str) -> str:
    """Return the name of a student's files: the answer's, without folder and ending."""
    return os.path.splitext(os.path.basename(name))[0]


def _names(results: Sequence[Result]) -> list[str]:
    """Return the name of each student's files, with a number where it is repeated."""
    names: list[str] = []
    for result in results:
        stem = _stem(result.answer)
        numbered = (f"{stem}-{number}" for number in count(2))
        names.append(next(name for name in chain([stem], numbered) if name not in names))
    return names


def _pages(exercise: Exercise, results: Sequence[Result]) -> Iterator[tuple[str, bytes]]:
    """Yield a page for each answer."""
    for name, result in zip(_names(results), results, strict=True):
        yield f"{name}.html", page.html(exercise, result).encode()


def _show(exercise: Exercise, answers: Sequence[Answer], results: Sequence[Result]) -> None:
    from rich.console import Console

    command.echo(f"{exercise.title}\n")
    console = Console(file=sys.stdout, highlight=False)
    with console.capture() as table:
        console.print(scores.table(exercise, results))
    click.echo(table.get(), nl=False)
    for result in results:
        said = "\n".join(scores.details(result))
        if said:
            command.echo(f"\n{said}")
    if exercise.note:
        command.echo(f"\n{exercise.note}")
    found = alike.pairs(answers) if exercise.cases else []
    if found:
        command.echo("\nalike but for comments and names, a hint and no proof:")
    for pair in found:
        command.echo(f"  {scores.visible(pair.one)}  {scores.visible(pair.other)}  {pair.shared:.0%}")


def _where(exercise: Exercise, answers: Sequence[Answer], results: Sequence[Result], dialect: str) -> None:
    """Say where the first visible failed case of each answer goes wrong."""
    for given, result, stem in zip(answers, results, _names(results), strict=True):
        names = [mark.name for mark in result.marks if mark.failures and not mark.hidden]
        case = next((case for case in exercise.cases if case.name in names), None)
        if case is None:
            continue
        answer = assembled(given, dialect)
        whole, failed = next(
            (each, failed)
            for each in case.trials
            if (failed := marking.first_failed(answer, each)) is not None
        )
        place = where.find(answer, whole, failed)
        machine = where.standing(answer, whole, failed.outcome.number)
        name = os.path.basename(given.name)
        opened = link.link(name, given.source, machine, place.instructions)
        machine.run(instructions=place.instructions)
        machine.stop()
        after = counted(place.instructions, "instructions")
        command.echo(
            f"\n{given.name}: {case.name}: at {place.address:04o}, {after} after START: {place.says}"
        )
        command.check_output(f"{stem}.state")
        command.put(f"{stem}.state", state.save(machine))
        command.echo(opened)


def _prove(exercise: Exercise, name: str, seed: int) -> None:
    """Raise WorkError unless the exercise accepts its solution and rejects its mistakes."""
    solved = proof.solution(exercise)
    if not solved.right:
        said = "\n".join(scores.details(solved))
        raise WorkError(f"{exercise.name}: its own solution is not right\n{said}")
    marked, written = list(proof.mistakes(exercise)), proof.restated(exercise)
    slips = proof.slips(lambda number: form.read(name, number), seed)
    faults = [f"accepted as right: {what}" for what, result in marked if result.right]
    faults += [f"accepted as right with this seed, but not with each seed: {slip}" for slip in slips.lucky]
    faults += [f"the solution, {how}, loses points" for how, result in written if not result.right]
    faults += proof.untold(exercise)
    if faults:
        raise WorkError("\n".join(f"{exercise.name}: {fault}" for fault in faults))
    ways = f"; {counted(len(written), 'ways')} to write it, all right" * bool(written)
    noticed = f"; {counted(len(marked), 'mistakes')}, all noticed" * bool(marked)
    command.echo(f"{exercise.name}: the solution has {counted(solved.of, 'points')}{ways}{noticed}")
    if slips.tried:
        caught = slips.tried - len(slips.survivors)
        right = "; these seem right:" * bool(slips.survivors)
        command.echo(f"{slips.tried} of {counted(slips.number, 'slips')} tried, {caught} noticed{right}")
    for slip in slips.survivors:
        command.echo(f"  {slip}")
