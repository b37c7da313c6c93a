"""The options of all commands as they are declared, tried alone and two by two.

python -m tests.options.pairs                all
python -m tests.options.pairs run "nc cut"   those of some commands

An option acts if what a call does is other with it than without: a byte of its output, its files or its
messages, or its status. Two act together if the call with both is other than that with either alone. One of
the calls of inputs.py has to show it; else the call with both has to be refused, with status 2.
"""

import sys
from collections.abc import Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import cache
from itertools import combinations
from typing import NamedTuple

import click

from pdp8.cli.root import pdp8
from pdp8.cli.shared import rules
from release.reference import commands
from tests.options import inputs
from tests.options.trial import Outcome, outcome

ACT, REFUSED, HIDDEN = "act", "refused", "hidden"


class Pair(NamedTuple):
    """One option of a command, or two, by their names."""

    command: str
    options: tuple[str, ...]


def declared() -> dict[str, list[str]]:
    """Return the options of each command by its name, without those that end it before it begins."""
    found = {}
    for context in commands(click.Context(pdp8, info_name="pdp8")):
        name = context.command_path.partition(" ")[2]
        if not isinstance(context.command, click.Group):
            params = (param for param in context.command.params if _may_be_given(param))
            options = (rules.words(param)[0] for param in params)
            found[name] = [option for option in options if option not in inputs.ENDS]
    return found


def _may_be_given(param: click.Parameter) -> bool:
    """Whether it is an option, or an argument that may be left out and has no default."""
    return isinstance(param, click.Option) or not (param.required or param.nargs < 0 or param.default == "-")


def pairs(names: Iterable[str] = ()) -> Iterator[Pair]:
    """Yield each option of the commands of those names, all without names, and each two."""
    chosen = list(names)
    for name, options in declared().items():
        if not chosen or name in chosen:
            for count in (1, 2):
                yield from (Pair(name, some) for some in combinations(options, count))


def tried(pair: Pair) -> str:
    """Return ACT, REFUSED or HIDDEN; or what is wrong with the options."""
    if hidden(pair):
        return HIDDEN
    said = "no call of inputs.py tries it"
    refused = []
    for call in inputs.CALLS.get(pair.command, ()):
        if any(option in call.split() for option in pair.options) or (call and pair.options[0].isupper()):
            continue
        both = _outcome(pair.command, call, pair.options)
        refused.append(both.refused)
        if not both.refused:
            each = ([*pair.options[:at], *pair.options[at + 1 :]] for at in range(len(pair.options)))
            fewer = [_outcome(pair.command, call, tuple(options)) for options in each]
            if all(both != other for other in fewer):
                return ACT
            said = f"pdp8 {_line(pair.command, call, pair.options)}: one of them changes nothing"
    return REFUSED if refused and all(refused) and len(pair.options) == 2 else said


def hidden(pair: Pair) -> str:
    """Return why the options cannot show what they do, or nothing."""
    singles = [inputs.HIDDEN.get(f"{pair.command} {option}", "") for option in pair.options]
    group = pair.command.partition(" ")[0]
    if len(pair.options) == 2 and inputs.STOPS.get(group) in pair.options:
        return "ends the call at a fault of the tape"
    together = inputs.HIDDEN.get(f"{pair.command} {' '.join(pair.options)}", "")
    return inputs.HIDDEN.get(pair.command, "") or together or next(filter(None, singles), "")


def _line(command: str, call: str, options: Iterable[str]) -> str:
    given = (f"{option * (option[0] == '-')} {inputs.value(command, option)}".strip() for option in options)
    return " ".join([command, *given, call])


@cache
def _outcome(command: str, call: str, options: tuple[str, ...]) -> Outcome:
    return outcome(_line(command, call, options), inputs.FILES, inputs.STDIN.get(command, b""))


def main() -> None:
    """Try the pairs of the commands given, or of all; print what is wrong."""
    chosen, found = list(pairs(sys.argv[1:])), {}
    with ProcessPoolExecutor() as pool:
        for pair, how in zip(chosen, pool.map(tried, chosen, chunksize=20), strict=True):
            found[pair] = how
            if how not in (ACT, REFUSED, HIDDEN):
                print(f"{pair.command} {' '.join(pair.options)}: {how}", flush=True)
    wrong = sum(how not in (ACT, REFUSED, HIDDEN) for how in found.values())
    print(f"{len(found):,} single options and pairs, {wrong} without effect")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
