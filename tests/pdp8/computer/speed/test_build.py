"""What is compiled is what the sources say."""

import ast
import re
from collections.abc import Iterator

import pytest

from tests.pdp8.computer.speed.forms import COMPILED, HOUSE, beside, extension


@pytest.mark.parametrize("name", COMPILED)
def test_no_extension_hides_a_newer_source(name: str) -> None:
    built = extension(name)
    if built is None:
        pytest.skip("not compiled")
    for suffix in (".py", ".pxd"):
        source = beside(name, suffix)
        assert source.stat().st_mtime <= built.stat().st_mtime, (
            f"{source.name} is newer than {built.name}: run `make`, or delete the latter"
        )


def test_no_compiled_piece_hides_a_newer_source() -> None:
    built = extension("pdp8.computer.speed.engine")
    if built is None:
        pytest.skip("not compiled")
    for source in (beside("pdp8.computer.speed.piece", ".py"), HOUSE / "release/threaded.py"):
        assert source.stat().st_mtime <= built.stat().st_mtime, f"{source.name} is newer: run `make`"


def test_whatever_has_types_beside_it_is_compiled() -> None:
    typed = [*HOUSE.glob("pal/*.pxd"), *HOUSE.glob("pdp8/**/*.pxd")]
    names = {".".join(path.relative_to(HOUSE).with_suffix("").parts) for path in typed}
    assert names == {*COMPILED, "pdp8.computer.speed.piece"}  # translated, and compiled with the engine


@pytest.mark.parametrize("name", COMPILED)
def test_every_attribute_of_a_compiled_class_has_its_type(name: str) -> None:
    """An attribute that is only in the source exists when Python runs it, and not when it was compiled."""
    types = beside(name, ".pxd").read_text()
    tree = ast.parse(beside(name, ".py").read_text())
    for definition in ast.walk(tree):
        if not isinstance(definition, ast.ClassDef) or f"class {definition.name}" not in types:
            continue
        declared = re.split(r"^cdef class ", types, flags=re.MULTILINE)
        (own,) = [part for part in declared if re.match(rf"{definition.name}\b", part)]
        inherited = own + (
            beside("pdp8.computer.hardware.bus", ".pxd").read_text() if "(Device)" in own else ""
        )
        for attribute in set(_assigned(definition)):
            assert re.search(rf"\b{attribute}\b", inherited), f"{definition.name}.{attribute}"


def _assigned(definition: ast.ClassDef) -> Iterator[str]:
    """Yield the attributes of `self` that the class assigns to."""
    for node in ast.walk(definition):
        match node:
            case ast.Attribute(value=ast.Name(id="self"), attr=name, ctx=ast.Store()):
                yield name
