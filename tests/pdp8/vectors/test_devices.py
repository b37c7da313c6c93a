"""The Teletype and the PC8/L beside the reference, IOT by IOT: the tick of every flag and frame."""

import pytest

from pdp8.vectors import devices, runner
from tests.pdp8.vectors.emulators import ReferenceEmulator
from tests.reference.compiling import compiler

pytestmark = pytest.mark.skipif(compiler() is None, reason="the reference needs a C compiler")


@pytest.mark.parametrize("name", ["teletype", "pc8l"])
def test_the_reference_does_the_same(name: str) -> None:
    for vector in devices.vectors(name):
        assert runner.play(vector, ReferenceEmulator()) == "", vector["name"]
