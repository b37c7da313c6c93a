"""The two forms the machine runs in: as Python reads its sources, and as Cython compiled them."""

import importlib
import sys
from collections.abc import Sequence
from importlib.abc import MetaPathFinder
from importlib.machinery import EXTENSION_SUFFIXES, ModuleSpec
from importlib.util import spec_from_file_location
from pathlib import Path
from types import ModuleType
from unittest.mock import patch

import pal

HOUSE = Path(pal.__file__).parents[1]
COMPILED = (
    *(f"pal.{name}" for name in ("isa", "source", "table", "assembler", "notes", "listing")),
    *(f"pal.pal8.{name}" for name in ("expressions", "operators", "log", "lexer", "output")),
    *(f"pal.pal8.{name}" for name in ("table", "literals", "assembler")),
    *(f"pdp8.computer.hardware.{name}" for name in ("bus", "extension", "processor", "teletype")),
    *(f"pdp8.computer.speed.{name}" for name in ("waiting", "engine")),
)
FORMS = ("plain", "compiled")
USED = (
    *("pdp8.computer.machine", "pdp8.computer.count"),
    *(f"pdp8.computer.hardware.{name}" for name in ("bus", "fields", "signals")),
    *(f"pdp8.computer.past.{name}" for name in ("state", "history", "rewind")),
)
"""What tests take of both."""


def beside(name: str, suffix: str) -> Path:
    """Return the file of module `name` that ends in `suffix`."""
    return HOUSE / (name.replace(".", "/") + suffix)


def extension(name: str) -> Path | None:
    """Return the compiled form of module `name`, if it was built for this Python."""
    return next((path for suffix in EXTENSION_SUFFIXES if (path := beside(name, suffix)).exists()), None)


def _is_ours(name: str) -> bool:
    """Tell whether `name` is a module that may be compiled, or one that uses such a module."""
    return name == "pal.isa" or (name.startswith("pdp8.computer.") and beside(name, ".py").exists())


class _Sources(MetaPathFinder):
    """Finds the sources of the modules that may be compiled."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        return spec_from_file_location(fullname, beside(fullname, ".py")) if _is_ours(fullname) else None


def _plain() -> dict[str, ModuleType]:
    """Import what is USED from sources alone, and leave the modules in use as they were."""
    for name in USED:
        importlib.import_module(name)
    used = {name: module for name, module in sys.modules.items() if _is_ours(name)}
    with patch.dict(sys.modules), patch.object(sys, "meta_path", [_Sources(), *sys.meta_path]):
        for name in used:
            del sys.modules[name]
        plain = {name: importlib.import_module(name) for name in USED}
    for name, module in used.items():
        package, _, own = name.rpartition(".")
        setattr(sys.modules[package], own, module)
    return plain


_PLAIN = _plain()


def machine_module(form: str) -> ModuleType:
    """Return pdp8.computer.machine in one of the FORMS; skip the test if it was not built."""
    return module(form, "pdp8.computer.machine")


def module(form: str, name: str) -> ModuleType:
    """Return a module of those USED in one of the FORMS; skip the test if it was not built."""
    if form == "plain":
        return _PLAIN[name]
    missing = [name for name in COMPILED if extension(name) is None]
    if missing:
        import pytest  # the benchmarks, which come here too, do without

        pytest.skip(f"not compiled: {', '.join(missing)}")
    return importlib.import_module(name)
