"""What is compiled is what the sources say."""

import ast
import re

import pytest

from tests.pdp8.computer.speed.forms import COMPILED, HOUSE, beside, extension


@pytest.mark.parametrize("name", COMPILED)
def test_no_extension_hides_a_newer_source(name: str) -> None:
    built = extension(name)
    if built is None:
        pytest.skip("not compiled")
    sources = [beside(name, ".py"), beside(name, ".pxd")]
    if name == "pdp8.computer.speed.engine":
        sources += [beside("pdp8.computer.speed.piece", ".py"), HOUSE / "release/threaded.py"]
    for source in sources:
        assert source.stat().st_mtime <= built.stat().st_mtime, f"{source.name} is newer: run `make`"


def test_whatever_has_types_beside_it_is_compiled() -> None:
    typed = [*HOUSE.glob("pal/*.pxd"), *HOUSE.glob("pdp8/**/*.pxd")]
    names = {".".join(path.relative_to(HOUSE).with_suffix("").parts) for path in typed}
    assert names == {*COMPILED, "pdp8.computer.speed.piece"}  # translated, and compiled with the engine


@pytest.mark.parametrize("name", COMPILED)
def test_every_attribute_of_a_compiled_class_has_its_type(name: str) -> None:
    """An attribute that is only in the source exists when Python runs it, and not when it was compiled."""
    types = beside(name, ".pxd").read_text()
    declared = dict(re.findall(r"^cdef class (\w+)(.*?)(?=^cdef class|\Z)", types, re.MULTILINE | re.DOTALL))
    inherited = beside("pdp8.computer.hardware.bus", ".pxd").read_text()
    for definition in ast.walk(ast.parse(beside(name, ".py").read_text())):
        if not isinstance(definition, ast.ClassDef) or definition.name not in declared:
            continue
        own = declared[definition.name]
        for node in ast.walk(definition):
            match node:
                case ast.Attribute(value=ast.Name(id="self"), attr=attribute, ctx=ast.Store()):
                    there = own + (inherited if "(Device)" in own else "")
                    assert re.search(rf"\b{attribute}\b", there), f"{definition.name}.{attribute}"
