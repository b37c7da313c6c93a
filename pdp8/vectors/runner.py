"""Play vectors on an emulator: python runner.py MODULE:EMULATOR [--model 8/E] [FILE ...]

MODULE is found in the current folder too; without a FILE all those beside this one are played. With a model
only the vectors that hold for it are. EMULATOR is called without arguments; what it has to offer:

    set(registers)           pc, ac, link, sr, ion, mem_prot; flags down, RUN on, a FETCH comes next
    deposit(address, word)
    examine(address)         return the word
    run(instructions)        run so many, and the interrupt that comes after the last
    get()                    return {"pc": ..., ...}, also run, protect, ticks; what it lacks is not compared

and what it may offer:

    flag(device)             raise it, return whether there is such a device; if not, the vector is left out
    cycle()                  run one memory cycle, return [state, ma, mb]; it is called in place of run
    hand(what, value)        press a key (load_add, start, cont, stop, exam, dep), throw a switch (sr,
                             sing_step, mem_prot), or run until RUN goes off (run). A hand takes a tenth of a
                             second; return the lamps then: {"ma": ..., "state": "FETCH", ...}
    play(initial, inputs, ticks)
                             do the inputs among "events" to a machine as switched on, return all events
"""

import argparse
import gzip
import importlib
import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

INPUTS = ("iot", "key", "start")
REGISTERS = {"pc": 0, "ac": 0, "link": 0, "sr": 0, "ion": 0, "mem_prot": 0}
SHOWN = 20
"""How many words of each file have a difference printed."""


def play(vector: dict[str, Any], emulator: Any) -> str | None:
    """Return the first difference, "" if there is none, None if the emulator cannot do the vector."""
    if "events" in vector:
        return _events(vector, emulator)
    if "hands" in vector:
        return _hands(vector, emulator)
    initial, final = vector["initial"], vector["final"]
    flags = initial.get("flags", [])
    if flags and not hasattr(emulator, "flag"):
        return None
    emulator.set({name: initial.get(name, value) for name, value in REGISTERS.items()})
    for address, word in initial["ram"]:
        emulator.deposit(address, word)
    if not all(emulator.flag(device) for device in flags):
        return None
    if hasattr(emulator, "cycle"):
        for number, expected in enumerate(vector["cycles"], 1):
            for what, got, meant in zip(("state", "MA", "MB"), emulator.cycle(), expected, strict=True):
                if got != meant:
                    return f"{what} of cycle {number} is {_octal(got)}, not {_octal(meant)}"
    else:
        emulator.run(vector["instructions"])
    return _difference(emulator, final | {"ticks": vector["ticks"]})


def _difference(emulator: Any, final: dict[str, Any]) -> str:
    got = emulator.get()
    for name, meant in final.items():
        if name != "ram" and got.get(name, meant) != meant:
            show = str if name == "ticks" else _octal
            return f"{name} is {show(got[name])}, not {show(meant)}"
    for address, meant in final["ram"]:
        word = emulator.examine(address)
        if word != meant:
            return f"core {address:o} is {_octal(word)}, not {_octal(meant)}"
    return ""


def _octal(value: Any) -> str:
    return f"{value:o}" if isinstance(value, int) else str(value)


def _events(vector: dict[str, Any], emulator: Any) -> str | None:
    if not hasattr(emulator, "play"):
        return None
    inputs = [event for event in vector["events"] if any(name in event for name in INPUTS)]
    got = emulator.play(vector["initial"], inputs, vector["ticks"])
    for one, meant in zip(got, vector["events"], strict=False):
        if one != meant:
            return f"{one}, not {meant}"
    expected = len(vector["events"])
    return "" if len(got) == expected else f"{len(got)} events, not {expected}"


def _hands(vector: dict[str, Any], emulator: Any) -> str | None:
    if not hasattr(emulator, "hand"):
        return None
    emulator.set(dict(REGISTERS))
    for address, word in vector["initial"]["ram"]:
        emulator.deposit(address, word)
    for number, one in enumerate(vector["hands"], 1):
        lamps = emulator.hand(one["hand"], one["value"])
        for lamp, meant in one["lamps"].items():
            if lamps.get(lamp, meant) != meant:
                what = f"{lamp} after hand {number}, {one['hand']},"
                return f"{what} is {_octal(lamps[lamp])}, not {_octal(meant)}"
    return _difference(emulator, vector["final"])


def read(file: Path) -> Iterator[dict[str, Any]]:
    """Yield the vectors of a file."""
    with gzip.open(file, "rt") as lines:
        for line in lines:
            if line.startswith("{"):
                yield json.loads(line.rstrip(",\n"))


def main(emulator: Any, files: list[Path], model: str = "8/L") -> int:
    """Play the vectors of the files that hold for the model; return the exit status."""
    failed = 0
    for file in files:
        played = different = 0
        words: dict[str, str] = {}
        for vector in read(file):
            if model in vector["models"] and (found := play(vector, emulator)) is not None:
                played += 1
                different += bool(found)
                if found:
                    words.setdefault(vector["name"].split()[0], f"  {vector['name']}: {found}")
        print(f"{file.name}: {played} played, {different} differ in {len(words)} words")
        print("".join(f"{line}\n" for line in list(words.values())[:SHOWN]), end="", flush=True)
        failed += different
    return 1 if failed else 0


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Play vectors on an emulator.")
    parser.add_argument("emulator", metavar="MODULE:EMULATOR")
    parser.add_argument("files", metavar="FILE", nargs="*", type=Path)
    parser.add_argument("--model", default="8/L", choices=["8", "8/S", "8/I", "8/L", "8/E"])
    arguments = parser.parse_intermixed_args()
    sys.path.insert(0, "")
    module, _, name = arguments.emulator.partition(":")
    if not name:
        parser.error(f"{module}: MODULE:EMULATOR is needed, as in mine:Mine")
    emulator = getattr(importlib.import_module(module), name)()
    files = arguments.files or sorted(Path(__file__).parent.glob("*.json.gz"))
    sys.exit(main(emulator, files, arguments.model))
