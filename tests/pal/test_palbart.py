"""Random sources in the language that PAL III and palbart share: the same frames, first origin to checksum.

palbart (Debian's, by Gary A. Messenbrink) is an assembler of its own, for PAL8's dialect. What the dialects
do not share is left out: the floating-point names, references beyond the page, Z with another address than
one on page zero, digits 8 and 9 in octal, spaces beside an operator or before one (palbart does what follows
the space first), FIELD (palbart goes to 0200), redefinition, undefined symbols. Its leader and trailer have
other lengths.
"""

from pathlib import Path

import pytest

import pal
from pdp8.computer.use import program
from tests.conftest import case
from tests.pal.random_pal8 import PALBART, SEEDS, palbarts, written

PAL3 = {
    "source": "KA0={0-7777}\nKB1LONGER={0-7777}\nKX2Z={0-7777}\nK93={0-7777}\n{section*6-6}$\n",
    "section": "{origin}{origin*0-1}{new},{words}\n{line*4-15}",
    "origin": "*{0-7}{half}{2-3}{0-7}\n",
    "half": "0|2|4|6",
    "line": "{label}\t{words}{comment}\n",
    "label": "||{new},",
    "words": "{word}|{word}|{word}; {word}; {word}",
    "comment": "||\t/SAYS $ AND ;|/",
    "word": "{reference}|{reference}|{first group}|{second group}|{device}|{sum}",
    "reference": "{mri} {indirect}{zero}{0-177}|{mri} {indirect}.+{0-3}|{mri} {indirect}{last}",
    "mri": "AND|TAD|ISZ|DCA|JMS|JMP",
    "indirect": "||I ",
    "zero": "|Z ",
    "first group": "{clear} RAL|CMA CML|IAC CLL {clear}|7000 CMA|CML|IAC CMA {clear}",
    "clear": "CLA|CLL",
    "second group": "SMA {skip}|{skip} CLA|OSR HLT {skip}|HLT",
    "skip": "SZA|SNL",
    "device": "ION|IOF|KSF|KCC {device}|KRS|KRB|TSF|TCF|TPC {device}|TLS|RSF|RRB|PSF|PLS",
    "sum": "{sign}{item}{term*0-2}{or*0-2}",
    "sign": "||-",
    "term": "+{item}|-{item}",
    "or": " {item}",
    "item": "{0-7777}|{0-7777}|{constant}|.",
    "constant": "KA0|KB1LONGER|KX2Z|K93",
}


@pytest.mark.skipif(PALBART is None, reason="palbart is not installed")
def test_palbart_punches_the_same_frames(tmp_path: Path) -> None:
    for seed in SEEDS:
        source = written(PAL3, seed)
        with case(source):
            assembly = pal.assemble(source)
            assert assembly.ok
            tape, said = palbarts(source, tmp_path, "-e")
            assert said == ""
            assert assembly.tape.lstrip(b"\0").strip(b"\x80") == tape
            assert program.read((tmp_path / "x.lst").read_bytes(), "x").words == assembly.words
