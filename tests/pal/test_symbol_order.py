"""Each permanent symbol; the order of the symbol table: letters before digits, digits in their order."""

import pal
from pal.symbols import PERMANENT, PSEUDO_OPERATORS, spelled, typed
from pal.table import SymbolTable

MEMORY_REFERENCES = """
AND 0 TAD 1000 ISZ 2000 DCA 3000 JMS 4000 JMP 5000
FEXT 0 FADD 1000 FSUB 2000 FMPY 3000 FDIV 4000 FGET 5000 FPUT 6000 FNOR 7000
"""
OTHERS = """
ION 6001 IOF 6002 SMP 6101 CMP 6104 RSF 6011 RRB 6012 RFC 6014 PSF 6021 PCF 6022 PPC 6024 PLS 6026
KSF 6031 KCC 6032 KRS 6034 KRB 6036 TSF 6041 TCF 6042 TLS 6046 TPC 6044
NOP 7000 IAC 7001 RAL 7004 RTL 7006 RAR 7010 RTR 7012 CML 7020 CMA 7040 CLL 7100 CLA 7200
HLT 7402 OSR 7404 SKP 7410 SNL 7420 SZL 7430 SZA 7440 SNA 7450 SMA 7500 SPA 7510
CIA 7041 LAS 7604 STL 7120 GLK 7204 STA 7240
DTRA 6761 DTCA 6762 DTXA 6764 DTSF 6771 DTRB 6772 DTLB 6774
MMMM 6757 MMMF 6756 MMML 6766 MMLS 6751 MMLM 6752 MMLF 6754
MMSF 6761 MMCF 6772 MMSC 6771 MMRS 6774 MMCC 6762 MMLC 6764
"""


def test_the_permanent_symbols_of_february_1967() -> None:
    expected = [
        (name, int(word, 8), table is MEMORY_REFERENCES)
        for table in (MEMORY_REFERENCES, OTHERS)
        for name, word in zip(table.split()[::2], table.split()[1::2], strict=True)
    ]
    assert [(symbol.mnemonic, symbol.octal, symbol.memory_reference) for symbol in PERMANENT] == expected


def test_the_pseudo_operators_stand_for_the_addresses_of_their_routines() -> None:
    routines = (
        "FIELD 2157 EXPUNGE 1556 FIXMRI 2200 PAUSE 0372 FIXTAB 0561 DECIMAL 0167 OCTAL 0172 I 1174 Z 0535"
    )
    assert " ".join(f"{name} {address:04o}" for name, address in PSEUDO_OPERATORS.items()) == routines


def test_a_name_that_is_written_over_has_any_of_64_characters() -> None:
    shown = "@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_ !\"#$%&'()*+,-./0123456789:;<=>?"
    assert [spelled((code << 6 | 1, 0o100 | code)) for code in range(0o100)] == [
        f"{character}AA{character}".rstrip("@") for character in shown
    ]
    assert typed("A#B%@") == "A\nB\r  "


def test_letters_before_digits_and_8_before_9() -> None:
    tags = ["M9", "M8", "M60", "M6", "M", "MA", "M0", "A9", "A8Z", "A89", "A8"]
    source = "*200\n" + "".join(f"{tag},\t0\n" for tag in tags) + "$\n"
    order = ["A8", "A8Z", "A89", "A9", "M", "MA", "M0", "M6", "M60", "M8", "M9"]
    assert list(pal.assemble(source).symbols) == order


def test_what_lies_behind_the_table_is_0() -> None:
    table = SymbolTable(1)
    assert table.word(len(table.words)) == 0
