"""The piece as C: with a jump behind every operation, and with the switch that other compilers get."""

import ctypes
import random
import shutil
import subprocess
from array import array
from typing import Any

import pytest

from pdp8.computer.speed.piece import LEFT, STRIDE, WRAP, execute
from release.threaded import translate
from tests.pdp8.computer.lockstep.situations import any_word
from tests.pdp8.computer.speed.forms import HOUSE, machine_module

PIECE = HOUSE / "pdp8/computer/speed/piece.py"


def plain_engine() -> Any:
    return machine_module("plain").Machine().engine


@pytest.fixture(scope="module", params=["jumps", "switch"])
def library(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> ctypes.CDLL:
    if shutil.which("gcc") is None:
        pytest.skip("no gcc")
    source = tmp_path_factory.mktemp(request.param) / "piece.c"
    source.write_text(translate(PIECE).replace("static int execute", "int execute"))
    form = ["-U__GNUC__"] if request.param == "switch" else []
    made = source.with_suffix(".so")
    options = ["-O1", "-shared", "-fPIC", "-Wall", "-Werror"]
    subprocess.run(["gcc", *options, *form, "-o", made, source], check=True)
    return ctypes.CDLL(str(made))


def decoded(draw: random.Random) -> "list[array[int]]":
    """Return a core of nonsense, its operations and their operands; some words are not decoded."""
    engine = plain_engine()
    engine.core[:] = array("H", [any_word(draw) for _ in range(0o10000)])
    for page in range(0o200, 0o10000, 0o200):  # ISZ x110, JMP .-1
        engine.core[page], engine.core[page + 1] = 0o2310, 0o5200
    for address in range(0o10000):
        if draw.random() < 0.95:
            engine._decode(address)
    fields = (engine.core, engine.processor.forms, engine.arg)
    return [array("H", words[:STRIDE]) for words in fields]


@pytest.mark.parametrize("across", [False, True])
def test_the_translation_does_what_the_source_does(library: ctypes.CDLL, across: bool) -> None:
    engine = plain_engine()
    keep, flip, plus = tables = [array("H", table) for table in (engine.keep, engine.flip, engine.plus)]
    draw = random.Random(1971)
    tried: set[int] = set()
    for _ in range(8):
        words = decoded(draw)
        core, ops, arg, *others = words = [*words, *decoded(draw)[:2]] if across else words
        data, data_ops = others or (core, ops)
        places: dict[int, list[int]] = {}
        for address, operation in enumerate(ops[:0o10000]):
            places.setdefault(operation, []).append(address)
        for start in (draw.choice(places[operation]) for operation in places for _ in range(20)):
            copies = [array("H", part) for part in words]
            registers = [start, draw.randrange(0o20000), 0]
            translated = array("q", registers)
            wall, limit = draw.choice([0o7600, 0o10000]), draw.choice([0, 1, 5, 100, 6000]) << 26
            conditions = engine.conditions
            meant = execute(
                core, ops, arg, data, data_ops, keep, flip, plus, conditions, registers, wall, limit
            )
            pointers = [ctypes.c_void_p(each.buffer_info()[0]) for each in (*copies, *tables, translated)]
            limits = ctypes.c_int64(wall), ctypes.c_int64(limit)
            call = library.execute_across if across else library.execute
            found = call(*pointers[:-1], conditions, pointers[-1], *limits)
            assert (found, list(translated), copies) == (meant, registers, words)
        tried |= places.keys()
    assert tried == {*range(WRAP), LEFT}
