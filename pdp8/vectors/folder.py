"""A set of vectors as a folder: compressed vectors, what differs on other models, README and runners.

The same version of the project always gives the same bytes.
"""

import gzip
import io
import json
from collections.abc import Iterable, Iterator
from importlib import resources
from typing import Any

from pal.isa import GROUP_2, GROUP_3, IOT, OPERATIONS, OPR
from pal.models import MODELS, RULES
from pdp8.vectors import devices, hands, interrupts
from pdp8.vectors.record import Recorder, Vector
from pdp8.vectors.states import PROTECTED, states

COPIED = ("README.md", "runner.py", "runner.c", "emulator.h", "runner_test.go")
GROUPS = {
    **{name.lower(): list(range(code << 9, code + 1 << 9)) for code, name in enumerate(OPERATIONS[:OPR])},
    "opr1": list(range(0o7000, 0o7400)),
    "opr2": [word for word in range(0o7400, 0o10000) if word & GROUP_3 == GROUP_2],
    "opr3": [word for word in range(0o7400, 0o10000) if word & GROUP_3 == GROUP_3],
}
"""The words of each file."""
DEVICES = ("teletype", "pc8l")
COUNT = len(GROUPS) + 2 + len(DEVICES) + 2 + len(COPIED)
"""How many files there are."""


def files(count: int, pipan8l: bool = False) -> Iterator[tuple[str, bytes]]:
    """Yield name and content of every file, with `count` states for every word; `pipan8l` adds hands.tcl."""
    recorder = Recorder()
    for name, words in GROUPS.items():
        yield f"{name}.json.gz", _compressed(_single(recorder, words, count))
    yield "mem_prot.json.gz", _compressed(_protected(recorder))
    yield "interrupts.json.gz", _compressed(interrupts.vectors(recorder))
    for name in DEVICES:
        yield f"{name}.json.gz", _compressed(devices.vectors(name))
    yield "hands.json.gz", _compressed(hands.vectors())
    if pipan8l:
        yield "hands.tcl", hands.pipan8l(hands.vectors()).encode()
    yield "differences.json", differences().encode()
    for name in COPIED:
        yield name, resources.files("pdp8.vectors").joinpath(name).read_bytes()


def _single(recorder: Recorder, words: Iterable[int], count: int) -> Iterator[Vector]:
    number = 0
    for some in states(count):
        for word in words:
            for place, state in enumerate(some):
                yield recorder.vector(f"{word:04o} {number + place}", state, word)
        number += len(some)


def _protected(recorder: Recorder) -> Iterator[Vector]:
    """Yield every memory reference with MEM PROT up, within the page that it protects and beside it."""
    half = len(PROTECTED) // 2
    for word in range(IOT << 9):
        for number in (word % half, word % half + half):
            yield recorder.vector(f"{word:04o} {number}", PROTECTED[number], word, mem_prot=1)


def _compressed(vectors: Iterable[dict[str, Any]]) -> bytes:
    """Return a JSON list with one vector a line, compressed; no time and no name in the header."""
    lines = ",\n".join(json.dumps(vector, separators=(",", ":")) for vector in vectors)
    packed = io.BytesIO()
    with gzip.GzipFile(filename="", mode="wb", compresslevel=9, fileobj=packed, mtime=0) as file:
        file.write(f"[\n{lines}\n]\n".encode())
    return packed.getvalue()


def differences() -> str:
    """Return what words do on which model, as JSON."""
    rules = [{"mask": rule.mask, "value": rule.value, "does": rule.does} for rule in RULES]
    return json.dumps({"models": MODELS, "rules": rules}, indent=1) + "\n"
