"""`pdp8 tape read`: what it writes and says, and the page in which doubtful frames are corrected."""

import json
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

cv2 = pytest.importorskip("cv2", reason="OpenCV is not installed")

from tapes import photograph, shelf  # noqa: E402
from tapes.photograph import correction  # noqa: E402
from tests.conftest import Shell  # noqa: E402
from tests.tapes.photograph import camera  # noqa: E402
from tests.tapes.photograph.camera import Shot  # noqa: E402

if TYPE_CHECKING:
    from playwright.sync_api import Browser

PART = 60
"""Frames of a test's tape."""


def test_the_command_writes_the_tape_and_says_what_it_is(shell: Shell, tmp_path: Path) -> None:
    tape = shelf.read("circle.asc")[:PART]
    picture = camera.photograph(tape, Shot(angle=3)) + bytes(3 << 20)  # a file as long as a camera's
    (tmp_path / "photo.jpg").write_bytes(picture)
    done = shell("pdp8 tape read photo.jpg -o found.asc")
    assert (done.returncode, done.stderr) == (0, b"60 frames: ASCII\nwrote found.asc\n")
    assert (tmp_path / "found.asc").read_bytes() == tape


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
    page = browser.new_page()
    page.goto(file.as_uri())
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


def test_the_page_holds_the_picture_and_every_frame(shell: Shell, tmp_path: Path) -> None:
    tape = shelf.read("circle.asc")[:PART]
    (tmp_path / "a<b.jpg").write_bytes(camera.photograph(tape, Shot(covered=(40,))))
    assert shell("pdp8 tape read 'a<b.jpg' --page look.html -o found.asc").returncode == 0
    page = (tmp_path / "look.html").read_text()
    start = page.index("const pictures = ") + len("const pictures = ")
    (picture,) = json.JSONDecoder().raw_decode(page[start:])[0]
    assert picture["name"] == "a<b.jpg"
    assert picture["source"].startswith("data:image/jpeg;base64,/9j/")
    assert bytes(frame["holes"] for frame in picture["frames"]) == (tmp_path / "found.asc").read_bytes()
    assert [number for number, frame in enumerate(picture["frames"]) if frame["open"] == 0o377]
