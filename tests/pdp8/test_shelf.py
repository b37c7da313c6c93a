"""Files found, read, and written whole or not at all."""

import os
import sys
import zipfile
from contextlib import nullcontext
from pathlib import Path
from unittest.mock import Mock

import pytest

from pdp8 import shelf
from pdp8.shelf import ShelfError

pytestmark = pytest.mark.usefixtures("here")


def test_what_is_here_comes_before_what_is_bundled_and_hides_it() -> None:
    bundled = shelf.read_bundled("eia.pal")
    assert os.path.isabs(shelf.find("eia.pal"))
    Path("eia.pal").mkdir()
    assert shelf.read("eia.pal") == bundled
    assert not shelf.hides("eia.pal")
    Path("eia.pal").rmdir()
    for content in (bundled, b"$\n"):
        Path("eia.pal").write_bytes(content)
        assert shelf.find("eia.pal") == "eia.pal"
        assert shelf.read("eia.pal") == content
        assert shelf.hides("eia.pal") == (content != bundled)
    assert shelf.read_bundled("eia.pal") == bundled
    assert all(shelf.read(name) for name in shelf.bundled())


@pytest.mark.parametrize("name", ["./eia.pal", "sub/eia.pal", "cli.py", "../programs/eia.pal"])
def test_a_bundled_name_is_a_name_only(name: str) -> None:
    with pytest.raises(ShelfError, match="no such file, here or among the bundled ones"):
        shelf.find(name)


def test_a_package_in_a_zip_has_its_files_too(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "house.zip", "w") as house:
        for name in ("a/package/ours.tape", "a/package/deep/more", "a/packages/other", "rest"):
            house.writestr(name, name)
    folder = Path(shelf.beside(str(tmp_path / "house.zip" / "a" / "package" / "__init__.py")))
    assert {path.name: path.is_file() for path in folder.iterdir()} == {"ours.tape": True, "deep": False}
    assert (folder / "ours.tape").read_text() == "a/package/ours.tape"
    assert sorted(path.name for path in folder.parent.iterdir()) == ["package"]


BY_HAND = {".pal", ".pa", ".for", ".toml", ".jpg", ".jpeg", ".PNG"}
TAPES = {".asc", ".eia", ".bin", ".rim"}
REELS = {".tu56", ".df32", ".state"}
KEPT = {"tape": BY_HAND | REELS, "text": BY_HAND | REELS | TAPES, "image": BY_HAND | TAPES, "": set[str]()}


@pytest.mark.parametrize(("kind", "kept"), KEPT.items())
def test_what_a_product_never_replaces(kind: str, kept: set[str]) -> None:
    for name in (f"x{ending}" for ending in BY_HAND | TAPES | REELS | {".txt"}):
        Path(name).touch()
        shelf.check_kind(name, kind)
        Path(name).write_bytes(b"9")
        Path(f"link{name}.out").symlink_to(name)
        for written in (name, f"link{name}.out"):
            refused = pytest.raises(ShelfError, match=f"{written} is there, and is no {kind}: it is not")
            with refused if Path(name).suffix in kept else nullcontext():
                shelf.check_kind(written, kind)


@pytest.mark.parametrize(("kind", "first"), [("JSON", b"{"), ("XML", b"<"), ("SVG", b"<"), ("HTML", b"<")])
def test_a_record_replaces_its_like_alone(kind: str, first: bytes) -> None:
    shelf.check_kind("x", kind)
    for harmless in (b"", b"\xef\xbb\xbf \n" + first, b" " * 63 + first):
        Path("x").write_bytes(harmless)
        shelf.check_kind("x", kind)
    for other in (b"9", b" " * 64 + first):
        Path("x").write_bytes(other)
        with pytest.raises(ShelfError, match=f"x is there, and is no {kind}: it is not"):
            shelf.check_kind("x", kind)


@pytest.mark.parametrize("ending", [".png", ".jpg", ".jpeg", ".gif", ".webp", ".pdf", ".eps", ".DXF"])
def test_a_picture_of_another_format_is_not_promised(ending: str) -> None:
    for kind, formats in (("SVG", "SVG; name it .svg"), ("drawing", "SVG or DXF; name it .svg or .dxf")):
        if (kind, ending) != ("drawing", ".DXF"):
            with pytest.raises(ShelfError, match=f"x{ending}: pictures are written only as {formats}"):
                shelf.check_kind(f"x{ending}", kind)
    shelf.check_kind(f"x{ending}", "HTML")


def test_what_is_read_while_it_is_watched_is_not_written_until_then() -> None:
    with shelf.watched():
        shelf.write("x", shelf.read("eia.pal"))
        assert shelf.write("x", shelf.read("x"))
        Path("y").write_bytes(shelf.read("x"))
        shelf.read("y")
        with pytest.raises(ShelfError, match="y was read: it is not replaced"):
            shelf.write("y", b"")
    assert shelf.write("y", b"")


def test_what_cannot_be_written_leaves_what_was_there(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "x.bin"
    path.write_bytes(b"old")
    monkeypatch.setattr(os, "replace", Mock(side_effect=OSError(28, "No space left on device")))
    with pytest.raises(ShelfError, match="No space left on device; this file was not written"):
        shelf.write(str(path), b"new")
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


def test_what_cannot_be_read_or_written_is_named() -> None:
    Path("x").write_bytes(b"\xef\xbb\xbfA\xc4B")
    with pytest.raises(ShelfError, match="x: byte 4: not UTF-8"):
        shelf.read_text("x")
    with pytest.raises(ShelfError, match="-: standard output has what is said"):
        shelf.leave("-", b"x", "tape")
    for name in ("/tmp", "x/"):
        with pytest.raises(ShelfError, match=f"{name}: Is a directory"):
            shelf.check_writable(name)
    shelf.write("ü" * 127, b"the longest name")
    with pytest.raises(ShelfError, match="File name too long"):
        shelf.open_punch("x" * 300)


@pytest.mark.skipif(sys.platform == "win32", reason="a folder in use cannot go there")
def test_a_current_folder_that_is_gone_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    with pytest.raises(ShelfError, match=r"x\.pal: the current folder is no longer there"):
        shelf.find("x.pal")
