"""Objects of the page at a second use, at an end, or while the first use is still going on (again*.mjs)."""

import json
import re
from functools import cache
from pathlib import Path

import pytest

from tests.pdp8.web import node

SOURCES = sorted(Path(__file__).parent.glob("again*.mjs"))
CASES = [
    (source.stem, name)
    for source in SOURCES
    for name in re.findall(r'^  "(.+)": async', source.read_text(encoding="utf-8"), re.MULTILINE)
]
_ALL = """async (module) => {
  const { cases } = await import("@/" + module + ".mjs");
  const seen = {};
  for (const [name, act] of Object.entries(cases)) {
    seen[name] = await act().catch((error) => [String(error.stack), "no error"]);
  }
  return JSON.stringify(seen);
}"""

pytestmark = node.needs_node


@cache
def _seen(module: str) -> dict[str, list[object]]:
    seen: dict[str, list[object]] = json.loads(node.in_node(_ALL, module))
    return seen


@pytest.mark.parametrize(("module", "name"), CASES)
def test_again(module: str, name: str) -> None:
    seen, wanted = _seen(module)[name]
    assert seen == wanted
