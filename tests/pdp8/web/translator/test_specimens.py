"""Small programs, ours and of CPython's own tests: each gives what it gives in Python, or is refused."""

import re
import sys
import warnings
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests.pdp8.web.node import needs_node
from tests.pdp8.web.translator.cpython import assertions
from tests.pdp8.web.translator.specimens import tried

pytestmark = needs_node


def test_kinds_that_look_alike_in_both_languages(tmp_path: Path) -> None:
    text = Path(__file__).with_name("kinds.txt").read_text(encoding="utf-8")
    kinds = re.findall(r"^## (\w+)(?: refused ([^\n]*))?\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    found = tried({name: source for name, _, source in kinds}, tmp_path)
    assert {name: each[:2] for name, each in found.items() if each.differs} == {}
    assert {name: each.place for name, each in found.items()} == {name: place for name, place, _ in kinds}


@pytest.mark.skipif(sys.version_info < (3, 15), reason="this syntax came with Python 3.15")
def test_what_is_unpacked_in_a_comprehension_is_refused(tmp_path: Path) -> None:
    for made in ("[*a for a in b]", "[*(*a for a in b)]", "{*a for a in b}", "{**{1: a} for a in b}"):
        found = tried({"one": f"def main() -> str:\n    b = [[1], [2]]\n    return str({made})\n"}, tmp_path)
        assert found["one"].place == "in line 3", made


@pytest.mark.slow("translates 5,000 programs")
@pytest.mark.skipif(find_spec("test.string_tests") is None, reason="CPython's own tests are not installed")
def test_what_cpython_asserts_of_itself(tmp_path: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # some of what they compare is odd
        asserted = list(assertions())
        programs = {f"{each.name}_{at}": text for each in asserted for at, text in enumerate(each.programs)}
        found = tried(programs, tmp_path)
    names = [[f"{each.name}_{at}" for at in range(len(each.programs))] for each in asserted]
    equal = sum(any(not found[name].refused for name in each) for each in names)
    print(f"{len(asserted)} assertions: {equal} equal, {len(asserted) - equal} refused")
    assert len(asserted) >= 2000
    assert {programs[name]: each[:2] for name, each in found.items() if each.differs} == {}
