"""`pdp8 tape read`: what it writes and says, and the page in which doubtful frames are corrected."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from pdp8 import shelf
from tapes import ascii, photograph
from tapes.errors import TapeError
from tapes.photograph import Strip, correction
from tests.conftest import Shell
from tests.tapes.photograph import camera, survey
from tests.tapes.photograph.camera import Shot

if TYPE_CHECKING:
    from playwright.sync_api import Browser

PART = 60
"""Frames of a test's tape."""


def shown(page: str) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Return what a page holds: its pictures, and their strips in the order of the tape."""
    pictures, strips = json.JSONDecoder().raw_decode(page.partition("const [pictures, strips] = ")[2])[0]
    return pictures, strips


def test_the_command_writes_the_tape_and_says_what_it_is(shell: Shell, tmp_path: Path) -> None:
    tape = shelf.read("circle.asc")[:PART]
    picture = camera.photograph(tape, Shot(angle=3)) + bytes(3 << 20)  # a file as long as a camera's
    (tmp_path / "photo.jpg").write_bytes(picture)
    done = shell("pdp8 tape read photo.jpg --page look.html -o found.asc")
    said = [line.split(":")[0] for line in done.stderr.decode().splitlines()]
    expected = ["60 frames", "parity", "lines", "line ends", "wrote found.asc", "wrote look.html"]
    assert (done.returncode, said) == (0, expected)
    assert (tmp_path / "found.asc").read_bytes() == tape
    _, (strip,) = shown((tmp_path / "look.html").read_text())
    assert [frame["holes"] for frame in strip["frames"]] == [*tape]


@pytest.mark.parametrize(
    ("size", "why"), [(64 << 20, "no picture that can be read"), ((64 << 20) + 1, "longer")]
)
def test_a_picture_has_64_mib_at_most(shell: Shell, tmp_path: Path, size: int, why: str) -> None:
    with open(tmp_path / "large", "wb") as file:
        file.truncate(size)
    assert f"large: {why}" in shell("pdp8 tape read large -o found.asc").stderr.decode()


@pytest.mark.slow("two photographs, eight seconds")
def test_the_command_says_a_gap_and_the_other_side(shell: Shell, tmp_path: Path) -> None:
    tape = shelf.read("circle.asc")[:PART]
    (tmp_path / "photo.jpg").write_bytes(camera.photograph(tape, Shot(below=True, covered=(40,))))
    said = shell("pdp8 tape read photo.jpg -o found.asc").stderr.decode()
    assert "a gap of" in said
    assert "read in this order it makes no sense; --underside would\n" in said
    said = shell("pdp8 tape read photo.jpg --underside -o found.asc").stderr.decode()
    assert "sense" not in said


def frame(holes: int, at: int = 0, why: str = "", weakest: int = 1, margin: float = 0.4) -> photograph.Frame:
    return photograph.Frame(holes, 0o377 if why else 0, why, ((at, 7),) * 9, weakest, margin)


def strips(*tapes: bytes, why: str = "") -> list[Strip]:
    """Return strips of these frames, the last of them left out if there is a reason."""
    found = [Strip([*map(frame, tape, range(len(tape)))], (True, False)) for tape in tapes]
    return [*found[:-1], found[-1]._replace(why=why)]


def test_strips_are_named_and_read_in_any_order() -> None:
    content = camera.develop(np.zeros((9, 9)), Shot())
    one, two = (
        correction.Picture("one.jpg", content, strips(b"\1\2\3", b"\4\5")),
        correction.Picture("two.jpg", content, strips(b"\6\7", why="it is torn")),
    )
    reading = correction.Reading([one, two])
    assert reading.tape == b"\1\2\3\4\5"
    assert [*reading.report(underside=False)][:5] == [
        "frames 0 to 2: strip 1 of 3, from 0, 7 to 2, 7 in one.jpg",
        "the tape may go on before frame 0, where it leaves one.jpg",
        "frames 3 to 4: strip 2 of 3, from 0, 7 to 1, 7 in one.jpg",
        "the tape may go on before frame 3, where it leaves one.jpg",
        "strip 3 of 3 in two.jpg is left out: it is torn",
    ]
    turned = correction.Reading([one, two], (3, -1, 2))
    assert turned.tape == b"\6\7\3\2\1\4\5"
    assert "the tape may go on after frame 4, where it leaves one.jpg" in [*turned.report(underside=False)]
    assert correction.Reading([one, two], (2,)).tape == b"\4\5"
    _, shown_strips = shown(correction.page(turned))
    assert [strip["number"] for strip in shown_strips] == [3, 1, 2]
    assert [strip["read"] for strip in shown(correction.page(reading))[1]] == [True, True, False]
    ends = ((1, 2), (3, 4))
    seen = [one.strips[0]._replace(ends=ends), Strip([], why="too small", ends=ends)]
    _, drawn = shown(correction.page(correction.Reading([correction.Picture("a.jpg", content, seen)])))
    assert [strip["ends"] for strip in drawn] == [[], [[1, 2], [3, 4]]], "a line where no frames are"
    for order in ((1, 1), (1, -1), (4,)):
        with pytest.raises(TapeError, match="1,2,3 can be named, each once"):
            correction.Reading([one, two], order)
    nothing = correction.Picture("none.jpg", content, [Strip([], why="too small")])
    with pytest.raises(TapeError, match="strips 1: 2,3 can be named, each once"):
        correction.Reading([nothing, one], (1,))


def test_a_sure_frame_against_the_tape_s_parity_is_doubtful() -> None:
    """The other reading is that of the channel that is nearest to it."""
    tape = ascii.encode("0010000000000003588\n", "even")
    frames = [frame(holes, at) for at, holes in enumerate(tape)]
    frames[5] = frame(tape[5] ^ 0o010, 5, weakest=0o010, margin=0.26)
    content = camera.develop(np.zeros((9, 9)), Shot())
    reading = correction.Reading([correction.Picture("a.jpg", content, [Strip(frames)])])
    assert reading.tape == tape
    assert next(reading.report(underside=False)) == (
        "frame 5: 060 by the tape's parity, even; 070 was seen: channel 4, at 5, 7 in a.jpg: "
        "it contradicts the tape's parity, even"
    )
    assert [number for number, each, _ in reading.frames if each.doubtful] == [5]


def test_a_code_is_not_named_by_doubtful_frames_alone() -> None:
    content = camera.develop(np.zeros((9, 9)), Shot())

    def last_line(*frames: photograph.Frame) -> str:
        picture = correction.Picture("a.jpg", content, [Strip([*frames])])
        return [*correction.Reading([picture]).report(underside=False)][-1]

    blank = [frame(0, at) for at in range(3)]
    torn = [frame(holes, 3 + at, why="torn") for at, holes in enumerate((0o300, 0o100))]
    assert last_line(*blank, *torn) == "5 frames: 2 are doubtful, the others blank"
    sure = [frame(holes, 5 + at) for at, holes in enumerate(ascii.encode("PDP-8\n"))]
    assert last_line(*blank, *torn, *sure) != "5 frames: 2 are doubtful, the others blank"
    assert last_line(*blank) == "3 frames: blank"


@pytest.mark.slow("two photographs, six seconds")
def test_a_strip_that_cannot_be_read_is_left_out_and_shown(shell: Shell, tmp_path: Path) -> None:
    """Half of the second strip is stained; alone it is refused, and the page shows it all the same."""
    tape = survey.some_tape(7, 40)
    good, places = camera.picture(tape, Shot()), camera.places(40, Shot())
    bad = good.copy()
    y, x = np.mgrid[: bad.shape[0], : bad.shape[1]]
    for across, down in places[::2, 0]:
        bad[np.hypot(x - across - 6, y - down - 6) < 2] = 60
    (tmp_path / "both.jpg").write_bytes(camera.develop(np.concatenate([good, bad]), Shot()))
    (tmp_path / "bad.jpg").write_bytes(camera.develop(bad, Shot()))
    done = shell("pdp8 tape read both.jpg -o found.asc --page look.html")
    assert (done.returncode, (tmp_path / "found.asc").read_bytes()) == (1, tape)
    assert b"strip 2 of 2 in both.jpg, from " in done.stderr
    assert b", is left out: 34 of 34 frames are doubtful" in done.stderr
    assert [len(strip["frames"]) for strip in shown((tmp_path / "look.html").read_text())[1]] == [40, 40]
    for strips in ("1", "2,1"):
        assert shell(f"pdp8 tape read both.jpg --strips {strips} -o found.asc").returncode == 0
    assert (tmp_path / "found.asc").read_bytes()[40:] == tape
    done = shell("pdp8 tape read bad.jpg -o none.asc")
    assert (done.returncode, (tmp_path / "none.asc").exists()) == (1, False)
    assert b"frames are doubtful" in done.stderr
    assert b"--page FILE shows what was seen" in done.stderr
    assert shell("pdp8 tape read bad.jpg -o none.asc --page bad.html").returncode == 1
    assert shown((tmp_path / "bad.html").read_text())[1][0]["read"] is False


@pytest.mark.slow("starts Chromium")
def test_on_the_page_strips_change_places(browser: "Browser", tmp_path: Path) -> None:
    content = camera.develop(np.full((90, 90), 200), Shot())
    picture = correction.Picture("a.jpg", content, strips(b"\1\2\3", b"\4\5", b"\6\7", why="torn"))
    file = tmp_path / "page.html"
    file.write_text(correction.page(correction.Reading([picture])), encoding="utf-8")
    page = browser.new_page()
    page.goto(file.as_uri())

    def tape() -> bytes:
        with page.expect_download() as download:
            page.get_by_text("Save the tape").click()
        return Path(download.value.path()).read_bytes()

    assert tape() == b"\1\2\3\4\5"
    page.get_by_title("strip 2 earlier").click()
    assert tape() == b"\4\5\1\2\3"
    page.get_by_label("strip 3: 2 frames of a.jpg; torn").check()
    page.get_by_title("strip 3 earlier").click()
    assert page.evaluate("document.activeElement.title") == "strip 3 earlier", "the focus moves with it"
    page.get_by_label("strip 2").uncheck()
    assert tape() == b"\6\7\1\2\3"


@pytest.mark.slow("starts Chromium")
def test_on_the_page_a_doubtful_frame_is_corrected(browser: "Browser", tmp_path: Path) -> None:
    tape = shelf.read("circle.asc")[:PART]
    content = camera.photograph(tape, Shot(covered=(40,)))
    read = correction.Reading([correction.Picture("strip.jpg", content, photograph.strips(content))])
    number = next(number for number, frame, _ in read.frames if frame.why == photograph.UNSEEN)
    file = tmp_path / "page.html"
    file.write_text(correction.page(read), encoding="utf-8")
    page = browser.new_page(viewport={"width": 390, "height": 844})
    page.goto(file.as_uri())
    widths = "[document.documentElement.scrollWidth, document.querySelector('main').clientWidth]"
    assert page.evaluate(widths) == [390, 390]
    page.get_by_role("button", name=f"{number}: ").click()
    page.get_by_title("channel 8").press("Enter")
    assert page.evaluate("document.activeElement.title") == "channel 8", "it has the focus still"
    asks = "!dispatchEvent(new Event('beforeunload', { cancelable: true }))"
    assert page.evaluate(asks), "what was corrected is not saved yet"
    saved = {}
    for button in ("Save the tape", "Save the record of corrections"):
        with page.expect_download() as download:
            page.get_by_text(button).click()
        saved[button] = Path(download.value.path()).read_bytes()
    assert not page.evaluate(asks)
    mended = bytearray(read.tape)
    mended[number] ^= 0o200
    assert saved["Save the tape"] == mended
    (changed,) = [
        one for one in json.loads(saved["Save the record of corrections"])["frames"] if one["corrected"]
    ]
    assert (changed["frame"], changed["is"]) == (number, f"{mended[number]:03o}")


def test_what_is_doubtful_is_said_frame_by_frame_a_gap_as_one() -> None:
    """Even parity, which mends a channel and not two; frames without a sprocket hole, one alone and two."""
    tape = ascii.encode("0010000000000003588\n", "even", 2)
    frames = [photograph.Frame(frame, 0, "", ((at, 7),) * 9) for at, frame in enumerate(tape)]
    for at, mask, why in ((3, 0o004, "dirt"), (4, 0o003, "dirt"), (6, 0o377, photograph.UNSEEN)):
        frames[at] = frames[at]._replace(holes=tape[at] ^ mask & 0o007, open=mask, why=why)
    for at in (9, 10):
        frames[at] = frames[at]._replace(open=0o377, why=photograph.UNSEEN)
    content = camera.develop(np.zeros((9, 9)), Shot())
    reading = correction.Reading([correction.Picture("a<b.jpg", content, [Strip(frames)])])
    assert list(reading.report(underside=False)) == [
        "frame 3: 060 by the tape's parity, even; 064 was seen: channel 3, at 3, 7 in a<b.jpg: dirt",
        "frame 4: 063 is doubtful: channel 1, at 4, 7 in a<b.jpg: dirt",
        "frame 6: 067 is doubtful: at 6, 7 in a<b.jpg: its sprocket hole is not seen",
        "frames 9 to 10: a gap of 2 frames without a sprocket hole, counted by their distance, "
        "at 9, 7 in a<b.jpg",
        "23 frames: ASCII",
        "parity: even",
        "lines: 1 of 19 characters",
        "line ends: 1 CR, 1 LF, 2 RUBOUT",
    ]
    (picture,), (strip,) = shown(correction.page(reading))
    assert picture["name"] == "a<b.jpg"
    assert picture["source"].startswith("data:image/jpeg;base64,/9j/")
    assert strip["frames"][3] == {
        "seen": 0o064,
        "holes": 0o060,
        "by": "the tape's parity, even",
        "why": "dirt",
        "open": 0o004,
        "places": [[3, 7]] * 9,
    }
    assert strip["frames"][0]["by"] == ""
