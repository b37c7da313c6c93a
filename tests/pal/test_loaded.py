"""`Assembly.words` is what DEC's BIN loader leaves in core of our tape.

SOURCES=8000 pytest -k loaded tests/pal     tries 2,000 sources, right and wrong, in both dialects
"""

import pal
from pal import punch
from tests.conftest import case
from tests.pal.random_pal8 import PAL8, SEEDS, faulty, written
from tests.pdp8.computer.use.test_loaders import FREE, loaded


def compare(source: str, dialect: str) -> bool:
    """Compare core with the assembly's words; return whether there were words in core to compare."""
    assembly = pal.assemble(source, dialect=dialect)
    if not assembly.tape or any(address & 0o7777 not in FREE for address in assembly.words):  # PN57
        return False
    core, good = loaded("bin", assembly.tape.lstrip(b"\0"))  # an operator sets the tape on its leader
    no_loader = any(found.code == "PS02" for found in assembly.diagnostics)
    assert good or no_loader
    found: dict[int, set[int]] = {}
    for address, word in assembly.words.items():
        found.setdefault(address & 0o7777, set()).add(word)  # a machine of one field: the last one stays
    if no_loader:
        return True
    assert core.keys() <= found.keys()
    for address, words in found.items():
        assert core.get(address, 0) in words, f"{address:04o}"
    return True


def test_a_word_is_loaded_at_0_and_none_before_an_origin() -> None:
    assert punch.loaded(b"\x80\x00\x05\x40\x00\x00\x07\x00\x08\x80") == {0: 7}


def test_words_are_what_is_loaded() -> None:
    compared = 0
    for seed in SEEDS[::8]:
        for source in (written(PAL8, seed), faulty(seed)):
            for dialect in ("pal3", "pal8"):
                with case(dialect, source):
                    compared += compare(source, dialect)
    assert compared
