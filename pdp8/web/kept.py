"""Results that take long to make, kept as JSON in the user's cache while their sources are the same."""

import hashlib
import json
from collections.abc import Callable
from contextlib import suppress
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from pdp8 import shelf

_PACKAGES = ("nc", "pal", "pdp8", "programs", "tapes")
_NOT_SOURCES = (".pyc", ".so", ".pyd")


def kept(name: str, content: str, make: Callable[[], Any]) -> Any:
    """Return `make(content)`, from the cache if `content` is unchanged."""
    folder = Path(shelf.of_user("XDG_CACHE_HOME", "~/.cache")) / "pdp8"
    path = folder / f"{name}-{hashlib.sha256(content.encode()).hexdigest()[:16]}.json"
    try:
        return json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        made = make()
    with suppress(OSError):
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob(f"{name}-*.json"):
            old.unlink()
        path.write_text(json.dumps(made), encoding="utf-8")
    return made


def house() -> str:
    """Return a digest of our installed packages."""
    digest = hashlib.sha256()
    for package in _PACKAGES:
        spec = find_spec(package)
        if spec is None or spec.origin is None:
            continue
        folder = shelf.beside(spec.origin)
        for path in sorted(Path(folder).rglob("*")):
            if path.is_file() and path.suffix not in _NOT_SOURCES:
                digest.update(f"{package} {path.relative_to(folder)}\n".encode() + path.read_bytes())
    return digest.hexdigest()
