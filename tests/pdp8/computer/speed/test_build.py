"""What is compiled is what the sources say."""

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
    typed = [*HOUSE.glob("pal/**/*.pxd"), *HOUSE.glob("pdp8/**/*.pxd")]
    names = {".".join(path.relative_to(HOUSE).with_suffix("").parts) for path in typed}
    assert names == {*COMPILED, "pdp8.computer.speed.piece"}  # translated, and compiled with the engine
