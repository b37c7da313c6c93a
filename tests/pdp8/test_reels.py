"""DECtape images on drives: what is refused, and what was written is not lost."""

from array import array
from collections.abc import Callable
from pathlib import Path
from unittest.mock import patch

import pytest

from pdp8 import shelf
from pdp8.computer.dectape.tc08 import TC08
from pdp8.monitor import rack, simh
from pdp8.monitor.commands import do
from pdp8.monitor.prompt import Monitor
from pdp8.reels import Discs, Reel
from tapes import dectape
from tapes.errors import TapeError, WorkError
from tests.conftest import Call
from tests.pdp8.computer.dectape.reel import file

WHOLE = dectape.blank().content()
NO_IMAGE = {
    b"": "0 bytes; a DECtape image has 380,292 or 377,344, or ends after a block of 258",
    WHOLE[:-1]: "380,291 bytes; a DECtape image",
    WHOLE + bytes(258): "380,550 bytes; a DECtape image",
    bytes(591_872): "591,872 bytes: a DECtape of 18-bit words, of a PDP-7, 9 or 15",
    bytes(3_325_952): "3,325,952 bytes: an RK05 disk; no PDP-8/L had one",
    bytes(65_536): "65,536 bytes: a DF32 disk",
    WHOLE[:262] + b"\0\x10" + WHOLE[264:]: "block 1, word 2: 10000 (octal) is no word of 12 bits",
}


@pytest.mark.parametrize(("content", "said"), NO_IMAGE.items(), ids=NO_IMAGE.values())
def test_what_is_no_image_is_refused_with_the_reason(content: bytes, said: str) -> None:
    with pytest.raises(TapeError) as refused:
        dectape.decode(content)
    assert str(refused.value).startswith(said)


def test_an_image_comes_back_byte_for_byte() -> None:
    words = array("H", [number * 7 & 0o7777 for number in range(dectape.BLOCKS * dectape.WORDS)])
    whole = dectape.Image(words).content()
    for front, known in ((b"", True), (b"tu56", True), (b"tu55", False)):  # Jones' emulator has it so
        assert dectape.is_image(front + whole) == known
    assert dectape.decode(whole)[0].content() == dectape.decode(b"tu56" + whole)[0].content() == whole
    short, notes = dectape.decode(whole[: 3 * 258])
    assert notes == ["3 of 1474 blocks; the others are taken as 0"]
    assert short.content() == whole[: 3 * 258] + bytes(len(whole) - 3 * 258)
    for own, said in (((0o6776, 0o6777), 1), ((0o6776, 0o6777, 0o6766), 0), ((0o6776, 0o7777), 0)):
        system = dectape.blank()
        system.words[9 : 9 + len(own)] = array("H", own)
        assert len([note for note in dectape.decode(system.content())[1] if "a TD8E" in note]) == said
    narrow = b"".join(whole[at : at + 256] for at in range(0, len(whole), 258))
    reel = dectape.decode(narrow)[0]
    assert reel.content() == narrow
    reel.words[-1] = 5  # a program has written the 129th word of a block
    assert dectape.decode(reel.content())[0].words == reel.words


pytestmark = pytest.mark.usefixtures("here")


@pytest.fixture
def monitor() -> Monitor:
    """Return a monitor with a reel on drive 0, of which a block was written."""
    said: list[str] = []
    made = Monitor(said.append)
    do(made, "save bare.state")
    do(made, f"attach dt0 {file(Path('reel.tu56'))}")
    control = made.machine.devices[-1]
    assert isinstance(control, TC08)
    control.drives[0].write(5, 7, 0o1234)
    return made


def failing(times: int) -> Callable[[str, bytes], bool]:
    """Return what writes a file, but finds the disk full so many times."""
    left, write = [times], shelf.write

    def written(name: str, content: bytes) -> bool:
        if left[0]:
            left[0] -= 1
            raise shelf.ShelfError(f"{name}: No space left on device; this file was not written")
        return write(name, content)

    return written


def test_a_reel_is_on_one_drive(monitor: Monitor) -> None:
    Path("other.tu56").symlink_to("reel.tu56")
    for name in ("reel.tu56", "other.tu56"):
        with pytest.raises(WorkError, match="is on drive 0: a reel is on one drive"):
            do(monitor, f"attach dt1 {name}")


def test_a_file_that_is_there_but_cannot_be_read_is_named_once() -> None:
    Path("loop").symlink_to("loop")
    with pytest.raises(WorkError, match=r"^loop: Too many levels of symbolic links"):
        Reel(0, {}).mount("loop")


def test_what_was_written_is_not_lost_where_it_cannot_be_saved(monitor: Monitor) -> None:
    before = Path("reel.tu56").read_bytes()
    Path("mine.pal").write_text("a source")
    for line in ("detach dt0 /dev/full", "detach dt0 reel.tu56", "detach dt0 mine.pal", "detach dt0"):
        with pytest.raises(WorkError):
            do(monitor, line)
        assert monitor.reels.places["dt0"].changed() == 1
    saved = Path("saved.tu56")
    with patch.object(shelf, "write", failing(1)), pytest.raises(WorkError, match="No space left"):
        do(monitor, f"detach dt0 {saved}")
    assert not saved.exists()
    do(monitor, f"detach dt0 {saved}")
    assert dectape.decode(saved.read_bytes())[0].words[5 * dectape.WORDS + 7] == 0o1234
    assert Path("reel.tu56").read_bytes() == before


def test_what_was_saved_is_not_changed_until_it_is_written_again(monitor: Monitor) -> None:
    """A reel and the discs, restored between; and what is taken off leaves nothing on the next."""
    do(monitor, "set df enabled")
    reel, discs = monitor.reels.places["dt0"], monitor.reels.places["df"]
    assert isinstance(reel, Reel)
    assert isinstance(discs, Discs)
    for number in (1, 2):
        reel.drive.write(5, 7, number)
        discs.control.words[9] = number
        do(monitor, f"save s{number}")
        do(monitor, f"restore s{number}")
        for place in (reel, discs):
            assert place.changed() == 1
            of_file = place.file
            monitor.reels.save(place.device, f"{place.device}-{number}")
            assert (place.changed(), monitor.reels.said(place.device), place.file) == (0, "", of_file)
    assert [*monitor.reels.rescue()] == []
    for name in ("dt0-2", "df-2"):
        device, _, _ = name.partition("-")
        do(monitor, f"detach {device}")
        do(monitor, f"attach {device} {name}")
        assert monitor.reels.places[device].changed() == 0
    do(monitor, "restore bare.state")
    assert (reel.drive.read(5, 7), discs.control.words[9]) == (2, 2)
    reel.drive.write(5, 7, 3)
    discs.control.words[9] = 3
    with patch.object(shelf, "write", failing(2)):  # beside the first reel, and in the temporary folder
        rescued = monitor.reels.rescue()
        assert next(rescued).startswith("df: ")
        with pytest.raises(WorkError, match=r"drive 0: .*No space left"):
            next(rescued)


@pytest.mark.parametrize(
    "acts",
    [
        ("detach dt0 forget",),
        ("detach dt0 saved.tu56",),
        ("detach dt0 forget", "attach dt0 saved.tu56"),
        ("detach dt0 forget", "attach dt1 reel.tu56"),
        ("save then.state", "detach dt0 forget", "attach dt0 reel.tu56", "restore then.state"),
        ("restore bare.state",),
        ("save then.state", "detach dt0 forget", "attach dt1 reel.tu56", "restore then.state"),
    ],
)
def test_a_reel_that_is_on_its_drive_again_has_its_file_and_is_not_lost(
    acts: tuple[str, ...], monitor: Monitor
) -> None:
    Path("saved.tu56").write_bytes(WHOLE)
    said: list[str] = []
    monitor.say = said.append
    for line in ("deposit 200 5200", "go 200 .01", "show devices"):
        do(monitor, line)
    assert said[-1] == "dt0  reel.tu56, 1 block written"
    back = () if "restore" in acts[-1] else ("cont .01", "back .01 seconds")
    for line in (*acts, *back, "show devices"):
        do(monitor, line)
    assert said[-1] == "dt0  reel.tu56, 1 block written"
    rack.leave(monitor)
    assert dectape.decode(Path("reel-changed.tu56").read_bytes())[0].words[5 * dectape.WORDS + 7] == 0o1234


@pytest.mark.parametrize("name", ["forget", "saved"])
def test_discs_that_are_full_again_have_their_file_and_what_was_written_is_counted(name: str) -> None:
    said: list[str] = []
    made = Monitor(said.append)
    for file_ in ("first", "second"):
        Path(file_).write_bytes(bytes(65_536))
    do(made, "attach df first")
    made.reels.discs.control.words[9] = 1
    for line in ("deposit 200 2010 5200 5200", "go 200 .01", f"detach df {name}", "attach df second"):
        do(made, line)
    for line in ("cont .01", "back .01 seconds", "show devices", "back .005 seconds", "show devices"):
        do(made, line)
    assert [line for line in said if line.startswith("df ")] == ["df   second", "df   first, 1 word written"]


@pytest.mark.parametrize(("full", "place"), [(0, "reel-changed.tu56"), (1, "tmp/reel-changed.tu56")])
def test_what_nobody_saved_is_left_beside(monitor: Monitor, full: int, place: str) -> None:
    Path("tmp").mkdir()
    with patch.object(shelf, "write", failing(full)), patch("tempfile.tempdir", "tmp"):
        rack.leave(monitor)
    assert dectape.decode(Path(place).read_bytes())[0].words[5 * dectape.WORDS + 7] == 0o1234


def test_a_reel_is_left_beside_its_file_and_a_page_where_a_punched_tape_cannot_be_written(
    monitor: Monitor,
) -> None:
    do(monitor, "attach lpt paper")
    do(monitor, "attach ptp out")
    monitor.machine.teletype.punch.frames += b"Y"
    Path("out").mkdir()
    with pytest.raises(WorkError, match="out"):
        simh.leave(monitor)
    assert Path("reel-changed.tu56").exists()
    assert Path("paper").exists()


def test_an_image_is_no_program(call: Call) -> None:
    for length, what in ((380_292, "a DECtape image"), (65_536, "a DF32 disk"), (3_325_952, "an RK05 disk")):
        Path("image.bin").write_bytes(b"\x93\x0e" * (length // 2))
        assert f"image.bin: {what}" in call("pdp8 run image.bin")[2]
        assert f"image.bin: {what}" in call("pdp8 dis image.bin")[2]
    Path("os8.rk05").write_bytes(bytes(3_325_952))
    assert "os8.rk05: no program tape: a disk image" in call("pdp8 run os8.rk05")[2]
    assert "an RK05 disk; no PDP-8/L had one" in call("pdp8 run --memory 8k --dectape 0=os8.rk05")[2]


def test_a_disk_that_is_refused_fits_nothing() -> None:
    monitor = Monitor(lambda line: None)
    Path("odd.df32").write_bytes(bytes(101))
    for name in ("odd.df32", "none.df32"):
        with pytest.raises(WorkError, match=name):
            do(monitor, f"attach df {name}")
    with pytest.raises(WorkError, match="df: no DF32 is fitted; attach df FILE fits it"):
        do(monitor, "boot df")
    Path("whole.df32").write_bytes(bytes(65_536))
    do(monitor, "attach df whole.df32")
    assert [place.device for place in monitor.reels.mounted()] == ["df"]


def test_a_disk_that_ends_with_what_was_written_last_is_filled_with_zeros() -> None:
    """As SIMH leaves its images: OS/8 of four discs in 185,856 bytes."""
    said: list[str] = []
    monitor = Monitor(said.append)
    for length, discs in ((2, 1), (65_534, 1), (65_536, 1), (65_538, 2), (262_144, 4)):
        Path("own.df32").write_bytes(bytes(length - 2) + b"\x07\x01")
        said.clear()
        do(monitor, "attach df own.df32")
        words = monitor.reels.discs.control.words
        assert (len(words), words[length // 2 - 1]) == (discs * 32_768, 0o407)
        missing = len(words) - length // 2
        assert (f"{missing:,} word" in said[0]) == (missing > 0), said
        assert monitor.reels.places["df"].changed() == 0
