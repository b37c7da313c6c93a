"""What is kept in the user's cache is taken from there while it holds, and made again else."""

import importlib
import os
import zipfile
from pathlib import Path

import pytest

from pdp8 import shelf
from pdp8.web import kept as module
from pdp8.web.kept import house, kept


def test_what_is_kept_is_not_made_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Not for the same content; for another it is, and replaces what was kept, as it does a damaged file."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    assert kept("page", "a", lambda: {"made": 1}) == {"made": 1}
    assert kept("page", "a", lambda: pytest.fail("made again")) == {"made": 1}
    assert kept("other", "a", lambda: [2]) == [2]
    assert kept("page", "b", lambda: {"made": 3}) == {"made": 3}
    other, page = sorted((tmp_path / "pdp8").iterdir())
    assert (other.name[:6], page.name[:5]) == ("other-", "page-")
    page.write_text('{"made"')
    assert kept("page", "b", lambda: {"made": 4}) == {"made": 4}
    assert kept("page", "b", lambda: pytest.fail("made again")) == {"made": 4}
    monkeypatch.setenv("XDG_CACHE_HOME", str(page))
    assert kept("page", "b", lambda: {"made": 5}) == {"made": 5}, "where no folder can be made"
    for named in ("", "relative"):  # freedesktop.org: "should consider the path invalid and ignore it"
        monkeypatch.setenv("XDG_CACHE_HOME", named)
        assert shelf.of_user("XDG_CACHE_HOME", "~") == os.path.expanduser("~")


def test_a_zip_of_our_packages_is_a_source_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_PACKAGES", ("boxed",))
    monkeypatch.syspath_prepend(str(tmp_path / "box.zip"))
    seen = set()
    for text in ("", "ONE = 1", "ONE = 2"):
        with zipfile.ZipFile(tmp_path / "box.zip", "w") as box:
            box.writestr("boxed/__init__.py", text)
        importlib.invalidate_caches()
        seen.add(house())
    assert len(seen) == 3
