"""The main job: the 1971 chain from part program to EIA tape, through the commands as a user types them."""

from pathlib import Path

import pytest

from tests.conftest import Shell, assert_same_tape

# The thesis, Appendix B: P0 to P9, PCR; a space is an EIA zero. Everything else punches nothing.
EIA = {
    "0": 0o040, "1": 0o001, "2": 0o002, "3": 0o023, "4": 0o004, "5": 0o025,
    "6": 0o026, "7": 0o007, "8": 0o010, "9": 0o031, " ": 0o040, "\n": 0o200,
}  # fmt: skip
SAMPLES = Path(__file__).parent.parent / "tapes"


def expected_eia(lines: str) -> bytes:
    """Translate part program lines as the thesis describes it; the start-up TLS punches a blank frame."""
    return b"\0" + bytes(EIA[character] for character in lines)


@pytest.mark.parametrize(
    ("name", "blocks", "frames", "minutes"),
    [("circle", 666, 13_321, "29 min 58."), ("ellipse", 976, 19_521, "43 min 55.")],
)
def test_part_program_to_eia_tape(shell: Shell, name: str, blocks: int, frames: int, minutes: str) -> None:
    """The bundled tapes are what the chain makes."""
    lines = shell(f"pdp8 part {name} --parity none --fill 0").stdout.decode("ascii").replace("\r\n", "\n")
    typed = shell(f"pdp8 part {name} > {name}.asc; cat {name}.asc").stdout
    done = shell(f"pdp8 run eia.pal < {name}.asc > {name}.eia; cat {name}.eia")
    tape = done.stdout
    assert len(lines.splitlines()) == blocks
    assert len(tape) == frames
    assert tape[0] == 0
    rows = tape[1:]
    assert {rows[end] for end in range(19, len(rows), 20)} == {0o200}
    assert rows.count(0o200) == blocks
    assert all(row.bit_count() % 2 for row in rows)
    assert_same_tape(tape, expected_eia(lines))
    assert minutes in done.stderr.decode()
    assert f"{blocks * 27:,} frames read, {frames:,} frames punched" in done.stderr.decode()
    assert_same_tape((SAMPLES / f"{name}.asc").read_bytes(), typed)
    assert_same_tape((SAMPLES / f"{name}.eia").read_bytes(), tape)


@pytest.mark.parametrize(
    ("line", "given", "status", "said"),
    [
        ("eia.pal", "", 0, "no frames read"),
        ("eia.pal", "0010190000000000002\n", 0, "no carriage returns: no block will end."),
        ("- --max-time 0.5", "*200\nL,IAC\nJMP L\n$\n", 1, "still running"),
        ("-", "*200\nJMP .\n$\n", 1, "an endless loop at 0200"),
    ],
)
def test_how_a_run_ends_is_said(line: str, given: str, status: int, said: str, shell: Shell) -> None:
    done = shell(f"pdp8 run {line}", given.encode())
    assert (done.returncode, said in done.stderr.decode()) == (status, True), done.stderr
