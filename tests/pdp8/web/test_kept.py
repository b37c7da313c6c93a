"""What is kept in the user's cache is taken from there while it holds, and made again else."""

import importlib
import zipfile
from pathlib import Path

import pytest

from pdp8.web import kept as module
from pdp8.web.kept import house, kept


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The cache's folder."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "pdp8"


def test_what_is_kept_is_not_made_again(cache: Path) -> None:
    """Not for the same content; for another it is, and replaces what was kept."""
    assert kept("page", "a", lambda: {"made": 1}) == {"made": 1}
    assert kept("page", "a", lambda: pytest.fail("made again")) == {"made": 1}
    assert kept("other", "a", lambda: [2]) == [2]
    assert kept("page", "b", lambda: {"made": 3}) == {"made": 3}
    assert [path.name.split("-")[0] for path in sorted(cache.iterdir())] == ["other", "page"]


def test_a_damaged_cache_is_made_again(cache: Path) -> None:
    """A file that is cut off is replaced."""
    kept("page", "a", lambda: {"made": 1})
    (file,) = cache.iterdir()
    file.write_text('{"made"')
    assert kept("page", "a", lambda: {"made": 2}) == {"made": 2}
    assert kept("page", "a", lambda: pytest.fail("made again")) == {"made": 2}


def test_a_cache_that_cannot_be_written_is_done_without(cache: Path) -> None:
    """A file stands where the folder should be."""
    cache.write_text("")
    assert kept("page", "a", lambda: {"made": 1}) == {"made": 1}


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
