"""An editor that debugs: a conversation with `pdp8 dap`, held by Microsoft's own client under Node.js.

seen = play(folder, *launched({"program": "hello.pal"}), ["continue", {}, "stopped"])
seen.answers[-1]["event"]["reason"], seen.page
"""

import json
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from tests.commands import BIN
from tests.pdp8.web.node import NODE

NPM = Path(__file__).parents[2] / "node"
CLIENT = NPM / "debug_client.mjs"

Step = Sequence[Any]


class Seen(NamedTuple):
    """What an editor was answered, step by step, and what was put out, each with its category."""

    answers: list[dict[str, Any]]
    output: list[tuple[str, str]]

    @property
    def page(self) -> str:
        """What the Teletype has printed."""
        return "".join(text for category, text in self.output if category == "stdout")


def play(folder: Path, *steps: Step) -> Seen:
    """Hold a conversation: each step is a request, its arguments, the event that is to come of it."""
    if NODE is None or not (NPM / "node_modules" / "@vscode").exists():
        pytest.skip("the debug client is not installed: npm install --prefix tests/node")
    whole = [[*step, *({}, None)[len(step) - 1 :]] for step in steps]
    asked = {"adapter": [str(BIN / "pdp8"), "dap"], "steps": whole}
    done = subprocess.run(
        [NODE, str(CLIENT)],
        input=json.dumps(asked),
        capture_output=True,
        text=True,
        cwd=folder,
        check=False,
        timeout=60,
    )
    assert done.returncode == 0, done.stderr
    return Seen(**json.loads(done.stdout))


def launched(arguments: dict[str, Any], *breakpoints: Step) -> list[Step]:
    """Return the steps up to where the program stands before its first instruction."""
    return [
        ["initialize", {"adapterID": "pdp8", "linesStartAt1": True}],
        ["launch", {"stopOnEntry": True, **arguments}, "initialized"],
        *breakpoints,
        ["configurationDone", {}, "stopped"],
    ]
