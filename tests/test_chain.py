"""The main job: the 1971 chain from part program to EIA tape, through the commands as a user types them."""

from pathlib import Path

import pytest

from tests.conftest import Shell, assert_same_tape
from tests.nc.tapes_1971 import tape

SAMPLES = Path(__file__).parent.parent / "tapes"


@pytest.mark.parametrize(
    ("name", "blocks", "frames", "minutes"),
    [("circle", 666, 13_321, "29 min 58."), ("ellipse", 976, 19_521, "43 min 55.")],
)
def test_part_program_to_eia_tape(shell: Shell, name: str, blocks: int, frames: int, minutes: str) -> None:
    """A space is an EIA zero, the start-up TLS punches a blank frame; the bundled tapes are what is made."""
    lines = shell(f"pdp8 part {name} | pdp8 tape convert - --to text").stdout.decode("ascii").splitlines()
    typed = shell(f"pdp8 part {name} > {name}.asc; cat {name}.asc").stdout
    done = shell(f"pdp8 run eia.pal < {name}.asc > {name}.eia; cat {name}.eia")
    assert (len(lines), len(done.stdout)) == (blocks, frames)
    assert_same_tape(done.stdout, tape(*(line.replace(" ", "0") for line in lines)))
    assert minutes in done.stderr.decode()
    assert f"{blocks * 27:,} frames read, {frames:,} frames punched" in done.stderr.decode()
    assert_same_tape((SAMPLES / f"{name}.asc").read_bytes(), typed)
    assert_same_tape((SAMPLES / f"{name}.eia").read_bytes(), done.stdout)
