"""Run random situations on the machine and on the reference.

    python -m tests.pdp8.computer.lockstep INSTRUCTIONS [SEED]

Ends with exit status 1 at the first difference, after it has shrunk the situation to a listing.
"""

import sys
import time

from tests.pdp8.computer.lockstep.play import listing, play
from tests.pdp8.computer.lockstep.shrink import shrink
from tests.pdp8.computer.lockstep.situations import situation

EVERY = 30
"""Seconds between two lines that say how far it is."""


def main(instructions: int, seed: int) -> int:
    """Run situations from `seed` on until so many instructions are done; return the exit status."""
    form = "compiled"
    done, began, shown, first = 0, time.monotonic(), time.monotonic(), seed
    while done < instructions:
        played = play(situation(seed), form)
        if played.difference:
            print(f"seed {seed}: {played.difference}\n")
            smallest = shrink(situation(seed), lambda smaller: bool(play(smaller, form).difference))
            print(f"the same, with less:\n{listing(smallest)}\n{play(smallest, form).difference}")
            return 1
        done += played.instructions
        seed += 1
        if time.monotonic() > shown + EVERY:
            shown = time.monotonic()
            print(f"{done:,} instructions, {seed - first:,} situations, {shown - began:.0f} s", flush=True)
    print(f"{done:,} instructions in {seed - first:,} situations: 0 differences")
    print(f"{time.process_time():.0f} s of processor time")
    return 0


if __name__ == "__main__":
    sys.exit(main(int(float(sys.argv[1])), int(sys.argv[2]) if len(sys.argv) > 2 else 0))
