"""Put every fault of the catalogue into a copy of the sources and run its tests; print the table.

    python -m tests.faults [-j JOBS] [NAME...]     those alone whose room or name has NAME in it

Exit status 1 if a fault is not caught, if it does not fit any more, or if the tests fail without one.
"""

import argparse
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from queue import Queue

from tests.faults.catalogue import Fault, catalogue
from tests.faults.workshop import LONGEST, Found, Workshop


def main(names: list[str], jobs: int) -> int:
    """Try the faults; return the exit status."""
    faults = [
        fault
        for fault in catalogue()
        if not names or any(name in f"{fault.room} {fault.name}" for name in names)
    ]
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="pdp8-faults-") as folder:
        free: Queue[Workshop] = Queue()
        for number in range(jobs):
            free.put(Workshop(Path(folder) / str(number)))
        sound = _without_a_fault(faults, free)
        with ThreadPoolExecutor(jobs) as pool:
            verdicts = pool.map(lambda fault: _try(fault, free), faults)
            bad = [fault for fault, found in zip(faults, verdicts, strict=True) if not _shown(fault, found)]
    print(f"\n{len(faults)} faults, {len(bad)} not caught, {time.monotonic() - began:.0f} s")
    for fault in bad:
        print(f"  {fault.room}: {fault.name}")
    return 0 if sound and not bad else 1


def _without_a_fault(faults: list[Fault], free: "Queue[Workshop]") -> bool:
    """Run all tests of the faults on the sources as they are; return whether they pass."""
    tests = sorted({test for fault in faults for test in fault.tests})
    workshop = free.get()
    found = workshop.run(tuple(tests), LONGEST * len(tests))
    free.put(workshop)
    if found.verdict != "passes":
        print(f"without a fault: {found.by} fails")
    return found.verdict == "passes"


def _try(fault: Fault, free: "Queue[Workshop]") -> Found:
    workshop = free.get()
    try:
        return workshop.try_out(fault)
    except ValueError as error:
        return Found("does not fit", str(error))
    finally:
        free.put(workshop)


def _shown(fault: Fault, found: Found) -> bool:
    """Print a line of the table; return whether the fault is caught."""
    mark = " " if found.verdict == "caught" else "!"
    print(f"{mark} {fault.room:10} {fault.name:56} {found.verdict:8} {found.by}", flush=True)
    return found.verdict == "caught"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Put faults into a copy of the sources and run the tests.")
    parser.add_argument("names", nargs="*", help="only faults whose room or name has one of these in it")
    parser.add_argument("-j", "--jobs", type=int, default=1, help="how many at once [1]")
    arguments = parser.parse_args()
    sys.exit(main(arguments.names, arguments.jobs))
