"""Part programs in the page: the tape that `pdp8 part` punches, and the refusal that it says."""

import re
import shlex
from pathlib import Path
from typing import Any

import pytest

from pdp8.web import parts
from tapes import ascii
from tests.conftest import Call
from tests.pdp8.web.node import called, needs_node

ASKED: tuple[tuple[str, dict[str, Any]], ...] = (
    ("circle", {}),
    ("circle", {"radius": "1.2", "tolerance": "0.0033", "close": True}),
    ("circle", {"technique": "piece", "fastest": "8", "spindle": "35"}),
    ("ellipse", {"major": "2.9", "minor": "1.15", "tolerance": "0.0051", "feed_code": "2"}),
    ("polynomial", {"b": "1.5", "c": "5", "to": "5", "cutter": "0.25", "side": "below"}),
    ("slope", {"to_x": "6 in", "to_y": "9", "stop": "inside"}),
    ("curve", {"expression": "2*SIN(x)**2/x + 1e-1", "from_": "0.5", "to": "4"}),
    ("curve", {"expression": "x**2/4", "from_": "-2", "to": "2", "tolerance": ".01", "cutter": "0.5"}),
    ("profile", {"expression": "1.2+0.2*cos(3*x)", "cutter": "0.25", "side": "inside"}),
    ("die", {"cut": "groove", "technique": "piece"}),
    ("drill", {"holes": "1,1 2.5,1 4,1", "z_depth": "3.25"}),
    ("fluidic", {"program": "control", "control": "0.8"}),
    # what is refused
    ("circle", {"radius": "1750"}),
    ("ellipse", {"major": "12"}),
    ("drill", {"holes": "1,1 2"}),
    ("curve", {"expression": "x + y"}),
    ("curve", {}),
    ("polynomial", {"cutter": "11"}),
)


def _line(name: str, typed: dict[str, Any]) -> str:
    """Return the command that is given what is typed."""
    given = {key.strip("_").replace("_", "-"): value for key, value in typed.items()}
    words = [given.pop("expression")] if "expression" in given else []
    for option, value in given.items():
        words += [f"--{option}"] if value is True else [f"--{option}", value]
    return shlex.join(["pdp8", "part", name, *words])


@pytest.mark.slow("each part with each of its options, 15 s")
@needs_node
def test_the_page_punches_and_refuses_what_the_command_does(call: Call) -> None:
    declared = {part["name"]: part for part in parts.declared()}
    there = called(*(("pdp8/web/bench/parts", "printout", declared[name], typed) for name, typed in ASKED))
    for (name, typed), found in zip(ASKED, there, strict=True):
        status, punched, said = call(_line(name, typed))
        if status:
            assert found.split(": ", 2)[2].rstrip(".") in said.replace("\n", " "), (name, typed)
        else:
            assert ascii.encode(found) == punched.encode("utf-8", "surrogateescape"), (name, typed)


def test_the_page_has_the_program_of_each_part_that_it_offers() -> None:
    source = (Path(parts.__file__).parent / "bench" / "parts.mjs").read_text(encoding="utf-8")
    programs = re.findall(r"const PROGRAMS = \{ (.*) \};$", source, re.MULTILINE)[0].split(", ")
    assert sorted(part["name"] for part in parts.declared()) == sorted(programs)
