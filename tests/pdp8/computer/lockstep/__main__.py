"""Run random situations on the machine in all its forms and on the reference.

    python -m tests.pdp8.computer.lockstep INSTRUCTIONS [SEED [PROCESSES]]

Each situation is played compiled and in JavaScript; one in four, a shorter one, in the plain form too; one in
a hundred is at the Teletype, one in twenty at the panel, one in five with the rack. Ends with exit status 1
at the first difference, after it has shrunk the situation to a listing.
"""

import multiprocessing
import sys
import time
from functools import partial

from tests.pdp8.computer.lockstep.play import Played, listing, play
from tests.pdp8.computer.lockstep.shrink import shrink
from tests.pdp8.computer.lockstep.situations import (
    Situation,
    at_the_panel,
    at_the_teletype,
    in_the_rack,
    situation,
)
from tests.pdp8.web.node import NODE

EVERY = 30
"""Seconds between two lines that say how far it is."""
AT_ONCE = 100
"""Situations that the processes are given together."""
LONGEST, SHORT = 100_000, 3_000
"""Instructions of the longest piece, and of the longest that is played in the plain form too."""
FORMS = ("compiled", "javascript") if NODE else ("compiled",)


def chosen(seed: int) -> tuple[Situation, tuple[str, ...]]:
    """Return the situation of `seed`, and the forms that play it."""
    if seed % 100 == 99:
        return at_the_teletype(seed), FORMS
    if seed % 5 == 2:
        plain = seed % 20 == 2
        return in_the_rack(seed, SHORT if plain else LONGEST), (*FORMS, "plain") if plain else FORMS
    if seed % 20 == 10:
        return at_the_panel(seed), (*FORMS, "plain")
    return (situation(seed), FORMS) if seed % 4 else (situation(seed, SHORT), (*FORMS, "plain"))


def played(seed: int) -> Played:
    """Play the situation of `seed`."""
    return play(*chosen(seed))


def differs(forms: tuple[str, ...], situation: Situation) -> bool:
    """Tell whether the forms differ."""
    return bool(play(situation, forms).difference)


def main(instructions: int, first: int = 0, processes: int = 1) -> int:
    """Run situations from seed `first` on until so many instructions are done; return the exit status."""
    began = shown = time.monotonic()
    done, seed = 0, first
    with multiprocessing.Pool(processes) as pool:
        while done < instructions:
            for ran, difference in pool.map(played, range(seed, seed + AT_ONCE), chunksize=1):
                if difference:
                    whole, forms = chosen(seed)
                    smallest = shrink(whole, partial(differs, forms))
                    print(f"seed {seed}: {difference}\n\nthe same, with less:\n{listing(smallest)}")
                    print(play(smallest, forms).difference)
                    return 1
                done += ran
                seed += 1
            if time.monotonic() > shown + EVERY:
                shown = time.monotonic()
                print(
                    f"{done:,} instructions, {seed - first:,} situations, {shown - began:.0f} s", flush=True
                )
    seconds = time.monotonic() - began
    print(f"{done:,} instructions in {seed - first:,} situations: 0 differences, {seconds:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main(int(float(sys.argv[1])), *(int(each) for each in sys.argv[2:])))
