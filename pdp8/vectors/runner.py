"""Play the vectors of a folder on an emulator: python runner.py FOLDER MODULE:EMULATOR [MODEL]

EMULATOR has two methods, of which a vector needs one:

    step(initial, cycles)          set the registers and core of "initial", run so many memory cycles, return
                                   {"final": ..., "ticks": ..., "cycles": ...}
    play(initial, inputs, ticks)   do the inputs among "events" to a machine as switched on, return all events

What they leave out is not compared; None is what they cannot do. With a MODEL, words that differ on it are
passed over.
"""

import gzip
import importlib
import json
import sys
from pathlib import Path
from typing import Any

INPUTS = ("iot", "key", "start")


def play(vector: dict[str, Any], emulator: Any) -> str | None:
    """Return the first difference, "" if there is none, None if the emulator cannot do the vector."""
    if "events" in vector:
        inputs = [event for event in vector["events"] if any(name in event for name in INPUTS)]
        done = emulator.play(vector["initial"], inputs, vector["ticks"])
        got = None if done is None else {"events": done}
    else:
        got = emulator.step(vector["initial"], len(vector["cycles"]))
    return None if got is None else first_difference(got, vector, "")


def first_difference(got: Any, expected: Any, where: str) -> str:
    """Return where `got` differs from `expected`, as far as it says anything."""
    if isinstance(got, dict) and isinstance(expected, dict):
        for name in got:
            found = first_difference(got[name], expected.get(name), f"{where} {name}")
            if found:
                return found
        return ""
    if isinstance(got, list | tuple) and isinstance(expected, list | tuple) and len(got) == len(expected):
        all_found = (first_difference(one, expected[i], f"{where} {i}") for i, one in enumerate(got))
        return next(filter(None, all_found), "")
    return "" if got == expected else f"{where.strip()} is {got}, not {expected}"


def passed_over(vector: dict[str, Any], rules: list[dict[str, Any]], model: str) -> bool:
    """Tell whether the model does otherwise what the vector's words do on an 8/L."""
    words = [mb for state, _, mb in vector.get("cycles", ()) if state == "FETCH"]
    words += [event["iot"] for event in vector.get("events", ()) if "iot" in event]
    return any(
        word & rule["mask"] == rule["value"] and rule["does"].get(model) != rule["does"]["8/L"]
        for word in words
        for rule in rules
    )


def main(folder: Path, emulator: Any, model: str = "8/L") -> int:
    """Play all vectors; return the exit status."""
    rules = json.loads((folder / "differences.json").read_text())["rules"]
    failed = 0
    for file in sorted(folder.glob("*.json.gz")):
        vectors = json.loads(gzip.decompress(file.read_bytes()))
        fit = [vector for vector in vectors if model == "8/L" or not passed_over(vector, rules, model)]
        results = [(vector["name"], play(vector, emulator)) for vector in fit]
        wrong = [(name, found) for name, found in results if found]
        done = sum(found is not None for _, found in results)
        print(f"{file.name}: {done} of {len(vectors)} played, {len(wrong)} differ")
        print("".join(f"  {name}: {found}\n" for name, found in wrong[:3]), end="")
        failed += len(wrong)
    return 1 if failed else 0


if __name__ == "__main__":
    module, name = sys.argv[2].split(":")
    sys.exit(main(Path(sys.argv[1]), getattr(importlib.import_module(module), name)(), *sys.argv[3:]))
