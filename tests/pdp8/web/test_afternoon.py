"""The afternoon as the page does it: the same script of the operator's hands, translated, beside Python's."""

import json
import random
from typing import Any

from pdp8.computer.past import state
from pdp8.replay import Afternoon
from pdp8.replay.day import PROGRAMS
from tapes import shelf
from tests.pdp8.web.follower import Follower
from tests.pdp8.web.node import in_node, needs_node

pytestmark = needs_node

_AT = """async ({ text, sources, instants }) => {
  const { Day, Judgement } = await import("@/pdp8/replay/day.mjs");
  const { Script } = await import("@/pdp8/replay/script.mjs");
  const { save } = await import("@/pdp8/computer/past/state.mjs");
  const { dict } = await import("@/pdp8/web/translator/runtime.mjs");
  const programs = dict(Object.entries(sources).map(([name, source]) => [name, source.encode("latin-1")]));
  const day = new Day("circle", text, programs, () => new Judgement("Inspection", "", ""));
  const script = new Script(day);
  const began = performance.now();
  let longest = 0;
  let last = began;
  for (const _ of script.rehearse()) {
    longest = Math.max(longest, performance.now() - last);
    last = performance.now();
  }
  const took = performance.now() - began;
  let seek = 0;
  const states = instants.map((tick) => {
    const from = performance.now();
    script.to(tick);
    seek = Math.max(seek, performance.now() - from);
    return save(script.machine);
  });
  return { took, longest, seek, end: script.end, states, actions: day.actions.map((action) => [...action]) };
}"""


def test_any_instant_is_the_same_as_in_python(circle: Afternoon) -> None:
    """Ten instants in any order: the whole state, so lamps, core and tapes, is that of Python's machine."""
    draw = random.Random(71)
    translation = circle.acts[4]
    instants = [draw.randrange(circle.acts[-1].ends) for _ in range(5)]
    instants += [draw.randrange(translation.starts, translation.ends) for _ in range(5)]
    draw.shuffle(instants)
    sources = {name: shelf.read_bundled(name).decode("latin-1") for name in PROGRAMS}
    there = in_node(_AT, {"text": circle.text, "sources": sources, "instants": instants})
    print({name: there[name] for name in ("took", "longest", "seek")})
    assert there["end"] == circle.acts[-1].ends
    assert there["actions"] == [list(action) for action in circle.actions]
    follower, expected = Follower(circle), {}
    for tick in sorted(instants):
        follower.to(tick)
        expected[tick] = _seen(state.save(follower.machine))
    for tick, found in zip(instants, there["states"], strict=True):
        assert _seen(found) == expected[tick], tick


def _seen(saved: str) -> Any:
    """Return a state without what a machine notes of its own runs."""
    fields = json.loads(saved)
    del fields["waiting"]
    return fields
