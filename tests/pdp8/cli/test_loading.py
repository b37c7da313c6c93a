"""Tapes as they are: of several sections, with labels, damaged, for another loader; through every way of
loading them.
"""

from pathlib import Path

import pytest

import pal
from pdp8.computer.past import state
from tapes import binary, frames, rim, shelf
from tests.conftest import Shell

FIRST = {0o200: 0o7001, 0o201: 0o7402}
SECOND = {0o300: 0o1234, 0o301: 0o4321}
LABEL = bytes(8) + bytes([0o265, 0o011, 0o377, 0o001, 0, 0o176, 0o101, 0o101, 0o076])
HIGH = {0o200: 0o7402} | {address: address for address in (*range(0o7602, 0o7612), *range(0o7617, 0o7622))}


@pytest.fixture(autouse=True)
def tapes(tmp_path: Path) -> None:
    sections = binary.encode(FIRST) + binary.encode(SECOND)
    damaged = bytearray(binary.encode(FIRST | SECOND))
    damaged[67] ^= 0o002
    (tmp_path / "two.bin").write_bytes(sections + LABEL)
    (tmp_path / "labels.bin").write_bytes(LABEL + bytes(8) + sections + LABEL)
    message = bytes([0o377, 0o310, 0o311, 0o101, 0o377])
    (tmp_path / "message.bin").write_bytes(
        frames.leader(9) + message + binary.encode(FIRST) + message + binary.encode(SECOND)
    )
    (tmp_path / "high.bin").write_bytes(binary.encode(HIGH))
    (tmp_path / "bad.bin").write_bytes(damaged)
    (tmp_path / "cut.bin").write_bytes(binary.encode(FIRST | SECOND)[:74])


@pytest.mark.parametrize(
    ("tape", "words", "said"),
    [
        ("two.bin", FIRST | SECOND, "209 frames, 2 sections, 4 words; 20.9 s"),
        ("labels.bin", FIRST | SECOND, "209 frames, 2 sections, 4 words; 20.9 s"),
        ("message.bin", FIRST | SECOND, ""),
        ("high.bin", HIGH, ""),
    ],
)
def test_run_loads_all_of_it_and_says_so(
    shell: Shell, tmp_path: Path, tape: str, words: dict[int, int], said: str
) -> None:
    for option in ("", "--boot"):
        done = shell(f"pdp8 run {tape} {option} --save x < /dev/null")
        core = state.restore((tmp_path / "x").read_text()).core
        assert {address: core[address] for address in words} == words, done.stderr
        labelled = b"a label of 9 frames from frame" in done.stderr
        assert labelled == (tape in ("two.bin", "labels.bin"))
        assert b"HLT at 020" in done.stderr
    assert f"{tape} read by BIN: {said}" in done.stderr.decode()


def test_a_damaged_tape_stops_run_and_load_and_is_judged_by_the_loader(shell: Shell) -> None:
    done = shell("pdp8 run bad.bin < /dev/null")
    assert done.returncode == 1
    assert b"pdp8 run: bad.bin: frame 76: checksum: computed" in done.stderr
    done = shell("pdp8 run bad.bin --boot < /dev/null")
    assert done.returncode == 1
    assert b"bad.bin: the BIN loader halted with AC = 0002 after 79 frames: wrong checksum" in done.stderr
    done = shell("pdp8 run cut.bin --boot < /dev/null")
    assert b"cut.bin: the BIN loader ended with tape out at" in done.stderr
    for command in ("load", "boot"):
        done = shell(f"echo {command} bad.bin | pdp8 monitor")
        assert done.returncode == 1
        assert b"checksum" in done.stderr


@pytest.mark.parametrize("option", ["", "--boot"])
def test_force_loads_it_and_says_so(shell: Shell, option: str) -> None:
    done = shell(f"pdp8 run bad.bin --force {option} < /dev/null")
    assert done.returncode == 0, done.stderr
    assert b"bad.bin: frame 76: checksum" in done.stderr
    assert b"HLT at 0201" in done.stderr


def test_another_loader(shell: Shell, tmp_path: Path) -> None:
    words = pal.assemble(shelf.read_bundled("bin.pal")).words
    (tmp_path / "ours.rim").write_bytes(rim.encode(words))
    done = shell("pdp8 run two.bin --boot --loader ours.rim < /dev/null")
    assert done.returncode == 0, done.stderr
    (tmp_path / "halts.rim").write_bytes(rim.encode({0o7777: 0o7402}))
    done = shell("pdp8 run two.bin --boot --loader halts.rim < /dev/null")
    assert b"HLT at 0200" not in done.stderr


def test_a_file_of_ours_is_not_replaced_by_one_of_the_same_name(shell: Shell, tmp_path: Path) -> None:
    (tmp_path / "bin.pal").write_text("nonsense\n")
    done = shell("pdp8 run two.bin --boot < /dev/null")
    assert done.returncode == 0, done.stderr
    (tmp_path / "hello.pal").write_text("*200\n\tHLT\n$\n")
    done = shell("pdp8 run hello.pal < /dev/null")
    assert b"hello.pal is the file in this folder, not the bundled one of that name" in done.stderr


def test_a_section_after_a_label_is_named(shell: Shell, tmp_path: Path) -> None:
    first, other = (binary.encode({address: 0o7402}) for address in (0o200, 0o400))
    (tmp_path / "apart.bin").write_bytes(first + bytes.fromhex("007f09090100") + other)
    start = len(first) + 6
    said = f"after the label, from frame {start} on, a good section: a tape of its own, left out"
    for line in ("pdp8 run apart.bin", "pdp8 run apart.bin --boot", "echo load apart.bin | pdp8 monitor"):
        done = shell(f"{line} < /dev/null" if "run" in line else line)
        assert said.encode() in done.stdout + done.stderr, line
    for line in ("pdp8 dis apart.bin", "pdp8 tape convert apart.bin --to rim"):
        label, apart = shell(f"{line} > out").stderr.decode().splitlines()
        where = f"{len(other) + 5} frames from frame {start - 5} on"
        assert label.endswith(f": apart.bin: a label of {where}, left out")
        assert apart.endswith(f": apart.bin: {said}")


def test_show_says_label(shell: Shell) -> None:
    shown = shell("pdp8 tape show two.bin --from 279").stdout.decode()
    assert shown.splitlines()[2].endswith("|  label")
    shown = shell("pdp8 tape show labels.bin --to 25").stdout.decode()
    assert "|  label" in shown
    assert shown.splitlines()[-1].startswith("   label    ")


LATE = "*200\n\tTLS\n\tTSF\n\tJMP .-1\n\tKCC\nL,\tKSF\n\tJMP .-1\n\tKRB\n\tTLS\n\tJMP L\n$\n"
"""Clears the reader only when a character is typed, as PAL III does: READER RUN is set since START."""
ASKS = "*200\nL,\tKSF\n\tJMP .-1\n\tKRB\n\tTLS\n\tJMP L\n$\n"


@pytest.mark.parametrize(
    ("source", "leader", "warned", "punched"),
    [
        (LATE, "0", True, b"\0BC"),
        (LATE, "3", False, b"\0\0\0ABC\0\0\0"),
        ("*200\n\tHLT\n$\n", "0", True, b""),
        ("*200\n\tHLT\n$\n", "3", False, b""),
        (ASKS, "0", False, b"ABC"),
    ],
)
def test_a_first_frame_that_may_be_lost_is_named(
    shell: Shell, tmp_path: Path, source: str, leader: str, warned: bool, punched: bytes
) -> None:
    (tmp_path / "p.pal").write_text(source)
    shell(f"printf ABC | pdp8 tape punch --parity none --leader {leader} -o abc.asc")
    done = shell("pdp8 run p.pal --reader abc.asc")
    assert (b"the first frame of abc.asc came in with START" in done.stderr) == warned
    assert done.stdout.replace(b"\0\0\0\0", b"\0\0\0") == punched
    assert b"first frame" not in shell("pdp8 run p.pal --reader abc.asc --quiet").stderr


def test_a_tape_that_never_went_in_is_named(shell: Shell) -> None:
    shell("printf A | pdp8 tape punch -o a.asc")
    done = shell("pdp8 run echo.pal --reader a.asc --reader a.asc --max-time 2")
    assert b"a.asc did not go into the reader: the program did not wait for it" in done.stderr


def test_a_tape_that_overwrites_the_loader_ends_the_boot(shell: Shell, tmp_path: Path) -> None:
    instead_of_ksf = {0o7757: 0o2010}  # ISZ 10: the RIM loader reads for ever
    (tmp_path / "over.rim").write_bytes(rim.encode({0o200: 0o7402, 0o300: 1} | instead_of_ksf))
    done = shell("pdp8 run over.rim --boot < /dev/null")
    assert done.returncode == 1
    assert b"over.rim: the RIM loader did not end within 1 min" in done.stderr
    assert b"; STOP was pressed at 77" in done.stderr


@pytest.mark.parametrize("command", ["pdp8 run five.pal < /dev/null", "echo load five.pal | pdp8 monitor -"])
def test_a_source_in_pal8_is_found_and_taken(command: str, shell: Shell) -> None:
    shell("printf '*200\\n\\tTAD (5)\\n\\tHLT\\n$\\n' > five.pal")
    done = shell(command)
    assert done.returncode == 0
    assert b"five.pal: taken for PAL8: it has what PAL III has not" in done.stdout + done.stderr
    refused = shell(
        command.replace("five.pal <", "five.pal --dialect pal3 <").replace("r -", "r - --dialect pal3")
    )
    assert refused.returncode == 1
    assert b"five.pal:2:6: error: IC  0250  AT  0200" in refused.stderr
