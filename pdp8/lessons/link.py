"""A link that opens the workbench where an answer goes wrong: the program in the editor, the machine as it is
at START, and how many instructions it runs from there; all of them can be undone.
"""

import base64
import json
import zlib
from typing import Any

from pdp8.computer.hardware.devices import one_of_each
from pdp8.computer.machine import Machine
from pdp8.computer.past.state import HEAD, save

PAGE = "pdp8.html"


def link(name: str, source: str, machine: Machine, until: int) -> str:
    """Return the link; `until` is the number of instructions to run from the state."""
    state = _other(json.loads(save(machine)), json.loads(save(Machine(one_of_each()))))
    shared = {"program": {"name": name, "text": source}, "machine": {**HEAD, **state}, "until": until}
    packed = zlib.compress(json.dumps(shared, separators=(",", ":")).encode(), 9, wbits=-15)
    return f"{PAGE}#s={base64.urlsafe_b64encode(packed).decode().rstrip('=')}"


def _other(state: dict[str, Any], usual: dict[str, Any]) -> dict[str, Any]:
    """Return the unusual parts of a state."""
    found = {}
    for key, value in state.items():
        before = usual.get(key)
        other = (
            _other(value, before if isinstance(before, dict) else {}) if isinstance(value, dict) else value
        )
        if other not in (before, {}):
            found[key] = other
    return found
