"""Put every fault of the catalogue into a copy of the sources and run its tests; print the table.

    python -m tests.faults [-j JOBS] [NAME...]     only those whose package or name has NAME in it

Exit status 1 if a fault is not caught, if it does not fit any more, or if the tests fail without one.
"""

import argparse
import sys
import time
from concurrent.futures import ThreadPoolExecutor

from tests.faults.catalogue import Fault, catalogue
from tests.faults.workshop import first_failure


def main(names: list[str], jobs: int) -> int:
    began = time.monotonic()
    faults = [
        fault
        for fault in catalogue()
        if not names or any(name in f"{fault.package} {fault.name}" for name in names)
    ]
    if failure := first_failure(sorted({test for fault in faults for test in fault.tests})):
        print(f"without a fault: {failure} fails")
    with ThreadPoolExecutor(jobs) as pool:
        caught = list(pool.map(_caught, faults))
    print(f"\n{len(faults)} faults, {caught.count(False)} not caught, {time.monotonic() - began:.0f} s")
    return 0 if all(caught) and not failure else 1


def _caught(fault: Fault) -> bool:
    """Print a line of the table; return whether a test finds the fault."""
    verdict = "passes  "
    try:
        if by := first_failure(fault.tests, fault):
            verdict = f"caught   {by}"
    except ValueError as error:
        verdict = f"does not fit: {error}"
    caught = verdict.startswith("caught")
    print(f"{' ' if caught else '!'} {fault.package:10} {fault.name:56} {verdict}", flush=True)
    return caught


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Put faults into a copy of the sources and run the tests.")
    parser.add_argument("names", nargs="*", help="only faults whose package or name has one of these in it")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="how many at once [1]")
    arguments = parser.parse_args()
    sys.exit(main(arguments.names, arguments.jobs))
