"""After anything was done at a prompt, a session that is restored goes as a new one does."""

from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.computer.machine import Machine
from pdp8.computer.past import state
from pdp8.monitor.prompt import Monitor
from tapes.errors import WorkError
from tests.pdp8.monitor import do

BEFORE = {
    "nothing": [],
    "a run": ["load hello.pal", "go 200 2"],
    "a run that was not ended": ["load hello.pal", "go 200 0.3"],
    "tapes that wait": ["load eia.pal", "reader circle.asc circle.asc", "go 200 3"],
    "keys that wait": ['keyboard "XYZ"', 'send "A"'],
    "a page": ["load hello.pal", "go 200 2", "page", "expect HELLO"],
    "a text that did not come": ["load hello.pal", "go 200 0.3", "expect NEVER 0.2"],
    "a punch": ["load hello.pal", "punch on", "go 200 2", "punch out.tape"],
    "an attached punch": ["attach ptp out.tape", "load hello.pal", "go 200 2", "detach ptp"],
    "a count": ["count on", "load hello.pal", "go 200 1", "count off"],
    "a trace": ["trace on", "load hello.pal", "go 200 0.01", "trace off"],
    "a breakpoint": ["load eia.pal", "break CHK", "watch HOLD", "go 200 0.2", "forget"],
    "steps and back": ["load hello.pal", "go 200 0.2", "key stop", "step 3", "back 2"],
    "other sources": ["load eia2.pal", "listing eia.pal"],
    "the loaders": ["boot hello.pal"],
    "switches": [
        "set sr 7777",
        "set sing_step 1",
        "cycle",
        "set sing_step 0",
    ],
    "a refusal": ["load nowhere.pal"],
}
"""What was done before, and ended."""
NOW = [
    "load eia.pal", "go 200 0.5", "reader in.asc in.asc", "go 200 1", "page more", "cont", "page",
    "registers", "key stop", "step 2", "back 1 characters", "examine 0200-0203", "key start", "until 1 2",
    "page more",
]  # fmt: skip


def said(before: list[str]) -> tuple[list[str], str]:
    """Return what is said after `before`, and the machine."""
    lines: list[str] = []
    made = Monitor(lines.append)
    with shelf.watched():
        for line in [*before, "key stop", "restore fresh.state", "NOW", *NOW]:
            try:
                if line == "NOW":
                    lines.clear()
                else:
                    do(made, line)
            except WorkError as error:
                lines.append(str(error))
    return lines, state.save(made.machine)


@pytest.mark.parametrize(
    ("between", "frames"),
    [
        ("save s|restore s", 5), ("set cpu 8k", 5), ("step 2|go 200 .00001|back 4", 5),
        ("boot eia.pal", 5), ("reader stop", 0), ("reader start|reader stop", 0),
    ],
)  # fmt: skip
def test_start_throws_the_lever_for_a_tape_unless_a_hand_put_it_to_stop(
    between: str, frames: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in.asc").write_bytes(b"\xb1\xb2\x8d\x8a\xb1")
    made = Monitor(lambda line: None)
    do(made, "load eia.pal", "set pc 200", "reader in.asc", *between.split("|"), "go 200 1")
    assert made.machine.teletype.reader.position == frames


@pytest.mark.parametrize("before", BEFORE)
def test_what_was_done_before_is_forgotten(
    before: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "in.asc").write_bytes(b"\xb1\xb2\x8d\x8a\xb1")
    machine = Machine()
    machine.teletype.reader.load(b"")
    (tmp_path / "fresh.state").write_text(state.save(machine))
    fresh = said([])
    assert said(BEFORE[before]) == fresh
