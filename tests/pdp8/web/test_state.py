"""A state saved by `pdp8 run` and by the page: each takes the other's."""

import json

import pytest

from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from tests.pdp8.web.node import in_node, needs_node

pytestmark = needs_node

_THROUGH = """async ([text, ticks]) => {
  const { restore, save } = await import("@/computer/state.mjs");
  try {
    const machine = restore(text);
    machine.run(machine.processor.clock + ticks);
    return save(machine);
  } catch (error) { return error.message; }
}"""


def _through(text: str, ticks: int = 0) -> str:
    """Return the state after the page has restored it, run it for so long, and saved it."""
    return str(in_node(_THROUGH, [text, ticks]))


def _echo() -> Machine:
    machine = Machine(highspeed=True)
    program = [0o6032, 0o6046, 0o6031, 0o5202, 0o6036, 0o6041, 0o5205, 0o6046, 0o5202]
    machine.load(enumerate(program, 0o200))
    machine.teletype.reader.load(bytes(range(0o200, 0o377)))
    machine.start(0o200)
    machine.run(seconds=1.2345)
    return machine


def test_a_run_goes_on_in_the_page_and_comes_back() -> None:
    """Saved here in the middle, run on there, restored here: as if it had never left."""
    machine = _echo()
    there = state.restore(_through(state.save(machine), 30_000_000))
    machine.run(seconds=(there.processor.clock - machine.processor.clock) / 20e6)
    assert machine.processor.clock == there.processor.clock
    assert machine.teletype.punch.tape == there.teletype.punch.tape
    assert (list(machine.core), machine.ac, machine.pc) == (list(there.core), there.ac, there.pc)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "cut short or damaged"),
        ("{}", 'begins with {"format"'),
        (json.dumps({"format": "pdp8 state", "version": 2, "core": {"0200": "9"}}), "not an octal number"),
        (
            json.dumps({"format": "pdp8 state", "version": 2, "core": {"7777": "1 2"}}),
            "core 7777: the words go beyond 7777",
        ),
        (json.dumps({"format": "pdp8 state", "version": 2, "processor": {"xyz": 1}}), "the fields are"),
    ],
)
def test_what_is_no_state(text: str, message: str) -> None:
    """The page says what is wrong with it."""
    assert message in _through(text)
