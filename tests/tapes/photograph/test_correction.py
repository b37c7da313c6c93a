"""`pdp8 tape read`: what it writes and says, and the page in which doubtful frames are corrected."""

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import pytest

from pdp8 import shelf
from tapes import ascii, photograph
from tapes.photograph import correction
from tests.conftest import Shell
from tests.tapes.photograph import camera
from tests.tapes.photograph.camera import Shot

if TYPE_CHECKING:
    from playwright.sync_api import Browser

PART = 60
"""Frames of a test's tape."""


def shown(page: str) -> dict[str, Any]:
    """Return what a page holds of its picture."""
    (picture,) = json.JSONDecoder().raw_decode(page.partition("const pictures = ")[2])[0]
    return dict(picture)


def test_the_command_writes_the_tape_and_says_what_it_is(shell: Shell, tmp_path: Path) -> None:
    tape = shelf.read("circle.asc")[:PART]
    picture = camera.photograph(tape, Shot(angle=3)) + bytes(3 << 20)  # a file as long as a camera's
    (tmp_path / "photo.jpg").write_bytes(picture)
    done = shell("pdp8 tape read photo.jpg --page look.html -o found.asc")
    assert (done.returncode, done.stderr) == (0, b"60 frames: ASCII\nwrote found.asc\nwrote look.html\n")
    assert (tmp_path / "found.asc").read_bytes() == tape
    assert [frame["holes"] for frame in shown((tmp_path / "look.html").read_text())["frames"]] == [*tape]


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


@pytest.mark.slow("starts Chromium")
def test_on_the_page_a_doubtful_frame_is_corrected(browser: "Browser", tmp_path: Path) -> None:
    tape = shelf.read("circle.asc")[:PART]
    content = camera.photograph(tape, Shot(covered=(40,)))
    read = correction.Reading([correction.Picture("strip.jpg", content, photograph.read(content))])
    number = next(number for number, frame, _ in read.frames if frame.why == photograph.UNSEEN)
    file = tmp_path / "page.html"
    file.write_text(correction.page(read), encoding="utf-8")
    page = browser.new_page(viewport={"width": 390, "height": 844})
    page.goto(file.as_uri())
    widths = "[document.documentElement.scrollWidth, document.querySelector('main').clientWidth]"
    assert page.evaluate(widths) == [390, 390]
    page.get_by_role("button", name=f"{number}: ").click()
    page.get_by_title("channel 8").click()
    saved = {}
    for button in ("Save the tape", "Save the record of corrections"):
        with page.expect_download() as download:
            page.get_by_text(button).click()
        saved[button] = Path(download.value.path()).read_bytes()
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
    reading = correction.Reading([correction.Picture("a<b.jpg", content, frames)])
    assert list(reading.report(underside=False)) == [
        "frame 3: 060 by the tape's parity, even; 064 was seen: channel 3, at 3, 7 in a<b.jpg: dirt",
        "frame 4: 063 is doubtful: channel 1, at 4, 7 in a<b.jpg: dirt",
        "frame 6: 067 is doubtful: at 6, 7 in a<b.jpg: its sprocket hole is not seen",
        "frames 9 to 10: a gap of 2 frames without a sprocket hole, counted by their distance, "
        "at 9, 7 in a<b.jpg",
        "23 frames: ASCII",
    ]
    picture = shown(correction.page(reading))
    assert picture["name"] == "a<b.jpg"
    assert picture["source"].startswith("data:image/jpeg;base64,/9j/")
    assert picture["frames"][3] == {
        "seen": 0o064,
        "holes": 0o060,
        "by": "the tape's parity, even",
        "why": "dirt",
        "open": 0o004,
        "places": [[3, 7]] * 9,
    }
    assert picture["frames"][0]["by"] == ""
