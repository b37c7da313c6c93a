"""The thesis's program: the words of Appendix B, and a listing whose legible lines are those of its page."""

import re
from pathlib import Path

import pal
import programs

SOURCE = (Path(programs.__file__).parent / "eia.pal").read_bytes()
TABLE = """
0200: 6046 6032 4214 0101 1102 3100 4227 7440 5201 1100 4221 5201
0214: 0000 6031 5215 6036 5614
0221: 0000 6041 5222 6046 7300 5621
0227: 0000 1100 7440 5236 1103 3100 5627
0236: 1116 7640 5244 1104 3100 5627
0244: 1100 1117 7640 5253 1105 3100 5627
0253: 1100 1120 7640 5262 1106 3100 5627
0262: 1100 1121 7640 5271 1107 3100 5627
0271: 1100 1122 7640 5300 1110 3100 5627
0300: 1100 1123 7640 5307 1111 3100 5627
0307: 1100 1124 7640 5316 1112 3100 5627
0316: 1100 1125 7640 5325 1113 3100 5627
0325: 1100 1126 7640 5334 1114 3100 5627
0334: 1100 1127 7640 5343 1103 3100 5627
0343: 1100 1130 7440 5627 1115 3100 5627
0100: 0000 0177 7720 0040 0001 0002 0023 0004 0025 0026 0007 0010 0031 0200
0116: 7777 7776 7775 7774 7773 7772 7771 7770 7767 0020 0043
"""
APPENDIX_B = """
0211 1100 TAD HOLD
0231 7440 SZA
0255 7640 SZA CLA
0342 5627 JMP I CHK
0343 1100 TAD HOLD
0344 1130 TAD MCR
0345 7440 SZA
0346 5627 JMP I CHK
0347 1115 TAD PCR
0350 3100 DCA HOLD
0351 5627 JMP I CHK
0100 0000 HOLD,0
0101 0177 MASK,177
0102 7720 M60,-60
0103 0040 P0,40
0105 0002 P2,2
0106 0023 P3,23
0107 0004 P4,4
0110 0025 P5,25
0111 0026 P6,26
0112 0007 P7,7
0113 0010 P8,10
0114 0031 P9,31
0115 0200 PCR,200
0116 7777 M1,-1
0117 7776 M2,-2
0120 7775 M3,-3
0121 7774 M4,-4
0122 7773 M5,-5
0123 7772 M6,-6
0124 7771 M7,-7
0125 7770 M8,-10
0126 7767 M9,-11
0127 0020 MSP,20
0130 0043 MCR,43
"""


def test_the_words_are_those_of_appendix_b() -> None:
    words: dict[int, int] = {}
    for line in TABLE.split("\n")[1:-1]:
        start, _, run = line.partition(": ")
        words |= {int(start, 8) + offset: int(word, 8) for offset, word in enumerate(run.split())}
    assembly = pal.assemble(SOURCE)
    assert len(words) == 131
    assert assembly.words == words
    assert assembly.diagnostics == []


def test_the_legible_lines_are_in_the_listing() -> None:
    listing = pal.assemble(SOURCE).listing.splitlines()
    typed = [re.sub(r",\s+", ",", " ".join(line.partition("/")[0].split())) for line in listing]
    typed += [re.sub(r" \w+,", " ", line) for line in typed]  # tags are lost on the page
    for line in APPENDIX_B.split("\n")[1:-1]:
        assert line in typed
    for unnumbered in ("/// EIA", "*200", "/DEFINITIONS:", "*100"):
        assert " " * 12 + unnumbered in listing
