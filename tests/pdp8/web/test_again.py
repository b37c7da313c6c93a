"""Objects of the page at a second use, at an end, or while the first use is still going on (again.mjs)."""

import json
import re
import shutil
from functools import cache
from pathlib import Path

import pytest

from tests.pdp8.web import node

SOURCE = Path(__file__).with_name("again.mjs")
CASES = re.findall(r'^  "(.+)": async', SOURCE.read_text(encoding="utf-8"), re.MULTILINE)
_ALL = """async () => {
  const { cases } = await import("@/again.mjs");
  const seen = {};
  for (const [name, act] of Object.entries(cases)) {
    seen[name] = await act().catch((error) => [String(error.stack), "no error"]);
  }
  return JSON.stringify(seen);
}"""

pytestmark = node.needs_node


@cache
def _seen() -> dict[str, list[object]]:
    shutil.copy(SOURCE, node.modules())
    seen: dict[str, list[object]] = json.loads(node.in_node(_ALL))
    return seen


@pytest.mark.parametrize("name", CASES)
def test_again(name: str) -> None:
    seen, wanted = _seen()[name]
    assert seen == wanted
